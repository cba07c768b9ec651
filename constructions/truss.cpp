#include "constructions/truss.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/assert.hpp"

namespace kinegraph::statics {
namespace {

bool holds(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

/// Pins on which something acts from outside.
std::vector<int> pins_under_forces(const ForceModel& model, Board& board, const TrussStructure& truss) {
    std::vector<int> pins;
    for (std::size_t pin = 0; pin < truss.pins.size(); ++pin) {
        const ElementIndex here = board.place(truss.pins[pin].point).element;
        const bool held = !truss.pins[pin].hinges.empty() || !truss.pins[pin].supports.empty();
        const bool loaded = std::any_of(model.loads().begin(), model.loads().end(),
                                        [&](const statics::Load& load) { return load.place.element == here; });
        if (held || loaded) pins.push_back(static_cast<int>(pin));
    }
    return pins;
}

}  // namespace

TrussDrawing::TrussDrawing(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss,
                           const Run& whole)
    : model_(model),
      board_(board),
      mechanism_(mechanism),
      truss_(truss),
      plan_(board, truss, pins_under_forces(model, board, truss)),
      bars_(truss.bars.size()),
      loads_(truss.pins.size()),
      resolved_(truss.pins.size(), false),
      cut_done_(mechanism.find.cuts.size(), false) {
    found_.structure = truss;
    found_.bars.resize(truss.bars.size());
    note_loads();
    collect_supports(whole);
}

void TrussDrawing::note_loads() {
    for (std::size_t l = 0; l < model_.loads().size(); ++l)
        for (std::size_t pin = 0; pin < truss_.pins.size(); ++pin)
            if (place(static_cast<int>(pin)).element == model_.loads()[l].place.element)
                loads_[pin].push_back(static_cast<int>(l));
}

void TrussDrawing::collect_supports(const Run& whole) {
    const auto take = [&](int pin, const std::vector<JointIndex>& joints) {
        Support support;
        support.pin = pin;
        for (std::size_t b = 0; b < model_.joint_bonds(); ++b) {
            const Bond& bond = model_.bonds()[b];
            const bool on_frame = bond.first == member_of(frame) || bond.second == member_of(frame);
            if (on_frame && std::find(joints.begin(), joints.end(), bond.joint) != joints.end())
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
            support.force = support.force ? board_.add(*support.force, force) : force;
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

std::optional<Force> TrussDrawing::pull_on(int bar, int pin) {
    const auto& pull = bars_[at(bar)].pull;
    if (!pull || truss_.bars[at(bar)].pins[0] == pin) return pull;
    return board_.negate(*pull);
}

Symbol TrussDrawing::symbol_of(const Support& support) const {
    const Bond& bond = model_.bonds()[at(support.bonds.front())];
    return bond.first == member_of(frame) ? bond.reverse : bond.symbol;
}

Names TrussDrawing::names_of(const std::vector<int>& bars) const {
    Names names;
    for (const int bar : bars) names.push_back(truss_.bars[at(bar)].name);
    return names;
}

// --- sentences ---------------------------------------------------------------------------------------------------------------

void TrussDrawing::say(Sentence sentence, std::vector<Argument> arguments, const char* source) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = Topic::forces;
    statement.source = source;
    statement_ = board_.state(std::move(statement));
}

/// `pull`: on this pin.
void TrussDrawing::settle(int bar, int pin, const std::optional<Force>& pull) {
    Bar& own = bars_[at(bar)];
    own.known = true;
    own.pull.reset();
    if (pull && !board_.is_zero(*pull)) own.pull = truss_.bars[at(bar)].pins[0] == pin ? *pull : board_.negate(*pull);
    found_.bars[at(bar)].statement = statement_;
    board_.statement(statement_).finds.push_back({.kind = Quantity::Kind::bar, .body = truss_.bars[at(bar)].body});
}

void TrussDrawing::settle(Support& support, const std::optional<Force>& force) {
    support.known = true;
    support.force.reset();
    if (force && !board_.is_zero(*force)) support.force = force;
    support.statement = statement_;
}

// --- bars that carry nothing -------------------------------------------------------------------------------------------------

bool TrussDrawing::is_unloaded(int pin) const {
    return loads_[at(pin)].empty() &&
           std::none_of(supports_.begin(), supports_.end(), [&](const Support& each) { return each.pin == pin; });
}

/// At an unloaded pin: two bars not in line, the third of three with two in line, one alone.
bool TrussDrawing::idle_at(int pin) {
    if (!is_unloaded(pin)) return false;
    std::vector<int> left;
    for (const int bar : truss_.pins[at(pin)].bars)
        if (!bars_[at(bar)].known)
            left.push_back(bar);
        else if (bars_[at(bar)].pull)
            return false;
    const auto in_line = [&](int bar, int other) { return board_.parallel(toward(bar, pin), toward(other, pin)); };
    const auto is_idle = [&](int bar) {
        settle(bar, pin, std::nullopt);
        found_.bars[at(bar)].idle_by_rule = true;
    };
    const auto named = [&](int bar) { return PointName{truss_.bars[at(bar)].name}; };
    if (left.size() == 1) {
        say(Sentence::truss_idle_single, {name_of(pin), named(left[0])});
        is_idle(left[0]);
        return true;
    }
    if (left.size() == 2 && !in_line(left[0], left[1])) {
        say(Sentence::truss_idle_pair, {name_of(pin), named(left[0]), named(left[1])});
        is_idle(left[0]);
        is_idle(left[1]);
        return true;
    }
    if (left.size() != 3) return false;
    for (std::size_t third = 0; third < 3; ++third) {
        const int one = left[(third + 1) % 3], two = left[(third + 2) % 3];
        if (!in_line(one, two) || in_line(left[third], one)) continue;
        say(Sentence::truss_idle_third, {name_of(pin), named(left[third]), named(one), named(two)});
        is_idle(left[third]);
        return true;
    }
    return false;
}

bool TrussDrawing::idle_bars() {
    bool any = false;
    for (bool more = true; more;) {
        more = false;
        for (int pin = 0; pin < static_cast<int>(truss_.pins.size()); ++pin) more = idle_at(pin) || more;
        any = any || more;
    }
    return any;
}

// --- pin by pin --------------------------------------------------------------------------------------------------------------

bool TrussDrawing::all_known() const {
    return std::all_of(bars_.begin(), bars_.end(), [](const Bar& bar) { return bar.known; }) &&
           std::all_of(supports_.begin(), supports_.end(), [](const Support& support) { return support.known; });
}

std::vector<TrussDrawing::Unknown> TrussDrawing::unknown_at(int pin) {
    std::vector<Unknown> unknown;
    for (const int bar : truss_.pins[at(pin)].bars)
        if (!bars_[at(bar)].known) unknown.push_back({bar, -1, toward(bar, pin)});
    for (std::size_t s = 0; s < supports_.size(); ++s)
        if (supports_[s].pin == pin && !supports_[s].known) unknown.push_back({-1, static_cast<int>(s), supports_[s].line});
    return unknown;
}

/// The sum of all that is known at a pin; nothing where it vanishes.
std::optional<Force> TrussDrawing::known_at(int pin) {
    std::optional<Force> sum;
    const auto add = [&](const std::optional<Force>& force) {
        if (force) sum = sum ? board_.add(*sum, *force) : *force;
    };
    for (const int load : loads_[at(pin)]) add(model_.loads()[at(load)].force);
    for (const Support& support : supports_)
        if (support.pin == pin && support.known) add(support.force);
    for (const int bar : truss_.pins[at(pin)].bars)
        if (bars_[at(bar)].known) add(pull_on(bar, pin));
    if (sum && board_.is_zero(*sum)) sum.reset();
    return sum;
}

void TrussDrawing::settle(int pin, const Unknown& unknown, const std::optional<Force>& force) {
    if (unknown.bar >= 0)
        settle(unknown.bar, pin, force);
    else
        settle(supports_[at(unknown.support)], force);
}

/// Closes the polygon of a pin: with one force any way or along its line, or with two along theirs.
bool TrussDrawing::close_pin(int pin, const std::vector<Unknown>& unknown) {
    const std::optional<Force> known = known_at(pin);
    const auto nothing = [&] {
        for (const Unknown& each : unknown) settle(pin, each, std::nullopt);
        return true;
    };
    if (unknown.size() == 1) {
        const auto& along = unknown[0].along;
        if (known && along && !board_.parallel(board_.direction(*known), *along)) {
            contradictory_ = true;
            return false;
        }
        settle(pin, unknown[0], known ? std::optional(board_.negate(*known)) : std::nullopt);
        return true;
    }
    if (!unknown[0].along || !unknown[1].along || board_.parallel(*unknown[0].along, *unknown[1].along)) return false;
    if (!known) return nothing();
    const auto start = board_.pole<Plane::force>(), end = board_.carry(start, *known);
    const auto corner = board_.meet(board_.through(end, *unknown[0].along), board_.through(start, *unknown[1].along));
    KG_ASSERT(corner && !board_.is_at_infinity(*corner), "lines that are not parallel meet");
    settle(pin, unknown[0], board_.vector(end, *corner));
    settle(pin, unknown[1], board_.vector(*corner, start));
    return true;
}

/// What was found there, once it is: senses are read off the polygon.
void TrussDrawing::say_pin(int pin, const std::vector<Unknown>& unknown) {
    std::vector<int> bars, tension, compression, idle;
    std::vector<Symbol> reactions;
    for (const Unknown& each : unknown) {
        if (each.bar < 0) {
            reactions.push_back(symbol_of(supports_[at(each.support)]));
            continue;
        }
        bars.push_back(each.bar);
        const auto pull = pull_on(each.bar, pin);
        (!pull ? idle : board_.along_sign(*each.along, *pull) > 0 ? tension : compression).push_back(each.bar);
    }
    Message& message = board_.statement(statement_).message;
    if (reactions.empty()) {
        message = {Sentence::truss_pin, {name_of(pin), names_of(bars), names_of(tension), names_of(compression), names_of(idle)}};
    } else if (bars.empty()) {
        message = {Sentence::truss_support, {name_of(pin), reactions}};
    } else {
        message = {Sentence::truss_bar_and_support, {name_of(pin), PointName{truss_.bars[at(bars[0])].name}, reactions[0]}};
    }
}

bool TrussDrawing::resolve_pin(int pin) {
    const std::vector<Unknown> unknown = unknown_at(pin);
    const auto free = std::count_if(unknown.begin(), unknown.end(), [](const Unknown& each) { return !each.along; });
    if (unknown.empty() || unknown.size() + static_cast<std::size_t>(free) > 2) return false;
    const Board::Mark before = board_.mark();
    const StatementIndex said = statement_;
    say(Sentence::truss_pin, {}, "Cremona");
    if (!close_pin(pin, unknown)) {
        board_.rewind(before);
        statement_ = said;
        return false;
    }
    say_pin(pin, unknown);
    resolved_[at(pin)] = true;
    return true;
}

/// Pins of which all was known when their turn came: they must close.
bool TrussDrawing::check_rest() {
    Names closed;
    for (int pin = 0; pin < static_cast<int>(truss_.pins.size()); ++pin) {
        if (resolved_[at(pin)]) continue;
        if (known_at(pin)) return false;
        if (!is_unloaded(pin) || std::any_of(truss_.pins[at(pin)].bars.begin(), truss_.pins[at(pin)].bars.end(),
                                             [&](int bar) { return bars_[at(bar)].pull.has_value(); }))
            closed.push_back(truss_.name_of(mechanism_, pin));
    }
    if (!closed.empty()) say(Sentence::truss_closes, {closed});
    return true;
}

bool TrussDrawing::resolve() {
    idle_bars();
    const auto supports_known = std::all_of(supports_.begin(), supports_.end(), [](const Support& each) { return each.known; });
    if (plan_.exists() && supports_known && !model_.loads().empty()) {
        say(Sentence::truss_plan, {std::string()}, "Bow");
        opening_ = statement_;
    }
    cuts_of_file(false);
    while (!all_known() && !contradictory_) {
        bool any = false;
        for (int pin = 0; pin < static_cast<int>(truss_.pins.size()); ++pin) any = resolve_pin(pin) || any;
        if (!any && !contradictory_ && !any_cut()) return false;
    }
    if (contradictory_ || !check_rest()) return false;
    cuts_of_file(true);
    return true;
}

// --- cuts --------------------------------------------------------------------------------------------------------------------

void TrussDrawing::cuts_of_file(bool at_last) {
    for (std::size_t c = 0; c < mechanism_.find.cuts.size(); ++c) {
        if (cut_done_[c]) continue;
        std::vector<int> bars;
        for (const BodyIndex body : mechanism_.find.cuts[c].bars)
            for (std::size_t bar = 0; bar < truss_.bars.size(); ++bar)
                if (truss_.bars[bar].body == body) bars.push_back(static_cast<int>(bar));
        const auto sides = sides_of_cut(truss_, bars);
        const auto side = std::find_if(sides.begin(), sides.end(), [&](const auto& each) { return are_known(each); });
        if (side == sides.end() && !at_last) continue;
        cut_done_[c] = true;
        if (side == sides.end())
            unsolved_.push_back({{Sentence::cut_of_bars, {names_of(bars)}}, {Sentence::cut_without_reactions, {}}});
        else if (!cut(bars, *side, true))
            unsolved_.push_back({{Sentence::cut_of_bars, {names_of(bars)}}, {Sentence::cut_in_one_point, {}}});
    }
}

bool TrussDrawing::are_known(const std::vector<int>& side) const {
    return std::all_of(supports_.begin(), supports_.end(),
                       [&](const Support& support) { return support.known || !holds(side, support.pin); });
}

/// Where no pin leads on: three unknown bars that part the truss, other bars cut being known.
bool TrussDrawing::any_cut() {
    std::vector<int> known, unknown;
    for (std::size_t bar = 0; bar < bars_.size(); ++bar) (bars_[bar].known ? known : unknown).push_back(static_cast<int>(bar));
    for (std::size_t i = 0; i < unknown.size(); ++i)
        for (std::size_t j = i + 1; j < unknown.size(); ++j)
            for (std::size_t k = j + 1; k < unknown.size(); ++k) {
                const std::vector<int> bars{unknown[i], unknown[j], unknown[k]};
                for (const std::vector<int>& side : sides_of_cut(truss_, bars, known)) {
                    constexpr std::size_t least = 2;
                    if (side.size() < least || !are_known(side)) continue;
                    const Board::Mark before = board_.mark();
                    const StatementIndex said = statement_;
                    say(Sentence::truss_stuck, {names_of(bars)});
                    if (cut(bars, side, false)) return true;
                    board_.rewind(before);
                    statement_ = said;
                }
            }
    return false;
}

/// All that acts on a side but the bars of the cut.
Wrench TrussDrawing::known_on(const std::vector<int>& side, const std::vector<int>& bars) {
    Wrench total;
    const auto add = [&](const std::optional<Force>& force, int pin) {
        if (!force) return;
        Wrench one;
        one.force = *force;
        one.place = place(pin);
        total = model_.sum(total, one);
    };
    for (const int pin : side) {
        for (const int load : loads_[at(pin)]) add(model_.loads()[at(load)].force, pin);
        for (const Support& support : supports_)
            if (support.pin == pin) add(support.force, pin);
        for (const int bar : truss_.pins[at(pin)].bars)
            if (!holds(bars, bar) && !holds(side, truss_.other_end(bar, pin))) add(pull_on(bar, pin), pin);
    }
    return total;
}

/// The equation that holds one of three bars alone: moments about the meet of the others, or across them where they are parallel.
std::optional<TrussDrawing::Equation> TrussDrawing::equation_for(const std::vector<int>& bars, std::size_t sought,
                                                                 const Wrench& known) {
    const Action own = action_of(bars[sought]), one = action_of(bars[(sought + 1) % 3]), two = action_of(bars[(sought + 2) % 3]);
    Equation equation;
    equation.bar = bars[sought];
    if (board_.parallel(one.direction, two.direction)) {
        const auto& ends = truss_.bars[at(bars[(sought + 1) % 3])].pins;
        const auto along = board_.vector(place(ends[0]), place(ends[1]));
        equation.lever = board_.moment(along, own.direction);
        equation.moment = known.force ? board_.moment(board_.direction(along), *known.force) : board_.number(0);
    } else {
        equation.pivot = *board_.meet(one.line, two.line);
        equation.lever = board_.moment(board_.vector(*equation.pivot, own.place), own.direction);
        equation.moment = model_.moment(known, *equation.pivot);
    }
    if (board_.is_zero(equation.lever)) return std::nullopt;
    return equation;
}

std::string TrussDrawing::name_of_meet(PlaceOnDrawing meet) {
    for (std::size_t pin = 0; pin < truss_.pins.size(); ++pin)
        if (board_.coincide(meet, place(static_cast<int>(pin)))) return truss_.name_of(mechanism_, static_cast<int>(pin));
    for (const auto& [name, where] : meets_)
        if (board_.coincide(meet, where)) return name;
    for (int number = 1;; ++number) {
        std::string name = "R" + std::to_string(number);  // Ritter's points
        if (mechanism_.point_named(name)) continue;
        if (std::any_of(meets_.begin(), meets_.end(), [&](const auto& each) { return each.first == name; })) continue;
        meets_.emplace_back(name, meet);
        return name;
    }
}

bool TrussDrawing::cut(const std::vector<int>& bars, const std::vector<int>& side, bool asked) {
    const Board::Mark before = board_.mark();
    const Wrench known = known_on(side, bars);
    std::vector<Equation> equations;
    for (std::size_t sought = 0; sought < bars.size(); ++sought) {
        const auto equation = equation_for(bars, sought, known);
        if (!equation) {
            board_.rewind(before);
            return false;
        }
        equations.push_back(*equation);
    }
    for (std::size_t sought = 0; sought < bars.size(); ++sought) {
        const Equation* equation = &equations[sought];
        const int bar = equation->bar;
        const Names all = names_of(bars);
        const PointName one{all[(sought + 1) % 3]}, two{all[(sought + 2) % 3]};
        Truss::Cut told{bars, side, bar, {}, {}, {}, none, asked};
        if (equation->pivot) {
            told.pivot_name = name_of_meet(*equation->pivot);
            told.pivot = Recorded<Vector>::at(equation->pivot->element);
            say(Sentence::truss_cut_moment, {all, symbol_of(bar), one, two, PointName{told.pivot_name}}, "Ritter");
        } else {
            say(Sentence::truss_cut_across, {all, symbol_of(bar), one, two}, "Ritter");
        }
        told.moment = Recorded<Exact>::at(equation->moment.element);
        told.statement = statement_;
        found_.cuts.push_back(std::move(told));
        const Action line = action_of(bar);
        const ScalarHandle size = board_.quotient(board_.opposite(equation->moment), equation->lever);
        const int pin = holds(side, truss_.bars[at(bar)].pins[0]) ? truss_.bars[at(bar)].pins[0] : truss_.bars[at(bar)].pins[1];
        if (!bars_[at(bar)].known) settle(bar, pin, board_.scale<Plane::force>(size, line.direction));
    }
    return true;
}

// --- what was found ----------------------------------------------------------------------------------------------------------

/// The force at each joint of a pin, from those with one unknown on: they hold its bodies together as a tree.
bool TrussDrawing::settle_joints(int pin, Run& run) {
    const ElementIndex here = place(pin).element;
    std::vector<int> bonds;
    for (std::size_t b = 0; b < model_.joint_bonds(); ++b)
        if (model_.bonds()[b].place.element == here) bonds.push_back(static_cast<int>(b));
    const auto unknown_of = [&](MemberIndex member) {
        std::vector<int> unknown;
        for (const int b : bonds)
            if (!run.reactions[at(b)].known && (model_.bonds()[at(b)].first == member || model_.bonds()[at(b)].second == member))
                unknown.push_back(b);
        return unknown;
    };
    const auto known_on_member = [&](MemberIndex member) {
        std::optional<Force> sum;
        const auto add = [&](const std::optional<Force>& force) {
            if (force) sum = sum ? board_.add(*sum, *force) : *force;
        };
        for (const int load : loads_[at(pin)])
            if (model_.loads()[at(load)].member == member) add(model_.loads()[at(load)].force);
        for (const int bar : truss_.pins[at(pin)].bars)
            if (member_of(truss_.bars[at(bar)].body) == member) add(pull_on(bar, pin));
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
            reaction.force_statement = statement_;
            if (const auto sum = known_on_member(member); sum && !board_.is_zero(*sum))
                reaction.force = bond.first == member ? board_.negate(*sum) : *sum;
        }
    }
    return std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
}

Run TrussDrawing::run(Run from) {
    for (const Support& support : supports_) {
        if (support.bonds.size() != 1 || !support.line) continue;
        Reaction& reaction = from.reactions[at(support.bonds[0])];
        reaction.known = true;
        reaction.force_statement = support.statement;
        reaction.force.reset();
        if (support.force)
            reaction.force =
                model_.bonds()[at(support.bonds[0])].first == member_of(frame) ? board_.negate(*support.force) : *support.force;
    }
    from.complete = true;
    for (int pin = 0; pin < static_cast<int>(truss_.pins.size()); ++pin)
        from.complete = settle_joints(pin, from) && from.complete;
    return from;
}

/// A bar pulls with what acts on its end at the other side of the pull: the joints' forces there, and its loads.
void TrussDrawing::read_off(const Run& run) {
    for (std::size_t bar = 0; bar < bars_.size(); ++bar) {
        const int pin = truss_.bars[bar].pins[0];
        const MemberIndex member = member_of(truss_.bars[bar].body);
        std::optional<Force> sum;
        const auto add = [&](Force force) { sum = sum ? board_.add(*sum, force) : force; };
        for (const int load : loads_[at(pin)])
            if (model_.loads()[at(load)].member == member && model_.loads()[at(load)].force) add(*model_.loads()[at(load)].force);
        for (const int b : model_.bonds_of(member)) {
            const Bond& bond = model_.bonds()[at(b)];
            if (bond.place.element != place(pin).element || !run.reactions[at(b)].force) continue;
            add(bond.first == member ? *run.reactions[at(b)].force : board_.negate(*run.reactions[at(b)].force));
        }
        bars_[bar].known = true;
        bars_[bar].pull.reset();
        if (sum && !board_.is_zero(*sum)) bars_[bar].pull = board_.negate(*sum);
    }
    supports_.clear();
    collect_supports(run);
}

std::vector<OuterForce> TrussDrawing::outer_forces(const Run&) const {
    std::vector<OuterForce> outer;
    for (std::size_t pin = 0; pin < loads_.size(); ++pin)
        for (const int l : loads_[pin]) {
            const statics::Load& load = model_.loads()[at(l)];
            if (!load.force) continue;
            Truss::External told;
            told.pin = static_cast<int>(pin);
            told.force = Recorded<Vector>::at(load.force->element);
            told.given = load.given;
            told.symbol = load.symbol;
            outer.push_back({std::move(told), *load.force, {.kind = Quantity::Kind::load, .given = load.given}});
        }
    for (const Support& support : supports_) {
        if (!support.force) continue;
        const Bond& bond = model_.bonds()[at(support.bonds.front())];
        const MemberIndex on = bond.first == member_of(frame) ? bond.second : bond.first;
        Truss::External told;
        told.pin = support.pin;
        told.force = Recorded<Vector>::at(support.force->element);
        told.joint = bond.joint;
        told.symbol = symbol_of(support);
        told.statement = support.statement;
        const Quantity quantity{.kind = Quantity::Kind::force, .body = model_.body_of(on), .other = frame, .joint = bond.joint};
        outer.push_back({std::move(told), *support.force, quantity});
    }
    return outer;
}

Truss TrussDrawing::finish(const Run& run) {
    std::vector<std::optional<Force>> pulls;
    for (std::size_t bar = 0; bar < bars_.size(); ++bar) {
        pulls.push_back(bars_[bar].pull);
        found_.bars[bar].force = bars_[bar].pull ? Recorded<Vector>::at(bars_[bar].pull->element) : Recorded<Vector>::zero();
        if (found_.bars[bar].statement == none) found_.bars[bar].statement = statement_;
    }
    std::vector<OuterForce> outer = outer_forces(run);
    if (!plan_.exists() || outer.empty()) {
        for (const OuterForce& force : outer) found_.externals.push_back(force.told);
        return std::move(found_);
    }
    if (opening_ == none) {
        say(Sentence::truss_plan, {std::string()}, "Bow");
        opening_ = statement_;
    }
    plan_.draw(found_, std::move(outer), pulls, opening_);
    std::string letters;
    for (const Truss::Space& space : found_.spaces)
        if (space.outside) letters += (letters.empty() ? "" : ", ") + space.letter;
    board_.statement(opening_).message.arguments = {letters};
    return std::move(found_);
}

}  // namespace kinegraph::statics
