// Polygon scene: the content of a polygon of the solution, namely its vectors and lines, their roles, their quantities
// and the statements that draw them. In values of the polygon's plane; no millimetres, colours or words.
#pragma once

#include <string>
#include <vector>

#include "engine/sentences/statement.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// A point of the polygon's plane relative to its pole, in the unit of its values, y upwards; or a unit vector.
struct Place {
    double x = 0, y = 0;
};

struct SceneVector {
    Symbol symbol;
    std::string name;  ///< unique within the polygon
    Place tail, tip;
    double value = 0;  ///< the double nearest to the exact length
    BodyIndex body = none;
    bool is_part = false;             ///< a partial force in a polygon that joins those of a body
    bool falls_out = false;           ///< an inner side of joined polygons, which cancels
    bool has_right_angles = false;    ///< a line through one of its ends is perpendicular to it by construction
    StatementIndex statement = none;  ///< none: given
};
/// A construction line: through a support, up to the intersection that it is drawn for.
struct SceneLine {
    LineReason reason;
    Place support, meet, along;
    StatementIndex statement = none;
};
/// An element drawn from a trial value.
struct SceneTrial {
    Place from, to;
    bool is_line = false;  ///< a line; else a vector
    StatementIndex statement = none;
};
/// The error of a trial: from the tip of the vector to the foot of its perpendicular on the line.
struct SceneMiss {
    Symbol symbol;
    Place through, foot, tip;
    StatementIndex statement = none;
};
struct SceneImage {
    enum class Kind { pole, image, trial } kind = Kind::image;
    Symbol symbol;
    Place at;
    int trial = 0;         ///< 1 or 2: the trial value it comes from
    bool is_named = true;  ///< false: of a trial, and no sentence speaks of it
    StatementIndex statement = none;
};
/// In a force polygon, the polygon of one body, in order. In a polygon of motion, the images of a body's points, in any
/// order.
struct SceneFace {
    BodyIndex body = none;
    std::vector<Place> corners;
    StatementIndex statement = none;  ///< the statement that completes its corners
};

/// The direction of a Coriolis term: the relative velocity, rotated by 90° in the sense of ω.
struct SceneCoriolis {
    Symbol coriolis, velocity, omega;
    Place along;  ///< direction of the velocity, a unit vector
    bool counter_clockwise = true;
    BodyIndex body = none, guide = none;  ///< their colours are used
    StatementIndex statement = none;
};

struct PolygonScene {
    enum class Kind { velocity, acceleration, forces, closure } kind = Kind::velocity;
    std::string id;
    std::string point, observer;  ///< see Polygon
    bool translating = false;
    Unit unit;
    std::vector<SceneVector> vectors;
    std::vector<SceneLine> lines;
    std::vector<SceneTrial> trials;
    std::vector<SceneMiss> misses;
    std::vector<SceneImage> images;
    std::vector<SceneFace> faces;
    std::vector<SceneCoriolis> coriolis;
    Place least, most;   ///< bounding box of its vectors; in a polygon of motion also of the pole and the images
    Place along;         ///< direction of the longest vector
    double longest = 0;  ///< length of the longest vector

    double width() const { return most.x - least.x; }
    double height() const { return most.y - least.y; }
    double size() const { return width() > height() ? width() : height(); }
    /// Whether all its vectors have one direction or its opposite.
    bool is_straight() const;
    /// Whether all its vectors are zero.
    bool empty() const { return !(size() > 0); }
};

/// The scene of a polygon of the protocol, by its index.
PolygonScene polygon_scene(const Solution& solution, int polygon);
/// Indices of the force polygons that join those of several bodies.
std::vector<int> closed_polygons(const Solution& solution);

}  // namespace kinegraph::render
