// The points in the order in which they need each other: by coordinates, distances, ratios, and meets, of which one is
// chosen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/intersections.hpp"

namespace kinegraph::drafting {

class Placing {
public:
    explicit Placing(Draft& draft)
        : draft_(draft), intersections_(draft), state_(draft.mechanism.points.size(), State::waiting) {}

    /// True when the point has its place. False: it, or one it needs, could not be placed, which has been said.
    bool drawn(PointIndex point);
    bool drawn(const Place& place);
    bool drawn(const Bearing& bearing);
    bool drawn(const Bearing::Between& between);

private:
    enum class State { waiting, under_way, done, failed };
    bool place(const NamedPoint& named, const Coordinates& placement, PositionStep&);
    bool place(const NamedPoint& named, const Polar& placement, PositionStep& step);
    bool place(const NamedPoint& named, const Along& placement, PositionStep& step);
    bool place(const NamedPoint& named, const Meet& placement, PositionStep& step);
    std::optional<Stroke> stroke(const CircleCurve& circle, const std::string&);
    std::optional<Stroke> stroke(const LineCurve& line, const std::string& where);
    std::optional<Vector> choose(const Candidates& found, const Meet& meet, PositionStep::How how,
                                 const NamedPoint& named);

    Draft& draft_;
    Intersections intersections_;
    std::vector<State> state_;
};

}  // namespace kinegraph::drafting
