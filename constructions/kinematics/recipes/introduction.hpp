// The sentence before a contact or a mesh is first used: what it leaves to its places, by what linkage it is replaced.
#pragma once

#include <set>

#include "constructions/kinematics/recipes/pen.hpp"

namespace kinegraph::recipes {

class Introduction {
public:
    Introduction(Chains& chains, RecipePen& pen) : chains_(chains), pen_(pen) {}

    /// Before a contact or a mesh is first used: what it leaves to its places, and by what linkage it is replaced.
    void introduce(const Locus& locus);

private:
    PointName place_on(const Joint& joint, BodyIndex body);

    Chains& chains_;
    RecipePen& pen_;
    std::set<JointIndex> introduced_;  ///< higher pairs whose sentence was said
};

}  // namespace kinegraph::recipes
