// Motion that follows without intersecting loci: ω through joints and drivers, a body's motion from one point and ω or
// from two points, points in rolling contacts, driven slides.
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
    /// Adds the contact points of higher pairs, on both bodies; the file need not list them.
    void add_places_of_higher_pairs();

private:
    bool learn_spins();
    bool learn_bodies();
    /// Two bodies roll on each other: if the contact point of one is known, so is that of the other.
    bool learn_rolling_points();

    Structure& structure_;
    const Mechanism& mechanism_;
    const std::vector<bool>& use_driver_;
    KnownMotion& known_;
};

}  // namespace kinegraph::planning
