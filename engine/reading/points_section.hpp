// "points": coordinates, or a place found from others by distances, lines and circles. Whether the curves meet, the
// pose tells.
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/point_cycles.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class PointsSection {
public:
    PointsSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void register_point(JsonValue member);
    void read_points(JsonValue points);

private:
    using Kind = FormReader::Kind;

    void report_cycle(const std::vector<PointIndex>& cycle, const std::vector<JsonValue>& places);
    Placement placement(JsonValue value);
    Placement point_on_line(JsonValue value);
    Placement meet(JsonValue value);
    /// Of two circles left or right; where a line meets a circle also which comes first on the line.
    Meet::Side side_of(JsonValue value, const Meet& meet);
    Curve curve(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
