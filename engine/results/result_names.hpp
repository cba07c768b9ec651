// Names of results, as used in the rows of a sweep and in files that request results. Contains no values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/couplers.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/column.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

struct Solution;

/// Appends to `columns` the columns of one scalar or component of a solution: ω of 3 gives "angle 3" and "omega 3", v_x
/// of B gives "x B", "y B" and "vx B". `subject`: the name of the point or the sliding joint, "A on 4" where several
/// bodies carry A separately; ignored for other quantities.
void add_columns(const Quantity& quantity, const Mechanism& mechanism, const std::string& subject,
                 std::vector<Column>& columns);

/// The length of a vector: "v B", "a B", "F A 3 on 2". `vector` must have the component `whole`.
Column modulus_column(const Quantity& vector, const Mechanism& mechanism, const std::string& subject);
/// The same of a vector with this component.
Column modulus_column(const Column& component, const Mechanism& mechanism);
bool is_modulus(const Column& column);

/// The symbol of a force or a couple in solutions: F_32 of body 3 on body 2, F_A2 of the pin A; with the joint's name
/// where the two bodies meet at several joints.
Symbol symbol_of_action(const Quantity& action, const Mechanism& mechanism);

/// What a result on request is named by, behind its letter: "P13" (P1,3 where names are long), "F_gas", "3", "B".
std::string subject_on_request(const Quantity& quantity, const Mechanism& mechanism);

/// All results that a solution of this mechanism may contain, under every possible name: for a point that several
/// bodies carry "vx A" and "vx A on 4". Not for problems without joints: their results depend on the solution.
/// `driver`: of whose couplers the transmission angles are.
std::vector<Column> possible_results(const Mechanism& mechanism, int driver = 0);
/// The same without those that are defined by others (engine/results/operands.hpp).
std::vector<Column> constructed_results(const Mechanism& mechanism, int driver = 0);

/// The transmission angles as they are drawn, by their columns.
std::vector<std::pair<Column, Coupler>> transmission_columns(const Mechanism& mechanism, int driver);

/// For a truss: the force in a bar (Quantity::Kind::bar, tension positive), if the column is the magnitude of the force
/// of a pin on it and nothing else acts on the bar there.
std::optional<Quantity> bar_of(const Column& column, const Mechanism& mechanism);

/// The results that the file requests, in its order. Forces of pins on the bars of a truss become bar forces. A result
/// without a column in a sweep (a value of a problem, the transmission angle) has only its name.
std::vector<Column> asked_columns(const Mechanism& mechanism);

/// The line whose direction is the "angle" of a body: from its first point to the first one at another place; empty if
/// there is none.
std::optional<std::array<PointIndex, 2>> line_of(const Body& body, const Pose& pose);

/// The smallest angle between a coupler and the link it drives, over the whole travel of the first driver
/// (Transmission).
inline constexpr const char* transmission_angle_name = "transmission angle";
Column transmission_column();

/// The name of a bar by its pins, "AB". Null if the body is not a bar of a truss, or if the file's questions refer to
/// bars by number.
const std::string* name_of_bar(const Solution& solution, BodyIndex body);

}  // namespace kinegraph
