#include "constructions/statics/truss/cuts.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {
namespace {

bool holds(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

/// The bars, in order, without which the pins that other bars connect would fall into two parts (bridges, by
/// depth-first search: R. E. Tarjan, 1974).
class BridgeBars {
public:
    BridgeBars(const TrussStructure& truss, std::vector<bool> removed)
        : truss_(truss), removed_(std::move(removed)), order_(truss.pins.size(), 0), lowest_(truss.pins.size(), 0) {
        for (std::size_t pin = 0; pin < truss.pins.size(); ++pin)
            if (order_[pin] == 0) visit(static_cast<int>(pin), -1);
        std::sort(found_.begin(), found_.end());
    }
    const std::vector<int>& found() const { return found_; }

private:
    void visit(int pin, int from) {
        order_[at(pin)] = lowest_[at(pin)] = ++count_;
        for (const int bar : truss_.pins[at(pin)].bars) {
            if (bar == from || removed_[at(bar)]) continue;
            const int other = truss_.other_end(bar, pin);
            if (order_[at(other)] == 0) {
                visit(other, bar);
                if (lowest_[at(other)] > order_[at(pin)]) found_.push_back(bar);
            }
            lowest_[at(pin)] = std::min(lowest_[at(pin)], lowest_[at(other)]);
        }
    }

    const TrussStructure& truss_;
    std::vector<bool> removed_;
    std::vector<int> order_, lowest_, found_;
    int count_ = 0;
};

}  // namespace

void Cuts::make_those_of_file(bool at_last) {
    for (std::size_t c = 0; c < truss_.mechanism().find.cuts.size(); ++c) {
        if (done_[c]) continue;
        std::vector<int> bars;
        for (const BodyIndex body : truss_.mechanism().find.cuts[c].bars)
            for (std::size_t bar = 0; bar < truss_.bars().size(); ++bar)
                if (truss_.structure().bars[bar].body == body) bars.push_back(static_cast<int>(bar));
        const auto sides = sides_of_cut(truss_.structure(), bars);
        const auto side =
            std::find_if(sides.begin(), sides.end(), [&](const auto& each) { return reactions_known(each); });
        if (side == sides.end() && !at_last) continue;
        done_[c] = true;
        if (side == sides.end())
            unsolved_.push_back(
                {{lang::phrases::cut_of_bars, {truss_.names_of(bars)}}, {lang::phrases::cut_without_reactions, {}}});
        else if (!make(bars, *side, true))
            unsolved_.push_back(
                {{lang::phrases::cut_of_bars, {truss_.names_of(bars)}}, {lang::phrases::cut_in_one_point, {}}});
    }
}

bool Cuts::reactions_known(const std::vector<int>& side) const {
    return std::all_of(truss_.supports().begin(), truss_.supports().end(),
                       [&](const KnownTruss::Support& support) { return support.known || !holds(side, support.pin); });
}

bool Cuts::make_any() {
    std::vector<int> known, unknown;
    std::vector<bool> removed;
    for (std::size_t bar = 0; bar < truss_.bars().size(); ++bar) {
        (truss_.bars()[bar].known ? known : unknown).push_back(static_cast<int>(bar));
        removed.push_back(truss_.bars()[bar].known);
    }
    for (std::size_t i = 0; i < unknown.size(); ++i)
        for (std::size_t j = i + 1; j < unknown.size(); ++j) {
            removed[at(unknown[i])] = removed[at(unknown[j])] = true;
            const BridgeBars third(truss_.structure(), removed);
            removed[at(unknown[i])] = removed[at(unknown[j])] = false;
            for (const int last : third.found()) {
                if (last < unknown[j]) continue;
                const std::vector<int> bars{unknown[i], unknown[j], last};
                for (const std::vector<int>& side : sides_of_cut(truss_.structure(), bars, known)) {
                    constexpr std::size_t least = 2;
                    if (side.size() < least || !reactions_known(side)) continue;
                    const KnownTruss::Mark before = truss_.mark();
                    truss_.say(lang::sentences::truss_stuck, {truss_.names_of(bars)});
                    if (make(bars, side, false)) return true;
                    truss_.rewind(before);
                }
            }
        }
    return false;
}

/// The sum of all forces on a side, without the cut bars.
Wrench Cuts::known_on(const std::vector<int>& side, const std::vector<int>& bars) {
    Wrench total;
    const auto add = [&](const std::optional<Force>& force, int pin) {
        if (!force) return;
        Wrench one;
        one.force = *force;
        one.place = truss_.place(pin);
        total = truss_.model().sum(total, one);
    };
    for (const int pin : side) {
        for (const int load : truss_.loads_at(pin)) add(truss_.load(load).force, pin);
        for (const KnownTruss::Support& support : truss_.supports())
            if (support.pin == pin) add(support.force, pin);
        for (const int bar : truss_.structure().pins[at(pin)].bars)
            if (!holds(bars, bar) && !holds(side, truss_.structure().other_end(bar, pin)))
                add(truss_.pull_on(bar, pin), pin);
    }
    return total;
}

/// The equation with one of three bars only: moments about the intersection of the others, or the components across
/// them if they are parallel.
std::optional<Cuts::Equation> Cuts::equation_for(const std::vector<int>& bars, std::size_t sought,
                                                 const Wrench& known) {
    const Action own = truss_.action_of(bars[sought]), one = truss_.action_of(bars[(sought + 1) % 3]),
                 two = truss_.action_of(bars[(sought + 2) % 3]);
    Equation equation;
    if (board_.parallel(one.direction, two.direction)) {
        const auto& ends = truss_.structure().bars[at(bars[(sought + 1) % 3])].pins;
        const auto along = board_.vector(truss_.place(ends[0]), truss_.place(ends[1]));
        equation.lever = board_.moment(along, own.direction);
        equation.moment = known.force ? board_.moment(board_.direction(along), *known.force) : board_.number(0);
    } else {
        equation.pivot = *board_.meet(one.line, two.line);
        equation.lever = board_.moment(board_.vector(*equation.pivot, own.place), own.direction);
        equation.moment = truss_.model().moment(known, *equation.pivot);
    }
    if (board_.is_zero(equation.lever)) return std::nullopt;
    return equation;
}

std::string Cuts::name_of_meet(PlaceOnDrawing meet) {
    for (int pin = 0; pin < truss_.pins(); ++pin)
        if (board_.coincide(meet, truss_.place(pin))) return truss_.name_of(pin).name;
    for (const auto& [name, where] : meets_)
        if (board_.coincide(meet, where)) return name;
    for (int number = 1;; ++number) {
        std::string name = "R" + std::to_string(number);  // Ritter's points
        if (truss_.mechanism().point_named(name)) continue;
        if (std::any_of(meets_.begin(), meets_.end(), [&](const auto& each) { return each.first == name; })) continue;
        meets_.emplace_back(name, meet);
        return name;
    }
}

bool Cuts::make(const std::vector<int>& bars, const std::vector<int>& side, bool asked) {
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
        const Equation& equation = equations[sought];
        const int bar = bars[sought];
        tell(bars, side, sought, equation, asked);
        const Action line = truss_.action_of(bar);
        const ScalarHandle size = board_.quotient(board_.opposite(equation.moment), equation.lever);
        const auto& ends = truss_.structure().bars[at(bar)].pins;
        const int pin = holds(side, ends[0]) ? ends[0] : ends[1];
        if (!truss_.bar(bar).known) truss_.settle(bar, pin, board_.scale<Plane::force>(size, line.direction));
    }
    return true;
}

void Cuts::tell(const std::vector<int>& bars, const std::vector<int>& side, std::size_t sought,
                const Equation& equation, bool asked) {
    const int bar = bars[sought];
    const Names all = truss_.names_of(bars);
    const PointName one{all[(sought + 1) % 3]}, two{all[(sought + 2) % 3]};
    Truss::Cut told{bars, side, bar, {}, {}, {}, none, asked};
    if (equation.pivot) {
        told.pivot_name = name_of_meet(*equation.pivot);
        told.pivot = Recorded<Vector>::at(equation.pivot->element);
        truss_.say(lang::sentences::truss_cut_moment,
                   {all, truss_.symbol_of(bar), one, two, PointName{told.pivot_name}}, "Ritter");
    } else {
        truss_.say(lang::sentences::truss_cut_across, {all, truss_.symbol_of(bar), one, two}, "Ritter");
    }
    told.moment = Recorded<Exact>::at(equation.moment.element);
    told.statement = truss_.statement();
    truss_.found().cuts.push_back(std::move(told));
}

}  // namespace kinegraph::statics
