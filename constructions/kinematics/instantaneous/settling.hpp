// From what is given to one vector and the spin: whole vectors first, then directions beside them (Rivals).
#pragma once

#include "constructions/kinematics/instantaneous/directions.hpp"
#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Settling {
public:
    explicit Settling(ActDraft& act) : act_(act), board_(act.board), agreement_(act), directions_(act, agreement_) {}

    void settle(State<plane>& state);

private:
    /// What contradicts itself is no result; the polygon keeps what was drawn of it.
    void forget(State<plane>& state);
    void take_whole(State<plane>& state, std::size_t index);
    /// Two whole vectors: what remains of their difference, ⟂ to the join, is the spin's.
    void take_pair(State<plane>& state, std::size_t index);
    /// ω = v_YX / XY, α = a_YX^t / XY; the parts are drawn from the base's tip.
    void take_spin(State<plane>& state, NodeIndex index, PointOn<plane> tip);
    /// A direction is of use beside a known vector: from its tip ⟂ to the join, from the pole along the direction.
    void take_direction(State<plane>& state, std::size_t index);
    /// v_Y = v_X + v_YX, a_Y = a_X + a_YX^n + a_YX^t, of v_Y the direction known.
    Equation equation(const State<plane>& state, const Given<plane>& given, bool has_normal) const;

    ActDraft& act_;
    Board& board_;
    Agreement<plane> agreement_;
    Directions<plane> directions_;
};

}  // namespace kinegraph::act
