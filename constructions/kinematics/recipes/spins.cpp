#include "constructions/kinematics/recipes/spins.hpp"

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::recipes {

template <Plane plane>
void SpinRecipes<plane>::spin_by_joint(Track<plane>& track, const Step& step) {
    if (!track.turns(step.other)) return;
    const Joint& joint = chains_.mechanism().joints[at(step.joint)];
    if (joint.pair().is_sleeve() && joint.bodies[1] == frame)
        pen_.begin_spin<plane>(
            step.body, either<plane>(lang::sentences::omega_by_fixed_guide, lang::sentences::alpha_by_fixed_guide),
            {pen_.spin_of<plane>(step.body), pen_.body(step.body), pen_.place_of(joint)}, "");
    else
        pen_.begin_spin<plane>(
            step.body,
            joint.pair().is_sleeve() ? either<plane>(lang::sentences::omega_by_sleeve, lang::sentences::alpha_by_sleeve)
                                     : either<plane>(lang::sentences::omega_by_joint, lang::sentences::alpha_by_joint),
            {pen_.spin_of<plane>(step.body), pen_.spin_of<plane>(step.other), pen_.place_of(joint)}, "");
    track.spins[at(step.body)] = track.spin(step.other);
}

template <Plane plane>
void SpinRecipes<plane>::spin_by_driver(Track<plane>& track, const Step& step) {
    if (!track.turns(step.other)) return;
    if (step.other != frame) {
        pen_.begin_spin<plane>(step.body,
                               either<plane>(lang::sentences::omega_by_driver, lang::sentences::alpha_by_driver),
                               {pen_.spin_of<plane>(step.body), pen_.spin_of<plane>(step.other)}, "");
    }
    const ScalarHandle given = chains_.driven<plane>(step.driver);
    ScalarHandle& spin = track.spins[at(step.body)].emplace(given);
    if (step.other != frame)
        spin =
            step.inverse ? board_.difference(track.spin(step.other), given) : board_.sum(track.spin(step.other), given);
    if (step.other == frame && step.inverse) spin = board_.opposite(given);
}

template <Plane plane>
void SpinRecipes<plane>::spin_from_pair(Track<plane>& track, const Step& step) {
    if (!track.has(step.base) || !track.has(step.node)) return;
    if (!is_velocity<plane> && !chains_.motion().velocity.turns(step.body)) return;
    const char* const term = is_velocity<plane> ? "" : "t";
    // Uses the symbol of the vector as drawn, possibly in the opposite sense.
    const bool drawn =
        track.tangential.contains({step.node, step.base}) || track.tangential.contains({step.base, step.node});
    const bool from_node =
        drawn ? track.tangential.contains({step.node, step.base}) : pen_.is_drawn<plane>(step.base, step.node);
    const auto still = [&](NodeIndex each) {
        return chains_.at_rest(each) || (is_velocity<plane> && !drawn && pen_.stands_still(each));
    };
    Symbol relative_symbol = still(step.base)   ? chains_.absolute<plane>(step.node, term)
                             : still(step.node) ? chains_.absolute<plane>(step.base, term)
                             : from_node        ? chains_.relative<plane>(step.base, step.node, term)
                                                : chains_.relative<plane>(step.node, step.base, term);
    const StatementIndex statement = pen_.begin_spin<plane>(
        step.body, either<plane>(lang::sentences::omega_from_pair, lang::sentences::alpha_from_pair),
        {pen_.spin_of<plane>(step.body), relative_symbol, chains_.segment(step.base, step.node), pen_.body(step.body)},
        "Rivals");
    const auto turned = board_.turn(chains_.diagram().join(step.base, step.node));
    const auto found = track.tangential.find({step.base, step.node});
    VectorOn<plane> tangential;
    if (found != track.tangential.end()) {
        tangential = found->second;
    } else {
        tangential = board_.vector(track.tip(step.base), track.tip(step.node));
        if constexpr (!is_velocity<plane>)
            tangential = board_.subtract(tangential, chains_.normal_of(step.body, step.base, step.node));
        if (!board_.is_zero(tangential) && !board_.parallel(board_.direction(tangential), board_.direction(turned))) {
            if (pen_.hand() == RecipePen::Hand::solution) {
                if (is_velocity<plane>) chains_.motion().contradictions.push_back({step.body, step.base, step.node});
                return;
            }
            // A trial need not close: the part ⟂ to the join gives ω, the other part is the closing error.
            const auto foot = board_.meet(board_.through(board_.pole<plane>(), board_.direction(turned)),
                                          board_.through(board_.carry(board_.pole<plane>(), tangential),
                                                         board_.perpendicular(board_.direction(turned))));
            tangential = board_.vector(board_.pole<plane>(), *foot);
        }
        if (pen_.hand() == RecipePen::Hand::solution && !(is_velocity<plane> && (still(step.base) || still(step.node))))
            draw_between_tips(track, step, pen_.said(statement));
    }
    track.spins[at(step.body)] = board_.ratio(tangential, turned);
}

/// The two tips were found independently: writes and draws the parts of their difference.
template <Plane plane>
void SpinRecipes<plane>::draw_between_tips(const Track<plane>& track, const Step& step, Statement& said) {
    if (pen_.drawn_between<plane>(step.node, step.base)) return;
    const bool backwards = chains_.at_rest(step.node);
    const NodeIndex from = backwards ? step.node : step.base, to = backwards ? step.base : step.node;
    const auto symbol = [&](const char* term) {
        return chains_.at_rest(from) ? chains_.absolute<plane>(to, term) : chains_.relative<plane>(to, from, term);
    };
    said.message.arguments.emplace_back(pen_.image<plane>(from));
    said.message.arguments.emplace_back(pen_.image<plane>(to));
    const Seen seen = chains_.turning(to, from);
    const PointOn<plane> tail = track.tip(from), tip = track.tip(to);
    if constexpr (is_velocity<plane>) {
        pen_.draw_vector(track, symbol(""), seen, tail, tip, step.body, DrawnVector::Role::relative);
    } else {
        const PointOn<plane> middle = board_.carry(tail, chains_.normal_of(step.body, from, to));
        said.message.arguments.emplace_back(symbol("n"));
        pen_.draw_vector(track, symbol("n"), seen, tail, middle, step.body, DrawnVector::Role::normal);
        pen_.draw_vector(track, symbol("t"), seen, middle, tip, step.body, DrawnVector::Role::tangential);
    }
}

template <Plane plane>
void SpinRecipes<plane>::spin_from_parallels(Track<plane>& track, const Step& step) {
    if (!chains_.ready(track, step.first) || !chains_.ready(track, step.second)) return;
    if (!is_velocity<plane> && !chains_.motion().velocity.turns(step.body)) return;
    pen_.begin_spin<plane>(step.body,
                           either<plane>(lang::sentences::omega_from_parallels, lang::sentences::alpha_from_parallels),
                           {pen_.spin_of<plane>(step.body), chains_.segment(step.first.holds(), step.second.holds()),
                            pen_.body(step.body)},
                           "Rivals");
    const Chain<plane> first = chains_.chain(track, step.first);
    const Chain<plane> second = chains_.chain(track, step.second);
    pen_.draw_line(track, first.line, first.reason, {first.end.element});
    pen_.draw_line(track, second.line, second.reason, {second.end.element});
    // The planner has found it on a board of its own; the record depends on it, too: elsewhere they need not be.
    const bool are_parallel = board_.parallel(board_.direction(first.line), board_.direction(second.line));
    KG_ASSERT(are_parallel, "the planner takes this step where the directions are parallel");
    // From a place of the first locus, the line ⟂ to the join (the direction of the difference sought) meets the
    // second.
    const auto join = chains_.diagram().join(step.first.holds(), step.second.holds());
    PointOn<plane> from = first.end;
    if constexpr (!is_velocity<plane>)
        from = board_.carry(from, chains_.normal_of(step.body, step.first.holds(), step.second.holds()));
    const auto turned = board_.turn(join);
    const auto met = board_.meet(board_.through(from, board_.direction(turned)), second.line);
    KG_ASSERT(met && !board_.is_at_infinity(*met), "perpendiculars that coincide are no two loci");
    track.spins[at(step.body)] = board_.ratio(board_.vector(from, *met), turned);
}

template class SpinRecipes<Plane::velocity>;
template class SpinRecipes<Plane::acceleration>;

}  // namespace kinegraph::recipes
