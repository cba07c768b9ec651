// Workings: the arithmetic of the sentences, once the record has its values: v_A = ω·r, ω_3 = v_BA/AB, a_cor =
// 2·ω·v_rel, F_i = m·a_G. Each is told with the numbers that the drawing gives; none is a source of a result.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Adds to every statement of the finished solution what it works out, in the file's units and rounded by no one yet,
/// and takes out of its sentence what vanishes: ω² of a body that translates, a Coriolis term of none. A product that
/// does not come out to the value found is left unsaid.
void add_workings(Solution& solution);

}  // namespace kinegraph
