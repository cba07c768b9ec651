// Force tables: what is known of each force of a polygon, the forces as drawn beside the numbers of the check, active
// forces and reactions body by body. Owns their columns; computes no statics.
#pragma once

#include <vector>

#include "render/page/figure.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {

/// The couple of an applied force or couple, as it is written: M_12 beside F_12.
Symbol couple_symbol(const AppliedForce& applied);

/// The bodies whose polygons a statement closes: nothing of theirs is left to be found by a later one.
std::vector<const FreeBody*> closed_by(const Solution& solution, StatementIndex statement);

/// F_g + F_01 + F_21 = 0 above its table: magnitude and direction known or sought, and the line. Empty (no width) where
/// the forces were not found by closing this polygon alone.
Block force_equation_block(const DrawingContext& context, const FreeBody& body, bool with_names);
/// The names of the rows alone, for several tables in a row.
Block force_row_names(const DrawingContext& context);

/// The same reaction reduced to its pair's point, where it has a couple there (a sleeve, a clamp): the force with that
/// couple is the single force of `applied`, moved aside by d = M/F. Null where there is none.
const JointForce* at_the_pair(const Solution& solution, const FreeBody& body, const AppliedForce& applied);

/// Where a slider's reaction passes beside its guide: how far from the joint's point, or that it is outside of the
/// points of slider that the guide holds, so that it tips. Empty where it passes through the joint's point.
RichText beside_guide(const DrawingContext& context, const FreeBody& body, const AppliedForce& applied);

/// Rows for the results table: loads, reactions once for each joint, efforts; their axes on `figures` are measured.
/// `at_pairs`: the couples of sleeves and clamps beside their forces, too.
std::vector<ResultRow> force_rows(const DrawingContext& context, const std::vector<Figure>& figures,
                                  bool at_pairs = true);

/// Active forces and reactions, body by body, the frame last; head and rows, `width` mm wide.
std::vector<Block> reaction_lines(const DrawingContext& context, double width);

}  // namespace kinegraph::render
