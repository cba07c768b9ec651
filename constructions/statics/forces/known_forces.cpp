#include "constructions/statics/forces/known_forces.hpp"

#include <algorithm>

namespace kinegraph::statics {

Run KnownForces::fresh() const {
    Run run;
    run.reactions.resize(model_.bonds().size());
    for (std::size_t b = 0; b < model_.bonds().size(); ++b) {
        if (model_.bonds()[b].kind == Bond::Kind::line)
            run.reactions[b].action = model_.action(model_.bonds()[b].place, model_.bonds()[b].direction);
        run.reactions[b].known =
            adrift_.count(model_.bonds()[b].first) > 0 || adrift_.count(model_.bonds()[b].second) > 0;
    }
    return run;
}

Bond::Kind KnownForces::shape(int b, const Run& run) const {
    const Bond& bond = model_.bonds()[at(b)];
    const Reaction& reaction = run.reactions[at(b)];
    if (bond.kind == Bond::Kind::couple || reaction.only_couple) return Bond::Kind::couple;
    return reaction.action ? Bond::Kind::line : bond.kind;
}

std::vector<int> KnownForces::unknown_of(const Group& group, const Run& run) const {
    std::vector<int> unknown;
    for (const int b : model_.outer_bonds(group)) {
        if (!run.reactions[at(b)].known) unknown.push_back(b);
    }
    return unknown;
}

KnownForces::Unknowns KnownForces::sorted(const std::vector<int>& unknown, const Run& run) const {
    Unknowns result;
    for (const int b : unknown) {
        switch (shape(b, run)) {
            case Bond::Kind::pin: result.pins.push_back(b); break;
            case Bond::Kind::guide: result.guides.push_back(b); break;
            case Bond::Kind::line: result.fixed.push_back(b); break;
            case Bond::Kind::couple: result.couples.push_back(b); break;
            case Bond::Kind::clamp: result.clamps.push_back(b); break;
        }
    }
    return result;
}

bool KnownForces::all_known(const Run& run) const {
    return std::all_of(run.reactions.begin(), run.reactions.end(), [](const Reaction& r) { return r.known; });
}

std::vector<Group> KnownForces::groups(const Run& run) const {
    // A structure with a part already solved is not taken as one free body.
    const auto is_begun = [&](const Group& group) {
        const std::vector<int> outer = model_.outer_bonds(group);
        return std::any_of(outer.begin(), outer.end(), [&](int b) { return run.reactions[at(b)].known; });
    };
    std::vector<Group> result;
    for (const Group& whole : wholes_)
        if (!is_begun(whole)) result.push_back(whole);
    for (const MemberIndex member : model_.moving_members()) result.push_back({member});
    for (const Group& whole : wholes_)
        if (is_begun(whole)) result.push_back(whole);
    // Bodies that slide in one another, taken together; then any two with a common bond.
    for (const bool only_guides : {true, false}) {
        for (const Bond& bond : model_.bonds()) {
            if (bond.first == member_of(frame) || bond.second == member_of(frame) || bond.effort >= 0) continue;
            if (only_guides != (bond.kind == Bond::Kind::guide)) continue;
            result.push_back({std::min(bond.first, bond.second), std::max(bond.first, bond.second)});
        }
    }
    return result;
}

void KnownForces::note(const Group& group, Run& run) const {
    if (is_whole(group)) return;  // its bodies are solved later
    for (const MemberIndex member : group) {
        const bool there =
            std::any_of(run.order.begin(), run.order.end(), [&](const Resolved& r) { return r.member == member; });
        if (!there) run.order.push_back({member});
    }
}

PlaceOnDrawing KnownForces::place_of(int b, const Run& run) const {
    const Reaction& reaction = run.reactions[at(b)];
    return reaction.action ? reaction.action->place : model_.bonds()[at(b)].place;
}

}  // namespace kinegraph::statics
