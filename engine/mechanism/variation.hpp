// The set of all combinations of parameter values of an exercise, and the order in which a seed draws from it. Integers
// only: the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/exercise.hpp"

namespace kinegraph {

/// All digits of a fraction with a finite decimal expansion; empty for any other.
std::optional<std::string> decimal_text(const Exact& value);

/// Every combination of the values of some parameters, numbered from 0.
class Lattice {
public:
    /// The number of combinations; empty where it exceeds `most`.
    static std::optional<std::uint64_t> size(const std::vector<Variation>& vary);
    static constexpr std::uint64_t most = std::uint64_t{1} << 62;

    /// The combination with this number: a setting for each variation, in their order.
    static std::vector<Setting> at(const std::vector<Variation>& vary, std::uint64_t number);
};

/// The numbers 0 … size − 1 in an order that a seed chooses, each once: a Feistel network on the next even power of
/// two, iterated until the value is below `size` (cycle walking; Black and Rogaway, Ciphers with arbitrary finite
/// domains, 2002). Any element is computed without the earlier ones.
class Shuffle {
public:
    Shuffle(std::uint64_t seed, std::uint64_t size);
    std::uint64_t at(std::uint64_t place) const;

private:
    std::uint64_t encrypted(std::uint64_t number) const;
    static constexpr std::size_t rounds = 8;
    std::uint64_t size_;
    unsigned half_bits_;
    std::array<std::uint64_t, rounds> keys_{};
};

}  // namespace kinegraph
