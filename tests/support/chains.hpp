// Kinematic chains with one freedom and hinges only, found by enumeration: the four-bar, the two six-bars (Watt,
// Stephenson), the sixteen eight-bars. Random mechanisms built on them: any link is the frame, any body is driven, some
// pairs are replaced by others. Any position of the pins is a valid pose, since the links join the pins.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kinegraph {

/// Links 0 … links−1; each joint is a hinge of two of them.
struct Chain {
    int links = 0;
    std::vector<std::pair<int, int>> joints;

    std::vector<int> neighbours(int link) const;
    int degree(int link) const { return static_cast<int>(neighbours(link).size()); }
};

/// All chains with this number of links (even, at most 8) and 3(n−1) − 2j = 1, in which each link has at least two
/// joints and no part is rigid (every set of k links has at most (3k−4)/2 joints). Each once up to isomorphism, in a
/// fixed order.
std::vector<Chain> chains_of(int links);

/// The chains of four, six and eight links.
const std::vector<Chain>& all_chains();

/// A chain with a frame link and a driven link.
struct Inversion {
    int chain = 0;  ///< index into all_chains()
    int frame = 0, driven = 0;
};
/// All of them: 4·3 + 2·6·5 + 16·8·7.
const std::vector<Inversion>& all_inversions();

struct ChainMechanism {
    std::string text;    ///< a mechanism file with one driver and one input force or couple, no loads
    std::string recipe;  ///< "chain 5, frame 2, driven 7, 3-4 slides …": for messages
    Inversion inversion;
};

/// The mechanism of a seed. Successive seeds go through all inversions again and again, each time with other
/// dimensions.
ChainMechanism random_chain_mechanism(std::uint64_t seed);

}  // namespace kinegraph
