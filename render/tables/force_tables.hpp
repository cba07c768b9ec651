// Force tables: known and sought properties of the forces of a polygon; drawn forces beside the numbers of the check;
// active forces and reactions body by body. Owns their columns; computes no statics.
#pragma once

#include <limits>
#include <vector>

#include "render/page/figure.hpp"
#include "render/scene/load_case.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {

/// The symbol of the couple that belongs to a force: M_12 beside F_12.
Symbol couple_symbol(const AppliedForce& applied);

/// The bodies whose force polygons a statement closes; no later statement finds a force on them.
std::vector<const FreeBody*> closed_by(const LoadCase& loads, StatementIndex statement);
/// Those of them of which the statement speaks, each by itself: it solves their equations. The others are closed by
/// what it finds elsewhere.
std::vector<const FreeBody*> solved_by(const LoadCase& loads, StatementIndex statement);

/// F_g + F_01 + F_21 = 0 above its table: magnitude and direction known or sought, and the line. An empty block (no
/// width) if the forces were not found by closing this polygon alone, or if it has no room in `most` mm even when set
/// closer and smaller. `loads`: under which the body is cut free.
Block force_equation_block(const DrawingContext& context, const LoadCase& loads, const FreeBody& body, bool with_names,
                           double most = std::numeric_limits<double>::infinity());
/// Only the names of the rows, to stand before several tables side by side.
Block force_row_names(const DrawingContext& context);

/// The reaction reduced to its pair's point, if it has a couple there (a sleeve, a clamp). The force with that couple
/// is equivalent to the single force of `applied`, displaced by d = M/F. Null without a couple.
const JointForce* at_the_pair(const Solution& solution, const FreeBody& body, const AppliedForce& applied);

/// Where a slider's reaction passes its guide: the distance from the joint's point, or a note that it lies outside the
/// slider's points on the guide, so that the slider tips. Empty if it passes through the joint's point.
/// `is_dimensioned`: the figure shows the distance, as d.
RichText beside_guide(const DrawingContext& context, const FreeBody& body, const AppliedForce& applied,
                      bool is_dimensioned);

/// Rows for the results table: loads, reactions once per joint, input forces and couples. Their lengths are measured on
/// `figures`. `at_pairs`: also the couples of sleeves and clamps beside their forces. `beside`: the bodies whose
/// polygons tables stand beside, in their order; there an action is called as it acts on that body.
std::vector<ResultRow> force_rows(const DrawingContext& context, const std::vector<Figure>& figures,
                                  bool at_pairs = true, std::vector<const FreeBody*> beside = {});
/// Whether two quantities are one force or couple, on the one body or on the other; a couple of a pair is its force's.
bool are_one_action(Quantity one, const Quantity& other);

/// Whether figures show resultants, which have two heads.
bool has_resultants(const Solution& solution);
/// Small and grey, to stand beneath a table.
Block note_block(const DrawingContext& context, const RichText& text, double width);

/// Active forces and reactions, body by body, the frame last; the head and the rows of a table `width` mm wide.
std::vector<Block> reaction_lines(const DrawingContext& context, double width);

}  // namespace kinegraph::render
