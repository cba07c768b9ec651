// The place of the body that is at rest, by a construction that suits the velocities at hand; and the place without
// acceleration.
#pragma once

#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

class Centre {
public:
    explicit Centre(ActDraft& act) : act_(act), board_(act.board) {}

    /// The place of the body that is at rest, by a construction that suits the velocities at hand.
    void locate_centre(State<Plane::velocity>& state);
    /// The place K without acceleration: AK = (ω² a_A + α z∧a_A) : (ω⁴ + α²).
    void locate_acceleration_centre(const State<Plane::acceleration>& state);

private:
    void centre_at_rest(NodeIndex index);

    ActDraft& act_;
    Board& board_;
};

}  // namespace kinegraph::act
