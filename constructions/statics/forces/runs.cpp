#include "constructions/statics/forces/runs.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace kinegraph::statics {

Run Runs::run() {
    Run result = solve(model_.loads());
    sums_.gather_components(result);
    return result;
}

Run Runs::solve(const std::vector<Load>& loads) {
    Run direct = known_.fresh();
    rules_.advance(loads, direct);
    if (direct.complete) return direct;
    if (redundant_) return alike_.in_every_equilibrium(loads, std::move(direct));
    // Several loaded bodies: one after the other.
    Group loaded;
    for (const Load& load : loads) {
        if (!in(loaded, load.member)) loaded.push_back(load.member);
    }
    if (loaded.size() < 2) {
        Run run = direct;
        trials_.close_by_trial(loads, run, 0);
        return run.complete ? run : direct;
    }
    std::vector<PartRun> parts;
    for (const MemberIndex member : loaded) {
        std::vector<Load> own;
        std::copy_if(loads.begin(), loads.end(), std::back_inserter(own),
                     [&](const Load& load) { return load.member == member; });
        const std::string name = model_.member_name(member);
        said_.set_mark(name);
        said_.say(Sentence::superposition,
                  {BodyName{name, model_.is_pin(member) ? BodyName::As::pin : BodyName::As::body}});
        PartRun part{member, own, known_.fresh(), said_.last(), none};
        rules_.advance(own, part.run);
        if (!part.run.complete) trials_.close_by_trial(own, part.run, 0);
        said_.set_mark({});
        if (!part.run.complete) return direct;  // what the rules found without trials does not depend on the rest
        if (!parts.empty()) parts.back().end = part.first;
        parts.push_back(std::move(part));
    }
    said_.say(Sentence::superposition_sum, {});
    parts.back().end = said_.last();
    return sums_.add_up(std::move(parts));
}

}  // namespace kinegraph::statics
