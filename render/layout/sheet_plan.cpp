// A plan for each common scale of force polygons; bands that no page can hold are divided; what has room grows.
#include "render/layout/sheet_plan.hpp"

#include <algorithm>
#include <utility>

#include "engine/number/assert.hpp"
#include "render/page/scale.hpp"

namespace kinegraph::render {

namespace {

constexpr int columns_more_at_first = 1, columns_more_for_small = 2;
constexpr double packed = 0.85;                  // of a page, about the most that plans reach
constexpr double larger_text[] = {1.25, 1.125};  // relative to the text of the format

}  // namespace

void SheetPlan::make() {
    if (now_.texts->size() != format_.text_size) now_ = {texts_of(format_.text_size)};
    large_.clear();
    find_pages();
    try_finer_force_scales();
    enlarge_figures();
    for (const double larger : larger_text)
        if (may_enlarge_text_ && may_hold_text(larger) && enlarge_text(larger * format_.text_size)) break;
    fill_rooms();
}

const BandLayout& SheetPlan::layout_of(const PlacedBand& placed) const {
    std::optional<BandLayout>& taken = now_.taken[placed.band];
    if (!taken) taken = now_.layouts[placed.band].in(placed.width, placed.room.height(), placed.notch);
    return *taken;
}

std::shared_ptr<BandTexts> SheetPlan::texts_of(double size) const {
    return std::make_shared<BandTexts>(bands_, bands_.results(), format_, size);
}

/// Plans anew, with no figure at a coarser scale. Keeps the plan before, and returns false, if it has fewer pages.
bool SheetPlan::improves(std::shared_ptr<BandTexts> texts) {
    not_coarser_ = scales();
    Planned before = std::exchange(now_, {std::move(texts)});
    const bool good = plan_all([&](const Planned& plan) { return plan.pages.size() <= before.pages.size(); });
    not_coarser_.reset();
    if (!good) now_ = std::move(before);
    return good;
}

/// Whether each page has area enough for its figures and a larger text: a bound that is quick to compute.
bool SheetPlan::may_hold_text(double larger) const {
    for (const PlannedPage& page : now_.pages) {
        const Box content = content_of(format_, &page == &now_.pages.front());
        double taken = 0;
        for (const PlannedRow& row : page)
            for (const PlannedCell& cell : row)
                for (const PlacedBand& placed : cell) {
                    const BandLayout& layout = layout_of(placed);
                    for (const FigureSize& size : layout.sizes) taken += size.x * size.y;
                    if (layout.divided == 0) continue;
                    const ColumnText& text = layouts(placed.band).text(layout.divided, layout.cornered);
                    taken += larger * larger * text.measure() * text.whole_height();
                }
        if (taken > packed * content.width() * content.height()) return false;
    }
    return true;
}

bool SheetPlan::enlarge_text(double size) {
    const std::shared_ptr<BandTexts> texts = texts_of(size);
    const auto is_too_wide = [&](const Band& band) { return texts->has_too_wide(band, format_.columns, false); };
    return std::none_of(bands_.list.begin(), bands_.list.end(), is_too_wide) && improves(texts);
}

/// Where force polygons could hardly be measured: plans anew with finer common scales, and keeps what is worth more.
void SheetPlan::try_finer_force_scales() {
    const std::optional<double> kept = force_scale_;
    if (!kept) return;
    for (const double scale : measured_.force_scales_between(*kept, hardly_measured)) {
        Planned before = std::exchange(now_, {now_.texts});
        now_.layouts = std::vector(before.layouts);
        force_scale_ = scale;
        if (plan_all([&](const Planned& plan) { return plan.score > before.score; })) return;
        now_ = std::move(before);
        force_scale_ = kept;
    }
}

/// Whether less than two fifths of the room of a band are covered.
bool SheetPlan::is_white(const PlacedBand& placed, const BandLayout& layout) const {
    constexpr double little = 0.4;
    return layouts(placed.band).taken_by(layout) < little * placed.room.width() * placed.room.height();
}

/// Figures that have their largest size may be larger where their bands have room for the next scale.
void SheetPlan::enlarge_figures() {
    for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        const Band& band = bands_.list[placed.band];
        if (!is_white(placed, layout)) return;
        for (std::size_t f = 0; f < layout.rooms.size(); ++f) {
            const FigureSize& size = layout.sizes[f];
            const Wanted& wanted = wanted_.list[band.figures[f]];
            if (!(size.x > 0) || wanted.to_force_scale || wanted.empty || wanted.asked) continue;
            // Its strokes grow, its names do not.
            const double finer = finer_scale(size.scale);
            const double more = 1 / finer - 1 / size.scale;
            if (size.x + more * wanted.extent_x < placed.room.width() &&
                size.y + more * wanted.extent_y < placed.room.height())
                large_.insert(band.question);
        }
    });
    if (!large_.empty() && !improves(now_.texts)) large_.clear();
}

/// Small figures, and all those of white bands, grow in the rooms that the plan gave to their bands; nothing else
/// moves.
void SheetPlan::fill_rooms() {
    if (force_scale_)
        for (const double scale : measured_.force_scales_between(*force_scale_, large_enough))
            if (fills_rooms_with_forces(scale)) break;
    for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        const Spot room{placed.room.width(), placed.room.height()};
        const double enough = is_white(placed, layout) ? room.x : large_enough;
        double left = packed * room.x * room.y;  // mm² that nothing covers
        for (const FigureSize& size : layout.sizes) left -= size.x * size.y;
        if (layout.divided > 0) {
            const ColumnText& text = layouts(placed.band).text(layout.divided, layout.cornered);
            left -= text.measure() * text.whole_height();
        }
        std::vector<std::vector<FigureSize>> sizes;
        bool may_grow = false;
        for (std::size_t f = 0; f < layout.sizes.size(); ++f) {
            sizes.push_back(
                measured_.grown(bands_.list[placed.band].figures[f], layout.sizes[f], {room, left, enough}));
            may_grow = may_grow || !sizes.back().empty();
            sizes.back().push_back(layout.sizes[f]);
        }
        if (!may_grow) return;
        if (std::optional<BandLayout> grown = filled(placed, std::move(sizes)); grown && grown->score > layout.score)
            now_.taken[placed.band] = std::move(grown);
    });
}

/// Whether all bands have room for their force polygons at this scale; they have it then.
bool SheetPlan::fills_rooms_with_forces(double scale) {
    std::vector<std::optional<BandLayout>> grown = now_.taken;
    bool all = true;
    for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        std::vector<std::vector<FigureSize>> sizes;
        bool has_forces = false;
        for (std::size_t f = 0; f < layout.sizes.size(); ++f) {
            const std::size_t figure = bands_.list[placed.band].figures[f];
            const bool of_forces = all && wanted_.list[figure].to_force_scale && layout.sizes[f].x > 0;
            has_forces = has_forces || of_forces;
            sizes.push_back(of_forces ? measured_.drawn_sizes(figure, scale, MeasuredFigures::Range::usual)
                                      : std::vector{layout.sizes[f]});
        }
        if (has_forces) all = (grown[placed.band] = filled(placed, std::move(sizes))).has_value() && all;
    });
    if (!all) return false;
    now_.taken = std::move(grown);
    force_scale_ = scale;
    return true;
}

/// The best layout of a band with other sizes of its figures in the room that it has. Empty: there is none.
std::optional<BandLayout> SheetPlan::filled(const PlacedBand& placed,
                                            std::vector<std::vector<FigureSize>> sizes) const {
    const Band& band = bands_.list[placed.band];
    const BandLayouts layouts(*now_.texts, band, wanted_, measured_, format_, std::move(sizes),
                              !wide_.contains(band.question));
    BandLayout best = layouts.in(placed.width, placed.room.height(), placed.notch);
    return best.score < BandLayout::possible ? std::nullopt : std::optional(std::move(best));
}

bool SheetPlan::has_wide_tables(const std::string& question, int divided) {
    if (divided > format_.columns) return wide_.insert(question).second;
    return std::exchange(may_enlarge_text_, false);
}

/// Figures are small, and more bands stand side by side, only where that is worth more.
void SheetPlan::find_pages() {
    small_ = false;
    columns_more_ = columns_more_at_first;
    const bool found = finds_pages(BandLayout::impossible);
    if (found && (now_.pages.size() == 1 || !may_be_small())) return;
    const std::optional<double> force_scale = force_scale_;
    Planned before = std::exchange(now_, {now_.texts});
    small_ = true;
    columns_more_ = columns_more_for_small;
    if (finds_pages(before.score)) return;
    if (found) {
        columns_more_ = columns_more_at_first;
        small_ = false;
        now_ = std::move(before);
        force_scale_ = force_scale;
        return;
    }
    give_each_a_page();
    const bool divided = finds_pages(BandLayout::impossible);
    KG_ASSERT(divided, "each band has a page");
}

bool SheetPlan::may_be_small() {
    using Range = MeasuredFigures::Range;
    for (const Band& band : bands_.list)
        for (const std::size_t figure : band.figures)
            if (measured_.has_more_sizes(figure, force_scale_, Range::small)) return true;
    return false;
}

/// Plans at each common scale of forces, and keeps the best plan. False if none is worth more than `least`.
bool SheetPlan::finds_pages(double least) {
    std::vector<double> scales = measured_.force_scales();
    std::optional<double> best;
    Planned plan;
    const auto may_do = [&](const Planned& now) { return now.score > least && (!best || now.score > plan.score); };
    if (scales.empty()) return plan_all(may_do);
    for (const double scale : scales) {
        force_scale_ = scale;
        if (!plan_all(may_do)) continue;
        best = scale;
        plan = Planned(now_);
    }
    if (best) force_scale_ = best, now_ = std::move(plan);
    return best.has_value();
}

/// Plans, draws what the plan has chosen by its strokes alone, and plans again with what that takes, until all that is
/// chosen is drawn. False as soon as there is no plan that may do: drawn figures take more space than estimated ones.
bool SheetPlan::plan_all(const std::function<bool(const Planned&)>& may_do) {
    do {
        plan_once();
        if (now_.pages.empty() || !may_do(now_)) return false;
    } while (draws_what_is_chosen());
    return true;
}

void SheetPlan::plan_once() {
    std::vector<BandLayouts> before = std::move(now_.layouts);
    now_.layouts.clear();
    for (std::size_t b = 0; b < bands_.list.size(); ++b) {
        BandLayouts layouts = layouts_of(bands_.list[b]);
        const bool same = b < before.size() && before[b].is_like(layouts);
        now_.layouts.push_back(std::move(same ? before[b] : layouts));
    }
    PagePlan plan = plan_pages(now_.layouts, bands_.list, format_, columns_more_);
    now_.taken.assign(now_.layouts.size(), std::nullopt);
    now_.pages = std::move(plan.pages);
    now_.score = plan.score;
}

bool SheetPlan::draws_what_is_chosen() {
    bool any = false;
    for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        for (std::size_t f = 0; f < layout.sizes.size(); ++f)
            any = measured_.draws(bands_.list[placed.band].figures[f], layout.sizes[f]) || any;
    });
    return any;
}

KeptScales SheetPlan::scales() const {
    KeptScales kept;
    kept.of_forces = force_scale_;
    for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        for (std::size_t f = 0; f < layout.rooms.size(); ++f) {
            if (!(layout.rooms[f].x > 0)) continue;
            const std::size_t figure = bands_.list[placed.band].figures[f];
            const std::string name = wanted_.kept_as(wanted_.list[figure].id);
            kept.of_figures[name] = layout.sizes[f].scale;
            if (wanted_.list[figure].arrow > 0 && !layout.sizes[f].estimated)
                kept.of_figures[KeptScales::vectors_of(name)] = measured_.drawing(figure, layout.sizes[f]).scale;
        }
    });
    return kept;
}

// --- bands that no page can hold

namespace {

/// Reduces a number of rows so that no table that a page holds is divided, and neither the first row of a list stands
/// alone on a page nor its last one on the next. Not below `fewest`.
std::size_t without_widows(const std::vector<BandTexts::RowsOfPassage>& passages, std::size_t rows,
                           std::size_t fewest) {
    std::size_t first = 0;
    for (const BandTexts::RowsOfPassage& own : passages) {
        const std::size_t end = first + own.count;
        if (rows <= first || rows >= end) {
            first = end;
            continue;
        }
        std::size_t before = end - rows == 1 ? rows - 1 : rows;
        if (before - first <= 1 || (own.is_table && own.count < long_table)) before = first;
        return before >= fewest ? before : rows;
    }
    return rows;
}

}  // namespace

void SheetPlan::give_each_a_page() {
    now_.layouts.clear();
    rejoin();
    draws_all_ = true;
    for (std::size_t b = 0; b < bands_.list.size(); ++b)
        while (score_of(b, bands_.list[b].end_row) < BandLayout::possible)
            if (const std::size_t rows = rows_for_a_page(b); rows > 0)
                divide(b, rows);
            else if (!crowded_.insert(bands_.list[b].question).second)
                part_figures(b);
    draws_all_ = false;
}

/// The score of a band that has a page to itself, with its text up to row `end_row`.
double SheetPlan::score_of(std::size_t index, std::size_t end_row) {
    Band band = bands_.list[index];
    band.end_row = end_row;
    return score_of_page(layouts_of(band), format_, index == 0);
}

/// The greatest number of rows with which a page shows the figures about as large as without text. 0: not even the
/// fewest rows fit.
std::size_t SheetPlan::rows_for_a_page(std::size_t index) {
    constexpr std::size_t fewest = 2;
    constexpr double one_step = 0.7;  // of the scale
    const Band& band = bands_.list[index];
    const std::size_t all = now_.texts->rows(band);
    const auto score = [&](std::size_t rows) { return score_of(index, band.first_row + rows); };
    const double best = all < fewest ? BandLayout::impossible : score(fewest);
    // Two rows may be higher than a page.
    if (best < BandLayout::possible) return band.figures.empty() && all > 1 && score(1) > BandLayout::possible ? 1 : 0;
    const auto is_good = [&](std::size_t rows) {
        return score(rows) > (band.figures.empty() ? BandLayout::possible : best - one_step);
    };
    std::size_t good = fewest, bad = 2 * fewest;
    for (; bad < all && is_good(bad); bad *= 2) good = bad;
    for (bad = std::min(bad, all); bad - good > 1;) {
        const std::size_t middle = (good + bad) / 2;
        (is_good(middle) ? good : bad) = middle;
    }
    const std::vector<BandTexts::RowsOfPassage> passages = now_.texts->rows_by_passage(band);
    const std::size_t rows = without_widows(passages, std::min(good, all - std::min(all - 1, fewest)), fewest);
    return rows_for_a_filled_rest(index, passages, rows, fewest);
}

/// Fewer rows, without the last tables, where the rest would leave most of its page white: the figures are larger for
/// it. Sentences stay beside their figures.
std::size_t SheetPlan::rows_for_a_filled_rest(std::size_t index, const std::vector<BandTexts::RowsOfPassage>& passages,
                                              std::size_t rows, std::size_t fewest) {
    constexpr double filled = 0.4;  // of the page
    const Box content = content_of(format_, false);
    const auto is_filled = [&](std::size_t before) {
        Band rest = bands_.list[index];
        rest.figures.clear();
        rest.first_row += before;
        const ColumnText& text = now_.texts->of(rest, format_.columns, false);
        return text.whole_height() * text.measure() >= filled * content.width() * content.height();
    };
    std::size_t first = now_.texts->rows(bands_.list[index]);
    for (std::size_t p = passages.size(); p-- > 0 && passages[p].is_table && !is_filled(rows);) {
        first -= passages[p].count;
        if (first >= fewest) rows = std::min(rows, first);
    }
    return rows;
}

BandLayouts SheetPlan::layouts_of(const Band& band) {
    using Range = MeasuredFigures::Range;
    const Range range = crowded_.contains(band.question) ? Range::crowded
                        : large_.contains(band.question) ? Range::up_to_page
                        : small_                         ? Range::small
                                                         : Range::usual;
    std::vector<std::vector<FigureSize>> sizes;
    for (const std::size_t figure : band.figures) {
        sizes.push_back(draws_all_ ? measured_.drawn_sizes(figure, force_scale_, range)
                                   : measured_.sizes(figure, force_scale_, range));
        if (!not_coarser_) continue;
        constexpr double same = 1 + 1e-9;
        const auto kept = not_coarser_->of_figures.find(wanted_.kept_as(wanted_.list[figure].id));
        if (kept == not_coarser_->of_figures.end()) continue;
        std::erase_if(sizes.back(),
                      [&](const FigureSize& size) { return !(size.x > 0) || size.scale > kept->second * same; });
    }
    return {*now_.texts, band, wanted_, measured_, format_, std::move(sizes), !wide_.contains(band.question)};
}

/// Divides a band: `rows` rows stay with its figures, the rest becomes a band without figures.
void SheetPlan::divide(std::size_t index, std::size_t rows) {
    Band& band = bands_.list[index];
    Band rest = band;
    rest.figures.clear();
    band.end_row = rest.first_row = band.first_row + rows;
    bands_.list.insert(bands_.list.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
}

/// Joins the parts of each divided band, because its figures may have other sizes now.
void SheetPlan::rejoin() {
    std::vector<Band> whole;
    for (Band& band : bands_.list)
        if (!whole.empty() && band.figures.empty() && band.question == whole.back().question &&
            band.first_row == whole.back().end_row)
            whole.back().end_row = band.end_row;
        else
            whole.push_back(std::move(band));
    bands_.list = std::move(whole);
}

/// Moves half of the figures to a band without text. If there is only one figure and no space beside it, all text is
/// moved.
void SheetPlan::part_figures(std::size_t index) {
    Band& band = bands_.list[index];
    if (band.figures.size() == 1 && band.first_row < std::min(band.end_row, now_.texts->rows(band)))
        return divide(index, 0);
    KG_ASSERT(band.figures.size() > 1, "a page holds a figure, and two rows of text");
    Band rest = band;
    const auto half = static_cast<std::ptrdiff_t>((band.figures.size() + 1) / 2);
    rest.figures.assign(band.figures.begin() + half, band.figures.end());
    rest.parts.clear();
    rest.first_row = rest.end_row = 0;
    band.figures.resize(static_cast<std::size_t>(half));
    bands_.list.insert(bands_.list.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
}

}  // namespace kinegraph::render
