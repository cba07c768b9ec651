#include "render/mechanism/centre_choice.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

namespace {

/// Names of the centres on which sentences measure. A sentence that finds a centre does not make it needed: the list of
/// centres has them all.
std::set<std::string> measured_on(const Solution& solution) {
    std::set<std::string> names;
    for (const Statement& statement : solution.protocol.statements) {
        if (statement.section == Topic::centres) continue;
        for (const Argument& argument : statement.message.arguments)
            if (const auto* symbol = std::get_if<Symbol>(&argument); symbol && symbol->letter == Symbol::Letter::centre)
                names.insert(name_of(*symbol));
    }
    return names;
}

}  // namespace

std::size_t index_of_centre(const Mechanism& mechanism, BodyIndex i, BodyIndex j) {
    if (i > j) std::swap(i, j);
    const std::size_t count = mechanism.bodies.size(), row = at_index(i), column = at_index(j);
    return row * (2 * count - row - 1) / 2 + (column - row - 1);
}

std::vector<bool> needed_centres(const Solution& solution) {
    const std::vector<InstantCentre>& all = solution.centres;
    const std::set<std::string> cited = measured_on(solution);
    std::vector<std::size_t> wanted;
    for (std::size_t c = 0; c < all.size(); ++c)
        if (all[c].first == frame || all[c].how == InstantCentre::How::primary ||
            cited.contains(name_of(symbol_of(solution.mechanism, all[c]))))
            wanted.push_back(c);
    std::vector<bool> needed(all.size(), false);
    while (!wanted.empty()) {
        const std::size_t c = wanted.back();
        wanted.pop_back();
        if (needed[c]) continue;
        needed[c] = true;
        for (const auto& [a, b] : all[c].through)
            for (const int one : {a, b}) wanted.push_back(at_index(one));
    }
    return needed;
}

}  // namespace kinegraph::render::drawing
