// Whether what is given once more agrees with what is known, and how it is said that it does not.
#pragma once

#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Agreement {
public:
    explicit Agreement(ActDraft& act) : act_(act), board_(act.board) {}

    /// What is given once more must be what the body has there.
    void verify(State<plane>& state, std::size_t index);
    /// Two points whose vectors no rigid body has: their projections on the join differ (of accelerations by other than
    /// ω²·XY).
    void differ(State<plane>& state, NodeIndex first, NodeIndex second);
    void miss(State<plane>& state, NodeIndex index, NodeIndex against);

private:
    /// With which of the points before does it disagree? One of them shows it by projections, unless all lie on one
    /// line.
    void disagree(State<plane>& state, std::size_t index);
    /// The vector given at a point; of a direction ⟂ to the join nothing projects.
    VectorOn<Plane::velocity> vector_of(const State<Plane::velocity>& state, NodeIndex index);

    ActDraft& act_;
    Board& board_;
};

}  // namespace kinegraph::act
