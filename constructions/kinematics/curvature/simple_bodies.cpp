#include "constructions/kinematics/curvature/simple_bodies.hpp"
#include "lang/keys/sentences.hpp"

#include <utility>

namespace kinegraph::curvature {

bool SimpleBodies::settle(BodyIndex body) {
    CurvatureDraft::State& state = draft_.of(body);
    state.result.body = body;
    const NodeIndex base = draft_.base_of(body);
    if (board_.is_zero(draft_.motion.velocity.spin(body))) {
        if (draft_.rests(base)) {
            state.result.kind = Kind::rest;
            draft_.say(body, lang::sentences::curvature_rest, {draft_.name(body)});
            for (const NodeIndex node : draft_.paths_of(body)) draft_.add_path(body, node).centre = {};
        } else {
            translate(body, base);
        }
        return state.solved = true;
    }
    for (const NodeIndex node : draft_.structure.nodes_of(body)) {
        if (draft_.structure.node(node).point == none || !draft_.is_on_frame(node)) continue;
        turn_about(body, draft_.diagram.place(node), PointName{draft_.structure.node(node).label},
                   draft_.name_of(draft_.structure.node(node).point));
        return state.solved = true;
    }
    return false;
}

void SimpleBodies::turn_about(BodyIndex body, Place pole, Argument name_of_pole, const std::string& centre) {
    CurvatureDraft::State& state = draft_.of(body);
    state.pole = pole;
    state.result.kind = Kind::turning;
    state.result.pole = Recorded<ProjectivePoint>::at(pole.element);
    state.result.inflection_centre = Recorded<Vector>::at(pole.element);
    state.result.acceleration_pole = Recorded<Vector>::at(pole.element);
    state.result.pole_statement =
        draft_.say(body, lang::sentences::curvature_turning, {draft_.name(body), std::move(name_of_pole)});
    for (const NodeIndex node : draft_.paths_of(body)) {
        PathCentre& path = draft_.add_path(body, node);
        path.is_pin = true;
        if (!centre.empty()) path.name = centre;
        if (draft_.rests(node) || board_.coincide(draft_.diagram.place(node), pole)) continue;
        path.centre = Recorded<ProjectivePoint>::at(pole.element);
    }
}

/// If a body translates, only the accelerations give the curvature: κ = v ∧ a / v³.
void SimpleBodies::translate(BodyIndex body, NodeIndex base) {
    CurvatureDraft::State& state = draft_.of(body);
    state.result.kind = Kind::translation;
    state.result.pole_statement = draft_.say(body, lang::sentences::curvature_translation, {draft_.name(body)});
    const auto v = draft_.velocity(base);
    state.result.pole =
        Recorded<ProjectivePoint>::at(board_.at_infinity(board_.perpendicular(board_.direction(v))).element);
    const ScalarHandle one = board_.number(1);
    for (const NodeIndex node : draft_.paths_of(body)) {
        if (!draft_.motion.velocity.has(node) || !draft_.motion.acceleration.has(node)) continue;
        PathCentre& path = draft_.add_path(body, node);
        const Arrow v_here = board_.scale<Plane::drawing>(one, draft_.velocity(node));
        const Arrow a_here = board_.scale<Plane::drawing>(one, draft_.acceleration(node));
        const bool straight =
            board_.is_zero(a_here) || board_.parallel(board_.direction(v_here), board_.direction(a_here));
        const PointName here{path.label};
        if (straight) {
            path.statement = draft_.say(body, lang::sentences::curvature_by_normal_straight, {here});
            path.centre = Recorded<ProjectivePoint>::at(
                board_.at_infinity(board_.perpendicular(board_.direction(v_here))).element);
            continue;
        }
        path.statement =
            draft_.say(body, lang::sentences::curvature_by_normal, {here, PointName{path.name}}, "Huygens");
        const Arrow across = board_.turn(v_here);
        const ScalarHandle share = board_.quotient(board_.moment(v_here, board_.direction(across)),
                                                   board_.moment(v_here, board_.direction(a_here)));
        const Place centre =
            board_.carry(draft_.diagram.place(node), board_.scale<Plane::drawing>(share, board_.direction(across)));
        path.centre = Recorded<ProjectivePoint>::at(centre.element);
    }
}

}  // namespace kinegraph::curvature
