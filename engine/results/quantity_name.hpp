// Names of quantities in the results file.
#pragma once

#include <string>

#include "engine/sentences/quantity.hpp"

namespace kinegraph {

struct Solution;

/// The name of a quantity in `checks` of the results file (docs/results.md): "omega 3", "velocity B x", "force A 3 on 2
/// couple". Where several bodies carry a point separately, the body is added: "velocity A on 4 y".
std::string name_of(const Quantity& quantity, const Solution& solution);
/// What it is of, as the results file and the columns name it: "3", "B", "A 3 on 2". A contact that shares its point
/// with another sliding joint names its bodies too: "P (2 on 3)".
std::string subject_of(const Quantity& quantity, const Solution& solution);

}  // namespace kinegraph
