// Page plan: which bands share a page, in which rows, how wide and how high. Sets bands in their order onto the fewest
// pages, and on these so that their figures are worth most. Draws nothing.
#pragma once

#include <vector>

#include "render/layout/band_layout.hpp"

namespace kinegraph::render {

/// A band in its place on a page.
struct PlacedBand {
    std::size_t band = 0;
    Width width;
    Box room;
    Notch notch{};
};
using PlannedCell = std::vector<PlacedBand>;  ///< one under the other
using PlannedRow = std::vector<PlannedCell>;  ///< side by side
using PlannedPage = std::vector<PlannedRow>;

constexpr double row_gap = 6;  ///< between rows of bands, mm

/// What the bands of a page after the first may take: above the strip.
Box content_of(const SheetFormat& format, bool first_page);

/// What a band is worth on a page that it has to itself; less than BandLayout::possible where none holds it.
double worth_of_a_page(const BandLayouts& layouts, const SheetFormat& format, bool first_page);
struct PagePlan {
    std::vector<PlannedPage> pages;  ///< none where some band has no room on any
    double worth = BandLayout::impossible;
};
PagePlan plan_pages(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands, const SheetFormat& format);

}  // namespace kinegraph::render
