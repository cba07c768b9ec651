#include "constructions/statics/forces/sums.hpp"

#include <utility>

namespace kinegraph::statics {

Run Sums::add_up(std::vector<PartRun> parts) {
    Run total = known_.fresh();
    for (Reaction& reaction : total.reactions) {
        reaction = {};
        reaction.known = true;
    }
    for (PartRun& part : parts) {
        add_to(total, part.run);
    }
    total.complete = true;
    found_in_parts(total);
    total.parts = std::move(parts);
    total.summed = said_.last();
    return total;
}

void Sums::found_in_parts(Run& run) const {
    run.in_parts = true;
    for (Reaction& reaction : run.reactions) reaction.line_statement = reaction.force_statement = said_.last();
}

void Sums::add_to(Run& total, const Run& b) {
    for (std::size_t i = 0; i < b.reactions.size(); ++i) {
        Reaction& sum_of = total.reactions[i];
        sum_of.known = true;
        const Reaction& more = b.reactions[i];
        if (more.force) {
            sum_of.force = sum_of.force ? board_.add(*sum_of.force, *more.force) : *more.force;
            if (board_.is_zero(*sum_of.force)) sum_of.force.reset();
        }
        if (more.couple) {
            sum_of.couple = sum_of.couple ? board_.sum(*sum_of.couple, *more.couple) : *more.couple;
            if (board_.is_zero(*sum_of.couple)) sum_of.couple.reset();
        }
        sum_of.action.reset();
        sum_of.deduced = false;
    }
    for (const Resolved& resolved : b.order) known_.note({resolved.member}, total);
}

}  // namespace kinegraph::statics
