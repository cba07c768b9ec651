// What the figures of all problems of contact, wear and impact begin and end with.
#pragma once

#include <string>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A figure with its group opened; `scale` of `unit` for each mm.
Figure begun(const char* kind, const char* id, const Words& caption, double scale, const std::string& unit,
             Language language);
/// Its group closed, its labels placed within the room, its box at the origin.
Figure finished(Figure figure, const DrawingContext& context, Spot room);

}  // namespace kinegraph::render
