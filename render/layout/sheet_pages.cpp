// Places rows from the top of the page downwards, each as high as its highest cell.
#include "render/layout/sheet_pages.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "render/figures/caption.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double notch_grace = 0.05;

/// Makes names unique on a page. Two figures may show the same element, such as the mechanism and the mechanism with
/// lines of action; in the second one its name begins with that of the figure, such as "mechanism-2".
void tell_apart(Figure& figure, std::set<std::string>& names_on_page) {
    const auto for_each_id = [&](auto look) {
        for (Mark& mark : figure.marks)
            if (auto* group = std::get_if<GroupBegin>(&mark); group && !group->id.empty()) look(group->id);
    };
    bool meets = false;
    for_each_id([&](const GroupId& id) { meets = meets || names_on_page.contains(id.text()); });
    const GroupId whole(figure.id);
    GroupId own = whole;
    for (int number = 2; names_on_page.contains(own.text()); ++number)
        own.figure = figure.id + "-" + std::to_string(number);
    for_each_id([&](GroupId& id) {
        if (meets && id == whole)
            id = own;
        else if (meets)
            id.shown_in = own.text();
        names_on_page.insert(id.text());
    });
}

std::vector<Figure> all_of(const std::vector<DrawnFigure>& drawn) {
    std::vector<Figure> all;
    for (const DrawnFigure& each : drawn) all.push_back(each.figure);
    return all;
}
std::vector<Figure> all_of(const DrawnFigures& figures) {
    std::vector<Figure> all;
    for (const auto& [band, drawn] : figures.by_band())
        for (Figure& figure : all_of(drawn)) all.push_back(std::move(figure));
    return all;
}

bool shows_detail(const std::vector<DrawnFigure>& figures, const std::string& letter) {
    return std::any_of(figures.begin(), figures.end(), [&](const DrawnFigure& drawn) {
        const std::vector<DetailOn>& details = drawn.figure.details;
        return std::any_of(details.begin(), details.end(),
                           [&](const DetailOn& detail) { return detail.letter == letter; });
    });
}

/// The rows of results as measured on the sheet. Each is read where it is longest; but no table cites a detail of
/// another band, which may stand on another page.
std::vector<ResultRow> results_measured(const Bands& bands, const DrawnFigures& figures) {
    std::vector<ResultRow> rows = bands.results_on(all_of(figures));
    for (const auto& [band, drawn] : figures.by_band()) {
        std::vector<ResultRow> own;  // measured on the figures of this band
        for (const Band::Part& part : bands.list[band].parts)
            for (const std::size_t i :
                 part.kind == Band::Part::Kind::results ? part.which : std::vector<std::size_t>{}) {
                if (rows[i].detail.empty() || shows_detail(drawn, rows[i].detail)) continue;
                if (own.empty()) own = bands.results_on(all_of(drawn));
                rows[i] = own[i];
            }
    }
    return rows;
}

}  // namespace

DrawnText::DrawnText(const Bands& bands, const DrawnFigures& figures, BandTexts& planned)
    : results_(results_measured(bands, figures)), texts_(results_, planned) {}

std::vector<Page> SheetPages::set(std::size_t after) {
    std::vector<Page> pages;
    const std::size_t own = contents_.plan.pages().size();
    for (std::size_t p = 0; p < own; ++p) {
        std::optional<double> scale_of_mechanism;
        std::vector<Mark> marks = marks_on(p, scale_of_mechanism);
        pages.push_back(framed_page(context_, format_, signature_, std::move(marks), scale_of_mechanism, p + 1,
                                    own + after, p == 0));
    }
    return pages;
}

// --- heights

SheetPages::Standing SheetPages::standing(const PlacedBand& placed) const {
    Standing band{&placed, contents_.plan.layout_of(placed)};
    const BandLayout& layout = band.layout;
    double right = 0;
    const DrawnFigures::ByBand& by_band = std::as_const(contents_.figures).by_band();
    if (const auto drawn = by_band.find(placed.band); drawn != by_band.end())
        for (const DrawnFigure& each : drawn->second) {
            band.figures = layout.stacked ? band.figures + (band.figures > 0 ? gap : 0) + each.height()
                                          : std::max(band.figures, each.height());
            right = std::max(right, each.room.max.x);
        }
    const bool has_text = layout.divided > 0;
    if (has_text && layout.under > 0) {
        const ColumnText& text = contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered);
        band.words = text.height(layout.text_columns(placed.room.width(), text.measure(), band.figures, placed.notch));
    } else {
        if (has_text)
            band.words =
                contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered).height(layout.columns);
        if (!layout.beside) band.above = band.figures + (band.figures > 0 && has_text ? text_gap : 0);
        band.below = placed.notch.high;
    }
    if (right > placed.notch.left + notch_grace) band.block = placed.notch.high;
    return band;
}

double SheetPages::Standing::height(double loose) const {
    return std::max(figures + block, above + (1 + loose) * words + below);
}
/// Bands one below the other.
double SheetPages::height_of(const StandingCell& cell, double loose) {
    double height = -row_gap;
    for (const Standing& band : cell) height += row_gap + band.height(loose);
    return height;
}
double SheetPages::height_of(const StandingRow& row, double loose) {
    double height = 0;
    for (const StandingCell& cell : row) height = std::max(height, height_of(cell, loose));
    return height;
}
double SheetPages::height_of(const std::vector<StandingRow>& rows, double loose) {
    double height = -row_gap;
    for (const StandingRow& row : rows) height += row_gap + height_of(row, loose);
    return height;
}
/// By how much rows of text may be spaced on a page of this height.
double SheetPages::looseness_of(const std::vector<StandingRow>& rows, double height) {
    constexpr double most = 0.2, fine = 0.01;
    if (height_of(rows, most) <= height) return most;
    double low = 0, high = most;
    while (high - low > fine) {
        const double middle = 0.5 * (low + high);
        (height_of(rows, middle) <= height ? low : high) = middle;
    }
    return low;
}

// --- positions

std::vector<Mark> SheetPages::marks_on(std::size_t page, std::optional<double>& scale_of_mechanism) {
    std::vector<Mark> marks;
    names_on_page_.clear();
    movable_.clear();
    figures_on_page_.clear();
    std::vector<StandingRow> rows;
    for (const PlannedRow& row : contents_.plan.pages()[page]) {
        StandingRow& cells = rows.emplace_back();
        for (const PlannedCell& cell : row) {
            StandingCell& bands = cells.emplace_back();
            for (const PlacedBand& placed : cell) bands.push_back(standing(placed));
        }
    }
    const Box content = content_of(format_, page == 0);
    // The remaining height spaces the text, then the rows; figures stand in the middle of what their band gets.
    constexpr double most_of_a_row = 24, most_of_a_band = 16;
    const double loose = looseness_of(rows, content.height());
    const double air =
        std::clamp((content.height() - height_of(rows, loose)) / static_cast<double>(rows.size()), 0.0, most_of_a_row);
    double y = content.min.y;
    for (const StandingRow& row : rows) {
        const double height = height_of(row, loose) + air;
        for (const StandingCell& cell : row) {
            double down = y;
            const double spare = (height - height_of(cell, loose)) / static_cast<double>(cell.size());
            for (const Standing& band : cell) {
                const bool last = &band == &cell.back();
                const double own = last ? y + height - down - band.height(loose) : std::min(spare, most_of_a_band);
                set_band(marks, scale_of_mechanism, band, {band.placed->room.min.x, down}, loose, own);
                down += band.height(loose) + own + row_gap;
            }
        }
        y += height + row_gap;
    }
    const std::vector<Spot> moved = spread(marks, movable_, content, page == 0 ? format_.block : Box{});
    for (std::size_t f = 0; f < moved.size(); ++f) figures_on_page_[f]->move(moved[f].x, moved[f].y);
    return marks;
}

/// `spare`: height that the band has beyond its own.
void SheetPages::set_band(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism, const Standing& band,
                          Spot at, double loose, double spare) {
    constexpr double most_above_text = 36;
    const std::size_t index = band.placed->band;
    marks.emplace_back(GroupBegin{"band", {}, "", {{"data-question", contents_.bands.list[index].question}}});
    const bool has_text = band.layout.divided > 0, is_below = has_text && (band.above > 0 || band.layout.under > 0);
    double below = 0;
    DrawnFigures::ByBand& by_band = contents_.figures.by_band();
    if (const auto figures = by_band.find(index); figures != by_band.end()) {
        below = band.figures + (band.layout.under > 0 ? spare_above_text(band, most_above_text, loose, spare)
                                                      : std::min(spare, most_above_text));
        set_figures(marks, scale_of_mechanism, figures->second, band.layout.stacked, at,
                    is_below ? below : band.height(loose) - band.block + spare);
    }
    if (has_text) set_text(marks, band, at, below, loose, band.height(loose) + spare);
    marks.emplace_back(GroupEnd{});
}

/// By how much columns of text below the figures may stand lower, where others stand beside them.
double SheetPages::spare_above_text(const Standing& band, double most, double loose, double spare) const {
    constexpr double fine = 4;
    const PlacedBand& placed = *band.placed;
    const ColumnText& text = contents_.plan.layouts(placed.band).text(band.layout.divided, band.layout.cornered);
    const double height = std::min(band.height(loose) + spare, placed.room.height()) / (1 + loose);
    most = std::min(most, band.height(loose) + spare - band.block - band.figures);  // there may be no text below them
    while (most > 0 &&
           !text.fits(band.layout.text_columns(placed.room.width(), text.measure(), band.figures + most, placed.notch),
                      height))
        most -= fine;
    return std::max(most, 0.0);
}

/// Each figure stands in the middle between its caption and the end of its part of `height`, but near its caption.
void SheetPages::set_figures(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism,
                             std::vector<DrawnFigure>& figures, bool stacked, Spot at, double height) {
    constexpr double most_below_caption = 30, most_when_spread = 60;
    double own = -gap;
    for (const DrawnFigure& drawn : figures) own = stacked ? own + gap + drawn.height() : drawn.height();
    const double shared = (height - own) / static_cast<double>(figures.size());
    double down = 0;
    for (DrawnFigure& drawn : figures) {
        const double spare = std::max(stacked ? shared : height - drawn.height(), 0.0);
        const Spot corner{at.x + drawn.room.min.x, at.y + down};
        set_caption(marks, context_, drawn.figure, drawn.number, corner, drawn.room.width());
        if (drawn.number == 1) first_caption_ = corner, first_caption_width_ = drawn.room.width();
        const Box& box = drawn.figure.box;
        const Spot by{corner.x - box.min.x + 0.5 * (drawn.room.width() - box.width()),
                      corner.y + drawn.caption - box.min.y + std::min(0.5 * spare, most_below_caption)};
        drawn.figure.move(by.x, by.y);
        const std::size_t first = marks.size();
        tell_apart(drawn.figure, names_on_page_);
        marks.insert(marks.end(), drawn.figure.marks.begin(), drawn.figure.marks.end());
        render::move(drawn.beside, by.x, by.y);
        marks.insert(marks.end(), drawn.beside.begin(), drawn.beside.end());
        const double aside = std::max(0.5 * (drawn.room.width() - box.width()), 0.0);
        const double up = std::min(0.5 * spare, most_below_caption);
        movable_.push_back({first, marks.size(), aside, aside, up, std::min(spare, most_when_spread) - up});
        figures_on_page_.push_back(&drawn.figure);
        if (drawn.figure.traits.measured == QuantityKind::length && !scale_of_mechanism)
            scale_of_mechanism = drawn.figure.scale;
        if (stacked) down += drawn.height() + spare + gap;
    }
}

/// `height`: of the band.
void SheetPages::set_text(std::vector<Mark>& marks, const Standing& band, Spot at, double below, double loose,
                          double height) {
    const PlacedBand& placed = *band.placed;
    const BandLayout& layout = band.layout;
    const ColumnText& planned = contents_.plan.layouts(placed.band).text(layout.divided, layout.cornered);
    const ColumnText& measured = contents_.text.of(contents_.bands.list[placed.band], layout);
    if (layout.under > 0) {
        measured.set(marks, at, layout.text_columns(placed.room.width(), planned.measure(), below, placed.notch), loose,
                     height);
    } else {
        const double width = layout.columns * (planned.measure() + gap) - gap;
        const Spot corner = layout.beside ? Spot{placed.room.max.x - width, at.y}
                                          : Spot{at.x, at.y + below + (below > 0 ? text_gap : 0)};
        measured.set(marks, corner, layout.columns, gap, loose, height - (corner.y - at.y) - band.below);
    }
}

}  // namespace kinegraph::render
