// Funicular polygons: pole, rays and strings of forces along a line and at a place off it that balance known forces.
// Used if the lines meet too far away or not at all (Culmann).
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

    /// Strings for forces along a line and at a place off it that balance known ones. None if the drawing would be
    /// unreadable (for a pin, for a couple, for very many forces, too deep for the sheet) or a string does
    /// not meet its line.
    std::optional<Funicular> drawn(const Group& group, std::vector<Actor> actors, Force sum, const Action& line,
                                   PlaceOnDrawing place);
    /// Both reactions, and the strings for the last sentence.
    std::pair<Force, Force> by_funicular(Funicular found, int line, int pin, Force sum, const Group& group, Run& run);
    /// Whether the meet is too far away to draw; for a structure as one free body: farther away than its own extent.
    bool is_far(const Group& group, PlaceOnDrawing met, PlaceOnDrawing place, PlaceOnDrawing one, PlaceOnDrawing two);

private:
    /// Sorts known forces along the line on which they are drawn, from the place to the line.
    void sort_along(std::vector<Actor>& actors, PlaceOnDrawing from, PlaceOnDrawing to);
    /// Draws strings from the place, from known line to known line; false if a string does not meet its line.
    bool draw(Funicular& found, const std::vector<Actor>& actors, const Action& line, PlaceOnDrawing place);
    /// Candidate poles beside the middle of the sum. For several bodies also farther along it: then the strings are
    /// oblique to the sum and can reach lines that its perpendicular would miss.
    std::vector<PointOn<Plane::force>> poles(const std::vector<PointOn<Plane::force>>& corners, Force sum,
                                             bool several);
    /// As a multiple of the sum of the forces; the distance is about the length of all forces, so strings between
    /// parallel forces are at most a quarter as deep as they are wide. None above `most`: the sum is small compared to
    /// its terms.
    std::optional<Exact> pole_distance(const std::vector<PointOn<Plane::force>>& corners, Force sum, int most);
    /// Whether a string ends farther from its force's point than `times` the extent of the structure.
    bool is_deep(const std::vector<PlaceOnDrawing>& vertices, const std::vector<Actor>& actors, const Action& line,
                 const Exact& times);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
};

}  // namespace kinegraph::statics
