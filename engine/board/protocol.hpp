// The protocol: what the board leaves when it is finished. The program with its values, the sentences, and what is
// shown of the figures in each plane.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/board/program.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/geometry.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// The polygon of one body within a joined force polygon: its corners in order.
struct Face {
    BodyIndex body = none;
    std::vector<ElementIndex> corners;  ///< elements: points of the force plane
};
/// A polygon: a figure of one plane, with its own pole.
struct Polygon {
    Plane plane = Plane::velocity;
    std::string id;               ///< "velocity", "acceleration", "velocity-E-2"
    std::string point, observer;  ///< relative-motion polygons: the point and its observer ("translating" ones:
                                  ///< observer is the origin's name, `translating` true)
    bool translating = false;
    std::vector<int> vectors;  ///< indices into Protocol::vectors
    std::vector<int> images;   ///< indices into Protocol::images
    std::vector<Face> faces;   ///< force polygons: one for each body
    enum class Kind {
        motion,           ///< of all points: one for velocities, one for accelerations
        relative_motion,  ///< of one point, as an observer sees it
        body_forces,      ///< of one body
        joined_forces     ///< of several bodies together, sharing their common forces
    } kind = Kind::motion;
};
/// A place carried by a body.
struct CarriedPlace {
    ElementIndex place = none;  ///< point element of the drawing
    BodyIndex body = none;
    PointIndex point = none;  ///< the file's point there; none: an auxiliary place
};
/// The moving place of a vector of motion, and the place from which its motion is seen.
struct Seen {
    CarriedPlace of;
    CarriedPlace to;            ///< where it is seen from; without a body: the frame
    ElementIndex about = none;  ///< point element about which `of` turns, seen from `to`; none: it moves along a
                                ///< straight line
};
/// A named vector of a polygon, from tail to tip (elements that are points of its plane).
struct DrawnVector {
    Symbol symbol;
    int polygon = 0;
    ElementIndex tail = none, tip = none;
    BodyIndex body = none;
    enum class Role {
        absolute,
        relative,
        normal,
        tangential,
        transport,
        sliding,
        coriolis,
        external,
        internal
    } role = Role::absolute;
    StatementIndex statement = none;
    int trial = 0;  ///< 1, 2: drawn from the first or second trial value of an assumption (Protocol::trials); 0: the
                    ///< solution
    Seen seen;      ///< empty for a force and for a component along a line
    Quantity quantity;      ///< empty for a component along a line
    bool vanishes = false;  ///< zero within the precision of the data: not drawn
};
/// A labelled vertex of a polygon: the image of a point ("a"), the pole ("o", with the points at rest).
struct Image {
    Symbol symbol;
    int polygon = 0;
    ElementIndex point = none;
    BodyIndex body = none;
    StatementIndex statement = none;
    int trial = 0;  ///< as DrawnVector::trial
};
/// A construction line of a polygon or of the drawing that is shown, with its direction in words and the places that
/// define it.
struct DrawnLine {
    ElementIndex line = none;
    int polygon = -1;  ///< −1: in the drawing of the mechanism
    LineReason reason;
    std::vector<ElementIndex> points;  ///< point elements it passes (support, meet)
    StatementIndex statement = none;
    int trial = 0;  ///< as DrawnVector::trial
};

/// The subject of a sentence: the section of the solution that contains it.
enum class Topic { unnamed, velocity, acceleration, relative_motion, centres, curvature, forces };

/// A sentence of the solution with its equation and strokes.
struct Statement {
    Message message;
    std::optional<Equation> equation;
    Topic section = Topic::unnamed;
    std::string source;             ///< theorem or author: "Rivals", "Aronhold–Kennedy", "Coriolis"
    std::vector<Quantity> finds;    ///< the ω, α and forces that it determines, in the order it names them
    std::vector<BodyIndex> bodies;  ///< forces: the bodies taken together; curvature: the body concerned
};

/// The distance from the tip of a trial to the line on which it must lie.
struct DrawnMiss {
    Symbol symbol;  ///< ε^I
    int polygon = 0;
    ElementIndex through = none;  ///< the point through which the line was drawn
    ElementIndex foot = none;     ///< foot of the perpendicular from the tip
    ElementIndex tip = none;
    StatementIndex statement = none;
};

/// Intermediate constructions from trial values, kept apart from the solution: thin broken lines of the same polygons.
struct Trials {
    std::vector<DrawnVector> vectors;
    std::vector<Image> images;
    std::vector<DrawnLine> lines;
    std::vector<DrawnMiss> misses;
};

/// The finished board.
struct Protocol {
    std::vector<Statement> statements;
    Program program;
    std::vector<Value> values;  ///< by element, in the drawn pose
    std::vector<Polygon> polygons;
    std::vector<DrawnVector> vectors;
    std::vector<Image> images;
    std::vector<DrawnLine> lines;
    Trials trials;
    /// By element, on each of the pose's shifted drawings, to about 200 bits. Empty where no datum is rounded.
    std::vector<std::vector<Value>> shifted;
    /// Bits of all numbers of the construction, those of the finer and the shifted drawings included: what it cost.
    std::size_t bits = 0;

    const ProjectivePoint& point(ElementIndex element) const {
        return std::get<ProjectivePoint>(values[at_index(element)]);
    }
    const ProjectiveLine& line(ElementIndex element) const {
        return std::get<ProjectiveLine>(values[at_index(element)]);
    }
    const Vector& vector(ElementIndex element) const { return std::get<Vector>(values[at_index(element)]); }
    const Exact& scalar(ElementIndex element) const { return std::get<Exact>(values[at_index(element)]); }
    /// Tip − tail of a drawn vector, exact, in its plane's SI unit; empty where it is zero within the data.
    Vector value_of(const DrawnVector& drawn) const {
        return drawn.vanishes ? Vector{} : point(drawn.tip) - point(drawn.tail);
    }
    /// Its length, to the nearest double.
    double modulus_of(const DrawnVector& drawn) const {
        return drawn.vanishes ? 0 : distance(point(drawn.tail), point(drawn.tip));
    }
};

/// Visits the elements that are drawn: vectors, images, lines and corners of faces, including those of trials.
void for_each_drawn(Protocol& protocol, const std::function<void(ElementIndex& element)>& see);

}  // namespace kinegraph
