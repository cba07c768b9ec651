// Points: on a driven slide (Coriolis), by the image of a body (Rivals), in rolling contact (Euler, Savary), where two
// loci meet, and Assur's auxiliary point.
#pragma once

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

template <Plane plane>
class PointRecipes {
public:
    PointRecipes(Chains& chains, Board& board, RecipePen& pen) : chains_(chains), board_(board), pen_(pen) {}

    /// v_X = v_X* + ṡ u;  a_X = a_X* + 2 ω_j ∧ v_rel + s̈ u (Coriolis), the slide being driven.
    void slide_by_driver(Track<plane>& track, const Step& step);
    /// The image of a further point: v_X = v_C + ω ∧ CX;  a_X = a_C − ω² CX + α ∧ CX (Rivals).
    void draw_image(Track<plane>& track, const Step& step);
    /// Rolling: v_P = v_P*;  a_P = a_P* + a_PP*^n, which is ω_rel² · r₁r₂/(r₁ ± r₂) along the common normal (a line: r
    /// alone).
    void draw_rolling_point(Track<plane>& track, const Step& step);
    /// Two loci meet in the tip sought: the dyad's vector equation, closed.
    void draw_meet(Track<plane>& track, const Step& step);
    /// Assur's point S of a body with two loci: v_S has the same projection as v_X on XS, so its tip lies on the locus
    /// of X as on that of Y; for accelerations each locus is first shifted by −ω²·XS.
    void draw_auxiliary(Track<plane>& track, const Step& step);

private:
    /// Whether no point of the body has an image but the one that a step begins at: what leads on from it is drawn
    /// then, where later ones follow by similar figures.
    bool begins_image(const Track<plane>& track, const Step& step) const;
    /// Two circles curve apart where their centres are on different sides of the contact.
    RollingLever rolling_lever(const Joint& joint);
    /// Where the file asks that the motion be found through an observer, what the meet that follows is for him.
    void say_observer(const Step& step);

    Chains& chains_;
    Board& board_;
    RecipePen& pen_;
};

}  // namespace kinegraph::recipes
