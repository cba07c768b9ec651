#include "constructions/kinematics/curvature/known_paths.hpp"

#include <utility>

namespace kinegraph::curvature {

std::vector<KnownPath> KnownPaths::of(BodyIndex body) {
    std::vector<KnownPath> known;
    for (const NodeIndex node : draft_.paths_of(body)) {
        if (!draft_.motion.velocity.has(node) || draft_.rests(node)) continue;
        if (auto path = by_pin(node, body)) known.push_back(*std::move(path));
    }
    for (const Passage& passage : draft_.structure.passages_of(body))
        if (auto path = by_frame(passage)) known.push_back(*std::move(path));
    return known;
}

std::optional<KnownPath> KnownPaths::of_point(NodeIndex node, BodyIndex body) {
    const PointIndex point = draft_.structure.node(node).point;
    for (const Curvature::Ray& ray : draft_.of(body).result.rays)
        if (ray.point == point)
            return KnownPath{point, ray.from, ray.to, draft_.diagram.place(node), {ray.centre.element()}};
    return draft_.rests(node) ? std::nullopt : by_pin(node, body);
}

KnownPath KnownPaths::straight_path(PointIndex point, DirectionHandle along) {
    return {point, draft_.name_of(point), "", board_.place(point), board_.at_infinity(board_.perpendicular(along))};
}

/// By a pin: the other body turns about a hinge of the frame, slides on it, or is solved already.
std::optional<KnownPath> KnownPaths::by_pin(NodeIndex node, BodyIndex body) {
    const Node& here = draft_.structure.node(node);
    for (const BodyIndex other : here.bodies) {
        if (other == body || other == frame || !draft_.of(other).solved) continue;
        for (const PathCentre& path : draft_.of(other).result.points) {
            if (path.point != here.point || !path.centre) continue;
            const Place centre{path.centre.element()};
            const bool far = board_.is_at_infinity(centre);
            return KnownPath{here.point, here.label, far ? "" : path.name, draft_.diagram.place(node), centre};
        }
    }
    return std::nullopt;
}

/// A pin in a slot of the frame, or a circular profile on a profile of the frame.
std::optional<KnownPath> KnownPaths::by_frame(const Passage& passage) {
    if (passage.other != frame || passage.inverse) return std::nullopt;
    const Joint& joint = draft_.mechanism.joint(passage.joint);
    if (passage.kind == Passage::Kind::link)
        return KnownPath{passage.own, draft_.name_of(passage.own), draft_.name_of(passage.others),
                         board_.place(passage.own), board_.place(passage.others)};
    if (passage.kind != Passage::Kind::slot || joint.pair().touches()) return std::nullopt;
    if (joint.along) return straight_path(passage.own, board_.guide(passage.joint));
    return KnownPath{passage.own, draft_.name_of(passage.own), draft_.name_of(joint.arc), board_.place(passage.own),
                     board_.place(joint.arc)};
}

}  // namespace kinegraph::curvature
