// Angular velocities and accelerations: through joints and drivers, from two points of a body (Rivals), from two
// parallel loci.
#pragma once

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

template <Plane plane>
class SpinRecipes {
public:
    SpinRecipes(Chains& chains, Board& board, RecipePen& pen) : chains_(chains), board_(board), pen_(pen) {}

    /// A sleeve or a weld allows no relative rotation: ω_i = ω_j at all times, so α_i = α_j.
    void spin_by_joint(Track<plane>& track, const Step& step);
    void spin_by_driver(Track<plane>& track, const Step& step);
    /// ω = v_BA / AB, with the part of v_BA ⟂ AB; α = a_BA^t / AB (Rivals).
    void spin_from_pair(Track<plane>& track, const Step& step);
    /// Two parallel loci (S at infinity), with normal n: v_Y·n − v_X·n = ω (z ∧ XY)·n.
    void spin_from_parallels(Track<plane>& track, const Step& step);

private:
    void draw_between_tips(const Track<plane>& track, const Step& step, Statement& said);

    Chains& chains_;
    Board& board_;
    RecipePen& pen_;
};

}  // namespace kinegraph::recipes
