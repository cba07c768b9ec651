#include "constructions/statics/truss/known_truss.hpp"
#include "lang/keys/sentences.hpp"

#include <vector>

namespace kinegraph::statics {
namespace {

/// Sets a zero-force bar at this pin; false if there is none.
bool settle_idle_at(KnownTruss& truss, int pin) {
    if (!truss.is_unloaded(pin)) return false;
    std::vector<int> left;
    for (const int bar : truss.structure().pins[at(pin)].bars)
        if (!truss.bar(bar).known)
            left.push_back(bar);
        else if (truss.bar(bar).pull)
            return false;
    const auto in_line = [&](int bar, int other) {
        return truss.board().parallel(truss.toward(bar, pin), truss.toward(other, pin));
    };
    const auto is_idle = [&](int bar) {
        truss.settle(bar, pin, std::nullopt);
        truss.found().bars[at(bar)].idle_by_rule = true;
    };
    if (left.size() == 1) {
        truss.say(lang::sentences::truss_idle_single, {truss.name_of(pin), truss.name_of_bar(left[0])});
        is_idle(left[0]);
        return true;
    }
    if (left.size() == 2 && !in_line(left[0], left[1])) {
        truss.say(lang::sentences::truss_idle_pair,
                  {truss.name_of(pin), truss.name_of_bar(left[0]), truss.name_of_bar(left[1])});
        is_idle(left[0]);
        is_idle(left[1]);
        return true;
    }
    if (left.size() != 3) return false;
    for (std::size_t third = 0; third < 3; ++third) {
        const int one = left[(third + 1) % 3], two = left[(third + 2) % 3];
        if (!in_line(one, two) || in_line(left[third], one)) continue;
        truss.say(lang::sentences::truss_idle_third,
                  {truss.name_of(pin), truss.name_of_bar(left[third]), truss.name_of_bar(one), truss.name_of_bar(two)});
        is_idle(left[third]);
        return true;
    }
    return false;
}

}  // namespace

void settle_idle_bars(KnownTruss& truss) {
    for (bool more = true; more;) {
        more = false;
        for (int pin = 0; pin < truss.pins(); ++pin) more = settle_idle_at(truss, pin) || more;
    }
}

}  // namespace kinegraph::statics
