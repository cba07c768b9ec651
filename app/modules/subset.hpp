// The seam between the program and kinegraph_subset.so, the module that divides fonts for live text. HarfBuzz's
// subsetter is a library of its own, which other runs do without.
#pragma once

#include <string>
#include <string_view>

#include "render/text/subset.hpp"

namespace kinegraph::app {

/// What the module exports, under the name `kinegraph_subset`.
struct SubsetFunctions {
    std::string (*font_subset)(std::string_view file, const render::WantedType& wanted);
};

}  // namespace kinegraph::app
