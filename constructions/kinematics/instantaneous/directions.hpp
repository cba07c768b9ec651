// The spin and a vector from directions only.
#pragma once

#include "constructions/kinematics/instantaneous/agreement.hpp"
#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Directions {
public:
    Directions(InstantaneousMotionDraft& act, Agreement<plane>& agreement)
        : act_(act), board_(act.board), agreement_(agreement) {}

    /// Two directions. If their perpendiculars meet, both projections of that place are known: for velocities it is the
    /// instant centre, for accelerations Assur's auxiliary point. If they are parallel, they give the spin.
    void combine_directions(State<plane>& state);
    /// The spin is known from two parallel directions; a third direction, not parallel to them, gives a vector.
    void take_second_direction(State<plane>& state, std::size_t index);
    /// The third perpendicular does not pass through the centre of the first two, so the body is at rest.
    void rest_by_lines(State<plane>& state, NodeIndex index);

private:
    void auxiliary_place(State<plane>& state, const Given<plane>& first, const Given<plane>& second,
                         PointOn<Plane::drawing> met_at);
    void spin_from_parallels(State<plane>& state, const Given<plane>& first, const Given<plane>& second);

    InstantaneousMotionDraft& act_;
    Board& board_;
    Agreement<plane>& agreement_;
    NodeIndex parallel_base_ = none;  ///< the first of two parallel directions
};

}  // namespace kinegraph::act
