// What is known on bodies cut free, added up on the way: the forces one by one, the sentence of their resultant, the
// arm of a couple of two. What is noted in the run leads on and acts on nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/sentences.hpp"

namespace kinegraph::statics {

/// A force or couple that is known on a group.
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
    /// Several known forces are one first: its line is what meets the others.
    void say_resultant(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run);
    /// Of the one known force, or of the resultant that was said.
    Symbol symbol_of_known(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Where the resultant of several known forces, which is said, meets a line; nothing: of one there is nothing to be
    /// added.
    std::optional<PlaceOnDrawing> meet_of_resultant(const Group& group, const Action& line, const Wrench& known,
                                                    const std::vector<Load>& loads, Run& run);
    /// What the known force and the first of three lines make together acts along Culmann's line.
    void note_culmann(const Group& group, int one, const std::string& names, Force force, PlaceOnDrawing met,
                      const std::vector<Load>& loads, Run& run);
    void note_lever(const Group& group, PlaceOnDrawing about, Force force, PlaceOnDrawing place, Run& run);
    /// A couple of two forces has their distance for its arm.
    void note_couple_of_two(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run);

private:
    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
