// Stores in a run what a rule has found for a bond: a line of action, a force, a couple, or zero; and the sentence that
// found it.
#pragma once

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

class Settling {
public:
    Settling(ForceModel& model, Board& board, ForceSentences& said) : model_(model), board_(board), said_(said) {}

    /// Notes which results of a bond the last sentence finds.
    void found_line(int b, Run& run) const;
    void found(int b, const Group& group, Run& run);
    void settle_line(int b, const Action& found, Run& run);
    void vanish(int b, const Group& group, Run& run);
    void settle(int b, Force force_on_group, PlaceOnDrawing place, const Group& group, Run& run);
    /// A guide or a clamp transmits force and couple: its line of action is offset by their arm.
    void settle_with_couple(int b, Force force_on_group, ScalarHandle couple_on_group, const Group& group, Run& run);
    void settle_couple(int b, ScalarHandle couple_on_group, const Group& group, Run& run);

private:
    ForceModel& model_;
    Board& board_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
