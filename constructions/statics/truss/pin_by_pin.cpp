#include "constructions/statics/truss/pin_by_pin.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

std::vector<PinByPin::Unknown> PinByPin::unknown_at(int pin) const {
    std::vector<Unknown> unknown;
    for (const int bar : truss_.structure().pins[at(pin)].bars)
        if (!truss_.bar(bar).known) unknown.push_back({bar, -1, truss_.toward(bar, pin)});
    for (std::size_t s = 0; s < truss_.supports().size(); ++s)
        if (truss_.supports()[s].pin == pin && !truss_.supports()[s].known)
            unknown.push_back({-1, static_cast<int>(s), truss_.supports()[s].line});
    return unknown;
}

/// The sum of all known forces at a pin; none if it vanishes.
std::optional<Force> PinByPin::known_at(int pin) {
    std::optional<Force> sum;
    const auto add = [&](const std::optional<Force>& force) { sum = truss_.sum(sum, force); };
    for (const int load : truss_.loads_at(pin)) add(truss_.load(load).force);
    for (const KnownTruss::Support& support : truss_.supports())
        if (support.pin == pin && support.known) add(support.force);
    for (const int bar : truss_.structure().pins[at(pin)].bars)
        if (truss_.bar(bar).known) add(truss_.pull_on(bar, pin));
    if (sum && board_.is_zero(*sum)) sum.reset();
    return sum;
}

void PinByPin::settle(int pin, const Unknown& unknown, const std::optional<Force>& force) {
    if (unknown.bar >= 0)
        truss_.settle(unknown.bar, pin, force);
    else
        truss_.settle(at(unknown.support), force);
}

/// Closes the polygon of a pin: with one force of any direction or along its line, or with two along theirs.
bool PinByPin::close(int pin, const std::vector<Unknown>& unknown) {
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

/// Writes the results at a pin; senses are read from the polygon.
void PinByPin::say(int pin, const std::vector<Unknown>& unknown) {
    std::vector<int> bars, tension, compression, idle;
    std::vector<Symbol> reactions;
    for (const Unknown& each : unknown) {
        if (each.bar < 0) {
            reactions.push_back(truss_.symbol_of(truss_.supports()[at(each.support)]));
            continue;
        }
        bars.push_back(each.bar);
        const auto pull = truss_.pull_on(each.bar, pin);
        (!pull ? idle : board_.along_sign(*each.along, *pull) > 0 ? tension : compression).push_back(each.bar);
    }
    Message& message = truss_.message();
    if (reactions.empty()) {
        message = {lang::sentences::truss_pin,
                   {truss_.name_of(pin), truss_.names_of(bars), truss_.names_of(tension), truss_.names_of(compression),
                    truss_.names_of(idle)}};
    } else if (bars.empty()) {
        message = {lang::sentences::truss_support, {truss_.name_of(pin), reactions}};
    } else {
        message = {lang::sentences::truss_bar_and_support,
                   {truss_.name_of(pin), truss_.name_of_bar(bars[0]), reactions[0]}};
    }
}

bool PinByPin::resolve(int pin) {
    const std::vector<Unknown> unknown = unknown_at(pin);
    const auto free = std::count_if(unknown.begin(), unknown.end(), [](const Unknown& each) { return !each.along; });
    if (unknown.empty() || unknown.size() + static_cast<std::size_t>(free) > 2) return false;
    const KnownTruss::Mark before = truss_.mark();
    truss_.say(lang::sentences::truss_pin, {}, "Cremona");
    if (!close(pin, unknown)) {
        truss_.rewind(before);
        return false;
    }
    say(pin, unknown);
    resolved_[at(pin)] = true;
    return true;
}

bool PinByPin::check_rest() {
    Names closed;
    for (int pin = 0; pin < truss_.pins(); ++pin) {
        if (resolved_[at(pin)]) continue;
        if (known_at(pin)) return false;
        const std::vector<int>& bars = truss_.structure().pins[at(pin)].bars;
        if (!truss_.is_unloaded(pin) ||
            std::any_of(bars.begin(), bars.end(), [&](int bar) { return truss_.bar(bar).pull.has_value(); }))
            closed.push_back(truss_.name_of(pin).name);
    }
    if (!closed.empty()) truss_.say(lang::sentences::truss_closes, {closed});
    return true;
}

}  // namespace kinegraph::statics
