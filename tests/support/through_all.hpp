// Runs all stages on a file: reads, solves, writes the results, draws the sheet as SVG. For files that nobody would
// write.
#pragma once

#include <string_view>

#include "render/text/text.hpp"

namespace kinegraph::tests {

/// The stages that a file passed.
struct HowFar {
    bool read = false, solved = false, drawn = false;
};
/// Throws if a result is not a finite number or a mark has no place. A crash or a hang ends the program.
HowFar through_all(std::string_view text, const render::Fonts& fonts);

}  // namespace kinegraph::tests
