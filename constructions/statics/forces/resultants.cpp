#include "constructions/statics/forces/resultants.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {
namespace {

/// Whether two loads are the inertia force and couple of one mass.
bool are_of_one_mass(const Load& one, const Load& other) {
    return one.kind == Quantity::Kind::inertia && other.kind == one.kind && one.member == other.member &&
           one.given == other.given;
}
const Load* inertia_with(const Load& load, const std::vector<Load>& loads, bool force) {
    const auto found = std::find_if(loads.begin(), loads.end(), [&](const Load& other) {
        return are_of_one_mass(load, other) && load.force.has_value() != force && other.force.has_value() == force;
    });
    return found == loads.end() ? nullptr : &*found;
}
/// The inertia force whose offset includes this couple, so that the couple is not added again.
const Load* inertia_force_with(const Load& couple, const std::vector<Load>& loads) {
    return inertia_with(couple, loads, true);
}
const Load* inertia_couple_with(const Load& force, const std::vector<Load>& loads) {
    return inertia_with(force, loads, false);
}

}  // namespace

std::vector<Actor> Resultants::actors_on(const Group& group, const std::vector<Load>& loads, const Run& run) {
    std::vector<Actor> actors;
    // For one body under all loads the sentence before says that the offset force includes the couple; otherwise the
    // couple is separate.
    const bool is_moved_before = group.size() == 1 && !said_.has_mark();
    for (const Load& load : loads) {
        if (!in(group, load.member) || ForceModel::is_inner(load, group, loads)) continue;
        if (is_moved_before && inertia_force_with(load, loads) != nullptr) continue;
        const Load* const couple = is_moved_before ? inertia_couple_with(load, loads) : nullptr;
        const PlaceOnDrawing place =
            couple != nullptr ? board_.carry(load.place, board_.arm(*couple->couple, *load.force)) : load.place;
        actors.push_back({couple != nullptr ? moved_aside(load.symbol) : load.symbol, load.force, place, -1});
    }
    for (const int b : model_.outer_bonds(group)) {
        const Bond& bond = model_.bonds()[at(b)];
        const Reaction& reaction = run.reactions[at(b)];
        if (!reaction.known || (!reaction.force && !reaction.couple)) continue;
        const MemberIndex member = in(group, bond.first) ? bond.first : bond.second;
        const Wrench wrench = model_.wrench_of(bond, reaction, member);
        Symbol symbol = said_.symbol_on(b, group);
        if (!wrench.force && bond.effort < 0) symbol.letter = Symbol::Letter::M;
        actors.push_back({std::move(symbol), wrench.force, wrench.place, b});
    }
    return actors;
}

void Resultants::say_resultant(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run) {
    const std::size_t most = known_.is_whole(group) ? 12 : 6;
    if (!known.force) return;
    const std::vector<Actor> actors = actors_on(group, loads, run);
    if (actors.size() < 2 || actors.size() > most) return;
    Sum sum{group, {}, *known.force, known.place, {}, none};
    sum.symbol = said_.resultant_symbol(group);
    Symbols forces, couples;
    Wrench alone;  // the forces, without the couples
    for (const Actor& actor : actors) {
        (actor.force ? forces : couples).push_back(actor.symbol);
        if (actor.force) alone = model_.sum(alone, {actor.force, actor.place, {}});
        if (actor.bond >= 0) sum.bonds.push_back(actor.bond);
    }
    // First the sum of the forces, then its offset for a couple, as drawn.
    const bool in_two_steps = forces.size() > 1 && couples.size() == 1 && alone.force;
    Symbols symbols = forces;
    if (!in_two_steps) symbols.insert(symbols.end(), couples.begin(), couples.end());
    said_.say_of(group, lang::sentences::known_resultant, {std::move(symbols), sum.symbol});
    sum.statement = said_.last();
    if (in_two_steps) said_.say_of(group, lang::sentences::inertia_moved, {sum.symbol, couples.front()});
    const bool is_moved = !couples.empty() && alone.force;
    if (is_moved && group.size() == 1 && !model_.is_pin(group.front()))
        run.arms.push_back({group.front(), alone.place, *known.force, known.place, said_.last(), true});
    run.sums.push_back(std::move(sum));
}

Symbol Resultants::symbol_of_known(const Group& group, const std::vector<Load>& loads, const Run& run) {
    const std::vector<Actor> actors = actors_on(group, loads, run);
    return actors.size() == 1 ? actors.front().symbol : said_.resultant_symbol(group);
}

std::optional<PlaceOnDrawing> Resultants::meet_of_resultant(const Group& group, const Action& line, const Wrench& known,
                                                            const std::vector<Load>& loads, Run& run) {
    if (!known.force || actors_on(group, loads, run).size() < 2) return std::nullopt;
    say_resultant(group, known, loads, run);
    return board_.meet(model_.line_of(known), line.line);
}

void Resultants::note_culmann(const Group& group, int one, const std::string& names, Force force, PlaceOnDrawing met,
                              const std::vector<Load>& loads, Run& run) {
    if (board_.is_zero(force)) return;
    Sum sum{group, said_.with_mark({Symbol::Letter::F, names, {}}), force, met, {one}, said_.last()};
    for (const Actor& actor : actors_on(group, loads, run))
        if (actor.bond >= 0) sum.bonds.push_back(actor.bond);
    run.sums.push_back(std::move(sum));
}

void Resultants::note_lever(const Group& group, PlaceOnDrawing about, Force force, PlaceOnDrawing place, Run& run) {
    if (group.size() > 1 || model_.is_pin(group.front())) return;
    run.arms.push_back({group.front(), about, force, place, said_.last(), false});
}

void Resultants::note_couple_of_two(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run) {
    if (!known.couple) return;
    const std::vector<Actor> actors = actors_on(group, loads, run);
    if (actors.size() == 2 && actors[0].force && actors[1].force)
        note_lever(group, actors[0].place, *actors[1].force, actors[1].place, run);
}

}  // namespace kinegraph::statics
