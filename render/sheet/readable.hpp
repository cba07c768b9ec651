// Whether the vectors that are sought can be read on the sheet of a solution.
#pragma once

#include "engine/mechanism/exercise.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// True where no vector that is sought in a polygon is shorter on the solution's sheet than `readable_length`; also of
/// a solution without such vectors.
bool is_readable(const Solution& solution, Condition::Polygon polygon, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
