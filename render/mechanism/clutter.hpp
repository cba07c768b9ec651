// Clutter: the strokes of a drawing, to see where an arrow would stand in the way. Mechanisms only; labels have their
// ink map.
#pragma once

#include <vector>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

class Clutter {
public:
    void add(const std::vector<Mark>& marks);
    void add(Spot from, Spot to) { add(Bar{from, to}, 1.0); }
    void add_arc(Spot centre, double radius, double from, double sweep);
    /// The share of the stretch that lies near strokes.
    double along(Spot from, Spot to) const;
    /// The mean of that over the pieces of an arc, `sweep` radians clockwise on paper.
    double along_arc(Spot centre, double radius, double from, double sweep) const;

private:
    struct Stroke {
        Bar bar;
        double near;  ///< at less than this from it something lies near it
        Box box;      ///< of all that does
    };
    void add(const Bar& bar, double half);
    std::vector<Stroke> strokes_;
};

}  // namespace kinegraph::render::drawing
