// Bars of a truss by their names: what a reader calls them by instead of the numbers of the file.
#pragma once

#include <string>

#include "engine/solution/solution.hpp"

namespace kinegraph::render {

/// A bar by its pins, "AB"; null where the body is no bar of a truss, or where what is asked for calls bars by their
/// numbers.
const std::string* name_of_bar(const Solution& solution, BodyIndex body);

}  // namespace kinegraph::render
