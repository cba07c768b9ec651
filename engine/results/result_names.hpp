// Names of results: how the rows of a sweep, and a file that asks for results, call what may be found of a mechanism.
// Knows no values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/column.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// The columns that one scalar or component of a solution gives rise to, added to `columns`: ω of 3 is "angle 3" and
/// "omega 3", v_x of B "x B", "y B" and "vx B". `subject`: how the point or the sliding joint is called, "A on 4" where
/// several bodies carry A apart; of other quantities not looked at.
void add_columns(const Quantity& quantity, const Mechanism& mechanism, const std::string& subject,
                 std::vector<Column>& columns);

/// The length of a vector: "v B", "a B", "F A 3 on 2". Its quantity has the component `whole`.
Column modulus_column(const Quantity& vector, const Mechanism& mechanism, const std::string& subject);
bool is_modulus(const Column& column);

/// A force or a couple as solutions call it: F_32 of body 3 on body 2, F_A2 of the pin A; with the joint's name where
/// the two bodies meet at several joints.
Symbol symbol_of_action(const Quantity& action, const Mechanism& mechanism);

/// All that a solution of this mechanism may hold, under every name that it may have there: of a point that several
/// bodies carry "vx A" and "vx A on 4". Of a problem in place of joints only the solution tells.
std::vector<Column> possible_results(const Mechanism& mechanism);

/// Of a truss: the force in a bar (Quantity::Kind::bar, tension positive), where a column is the length of what a pin
/// exerts on it and nothing else acts on the bar there.
std::optional<Quantity> bar_of(const Column& column, const Mechanism& mechanism);

/// What the file asks for, in its order, forces of pins on the bars of a truss as those in the bars. What has no column
/// in a sweep (a value of a problem, the transmission angle) has its name alone.
std::vector<Column> asked_columns(const Mechanism& mechanism);

/// The line whose direction is the "angle" of a body: from its first point to the first that is elsewhere; nothing of a
/// body that has no two.
std::optional<std::array<PointIndex, 2>> line_of(const Body& body, const Pose& pose);

/// The least angle between a coupler and what it drives, over the whole travel of the first driver (Transmission).
inline constexpr const char* transmission_angle_name = "transmission angle";

}  // namespace kinegraph
