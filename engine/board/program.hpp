// Program: a construction as a straight-line program. Givens are data with their names in the file; strokes construct
// elements; guards are the verdicts on which the construction depends, each at its position among the strokes. There
// are no branches: a verdict has already chosen the verb. So the program can be replayed with any number type and with
// other givens, as long as its guards hold.
//
// The single definition of each verb is carry_out(). The board runs it in Exact, Replay in doubles. The program
// contains no mechanism theory and no text about the purpose of a stroke; these belong to the protocol
// (engine/board/board.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "engine/number/assert.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/geometry.hpp"
#include "engine/number/index.hpp"

namespace kinegraph {

struct Mechanism;
struct Pose;

/// The plane of a stroke: the drawing of the mechanism (m), the velocity plane (m/s), the acceleration plane (m/s²),
/// the force plane (N). A scalar has the plane of the vectors it is proportional to: angular velocities the velocity
/// plane, angular accelerations and ω² the acceleration plane, couples and powers the force plane, pure numbers the
/// drawing.
enum class Plane : std::uint8_t { drawing, velocity, acceleration, force };
inline constexpr std::size_t plane_count = 4;

template <class Number>
using ValueOf = std::variant<PointOf<Number>, LineOf<Number>, VectorOf<Number>, Number>;
using Value = ValueOf<Exact>;

/// An input of the construction. `index` is that of the point, joint, driver, load, mass or effort.
struct Given {
    enum class Kind : std::uint8_t {
        place,  ///< a point of the drawing
        guide,  ///< direction of a joint's guide; _unit: as a unit vector
        guide_unit,
        normal,        ///< common normal of a pin-slot, contact, rolling or gear (its line of action)
        other_normal,  ///< a gear's other line of action: the normal mirrored at the common tangent
        tangent,       ///< common tangent of the profiles or pitch curves
        push,          ///< the sense in which a contact pushes its first body
        driver_direction,
        driver_unit,
        driver_velocity,      ///< ω (rad/s) or speed (m/s)
        driver_acceleration,  ///< α (rad/s²) or acceleration (m/s²)
        act_velocity,         ///< of the given instantaneous motion: a vector, or a direction where only that is given
        act_acceleration,
        load_force,      ///< its components, N
        load_magnitude,  ///< N, for a force given by magnitude and direction and for a spring; N m for a couple
        load_unit,       ///< direction of such a force; for a spring from its first point to the second
        load_unit_back,  ///< for a spring from its second point to the first
        effort_unit,     ///< direction of a balancing force
        gravity,         ///< m/s²
        mass,            ///< kg
        inertia,         ///< kg m²
        number,          ///< a number chosen by the construction: 2 of 2ω, a trial value
        direction        ///< a direction chosen by the construction: that of x, of y
    } kind = Kind::number;
    int index = -1;
    Vector constant;   ///< number (its x) and direction
    std::string name;  ///< JSON pointer into the file; empty where the construction chose the value
};

enum class Verb : std::uint8_t {
    given_point,
    given_vector,
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
    opposite,
    quotient,
    moment,
    projection,
    arm,
};

/// One stroke: element = verb(inputs). Its element has its index in Program::strokes.
struct Stroke {
    Verb verb = Verb::given_scalar;
    Plane plane = Plane::drawing;
    ElementIndex inputs[2] = {none, none};
    int given = -1;                   ///< index in Program::givens
    StatementIndex statement = none;  ///< the sentence it belongs to; none: before the first sentence
};

/// A predicate and its verdict. The later strokes depend on it.
struct Guard {
    enum class Question : std::uint8_t {
        coincide,     ///< two points
        parallel,     ///< two directions or lines
        zero_vector,  ///< one vector
        zero_scalar,
        on_line,    ///< a point and a line
        sign,       ///< of a scalar: −1, 0, 1
        turn_sign,  ///< of two vectors: 1 where the second is turned counter-clockwise from the first by less than 180°
        along_sign,  ///< of two vectors: 1 where the second has a component along the first, −1 against it
        longer       ///< of two vectors: whether the first is longer
    } question = Question::coincide;
    enum class How : std::uint8_t {
        exactly,
        by_finer_pose,  ///< suspiciously small: decided by how it shrinks on the finer pose (a heuristic, not a proof)
        by_precision,   ///< zero within the data: no larger than the effect of the precision of the givens
        by_choice       ///< no result depends on it: several choices were correct and the more convenient one was taken
    } how = How::exactly;
    ElementIndex inputs[2] = {none, none};
    int verdict = 0;  ///< 0 and 1 for no and yes
    int before = 0;   ///< index of the first stroke made after the decision
};

struct Program {
    std::vector<Given> givens;
    std::vector<Stroke> strokes;
    std::vector<Guard> guards;  ///< in the order of the decisions
    int doubtful_bits =
        0;  ///< values judged zero by the precision of the givens are below 2^-this of their reference magnitude
};

/// Whether a point or a line lies at infinity. Its verb decides, because guards chose the verb.
bool is_at_infinity(const Program& program, ElementIndex element);
/// The vector that was turned or reversed to make a direction. Both vanish together.
ElementIndex before_turning(const Program& program, ElementIndex element);

/// The values of a program's givens in the mechanism's pose (or another of its poses). Lengths in m, all SI.
std::vector<Value> givens_of(const Program& program, const Mechanism& mechanism, const Pose& pose);
Value given_value(const Given& given, const Mechanism& mechanism, const Pose& pose);
/// The JSON pointer of the given in the file.
std::string name_of_given(Given::Kind kind, int index, const Mechanism& mechanism);
ValueOf<double> to_double(const Value& value);
/// Compares number by number.
bool identical(const Value& a, const Value& b);

/// The indices of the givens on which an element depends, ascending.
std::vector<int> hangs_on(const Program& program, ElementIndex element);

/// A program reduced to the strokes that a set of elements needs (dead-code elimination).
struct Cut {
    Program program;
    std::vector<ElementIndex> element;  ///< by element of the whole: its index in `program`; none: dropped
};
/// Keeps the strokes that `wanted` needs, every guard decided before `settled` strokes were made, and the strokes those
/// guards need. A result depends on every earlier verdict, even where no stroke shows it (a body that translates).
/// Guards that only chose between correct alternatives are removed.
Cut cut(const Program& program, const std::vector<ElementIndex>& wanted, int settled);

/// A program evaluated in Exact.
struct Evaluation {
    std::vector<Value> values;   ///< by element; shorter than the program where a guard flipped
    std::optional<int> flipped;  ///< index of the first guard with a different verdict
};
/// Evaluates with other givens. `pose` supplies the drawing's size and the number of bits of the compass: a value as
/// small as its leftovers counts as zero.
Evaluation evaluate(const Program& program, const std::vector<Value>& givens, const Pose& pose);

/// The value with each number reduced to `digits` binary digits.
Value trimmed(const Value& value, int digits);
/// Binary digits that suffice to compare magnitudes on a pose computed to `bits` bits, with a margin for cancellation.
constexpr int digits_to_compare(int bits) { return 4 * bits; }
/// Values by element, truncated to `digits`. Enough to compare magnitudes; guards are not evaluated.
std::vector<Value> trimmed_values(const Program& program, const std::vector<Value>& givens, int digits);

// --- the one text
// ------------------------------------------------------------------------------------------------------------

/// k with v = k·w, computed as the component along w. So it is defined also for a replay on another pose, where v and w
/// are only nearly parallel.
template <class Number>
Number ratio_of(const VectorOf<Number>& v, const VectorOf<Number>& w) {
    if (is_zero(w.x)) return v.y / w.y;
    if (is_zero(w.y) || is_same_ratio(v.x, w.x, v.y, w.y)) return v.x / w.x;
    return dot(v, w) / squared_length(w);
}

/// Carries out a verb. `Memory` has Number, point(i), line(i), vector(i), scalar(i) and put(i, …) for each of these.
/// The owner of the memory stores the givens.
template <class Memory>
void carry_out(const Stroke& stroke, ElementIndex element, Memory& memory) {
    using Number = typename Memory::Number;
    using Point = PointOf<Number>;
    const ElementIndex a = stroke.inputs[0], b = stroke.inputs[1];
    switch (stroke.verb) {
        case Verb::given_point:
        case Verb::given_vector:
        case Verb::given_scalar: return;
        case Verb::pole: return memory.put(element, Point{0, 0, 1});
        case Verb::vector_between: return memory.put(element, memory.point(b) - memory.point(a));
        case Verb::perpendicular:
        case Verb::turn: return memory.put(element, quarter_turn(memory.vector(a)));
        case Verb::direction_of_line: return memory.put(element, memory.line(a).direction());
        case Verb::point_at_infinity: return memory.put(element, Point{memory.vector(a).x, memory.vector(a).y, 0});
        case Verb::through: return memory.put(element, line_through(memory.point(a), memory.vector(b)));
        case Verb::join: return memory.put(element, line_joining(memory.point(a), memory.point(b)));
        case Verb::meet: return memory.put(element, finite_meet(memory.line(a), memory.line(b)));
        case Verb::meet_at_infinity:
            return memory.put(element,
                              point_at_infinity_of(memory.line(a).at_infinity() ? memory.line(b) : memory.line(a)));
        case Verb::carry: {
            const auto tip = memory.point(a).place() + memory.vector(b);
            return memory.put(element, Point{tip.x, tip.y, 1});
        }
        case Verb::add: return memory.put(element, memory.vector(a) + memory.vector(b));
        case Verb::subtract: return memory.put(element, memory.vector(a) - memory.vector(b));
        case Verb::negate: return memory.put(element, -memory.vector(a));
        case Verb::scale: return memory.put(element, memory.scalar(a) * memory.vector(b));
        case Verb::ratio: return memory.put(element, ratio_of(memory.vector(a), memory.vector(b)));
        case Verb::product: return memory.put(element, Number(memory.scalar(a) * memory.scalar(b)));
        case Verb::sum: return memory.put(element, Number(memory.scalar(a) + memory.scalar(b)));
        case Verb::difference: return memory.put(element, Number(memory.scalar(a) - memory.scalar(b)));
        case Verb::opposite: return memory.put(element, Number(-memory.scalar(a)));
        case Verb::quotient: return memory.put(element, Number(memory.scalar(a) / memory.scalar(b)));
        case Verb::moment: return memory.put(element, cross(memory.vector(a), memory.vector(b)));
        case Verb::projection: return memory.put(element, dot(memory.vector(a), memory.vector(b)));
        case Verb::arm: {
            const auto& force = memory.vector(b);
            return memory.put(element, Number(-memory.scalar(a) / squared_length(force)) * quarter_turn(force));
        }
    }
    KG_ASSERT(false, "every verb is carried out");
}

/// The size of a number, to detect suspiciously small ones: for an Exact its binary order, which is cheap; for a double
/// its absolute value.
template <class Number>
struct Magnitude;
template <>
struct Magnitude<Exact> {
    static constexpr long order_of_zero = -1000000;  ///< below any value that a file may contain
    long order = order_of_zero;                      ///< log2 |value|, to within one

    static Magnitude of(const Exact& value);
    friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return {a.order + b.order}; }
    friend Magnitude operator/(const Magnitude& a, const Magnitude& b) { return {a.order - b.order}; }
    friend bool operator<(const Magnitude& a, const Magnitude& b) { return a.order < b.order; }
    /// At most 2^-bits of the unit.
    bool is_below(const Magnitude& unit, int bits) const { return order - unit.order <= -bits; }
};
template <>
struct Magnitude<double> {
    double size = 0;

    static Magnitude of(double value) { return {std::abs(value)}; }
    friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return {a.size * b.size}; }
    friend Magnitude operator/(const Magnitude& a, const Magnitude& b) { return {a.size / b.size}; }
    friend bool operator<(const Magnitude& a, const Magnitude& b) { return a.size < b.size; }
    bool is_below(const Magnitude& unit, int bits) const {
        return size * static_cast<double>(1ULL << bits) <= unit.size;
    }
};
template <class Number>
Magnitude<Number> magnitude_of(const Number& value) {
    return Magnitude<Number>::of(value);
}
template <class Number>
Magnitude<Number> magnitude_of(const VectorOf<Number>& vector) {
    return std::max(magnitude_of(vector.x), magnitude_of(vector.y));
}

/// The reference magnitude of each plane: the longest vector and the largest scalar so far; in the drawing its size.
template <class Number>
struct Largest {
    std::array<Magnitude<Number>, plane_count> vector, scalar;

    /// The reference for a scalar: the largest so far, or the product or quotient of the plane's vectors and the
    /// drawing's size (a couple F·l, an angular velocity v/l).
    Magnitude<Number> beside_scalar(Plane plane) const {
        const auto at = static_cast<std::size_t>(plane);
        if (plane == Plane::drawing) return scalar[at];
        const Magnitude<Number>& size = vector[static_cast<std::size_t>(Plane::drawing)];
        return std::max(scalar[at], plane == Plane::force ? vector[at] * size : vector[at] / size);
    }

    void note(Plane plane, const VectorOf<Number>& drawn) {
        auto& largest = vector[static_cast<std::size_t>(plane)];
        if (plane != Plane::drawing) largest = std::max(largest, magnitude_of(drawn));
    }
    void note(Plane plane, const PointOf<Number>& point) {
        if (plane != Plane::drawing) note(plane, point.place());
    }
    void note(Plane, const LineOf<Number>&) {}
    void note(Plane plane, const Number& value) {
        auto& largest = scalar[static_cast<std::size_t>(plane)];
        largest = std::max(largest, magnitude_of(value));
    }
};

/// The answer to a predicate, and the size of the number that decided it.
template <class Number>
struct Answer {
    int verdict = 0;
    bool is_exact = true;  ///< no number was measured, or it is exactly zero
    Magnitude<Number> excess, unit;
    std::optional<VectorOf<Number>> measured;  ///< the number that decided, if requested; a scalar in x

    bool is_small(int bits) const { return is_exact || excess.is_below(unit, bits); }
};

/// The direction of a vector or a line.
template <class Memory>
VectorOf<typename Memory::Number> direction_in(const Memory& memory, ElementIndex element) {
    return memory.is_line(element) ? memory.line(element).direction()
                                   : VectorOf<typename Memory::Number>(memory.vector(element));
}

template <class Memory>
Magnitude<typename Memory::Number> magnitude_of_direction(const Memory& memory, ElementIndex element) {
    if (!memory.is_line(element)) return magnitude_of(memory.vector(element));
    const auto& line = memory.line(element);
    return std::max(magnitude_of(line.b), magnitude_of(line.a));
}

/// The size of the vectors whose difference gives a direction. Its rounding error is relative to this size.
template <class Memory>
Magnitude<typename Memory::Number> scale_of(const std::vector<Stroke>& strokes, const Memory& memory,
                                            ElementIndex element, const Largest<typename Memory::Number>& largest) {
    const Stroke& stroke = strokes[at_index(element)];
    switch (stroke.verb) {
        case Verb::given_vector: return magnitude_of(memory.vector(element));
        case Verb::through: return scale_of(strokes, memory, stroke.inputs[1], largest);
        case Verb::perpendicular:
        case Verb::turn:
        case Verb::negate:
        case Verb::direction_of_line: return scale_of(strokes, memory, stroke.inputs[0], largest);
        default:
            return std::max(largest.vector[static_cast<std::size_t>(stroke.plane)],
                            magnitude_of_direction(memory, element));
    }
}

/// The reference for the cross product of two directions: it bounds what rounding alone produces when they are
/// parallel.
template <class Memory>
Magnitude<typename Memory::Number> slack_of_parallels(const Guard& guard, const std::vector<Stroke>& strokes,
                                                      const Memory& memory,
                                                      const Largest<typename Memory::Number>& largest) {
    const ElementIndex a = guard.inputs[0], b = guard.inputs[1];
    return std::max(scale_of(strokes, memory, a, largest) * magnitude_of_direction(memory, b),
                    magnitude_of_direction(memory, a) * scale_of(strokes, memory, b, largest));
}

/// The question of a guard, with the numbers that decide it.
template <class Memory>
class Predicate {
public:
    using Number = typename Memory::Number;

    Predicate(const Guard& guard, const std::vector<Stroke>& strokes, const Memory& memory,
              const Largest<Number>& largest, bool measures)
        : question_(guard.question),
          a_(guard.inputs[0]),
          b_(guard.inputs[1]),
          plane_(strokes[at_index(a_)].plane),
          memory_(memory),
          largest_(largest),
          measures_(measures) {}

    Answer<Number> answer() const {
        using Question = Guard::Question;
        switch (question_) {
            case Question::coincide: return coincide();
            case Question::parallel: return parallel();
            case Question::zero_vector: return zero(memory_.vector(a_), beside_vectors());
            case Question::zero_scalar: return zero(memory_.scalar(a_), largest_.beside_scalar(plane_));
            case Question::on_line: return on_line();
            case Question::sign: return sign(memory_.scalar(a_), largest_.beside_scalar(plane_));
            case Question::turn_sign:
                return sign(Number(cross(memory_.vector(a_), memory_.vector(b_))), size_of_product());
            case Question::along_sign:
                return sign(Number(dot(memory_.vector(a_), memory_.vector(b_))), size_of_product());
            case Question::longer:
                return without_size(squared_length(memory_.vector(b_)) < squared_length(memory_.vector(a_)));
        }
        KG_ASSERT(false, "every question has an answer");
    }

private:
    Answer<Number> coincide() const {
        const auto& p = memory_.point(a_);
        const auto& q = memory_.point(b_);
        if (p.at_infinity() && q.at_infinity()) return angle(p.place(), q.place());
        if (p.at_infinity() || q.at_infinity()) return without_size(false);
        return zero(p - q, beside_vectors());
    }
    Answer<Number> parallel() const {
        const bool first = memory_.is_line(a_) && memory_.line(a_).at_infinity();
        const bool second = memory_.is_line(b_) && memory_.line(b_).at_infinity();
        if (first || second) return without_size(first && second);
        return angle(direction_in(memory_, a_), direction_in(memory_, b_));
    }
    Answer<Number> on_line() const {
        const auto& p = memory_.point(a_);
        const auto& l = memory_.line(b_);
        if (l.at_infinity()) return without_size(p.at_infinity());
        if (p.at_infinity()) return angle(p.place(), l.direction());
        return zero(offset(p, l), magnitude_of(l.direction()) * beside_vectors());
    }

    const Magnitude<Number>& beside_vectors() const { return largest_.vector[static_cast<std::size_t>(plane_)]; }
    Magnitude<Number> size_of_product() const {
        return magnitude_of(memory_.vector(a_)) * magnitude_of(memory_.vector(b_));
    }

    static Answer<Number> without_size(bool yes) { return {yes ? 1 : 0, true, {}, {}, {}}; }
    template <class Excess>
    Answer<Number> zero(const Excess& excess, Magnitude<Number> unit) const {
        const Magnitude<Number> size = magnitude_of(excess);
        const bool vanishes = is_zero(excess);
        return noted({vanishes ? 1 : 0, vanishes, size, unit, {}}, excess);
    }
    Answer<Number> sign(const Number& value, Magnitude<Number> unit) const {
        const int verdict = sign_of(value);
        return noted({verdict, verdict == 0, magnitude_of(value), unit, {}}, value);
    }
    Answer<Number> angle(const VectorOf<Number>& d, const VectorOf<Number>& e) const {
        return zero(Number(cross(d, e)), magnitude_of(d) * magnitude_of(e));
    }
    template <class Measured>
    Answer<Number> noted(Answer<Number> found, const Measured& value) const {
        if (measures_) {
            if constexpr (requires { value.x; }) {
                found.measured = value;
            } else {
                found.measured = VectorOf<Number>{value, Number(0)};
            }
        }
        return found;
    }

    Guard::Question question_;
    ElementIndex a_, b_;
    Plane plane_;
    const Memory& memory_;
    const Largest<Number>& largest_;
    bool measures_;
};

/// Decides a predicate by exact zeros; the caller decides what a small excess means. For predicates of zero the verdict
/// 1 means that the excess is exactly zero.
template <class Memory>
Answer<typename Memory::Number> answer(const Guard& guard, const std::vector<Stroke>& strokes, const Memory& memory,
                                       const Largest<typename Memory::Number>& largest, bool measures = false) {
    return Predicate<Memory>(guard, strokes, memory, largest, measures).answer();
}

/// Whether the verdict is 1 where a number is zero. The other predicates return a sign (0 for zero) or an order.
constexpr bool asks_for_zero(Guard::Question question) { return question <= Guard::Question::on_line; }

}  // namespace kinegraph
