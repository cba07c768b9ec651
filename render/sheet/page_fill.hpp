// How full pages are: two ways to lay out the same solution are told apart by it.
#pragma once

#include <vector>

#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// The share (0 to 1) of squares of 10 mm within a frame on which a page has anything, tints included; 1: a frame of less than a
/// square.
double fill_of(const Page& page, const Box& frame, const Fonts& fonts);

/// What pages look like in a row: how many, and how full they are but for the last, which ends where the solution does.
struct Fill {
    std::size_t pages = 0;
    double least = 1, mean = 1;  ///< of the pages but the last; a single page lacks nothing
};
Fill fill_of(const std::vector<Page>& pages, const Box& frame, const Fonts& fonts);

/// Whether a reader would rather have these pages: fewer, or as many and fuller.
bool is_better(const Fill& one, const Fill& other);

}  // namespace kinegraph::render
