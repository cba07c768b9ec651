// Names of quantities in the results file.
#pragma once

#include <string>

#include "engine/sentences/quantity.hpp"

namespace kinegraph {

struct Solution;

/// The name that `checks` of the results file prints (docs/results.md): "omega 3", "velocity B x", "force A 3 on 2
/// couple". Points that several bodies carry apart are told by their body: "velocity A on 4 y".
std::string name_of(const Quantity& quantity, const Solution& solution);

}  // namespace kinegraph
