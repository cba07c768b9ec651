// Tests whether the vectors to be found are long enough on the solution's sheet.
#pragma once

#include "engine/mechanism/exercise.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// False if a vector to be found in a polygon is shorter on the solution's sheet than `readable_length`. True if there
/// are no such vectors.
bool is_readable(const Solution& solution, Condition::Polygon polygon, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
