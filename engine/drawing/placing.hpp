// Places the points in the order of their dependencies: by coordinates, distances, ratios, and intersections, of which
// one is chosen.
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

    /// Whether the point has its place. False: it, or a point it depends on, could not be placed; the fault has been
    /// reported.
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
