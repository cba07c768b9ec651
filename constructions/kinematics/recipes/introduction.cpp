#include "constructions/kinematics/recipes/introduction.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::recipes {

void Introduction::introduce(const Locus& locus) {
    const bool higher =
        locus.kind == Locus::Kind::link || locus.kind == Locus::Kind::tangent || locus.kind == Locus::Kind::mesh ||
        (locus.kind == Locus::Kind::slot && chains_.mechanism().joints[at(locus.joint)].pair().touches());
    if (pen_.hand() != RecipePen::Hand::solution || !higher || !introduced_.insert(locus.joint).second) return;
    const Joint& joint = chains_.mechanism().joints[at(locus.joint)];
    const PointName contact{chains_.mechanism().points[at(joint.point)].name};
    const NodeIndex pin = locus.inverse ? locus.base : locus.node;
    const BodyIndex other = joint.bodies[0] == locus.body ? joint.bodies[1] : joint.bodies[0];
    const auto equivalent = [&](EquivalentLinkage::Kind kind, BodyIndex first, BodyIndex second, NodeIndex on_first,
                                NodeIndex on_second) {
        chains_.motion().equivalents.push_back(
            {kind, locus.joint, {first, second}, {chains_.node(on_first).point, chains_.node(on_second).point}});
    };
    switch (locus.kind) {
        case Locus::Kind::link:
            pen_.begin<Plane::velocity>(
                lang::sentences::equivalent_link,
                {pen_.body(locus.body), pen_.body(other), contact, chains_.segment(locus.base, locus.node)},
                "Euler–Savary");
            return equivalent(EquivalentLinkage::Kind::link, locus.body, other, locus.node, locus.base);
        case Locus::Kind::slot: {
            const BodyIndex pins = locus.inverse ? other : locus.body;
            const bool tip = chains_.node(pin).point == joint.point;
            pen_.begin<Plane::velocity>(tip ? lang::sentences::equivalent_tip : lang::sentences::equivalent_slot,
                                        {pen_.body(pins), pen_.body(locus.guide), contact,
                                         PointName{chains_.mechanism().points[at(chains_.node(pin).point)].name}},
                                        tip ? "" : "Euler–Savary");
            return equivalent(EquivalentLinkage::Kind::slot, pins, locus.guide, pin, pin);
        }
        case Locus::Kind::mesh:
            pen_.begin<Plane::velocity>(
                lang::sentences::pitch_curves,
                {pen_.body(locus.body), pen_.body(other), contact, place_on(joint, locus.body), place_on(joint, other)},
                "");
            return;
        default:
            pen_.begin<Plane::velocity>(lang::sentences::contact_tangent,
                                        {pen_.body(locus.body), pen_.body(other), contact}, "");
    }
}

/// The name of the joint's point on this body; a star distinguishes the two bodies.
PointName Introduction::place_on(const Joint& joint, BodyIndex body) {
    return {chains_.node(chains_.structure().on(joint.point, body)).label};
}

}  // namespace kinegraph::recipes
