// Proposal of places, their pricing and their order by price.
#include "render/page/label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/number/functions.hpp"
#include "render/page/label_prices.hpp"

namespace kinegraph::render::lettering {

namespace {

constexpr double beside_price = 2.5;       // for the name of a vector beyond its ends
constexpr double upright_price = 8;        // for a direction mark that leaves its line
constexpr double named_by_another = 29;    // for the name of a vector nearer to another; a leader is better
constexpr double leads_along = 14;         // for a leader in the direction of its vector
constexpr double foreign_tint_price = 34;  // for a body number on another's tint; a leader is better
constexpr double leaves_room = 30;
constexpr double least_of_far = 11;  // leader plus distance: lower bound for all distant places
constexpr double unlimited = 1e300;
constexpr double kept_apart = line_gap / 2;  // half of the distance between two labels side by side
// A place that covers ink costs more than every surcharge for less desirable places.
static_assert(covers_stroke > std::max({beside_price, upright_price, least_of_far}));

enum class Distance { nearest, near, far };

void sort_by_bound(std::vector<Seed>& seeds) {
    std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.bound < b.bound; });
}

/// Seeds on rings about an anchor. A number in a circle gets a leader at a shorter distance.
std::vector<Seed> seeds_around(Distance distance, bool balloon) {
    constexpr int count = 24;
    using enum Distance;
    const std::vector<double> rings = distance == nearest ? std::vector{0.0}
                                      : distance == near  ? std::vector{0.5, 1.1, 2.0, 3.2}
                                                          : std::vector{6.0, 9.0, 13.0, 18.0, 24.0};
    std::vector<Seed> seeds;
    for (const double extra : rings)
        for (int k = 0; k < count; ++k) {
            const bool leader = extra > 3.5 || (balloon && extra > 1.5);
            if (leader && k % 2 != 0) continue;
            const double angle = 2 * std::numbers::pi * k / count;
            const Spot u{nearest::cos(angle), -nearest::sin(angle)};
            // Order of preference: upper right, upper left, right, below.
            const double turned_away = 0.45 * (1 - (u.x - u.y) * std::numbers::sqrt2 / 2) + (k % 6 == 0 ? 0 : 0.05);
            seeds.push_back({.bound = far_price * extra + turned_away + (leader ? leader_price : 0),
                             .extra = extra,
                             .along = u,
                             .leader = leader});
        }
    sort_by_bound(seeds);
    return seeds;
}

/// Seeds beside a line on both sides, from its middle outwards. Only a mark that is turned with its line may stand
/// before or behind it.
std::vector<Seed> seeds_beside(Distance distance, bool turned_with_it) {
    constexpr double past_the_end = 1.1;
    const std::vector<double> rows = distance == Distance::nearest ? std::vector{0.0} : std::vector{0.7, 1.5, 3.0};
    std::vector<Seed> seeds;
    for (const double extra : rows)
        for (const double at : {0.0, -0.15, 0.15, -0.3, 0.3, -0.5, 0.5, -0.7, 0.7, -0.85, 0.85, -1.0, 1.0, -1.4, 1.4,
                                -1.9, 1.9, -2.5, 2.5})
            for (const double side : {-1.0, 1.0})
                if (turned_with_it || std::abs(at) <= past_the_end)
                    seeds.push_back(
                        {.bound = 1.5 * extra + 2.0 * std::abs(at), .extra = extra, .at = at, .side = side});
    sort_by_bound(seeds);
    return seeds;
}

/// All seeds, computed once.
const std::vector<Seed>& seeds_of(bool beside, Distance distance, bool turned_or_balloon) {
    static const auto all = [] {
        std::array<std::vector<Seed>, 12> made;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const auto how_far = static_cast<Distance>(i / 4);
            made[i] = i % 4 < 2 ? seeds_around(how_far, i % 2 == 1) : seeds_beside(how_far, i % 2 == 1);
        }
        return made;
    }();
    return all[4 * static_cast<std::size_t>(distance) + (beside ? 2 : 0) + (turned_or_balloon ? 1 : 0)];
}

/// Distance along u of the box's centre, if the ink nearest to the origin is `distance` away from it.
double centre_distance(const InkBox& box, Spot u, double distance) {
    const Spot v{std::abs(u.x), std::abs(u.y)}, h = box.half;
    if (const double t = (distance + h.x) / std::max(v.x, 1e-12); t * v.y <= h.y) return t;
    if (const double t = (distance + h.y) / std::max(v.y, 1e-12); t * v.x <= h.x) return t;
    // Past both sides, the corner is nearest.
    const double b = dot(v, h), c = dot(h, h) - distance * distance;
    return b + std::sqrt(std::max(0.0, b * b - c));
}

}  // namespace

void Candidate::add_leader(const LabelSetting& setting, std::size_t label) {
    const LabelRequest& request = setting.requests[label];
    const Spot end = setting.ends.nearest(label, box), at = end - box.centre;
    const Spot foot =
        box.centre + Spot{std::clamp(at.x, -box.half.x, box.half.x), std::clamp(at.y, -box.half.y, box.half.y)};
    const Spot back = unit(foot - end);
    leader = true;
    // A leader that runs on along its vector is taken for a line of the construction.
    constexpr double as_one_line = 0.94;
    if (request.is_of_vector && std::abs(dot(back, unit(*request.toward - request.anchor))) > as_one_line)
        price += leads_along;
    // The leader of a link's number begins on the link itself.
    const bool on_it = request.toward && !request.along;
    leader_from = end + (on_it ? 0 : std::max(0.6, request.clearance - 0.9)) * back;
    leader_to = foot - 0.5 * back;
    thread = {0.5 * (leader_from + leader_to), {length(leader_to - leader_from) / 2, 0.1}, back};
}

void Candidate::close_extent(const Box& of_box) {
    constexpr Spot kept{kept_apart, kept_apart};
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
    // Reserved at once: growing step by step takes twice the memory, and candidates are large.
    constexpr std::size_t often_met = 96, most_batches = 5;
    all_.reserve(often_met);
    batches_.reserve(most_batches);
    if (is_beside_line()) {
        beside_ = beside_of(*request_.toward);
        propose(seeds_of(true, Distance::nearest, request_.along), 0, true, unlimited);
    } else {
        propose(seeds_of(false, Distance::nearest, request_.balloon > 0), 0, false, unlimited);
    }
    // All of the nearest places are evaluated first: the number of free ones determines the order of the labels. With
    // fewer places the order is worse and figures become smaller.
    while (batches_.front().has_seeds()) place_next(batches_.front());
    propose_more(unlimited);
    while (batches_.back().next < batches_.back().seeds->size() / 2) place_next(batches_.back());
    for (const Candidate& candidate : all_) uncovered_ += !candidate.covered;
}

bool LabelPlaces::is_beside_line() const { return request_.toward && length(*request_.toward - request_.anchor) > 0; }

bool LabelPlaces::propose_more(double least) {
    const bool balloon = request_.balloon > 0;
    // A vector shorter than its name has room beyond its ends; a direction mark should stay on its line.
    const double beyond = !beside_ ? 0 : request_.along ? upright_price : beside_price;
    using enum Distance;
    const auto may_help = [&](const std::vector<Seed>& seeds, double penalty) {
        return penalty + seeds.front().bound < least;
    };
    switch (stage_) {
        case 0: {
            const std::vector<Seed>& seeds = seeds_of(beside_.has_value(), near, beside_ ? request_.along : balloon);
            if (!may_help(seeds, 0)) return false;
            propose(seeds, 0, beside_.has_value(), unlimited);
            break;
        }
        case 1:
        case 2: {
            if (!beside_) {
                stage_ = 3;
                return propose_more(least);
            }
            const std::vector<Seed>& seeds = seeds_of(false, stage_ == 1 ? nearest : near, balloon);
            constexpr double at_an_end = 2.5;
            if (!may_help(seeds, beyond)) return false;
            propose(seeds, beyond, false, request_.along ? unlimited : at_an_end);
            break;
        }
        case 3: {
            if (least < least_of_far) return false;
            propose(seeds_of(false, far, balloon), beyond, false, unlimited);
            break;
        }
        default: return false;
    }
    ++stage_;
    return true;
}

void LabelPlaces::propose(const std::vector<Seed>& seeds, double penalty, bool beside, double farthest) {
    batches_.push_back({&seeds, penalty, beside, farthest});
    constexpr std::size_t often_free = 64, often_covering = 32, often_met = 8;
    batches_.back().free.waiting.reserve(often_free);
    batches_.back().free.met.reserve(often_met);
    batches_.back().covering.waiting.reserve(often_covering);
    // Upper bound of the extent of all its places.
    double extra = 0, at = 0;
    for (const Seed& seed : seeds) extra = std::max(extra, seed.extra), at = std::max(at, std::abs(seed.at));
    const double reach =
        request_.clearance + extra + 2 * (half_.x + half_.y) + kept_apart + (beside ? at * beside_->slide : 0);
    enlarge(span_, Box{request_.anchor - Spot{reach, reach}, request_.anchor + Spot{reach, reach}});
}

LabelPlaces::Beside LabelPlaces::beside_of(Spot toward) const {
    Beside beside;
    beside.along = unit(toward - request_.anchor);
    beside.across = turned(beside.along);
    beside.axis = {1, 0};
    if (request_.along) {
        beside.axis = beside.along;
        // Text reads from below or from the right, never upside down; nearly vertical text reads upwards.
        constexpr double nearly = 0.17;
        if (beside.axis.x < -nearly || (beside.axis.x < nearly && beside.axis.y > 0)) beside.axis = -1.0 * beside.axis;
    }
    beside.reach_across =
        std::abs(dot(beside.across, beside.axis)) * half_.x + std::abs(cross(beside.across, beside.axis)) * half_.y;
    beside.slide = std::max(length(toward - request_.anchor) * 0.7, 4.0);
    const Spot outward = request_.anchor - 0.5 * (setting_.box.min + setting_.box.max);
    for (const double side : {-1.0, 1.0}) {
        const Spot off = side * beside.across;
        double& price = beside.price[side < 0 ? 0 : 1];
        price = dot(off, outward) < 0 ? 0.8 : 0;                                 // the outer side
        if (off.y > 0.3 || (std::abs(off.y) <= 0.3 && off.x < 0)) price += 0.3;  // above, right
    }
    return beside;
}

inline void LabelPlaces::stand_beside(const Seed& seed, Candidate& candidate) const {
    const Beside& line = *beside_;
    const double off = seed.side * (request_.clearance + seed.extra + line.reach_across);
    candidate.box = {request_.anchor + (seed.at * line.slide) * line.along + off * line.across, half_, line.axis};
    candidate.price += line.price[seed.side < 0 ? 0 : 1];
}

inline void LabelPlaces::stand_around(const Seed& seed, Candidate& candidate) const {
    InkBox box{{}, half_};
    box.centre = request_.anchor + centre_distance(box, seed.along, request_.clearance + seed.extra) * seed.along;
    candidate.box = box;
    if (seed.leader) candidate.add_leader(setting_, label_);
}

/// Computes the price that depends on the place's own position.
inline void LabelPlaces::finish(Candidate& candidate) const {
    const Box of_box = extent_of(candidate.box);
    const Spot out = setting_.outside(of_box);
    candidate.price += 0.06 * (out.x + out.y);
    // Leaving the room would force the whole drawing to shrink: dearer than a leader, cheaper than covering a stroke.
    if (out.x > setting_.spare.x || out.y > setting_.spare.y) {
        candidate.price += setting_.strict ? covers_label : leaves_room;
        candidate.covered = setting_.strict;
    }
    candidate.free = setting_.ground.is_free(candidate.box);
    candidate.covered = candidate.covered || !candidate.free;
    candidate.close_extent(of_box);
}

void LabelPlaces::place_next(Batch& batch) {
    const double bound = batch.bound();
    const Seed& seed = (*batch.seeds)[batch.next++];
    if (!seed.leader && seed.extra > batch.farthest) return;
    const std::size_t place = all_.size();
    Candidate& candidate = all_.emplace_back(bound);
    candidate.ringed = request_.balloon > 0;
    if (batch.beside)
        stand_beside(seed, candidate);
    else
        stand_around(seed, candidate);
    finish(candidate);
    if (candidate.free)
        batch.free.wait({candidate.price, place, false});
    else
        batch.covering.wait({candidate.price + covers_stroke, place, false});
}

void LabelPlaces::Queue::wait(Ranked place) {
    waiting.push_back(place);
    std::push_heap(waiting.begin(), waiting.end(), std::greater<>());
}

/// The surroundings of a place are examined only when it comes first; its price may then rise, so that others overtake
/// it.
bool LabelPlaces::is_met(Batch& batch, Queue& queue, std::size_t rank, double least) {
    while (queue.met.size() <= rank) {
        if (queue.waiting.empty() && !batch.has_seeds()) return false;
        const double first = queue.waiting.empty() ? unlimited : queue.waiting.front().price;
        const double bound = batch.has_seeds() ? batch.bound() : unlimited;
        if (std::min(first, bound) >= least) return false;
        if (bound <= first) {
            place_next(batch);
            continue;
        }
        std::pop_heap(queue.waiting.begin(), queue.waiting.end(), std::greater<>());
        Ranked next = queue.waiting.back();
        queue.waiting.pop_back();
        if (next.priced) {
            queue.met.push_back(next);
        } else {
            look_about(all_[next.place]);
            queue.wait({all_[next.place].price, next.place, true});
        }
    }
    return queue.met[rank].price < least;
}

/// Adds the price of nearby marks, and of objects that the label might seem to name.
void LabelPlaces::look_about(Candidate& candidate) const {
    const Ground& ground = setting_.ground;
    candidate.price += ground.price(candidate.box, candidate.free);
    if (is_on_foreign_tint(candidate)) candidate.price += foreign_tint_price;
    if (!candidate.free) return;
    candidate.price += request_.toward ? near_other_lines(candidate) : near_other_points(candidate);
    if (candidate.leader)
        candidate.price += crossing_price * ground.crossed(candidate.leader_from, candidate.leader_to) +
                           setting_.bodies.led_astray(label_, candidate.leader_from, candidate.leader_to);
    else
        candidate.price += setting_.bodies.near_another(request_, candidate.box);
}

/// Whether the number of a body stands, even partly, on the tint of another body, to which it would seem to belong.
bool LabelPlaces::is_on_foreign_tint(const Candidate& candidate) const {
    if (!request_.ground || request_.balloon <= 0) return false;
    const double off = request_.balloon;
    for (const Spot aside : {Spot{0, 0}, Spot{off, 0}, Spot{-off, 0}, Spot{0, off}, Spot{0, -off}}) {
        const auto tint = setting_.ground.tint_at(candidate.box.centre + aside);
        if (!tint) continue;
        // By the body and not by the colour, so that numbers stand alike in every theme.
        const BalloonGround& own = *request_.ground;
        if (tint->body != none ? tint->body != own.body : tint->colour != own.own && tint->colour != own.paper)
            return true;
    }
    return false;
}

/// Price of a name that might seem to belong to a neighbouring point.
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

/// Price of a vector's name that might seem to belong to the vector beside it.
double LabelPlaces::near_other_lines(const Candidate& candidate) const {
    if (request_.along) return 0;
    double price = 0;
    // A leader says whose name it is, however many other vectors are nearer.
    const bool has_leader = request_.is_of_vector && candidate.leader;
    constexpr double most_with_leader = 10;
    const Spot centre = candidate.box.centre;
    const double near = distance_to_line(request_, centre) + 0.8;
    const double own = has_leader ? 0 : distance_to_line(request_, candidate.box);
    const double seen = request_.is_of_vector && !has_leader ? std::max(near, own + half_.x + half_.y) : near;
    constexpr double same = 0.1;  // mm; vectors that lie on each other are told apart by their heads
    bool is_nearest = true;
    for (std::size_t j = 0; j < setting_.requests.size(); ++j) {
        const LabelRequest& other = setting_.requests[j];
        if (j == label_ || !names_a_line(other)) continue;
        if (is_beyond(other, centre, seen)) continue;
        const double away = distance_to_line(other, centre);
        if (away < near) price += 2.5 * std::min(2.0, near - away);
        if (has_leader && price >= most_with_leader) return most_with_leader;
        if (has_leader) continue;
        // Where two vectors meet, the name is as near to the one as to the other.
        const double apart = lie_on_one_line(request_, other) ? -same : same;
        is_nearest = is_nearest && distance_to_line(other, candidate.box) > own + apart;
    }
    // It would be read as the other's name.
    if (request_.is_of_vector && !is_nearest) price += named_by_another;
    return price;
}

}  // namespace kinegraph::render::lettering
