#include "constructions/statics/truss/known_truss.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {

KnownTruss::KnownTruss(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss)
    : model_(model),
      board_(board),
      mechanism_(mechanism),
      truss_(truss),
      bars_(truss.bars.size()),
      loads_(truss.pins.size()) {
    found_.structure = truss;
    found_.bars.resize(truss.bars.size());
    for (std::size_t l = 0; l < model_.loads().size(); ++l)
        for (int pin = 0; pin < pins(); ++pin)
            if (place(pin).element == model_.loads()[l].place.element) loads_[at(pin)].push_back(static_cast<int>(l));
}

void KnownTruss::take_supports(const Run& whole) {
    supports_.clear();
    const auto take = [&](int pin, const std::vector<JointIndex>& joints) {
        Support support;
        support.pin = pin;
        for (std::size_t b = 0; b < model_.bonds().size(); ++b) {
            const Bond& bond = model_.bonds()[b];
            if (is_on_frame(bond) && std::find(joints.begin(), joints.end(), bond.joint) != joints.end())
                support.bonds.push_back(static_cast<int>(b));
        }
        support.known = true;
        for (const int b : support.bonds) {
            const Bond& bond = model_.bonds()[at(b)];
            if (bond.kind == Bond::Kind::line || bond.kind == Bond::Kind::guide) support.line = bond.direction;
            const Reaction& reaction = whole.reactions[at(b)];
            support.known = support.known && reaction.known;
            if (!reaction.known || !reaction.force) continue;
            const Force force = bond.first == member_of(frame) ? board_.negate(*reaction.force) : *reaction.force;
            support.force = sum(support.force, force);
            support.statement = reaction.force_statement;
        }
        if (!support.known) support.force.reset();
        supports_.push_back(std::move(support));
    };
    for (std::size_t pin = 0; pin < truss_.pins.size(); ++pin) {
        if (!truss_.pins[pin].hinges.empty()) take(static_cast<int>(pin), truss_.pins[pin].hinges);
        for (const JointIndex joint : truss_.pins[pin].supports) take(static_cast<int>(pin), {joint});
    }
}

bool KnownTruss::is_unloaded(int pin) const {
    return loads_[at(pin)].empty() &&
           std::none_of(supports_.begin(), supports_.end(), [&](const Support& each) { return each.pin == pin; });
}

bool KnownTruss::all_known() const {
    return std::all_of(bars_.begin(), bars_.end(), [](const Bar& bar) { return bar.known; }) &&
           std::all_of(supports_.begin(), supports_.end(), [](const Support& support) { return support.known; });
}

std::optional<Force> KnownTruss::pull_on(int bar, int pin) {
    const auto& pull = bars_[at(bar)].pull;
    if (!pull || truss_.bars[at(bar)].pins[0] == pin) return pull;
    return board_.negate(*pull);
}

std::optional<Force> KnownTruss::sum(const std::optional<Force>& a, const std::optional<Force>& b) const {
    if (!a || !b) return a ? a : b;
    return board_.add(*a, *b);
}

std::vector<int> KnownTruss::pins_under_forces() const {
    std::vector<int> pins;
    for (std::size_t pin = 0; pin < truss_.pins.size(); ++pin) {
        const ElementIndex here = place(static_cast<int>(pin)).element;
        const bool held = !truss_.pins[pin].hinges.empty() || !truss_.pins[pin].supports.empty();
        const bool loaded = std::any_of(model_.loads().begin(), model_.loads().end(),
                                        [&](const Load& load) { return load.place.element == here; });
        if (held || loaded) pins.push_back(static_cast<int>(pin));
    }
    return pins;
}

Symbol KnownTruss::symbol_of(const Support& support) const {
    const Bond& bond = model_.bonds()[at(support.bonds.front())];
    return bond.first == member_of(frame) ? bond.reverse : bond.symbol;
}

Names KnownTruss::names_of(const std::vector<int>& bars) const {
    Names names;
    for (const int bar : bars) names.push_back(truss_.bars[at(bar)].name);
    return names;
}

StatementIndex KnownTruss::say(Key sentence, std::vector<Argument> arguments, const char* source) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = Topic::forces;
    statement.source = source;
    statement_ = board_.state(std::move(statement));
    return statement_;
}

void KnownTruss::settle(int bar, int pin, const std::optional<Force>& pull) {
    Bar& own = bars_[at(bar)];
    own.known = true;
    own.pull.reset();
    if (pull && !board_.is_zero(*pull)) own.pull = truss_.bars[at(bar)].pins[0] == pin ? *pull : board_.negate(*pull);
    found_.bars[at(bar)].statement = statement_;
    board_.statement(statement_).finds.push_back({.kind = Quantity::Kind::bar, .body = truss_.bars[at(bar)].body});
}

void KnownTruss::settle(std::size_t support, const std::optional<Force>& force) {
    Support& own = supports_[support];
    own.known = true;
    own.force.reset();
    if (force && !board_.is_zero(*force)) own.force = force;
    own.statement = statement_;
}

void KnownTruss::take_bar(int bar, const std::optional<Force>& pull) { bars_[at(bar)] = {true, pull}; }

void KnownTruss::rewind(const Mark& mark) {
    board_.rewind(mark.board);
    statement_ = mark.statement;
}

}  // namespace kinegraph::statics
