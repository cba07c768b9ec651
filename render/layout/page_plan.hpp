// Page plan: the rows, widths and heights of bands on pages. Finds the plan with the highest score that holds all bands
// in their order, by dynamic programming; a page has a price. Draws nothing.
#pragma once

#include <vector>

#include "render/layout/band_layout.hpp"

namespace kinegraph::render {

/// A band and its position on a page.
struct PlacedBand {
    std::size_t band = 0;
    Width width;
    Box room;
    Notch notch{};
};
using PlannedCell = std::vector<PlacedBand>;  ///< one below the other
using PlannedRow = std::vector<PlannedCell>;  ///< side by side
using PlannedPage = std::vector<PlannedRow>;

constexpr double row_gap = 6;  ///< between rows of bands, mm

/// The area for bands: on pages after the first it ends above the strip.
Box content_of(const SheetFormat& format, bool first_page);

/// The score of a band that has a page to itself. Below BandLayout::possible if the page cannot hold it.
double score_of_page(const BandLayouts& layouts, const SheetFormat& format, bool first_page);
struct PagePlan {
    std::vector<PlannedPage> pages;  ///< empty if no page can hold some band
    double score = BandLayout::impossible;
};
/// `columns_more`: bands side by side may also share the page in so many columns more than those of the format.
PagePlan plan_pages(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands, const SheetFormat& format,
                    int columns_more);

}  // namespace kinegraph::render
