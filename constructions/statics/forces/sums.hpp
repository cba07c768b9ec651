// The sum of the runs of loads that acted alone, bond by bond: all is linear.
#pragma once

#include <vector>

#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

class Sums {
public:
    Sums(Board& board, const KnownForces& known, const ForceSentences& said)
        : board_(board), known_(known), said_(said) {}

    Run add_up(std::vector<PartRun> parts);

private:
    /// Marks that the last sentence gives all at once.
    void found_in_parts(Run& run) const;
    void add_to(Run& total, const Run& b);

    Board& board_;
    const KnownForces& known_;
    const ForceSentences& said_;
};

}  // namespace kinegraph::statics
