#include "constructions/statics/free_bodies/determinacy.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "constructions/statics/equilibria.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

std::set<MemberIndex> ForceDeterminacy::out_of_equilibrium(const Run& run) {
    Group found;
    for (const MemberIndex member : model_.moving_members()) {
        const auto& bonds = model_.bonds_of(member);
        const bool all_known =
            std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
        if (all_known && !model_.known_on({member}, *under_.loads, run).vanishes()) found.push_back(member);
    }
    std::set<MemberIndex> open(found.begin(), found.end());
    for (std::size_t next = 0; next < found.size(); ++next) {
        for (const int b : model_.bonds_of(found[next])) {
            const Bond& bond = model_.bonds()[at(b)];
            const MemberIndex other = bond.first == found[next] ? bond.second : bond.first;
            if (other != member_of(frame) && run.reactions[at(b)].known && open.insert(other).second)
                found.push_back(other);
        }
    }
    return open;
}

bool ForceDeterminacy::is_complete(const Run& run, const std::set<MemberIndex>& unbalanced) const {
    for (std::size_t b = 0; b < model_.bonds().size(); ++b)
        if (!run.reactions[b].known && unbalanced.count(model_.bonds()[b].first) == 0) return false;
    return true;
}

void ForceDeterminacy::explain(const Run& run, bool balanced, ForceResults& results) {
    Symbols open;
    for (std::size_t b = 0; b < model_.bonds().size() && balanced; ++b) {
        for (Symbol& symbol :
             open_symbols(model_.bonds()[b], run.reactions[b], model_.bonds()[b].first == member_of(frame)))
            open.push_back(std::move(symbol));
    }
    results.unsolved.push_back({{lang::phrases::all_forces, {}}, reason(std::move(open))});
}

/// Teeth have two lines of action: a remark says why one of them is taken.
void ForceDeterminacy::remark_teeth(const Run& run, ForceResults& results) {
    Names pressing;
    for (std::size_t b = 0; b < model_.bonds().size(); ++b)
        if (model_.is_of_teeth(b) && run.reactions[b].force)
            pressing.push_back(mechanism_.point(mechanism_.joints[at(model_.bonds()[b].joint)].point).name);
    if (!pressing.empty()) results.remarks.push_back({lang::sentences::teeth_push, {std::move(pressing)}});
}

void ForceDeterminacy::remark_lift_off(const Run& run, ForceResults& results) {
    for (std::size_t b = 0; b < model_.bonds().size(); ++b) {
        const JointIndex joint = model_.bonds()[b].joint;
        if (joint != none && !model_.is_of_teeth(b) && model_.pulls(b, run))
            results.remarks.push_back({lang::sentences::lift_off, {file_name(mechanism_.joints[at(joint)])}});
    }
}

Symbols ForceDeterminacy::open_symbols(const Bond& bond, const Reaction& reaction, bool reversed) {
    Symbols open;
    if (reaction.known) return open;
    Symbol symbol = reversed ? bond.reverse : bond.symbol;
    const bool takes_couple = bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp;
    if (reaction.alike == Reaction::Alike::component) {
        Symbol across = symbol;
        across.term += (across.term.empty() ? "" : ",") + std::string(reaction.across);
        open.push_back(std::move(across));
    } else if (reaction.alike == Reaction::Alike::nothing) {
        open.push_back(symbol);
    }
    if (takes_couple && !reaction.couple_alike && reaction.alike != Reaction::Alike::nothing) {
        symbol.letter = Symbol::Letter::M;
        open.push_back(std::move(symbol));
    }
    return open;
}

bool ForceDeterminacy::moves_freely() {
    Run nothing_known;
    nothing_known.reactions.resize(model_.bonds().size());
    const Board::Mark before = board_.mark();
    const ScalarHandle zero = board_.number(0);
    bool moves = false;
    for (Group& group : groups_in_question(model_, nothing_known)) {
        const Equilibria all(model_, board_, nothing_known, std::move(group), board_.place(PointIndex(0)),
                             [&](MemberIndex) {
                                 return Equilibria::Gap{zero, zero, zero};
                             });
        moves = moves || !all.free_motions().empty();
    }
    board_.rewind(before);
    return moves;
}

Message ForceDeterminacy::reason(Symbols open) {
    const auto efforts = static_cast<int>(mechanism_.efforts.size());
    const Count freedoms{mobility_.effective};
    if (efforts < mobility_.effective) return {lang::phrases::unbalanced, {freedoms, Count{efforts}, std::move(open)}};
    if (efforts > mobility_.effective)
        return {lang::phrases::too_many_efforts, {Count{efforts}, freedoms, std::move(open)}};
    if (efforts > 0 && moves_freely()) return {lang::phrases::effort_without_work, {std::move(open)}};
    int repeated = 0;
    Names joints;
    for (const Mobility::Redundant& redundant : mobility_.redundant) {
        repeated += redundant.rows;
        joints.push_back(mechanism_.joints[at(redundant.joint)].name);
    }
    if (repeated > 0) return {lang::phrases::indeterminate, {Count{repeated}, std::move(joints), std::move(open)}};
    return {lang::phrases::not_by_equilibrium, {std::move(open)}};
}

}  // namespace kinegraph::statics
