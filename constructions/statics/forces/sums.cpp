#include "constructions/statics/forces/sums.hpp"

#include <utility>

namespace kinegraph::statics {

Run Sums::add_up(std::vector<PartRun> parts) {
    Run total = known_.fresh();
    known_.fit(total);
    for (Reaction& reaction : total.reactions) {
        reaction = {};
        reaction.known = true;
    }
    for (PartRun& part : parts) {
        known_.fit(part.run);
        add_to(total, part.run, std::nullopt);
    }
    total.complete = true;
    found_in_parts(total);
    total.parts = std::move(parts);
    total.summed = said_.last();
    return total;
}

Run Sums::combine(Run a, ScalarHandle share_a, Run b, ScalarHandle share_b) {
    known_.fit(a);
    known_.fit(b);
    Run total = a;
    for (Reaction& reaction : total.reactions) {
        if (reaction.force) reaction.force = board_.scale<Plane::force>(share_a, *reaction.force);
        if (reaction.force && board_.is_zero(*reaction.force)) reaction.force.reset();
        if (reaction.couple) reaction.couple = board_.product(share_a, *reaction.couple);
    }
    add_to(total, b, share_b);
    found_in_parts(total);
    return total;
}

void Sums::gather_components(Run& run) {
    for (PartRun& part : run.parts) gather(part.run);
    gather(run);
    model_.drop_components();
}

void Sums::found_in_parts(Run& run) const {
    run.in_parts = true;
    for (Reaction& reaction : run.reactions) reaction.line_statement = reaction.force_statement = said_.last();
}

void Sums::add_to(Run& total, const Run& b, std::optional<ScalarHandle> factor) {
    for (std::size_t i = 0; i < b.reactions.size(); ++i) {
        Reaction& sum_of = total.reactions[i];
        sum_of.known = true;
        const Reaction& more = b.reactions[i];
        if (more.force) {
            const Force scaled = factor ? board_.scale<Plane::force>(*factor, *more.force) : *more.force;
            sum_of.force = sum_of.force ? board_.add(*sum_of.force, scaled) : scaled;
            if (board_.is_zero(*sum_of.force)) sum_of.force.reset();
        }
        if (more.couple) {
            const ScalarHandle scaled = factor ? board_.product(*factor, *more.couple) : *more.couple;
            sum_of.couple = sum_of.couple ? board_.sum(*sum_of.couple, scaled) : scaled;
            if (board_.is_zero(*sum_of.couple)) sum_of.couple.reset();
        }
        sum_of.action.reset();
        sum_of.deduced = false;
    }
    for (const Resolved& resolved : b.order) known_.note({resolved.member}, total);
}

void Sums::gather(Run& run) {
    known_.fit(run);
    for (std::size_t b = model_.joint_bonds(); b < model_.bonds().size(); ++b) {
        Reaction& hinge = run.reactions[at(model_.bonds()[b].part_of)];
        Reaction& part = run.reactions[b];
        if (!part.known) hinge.known = false;
        if (part.force) hinge.force = hinge.force ? board_.add(*hinge.force, *part.force) : *part.force;
        if (hinge.force && board_.is_zero(*hinge.force)) hinge.force.reset();
        part.force.reset();
    }
    run.reactions.resize(model_.joint_bonds());
}

}  // namespace kinegraph::statics
