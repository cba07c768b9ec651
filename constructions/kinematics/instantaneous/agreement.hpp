// Whether redundant data agree with what is already known, and the sentences if they do not.
#pragma once

#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Agreement {
public:
    explicit Agreement(InstantaneousMotionDraft& act) : act_(act), board_(act.board) {}

    /// Compares a given vector or direction with the one that the body has there.
    void verify(State<plane>& state, std::size_t index);
    /// Reports two points with vectors that no rigid body has: their projections on the join differ (for accelerations
    /// by other than ω²·XY).
    void differ(State<plane>& state, NodeIndex first, NodeIndex second);
    void miss(State<plane>& state, NodeIndex index, NodeIndex against);

private:
    /// Finds an earlier point that shows the disagreement by projections. There is one unless all points lie on one
    /// line.
    void disagree(State<plane>& state, std::size_t index);
    /// The vector given at a point. A direction ⟂ to the join has no projection on it.
    VectorOn<Plane::velocity> vector_of(const State<Plane::velocity>& state, NodeIndex index);

    InstantaneousMotionDraft& act_;
    Board& board_;
};

}  // namespace kinegraph::act
