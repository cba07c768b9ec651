// The drawing board: the instruments and nothing else. Each call carries out one construction exactly and records it as
// a stroke in the protocol: verb, inputs, output, figure. Predicates return a verdict and are recorded as guards. No
// call returns a number; results are read from the finished protocol. The board contains no mechanism theory and no
// paper size.
//
// The board replays its program on a finer pose to decide whether a suspiciously small value is zero (docs/notation.md,
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

#include "engine/board/protocol.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/geometry.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// Typed handles: an index into the protocol's elements, with the plane in its type. So a point of the drawing cannot
/// be joined to a tip of a polygon.
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

class Board {
public:
    /// `finer` returns the pose of the same mechanism at twice the bits. It is called only when a predicate cannot be
    /// decided otherwise. All three arguments must outlive the board.
    Board(const Mechanism& mechanism, const Pose& pose, std::function<const Pose&()> finer);
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;

    /// Opens a sentence: the strokes that follow belong to it, until the next one is opened. Returns its index.
    StatementIndex state(Statement statement);
    Statement& statement(StatementIndex index);

    // Givens, then constructions. The same call made twice returns the same element.
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
    /// A number or a direction chosen by the construction.
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
        return {v.element};  // a vector is its own direction: no stroke is needed
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
    /// The join of two points, finite or at infinity. Precondition: they do not coincide (test first).
    template <Plane plane>
    LineOn<plane> join(PointOn<plane> p, PointOn<plane> q) {
        return {join(plane, p.element, q.element)};
    }
    /// The meet of two lines: finite, or at infinity where they are parallel; empty where they coincide.
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
    /// s·v carried into another plane. Example: −ω²·BA is an acceleration.
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
    /// a / b. Precondition: b ≠ 0 (test first).
    ScalarHandle quotient(ScalarHandle a, ScalarHandle b) { return {of_scalars(Verb::quotient, a.element, b.element)}; }
    ScalarHandle opposite(ScalarHandle a) { return {of_scalars(Verb::opposite, a.element, none)}; }
    /// r ∧ F: the moment of a force about the tail of r (N m, counter-clockwise positive).
    ScalarHandle moment(VectorOn<Plane::drawing> r, VectorOn<Plane::force> force) {
        return {binary(Verb::moment, Plane::force, r.element, force.element)};
    }
    /// d ∧ F: the component of a force across the direction, times the direction's length.
    ScalarHandle moment(DirectionHandle d, VectorOn<Plane::force> force) {
        return {binary(Verb::moment, Plane::force, d.element, force.element)};
    }
    /// F·v: the power of a force applied at a place with this velocity (W).
    ScalarHandle power(VectorOn<Plane::force> force, VectorOn<Plane::velocity> velocity) {
        return {binary(Verb::projection, Plane::force, force.element, velocity.element)};
    }
    /// r ∧ d for a direction in the drawing: the lever arm of a force along d, times the length of d.
    ScalarHandle moment(VectorOn<Plane::drawing> r, DirectionHandle d) {
        return {binary(Verb::moment, Plane::drawing, r.element, d.element)};
    }
    /// The displacement that makes a force F ≠ 0 equivalent to F and a couple M: the vector b ⟂ F with b ∧ F = M, |b| =
    /// M/F.
    VectorOn<Plane::drawing> arm(ScalarHandle couple, VectorOn<Plane::force> force) {
        return {binary(Verb::arm, Plane::drawing, couple.element, force.element)};
    }
    ScalarHandle sum(ScalarHandle a, ScalarHandle b) { return {of_scalars(Verb::sum, a.element, b.element)}; }
    ScalarHandle difference(ScalarHandle a, ScalarHandle b) {
        return {of_scalars(Verb::difference, a.element, b.element)};
    }

    // Predicates: decided exactly; on a pose with a leftover decided by the finer pose; on rounded data decided within
    // their precision. Each is recorded as a guard. A repeated question returns the recorded verdict.
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
    /// Whether w points along v (1), against it (−1) or across it (0).
    template <Plane p>
    int along_sign(DirectionHandle v, VectorOn<p> w) {
        return ask(Guard::Question::along_sign, v.element, w.element);
    }

    // The same, for choices where every answer is correct and only convenience differs (the order of a polygon's sides,
    // the size of a trial value).
    /// The side of v to which w is turned: counter-clockwise 1, clockwise −1; 0 along the same line.
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

    /// A position in the program. `rewind` removes everything after it, when an attempt fails: a search is not part of
    /// the solution. Handles made since are invalid.
    struct Mark {
        std::size_t strokes = 0, guards = 0, givens = 0, statements = 0, made = 0, asked = 0;
        StatementIndex statement = none;
        Largest<Exact> largest;
    };
    Mark mark() const;
    void rewind(const Mark& mark);
    /// Number of strokes so far.
    int strokes() const { return static_cast<int>(protocol_.program.strokes.size()); }

    // What is shown.
    int add_polygon(Polygon polygon);
    /// Belongs to the latest sentence, unless it names one.
    void draw(DrawnVector vector);
    void label(Image image);
    void add_face(int polygon, Face face);
    void draw(DrawnLine line);
    void draw(DrawnMiss miss);

    /// The strokes so far, for replay. Recipes and planner do not read it.
    const Program& program() const { return protocol_.program; }
    /// The complete record, including attempts that failed. The caller cuts it to the results that are needed.
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
    /// The stroke whose value was stored last.
    ElementIndex enter(const Stroke& stroke);
    int ask(Guard::Question question, ElementIndex a, ElementIndex b, Guard::How how = Guard::How::exactly);
    void decide(Guard& guard);
    struct Echo;
    Echo echo_on(const Mechanism& mechanism, const Pose& pose, int digits) const;
    void follow(Echo& echo) const;
    bool lies_within_precision(const Guard& guard, const Answer<Exact>& here);

    /// Elements stored in a row: the memory of carry_out().
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

    /// The same strokes on another pose, evaluated only as far as a predicate needs.
    struct Echo {
        const Mechanism& mechanism;
        const Pose& pose;
        int digits;  ///< enough for a comparison
        Memory memory;
        Largest<Exact> largest;
    };

    const Mechanism& mechanism_;
    const Pose& pose_;
    std::function<const Pose&()> finer_pose_;
    Protocol protocol_;
    Memory memory_;
    Largest<Exact> largest_;
    std::vector<Echo> shifted_;  ///< on the poses shifted within the precision; empty where no datum is rounded
    std::optional<Echo> finer_;
    std::map<Key, ElementIndex> givens_;
    std::vector<std::pair<Exact, ElementIndex>> numbers_;
    std::vector<std::pair<Vector, ElementIndex>> directions_;
    std::map<std::tuple<Guard::Question, ElementIndex, ElementIndex>, std::size_t> asked_;
    std::map<std::tuple<Verb, Plane, ElementIndex, ElementIndex>, ElementIndex> made_;  ///< so that no line is drawn
                                                                                        ///< twice
    // In the order of recording: rewinding removes the latest.
    std::vector<decltype(asked_)::iterator> asked_in_order_;
    std::vector<decltype(made_)::iterator> made_in_order_;
    StatementIndex current_statement_ = none;
};

}  // namespace kinegraph
