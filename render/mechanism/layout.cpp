// Layout: positions at one scale, strokes that leave a point, and collisions near a place.
#include "render/mechanism/layout.hpp"

#include <cmath>

namespace kinegraph::render::drawing {

Layout::Layout(const Subject& of, const Theme& look, double metres_per_millimetre)
    : subject(of),
      mechanism(of.mechanism),
      theme(look),
      measures{std::clamp(of.shortest / metres_per_millimetre / 14, 0.62, 1.0)},
      scale_(metres_per_millimetre) {
    for (const Spot point : subject.points) spots_.push_back((1 / scale_) * point);
    module_ = gear_module(*this);
    cylinders_ = cylinders_in(*this);
    for (const BodyIndex body : indices_of(mechanism.bodies)) shapes_.push_back(shape_of(*this, body));
}

const Cylinder* Layout::cylinder_of(const Joint& joint) const {
    const auto found = std::find_if(cylinders_.begin(), cylinders_.end(), [&](const Cylinder& cylinder) {
        return cylinder.joint == mechanism.index_of(joint);
    });
    return found == cylinders_.end() ? nullptr : &*found;
}

BlockSize Layout::block(const Joint& slide) const {
    return slide.bodies[1] == frame ? BlockSize{measures.slider_half, measures.slider_side}
                                    : BlockSize{measures.sleeve_half, measures.sleeve_side};
}

std::vector<Spot> Layout::corners_of_block(const Joint& slide) const {
    const auto [half, side] = block(slide);
    return corners_about(spot(slide), half * guide(slide), side * turned(guide(slide)));
}

Arc Layout::curved_slot(const Joint& joint) const {
    const Spot centre = spot(joint.arc), at = spot(joint);
    const double radius = length(at - centre);
    if (radius < measures.slot_side + 0.5) return {};
    const double middle = angle_of(at - centre), half = std::min(measures.slot_half / radius, 2.6);
    return {centre, radius, middle - half, middle + half};
}

std::vector<Spot> Layout::leaving(PointIndex point) const {
    std::vector<Spot> directions;
    const Spot at = spot(point);
    for (const Shape& shape : shapes_)
        for (const auto& [from, to] : shape.strokes) {
            const Spot along = unit(to - from);
            const double run = dot(along, at - from);
            if (length(from - at) < 0.3) {
                directions.push_back(along);
            } else if (length(to - at) < 0.3) {
                directions.push_back(unit(from - to));
            } else if (std::abs(cross(along, at - from)) < 0.5 && run > 0 && run < length(to - from)) {
                directions.push_back(along);
                directions.push_back(-1.0 * along);
            }
        }
    return directions;
}

std::vector<BodyStroke> Layout::strokes_of_bodies() const {
    constexpr int chords = 16;
    std::vector<BodyStroke> strokes;
    for (const BodyIndex body : mechanism.moving_bodies()) {
        for (const Bar& stroke : shape(body).strokes) strokes.push_back({body, stroke.from, stroke.to});
        for (const Flat& flat : shape(body).flats) strokes.push_back({body, flat.bar.from, flat.bar.to});
        for (const Rim& rim : shape(body).rims) {
            const Arc round{rim.centre, rim.radius, 0, 2 * pi_number};
            for (int i = 0; i < chords && rim.form != Rim::Form::arc; ++i)
                strokes.push_back({body, round.at(i * round.to / chords), round.at((i + 1) * round.to / chords)});
        }
        for (const Joint& joint : mechanism.joints) {
            if (joint.connects(body)) strokes.push_back({body, spot(joint), spot(joint)});
            if (!joint.pair().is_sleeve() || joint.bodies[0] != body) continue;
            const std::vector<Spot> corners = corners_of_block(joint);
            for (std::size_t i = 0; i < corners.size(); ++i)
                strokes.push_back({body, corners[i], corners[(i + 1) % corners.size()]});
        }
    }
    return strokes;
}

double Layout::crowding(Spot spot, Spot besides) const {
    double crowd = 0;
    for (const Shape& shape : shapes_) {
        for (const Bar& stroke : shape.strokes) crowd += distance(spot, stroke) < theme.link / 2 + 1;
        for (const Flat& flat : shape.flats) crowd += distance(spot, flat.bar) < theme.link + 1;
        for (const Rim& rim : shape.rims)
            if (rim.form != Rim::Form::arc)
                crowd += std::abs(length(spot - rim.centre) - rim.radius) < theme.link / 2 + 1;
    }
    for (const Joint& joint : mechanism.joints) crowd += crowding_of_joint(joint, spot, besides);
    return crowd;
}

double Layout::crowding_of_joint(const Joint& joint, Spot spot, Spot besides) const {
    const Spot at = this->spot(joint), d = spot - at;
    if (joint.pair().is_sleeve()) {
        const bool on_frame = joint.bodies[1] == frame;
        const double half = on_frame ? measures.slider_half + measures.wall_beyond : measures.sleeve_half;
        const double side = on_frame ? measures.slider_side + measures.hatch_depth : measures.sleeve_side;
        return std::abs(dot(d, guide(joint))) < half + 1 && std::abs(cross(d, guide(joint))) < side + 1 ? 1 : 0;
    }
    if (coincide(at, besides)) return 0;
    if (length(d) < measures.pin_radius + 1) return 1;
    // The ground symbol of a fixed pin stands on some side of it.
    return is_fixed_pin(joint) && length(d) < measures.triangle_height + 2 ? 0.4 : 0;
}

bool Layout::lies_on(BodyIndex body, BodyIndex longer) const {
    const Shape &a = shape(body), &b = shape(longer);
    if (body == longer || a.bars.size() != 1 || b.bars.size() != 1) return false;
    for (const Joint& joint : mechanism.joints)
        if (is_slide(joint) && joint.connects(body) && joint.connects(longer)) return false;
    const Bar &p = a.bars[0], &q = b.bars[0];
    const Spot along = direction(q);
    const double whole = length(q), own = length(p);
    if (own > whole + 1e-9 || (own > whole - 1e-9 && body < longer)) return false;
    if (std::abs(cross(along, p.from - q.from)) > 0.8 || std::abs(cross(along, p.to - q.from)) > 0.8) return false;
    const double t = dot(along, p.from - q.from), u = dot(along, p.to - q.from);
    return std::min(std::max(t, u), whole) - std::max(std::min(t, u), 0.0) > 2;
}

}  // namespace kinegraph::render::drawing
