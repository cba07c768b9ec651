// Runs added up, bond by bond: loads that acted alone, trials in their proportion, the components of a hinge. All is
// linear.
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
    /// a + s·b, bond by bond.
    Run combine(Run a, ScalarHandle share_a, Run b, ScalarHandle share_b);
    /// The components of a hinge that was tried by them are its force again.
    void gather_components(Run& run);

private:
    /// The sentence said last gives all at once.
    void found_in_parts(Run& run) const;
    void add_to(Run& total, const Run& b, std::optional<ScalarHandle> factor);
    void gather(Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    const ForceSentences& said_;
};

}  // namespace kinegraph::statics
