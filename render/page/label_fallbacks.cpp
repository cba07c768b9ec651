// Search for the nearest free place, on square rings about the anchor, until no farther place can be better.
#include "render/page/label_fallbacks.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "render/page/label_prices.hpp"

namespace kinegraph::render::lettering {

namespace {

constexpr double longest_leader = 40;   // mm; with a longer leader the named object is hard to find
constexpr double farthest_beyond = 80;  // mm beyond the figure's box, if no room is given
constexpr double unruly_price = 12;     // per leader that this leader crosses
constexpr int most_looks = 30000;       // per figure; beyond it the first free place is taken

/// How far beyond the figure's box a label without a place may go.
Spot reach_of(const LabelSetting& setting) {
    return {std::min(setting.spare.x, farthest_beyond), std::min(setting.spare.y, farthest_beyond)};
}

/// The area that labels can occupy.
Box area_of(const LabelSetting& setting, const std::vector<Lettered>& letters) {
    Spot most = reach_of(setting);
    for (const Lettered& label : letters) {
        const Spot half = label.half();
        most = {std::max(most.x, 3 * half.x + 5), std::max(most.y, 3 * half.y + 5)};
    }
    return {setting.box.min - most, setting.box.max + most};
}

}  // namespace

Refuges::Refuges(const LabelSetting& setting, const std::vector<Lettered>& letters,
                 const std::vector<Candidate>& chosen)
    : setting_(setting),
      letters_(letters),
      chosen_(chosen),
      taken_(area_of(setting, letters)),
      threads_(taken_),
      looks_left_(most_looks) {
    for (std::size_t label = 0; label < letters_.size(); ++label) take(label);
}

void Refuges::take(std::size_t label) {
    const Candidate& place = chosen_[label];
    taken_.fill(place.box.grown(label_gap));
    if (place.leader) threads_.stroke(place.leader_from, place.leader_to, ink_margin);
}

void Refuges::give_back(std::size_t label) {
    const Box& hole = chosen_[label].extent;
    taken_.clear(hole);
    threads_.clear(hole);
    for (std::size_t other = 0; other < chosen_.size(); ++other)
        if (other != label && !apart(chosen_[other].extent, hole)) take(other);
}

std::optional<Candidate> Refuges::nearest(std::size_t label) {
    const Box& box = setting_.box;
    const Spot half = letters_[label].half(), edge = reach_of(setting_);
    if (const auto found = nearest(label, {box.min - edge + half, box.max + edge - half})) return found;
    if (setting_.strict) return std::nullopt;
    constexpr double beyond = 4;
    const Spot further = 2.0 * half + Spot{beyond, beyond};
    return nearest(label, {box.min - further, box.max + further});
}

/// The nearest free place whose middle lies in a box; of places at about the same distance, the one whose leader
/// crosses least.
std::optional<Candidate> Refuges::nearest(std::size_t label, const Box& middles) {
    const double step = looks_left_ > 0 ? 1 : 2;
    const LabelRequest& request = setting_.requests[label];
    const Spot at = request.anchor, half = letters_[label].half();
    std::optional<Candidate> found;
    // Beyond the longest leader there is nothing to look for, however large the figure.
    const double farthest =
        std::min(longest_leader + request.clearance + std::max(half.x, half.y) + step,
                 std::max({at.x - middles.min.x, middles.max.x - at.x, at.y - middles.min.y, middles.max.y - at.y}));
    const auto last = static_cast<int>(farthest / step);
    for (int ring = 1; ring <= last; ++ring) {
        const double away = ring * step;
        if (found && looks_left_ <= 0) break;
        if (found && leader_price + far_price * (away - std::max(half.x, half.y) - request.clearance) >= found->price)
            break;
        // Places that must still touch what an earlier one in the line touched are passed over. They are counted, since
        // far from the origin a step more may be the same double.
        const auto row = [&](double y) {
            if (y < middles.min.y || y > middles.max.y) return;
            double free_from = -1e300, x = std::max(at.x - away, middles.min.x);
            for (int i = 0; i <= 2 * ring && x <= std::min(at.x + away, middles.max.x); ++i, x += step)
                if (x >= free_from) free_from = x + look_at(label, {x, y}, step, &InkMap::way_right, found);
        };
        const auto column = [&](double x) {
            if (x < middles.min.x || x > middles.max.x) return;
            double free_from = -1e300, y = std::max(at.y - away + step, middles.min.y);
            for (int i = 0; i <= 2 * ring && y < std::min(at.y + away, middles.max.y); ++i, y += step)
                if (y >= free_from) free_from = y + look_at(label, {x, y}, step, &InkMap::way_down, found);
        };
        row(at.y - away);
        row(at.y + away);
        column(at.x + away);
        column(at.x - away);
    }
    if (found) found->close_extent();
    return found;
}

/// Keeps a place that covers no stroke and no label, if it is better than the best so far. Returns how far along the
/// line of places what it covers reaches.
double Refuges::look_at(std::size_t label, Spot centre, double step, WayOut way_out, std::optional<Candidate>& found) {
    const LabelRequest& request = setting_.requests[label];
    const InkBox box{centre, letters_[label].half()};
    const double extra = distance_to_box(request.anchor, box) - request.clearance;
    const double least = leader_price + far_price * extra;
    if (extra < step || extra > longest_leader || (found && least >= found->price)) return 0;
    --looks_left_;
    constexpr double rounding = 1e-9;
    if (const auto way = (taken_.*way_out)(box)) return *way - rounding;
    if (const auto way = (threads_.*way_out)(box)) return *way - rounding;
    if (const auto way = (setting_.ground.map().*way_out)(box.grown(ink_margin))) return *way - rounding;
    Candidate candidate;
    candidate.box = box;
    candidate.price = least;
    candidate.ringed = request.balloon > 0;
    candidate.add_leader(setting_, label);
    if (leads_over_another(label, candidate.thread) || setting_.ground.covers_text(candidate.thread)) return 0;
    candidate.price +=
        crossings_of(label, candidate, found ? found->price - least : std::numeric_limits<double>::infinity());
    if (!found || candidate.price < found->price) found = candidate;
    return 0;
}

bool Refuges::leads_over_another(std::size_t label, const InkBox& thread) const {
    for (std::size_t other = 0; other < chosen_.size(); ++other)
        if (other != label && gap_between(thread, chosen_[other].box, label_gap) < label_gap) return true;
    return false;
}

/// The price of what a leader crosses, counted until it exceeds `enough`.
double Refuges::crossings_of(std::size_t label, const Candidate& candidate, double enough) const {
    double price = 0;
    const auto count = [&](double each, const auto& crossings) {
        constexpr double most = 1e6;
        const double left = (enough - price) / each;
        if (left > 0) price += each * crossings(static_cast<int>(std::min(left, most)) + 1);
    };
    const Spot from = candidate.leader_from, to = candidate.leader_to;
    count(unruly_price, [&](int most) { return threads_.crossings(from, to, most); });
    price += setting_.bodies.led_astray(label, from, to);
    count(crossing_price, [&](int most) { return setting_.ground.crossed(from, to, most); });
    return price;
}

}  // namespace kinegraph::render::lettering
