// Drawing context: the common inputs of all drawing and typesetting of a Solution, namely the Solution, theme, fonts
// and language.
#pragma once

#include "engine/solution/solution.hpp"
#include "render/page/theme.hpp"
#include "render/text/text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Whether the mechanism figure shows the given lengths, radii and angles as dimensions. automatic: those that find a
/// free place.
enum class Dimensions { automatic, on, off };

struct DrawingContext {
    const Solution& solution;
    const Theme& theme;
    const Fonts& fonts;
    Language language = Language::en;
    Dimensions dimensions = Dimensions::automatic;
};

}  // namespace kinegraph::render
