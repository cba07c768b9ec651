#include "constructions/positions/smooth_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinegraph {

std::vector<SmoothStretch> smooth_stretches(const Travel& travel, bool turns, const Law* law) {
    const double travelled = travel.at(1) - travel.at(0);
    if (law == nullptr) {
        constexpr double longest = std::numbers::pi / 64;
        constexpr int least = 128, most = 4096;
        const double turned = turns ? std::abs(travelled) : 0;
        return {{{travel.from, travel.to, travel.starts_at_limit, travel.ends_at_limit},
                 std::clamp(static_cast<int>(std::ceil(turned / longest)), least, most)}};
    }
    const double drawn = law->drawn.to_double();
    std::vector<double> breaks{travel.at(0)};
    const auto [first, last] = std::minmax({travel.at(0), travel.at(1)});
    double end = -drawn;
    const auto add = [&, first = first, last = last](double at) {
        if (at > first + 1e-9 * (last - first) && at < last - 1e-9 * (last - first)) breaks.push_back(at);
    };
    for (const LawPiece& piece : law->pieces) {
        add(end + piece.over.to_double() / 2);  // where a constant acceleration changes its sense
        end += piece.over.to_double();
        add(end);
    }
    add(-drawn);
    breaks.push_back(travel.at(1));
    std::sort(breaks.begin(), breaks.end());
    if (travelled < 0) std::reverse(breaks.begin(), breaks.end());
    std::vector<SmoothStretch> all;
    constexpr int intervals = 64;
    // Rates on a break are those of what follows in time.
    const double before = 1e-12 * (last - first);
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        double from = breaks[i - 1], to = breaks[i];
        if (i + 1 < breaks.size() && travelled > 0) to -= before;
        if (i > 1 && travelled < 0) from -= before;
        all.push_back({{from, to, false, false}, intervals});
    }
    return all;
}

}  // namespace kinegraph
