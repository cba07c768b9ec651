// Intersections of straight lines and circles, with the error bound, and messages where they do not meet.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/drawing/draft.hpp"

namespace kinegraph::drafting {

struct Ray {
    Vector through;
    Vector along;
    bool rational_angle = true;
    bool touched = false;  ///< its place depends on an earlier root
    Words name;            ///< "through O2"
};
struct Disc {
    Vector centre;
    Exact radius;
    bool touched = false;
    Words name;  ///< "A (radius 50 mm)"
};
using Stroke = std::variant<Ray, Disc>;

struct Candidates {
    std::vector<Vector>
        places;  ///< of circles: left, right of first → second; of line and circle: back, further along the line
    Exact leftover;
    bool touched = false;
};

class Intersections {
public:
    explicit Intersections(Draft& draft) : draft_(draft) {}

    std::optional<Candidates> meet(const Ray& a, const Ray& b, const std::string& where);
    std::optional<Candidates> meet(const Ray& line, const Disc& circle, const std::string& where);
    std::optional<Candidates> meet(const Disc& a, const Disc& b, const std::string& where);

private:
    Exact reach_of(const Ray& line, const Disc& circle) const;
    /// Whether errors of earlier roots may have moved a squared half chord across zero.
    bool is_doubtful(const Exact& room, const Exact& radius) const;
    /// Whether the curves touch within the precision. For an overlap δ the square of half the chord is 2rδ; for two
    /// circles it is multiplied by r_b over the distance of the centres, and `lever` is the square of that factor.
    bool touches(const Exact& room, const Exact& radius, const Exact& lever) const;
    /// Where the circles close a parallelogram with a point already drawn, the fourth corner itself. It is as accurate
    /// as the root (within the same doubt), and it makes the opposite sides exactly parallel.
    Vector corner_of_parallelogram(const Vector& a, const Vector& b, const Vector& place) const;

    Draft& draft_;
};

}  // namespace kinegraph::drafting
