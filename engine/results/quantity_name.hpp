// Names of quantities in the results file.
#pragma once

#include <string>

#include "engine/sentences/quantity.hpp"

namespace kinegraph {

struct Solution;

/// The name of a quantity in `checks` of the results file (docs/results.md): "omega 3", "velocity B x", "force A 3 on 2
/// couple". Where several bodies carry a point separately, the body is added: "velocity A on 4 y".
std::string name_of(const Quantity& quantity, const Solution& solution);

}  // namespace kinegraph
