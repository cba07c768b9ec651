#include "constructions/statics/forces/settling.hpp"

namespace kinegraph::statics {

void Settling::found_line(int b, Run& run) const {
    Reaction& reaction = run.reactions[at(b)];
    if (reaction.line_statement == none) reaction.line_statement = said_.last();
}

void Settling::found(int b, const Group& group, Run& run) {
    found_line(b, run);
    Reaction& reaction = run.reactions[at(b)];
    reaction.known = true;
    reaction.force_statement = said_.last();
    board_.statement(said_.last()).finds.push_back(said_.quantity_on(b, group));
}

void Settling::settle_line(int b, const Action& found, Run& run) {
    found_line(b, run);
    Reaction& reaction = run.reactions[at(b)];
    reaction.action = found;
    reaction.deduced = true;
}

void Settling::vanish(int b, const Group& group, Run& run) {
    if (model_.bonds()[at(b)].kind == Bond::Kind::guide) {
        found_line(b, run);
        run.reactions[at(b)].only_couple = true;
    } else {
        found(b, group, run);
    }
}

void Settling::settle(int b, Force force_on_group, PlaceOnDrawing place, const Group& group, Run& run) {
    const Bond& bond = model_.bonds()[at(b)];
    found(b, group, run);
    if (board_.is_zero(force_on_group)) return;
    Reaction& reaction = run.reactions[at(b)];
    reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
    if (!reaction.action) reaction.action = model_.action(place, board_.direction(*reaction.force));
    if (bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp) {
        const ScalarHandle couple = board_.moment(board_.vector(bond.place, place), *reaction.force);
        if (!board_.is_zero(couple)) reaction.couple = couple;
    }
}

void Settling::settle_with_couple(int b, Force force_on_group, ScalarHandle couple_on_group, const Group& group,
                                  Run& run) {
    const Bond& bond = model_.bonds()[at(b)];
    settle_couple(b, couple_on_group, group, run);
    if (board_.is_zero(force_on_group)) return;
    Reaction& reaction = run.reactions[at(b)];
    reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
    const PlaceOnDrawing place =
        reaction.couple ? board_.carry(bond.place, board_.arm(*reaction.couple, *reaction.force)) : bond.place;
    if (!reaction.action) reaction.action = model_.action(place, board_.direction(*reaction.force));
}

void Settling::settle_couple(int b, ScalarHandle couple_on_group, const Group& group, Run& run) {
    found(b, group, run);
    if (board_.is_zero(couple_on_group)) return;
    run.reactions[at(b)].couple =
        in(group, model_.bonds()[at(b)].first) ? couple_on_group : board_.opposite(couple_on_group);
}

}  // namespace kinegraph::statics
