// From the data to one vector and the spin: whole vectors first, then directions combined with them (Rivals).
#pragma once

#include "constructions/kinematics/instantaneous/directions.hpp"
#include "constructions/kinematics/instantaneous/draft.hpp"

namespace kinegraph::act {

template <Plane plane>
class Settling {
public:
    explicit Settling(InstantaneousMotionDraft& act)
        : act_(act), board_(act.board), agreement_(act), directions_(act, agreement_) {}

    void settle(State<plane>& state);

private:
    /// Discards the result of contradictory data; the polygon keeps what was drawn.
    void forget(State<plane>& state);
    void take_whole(State<plane>& state, std::size_t index);
    /// Two whole vectors: the part of their difference ⟂ to the join gives the spin.
    void take_pair(State<plane>& state, std::size_t index);
    /// ω = v_YX / XY, α = a_YX^t / XY; the parts are drawn from the base's tip.
    void take_spin(State<plane>& state, NodeIndex index, PointOn<plane> tip);
    /// A direction together with a known vector: the line from its tip ⟂ to the join meets the line from the pole along
    /// the direction.
    void take_direction(State<plane>& state, std::size_t index);
    /// v_Y = v_X + v_YX, a_Y = a_X + a_YX^n + a_YX^t, with known direction of v_Y (a_Y).
    Equation equation(const State<plane>& state, const Given<plane>& given, bool has_normal) const;

    InstantaneousMotionDraft& act_;
    Board& board_;
    Agreement<plane> agreement_;
    Directions<plane> directions_;
};

}  // namespace kinegraph::act
