// Polygon scene: what a polygon of the solution shows, in which role, of which quantity and drawn by which statement.
// Places are values of its plane; no millimetre, no colour, no word.
#pragma once

#include <string>
#include <vector>

#include "engine/solution/solution.hpp"

namespace kinegraph::render {

/// A place of a polygon's plane from its pole, in the unit that its values are told in, y upwards; or a direction
/// there, as a unit.
struct Place {
    double x = 0, y = 0;
};

struct SceneVector {
    Symbol symbol;
    std::string name;  ///< unique in the polygon
    Place tail, tip;
    double value = 0;  ///< the double nearest to its exact length
    BodyIndex body = none;
    bool falls_out = false;           ///< an inner side of joined polygons
    bool has_right_angles = false;    ///< a line ⟂ to it through one of its ends is so by construction
    StatementIndex statement = none;  ///< none: it is given
};
/// A line of the construction: through a support, as far as the meet that it is drawn for.
struct SceneLine {
    LineReason reason;
    Place support, meet, along;
    StatementIndex statement = none;
};
/// What was drawn from a trial value on the way.
struct SceneTrial {
    Place from, to;
    bool is_line = false;  ///< it runs on; else a vector
    StatementIndex statement = none;
};
/// By how much a trial misses a line: from the tip to the foot of its perpendicular.
struct SceneMiss {
    Symbol symbol;
    Place through, foot, tip;
    StatementIndex statement = none;
};
struct SceneImage {
    enum class Kind { pole, image, trial } kind = Kind::image;
    Symbol symbol;
    Place at;
    int trial = 0;  ///< 1, 2: of which trial value
    StatementIndex statement = none;
};
/// The polygon of one body within a force polygon, in order; in one of motion the images of its points, in any.
struct SceneFace {
    BodyIndex body = none;
    std::vector<Place> corners;
    StatementIndex statement = none;  ///< after which all its corners stand
};

/// What gives a Coriolis term its direction: the relative velocity, turned a quarter as ω turns.
struct SceneCoriolis {
    Symbol coriolis, velocity, omega;
    Place along;  ///< of the velocity, a unit
    bool counter_clockwise = true;
    BodyIndex body = none, guide = none;  ///< whose colours they have
    StatementIndex statement = none;
};

struct PolygonScene {
    enum class Kind { velocity, acceleration, forces, closure } kind = Kind::velocity;
    std::string id;
    std::string point, observer;  ///< as Polygon's
    bool translating = false;
    Unit unit;
    std::vector<SceneVector> vectors;
    std::vector<SceneLine> lines;
    std::vector<SceneTrial> trials;
    std::vector<SceneMiss> misses;
    std::vector<SceneImage> images;
    std::vector<SceneFace> faces;
    std::vector<SceneCoriolis> coriolis;
    Place least, most;  ///< round its vectors; round pole and images too where it is one of motion
    Place along;        ///< direction of the longest vector

    double width() const { return most.x - least.x; }
    double height() const { return most.y - least.y; }
    double size() const { return width() > height() ? width() : height(); }
    /// All its vectors are zero.
    bool empty() const { return !(size() > 0); }
};

/// One polygon of the protocol, by its index.
PolygonScene polygon_scene(const Solution& solution, int polygon);
/// Indices of the force polygons in which those of several bodies are joined.
std::vector<int> closed_polygons(const Solution& solution);

}  // namespace kinegraph::render
