// Random mechanisms as file text: one or two driven bodies and a chain of dyads, at most twelve bodies, the same on
// every machine. Rejects degenerate draws by its own tests in doubles, independently of the program.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <string_view>

#include "tests/support/sanitized.hpp"

namespace kinegraph {

/// std::mt19937_64 is the same on every machine, but the distributions of <random> are not; hence our own.
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
    int bodies = 0;           ///< with the frame
    int freedoms = 0;         ///< equal to the number of drivers
    bool by_compass = false;  ///< some points are given by polar, ratio or compass constructions
    std::string recipe;       ///< "crank RRR pin-in-slot …": for messages
};

/// The mechanism of a seed.
RandomMechanism random_mechanism(std::uint64_t seed);

/// `count`; under sanitizers, which slow everything several times, `sanitized`.
constexpr int unless_sanitized([[maybe_unused]] int count, [[maybe_unused]] int sanitized) {
#if defined(KINEGRAPH_SANITIZED)
    return sanitized;
#else
    return count;
#endif
}
constexpr int default_random_count = unless_sanitized(1000, 200);

/// Calls `hold` with every fourth seed from `quarter` on, until a quarter of `count` draws (of
/// KINEGRAPH_RANDOM_MECHANISMS, if set) were valid, that is `hold` returned true. The four quarters are four ctest
/// entries that run in parallel. Stops when `failed` returns true: the violations of one mechanism are easier to read
/// than those of many. KINEGRAPH_SEED=n runs that seed only. Returns false if too few draws were valid.
bool hold_quarter(int quarter, int count, const std::function<bool(std::uint64_t)>& hold,
                  const std::function<bool()>& failed);

/// Frame, crank, and `dyads` RRR dyads in a chain, every point a decimal: 2 + 2·dyads bodies. For benchmarks.
RandomMechanism chain_of_dyads(int dyads, std::uint64_t seed);

}  // namespace kinegraph
