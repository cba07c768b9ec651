// Lines of action before magnitudes: bodies under two forces, under three of which two lines are known (Culmann), under
// two and a couple, under parallel ones.
#pragma once

#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/settling.hpp"

namespace kinegraph::statics {

class LinesOfAction {
public:
    LinesOfAction(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model), board_(board), known_(known), said_(said), settled_(model, board, said) {}

    /// `beside_couples`: bodies that carry a couple too; tried when nothing else is left.
    bool lines(const Group& group, const std::vector<Load>& loads, Run& run, bool beside_couples);
    /// All other forces on a body are parallel, known or not: across them nothing balances a force at its pin.
    bool parallel_to_all(const Group& group, const std::vector<Load>& loads, Run& run);
    /// What is known on a body passes its pin: moments about that leave none to the guide, so its reaction passes there
    /// too.
    bool through_pin(const Group& group, const std::vector<Load>& loads, Run& run);

private:
    /// Two forces only: equal, opposite, on one line.
    bool two_forces(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                    const std::vector<int>& fixed, Run& run);
    /// Two forces and a couple: the forces are equal and opposite, so parallel.
    bool parallel_to_other(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                           const std::vector<int>& fixed, Run& run);
    /// Three forces, two lines known: the third passes through their meet.
    bool concurrent(const Group& group, const std::vector<int>& fixed, const std::vector<int>& pins,
                    const std::vector<int>& guides, Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Settling settled_;
};

}  // namespace kinegraph::statics
