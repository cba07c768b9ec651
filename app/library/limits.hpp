// Limits of what is solved in one run: beyond them a small file would take minutes or the memory of a machine for many
// requests. docs/file_faults.md lists them; those of a sheet are in render/sheet/sheet_limits.hpp.
#pragma once

#include <optional>

#include "engine/board/protocol.hpp"
#include "engine/file/error.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "lang/words.hpp"

namespace kinegraph::app {

/// Bodies of a mechanism or truss: planning its forces and checking them takes the cube of their number.
constexpr std::size_t most_bodies = 300;
/// Bodies of a mechanism whose instant centres are found: their number grows with the square.
constexpr std::size_t most_bodies_with_centres = 250;
/// Bodies of a mechanism whose positions are found one after another: in each, closing and checking it takes the cube.
constexpr std::size_t most_swept_bodies = 40;
/// What a sweep over a parameter may solve in all its values together, in work_of().
constexpr std::size_t most_work_of_values = 1'000'000;
/// Turns of a driver from the drawn position: the mechanism is moved there step by step.
constexpr double most_turns = 1000;

/// Why a file is not solved, with the limit and a remedy; none if it is.
std::optional<Error> beyond_solving(const Mechanism& mechanism);
std::optional<Words> beyond_sweep(const Mechanism& mechanism);

/// What reading and solving a file cost, in units of some three microseconds: counted, so that it is the same on every
/// machine.
std::size_t work_of(std::size_t bytes, const Mechanism& mechanism);
std::size_t work_of(const Protocol& record);

}  // namespace kinegraph::app
