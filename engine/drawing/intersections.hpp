// Where straight lines and circles meet, with the bound on what is missed, and the words where they do not.
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
    bool touched = false;  ///< lies where it does through an earlier root
    Words name;            ///< "through O2"
};
struct Disc {
    Vector centre;
    Exact radius;
    PointIndex point = none;
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
    /// A squared half chord that earlier roots may have moved across zero.
    bool is_doubtful(const Exact& room, const Exact& radius) const;
    /// The square of half the chord is 2rδ (for two circles times r_b over the distance of the centres, `lever` its
    /// square) where the curves overlap by δ: within the precision they touch.
    bool touches(const Exact& room, const Exact& radius, const Exact& lever) const;
    /// Where the circles close a parallelogram with a point already drawn, the fourth corner itself: it is as good as
    /// the root (within the same doubt), and sides meant to be parallel then are.
    Vector corner_of_parallelogram(const Vector& a, const Vector& b, const Vector& place) const;

    Draft& draft_;
};

}  // namespace kinegraph::drafting
