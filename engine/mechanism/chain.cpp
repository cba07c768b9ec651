#include "engine/mechanism/chain.hpp"

#include <algorithm>
#include <numeric>

namespace kinegraph {

KinematicChain::Kind KinematicChain::kind() const {
    if (loops == 0) return Kind::open;
    return std::any_of(pairs.begin(), pairs.end(), [](int count) { return count < 2; }) ? Kind::mixed : Kind::closed;
}

KinematicChain chain_of(const Mechanism& mechanism) {
    KinematicChain chain;
    chain.pairs.assign(mechanism.bodies.size(), 0);
    // Connected components by union-find: connected bodies have the same root.
    std::vector<std::size_t> above(mechanism.bodies.size());
    std::iota(above.begin(), above.end(), std::size_t{0});
    const auto root = [&](std::size_t body) {
        while (above[body] != body) body = above[body];
        return body;
    };
    chain.parts = static_cast<int>(mechanism.bodies.size());
    for (const Joint& joint : mechanism.joints) {
        chain.joints += static_cast<int>(joint.bodies.size()) - 1;
        for (const BodyIndex body : joint.bodies) {
            ++chain.pairs[at_index(body)];
            const std::size_t here = root(at_index(body)), there = root(at_index(joint.bodies.front()));
            if (here == there) continue;
            above[here] = there;
            --chain.parts;
        }
    }
    chain.loops = chain.joints - static_cast<int>(mechanism.bodies.size()) + chain.parts;
    return chain;
}

}  // namespace kinegraph
