// Forces that balance a known one: opposite to it, along a line by moments about a place (Ritter), along two directions
// by the force triangle. Strokes of the board alone, no bonds and no sentences.
#pragma once

#include <optional>
#include <utility>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

class Balancing {
public:
    Balancing(ForceModel& model, Board& board) : model_(model), board_(board) {}

    Force opposite(const Wrench& known) { return board_.negate(*known.force); }
    /// The part of −F that a line or a guide can give: all of it where the loads allow equilibrium; what is missing
    /// shows as a gap.
    Force opposite_along(const Wrench& known, DirectionHandle direction);
    /// s·d of a force along a line, so that its moment about a place balances the known one (Ritter).
    std::optional<Force> by_moments(const Action& line, PlaceOnDrawing about, const Wrench& known);
    /// Closes F + X + Y = 0 with X along d, Y along e, not parallel: the force triangle.
    std::pair<Force, Force> triangle(const Wrench& known, DirectionHandle d, DirectionHandle e);
    /// No triangle closes with a force that is nothing.
    bool is_along(const Wrench& known, const Action& line);
    static Wrench wrench_at(Force force, PlaceOnDrawing place);
    Wrench nonzero(Force force, PlaceOnDrawing place) {
        return board_.is_zero(force) ? Wrench{} : wrench_at(force, place);
    }

private:
    ForceModel& model_;
    Board& board_;
};

}  // namespace kinegraph::statics
