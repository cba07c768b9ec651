#include "engine/mechanism/pair_catalogue.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

/// The tree of a Prüfer sequence: repeatedly, the smallest leaf is joined to the next body of the sequence.
BinaryScheme tree_of(const std::vector<int>& sequence) {
    const std::size_t bodies = sequence.size() + 2;
    std::vector<int> degree(bodies, 1);
    for (const int body : sequence) ++degree[static_cast<std::size_t>(body)];
    BinaryScheme scheme;
    const auto join = [&](int a, int b) {
        scheme.hinges.push_back({std::min(a, b), std::max(a, b)});
        --degree[static_cast<std::size_t>(a)];
        --degree[static_cast<std::size_t>(b)];
    };
    const auto leaf = [&] { return static_cast<int>(std::find(degree.begin(), degree.end(), 1) - degree.begin()); };
    for (const int body : sequence) join(leaf(), body);
    const int last = leaf();
    join(last, static_cast<int>(std::find(degree.begin() + last + 1, degree.end(), 1) - degree.begin()));
    std::sort(scheme.hinges.begin(), scheme.hinges.end());
    return scheme;
}

}  // namespace

std::vector<BinaryScheme> binary_schemes(int bodies) {
    KG_ASSERT(bodies >= 2, "a hinge joins two bodies at least");
    std::vector<int> sequence(static_cast<std::size_t>(bodies) - 2, 0);
    std::vector<BinaryScheme> schemes;
    while (true) {
        schemes.push_back(tree_of(sequence));
        auto digit = sequence.rbegin();
        while (digit != sequence.rend() && *digit == bodies - 1) *digit++ = 0;
        if (digit == sequence.rend()) return schemes;
        ++*digit;
    }
}

}  // namespace kinegraph
