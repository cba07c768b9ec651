// Magnitudes: free bodies with at most three unknowns of any form: one unknown, a force and a couple, two lines, a line
// and a pin or a guide, three lines (Culmann).
#pragma once

#include <utility>
#include <vector>

#include "constructions/statics/forces/balancing.hpp"
#include "constructions/statics/forces/funicular.hpp"
#include "constructions/statics/forces/settling.hpp"

namespace kinegraph::statics {

class Magnitudes {
public:
    Magnitudes(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          settled_(model, board, said),
          balance_(model, board),
          resultants_(model, board, known, said),
          funicular_(model, board, known, said) {}

    bool magnitudes(const Group& group, const std::vector<Load>& loads, Run& run);

private:
    /// One unknown balances the known forces.
    bool single(const Group& group, int b, const Wrench& known, const std::vector<Load>& loads, Run& run);
    /// A force through a point and a couple: the force is opposite to the known one, the couple is force times arm.
    bool force_and_couple(const Group& group, int force, int couple, const Wrench& known,
                          const std::vector<Load>& loads, Run& run);
    bool line_and_pin(const Group& group, int line, int pin, const Wrench& known, const std::vector<Load>& loads,
                      Run& run);
    /// More than two forces of several directions on a structure, or two whose sum meets the line too `far` away: one
    /// funicular polygon adds them and resolves the sum.
    bool several_by_funicular(const Group& group, int line, int pin, const Wrench& known, bool far,
                              const std::vector<Load>& loads, Run& run);
    void say_funicular(const Group& group, Key sentence, std::vector<Argument> arguments, const Funicular& found);
    /// `couple_too`: the pair can transmit a couple, and it vanishes.
    void say_no_force_along(const Group& group, int nothing, int all, bool couple_too);
    /// A guide takes its force at any place: the triangle gives the forces, the remaining moment is the guide's couple.
    bool line_and_guide(const Group& group, int line, int guide, const Wrench& known, const std::vector<Load>& loads,
                        Run& run);
    /// The last sentence also says where the couple of a bond comes from: moments about the point of another.
    void say_moment(ScalarHandle couple, int of, int about, const Group& group);
    bool two_lines(const Group& group, int one, int two, int couple, const Wrench& known,
                   const std::vector<Load>& loads, Run& run);
    /// Culmann: three lines that are neither concurrent nor all parallel. The line through the intersections of two
    /// pairs carries the sum of each pair.
    bool three_lines(const Group& group, const std::vector<int>& fixed, const Wrench& known,
                     const std::vector<Load>& loads, Run& run);
    /// The force of the first of three lines, and its sum with the known one: along Culmann's line, or by moments
    /// about the pivot of the other two if the known one is a couple, is parallel or meets the first in the pivot.
    std::pair<Force, Wrench> known_and_one(const Group& group, const Wrench& known, int one, int two, int three,
                                           PlaceOnDrawing pivot, const std::vector<Load>& loads, Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Settling settled_;
    Balancing balance_;
    Resultants resultants_;
    FunicularPolygons funicular_;
};

}  // namespace kinegraph::statics
