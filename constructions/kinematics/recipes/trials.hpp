// Solution by two trial values, if no other rule applies. An unknown gets two values, and the polygon is drawn from
// each up to a closing condition. The problem is linear, so the closing errors give the true value (regula falsi).
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

/// An unknown with its two trial values: the tip of a node on its line, or the ω (α) of a body.
template <Plane plane>
struct Assumed {
    std::optional<Chain<plane>> line;
    PointOn<plane> tips[2];
    ScalarHandle spins[2];
};

template <Plane plane>
class TrialRecipes {
public:
    /// Function that draws one step of a trial.
    using CarryOut = std::function<void(Track<plane>&, const Step&)>;

    TrialRecipes(Chains& chains, Board& board, RecipePen& pen, CarryOut carry_out)
        : chains_(chains), board_(board), pen_(pen), carry_out_(std::move(carry_out)) {}

    /// The assumption that gets the value one; the others get zero. Used to compute a response.
    void move(const Step* assumption) { moved_ = assumption; }

    /// Gives one unknown two values, draws the polygon from each up to the closing condition, and interpolates
    /// linearly.
    void assume(Track<plane>& track, const Step& step);
    /// From the tip in a trial to a point of its locus in the same trial: the closing error.
    VectorOn<plane> miss(Track<plane>& track, const Locus& locus);
    /// Difference of two angular velocities that should be equal.
    ScalarHandle mismatch_of_spins(const Track<plane>& track, const Closing& closing);

private:
    /// What two trials come to: by how much each misses its condition.
    struct Tried {
        VectorOn<plane> missed[2];
        ScalarHandle mismatch[2];
        std::vector<std::optional<PointOn<plane>>> tips[2];  // by node
        std::optional<PointOn<plane>> ends[2];
        std::optional<Chain<plane>> loci[2];
    };
    /// Draws the polygon from both values up to the closing condition. Empty: that cannot be tested.
    std::optional<Tried> carry_out_trials(const Track<plane>& track, const Step& step, const Assumed<plane>& assumed,
                                          bool is_shown);
    /// The share of the way from the first value to the second at which the condition holds.
    ScalarHandle share_of(const Step& step, const Tried& tried);
    void come_near(const Track<plane>& track, const Step& step, Assumed<plane>& assumed);
    void set_assumed(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, int which);
    Assumed<plane> assumed_of(Track<plane>& track, const Step& step);
    /// The line on which the tip moves from trial to trial; the true tip is on it.
    void draw_line_of_ends(const Track<plane>& track, PointOn<plane> first, PointOn<plane> second);
    bool can_close(const Track<plane>& track, const Closing& closing) const;
    /// Sets the tip of the assumed node on its line.
    void set_on_line(Track<plane>& track, const Step& step, const Chain<plane>& line, PointOn<plane> tip);
    /// Sets the true value: first trial + share · (second − first).
    void settle(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, ScalarHandle share);
    /// Sets both closing errors off from one point. The line through their ends meets the parallel to the locus through
    /// that point where the error vanishes.
    ScalarHandle share_by_line(const VectorOn<plane> (&missed)[2], DirectionHandle direction);
    /// Offset of the second trial along a direction. Free to choose: a power of ten, of the order of
    /// the longest vector so far.
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
