// Directions alone: two whose perpendiculars meet give a place whose vector is known, parallel ones the spin; what a
// third one adds.
#pragma once

#include "constructions/kinematics/instantaneous/agreement.hpp"
#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Directions {
public:
    Directions(ActDraft& act, Agreement<plane>& agreement) : act_(act), board_(act.board), agreement_(agreement) {}

    /// Directions alone. Where the perpendiculars to two of them meet, a place of the body has both projections known:
    /// of velocities it is the centre, at rest; of accelerations Assur's auxiliary point. Parallel ones give the spin.
    void combine_directions(State<plane>& state);
    /// The spin is known from two parallel directions, a vector from a third that is not parallel to them.
    void take_second_direction(State<plane>& state, std::size_t index);
    /// A third perpendicular that does not pass through the centre of the first two: only rest has these directions.
    void rest_by_lines(State<plane>& state, NodeIndex index);

private:
    void auxiliary_place(State<plane>& state, const Given<plane>& first, const Given<plane>& second,
                         PointOn<Plane::drawing> met_at);
    void spin_from_parallels(State<plane>& state, const Given<plane>& first, const Given<plane>& second);

    ActDraft& act_;
    Board& board_;
    Agreement<plane>& agreement_;
    NodeIndex parallel_base_ = none;  ///< the first of two parallel directions
};

}  // namespace kinegraph::act
