// Which equations of a sparse linear system can be solved together, and in which order, by structure alone
// (Dulmage and Mendelsohn, Coverings of bipartite graphs, 1958).
#pragma once

#include <cstddef>
#include <vector>

namespace kinegraph::statics {

/// As many equations as unknowns; the equations contain no other unknown.
struct SolvableBlock {
    std::vector<std::size_t> unknowns, equations;
};

/// The blocks that contain no smaller one, smallest first. `unknowns_in`: by equation. `owner`: by equation; equations
/// of one owner are never separated.
std::vector<SolvableBlock> solvable_blocks(const std::vector<std::vector<std::size_t>>& unknowns_in,
                                           const std::vector<std::size_t>& owner, std::size_t unknowns);

}  // namespace kinegraph::statics
