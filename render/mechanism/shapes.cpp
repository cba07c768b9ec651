// What a mechanism is made of on paper: points, bars, plates, rods and slots of each body, what lies on what. Draws nothing.
#include "render/mechanism/sketch.hpp"

#include <algorithm>

namespace kinegraph::render::drawing {

namespace {

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

}  // namespace

Spot paper_direction(const Vector& v) {
    const Exact largest = std::max(abs(v.x), abs(v.y));
    if (largest.is_zero()) return {1, 0};
    return unit({(v.x / largest).to_double(), -(v.y / largest).to_double()});
}

bool contains(const Box& box, Spot spot) {
    return spot.x >= box.min.x && spot.x <= box.max.x && spot.y >= box.min.y && spot.y <= box.max.y;
}

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

double distance(Spot spot, const Bar& bar) {
    const Spot d = bar.to - bar.from;
    const double whole = dot(d, d);
    const double t = whole > 0 ? std::clamp(dot(spot - bar.from, d) / whole, 0.0, 1.0) : 0;
    return length(spot - bar.from - t * d);
}

Subject::Subject(const Solution& s) : solution(s), mechanism(s.mechanism) {
    for (const Vector& point : s.pose.points) points.push_back(paper_spot(point));
    const auto units = [](const std::vector<Vector>& from, std::size_t count) {
        std::vector<Spot> to(count);
        for (std::size_t i = 0; i < std::min(count, from.size()); ++i)
            if (!from[i].is_zero()) to[i] = paper_direction(from[i]);
        return to;
    };
    guides = units(s.pose.guides, mechanism.joints.size());
    normals = units(s.pose.normals, mechanism.joints.size());
    mass_centre.assign(points.size(), false);
    shown.assign(points.size(), false);
    for (const Mass& mass : mechanism.masses)
        if (mass.centre >= 0) mass_centre[at_index(mass.centre)] = shown[at_index(mass.centre)] = true;
    for (const Load& load : mechanism.loads)
        if (const auto* spring = std::get_if<SpringLoad>(&load))
            for (const PointIndex end : spring->between) shown[at_index(end)] = true;
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
            const bool held =
                joint.pair().has_common_point() || (joint.pair().has_guide() && i == 0) || is_tip(joint, joint.bodies[i]);
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

bool Subject::touches_there(BodyIndex body, PointIndex point) const {
    bool touches = false;
    for (const Joint& joint : mechanism.joints) {
        const auto in = std::find(joint.bodies.begin(), joint.bodies.end(), body);
        if (in == joint.bodies.end() || joint.point != point) continue;
        if (joint.pair().has_common_point() || (joint.pair().has_guide() && in == joint.bodies.begin())) return false;
        // Without a profile it is a point of the body that touches.
        if (joint.pair().touches()) touches = joint.profiles.count(body) != 0 && !is_tip(joint, body);
    }
    return touches;
}

Sketch::Sketch(const Subject& subject, const DrawingContext& context, double scale, std::string prefix)
    : shrink_(std::clamp(subject.shortest / scale / 14, 0.62, 1.0)),
      s_(subject),
      m_(subject.mechanism),
      context_(context),
      theme_(context.theme),
      scale_(scale),
      prefix_(std::move(prefix)) {
    for (const Spot point : s_.points) spots_.push_back((1 / scale_) * point);
    for (const Joint& joint : m_.joints)
        for (const auto& [body, profile] : joint.profiles)
            if (const auto* round = std::get_if<CircleProfile>(&profile); round && joint.pair().meshes())
                module_ = std::min(module_, length(spot(joint.point) - spot(round->centre)) / 6);
    find_cylinders();
    for (std::size_t b = 0; b < m_.bodies.size(); ++b) shapes_.push_back(shape_of(static_cast<int>(b)));
}

/// Driven slides between two moving bodies whose pins all lie on the axis: those that look like a cylinder.
void Sketch::find_cylinders() {
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (!joint.pair().is_sleeve() || joint.bodies.size() != 2 || joint.bodies[0] == 0 || joint.bodies[1] == 0) continue;
        const auto driven = [&](const auto& listed) {
            return std::any_of(listed.begin(), listed.end(), [&](const auto& one) {
                const auto* slide = std::get_if<SlideDriver>(&one);
                return slide && at_index(slide->joint) == j;
            });
        };
        const bool pushed = std::any_of(m_.efforts.begin(), m_.efforts.end(), [&](const Effort& effort) {
            const auto* actuator = std::get_if<ActuatorEffort>(&effort);
            return actuator && at_index(actuator->joint) == j;
        });
        if (!driven(m_.drivers) && !pushed) continue;
        const Spot at = spot(joint.point), along = s_.guides[j];
        const auto farthest = [&](BodyIndex body) -> std::optional<double> {
            std::optional<double> found;
            for (const int corner : s_.corners[at_index(body)]) {
                const Spot d = spot(corner) - at;
                if (std::abs(cross(along, d)) > 0.3) return std::nullopt;
                if (!found || std::abs(dot(along, d)) > std::abs(*found) + 1e-9) found = dot(along, d);
            }
            return found;
        };
        const auto rod = farthest(joint.bodies[0]), barrel = farthest(joint.bodies[1]);
        if (!rod || !barrel) continue;
        const double sense = *rod > *barrel ? 1 : -1, whole = sense * (*rod - *barrel);
        if (whole < 24 * shrink_) continue;
        // The piston is the joint's point, where that lies well within.
        const double wanted = -sense * *barrel;
        const double piston = wanted > 0.25 * whole && wanted < 0.75 * whole ? wanted : 0.5 * whole;
        const double open_end = std::min(piston + 0.2 * whole, whole - 5 * shrink_),
                     closed_end = std::min(5.0 * shrink_, piston - 2);
        const Spot foot = at + *barrel * along, onward = sense * along;
        cylinders_.push_back(
            {j, at + *rod * along, foot + piston * onward, {foot + closed_end * onward, foot + open_end * onward}});
    }
}

const Cylinder* Sketch::cylinder_of(std::size_t joint) const {
    const auto found =
        std::find_if(cylinders_.begin(), cylinders_.end(), [&](const Cylinder& cylinder) { return cylinder.joint == joint; });
    return found == cylinders_.end() ? nullptr : &*found;
}

/// A bar that ends in a tip is cut short and pointed.
void Sketch::cut_knife_edges(Shape& shape, BodyIndex body) const {
    for (const Joint& joint : m_.joints) {
        if (std::find(joint.bodies.begin(), joint.bodies.end(), body) == joint.bodies.end() || !Subject::is_tip(joint, body))
            continue;
        const Spot tip = spot(joint.point);
        const double edge = 4.5 * shrink_;
        for (Bar& bar : shape.bars)
            for (Spot Bar::*end : {&Bar::from, &Bar::to}) {
                const Spot other = end == &Bar::from ? bar.to : bar.from;
                if (length(bar.*end - tip) > same_place || length(other - tip) < 2 * edge) continue;
                bar.*end = tip + edge * unit(other - tip);
                shape.edges.push_back({bar.*end, tip});
            }
    }
}

std::string Sketch::id(std::string_view kind, std::string_view name) {
    std::string wanted = prefix_ + std::string(kind) + (kind.empty() ? "" : "-") + legal_id(name);
    // "a b" and "a_x20_b" are two names and one id.
    while (!ids_.insert(wanted).second) wanted += "_";
    return wanted;
}

Sketch::CurvedSlot Sketch::curved_slot(const Joint& joint) const {
    const Spot centre = spot(joint.arc), at = spot(joint.point);
    const double radius = length(at - centre);
    if (radius < slot_side_ + 0.5) return {};
    const double middle = std::atan2(at.y - centre.y, at.x - centre.x), half = std::min(slot_half_ / radius, 2.6);
    return {centre, radius, middle - half, middle + half};
}

Shape Sketch::shape_of(BodyIndex body) const {
    Shape shape;
    shape.rims = rims_of(body);
    shape.flats = flats_of(body);
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
        const bool slides =
            joint.pair().has_guide() && joint.bodies.size() == 2 && joint.bodies[1] == body && length(s_.guides[j]) > 0;
        if (!slides) continue;
        if (cylinder_of(j)) continue;
        const bool slot = joint.pair().is_slot();
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
        if (!joint.pair().is_slot() || joint.arc < 0 || joint.bodies[1] != body || corners.empty()) continue;
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
    // A flat face reaches to the points that lie on it, else it hangs on the nearest by an arm at right angles.
    for (Flat& flat : shape.flats) {
        const Spot along = unit(flat.bar.to - flat.bar.from), start = flat.bar.from;
        double from = 0, to = length(flat.bar.to - start);
        std::optional<Bar> arm;
        bool carries_corner = false;
        for (const Spot corner : corners) {
            const double t = dot(corner - start, along);
            if (std::abs(cross(along, corner - start)) < 0.6) {
                carries_corner = true;
                from = std::min(from, t);
                to = std::max(to, t);
            }
            const Spot foot = start + std::clamp(t, from, to) * along + (flat.rack ? module_ : flat.depth) * flat.inward;
            if (!arm || length(foot - corner) < length(arm->to - arm->from) - 1e-9) arm = Bar{corner, foot};
        }
        flat.bar = {start + from * along, start + to * along};
        if (carries_corner)
            flat.depth = 0;
        else if (arm && length(arm->to - arm->from) > theme_.link / 2 + 0.3)
            shape.bars.push_back(*arm);
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
    // Of a cylinder one carries the barrel, the other the rod; both hang on pins in line.
    for (const Cylinder& cylinder : cylinders_) {
        const Joint& joint = m_.joints[cylinder.joint];
        if (joint.bodies[0] == body) {
            shape.bars.push_back({cylinder.rod_end, cylinder.piston});
            off_guide.clear();
        } else if (joint.bodies[1] == body) {
            const Spot along = unit(cylinder.barrel.to - cylinder.barrel.from);
            for (const Spot corner : corners)
                if (dot(corner - cylinder.barrel.from, along) < -1e-9) shape.bars.push_back({corner, cylinder.barrel.from});
            off_guide.clear();
        }
    }
    // The rest is a line or a plate through all corners (those on a guide too, or the plate would not hold together).
    if (!off_guide.empty() && corners.size() >= 2) {
        const Chord chord = longest_chord(corners);
        if (corners.size() == 2 || chord.deviation < 0.6)
            shape.bars.push_back({chord.from, chord.to});
        else
            shape.plate = hull_of(corners);
        shape.solid = !shape.plate.empty() && chord.deviation < 1.8 * theme_.link && theme_.body(body).dashes.empty();
    }
    cut_knife_edges(shape, body);
    if (!shape.plate.empty()) {
        for (const Spot spot : shape.plate) shape.middle = shape.middle + (1.0 / static_cast<double>(shape.plate.size())) * spot;
    } else if (!shape.bars.empty()) {
        const Bar& longest = *std::max_element(shape.bars.begin(), shape.bars.end(), [](const Bar& a, const Bar& b) {
            return length(a.to - a.from) < length(b.to - b.from) - 1e-9;
        });
        shape.middle = 0.5 * (longest.from + longest.to);
    } else if (!corners.empty()) {
        shape.middle = corners.front();
    } else if (!shape.rims.empty()) {
        shape.middle = shape.rims.front().centre;
    } else if (!shape.flats.empty()) {
        shape.middle = 0.5 * (shape.flats.front().bar.from + shape.flats.front().bar.to);
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
        for (const Flat& flat : shape.flats) crowd += distance(spot, flat.bar) < theme_.link + 1;
        for (const Rim& rim : shape.rims)
            if (rim.form != Rim::Form::arc) crowd += std::abs(length(spot - rim.centre) - rim.radius) < theme_.link / 2 + 1;
    }
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const Spot at = this->spot(joint.point);
        if (joint.pair().is_sleeve()) {
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
        if (joint.pair().is_sleeve() && joint.bodies.size() == 2 &&
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
        if (!joint.pair().is_sleeve() || joint.bodies.size() != 2) continue;
        const std::size_t block = at_index(joint.bodies[0]), guide = at_index(joint.bodies[1]);
        above[block][guide] = true;
        for (const Joint& other : m_.joints) {
            if (other.point != joint.point || !other.pair().is_hinge()) continue;
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

}  // namespace kinegraph::render::drawing
