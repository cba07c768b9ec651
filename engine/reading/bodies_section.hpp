// "frame" and "bodies": the bodies by name, and the points that move with each.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class BodiesSection {
public:
    BodiesSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    /// `stated`: the frame's name, where the file gives one.
    void register_bodies(JsonValue stated, JsonValue bodies);
    void read_bodies(JsonValue bodies);
    void carry(BodyIndex on, PointIndex carried);

private:
    using Kind = FormReader::Kind;

    Body& body_at(BodyIndex index) { return mechanism_.bodies[at_index(index)]; }
    void read_body_circle(JsonValue value, BodyIndex index);

    FormReader& file_;
    Mechanism& mechanism_;
    std::unordered_set<std::uint64_t> carried_;  ///< (body, point)
};

}  // namespace kinegraph
