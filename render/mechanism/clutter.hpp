// Clutter: the strokes of a mechanism's drawing, to find out where an arrow would collide with them. Labels use an ink
// map instead.
#pragma once

#include <vector>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

class Clutter {
public:
    void add(const std::vector<Mark>& marks);
    void add(Spot from, Spot to) { add(Bar{from, to}, 1.0); }
    void add_arc(Spot centre, double radius, double from, double sweep);
    /// The fraction of the segment that lies near strokes.
    double along(Spot from, Spot to) const;
    /// The mean of along() over the chords of an arc of `sweep` radians (clockwise on paper). From `enough` on the
    /// result is only a lower bound.
    double along_arc(Spot centre, double radius, double from, double sweep, double enough = 1) const;

private:
    struct Stroke {
        Bar bar;
        double near;  ///< distance below which something counts as near, mm
        Box box;      ///< bounding box of that neighbourhood
    };
    void add(const Bar& bar, double half);
    std::vector<Stroke> strokes_;
};

}  // namespace kinegraph::render::drawing
