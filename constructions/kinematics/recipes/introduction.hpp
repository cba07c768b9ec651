// The sentence before the first use of a contact or a mesh: which relative motion it allows, and its equivalent
// linkage.
#pragma once

#include <set>

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

class Introduction {
public:
    Introduction(Chains& chains, RecipePen& pen) : chains_(chains), pen_(pen) {}

    /// Writes the sentence if the joint is used for the first time.
    void introduce(const Locus& locus);

private:
    PointName place_on(const Joint& joint, BodyIndex body);

    Chains& chains_;
    RecipePen& pen_;
    std::set<JointIndex> introduced_;  ///< higher pairs whose sentence was written
};

}  // namespace kinegraph::recipes
