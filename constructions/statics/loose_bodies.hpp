// Loose bodies: those of which it is asked whether what is given on them is in equilibrium, for no effort holds them
// and nothing drives. Either nothing holds them at all, or a body hangs on the frame by joints that leave it free to
// move.
#pragma once

#include <optional>
#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

struct Loose {
    Group group;
    bool balanced = false;
    /// Of a body on the frame that is not balanced and has one freedom: the place about which it turns, or along which
    /// it goes.
    std::optional<PlaceOnDrawing> centre;
    std::optional<DirectionHandle> along;
};

/// Those that nothing holds; of those on the frame the bodies that are out of balance.
std::vector<Loose> loose_bodies(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility);

}  // namespace kinegraph::statics
