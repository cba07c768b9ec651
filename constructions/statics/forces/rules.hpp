// Applies the rules in order, body after body, until no more follows. A rule that does not apply records nothing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "constructions/statics/forces/lines_of_action.hpp"
#include "constructions/statics/forces/magnitudes.hpp"

namespace kinegraph::statics {

class Rules {
public:
    Rules(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          lines_(model, board, known, said),
          magnitudes_(model, board, known, said) {}

    /// Applies the rules until no more follows.
    void advance(const std::vector<Load>& loads, Run& run);
    /// Finds what the structure as one free body gives of its reactions. `hung`: its two-force bars and rollers to the
    /// frame; `bars`: names of the bars among these.
    Run whole(const Group& hung, std::map<MemberIndex, std::string> bars);

private:
    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    LinesOfAction lines_;
    Magnitudes magnitudes_;
};

}  // namespace kinegraph::statics
