#include "constructions/kinematics/curvature/inflection_circle.hpp"

#include <vector>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::curvature {

bool InflectionCircle::by_known_paths(BodyIndex body) {
    const std::vector<KnownPath> known = known_.of(body);
    for (std::size_t i = 0; i < known.size(); ++i)
        for (std::size_t j = i + 1; j < known.size(); ++j) {
            if (!rays_meet(known[i], known[j])) continue;
            draw_pole_tangent(body, known[i], known[j]);
            return true;
        }
    return false;
}

bool InflectionCircle::rays_meet(const KnownPath& a, const KnownPath& b) {
    const Board::Mark before = board_.mark();
    // If both circles have the same centre, the body turns about it.
    const bool same_centre = board_.coincide(a.centre, b.centre);
    const auto met = board_.meet(board_.join(a.place, a.centre), board_.join(b.place, b.centre));
    const bool meets = !same_centre && met && !board_.is_at_infinity(*met) && !board_.coincide(*met, a.place) &&
                       !board_.coincide(*met, b.place);
    board_.rewind(before);
    return meets;
}

Argument InflectionCircle::ray_of(const KnownPath& path) {
    if (!path.centre_name.empty()) return Segment{path.label, path.centre_name};
    return LineReason{LineReason::Kind::parallel_to_normal, path.label, {}};
}

/// A centre at infinity lies on the parallel to its ray through the other one.
StatementIndex InflectionCircle::say_bobillier(BodyIndex body, const KnownPath& a, const KnownPath& b) {
    const Symbol pole = draft_.symbol_of_pole(body);
    const Segment join{a.label, b.label};
    const bool first_far = a.centre_name.empty(), second_far = b.centre_name.empty();
    if (first_far && second_far)
        return draft_.say(body, lang::sentences::curvature_bobillier_at_infinity, {pole, join, ray_of(a), ray_of(b)},
                          "Bobillier");
    const PointName meet{draft_.free_name("Q")};
    if (!first_far && !second_far)
        return draft_.say(body, lang::sentences::curvature_bobillier,
                          {pole, join, Segment{a.centre_name, b.centre_name}, ray_of(a), ray_of(b), meet}, "Bobillier");
    const KnownPath &near = first_far ? b : a, &far = first_far ? a : b;
    return draft_.say(body, lang::sentences::curvature_bobillier_one_far,
                      {pole, join, PointName{near.centre_name}, ray_of(a), ray_of(b), meet, ray_of(far)}, "Bobillier");
}

void InflectionCircle::draw_pole_tangent(BodyIndex body, const KnownPath& a, const KnownPath& b) {
    State& state = draft_.of(body);
    Curvature& result = state.result;
    const Symbol pole_symbol = draft_.symbol_of_pole(body);
    result.pole_statement =
        draft_.say(body, lang::sentences::curvature_rays, {pole_symbol, ray_of(a), ray_of(b)}, "Aronhold–Kennedy");
    const Place pole = *board_.meet(board_.join(a.place, a.centre), board_.join(b.place, b.centre));
    draft_.set_pole(state, pole);
    for (const KnownPath* path : {&a, &b})
        result.rays.push_back({path->point, path->label, path->centre_name, Recorded<Vector>::at(path->place.element),
                               Recorded<ProjectivePoint>::at(path->centre.element)});

    result.tangent_statement = say_bobillier(body, a, b);
    const auto axis_point = board_.meet(board_.join(a.place, b.place), board_.join(a.centre, b.centre));
    KG_ASSERT(axis_point, "the join of two points is that of their centres only through the pole");
    result.axis_point = Recorded<ProjectivePoint>::at(axis_point->element);
    // As directions in the complex plane t = a·b/c, up to a real factor: t = (a·c) b + (c∧a) z∧b.
    const Arrow to_a = board_.vector(pole, a.place), to_b = board_.vector(pole, b.place);
    const Arrow axis = board_.scale<Plane::drawing>(board_.number(1), board_.direction(board_.join(pole, *axis_point)));
    const ScalarHandle along = board_.moment(axis, board_.direction(board_.turn(to_a)));
    const ScalarHandle across = board_.moment(axis, board_.direction(to_a));
    const Arrow tangent =
        board_.add(board_.scale<Plane::drawing>(along, to_b), board_.scale<Plane::drawing>(across, board_.turn(to_b)));
    const Line normal = board_.through(pole, board_.perpendicular(board_.direction(tangent)));
    draw_inflection_pole(body, a, b, normal);
}

/// Euler–Savary on the first ray whose centre is not the pole: AW = AP²/AA₀; the angle at W is right.
void InflectionCircle::draw_inflection_pole(BodyIndex body, const KnownPath& a, const KnownPath& b, Line normal) {
    State& state = draft_.of(body);
    const Place pole = *state.pole;
    const bool far = a.centre_name.empty();
    // A point on the pole tangent has its centre in the pole, so its ray does not give the diameter.
    const KnownPath& path = !far && board_.coincide(a.centre, pole) ? b : a;
    const bool straight = path.centre_name.empty();
    state.result.inflection_name = draft_.free_name("J");
    const PointName end{state.result.inflection_name};
    state.result.inflection_statement =
        straight ? draft_.say(body, lang::sentences::curvature_inflection_straight,
                              {draft_.symbol_of_pole(body), PointName{path.label}, end}, "Euler–Savary")
                 : draft_.say(body, lang::sentences::curvature_inflection,
                              {draft_.symbol_of_pole(body), PointName{path.label}, PointName{path.centre_name}, end},
                              "Euler–Savary");
    Place foot = path.place;
    if (!straight) {
        const Arrow to_pole = board_.vector(path.place, pole), to_centre = board_.vector(path.place, path.centre);
        foot = board_.carry(path.place, board_.scale<Plane::drawing>(board_.ratio(to_pole, to_centre), to_pole));
    }
    const DirectionHandle ray = board_.direction(board_.vector(pole, path.place));
    const auto met = board_.meet(board_.through(foot, board_.perpendicular(ray)), normal);
    KG_ASSERT(met && !board_.is_at_infinity(*met),
              "a ray that is not the pole tangent meets the inflection circle again");
    draft_.set_inflection_pole(state, *met);
}

void InflectionCircle::by_acceleration(BodyIndex body) {
    State& state = draft_.of(body);
    const NodeIndex base = draft_.base_of(body);
    const ScalarHandle omega = draft_.motion.velocity.spin(body), alpha = draft_.motion.acceleration.spin(body);
    const ScalarHandle one = board_.number(1), square = board_.product(omega, omega);
    const std::string& label = draft_.structure.node(base).label;
    state.result.pole_statement = draft_.say(
        body, lang::sentences::curvature_pole,
        {draft_.symbol_of_pole(body), PointName{label}, motion_symbol<Plane::velocity>(label), draft_.omega(body)},
        "Euler");
    const Place from = draft_.diagram.place(base);
    const Arrow to_pole = board_.scale<Plane::drawing>(board_.quotient(one, omega), board_.turn(draft_.velocity(base)));
    const Place pole = board_.carry(from, to_pole);
    const auto normal = board_.scale<Plane::acceleration>(board_.opposite(square), to_pole);
    const auto tangential = board_.scale<Plane::acceleration>(alpha, board_.turn(to_pole));
    const auto tip = board_.carry(board_.carry(draft_.motion.acceleration.tip(base), normal), tangential);
    const auto acceleration = board_.vector(board_.pole<Plane::acceleration>(), tip);
    if (board_.is_zero(acceleration)) return simple_.turn_about(body, pole, draft_.symbol_of_pole(body), "");
    draft_.set_pole(state, pole);
    state.result.inflection_name = draft_.free_name("J");
    state.result.tangent_statement = state.result.inflection_statement = draft_.say(
        body, lang::sentences::curvature_by_acceleration,
        {draft_.symbol_of_pole(body), PointName{state.result.inflection_name}, draft_.omega(body)}, "Bresse");
    draft_.set_inflection_pole(
        state, board_.carry(pole, board_.scale<Plane::drawing>(board_.quotient(one, square), acceleration)));
}

}  // namespace kinegraph::curvature
