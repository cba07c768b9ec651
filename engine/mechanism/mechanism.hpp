// Mechanism: the contents of a file, with names resolved, units converted to SI and every number exact. It does not
// change once read. Without constructed positions (Pose) and without motion.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/file/formula.hpp"
#include "engine/mechanism/law.hpp"
#include "engine/mechanism/pair.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/index.hpp"

namespace kinegraph {

/// An angle as written: exact degrees or exact radians.
struct Angle {
    Exact value;
    bool in_degrees = true;
};

/// FORMAT "X, a direction": an angle from +x, the sense from one point to another, or a vector.
struct Bearing {
    struct Between {
        PointIndex from = none;
        PointIndex to = none;
    };
    std::variant<Angle, Between, Vector> form = Vector{};
};

/// A place that is a named point or bare coordinates (m).
using Place = std::variant<PointIndex, Vector>;

/// How a point is placed. Lengths in m.
struct Coordinates {
    Vector at;
};
struct Polar {
    PointIndex from = none;
    Exact distance;
    Angle angle;
    std::optional<Bearing::Between> relative_to;  ///< angle counted from P→Q instead of +x
};
struct Along {
    PointIndex from = none, to = none;
    Exact amount;
    bool is_ratio = false;  ///< `amount` is a fraction of the distance from→to, else a distance in m
};
struct CircleCurve {
    Place centre;
    Exact radius;
};
struct LineCurve {
    Place through;
    enum class By { angle, to, parallel, perpendicular } by = By::angle;
    Angle angle;           ///< by == angle
    PointIndex to = none;  ///< by == to
    Bearing bearing;       ///< by == parallel, perpendicular
};
using Curve = std::variant<CircleCurve, LineCurve>;
struct Meet {
    Curve first, second;
    std::optional<Vector> near;
    enum class Side { either, left, right, behind, ahead } side = Side::either;  ///< behind, ahead: on a line alone
};
using Placement = std::variant<Coordinates, Polar, Along, Meet>;

struct NamedPoint {
    std::string name;
    Placement placement;
    std::string where;  ///< JSON pointer
};

struct Circle {
    PointIndex centre = none;
    Exact radius;
};

struct Body {
    std::string name;
    std::vector<PointIndex>
        points;  ///< listed by the file first, then those of its revolute and weld joints; no doubles
    Words label;
    std::optional<Circle> circle;
    std::string where;
    std::optional<std::uint32_t> colour = std::nullopt;  ///< 0xRRGGBB; none: the theme's
};

/// Profile of one body at a contact.
struct LineProfile {
    Bearing along;
};
struct CircleProfile {
    PointIndex centre = none;
    bool of_body = false;  ///< the joint gives no profile of the body, whose own circle counts: its radius binds P
};
struct TipProfile {};
using Profile = std::variant<LineProfile, CircleProfile, TipProfile>;

struct Joint {
    JointKind kind = JointKind::revolute;
    std::string name;    ///< given, or the point's name
    bool named = false;  ///< true where the file gives "name"
    PointIndex point = none;
    std::vector<BodyIndex> bodies;          ///< two; a revolute or weld may have more
    std::optional<Bearing> along;           ///< prismatic, straight pin-slot
    PointIndex arc = none;                  ///< pin-slot curved about this point
    std::map<BodyIndex, Profile> profiles;  ///< rolling, contact, gear (the reader adds a body's own circle)
    std::optional<Bearing> tangent;
    std::optional<Angle> pressure_angle;
    BodyIndex arm = frame;         ///< gear: the carrier
    std::optional<Vector> pushes;  ///< contact: sense of the force on bodies[0]
    bool loaded_pin = false;       ///< a hinge of two bodies with a load on its pin
    std::string where;

    /// Whether the joint is a node of its own: a massless pin in contact with each of the bodies.
    bool has_own_node() const { return bodies.size() > 2 || loaded_pin; }
    const PlanePair& pair() const { return plane_pair(kind); }
    bool connects(BodyIndex body) const { return std::find(bodies.begin(), bodies.end(), body) != bodies.end(); }
    /// Of two bodies the one that is not `body`.
    BodyIndex other_than(BodyIndex body) const { return bodies[bodies[0] == body ? 1 : 0]; }
};

/// rad/s, rad/s², m/s, m/s². With a law, these are its rates in the drawn position.
struct SpinDriver {
    BodyIndex body = none, relative_to = frame;
    Exact omega, alpha;
    std::string where;
    std::optional<Law> law = std::nullopt;
};
struct SlideDriver {
    JointIndex joint = none;
    Exact speed, acceleration;
    std::string where;
    std::optional<Law> law = std::nullopt;
};
struct PointDriver {
    BodyIndex body = none;
    PointIndex at = none;
    Bearing along;
    Exact speed, acceleration;
    std::string where;
    std::optional<Law> law = std::nullopt;
};
using Driver = std::variant<SpinDriver, SlideDriver, PointDriver>;

struct Mass {
    BodyIndex body = none;
    Exact mass;
    PointIndex centre = none;
    Exact inertia;
    std::string where;
};

/// Loads: N, N m.
struct ForceLoad {
    std::string name;
    BodyIndex body = none;  ///< none: it acts on the pin of a hinge
    PointIndex at = none;
    std::optional<Vector> value;                         ///< either the components …
    std::optional<std::pair<Exact, Bearing>> magnitude;  ///< … or magnitude and direction
    std::string where;
    JointIndex pin = none;  ///< the hinge on whose pin it acts; none: it acts on `body`
};
struct CoupleLoad {
    std::string name;
    BodyIndex body = none;
    Exact value;
    std::string where;
};
/// Pulls its two points together; where negative, it pushes them apart.
struct SpringLoad {
    /// k in N/m and the free length, m: the force is k (l − l_0).
    struct Elastic {
        Exact stiffness, free_length;
    };
    std::string name;
    std::array<BodyIndex, 2> bodies{none, none};
    std::array<PointIndex, 2> between{none, none};
    Exact magnitude;  ///< where it is not elastic
    std::string where;
    std::optional<Elastic> elastic = std::nullopt;
};
/// A load along PQ, of an intensity (N per m of PQ) that varies linearly from one end to the other.
struct DistributedLoad {
    std::string name;
    BodyIndex body = none;
    PointIndex from = none, to = none;
    std::array<Exact, 2> intensity;
    Bearing along;
    std::string where;
};
/// A restoring couple: −k φ on the first body, the opposite on the second.
struct TorsionLoad {
    std::string name;
    std::array<BodyIndex, 2> bodies{none, none};
    PointIndex at = none;  ///< where it is drawn
    Exact stiffness;       ///< k, N m/rad
    Exact turned;          ///< φ, rad: rotation of the first body relative to the second, from the position without
                           ///< couple
    std::string where;
};
using Load = std::variant<ForceLoad, CoupleLoad, SpringLoad, DistributedLoad, TorsionLoad>;

struct CoupleEffort {
    std::string name;
    BodyIndex body = none;
    BodyIndex from = frame;
    std::string where;
};
struct ForceEffort {
    std::string name;
    BodyIndex body = none;
    PointIndex at = none;
    Bearing along;
    std::string where;
};
struct ActuatorEffort {
    std::string name;
    JointIndex joint = none;
    std::string where;
};
using Effort = std::variant<CoupleEffort, ForceEffort, ActuatorEffort>;

/// The given instantaneous motion of one rigid body, instead of joints and drivers (m/s, m/s²).
struct GivenMotion {
    PointIndex point = none;
    std::variant<Vector, Bearing> value;
};
struct InstantaneousMotion {
    BodyIndex body = none;
    std::vector<GivenMotion> velocities, accelerations;
    std::string where;
};

/// A request for one point's relative motion.
struct RelativeMotionQuery {
    PointIndex point = none;
    BodyIndex observer = frame;          ///< the frame is fixed in this body …
    PointIndex translating_with = none;  ///< … or, where there is one, it translates with this point
    std::string where;
    bool solves = false;  ///< the motion itself is found through this observer where the mechanism allows it
};
/// A cut through three bars of a truss: bodies, in the order that the file gives.
struct CutQuery {
    std::vector<BodyIndex> bars;
    std::string where;
};
struct Find {
    bool stated = false;  ///< false: find everything that the data allow
    bool instant_centres = false, velocity = false, acceleration = false, forces = false, curvature = false;
    bool equations = false;     ///< the closure equations; may be set although `stated` is false
    bool virtual_work = false;  ///< virtual displacements and the efforts that follow from them; likewise
    std::vector<RelativeMotionQuery> relative_motion;
    std::vector<CutQuery> cuts;
};

/// A unit of printed values: its symbol and its size in SI.
struct Unit {
    std::string symbol;
    Exact si;
};
struct Units {
    Unit length{"m", 1}, angle{"deg", 1}, angular_velocity{"rad/s", 1}, velocity{"m/s", 1}, acceleration{"m/s²", 1},
        mass{"kg", 1}, force{"N", 1}, moment{"N m", 1}, inertia{"kg m²", 1}, pressure{"Pa", 1};
};

/// A scale that the file prescribes for a figure: `quantity` SI units for each mm on paper (drawing: m/mm, "1:5" is
/// 0.005).
struct AskedScale {
    std::string figure;
    Exact per_millimetre;
    std::string where;
};

/// A parameter of the file, for expressions of results.
struct NamedParameter {
    std::string name;
    double value = 0;  ///< SI, angles in rad
    Dimension dimension;
};

/// What a file states in place of joints (engine/mechanism/problem.hpp).
struct Problem;
/// The materials of the contact at a joint (engine/mechanism/contact.hpp).
struct LoadedContact;

/// The exercise of a file: wanted results, and which parameters vary (engine/mechanism/exercise.hpp).
struct Exercise;

struct Mechanism {
    std::string source;  ///< the file's name, for messages and the title block
    Words title;
    Units units;
    std::optional<Exact> precision;  ///< error of coordinates and lengths, m, as the file states it; 0: none
    std::string cam_file;  ///< not empty: this is one position of that file's cam, with its circle of curvature at the
                           ///< contact in place of the profile, so it cannot be moved
    std::vector<Exact> computed;  ///< lengths computed by formulas, m, in order: exact, however many digits they have
    std::vector<NamedPoint> points;
    std::vector<Body> bodies;  ///< the frame first
    std::vector<Joint> joints;
    std::vector<Driver> drivers;
    std::vector<Mass> masses;
    std::optional<Vector> gravity;
    bool inertia_forces = false;
    std::vector<Load> loads;
    std::vector<Effort> efforts;
    std::optional<InstantaneousMotion> motion;
    std::shared_ptr<const Problem> problem;                      ///< in place of joints; null: none
    std::shared_ptr<const std::vector<LoadedContact>> contacts;  ///< null: no joint has materials
    std::shared_ptr<const Exercise> exercise;                    ///< null: the file is no exercise
    std::vector<NamedParameter> parameters;                      ///< in the file's order
    Find find;
    std::vector<AskedScale> scales;

    const NamedPoint& point(PointIndex index) const { return points[at_index(index)]; }
    const Body& body(BodyIndex index) const { return bodies[at_index(index)]; }
    const Joint& joint(JointIndex index) const { return joints[at_index(index)]; }
    /// Precondition: the joint is one of this mechanism's.
    JointIndex index_of(const Joint& joint) const { return JointIndex(&joint - joints.data()); }
    /// All bodies but the frame.
    Indices<BodyIndex> moving_bodies() const { return bodies_after(frame); }
    Indices<BodyIndex> bodies_after(BodyIndex body) const { return indices<BodyIndex>(bodies.size(), body.next()); }
    std::optional<PointIndex> point_named(std::string_view name) const;
    std::optional<BodyIndex> body_named(std::string_view name) const;

    // Defined in one source file: inlining them in every user would cost seconds of compile time.
    Mechanism();
    Mechanism(const Mechanism&);
    Mechanism(Mechanism&&) noexcept;
    Mechanism& operator=(const Mechanism&);
    Mechanism& operator=(Mechanism&&) noexcept;
    ~Mechanism();
};

/// A parameter's value that replaces the file's: "r", "45 mm".
struct Setting {
    std::string name;
    std::string value;
};

/// Reads a mechanism from the text of a file, as docs/file.md says. `source` names it in messages.
/// Errors: every fault of the text at once, each with its JSON pointer, what is wrong and the remedy.
Result<Mechanism> read_mechanism(std::string_view text, std::string source, std::span<const Setting> set = {});

}  // namespace kinegraph
