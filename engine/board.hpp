// The drawing board: the instruments and nothing else. Each call does a construction exactly and enters a stroke in the Protocol:
// verb, inputs, output, figure. Predicates answer and are entered as guards. It knows no mechanism theory, no millimetre.
//
// Strokes are a straight-line program over the pose: branch-free, because a verdict (parallel, coincident) chooses the verb.
// So the board can replay them on a finer pose, which is how a suspiciously small value is decided (docs/notation.md, "Exact").
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/exact.hpp"
#include "engine/geometry.hpp"
#include "engine/pose.hpp"
#include "engine/quantity.hpp"
#include "engine/statement.hpp"

namespace kinegraph {

/// The planes a stroke may lie in: the drawing of the mechanism (m), the velocity plane (m/s), the acceleration plane (m/s²),
/// the force plane (N).
enum class Plane : std::uint8_t { drawing, velocity, acceleration, force };

using Value = std::variant<ProjectivePoint, ProjectiveLine, Vector, Exact>;

/// Typed handles: an index into the protocol's elements that knows its plane. A point of the drawing cannot be joined to a tip.
template <Plane plane>
struct PointOn {
    int element = -1;
};
template <Plane plane>
struct LineOn {
    int element = -1;
};
template <Plane plane>
struct VectorOn {
    int element = -1;
};
struct DirectionHandle {
    int element = -1;
};
struct ScalarHandle {
    int element = -1;
};

enum class Verb : std::uint8_t {
    given_place,
    given_guide,
    given_unit_guide,
    given_normal,
    given_tangent,
    given_driver_direction,
    given_unit_driver_direction,
    given_direction,
    given_by_pose,
    given_scalar,
    pole,
    vector_between,
    perpendicular,
    direction_of_line,
    point_at_infinity,
    through,
    join,
    meet,
    meet_at_infinity,
    carry,
    add,
    subtract,
    negate,
    scale,
    turn,
    ratio,
    product,
    sum,
    difference,
    quotient,
    moment,
    arm,
};

/// One stroke: element = verb(inputs). `index` is the point, joint or number of a given.
struct Stroke {
    Verb verb = Verb::given_scalar;
    Plane plane = Plane::drawing;
    int inputs[2] = {-1, -1};
    int index = -1;
    int statement = -1;  ///< the sentence it belongs to; −1 before the first
};

/// A predicate's verdict, kept because the construction went on with it.
struct Guard {
    enum class Question : std::uint8_t { coincide, parallel, zero_vector, zero_scalar, on_line } question = Question::coincide;
    int inputs[2] = {-1, -1};
    bool verdict = false;
    bool by_finer_pose = false;  ///< suspiciously small: decided by what it did on the finer pose (a heuristic, not a proof)
};

/// The polygon of one body within a joined force polygon: its corners in order.
struct Face {
    BodyIndex body = -1;
    std::vector<int> corners;  ///< elements: points of the force plane
};
/// A polygon: a figure of one plane, with its own pole.
struct Polygon {
    Plane plane = Plane::velocity;
    std::string id;               ///< "velocity", "acceleration", "velocity-E-2"
    std::string point, observer;  ///< relative-motion polygons: of which point, seen by whom ("translating" ones: observer is the
                                  ///< origin's name, `translating` true)
    bool translating = false;
    std::vector<int> vectors;  ///< indices into Protocol::vectors
    std::vector<int> images;   ///< indices into Protocol::images
    std::vector<Face> faces;   ///< force polygons: one for each body
    enum class Kind {
        motion,           ///< of all points: one for velocities, one for accelerations
        relative_motion,  ///< of one point, as an observer sees it
        body_forces,      ///< of one body
        joined_forces     ///< of bodies side by side, on their common forces
    } kind = Kind::motion;
};
/// A place as a body carries it.
struct CarriedPlace {
    int place = -1;  ///< point element of the drawing
    BodyIndex body = -1;
    PointIndex point = -1;  ///< the file's point there; −1: an auxiliary place
};
/// Whose motion a vector of motion is, or is part of, and how it is seen.
struct Seen {
    CarriedPlace of;
    CarriedPlace to;  ///< from where it is seen; no body: from the frame
    int about = -1;   ///< point element about which `of` turns, seen from `to`; −1: it goes straight
};
/// A named vector of a polygon, from tail to tip (elements that are points of its plane).
struct DrawnVector {
    Symbol symbol;
    int polygon = 0;
    int tail = -1, tip = -1;
    BodyIndex body = -1;
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
    int statement = -1;
    int trial = 0;      ///< 1, 2: from the first, the second trial value of an assumption (Protocol::trials); 0: the solution
    Seen seen;          ///< nothing for a force, nor for a component along a line
    Quantity quantity;  ///< nothing for a component along a line
};
/// A labelled vertex of a polygon: the image of a point ("a"), the pole ("o", with the points at rest).
struct Image {
    Symbol symbol;
    int polygon = 0;
    int point = -1;  ///< element
    BodyIndex body = -1;
    int trial = 0;  ///< as DrawnVector::trial
};
/// A construction line of a polygon or of the drawing worth showing, with its direction in words and the places it was drawn
/// between.
struct DrawnLine {
    int line = -1;     ///< element
    int polygon = -1;  ///< −1: in the drawing of the mechanism
    LineReason reason;
    std::vector<int> points;  ///< point elements it passes (support, meet)
    int statement = -1;
    int trial = 0;  ///< as DrawnVector::trial
};

/// What a sentence is about: the section of the solution that it stands in.
enum class Topic { none, velocity, acceleration, relative_motion, centres, forces };
/// As headings are looked up and results written: "relative motion".
std::string_view name_of(Topic topic);

/// A sentence of the solution with its equation and strokes.
struct Statement {
    Message message;
    std::optional<Equation> equation;
    Topic section = Topic::none;
    std::string source;                     ///< theorem or book: "Rivals", "Aronhold–Kennedy", "Coriolis"
    int first_stroke = 0, last_stroke = 0;  ///< [first, last)
    std::vector<Quantity> finds;            ///< ω, α and forces that it ends with, in the order it names them
    std::vector<BodyIndex> bodies;          ///< forces: the bodies it takes together
};

/// What was drawn from trial values on the way, apart from the solution: thin broken lines of the same polygons.
struct Trials {
    std::vector<DrawnVector> vectors;
    std::vector<Image> images;
    std::vector<DrawnLine> lines;
};

/// The finished board.
struct Protocol {
    std::vector<Statement> statements;
    std::vector<Stroke> strokes;
    std::vector<Value> values;  ///< by element = stroke index
    std::vector<Guard> guards;
    std::vector<Polygon> polygons;
    std::vector<DrawnVector> vectors;
    std::vector<Image> images;
    std::vector<DrawnLine> lines;
    Trials trials;

    const ProjectivePoint& point(int element) const {
        return std::get<ProjectivePoint>(values[static_cast<std::size_t>(element)]);
    }
    const ProjectiveLine& line(int element) const { return std::get<ProjectiveLine>(values[static_cast<std::size_t>(element)]); }
    const Vector& vector(int element) const { return std::get<Vector>(values[static_cast<std::size_t>(element)]); }
    const Exact& scalar(int element) const { return std::get<Exact>(values[static_cast<std::size_t>(element)]); }
    /// Tip − tail of a drawn vector, exact, in its plane's SI unit.
    Vector value_of(const DrawnVector& drawn) const { return point(drawn.tip).place() - point(drawn.tail).place(); }
};

class Board {
public:
    /// `finer` gives the same mechanism's pose at twice the bits, asked for only when a predicate needs a second look.
    Board(const Pose& pose, std::function<const Pose&()> finer);
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;
    ~Board();

    /// Opens a sentence: the strokes that follow belong to it, until the next one. Returns its index.
    int state(Statement statement);
    Statement& statement(int index);

    // What is given. Asked for twice, the same element is returned.
    PointOn<Plane::drawing> place(PointIndex point);
    DirectionHandle guide(JointIndex joint);
    DirectionHandle guide_unit(JointIndex joint);  ///< as a unit vector (within the pose's bits)
    DirectionHandle normal(JointIndex joint);      ///< common normal of a pin-slot, contact, rolling or gear
    DirectionHandle tangent(JointIndex joint);     ///< common tangent of the profiles or pitch curves that touch there
    DirectionHandle driver_direction(int driver);  ///< `along` of a point driver
    DirectionHandle driver_unit(int driver);       ///< the same as a unit vector
    DirectionHandle given_direction(const Vector& direction);
    ScalarHandle given(const Exact& value);
    /// A given vector that hangs on the pose (a load along a guide, say), so that a finer pose gives it finer.
    template <Plane plane>
    VectorOn<plane> given(std::function<Vector(const Pose&)> vector) {
        return {given_by_pose(plane, std::move(vector))};
    }

    // Constructions in any plane.
    template <Plane plane>
    PointOn<plane> pole() {
        return {pole(plane)};
    }
    template <Plane plane>
    VectorOn<plane> vector(PointOn<plane> from, PointOn<plane> to) {
        return {binary(Verb::vector_between, plane, from.element, to.element)};
    }
    template <Plane plane>
    DirectionHandle direction(VectorOn<plane> v) const {
        return {v.element};  // a vector is its own direction: no stroke
    }
    template <Plane plane>
    DirectionHandle direction(LineOn<plane> l) {
        return {unary(Verb::direction_of_line, plane, l.element)};
    }
    DirectionHandle perpendicular(DirectionHandle d) { return {unary(Verb::perpendicular, Plane::drawing, d.element)}; }
    template <Plane plane>
    LineOn<plane> through(PointOn<plane> p, DirectionHandle d) {
        return {binary(Verb::through, plane, p.element, d.element)};
    }
    /// The join of two points that do not coincide (ask first); finite or at infinity.
    template <Plane plane>
    LineOn<plane> join(PointOn<plane> p, PointOn<plane> q) {
        return {join(plane, p.element, q.element)};
    }
    /// The meet of two lines: finite, or at infinity where they are parallel; nothing where they coincide.
    template <Plane plane>
    std::optional<PointOn<plane>> meet(LineOn<plane> l, LineOn<plane> m) {
        const int element = meet(plane, l.element, m.element);
        if (element < 0) return std::nullopt;
        return PointOn<plane>{element};
    }
    PointOn<Plane::drawing> at_infinity(DirectionHandle d) { return {unary(Verb::point_at_infinity, Plane::drawing, d.element)}; }
    template <Plane plane>
    PointOn<plane> carry(PointOn<plane> p, VectorOn<plane> v) {
        return {binary(Verb::carry, plane, p.element, v.element)};
    }
    template <Plane plane>
    VectorOn<plane> add(VectorOn<plane> v, VectorOn<plane> w) {
        return {binary(Verb::add, plane, v.element, w.element)};
    }
    template <Plane plane>
    VectorOn<plane> subtract(VectorOn<plane> v, VectorOn<plane> w) {
        return {binary(Verb::subtract, plane, v.element, w.element)};
    }
    template <Plane plane>
    VectorOn<plane> negate(VectorOn<plane> v) {
        return {unary(Verb::negate, plane, v.element)};
    }
    /// s·v carried into another plane: −ω²·BA is an acceleration.
    template <Plane to, Plane from>
    VectorOn<to> scale(ScalarHandle s, VectorOn<from> v) {
        return {binary(Verb::scale, to, s.element, v.element)};
    }
    template <Plane to>
    VectorOn<to> scale(ScalarHandle s, DirectionHandle d) {
        return {binary(Verb::scale, to, s.element, d.element)};
    }
    /// A quarter turn counter-clockwise.
    template <Plane plane>
    VectorOn<plane> turn(VectorOn<plane> v) {
        return {unary(Verb::turn, plane, v.element)};
    }
    /// k with v = k·w for parallel v and w ≠ 0 (any planes): ω = v_BA / (z × BA).
    template <Plane p, Plane q>
    ScalarHandle ratio(VectorOn<p> v, VectorOn<q> w) {
        return {binary(Verb::ratio, p, v.element, w.element)};
    }
    ScalarHandle product(ScalarHandle a, ScalarHandle b) { return {binary(Verb::product, Plane::drawing, a.element, b.element)}; }
    /// a / b, b ≠ 0 (ask first).
    ScalarHandle quotient(ScalarHandle a, ScalarHandle b) {
        return {binary(Verb::quotient, Plane::drawing, a.element, b.element)};
    }
    /// r ∧ F: the moment of a force about the tail of r (N m, counter-clockwise positive).
    ScalarHandle moment(VectorOn<Plane::drawing> r, VectorOn<Plane::force> force) {
        return {binary(Verb::moment, Plane::drawing, r.element, force.element)};
    }
    /// r ∧ d for a direction in the drawing: the lever of a force along d, times the length of d.
    ScalarHandle moment(VectorOn<Plane::drawing> r, DirectionHandle d) {
        return {binary(Verb::moment, Plane::drawing, r.element, d.element)};
    }
    /// By how much a force ≠ 0 must be moved aside to carry the couple too: the vector b ⟂ F with b ∧ F = M, |b| = M/F.
    VectorOn<Plane::drawing> arm(ScalarHandle couple, VectorOn<Plane::force> force) {
        return {binary(Verb::arm, Plane::drawing, couple.element, force.element)};
    }
    ScalarHandle sum(ScalarHandle a, ScalarHandle b) { return {binary(Verb::sum, Plane::drawing, a.element, b.element)}; }
    ScalarHandle difference(ScalarHandle a, ScalarHandle b) {
        return {binary(Verb::difference, Plane::drawing, a.element, b.element)};
    }

    // Predicates: answered exactly, or on a pose with a leftover by the finer pose; entered as guards.
    template <Plane plane>
    bool coincide(PointOn<plane> p, PointOn<plane> q) {
        return ask(Guard::Question::coincide, p.element, q.element);
    }
    bool parallel(DirectionHandle d, DirectionHandle e) { return ask(Guard::Question::parallel, d.element, e.element); }
    template <Plane plane>
    bool parallel(LineOn<plane> l, LineOn<plane> m) {
        return ask(Guard::Question::parallel, l.element, m.element);
    }
    template <Plane plane>
    bool is_zero(VectorOn<plane> v) {
        return ask(Guard::Question::zero_vector, v.element, -1);
    }
    bool is_zero(ScalarHandle s) { return ask(Guard::Question::zero_scalar, s.element, -1); }
    template <Plane plane>
    bool on_line(PointOn<plane> p, LineOn<plane> l) {
        return ask(Guard::Question::on_line, p.element, l.element);
    }
    template <Plane plane>
    bool is_at_infinity(PointOn<plane> p) const {
        return protocol_.point(p.element).at_infinity();
    }
    template <Plane plane>
    bool is_at_infinity(LineOn<plane> l) const {
        return protocol_.line(l.element).at_infinity();
    }

    // Values, for results and drawing; recipes and planner do not compute with them.
    const Protocol& protocol() const { return protocol_; }
    const Pose& pose() const { return pose_; }
    template <Plane plane>
    const ProjectivePoint& value(PointOn<plane> p) const {
        return protocol_.point(p.element);
    }
    template <Plane plane>
    const Vector& value(VectorOn<plane> v) const {
        return protocol_.vector(v.element);
    }
    const Exact& value(ScalarHandle s) const { return protocol_.scalar(s.element); }

    // What is shown.
    int add_polygon(Polygon polygon);
    void draw(DrawnVector vector);
    void label(Image image);
    void add_face(int polygon, Face face);
    void draw(DrawnLine line);

    Protocol finish() &&;

private:
    struct Replay;
    int pole(Plane plane);
    int given_by_pose(Plane plane, std::function<Vector(const Pose&)> vector);
    int unary(Verb verb, Plane plane, int a);
    int binary(Verb verb, Plane plane, int a, int b);
    int join(Plane plane, int p, int q);
    int meet(Plane plane, int l, int m);
    int given_once(std::vector<int>& known, Verb verb, int index);
    int enter(const Stroke& stroke);
    Value evaluate(const Stroke& stroke, const std::vector<Value>& values, const Pose& pose) const;
    bool ask(Guard::Question question, int a, int b);
    bool decide(Guard& guard);

    const Pose& pose_;
    std::function<const Pose&()> finer_;
    Protocol protocol_;
    std::unique_ptr<Replay> replay_;
    std::vector<Value> constants_;
    std::vector<std::function<Vector(const Pose&)>> by_pose_;
    std::vector<int> places_, guides_, guide_units_, normals_, tangents_, driver_directions_, driver_units_;
    int poles_[4] = {-1, -1, -1, -1};
    int current_statement_ = -1;
};

}  // namespace kinegraph
