// Values of a record's givens in another position of the mechanism, in doubles, for replay.
#pragma once

#include <vector>

#include "engine/board/program.hpp"
#include "engine/motion/positions.hpp"

namespace kinegraph {

class GivensHere {
public:
    /// `pose` is the drawn one. Keeps a reference to the mechanism.
    GivensHere(const Mechanism& mechanism, const Pose& pose);

    /// Whether a given depends on the position. Rates do not: those of a law depend on time.
    bool hangs(const Given& given) const;
    /// Its value, if it depends on the position.
    ValueOf<double> value(const Given& given, const Places& places, const Positions& positions) const;
    /// The sense in which a contact pushes its first body, here.
    VectorOf<double> push(JointIndex joint, const Places& places) const {
        return senses_[at_index(joint)] * places.normals[at_index(joint)];
    }
    /// Rotation of a torsion spring from its unloaded position, rad.
    static double turned(const TorsionLoad& torsion, const Positions& positions);

private:
    ValueOf<double> value_of_load(const Given& given, const Places& places, const Positions& positions) const;

    const Mechanism& mechanism_;
    std::vector<double> senses_;  ///< by joint: −1 if it pushes against its normal as drawn
};

}  // namespace kinegraph
