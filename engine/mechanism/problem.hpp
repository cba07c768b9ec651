// Problems that a file states in place of joints: contact (Hertz), wear (Reye), impact, the motion of a point,
// positions of a body; and contact at joints of a mechanism, whose force is found first. Values in SI units, angles in
// radians. Results: engine/solution/problem_solution.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/file/expression.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// One of two elastic bodies that are pressed together.
struct HertzBody {
    BodyIndex body = none;
    /// Principal radii at the contact, m; 0: flat in that plane. A sphere has two equal ones; the second one of a
    /// cylinder that lies along a line of contact is not used.
    std::array<Exact, 2> radii{};
    std::array<bool, 2> inside{};  ///< concave: the material lies outside the radius
    Exact young;                   ///< Pa
    Exact poisson;
    std::optional<Exact> depth;  ///< line contact of a flat or concave body: depth of the datum of its approach, m
    std::string where;

    /// Curvature in a principal plane, 1/m, positive where the body bulges towards the other.
    Exact curvature(std::size_t plane) const {
        if (radii[plane].is_zero()) return {};
        return inside[plane] ? -(Exact(1) / radii[plane]) : Exact(1) / radii[plane];
    }
};
/// The materials of a contact at a joint of a mechanism, which supplies the force and the radii.
struct AtJoint {
    std::string joint;    ///< name of the joint
    bool meshes = false;  ///< teeth touch at the pitch point: involutes of these pitch radii (m; 0: a rack)
    std::array<double, 2> pitch_radii{};
    double pressure_angle = 0;  ///< rad
};
struct HertzProblem {
    Exact force;  ///< N
    std::array<HertzBody, 2> bodies;
    bool line = false;
    Exact length;                 ///< of a line contact, m
    Exact turn;                   ///< between the first principal planes of the two bodies, rad
    std::optional<AtJoint> at{};  ///< none: the file gives force and radii
};
/// Materials and length of the contact at a joint. The load is the normal force found there; the radii are those of the
/// profiles or of the teeth in the drawn position.
struct LoadedContact {
    JointIndex joint = none;
    std::array<HertzBody, 2> bodies;  ///< as the joint's; without radii
    Exact length;                     ///< m
    std::string where;
};
using LoadedContacts = std::vector<LoadedContact>;

/// One of two bodies that hit each other.
struct ImpactBody {
    BodyIndex body = none;
    bool fixed = false;            ///< at rest, whatever hits it
    Exact mass;                    ///< kg
    std::optional<Exact> inertia;  ///< about the centre of mass, kg m²; none: a particle, which does not turn
    std::optional<Place> centre;   ///< none: at the point of impact
    std::optional<Place> pivot;    ///< of a body that turns about a fixed hinge
    std::optional<Vector>
        velocity;  ///< of the centre of mass before the impact, m/s; a pivoted body has `omega` instead
    Exact omega;   ///< rad/s
    std::string where;
};
struct ImpactProblem {
    std::array<ImpactBody, 2> bodies;
    Place at;
    Bearing normal;     ///< of the plane of impact; its sense from the second body to the first, where their centres do
                        ///< not determine it
    Exact restitution;  ///< 0 … 1, the ratio of the normal impulses of restitution and compression (Poisson)
    Exact friction;     ///< coefficient of Coulomb
    std::string where;
};

/// A rubbing contact whose pressure follows from its wear (Reye: the volume worn off is proportional to the work of
/// friction).
struct ReyeProblem {
    enum class Kind {
        pad,    ///< a pad free to tilt, under an eccentric force
        block,  ///< the same, guided so that it wears evenly
        disc,   ///< a ring pressed on a plane that turns: clutch or collar
        shoe    ///< on a drum, turning about a pivot
    } kind = Kind::pad;
    Exact force;                    ///< N; for a shoe the force that turns it about its pivot, at the arm `arm`
    std::optional<Exact> friction;  ///< coefficient; a disc and a shoe have one
    Exact length, width, offset;    ///< pad, block: m; the offset from the end x = 0
    Exact inner, outer;             ///< disc: radii, m
    int surfaces = 1;               ///< disc
    Exact radius, pivot,
        arm;         ///< shoe: radius of the drum; distance of the pivot from the drum's centre; arm of the force about
                     ///< the pivot, m
    Exact from, to;  ///< shoe: its ends, rad, from the direction of the pivot as seen from the drum's centre
    bool inside = false, leading = true;     ///< shoe: inside the drum; friction turns it in the same sense as the
                                             ///< force
    std::optional<Exact> wear, speed, time;  ///< m²/N; m/s or, for discs and shoes, rad/s; s
    std::string where;
};

// ----- the motion of a point

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

// ----- finite displacements

/// Two points of a body in two or three positions.
struct PositionsProblem {
    std::array<std::string, 2> points;
    struct Position {
        std::array<Vector, 2> places;
        double moved = 0;  ///< displacement of the second point along AB that keeps its distance (m)
        std::string where;
    };
    std::vector<Position> positions;
    std::string where;
};

struct Problem {
    std::variant<HertzProblem, ImpactProblem, ReyeProblem, LoadedContacts, PointProblem, PositionsProblem> of;
};
/// Whether the problem replaces the joints; contacts belong to joints.
inline bool stands_for_joints(const Mechanism& mechanism) {
    return mechanism.problem && !std::holds_alternative<LoadedContacts>(mechanism.problem->of);
}
/// The name of a body in sentences: its label, where the file gives one.
inline Words called(const Body& body) { return body.label.empty() ? Words(body.name) : body.label; }

}  // namespace kinegraph
