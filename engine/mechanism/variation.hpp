// The lattice of all values that the parameters of an exercise may take together, and the order in which a seed draws
// from it. Whole numbers only: the same on every machine. Knows no mechanism.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/exercise.hpp"

namespace kinegraph {

/// All digits of a fraction that is a decimal; nothing of one that goes on for ever.
std::optional<std::string> decimal_text(const Exact& value);

/// Every combination of the values of some parameters, numbered from 0.
class Lattice {
public:
    /// How many there are; nothing where they are beyond `most`.
    static std::optional<std::uint64_t> size(const std::vector<Variation>& vary);
    static constexpr std::uint64_t most = std::uint64_t{1} << 62;

    /// The combination of this number: a setting for each variation, in their order.
    static std::vector<Setting> at(const std::vector<Variation>& vary, std::uint64_t number);
};

/// The numbers 0 … size − 1 in an order that a seed chooses, each once: a Feistel network on the next even power of
/// two, walked until it comes back below `size` (Black and Rogaway, Ciphers with arbitrary finite domains, 2002). Any
/// place of the order is found without those before it.
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
