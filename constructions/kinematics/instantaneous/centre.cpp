#include "constructions/kinematics/instantaneous/centre.hpp"

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::act {

void Centre::locate_centre(State<Plane::velocity>& state) {
    if (!state.base || !act_.wishes.centre || (act_.centre && !act_.turns(state))) return;
    const auto pole = board_.pole<Plane::velocity>();
    const Base<Plane::velocity>& base = *state.base;
    const auto v_base = board_.vector(pole, base.tip);
    const bool base_rests = board_.is_zero(v_base);
    const bool still = act_.turns(state) && board_.is_zero(state.track.spin(act_.body_index));
    if (still && base_rests) {
        act_.result.figure.found = InstantaneousMotionFigure::Found::rest;
        act_.result.figure.points.clear();
        act_.result.centre.everywhere = true;
        act_.result.centre.how = InstantCentre::How::velocities;
        act_.begin<Plane::velocity>(lang::sentences::act_rest, {act_.body()});
        return;
    }
    if (base_rests) return centre_at_rest(base.node);
    if (!act_.turns(state)) return;
    const NodeIndex second = state.second;
    const auto v_second = board_.vector(pole, state.track.tip(second));
    if (still) {
        act_.begin_centre(
            lang::sentences::act_translation,
            {act_.body(), act_.absolute<Plane::velocity>(base.node), act_.absolute<Plane::velocity>(second)}, "Rivals");
        act_.settle_centre(board_.at_infinity(board_.perpendicular(board_.direction(v_base))),
                           InstantaneousMotionFigure::Found::translation, {base.node, second});
        return;
    }
    if (board_.is_zero(v_second)) return centre_at_rest(second);
    const auto other = act_.place(second);
    if (board_.parallel(board_.direction(v_base), board_.direction(v_second))) {
        // The body turns, so velocities ⟂ to the join are proportional to the distance from the centre.
        const StatementIndex statement = act_.begin_centre(lang::sentences::act_tips, {}, "Euler–Chasles");
        const auto tip = [&](PointOn<Plane::drawing> from, VectorOn<Plane::velocity> velocity) {
            return board_.carry(from, board_.scale<Plane::drawing>(board_.number(1), velocity));
        };
        const auto met =
            board_.meet(board_.join(tip(base.place, v_base), tip(other, v_second)), board_.join(base.place, other));
        KG_ASSERT(met && !board_.is_at_infinity(*met), "velocities of different size have no parallel joins");
        act_.settle_centre(*met, InstantaneousMotionFigure::Found::tips, {base.node, second});
        board_.statement(statement).message.arguments = {
            act_.symbol_of_centre(), act_.absolute<Plane::velocity>(base.node), act_.absolute<Plane::velocity>(second),
            Segment{base.label, act_.node(second).label}};
        return;
    }
    const StatementIndex statement = act_.begin_centre(lang::sentences::act_perpendiculars, {}, "Euler–Chasles");
    const auto perpendicular = [&](PointOn<Plane::drawing> at_place, VectorOn<Plane::velocity> velocity) {
        return board_.through(at_place, board_.perpendicular(board_.direction(velocity)));
    };
    const auto met = board_.meet(perpendicular(base.place, v_base), perpendicular(other, v_second));
    KG_ASSERT(met && !board_.is_at_infinity(*met), "velocities that are not parallel have perpendiculars that meet");
    act_.settle_centre(*met, InstantaneousMotionFigure::Found::perpendiculars, {base.node, second});
    board_.statement(statement).message.arguments = {act_.symbol_of_centre(), act_.name(base.node), act_.name(second)};
}

void Centre::locate_acceleration_centre(const State<Plane::acceleration>& state) {
    const ScalarHandle omega = act_.result.motion.velocity.spin(act_.body_index),
                       alpha = state.track.spin(act_.body_index);
    const ScalarHandle square = board_.product(omega, omega);
    const ScalarHandle whole = board_.sum(board_.product(square, square), board_.product(alpha, alpha));
    if (board_.is_zero(whole)) return;
    act_.result.figure.acceleration_centre_name = act_.free_name("K");
    act_.result.figure.acceleration_centre_statement = act_.begin<Plane::acceleration>(
        lang::sentences::act_acceleration_centre,
        {PointName{act_.result.figure.acceleration_centre_name}, PointName{state.base->label}}, "Burmester");
    const auto a = board_.vector(board_.pole<Plane::acceleration>(), state.base->tip);
    const auto along = board_.scale<Plane::drawing>(board_.quotient(square, whole), a);
    const auto aside = board_.scale<Plane::drawing>(board_.quotient(alpha, whole), board_.turn(a));
    act_.result.figure.acceleration_centre =
        Recorded<Vector>::at(board_.carry(board_.carry(state.base->place, along), aside).element);
}

void Centre::centre_at_rest(NodeIndex index) {
    act_.settle_centre(act_.place(index), InstantaneousMotionFigure::Found::point_at_rest, {index});
    act_.begin_centre(lang::sentences::act_point_at_rest, {act_.symbol_of_centre(), act_.name(index)}, "Euler–Chasles");
}

}  // namespace kinegraph::act
