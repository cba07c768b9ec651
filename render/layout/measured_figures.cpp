// Which scales are tried, what a size is worth, and what a caption takes.
#include "render/layout/measured_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/number/functions.hpp"
#include "render/figures/caption.hpp"
#include "render/layout/free_corner.hpp"
#include "render/page/scale.hpp"

namespace kinegraph::render {
namespace {

constexpr double rounding = 1e-9;
constexpr double nothing = 1e-20;            // an extent that is that of a point
constexpr double largest_of_scaled = 130;    // mm; a figure gains nothing from a larger size
constexpr double not_small = 24;             // mm; lengths can be read to half a percent
constexpr double unreadable_of_forces = 25;  // mm; a smaller force polygon is drawn at a finer scale than the others …
constexpr double readable_of_forces = 40;    // … as may one that is smaller than this, where the plan has room …
constexpr double own_scale_of_forces = 60;   // … at which it is not larger than this

/// How long the longest vector is at least, mm, where it acts on something at this scale.
double arrow_at(const Wanted& wanted, double scale) {
    constexpr double of_body = 0.4, least = 0.4;
    return std::clamp(of_body * wanted.extent_of_subject() / scale, least * wanted.arrow, wanted.arrow);
}

/// A body shows no more forces when it is larger than this, mm.
double most_of(const Wanted& wanted) { return wanted.arrow > 0 ? 110 : std::numeric_limits<double>::infinity(); }

/// The score of a figure of this size (mm). Roughly the number of scale steps, with a penalty for small figures, and a
/// greater one for those that can hardly be read. Above 80 mm lengths can be read to a hundredth or better, and a
/// larger figure gains little.
double use_of_figure(double size) {
    constexpr double long_enough = 80, of_more = 0.3, hardly_read = 20;
    const double read = std::min(size, long_enough), small = hardly_read / read;
    return nearest::log(read) - 40 / read - small * small * small + of_more * nearest::log(size / read);
}

/// What is measured on a polygon is shorter than its longest vector: of two polygons the smaller one gains more by a
/// step of the scale than the larger one by two, below this size.
double price_of_coarse_reading(double size) {
    constexpr double readable = 40, of_a_step = 1.5;
    return size < readable ? of_a_step * nearest::log(readable / size) : 0;
}

/// Whether vectors are measured on it, at a scale of its own.
bool is_measured(const Wanted& wanted) {
    return !(wanted.arrow > 0) && !wanted.to_force_scale &&
           row_of(wanted.id.kind).traits.measured != QuantityKind::length;
}

}  // namespace

const std::vector<FigureSize>& MeasuredFigures::sizes(std::size_t figure, std::optional<double> force_scale,
                                                      Range range) {
    const Wanted& wanted = wanted_.list[figure];
    if (!wanted.to_force_scale) force_scale.reset();
    const auto [found, fresh] = sizes_.try_emplace({figure, force_scale.value_or(0), range});
    Sizes& known = found->second;
    std::vector<FigureSize>& sizes = known.list;
    if (!fresh && known.drawings == times_drawn_[figure]) return sizes;
    sizes.clear();
    for (const Measure& each : measures(wanted, force_scale, range)) {
        // A scale in the file is kept even if it costs a page, provided that the figure fits on a page.
        const bool asked = each.wish.asked.has_value() && !wanted.spare;
        if (asked) drawn(figure, each);
        measure(sizes, figure, each, range);
        if (sizes.empty() || !asked) continue;
        const Box& box = drawing(figure, sizes.back()).box;
        if (range != Range::crowded && box.width() <= page().x && box.height() <= page().y) break;
    }
    std::stable_sort(sizes.begin(), sizes.end(),
                     [](const FigureSize& one, const FigureSize& other) { return one.score > other.score; });
    // What is larger than a page has that page; the first one has its title block.
    const double most = format_.block.min.y - above_block - format_.content.min.y;
    if (range == Range::crowded)
        for (FigureSize& size : sizes) size.y = std::min(size.y, most);
    if (wanted.spare) sizes.push_back({});
    known.drawings = times_drawn_[figure];
    return sizes;
}

const std::vector<FigureSize>& MeasuredFigures::drawn_sizes(std::size_t figure, std::optional<double> force_scale,
                                                            Range range) {
    for (;;) {
        const std::vector<FigureSize>& all = sizes(figure, force_scale, range);
        bool any = false;
        for (const FigureSize& size : all) any = draws(figure, size) || any;
        if (!any) return all;
    }
}

bool MeasuredFigures::draws(std::size_t figure, const FigureSize& size) {
    if (!size.estimated) return false;
    Drawing& drawing = drawings_[figure][size.drawing];
    if (drawing.figure) return false;
    ScaleWish wish = drawing.wish;
    wish.has_steps = true;
    drawing.figure = wanted_.draw(figure, drawing.room, wish);
    ++times_drawn_[figure];
    return true;
}

bool MeasuredFigures::has_more_sizes(std::size_t figure, std::optional<double> force_scale, Range range) const {
    const Wanted& wanted = wanted_.list[figure];
    if (!wanted.to_force_scale) force_scale.reset();
    return measures(wanted, force_scale, range).size() != measures(wanted, force_scale, Range::usual).size();
}

bool MeasuredFigures::may_grow(std::size_t figure) const {
    const Wanted& wanted = wanted_.list[figure];
    const bool is_kept = kept_ && kept_->of_figures.contains(wanted_.kept_as(wanted.id));
    // A force polygon leaves the common scale only where its vectors could hardly be read.
    const bool is_bound = wanted.to_force_scale && !wanted.may_be_larger;
    return !is_kept && !is_bound && !wanted.empty && !wanted.spare && !wanted.asked && wanted.extent() >= nothing;
}

std::vector<FigureSize> MeasuredFigures::grown(std::size_t figure, const FigureSize& now, const Growth& growth) {
    const Wanted& wanted = wanted_.list[figure];
    std::vector<FigureSize> sizes;
    const double enough = wanted.to_force_scale ? readable_of_forces : std::min(growth.enough, most_of(wanted));
    if (!may_grow(figure) || !(now.x > 0) || wanted.extent_of_subject() / now.scale >= enough) return sizes;
    const Spot most{std::min(growth.room.x, page().x), std::min(growth.room.y - caption_line, page().y)};
    for (const double scale : finer_scales(wanted, now.scale, growth.enough > large_enough)) {
        // Its strokes grow, its names do not.
        const double more = 1 / scale - 1 / now.scale;
        const Spot own{now.x + more * wanted.extent_x, now.y + more * wanted.extent_y};
        if (wanted.extent_of_subject() / scale > most_of(wanted) || own.x > growth.room.x || own.y > growth.room.y ||
            own.x * own.y > now.x * now.y + growth.left)
            continue;
        const Measure measure{scale, most, {.finest = scale, .exactly = true, .arrow = wanted.arrow}};
        const std::size_t drawing = drawn(figure, measure);
        const Figure& made = *drawings_[figure][drawing].figure;
        if (made.scale == any_scale || made.box.width() > most.x || made.box.height() > most.y) continue;
        add_sizes(sizes, figure, drawing, score_of(wanted, measure, &made, page().x), scale);
    }
    std::stable_sort(sizes.begin(), sizes.end(),
                     [](const FigureSize& one, const FigureSize& other) { return one.score > other.score; });
    return sizes;
}

/// The scales to which a figure may grow, the finest first: what is large enough to be measured keeps those of the
/// series.
std::vector<double> MeasuredFigures::finer_scales(const Wanted& wanted, double scale, bool is_white) const {
    const double finest = finer_scale(scale);
    if (wanted.arrow > 0) return {finer_scale(finest), finest, scale};
    if (row_of(wanted.id.kind).traits.measured == QuantityKind::length ||
        (!is_white && wanted.extent_of_subject() / scale >= hardly_measured))
        return {finest};
    return scales_between(finest, scale);
}

/// `drawing`: it may have come at a coarser scale.
double MeasuredFigures::score_of(const Wanted& wanted, const Measure& measure, const Figure* drawing,
                                 double enough) const {
    constexpr double as_asked = 6;
    constexpr double price_of_short_arrows = 0.5;  // for arrows of no length
    const bool has_own = drawing != nullptr && drawing->scale != any_scale && !wanted.fills;
    const double own = !has_own ? 0 : wanted.arrow > 0 ? drawing->places : drawing->scale;
    const double size = std::clamp(wanted.extent_of_subject() / std::max(own, measure.scale), 1.0, enough);
    const double lack = is_measured(wanted) ? price_of_coarse_reading(size) : 0;
    return wanted.weight * (use_of_figure(size) - lack) + (measure.wish.asked && !wanted.spare ? as_asked : 0) -
           (wanted.arrow > 0 ? price_of_short_arrows * (1 - measure.wish.arrow / wanted.arrow) : 0);
}

/// Names spread where they have space. If they make the figure wider than a column, it is also drawn with its names
/// within that column, as far as they find places there.
void MeasuredFigures::measure(std::vector<FigureSize>& sizes, std::size_t figure, const Measure& measure, Range range) {
    const Wanted& wanted = wanted_.list[figure];
    const std::size_t free = entered(figure, measure);
    const Figure* drawing = drawings_[figure][free].figure ? &*drawings_[figure][free].figure : nullptr;
    const double score = score_of(wanted, measure, drawing, range == Range::up_to_page ? page().x : wanted.enough);
    if (drawing == nullptr) {
        const Spot names = about_strokes(figure);
        sizes.push_back({.x = std::min(wanted.extent_x / measure.scale + names.x, page().x),
                         .y = std::min(wanted.extent_y / measure.scale + names.y, page().y) + caption_line,
                         .score = score,
                         .scale = measure.scale,
                         .caption = caption_line,
                         .drawing = free,
                         .estimated = true});
        return;
    }
    if (drawing->scale == any_scale) return;
    // A drawing of places has the scale of its vectors; that of its strokes is another.
    const auto scale_of = [&](const Figure& drawn) {
        return wanted.fills ? measure.scale : wanted.arrow > 0 ? drawn.places : drawn.scale;
    };
    add_sizes(sizes, figure, free, score, scale_of(*drawing));
    // Enlarged details want room, and names that are in a key already find no place in less.
    if (!(measure.wish.finest > 0) || !drawing->details.empty() || drawing->has_key) return;
    constexpr double least_round = 8;  // mm, for names beside the strokes
    constexpr double price_of_narrow = 0.05;
    constexpr double least_share = 0.75;  // of the width; names hardly ever find places in less
    double width = drawing->box.width();
    const double strokes = wanted.extent_x / measure.scale;
    while (const auto column = narrower(width, std::max(strokes + least_round, least_share * width))) {
        ScaleWish close = measure.wish;
        close.asked.reset();
        close.strict = close.exactly = true;
        const std::size_t narrow = entered(figure, {measure.scale, {*column, page().y}, close});
        if (!drawings_[figure][narrow].figure) {
            sizes.push_back({.x = *column,
                             .y = std::min(drawing->box.height(), page().y) + caption_line,
                             .score = score - price_of_narrow,
                             .scale = scale_of(*drawing),
                             .caption = caption_line,
                             .drawing = narrow,
                             .estimated = true});
            return;
        }
        const Figure& other = *drawings_[figure][narrow].figure;
        const bool is_coarser = scale_of(other) > scale_of(*drawing) * (1 + rounding);
        if (other.scale == any_scale || is_coarser || other.box.width() > *column || other.has_key) return;
        add_sizes(sizes, figure, narrow, score - price_of_narrow, scale_of(other));
        width = other.box.width();
    }
}

/// What names take about the strokes at other scales, at least: half of what they take in the drawing in which they
/// take least, so that no scale is passed over that has room. As long as the figure is not drawn at any scale, what
/// they take in most figures.
Spot MeasuredFigures::about_strokes(std::size_t figure) const {
    const Wanted& wanted = wanted_.list[figure];
    std::optional<Spot> least;
    for (const Drawing& drawing : drawings_[figure]) {
        if (!drawing.figure || drawing.wish.strict || drawing.figure->scale == any_scale) continue;
        const double scale = wanted.arrow > 0 ? drawing.figure->places : drawing.figure->scale;
        const Spot names{std::max(drawing.figure->box.width() - wanted.extent_x / scale, 0.0),
                         std::max(drawing.figure->box.height() - wanted.extent_y / scale, 0.0)};
        least = least ? Spot{std::min(least->x, names.x), std::min(least->y, names.y)} : names;
    }
    constexpr double certain = 0.5;
    constexpr Spot of_most{14, 10};  // mm
    return least ? Spot{certain * least->x, certain * least->y} : of_most;
}

/// The widest column or columns of less than `width` and at least `least` mm.
std::optional<double> MeasuredFigures::narrower(double width, double least) const {
    std::optional<double> widest;
    for (const int of : {format_.columns, format_.columns + 1})
        for (int columns = 1; columns <= of; ++columns) {
            const double span = format_.span(columns, of);
            if (span < width && span >= least && span > widest.value_or(0)) widest = span;
        }
    return widest;
}

/// The largest single polygon of forces; null if there is none.
const Wanted* MeasuredFigures::largest_of_forces() const {
    const Wanted* largest = nullptr;
    for (const Wanted& each : wanted_.list)
        if (each.to_force_scale && !each.is_row && (largest == nullptr || each.extent() > largest->extent()))
            largest = &each;
    return largest;
}

std::vector<double> MeasuredFigures::force_scales() const {
    for (const Wanted& each : wanted_.list)
        if (each.to_force_scale && each.asked) return {};
    const Wanted* largest = largest_of_forces();
    std::vector<double> scales;
    if (largest == nullptr || largest->extent() < nothing) return scales;
    for (double scale = choose_scale(largest->extent(), 0, largest->enough, 1, std::nullopt);
         scales.empty() || largest->extent() / scale >= std::max(largest->least, hardly_readable);
         scale = next_scale(scale))
        scales.push_back(scale);
    if (kept_ && kept_->of_forces) {
        if (kept_->hold == KeptScales::Hold::exactly) return {*kept_->of_forces};
        std::erase_if(scales, [&](double scale) { return scale > *kept_->of_forces * (1 + rounding); });
        if (scales.empty()) return {*kept_->of_forces};
    }
    return scales;
}

std::vector<double> MeasuredFigures::force_scales_between(double scale, double enough) const {
    const Wanted* largest = largest_of_forces();
    if (largest == nullptr || (kept_ && kept_->of_forces)) return {};
    const double size = largest->extent_of_subject() / scale;
    if (size >= enough) return {};
    return size < hardly_measured ? scales_between(finer_scale(scale), scale) : std::vector{finer_scale(scale)};
}

std::vector<MeasuredFigures::Measure> MeasuredFigures::measures(const Wanted& wanted, std::optional<double> force_scale,
                                                                Range range) const {
    if (wanted.empty) return {{1, {60, 30}, {}}};
    if (wanted.fills) return {filling(wanted)};
    if (wanted.extent() < nothing) return with_arrows(wanted, {{1, page(), {}}});
    if (wanted.to_force_scale && force_scale) return at_force_scale(wanted, *force_scale);
    return with_arrows(wanted, as_kept(wanted, at_scales(wanted, range)));
}

/// Only with the scale that is kept. What was left out to save room stays so.
std::vector<MeasuredFigures::Measure> MeasuredFigures::as_kept(const Wanted& wanted, std::vector<Measure> all) const {
    if (!kept_ || wanted.asked) return all;
    const auto scale = kept_->of_figures.find(wanted_.kept_as(wanted.id));
    if (scale == kept_->of_figures.end()) return all;
    if (kept_->hold == KeptScales::Hold::not_coarser)
        std::erase_if(all, [&](const Measure& each) { return each.scale > scale->second * (1 + rounding); });
    else
        all.clear();
    if (all.empty()) all.push_back({scale->second, page(), {.finest = scale->second}});
    // As of all scales, the last has to show something.
    all.back().wish.exactly = false;
    return all;
}

/// A room in the shape of the figure.
MeasuredFigures::Measure MeasuredFigures::filling(const Wanted& wanted) const {
    const double scale = wanted.extent() / wanted.enough;
    return {scale,
            {std::min(wanted.extent_x / scale + wanted.rim_x, page().x),
             std::min(wanted.extent_y / scale + wanted.rim_y, page().y)},
            {}};
}

/// Vectors with a scale of their own become shorter with what they act on. What has no length of its own is drawn for
/// rooms of several sizes.
std::vector<MeasuredFigures::Measure> MeasuredFigures::with_arrows(const Wanted& wanted,
                                                                   std::vector<Measure> all) const {
    if (!(wanted.arrow > 0)) return all;
    if (wanted.extent() < nothing) {
        all.clear();
        for (const double part : {1.0, 0.7, 0.5})
            all.push_back({1,
                           {part * wanted.enough + wanted.rim_x, part * wanted.enough + wanted.rim_y},
                           {.arrow = part * wanted.arrow}});
    } else {
        for (Measure& each : all) each.wish.arrow = arrow_at(wanted, each.scale);
    }
    if (!kept_) return all;
    const auto vectors = kept_->of_figures.find(KeptScales::vectors_of(wanted_.kept_as(wanted.id)));
    if (vectors == kept_->of_figures.end()) return all;
    for (Measure& each : all) {
        each.wish.vectors = vectors->second;
        if (kept_->hold == KeptScales::Hold::exactly) each.wish.arrow = 0;
    }
    return all;
}

/// A row of polygons may also stand in several rows. At the coarsest common scale a polygon whose names want more room
/// may come coarser still; a finer scale is common to all or not taken.
std::vector<MeasuredFigures::Measure> MeasuredFigures::at_force_scale(const Wanted& wanted, double force_scale) const {
    constexpr double part_that_must = 0.35, part_that_may = 0.5;  // of the largest polygon
    std::vector<double> scales{force_scale};
    const double size = wanted.extent() / force_scale, part = wanted.extent() / largest_of_forces()->extent();
    if (wanted.may_be_larger && size < readable_of_forces && part <= part_that_may) {
        const double own = choose_scale(wanted.extent(), 0, own_scale_of_forces, 1, std::nullopt);
        if (size < unreadable_of_forces && part <= part_that_must)
            scales = {own};
        else if (own < force_scale)
            scales.push_back(own);
    }
    if (kept_ && wanted.may_be_larger)
        if (const auto own = kept_->of_figures.find(wanted_.kept_as(wanted.id)); own != kept_->of_figures.end())
            for (double& scale : scales) scale = std::min(scale, own->second);
    const std::vector<double> common = force_scales();
    const bool exactly = !common.empty() && force_scale < common.back() * (1 - rounding);
    std::vector<Measure> all;
    for (const double scale : scales)
        for (int columns = wanted.is_row ? 1 : format_.columns; columns <= format_.columns; ++columns)
            all.push_back(
                {scale, {format_.span(columns, format_.columns), page().y}, {.finest = scale, .exactly = exactly}});
    return all;
}

std::vector<MeasuredFigures::Measure> MeasuredFigures::at_scales(const Wanted& wanted, Range range) const {
    std::vector<Measure> all;
    if (wanted.asked) all.push_back({*wanted.asked, page(), {0, wanted.asked}});
    const double largest = range == Range::up_to_page && !wanted.is_straight
                               ? std::min(page().x, most_of(wanted))
                               : std::min(largest_of_scaled, wanted.enough);
    // Little is measured on a body with its forces: it may be smaller than what is read.
    const bool may_be_small = range == Range::crowded || range == Range::small || wanted.arrow > 0;
    const double smallest = may_be_small ? hardly_readable : not_small;
    const double least = std::max(range == Range::crowded ? 0 : wanted.least, smallest);
    double scale = choose_scale(wanted.extent_x, wanted.extent_y, std::min(page().x, largest),
                                std::min(page().y, largest), std::nullopt);
    for (bool first = true; first || (!wanted.spare && wanted.extent() / scale >= least * (1 - rounding));
         first = false) {
        all.push_back({scale, page(), {.finest = scale, .exactly = true}});
        scale = next_scale(scale);
    }
    // A polygon that would be too small at the next scale of the series may have one between them.
    if (is_measured(wanted) && !wanted.spare) {
        const std::vector<double> between = scales_between(all.back().scale * (1 + rounding), scale);
        const auto last = std::find_if(between.rbegin(), between.rend(),
                                       [&](double each) { return wanted.extent() / each >= least * (1 - rounding); });
        if (last != between.rend()) all.push_back({*last, page(), {.finest = *last, .exactly = true}});
    }
    // The last has to show something.
    all.back().wish.exactly = false;
    return all;
}

/// The drawing of a figure for a measure, which may still have to be made. What had room at the finest scale is the
/// same drawing whether or not it might have come coarser.
std::size_t MeasuredFigures::entered(std::size_t figure, const Measure& measure) {
    std::deque<Drawing>& known = drawings_[figure];
    for (std::size_t i = 0; i < known.size(); ++i)
        if (known[i].room.x == measure.room.x && known[i].room.y == measure.room.y &&
            known[i].wish.finest == measure.wish.finest && known[i].wish.asked == measure.wish.asked &&
            known[i].wish.strict == measure.wish.strict && known[i].wish.arrow == measure.wish.arrow &&
            known[i].wish.vectors == measure.wish.vectors &&
            (known[i].wish.exactly == measure.wish.exactly ||
             (known[i].figure && known[i].figure->scale == measure.wish.finest)))
            return i;
    known.push_back({measure.room, measure.wish, std::nullopt});
    return known.size() - 1;
}

std::size_t MeasuredFigures::drawn(std::size_t figure, const Measure& measure) {
    const std::size_t drawing = entered(figure, measure);
    draws(figure, {.drawing = drawing, .estimated = true});
    return drawing;
}

void MeasuredFigures::add_sizes(std::vector<FigureSize>& sizes, std::size_t figure, std::size_t drawing, double score,
                                double scale) {
    constexpr double price_of_lack = 0.4;  // about half a step of the scale
    Drawing& own = drawings_[figure][drawing];
    // Vectors too short to read, and names that stand in a key.
    if (own.figure->lacks_details || own.figure->has_key) score -= price_of_lack;
    if (own.sizes.empty()) own.sizes = sizes_of(*own.figure);
    for (FigureSize size : own.sizes) {
        size.score += score, size.scale = scale, size.drawing = drawing;
        sizes.push_back(size);
    }
}

/// With its caption in one line and, at prices, in several. At least one.
std::vector<FigureSize> MeasuredFigures::sizes_of(const Figure& drawn) const {
    constexpr double price_of_second_line = 0.5, price_of_broken_words = 1.5;  // a line that breaks is read as two
    constexpr double least_of_caption = 40;                                    // mm
    constexpr int number = 88;                                                 // as wide as any that a sheet has
    const double own = std::min(drawn.box.width(), page().x), high = std::min(drawn.box.height(), page().y);
    const double whole = caption_width(context_, drawn, number);
    std::vector<FigureSize> sizes;
    if (whole <= format_.content.width()) {
        sizes.push_back({.x = std::max(own, whole), .y = high + caption_line, .caption = caption_line});
        if (whole <= own) return sizes;
    }
    const double words = caption_width_without_scale(context_, drawn, number);
    const auto add = [&](double width, double price) {
        std::vector<Mark> unused;
        const double caption = set_caption(unused, context_, drawn, number, {0, 0}, width);
        sizes.push_back({.x = width, .y = high + caption, .score = -price, .caption = caption});
    };
    // With the scale on a line of its own, and with broken words.
    if (words < whole && words <= format_.content.width()) add(std::max(own, words), price_of_second_line);
    if (const double narrow = std::max(own, std::min(least_of_caption, format_.content.width())); narrow < words)
        add(narrow, price_of_broken_words);
    return sizes;
}

double MeasuredFigures::wider_for(std::size_t figure, const FigureSize& size, const Block& equations) {
    if (size.estimated) return 0;
    Drawing& drawing = drawings_[figure][size.drawing];
    // What is larger than its page leaves no corner.
    const Box& box = drawing.figure->box;
    if (box.width() > size.x || box.height() > size.y - size.caption + rounding)
        return std::numeric_limits<double>::infinity();
    if (drawing.beside != equations.width)
        drawing.beside = equations.width, drawing.wider = width_beside(*drawing.figure, equations);
    return drawing.wider;
}

}  // namespace kinegraph::render
