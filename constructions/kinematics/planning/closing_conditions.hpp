// What the bodies reached must fulfil, and which of it an assumption moves: that is asked of the drawing itself, with
// all drivers at rest.
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

    /// Of the conditions that the drawing breaks, one whose line stays where it is, else the first.
    std::optional<Closing> moved_condition(std::size_t assumed);
    /// The same at a slide whose place is not seen yet on both of its bodies, though both are known.
    std::optional<Closing> moved_condition_at(JointIndex index, std::size_t assumed);

private:
    /// Makes the places by which a joint holds its two known bodies known on both; false where it is no slide and no
    /// higher pair.
    bool see_places_of(JointIndex index);
    /// All that the bodies reached must fulfil; most of it does by the way it was drawn.
    std::vector<Closing> conditions(const Track<Plane::velocity>& moved);
    /// Two points of a body: equal projections on their join and, where ω is known, the image ⟂ to it.
    void add_rigidity(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found);
    /// Points in contact in rolling: alike along the tangent and along the normal.
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
