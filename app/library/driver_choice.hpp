// Reads and writes drivers, their coordinates and times, as a command line gives them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "constructions/solving/solve.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/positions.hpp"
#include "kinegraph/mechanism.hpp"

namespace kinegraph::app {

/// A driver by the name of its body, joint or point; the first if the name is empty. Error: a message that lists the
/// existing names.
tl::expected<int, Words> driver_named(const Mechanism& mechanism, const std::string& name, const std::string& dashes);
/// Why one position of a cam is not moved.
Words cam_stays(const Mechanism& mechanism);
std::string name_of_driver(const Mechanism& mechanism, int driver);
bool turns(const Mechanism& mechanism, int driver);
const Law* law_of(const Mechanism& mechanism, int driver);  ///< null if it has none

/// `branch` as on the command line: from 1; 0: not given.
Course course_of(int driver, int branch);

/// "90°", "1.57 rad", "20 mm", or a bare number in rad or m, exactly. Error: a message that says what is wrong.
tl::expected<Exact, Words> coordinate_of(const Mechanism& mechanism, int driver, const std::string& text);
/// A quantity of one kind, or a bare number of `unit`s. Error: a message that says what is wrong.
tl::expected<Exact, Words> quantity_of(const std::string& text, QuantityKind kind, const Exact& unit);
/// "0.2 s" or a bare number of seconds. Error: a message that says what is wrong.
tl::expected<Exact, Words> time_of(const std::string& text);
/// In the file's unit, rounded to `grain` of it and to seven digits: "30°", "20 mm".
Words coordinate_text(const Mechanism& mechanism, int driver, double coordinate, double grain = 1e-9);
Words time_text(double time);  ///< "0.2 s"

/// "400 mm is out of reach: driver 2 stops at 80 mm".
Words out_of_reach(const Words& wanted, const std::string& driver, const Words& limit);
/// The same of a position to which it would be moved by too many steps (Positions::is_near).
Words too_far(const Words& wanted, const std::string& driver);

/// Solutions in the order of `wanted.at`; the title of each names its position. Errors: bad_input for a text that is no
/// position or one out of reach, no_unique_answer at a change point, and those of the drawing.
Result<std::vector<Solution>> solved_positions(const Mechanism& mechanism, const PositionsWanted& wanted,
                                               Arithmetic arithmetic);

}  // namespace kinegraph::app
