// How places are proposed, priced and put into the order of price.
#include "render/page/label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "render/page/label_prices.hpp"

namespace kinegraph::render::lettering {

namespace {

constexpr double beside_price = 2.5;  // of a vector's name beyond its ends
constexpr double upright_price = 8;   // of a direction mark that leaves its line
constexpr double leaves_room = 30;
constexpr double least_of_far = 11;  // leader and distance: no far place costs less
// What covers ink costs more than all that makes less wanted places worth a thought.
static_assert(covers_stroke > std::max({beside_price, upright_price, least_of_far}));

std::vector<Spot> directions(int count) {
    std::vector<Spot> round;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        round.push_back({std::cos(angle), -std::sin(angle)});
    }
    return round;
}

/// How far along u the box's centre is when its nearest ink is `distance` from the origin.
double centre_distance(const InkBox& box, Spot u, double distance) {
    const Spot v{std::abs(u.x), std::abs(u.y)}, h = box.half;
    if (const double t = (distance + h.x) / std::max(v.x, 1e-12); t * v.y <= h.y) return t;
    if (const double t = (distance + h.y) / std::max(v.y, 1e-12); t * v.x <= h.x) return t;
    // Past both sides: the corner is nearest.
    const double b = dot(v, h), c = dot(h, h) - distance * distance;
    return b + std::sqrt(std::max(0.0, b * b - c));
}

/// Whether the box round the line that a request's label names tells that the line is farther away.
bool is_beyond(const LabelRequest& request, Spot spot, double distance) {
    const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
    return std::abs(d.x) > std::abs(half.x) + distance || std::abs(d.y) > std::abs(half.y) + distance;
}
/// From the line that a request's label names (its anchor in the middle).
double distance_to_line(const LabelRequest& request, Spot spot) {
    const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
    const double t = std::clamp(dot(d, half) / std::max(dot(half, half), 1e-12), -1.0, 1.0);
    return length(d - t * half);
}

}  // namespace

void Candidate::add_leader(const LabelRequest& request) {
    const Spot at = request.anchor - box.centre;
    const Spot foot = box.centre + Spot{std::clamp(at.x, -box.half.x, box.half.x), std::clamp(at.y, -box.half.y, box.half.y)};
    const Spot back = unit(foot - request.anchor);
    leader = true;
    // To a link's number the leader begins on the link itself.
    const bool on_it = request.toward && !request.along;
    leader_from = request.anchor + (on_it ? 0 : std::max(0.6, request.clearance - 0.9)) * back;
    leader_to = foot - 0.5 * back;
    thread = {0.5 * (leader_from + leader_to), {length(leader_to - leader_from) / 2, 0.1}, back};
}

void Candidate::close_extent(const Box& of_box) {
    // Half of what two labels keep between them, and a little for turned ones.
    constexpr Spot kept{1.2, 1.2};
    extent = of_box;
    if (leader) {
        enlarge(extent, leader_from);
        enlarge(extent, leader_to);
    }
    extent.min = extent.min - kept;
    extent.max = extent.max + kept;
}

LabelPlaces::LabelPlaces(const LabelSetting& setting, std::size_t label, Spot half)
    : setting_(setting), request_(setting.requests[label]), label_(label), half_(half) {
    // Memory that grows step by step takes twice as much of it, and a place is no small thing.
    constexpr std::size_t beside_it = 104, along_it = 152, around = 120, most_batches = 3;
    const bool beside = is_beside_line();
    all_.reserve(!beside ? around : request_.along ? along_it : beside_it);
    free_.reserve(most_batches), covering_.reserve(most_batches);
    if (beside)
        propose_beside_line(*request_.toward);
    else
        propose_around(0, 0, false);
    keep_as_batch();
}

bool LabelPlaces::is_beside_line() const { return request_.toward && length(*request_.toward - request_.anchor) > 0; }

int LabelPlaces::uncovered() const {
    int count = 0;
    for (const Candidate& candidate : all_) count += !candidate.covered;
    return count;
}

bool LabelPlaces::propose_more(double least) {
    const bool beside = is_beside_line();
    // A vector shorter than its name has room beyond its ends; a direction mark stays on its line if it can.
    const double price = request_.along ? upright_price : beside_price;
    if (stage_ == 0) {
        if (beside && least < price) return false;
        stage_ = 1;
        if (beside) {
            propose_around(price, request_.along ? 0.0 : length(*request_.toward - request_.anchor), false);
            keep_as_batch();
            return true;
        }
    }
    if (stage_ == 1) {
        if (least < least_of_far) return false;
        stage_ = 2;
        propose_around(beside ? price : 0.0, 0, true);
        keep_as_batch();
        return true;
    }
    return false;
}

/// What was proposed since the last time.
void LabelPlaces::keep_as_batch() {
    const std::size_t first = free_.empty() ? 0 : free_.back().end;
    free_.push_back({first, all_.size()});
    covering_.push_back({first, all_.size()});
}

/// Prices a place as far as its own position goes; in line, since there are a hundred for each label.
inline void LabelPlaces::finish(Candidate& candidate) {
    const Box of_box = extent_of(candidate.box);
    const Spot out = setting_.outside(of_box);
    candidate.price += 0.06 * (out.x + out.y);
    // Out of the room means that the whole drawing must shrink: dearer than a leader, cheaper than covering a stroke.
    if (out.x > setting_.spare.x || out.y > setting_.spare.y) {
        candidate.price += setting_.strict ? covers_label : leaves_room;
        candidate.covered = setting_.strict;
    }
    candidate.free = setting_.ground.is_free(candidate.box);
    candidate.covered = candidate.covered || !candidate.free;
    candidate.close_extent(of_box);
    enlarge(span_, candidate.extent);
}

void LabelPlaces::propose_beside_line(Spot toward) {
    const Spot along = unit(toward - request_.anchor), across = turned(along);
    const double half_line = length(toward - request_.anchor);
    Spot axis{1, 0};
    if (request_.along) {
        axis = along;
        // Read from below or from the right, never upside-down; what is nearly upright reads upwards.
        constexpr double nearly = 0.17;
        if (axis.x < -nearly || (axis.x < nearly && axis.y > 0)) axis = -1.0 * axis;
    }
    const double reach_across = std::abs(dot(across, axis)) * half_.x + std::abs(cross(across, axis)) * half_.y;
    const double slide = std::max(half_line * 0.7, 4.0);
    const Spot middle = 0.5 * (setting_.box.min + setting_.box.max);
    const Spot outward = request_.anchor - middle;
    for (const double extra : {0.0, 0.7, 1.5, 3.0})
        for (const double at :
             {0.0, -0.15, 0.15, -0.3, 0.3, -0.5, 0.5, -0.7, 0.7, -0.85, 0.85, -1.0, 1.0, -1.4, 1.4, -1.9, 1.9, -2.5, 2.5}) {
            // Only a mark that is turned with its line can stand before or behind it.
            if (std::abs(at) > 1.1 && !request_.along) continue;
            for (const double side : {-1.0, 1.0}) {
                Candidate& candidate = all_.emplace_back();
                const Spot off = side * across;
                candidate.box = {request_.anchor + (at * slide) * along + (request_.clearance + extra + reach_across) * off,
                                 half_, axis};
                candidate.price = 1.5 * extra + 2.0 * std::abs(at);
                if (dot(off, outward) < 0) candidate.price += 0.8;                                 // the outer side
                if (off.y > 0.3 || (std::abs(off.y) <= 0.3 && off.x < 0)) candidate.price += 0.3;  // above, right
                finish(candidate);
            }
        }
}

/// A place in the direction u from the anchor, `extra` mm further than the nearest.
inline void LabelPlaces::stand_around(Spot u, double extra, bool leader, Candidate& candidate) const {
    InkBox box{{}, half_};
    box.centre = request_.anchor + centre_distance(box, u, request_.clearance + extra) * u;
    candidate.box = box;
    // Upper right is read first, then upper left, right, below.
    candidate.price = far_price * extra + 0.45 * (1 - (u.x - u.y) * std::numbers::sqrt2 / 2);
    if (leader) {
        candidate.add_leader(request_);
        candidate.price += leader_price;
    }
}

void LabelPlaces::propose_around(double penalty, double half_line, bool far) {
    static const std::vector<Spot> round = directions(24);
    static constexpr std::array near_rings{0.0, 0.5, 1.1, 2.0, 3.2}, far_rings{6.0, 9.0, 13.0, 18.0, 24.0};
    for (const double extra : far ? far_rings : near_rings)
        for (std::size_t k = 0; k < round.size(); ++k) {
            const bool leader = extra > 3.5 || (request_.balloon > 0 && extra > 1.5);
            if (leader && k % 2 != 0) continue;
            if (half_line > 0 && !leader && extra > 2.5) continue;
            Candidate& candidate = all_.emplace_back();
            stand_around(round[k], extra, leader, candidate);
            candidate.price += penalty + (k % 6 == 0 ? 0 : 0.05);
            finish(candidate);
        }
}

/// The most wanted first: where one of them is free, the others need no look.
void LabelPlaces::rank(Queue& queue, bool free) const {
    if (std::exchange(queue.is_ranked, true)) return;
    constexpr std::size_t often_met = 16;
    queue.waiting.reserve(queue.end - queue.first);
    queue.met.reserve(std::min(often_met, queue.end - queue.first));
    for (std::size_t place = queue.first; place < queue.end; ++place)
        if (const Candidate& candidate = all_[place]; candidate.free == free)
            queue.waiting.push_back({candidate.price + (free ? 0 : covers_stroke), place, false});
    std::make_heap(queue.waiting.begin(), queue.waiting.end(), std::greater<>());
}

/// The next place of a queue, of which `rank` have been met. What stands about a place is looked at only when it is its turn; it
/// then makes room for those that now cost less.
std::size_t LabelPlaces::next_of(Queue& queue, std::size_t rank) {
    while (queue.met.size() <= rank) {
        std::pop_heap(queue.waiting.begin(), queue.waiting.end(), std::greater<>());
        Ranked& next = queue.waiting.back();
        if (next.priced) {
            queue.met.push_back(next);
            queue.waiting.pop_back();
        } else {
            Candidate& candidate = all_[next.place];
            look_about(candidate);
            next.price = candidate.price;
            next.priced = true;
            std::push_heap(queue.waiting.begin(), queue.waiting.end(), std::greater<>());
        }
    }
    return queue.met[rank].place;
}

/// Adds what the marks about a place cost, and the objects that it might seem to name.
void LabelPlaces::look_about(Candidate& candidate) const {
    const Ground& ground = setting_.ground;
    candidate.price += ground.price(candidate.box, candidate.free);
    if (!candidate.free) return;
    candidate.price += request_.toward ? near_other_lines(candidate) : near_other_points(candidate);
    if (candidate.leader) candidate.price += crossing_price * ground.crossed(candidate.leader_from, candidate.leader_to);
}

/// A name must not seem to belong to a neighbour …
double LabelPlaces::near_other_points(const Candidate& candidate) const {
    double price = 0;
    const Spot reach = candidate.box.reach(), centre = candidate.box.centre;
    const double own = distance_to_box(request_.anchor, candidate.box);
    for (std::size_t j = 0; j < setting_.requests.size(); ++j) {
        const LabelRequest& other = setting_.requests[j];
        if (j == label_ || other.toward) continue;
        const Spot d = other.anchor - centre;
        if (std::abs(d.x) > reach.x + own + 1 || std::abs(d.y) > reach.y + own + 1) continue;
        const double away = distance_to_box(other.anchor, candidate.box);
        if (away < own + 1.0) price += 4 * (own + 1.0 - away);
    }
    return price;
}

/// … nor a vector's name to the vector beside it.
double LabelPlaces::near_other_lines(const Candidate& candidate) const {
    if (request_.along) return 0;
    double price = 0;
    const Spot centre = candidate.box.centre;
    const double near = distance_to_line(request_, centre) + 0.8;
    for (std::size_t j = 0; j < setting_.requests.size(); ++j) {
        const LabelRequest& other = setting_.requests[j];
        if (j == label_ || !other.toward || other.along || other.balloon > 0) continue;
        if (is_beyond(other, centre, near)) continue;
        const double away = distance_to_line(other, centre);
        if (away < near) price += 2.5 * std::min(2.0, near - away);
    }
    return price;
}

}  // namespace kinegraph::render::lettering
