// The last rule: an unknown is given two values, the polygon is drawn from each as far as a condition that closes it,
// and since all is linear the true value follows from how far the two drawings miss.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

/// An unknown with its two trial values: the tip of a node on its line, or a body's ω (α).
template <Plane plane>
struct Assumed {
    std::optional<Chain<plane>> line;
    PointOn<plane> tips[2];
    ScalarHandle spins[2];
};

template <Plane plane>
class TrialRecipes {
public:
    /// How the steps of a trial are carried out.
    using CarryOut = std::function<void(Track<plane>&, const Step&)>;

    TrialRecipes(Chains& chains, Board& board, RecipePen& pen, CarryOut carry_out)
        : chains_(chains), board_(board), pen_(pen), carry_out_(std::move(carry_out)) {}

    /// The one assumption that is moved by one where none is closed yet.
    void move(const Step* assumption) { moved_ = assumption; }

    /// The last rule: one unknown is given two values, the polygon is drawn from each as far as a condition that closes
    /// it, and since all is linear the true value follows from how far the two drawings miss.
    void assume(Track<plane>& track, const Step& step);
    /// Where a trial's tip lies, seen from the place on its locus that the trial offers it.
    VectorOn<plane> miss(Track<plane>& track, const Locus& locus);
    /// By how much two angular velocities that must agree do not.
    ScalarHandle mismatch_of_spins(const Track<plane>& track, const Closing& closing);

private:
    void set_assumed(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, int which);
    Assumed<plane> assumed_of(Track<plane>& track, const Step& step);
    /// The line on which the tip moves from trial to trial, and on which the true one lies.
    void draw_line_of_ends(const Track<plane>& track, PointOn<plane> first, PointOn<plane> second);
    bool can_close(const Track<plane>& track, const Closing& closing) const;
    /// The tip of the assumed node at a place of its line.
    void set_on_line(Track<plane>& track, const Step& step, const Chain<plane>& line, PointOn<plane> tip);
    /// The true value: so many parts of the way from the first trial to the second.
    void settle(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, ScalarHandle share);
    /// The two misses set off from one point: the line of their ends meets the line through it ∥ to the locus where
    /// nothing is missed.
    ScalarHandle share_by_line(const VectorOn<plane> (&missed)[2], DirectionHandle direction);
    /// How far along a direction the second trial is set off: free to choose, so about as long as the longest vector
    /// drawn yet, in one figure.
    VectorOn<plane> reach(const Track<plane>& track, DirectionHandle direction);
    std::vector<Argument> assumption_arguments(const Step& step);
    std::vector<Argument> closing_arguments(const Step& step);

    Chains& chains_;
    Board& board_;
    RecipePen& pen_;
    CarryOut carry_out_;
    const Step* moved_ = nullptr;
};

}  // namespace kinegraph::recipes
