// Names of the bars of a truss, for readers instead of the body numbers of the file.
#pragma once

#include <string>

#include "engine/number/index.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// The name of a bar by its pins, "AB". Null if the body is not a bar of a truss, or if the file's questions refer to
/// bars by number.
const std::string* name_of_bar(const Solution& solution, BodyIndex body);

}  // namespace kinegraph::render
