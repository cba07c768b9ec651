#include "engine/sentences/centre_symbol.hpp"

#include <algorithm>
#include <cctype>

namespace kinegraph {
namespace {

/// P1, C12.
bool looks_like_a_centre(const NamedPoint& point) {
    const std::string& name = point.name;
    return name.size() > 1 && (name[0] == 'P' || name[0] == 'C') &&
           std::all_of(name.begin() + 1, name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

std::string free_name(const Mechanism& mechanism, const std::string& letter) {
    std::string candidate = letter;
    for (int n = 2; mechanism.point_named(candidate); ++n) candidate = letter + std::to_string(n);
    return candidate;
}

Symbol centre_symbol(const Mechanism& mechanism, BodyIndex first, BodyIndex second, bool at_infinity) {
    const std::string &i = mechanism.body(first).name, &j = mechanism.body(second).name;
    const bool together = i.size() == 1 && j.size() == 1 &&
                          std::none_of(mechanism.points.begin(), mechanism.points.end(), looks_like_a_centre);
    return {Symbol::Letter::centre, together ? i + j : i + "," + j, at_infinity ? "∞" : ""};
}

}  // namespace kinegraph
