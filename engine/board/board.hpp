// The drawing board: the instruments and nothing else. Each call does a construction exactly and enters a stroke in the
// Protocol: verb, inputs, output, figure. Predicates answer and are entered as guards. Nothing asks a number off the
// board: what was found is read from the finished protocol. It knows no mechanism theory, no millimetre.
//
// The board replays its program on a finer pose, which is how a suspiciously small value is decided (docs/notation.md,
// "Exact").
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/board/program.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/geometry.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// Typed handles: an index into the protocol's elements that knows its plane. A point of the drawing cannot be joined
/// to a tip.
template <Plane plane>
struct PointOn {
    ElementIndex element = none;
};
template <Plane plane>
struct LineOn {
    ElementIndex element = none;
};
template <Plane plane>
struct VectorOn {
    ElementIndex element = none;
};
struct DirectionHandle {
    ElementIndex element = none;
};
struct ScalarHandle {
    ElementIndex element = none;
};

/// The polygon of one body within a joined force polygon: its corners in order.
struct Face {
    BodyIndex body = none;
    std::vector<ElementIndex> corners;  ///< elements: points of the force plane
};
/// A polygon: a figure of one plane, with its own pole.
struct Polygon {
    Plane plane = Plane::velocity;
    std::string id;               ///< "velocity", "acceleration", "velocity-E-2"
    std::string point, observer;  ///< relative-motion polygons: of which point, seen by whom ("translating" ones:
                                  ///< observer is the origin's name, `translating` true)
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
    ElementIndex place = none;  ///< point element of the drawing
    BodyIndex body = none;
    PointIndex point = none;  ///< the file's point there; none: an auxiliary place
};
/// Whose motion a vector of motion is, or is part of, and how it is seen.
struct Seen {
    CarriedPlace of;
    CarriedPlace to;            ///< from where it is seen; no body: from the frame
    ElementIndex about = none;  ///< point element about which `of` turns, seen from `to`; none: it goes straight
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
    int trial =
        0;      ///< 1, 2: from the first, the second trial value of an assumption (Protocol::trials); 0: the solution
    Seen seen;  ///< nothing for a force, nor for a component along a line
    Quantity quantity;      ///< nothing for a component along a line
    bool vanishes = false;  ///< zero within the precision of the data: it is not drawn
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
/// A construction line of a polygon or of the drawing worth showing, with its direction in words and the places it was
/// drawn between.
struct DrawnLine {
    ElementIndex line = none;
    int polygon = -1;  ///< −1: in the drawing of the mechanism
    LineReason reason;
    std::vector<ElementIndex> points;  ///< point elements it passes (support, meet)
    StatementIndex statement = none;
    int trial = 0;  ///< as DrawnVector::trial
};

/// What a sentence is about: the section of the solution that it stands in.
enum class Topic { unnamed, velocity, acceleration, relative_motion, centres, curvature, forces };
/// As headings are looked up and results written: "relative motion".
std::string_view name_of(Topic topic);

/// A sentence of the solution with its equation and strokes.
struct Statement {
    Message message;
    std::optional<Equation> equation;
    Topic section = Topic::unnamed;
    std::string source;             ///< theorem or book: "Rivals", "Aronhold–Kennedy", "Coriolis"
    std::vector<Quantity> finds;    ///< ω, α and forces that it ends with, in the order it names them
    std::vector<BodyIndex> bodies;  ///< forces: the bodies it takes together; curvature: the body it is about
};

/// By how much the tip of a trial misses the line that it must lie on.
struct DrawnMiss {
    Symbol symbol;  ///< ε^I
    int polygon = 0;
    ElementIndex through = none;  ///< what the line was drawn from
    ElementIndex foot = none;     ///< of the perpendicular from the tip
    ElementIndex tip = none;
    StatementIndex statement = none;
};

/// What was drawn from trial values on the way, apart from the solution: thin broken lines of the same polygons.
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
    /// By element, on each of the pose's shifted drawings; to some 200 bits. Empty where nothing is rounded.
    std::vector<std::vector<Value>> shifted;

    const ProjectivePoint& point(ElementIndex element) const {
        return std::get<ProjectivePoint>(values[at_index(element)]);
    }
    const ProjectiveLine& line(ElementIndex element) const {
        return std::get<ProjectiveLine>(values[at_index(element)]);
    }
    const Vector& vector(ElementIndex element) const { return std::get<Vector>(values[at_index(element)]); }
    const Exact& scalar(ElementIndex element) const { return std::get<Exact>(values[at_index(element)]); }
    /// Tip − tail of a drawn vector, exact, in its plane's SI unit; nothing where it is zero within the data.
    Vector value_of(const DrawnVector& drawn) const {
        return drawn.vanishes ? Vector{} : point(drawn.tip) - point(drawn.tail);
    }
    /// Its length, to the nearest double.
    double modulus_of(const DrawnVector& drawn) const {
        return drawn.vanishes ? 0 : distance(point(drawn.tail), point(drawn.tip));
    }
};

/// The elements that are drawn: vectors, images, lines, corners of faces, those of trials too.
void for_each_drawn(Protocol& protocol, const std::function<void(ElementIndex& element)>& see);

class Board {
public:
    /// `finer` gives the same mechanism's pose at twice the bits, asked for only when a predicate needs a second look.
    /// All three must outlive the board.
    Board(const Mechanism& mechanism, const Pose& pose, std::function<const Pose&()> finer);
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;

    /// Opens a sentence: the strokes that follow belong to it, until the next one. Returns its index.
    StatementIndex state(Statement statement);
    Statement& statement(StatementIndex index);

    // What is given, and below what is constructed: asked for twice, the same element is returned.
    PointOn<Plane::drawing> place(PointIndex point) { return {given(Given::Kind::place, point)}; }
    DirectionHandle guide(JointIndex joint) { return {given(Given::Kind::guide, joint)}; }
    DirectionHandle guide_unit(JointIndex joint) { return {given(Given::Kind::guide_unit, joint)}; }
    DirectionHandle normal(JointIndex joint) { return {given(Given::Kind::normal, joint)}; }
    DirectionHandle other_normal(JointIndex joint) { return {given(Given::Kind::other_normal, joint)}; }
    DirectionHandle tangent(JointIndex joint) { return {given(Given::Kind::tangent, joint)}; }
    DirectionHandle push(JointIndex joint) { return {given(Given::Kind::push, joint)}; }
    DirectionHandle driver_direction(int driver) { return {given(Given::Kind::driver_direction, driver)}; }
    DirectionHandle driver_unit(int driver) { return {given(Given::Kind::driver_unit, driver)}; }
    ScalarHandle driver_velocity(int driver) { return {given(Given::Kind::driver_velocity, driver)}; }
    ScalarHandle driver_acceleration(int driver) { return {given(Given::Kind::driver_acceleration, driver)}; }
    VectorOn<Plane::velocity> act_velocity(int index) { return {given(Given::Kind::act_velocity, index)}; }
    VectorOn<Plane::acceleration> act_acceleration(int index) { return {given(Given::Kind::act_acceleration, index)}; }
    VectorOn<Plane::force> load_force(int load) { return {given(Given::Kind::load_force, load)}; }
    ScalarHandle load_magnitude(int load) { return {given(Given::Kind::load_magnitude, load)}; }
    DirectionHandle load_unit(int load) { return {given(Given::Kind::load_unit, load)}; }
    DirectionHandle load_unit_back(int load) { return {given(Given::Kind::load_unit_back, load)}; }
    DirectionHandle effort_unit(int effort) { return {given(Given::Kind::effort_unit, effort)}; }
    VectorOn<Plane::acceleration> gravity() { return {given(Given::Kind::gravity, 0)}; }
    ScalarHandle mass(int mass) { return {given(Given::Kind::mass, mass)}; }
    ScalarHandle inertia(int mass) { return {given(Given::Kind::inertia, mass)}; }
    /// A number, a direction of the construction's own.
    ScalarHandle number(const Exact& value);
    DirectionHandle own_direction(const Vector& direction);

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
        const ElementIndex element = meet(plane, l.element, m.element);
        if (element == none) return std::nullopt;
        return PointOn<plane>{element};
    }
    PointOn<Plane::drawing> at_infinity(DirectionHandle d) {
        return {unary(Verb::point_at_infinity, Plane::drawing, d.element)};
    }
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
    ScalarHandle product(ScalarHandle a, ScalarHandle b) { return {of_scalars(Verb::product, a.element, b.element)}; }
    /// a / b, b ≠ 0 (ask first).
    ScalarHandle quotient(ScalarHandle a, ScalarHandle b) { return {of_scalars(Verb::quotient, a.element, b.element)}; }
    ScalarHandle opposite(ScalarHandle a) { return {of_scalars(Verb::opposite, a.element, none)}; }
    /// r ∧ F: the moment of a force about the tail of r (N m, counter-clockwise positive).
    ScalarHandle moment(VectorOn<Plane::drawing> r, VectorOn<Plane::force> force) {
        return {binary(Verb::moment, Plane::force, r.element, force.element)};
    }
    /// The same of a direction and a force: how large the force is across the direction, times the direction's length.
    ScalarHandle moment(DirectionHandle d, VectorOn<Plane::force> force) {
        return {binary(Verb::moment, Plane::force, d.element, force.element)};
    }
    /// F·v: the power of a force at a place with this velocity (W).
    ScalarHandle power(VectorOn<Plane::force> force, VectorOn<Plane::velocity> velocity) {
        return {binary(Verb::projection, Plane::force, force.element, velocity.element)};
    }
    /// r ∧ d for a direction in the drawing: the lever of a force along d, times the length of d.
    ScalarHandle moment(VectorOn<Plane::drawing> r, DirectionHandle d) {
        return {binary(Verb::moment, Plane::drawing, r.element, d.element)};
    }
    /// By how much a force ≠ 0 must be moved aside to carry the couple too: the vector b ⟂ F with b ∧ F = M, |b| = M/F.
    VectorOn<Plane::drawing> arm(ScalarHandle couple, VectorOn<Plane::force> force) {
        return {binary(Verb::arm, Plane::drawing, couple.element, force.element)};
    }
    ScalarHandle sum(ScalarHandle a, ScalarHandle b) { return {of_scalars(Verb::sum, a.element, b.element)}; }
    ScalarHandle difference(ScalarHandle a, ScalarHandle b) {
        return {of_scalars(Verb::difference, a.element, b.element)};
    }

    // Predicates: answered exactly, on a pose with a leftover by the finer pose, on rounded data within their
    // precision; entered as guards. Asked twice, the answer is the one already entered.
    template <Plane plane>
    bool coincide(PointOn<plane> p, PointOn<plane> q) {
        return ask(Guard::Question::coincide, p.element, q.element) != 0;
    }
    bool parallel(DirectionHandle d, DirectionHandle e) {
        return ask(Guard::Question::parallel, d.element, e.element) != 0;
    }
    template <Plane plane>
    bool parallel(LineOn<plane> l, LineOn<plane> m) {
        return ask(Guard::Question::parallel, l.element, m.element) != 0;
    }
    template <Plane plane>
    bool is_zero(VectorOn<plane> v) {
        return ask(Guard::Question::zero_vector, before_turning(protocol_.program, v.element), none) != 0;
    }
    bool is_zero(ScalarHandle s) { return ask(Guard::Question::zero_scalar, s.element, none) != 0; }
    template <Plane plane>
    bool on_line(PointOn<plane> p, LineOn<plane> l) {
        return ask(Guard::Question::on_line, p.element, l.element) != 0;
    }
    template <Plane plane>
    bool is_at_infinity(PointOn<plane> p) const {
        return kinegraph::is_at_infinity(protocol_.program, p.element);
    }
    template <Plane plane>
    bool is_at_infinity(LineOn<plane> l) const {
        return kinegraph::is_at_infinity(protocol_.program, l.element);
    }
    /// −1, 0, 1.
    int sign(ScalarHandle s) { return ask(Guard::Question::sign, s.element, none); }
    /// Whether w lies along v (1), against it (−1) or across it (0).
    template <Plane p>
    int along_sign(DirectionHandle v, VectorOn<p> w) {
        return ask(Guard::Question::along_sign, v.element, w.element);
    }

    // The same where every answer is right and the handier way is taken (the order of a polygon's sides, a trial's
    // size).
    /// To which side of v is w turned: counter-clockwise 1, clockwise −1; 0 along the same line.
    template <Plane plane>
    int choose_turn(VectorOn<plane> v, VectorOn<plane> w) {
        return ask(Guard::Question::turn_sign, v.element, w.element, Guard::How::by_choice);
    }
    template <Plane plane>
    int choose_along(VectorOn<plane> v, VectorOn<plane> w) {
        return ask(Guard::Question::along_sign, v.element, w.element, Guard::How::by_choice);
    }
    template <Plane plane>
    bool choose_longer(VectorOn<plane> v, VectorOn<plane> w) {
        return ask(Guard::Question::longer, v.element, w.element, Guard::How::by_choice) != 0;
    }

    /// How far the board is; `rewind` wipes off what came after, where an attempt led nowhere: search is not solution.
    /// Handles made since are void.
    struct Mark {
        std::size_t strokes = 0, guards = 0, givens = 0, statements = 0, made = 0, asked = 0;
        StatementIndex statement = none;
        Largest<Exact> largest;
    };
    Mark mark() const;
    void rewind(const Mark& mark);
    /// How many strokes there are: what was found by now is settled.
    int strokes() const { return static_cast<int>(protocol_.program.strokes.size()); }

    // What is shown.
    int add_polygon(Polygon polygon);
    /// Of the sentence said last, where it names none.
    void draw(DrawnVector vector);
    void label(Image image);
    void add_face(int polygon, Face face);
    void draw(DrawnLine line);
    void draw(DrawnMiss miss);

    /// The strokes so far, to be replayed; recipes and planner look at none.
    const Program& program() const { return protocol_.program; }
    /// The record as it stands, with all that was tried and led nowhere still in it: to be cut by who knows what was
    /// wanted.
    Protocol finish() &&;

private:
    using Key = std::pair<Given::Kind, int>;
    ElementIndex given(Given::Kind kind, int index);
    template <class Of>
    ElementIndex given(Given::Kind kind, ListIndex<Of> index) {
        return given(kind, index.number());
    }
    ElementIndex enter_given(Given given);
    ElementIndex pole(Plane plane);
    ElementIndex unary(Verb verb, Plane plane, ElementIndex a);
    ElementIndex binary(Verb verb, Plane plane, ElementIndex a, ElementIndex b);
    ElementIndex make(Verb verb, Plane plane, ElementIndex a, ElementIndex b);
    ElementIndex of_scalars(Verb verb, ElementIndex a, ElementIndex b);
    ElementIndex join(Plane plane, ElementIndex p, ElementIndex q);
    ElementIndex meet(Plane plane, ElementIndex l, ElementIndex m);
    /// The stroke whose value was put last.
    ElementIndex enter(const Stroke& stroke);
    int ask(Guard::Question question, ElementIndex a, ElementIndex b, Guard::How how = Guard::How::exactly);
    void decide(Guard& guard);
    struct Echo;
    Echo echo_on(const Mechanism& mechanism, const Pose& pose, int digits) const;
    void follow(Echo& echo) const;
    bool lies_within_precision(const Guard& guard, const Answer<Exact>& here);

    /// Elements in a row: what carry_out() works on.
    struct Memory {
        using Number = Exact;
        std::vector<Value> values;

        const Value& value(ElementIndex i) const;
        const ProjectivePoint& point(ElementIndex i) const { return std::get<ProjectivePoint>(value(i)); }
        const ProjectiveLine& line(ElementIndex i) const { return std::get<ProjectiveLine>(value(i)); }
        const Vector& vector(ElementIndex i) const { return std::get<Vector>(value(i)); }
        const Exact& scalar(ElementIndex i) const { return std::get<Exact>(value(i)); }
        bool is_line(ElementIndex i) const { return std::holds_alternative<ProjectiveLine>(value(i)); }
        template <class Made>
        void put(ElementIndex, Made&& made) {
            values.emplace_back(std::forward<Made>(made));
        }
    };

    /// The same strokes on another pose; continued only when a predicate asks.
    struct Echo {
        const Mechanism& mechanism;
        const Pose& pose;
        int digits;  ///< that a comparison needs
        Memory memory;
        Largest<Exact> largest;
    };

    const Mechanism& mechanism_;
    const Pose& pose_;
    std::function<const Pose&()> finer_pose_;
    Protocol protocol_;
    Memory memory_;
    Largest<Exact> largest_;
    std::vector<Echo> shifted_;  ///< on the poses shifted within the precision; none where nothing is rounded
    std::optional<Echo> finer_;
    std::map<Key, ElementIndex> givens_;
    std::vector<std::pair<Exact, ElementIndex>> numbers_;
    std::vector<std::pair<Vector, ElementIndex>> directions_;
    std::map<std::tuple<Guard::Question, ElementIndex, ElementIndex>, std::size_t> asked_;
    std::map<std::tuple<Verb, Plane, ElementIndex, ElementIndex>, ElementIndex> made_;  ///< no line is drawn twice
    // In the order in which they were entered: what is taken back is the latest, however many there are.
    std::vector<decltype(asked_)::iterator> asked_in_order_;
    std::vector<decltype(made_)::iterator> made_in_order_;
    StatementIndex current_statement_ = none;
};

}  // namespace kinegraph
