#include "constructions/kinematics/instantaneous/settling.hpp"

#include <utility>
#include <vector>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::act {

template <Plane plane>
void Settling<plane>::settle(State<plane>& state) {
    for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
        if (state.given[i].whole) take_whole(state, i);
    }
    if (!state.contradicted && !state.base) directions_.combine_directions(state);
    for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
        if (!state.given[i].whole && !state.used[i]) take_direction(state, i);
    }
    // Data not used so far must agree with the result.
    for (std::size_t i = 0; i < state.given.size() && !state.contradicted; ++i) {
        if (!state.used[i] && state.base && act_.turns(state)) agreement_.verify(state, i);
    }
    if (state.contradicted) forget(state);
}

template <Plane plane>
void Settling<plane>::forget(State<plane>& state) {
    for (const NodeIndex index : act_.structure.nodes_of(act_.body_index)) state.track.tips[at(index)].reset();
    state.track.spins[at(act_.body_index)].reset();
}

template <Plane plane>
void Settling<plane>::take_whole(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    if (!state.base) {
        act_.begin<plane>(lang::sentences::act_given, {act_.absolute<plane>(given.node)});
        const auto tip = act_.tip_of(given);
        act_.set_base(state, given.node, tip);
        act_.set_tip(state, given.node, tip);
        state.used[index] = true;
    } else if (!act_.turns(state) && !board_.coincide(state.base->place, act_.place(given.node))) {
        take_pair(state, index);
    } else {
        agreement_.verify(state, index);
    }
}

template <Plane plane>
void Settling<plane>::take_pair(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    const Base<plane>& base = *state.base;
    act_.begin<plane>(lang::sentences::act_given, {act_.absolute<plane>(given.node)});
    const auto tip = act_.tip_of(given);
    act_.set_tip(state, given.node, tip);
    state.used[index] = true;
    if (!act_.fits_rigid(base, act_.place(given.node), tip)) return agreement_.differ(state, base.node, given.node);
    std::vector<Argument> arguments{Segment{base.label, act_.node(given.node).label}, act_.absolute<plane>(base.label),
                                    act_.absolute<plane>(given.node)};
    if (!is_velocity<plane>) arguments.emplace_back(act_.spin<Plane::velocity>());
    act_.begin<plane>(either<plane>(lang::sentences::act_projections, lang::sentences::act_projections_acceleration),
                      std::move(arguments), "Rivals");
    take_spin(state, given.node, tip);
}

template <Plane plane>
void Settling<plane>::take_spin(State<plane>& state, NodeIndex index, PointOn<plane> tip) {
    const Base<plane>& base = *state.base;
    const PointOn<plane> middle = act_.without_tangential(base, act_.place(index));
    const auto tangential = board_.vector(middle, tip);
    const bool vanishes = board_.is_zero(tangential);
    if (!vanishes || !is_velocity<plane>) {
        const Seen seen{act_.carried(index), act_.carried(base), base.place.element};
        if (middle.element != base.tip.element)
            act_.draw_vector(state, act_.relative(index, base, "n"), seen, base.tip, middle, DrawnVector::Role::normal);
        act_.draw_vector(state, act_.relative(index, base, is_velocity<plane> ? "" : "t"), seen, middle, tip,
                         is_velocity<plane> ? DrawnVector::Role::relative : DrawnVector::Role::tangential);
    }
    if (vanishes && is_velocity<plane>) {
        // the sentence of the centre says it: a translation, or rest
        state.track.spins[at(act_.body_index)] = board_.number(0);
    } else {
        act_.begin_spin<plane>(either<plane>(lang::sentences::omega_from_pair, lang::sentences::alpha_from_pair),
                               {act_.spin<plane>(), act_.relative(index, base, is_velocity<plane> ? "" : "t"),
                                Segment{base.label, act_.node(index).label}, act_.body()},
                               "Rivals");
        state.track.spins[at(act_.body_index)] =
            board_.ratio(tangential, board_.turn(board_.vector(base.place, act_.place(index))));
    }
    state.second = index;
}

template <Plane plane>
void Settling<plane>::take_direction(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    const auto here = act_.place(given.node);
    if (!state.base) {
        if (act_.turns(state)) directions_.take_second_direction(state, index);
        return;
    }
    if (act_.turns(state)) return;
    const Base<plane>& base = *state.base;
    const auto along = board_.direction(given.vector);
    if (board_.coincide(base.place, here)) {
        const auto known = board_.vector(board_.pole<plane>(), base.tip);
        if (!board_.is_zero(known) && !board_.parallel(board_.direction(known), along))
            agreement_.miss(state, given.node, base.node);
        state.used[index] = true;
        return;
    }
    const auto across_join = board_.perpendicular(board_.direction(board_.vector(base.place, here)));
    const PointOn<plane> start = act_.without_tangential(base, here);
    if (board_.parallel(across_join, along)) {
        // Its projection on the join is zero for any magnitude: the direction is redundant or contradictory.
        if (!board_.on_line(start, board_.through(board_.pole<plane>(), along)))
            agreement_.differ(state, base.node, given.node);
        return;
    }
    state.used[index] = true;
    if (is_velocity<plane> && base.node == none) return directions_.rest_by_lines(state, given.node);
    const StatementIndex statement =
        act_.begin<plane>(either<plane>(lang::sentences::act_direction, lang::sentences::act_direction_acceleration),
                          {image_symbol<plane>(act_.node(given.node).label), act_.absolute<plane>(given.node),
                           Segment{base.label, act_.node(given.node).label}, act_.absolute<plane>(base.label)},
                          "Rivals");
    const auto first = board_.through(start, across_join);
    const auto second = board_.through(board_.pole<plane>(), along);
    const auto met = board_.meet(first, second);
    KG_ASSERT(met && !board_.is_at_infinity(*met), "only lines that are not parallel are met");
    board_.statement(statement).equation = equation(state, given, start.element != base.tip.element);
    act_.draw_line(state, first, act_.across(base, given.node), {start.element, met->element});
    act_.draw_line(state, second, act_.reason_of(given), {board_.pole<plane>().element, met->element});
    act_.set_tip(state, given.node, *met);
    take_spin(state, given.node, *met);
}

template <Plane plane>
Equation Settling<plane>::equation(const State<plane>& state, const Given<plane>& given, bool has_normal) const {
    const Base<plane>& base = *state.base;
    const LineReason known{LineReason::Kind::known, {}, {}};
    std::vector<Term> right{{act_.absolute<plane>(base.label), true, true, known, act_.body_index}};
    if (has_normal) {
        const LineReason along{LineReason::Kind::parallel_to_segment, base.label, act_.node(given.node).label};
        right.push_back({act_.relative(given.node, base, "n"), true, true, along, act_.body_index});
    }
    right.push_back({act_.relative(given.node, base, is_velocity<plane> ? "" : "t"), false, true,
                     act_.across(base, given.node), act_.body_index});
    return {
        {{{act_.absolute<plane>(given.node), false, true, act_.reason_of(given), act_.body_index}}, std::move(right)}};
}

template class Settling<Plane::velocity>;
template class Settling<Plane::acceleration>;

}  // namespace kinegraph::act
