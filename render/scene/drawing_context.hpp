// What everything that is drawn or set from a Solution is given: the Solution, the look, the type, the language.
#pragma once

#include "engine/solution/solution.hpp"
#include "render/page/theme.hpp"
#include "render/text/text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Whether the mechanism figure shows the given lengths, radii and angles as dimensions: each that finds a free place,
/// all, none.
enum class Dimensions { automatic, on, off };

struct DrawingContext {
    const Solution& solution;
    const Theme& theme;
    const Fonts& fonts;
    Language language = Language::en;
    Dimensions dimensions = Dimensions::automatic;
};

}  // namespace kinegraph::render
