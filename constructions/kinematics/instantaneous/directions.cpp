#include "constructions/kinematics/instantaneous/directions.hpp"

#include <algorithm>
#include <string>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::act {

template <Plane plane>
void Directions<plane>::combine_directions(State<plane>& state) {
    const auto is_direction = [](const Given<plane>& given) { return !given.whole; };
    const auto first = std::find_if(state.given.begin(), state.given.end(), is_direction);
    if (first == state.given.end()) return;
    const auto perpendicular = [&](const Given<plane>& given) {
        return board_.through(act_.place(given.node), board_.perpendicular(board_.direction(given.vector)));
    };
    const auto line = perpendicular(*first);
    for (auto other = first + 1; other != state.given.end(); ++other) {
        const auto met = board_.meet(line, perpendicular(*other));
        if (!met) continue;
        state.used[static_cast<std::size_t>(first - state.given.begin())] = true;
        state.used[static_cast<std::size_t>(other - state.given.begin())] = true;
        if (board_.is_at_infinity(*met)) return spin_from_parallels(state, *first, *other);
        return auxiliary_place(state, *first, *other, *met);
    }
}

template <Plane plane>
void Directions<plane>::take_second_direction(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    const auto first = std::find_if(state.given.begin(), state.given.end(),
                                    [&](const Given<plane>& each) { return each.node == parallel_base_; });
    const auto pole = board_.pole<plane>();
    const auto along = board_.direction(given.vector), other = board_.direction(first->vector);
    const Base<plane> from{first->node, act_.node(first->node).label, act_.place(first->node), pole};
    const auto join = board_.vector(from.place, act_.place(given.node));
    const auto end = board_.carry(act_.without_tangential(from, act_.place(given.node)),
                                  board_.scale<plane>(state.track.spin(act_.body_index), board_.turn(join)));
    state.used[index] = true;
    const auto own = board_.through(pole, along);
    if (board_.parallel(along, other)) {
        if (!board_.on_line(end, own)) agreement_.miss(state, given.node, first->node);
        return;
    }
    if (is_velocity<plane>) return rest_by_lines(state, given.node);
    act_.begin<plane>(lang::sentences::two_lines_acceleration,
                      {image_symbol<plane>(act_.node(given.node).label), act_.reason_of(*first), act_.reason_of(given)},
                      "Rivals");
    const auto shifted = board_.through(end, other);
    const auto met = board_.meet(shifted, own);
    KG_ASSERT(met && !board_.is_at_infinity(*met), "only lines that are not parallel are met");
    act_.draw_line(state, shifted, act_.reason_of(*first), {end.element, met->element});
    act_.draw_line(state, own, act_.reason_of(given), {pole.element, met->element});
    act_.set_tip(state, given.node, *met);
    act_.set_base(state, given.node, *met);
}

template <Plane plane>
void Directions<plane>::rest_by_lines(State<plane>& state, NodeIndex index) {
    act_.begin<plane>(lang::sentences::act_rest_by_lines, {act_.body(), act_.name(index)});
    act_.set_base(state, index, board_.pole<plane>());
    act_.set_tip(state, index, board_.pole<plane>());
    state.track.spins[at(act_.body_index)] = board_.number(0);
    if constexpr (is_velocity<plane>) {
        act_.centre.reset();
        act_.result.centre = {};
        act_.result.centre.second = act_.body_index;
    }
}

template <Plane plane>
void Directions<plane>::auxiliary_place(State<plane>& state, const Given<plane>& first, const Given<plane>& second,
                                        PointOn<Plane::drawing> met_at) {
    if constexpr (is_velocity<plane>) {
        act_.settle_centre(met_at, InstantaneousMotionFigure::Found::perpendiculars, {first.node, second.node});
        if (act_.wishes.centre)
            act_.begin_centre(lang::sentences::act_perpendiculars,
                              {act_.symbol_of_centre(), act_.name(first.node), act_.name(second.node)},
                              "Euler–Chasles");
        state.base = {none, {}, met_at, board_.pole<plane>()};
    } else {
        const std::string label = act_.free_name("S");
        const Symbol symbol{Symbol::Letter::point, label, {}};
        act_.begin<plane>(lang::sentences::auxiliary_point,
                          {symbol, act_.body(), act_.reason_of(first), act_.reason_of(second)}, "Assur");
        LineOn<plane> lines[2];
        PointOn<plane> ends[2];
        const Given<plane>* sources[2] = {&first, &second};
        for (int i = 0; i < 2; ++i) {
            ends[i] = act_.without_tangential(Base<plane>{none, {}, act_.place(sources[i]->node), board_.pole<plane>()},
                                              met_at);
            lines[i] = board_.through(ends[i], board_.direction(sources[i]->vector));
        }
        const auto met = board_.meet(lines[0], lines[1]);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that meet have directions that do");
        for (int i = 0; i < 2; ++i)
            act_.draw_line(state, lines[i], act_.reason_of(*sources[i]), {ends[i].element, met->element});
        act_.label_image(state, label, *met);
        act_.draw_vector(state, act_.absolute<plane>(label), {CarriedPlace{met_at.element, act_.body_index}, {}, none},
                         board_.pole<plane>(), *met, DrawnVector::Role::absolute);
        state.base = {none, label, met_at, *met};
    }
}

template <Plane plane>
void Directions<plane>::spin_from_parallels(State<plane>& state, const Given<plane>& first,
                                            const Given<plane>& second) {
    parallel_base_ = first.node;
    if constexpr (is_velocity<plane>) {
        state.track.spins[at(act_.body_index)] = board_.number(0);
        act_.settle_centre(board_.at_infinity(board_.perpendicular(board_.direction(first.vector))),
                           InstantaneousMotionFigure::Found::translation, {first.node, second.node});
        act_.begin_centre(lang::sentences::act_parallels, {act_.body(), act_.name(first.node), act_.name(second.node)},
                          "Rivals");
    } else {
        act_.begin_spin<plane>(
            lang::sentences::alpha_from_parallels,
            {act_.spin<plane>(), Segment{act_.node(first.node).label, act_.node(second.node).label}, act_.body()},
            "Rivals");
        // From a place of the first locus, the line ⟂ to the join meets the second locus.
        const auto pole = board_.pole<plane>();
        const auto along = board_.direction(first.vector);
        const auto locus = board_.through(pole, along);
        const PointOn<plane> from =
            act_.without_tangential(Base<plane>{none, {}, act_.place(first.node), pole}, act_.place(second.node));
        const auto turned = board_.turn(board_.vector(act_.place(first.node), act_.place(second.node)));
        const auto met = board_.meet(board_.through(from, board_.direction(turned)), locus);
        KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that coincide are no two loci");
        act_.draw_line(state, locus, act_.reason_of(first), {pole.element, met->element});
        state.track.spins[at(act_.body_index)] = board_.ratio(board_.vector(from, *met), turned);
    }
}

template class Directions<Plane::velocity>;
template class Directions<Plane::acceleration>;

}  // namespace kinegraph::act
