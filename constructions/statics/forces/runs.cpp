#include "constructions/statics/forces/runs.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace kinegraph::statics {

Run Runs::run() {
    const std::vector<Load>& loads = model_.loads();
    Run direct = known_.fresh();
    rules_.advance(loads, direct);
    if (direct.complete) return direct;
    if (determinacy_ == Determinacy::redundant)
        return alike_.in_every_equilibrium(loads, jointly_where_large(loads, std::move(direct)));
    const Board::Mark before = board_.mark();
    const ForceSentences::Mark said = said_.mark();
    if (auto sum = in_parts(loads)) return *std::move(sum);
    // What was tried in vain is not part of the solution.
    said_.rewind(said);
    board_.rewind(before);
    direct = alike_.one_by_one(loads, std::move(direct));
    // Unless it is complete by now, the equations contradict each other.
    if (determinacy_ == Determinacy::unbalanced) return direct;
    direct = jointly(loads, std::move(direct));
    return direct.complete ? direct : alike_.in_every_equilibrium(loads, std::move(direct));
}

Run Runs::jointly(const std::vector<Load>& loads, Run run) {
    while (!run.complete && joint_.advance(loads, run)) rules_.advance(loads, run);
    return run;
}

Run Runs::jointly_where_large(const std::vector<Load>& loads, Run run) {
    const std::vector<Group> groups = groups_in_question(model_, run);
    const bool large = std::any_of(groups.begin(), groups.end(),
                                   [](const Group& group) { return group.size() > Equilibria::most_followed; });
    return large ? jointly(loads, std::move(run)) : run;
}

std::optional<Run> Runs::in_parts(const std::vector<Load>& loads) {
    // More loaded bodies are not taken one after the other: the joint equations are shorter.
    constexpr std::size_t most_parts = 8;
    Group loaded;
    for (const Load& load : loads) {
        if (!in(loaded, load.member)) loaded.push_back(load.member);
    }
    if (loaded.size() < 2 || loaded.size() > most_parts) return std::nullopt;
    std::vector<PartRun> parts;
    for (const MemberIndex member : loaded) {
        std::vector<Load> own;
        std::copy_if(loads.begin(), loads.end(), std::back_inserter(own),
                     [&](const Load& load) { return load.member == member; });
        const std::string name = model_.member_name(member);
        said_.set_mark(name);
        said_.say(parts.empty() ? lang::sentences::superposition : lang::sentences::superposition_next,
                  {BodyName{name, model_.is_pin(member) ? BodyName::As::pin : BodyName::As::body}});
        PartRun part{member, own, known_.fresh(), said_.last(), none};
        rules_.advance(own, part.run);
        said_.set_mark({});
        if (!part.run.complete) return std::nullopt;
        if (!parts.empty()) parts.back().end = part.first;
        parts.push_back(std::move(part));
    }
    said_.say(lang::sentences::superposition_sum, {});
    parts.back().end = said_.last();
    return sums_.add_up(std::move(parts));
}

}  // namespace kinegraph::statics
