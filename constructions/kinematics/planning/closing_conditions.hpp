// Conditions that the motion found so far must fulfil, and which of them an assumption changes. The latter is tested on
// the drawing itself, with all drivers at rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/planning/loci.hpp"

namespace kinegraph::planning {

class ClosingConditions {
public:
    ClosingConditions(Structure& structure, Board& board, const std::vector<bool>& drivers, KnownMotion& known,
                      Loci& loci)
        : structure_(structure),
          board_(board),
          mechanism_(structure.mechanism()),
          use_driver_(drivers),
          known_(known),
          loci_(loci) {}

    /// One of the conditions that the assumption breaks: one whose line stays fixed if there is one, else the first.
    std::optional<Closing> moved_condition(std::size_t assumed);
    /// The same at a slide whose contact place is not yet known on both bodies, though the motion of both is.
    std::optional<Closing> moved_condition_at(JointIndex index, std::size_t assumed);

private:
    /// Makes the contact places of a joint known on both of its known bodies; false if it is not a slide or higher
    /// pair.
    bool see_places_of(JointIndex index);
    /// All conditions on the known bodies. Most hold by construction.
    std::vector<Closing> conditions(const Track<Plane::velocity>& moved);
    /// Two points of a body have equal projections on their join; if ω is known, also the part ⟂ to it follows (image).
    void add_rigidity(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found);
    /// Points in rolling contact have equal components along the tangent and along the normal.
    void add_rollings(const Track<Plane::velocity>& moved, std::vector<Closing>& found);
    void add_driven_slides(const Track<Plane::velocity>& moved, std::vector<Closing>& found);
    void add_equal_spins(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found);

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    const std::vector<bool>& use_driver_;
    KnownMotion& known_;
    Loci& loci_;
};

}  // namespace kinegraph::planning
