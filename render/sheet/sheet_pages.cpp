// Rows from the top of the page downwards, each as high as its highest cell.
#include "render/sheet/sheet_pages.hpp"

#include <algorithm>
#include <utility>

#include "render/figures/caption.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double grace = 0.05;

std::vector<Figure> all_of(const DrawnFigures& figures) {
    std::vector<Figure> all;
    for (const auto& [band, drawn] : figures.by_band())
        for (const DrawnFigure& each : drawn) all.push_back(each.figure);
    return all;
}

}  // namespace

DrawnText::DrawnText(const Bands& bands, const DrawnFigures& figures, const SheetFormat& format, BandTexts& planned)
    : results_(bands.results_on(all_of(figures))), texts_(bands, results_, format, &planned) {}

std::vector<Page> SheetPages::set(std::size_t after) {
    std::vector<Page> pages;
    const std::size_t own = contents_.plan.pages().size();
    for (std::size_t p = 0; p < own; ++p) {
        std::optional<double> scale_of_mechanism;
        std::vector<Mark> marks = marks_on(p, scale_of_mechanism);
        pages.push_back(
            framed_page(context_, format_, signature_, std::move(marks), scale_of_mechanism, p + 1, own + after, p == 0));
    }
    return pages;
}

// --- heights ----------------------------------------------------------------------------------------------------------------

double SheetPages::height_of(const PlannedCell& cell) const {
    double height = -row_gap;
    for (const PlacedBand& placed : cell) height += row_gap + height_of(placed, true);
    return height;
}

/// What a band takes of its room once it is drawn; `whole`: with what the title block takes.
double SheetPages::height_of(const PlacedBand& placed, bool whole) const {
    const BandLayout layout = contents_.plan.layout_of(placed);
    double figures = 0, right = 0;
    const DrawnFigures::ByBand& by_band = std::as_const(contents_.figures).by_band();
    if (const auto drawn = by_band.find(placed.band); drawn != by_band.end())
        for (const DrawnFigure& each : drawn->second) {
            figures = layout.stacked ? figures + (figures > 0 ? gap : 0) + each.height() : std::max(figures, each.height());
            right = std::max(right, each.room.max.x);
        }
    if (layout.under > 0) return height_round(placed, layout, figures, right, whole);
    const double text = layout.divided == 0
                            ? 0
                            : contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered).height(layout.columns);
    const double notch = whole ? placed.notch.high : 0;
    if (!layout.beside) return figures + (figures > 0 && text > 0 ? text_gap : 0) + text + notch;
    return std::max(figures + (right > placed.notch.left + grace ? notch : 0), text + notch);
}

/// … of one whose text stands under and beside its figures.
double SheetPages::height_round(const PlacedBand& placed, const BandLayout& layout, double figures, double right,
                                bool whole) const {
    const ColumnText& text = contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered);
    const Notch notch = whole ? placed.notch : Notch{};
    const double words = text.height(layout.text_columns(placed.room.width(), text.measure(), figures, notch));
    return std::max(figures + (notch.high > 0 && right > notch.left + grace ? notch.high : 0), words);
}

// --- what stands where ------------------------------------------------------------------------------------------------------

std::vector<Mark> SheetPages::marks_on(std::size_t page, std::optional<double>& scale_of_mechanism) {
    std::vector<Mark> marks;
    const PlannedPage& rows = contents_.plan.pages()[page];
    const Box content = content_of(format_, page == 0);
    std::vector<double> heights;
    double spare = content.height();
    for (const PlannedRow& row : rows) {
        double height = 0;
        for (const PlannedCell& cell : row) height = std::max(height, height_of(cell));
        heights.push_back(height);
        spare -= height + (heights.size() > 1 ? row_gap : 0);
    }
    // A little of what is left loosens the rows.
    constexpr double most_air = 6;
    const double air = std::clamp(spare / static_cast<double>(rows.size()), 0.0, most_air);
    double y = content.min.y;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (const PlannedCell& cell : rows[r]) {
            double down = y;
            for (const PlacedBand& placed : cell) {
                set_band(marks, scale_of_mechanism, placed, {placed.room.min.x, down});
                down += height_of(placed, false) + row_gap + std::min(air, (heights[r] - height_of(cell)) / 2);
            }
        }
        y += heights[r] + row_gap + air;
    }
    return marks;
}

void SheetPages::set_band(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism, const PlacedBand& placed,
                          Spot at) {
    const BandLayout layout = contents_.plan.layout_of(placed);
    marks.emplace_back(GroupBegin{"band", "", "", {{"data-question", contents_.bands.list[placed.band].question}}});
    double below = 0;
    DrawnFigures::ByBand& by_band = contents_.figures.by_band();
    if (const auto figures = by_band.find(placed.band); figures != by_band.end())
        below = set_figures(marks, scale_of_mechanism, figures->second, layout.stacked, at);
    if (layout.divided > 0) set_text(marks, placed, layout, at, below);
    marks.emplace_back(GroupEnd{});
}

/// The height that they take.
double SheetPages::set_figures(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism,
                               std::vector<DrawnFigure>& figures, bool stacked, Spot at) {
    double down = 0, below = 0;
    for (DrawnFigure& drawn : figures) {
        const Spot corner{at.x + drawn.room.min.x, at.y + (stacked ? down : 0)};
        set_caption(marks, context_, drawn.figure, drawn.number, corner, drawn.room.width());
        if (drawn.number == 1) first_caption_ = corner, first_caption_width_ = drawn.room.width();
        const Box& box = drawn.figure.box;
        const Spot by{corner.x - box.min.x + 0.5 * (drawn.room.width() - box.width()), corner.y + drawn.caption - box.min.y};
        drawn.figure.move(by.x, by.y);
        marks.insert(marks.end(), drawn.figure.marks.begin(), drawn.figure.marks.end());
        render::move(drawn.beside, by.x, by.y);
        marks.insert(marks.end(), drawn.beside.begin(), drawn.beside.end());
        if (drawn.figure.kind == "mechanism" && !scale_of_mechanism) scale_of_mechanism = drawn.figure.scale;
        down += drawn.height() + gap;
        below = stacked ? down - gap : std::max(below, drawn.height());
    }
    return below;
}

void SheetPages::set_text(std::vector<Mark>& marks, const PlacedBand& placed, const BandLayout& layout, Spot at, double below) {
    const ColumnText& planned = contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered);
    const ColumnText& measured = contents_.text.of(contents_.bands.list[placed.band], layout);
    if (layout.under > 0) {
        measured.set(marks, at, layout.text_columns(placed.room.width(), planned.measure(), below, placed.notch));
    } else {
        const double width = layout.columns * (planned.measure() + gap) - gap;
        const Spot corner =
            layout.beside ? Spot{placed.room.max.x - width, at.y} : Spot{at.x, at.y + below + (below > 0 ? text_gap : 0)};
        measured.set(marks, corner, layout.columns, gap);
    }
}

}  // namespace kinegraph::render
