#include "constructions/statics/forces/rules.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {

void Rules::advance(const std::vector<Load>& loads, Run& run) {
    std::vector<Group> all;
    // A rule that does not apply records nothing.
    const auto leads_on = [&](auto rule) {
        const Board::Mark before = board_.mark();
        const bool applied = rule();
        if (!applied) board_.rewind(before);
        return applied;
    };
    const auto any = [&](auto rule) { return std::any_of(all.begin(), all.end(), rule); };
    const auto direct = [&](const auto& group) {
        return leads_on([&] {
                   if (known_.is_whole(group)) said_.say_of(group, lang::sentences::structure_whole, {});
                   return magnitudes_.magnitudes(group, loads, run);
               }) ||
               leads_on([&] { return lines_.lines(group, loads, run, false); });
    };
    const auto beside_couples = [&](const auto& group) {
        return leads_on([&] { return lines_.lines(group, loads, run, true); });
    };
    const auto past_pins = [&](const auto& group) {
        return leads_on([&] { return lines_.through_pin(group, loads, run); });
    };
    const auto alongside = [&](const auto& group) {
        return leads_on([&] { return lines_.parallel_to_all(group, loads, run); });
    };
    do {
        all = known_.groups(run);
    } while (!known_.all_known(run) && (any(direct) || any(alongside) || any(beside_couples) || any(past_pins)));
    run.complete = known_.all_known(run);
}

Run Rules::whole(const Group& hung, std::map<MemberIndex, std::string> bars) {
    said_.speak_of_truss(std::move(bars));
    Run run = known_.fresh();
    const Board::Mark before = board_.mark();
    for (const MemberIndex member : hung) lines_.lines({member}, model_.loads(), run, false);
    bool any = false;
    for (const Group& group : known_.wholes())
        while (magnitudes_.magnitudes(group, model_.loads(), run) || lines_.lines(group, model_.loads(), run, false))
            any = true;
    if (any) return run;
    board_.rewind(before);
    return known_.fresh();
}

}  // namespace kinegraph::statics
