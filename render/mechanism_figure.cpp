// The mechanism to scale: links, pair symbols (ISO 3952), ground, drivers, instant centres with the lines of Kennedy, and the
// velocities on the mechanism. Owns which symbol stands where; takes every place from the Solution and computes no mechanics.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/assert.hpp"
#include "render/figure.hpp"
#include "render/shapes.hpp"

namespace kinegraph::render {

namespace {

constexpr double overshoot = 7.0;    // of a construction line, mm
constexpr double same_place = 0.02;  // what nobody can tell apart on paper, mm
constexpr double pi_number = std::numbers::pi;

std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

Spot paper_spot(const Vector& v) { return {v.x.to_double(), -v.y.to_double()}; }
Spot polar_spot(double angle) { return {std::cos(angle), std::sin(angle)}; }

std::string shortest(double value) {
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

/// The number as given: significant digits without the zeros that only fill.
std::string given_number(double value, Language language, int digits = 6) {
    std::string text = number(value, digits, language);
    const std::size_t mark = text.find_first_of(".,");
    if (mark == std::string::npos) return text;
    std::size_t end = mark + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    std::size_t keep = end;
    while (keep > mark + 1 && text[keep - 1] == '0') --keep;
    if (keep == mark + 1) keep = mark;
    text.erase(keep, end - keep);
    // Six digits are for round values; of 120 rpm in rad/s four tell enough.
    if (digits == 6 && keep - mark > 3)
        if (std::string rounded_text = given_number(value, language, 4); rounded_text.size() + 1 < text.size())
            return rounded_text;
    return text;
}

struct Bar {
    Spot from, to;
};

double distance(Spot spot, const Bar& bar) {
    const Spot d = bar.to - bar.from;
    const double whole = dot(d, d);
    const double t = whole > 0 ? std::clamp(dot(spot - bar.from, d) / whole, 0.0, 1.0) : 0;
    return length(spot - bar.from - t * d);
}

/// What a body is drawn of, mm.
struct Shape {
    std::vector<Bar> bars;
    std::vector<Spot> plate;  // hull; empty: none
    std::vector<Bar> slots;   // centre lines of straight slots
    Spot middle;              // somewhere on it
};

std::vector<Spot> hull_of(std::vector<Spot> spots) {
    std::sort(spots.begin(), spots.end(), [](Spot a, Spot b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    if (spots.size() < 3) return spots;
    std::vector<Spot> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Spot spot : spots) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], spot - hull.back()) <= 1e-9)
                hull.pop_back();
            hull.push_back(spot);
        }
        hull.pop_back();
        std::reverse(spots.begin(), spots.end());
    }
    return hull;
}

/// The farthest pair and how far the others stand off its line.
struct Chord {
    Spot from, to;
    double deviation = 0;
};
Chord longest_chord(const std::vector<Spot>& spots) {
    Chord chord{spots.front(), spots.front(), 0};
    for (std::size_t i = 0; i < spots.size(); ++i)
        for (std::size_t j = i + 1; j < spots.size(); ++j)
            if (length(spots[j] - spots[i]) > length(chord.to - chord.from) + 1e-9) chord = {spots[i], spots[j], 0};
    const Spot along = unit(chord.to - chord.from);
    for (const Spot spot : spots) chord.deviation = std::max(chord.deviation, std::abs(cross(along, spot - chord.from)));
    return chord;
}

/// The part of the line from + t·along that lies in the box, as an interval of t; from > to where it misses.
struct Interval {
    double from, to;
};
Interval within(const Box& box, Spot from, Spot along) {
    Interval interval{-1e300, 1e300};
    const auto clip = [&](double start, double step, double low, double high) {
        if (std::abs(step) < 1e-12) {
            if (start < low || start > high) interval = {1, -1};
            return;
        }
        double a = (low - start) / step, b = (high - start) / step;
        if (a > b) std::swap(a, b);
        interval = {std::max(interval.from, a), std::min(interval.to, b)};
    };
    clip(from.x, along.x, box.min.x, box.max.x);
    clip(from.y, along.y, box.min.y, box.max.y);
    return interval;
}
Box grown(Box box, double by) { return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}}; }
bool contains(const Box& box, Spot spot) {
    return spot.x >= box.min.x && spot.x <= box.max.x && spot.y >= box.min.y && spot.y <= box.max.y;
}

/// What the figure takes from the solution, once, in metres with y downwards; scales are tried on it.
struct Subject {
    const Solution& solution;
    const Mechanism& mechanism;
    std::vector<Spot> points;
    std::vector<Spot> guides, normals;      // units, by joint
    std::vector<bool> shown;                // by point: some body carries it
    std::vector<std::vector<int>> corners;  // by body: points its strokes join
    std::vector<bool> mass_centre;          // by point
    Box box;                                // of the mechanism, m
    double shortest = 1e300;                // link, m

    explicit Subject(const Solution& s) : solution(s), mechanism(s.mechanism) {
        for (const Vector& point : s.pose.points) points.push_back(paper_spot(point));
        const auto units = [](const std::vector<Vector>& from, std::size_t count) {
            std::vector<Spot> to(count);
            for (std::size_t i = 0; i < std::min(count, from.size()); ++i)
                if (!from[i].is_zero()) to[i] = unit(paper_spot(from[i]));
            return to;
        };
        guides = units(s.pose.guides, mechanism.joints.size());
        normals = units(s.pose.normals, mechanism.joints.size());
        mass_centre.assign(points.size(), false);
        for (const Mass& mass : mechanism.masses)
            if (mass.centre >= 0) mass_centre[at_index(mass.centre)] = true;
        shown.assign(points.size(), false);
        corners.resize(mechanism.bodies.size());
        for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
            for (const PointIndex p : mechanism.bodies[b].points) {
                shown[at_index(p)] = true;
                if (!touches_there(static_cast<int>(b), p)) add_corner(static_cast<int>(b), p);
            }
        for (const Joint& joint : mechanism.joints) {
            if (joint.point < 0) continue;
            shown[at_index(joint.point)] = true;
            for (std::size_t i = 0; i < joint.bodies.size(); ++i) {
                const bool held = joint.kind == JointKind::revolute || joint.kind == JointKind::weld ||
                                  ((joint.kind == JointKind::prismatic || joint.kind == JointKind::pin_slot) && i == 0) ||
                                  is_tip(joint, joint.bodies[i]);
                if (held) add_corner(joint.bodies[i], joint.point);
            }
        }
        for (std::size_t b = 1; b < corners.size(); ++b) {
            double reach = 0;
            for (const int p : corners[b])
                for (const int q : corners[b]) reach = std::max(reach, length(points[at_index(p)] - points[at_index(q)]));
            if (reach > 0) shortest = std::min(shortest, reach);
        }
        for (const Joint& a : mechanism.joints)
            for (const Joint& b : mechanism.joints)
                if (const double apart = length(points[at_index(a.point)] - points[at_index(b.point)]);
                    is_fixed_pin(a) && is_fixed_pin(b) && apart > 0)
                    shortest = std::min(shortest, apart);
        bool first = true;
        const auto include = [&](Spot spot, double radius) {
            const Box around = {{spot.x - radius, spot.y - radius}, {spot.x + radius, spot.y + radius}};
            if (first) box = around;
            first = false;
            box.min = {std::min(box.min.x, around.min.x), std::min(box.min.y, around.min.y)};
            box.max = {std::max(box.max.x, around.max.x), std::max(box.max.y, around.max.y)};
        };
        for (std::size_t p = 0; p < points.size(); ++p)
            if (shown[p]) include(points[p], 0);
        for (const Body& body : mechanism.bodies)
            if (body.circle) include(points[at_index(body.circle->centre)], body.circle->radius.to_double());
    }

    double size() const { return std::max({box.width(), box.height(), 1e-12}); }
    static bool is_fixed_pin(const Joint& joint) {
        return joint.kind == JointKind::revolute && std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end();
    }
    static bool is_tip(const Joint& joint, BodyIndex body) {
        const auto profile = joint.profiles.find(body);
        return profile != joint.profiles.end() && std::holds_alternative<TipProfile>(profile->second);
    }
    /// A point where the body only touches or is slid upon: no stroke leads there.
    bool touches_there(BodyIndex body, PointIndex point) const {
        bool touches = false;
        for (const Joint& joint : mechanism.joints) {
            const auto in = std::find(joint.bodies.begin(), joint.bodies.end(), body);
            if (in == joint.bodies.end() || joint.point != point) continue;
            switch (joint.kind) {
                case JointKind::revolute:
                case JointKind::weld:
                    return false;
                case JointKind::prismatic:
                case JointKind::pin_slot:
                    if (in == joint.bodies.begin()) return false;
                    break;
                default:
                    touches = !is_tip(joint, body);
            }
        }
        return touches;
    }

private:
    void add_corner(BodyIndex body, PointIndex point) {
        std::vector<int>& list = corners[at_index(body)];
        if (std::find(list.begin(), list.end(), point) == list.end()) list.push_back(point);
    }
};

/// One try at a scale.
class Sketch {
public:
    Sketch(const Subject& subject, const DrawingContext& context, double scale, std::string prefix)
        : shrink_(std::clamp(subject.shortest / scale / 14, 0.62, 1.0)),
          s_(subject),
          m_(subject.mechanism),
          context_(context),
          theme_(context.theme),
          scale_(scale),
          prefix_(std::move(prefix)) {
        for (const Spot point : s_.points) spots_.push_back((1 / scale_) * point);
        for (std::size_t b = 0; b < m_.bodies.size(); ++b) shapes_.push_back(shape_of(static_cast<int>(b)));
    }

    std::vector<Mark> tints, construction, ground, bodies, pins, arrows, centres, type;
    std::vector<LabelRequest> labels;

    Spot spot(PointIndex point) const { return spots_[at_index(point)]; }
    Spot spot(const Vector& place) const { return (1 / scale_) * paper_spot(place); }
    const Shape& shape(BodyIndex body) const { return shapes_[at_index(body)]; }
    double size() const { return s_.size() / scale_; }
    Box mechanism_box() const { return {(1 / scale_) * s_.box.min, (1 / scale_) * s_.box.max}; }
    std::string id(std::string_view kind, std::string_view name) {
        std::string wanted = prefix_ + std::string(kind) + (kind.empty() ? "" : "-") + legal_id(name);
        // "a b" and "a_x20_b" are two names and one id.
        while (!ids_.insert(wanted).second) wanted += "_";
        return wanted;
    }

    void draw_in_colour();
    void draw_in_grey();
    void draw_points(bool names);
    void draw_drivers();
    void draw_compass();
    void draw_centres();
    void draw_pole(const InstantCentre& centre);
    Figure finish(std::string kind, std::string figure_id, std::string unit_name);
    void close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit);

private:
    /// The centre line of a slot curved about a point; radius 0: too narrow to draw.
    struct CurvedSlot {
        Spot centre;
        double radius = 0, from = 0, to = 0;
    };
    CurvedSlot curved_slot(const Joint& joint) const;
    Shape shape_of(BodyIndex body) const;
    Symbol symbol_of(const InstantCentre& centre) const;
    std::vector<Spot> leaving(PointIndex point) const;
    double crowding(Spot spot, Spot besides) const;
    bool lies_on(BodyIndex body, BodyIndex longer) const;
    std::vector<BodyIndex> drawing_order() const;
    void draw_body(BodyIndex body);
    void draw_block(const Joint& joint, std::size_t index, std::vector<Mark>& marks);
    void draw_profiles(BodyIndex body, std::vector<Mark>& marks);
    void draw_wall(Spot from, Spot to, Spot away);
    void draw_fixed_pin(PointIndex point);
    void draw_guides();
    void draw_slot(const Bar& slot, BodyIndex body, std::vector<Mark>& marks);
    void draw_curved_slot(const Joint& joint, std::vector<Mark>& marks);
    void draw_mass_centre(Spot centre);
    void draw_clamp(const Joint& joint);
    void balloon(BodyIndex body);
    Colour line_colour(BodyIndex body) const { return body == 0 ? theme_.text : theme_.body(body).line; }
    Colour letter_colour(BodyIndex body) const { return body == 0 ? theme_.text : theme_.body(body).letter; }
    Colour tint_colour(BodyIndex body) const { return body == 0 ? theme_.paper : theme_.body(body).tint; }
    bool is_wheel(BodyIndex body) const { return m_.bodies[at_index(body)].circle.has_value(); }

    // Measures of the symbols, mm; they shrink where the links are short.
    double shrink_ = 1;
    double pin_radius_ = 1.5 * shrink_, triangle_height_ = 6.2 * shrink_, triangle_half_ = 3.6 * shrink_,
           base_half_ = 5.4 * shrink_;
    double hatch_depth_ = 2.2 * shrink_, hatch_pitch_ = 1.5 * shrink_;
    double slider_half_ = 8.0 * shrink_, slider_side_ = 4.4 * shrink_, sleeve_half_ = 7.5 * shrink_, sleeve_side_ = 3.6 * shrink_;
    double wall_beyond_ = 9.0 * shrink_, axis_beyond_ = 14.0 * shrink_, rod_beyond_ = 9.0 * shrink_;
    double slot_half_ = 10.0 * shrink_, slot_side_ = 2.2 * shrink_;

    const Subject& s_;
    const Mechanism& m_;
    const DrawingContext& context_;
    const Theme& theme_;
    double scale_;
    std::string prefix_;
    std::set<std::string> ids_;
    std::vector<Spot> spots_;
    std::vector<Shape> shapes_;
    std::vector<std::pair<Spot, Spot>> arcs_of_drivers_;  // pivot and where the arrow is: ground turns away from it
};

Shape Sketch::shape_of(BodyIndex body) const {
    Shape shape;
    if (body == 0) return shape;
    std::vector<Spot> corners;
    for (const int p : s_.corners[at_index(body)]) {
        const Spot spot = spots_[at_index(p)];
        const bool known = std::any_of(corners.begin(), corners.end(), [&](Spot c) { return length(c - spot) < same_place; });
        if (!known) corners.push_back(spot);
    }
    // Guides the body carries: each a rod (or a slot) through P, long enough to be slid upon.
    struct Rod {
        Spot at, along;
        double from, to;
        bool slot;
    };
    std::vector<Rod> rods;
    std::vector<Spot> off_guide = corners;
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const bool slides = (joint.kind == JointKind::prismatic || joint.kind == JointKind::pin_slot) &&
                            joint.bodies.size() == 2 && joint.bodies[1] == body && length(s_.guides[j]) > 0;
        if (!slides) continue;
        const bool slot = joint.kind == JointKind::pin_slot;
        const double reach = slot ? slot_half_ : sleeve_half_ + rod_beyond_;
        rods.push_back({spots_[at_index(joint.point)], s_.guides[j], -reach, reach, slot});
    }
    for (Rod& rod : rods) {
        bool carries_corner = false;
        const double slot_from = rod.from, slot_to = rod.to;
        double pin_before = -1e300, pin_after = 1e300;
        for (const Spot corner : corners) {
            if (std::abs(cross(rod.along, corner - rod.at)) > 0.3) continue;
            const double t = dot(corner - rod.at, rod.along);
            carries_corner = true;
            rod.from = std::min(rod.from, t);
            rod.to = std::max(rod.to, t);
            if (t < 0) pin_before = std::max(pin_before, t);
            if (t > 0) pin_after = std::min(pin_after, t);
            std::erase_if(off_guide, [&](Spot other) { return length(other - corner) < same_place; });
        }
        if (!carries_corner && !corners.empty()) {
            // The arm from the nearest corner meets the guide at right angles.
            const Spot nearest = *std::min_element(corners.begin(), corners.end(), [&](Spot a, Spot b) {
                return std::abs(cross(rod.along, a - rod.at)) < std::abs(cross(rod.along, b - rod.at));
            });
            const double t = dot(nearest - rod.at, rod.along);
            const Spot foot = rod.at + t * rod.along;
            rod.from = std::min(rod.from, t);
            rod.to = std::max(rod.to, t);
            if (!rod.slot)
                shape.bars.push_back({nearest, foot});
            else
                shape.bars.push_back({nearest, foot + (t > slot_from && t < slot_to ? slot_side_ : 0) * unit(nearest - foot)});
        }
        if (rod.slot) {
            const double from = std::max(slot_from, pin_before + 4.0), to = std::min(slot_to, pin_after - 4.0);
            shape.slots.push_back({rod.at + from * rod.along, rod.at + to * rod.along});
            if (rod.from < from - 0.5)
                shape.bars.push_back({rod.at + rod.from * rod.along, rod.at + (from - slot_side_) * rod.along});
            if (rod.to > to + 0.5) shape.bars.push_back({rod.at + rod.to * rod.along, rod.at + (to + slot_side_) * rod.along});
        } else {
            shape.bars.push_back({rod.at + rod.from * rod.along, rod.at + rod.to * rod.along});
        }
    }
    // A curved slot hangs on the nearest corner by its nearer end.
    for (const Joint& joint : m_.joints) {
        if (joint.kind != JointKind::pin_slot || joint.arc < 0 || joint.bodies[1] != body || corners.empty()) continue;
        const CurvedSlot slot = curved_slot(joint);
        if (slot.radius <= 0) continue;
        Bar nearest{corners.front(), slot.centre + slot.radius * polar_spot(slot.from)};
        for (const Spot corner : corners)
            for (const double end : {slot.from, slot.to})
                if (const Spot at = slot.centre + slot.radius * polar_spot(end);
                    length(at - corner) < length(nearest.to - nearest.from) - 1e-9)
                    nearest = {corner, at};
        if (const double whole = length(nearest.to - nearest.from); whole > slot_side_ + 0.5)
            shape.bars.push_back({nearest.from, nearest.to - slot_side_ * unit(nearest.to - nearest.from)});
    }
    // A body of two guides and no pin (Oldham, trammel cross): the guides are one piece.
    if (corners.empty() && rods.size() >= 2)
        for (std::size_t i = 1; i < rods.size(); ++i) {
            const double turn = cross(rods[0].along, rods[i].along);
            if (std::abs(turn) < 0.1) {
                shape.bars.push_back({rods[0].at, rods[i].at});
                continue;
            }
            const Spot meet = rods[0].at + (cross(rods[i].at - rods[0].at, rods[i].along) / turn) * rods[0].along;
            for (const Rod& rod : {rods[0], rods[i]})
                if (length(meet - rod.at) > same_place) shape.bars.push_back({rod.at, meet});
        }
    // The rest is a line or a plate through all corners (those on a guide too, or the plate would not hold together).
    if (!off_guide.empty() && corners.size() >= 2) {
        const Chord chord = longest_chord(corners);
        if (corners.size() == 2 || chord.deviation < 0.6)
            shape.bars.push_back({chord.from, chord.to});
        else
            shape.plate = hull_of(corners);
    }
    if (!shape.plate.empty()) {
        for (const Spot spot : shape.plate) shape.middle = shape.middle + (1.0 / static_cast<double>(shape.plate.size())) * spot;
    } else if (!shape.bars.empty()) {
        const Bar& longest = *std::max_element(shape.bars.begin(), shape.bars.end(), [](const Bar& a, const Bar& b) {
            return length(a.to - a.from) < length(b.to - b.from) - 1e-9;
        });
        shape.middle = 0.5 * (longest.from + longest.to);
    } else if (!corners.empty()) {
        shape.middle = corners.front();
    }
    return shape;
}

/// Unit directions in which strokes leave a point.
std::vector<Spot> Sketch::leaving(PointIndex point) const {
    std::vector<Spot> directions;
    const Spot at = spot(point);
    const auto look = [&](Spot from, Spot to) {
        if (length(from - at) < 0.3)
            directions.push_back(unit(to - from));
        else if (length(to - at) < 0.3)
            directions.push_back(unit(from - to));
        else if (const Spot along = unit(to - from); std::abs(cross(along, at - from)) < 0.5 && dot(along, at - from) > 0 &&
                                                     dot(along, at - from) < length(to - from)) {
            directions.push_back(along);
            directions.push_back(-1.0 * along);
        }
    };
    for (const Shape& shape : shapes_) {
        for (const Bar& bar : shape.bars) look(bar.from, bar.to);
        for (std::size_t i = 0; i < shape.plate.size(); ++i) look(shape.plate[i], shape.plate[(i + 1) % shape.plate.size()]);
    }
    return directions;
}

/// How much a small symbol at `spot` would be in the way of strokes, blocks and pins other than that at `besides`: 0 not at all.
double Sketch::crowding(Spot spot, Spot besides) const {
    double crowd = 0;
    for (const Shape& shape : shapes_) {
        for (const Bar& bar : shape.bars) crowd += distance(spot, bar) < theme_.link / 2 + 1;
        for (std::size_t i = 0; i < shape.plate.size(); ++i)
            crowd += distance(spot, {shape.plate[i], shape.plate[(i + 1) % shape.plate.size()]}) < theme_.link / 2 + 1;
    }
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const Spot at = this->spot(joint.point);
        if (joint.kind == JointKind::prismatic) {
            const bool on_frame = joint.bodies[1] == 0;
            const Spot d = spot - at;
            if (std::abs(dot(d, s_.guides[j])) < (on_frame ? slider_half_ + wall_beyond_ : sleeve_half_) + 1 &&
                std::abs(cross(d, s_.guides[j])) < (on_frame ? slider_side_ + hatch_depth_ : sleeve_side_) + 1)
                crowd += 1;
        } else if (length(at - besides) > same_place) {
            if (length(spot - at) < pin_radius_ + 1) crowd += 1;
            // The ground of a fixed pin stands somewhere about it.
            else if (Subject::is_fixed_pin(joint) && length(spot - at) < triangle_height_ + 2)
                crowd += 0.4;
        }
    }
    return crowd;
}

/// Whether a straight link lies along a longer one (and does not slide on it).
bool Sketch::lies_on(BodyIndex body, BodyIndex longer) const {
    const Shape &a = shapes_[at_index(body)], &b = shapes_[at_index(longer)];
    if (body == longer || a.bars.size() != 1 || b.bars.size() != 1) return false;
    for (const Joint& joint : m_.joints)
        if (joint.kind == JointKind::prismatic && joint.bodies.size() == 2 &&
            std::max(joint.bodies[0], joint.bodies[1]) == std::max(body, longer) &&
            std::min(joint.bodies[0], joint.bodies[1]) == std::min(body, longer))
            return false;
    const Bar &p = a.bars[0], &q = b.bars[0];
    const Spot along = unit(q.to - q.from);
    const double whole = length(q.to - q.from), own = length(p.to - p.from);
    if (own > whole + 1e-9 || (own > whole - 1e-9 && body < longer)) return false;
    if (std::abs(cross(along, p.from - q.from)) > 0.8 || std::abs(cross(along, p.to - q.from)) > 0.8) return false;
    const double t = dot(along, p.from - q.from), u = dot(along, p.to - q.from);
    return std::min(std::max(t, u), whole) - std::max(std::min(t, u), 0.0) > 2;
}

/// Blocks stand above the guide they slide on and below the links pinned to them.
std::vector<BodyIndex> Sketch::drawing_order() const {
    const std::size_t n = m_.bodies.size();
    std::vector<std::vector<bool>> above(n, std::vector<bool>(n, false));  // above[a][b]: a is drawn after b
    for (const Joint& joint : m_.joints) {
        if (joint.kind != JointKind::prismatic || joint.bodies.size() != 2) continue;
        const std::size_t block = at_index(joint.bodies[0]), guide = at_index(joint.bodies[1]);
        above[block][guide] = true;
        for (const Joint& other : m_.joints) {
            if (other.point != joint.point || other.kind != JointKind::revolute) continue;
            for (const BodyIndex body : other.bodies)
                if (at_index(body) != block && at_index(body) != guide) above[at_index(body)][block] = true;
        }
    }
    for (std::size_t a = 1; a < n; ++a)
        for (std::size_t b = 1; b < n; ++b)
            if (lies_on(static_cast<int>(a), static_cast<int>(b)) && !above[b][a]) above[a][b] = true;
    std::vector<BodyIndex> order;
    std::vector<bool> done(n, false);
    while (order.size() < n) {
        std::size_t next = n;
        for (std::size_t b = 0; b < n && next == n; ++b) {
            if (done[b]) continue;
            bool free = true;
            for (std::size_t below = 0; below < n; ++below) free = free && (done[below] || !above[b][below]);
            if (free) next = b;
        }
        if (next == n)  // the orders contradict each other: take the first
            next = static_cast<std::size_t>(std::find(done.begin(), done.end(), false) - done.begin());
        done[next] = true;
        order.push_back(static_cast<int>(next));
    }
    return order;
}

/// Ground: a line with hatching on the side `away`.
void Sketch::draw_wall(Spot from, Spot to, Spot away) {
    const Pen edge{theme_.outline, theme_.text, {}, false}, hatch{theme_.thin, theme_.text, {}, false};
    const Spot along = unit(to - from);
    const double whole = length(to - from);
    const double depth_along = hatch_depth_;
    Path strokes;
    strokes.stroked = true;
    strokes.pen = hatch;
    const int count = std::max(2, static_cast<int>(std::floor(whole / hatch_pitch_)));
    const double pitch = whole / count;
    for (int i = 1; i <= count; ++i) {
        const double t = i * pitch, back = std::min(depth_along, t);
        strokes.segments.emplace_back(MoveTo{from + t * along});
        strokes.segments.emplace_back(LineTo{from + (t - back) * along + back * away});
    }
    ground.emplace_back(std::move(strokes));
    ground.emplace_back(line(from, to, edge));
}

void Sketch::draw_fixed_pin(PointIndex point) {
    const Spot at = spot(point);
    std::vector<Spot> links = leaving(point);
    for (const Joint& joint : m_.joints)
        if (const Spot d = spot(joint.point) - at; length(d) > same_place && length(d) < triangle_height_ + hatch_depth_ + 2)
            links.push_back(unit(d));  // a pin where the triangle would stand
    // Down first, then the sides, then up; away from links and from the arrow of a crank.
    const std::array<std::pair<Spot, double>, 4> choices{
        {{Spot{0, 1}, 0.0}, {Spot{1, 0}, 0.35}, {Spot{-1, 0}, 0.35}, {Spot{0, -1}, 0.6}}};
    Spot down{0, 1};
    double least = 1e300;
    for (const auto& [direction, bias] : choices) {
        double price = bias;
        for (const Spot link : links) {
            const double angle = std::acos(std::clamp(dot(link, direction), -1.0, 1.0));
            if (angle < 1.2) price += 2.5 * (1.2 - angle);
        }
        for (const auto& [pivot, arrow] : arcs_of_drivers_)
            if (length(pivot - at) < same_place) {
                const double angle = std::acos(std::clamp(dot(unit(arrow - pivot), direction), -1.0, 1.0));
                if (angle < 1.2) price += 1.0 * (1.2 - angle);
            }
        if (price < least - 1e-9) {
            least = price;
            down = direction;
        }
    }
    const Spot across = turned(down), base = at + triangle_height_ * down;
    Path triangle = polyline({at, base + triangle_half_ * across, base - triangle_half_ * across},
                             {theme_.outline, theme_.text, {}, false}, true);
    triangle.filled = true;
    triangle.fill = theme_.paper;
    ground.emplace_back(std::move(triangle));
    draw_wall(base + base_half_ * across, base - base_half_ * across, down);
}

/// Guides of the frame: axis and walls on both sides, open where a link passes.
void Sketch::draw_guides() {
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (joint.bodies.size() != 2 || length(s_.guides[j]) == 0) continue;
        const Spot at = spot(joint.point), along = s_.guides[j];
        const auto walls = [&](double side_distance, double half, bool heed_links) {
            for (const double side : {1.0, -1.0}) {
                const Spot away = side * turned(along);
                std::vector<Interval> pieces{{-half, half}};
                for (const Spot link : heed_links ? leaving(joint.point) : std::vector<Spot>{}) {
                    const double rise = dot(link, away), run = dot(link, along);
                    if (rise < 0.08) continue;
                    const double crossing = side_distance * run / rise, gap = 2.6 / rise + 1.2 * std::abs(run) / rise;
                    std::vector<Interval> rest;
                    // A link that passes beside the block would leave a stub: that side stays open.
                    const bool beside = std::abs(crossing) - gap < slider_half_;
                    for (const Interval piece : pieces) {
                        if (beside) break;
                        if (piece.from < crossing - gap) rest.push_back({piece.from, std::min(piece.to, crossing - gap)});
                        if (piece.to > crossing + gap) rest.push_back({std::max(piece.from, crossing + gap), piece.to});
                    }
                    pieces = rest;
                }
                for (const Interval piece : pieces)
                    if (piece.to - piece.from > 6)
                        draw_wall(at + piece.from * along + side_distance * away, at + piece.to * along + side_distance * away,
                                  away);
            }
        };
        if (joint.kind == JointKind::prismatic && joint.bodies[1] == 0) {
            const double half = slider_half_ + axis_beyond_;
            construction.emplace_back(
                line(at - half * along, at + half * along, {theme_.thin, theme_.secondary, dash_dot(), false}));
            // A wall ends before the next pin on its way.
            double reach = slider_half_ + wall_beyond_;
            for (const Joint& other : m_.joints) {
                const Spot d = spot(other.point) - at;
                const double ahead = std::abs(dot(d, along));
                if (ahead > slider_half_ && std::abs(cross(d, along)) < slider_side_ + 3)
                    reach = std::min(reach, std::max(ahead - 3.5, slider_half_ + 2));
            }
            walls(slider_side_ + theme_.vector / 2 + theme_.outline / 2, reach, true);
        } else if (joint.kind == JointKind::prismatic && joint.bodies[0] == 0) {
            walls(theme_.link / 2 + 0.5, sleeve_half_, false);
        } else if (joint.kind == JointKind::pin_slot && joint.bodies[1] == 0) {
            const double half = slider_half_ + axis_beyond_;
            construction.emplace_back(
                line(at - half * along, at + half * along, {theme_.thin, theme_.secondary, dash_dot(), false}));
            walls(slot_side_, slot_half_ + 3, true);
        }
    }
}

void Sketch::draw_block(const Joint& joint, std::size_t index, std::vector<Mark>& marks) {
    const BodyIndex body = joint.bodies[0];
    if (body == 0) return;
    const bool on_frame = joint.bodies[1] == 0;
    const double half = on_frame ? slider_half_ : sleeve_half_, side = on_frame ? slider_side_ : sleeve_side_;
    const Spot at = spot(joint.point), u = half * s_.guides[index], w = side * turned(s_.guides[index]);
    Path block = polyline({at + u + w, at + u - w, at - u - w, at - u + w}, {theme_.vector, line_colour(body), {}, false}, true);
    block.filled = true;
    block.fill = tint_colour(body);
    marks.emplace_back(std::move(block));
}

void Sketch::draw_slot(const Bar& slot, BodyIndex body, std::vector<Mark>& marks) {
    const Spot along = unit(slot.to - slot.from), across = slot_side_ * turned(along);
    const double a = std::atan2(along.y, along.x);
    Path path;
    path.segments = {MoveTo{slot.from + across}, ArcTo{slot.from, slot_side_, a + pi_number / 2, a + 3 * pi_number / 2},
                     LineTo{slot.to - across}, ArcTo{slot.to, slot_side_, a - pi_number / 2, a + pi_number / 2}, Close{}};
    path.filled = true;
    path.fill = theme_.paper;
    path.stroked = true;
    path.pen = {theme_.vector, line_colour(body), {}, true};
    marks.emplace_back(std::move(path));
}

Sketch::CurvedSlot Sketch::curved_slot(const Joint& joint) const {
    const Spot centre = spot(joint.arc), at = spot(joint.point);
    const double radius = length(at - centre);
    if (radius < slot_side_ + 0.5) return {};
    const double middle = std::atan2(at.y - centre.y, at.x - centre.x), half = std::min(slot_half_ / radius, 2.6);
    return {centre, radius, middle - half, middle + half};
}

void Sketch::draw_curved_slot(const Joint& joint, std::vector<Mark>& marks) {
    const auto [centre, radius, from, to] = curved_slot(joint);
    if (radius <= 0) return;
    const Spot start = centre + radius * polar_spot(from), end = centre + radius * polar_spot(to);
    Path path;
    path.segments = {MoveTo{centre + (radius + slot_side_) * polar_spot(from)},
                     ArcTo{centre, radius + slot_side_, from, to},
                     ArcTo{end, slot_side_, to, to + pi_number},
                     ArcTo{centre, radius - slot_side_, to, from},
                     ArcTo{start, slot_side_, from + pi_number, from + 2 * pi_number},
                     Close{}};
    path.filled = true;
    path.fill = theme_.paper;
    path.stroked = true;
    const BodyIndex body = joint.bodies[1];
    path.pen = {body == 0 ? theme_.outline : theme_.vector, line_colour(body), {}, true};
    (body == 0 ? ground : marks).emplace_back(std::move(path));
}

/// Wheels, cams and flat faces.
void Sketch::draw_profiles(BodyIndex body, std::vector<Mark>& marks) {
    const Body& data = m_.bodies[at_index(body)];
    const Pen pen{theme_.vector, line_colour(body), {}, false};
    bool geared = false;
    for (const Joint& joint : m_.joints)
        if (joint.kind == JointKind::gear && std::find(joint.bodies.begin(), joint.bodies.end(), body) != joint.bodies.end())
            geared = true;
    std::vector<std::pair<Spot, double>> circles;
    const auto add_circle = [&](Spot centre, double radius) {
        for (const auto& [c, r] : circles)
            if (length(c - centre) < same_place && std::abs(r - radius) < same_place) return;
        circles.emplace_back(centre, radius);
        Pen edge = pen;
        if (geared) edge.dashes = dash_dot();
        (body == 0 ? ground : marks).emplace_back(circle(centre, radius, edge));
        if (body == 0) {
            // Hatch the rim on the side where nothing rolls: inside, unless the wheels are within.
            bool inner = true;
            for (std::size_t other = 1; other < m_.bodies.size(); ++other)
                if (const auto& wheel = m_.bodies[other].circle)
                    if (length(spot(wheel->centre) - centre) + wheel->radius.to_double() / scale_ < radius + 0.5) inner = false;
            Path rim;
            rim.stroked = true;
            rim.pen = {theme_.thin, theme_.text, {}, false};
            const int count = std::max(8, static_cast<int>(2 * pi_number * radius / 3.0));
            for (int i = 0; i < count; ++i) {
                const double angle = 2 * pi_number * i / count, lean = angle + 1.5 / radius;
                rim.segments.emplace_back(MoveTo{centre + radius * polar_spot(angle)});
                rim.segments.emplace_back(LineTo{centre + (radius + (inner ? -1.6 : 1.6)) * polar_spot(lean)});
            }
            ground.emplace_back(std::move(rim));
        }
    };
    if (data.circle) add_circle(spot(data.circle->centre), data.circle->radius.to_double() / scale_);
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (joint.kind != JointKind::rolling && joint.kind != JointKind::contact && joint.kind != JointKind::gear) continue;
        const auto in = std::find(joint.bodies.begin(), joint.bodies.end(), body);
        if (in == joint.bodies.end()) continue;
        const auto profile = joint.profiles.find(body);
        const Spot at = spot(joint.point);
        const Spot tangent = turned(s_.normals[j]);
        const bool first = in == joint.bodies.begin();
        if (profile != joint.profiles.end() && std::holds_alternative<CircleProfile>(profile->second)) {
            const Spot centre = spot(std::get<CircleProfile>(profile->second).centre);
            add_circle(centre, length(at - centre));
        } else if (profile != joint.profiles.end() && std::holds_alternative<LineProfile>(profile->second)) {
            if (length(tangent) == 0) continue;
            const double half = 16;
            if (body == 0) {
                // Hatched away from what stands on it.
                const BodyIndex other = joint.bodies[first ? 1 : 0];
                Spot away = s_.normals[j];
                const Spot across = is_wheel(other) ? spot(m_.bodies[at_index(other)].circle->centre) : shape(other).middle;
                if (dot(across - at, away) > 0) away = -1.0 * away;
                draw_wall(at - half * tangent, at + half * tangent, away);
            } else {
                marks.emplace_back(line(at - half * tangent, at + half * tangent, {theme_.link, line_colour(body), {}, true}));
                const std::vector<int>& corners = s_.corners[at_index(body)];
                if (!corners.empty()) {
                    const Spot from = spot(corners.front());
                    const double t = dot(from - at, tangent);
                    marks.emplace_back(
                        line(from, at + std::clamp(t, -half, half) * tangent, {theme_.link, line_colour(body), {}, true}));
                }
            }
        } else if (!data.circle && profile == joint.profiles.end() && length(tangent) > 0 && first) {
            construction.emplace_back(
                line(at - 10.0 * tangent, at + 10.0 * tangent, {theme_.thin, theme_.secondary, dash_dot(), false}));
        }
    }
}

void Sketch::draw_body(BodyIndex body) {
    const Body& data = m_.bodies[at_index(body)];
    const Shape& shape = shapes_[at_index(body)];
    // Of two links in line (a dead point) the shorter one lies on top, narrower, so that both are seen.
    bool on_another = false;
    for (std::size_t other = 1; other < m_.bodies.size(); ++other)
        on_another = on_another || lies_on(body, static_cast<int>(other));
    const Pen stroke{on_another ? 0.5 * theme_.link : theme_.link, line_colour(body), {}, true};
    std::vector<Mark> marks;
    draw_profiles(body, marks);
    if (!shape.plate.empty()) {
        tints.emplace_back(filled(shape.plate, tint_colour(body)));
        marks.emplace_back(polyline(shape.plate, stroke, true));
    }
    for (const Bar& bar : shape.bars)
        if (length(bar.to - bar.from) > 1e-6) marks.emplace_back(line(bar.from, bar.to, stroke));
    // The block covers the end of its own rod: they are one piece.
    for (std::size_t j = 0; j < m_.joints.size(); ++j)
        if (m_.joints[j].kind == JointKind::prismatic && m_.joints[j].bodies.size() == 2 && m_.joints[j].bodies[0] == body)
            draw_block(m_.joints[j], j, marks);
    for (const Bar& slot : shape.slots) draw_slot(slot, body, marks);
    for (const Joint& joint : m_.joints)
        if (joint.kind == JointKind::pin_slot && joint.arc >= 0 && joint.bodies.size() == 2 && joint.bodies[1] == body)
            draw_curved_slot(joint, marks);
    const std::string& words = in(data.label, context_.language);
    bodies.emplace_back(GroupBegin{"link", id("link", data.name), words.empty() ? data.name : data.name + ": " + words, {}});
    for (Mark& mark : marks) bodies.push_back(std::move(mark));
    bodies.emplace_back(GroupEnd{});
}

/// The body's number in a circle beside its longest stroke; names longer than two letters go without the circle.
void Sketch::balloon(BodyIndex body) {
    const Body& data = m_.bodies[at_index(body)];
    const Shape& shape = shapes_[at_index(body)];
    LabelRequest request;
    request.text = one_piece(data.name);
    request.size = data.name.size() > 1 ? theme_.small : theme_.derived;
    request.colour = letter_colour(body);
    if (context_.fonts.shape(request.text, request.size).width < 3.7)
        request.balloon = 2.3;
    else
        request.size = theme_.derived;
    std::vector<Bar> sides = shape.bars;
    for (std::size_t i = 0; i < shape.plate.size(); ++i)
        sides.push_back({shape.plate[i], shape.plate[(i + 1) % shape.plate.size()]});
    const auto longest = std::max_element(sides.begin(), sides.end(), [](const Bar& a, const Bar& b) {
        return length(a.to - a.from) < length(b.to - b.from) - 1e-9;
    });
    if (longest != sides.end() && length(longest->to - longest->from) > 6) {
        request.anchor = 0.5 * (longest->from + longest->to);
        request.toward = longest->to;
        request.clearance = 2.7;
    } else {
        // A block or a wheel: beside it.
        request.anchor = shape.middle;
        request.clearance = 6.4;
        for (std::size_t j = 0; j < m_.joints.size(); ++j)
            if (m_.joints[j].kind == JointKind::prismatic && m_.joints[j].bodies[0] == body) {
                request.anchor = spot(m_.joints[j].point);
                const double half = m_.joints[j].bodies[1] == 0 ? slider_half_ : sleeve_half_;
                const double side = m_.joints[j].bodies[1] == 0 ? slider_side_ : sleeve_side_;
                request.toward = request.anchor + (half + 2) * s_.guides[j];
                request.clearance = side + 2.2;
            }
        if (data.circle) {
            const double radius = data.circle->radius.to_double() / scale_;
            request.anchor = spot(data.circle->centre) + (radius * std::sqrt(0.5)) * Spot{1, -1};
            request.toward = request.anchor + 4.0 * Spot{1, 1};
            request.clearance = 1.8;
        }
    }
    labels.push_back(std::move(request));
}

void Sketch::draw_mass_centre(Spot centre) {
    constexpr double radius = 1.9;
    pins.emplace_back(ring(centre, radius, theme_.paper, {theme_.outline, theme_.text, {}, false}));
    for (const double from : {0.0, pi_number}) {
        Path quarter;
        quarter.segments = {MoveTo{centre}, LineTo{centre + radius * polar_spot(from)},
                            ArcTo{centre, radius, from, from + pi_number / 2}, Close{}};
        quarter.filled = true;
        quarter.fill = theme_.text;
        pins.emplace_back(std::move(quarter));
    }
}

/// Two bodies in one piece: a filled square across the joint; a clamp in the frame: a wall.
void Sketch::draw_clamp(const Joint& joint) {
    const Spot at = spot(joint.point);
    const std::vector<Spot> links = leaving(joint.point);
    const Spot along = links.empty() ? Spot{1, 0} : links.front();
    const bool fixed = std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end();
    if (fixed) draw_wall(at + base_half_ * turned(along), at - base_half_ * turned(along), -1.0 * along);
    const double half = 1.7;
    const Spot u = half * along, w = half * turned(along);
    const BodyIndex body = joint.bodies[0] != 0 ? joint.bodies[0] : joint.bodies.back();
    if (!fixed) pins.emplace_back(filled({at + u + w, at + u - w, at - u - w, at - u + w}, line_colour(body)));
}

void Sketch::draw_in_colour() {
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const bool fixed = std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end();
        if (joint.kind == JointKind::revolute && fixed) draw_fixed_pin(joint.point);
        if (joint.kind == JointKind::weld) draw_clamp(joint);
        if (joint.kind == JointKind::pin_slot && joint.arc >= 0 && joint.bodies[1] == 0) draw_curved_slot(joint, ground);
    }
    draw_guides();
    {
        std::vector<Mark> frame;
        draw_profiles(0, frame);
    }
    for (const BodyIndex body : drawing_order())
        if (body != 0) draw_body(body);
    for (std::size_t b = 1; b < m_.bodies.size(); ++b) balloon(static_cast<int>(b));

    // Joints: one group each; a pin where bodies turn about each other, a dot where they touch.
    std::vector<Spot> pinned;
    for (const Joint& joint : m_.joints) {
        const Spot at = spot(joint.point);
        std::string title = joint.name + ":";
        for (const BodyIndex body : joint.bodies) title += " " + m_.bodies[at_index(body)].name;
        pins.emplace_back(GroupBegin{"joint", id("joint", joint.name), title, {}});
        const bool already = std::any_of(pinned.begin(), pinned.end(), [&](Spot p) { return length(p - at) < same_place; });
        const bool hinge = joint.kind == JointKind::revolute || joint.kind == JointKind::pin_slot;
        if (hinge && !already) {
            pins.emplace_back(ring(at, pin_radius_, theme_.paper, {theme_.outline, theme_.text, {}, false}));
            pinned.push_back(at);
        } else if (joint.kind == JointKind::rolling || joint.kind == JointKind::contact || joint.kind == JointKind::gear) {
            pins.emplace_back(disc(at, 0.65, theme_.text));
        }
        pins.emplace_back(GroupEnd{});
    }
    for (std::size_t p = 0; p < spots_.size(); ++p) {
        if (!s_.shown[p]) continue;
        const bool taken = std::any_of(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
            return length(spot(joint.point) - spots_[p]) < same_place && joint.kind != JointKind::prismatic;
        });
        if (taken) continue;
        if (s_.mass_centre[p])
            draw_mass_centre(spots_[p]);
        else
            pins.emplace_back(disc(spots_[p], 0.65, theme_.text));
    }
}

/// The same mechanism as a thin grey skeleton, under vectors.
void Sketch::draw_in_grey() {
    const Pen thin{theme_.outline, {0x9A, 0x9A, 0xA2}, {}, true};
    for (const BodyIndex body : drawing_order()) {
        if (body == 0) continue;
        const Shape& shape = shapes_[at_index(body)];
        bodies.emplace_back(GroupBegin{"link", id("link", m_.bodies[at_index(body)].name), m_.bodies[at_index(body)].name, {}});
        for (std::size_t j = 0; j < m_.joints.size(); ++j) {
            const Joint& joint = m_.joints[j];
            if (joint.kind != JointKind::prismatic || joint.bodies[0] != body) continue;
            const bool on_frame = joint.bodies[1] == 0;
            const double half = on_frame ? slider_half_ : sleeve_half_, side = on_frame ? slider_side_ : sleeve_side_;
            const Spot at = spot(joint.point), u = half * s_.guides[j], w = side * turned(s_.guides[j]);
            Path block = polyline({at + u + w, at + u - w, at - u - w, at - u + w}, thin, true);
            block.filled = true;
            block.fill = theme_.paper;
            bodies.emplace_back(std::move(block));
        }
        if (const auto& wheel = m_.bodies[at_index(body)].circle)
            bodies.emplace_back(circle(spot(wheel->centre), wheel->radius.to_double() / scale_, thin));
        if (!shape.plate.empty()) bodies.emplace_back(polyline(shape.plate, thin, true));
        for (const Bar& bar : shape.bars)
            if (length(bar.to - bar.from) > 1e-6) bodies.emplace_back(line(bar.from, bar.to, thin));
        for (const Bar& slot : shape.slots) bodies.emplace_back(line(slot.from, slot.to, thin));
        bodies.emplace_back(GroupEnd{});
    }
    for (const Joint& joint : m_.joints) {
        if (joint.kind == JointKind::prismatic) continue;
        pins.emplace_back(ring(spot(joint.point), 0.9, theme_.paper, thin));
        if (joint.kind == JointKind::revolute && std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end())
            draw_fixed_pin(joint.point);
    }
}

/// Names of points; those at one place share a label.
void Sketch::draw_points(bool names) {
    if (!names) return;
    std::vector<bool> named(spots_.size(), false);
    for (std::size_t p = 0; p < spots_.size(); ++p) {
        if (!s_.shown[p] || named[p]) continue;
        const auto there = std::find_if(labels.begin(), labels.end(), [&](const LabelRequest& label) {
            return label.balloon == 0 && !label.toward && length(label.anchor - spots_[p]) < same_place;
        });
        LabelRequest request;
        request.size = theme_.label;
        request.colour = theme_.text;
        request.anchor = spots_[p];
        request.clearance = pin_radius_ + 0.8;
        for (std::size_t q = p; q < spots_.size(); ++q) {
            if (!s_.shown[q] || named[q] || length(spots_[q] - spots_[p]) > same_place) continue;
            named[q] = true;
            if (!request.text.empty()) request.text.push_back(one_piece(" ≡ ").front());
            for (Piece& piece : typeset(Symbol{Symbol::Letter::point, m_.points[q].name, ""}, context_.language))
                request.text.push_back(std::move(piece));
        }
        if (there != labels.end()) {
            // An instant centre falls on the point: "B ≡ P_13".
            request.text.push_back(one_piece(" ≡ ").front());
            for (Piece& piece : there->text) request.text.push_back(std::move(piece));
            there->text = std::move(request.text);
            there->clearance = std::max(there->clearance, request.clearance);
        } else {
            labels.push_back(std::move(request));
        }
    }
}

/// ω of a driven body as an arc about its pivot, the speed of a driven slide as an arrow beside it.
void Sketch::draw_drivers() {
    const auto valued = [&](Symbol symbol, double value, const Unit& unit_of) {
        RichText text = typeset(symbol, context_.language);
        text.push_back(
            one_piece(" = " + given_number(value / unit_of.si.to_double(), context_.language) + " " + unit_of.symbol).front());
        return text;
    };
    const auto straight = [&](Spot start, Spot along, double value, BodyIndex body, const std::string& about) {
        if (value == 0) return;
        const Spot direction = value < 0 ? -1.0 * along : along;
        const Spot tail = start - 7.0 * direction, tip = start + 7.0 * direction;
        draw_arrow(arrows, tail, tip, theme_.outline, letter_colour(body));
        LabelRequest request;
        request.text = valued({Symbol::Letter::v, about, ""}, value, m_.units.velocity);
        request.size = theme_.label;
        request.colour = letter_colour(body);
        request.anchor = start;
        request.toward = tip;
        request.clearance = 1.5;
        labels.push_back(std::move(request));
    };
    for (const Driver& driver : m_.drivers) {
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) {
            const double omega = spin->omega.to_double();
            if (omega == 0) continue;
            PointIndex pivot = -1;
            for (const Joint& joint : m_.joints) {
                const auto has = [&](BodyIndex b) {
                    return std::find(joint.bodies.begin(), joint.bodies.end(), b) != joint.bodies.end();
                };
                if (pivot < 0 && joint.kind == JointKind::revolute && has(spin->body) && has(spin->relative_to))
                    pivot = joint.point;
            }
            const std::vector<int>& corners = s_.corners[at_index(spin->body)];
            if (pivot < 0 && !corners.empty()) pivot = corners.front();
            if (pivot < 0) continue;
            const Spot at = spot(pivot);
            Spot arm{1, 0};
            const auto& wheel = m_.bodies[at_index(spin->body)].circle;
            double reach = wheel ? wheel->radius.to_double() / scale_ : 12;
            for (const int corner : corners)
                if (length(spot(corner) - at) > 1) {
                    arm = unit(spot(corner) - at);
                    reach = length(spot(corner) - at);
                    break;
                }
            // On paper y runs down: counter-clockwise is the negative turn.
            const double turn = omega > 0 ? -1 : 1;
            // Ahead of the crank if nothing is in the way, else further on.
            double radius = 8, start = 0, sweep = 0, least = 1e300;
            for (const double tried : {std::clamp(0.4 * reach, 8.0, 14.0), std::clamp(0.25 * reach, 6.0, 8.0), 11.0})
                for (int step = 0; step < 9; ++step) {
                    const double from = std::atan2(arm.y, arm.x) + turn * (2.6 / tried + 0.6 * step);
                    const double by = turn * std::min(1.05, 11.0 / tried);
                    double price = 0.35 * step + 0.1 * std::abs(tried - 0.4 * reach);
                    for (int i = 0; i <= 6; ++i) price += 2.5 * crowding(at + tried * polar_spot(from + by * i / 6), at);
                    if (price < least - 1e-9) {
                        least = price;
                        radius = tried;
                        start = from;
                        sweep = by;
                    }
                }
            draw_arc_arrow(arrows, at, radius, start, start + sweep, theme_.outline, letter_colour(spin->body));
            const Spot middle = at + radius * polar_spot(start + 0.5 * sweep);
            arcs_of_drivers_.emplace_back(at, middle);
            LabelRequest request;
            Symbol symbol{Symbol::Letter::omega, m_.bodies[at_index(spin->body)].name, ""};
            if (spin->relative_to != 0) symbol.about += m_.bodies[at_index(spin->relative_to)].name;
            request.text = valued(symbol, omega, m_.units.angular_velocity);
            request.size = theme_.label;
            request.colour = letter_colour(spin->body);
            request.anchor = middle;
            request.clearance = 1.5;
            labels.push_back(std::move(request));
        } else if (const auto* slide = std::get_if<SlideDriver>(&driver)) {
            const Joint& joint = m_.joints[at_index(slide->joint)];
            const Spot along = s_.guides[at_index(slide->joint)];
            Spot side = turned(along);
            if (side.y > 0 || (side.y == 0 && side.x > 0)) side = -1.0 * side;
            std::string about = joint.name;
            straight(spot(joint.point) + (slider_side_ + 5.0) * side, along, slide->speed.to_double(), joint.bodies[0], about);
        } else if (const auto* point = std::get_if<PointDriver>(&driver)) {
            const Vector direction = direction_of(point->along, s_.solution.pose);
            const Spot along = unit(paper_spot(direction));
            straight(spot(point->at) + 11.0 * along, along, point->speed.to_double(), point->body,
                     m_.points[at_index(point->at)].name);
        }
    }
}

/// The compass strokes that found the points.
void Sketch::draw_compass() {
    for (const PositionStep& step : s_.solution.pose.steps) {
        if (step.point < 0 || !s_.shown[at_index(step.point)]) continue;
        const Spot at = spot(step.point);
        for (const PositionStep::Arc& arc : step.arcs) {
            const Spot centre = spot(arc.centre);
            const double radius = arc.radius.to_double() / scale_;
            if (radius < 2 || std::abs(length(at - centre) - radius) > 0.1) continue;
            const double middle = std::atan2(at.y - centre.y, at.x - centre.x);
            const double half = std::clamp(6 * pi_number / 180, 4.0 / radius, 9.0 / radius);
            Path stroke;
            stroke.segments = {MoveTo{centre + radius * polar_spot(middle - half)},
                               ArcTo{centre, radius, middle - half, middle + half}};
            stroke.stroked = true;
            stroke.pen = {theme_.thin, theme_.secondary, {}, false};
            construction.emplace_back(std::move(stroke));
        }
    }
}

Symbol Sketch::symbol_of(const InstantCentre& centre) const {
    const std::string& i = m_.bodies[at_index(centre.first)].name;
    const std::string& j = m_.bodies[at_index(centre.second)].name;
    const bool short_names = i.size() == 1 && j.size() == 1;
    return Symbol{Symbol::Letter::centre, short_names ? i + j : i + "," + j, centre.at && centre.at->at_infinity() ? "∞" : ""};
}

/// An absolute centre under the velocities: a dot and its name, once; none where a pin stands.
void Sketch::draw_pole(const InstantCentre& centre) {
    const Spot at = spot(centre.at->place());
    for (const Joint& joint : m_.joints)
        if (length(spot(joint.point) - at) < same_place) return;
    const RichText name = typeset(symbol_of(centre), context_.language);
    for (LabelRequest& label : labels)
        if (!label.toward && length(label.anchor - at) < same_place) {
            const bool said = plain(label.text).find(plain(name)) != std::string::npos;
            if (!said) label.text.push_back(one_piece(" ≡ ").front());
            if (!said) label.text.insert(label.text.end(), name.begin(), name.end());
            return;
        }
    centres.emplace_back(disc(at, 0.8, theme_.text));
    LabelRequest request;
    request.text = name;
    request.size = theme_.label;
    request.colour = theme_.text;
    request.anchor = at;
    request.clearance = 1.7;
    labels.push_back(std::move(request));
}

void Sketch::draw_centres() {
    const std::vector<InstantCentre>& all = s_.solution.centres;
    const auto group = [&](const InstantCentre& centre) {
        const std::string key = m_.bodies[at_index(centre.first)].name + "." + m_.bodies[at_index(centre.second)].name;
        return GroupBegin{"centre", id("centre", key), plain(typeset(symbol_of(centre), context_.language)), {}};
    };
    const Pen thin{theme_.thin, theme_.secondary, {}, false};

    // Where each centre is: near the mechanism, far from it, or at infinity.
    enum class Where { nowhere, here, far, infinity };
    const Box mechanism = mechanism_box();
    const Box near = grown(mechanism, 0.6 * size());
    std::vector<Where> where(all.size(), Where::nowhere);
    std::vector<Spot> place(all.size());  // spot, or unit direction at infinity
    Box view = mechanism;
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (!all[c].at) continue;
        if (all[c].at->at_infinity()) {
            where[c] = Where::infinity;
            place[c] = unit(paper_spot(all[c].at->place()));
        } else {
            place[c] = spot(all[c].at->place());
            where[c] = contains(near, place[c]) ? Where::here : Where::far;
            if (where[c] == Where::here) {
                view.min = {std::min(view.min.x, place[c].x), std::min(view.min.y, place[c].y)};
                view.max = {std::max(view.max.x, place[c].x), std::max(view.max.y, place[c].y)};
            }
        }
    }
    view = grown(view, 9);

    // Lines of Kennedy and normals, each once however many centres lie on it.
    struct Ray {
        Spot at, along;
        double from, to;
    };
    std::vector<Ray> rays;
    const auto draw_ray = [&](Spot at, Spot along, double from, double to) {
        for (Ray& ray : rays)
            if (std::abs(cross(ray.along, along)) < 1e-6 && std::abs(cross(ray.along, at - ray.at)) < 1e-3) {
                const double a = dot(at + from * along - ray.at, ray.along), b = dot(at + to * along - ray.at, ray.along);
                ray.from = std::min({ray.from, a, b});
                ray.to = std::max({ray.to, a, b});
                return;
            }
        rays.push_back({at, along, from, to});
    };
    struct Arrow {
        Spot base, along;
    };
    std::vector<std::vector<Arrow>> arrows_to(all.size());  // one on each line that runs out of the drawing
    // What the distance of a far centre is counted from.
    struct Named {
        RichText name;
        Spot at;
    };
    std::vector<std::optional<Named>> far_from(all.size());
    const auto name_at = [&](Spot at) -> std::optional<Named> {
        for (std::size_t p = 0; p < spots_.size(); ++p)
            if (s_.shown[p] && length(spots_[p] - at) < same_place)
                return Named{typeset(Symbol{Symbol::Letter::point, m_.points[p].name, ""}, context_.language), at};
        for (std::size_t c = 0; c < all.size(); ++c)
            if (where[c] == Where::here && length(place[c] - at) < same_place)
                return Named{typeset(symbol_of(all[c]), context_.language), at};
        return std::nullopt;
    };
    // A line through `known` (finite spots, at most one direction) to the centre c.
    const auto construct = [&](std::size_t c, const std::vector<Spot>& known, std::optional<Spot> direction) {
        if (known.empty()) return;
        Spot along;
        if (where[c] != Where::infinity && length(place[c] - known[0]) > same_place)
            along = unit(place[c] - known[0]);
        else if (direction)
            along = *direction;
        else if (where[c] == Where::infinity)
            along = place[c];
        else if (known.size() > 1 && length(known[1] - known[0]) > same_place)
            along = unit(known[1] - known[0]);
        else
            return;
        double from = 0, to = 0;
        const auto take = [&](Spot spot) {
            const double t = dot(spot - known[0], along);
            from = std::min(from, t);
            to = std::max(to, t);
        };
        for (const Spot spot : known)
            if (contains(view, spot)) take(spot);
        const Interval seen = within(view, known[0], along);
        if (where[c] == Where::here) {
            take(place[c]);
            const double t = dot(place[c] - known[0], along);
            if (t >= to - 1e-9) to += overshoot;
            if (t <= from + 1e-9) from -= overshoot;
        } else {
            // Beyond the drawing: the line runs on to its edge and says where to.
            double way = where[c] == Where::far ? dot(place[c] - known[0], along) : 1;
            if (where[c] == Where::infinity) {
                // Either end will do, but the same for all lines: where fewer things are in the way.
                if (!arrows_to[c].empty()) {
                    way = dot(arrows_to[c].front().along, along) > 0 ? 1 : -1;
                } else {
                    const auto price = [&](double end, double sense) {
                        double sum = 0;
                        for (double step = 3; step <= 18; step += 3) {
                            const Spot at = known[0] + (end + sense * step) * along;
                            sum += 2 * crowding(at, at);
                            for (const Joint& joint : m_.joints) {
                                if (Subject::is_fixed_pin(joint) && length(spot(joint.point) + Spot{0, 5} - at) < 6) sum += 3;
                            }
                        }
                        return sum;
                    };
                    const double after = price(to, 1) + 0.01 * (seen.to - to),
                                 before = price(from, -1) + 0.01 * (from - seen.from);
                    way = after <= before ? 1 : -1;
                }
            }
            const double beyond = 16;
            if (way > 0)
                to = where[c] == Where::far ? std::max(seen.to, to + 4) : to + beyond;
            else
                from = where[c] == Where::far ? std::min(seen.from, from - 4) : from - beyond;
            arrows_to[c].push_back({known[0] + (way > 0 ? to : from) * along, way > 0 ? along : -1.0 * along});
            for (std::size_t k = 0; k < known.size() && !far_from[c]; ++k) far_from[c] = name_at(known[k]);
        }
        draw_ray(known[0], along, from, to);
    };

    // In the order found; of a large mechanism only what leads to the absolute centres.
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < all.size(); ++c) order.push_back(c);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a].order < all[b].order; });
    std::vector<bool> drawn(all.size(), true);
    const auto secondary = std::count_if(all.begin(), all.end(),
                                         [](const InstantCentre& c) { return c.at && c.how != InstantCentre::How::primary; });
    const Spot room{view.width(), view.height()};
    if (secondary > 14 || room.x * room.y < 700 * static_cast<double>(secondary)) {
        drawn.assign(all.size(), false);
        std::vector<std::size_t> wanted;
        for (std::size_t c = 0; c < all.size(); ++c)
            if (all[c].first == 0 || all[c].how == InstantCentre::How::primary) wanted.push_back(c);
        while (!wanted.empty()) {
            const std::size_t c = wanted.back();
            wanted.pop_back();
            if (drawn[c]) continue;
            drawn[c] = true;
            for (const auto& [a, b] : all[c].through) {
                wanted.push_back(at_index(a));
                wanted.push_back(at_index(b));
            }
        }
    }
    for (const std::size_t c : order) {
        if (where[c] == Where::nowhere || !drawn[c] || all[c].how == InstantCentre::How::primary) continue;
        for (const auto& [a, b] : all[c].through) {
            std::vector<Spot> known;
            std::optional<Spot> direction;
            for (const int one : {a, b}) {
                if (one < 0 || where[at_index(one)] == Where::nowhere) continue;
                if (where[at_index(one)] == Where::infinity)
                    direction = place[at_index(one)];
                else
                    known.push_back(place[at_index(one)]);
            }
            // Start from what can be seen.
            std::stable_sort(known.begin(), known.end(), [&](Spot p, Spot q) { return contains(view, p) && !contains(view, q); });
            construct(c, known, direction);
        }
        for (const PointIndex point : all[c].normals) construct(c, {spot(point)}, std::nullopt);
    }
    for (const Ray& ray : rays) {
        const Interval seen = within(grown(view, 12), ray.at, ray.along);
        const double from = std::max(ray.from, seen.from), to = std::min(ray.to, seen.to);
        if (to > from) construction.emplace_back(line(ray.at + from * ray.along, ray.at + to * ray.along, thin));
    }

    // The centres themselves. Those at one place are one dot with one label.
    std::vector<bool> done(all.size(), false);
    for (const std::size_t c : order) {
        if (where[c] == Where::nowhere || done[c] || !drawn[c]) continue;
        std::vector<std::size_t> here{c};
        for (const std::size_t d : order) {
            if (d == c || done[d] || !drawn[d] || where[d] != where[c]) continue;
            const bool finite_same = where[c] == Where::here && length(place[d] - place[c]) < same_place;
            const bool far_same = where[c] == Where::far && length(place[d] - place[c]) < 1e-6 * length(place[c]) + same_place;
            const bool infinite_same = where[c] == Where::infinity && !arrows_to[c].empty() && !arrows_to[d].empty() &&
                                       length(arrows_to[c].front().base - arrows_to[d].front().base) < 2 &&
                                       all[d].how != InstantCentre::How::primary;
            if (finite_same || far_same || infinite_same) here.push_back(d);
        }
        // A pin has its own name; the centre there is for the reader who points at it.
        bool at_pin = false;
        const bool pin_there =
            where[c] == Where::here && std::any_of(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
                return (joint.kind == JointKind::revolute || joint.kind == JointKind::pin_slot ||
                        joint.kind == JointKind::weld) &&
                       length(spot(joint.point) - place[c]) < same_place;
            });
        for (const std::size_t d : here) {
            done[d] = true;
            at_pin = at_pin || (pin_there && all[d].how == InstantCentre::How::primary);
        }
        RichText text;
        for (const std::size_t d : here) {
            if (at_pin && all[d].how == InstantCentre::How::primary) continue;
            if (!text.empty()) text.push_back(one_piece(" ≡ ").front());
            for (Piece& piece : typeset(symbol_of(all[d]), context_.language)) text.push_back(std::move(piece));
        }
        LabelRequest request;
        request.text = text;
        request.size = theme_.label;
        request.colour = theme_.text;

        if (where[c] == Where::here) {
            for (const std::size_t d : here) {
                centres.emplace_back(group(all[d]));
                // On a stroke the dot stands in a white ring, or a dark link would swallow it.
                if (!pin_there && crowding(place[d], place[d]) > 0) centres.emplace_back(disc(place[d], 1.15, theme_.paper));
                if (at_pin && all[d].how == InstantCentre::How::primary)
                    centres.emplace_back(disc(place[d], 0.9, theme_.paper));
                else
                    centres.emplace_back(disc(place[d], at_pin ? 0.55 : 0.8, theme_.text));
                centres.emplace_back(GroupEnd{});
            }
            request.anchor = place[c];
            request.clearance = at_pin ? pin_radius_ + 0.8 : 1.7;
        } else {
            Spot base, along;
            double shaft = 0;
            if (where[c] == Where::infinity && all[c].how == InstantCentre::How::primary) {
                // ⟂ to the guide, from the slider.
                along = place[c];
                for (std::size_t j = 0; j < m_.joints.size(); ++j) {
                    const Joint& joint = m_.joints[j];
                    const bool both = std::find(joint.bodies.begin(), joint.bodies.end(), all[c].first) != joint.bodies.end() &&
                                      std::find(joint.bodies.begin(), joint.bodies.end(), all[c].second) != joint.bodies.end();
                    if (!both || joint.kind != JointKind::prismatic) continue;
                    const Spot at = spot(joint.point);
                    double up = 0, down = 0;
                    for (const Spot link : leaving(joint.point)) {
                        up = std::max(up, dot(link, along));
                        down = std::max(down, -dot(link, along));
                    }
                    const Spot middle = 0.5 * (mechanism.min + mechanism.max);
                    const bool flip = up > down + 0.05 || (std::abs(up - down) <= 0.05 && dot(along, at - middle) < 0);
                    if (flip) along = -1.0 * along;
                    base = at;
                    shaft = slider_side_ + 15;
                    break;
                }
                if (shaft == 0) continue;
            } else if (!arrows_to[c].empty()) {
                base = arrows_to[c].front().base;
                along = arrows_to[c].front().along;
            } else {
                const Spot start = shape(all[c].second).middle;
                along = where[c] == Where::infinity ? place[c] : unit(place[c] - start);
                base = start;
                shaft = 18;
                far_from[c].reset();
            }
            const Spot tip = base + std::max(shaft, 3.0) * along;
            // The symbol lies under the blocks, its head beyond them.
            for (const std::size_t d : here) {
                construction.emplace_back(group(all[d]));
                draw_arrow(construction, base, tip, theme_.thin, theme_.secondary);
                // Parallels all say where they go; of two lines to a far centre one says it.
                for (std::size_t k = 1; k < arrows_to[d].size() && where[d] == Where::infinity; ++k)
                    draw_arrow(construction, arrows_to[d][k].base, arrows_to[d][k].base + 3.0 * arrows_to[d][k].along,
                               theme_.thin, theme_.secondary);
                construction.emplace_back(GroupEnd{});
            }
            if (where[c] == Where::far && far_from[c] && all[c].first == 0) {
                // "P_13 (O4 P_13 = 1.84 m)": the segment that the drawing cannot hold.
                const double metres = length(place[c] - far_from[c]->at) * scale_;
                request.text.push_back(one_piece("  (").front());
                for (Piece& piece : far_from[c]->name) request.text.push_back(std::move(piece));
                for (Piece& piece : typeset(symbol_of(all[c]), context_.language)) request.text.push_back(std::move(piece));
                request.text.push_back(one_piece(" = " + number(metres / m_.units.length.si.to_double(), 3, context_.language) +
                                                 " " + m_.units.length.symbol + ")")
                                           .front());
            }
            request.anchor = tip;
            request.clearance = 1.2;
        }
        if (!request.text.empty()) labels.push_back(std::move(request));
    }
    // Bodies that do not move against each other have no one centre; the drawing shows none.
}

Figure Sketch::finish(std::string kind, std::string figure_id, std::string unit_name) {
    Figure figure;
    figure.kind = std::move(kind);
    figure.id = std::move(figure_id);
    figure.scale = scale_;
    figure.unit = std::move(unit_name);
    for (std::vector<Mark>* layer : {&tints, &construction, &ground, &bodies, &pins, &arrows, &centres, &type}) {
        for (Mark& mark : *layer) figure.marks.push_back(std::move(mark));
        layer->clear();
    }
    figure.labels = std::move(labels);
    figure.box = box_of(figure.marks);
    return figure;
}

/// Scale bar below, labels placed, all in its group, its top left corner at the origin.
void Sketch::close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit) {
    // Too large already: not worth placing names.
    if (!fixed && (figure.box.width() > room.x || figure.box.height() > room.y)) return;
    const double target = std::min(30.0, std::max(8.0, room.x / 4));
    std::vector<Mark> bar;
    draw_scale_bar(bar, context_.fonts, theme_, {0, 0}, target, bar_scale, bar_unit.si.to_double(), bar_unit.symbol,
                   context_.language);
    figure.marks.insert(
        figure.marks.begin(),
        GroupBegin{"figure",
                   figure.id,
                   plain(figure.caption),
                   {{"data-figure", figure.kind}, {"data-scale", shortest(figure.scale)}, {"data-unit", figure.unit}}});
    figure.marks.emplace_back(GroupEnd{});
    place_labels(figure, context_.fonts, Spot{room.x, room.y - 8});
    const Box size_of_bar = box_of(bar);
    move(bar, figure.box.min.x - size_of_bar.min.x, figure.box.max.y + 3 - size_of_bar.min.y);
    const Box at = box_of(bar);
    figure.marks.pop_back();
    for (Mark& mark : bar) figure.marks.push_back(std::move(mark));
    figure.marks.emplace_back(GroupEnd{});
    figure.box.max = {std::max(figure.box.max.x, at.max.x), std::max(figure.box.max.y, at.max.y)};
    figure.move(-figure.box.min.x, -figure.box.min.y);
}

std::optional<double> asked_scale(const Mechanism& mechanism, std::string_view figure) {
    for (const AskedScale& scale : mechanism.scales)
        if (scale.figure == figure) return scale.per_millimetre.to_double();
    return std::nullopt;
}

double next_scale(double scale) { return choose_scale(scale * 1.01, 0, 1, 1, std::nullopt); }

/// Draws at ever smaller scales until everything, labels too, is within the room.
template <class Draw>
Figure fitted(double first, bool fixed, double room_x, double room_y, Draw draw) {
    constexpr int most_tries = 12;
    double scale = first;
    for (int tries = 0;; ++tries) {
        Figure figure = draw(scale, tries == most_tries);
        const bool fits = figure.box.width() <= room_x && figure.box.height() <= room_y;
        if (fixed || fits || tries == most_tries) return figure;
        scale = next_scale(scale);
    }
}

}  // namespace

Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres) {
    const Subject subject(context.solution);
    const std::optional<double> asked = asked_scale(context.solution.mechanism, "mechanism");
    // Symbols and names need a rim; the first guess leaves the least that they take.
    Box extent = subject.box;
    if (with_centres) {
        const Box near = grown(subject.box, 0.6 * subject.size());
        for (const InstantCentre& centre : context.solution.centres) {
            if (!centre.at || centre.at->at_infinity()) continue;
            const Spot at = paper_spot(centre.at->place());
            if (!contains(near, at)) continue;
            extent.min = {std::min(extent.min.x, at.x), std::min(extent.min.y, at.y)};
            extent.max = {std::max(extent.max.x, at.x), std::max(extent.max.y, at.y)};
        }
    }
    const double first =
        choose_scale(extent.width(), extent.height(), std::max(room_x - 10, 10.0), std::max(room_y - 18, 10.0), asked);
    return fitted(first, asked.has_value(), room_x, room_y, [&](double scale, bool last) {
        Sketch sketch(subject, context, scale, "");
        sketch.draw_drivers();
        sketch.draw_compass();
        sketch.draw_in_colour();
        if (with_centres) sketch.draw_centres();
        sketch.draw_points(true);
        Figure figure = sketch.finish("mechanism", "mechanism", "m");
        figure.caption = one_piece(word(with_centres ? "mechanism and instant centres" : "mechanism", context.language));
        sketch.close(figure, {room_x, room_y}, last || asked.has_value(), scale, context.solution.mechanism.units.length);
        return figure;
    });
}

Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y) {
    const Solution& solution = context.solution;
    const Subject subject(solution);
    const Theme& theme = context.theme;
    struct Shown {
        const PointMotion* motion;
        BodyIndex body;
        double value;
    };
    std::vector<Shown> shown;
    double longest = 0;
    for (const PointMotion& motion : solution.points) {
        if (motion.point < 0 || !motion.velocity || motion.velocity->is_zero()) continue;
        BodyIndex body = -1;
        for (const BodyIndex one : motion.bodies)
            if (one != 0 && body < 0) body = one;
        const double value = length(*motion.velocity);
        longest = std::max(longest, value);
        shown.push_back({&motion, body, value});
    }
    const std::optional<double> asked = asked_scale(solution.mechanism, "body");
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room_x - 30, 10.0),
                                      std::max(room_y - 36, 10.0), std::nullopt);
    return fitted(first, false, room_x, room_y, [&](double scale, bool last) {
        Sketch sketch(subject, context, scale, "velocities-");
        sketch.draw_in_grey();
        const double reach = std::clamp(0.5 * sketch.size(), 15.0, 50.0);
        const double velocity_scale = choose_scale(longest, 0, reach, reach, asked);
        Box view = grown(sketch.mechanism_box(), 0.25 * sketch.size());
        const Pen thin{theme.thin, theme.secondary, {}, false};
        std::vector<std::pair<Spot, Spot>> rays;
        for (const Shown& one : shown) {
            const Spot at = sketch.spot(one.motion->point);
            for (const InstantCentre& centre : solution.centres) {
                const std::vector<BodyIndex>& carriers = one.motion->bodies;
                if (!centre.at || centre.first != 0 || centre.everywhere || centre.at->at_infinity()) continue;
                if (std::find(carriers.begin(), carriers.end(), centre.second) == carriers.end()) continue;
                const Spot pole = sketch.spot(centre.at->place());
                const double whole = length(pole - at);
                if (whole < 0.1) continue;
                const Interval seen = within(view, at, unit(pole - at));
                rays.emplace_back(at, at + std::clamp(whole, 0.0, std::max(seen.to, 8.0)) * unit(pole - at));
                if (whole <= seen.to) sketch.draw_pole(centre);
            }
            const Spot tip = at + Spot{one.motion->velocity->x.to_double() / velocity_scale,
                                       -one.motion->velocity->y.to_double() / velocity_scale};
            Symbol symbol{
                Symbol::Letter::v,
                one.motion->label.empty() ? solution.mechanism.points[at_index(one.motion->point)].name : one.motion->label, ""};
            const Colour line_colour = one.body > 0 ? theme.body(one.body).line : theme.text;
            const Colour letter = one.body > 0 ? theme.body(one.body).letter : theme.text;
            const std::string name = name_of(symbol);
            const RichText text = typeset(symbol, context.language);
            sketch.arrows.emplace_back(GroupBegin{
                "vector", sketch.id("", name), plain(text), {{"data-name", name}, {"data-value", shortest(one.value)}}});
            draw_arrow(sketch.arrows, at, tip, theme.vector, line_colour);
            sketch.arrows.emplace_back(Axis{at, tip});
            sketch.arrows.emplace_back(GroupEnd{});
            LabelRequest request;
            request.text = text;
            request.size = theme.equation;
            request.colour = letter;
            request.anchor = 0.5 * (at + tip);
            request.toward = tip;
            request.clearance = 1.6;
            sketch.labels.push_back(std::move(request));
        }
        for (const auto& [from, to] : rays) sketch.construction.emplace_back(line(from, to, thin));
        Figure figure = sketch.finish("body", "velocities", "m/s");
        figure.scale = velocity_scale;
        figure.caption = one_piece(word("velocities on the mechanism", context.language));
        sketch.close(figure, {room_x, room_y}, last, velocity_scale, solution.mechanism.units.velocity);
        return figure;
    });
}

}  // namespace kinegraph::render
