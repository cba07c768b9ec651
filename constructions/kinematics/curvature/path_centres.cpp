#include "constructions/kinematics/curvature/path_centres.hpp"

#include <string>
#include <utility>
#include <variant>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::curvature {
namespace {

/// Whether the body carries the straight guide, slot or profile of a joint.
bool carries_line(const Joint& joint, BodyIndex body) {
    if (joint.along) return joint.bodies[1] == body;
    const auto profile = joint.profiles.find(body);
    return profile != joint.profiles.end() && std::holds_alternative<LineProfile>(profile->second);
}

}  // namespace

void PathCentres::draw(BodyIndex body) {
    draw_acceleration_pole(body);
    for (const NodeIndex node : draft_.paths_of(body)) draw_path(body, node);
    draw_envelopes(body);
}

/// H = P + z∧PJ·ω²/α. The foot of P on JH lies on both circles.
void PathCentres::draw_acceleration_pole(BodyIndex body) {
    State& state = draft_.of(body);
    Curvature& result = state.result;
    const ScalarHandle omega = draft_.motion.velocity.spin(body), alpha = draft_.motion.acceleration.spin(body);
    result.acceleration_name = draft_.free_name("K");
    const Place pole = *state.pole, end = *state.inflection_pole;
    if (board_.is_zero(alpha)) {
        result.bresse_statement = draft_.say(body, lang::sentences::curvature_bresse_uniform,
                                             {PointName{result.inflection_name}, draft_.name(body)}, "Bresse");
        result.acceleration_name = result.inflection_name;
        result.acceleration_pole = Recorded<Vector>::at(end.element);
        return;
    }
    result.tangential_name = draft_.free_name("H");
    result.bresse_statement = draft_.say(body, lang::sentences::curvature_bresse,
                                         {PointName{result.acceleration_name}, draft_.symbol_of_pole(body),
                                          PointName{result.inflection_name}, PointName{result.tangential_name}},
                                         "Bresse");
    const Arrow aside = board_.turn(board_.vector(pole, end));
    const ScalarHandle share = board_.quotient(board_.product(omega, omega), alpha);
    const Place second = board_.carry(pole, board_.scale<Plane::drawing>(share, aside));
    result.tangential_pole = Recorded<Vector>::at(second.element);
    const Line join = board_.join(end, second);
    const auto foot = board_.meet(board_.through(pole, board_.perpendicular(board_.direction(join))), join);
    KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
    result.acceleration_pole = Recorded<Vector>::at(foot->element);
}

/// Euler–Savary: CC₀ = CP²/CW, from C towards W, the foot of J on the ray.
void PathCentres::draw_path(BodyIndex body, NodeIndex node) {
    const State& state = draft_.of(body);
    const Place pole = *state.pole, place = draft_.diagram.place(node);
    PathCentre& path = draft_.add_path(body, node);
    if (const auto known = known_.of_point(node, body)) {
        path.is_pin = true;
        if (!known->centre_name.empty()) path.name = known->centre_name;
        path.centre = Recorded<ProjectivePoint>::at(known->centre.element);
        return;
    }
    const PointName here{path.label};
    if (board_.coincide(place, pole)) {
        path.statement = draft_.say(body, lang::sentences::curvature_at_pole, {here});
        return;
    }
    path.statement =
        draft_.say(body, lang::sentences::curvature_conjugate,
                   {here, PointName{path.name}, draft_.symbol_of_pole(body), PointName{state.result.inflection_name}},
                   "Euler–Savary");
    const Line ray = board_.join(pole, place);
    const auto foot =
        board_.meet(board_.through(*state.inflection_pole, board_.perpendicular(board_.direction(ray))), ray);
    KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
    path.foot = Recorded<ProjectivePoint>::at(foot->element);
    if (board_.coincide(*foot, place)) {
        board_.statement(path.statement).message = {lang::sentences::curvature_straight, {here}};
        path.centre = Recorded<ProjectivePoint>::at(board_.at_infinity(board_.direction(ray)).element);
        return;
    }
    const Arrow to_pole = board_.vector(place, pole), to_foot = board_.vector(place, *foot);
    const Place centre = board_.carry(place, board_.scale<Plane::drawing>(board_.ratio(to_pole, to_foot), to_pole));
    path.centre = Recorded<ProjectivePoint>::at(centre.element);
}

/// For straight guides, slots and profiles on the body: with F the foot of J on the normal, the pole is the middle of F
/// and the centre of curvature.
void PathCentres::draw_envelopes(BodyIndex body) {
    for (const JointIndex index : indices_of(draft_.mechanism.joints)) {
        const Joint& joint = draft_.mechanism.joint(index);
        if (!carries_line(joint, body)) continue;
        const State& state = draft_.of(body);
        EnvelopeCentre envelope;
        envelope.joint = index;
        const std::size_t before = state.result.envelopes.size();
        envelope.name = draft_.free_name(before == 0 ? "E" : "E" + std::to_string(before + 1));
        envelope.statement =
            draft_.say(body, lang::sentences::curvature_envelope,
                       {reader_name(draft_.mechanism, joint), PointName{envelope.name}, draft_.symbol_of_pole(body)},
                       "Euler–Savary");
        const DirectionHandle along = joint.along ? board_.guide(index) : board_.tangent(index);
        const Line normal = board_.through(*state.pole, board_.perpendicular(along));
        const auto touches = board_.meet(normal, board_.through(board_.place(joint.point), along));
        const auto foot = board_.meet(normal, board_.through(*state.inflection_pole, along));
        KG_ASSERT(touches && foot, "a normal meets its line");
        envelope.touches = Recorded<Vector>::at(touches->element);
        envelope.centre = Recorded<Vector>::at(board_.carry(*state.pole, board_.vector(*foot, *state.pole)).element);
        draft_.of(body).result.envelopes.push_back(std::move(envelope));
    }
}

}  // namespace kinegraph::curvature
