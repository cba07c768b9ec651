// The colours that a file gives its bodies, in a theme's table of looks.
#pragma once

#include <cstdint>

#include "engine/mechanism/mechanism.hpp"
#include "render/page/theme.hpp"

namespace kinegraph::render {

/// Of 0xRRGGBB.
Colour colour_of_number(std::uint32_t number);

/// The theme with the colours of the mechanism's bodies (docs/themes.md): the line as the file has it, on a dark ground
/// light enough to be seen; the tint and the letters follow from it. A theme in one ink stays as it is.
Theme with_colours_of(Theme theme, const Mechanism& mechanism);

}  // namespace kinegraph::render
