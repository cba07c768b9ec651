// Random mechanisms as file text: a driven body or two and a chain of dyads, up to twelve bodies, the same on every
// machine. Refuses degenerate draws by measures of its own (doubles over its own places); knows nothing of what the
// program makes of them.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <string_view>

#include "tests/support/sanitized.hpp"

namespace kinegraph {

/// std::mt19937_64 is the same everywhere, the distributions of <random> are not: so these are our own.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// Uniform in [least, most].
    int whole(int least, int most);
    bool chance(int percent) { return whole(1, 100) <= percent; }
    double real(double least, double most);

private:
    std::mt19937_64 engine_;
};

struct RandomMechanism {
    std::string text;         ///< a mechanism file (JSON)
    int bodies = 0;           ///< the frame counted
    int freedoms = 0;         ///< as many as there are drivers
    bool by_compass = false;  ///< some of its points are placed by polar, ratio or compass constructions
    std::string recipe;       ///< "crank RRR pin-in-slot …": what was drawn, for messages
};

/// The mechanism of a seed.
RandomMechanism random_mechanism(std::uint64_t seed);

/// As many as that; under sanitizers, where everything takes several times as long, fewer.
constexpr int unless_sanitized([[maybe_unused]] int count, [[maybe_unused]] int sanitized) {
#if defined(KINEGRAPH_SANITIZED)
    return sanitized;
#else
    return count;
#endif
}
constexpr int default_random_count = unless_sanitized(1000, 200);

/// Calls `hold` with every fourth seed from `quarter` on, until it has said a quarter of `count` times (of
/// KINEGRAPH_RANDOM_MECHANISMS, where that is set) that the draw counted; four entries for ctest to run side by side.
/// Stops when `failed` says so: one mechanism with all the laws it breaks reads better than many. KINEGRAPH_SEED=n runs
/// that one alone. False: too few draws counted.
bool hold_quarter(int quarter, int count, const std::function<bool(std::uint64_t)>& hold,
                  const std::function<bool()>& failed);

/// Frame, crank, and `dyads` RRR dyads one after the other, every point a decimal: 2 + 2·dyads bodies. For benchmarks.
RandomMechanism chain_of_dyads(int dyads, std::uint64_t seed);

}  // namespace kinegraph
