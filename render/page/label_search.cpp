// Assignment of labels to places: mutual prices of two labels, improvement by eviction, and which label is dropped.
#include "render/page/label_search.hpp"

#include <algorithm>
#include <limits>

#include "render/page/label_fallbacks.hpp"
#include "render/page/label_prices.hpp"

namespace kinegraph::render::lettering {

namespace {

constexpr double least_measure = 45;  // least width of a label before it is shortened, mm
constexpr double least_gain = 1e-6;   // least improvement for a move
constexpr double infinity = std::numeric_limits<double>::infinity();

LabelSetting setting_of(const std::vector<LabelRequest>& requests, const Box& box, const Ground& ground,
                        const std::vector<BodyStroke>& strokes, const std::optional<Spot>& room, bool strict) {
    LabelSetting setting{.requests = requests,
                         .ground = ground,
                         .ends = LeaderEnds(requests),
                         .bodies = Bodies(requests, strokes),
                         .box = box,
                         .strict = strict};
    if (room) setting.spare = {std::max(0.0, room->x - box.width()) / 2, std::max(0.0, room->y - box.height()) / 2};
    return setting;
}

/// Whether two labels would read as one: they stand side by side, hardly farther apart than two words if one of them
/// has a value, else than two letters of one.
bool read_as_one(const Candidate& a, const Candidate& b) {
    constexpr double letter = 4;  // half the width of the longest single symbol, mm
    if (a.ringed || b.ringed || a.box.axis.y != 0 || b.box.axis.y != 0) return false;
    const Spot d = b.box.centre - a.box.centre;
    const double least = std::max(a.box.half.x, b.box.half.x) < letter ? letter_gap : line_gap;
    return std::abs(d.y) < a.box.half.y + b.box.half.y && std::abs(d.x) - a.box.half.x - b.box.half.x < least;
}

double price_between(const Candidate& a, const Candidate& b) {
    constexpr double near = 1.6;
    double price = 0;
    const double gap = gap_between(a.box, b.box, near);
    if (gap < label_gap)
        price += covers_label + 50 * (label_gap - gap);
    else if (read_as_one(a, b))
        price += one_line_price;
    else if (gap < near)
        price += 0.8;
    if (a.leader && gap_between(a.thread, b.box, ink_margin) < ink_margin) price += covers_stroke;
    if (b.leader && gap_between(b.thread, a.box, ink_margin) < ink_margin) price += covers_stroke;
    if (a.leader && b.leader && gap_between(a.thread, b.thread, 0.3) < 0.3) price += 20;
    return price;
}

bool clash(const Candidate& a, const Candidate& b) {
    return !apart(a.extent, b.extent) && price_between(a, b) >= covers_stroke;
}

/// Whether the ink of two labels meets.
bool meet(const Candidate& a, const Candidate& b) {
    constexpr double apart_enough = 0.15;
    return gap_between(a.box, b.box, apart_enough) < apart_enough ||
           (a.leader && gap_between(a.thread, b.box, apart_enough) < apart_enough) ||
           (b.leader && gap_between(b.thread, a.box, apart_enough) < apart_enough);
}

}  // namespace

LabelSearch::LabelSearch(const std::vector<LabelRequest>& requests, const Box& box, const Fonts& fonts,
                         const Ground& ground, const std::vector<BodyStroke>& strokes, const std::optional<Spot>& room,
                         bool strict)
    : setting_(setting_of(requests, box, ground, strokes, room, strict)), chosen_(requests.size()) {
    const double measure = room ? std::max(0.5 * room->x, least_measure) : 1e300;
    letters_.reserve(requests.size()), places_.reserve(requests.size());
    for (const LabelRequest& request : requests) letters_.emplace_back(request, fonts, measure);
    for (std::size_t i = 0; i < requests.size(); ++i) places_.emplace_back(setting_, i, letters_[i].half());
}

bool LabelSearch::place(const std::optional<Spot>& only_within, bool first) {
    const std::vector<std::size_t> order = least_free_first();
    for (const std::size_t i : order) chosen_[i] = *best(i, infinity);
    const bool is_over = first && is_hopeless();
    if (!is_over) improve(order);
    if (only_within && !fits(*only_within)) return false;
    if (!is_over) repair(order);
    return true;
}

/// Ties keep the figure's order.
std::vector<std::size_t> LabelSearch::least_free_first() const {
    std::vector<std::pair<int, std::size_t>> ranked;
    ranked.reserve(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) ranked.emplace_back(places_[i].uncovered(), i);
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::size_t> order;
    order.reserve(ranked.size());
    for (const auto& [free, i] : ranked) order.push_back(i);
    return order;
}

void LabelSearch::improve(const std::vector<std::size_t>& order) {
    int looks_left = 30 + static_cast<int>(order.size());  // a limit, for figures without any room
    for (int round = 0; round < 4; ++round) {
        bool changed = false;
        for (const std::size_t i : order) {
            if (const auto better = best(i, price_now(i) - least_gain)) {
                chosen_[i] = *better;
                changed = true;
            }
            changed = evict(i, looks_left) || changed;
        }
        if (!changed) break;
    }
}

/// Final repair: a label that covers something moves to a free fallback place, in the figure or at its edge. Labels
/// that block a leader to it are moved next.
void LabelSearch::repair(const std::vector<std::size_t>& order) {
    std::vector<std::size_t> waiting;
    for (const std::size_t i : order)
        if (is_in_the_way(i)) waiting.push_back(i);
    if (waiting.empty()) return;
    Refuges fallbacks(setting_, letters_, chosen_);
    std::size_t moves_left = 2 * chosen_.size();
    for (std::size_t next = 0; next < waiting.size() && moves_left > 0; ++next) {
        const std::size_t i = waiting[next];
        if (!is_in_the_way(i)) continue;
        fallbacks.give_back(i);
        const auto place = fallbacks.nearest(i);
        if (place) chosen_[i] = *place;
        fallbacks.take(i);
        if (!place) continue;
        --moves_left;
        for (std::size_t j = 0; j < chosen_.size(); ++j)
            if (j != i && clash(chosen_[i], chosen_[j])) waiting.push_back(j);
    }
}

/// Collects the labels that some place of label i may touch.
void LabelSearch::look_around(std::size_t i) {
    around_.clear();
    for (std::size_t j = 0; j < chosen_.size(); ++j)
        if (j != i && !apart(chosen_[j].extent, places_[i].span())) around_.push_back(j);
}

double LabelSearch::price_now(std::size_t i) const {
    double price = chosen_[i].price;
    for (std::size_t j = 0; j < chosen_.size(); ++j)
        if (j != i && !apart(chosen_[j].extent, chosen_[i].extent)) price += price_between(chosen_[i], chosen_[j]);
    return price;
}

/// The cheapest place that costs less than `least`, with the other labels where they are.
std::optional<Candidate> LabelSearch::best(std::size_t i, double least) {
    LabelPlaces& places = places_[i];
    std::optional<std::size_t> found;
    const auto look_at = [&](std::size_t place) {
        const Candidate& candidate = places[place];
        double price = candidate.price;
        for (std::size_t n = 0; n < around_.size() && price < least; ++n)
            if (const Candidate& other = chosen_[around_[n]]; !apart(other.extent, candidate.extent))
                price += price_between(candidate, other);
        if (price < least) least = price, found = place;
    };
    look_around(i);
    for (std::size_t batch = 0;;) {
        for (; batch < places.batches(); ++batch) places.look_through(batch, true, least, look_at);
        if (!places.propose_more(least)) break;
        look_around(i);
    }
    if (least > covers_stroke)
        for (std::size_t batch = 0; batch < places.batches(); ++batch)
            places.look_through(batch, false, least, look_at);
    if (!found) return std::nullopt;
    return places[*found];
}

/// For each label that blocks a cheaper place of label i than its present one (price `now`), the cheapest such place.
void LabelSearch::find_wishes(std::size_t i, double now) {
    wishes_.clear();
    look_around(i);
    LabelPlaces& places = places_[i];
    const auto wish = [&](std::size_t place) { wish_for(i, place, now); };
    for (std::size_t batch = 0; batch < places.batches(); ++batch) places.look_through(batch, true, now, wish);
    if (now > covers_stroke)
        for (std::size_t batch = 0; batch < places.batches(); ++batch) places.look_through(batch, false, now, wish);
    constexpr std::size_t most = 6;
    std::sort(wishes_.begin(), wishes_.end(), [](const Wish& a, const Wish& b) {
        return a.price < b.price || (a.price == b.price && a.other < b.other);
    });
    if (wishes_.size() > most) wishes_.resize(most);
}

void LabelSearch::wish_for(std::size_t i, std::size_t place, double now) {
    const Candidate& candidate = places_[i][place];
    if (candidate.price >= now) return;
    met_.clear();
    double sum = candidate.price, most = 0;
    for (const std::size_t j : around_) {
        if (apart(chosen_[j].extent, candidate.extent)) continue;
        const double price = price_between(candidate, chosen_[j]);
        if (price <= 0) continue;
        met_.emplace_back(j, price);
        sum += price;
        most = std::max(most, price);
        if (sum - most >= now) return;
    }
    for (const auto& [j, price] : met_) {
        const double without = sum - price;
        if (without >= now) continue;
        const auto there =
            std::find_if(wishes_.begin(), wishes_.end(), [other = j](const Wish& w) { return w.other == other; });
        if (there == wishes_.end())
            wishes_.push_back({j, place, without});
        else if (without < there->price)
            *there = {j, place, without};
    }
}

/// Takes a better place from another label, if that label can move at a smaller loss.
bool LabelSearch::evict(std::size_t i, int& looks_left) {
    const double now = price_now(i);
    if (now < leader_price || looks_left <= 0) return false;
    find_wishes(i, now);
    for (const Wish& wish : wishes_) {
        if (--looks_left < 0) return false;
        const std::size_t j = wish.other;
        const Candidate before = chosen_[i];
        double both = now + price_now(j);
        if (!apart(before.extent, chosen_[j].extent)) both -= price_between(before, chosen_[j]);
        chosen_[i] = places_[i][wish.place];
        if (const auto place = best(j, both - wish.price - least_gain)) {
            chosen_[j] = *place;
            return true;
        }
        chosen_[i] = before;
    }
    return false;
}

bool LabelSearch::fits(Spot room) const {
    Box all = setting_.box;
    for (const Candidate& candidate : chosen_) enlarge(all, extent_of(candidate.box));
    return all.width() <= room.x && all.height() <= room.y;
}

bool LabelSearch::leaves_the_room(const Candidate& candidate) const {
    constexpr double grace = 0.01;
    const Spot out = setting_.outside(extent_of(candidate.box));
    return out.x > setting_.spare.x + grace || out.y > setting_.spare.y + grace;
}

/// Whether the label covers something, its leader crosses another label, or it stands where it may not.
bool LabelSearch::is_in_the_way(std::size_t i) const {
    if (chosen_[i].covered || (chosen_[i].leader && setting_.ground.covers_text(chosen_[i].thread))) return true;
    for (std::size_t j = 0; j < chosen_.size(); ++j)
        if (j != i && clash(chosen_[i], chosen_[j])) return true;
    return false;
}

/// Whether so many labels are in the way that moving them would only move what is in the way.
bool LabelSearch::is_hopeless() const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < chosen_.size(); ++i) found += is_in_the_way(i) ? 1 : 0;
    return 3 * found > 2 * chosen_.size();
}

bool LabelSearch::is_crowded() const {
    for (std::size_t i = 0; i < chosen_.size(); ++i)
        if (is_in_the_way(i)) return true;
    return false;
}

std::vector<std::size_t> LabelSearch::placeless() const {
    const std::size_t count = chosen_.size();
    std::vector<bool> gone(count);
    for (std::size_t i = 0; i < count; ++i)
        gone[i] = (setting_.strict && leaves_the_room(chosen_[i])) ||
                  !setting_.ground.is_bare(letters_[i].inked(chosen_[i].box)) ||
                  (chosen_[i].leader && setting_.ground.covers_text(chosen_[i].thread));
    std::vector<std::vector<std::size_t>> met(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            if (j != i && !gone[i] && !gone[j] && meet(chosen_[i], chosen_[j])) met[i].push_back(j);
    for (;;) {
        std::size_t most = 0, worst = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (!gone[i] && met[i].size() >= std::max<std::size_t>(most, 1)) {
                // Prefer to drop a label with a leader.
                if (met[i].size() == most && chosen_[worst].leader && !chosen_[i].leader) continue;
                most = met[i].size(), worst = i;
            }
        if (most == 0) break;
        gone[worst] = true;
        for (const std::size_t j : met[worst]) std::erase(met[j], worst);
    }
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < count; ++i)
        if (gone[i]) found.push_back(i);
    return found;
}

}  // namespace kinegraph::render::lettering
