// Writes into a run what a rule has found of a bond, and which sentence found it: a line of action, a force, a couple,
// that there is none. It does not ask whether that is right.
#pragma once

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

class Settling {
public:
    Settling(ForceModel& model, Board& board, ForceSentences& said) : model_(model), board_(board), said_(said) {}

    /// What the sentence said last finds of a bond, or says of it.
    void found_line(int b, Run& run) const;
    void found(int b, const Group& group, Run& run);
    void settle_line(int b, const Action& found, Run& run);
    void vanish(int b, const Group& group, Run& run);
    void settle(int b, Force force_on_group, PlaceOnDrawing place, const Group& group, Run& run);
    /// A guide or a clamp takes force and couple: its real line is moved aside by their arm.
    void settle_with_couple(int b, Force force_on_group, ScalarHandle couple_on_group, const Group& group, Run& run);
    void settle_couple(int b, ScalarHandle couple_on_group, const Group& group, Run& run);

private:
    ForceModel& model_;
    Board& board_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
