// Updates the estimated space for labels from drawings; without data it is increased by fixed steps.
#include "render/layout/figure_needs.hpp"

#include <algorithm>
#include <cmath>

#include "render/content/sheet_parts.hpp"

namespace kinegraph::render {
namespace {

constexpr int most_refusals = 3;
constexpr double ink = 0.25;  // mm: border lines of a figure may exceed its room by this

/// The size taken with a small reserve, at most that of the room, so that the next plan keeps a room that was large
/// enough.
double with_air(double taken, double room) {
    constexpr double air = 0.5;
    return taken < room + ink ? std::min(taken + air, room) : taken + air;
}

/// Increases the estimate to the space that labels took at a coarser scale; without data by a fixed step.
void give_more_room(Wanted& wanted, const DrawnFigure& drawn) {
    constexpr double more = 6;
    if (drawn.is_refused()) {
        (drawn.own.x > drawn.own.y ? wanted.rim_y : wanted.rim_x) += more;
        return;
    }
    const Spot strokes = wanted.strokes_at(drawn.figure.scale);
    const double rim_x = drawn.size.x - strokes.x;
    const double rim_y = drawn.size.y - strokes.y + drawn.caption - caption_line;
    const bool is_known = rim_x > wanted.rim_x || rim_y > wanted.rim_y;
    wanted.rim_x = is_known ? std::max(wanted.rim_x, rim_x + 1) : wanted.rim_x + more;
    wanted.rim_y = is_known ? std::max(wanted.rim_y, rim_y + 1) : wanted.rim_y + more;
}

}  // namespace

bool DrawnFigure::is_too_wide() const { return figure.box.width() - room.width() >= ink; }
bool DrawnFigure::is_too_high() const { return height() - room.height() >= ink; }

int& FigureNeeds::refusals_of(const Wanted& wanted) {
    return refusals_[{wanted.name, wanted.to_force_scale ? wanted_.force_scale.value_or(0) : 0}];
}

bool FigureNeeds::may_refuse(const Wanted& wanted) {
    // If figures are crowded, a figure refuses once, based on its number of names; a mechanism accepts every room.
    if (wanted_.are_crowded()) return wanted.letters > 0 && refusals_of(wanted) < 1;
    return refusals_of(wanted) < most_refusals;
}

void FigureNeeds::learn_from(const DrawnFigure& drawn) {
    Wanted& wanted = wanted_.list[drawn.wanted];
    if (!wanted.tells_its_extents() || wanted.asked) return;
    const Spot taken{with_air(drawn.size.x, drawn.room.width()),
                     with_air(drawn.height(), drawn.room.height()) - caption_line};
    const Spot guess = wanted.strokes_at(drawn.figure.scale) + Spot{wanted.rim_x, wanted.rim_y};
    const auto [known, fresh] = wanted.taken.try_emplace(drawn.figure.scale, taken);
    if (fresh) spared_ = std::max({spared_, guess.x - taken.x, guess.y - taken.y});
    // The size may be larger in a room of another shape. It never decreases, otherwise the plans would not converge.
    known->second = {std::max(known->second.x, taken.x), std::max(known->second.y, taken.y)};
}

bool FigureNeeds::is_coarser_than_promised(const DrawnFigure& drawn) const {
    const Wanted& wanted = wanted_.list[drawn.wanted];
    constexpr double rounding = 1e-6;
    return wanted.tells_its_extents() && !wanted.asked && drawn.figure.scale > drawn.promised * (1 + rounding);
}

bool FigureNeeds::asks_for_more_room(const DrawnFigure& drawn) {
    return is_coarser_than_promised(drawn) && may_refuse(wanted_.list[drawn.wanted]);
}

/// The size recorded for the planned scale, from a room of another shape, was too small; it is increased.
void FigureNeeds::wants_more_than_its_room(const DrawnFigure& drawn) {
    auto& taken = wanted_.list[drawn.wanted].taken;
    const auto known = taken.find(drawn.promised);
    if (known == taken.end()) return;
    if (drawn.wide_enough > 0) {
        known->second.x = std::max(known->second.x, drawn.wide_enough);
        return;
    }
    constexpr double more = 3;
    known->second = {std::max(known->second.x, drawn.own.x + more),
                     std::max(known->second.y, drawn.own.y - caption_line + more)};
}

bool FigureNeeds::has_outgrown(const DrawnFigure& drawn) {
    if (drawn.is_refused() || is_coarser_than_promised(drawn)) wants_more_than_its_room(drawn);
    Wanted& wanted = wanted_.list[drawn.wanted];
    if (drawn.is_refused() || asks_for_more_room(drawn)) {
        refused_.push_back({drawn.wanted, wanted.rim_x, wanted.rim_y, most_refusals});
        ++refusals_of(wanted);
        give_more_room(wanted, drawn);
        return true;
    }
    if (!drawn.is_too_wide() && !drawn.is_too_high()) return false;
    if (wanted.fills) {
        fills_a_larger_room(drawn, drawn.is_too_wide(), drawn.is_too_high());
    } else {
        // A figure that is too small to be read on paper is not drawn again.
        if (wanted_.are_crowded() && !wanted.to_force_scale)
            wanted.finest = std::max(wanted.finest, drawn.figure.scale);
        wanted.rim_x += std::max(drawn.figure.box.width() - drawn.room.width(), 0.0);
        wanted.rim_y += std::max(drawn.height() - drawn.room.height(), 0.0);
        learn_from(drawn);  // the caption may have more lines now
    }
    return true;
}

/// Increases the least room only in the direction in which the figure was too large; in the other one it may just have
/// filled its room. A wider room may save lines of the caption. After repeated failures the least room is the size
/// drawn; after further failures the figure shrinks.
void FigureNeeds::fills_a_larger_room(const DrawnFigure& drawn, bool too_wide, bool too_high) {
    constexpr int without_avail = 2;
    Wanted& wanted = wanted_.list[drawn.wanted];
    const int times = ++refusals_of(wanted);
    const bool settles = times > most_refusals, wants_width = drawn.wide_enough > 0 && !settles;
    wanted.shrinks = times > most_refusals + without_avail;
    Spot& least = wanted.least_room;
    if (too_wide || settles) least.x = std::max(least.x, drawn.figure.box.width());
    if (wants_width) least.x = std::max(least.x, drawn.wide_enough);
    if ((too_high && !wants_width) || settles) least.y = std::max(least.y, drawn.height() - caption_line);
}

bool FigureNeeds::misses_its_scale(const DrawnFigure& drawn) const {
    const Wanted& wanted = wanted_.list[drawn.wanted];
    constexpr double rounding = 1e-9;
    return wanted.asked && wanted.tells_its_extents() &&
           std::abs(drawn.figure.scale - *wanted.asked) > rounding * drawn.figure.scale;
}

bool FigureNeeds::gives_room_for_its_scale(const DrawnFigure& drawn) {
    Wanted& wanted = wanted_.list[drawn.wanted];
    if (!roomier_.insert(wanted.name).second) return false;
    constexpr double more = 16;
    wanted.rim_x += more;
    wanted.rim_y += more;
    return true;
}

void FigureNeeds::take_back(Refusal& refusal) {
    Wanted& wanted = wanted_.list[refusal.wanted];
    // A coarser scale of one force polygon would change the scale of all.
    if (wanted.to_force_scale) return;
    std::swap(wanted.rim_x, refusal.rim_x);
    std::swap(wanted.rim_y, refusal.rim_y);
    std::swap(refusals_of(wanted), refusal.refusals);
}

void FigureNeeds::give_up(const Tried& tried) {
    Wanted& wanted = wanted_.list[tried.wanted];
    wanted.taken.erase(tried.promised);
    wanted.finest = tried.came;
}

bool FigureNeeds::is_planned_as_it_came(const DrawnFigure& drawn) {
    if (wanted_.are_crowded()) return false;
    Wanted& wanted = wanted_.list[drawn.wanted];
    if (wanted.to_force_scale || wanted.finest > 0 || drawn.is_refused() || !is_coarser_than_promised(drawn))
        return false;
    // First, the size at the planned scale is estimated from the labels at the coarser one.
    if (said_to_take_more_.insert(wanted.name).second) {
        const Spot letters = drawn.size - wanted.strokes_at(drawn.figure.scale);
        const Spot more = wanted.strokes_at(drawn.promised) + letters;
        Spot& taken = wanted.taken[drawn.promised];
        taken = {std::max(taken.x, more.x), std::max(taken.y, more.y)};
        tried_ = Tried{drawn.wanted, drawn.promised, drawn.figure.scale};
        if (taken.x > drawn.own.x || taken.y > drawn.own.y - drawn.caption) return true;
    }
    // Below this size no room would be planned for it at all.
    if (std::max(wanted.extent_x, wanted.extent_y) / drawn.figure.scale < hardly_readable) return false;
    wanted.finest = drawn.figure.scale;
    return true;
}

bool FigureNeeds::take_less_than_thought() {
    constexpr int most_times = 2;
    constexpr double deserves_another_plan = 3;
    return ++times_less_ <= most_times && spared_ > deserves_another_plan;
}

}  // namespace kinegraph::render
