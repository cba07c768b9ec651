// The rules in their order, body after body, until no more follows. A rule that does not apply leaves no stroke.
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

    /// The rules, until no more follows.
    void advance(const std::vector<Load>& loads, Run& run);
    /// What the structure, cut free whole, gives of its reactions. `hung`: two-force bars by which it hangs on the
    /// frame, and rollers; `bars`: the names of the bars among these.
    Run whole(const Group& hung, std::map<MemberIndex, std::string> bars);

private:
    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    LinesOfAction lines_;
    Magnitudes magnitudes_;
    long attempts_left_ = 500'000;  ///< of rules in trials: nobody draws on a system that large
};

}  // namespace kinegraph::statics
