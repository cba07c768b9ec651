#include "constructions/kinematics/space_diagram.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {}  // namespace

PointOn<Plane::drawing> SpaceDiagram::place(NodeIndex node) {
    const Node& here = structure_.node(node);
    if (here.point != none) return board_.place(here.point);
    const auto& [first, second] = structure_.auxiliary(here.auxiliary);
    const auto met = board_.meet(perpendicular_at(first), perpendicular_at(second));
    KG_ASSERT(met, "an auxiliary point was found by two perpendiculars that differ");
    return *met;
}

LineOn<Plane::drawing> SpaceDiagram::perpendicular_at(const Locus& locus) {
    return board_.through(place(locus.holds()), board_.perpendicular(direction(locus)));
}

/// From the lower node to the higher, so that a link has the same direction from both ends.
DirectionHandle SpaceDiagram::across_join(NodeIndex a, NodeIndex b) {
    const auto [low, high] = std::minmax(a, b);
    return board_.perpendicular(board_.direction(join(low, high)));
}

DirectionHandle SpaceDiagram::direction(const Locus& locus) {
    const auto tangent = [&] { return board_.tangent(locus.joint); };
    switch (locus.kind) {
        case Locus::Kind::rotation:
        case Locus::Kind::link: return across_join(locus.base, locus.node);
        case Locus::Kind::image: return board_.perpendicular(across_join(locus.base, locus.node));
        case Locus::Kind::sleeve: return board_.guide(locus.joint);
        case Locus::Kind::slot: {
            const Joint& joint = structure_.mechanism().joints[at_index(locus.joint)];
            if (joint.pair().touches()) return tangent();
            return joint.arc != none ? board_.perpendicular(board_.normal(locus.joint)) : board_.guide(locus.joint);
        }
        case Locus::Kind::tangent: return tangent();
        case Locus::Kind::mesh: return board_.perpendicular(tangent());
        case Locus::Kind::component: return board_.perpendicular(board_.driver_direction(locus.driver));
        case Locus::Kind::driven_slide: return board_.perpendicular(board_.guide(locus.joint));
        case Locus::Kind::roll: return locus.across ? board_.perpendicular(tangent()) : tangent();
    }
    KG_ASSERT(false, "every locus has a direction");
}

}  // namespace kinegraph
