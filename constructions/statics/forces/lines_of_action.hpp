// Lines of action, found before magnitudes: of bodies under two forces, three forces with two known lines (Culmann),
// two forces and a couple, parallel forces.
#pragma once

#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/resultants.hpp"
#include "constructions/statics/forces/settling.hpp"

namespace kinegraph::statics {

class LinesOfAction {
public:
    LinesOfAction(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          resultants_(model, board, known, said),
          settled_(model, board, said) {}

    /// `beside_couples`: also bodies with a couple; tried last.
    bool lines(const Group& group, const std::vector<Load>& loads, Run& run, bool beside_couples);
    /// All other forces on a body are parallel, known or not, so the force at its pin is parallel too.
    bool parallel_to_all(const Group& group, const std::vector<Load>& loads, Run& run);
    /// All known forces on a body pass through its pin. By moments about it the guide's reaction passes there too.
    bool through_pin(const Group& group, const std::vector<Load>& loads, Run& run);

private:
    void note_balanced(const Wrench& known, const Group& group, const std::vector<Load>& loads, const Run& run);
    /// A sentence of the body's other forces, which says what acts besides them.
    void say_of_others(const Group& group, Key sentence, std::vector<Argument> arguments, const char* source = "");
    /// Two forces only: equal, opposite, on one line.
    bool two_forces(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                    const std::vector<int>& fixed, Run& run);
    /// Two forces and a couple: the forces are equal and opposite, so parallel.
    bool parallel_to_other(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                           const std::vector<int>& fixed, Run& run);
    /// Three forces, two known lines: the third passes through their intersection.
    bool concurrent(const Group& group, const std::vector<int>& fixed, const std::vector<int>& pins,
                    const std::vector<int>& guides, Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Resultants resultants_;
    Settling settled_;
    Symbols balanced_;  ///< the known forces on the body in question, which are in equilibrium
};

}  // namespace kinegraph::statics
