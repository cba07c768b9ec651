// Draws each figure once for all rooms that give the same scale, and divides the space that the figures of a band
// leave.
#include "render/layout/drawn_figures.hpp"

#include <algorithm>
#include <utility>

#include "render/figures/caption.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/layout/beside.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

/// Whether the figure would have the same scale in a larger room and has all its content.
bool gains_nothing(const Wanted& wanted, const Figure& drawn, Spot room) {
    constexpr double rounding = 1e-9;
    if (!wanted.tells_its_extents() || wanted.asked || drawn.lacks_details || drawn.has_key) return false;
    const double finest = choose_scale(wanted.extent_x, wanted.extent_y, room.x, room.y, std::nullopt);
    return finest >= drawn.scale * (1 - rounding);
}

/// Whether a figure that fills its room would hardly change in another room.
bool is_hardly_other(Spot known, Spot room) {
    constexpr double hardly = 1.2;
    const double x = room.x / known.x, y = room.y / known.y;
    return std::max(x, 1 / x) <= hardly && std::max(y, 1 / y) <= hardly;
}

}  // namespace

bool DrawnFigures::draw(SheetPlan& plan, bool refuse) {
    const std::vector<InItsRoom> all = in_their_rooms(plan);
    draw_each(all, refuse);
    bool all_in_corners = true;
    for (const InItsRoom& each : all) {
        DrawnFigure& drawn = *each.drawn;
        if (!drawn.waits && !drawn.is_refused()) needs_.learn_from(drawn);
        if (each.cornered && !drawn.is_refused() && !set_in_corner(drawn, each.layouts->equations())) {
            plan.has_no_corner(each.band->question);
            all_in_corners = false;
        }
    }
    for (auto& [band, figures] : by_band_) share_room(figures);
    return all_in_corners;
}

/// The figures of the plan with their rooms, not drawn yet.
std::vector<DrawnFigures::InItsRoom> DrawnFigures::in_their_rooms(const SheetPlan& plan) {
    by_band_.clear();
    std::vector<InItsRoom> all;
    plan.for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        const Band& band = bands_.list[placed.band];
        const BandLayouts& layouts = plan.layouts(placed.band);
        std::vector<DrawnFigure>* figures = nullptr;
        Spot corner{0, 0};
        for (std::size_t f = 0; f < layout.rooms.size(); ++f) {
            const Spot size = layout.rooms[f];
            if (!(size.x > 0)) continue;
            if (figures == nullptr) {
                figures = &by_band_[placed.band];
                figures->reserve(layout.rooms.size());  // pointers to the elements are kept
            }
            DrawnFigure& drawn = figures->emplace_back();
            drawn.wanted = band.figures[f];
            drawn.number = static_cast<int>(all.size()) + 1;
            drawn.room = rectangle(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
            drawn.own = {size.x - (layout.cornered ? layouts.wider_in(size) : 0), size.y};
            drawn.promised = layouts.scale_in(f, drawn.own);
            drawn.waits = wanted_.list[drawn.wanted].fills;
            all.push_back({&drawn, &band, &layouts, layout.cornered});
            (layout.stacked ? corner.y : corner.x) += (layout.stacked ? size.y : size.x) + gap;
        }
    });
    return all;
}

/// Draws all figures except those that wait.
void DrawnFigures::draw_each(const std::vector<InItsRoom>& all, bool refuse) {
    for (const InItsRoom& each : all) {
        const Wanted& wanted = wanted_.list[each.drawn->wanted];
        if (each.drawn->waits) continue;
        constexpr double rounding = 1e-9;
        const bool may_refuse = refuse && wanted.draw_or_refuse && needs_.may_refuse(wanted);
        draw_into(*each.drawn, each.drawn->own, may_refuse ? each.drawn->promised * (1 + rounding) : any_scale);
    }
}

void DrawnFigures::draw_what_fills_its_room() {
    std::vector<DrawnFigure*> in_order;
    for (auto& [band, figures] : by_band_)
        for (DrawnFigure& drawn : figures) in_order.push_back(&drawn);
    std::sort(in_order.begin(), in_order.end(),
              [](const auto* one, const auto* other) { return one->number < other->number; });
    std::size_t details = 0;
    for (DrawnFigure* drawn : in_order) {
        if (std::exchange(drawn->waits, false))
            draw_into(*drawn, {drawn->room.width(), drawn->room.height()}, any_scale);
        enlarge(*drawn);
        letter_details_on(drawn->figure, context_, details);
        details += drawn->figure.details.size();
    }
    for (auto& [band, figures] : by_band_) share_room(figures);
}

/// Replaces a figure by one with a finer scale of its own if that fits into the room.
void DrawnFigures::enlarge(DrawnFigure& drawn) const {
    const Wanted& wanted = wanted_.list[drawn.wanted];
    if (!wanted.larger) return;
    const Spot room{drawn.room.width(), drawn.room.height() - drawn.caption};
    Figure larger = wanted.larger(room);
    const bool fits = larger.box.width() <= room.x && larger.box.height() <= room.y;
    if (!fits || !(larger.scale < drawn.figure.scale)) return;
    drawn.figure = std::move(larger);
    drawn.size = {drawn.figure.box.width(), drawn.figure.box.height()};
    drawn.has_own_scale = true;
}

void DrawnFigures::enrich() {
    for (auto& [band, figures] : by_band_)
        for (DrawnFigure& drawn : figures) {
            const Wanted& wanted = wanted_.list[drawn.wanted];
            if (!wanted.enrich) continue;
            Figure more = wanted.enrich(drawn.figure, {drawn.room.width(), drawn.room.height() - drawn.caption});
            if (more.scale != any_scale) drawn.figure = std::move(more);
        }
}

bool DrawnFigures::keep_to_rooms() const {
    return std::all_of(by_band_.begin(), by_band_.end(), [](const auto& band) {
        return std::none_of(band.second.begin(), band.second.end(),
                            [](const DrawnFigure& drawn) { return drawn.is_too_wide() || drawn.is_too_high(); });
    });
}

/// Moves the borders between the figures of a band, so that one that is too large gets the space that others leave.
void DrawnFigures::share_room(std::vector<DrawnFigure>& figures) const {
    const auto is_open = [](const DrawnFigure& drawn) { return drawn.waits || drawn.is_refused(); };
    if (figures.size() < 2 || std::any_of(figures.begin(), figures.end(), is_open)) return;
    const bool stacked = figures.back().room.min.y > figures.front().room.min.y;
    const auto across = [&](const DrawnFigure& drawn) {
        return stacked ? drawn.size.x <= drawn.room.width() : drawn.height() <= drawn.room.height();
    };
    const auto along = [&](const DrawnFigure& drawn) {
        if (stacked) return drawn.height();
        const double own = drawn.figure.box.width();
        return width_for_caption(drawn, drawn.caption, own, std::max(own, drawn.room.width()));
    };
    const auto own = [&](const DrawnFigure& drawn) { return stacked ? drawn.room.height() : drawn.room.width(); };
    double left = 0;
    bool outgrown = false;
    for (const DrawnFigure& drawn : figures) {
        left += own(drawn) - along(drawn);
        outgrown = outgrown || along(drawn) > own(drawn);
    }
    if (!outgrown || left < 0 || !std::all_of(figures.begin(), figures.end(), across)) return;
    double at = stacked ? figures.front().room.min.y : figures.front().room.min.x;
    for (DrawnFigure& drawn : figures) {
        const double end = at + along(drawn) + left / static_cast<double>(figures.size());
        (stacked ? drawn.room.min.y : drawn.room.min.x) = at;
        (stacked ? drawn.room.max.y : drawn.room.max.x) = end;
        drawn.caption = height_of_caption(drawn, drawn.room.width());
        at = end + gap;
    }
}

/// Places the equations in a free corner of the room. False if none is free.
bool DrawnFigures::set_in_corner(DrawnFigure& drawn, const Block& equations) const {
    const Box room = rectangle(0, 0, drawn.room.width(), drawn.room.height() - drawn.caption);
    if (!set_beside(drawn.beside, drawn.figure, equations, room)) return false;
    drawn.figure.box.include(box_of(drawn.beside));
    return true;
}

/// Cached. A drawing is reused for all rooms between its own and its size, because its scale is the finest that fits.
/// If the room does not allow the scale `coarsest`, the result is empty and at any_scale; that takes less time than to
/// place the labels.
const Figure& DrawnFigures::figure_in(std::size_t index, Spot room, double coarsest) {
    const Wanted& wanted = wanted_.list[index];
    std::vector<Known>& known = known_[index];
    for (const Known& each : known)
        if (serves(each, wanted, room, coarsest)) return each.figure;
    Known drawn{room, wanted.to_force_scale ? wanted_.force_scale : std::nullopt, wanted.shrinks, {}, {}};
    if (coarsest < any_scale) {
        drawn.figure = wanted.draw_or_refuse(room, coarsest);
        if (drawn.figure.scale == any_scale) drawn.refused_at = coarsest;
    } else {
        drawn.figure = wanted.draw(room.x, room.y);
    }
    return known.emplace_back(std::move(drawn)).figure;
}

/// Whether a cached drawing or refusal is valid for this room.
bool DrawnFigures::serves(const Known& known, const Wanted& wanted, Spot room, double coarsest) const {
    constexpr double rounding = 1e-6;
    if (known.force_scale != (wanted.to_force_scale ? wanted_.force_scale : std::nullopt)) return false;
    if (known.shrinks != wanted.shrinks) return false;
    const bool larger = room.x > known.room.x + rounding || room.y > known.room.y + rounding;
    if (known.refused_at) return !larger && coarsest <= *known.refused_at;
    const bool same = !larger && room.x > known.room.x - rounding && room.y > known.room.y - rounding;
    if (same) return true;
    const Box& box = known.figure.box;
    const bool fits = box.width() <= room.x + rounding && box.height() <= room.y + rounding;
    if (fits && wanted_.are_crowded()) return true;
    return fits &&
           (wanted.fills ? is_hardly_other(known.room, room) : !larger || gains_nothing(wanted, known.figure, room));
}

void DrawnFigures::draw_into(DrawnFigure& drawn, Spot room, double coarsest) {
    constexpr double least_room = 10;
    const auto below = [&](double taken) {
        return Spot{std::max(room.x, least_room), std::max(room.y - taken, least_room)};
    };
    drawn.wide_enough = 0;
    drawn.figure = figure_in(drawn.wanted, below(caption_line), coarsest);
    drawn.size = {drawn.figure.box.width(), drawn.figure.box.height()};
    if (drawn.is_refused()) return;
    drawn.caption = height_of_caption(drawn, drawn.room.width());
    if (drawn.caption > caption_line && drawn.height() > room.y && !wanted_.are_crowded()) {
        constexpr double widest_caption = 120;
        const double left = room.y - drawn.figure.box.height();
        if (left >= caption_line)
            drawn.wide_enough = width_for_caption(drawn, left, room.x, std::max(room.x, widest_caption));
        drawn.figure = figure_in(drawn.wanted, below(drawn.caption), coarsest);
    }
    drawn.size = {drawn.figure.box.width(), drawn.figure.box.height()};
}

double DrawnFigures::height_of_caption(const DrawnFigure& drawn, double width) const {
    std::vector<Mark> words;
    return set_caption(words, context_, drawn.figure, drawn.number, {0, 0}, width);
}

/// The least width in [low, high] for which its caption is no higher than `most`; `high` if there is none.
double DrawnFigures::width_for_caption(const DrawnFigure& drawn, double most, double low, double high) const {
    constexpr double fine = 1;
    if (height_of_caption(drawn, low) <= most) return low;
    while (high - low > fine) {
        const double middle = 0.5 * (low + high);
        (height_of_caption(drawn, middle) <= most ? high : low) = middle;
    }
    return high;
}

}  // namespace kinegraph::render
