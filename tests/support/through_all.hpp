// A file taken through everything: read, solved, its results written, its sheet drawn as SVG. For files that nobody
// would write.
#pragma once

#include <string_view>

#include "render/text/text.hpp"

namespace kinegraph::tests {

/// How far a file came.
struct HowFar {
    bool read = false, solved = false, drawn = false;
};
/// Throws where a result is no number or a mark stands nowhere. (What crashes or hangs ends the program.)
HowFar through_all(std::string_view text, const render::Fonts& fonts);

}  // namespace kinegraph::tests
