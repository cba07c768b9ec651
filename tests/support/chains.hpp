// Kinematic chains with one freedom and hinges only: the four-bar, the two six-bars (Watt, Stephenson), the sixteen
// eight-bars, found by enumeration; and random mechanisms built on them: any link as frame, any body driven, some pairs
// replaced by others. Any placing of the pins is a pose: the links are whatever joins them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kinegraph {

/// Links 0 … links−1; each joint hinges two of them.
struct Chain {
    int links = 0;
    std::vector<std::pair<int, int>> joints;

    std::vector<int> neighbours(int link) const;
    int degree(int link) const { return static_cast<int>(neighbours(link).size()); }
};

/// All chains of so many links (even, up to 8) with 3(n−1) − 2j = 1, links of two joints or more, and no part of them
/// rigid (every set of k links holds at most (3k−4)/2 joints), each once up to the naming of its links, in a fixed
/// order.
std::vector<Chain> chains_of(int links);

/// The chains of four, six and eight links.
const std::vector<Chain>& all_chains();

/// A chain with one of its links as frame and another driven.
struct Inversion {
    int chain = 0;  ///< index into all_chains()
    int frame = 0, driven = 0;
};
/// Every one of them: 4·3 + 2·6·5 + 16·8·7.
const std::vector<Inversion>& all_inversions();

struct ChainMechanism {
    std::string text;    ///< a mechanism file with one driver and one effort, no loads
    std::string recipe;  ///< "chain 5, frame 2, driven 7, 3-4 slides …": what was drawn, for messages
    Inversion inversion;
};

/// The mechanism of a seed: seeds one after the other go through all inversions, again and again, each time drawn
/// otherwise.
ChainMechanism random_chain_mechanism(std::uint64_t seed);

}  // namespace kinegraph
