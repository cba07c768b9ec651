// Profiles: rims and flat faces of a body at its contacts. Owns the form of a profile on paper; the contacts come from
// the mechanism.
#include <algorithm>
#include <cmath>

#include "render/mechanism/layout.hpp"

namespace kinegraph::render::drawing {

namespace {

Rim& rim_about(std::vector<Rim>& rims, Spot centre, double radius) {
    for (Rim& rim : rims)
        if (coincide(rim.centre, centre) && std::abs(rim.radius - radius) < same_place) return rim;
    rims.push_back({Rim::Form::arc, centre, radius, false, {}});
    return rims.back();
}

/// The form of a rim according to a contact.
Rim::Form form_of(const Layout& layout, const Rim& rim, const Joint& joint, BodyIndex body) {
    if (joint.pair().meshes()) return Rim::Form::gear;
    if (joint.pair().slides() && rim.form == Rim::Form::wheel) return Rim::Form::cam;
    if (rim.form != Rim::Form::arc) return rim.form;
    if (joint.pair().rolls()) return Rim::Form::wheel;
    const std::vector<PointIndex>& corners = layout.subject.corners[at_index(body)];
    const PointIndex centre = profile_of<CircleProfile>(joint, body)->centre;
    return std::find(corners.begin(), corners.end(), centre) != corners.end() ? Rim::Form::roller : Rim::Form::arc;
}

/// Unit vector into the material: away from the other body, else against the contact force, else towards the bulk of
/// its own body.
Spot inward_of(const Layout& layout, const Joint& joint, BodyIndex body) {
    const Spot at = layout.spot(joint), inward = turned(layout.subject.tangent(joint));
    double side = dot(bulk_of(layout, joint.other_than(body), joint) - at, inward);
    if (std::abs(side) < same_place && joint.pushes)
        side = (joint.bodies[0] == body ? -1.0 : 1.0) * dot(paper_direction(*joint.pushes), inward);
    if (std::abs(side) < same_place) side = -dot(bulk_of(layout, body, joint) - at, inward);
    return side > 0 ? -1.0 * inward : inward;
}

double half_of_flat(const Layout& layout, const Joint& joint, BodyIndex body) {
    const auto* wheel = profile_of<CircleProfile>(joint, joint.other_than(body));
    if (!joint.pair().meshes() || !wheel) return 16;
    const double radius = length(layout.spot(joint) - layout.spot(wheel->centre));
    return std::max(16.0, 1.1 * std::sqrt(4 * layout.module() * radius) + 2 * pi_number * layout.module());
}

bool on_one_line(const Flat& known, const Flat& added) {
    const Spot along = direction(known.bar);
    return known.rack == added.rack && std::abs(cross(along, direction(added.bar))) < 1e-6 &&
           std::abs(cross(along, middle(added.bar) - known.bar.from)) < same_place &&
           dot(known.inward, added.inward) > 0;
}

/// Merges flats on one line.
void add_flat(std::vector<Flat>& flats, Flat added) {
    const auto known =
        std::find_if(flats.begin(), flats.end(), [&](const Flat& flat) { return on_one_line(flat, added); });
    if (known == flats.end()) {
        flats.push_back(std::move(added));
        return;
    }
    const Spot along = direction(known->bar), start = known->bar.from;
    double from = 0, to = length(known->bar);
    for (const Spot end : {added.bar.from, added.bar.to}) {
        from = std::min(from, dot(end - start, along));
        to = std::max(to, dot(end - start, along));
    }
    known->bar = {start + from * along, start + to * along};
    known->touches.push_back(added.touches.front());
}

}  // namespace

double gear_module(const Layout& layout) {
    double module = 1.25;
    for (const Joint& joint : layout.mechanism.joints)
        for (const BodyIndex body : joint.bodies)
            if (const auto* round = profile_of<CircleProfile>(joint, body); round && joint.pair().meshes())
                module = std::min(module, length(layout.spot(joint) - layout.spot(round->centre)) / 6);
    return module;
}

Spot bulk_of(const Layout& layout, BodyIndex body, const Joint& joint) {
    const Spot at = layout.spot(joint);
    if (const auto* round = profile_of<CircleProfile>(joint, body)) return layout.spot(round->centre);
    if (const auto& wheel = layout.mechanism.body(body).circle) return layout.spot(wheel->centre);
    Spot sum;
    int count = 0;
    for (const PointIndex corner : layout.subject.corners[at_index(body)])
        if (length(layout.spot(corner) - at) > same_place) {
            sum = sum + layout.spot(corner);
            ++count;
        }
    return count > 0 ? (1.0 / count) * sum : at;
}

std::vector<Rim> rims_of(const Layout& layout, BodyIndex body) {
    std::vector<Rim> rims;
    if (const auto& circle = layout.mechanism.body(body).circle)
        rim_about(rims, layout.spot(circle->centre), circle->radius.to_double() / layout.scale()).form =
            Rim::Form::wheel;
    for (const Joint& joint : layout.mechanism.joints) {
        const auto* round =
            joint.pair().touches() && joint.bodies.size() == 2 ? profile_of<CircleProfile>(joint, body) : nullptr;
        if (!round) continue;
        const Spot at = layout.spot(joint), centre = layout.spot(round->centre);
        const double radius = length(at - centre);
        if (radius < same_place) continue;
        Rim& rim = rim_about(rims, centre, radius);
        const BodyIndex other = joint.other_than(body);
        rim.touches.push_back({layout.mechanism.index_of(joint), other});
        rim.form = form_of(layout, rim, joint, body);
        // If two circles lie on the same side of the contact, the larger one encloses the smaller.
        if (const auto* within = profile_of<CircleProfile>(joint, other))
            if (const Spot inner = layout.spot(within->centre) - at;
                dot(inner, centre - at) > 0 && length(inner) < radius)
                rim.hollow = true;
    }
    return rims;
}

std::vector<Flat> flats_of(const Layout& layout, BodyIndex body) {
    std::vector<Flat> flats;
    for (const Joint& joint : layout.mechanism.joints) {
        if (!joint.pair().touches() || joint.bodies.size() != 2 || !profile_of<LineProfile>(joint, body)) continue;
        const Spot at = layout.spot(joint), along = layout.subject.tangent(joint);
        const double half = half_of_flat(layout, joint, body);
        add_flat(flats, {{at - half * along, at + half * along},
                         inward_of(layout, joint, body),
                         0.5 * layout.theme.link,
                         joint.pair().meshes(),
                         {{layout.mechanism.index_of(joint), joint.other_than(body)}}});
    }
    return flats;
}

}  // namespace kinegraph::render::drawing
