#include "constructions/statics/forces/every_equilibrium.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

namespace kinegraph::statics {

Run EveryEquilibrium::in_every_equilibrium(const std::vector<Load>& loads, Run run) {
    while (!run.complete && settle_alike(loads, run)) rules_.advance(loads, run);
    for (const Group& group : groups_in_question(model_, run)) {
        Equilibria all = equilibria(group, loads, run);
        if (!all.exist()) continue;
        run.redundant.insert(run.redundant.end(), group.begin(), group.end());
        if (all.follows_motions())
            for (const int b : in_question(group, run)) note_alike(b, all.of(b), all, run);
        else
            by_elimination(group, all, run);
    }
    return run;
}

Run EveryEquilibrium::one_by_one(const std::vector<Load>& loads, Run run) {
    is_only_ = true;
    while (!run.complete && settle_shortest(loads, run)) rules_.advance(loads, run);
    is_only_ = false;
    return run;
}

Equilibria EveryEquilibrium::equilibria(const Group& group, const std::vector<Load>& loads, const Run& run) {
    return {model_, board_,  run,
            group,  origin_, [&](MemberIndex member) { return model_.gap(member, loads, run, origin_); }};
}

std::vector<int> EveryEquilibrium::in_question(const Group& group, const Run& run) const {
    std::set<int> bonds;
    for (const MemberIndex member : group)
        for (const int b : model_.bonds_of(member))
            if (!run.reactions[at(b)].known) bonds.insert(b);
    std::vector<int> sorted(bonds.begin(), bonds.end());
    const auto rank = [&](int b) {
        const Bond& bond = model_.bonds()[at(b)];
        const bool one = bond.kind == Bond::Kind::line || bond.kind == Bond::Kind::couple;
        return bond.effort >= 0 ? 0 : one ? 1 : bond.kind == Bond::Kind::clamp ? 3 : 2;
    };
    std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return sorted;
}

bool EveryEquilibrium::settle_alike(const std::vector<Load>& loads, Run& run) {
    for (const Group& group : groups_in_question(model_, run)) {
        if (group.size() > Equilibria::most_followed) continue;
        Equilibria all = equilibria(group, loads, run);
        if (!all.exist()) continue;
        for (const int b : in_question(group, run)) {
            const Equilibria::Alike alike = all.of(b);
            if (!alike.all) continue;
            settle_by_work(b, alike, all, run);
            return true;
        }
    }
    return false;
}

bool EveryEquilibrium::settle_shortest(const std::vector<Load>& loads, Run& run) {
    // Of more bodies nobody would follow the motions; their equations are solved together.
    constexpr std::size_t most = 8;
    for (const Group& group : groups_in_question(model_, run)) {
        if (group.size() > most) continue;
        const Board::Mark start = board_.mark();
        Equilibria all = equilibria(group, loads, run);
        std::optional<std::pair<int, std::optional<DirectionHandle>>> best;
        std::size_t least = 0;
        for (const int b : all.exist() ? in_question(group, run) : std::vector<int>{}) {
            if (!all.of(b).all) continue;
            for (const auto& way : ways_of(b, group, run)) {
                const std::size_t price = price_of(taken_apart(b, way, all), all);
                if (best && price >= least) continue;
                best.emplace(b, way);
                least = price;
            }
        }
        if (best) {
            settle_by_work(best->first, taken_apart(best->first, best->second, all), all, run);
            return true;
        }
        board_.rewind(start);
    }
    return false;
}

std::vector<std::optional<DirectionHandle>> EveryEquilibrium::ways_of(int b, const Group& group, const Run& run) {
    const auto is_hinge = [&](int bond) {
        return model_.bonds()[at(bond)].kind == Bond::Kind::pin && !run.reactions[at(bond)].action;
    };
    std::vector<std::optional<DirectionHandle>> ways{std::nullopt};
    if (!is_hinge(b)) return ways;
    const PlaceOnDrawing place = model_.bonds()[at(b)].place;
    std::vector<PlaceOnDrawing> others;
    std::vector<int> beside;
    for (const MemberIndex member : {model_.bonds()[at(b)].first, model_.bonds()[at(b)].second})
        if (in(group, member))
            beside.insert(beside.end(), model_.bonds_of(member).begin(), model_.bonds_of(member).end());
    for (const int other : beside) {
        if (run.reactions[at(other)].known) continue;
        const PlaceOnDrawing there = model_.bonds()[at(other)].place;
        const auto is_there = [&](PlaceOnDrawing each) { return board_.coincide(each, there); };
        if (!is_hinge(other) || is_there(place) || std::any_of(others.begin(), others.end(), is_there)) continue;
        others.push_back(there);
        ways.emplace_back(board_.perpendicular(board_.direction(board_.vector(place, there))));
    }
    return ways;
}

Equilibria::Alike EveryEquilibrium::taken_apart(int b, const std::optional<DirectionHandle>& way, Equilibria& all) {
    return way ? all.of(b, *way) : all.of(b);
}

std::size_t EveryEquilibrium::price_of(const Equilibria::Alike& alike, Equilibria& all) const {
    // As three motions of as many bodies as are taken one by one: moments and components of bodies that move as one are
    // read off the drawing, virtual work is not.
    constexpr std::size_t of_moving_apart = 24;
    std::size_t price = 0;
    const auto add = [&](const Equilibria::Motion& motion) {
        price += motion.members.size() + (all.moves_as_one(motion) ? 0 : of_moving_apart);
    };
    for (const Equilibria::Component& each : alike.components) add(each.motion);
    if (alike.couple) add(alike.couple->motion);
    return price;
}

void EveryEquilibrium::by_elimination(const Group& group, Equilibria& all, Run& run) {
    std::vector<std::pair<int, Equilibria::Alike>> shared;
    Symbols symbols;
    for (const int b : in_question(group, run)) {
        Equilibria::Alike alike = all.of(b);
        if (alike.components.empty() && !alike.couple) continue;
        Symbol symbol = said_.symbol_on(b, cut_at(b));
        if (!alike.whole_force && !alike.components.empty())
            symbol = component_symbol(std::move(symbol), alike.components.front().direction);
        else if (alike.components.empty())
            symbol.letter = Symbol::Letter::M;
        symbols.push_back(std::move(symbol));
        shared.emplace_back(b, std::move(alike));
    }
    if (shared.empty()) return;
    said_.say_of(group, lang::sentences::elimination_alone,
                 {Count{static_cast<int>(all.equations())}, std::move(symbols)});
    for (const auto& [b, alike] : shared)
        if (alike.all)
            settle_by_work(b, alike, all, run);
        else
            note_alike(b, alike, all, run);
}

Group EveryEquilibrium::cut_at(int b) const {
    const Bond& bond = model_.bonds()[at(b)];
    return {bond.first == member_of(frame) ? bond.second : bond.first};
}

void EveryEquilibrium::settle_by_work(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
    const Group on = cut_at(b);
    const Bond& bond = model_.bonds()[at(b)];
    const bool reversed = !in(on, bond.first);
    std::optional<Force> force = said_components(b, alike, all, run);
    std::optional<ScalarHandle> couple = said_couple(b, alike, all, run);
    if (force && reversed) force = board_.negate(*force);
    if (couple && reversed) couple = board_.opposite(*couple);
    if (force && couple) return settled_.settle_with_couple(b, *force, *couple, on, run);
    if (force) return settled_.settle(b, *force, known_.place_of(b, run), on, run);
    if (couple) return settled_.settle_couple(b, *couple, on, run);
    settled_.found(b, on, run);
}

std::optional<Force> EveryEquilibrium::said_components(int b, const Equilibria::Alike& alike, Equilibria& all,
                                                       Run& run) {
    std::optional<Force> force;
    const bool apart = alike.components.size() > 1 || !alike.whole_force;  // otherwise the symbol is sufficient
    for (const Equilibria::Component& each : alike.components) {
        // That a force has no component across the line of its body is said with the line.
        if (each.vanishes && apart && run.reactions[at(b)].deduced) continue;
        const bool is_second = &each != &alike.components.front();
        Symbol symbol = said_.symbol_on(b, acting_on(b, each.motion));
        if (apart) symbol.term += (symbol.term.empty() ? "" : ",") + axis_of(alike, is_second);
        say_work(b, std::move(symbol), each.direction, each.motion, all, run);
        if (all.follows_motions()) {
            VirtualMotion& motion = run.virtual_motions.back();
            if (is_second && force)  // its other part is known by then
                for (const MemberIndex member : {model_.bonds()[at(b)].first, model_.bonds()[at(b)].second})
                    motion.known.push_back({member, *force, model_.bonds()[at(b)].place});
            if (!each.vanishes) motion.force = each.force;
        }
        if (!each.vanishes) force = force ? board_.add(*force, each.force) : each.force;
    }
    return force;
}

std::optional<ScalarHandle> EveryEquilibrium::said_couple(int b, const Equilibria::Alike& alike, Equilibria& all,
                                                          Run& run) {
    if (!alike.couple) return std::nullopt;
    Symbol symbol = said_.symbol_on(b, cut_at(b));
    symbol.letter = Symbol::Letter::M;
    say_work(b, std::move(symbol), std::nullopt, alike.couple->motion, all, run);
    if (!all.follows_motions()) return alike.couple->couple;
    run.virtual_motions.back().couple = alike.couple->couple;
    if (alike.couple->couple && !in(cut_at(b), model_.bonds()[at(b)].first))
        run.virtual_motions.back().couple = board_.opposite(*alike.couple->couple);  // with the sign of the symbol
    return alike.couple->couple;
}

/// The side of a bond on which its force acts in a motion: where the bodies move.
Group EveryEquilibrium::acting_on(int b, const Equilibria::Motion& motion) const {
    Group cut = cut_at(b);
    if (motion.members.contains(cut.front())) return cut;
    const Bond& bond = model_.bonds()[at(b)];
    for (const MemberIndex member : {bond.first, bond.second})
        if (motion.members.contains(member)) return {member};
    return cut;
}

/// Of oblique components the first is n, the second t.
std::string EveryEquilibrium::axis_of(const Equilibria::Alike& alike, bool is_second) {
    const auto [first, second] = axes(alike.components.front().direction);
    return is_second ? second : first;
}

std::pair<std::string, std::string> EveryEquilibrium::axes(DirectionHandle along) {
    if (board_.parallel(along, board_.own_direction({1, 0}))) return {"x", "y"};
    if (board_.parallel(along, board_.own_direction({0, 1}))) return {"y", "x"};
    return {"n", "t"};
}

Symbol EveryEquilibrium::component_symbol(Symbol symbol, DirectionHandle along) {
    symbol.term += (symbol.term.empty() ? "" : ",") + axes(along).first;
    return symbol;
}

void EveryEquilibrium::note_alike(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
    if (alike.components.empty() && !alike.couple) return;
    const std::optional<Force> force = said_components(b, alike, all, run);
    Reaction& reaction = run.reactions[at(b)];
    if (!alike.components.empty()) {
        reaction.alike = alike.whole_force ? Reaction::Alike::force : Reaction::Alike::component;
        reaction.force = force;
        reaction.along = alike.components.front().direction;
        std::tie(reaction.axis, reaction.across) = axes(*reaction.along);
    }
    reaction.couple = said_couple(b, alike, all, run);
    reaction.couple_alike = alike.couple.has_value();
    const bool said = !run.virtual_motions.empty() && run.virtual_motions.back().bond == b;
    reaction.force_statement = said || !all.follows_motions() ? said_.last() : reaction.line_statement;
}

void EveryEquilibrium::say_translation(const Group& moved, const Symbol& symbol, std::optional<DirectionHandle> along,
                                       DirectionHandle way) {
    if (along && board_.parallel(*along, way)) return said_.say_of(moved, told().components, {symbol});
    std::vector<Argument> arguments{symbol};
    if (const auto reason = said_.guide_along(moved, way)) arguments.emplace_back(*reason);
    said_.say_of(moved, told().translation, std::move(arguments));
}

void EveryEquilibrium::say_work(int b, Symbol symbol, std::optional<DirectionHandle> along,
                                const Equilibria::Motion& motion, Equilibria& all, Run& run) {
    if (!all.follows_motions()) return;  // one sentence for all
    VirtualMotion drawn;
    drawn.bond = b;
    drawn.sought = symbol;
    drawn.along = along;
    const bool of_bodies = std::any_of(motion.members.begin(), motion.members.end(),
                                       [&](const auto& each) { return !model_.is_pin(each.first); });
    Group moved;
    Names turning, centres, translating;
    for (const auto& [member, twist] : motion.members) {
        if (of_bodies && model_.is_pin(member)) continue;
        moved.push_back(member);
        VirtualMotion::Turning each{member, twist.turn, all.centre(twist), {}};
        if (each.centre) each.name = said_.name_at(moved, *each.centre);
        (each.centre ? turning : translating).push_back(model_.member_name(member));
        if (each.centre) centres.push_back(each.name);
        drawn.members.push_back(std::move(each));
    }
    // A common centre is named once.
    if (std::adjacent_find(centres.begin(), centres.end(), std::not_equal_to<>()) == centres.end())
        centres.resize(std::min<std::size_t>(centres.size(), 1));
    const bool as_one = of_bodies ? all.moves_as_one(motion) : moved.size() == 1;
    if (as_one && !centres.empty()) {
        said_.say_of(moved, told().moments, {PointName{centres.front()}, symbol}, "Ritter");
    } else if (as_one) {
        say_translation(moved, symbol, along, all.direction(motion.members.begin()->second));
    } else {
        said_.say(told().virtual_work, {symbol, turning, centres, translating}, "", moved);
    }
    drawn.statement = said_.last();
    if (is_only_) drawn.known = known_on(moved, run);
    if (!run.reactions[at(b)].known && run.reactions[at(b)].line_statement == none)
        run.reactions[at(b)].line_statement = said_.last();
    run.virtual_motions.push_back(std::move(drawn));
}

const EveryEquilibrium::Told& EveryEquilibrium::told() const {
    static constexpr Told shared{lang::sentences::moments_alone, lang::sentences::components_alone,
                                 lang::sentences::translation_alone, lang::sentences::virtual_work_alone},
        only{lang::sentences::moments_give, lang::sentences::components_give, lang::sentences::translation_gives,
             lang::sentences::virtual_work_gives};
    return is_only_ ? only : shared;
}

std::vector<VirtualMotion::Known> EveryEquilibrium::known_on(const Group& moved, const Run& run) const {
    std::vector<VirtualMotion::Known> known;
    for (const MemberIndex member : moved)
        for (const int b : model_.bonds_of(member)) {
            const Reaction& reaction = run.reactions[at(b)];
            if (reaction.known && reaction.force) known.push_back({member, *reaction.force, known_.place_of(b, run)});
        }
    return known;
}

}  // namespace kinegraph::statics
