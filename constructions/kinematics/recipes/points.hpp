// Velocities and accelerations of points: on a driven slide (Coriolis), by the image of a body (Rivals), in rolling
// contact (Euler, Savary), at the intersection of two loci, and Assur's auxiliary point.
#pragma once

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

template <Plane plane>
class PointRecipes {
public:
    PointRecipes(Chains& chains, Board& board, RecipePen& pen) : chains_(chains), board_(board), pen_(pen) {}

    /// Driven slide (Coriolis).
    ///   v_X = v_X* + ṡ u,  a_X = a_X* + 2 ω_j ∧ v_rel + s̈ u
    void slide_by_driver(Track<plane>& track, const Step& step);
    /// Image of another point of a body (Rivals).
    ///   v_X = v_C + ω ∧ CX,  a_X = a_C − ω² CX + α ∧ CX
    void draw_image(Track<plane>& track, const Step& step);
    /// Points in rolling contact (Euler, Savary).
    ///   v_P = v_P*,  a_P = a_P* + a_PP*^n along the common normal
    ///   |a_PP*^n| = ω_rel² · r₁r₂/(r₁ ± r₂); if one profile is a line, ω_rel² · r
    void draw_rolling_point(Track<plane>& track, const Step& step);
    /// Intersects two loci in the tip sought: closes the vector equation of the dyad.
    void draw_meet(Track<plane>& track, const Step& step);
    /// Assur's point S of a body with two loci. v_S and v_X have the same projection on XS, so the tip of S lies on the
    /// locus of X, and likewise on that of Y. For accelerations each locus is first shifted by −ω²·XS.
    void draw_auxiliary(Track<plane>& track, const Step& step);

private:
    /// Whether `step` starts the only image of this body so far. Then all its vectors are drawn; later points follow by
    /// similar figures.
    bool begins_image(const Track<plane>& track, const Step& step) const;
    /// How the profiles of a rolling joint lie: `outside` if their centres are on different sides of the contact.
    RollingLever rolling_lever(const Joint& joint);
    /// If the file asks for an observer, says what the next intersection means as seen from there.
    void say_observer(const Step& step);

    Chains& chains_;
    Board& board_;
    RecipePen& pen_;
};

}  // namespace kinegraph::recipes
