// Resultants of known forces on free bodies, and the arm of a couple of two forces. A resultant noted in a run is an
// auxiliary line of the construction; it is not an additional load.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

/// A known force or couple on a group.
struct Actor {
    Symbol symbol;
    std::optional<Force> force;
    PlaceOnDrawing place;
    int bond = -1;
};

class Resultants {
public:
    Resultants(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model), board_(board), known_(known), said_(said) {}

    std::vector<Actor> actors_on(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Adds several known forces to one, whose line is used next.
    void say_resultant(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run);
    /// The symbol of the only known force, or of the resultant.
    Symbol symbol_of_known(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Where the resultant of several known forces meets a line; none if there is only one known force.
    std::optional<PlaceOnDrawing> meet_of_resultant(const Group& group, const Action& line, const Wrench& known,
                                                    const std::vector<Load>& loads, Run& run);
    /// The sum of the known force and the first of three lines acts along Culmann's line.
    void note_culmann(const Group& group, int one, const std::string& names, Force force, PlaceOnDrawing met,
                      const std::vector<Load>& loads, Run& run);
    void note_lever(const Group& group, PlaceOnDrawing about, Force force, PlaceOnDrawing place, Run& run);
    /// The arm of a couple of two forces is their distance.
    void note_couple_of_two(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run);

private:
    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
