// "motion" of a body: what is known of the velocities and accelerations of its points.
#pragma once

#include <vector>

#include "engine/reading/bodies_section.hpp"

namespace kinegraph {

class MotionSection {
public:
    MotionSection(FormReader& file, Mechanism& mechanism, BodiesSection& bodies)
        : file_(file), mechanism_(mechanism), bodies_(bodies) {}

    void read_motion(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// The points named move with the body, listed there or not.
    std::vector<GivenMotion> given_motions(BodyIndex on, JsonValue value, QuantityKind kind);

    FormReader& file_;
    Mechanism& mechanism_;
    BodiesSection& bodies_;
};

}  // namespace kinegraph
