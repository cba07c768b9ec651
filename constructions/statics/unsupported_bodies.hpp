// Unsupported bodies: those without unknown loads and without drivers, so the question is whether the given forces
// balance. Either nothing supports them, or joints to the frame leave a body free to move.
#pragma once

#include <optional>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "engine/motion/mobility.hpp"

namespace kinegraph::statics {

struct Unsupported {
    Group group;
    bool balanced = false;
    /// For a body on the frame that is not balanced and has one freedom: the place about which it turns, or the
    /// direction in which it slides.
    std::optional<PlaceOnDrawing> centre;
    std::optional<DirectionHandle> along;
};

/// Bodies without support; of those on the frame only the bodies that are not in equilibrium.
std::vector<Unsupported> unsupported_bodies(ForceModel& model, Board& board, const Mechanism& mechanism,
                                            const Mobility& mobility);

}  // namespace kinegraph::statics
