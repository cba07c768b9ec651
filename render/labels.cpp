// Labels: finds every label of a figure a place beside its object where it covers no stroke, no arrowhead and no other label.
// Owns the candidates, their price and the search; knows no mechanics, only marks. Deterministic: all orders are those of the
// figure, all ties go to the first.
//
// Method: point-feature labelling by candidate places on rings about the anchor (after Imhof's rules), least free first, then
// rounds of improvement with evictions; obstacles lie in a uniform grid.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "render/figure.hpp"
#include "render/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double ink_margin = 0.45;    // clear paper round every letter, mm
constexpr double label_gap = 0.8;      // between two labels
constexpr double breathing = 1.3;      // a stroke nearer than this makes a place less wanted
constexpr double cell = 4.0;           // of the grid
constexpr double covers_stroke = 100;  // the price that no wish outweighs
constexpr double covers_label = 400;
constexpr double beside_price = 2.5;  // of a vector's name beyond its ends
constexpr double upright_price = 8;   // of a direction mark that leaves its line
constexpr double leaves_room = 30;
constexpr double leader_price = 6;
constexpr double least_measure = 45;  // of a label, before it is shortened
constexpr double least_of_far = 11;   // leader and distance: no far place costs less

/// A piece of stroke: everything within `half` of the segment is ink.
struct Obstacle {
    Spot from, to;
    double half = 0;
};
/// A tinted area: a label may stand in it, but rather not.
struct Area {
    std::vector<Spot> corners;
    Box box;
    bool forbidden = false;
};

/// A turned box: `half` extents along `axis` and its normal.
struct InkBox {
    Spot centre, half, axis{1, 0};
    Spot local(Spot spot) const {
        const Spot d = spot - centre;
        return {dot(d, axis), cross(axis, d)};
    }
    Spot reach() const {
        return {std::abs(axis.x) * half.x + std::abs(axis.y) * half.y, std::abs(axis.y) * half.x + std::abs(axis.x) * half.y};
    }
};

double squared(Spot a) { return dot(a, a); }

/// Length of the part of a segment inside a box of half extents `half` about the origin; negative where they do not meet.
double length_inside(Spot from, Spot to, Spot half) {
    const Spot d = to - from;
    double enter = 0, leave = 1;
    const auto clip = [&](double start, double step, double limit) {
        if (step == 0) return std::abs(start) <= limit;
        double low = (-limit - start) / step, high = (limit - start) / step;
        if (low > high) std::swap(low, high);
        enter = std::max(enter, low);
        leave = std::min(leave, high);
        return enter <= leave;
    };
    if (!clip(from.x, d.x, half.x) || !clip(from.y, d.y, half.y)) return -1;
    return (leave - enter) * length(d);
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

/// All that is drawn already, pieces of stroke sorted into square cells.
class Ground {
public:
    Ground(const std::vector<Mark>& marks, const Fonts& fonts) {
        for (const Mark& mark : marks) {
            if (const auto* path = std::get_if<Path>(&mark)) add(*path);
            if (const auto* axis = std::get_if<Axis>(&mark)) add_segment(axis->tail, axis->tip, 0.35);
            if (const auto* text = std::get_if<TextMark>(&mark)) add(*text, fonts);
        }
        sort_into_cells();
    }

    struct Finding {
        double price = 0;
        bool covered = false;
        bool whole = true;  // false: the price is more than was asked for, all else was not looked at
    };
    /// What a label there would cover, up to a price that is `enough`. Ink within the margin is forbidden, ink within breathing
    /// distance is a pity.
    Finding at(const InkBox& box, Spot anchor, double enough) const {
        Finding finding;
        for (const InkBox& text : texts_)
            if (gap_between(text, box, label_gap) < label_gap) {
                finding.covered = true;
                finding.price += covers_label;
            }
        for (const Area& area : areas_)
            if (inside(area, box.centre)) {
                finding.price += area.forbidden ? covers_stroke : 2.0;
                finding.covered = finding.covered || area.forbidden;
            }
        int crowded = 0;
        visit(box.centre, box.reach(), [&](const Obstacle& obstacle) {
            if (finding.price >= enough) finding.whole = false;
            if (!finding.whole) return false;
            const Spot from = box.local(obstacle.from), to = box.local(obstacle.to);
            const double near = obstacle.half + ink_margin, far = obstacle.half + breathing;
            if (length_inside(from, to, {box.half.x + far, box.half.y + far}) < 0) return true;
            const double covered = length_inside(from, to, {box.half.x + near, box.half.y + near});
            if (covered >= 0) {
                finding.covered = true;
                finding.price += covers_stroke * (0.5 + obstacle.half) + 10 * covered;
            } else if (squared(obstacle.from - anchor) > 0.01 && squared(obstacle.to - anchor) > 0.01) {
                ++crowded;  // … but a pin does not crowd its own name
            }
            return true;
        });
        finding.price += 0.7 * std::min(crowded, 4);
        return finding;
    }

    /// Strokes that a leader would cross, counted up to `enough`.
    int crossed(Spot from, Spot to, double enough) const {
        int count = 0;
        const Spot middle = 0.5 * (from + to), along = unit(to - from);
        const InkBox thread{middle, {length(to - from) / 2, 0.1}, along};
        visit(middle, thread.reach(), [&](const Obstacle& obstacle) {
            if (length_inside(thread.local(obstacle.from), thread.local(obstacle.to),
                              {thread.half.x, thread.half.y + obstacle.half}) >= 0)
                ++count;
            return count < enough;
        });
        for (const InkBox& text : texts_)
            if (gap_between(text, thread, 0.3) < 0.3) count += 20;
        return count;
    }

private:
    void add_segment(Spot from, Spot to, double half) {
        // Cut to the size of a cell, so that a long diagonal fills only the cells it passes.
        const int pieces = std::max(1, static_cast<int>(std::ceil(length(to - from) / cell)));
        for (int i = 0; i < pieces; ++i)
            obstacles_.push_back({from + (static_cast<double>(i) / pieces) * (to - from),
                                  from + (static_cast<double>(i + 1) / pieces) * (to - from), half});
    }

    void add(const Path& path) {
        const double half = path.stroked ? path.pen.width / 2 : 0;
        // Pins, dots and balloons: one disc.
        if (path.filled && path.segments.size() == 3)
            if (const auto* arc = std::get_if<ArcTo>(&path.segments[1]); arc && arc->radius <= 3) {
                obstacles_.push_back({arc->centre, arc->centre, arc->radius + half});
                return;
            }
        std::vector<Spot> outline;
        Spot pen, start;
        const auto stroke_to = [&](Spot to) {
            add_segment(pen, to, half);
            outline.push_back(to);
            pen = to;
        };
        for (const Segment& segment : path.segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                pen = start = m->to;
                outline.push_back(pen);
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                stroke_to(l->to);
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                const Spot p0 = pen;
                for (int i = 1; i <= 8; ++i) {
                    const double t = i / 8.0, u = 1 - t;
                    stroke_to((u * u * u) * p0 + (3 * u * u * t) * c->control_1 + (3 * u * t * t) * c->control_2 +
                              (t * t * t) * c->to);
                }
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                const double sweep = a->to - a->from;
                const double step = std::clamp(2 * std::acos(std::max(0.0, 1 - 0.05 / std::max(a->radius, 0.06))), 0.05, 0.8);
                const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
                for (int i = 0; i <= parts; ++i) {
                    const double angle = a->from + sweep * i / parts;
                    const Spot at = a->centre + a->radius * Spot{std::cos(angle), std::sin(angle)};
                    if (i == 0 && outline.empty()) pen = start = at;
                    stroke_to(at);
                }
            } else {
                stroke_to(start);
            }
        }
        if (!path.filled || outline.size() < 3) return;
        Area area{std::move(outline), {{1e300, 1e300}, {-1e300, -1e300}}, false};
        for (const Spot& spot : area.corners) {
            area.box.min = {std::min(area.box.min.x, spot.x), std::min(area.box.min.y, spot.y)};
            area.box.max = {std::max(area.box.max.x, spot.x), std::max(area.box.max.y, spot.y)};
        }
        const int light = std::min({path.fill.red, path.fill.green, path.fill.blue});
        area.forbidden = light < 0xC0;
        areas_.push_back(std::move(area));
    }

    void add(const TextMark& text, const Fonts& fonts) {
        Box box{{1e300, 1e300}, {-1e300, -1e300}};
        for (const Glyph& glyph : text.glyphs)
            for (const Segment& segment : fonts.outline(glyph.face, glyph.index).segments) {
                std::array<Spot, 3> spots{};
                int count = 0;
                if (const auto* m = std::get_if<MoveTo>(&segment)) spots[0] = m->to, count = 1;
                if (const auto* l = std::get_if<LineTo>(&segment)) spots[0] = l->to, count = 1;
                if (const auto* c = std::get_if<CurveTo>(&segment)) spots = {c->control_1, c->control_2, c->to}, count = 3;
                for (int i = 0; i < count; ++i) {
                    const Spot s = spots[static_cast<std::size_t>(i)];
                    const Spot at{glyph.origin.x + glyph.size * s.x, glyph.origin.y - glyph.size * s.y};
                    box.min = {std::min(box.min.x, at.x), std::min(box.min.y, at.y)};
                    box.max = {std::max(box.max.x, at.x), std::max(box.max.y, at.y)};
                }
            }
        if (box.min.x > box.max.x) return;
        InkBox ink{0.5 * (box.min + box.max), 0.5 * (box.max - box.min), {1, 0}};
        const double c = std::cos(text.angle), s = std::sin(text.angle);
        const Spot arm = ink.centre - text.pivot;
        ink.centre = text.pivot + Spot{arm.x * c - arm.y * s, arm.x * s + arm.y * c};
        ink.axis = {c, s};
        texts_.push_back(ink);
    }

    void sort_into_cells() {
        if (obstacles_.empty()) return;
        Box box{{1e300, 1e300}, {-1e300, -1e300}};
        for (const Obstacle& o : obstacles_)
            for (const Spot s : {o.from, o.to}) {
                box.min = {std::min(box.min.x, s.x), std::min(box.min.y, s.y)};
                box.max = {std::max(box.max.x, s.x), std::max(box.max.y, s.y)};
            }
        // Each piece is entered once, by its middle; a look at a box reaches half a piece and half the widest stroke further.
        origin_ = box.min;
        columns_ = static_cast<int>(box.width() / cell) + 1;
        rows_ = static_cast<int>(box.height() / cell) + 1;
        starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
        for (const Obstacle& o : obstacles_) ++starts_[cell_of(0.5 * (o.from + o.to)) + 1];
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        std::vector<Obstacle> sorted(obstacles_.size());
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        for (const Obstacle& o : obstacles_) {
            sorted[next[cell_of(0.5 * (o.from + o.to))]++] = o;
            reach_ = std::max(reach_, o.half);
        }
        obstacles_ = std::move(sorted);
        reach_ += breathing + cell / 2;
    }
    int column_of(double x) const { return std::clamp(static_cast<int>(std::floor((x - origin_.x) / cell)), 0, columns_ - 1); }
    int row_of(double y) const { return std::clamp(static_cast<int>(std::floor((y - origin_.y) / cell)), 0, rows_ - 1); }
    std::size_t cell_of(Spot spot) const {
        return static_cast<std::size_t>(row_of(spot.y)) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column_of(spot.x));
    }

    template <class Look>
    void visit(Spot centre, Spot reach, Look look) const {
        if (obstacles_.empty()) return;
        const Spot half{reach.x + reach_, reach.y + reach_};
        const int left = column_of(centre.x - half.x), right = column_of(centre.x + half.x);
        for (int row = row_of(centre.y - half.y), last = row_of(centre.y + half.y); row <= last; ++row) {
            const std::size_t base = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
            // Cells of a row lie one behind the other.
            const std::size_t end = starts_[base + static_cast<std::size_t>(right) + 1];
            for (std::size_t i = starts_[base + static_cast<std::size_t>(left)]; i < end; ++i) {
                const Obstacle& o = obstacles_[i];
                const double margin = o.half + breathing;
                if (std::abs(0.5 * (o.from.x + o.to.x) - centre.x) > reach.x + margin + 0.5 * std::abs(o.to.x - o.from.x))
                    continue;
                if (std::abs(0.5 * (o.from.y + o.to.y) - centre.y) > reach.y + margin + 0.5 * std::abs(o.to.y - o.from.y))
                    continue;
                if (!look(o)) return;
            }
        }
    }

    std::vector<Obstacle> obstacles_;
    std::vector<InkBox> texts_;
    std::vector<Area> areas_;
    std::vector<std::size_t> starts_;
    Spot origin_;
    int columns_ = 0, rows_ = 0;
    double reach_ = 0;
};

/// A place a label may take.
struct Candidate {
    InkBox box;
    double base = 0;       // the part of the price that is known at once
    double price = 0;      // what does not depend on other labels; the least it can be until it is settled
    bool settled = false;  // the ground and the neighbours have been looked at
    bool covered = false;
    bool leader = false;
    Spot leader_from, leader_to;
    InkBox thread;  // the leader's
    Box extent;     // of box and leader and what another label must keep off it
};

bool apart(const Box& a, const Box& b) {
    return a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y;
}
void enlarge(Box& box, const Box& by) {
    box.min = {std::min(box.min.x, by.min.x), std::min(box.min.y, by.min.y)};
    box.max = {std::max(box.max.x, by.max.x), std::max(box.max.y, by.max.y)};
}
Box extent_of(const InkBox& box) {
    const Spot reach = box.reach();
    return {box.centre - reach, box.centre + reach};
}
constexpr Box nowhere{{1e300, 1e300}, {-1e300, -1e300}};

/// The first `count` characters of UTF-8 text.
std::string beginning(const std::string& text, std::size_t count) {
    std::size_t at = 0;
    for (; at < text.size(); ++at)
        if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80 && count-- == 0) break;
    return text.substr(0, at);
}

/// Sets a line wider than `measure` again, ended by an ellipsis: pieces go from the end, then characters of the first. What the
/// line says stays whole.
void shorten(const LabelRequest& request, const Fonts& fonts, double measure, ShapedLine& shaped) {
    if (shaped.width <= measure || request.text.empty()) return;
    const std::string words = shaped.words;
    const auto fits = [&](RichText text) {
        text.push_back({"…", Face::regular, "", Face::italic, "", Face::regular, 0, false, {}});
        shaped = fonts.shape(text, request.size);
        shaped.words = words;
        return shaped.width <= measure;
    };
    RichText text = request.text;
    // What can stand is found by halves: names may be as long as a file lets them.
    const auto longest = [&](std::size_t low, std::size_t high, const auto& kept) {
        while (low < high) {
            const std::size_t middle = (low + high + 1) / 2;
            if (fits(kept(middle)))
                low = middle;
            else
                high = middle - 1;
        }
        return low;
    };
    const std::size_t pieces = longest(
        0, text.size() - 1, [&](std::size_t n) { return RichText(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(n)); });
    text.resize(std::max<std::size_t>(pieces, 1));
    if (pieces == 0) {
        Piece& first = text.front();
        std::string& long_one = first.sub.size() > first.text.size() ? first.sub : first.text;
        const std::string all = long_one;
        const auto cut = [&](std::size_t n) {
            long_one = beginning(all, n);
            return text;
        };
        cut(longest(1, all.size(), cut));
    }
    fits(text);
}

class Placing {
public:
    Placing(const Figure& figure, const Fonts& fonts, const Ground& ground, const std::optional<Spot>& room, bool strict)
        : requests_(figure.labels), ground_(ground), box_(figure.box), outside_price_(strict ? 3 * covers_label : leaves_room) {
        if (!(box_.width() > 0) || !(box_.height() > 0)) box_ = box_of(figure.marks);
        if (room) spare_ = {std::max(0.0, room->x - box_.width()) / 2, std::max(0.0, room->y - box_.height()) / 2};
        for (const LabelRequest& request : requests_) {
            shaped_.push_back(fonts.shape(request.text, request.size));
            if (room && request.balloon <= 0) shorten(request, fonts, std::max(0.5 * room->x, least_measure), shaped_.back());
        }
        candidates_.resize(requests_.size());
        stage_.assign(requests_.size(), 0);
        chosen_.assign(requests_.size(), -1);
        taken_.assign(requests_.size(), nowhere);
        span_.assign(requests_.size(), nowhere);
        for (std::size_t i = 0; i < requests_.size(); ++i) propose(i);
    }

    void place() {
        // The least free first; ties in the figure's order.
        std::vector<std::pair<int, std::size_t>> order;
        for (std::size_t i = 0; i < requests_.size(); ++i) {
            int free = 0;
            for (Candidate& candidate : candidates_[i]) {
                if (candidate.leader) continue;
                settle(i, candidate, candidate.base + covers_stroke / 2);
                free += candidate.settled && !candidate.covered;
            }
            order.emplace_back(free, i);
        }
        std::sort(order.begin(), order.end());
        for (const auto& [free, i] : order) choose(i, best(i));
        looks_left_ = 60 + 3 * static_cast<int>(requests_.size());
        for (int round = 0; round < 4; ++round) {
            bool changed = false;
            for (const auto& [free, i] : order) {
                const int before = chosen_[i];
                choose(i, best(i));
                changed = changed || chosen_[i] != before;
                changed = evict(i) || changed;
            }
            if (!changed) break;
        }
    }

    const ShapedLine& shaped(std::size_t i) const { return shaped_[i]; }
    const Candidate& chosen(std::size_t i) const { return candidates_[i][static_cast<std::size_t>(chosen_[i])]; }

private:
    InkBox box_at(std::size_t i, Spot centre, Spot axis) const {
        if (const double r = requests_[i].balloon; r > 0) return {centre, {r, r}, axis};
        const ShapedLine& s = shaped_[i];
        return {centre, {s.width / 2, (s.ascent + s.descent) / 2}, axis};
    }

    void propose(std::size_t i) {
        const LabelRequest& request = requests_[i];
        if (request.toward && length(*request.toward - request.anchor) > 0) {
            propose_beside_line(i, *request.toward);
        } else {
            propose_around(i, 0, 0, false);
        }
        sort_from(i, 0);
    }

    /// Less wanted places, thought of only where nothing so far costs less than they would.
    bool propose_more(std::size_t i, double least) {
        const LabelRequest& request = requests_[i];
        const bool beside = request.toward.has_value();
        const std::size_t so_far = candidates_[i].size();
        // A vector shorter than its name has room beyond its ends; a direction mark stays on its line if it can.
        const double price = request.along ? upright_price : beside_price;
        if (stage_[i] == 0) {
            if (beside && least < price) return false;
            if (beside) propose_around(i, price, request.along ? 0.0 : length(*request.toward - request.anchor), false);
            sort_from(i, so_far);
            stage_[i] = 1;
            if (beside) return true;
        }
        if (stage_[i] == 1) {
            if (least < least_of_far) return false;
            propose_around(i, beside ? price : 0.0, 0, true);
            sort_from(i, so_far);
            stage_[i] = 2;
            return true;
        }
        return false;
    }

    /// The most wanted first: where one of them is free, few others need a look.
    void sort_from(std::size_t i, std::size_t first) {
        std::stable_sort(candidates_[i].begin() + static_cast<std::ptrdiff_t>(first), candidates_[i].end(),
                         [](const Candidate& a, const Candidate& b) { return a.price < b.price; });
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
                    Candidate candidate;
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
        const LabelRequest& request = requests_[i];
        constexpr int directions = 24;
        static constexpr std::array near_rings{0.0, 0.5, 1.1, 2.0, 3.2}, far_rings{6.0, 9.0, 13.0, 18.0, 24.0};
        for (const double extra : far ? far_rings : near_rings)
            for (int k = 0; k < directions; ++k) {
                const bool leader = extra > 3.5 || (request.balloon > 0 && extra > 1.5);
                if (leader && k % 2 != 0) continue;
                if (half_line > 0 && !leader && extra > 2.5) continue;
                const double angle = 2 * std::numbers::pi * k / directions;
                const Spot u{std::cos(angle), -std::sin(angle)};
                Candidate candidate;
                InkBox box = box_at(i, {}, {1, 0});
                box.centre = request.anchor + centre_distance(box, u, request.clearance + extra) * u;
                candidate.box = box;
                // Upper right is read first, then upper left, right, below.
                candidate.price =
                    penalty + 0.9 * extra + 0.45 * (1 - std::cos(angle - std::numbers::pi / 4)) + 0.25 * (k % 6 == 0 ? 0 : 0.2);
                if (leader) {
                    candidate.leader = true;
                    const Spot at = box.local(request.anchor);
                    const Spot nearest{std::clamp(at.x, -box.half.x, box.half.x), std::clamp(at.y, -box.half.y, box.half.y)};
                    const Spot foot = box.centre + nearest;
                    const Spot back = unit(foot - request.anchor);
                    candidate.leader_from = request.anchor + std::max(0.6, request.clearance - 0.9) * back;
                    candidate.leader_to = foot - 0.5 * back;
                    candidate.price += leader_price;
                }
                finish(i, candidate);
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

    /// Adds a place with what is known of its price at once; the ground is looked at when the place has a chance.
    void finish(std::size_t i, Candidate& candidate) {
        candidate.extent = extent_of(candidate.box);
        const Box& e = candidate.extent;
        const double wide = std::max({0.0, box_.min.x - e.min.x, e.max.x - box_.max.x});
        const double high = std::max({0.0, box_.min.y - e.min.y, e.max.y - box_.max.y});
        candidate.price += 0.06 * (wide + high);
        // Out of the room means that the whole drawing must shrink: dearer than a leader, cheaper than covering a stroke.
        if (wide > spare_.x || high > spare_.y) candidate.price += outside_price_;
        if (candidate.leader) {
            const Spot thread = candidate.leader_to - candidate.leader_from;
            candidate.thread = {0.5 * (candidate.leader_from + candidate.leader_to), {length(thread) / 2, 0.1}, unit(thread)};
            enlarge(candidate.extent, extent_of(candidate.thread));
        }
        // Half of what two labels keep between them, and a little for turned ones.
        candidate.extent.min = candidate.extent.min - Spot{1.2, 1.2};
        candidate.extent.max = candidate.extent.max + Spot{1.2, 1.2};
        enlarge(span_[i], candidate.extent);
        candidate.base = candidate.price;
        candidates_[i].push_back(candidate);
    }

    /// Looks at what the place covers, whom it is near to, what its leader crosses, as long as its price is below `limit`.
    void settle(std::size_t i, Candidate& candidate, double limit) const {
        if (candidate.settled || candidate.price >= limit) return;
        double price = candidate.base + near_others(i, candidate);
        candidate.price = std::max(candidate.price, price);
        if (price >= limit) return;
        const Ground::Finding finding = ground_.at(candidate.box, requests_[i].anchor, limit - price);
        candidate.covered = finding.covered;
        price += finding.price;
        candidate.price = std::max(candidate.price, price);
        if (!finding.whole || price >= limit) {
            candidate.settled = finding.whole && !candidate.leader;
            return;
        }
        if (candidate.leader) {
            constexpr double crossing = 2.5;
            const double enough = (limit - price) / crossing;
            const int crossed = ground_.crossed(candidate.leader_from, candidate.leader_to, enough);
            price += crossing * crossed;
            candidate.price = std::max(candidate.price, price);
            if (crossed >= enough) return;
        }
        candidate.settled = true;
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
                const double other = distance_to_line(requests_[j], centre);
                if (other < to_own + 0.8) price += 2.5 * std::min(2.0, to_own + 0.8 - other);
            }
        }
        return price;
    }

    /// From the line that a request's label names (its anchor in the middle).
    static double distance_to_line(const LabelRequest& request, Spot spot) {
        const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
        const double t = std::clamp(dot(d, half) / std::max(dot(half, half), 1e-12), -1.0, 1.0);
        return length(d - t * half);
    }

    void choose(std::size_t i, int place) {
        chosen_[i] = place;
        taken_[i] = place < 0 ? nowhere : chosen(i).extent;
    }

    /// The labels that some place of label i may meet.
    void look_around(std::size_t i, int besides) {
        around_.clear();
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && static_cast<int>(j) != besides && !apart(taken_[j], span_[i])) around_.push_back(j);
    }

    double price_now(std::size_t i, int besides = -1) const {
        const Candidate& candidate = chosen(i);
        double price = candidate.price;
        for (std::size_t j = 0; j < requests_.size(); ++j)
            if (j != i && static_cast<int>(j) != besides && !apart(taken_[j], candidate.extent))
                price += price_between(candidate, chosen(j));
        return price;
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

    /// The cheapest place, other labels standing where they do. Far ones, with a leader, are looked at only where they can win.
    /// −1 where none costs less than `least`.
    int best(std::size_t i, double least = std::numeric_limits<double>::infinity()) {
        int found = -1;
        look_around(i, -1);
        for (std::size_t k = 0;; ++k) {
            if (k == candidates_[i].size()) {
                if (!propose_more(i, least)) break;
                if (k == candidates_[i].size()) break;
                look_around(i, -1);
            }
            Candidate& candidate = candidates_[i][k];
            if (candidate.price >= least) continue;
            settle(i, candidate, least);
            double price = candidate.price;
            for (std::size_t n = 0; n < around_.size() && price < least; ++n)
                if (!apart(taken_[around_[n]], candidate.extent)) price += price_between(candidate, chosen(around_[n]));
            if (price < least) {
                least = price;
                found = static_cast<int>(k);
            }
        }
        return found;
    }

    /// A place that would cost less if one other label were not there.
    struct Wish {
        std::size_t other;
        int place;
        double price;
    };
    /// For each label that keeps label i from a cheaper place than its own (which costs `now`), the cheapest of these.
    void wishes_of(std::size_t i, double now) {
        wishes_.clear();
        look_around(i, -1);
        for (std::size_t k = 0; k < candidates_[i].size(); ++k) {
            Candidate& candidate = candidates_[i][k];
            if (candidate.price >= now) continue;
            settle(i, candidate, now);
            met_.clear();
            double sum = candidate.price, most = 0;
            for (const std::size_t j : around_) {
                if (sum - most >= now) break;
                if (apart(taken_[j], candidate.extent)) continue;
                const double price = price_between(candidate, chosen(j));
                if (price <= 0) continue;
                met_.emplace_back(j, price);
                sum += price;
                most = std::max(most, price);
            }
            if (sum - most >= now) continue;
            for (const auto& met : met_) {
                const std::size_t j = met.first;
                const double without = sum - met.second;
                if (without >= now) continue;
                const auto there = std::find_if(wishes_.begin(), wishes_.end(), [&](const Wish& w) { return w.other == j; });
                if (there == wishes_.end())
                    wishes_.push_back({j, static_cast<int>(k), without});
                else if (without < there->price)
                    *there = {j, static_cast<int>(k), without};
            }
        }
        constexpr std::size_t most = 6;
        std::sort(wishes_.begin(), wishes_.end(),
                  [](const Wish& a, const Wish& b) { return a.price < b.price || (a.price == b.price && a.other < b.other); });
        if (wishes_.size() > most) wishes_.resize(most);
    }

    /// Takes a better place from another label where that one can move at less cost.
    bool evict(std::size_t i) {
        const double now = price_now(i);
        if (now < 3 || looks_left_ <= 0) return false;
        wishes_of(i, now);
        for (const Wish& wish : wishes_) {
            if (looks_left_ <= 0) return false;
            --looks_left_;
            const std::size_t j = wish.other;
            const int i_before = chosen_[i];
            const double before = now + price_now(j, static_cast<int>(i));
            choose(i, wish.place);
            if (const int place = best(j, before - wish.price - 1e-6); place >= 0) {
                choose(j, place);
                return true;
            }
            choose(i, i_before);
        }
        return false;
    }

    const std::vector<LabelRequest>& requests_;
    const Ground& ground_;
    Box box_;
    double outside_price_;
    Spot spare_{1e9, 1e9};  // how far a label may stand out of the box on each side
    std::vector<ShapedLine> shaped_;
    std::vector<std::vector<Candidate>> candidates_;
    std::vector<int> stage_;  // how many kinds of place have been proposed
    int looks_left_ = 0;      // where there is no room at all, looking on and on finds none
    std::vector<int> chosen_;
    std::vector<Box> taken_;  // what the chosen places take, by label
    std::vector<Box> span_;   // what all the places of a label take
    // Of one look at one label, kept for their memory.
    std::vector<std::size_t> around_;
    std::vector<std::pair<std::size_t, double>> met_;
    std::vector<Wish> wishes_;
};

}  // namespace

void place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, bool strict) {
    if (figure.labels.empty()) return;
    const Ground ground(figure.marks, fonts);
    Placing placing(figure, fonts, ground, room, strict);
    placing.place();

    const bool grouped = figure.marks.size() >= 2 && std::holds_alternative<GroupBegin>(figure.marks.front()) &&
                         std::holds_alternative<GroupEnd>(figure.marks.back());
    if (grouped) figure.marks.pop_back();
    const bool boxed = figure.box.width() > 0 && figure.box.height() > 0;
    if (!boxed) figure.box = box_of(figure.marks);
    for (std::size_t i = 0; i < figure.labels.size(); ++i) {
        const LabelRequest& request = figure.labels[i];
        const Candidate& place = placing.chosen(i);
        const ShapedLine& shaped = placing.shaped(i);
        if (!request.id.empty()) figure.marks.emplace_back(GroupBegin{"", request.id, "", {}});
        if (place.leader) figure.marks.emplace_back(line(place.leader_from, place.leader_to, {0.18, request.colour, {}, false}));
        const Spot centre = place.box.centre;
        if (request.balloon > 0) figure.marks.emplace_back(circle(centre, request.balloon, {0.35, request.colour, {}, false}));
        const std::size_t first = figure.marks.size();
        set_text(figure.marks, shaped, {centre.x - shaped.width / 2, centre.y + (shaped.ascent - shaped.descent) / 2},
                 request.colour, "label");
        for (std::size_t k = first; k < figure.marks.size(); ++k) {
            auto& text = std::get<TextMark>(figure.marks[k]);
            text.pivot = centre;
            text.angle = std::atan2(place.box.axis.y, place.box.axis.x);
            if (k > first) text.cls = "text";  // one label, one aria-label
        }
        if (!request.id.empty()) figure.marks.emplace_back(GroupEnd{});
        const Spot reach = place.box.reach();
        figure.box.min = {std::min(figure.box.min.x, centre.x - reach.x), std::min(figure.box.min.y, centre.y - reach.y)};
        figure.box.max = {std::max(figure.box.max.x, centre.x + reach.x), std::max(figure.box.max.y, centre.y + reach.y)};
    }
    if (grouped) figure.marks.emplace_back(GroupEnd{});
    figure.labels.clear();
}

}  // namespace kinegraph::render
