// Spread figures: moves the figures of a page within their rooms, so that white stands in smaller pieces.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// A figure whose marks are first … end - 1 of a page, and by how much it may move without leaving its room, mm.
struct MovableFigure {
    std::size_t first, end;
    double left = 0, right = 0, up = 0, down = 0;
};

/// Moves figures where the largest empty rectangle of the page becomes clearly smaller; nothing else moves. `content`:
/// the area for bands; `block`: what stands in it besides the marks, such as the title block. Returns by how much each
/// figure has moved, mm.
std::vector<Spot> spread(std::vector<Mark>& marks, std::vector<MovableFigure> figures, const Box& content,
                         const Box& block);

}  // namespace kinegraph::render
