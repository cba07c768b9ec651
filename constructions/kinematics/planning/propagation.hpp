// What follows without a meet: ω by joints and drivers, bodies by a point and ω or by two points, points over rolling
// contacts, slides that are driven.
#pragma once

#include <vector>

#include "constructions/kinematics/planning/known_motion.hpp"

namespace kinegraph::planning {

class Propagation {
public:
    Propagation(Structure& structure, const std::vector<bool>& drivers, KnownMotion& known)
        : structure_(structure), mechanism_(structure.mechanism()), use_driver_(drivers), known_(known) {}

    void propagate();
    bool slide_by_driver();
    /// The places by which higher pairs hold their bodies, on both; the file need not list them.
    void add_places_of_higher_pairs();

private:
    bool learn_spins();
    bool learn_bodies();
    /// Where two bodies roll on each other and the point of one is known, so is the point of the other.
    bool learn_rolling_points();

    Structure& structure_;
    const Mechanism& mechanism_;
    const std::vector<bool>& use_driver_;
    KnownMotion& known_;
};

}  // namespace kinegraph::planning
