// Lengths, radii and angles given by the file that a drawing can show as dimensions. Positions of the dimensions are
// chosen in dimensions.cpp.
#pragma once

#include <string>
#include <vector>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

struct DimensionedLength {
    Spot from, to;
    Spot along;    ///< unit vector along the dimension line
    double value;  ///< metres
    std::string name;
};
struct DimensionedRadius {
    Spot centre;
    double radius, value;
    std::string name;
};
struct DimensionedAngle {
    Spot vertex;
    double from, sweep;  ///< radians clockwise on paper
    std::string text, name;
};

struct DimensionData {
    std::vector<DimensionedLength> lengths;
    std::vector<DimensionedRadius> radii;
    std::vector<DimensionedAngle> angles;
};

/// In the order of the file; each length once.
DimensionData dimension_data(const Sketch& sketch);

}  // namespace kinegraph::render::drawing
