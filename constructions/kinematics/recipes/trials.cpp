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
    const Assumed<plane> assumed = assumed_of(track, step);
    VectorOn<plane> missed[2];
    ScalarHandle mismatch[2];
    std::optional<PointOn<plane>> ends[2];
    std::optional<Chain<plane>> loci[2];
    const RecipePen::Hand hand = pen_.hand();
    for (const int i : {0, 1}) {
        pen_.take(hand != RecipePen::Hand::solution ? RecipePen::Hand::silent
                  : i == 0                          ? RecipePen::Hand::first_trial
                                                    : RecipePen::Hand::second_trial);
        Track<plane> drawn = track;
        set_assumed(drawn, step, assumed, i);
        for (const Step& inner : step.trial) carry_out_(drawn, inner);
        if (!can_close(drawn, step.closing)) {
            pen_.take(hand);
            return;
        }
        if (step.closing.locus) {
            missed[i] = miss(drawn, *step.closing.locus);
            ends[i] = drawn.tip(step.closing.locus->node);
            loci[i] = chains_.chain(drawn, *step.closing.locus);
        } else {
            mismatch[i] = mismatch_of_spins(drawn, step.closing);
        }
    }
    pen_.take(hand);
    pen_.begin_spin<plane>(
        step.node != none ? none : step.body,
        step.closing.locus ? lang::sentences::trial_closes_on_line : lang::sentences::trial_closes_by_spin,
        closing_arguments(step), "");
    const ScalarHandle share = step.closing.locus
                                   ? share_by_line(missed, chains_.diagram().direction(*step.closing.locus))
                                   : board_.quotient(mismatch[0], board_.difference(mismatch[0], mismatch[1]));
    if (ends[0] && !board_.coincide(*ends[0], *ends[1])) {
        draw_line_of_ends(track, *ends[0], *ends[1]);
    }
    if (pen_.hand() == RecipePen::Hand::solution && step.closing.locus)
        for (const int i : {0, 1})
            PolygonPen<plane>(board_, track.polygon, i + 1).miss(loci[i]->end, loci[i]->line, *ends[i]);
    settle(track, step, assumed, share);
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
