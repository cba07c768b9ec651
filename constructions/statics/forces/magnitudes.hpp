// Magnitudes: bodies cut free with no more than three unknowns, whatever their form. What is left alone, a force and a
// couple, two lines, a line and a pin or a guide, three lines (Culmann). It asks for lines of action, and finds none
// but by the triangle.
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
    /// What is left balances the rest.
    bool single(const Group& group, int b, const Wrench& known, const std::vector<Load>& loads, Run& run);
    /// A force through a point and a couple: the force is the rest turned round, the couple their arm times it.
    bool force_and_couple(const Group& group, int force, int couple, const Wrench& known,
                          const std::vector<Load>& loads, Run& run);
    bool line_and_pin(const Group& group, int line, int pin, const Wrench& known, const std::vector<Load>& loads,
                      Run& run);
    /// More than two forces on a structure, of several directions, or two whose sum meets the line `far` away: one
    /// funicular polygon adds them and parts the sum.
    bool several_by_strings(const Group& group, int line, int pin, const Wrench& known, bool far,
                            const std::vector<Load>& loads, Run& run);
    void say_strings(const Group& group, Sentence sentence, std::vector<Argument> arguments, const Strings& found);
    /// `couple_too`: the pair transmits a couple, and it vanishes.
    void say_no_force_along(const Group& group, int nothing, int all, bool couple_too);
    /// A guide takes its force at any place: directions give the triangle, the guide's couple the rest.
    bool line_and_guide(const Group& group, int line, int guide, const Wrench& known, const std::vector<Load>& loads,
                        Run& run);
    /// A guide's reaction balances what is left, force and couple.
    void settle_guide(int guide, Force across, const Wrench& rest, const Group& group, Run& run);
    bool two_lines(const Group& group, int one, int two, int couple, const Wrench& known,
                   const std::vector<Load>& loads, Run& run);
    /// Culmann: three lines that neither meet in one point nor are all parallel. The line through the meet of two pairs
    /// carries the sum of each pair.
    bool three_lines(const Group& group, const std::vector<int>& fixed, const Wrench& known,
                     const std::vector<Load>& loads, Run& run);
    /// The force of the first of three lines, and what it makes with the known one: along Culmann's line where the two
    /// meet, by moments about the pivot of the other two where they are parallel, or a couple.
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
