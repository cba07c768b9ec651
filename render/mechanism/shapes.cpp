// Shapes of the bodies on paper: bars, plates, rods and slots. Draws nothing.
#include <algorithm>
#include <cmath>

#include "render/mechanism/layout.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render::drawing {

namespace {

/// The most distant pair of points, and the largest distance of the others from their line.
struct Chord {
    Bar bar;
    double deviation = 0;
};
Chord longest_chord(const std::vector<Spot>& spots) {
    Chord chord{{spots.front(), spots.front()}, 0};
    for (std::size_t i = 0; i < spots.size(); ++i)
        for (std::size_t j = i + 1; j < spots.size(); ++j)
            if (length(spots[j] - spots[i]) > length(chord.bar) + 1e-9) chord.bar = {spots[i], spots[j]};
    const Spot along = direction(chord.bar);
    for (const Spot spot : spots)
        chord.deviation = std::max(chord.deviation, std::abs(cross(along, spot - chord.bar.from)));
    return chord;
}

/// A guide of the body: a rod (or a slot) through the joint's point, as long as the slide requires.
struct Rod {
    Spot at, along;
    double from, to;
    bool slot;
    Spot on(double t) const { return at + t * along; }
};

/// Builds the shape of one moving body.
class Modelling {
public:
    Modelling(const Layout& layout, BodyIndex body) : l_(layout), body_(body) {
        for (const PointIndex point : l_.subject.corners[at_index(body)]) {
            const Spot spot = l_.spot(point);
            if (std::none_of(corners_.begin(), corners_.end(), [&](Spot c) { return coincide(c, spot); }))
                corners_.push_back(spot);
        }
        off_guide_ = corners_;
    }

    Shape shape(Shape with_profiles) {
        shape_ = std::move(with_profiles);
        leave_out_points_on_discs();
        find_rods();
        for (const Rod& rod : rods_) add_rod(rod);
        hang_curved_slots();
        for (Flat& flat : shape_.flats) hang_flat(flat);
        join_bare_guides();
        add_cylinder_parts();
        add_body_of_corners();
        cut_knife_edges();
        shape_.middle = middle_of_shape();
        return std::move(shape_);
    }

private:
    /// A disc carries its points: where a rope leaves it, or a mass centre, it needs no bar. Pins have theirs.
    void leave_out_points_on_discs() {
        const auto is_on_disc = [&](Spot corner) {
            constexpr double beside = 0.1;  // mm
            return std::any_of(shape_.rims.begin(), shape_.rims.end(), [&](const Rim& rim) {
                const double distance = length(corner - rim.centre);
                return rim.form != Rim::Form::arc && !rim.hollow && distance > beside && distance < rim.radius + beside;
            });
        };
        const auto has_pair = [&](Spot corner) {
            return std::any_of(l_.mechanism.joints.begin(), l_.mechanism.joints.end(), [&](const Joint& joint) {
                return joint.connects(body_) && coincide(l_.spot(joint), corner);
            });
        };
        const auto leaves = [&](Spot corner) { return is_on_disc(corner) && !has_pair(corner); };
        std::erase_if(corners_, leaves);
        std::erase_if(off_guide_, leaves);
    }
    void find_rods() {
        for (const Joint& joint : l_.mechanism.joints) {
            const bool slides = joint.pair().has_guide() && joint.bodies.size() == 2 && joint.bodies[1] == body_ &&
                                length(l_.guide(joint)) > 0;
            if (!slides || l_.cylinder_of(joint)) continue;
            const bool slot = joint.pair().is_slot();
            const double reach = slot ? l_.measures.slot_half : l_.measures.sleeve_half + l_.measures.rod_beyond;
            rods_.push_back({l_.spot(joint), l_.guide(joint), -reach, reach, slot});
        }
    }

    /// The rod reaches to the corners on its line; without such corners, an arm connects the nearest corner at a right
    /// angle.
    void add_rod(Rod rod) {
        bool carries_corner = false;
        const Interval slot{rod.from, rod.to};
        Interval free{-1e300, 1e300};  // between the pins on either side
        for (const Spot corner : corners_) {
            if (std::abs(cross(rod.along, corner - rod.at)) > 0.3) continue;
            const double t = dot(corner - rod.at, rod.along);
            carries_corner = true;
            rod.from = std::min(rod.from, t);
            rod.to = std::max(rod.to, t);
            if (t < 0) free.from = std::max(free.from, t);
            if (t > 0) free.to = std::min(free.to, t);
            std::erase_if(off_guide_, [&](Spot other) { return coincide(other, corner); });
        }
        if (!carries_corner && !corners_.empty()) hang_rod(rod, slot);
        if (rod.slot)
            cut_slot(rod, {std::max(slot.from, free.from + 4.0), std::min(slot.to, free.to - 4.0)});
        else
            shape_.bars.push_back({rod.on(rod.from), rod.on(rod.to)});
    }
    void hang_rod(Rod& rod, const Interval& slot) {
        const Spot nearest = *std::min_element(corners_.begin(), corners_.end(), [&](Spot a, Spot b) {
            return std::abs(cross(rod.along, a - rod.at)) < std::abs(cross(rod.along, b - rod.at));
        });
        const double t = dot(nearest - rod.at, rod.along);
        const Spot foot = rod.on(t);
        rod.from = std::min(rod.from, t);
        rod.to = std::max(rod.to, t);
        const double gap = rod.slot && t > slot.from && t < slot.to ? l_.measures.slot_side : 0;
        shape_.bars.push_back({nearest, gap > 0 ? foot + gap * unit(nearest - foot) : foot});
    }
    void cut_slot(const Rod& rod, const Interval& slot) {
        const double side = l_.measures.slot_side;
        shape_.slots.push_back({rod.on(slot.from), rod.on(slot.to)});
        if (rod.from < slot.from - 0.5) shape_.bars.push_back({rod.on(rod.from), rod.on(slot.from - side)});
        if (rod.to > slot.to + 0.5) shape_.bars.push_back({rod.on(rod.to), rod.on(slot.to + side)});
    }

    /// Connects the nearer end of a curved slot to the nearest corner.
    void hang_curved_slots() {
        const double side = l_.measures.slot_side;
        for (const Joint& joint : l_.mechanism.joints) {
            if (!is_curved_slot(joint) || joint.bodies[1] != body_ || corners_.empty()) continue;
            const Arc slot = l_.curved_slot(joint);
            if (slot.radius <= 0) continue;
            Bar nearest{corners_.front(), slot.centre + slot.radius * polar_spot(slot.from)};
            for (const Spot corner : corners_)
                for (const double end : {slot.from, slot.to})
                    if (const Bar bar{corner, slot.centre + slot.radius * polar_spot(end)};
                        length(bar) < length(nearest) - 1e-9)
                        nearest = bar;
            if (length(nearest) > side + 0.5)
                shape_.bars.push_back({nearest.from, nearest.to - side * direction(nearest)});
        }
    }

    /// A flat face reaches to the points on it; without such points, an arm at a right angle connects the nearest.
    void hang_flat(Flat& flat) {
        const Spot along = direction(flat.bar), start = flat.bar.from;
        double from = 0, to = length(flat.bar);
        std::optional<Bar> arm;
        bool carries_corner = false;
        for (const Spot corner : corners_) {
            const double t = dot(corner - start, along);
            if (std::abs(cross(along, corner - start)) < 0.6) {
                carries_corner = true;
                from = std::min(from, t);
                to = std::max(to, t);
            }
            const Spot foot =
                start + std::clamp(t, from, to) * along + (flat.rack ? l_.module() : flat.depth) * flat.inward;
            if (const Bar tried{corner, foot}; !arm || length(tried) < length(*arm) - 1e-9) arm = tried;
        }
        flat.bar = {start + from * along, start + to * along};
        if (carries_corner)
            flat.depth = 0;
        else if (arm && length(*arm) > l_.theme.link / 2 + 0.3)
            shape_.bars.push_back(*arm);
    }

    /// A body with two guides and no pin (Oldham coupling, trammel): the guides form one piece.
    void join_bare_guides() {
        if (!corners_.empty()) return;
        for (std::size_t i = 1; i < rods_.size(); ++i) {
            const double turn = cross(rods_[0].along, rods_[i].along);
            if (std::abs(turn) < 0.1) {
                shape_.bars.push_back({rods_[0].at, rods_[i].at});
                continue;
            }
            const Spot meet = rods_[0].on(cross(rods_[i].at - rods_[0].at, rods_[i].along) / turn);
            for (const Rod& rod : {rods_[0], rods_[i]})
                if (!coincide(meet, rod.at)) shape_.bars.push_back({rod.at, meet});
        }
    }

    /// Of a cylinder, one body has the barrel and the other the rod; both are connected to pins in line.
    void add_cylinder_parts() {
        for (const Cylinder& cylinder : l_.cylinders()) {
            const Joint& joint = l_.mechanism.joint(cylinder.joint);
            if (!joint.connects(body_)) continue;
            off_guide_.clear();
            if (joint.bodies[0] == body_) {
                shape_.bars.push_back({cylinder.rod_end, cylinder.piston});
                continue;
            }
            for (const Spot corner : corners_)
                if (dot(corner - cylinder.barrel.from, direction(cylinder.barrel)) < -1e-9)
                    shape_.bars.push_back({corner, cylinder.barrel.from});
        }
    }

    /// The remaining corners form a line or a plate, including those on a guide so that the body is connected.
    void add_body_of_corners() {
        if (off_guide_.empty() || corners_.size() < 2) return;
        const Chord chord = longest_chord(corners_);
        if (corners_.size() == 2 || chord.deviation < 0.6)
            shape_.bars.push_back(chord.bar);
        else
            shape_.plate = hull_of(corners_);
        shape_.slender = !shape_.plate.empty() && chord.deviation < 1.8 * l_.theme.link;
        shape_.solid = shape_.slender && l_.theme.body(body_).dashes.empty();
    }

    /// A bar that ends in a tip is shortened and pointed.
    void cut_knife_edges() {
        const double edge = 4.5 * l_.measures.shrink;
        for (const Joint& joint : l_.mechanism.joints) {
            if (!joint.connects(body_) || !is_tip(joint, body_)) continue;
            const Spot tip = l_.spot(joint);
            for (Bar& bar : shape_.bars)
                for (Spot Bar::*end : {&Bar::from, &Bar::to}) {
                    const Spot other = end == &Bar::from ? bar.to : bar.from;
                    if (!coincide(bar.*end, tip) || length(other - tip) < 2 * edge) continue;
                    bar.*end = tip + edge * unit(other - tip);
                    shape_.edges.push_back({bar.*end, tip});
                }
        }
    }

    Spot middle_of_shape() const {
        if (const std::vector<Spot>& plate = shape_.plate; !plate.empty()) {
            Spot sum;
            for (const Spot spot : plate) sum = sum + (1.0 / static_cast<double>(plate.size())) * spot;
            return sum;
        }
        if (!shape_.bars.empty()) return middle(longest_of(shape_.bars));
        if (!corners_.empty()) return corners_.front();
        if (!shape_.rims.empty()) return shape_.rims.front().centre;
        return shape_.flats.empty() ? Spot{} : middle(shape_.flats.front().bar);
    }

    const Layout& l_;
    BodyIndex body_;
    Shape shape_;
    std::vector<Spot> corners_;    // the points that its strokes join
    std::vector<Spot> off_guide_;  // those on none of its guides
    std::vector<Rod> rods_;
};

}  // namespace

Shape shape_of(const Layout& layout, BodyIndex body) {
    Shape shape;
    shape.rims = rims_of(layout, body);
    shape.flats = flats_of(layout, body);
    if (body == frame) return shape;
    shape = Modelling(layout, body).shape(std::move(shape));
    shape.strokes = shape.bars;
    const std::vector<Spot>& plate = shape.plate;
    for (std::size_t i = 0; i < plate.size(); ++i) shape.strokes.push_back({plate[i], plate[(i + 1) % plate.size()]});
    return shape;
}

}  // namespace kinegraph::render::drawing
