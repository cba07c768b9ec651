#include "constructions/kinematics/recipes/trials.hpp"

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::recipes {
namespace {

// The size of a trial value is free, so it is of the order of what is drawn already. On paper a much larger or smaller
// trial could not be read off, and in doubles it would be lost in rounding.
//
// The power of ten for which the length of `times(power)`, which is proportional to it, is between `longest` / 10 and
// `longest`. Both must not be zero.
template <Plane plane, class Times>
Exact power_of_ten_reaching(Board& board, VectorOn<plane> longest, Times times) {
    Exact power = 1;
    while (!board.choose_longer(times(10 * power), longest)) power = 10 * power;
    while (board.choose_longer(times(power), longest)) power = power / 10;
    return power;
}

}  // namespace

template <Plane plane>
void TrialRecipes<plane>::assume(Track<plane>& track, const Step& step) {
    if (step.node != none && !chains_.ready(track, step.first)) return;
    if (!step.closing.found()) return set_assumed(track, step, assumed_of(track, step), &step == moved_ ? 1 : 0);
    pen_.begin<plane>(step.node != none ? lang::sentences::trial_on_line : lang::sentences::trial_of_spin,
                      assumption_arguments(step), "");
    Assumed<plane> assumed = assumed_of(track, step);
    const bool is_shown = pen_.hand() == RecipePen::Hand::solution;
    if (is_shown && step.node != none) come_near(track, step, assumed);
    const std::optional<Tried> tried = carry_out_trials(track, step, assumed, is_shown);
    if (!tried) return;
    pen_.begin_spin<plane>(
        step.node != none ? none : step.body,
        step.closing.locus ? lang::sentences::trial_closes_on_line : lang::sentences::trial_closes_by_spin,
        closing_arguments(step), "");
    if (tried->ends[0] && !board_.coincide(*tried->ends[0], *tried->ends[1]))
        draw_line_of_ends(track, *tried->ends[0], *tried->ends[1]);
    if (is_shown && step.closing.locus)
        for (const int i : {0, 1})
            PolygonPen<plane>(board_, track.polygon, i + 1)
                .miss(tried->loci[i]->end, tried->loci[i]->line, *tried->ends[i]);
    settle(track, step, assumed, share_of(step, *tried));
}

template <Plane plane>
std::optional<typename TrialRecipes<plane>::Tried> TrialRecipes<plane>::carry_out_trials(const Track<plane>& track,
                                                                                         const Step& step,
                                                                                         const Assumed<plane>& assumed,
                                                                                         bool is_shown) {
    Tried tried;
    const RecipePen::Hand hand = pen_.hand();
    bool can_be_closed = true;
    for (const int i : {0, 1}) {
        pen_.take(!is_shown ? RecipePen::Hand::silent
                  : i == 0  ? RecipePen::Hand::first_trial
                            : RecipePen::Hand::second_trial);
        Track<plane> drawn = track;
        set_assumed(drawn, step, assumed, i);
        for (const Step& inner : step.trial) carry_out_(drawn, inner);
        can_be_closed = can_close(drawn, step.closing);
        tried.tips[i] = drawn.tips;
        if (!can_be_closed) break;
        if (step.closing.locus) {
            tried.missed[i] = miss(drawn, *step.closing.locus);
            tried.ends[i] = drawn.tip(step.closing.locus->node);
            tried.loci[i] = chains_.chain(drawn, *step.closing.locus);
        } else {
            tried.mismatch[i] = mismatch_of_spins(drawn, step.closing);
        }
    }
    pen_.take(hand);
    return can_be_closed ? std::optional(std::move(tried)) : std::nullopt;
}

template <Plane plane>
ScalarHandle TrialRecipes<plane>::share_of(const Step& step, const Tried& tried) {
    if (step.closing.locus) return share_by_line(tried.missed, chains_.diagram().direction(*step.closing.locus));
    return board_.quotient(tried.mismatch[0], board_.difference(tried.mismatch[0], tried.mismatch[1]));
}

/// Sets the trial values at round numbers on both sides of the true one, so near that no point of a trial is farther
/// from its true place than a third of the longest vector: else the trials would make the figure large and the solution
/// small. They are found by two trials that nobody sees; the result does not depend on them.
template <Plane plane>
void TrialRecipes<plane>::come_near(const Track<plane>& track, const Step& step, Assumed<plane>& assumed) {
    const std::optional<Tried> tried = carry_out_trials(track, step, assumed, false);
    if (!tried) return;
    const ScalarHandle share = share_of(step, *tried);
    std::optional<VectorOn<plane>> longest, farthest;  // … vector of the solution, and way between the two trials
    const auto keep_longer = [&](std::optional<VectorOn<plane>>& kept, VectorOn<plane> vector) {
        if (!kept || board_.choose_longer(vector, *kept)) kept = vector;
    };
    for (std::size_t node = 0; node < tried->tips[0].size(); ++node) {
        if (!tried->tips[0][node] || !tried->tips[1][node]) continue;
        const PointOn<plane> tip = *tried->tips[0][node];
        const auto way = board_.vector(tip, *tried->tips[1][node]);
        keep_longer(farthest, way);
        keep_longer(longest, board_.vector(board_.pole<plane>(), board_.carry(tip, board_.scale<plane>(share, way))));
    }
    if (!longest || board_.is_zero(*longest)) return;
    const auto way = board_.vector(assumed.tips[0], assumed.tips[1]);
    const auto found = board_.scale<plane>(share, way);
    const int sense = board_.choose_along(found, way) < 0 ? -1 : 1;
    const auto times = [&](const Exact& value) { return board_.scale<plane>(board_.number(value), way); };
    // The values are `step_by` and twice that, at most, from the true one.
    const auto near = board_.scale<plane>(board_.number(Exact(1) / 6), *longest);
    const auto strays = [&](const Exact& value) { return board_.scale<plane>(board_.number(value), *farthest); };
    Exact step_by = power_of_ten_reaching(board_, near, strays);
    while (!board_.choose_longer(strays(2 * step_by), near)) step_by = 2 * step_by;
    Exact below = 0, more = step_by;
    while (board_.choose_longer(found, times(more))) more = 2 * more;
    for (; more >= step_by; more = more / 2)
        if (board_.choose_longer(found, times(below + more))) below = below + more;
    assumed.tips[0] = board_.carry(assumed.line->end, times(sense * (below - step_by)));
    assumed.tips[1] = board_.carry(assumed.line->end, times(sense * (below + 2 * step_by)));
}

template <Plane plane>
VectorOn<plane> TrialRecipes<plane>::miss(Track<plane>& track, const Locus& locus) {
    const Chain<plane> drawn = chains_.chain(track, locus);
    return board_.vector(drawn.end, track.tip(locus.node));
}

template <Plane plane>
ScalarHandle TrialRecipes<plane>::mismatch_of_spins(const Track<plane>& track, const Closing& closing) {
    const ScalarHandle relative = board_.difference(track.spin(closing.body), track.spin(closing.other));
    if (closing.driver < 0) return relative;
    return board_.difference(relative, chains_.driven<plane>(closing.driver));
}

template <Plane plane>
void TrialRecipes<plane>::set_assumed(Track<plane>& track, const Step& step, const Assumed<plane>& assumed, int which) {
    if (step.node == none) {
        track.spins[at(step.body)] = assumed.spins[which];
        return;
    }
    set_on_line(track, step, *assumed.line, assumed.tips[which]);
}

template <Plane plane>
Assumed<plane> TrialRecipes<plane>::assumed_of(Track<plane>& track, const Step& step) {
    Assumed<plane> assumed;
    if (step.node == none) {
        assumed.spins[0] = board_.number(0);
        assumed.spins[1] = board_.number(1);
        return assumed;
    }
    assumed.line = chains_.chain(track, step.first);
    assumed.tips[0] = assumed.line->end;
    assumed.tips[1] = board_.carry(assumed.line->end, reach(track, chains_.diagram().direction(step.first)));
    return assumed;
}

template <Plane plane>
void TrialRecipes<plane>::draw_line_of_ends(const Track<plane>& track, PointOn<plane> first, PointOn<plane> second) {
    if (pen_.hand() != RecipePen::Hand::solution) return;
    pen_.take(RecipePen::Hand::second_trial);
    pen_.draw_line(track, board_.join(first, second), LineReason{}, {first.element, second.element});
    pen_.take(RecipePen::Hand::solution);
}

template <Plane plane>
bool TrialRecipes<plane>::can_close(const Track<plane>& track, const Closing& closing) const {
    if (!closing.locus) return track.turns(closing.body) && track.turns(closing.other);
    if (!track.has(closing.locus->node) || !chains_.ready(track, *closing.locus)) return false;
    return closing.locus->kind != Locus::Kind::image || track.turns(closing.locus->body);
}

template <Plane plane>
void TrialRecipes<plane>::set_on_line(Track<plane>& track, const Step& step, const Chain<plane>& line,
                                      PointOn<plane> tip) {
    pen_.draw_chain(track, line, tip, chains_.colour_of(step.node));
    pen_.remember_tangential(track, step.first, line, tip);
    pen_.set_tip(track, step.node, tip, !line.absolute);
}

template <Plane plane>
void TrialRecipes<plane>::settle(Track<plane>& track, const Step& step, const Assumed<plane>& assumed,
                                 ScalarHandle share) {
    if (step.node == none) {
        track.spins[at(step.body)] = board_.product(share, assumed.spins[1]);
        return;
    }
    const auto way = board_.vector(assumed.tips[0], assumed.tips[1]);
    const PointOn<plane> tip = board_.carry(assumed.tips[0], board_.scale<plane>(share, way));
    pen_.draw_line(track, assumed.line->line, assumed.line->reason, {assumed.line->end.element, tip.element});
    set_on_line(track, step, *assumed.line, tip);
}

template <Plane plane>
ScalarHandle TrialRecipes<plane>::share_by_line(const VectorOn<plane> (&missed)[2], DirectionHandle direction) {
    const PointOn<plane> pole = board_.pole<plane>();
    const PointOn<plane> first = board_.carry(pole, missed[0]), second = board_.carry(pole, missed[1]);
    const auto met = board_.meet(board_.join(first, second), board_.through(pole, direction));
    KG_ASSERT(met && !board_.is_at_infinity(*met), "the plan closes only with a condition that the assumption moves");
    return board_.ratio(board_.vector(first, *met), board_.vector(first, second));
}

template <Plane plane>
VectorOn<plane> TrialRecipes<plane>::reach(const Track<plane>& track, DirectionHandle direction) {
    const auto times = [&](const Exact& power) { return board_.scale<plane>(board_.number(power), direction); };
    std::optional<VectorOn<plane>> longest;
    for (const auto& tip : track.tips) {
        if (!tip) continue;
        const auto vector = board_.vector(board_.pole<plane>(), *tip);
        if (!longest || board_.choose_longer(vector, *longest)) longest = vector;
    }
    if (!longest || board_.is_zero(*longest)) return times(1);
    return times(power_of_ten_reaching(board_, *longest, times));
}

template <Plane plane>
std::vector<Argument> TrialRecipes<plane>::assumption_arguments(const Step& step) {
    // See assumed_of().
    if (step.node == none)
        return {pen_.spin_of<plane>(step.body), std::string(plane == Plane::velocity ? "1 rad/s" : "1 rad/s²")};
    return {pen_.image<plane>(step.node), chains_.reason_of(step.first)};
}

template <Plane plane>
std::vector<Argument> TrialRecipes<plane>::closing_arguments(const Step& step) {
    const Symbol assumed = step.node != none ? pen_.image<plane>(step.node) : pen_.spin_of<plane>(step.body);
    if (!step.closing.locus)
        return {pen_.spin_of<plane>(step.closing.body), pen_.spin_of<plane>(step.closing.other), assumed};
    return {pen_.image<plane>(step.closing.locus->node), chains_.reason_of(*step.closing.locus), assumed,
            closing_error(1), closing_error(2)};
}

template class TrialRecipes<Plane::velocity>;
template class TrialRecipes<Plane::acceleration>;

}  // namespace kinegraph::recipes
