// The instant centre of the body, by a construction that suits the given velocities; and the acceleration pole.
#pragma once

#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

class Centre {
public:
    explicit Centre(InstantaneousMotionDraft& act) : act_(act), board_(act.board) {}

    /// The place of the body with zero velocity.
    void locate_centre(State<Plane::velocity>& state);
    /// The place K with zero acceleration: AK = (ω² a_A + α z∧a_A) : (ω⁴ + α²).
    void locate_acceleration_centre(const State<Plane::acceleration>& state);

private:
    void centre_at_rest(NodeIndex index);

    InstantaneousMotionDraft& act_;
    Board& board_;
};

}  // namespace kinegraph::act
