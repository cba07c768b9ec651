// Funicular polygons: pole, rays and strings by which forces along a line and at a place off it balance known ones,
// where their lines meet too far away or not at all (Culmann). Where nobody would draw one, there is none.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "constructions/statics/forces/resultants.hpp"

namespace kinegraph::statics {

class FunicularPolygons {
public:
    FunicularPolygons(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model), board_(board), known_(known), said_(said) {}

    /// Forces along a line and at a place off it that balance known ones: pole, rays and strings. Nothing: nobody draws
    /// it (in a trial, of a pin, of a couple, of very many forces, so deep that it leaves the sheet), or a string would
    /// not meet its line.
    std::optional<Strings> strings(const Group& group, std::vector<Actor> actors, Force sum, const Action& line,
                                   PlaceOnDrawing place);
    /// Both reactions, and the strings of the sentence said last.
    std::pair<Force, Force> by_strings(Strings found, int line, int pin, Force sum, const Group& group, Run& run);
    /// So far away that nobody draws to it; from a whole, farther than it reaches.
    bool is_far(const Group& group, PlaceOnDrawing met, PlaceOnDrawing place, PlaceOnDrawing one, PlaceOnDrawing two);

private:
    /// Known forces along the line on which they are told: as far as that is a choice, from the place to the line.
    void sort_along(std::vector<Actor>& actors, PlaceOnDrawing from, PlaceOnDrawing to);
    /// Through the place and from known line to known line; false: a string does not meet its line.
    bool draw_strings(Strings& found, const std::vector<Actor>& actors, const Action& line, PlaceOnDrawing place);
    /// Beside the middle of the sum. Of several bodies also farther along it: the strings then run aslant to it, where
    /// its own perpendicular would not lead to the lines.
    std::vector<PointOn<Plane::force>> poles(const std::vector<PointOn<Plane::force>>& corners, Force sum,
                                             bool several);
    /// Times the sum of the forces. As far from them as they are long: strings between parallel forces are then a
    /// quarter as deep as they are wide, at most. Nothing: the sum is small beside what is added.
    std::optional<Exact> pole_distance(const std::vector<PointOn<Plane::force>>& corners, Force sum);
    /// Whether a string ends farther from where its force acts than so many times what the structure reaches.
    bool is_deep(const std::vector<PlaceOnDrawing>& vertices, const std::vector<Actor>& actors, const Action& line,
                 const Exact& times);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
