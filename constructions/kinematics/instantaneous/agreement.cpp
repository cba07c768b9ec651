#include "constructions/kinematics/instantaneous/agreement.hpp"

#include "engine/number/assert.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::act {

template <Plane plane>
void Agreement<plane>::verify(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    state.used[index] = true;
    const PointOn<plane> tip = act_.turns(state) ? act_.image_of(state, act_.place(given.node))
                                                 : state.base->tip;  // the same place, or known by the image
    if (given.whole) {
        if (!board_.coincide(tip, act_.tip_of(given))) {
            act_.set_tip(state, given.node, act_.tip_of(given));
            return disagree(state, index);
        }
    } else {
        const auto vector = board_.vector(board_.pole<plane>(), tip);
        if (!board_.is_zero(vector) && !board_.parallel(board_.direction(vector), board_.direction(given.vector)))
            return miss(state, given.node, state.base->node);
    }
    act_.begin<plane>(lang::sentences::act_agrees, {act_.absolute<plane>(given.node)}, "Rivals");
    if (!state.track.has(given.node)) act_.set_tip(state, given.node, tip);
}

template <Plane plane>
void Agreement<plane>::differ(State<plane>& state, NodeIndex first, NodeIndex second) {
    if (first == none) return miss(state, second, first);  // an auxiliary place is not a point of the file
    state.contradicted = true;
    const Segment segment{act_.node(first).label, act_.node(second).label};
    if constexpr (is_velocity<plane>) {
        act_.result.figure.found = InstantaneousMotionFigure::Found::contradiction;
        act_.result.figure.points = {act_.node(first).point, act_.node(second).point};
        const StatementIndex statement = act_.begin<plane>(lang::sentences::act_unequal_projections, {}, "Rivals");
        const auto from = act_.place(first), to = act_.place(second);
        const auto line = board_.join(from, to);
        const auto join = board_.vector(from, to);
        const auto projection = [&](PointOn<Plane::drawing> place, NodeIndex index) {
            // Velocities are drawn with a time scale of one second; the projections too.
            const auto tip =
                board_.carry(place, board_.scale<Plane::drawing>(board_.number(1), vector_of(state, index)));
            const auto foot = board_.meet(board_.through(tip, board_.perpendicular(board_.direction(join))), line);
            KG_ASSERT(foot && !board_.is_at_infinity(*foot), "a perpendicular meets its line");
            return board_.vector(place, *foot);
        };
        const auto of_first = projection(from, first), of_second = projection(to, second);
        // The values are added once the record is evaluated.
        act_.result.figure.differing = {act_.node(first).point,
                                        act_.node(second).point,
                                        Recorded<Vector>::at(of_first.element),
                                        Recorded<Vector>::at(of_second.element),
                                        Recorded<Vector>::at(join.element),
                                        statement};
        board_.statement(statement).message.arguments = {segment, act_.absolute<plane>(first),
                                                         act_.absolute<plane>(second)};
        act_.unsolved(act_.sought<plane>(),
                      {lang::phrases::unequal_projections, {segment, act_.name(first), act_.name(second)}});
    } else {
        act_.begin<plane>(lang::sentences::act_unequal_projections_acceleration,
                          {segment, act_.absolute<plane>(first), act_.absolute<plane>(second)}, "Rivals");
        act_.unsolved(act_.sought<plane>(),
                      {lang::phrases::unequal_normal_parts, {act_.name(first), act_.name(second)}});
    }
}

template <Plane plane>
void Agreement<plane>::miss(State<plane>& state, NodeIndex index, NodeIndex against) {
    state.contradicted = true;
    act_.begin<plane>(lang::sentences::act_misses, {act_.absolute<plane>(index)}, "Rivals");
    if constexpr (is_velocity<plane>) {
        act_.result.figure.found = InstantaneousMotionFigure::Found::contradiction;
        act_.result.figure.points = {act_.node(index).point};
    }
    const bool same_place = against != none && board_.coincide(act_.place(index), act_.place(against));
    if (same_place) {
        act_.unsolved(act_.sought<plane>(), {is_velocity<plane> ? lang::phrases::two_velocities_at_one_place
                                                                : lang::phrases::two_accelerations_at_one_place,
                                             {act_.name(index), act_.name(against)}});
    } else {
        act_.unsolved(act_.sought<plane>(),
                      {is_velocity<plane> ? lang::phrases::velocity_misses : lang::phrases::acceleration_misses,
                       {act_.name(index)}});
    }
}

template <Plane plane>
void Agreement<plane>::disagree(State<plane>& state, std::size_t index) {
    const Given<plane>& given = state.given[index];
    for (std::size_t i = 0; i < index; ++i) {
        const Given<plane>& other = state.given[i];
        if (!other.whole || board_.coincide(act_.place(other.node), act_.place(given.node))) continue;
        const Base<plane> from{other.node, act_.node(other.node).label, act_.place(other.node), act_.tip_of(other)};
        if (!act_.fits_rigid(from, act_.place(given.node), act_.tip_of(given)))
            return differ(state, other.node, given.node);
    }
    miss(state, given.node, state.base->node);
}

template <Plane plane>
VectorOn<Plane::velocity> Agreement<plane>::vector_of(const State<Plane::velocity>& state, NodeIndex index) {
    for (const auto& given : state.given)
        if (given.node == index) return given.vector;
    KG_ASSERT(false, "projections are of given velocities");
}

template class Agreement<Plane::velocity>;
template class Agreement<Plane::acceleration>;

}  // namespace kinegraph::act
