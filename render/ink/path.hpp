// Paths: strokes and fills in one colour each, mm, y downwards. Independent of pages and text.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "engine/number/index.hpp"
#include "render/ink/holds.hpp"
#include "render/ink/spot.hpp"

namespace kinegraph::render {

/// An sRGB colour.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// Stroke style. Width and dashes in mm; an empty dash list is a full line.
struct Pen {
    double width = 0.18;
    Colour colour;
    std::vector<double> dashes;
    bool round_ends = false;
    friend bool operator==(const Pen&, const Pen&) = default;
};

/// Segments of a path. An arc runs from `from` to `to` (radians, y downwards, so positive angles turn clockwise on
/// paper).
struct MoveTo {
    Spot to;
};
struct LineTo {
    Spot to;
};
struct CurveTo {
    Spot control_1, control_2, to;
};
struct ArcTo {
    Spot centre;
    double radius = 0;
    double from = 0;
    double to = 0;
};
struct Close {};
using Segment = std::variant<MoveTo, LineTo, CurveTo, ArcTo, Close>;

/// A path, filled, stroked or both.
struct Path {
    std::vector<Segment> segments;
    bool filled = false;
    Colour fill;
    bool stroked = false;
    Pen pen;
    StatementIndex statement = none;  ///< the statement of the solution that draws it; none: present from the beginning
    bool tinted = false;       ///< filled with a body's tint or the paper colour: not ink, labels may stand on it
    BodyIndex tint_of = none;  ///< the body whose tint it is; none: the paper's, or that of no body
    Holds holds{};             ///< what it moves with
};

/// Round ends go with round corners. A dash round a sharp corner must not leave a spike, either.
inline bool has_round_corners(const Path& path) {
    return path.pen.round_ends || (!path.pen.dashes.empty() && path.segments.size() > 3);
}

}  // namespace kinegraph::render
