// Forces that balance a known one: its opposite, along a line by moments about a place (Ritter), along two directions
// by the force triangle. Operations of the board only.
#pragma once

#include <optional>
#include <utility>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

class Balancing {
public:
    Balancing(ForceModel& model, Board& board) : model_(model), board_(board) {}

    Force opposite(const Wrench& known) { return board_.negate(*known.force); }
    /// The component of −F that a line or a guide can give. It is all of −F if the loads allow equilibrium; else the
    /// difference appears as a gap.
    Force opposite_along(const Wrench& known, DirectionHandle direction);
    /// A force s·d along a line whose moment about a place balances the known one (Ritter).
    std::optional<Force> by_moments(const Action& line, PlaceOnDrawing about, const Wrench& known);
    /// Closes F + X + Y = 0 with X along d and Y along e, not parallel (force triangle).
    std::pair<Force, Force> triangle(const Wrench& known, DirectionHandle d, DirectionHandle e);
    /// Whether the known force is parallel to the line. Then there is no triangle.
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
