#include "constructions/statics/forces/lines_of_action.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace kinegraph::statics {

bool LinesOfAction::lines(const Group& group, const std::vector<Load>& loads, Run& run, bool beside_couples) {
    const std::vector<int> unknown = known_.unknown_of(group, run);
    const auto [pins, guides, fixed, couples, clamps] = known_.sorted(unknown, run);
    if (!clamps.empty()) return false;
    const std::size_t forces = pins.size() + guides.size() + fixed.size();
    if ((pins.empty() && guides.empty()) || couples.empty() == beside_couples) return false;
    if (forces < 2 || forces > 3 || couples.size() > 1) return false;
    if (forces == 3 && (fixed.size() != 2 || !couples.empty())) return false;
    if (forces == 2 && fixed.size() == 2) return false;
    const Wrench known = model_.known_on(group, loads, run);
    if (!known.vanishes()) return false;
    note_balanced(known, group, loads, run);
    if (forces == 3) return concurrent(group, fixed, pins, guides, run);
    if (!couples.empty()) return parallel_to_other(group, pins, guides, fixed, run);
    return two_forces(group, pins, guides, fixed, run);
}

void LinesOfAction::note_balanced(const Wrench& known, const Group& group, const std::vector<Load>& loads,
                                  const Run& run) {
    balanced_.clear();
    if (!known.vanishes()) return;
    for (const Actor& actor : resultants_.actors_on(group, loads, run)) balanced_.push_back(actor.symbol);
}

void LinesOfAction::say_of_others(const Group& group, Key sentence, std::vector<Argument> arguments,
                                  const char* source) {
    if (!balanced_.empty()) arguments.emplace_back(balanced_);
    said_.say_of(group, sentence, std::move(arguments), source);
}

bool LinesOfAction::parallel_to_all(const Group& group, const std::vector<Load>& loads, Run& run) {
    const auto [pins, guides, fixed, couples, clamps] = known_.sorted(known_.unknown_of(group, run), run);
    if (pins.size() != 1 || !clamps.empty() || guides.size() + fixed.size() < 2) return false;
    const DirectionHandle along =
        fixed.empty() ? model_.bonds()[at(guides[0])].direction : run.reactions[at(fixed[0])].action->direction;
    const auto is_along = [&](DirectionHandle direction) { return board_.parallel(along, direction); };
    if (!std::all_of(fixed.begin(), fixed.end(),
                     [&](int b) { return is_along(run.reactions[at(b)].action->direction); }) ||
        !std::all_of(guides.begin(), guides.end(), [&](int b) { return is_along(model_.bonds()[at(b)].direction); }))
        return false;
    const Wrench known = model_.known_on(group, loads, run);
    if (known.force && !is_along(board_.direction(*known.force))) return false;
    note_balanced(known, group, loads, run);
    say_of_others(group, lang::sentences::three_parallel_lines, {said_.symbol_on(pins[0], group)});
    settled_.settle_line(pins[0], model_.action(model_.bonds()[at(pins[0])].place, along), run);
    return true;
}

bool LinesOfAction::through_pin(const Group& group, const std::vector<Load>& loads, Run& run) {
    const auto [pins, guides, fixed, couples, clamps] = known_.sorted(known_.unknown_of(group, run), run);
    if (pins.size() != 1 || guides.size() != 1 || !fixed.empty() || !couples.empty() || !clamps.empty()) return false;
    const Wrench known = model_.known_on(group, loads, run);
    const PlaceOnDrawing pin = model_.bonds()[at(pins[0])].place;
    if (!known.force || !board_.on_line(pin, model_.line_of(known))) return false;
    said_.say_of(group, lang::sentences::through_pin, {said_.place_name(pins[0]), said_.symbol_on(guides[0], group)});
    settled_.settle_line(guides[0], model_.action(pin, model_.bonds()[at(guides[0])].direction), run);
    return true;
}

bool LinesOfAction::two_forces(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                               const std::vector<int>& fixed, Run& run) {
    const auto join_direction = [&](PlaceOnDrawing p, PlaceOnDrawing q) {
        return board_.direction(board_.vector(p, q));
    };
    if (pins.size() == 2) {
        const Bond &one = model_.bonds()[at(pins[0])], &two = model_.bonds()[at(pins[1])];
        if (board_.coincide(one.place, two.place)) return false;
        say_of_others(group, group.size() > 1 ? lang::sentences::two_force_group : lang::sentences::two_force_body,
                      {said_.place_name(pins[0]), said_.place_name(pins[1])});
        const Action found = model_.action(one.place, join_direction(one.place, two.place));
        settled_.settle_line(pins[0], found, run);
        settled_.settle_line(pins[1], found, run);
        return true;
    }
    if (pins.size() == 1 && guides.size() == 1) {
        say_of_others(group, lang::sentences::two_force_guide,
                      {said_.place_name(pins[0]), said_.place_name(guides[0])});
        const Action found = model_.action(model_.bonds()[at(pins[0])].place, model_.bonds()[at(guides[0])].direction);
        settled_.settle_line(pins[0], found, run);
        settled_.settle_line(guides[0], found, run);
        return true;
    }
    if (pins.size() == 1 && fixed.size() == 1) {
        const Action given = *run.reactions[at(fixed[0])].action;
        if (board_.on_line(model_.bonds()[at(pins[0])].place, given.line)) {
            say_of_others(group, lang::sentences::two_force_body,
                          {said_.place_name(pins[0]), said_.place_name(fixed[0])});
            settled_.settle_line(pins[0], given, run);
            settled_.found_line(fixed[0], run);
        } else {
            say_of_others(group, lang::sentences::zero_forces, {});
            settled_.vanish(pins[0], group, run);
            settled_.vanish(fixed[0], group, run);
        }
        return true;
    }
    if (guides.size() == 2) {
        if (board_.parallel(model_.bonds()[at(guides[0])].direction, model_.bonds()[at(guides[1])].direction))
            return false;
        say_of_others(group, lang::sentences::zero_forces, {});
        settled_.vanish(guides[0], group, run);
        settled_.vanish(guides[1], group, run);
        return true;
    }
    // A guide and a line: the guide's reaction can be at any place.
    const Action given = *run.reactions[at(fixed[0])].action;
    if (board_.parallel(model_.bonds()[at(guides[0])].direction, given.direction)) {
        say_of_others(group, lang::sentences::two_force_guide,
                      {said_.place_name(fixed[0]), said_.place_name(guides[0])});
        settled_.settle_line(guides[0], given, run);
        settled_.found_line(fixed[0], run);
    } else {
        say_of_others(group, lang::sentences::zero_forces, {});
        settled_.vanish(guides[0], group, run);
        settled_.vanish(fixed[0], group, run);
    }
    return true;
}

bool LinesOfAction::parallel_to_other(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                                      const std::vector<int>& fixed, Run& run) {
    if (pins.size() != 1) return false;
    const DirectionHandle direction =
        fixed.empty() ? model_.bonds()[at(guides[0])].direction : run.reactions[at(fixed[0])].action->direction;
    say_of_others(group, lang::sentences::two_forces_and_couple, {said_.place_name(pins[0])});
    settled_.settle_line(pins[0], model_.action(model_.bonds()[at(pins[0])].place, direction), run);
    return true;
}

bool LinesOfAction::concurrent(const Group& group, const std::vector<int>& fixed, const std::vector<int>& pins,
                               const std::vector<int>& guides, Run& run) {
    const Action one = *run.reactions[at(fixed[0])].action, two = *run.reactions[at(fixed[1])].action;
    const auto met = board_.meet(one.line, two.line);
    if (!met) return false;
    const int third = pins.empty() ? guides[0] : pins[0];
    const Bond& bond = model_.bonds()[at(third)];
    const bool parallel = board_.is_at_infinity(*met);
    std::optional<Action> found;
    if (!pins.empty()) {
        if (parallel) {
            found = model_.action(bond.place, one.direction);
        } else {
            if (board_.coincide(*met, bond.place)) return false;
            found = model_.action(bond.place, board_.direction(board_.vector(*met, bond.place)));
        }
    } else {
        if (parallel) return false;
        found = model_.action(*met, bond.direction);
    }
    if (parallel) {
        say_of_others(group, lang::sentences::three_parallel_lines, {said_.symbol_on(third, group)});
    } else {
        say_of_others(group, lang::sentences::three_force_line,
                      {PointName{said_.meet_name(group, *met)}, said_.symbol_on(third, group), said_.place_name(third)},
                      "Culmann");
    }
    settled_.settle_line(third, *found, run);
    return true;
}

}  // namespace kinegraph::statics
