// Sums of runs, bond by bond: of loads that acted alone, of trials in their proportion, of the components of a hinge.
// All is linear.
#pragma once

#include <optional>
#include <vector>

#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

class Sums {
public:
    Sums(ForceModel& model, Board& board, const KnownForces& known, const ForceSentences& said)
        : model_(model), board_(board), known_(known), said_(said) {}

    Run add_up(std::vector<PartRun> parts);
    /// a + s·b for each bond, from two shares.
    Run combine(Run a, ScalarHandle share_a, Run b, ScalarHandle share_b);
    /// Adds the components of a hinge, used in a trial, to its force.
    void gather_components(Run& run);

private:
    /// Marks that the last sentence gives all at once.
    void found_in_parts(Run& run) const;
    void add_to(Run& total, const Run& b, std::optional<ScalarHandle> factor);
    void gather(Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    const ForceSentences& said_;
};

}  // namespace kinegraph::statics
