// Labels: finds every label of a figure a place beside its object where it covers no stroke, no arrowhead and no other label.
// Owns the candidates, their price and the search; knows no mechanics, only marks. Deterministic: all orders are those of the
// figure, all ties go to the first.
//
// Method: point-feature labelling by candidate places on rings about the anchor (after Imhof's rules), each priced once against
// the ink map and kept in the order of price; the least free label first, then rounds of improvement with evictions. What still
// covers something then is moved to the nearest room that is free, with a leader.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "render/page/ink_map.hpp"
#include "render/page/label_key.hpp"
#include "render/page/labels.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double ink_margin = 0.45;   // clear paper round every letter, mm
constexpr double label_gap = 0.8;     // between two labels
constexpr double breathing = 1.3;     // a stroke nearer than this makes a place less wanted
constexpr double covers_stroke = 50;  // the price that no wish outweighs …
constexpr double covers_area = 15;    // … and for each mm² of it
constexpr double covers_label = 400;
constexpr double crowding = 0.5;  // for each mm² of ink within breathing distance
constexpr double most_crowding = 2.8;
constexpr double beside_price = 2.5;  // of a vector's name beyond its ends
constexpr double upright_price = 8;   // of a direction mark that leaves its line
constexpr double leaves_room = 30;
constexpr double leader_price = 6;
constexpr double crossing_price = 2.5;  // of a leader, for each stroke it crosses
constexpr double far_price = 0.9;       // for each mm from the nearest place
constexpr double least_measure = 45;    // of a label, before it is shortened
constexpr double longest_leader = 40;   // beyond it nobody sees what is named
constexpr double wide_key = 90;         // of a key's lines under a narrow figure
constexpr double above_key = 2.5;
constexpr double least_of_far = 11;  // leader and distance: no far place costs less
constexpr double farthest = 80;      // out of the figure's box, where no room is given
constexpr int most_looks = 30000;    // for better far places, in a figure; then the first that is free will do

/// A tinted area: a label may stand in it, but rather not.
struct Area {
    std::vector<Spot> corners;
    Box box;
};

constexpr Box nowhere{{1e300, 1e300}, {-1e300, -1e300}};

bool apart(const Box& a, const Box& b) {
    return a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y;
}
void enlarge(Box& box, Spot by) {
    box.min = {std::min(box.min.x, by.x), std::min(box.min.y, by.y)};
    box.max = {std::max(box.max.x, by.x), std::max(box.max.y, by.y)};
}
void enlarge(Box& box, const Box& by) {
    enlarge(box, by.min);
    enlarge(box, by.max);
}
Box extent_of(const InkBox& box) {
    const Spot reach = box.axis.y == 0 ? box.half : box.reach();  // most are upright
    return {box.centre - reach, box.centre + reach};
}

/// Distance of two turned boxes along their worst of four separating axes; negative where they overlap. Of more than `enough` it
/// is only said that it is more.
double gap_between(const InkBox& a, const InkBox& b, double enough) {
    const Spot d = b.centre - a.centre;
    // Most pairs are far apart: their circles tell.
    const double round = a.half.x + a.half.y + b.half.x + b.half.y + enough;
    if (std::abs(d.x) > round || std::abs(d.y) > round) return enough;
    if (a.axis.y == 0 && b.axis.y == 0) return std::max(std::abs(d.x) - a.half.x - b.half.x, std::abs(d.y) - a.half.y - b.half.y);
    double gap = -std::numeric_limits<double>::infinity();
    for (const Spot axis : {a.axis, turned(a.axis), b.axis, turned(b.axis)}) {
        const double reach_a = std::abs(dot(axis, a.axis)) * a.half.x + std::abs(cross(axis, a.axis)) * a.half.y;
        const double reach_b = std::abs(dot(axis, b.axis)) * b.half.x + std::abs(cross(axis, b.axis)) * b.half.y;
        gap = std::max(gap, std::abs(dot(axis, d)) - reach_a - reach_b);
        if (gap >= enough) break;
    }
    return gap;
}

double distance_to_box(Spot spot, const InkBox& box) {
    const Spot at = box.local(spot);
    return length({std::max(std::abs(at.x) - box.half.x, 0.0), std::max(std::abs(at.y) - box.half.y, 0.0)});
}

bool inside(const Area& area, Spot spot) {
    if (spot.x < area.box.min.x || spot.x > area.box.max.x || spot.y < area.box.min.y || spot.y > area.box.max.y) return false;
    bool in = false;
    const std::vector<Spot>& c = area.corners;
    for (std::size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
        if ((c[i].y > spot.y) != (c[j].y > spot.y) && spot.x < (c[j].x - c[i].x) * (spot.y - c[i].y) / (c[j].y - c[i].y) + c[i].x)
            in = !in;
    return in;
}

/// All that is drawn already.
class Ground {
public:
    Ground(const std::vector<Mark>& marks, const Fonts& fonts) : map_(box_of(marks)) {
        for (const Mark& mark : marks) {
            if (const auto* path = std::get_if<Path>(&mark)) add(*path);
            if (const auto* axis = std::get_if<Axis>(&mark)) map_.stroke(axis->tail, axis->tip, 0.35);
            if (const auto* text = std::get_if<TextMark>(&mark)) add(*text, fonts);
        }
    }

    bool is_free(const InkBox& box) const { return !map_.touches(box.grown(ink_margin)); }
    /// No ink under it, however near. Grown so far that a corner which reaches into a slanting stroke does not slip between bits.
    bool is_bare(const InkBox& box) const { return !map_.touches(box.grown(0.7 * InkMap::pitch)); }
    /// Whether a leader there would run over letters that are drawn already.
    bool covers_text(const InkBox& thread) const {
        return std::any_of(texts_.begin(), texts_.end(),
                           [&](const InkBox& text) { return gap_between(thread, text, 0.1) < 0.1; });
    }
    /// What a label there costs: ink within the margin is forbidden, ink within breathing distance and a tint are a pity.
    double price(const InkBox& box, bool free) const {
        double price = 0;
        for (const Area& area : areas_)
            if (inside(area, box.centre)) price += 2.0;
        if (free) return price + std::min(most_crowding, crowding * map_.inked(box.grown(breathing), most_crowding / crowding));
        return price + covers_stroke + covers_area * map_.inked(box.grown(ink_margin));
    }
    /// Strokes that a leader would cross, counted no further than `most` of them.
    int crossed(Spot from, Spot to, int most = InkMap::all) const { return map_.crossings(from, to, most); }

private:
    void add(const Path& path) {
        map_.ink(path);
        if (!path.filled || !path.tinted || is_dot(path)) return;
        Area area{outline_of(path), nowhere};
        if (area.corners.size() < 3) return;
        for (const Spot& spot : area.corners) enlarge(area.box, spot);
        areas_.push_back(std::move(area));
    }

    void add(const TextMark& text, const Fonts& fonts) {
        if (const auto ink = ink_of(text, fonts)) {
            map_.fill(ink->grown(label_gap - ink_margin));
            texts_.push_back(*ink);
        }
    }

    InkMap map_;
    std::vector<Area> areas_;
    std::vector<InkBox> texts_;
};

/// A place a label may take.
struct Candidate {
    InkBox box;
    double price = 0;      // what does not depend on other labels
    bool free = false;     // covers no ink
    bool covered = false;  // … or is out of the room
    bool leader = false;
    Spot leader_from, leader_to;
    Box extent = nowhere;  // of box and leader and what another label must keep off it
    InkBox thread;         // the leader's
};

/// All places that one label may take.
struct Places {
    std::vector<Candidate> all;
    /// A place by its price; until it is priced, by the least that it can cost.
    struct Ranked {
        double price;
        std::size_t place;
        bool priced;
        bool operator>(const Ranked& other) const { return price > other.price || (price == other.price && place > other.place); }
    };
    /// Places that were proposed together, and are asked for in the order of price: most of them never are.
    struct Kind {
        std::size_t first, end;         // among all
        bool is_ranked = false;         // only once it is asked for
        std::vector<Ranked> met{};      // in their order
        std::vector<Ranked> waiting{};  // a heap, the cheapest on top
        /// What the next place costs at least of which `rank` have been asked for; infinity: there is none.
        double least(std::size_t rank) const {
            if (rank < met.size()) return met[rank].price;
            return waiting.empty() ? std::numeric_limits<double>::infinity() : waiting.front().price;
        }
    };
    std::vector<Kind> free, covering;  // those that cover ink: dearer than most, and the dearest to price
    int stage = 0;                     // how many kinds have been proposed
    Box span = nowhere;                // what all of them take
};

/// How far the ink of a line reaches beyond its ends: f and J lean out of their widths.
double overhang_of(const ShapedLine& line, const Fonts& fonts) {
    double out = 0;
    const auto look_at = [&](double x) { out = std::max({out, -x, x - line.width}); };
    for (const ShapedLine::Part& part : line.parts)
        for (const Glyph& glyph : part.glyphs)
            for (const Segment& segment : fonts.outline(glyph.face, glyph.index).segments) {
                if (const auto* m = std::get_if<MoveTo>(&segment)) look_at(glyph.origin.x + glyph.size * m->to.x);
                if (const auto* l = std::get_if<LineTo>(&segment)) look_at(glyph.origin.x + glyph.size * l->to.x);
                if (const auto* c = std::get_if<CurveTo>(&segment)) look_at(glyph.origin.x + glyph.size * c->to.x);
            }
    return out;
}

class Placing {
public:
    Placing(const std::vector<LabelRequest>& requests, const Box& box, const Fonts& fonts, const Ground& ground,
            const std::optional<Spot>& room, bool strict)
        : requests_(requests), ground_(ground), box_(box), strict_(strict) {
        const std::size_t count = requests_.size();
        shaped_.reserve(count), overhang_.reserve(count), halves_.reserve(count);
        if (room) spare_ = {std::max(0.0, room->x - box_.width()) / 2, std::max(0.0, room->y - box_.height()) / 2};
        for (const LabelRequest& request : requests_) {
            const double measure = room && request.balloon <= 0 ? std::max(0.5 * room->x, least_measure) : 1e300;
            shaped_.push_back(shaped_within(request.text, request.size, fonts, measure));
            overhang_.push_back(overhang_of(shaped_.back(), fonts));
            halves_.push_back(half_of(halves_.size()));
        }
        places_.resize(requests_.size());
        chosen_.resize(requests_.size());
        for (std::size_t i = 0; i < requests_.size(); ++i) propose(i);
    }

    /// False where `only_within` (the width and height of a room) is given and they do not fit into it.
    bool place(const std::optional<Spot>& only_within) {
        // The least free first; ties in the figure's order.
        std::vector<std::pair<int, std::size_t>> order;
        for (std::size_t i = 0; i < requests_.size(); ++i) {
            int free = 0;
            for (const Candidate& candidate : places_[i].all) free += !candidate.covered;
            order.emplace_back(free, i);
        }
        std::sort(order.begin(), order.end());
        for (const auto& [free, i] : order) chosen_[i] = *best(i);
        int looks_left = 30 + static_cast<int>(requests_.size());  // where there is no room at all, looking on finds none
        for (int round = 0; round < 4; ++round) {
            bool changed = false;
            for (const auto& [free, i] : order) {
                if (const auto better = best(i, price_now(i) - least_gain)) {
                    chosen_[i] = *better;
                    changed = true;
                }
                changed = evict(i, looks_left) || changed;
            }
            if (!changed) break;
        }
        if (only_within && !fits(*only_within)) return false;
        repair(order);
        return true;
    }

    /// To be set, once.
    ShapedLine take_shaped(std::size_t i) { return std::move(shaped_[i]); }
    const Candidate& chosen(std::size_t i) const { return chosen_[i]; }
    /// Whether some label is in the way.
    bool is_crowded() const {
        for (std::size_t i = 0; i < requests_.size(); ++i)
            if (in_the_way(i)) return true;
        return false;
    }
    /// The labels for which no place was found: they cover something, or stand where they may not, or in each other's way. Of two
    /// that do the one goes that frees more of the others.
    std::vector<std::size_t> placeless() const {
        std::vector<bool> gone(requests_.size());
        for (std::size_t i = 0; i < requests_.size(); ++i)
            gone[i] = (strict_ && leaves_the_room(chosen_[i])) || !ground_.is_bare(inked(i, chosen_[i].box)) ||
                      (chosen_[i].leader && ground_.covers_text(chosen_[i].thread));
        std::vector<std::vector<std::size_t>> met(requests_.size());
        for (std::size_t i = 0; i < requests_.size(); ++i)
            for (std::size_t j = 0; j < requests_.size(); ++j)
                if (j != i && !gone[i] && !gone[j] && meet(chosen_[i], chosen_[j])) met[i].push_back(j);
        for (;;) {
            std::size_t most = 0, worst = 0;
            for (std::size_t i = 0; i < requests_.size(); ++i)
                if (!gone[i] && met[i].size() >= std::max<std::size_t>(most, 1)) {
                    // A leader is no loss.
                    if (met[i].size() == most && chosen_[worst].leader && !chosen_[i].leader) continue;
                    most = met[i].size(), worst = i;
                }
            if (most == 0) break;
            gone[worst] = true;
            for (const std::size_t j : met[worst]) std::erase(met[j], worst);
        }
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < requests_.size(); ++i)
            if (gone[i]) found.push_back(i);
        return found;
    }

private:
    static constexpr double least_gain = 1e-6;
    static constexpr double forgiven = 0.3;  // of what leans out of a box: the margin has room for it
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    InkBox box_at(std::size_t i, Spot centre, Spot axis) const { return {centre, halves_[i], axis}; }
    Spot half_of(std::size_t i) const {
        if (const double r = requests_[i].balloon; r > 0) return {r, r};
        const ShapedLine& s = shaped_[i];
        return {s.width / 2 + std::max(0.0, overhang_[i] - forgiven), (s.ascent + s.descent) / 2};
    }
    /// The box of all ink of a label that stands in a box: what leans out of it, the pen of the circle round a number.
    InkBox inked(std::size_t i, InkBox box) const {
        constexpr double pen = 0.2;
        if (requests_[i].balloon > 0) return box.grown(pen);
        box.half.x += std::min(overhang_[i], forgiven);
        return box;
    }
    bool beside_line(std::size_t i) const {
        return requests_[i].toward && length(*requests_[i].toward - requests_[i].anchor) > 0;
    }

    void propose(std::size_t i) {
        // Memory that grows step by step takes twice as much of it, and a place is no small thing.
        constexpr std::size_t beside_it = 104, along_it = 152, around = 120, most_kinds = 3;
        const bool beside = beside_line(i);
        places_[i].all.reserve(!beside ? around : requests_[i].along ? along_it : beside_it);
        places_[i].free.reserve(most_kinds), places_[i].covering.reserve(most_kinds);
        if (beside)
            propose_beside_line(i, *requests_[i].toward);
        else
            propose_around(i, 0, 0, false);
        keep_as_kind(places_[i]);
    }

    /// Less wanted places, thought of only where nothing so far costs less than they would.
    bool propose_more(std::size_t i, double least) {
        const LabelRequest& request = requests_[i];
        const bool beside = beside_line(i);
        // A vector shorter than its name has room beyond its ends; a direction mark stays on its line if it can.
        const double price = request.along ? upright_price : beside_price;
        int& stage = places_[i].stage;
        if (stage == 0) {
            if (beside && least < price) return false;
            stage = 1;
            if (beside) {
                propose_around(i, price, request.along ? 0.0 : length(*request.toward - request.anchor), false);
                keep_as_kind(places_[i]);
                return true;
            }
        }
        if (stage == 1) {
            if (least < least_of_far) return false;
            stage = 2;
            propose_around(i, beside ? price : 0.0, 0, true);
            keep_as_kind(places_[i]);
            return true;
        }
        return false;
    }

    /// What was proposed since the last time.
    static void keep_as_kind(Places& places) {
        const std::size_t first = places.free.empty() ? 0 : places.free.back().end;
        places.free.push_back({first, places.all.size()});
        places.covering.push_back({first, places.all.size()});
    }
    /// The most wanted first: where one of them is free, the others need no look.
    static void rank(const Places& places, Places::Kind& kind, bool free) {
        if (std::exchange(kind.is_ranked, true)) return;
        constexpr std::size_t often_met = 16;
        kind.waiting.reserve(kind.end - kind.first);
        kind.met.reserve(std::min(often_met, kind.end - kind.first));
        for (std::size_t place = kind.first; place < kind.end; ++place)
            if (const Candidate& candidate = places.all[place]; candidate.free == free)
                kind.waiting.push_back({candidate.price + (free ? 0 : covers_stroke), place, false});
        std::make_heap(kind.waiting.begin(), kind.waiting.end(), std::greater<>());
    }

    /// The next place of a kind in the order of price, of which `rank` have been met. What stands about a place is looked at only
    /// when it is its turn; it then makes room for those that now cost less.
    std::size_t next_of(std::size_t i, Places::Kind& kind, std::size_t rank) {
        while (kind.met.size() <= rank) {
            std::pop_heap(kind.waiting.begin(), kind.waiting.end(), std::greater<>());
            Places::Ranked& next = kind.waiting.back();
            if (next.priced) {
                kind.met.push_back(next);
                kind.waiting.pop_back();
            } else {
                Candidate& candidate = places_[i].all[next.place];
                look_about(i, candidate);
                next.price = candidate.price;
                next.priced = true;
                std::push_heap(kind.waiting.begin(), kind.waiting.end(), std::greater<>());
            }
        }
        return kind.met[rank].place;
    }

    void propose_beside_line(std::size_t i, Spot toward) {
        const LabelRequest& request = requests_[i];
        const Spot along = unit(toward - request.anchor), across = turned(along);
        const double half_line = length(toward - request.anchor);
        Spot axis{1, 0};
        if (request.along) {
            axis = along;
            // Read from below or from the right, never upside-down; what is nearly upright reads upwards.
            constexpr double nearly = 0.17;
            if (axis.x < -nearly || (axis.x < nearly && axis.y > 0)) axis = -1.0 * axis;
        }
        const InkBox probe = box_at(i, {}, axis);
        const double reach_across =
            std::abs(dot(across, probe.axis)) * probe.half.x + std::abs(cross(across, probe.axis)) * probe.half.y;
        const double slide = std::max(half_line * 0.7, 4.0);
        const Spot middle = 0.5 * (box_.min + box_.max);
        const Spot outward = request.anchor - middle;
        for (const double extra : {0.0, 0.7, 1.5, 3.0})
            for (const double at :
                 {0.0, -0.15, 0.15, -0.3, 0.3, -0.5, 0.5, -0.7, 0.7, -0.85, 0.85, -1.0, 1.0, -1.4, 1.4, -1.9, 1.9, -2.5, 2.5}) {
                // Only a mark that is turned with its line can stand before or behind it.
                if (std::abs(at) > 1.1 && !request.along) continue;
                for (const double side : {-1.0, 1.0}) {
                    Candidate& candidate = places_[i].all.emplace_back();
                    const Spot off = side * across;
                    candidate.box =
                        box_at(i, request.anchor + (at * slide) * along + (request.clearance + extra + reach_across) * off, axis);
                    candidate.price = 1.5 * extra + 2.0 * std::abs(at);
                    if (dot(off, outward) < 0) candidate.price += 0.8;                                 // the outer side
                    if (off.y > 0.3 || (std::abs(off.y) <= 0.3 && off.x < 0)) candidate.price += 0.3;  // above, right
                    finish(i, candidate);
                }
            }
    }

    void propose_around(std::size_t i, double penalty, double half_line, bool far) {
        static const std::vector<Spot> round = directions(24);
        static constexpr std::array near_rings{0.0, 0.5, 1.1, 2.0, 3.2}, far_rings{6.0, 9.0, 13.0, 18.0, 24.0};
        for (const double extra : far ? far_rings : near_rings)
            for (std::size_t k = 0; k < round.size(); ++k) {
                const bool leader = extra > 3.5 || (requests_[i].balloon > 0 && extra > 1.5);
                if (leader && k % 2 != 0) continue;
                if (half_line > 0 && !leader && extra > 2.5) continue;
                Candidate& candidate = places_[i].all.emplace_back();
                stand_around(i, round[k], extra, leader, candidate);
                candidate.price += penalty + (k % 6 == 0 ? 0 : 0.05);
                finish(i, candidate);
            }
    }

    static std::vector<Spot> directions(int count) {
        std::vector<Spot> round;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            round.push_back({std::cos(angle), -std::sin(angle)});
        }
        return round;
    }

    void draw_leader(std::size_t i, Candidate& candidate) const {
        const LabelRequest& request = requests_[i];
        const InkBox& box = candidate.box;
        const Spot at = request.anchor - box.centre;
        const Spot foot = box.centre + Spot{std::clamp(at.x, -box.half.x, box.half.x), std::clamp(at.y, -box.half.y, box.half.y)};
        const Spot back = unit(foot - request.anchor);
        candidate.leader = true;
        // To a link's number the leader begins on the link itself.
        const bool on_it = request.toward && !request.along;
        candidate.leader_from = request.anchor + (on_it ? 0 : std::max(0.6, request.clearance - 0.9)) * back;
        candidate.leader_to = foot - 0.5 * back;
        candidate.thread = {0.5 * (candidate.leader_from + candidate.leader_to),
                            {length(candidate.leader_to - candidate.leader_from) / 2, 0.1},
                            back};
    }

    /// A place in the direction u from the anchor, `extra` mm further than the nearest.
    void stand_around(std::size_t i, Spot u, double extra, bool leader, Candidate& candidate) const {
        const LabelRequest& request = requests_[i];
        InkBox box = box_at(i, {}, {1, 0});
        box.centre = request.anchor + centre_distance(box, u, request.clearance + extra) * u;
        candidate.box = box;
        // Upper right is read first, then upper left, right, below.
        candidate.price = far_price * extra + 0.45 * (1 - (u.x - u.y) * std::numbers::sqrt2 / 2);
        if (leader) {
            draw_leader(i, candidate);
            candidate.price += leader_price;
        }
    }

    /// How far along u the box's centre is when its nearest ink is `distance` from the origin.
    static double centre_distance(const InkBox& box, Spot u, double distance) {
        const Spot v{std::abs(u.x), std::abs(u.y)}, h = box.half;
        if (const double t = (distance + h.x) / std::max(v.x, 1e-12); t * v.y <= h.y) return t;
        if (const double t = (distance + h.y) / std::max(v.y, 1e-12); t * v.x <= h.x) return t;
        // Past both sides: the corner is nearest.
        const double b = dot(v, h), c = dot(h, h) - distance * distance;
        return b + std::sqrt(std::max(0.0, b * b - c));
    }

    /// How far a box stands out of the figure's, to the left or right and above or below.
    Spot outside(const Box& extent) const {
        return {std::max({0.0, box_.min.x - extent.min.x, extent.max.x - box_.max.x}),
                std::max({0.0, box_.min.y - extent.min.y, extent.max.y - box_.max.y})};
    }
    /// Half of what two labels keep between them, and a little for turned ones.
    static void close_extent(Candidate& candidate) { close_extent(candidate, extent_of(candidate.box)); }
    static void close_extent(Candidate& candidate, const Box& of_box) {
        candidate.extent = of_box;
        if (candidate.leader) {
            enlarge(candidate.extent, candidate.leader_from);
            enlarge(candidate.extent, candidate.leader_to);
        }
        candidate.extent.min = candidate.extent.min - Spot{1.2, 1.2};
        candidate.extent.max = candidate.extent.max + Spot{1.2, 1.2};
    }

    /// Prices a place as far as its own position goes.
    void finish(std::size_t i, Candidate& candidate) {
        const Box of_box = extent_of(candidate.box);
        const Spot out = outside(of_box);
        candidate.price += 0.06 * (out.x + out.y);
        // Out of the room means that the whole drawing must shrink: dearer than a leader, cheaper than covering a stroke.
        if (out.x > spare_.x || out.y > spare_.y) {
            candidate.price += strict_ ? covers_label : leaves_room;
            candidate.covered = strict_;
        }
        candidate.free = ground_.is_free(candidate.box);
        candidate.covered = candidate.covered || !candidate.free;
        close_extent(candidate, of_box);
        enlarge(places_[i].span, candidate.extent);
    }
    /// Adds what the marks about a place cost, and the objects that it might seem to name.
    void look_about(std::size_t i, Candidate& candidate) const {
        candidate.price += ground_.price(candidate.box, candidate.free);
        if (!candidate.free) return;
        candidate.price += near_others(i, candidate);
        if (candidate.leader) candidate.price += crossing_price * ground_.crossed(candidate.leader_from, candidate.leader_to);
    }

    bool fits(Spot room) const {
        Box all = box_;
        for (const Candidate& candidate : chosen_) enlarge(all, extent_of(candidate.box));
        return all.width() <= room.x && all.height() <= room.y;
    }

    bool leaves_the_room(const Candidate& candidate) const {
        constexpr double grace = 0.01;
        const Spot out = outside(extent_of(candidate.box));
        return out.x > spare_.x + grace || out.y > spare_.y + grace;
    }
    /// Whether ink meets ink.
    static bool meet(const Candidate& a, const Candidate& b) {
        constexpr double apart_enough = 0.15;
        return gap_between(a.box, b.box, apart_enough) < apart_enough ||
               (a.leader && gap_between(a.thread, b.box, apart_enough) < apart_enough) ||
               (b.leader && gap_between(b.thread, a.box, apart_enough) < apart_enough);
    }
    /// Whether the label covers something, or its leader another label, or where it may not stand.
    bool in_the_way(std::size_t i) const {
        if (chosen_[i].covered || (chosen_[i].leader && ground_.covers_text(chosen_[i].thread))) return true;
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && clash(chosen_[i], chosen_[j])) return true;
        return false;
    }

    /// Nothing may stay covered: far away there is room, in the figure or at its edge. Labels that keep a leader from getting
    /// there are moved next.
    void repair(const std::vector<std::pair<int, std::size_t>>& order) {
        std::vector<std::size_t> waiting;
        for (const auto& [free, i] : order)
            if (in_the_way(i)) waiting.push_back(i);
        if (waiting.empty()) return;
        take_all();
        std::size_t moves_left = 2 * requests_.size();
        for (std::size_t next = 0; next < waiting.size() && moves_left > 0; ++next) {
            const std::size_t i = waiting[next];
            if (!in_the_way(i)) continue;
            give_back(i);
            const auto place = nearest_free(i);
            if (place) chosen_[i] = *place;
            take(i);
            if (!place) continue;
            --moves_left;
            for (std::size_t j = 0; j < requests_.size(); ++j)
                if (j != i && clash(chosen_[i], chosen_[j])) waiting.push_back(j);
        }
    }

    std::optional<Candidate> nearest_free(std::size_t i) {
        const Spot half = box_at(i, {}, {1, 0}).half;
        const Spot edge = reach();
        if (const auto found = nearest_free(i, {box_.min - edge + half, box_.max + edge - half})) return found;
        if (strict_) return std::nullopt;
        constexpr double beyond = 4;
        const Spot further = 2.0 * half + Spot{beyond, beyond};
        return nearest_free(i, {box_.min - further, box_.max + further});
    }
    /// How far a label that finds no place may go out of the figure's box.
    Spot reach() const { return {std::min(spare_.x, farthest), std::min(spare_.y, farthest)}; }

    /// The maps of what labels and leaders take, without one label while its place is looked for.
    void take_all() {
        Spot most = reach();
        for (std::size_t i = 0; i < requests_.size(); ++i) {
            const Spot half = box_at(i, {}, {1, 0}).half;
            most = {std::max(most.x, 3 * half.x + 5), std::max(most.y, 3 * half.y + 5)};
        }
        taken_.emplace(Box{box_.min - most, box_.max + most});
        threads_ = taken_;
        for (std::size_t i = 0; i < requests_.size(); ++i) take(i);
    }
    void take(std::size_t i) {
        taken_->fill(chosen_[i].box.grown(label_gap));
        if (chosen_[i].leader) threads_->stroke(chosen_[i].leader_from, chosen_[i].leader_to, ink_margin);
    }
    void give_back(std::size_t i) {
        const Box& hole = chosen_[i].extent;
        taken_->clear(hole);
        threads_->clear(hole);
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && !apart(chosen_[j].extent, hole)) take(j);
    }

    /// The nearest place with its middle in a box that covers no stroke and no label; of those about as near the one whose leader
    /// crosses least.
    std::optional<Candidate> nearest_free(std::size_t i, const Box& middles) {
        constexpr double unruly_price = 12;
        const double step = looks_left_ > 0 ? 1 : 2;
        const LabelRequest& request = requests_[i];
        InkBox box = box_at(i, {}, {1, 0});
        const InkMap &labels = *taken_, &leaders = *threads_;
        std::optional<Candidate> found;
        const auto look_at = [&](Spot centre) {
            box.centre = centre;
            const double extra = distance_to_box(request.anchor, box) - request.clearance;
            const double least = leader_price + far_price * extra;
            if (extra < step || extra > longest_leader || (found && least >= found->price)) return;
            --looks_left_;
            if (labels.touches(box) || leaders.touches(box) || !ground_.is_free(box)) return;
            Candidate candidate;
            candidate.box = box;
            candidate.price = least;
            draw_leader(i, candidate);
            if (labels.touches(candidate.thread) || ground_.covers_text(candidate.thread)) return;
            // Counted until it is no better than what was found.
            double met = 0;
            const auto count = [&](double price, const auto& crossings) {
                const double left = found ? (found->price - least - met) / price : 1e6;
                if (left > 0) met += price * crossings(static_cast<int>(std::min(left, 1e6)) + 1);
            };
            const Spot from = candidate.leader_from, to = candidate.leader_to;
            count(unruly_price, [&](int most) { return leaders.crossings(from, to, most); });
            count(crossing_price, [&](int most) { return ground_.crossed(from, to, most); });
            candidate.price += met;
            if (!found || candidate.price < found->price) found = candidate;
        };
        // Square rings about the anchor, as far as a better place may be.
        const Spot at = request.anchor;
        const auto last = static_cast<int>(
            std::max({at.x - middles.min.x, middles.max.x - at.x, at.y - middles.min.y, middles.max.y - at.y}) / step);
        for (int ring = 1; ring <= last; ++ring) {
            const double away = ring * step;
            if (found && looks_left_ <= 0) break;
            if (found && leader_price + far_price * (away - std::max(box.half.x, box.half.y) - request.clearance) >= found->price)
                break;
            const auto row = [&](double y) {
                if (y < middles.min.y || y > middles.max.y) return;
                for (double x = std::max(at.x - away, middles.min.x); x <= std::min(at.x + away, middles.max.x); x += step)
                    look_at({x, y});
            };
            const auto column = [&](double x) {
                if (x < middles.min.x || x > middles.max.x) return;
                for (double y = std::max(at.y - away + step, middles.min.y); y < std::min(at.y + away, middles.max.y); y += step)
                    look_at({x, y});
            };
            row(at.y - away);
            row(at.y + away);
            column(at.x + away);
            column(at.x - away);
        }
        if (found) close_extent(*found);
        return found;
    }

    /// A name must not seem to belong to a neighbour.
    double near_others(std::size_t i, const Candidate& candidate) const {
        double price = 0;
        const Spot reach = candidate.box.reach(), centre = candidate.box.centre;
        const double own = distance_to_box(requests_[i].anchor, candidate.box);
        if (!requests_[i].toward)
            for (std::size_t j = 0; j < requests_.size(); ++j) {
                if (j == i || requests_[j].toward) continue;
                const Spot d = requests_[j].anchor - centre;
                if (std::abs(d.x) > reach.x + own + 1 || std::abs(d.y) > reach.y + own + 1) continue;
                const double other = distance_to_box(requests_[j].anchor, candidate.box);
                if (other < own + 1.0) price += 4 * (own + 1.0 - other);
            }
        // … nor a vector's name to the vector beside it.
        if (requests_[i].toward && !requests_[i].along) {
            const double to_own = distance_to_line(requests_[i], centre);
            for (std::size_t j = 0; j < requests_.size(); ++j) {
                if (j == i || !requests_[j].toward || requests_[j].along || requests_[j].balloon > 0) continue;
                const double near = to_own + 0.8;
                if (is_beyond(requests_[j], centre, near)) continue;
                const double other = distance_to_line(requests_[j], centre);
                if (other < near) price += 2.5 * std::min(2.0, near - other);
            }
        }
        return price;
    }

    /// Whether the box round the line that a request's label names tells that the line is farther away.
    static bool is_beyond(const LabelRequest& request, Spot spot, double distance) {
        const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
        return std::abs(d.x) > std::abs(half.x) + distance || std::abs(d.y) > std::abs(half.y) + distance;
    }
    /// From the line that a request's label names (its anchor in the middle).
    static double distance_to_line(const LabelRequest& request, Spot spot) {
        const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
        const double t = std::clamp(dot(d, half) / std::max(dot(half, half), 1e-12), -1.0, 1.0);
        return length(d - t * half);
    }

    /// The labels that some place of label i may meet.
    void look_around(std::size_t i) {
        around_.clear();
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && !apart(chosen_[j].extent, places_[i].span)) around_.push_back(j);
    }

    double price_now(std::size_t i) const {
        double price = chosen_[i].price;
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && !apart(chosen_[j].extent, chosen_[i].extent)) price += price_between(chosen_[i], chosen_[j]);
        return price;
    }

    static bool clash(const Candidate& a, const Candidate& b) {
        return !apart(a.extent, b.extent) && price_between(a, b) >= covers_stroke;
    }

    static double price_between(const Candidate& a, const Candidate& b) {
        constexpr double near = 1.6;
        double price = 0;
        const double gap = gap_between(a.box, b.box, near);
        if (gap < label_gap)
            price += covers_label + 50 * (label_gap - gap);
        else if (gap < near)
            price += 0.8;
        if (a.leader && gap_between(a.thread, b.box, ink_margin) < ink_margin) price += covers_stroke;
        if (b.leader && gap_between(b.thread, a.box, ink_margin) < ink_margin) price += covers_stroke;
        if (a.leader && b.leader && gap_between(a.thread, b.thread, 0.3) < 0.3) price += 20;
        return price;
    }

    /// The cheapest place that costs less than `least`, other labels standing where they do.
    std::optional<Candidate> best(std::size_t i, double least = infinity) {
        std::optional<std::size_t> found;
        const auto look_at = [&](Places::Kind& kind, bool free) {
            rank(places_[i], kind, free);
            for (std::size_t rank = 0; kind.least(rank) < least; ++rank) {
                const std::size_t place = next_of(i, kind, rank);
                const Candidate& candidate = places_[i].all[place];
                double price = candidate.price;
                for (std::size_t n = 0; n < around_.size() && price < least; ++n)
                    if (const Candidate& other = chosen_[around_[n]]; !apart(other.extent, candidate.extent))
                        price += price_between(candidate, other);
                if (price < least) least = price, found = place;
            }
        };
        look_around(i);
        for (std::size_t k = 0;;) {
            for (; k < places_[i].free.size(); ++k) look_at(places_[i].free[k], true);
            if (!propose_more(i, least)) break;
            look_around(i);
        }
        // What covers ink costs more than all that makes less wanted places worth a thought.
        static_assert(covers_stroke > std::max({beside_price, upright_price, least_of_far}));
        if (least > covers_stroke)
            for (Places::Kind& kind : places_[i].covering) look_at(kind, false);
        if (!found) return std::nullopt;
        return places_[i].all[*found];
    }

    /// A place that would cost less if one other label were not there.
    struct Wish {
        std::size_t other;
        std::size_t place;
        double price;
    };
    /// For each label that keeps label i from a cheaper place than its own (which costs `now`), the cheapest of these.
    void wishes_of(std::size_t i, double now) {
        wishes_.clear();
        look_around(i);
        const auto wish = [&](Places::Kind& kind, bool free) {
            rank(places_[i], kind, free);
            for (std::size_t met = 0; kind.least(met) < now; ++met) wish_for(i, next_of(i, kind, met), now);
        };
        for (Places::Kind& kind : places_[i].free) wish(kind, true);
        if (now > covers_stroke)
            for (Places::Kind& kind : places_[i].covering) wish(kind, false);
        constexpr std::size_t most = 6;
        std::sort(wishes_.begin(), wishes_.end(),
                  [](const Wish& a, const Wish& b) { return a.price < b.price || (a.price == b.price && a.other < b.other); });
        if (wishes_.size() > most) wishes_.resize(most);
    }
    void wish_for(std::size_t i, std::size_t place, double now) {
        const Candidate& candidate = places_[i].all[place];
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
        for (const auto& met : met_) {
            const std::size_t j = met.first;
            const double without = sum - met.second;
            if (without >= now) continue;
            const auto there = std::find_if(wishes_.begin(), wishes_.end(), [&](const Wish& w) { return w.other == j; });
            if (there == wishes_.end())
                wishes_.push_back({j, place, without});
            else if (without < there->price)
                *there = {j, place, without};
        }
    }

    /// Takes a better place from another label where that one can move at less cost.
    bool evict(std::size_t i, int& looks_left) {
        const double now = price_now(i);
        if (now < leader_price || looks_left <= 0) return false;
        wishes_of(i, now);
        for (const Wish& wish : wishes_) {
            if (--looks_left < 0) return false;
            const std::size_t j = wish.other;
            const Candidate before = chosen_[i];
            double both = now + price_now(j);
            if (!apart(before.extent, chosen_[j].extent)) both -= price_between(before, chosen_[j]);
            chosen_[i] = places_[i].all[wish.place];
            if (const auto place = best(j, both - wish.price - least_gain)) {
                chosen_[j] = *place;
                return true;
            }
            chosen_[i] = before;
        }
        return false;
    }

    const std::vector<LabelRequest>& requests_;
    const Ground& ground_;
    Box box_;
    bool strict_;
    Spot spare_{1e9, 1e9};  // how far a label may stand out of the box on each side
    std::vector<ShapedLine> shaped_;
    std::vector<double> overhang_;  // of their ink
    std::vector<Spot> halves_;      // of the boxes that they take
    std::vector<Places> places_;
    std::vector<Candidate> chosen_;
    std::optional<InkMap> taken_, threads_;  // what labels take, and their leaders
    int looks_left_ = most_looks;
    // Of one look at one label, kept for their memory.
    std::vector<std::size_t> around_;
    std::vector<std::pair<std::size_t, double>> met_;
    std::vector<Wish> wishes_;
};

}  // namespace

double room_of_names(const Figure& figure, const Fonts& fonts) {
    constexpr double air = 2 * label_gap;
    double sum = 0;
    for (std::size_t i = 0; i < std::min(figure.labels.size(), most_names); ++i) {
        const LabelRequest& request = figure.labels[i];
        const ShapedLine shaped = fonts.shape(request.text, request.size);
        sum += (shaped.width + air) * (shaped.ascent + shaped.descent + air);
    }
    return sum;
}

namespace {

/// Whether all groups of a figure are within its own, which is closed.
bool is_closed(const Figure& figure) {
    const auto begun = std::count_if(figure.marks.begin(), figure.marks.end(),
                                     [](const Mark& mark) { return std::holds_alternative<GroupBegin>(mark); });
    const auto ended = std::count_if(figure.marks.begin(), figure.marks.end(),
                                     [](const Mark& mark) { return std::holds_alternative<GroupEnd>(mark); });
    return figure.marks.size() >= 2 && std::holds_alternative<GroupBegin>(figure.marks.front()) &&
           std::holds_alternative<GroupEnd>(figure.marks.back()) && begun == ended;
}

constexpr double leader_dot = 0.38;  // its radius, mm

/// It runs onto a line that it names, and as far as the symbol of a point.
void draw_leader(std::vector<Mark>& marks, const Candidate& place, Colour colour) {
    const Spot from = place.leader_from;
    marks.emplace_back(line(from, place.leader_to, {0.18, colour, {}, false}));
    marks.emplace_back(disc(from, leader_dot, colour));
}

void set_label(Figure& figure, const LabelRequest& request, const Candidate& place, ShapedLine shaped, Colour leaders) {
    const std::size_t own = figure.marks.size();
    if (!request.id.empty()) figure.marks.emplace_back(GroupBegin{"", request.id, "", {}});
    if (place.leader) draw_leader(figure.marks, place, leaders), ++figure.leaders;
    const Spot centre = place.box.centre;
    if (request.balloon > 0) {
        const double round = 2 * std::numbers::pi * request.balloon;
        figure.marks.emplace_back(
            circle(centre, request.balloon, {0.35, request.colour, going_round(request.dashes, round), false}));
    }
    const std::size_t first = figure.marks.size();
    const Spot origin{centre.x - shaped.width / 2, centre.y + (shaped.ascent - shaped.descent) / 2};
    set_text(figure.marks, std::move(shaped), origin, request.colour, "label");
    for (std::size_t k = first; k < figure.marks.size(); ++k) {
        auto& text = std::get<TextMark>(figure.marks[k]);
        text.pivot = centre;
        text.angle = std::atan2(place.box.axis.y, place.box.axis.x);
        text.names = request.names;
        text.holds = request.holds;
        if (k > first) text.cls = "text";  // one label, one aria-label
    }
    if (!request.id.empty()) figure.marks.emplace_back(GroupEnd{});
    belong(figure.marks, own, request.statement);
    const Spot reach = place.box.reach();
    figure.box.min = {std::min(figure.box.min.x, centre.x - reach.x), std::min(figure.box.min.y, centre.y - reach.y)};
    figure.box.max = {std::max(figure.box.max.x, centre.x + reach.x), std::max(figure.box.max.y, centre.y + reach.y)};
}

void set_key(Figure& figure, const LabelKey& key, double measure) {
    const Spot at{figure.box.min.x, figure.box.max.y + above_key};
    const LabelKey::Lines lines = key.lines(at, measure);
    figure.marks.insert(figure.marks.end(), lines.marks.begin(), lines.marks.end());
    figure.box.max = {std::max(figure.box.max.x, at.x + lines.width), at.y + lines.height};
    figure.has_key = true;
}

}  // namespace

void drop_leader(std::vector<Mark>& marks, Colour leaders) {
    if (marks.size() < 2) return;
    const auto* dot = std::get_if<Path>(&marks.back());
    const auto* stroke = std::get_if<Path>(&marks[marks.size() - 2]);
    if (!dot || !dot->filled || dot->stroked || dot->fill != leaders) return;
    if (!stroke || !stroke->stroked || stroke->segments.size() != 2 || stroke->pen.colour != leaders) return;
    marks.resize(marks.size() - 2);
}

bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling) {
    return place_labels(figure, fonts, room, labelling, Theme{}.secondary);
}
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling, Colour leaders) {
    if (figure.labels.empty()) return true;
    const Ground ground(figure.marks, fonts);
    const bool boxed = figure.box.width() > 0 && figure.box.height() > 0;
    if (!boxed) figure.box = box_of(figure.marks);
    const double measure = std::max(figure.box.width(), room ? std::min(room->x, wide_key) : wide_key);
    const std::size_t names = std::min(figure.labels.size(), most_names);
    std::vector<LabelRequest> requests(figure.labels.begin(), figure.labels.begin() + static_cast<std::ptrdiff_t>(names));
    LabelKey key(fonts);
    std::optional<Placing> placing;
    // With labels gone others may find a place; a number that finds none is no longer tried.
    for (;;) {
        std::optional<Spot> left = room;
        if (left && !key.empty()) left->y = std::max(left->y - above_key - key.lines({}, measure).height, figure.box.height());
        placing.emplace(requests, figure.box, fonts, ground, left, labelling == Labelling::strict);
        if (!placing->place(labelling == Labelling::if_it_fits ? left : std::nullopt)) return false;
        if (labelling == Labelling::if_all_free && placing->is_crowded()) return false;
        const std::vector<std::size_t> placeless = placing->placeless();
        if (placeless.empty()) break;
        key.take(requests, placeless);
    }
    // Into the figure's group, where that is closed already.
    const bool closed = is_closed(figure);
    if (closed) figure.marks.pop_back();
    for (std::size_t i = 0; i < requests.size(); ++i)
        set_label(figure, requests[i], placing->chosen(i), placing->take_shaped(i), leaders);
    if (!key.empty()) set_key(figure, key, measure);
    if (closed) figure.marks.emplace_back(GroupEnd{});
    for (std::size_t i = names; i < figure.labels.size(); ++i) figure.unnamed.push_back(std::move(figure.labels[i].text));
    figure.labels.clear();
    return true;
}

}  // namespace kinegraph::render
