#include "constructions/statics/truss.hpp"

#include <algorithm>
#include <utility>

#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

TrussDrawing::TrussDrawing(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss,
                           const Run& whole)
    : model_(model),
      board_(board),
      truss_(truss),
      known_(model, board, mechanism, truss),
      plan_(board, truss, known_.pins_under_forces()),
      pins_(known_),
      cuts_(known_) {
    known_.take_supports(whole);
}

Message TrussDrawing::why_no_plan() const {
    if (const auto& bars = plan_.crossing())
        return {lang::sentences::truss_with_crossing,
                {known_.name_of_bar(bars->first), known_.name_of_bar(bars->second)}};
    if (const auto pin = plan_.inside()) return {lang::sentences::truss_loaded_inside, {known_.name_of(*pin)}};
    return {lang::sentences::truss_in_parts, {Count{static_cast<int>(truss_.bars.size())}}};
}

// --- solving

bool TrussDrawing::resolve() {
    settle_idle_bars(known_);
    const auto& supports = known_.supports();
    const auto supports_known =
        std::all_of(supports.begin(), supports.end(), [](const auto& each) { return each.known; });
    if (plan_.exists() && supports_known && !model_.loads().empty()) open_plan();
    cuts_.make_those_of_file(false);
    while (!known_.all_known() && !pins_.is_contradictory()) {
        bool any = false;
        for (int pin = 0; pin < known_.pins(); ++pin) any = pins_.resolve(pin) || any;
        if (!any && !pins_.is_contradictory() && !cuts_.make_any()) return false;
    }
    if (pins_.is_contradictory() || !pins_.check_rest()) return false;
    cuts_.make_those_of_file(true);
    return true;
}

void TrussDrawing::open_plan() { opening_ = known_.say(lang::sentences::truss_plan, {std::string()}, "Bow"); }

// --- results

/// The force at each joint of a pin, starting at those with one unknown: the joints connect its bodies as a tree.
bool TrussDrawing::settle_joints(int pin, Run& run) {
    const ElementIndex here = known_.place(pin).element;
    std::vector<int> bonds;
    for (std::size_t b = 0; b < model_.bonds().size(); ++b)
        if (model_.bonds()[b].place.element == here) bonds.push_back(static_cast<int>(b));
    const auto unknown_of = [&](MemberIndex member) {
        std::vector<int> unknown;
        for (const int b : bonds)
            if (!run.reactions[at(b)].known &&
                (model_.bonds()[at(b)].first == member || model_.bonds()[at(b)].second == member))
                unknown.push_back(b);
        return unknown;
    };
    const auto known_on_member = [&](MemberIndex member) {
        std::optional<Force> sum;
        const auto add = [&](const std::optional<Force>& force) { sum = known_.sum(sum, force); };
        for (const int load : known_.loads_at(pin))
            if (known_.load(load).member == member) add(known_.load(load).force);
        for (const int bar : truss_.pins[at(pin)].bars)
            if (member_of(truss_.bars[at(bar)].body) == member) add(known_.pull_on(bar, pin));
        for (const int b : bonds) {
            const Bond& bond = model_.bonds()[at(b)];
            const Reaction& reaction = run.reactions[at(b)];
            if (!reaction.known || !reaction.force || (bond.first != member && bond.second != member)) continue;
            add(bond.first == member ? *reaction.force : board_.negate(*reaction.force));
        }
        return sum;
    };
    for (bool more = true; more;) {
        more = false;
        for (const MemberIndex member : model_.moving_members()) {
            const std::vector<int> unknown = unknown_of(member);
            if (unknown.size() != 1) continue;
            const Bond& bond = model_.bonds()[at(unknown[0])];
            Reaction& reaction = run.reactions[at(unknown[0])];
            reaction.known = more = true;
            reaction.force_statement = known_.statement();
            if (const auto sum = known_on_member(member); sum && !board_.is_zero(*sum))
                reaction.force = bond.first == member ? board_.negate(*sum) : *sum;
        }
    }
    return std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
}

Run TrussDrawing::run(Run from) {
    for (const KnownTruss::Support& support : known_.supports()) {
        if (support.bonds.size() != 1 || !support.line) continue;
        Reaction& reaction = from.reactions[at(support.bonds[0])];
        reaction.known = true;
        reaction.force_statement = support.statement;
        reaction.force.reset();
        if (support.force)
            reaction.force = model_.bonds()[at(support.bonds[0])].first == member_of(frame)
                                 ? board_.negate(*support.force)
                                 : *support.force;
    }
    from.complete = true;
    for (int pin = 0; pin < known_.pins(); ++pin) from.complete = settle_joints(pin, from) && from.complete;
    return from;
}

void TrussDrawing::read_off(const Run& run) {
    for (std::size_t bar = 0; bar < known_.bars().size(); ++bar) {
        const int pin = truss_.bars[bar].pins[0];
        const MemberIndex member = member_of(truss_.bars[bar].body);
        std::optional<Force> sum;
        const auto add = [&](const std::optional<Force>& force) { sum = known_.sum(sum, force); };
        for (const int load : known_.loads_at(pin))
            if (known_.load(load).member == member) add(known_.load(load).force);
        for (const int b : model_.bonds_of(member)) {
            const Bond& bond = model_.bonds()[at(b)];
            if (bond.place.element != known_.place(pin).element || !run.reactions[at(b)].force) continue;
            add(bond.first == member ? *run.reactions[at(b)].force : board_.negate(*run.reactions[at(b)].force));
        }
        known_.take_bar(static_cast<int>(bar),
                        sum && !board_.is_zero(*sum) ? std::optional(board_.negate(*sum)) : std::nullopt);
    }
    known_.take_supports(run);
}

std::vector<OuterForce> TrussDrawing::outer_forces() const {
    std::vector<OuterForce> outer;
    for (int pin = 0; pin < known_.pins(); ++pin)
        for (const int l : known_.loads_at(pin)) {
            const Load& load = known_.load(l);
            if (!load.force) continue;
            Truss::External told;
            told.pin = pin;
            told.force = Recorded<Vector>::at(load.force->element);
            told.given = load.given;
            told.symbol = load.symbol;
            outer.push_back({std::move(told), *load.force, {.kind = Quantity::Kind::load, .given = load.given}});
        }
    for (const KnownTruss::Support& support : known_.supports()) {
        if (!support.force) continue;
        const Bond& bond = model_.bonds()[at(support.bonds.front())];
        const MemberIndex on = bond.first == member_of(frame) ? bond.second : bond.first;
        Truss::External told;
        told.pin = support.pin;
        told.force = Recorded<Vector>::at(support.force->element);
        told.joint = bond.joint;
        told.symbol = known_.symbol_of(support);
        told.statement = support.statement;
        const Quantity quantity{
            .kind = Quantity::Kind::force, .body = model_.body_of(on), .other = frame, .joint = bond.joint};
        outer.push_back({std::move(told), *support.force, quantity});
    }
    return outer;
}

Truss TrussDrawing::finish() {
    Truss& found = known_.found();
    std::vector<std::optional<Force>> pulls;
    for (std::size_t bar = 0; bar < known_.bars().size(); ++bar) {
        pulls.push_back(known_.bars()[bar].pull);
        found.bars[bar].force =
            known_.bars()[bar].pull ? Recorded<Vector>::at(known_.bars()[bar].pull->element) : Recorded<Vector>::zero();
        if (found.bars[bar].statement == none) found.bars[bar].statement = known_.statement();
    }
    std::vector<OuterForce> outer = outer_forces();
    if (!plan_.exists() || outer.empty()) {
        for (const OuterForce& force : outer) found.externals.push_back(force.told);
        return std::move(found);
    }
    if (opening_ == none) open_plan();
    plan_.draw(found, std::move(outer), pulls, opening_);
    std::string letters;
    for (const Truss::Space& space : found.spaces)
        if (space.outside) letters += (letters.empty() ? "" : ", ") + space.letter;
    board_.statement(opening_).message.arguments = {letters};
    return std::move(found);
}

}  // namespace kinegraph::statics
