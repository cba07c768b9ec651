// The motion of a point: symbolic derivatives of its laws (engine/file/algebra.hpp) give place, velocity and
// acceleration. The board gives the components of the acceleration along tangent and normal, and the centre of
// curvature.
//
// Sources: the intrinsic components, Huygens; the centre of curvature from v and a_n by the altitude of a right
// triangle, Euclid II.14 (ρ a_n = v²).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/file/expression.hpp"
#include "engine/solution/problem_kind.hpp"
#include "lang/words.hpp"

namespace kinegraph {

// ----- what a file states

/// A law of the file and its place.
struct StatedLaw {
    std::string symbol;  ///< "x", "θ", "s"; "f" of a path
    std::string text;    ///< as the file writes it
    std::string where;
    Expressed law;
};
/// A curve y = f(x). The path length s is counted from x = `start`, in the sense of increasing x.
struct GraphPath {
    StatedLaw f;
    Exact start;
};
/// Counter-clockwise, from the angle `start`.
struct CirclePath {
    Vector centre;
    Exact radius, start;
};
/// Along `direction` (no unit vector), from `from`.
struct LinePath {
    Vector from;
    Vector direction;
};
using StatedPath = std::variant<GraphPath, CirclePath, LinePath>;

struct PointProblem {
    std::string point;
    enum class Form { cartesian, polar, path } form = Form::cartesian;
    /// x and y, or r and θ, or s.
    std::vector<StatedLaw> laws;
    std::optional<StatedPath> path;
    NamedConstants constants;
    Exact at, from, to;  ///< s
    std::string where, where_at, where_from;
};

// ----- solution

/// A law and its derivatives in symbols.
struct Derived {
    std::array<Expression, 3> by_order;
};

/// The motion of a point at the instant. Flags mark components that are undefined there.
struct PointMotionSolution {
    std::vector<Derived> laws;             ///< of PointProblem::laws
    std::optional<Derived> of_path;        ///< f, f′, f″
    Vector place, velocity, acceleration;  ///< the values of the laws in doubles, as input of the board
    double way = 0;                        ///< path length s from `from`; for a path, as its law counts it
    bool rests = false;                    ///< v = 0: no tangent, no normal, no curvature
    bool straight = false;                 ///< a_n = 0: the centre of curvature at infinity
    bool at_pole = false;                  ///< polar coordinates: r = 0, the radial direction is undefined
    /// By the construction; none where `rests`.
    std::optional<Vector> tangential, normal;  ///< components of the acceleration
    std::optional<Vector> centre;              ///< of curvature; none where `straight`
    double speed = 0, acceleration_length = 0, along = 0, across = 0, radius = 0;  ///< v, |a|, a_t, a_n, ρ
    double r = 0, theta = 0;
    std::array<double, 2> polar_velocity{}, polar_acceleration{};  ///< radial, transverse
    struct At {
        double time = 0, way = 0, speed = 0, along = 0, across = 0;
        VectorOf<double> place, velocity;
        bool rests = false;
    };
    std::vector<At> course;  ///< from `from` to `to`
    Protocol record;         ///< the board of the components and of the centre of curvature
    /// Elements of the record: points of the drawing, where one metre stands for 1 m/s or 1 m/s².
    struct Elements {
        ElementIndex tip_of_velocity = none, tip_of_acceleration = none, foot = none, reversed = none, centre = none;
    } elements;
};

/// Errors: laws that are not real or are infinite at the instant or along the path, each at its place.
Result<ProblemSolution> solve_point_motion(const PointProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- The numeric check: automatic differentiation (engine/file/expression.hpp, jets) instead of symbolic
// derivatives; the path length by Simpson's rule.

struct PointCheck {
    VectorOf<double> place, velocity, acceleration;
    double way = 0, speed = 0, acceleration_length = 0;
    double along = 0, across = 0, radius = 0;  ///< not meaningful where v or a_n vanishes
    VectorOf<double> centre;
    double r = 0, theta = 0;
    std::array<double, 2> polar_velocity{}, polar_acceleration{};
};
PointCheck check_point_motion(const PointProblem& problem);

// ----- the kind of problem

/// Whether a "motion" is that of a point, not of a body.
bool is_point_motion(JsonValue motion);
std::any read_point_motion(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue point_motion_section;
extern const ProblemKind point_problem;

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct EquationItem;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> point_sections(const DrawingContext& context);
/// The part of the solution that needs no figure: given data, derivatives, forms, tangent and normal.
std::vector<EquationItem> point_items(const Solution& solution, Language language);

// ----- Figures: the trajectory to scale with the known quantities of the instant; the hodograph; the centre of
// curvature by the altitude of a right triangle; path length, speed and components of the acceleration over the
// interval. Room in mm.

Figure trajectory_figure(const DrawingContext& context, double room_x, double room_y);
/// Without the quantities to be found.
Figure trajectory_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure hodograph_figure(const DrawingContext& context, double room_x, double room_y);
Figure curvature_centre_figure(const DrawingContext& context, double room_x, double room_y);
Figure way_figure(const DrawingContext& context, double room_x, double room_y);
Figure speed_figure(const DrawingContext& context, double room_x, double room_y);
Figure components_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
