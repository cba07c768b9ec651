#include "problems/point/point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/file/expression.hpp"
#include "engine/file/expression_gap.hpp"
#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/point_motion.hpp"

namespace kinegraph {
namespace {

using MotionForm = PointProblem::Form;

// ----- numbers with error bounds

Estimate operator+(const Estimate& a, const Estimate& b) {
    return {a.value + b.value,
            a.noise + b.noise + std::numeric_limits<double>::epsilon() * (std::abs(a.value) + std::abs(b.value))};
}
Estimate operator-(const Estimate& a) { return {-a.value, a.noise}; }
Estimate operator-(const Estimate& a, const Estimate& b) { return a + -b; }
Estimate operator*(const Estimate& a, const Estimate& b) {
    const double value = a.value * b.value;
    return {value, std::abs(a.value) * b.noise + std::abs(b.value) * a.noise +
                       std::numeric_limits<double>::epsilon() * std::abs(value)};
}
Estimate operator/(const Estimate& a, const Estimate& b) {
    const double value = a.value / b.value;
    return {value, (a.noise + std::abs(value) * b.noise) / std::abs(b.value) +
                       std::numeric_limits<double>::epsilon() * std::abs(value)};
}
Estimate certain(double value) { return {value, std::numeric_limits<double>::epsilon() * std::abs(value)}; }
Estimate certain(const Exact& value) { return certain(value.to_double()); }
Estimate cosine(const Estimate& a) {
    return {nearest::cos(a.value), std::abs(nearest::sin(a.value)) * a.noise + 1e-16};
}
Estimate sine(const Estimate& a) { return {nearest::sin(a.value), std::abs(nearest::cos(a.value)) * a.noise + 1e-16}; }
Estimate root(const Estimate& a) {
    const double value = std::sqrt(a.value);
    return {value, (value > 0 ? a.noise / (2 * value) : 0) + 1e-16 * value};
}
/// A value within its rounding error becomes zero.
double cleaned(const Estimate& a) { return a.is_zero() ? 0 : a.value; }

/// A law and its derivatives at an instant.
using Values = std::array<Estimate, 3>;
/// Components x, y; of the place, the velocity, the acceleration.
using Pair = std::array<Estimate, 2>;
struct State {
    Pair place, velocity, acceleration;
    Values first, second;  ///< of the laws
};

bool is_finite(const Pair& pair) { return std::isfinite(pair[0].value) && std::isfinite(pair[1].value); }

// ----- path length along a curve

/// The point at a given path length along y = f(x). Each position is found from the last one.
class Walk {
public:
    Walk(const GraphPath& path, const Derived& of_path, const NamedConstants& constants)
        : path_(path), of_path_(of_path), constants_(constants), x_(path.start.to_double()) {}

    Values curve(double x) const {
        const double unit = path_.f.law.unit.to_double(), per = path_.f.law.variable_unit.to_double();
        Values found;
        double factor = unit;
        for (std::size_t order = 0; order < 3; ++order) {
            const Estimate each = estimate(of_path_.by_order.at(order), constants_, x / per);
            found.at(order) = {factor * each.value, std::abs(factor) * each.noise};
            factor /= per;
        }
        return found;
    }
    /// NaN if it is not found.
    double x_at(double way) {
        // The first interval may be long; those between samples are short.
        const int steps = has_begun_ ? 4 : 400;
        has_begun_ = true;
        const double from = way_;
        for (int i = 1; i <= steps; ++i) {
            const double next = from + (way - from) * i / steps;
            if (!step(next - way_)) return std::numeric_limits<double>::quiet_NaN();
            way_ = next;
        }
        return x_;
    }

private:
    double rate(double x) const {
        const double unit = path_.f.law.unit.to_double(), per = path_.f.law.variable_unit.to_double();
        const double slope = unit / per * estimate(of_path_.by_order[1], constants_, x / per).value;
        return std::sqrt(1 + slope * slope);
    }
    /// Gauss quadrature with five nodes.
    double roughly_between(double from, double to) const {
        constexpr std::array<double, 3> places{0, 0.53846931010568309, 0.90617984593866399};
        constexpr std::array<double, 3> weights{0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
        const double middle = (from + to) / 2, half = (to - from) / 2;
        double sum = weights[0] * rate(middle);
        for (std::size_t i = 1; i < 3; ++i)
            sum += weights.at(i) * (rate(middle + half * places.at(i)) + rate(middle - half * places.at(i)));
        return sum * half;
    }
    /// In parts as short as the bends of the path want: a part is short enough when its halves give the same.
    double length_between(double from, double to) const {
        struct Part {
            double from, to, length;
        };
        std::vector<Part> left{{from, to, roughly_between(from, to)}};
        const double same = 1e-15 * std::abs(left.front().length);
        double sum = 0;
        for (int parts = 0; !left.empty(); ++parts) {
            const Part part = left.back();
            left.pop_back();
            const double middle = (part.from + part.to) / 2;
            const double first = roughly_between(part.from, middle), second = roughly_between(middle, part.to);
            constexpr int most = 400;
            if (parts >= most || !(std::abs(first + second - part.length) > same)) {
                sum += first + second;
                continue;
            }
            left.push_back({part.from, middle, first});
            left.push_back({middle, part.to, second});
        }
        return sum;
    }
    bool step(double way) {
        double x = x_ + way / rate(x_), before = std::numeric_limits<double>::infinity();
        constexpr int most = 1100;  // from far beyond a tight bend each pass halves what is missing
        for (int i = 0; i < most; ++i) {
            const double missing = way - length_between(x_, x), size = std::abs(way) + std::abs(way_);
            if (!std::isfinite(missing)) return false;
            x += missing / rate(x);
            const bool is_rounding = std::abs(missing) <= 1e-12 * size && std::abs(missing) >= before;
            if (std::abs(missing) <= 1e-15 * size || is_rounding) break;
            before = std::abs(missing);
        }
        x_ = x;
        return true;
    }

    const GraphPath& path_;
    const Derived& of_path_;
    const NamedConstants& constants_;
    double x_, way_ = 0;
    bool has_begun_ = false;
};

// ----- the motion

/// Faults of laws and paths that are not finite somewhere.
struct MotionFaults {
    static Error path_ends(const GraphPath& graph, double time) {
        return {ErrorCode::bad_input, graph.f.where, {lang::point_motion::this_path_as_far, number_text(time)}};
    }
    /// `order`: of the derivative.
    static Error not_finite(const StatedLaw& law, std::size_t order, bool is_infinite, double time) {
        static const std::array<Words, 3> orders{Words(), Words(lang::point_motion::the_velocity),
                                                 Words(lang::point_motion::the_acceleration)};
        const Words how = is_infinite ? Words(lang::point_motion::is_infinite)
                                      : Words(lang::point_motion::is_not_real_or_is_infinite);
        return Error{ErrorCode::bad_input,
                     law.where,
                     {lang::point_motion::at_t_s_choose_an_interval, orders.at(order), Words(law.symbol), how,
                      number_text(time)}};
    }

private:
    static Words number_text(double value) {
        std::string text = std::to_string(value);
        while (text.ends_with('0')) text.pop_back();
        if (text.ends_with('.')) text.pop_back();
        return decimal_words(text);
    }
};

/// Components of the acceleration and the centre of curvature, constructed on the board.
class PointConstruction {
public:
    explicit PointConstruction(PointMotionSolution& found) : found_(found) {}

    void draw(const Mechanism& mechanism, const Pose& pose) {
        Board board(mechanism, pose, [&]() -> const Pose& { return pose; });
        draw(board);
        found_.record = std::move(board).finish();
        read();
    }

private:
    /// One metre on the drawing is 1 m/s and 1 m/s², so that ρ = v²/a_n is in metres.
    void draw(Board& board) {
        using enum Plane;
        const ScalarHandle one = board.number(1);
        PointOn<drawing> p = board.pole<drawing>();
        const auto laid_off = [&](const Vector& v) {
            return board.carry(p, board.scale<drawing>(one, board.own_direction(v)));
        };
        if (!found_.place.is_zero()) p = laid_off(found_.place);
        auto& elements = found_.elements;
        PointOn<drawing> tip = p;
        if (!found_.acceleration.is_zero()) tip = laid_off(found_.acceleration);
        elements.tip_of_acceleration = tip.element;
        if (found_.rests) return;
        const PointOn<drawing> v = laid_off(found_.velocity);
        elements.tip_of_velocity = v.element;
        const LineOn<drawing> tangent = board.join(p, v);
        const DirectionHandle along = board.direction(board.vector(p, v)), across = board.perpendicular(along);
        const LineOn<drawing> normal = board.through(p, across);
        // The projection of a on the normal.
        const auto foot = board.meet(board.through(tip, along), normal);
        KG_ASSERT(foot && tangent.element != normal.element, "tangent and normal meet in the point alone");
        elements.foot = foot->element;
        if (board.coincide(p, *foot)) return;
        // The right angle is at the tip of v, and v is the altitude: PC · a_n = v².
        const PointOn<drawing> reversed = board.carry(p, board.negate(board.vector(p, *foot)));
        elements.reversed = reversed.element;
        const LineOn<drawing> leg = board.join(reversed, v);
        const auto centre = board.meet(board.through(v, board.perpendicular(board.direction(leg))), normal);
        KG_ASSERT(centre, "a leg that is no tangent has its perpendicular meet the normal");
        elements.centre = centre->element;
    }

    void read() {
        const auto& elements = found_.elements;
        const auto at = [&](ElementIndex element) { return found_.record.point(element).place(); };
        found_.speed = length(found_.velocity);
        found_.acceleration_length = length(found_.acceleration);
        if (found_.rests) return;
        const Vector a = found_.acceleration;
        found_.normal = at(elements.foot) - found_.place;
        found_.tangential = a - *found_.normal;
        const double sign = dot(*found_.tangential, found_.velocity).sign();
        found_.along = sign * length(*found_.tangential);
        found_.across = length(*found_.normal);
        if (elements.centre == none) return;
        found_.centre = at(elements.centre);
        found_.radius = length(*found_.centre - found_.place);
    }

    PointMotionSolution& found_;
};

class MotionOfPoint {
public:
    explicit MotionOfPoint(const PointProblem& problem) : problem_(problem) {}

    /// Symbolic derivatives.
    std::optional<Error> derive() {
        for (const StatedLaw& law : problem_.laws) {
            auto derived = derivatives(law);
            if (!derived) return derived.error();
            found_.laws.push_back(*std::move(derived));
        }
        if (const auto* graph = problem_.path ? std::get_if<GraphPath>(&*problem_.path) : nullptr) {
            auto derived = derivatives(graph->f);
            if (!derived) return derived.error();
            found_.of_path = *std::move(derived);
        }
        return std::nullopt;
    }

    /// Evaluates the laws at the instant and over the interval.
    std::optional<Error> follow() {
        if (const auto* graph = problem_.path ? std::get_if<GraphPath>(&*problem_.path) : nullptr)
            walk_.emplace(*graph, *found_.of_path, problem_.constants);
        if (auto why = sample()) return why;
        if (auto why = gap_between_samples()) return why;
        const double at = problem_.at.to_double();
        if (walk_) walk_.emplace(std::get<GraphPath>(*problem_.path), *found_.of_path, problem_.constants);
        const State state = state_at(at);
        if (auto why = why_none(state, at, problem_.where_at)) return why;
        settle(state);
        return std::nullopt;
    }

    void construct(const Mechanism& mechanism, const Pose& pose) { PointConstruction(found_).draw(mechanism, pose); }
    PointMotionSolution solution() && { return std::move(found_); }

private:
    tl::expected<Derived, Error> derivatives(const StatedLaw& law) const {
        Derived derived;
        derived.by_order[0] = law.law.tree;
        for (std::size_t order = 1; order < 3; ++order) {
            auto next = derivative(derived.by_order.at(order - 1), problem_.constants);
            if (!next) {
                next.error().where = law.where;
                return tl::make_unexpected(std::move(next.error()));
            }
            derived.by_order.at(order) = *std::move(next);
        }
        return derived;
    }
    Values values_of(std::size_t law, double time) const {
        const double unit = problem_.laws[law].law.unit.to_double();
        Values values;
        for (std::size_t order = 0; order < 3; ++order) {
            const Estimate each = estimate(found_.laws[law].by_order.at(order), problem_.constants, time);
            values.at(order) = {unit * each.value, unit * each.noise};
        }
        return values;
    }

    State state_at(double time) {
        State state;
        state.first = values_of(0, time);
        switch (problem_.form) {
            case MotionForm::cartesian:
                state.second = values_of(1, time);
                state.place = {state.first[0], state.second[0]};
                state.velocity = {state.first[1], state.second[1]};
                state.acceleration = {state.first[2], state.second[2]};
                break;
            case MotionForm::polar:
                state.second = values_of(1, time);
                take_polar(state);
                break;
            case MotionForm::path: take_path(state); break;
        }
        return state;
    }
    static void take_polar(State& state) {
        const auto& [r, r1, r2] = state.first;
        const auto& [theta, theta1, theta2] = state.second;
        const Estimate c = cosine(theta), s = sine(theta), two = certain(2.0);
        const Estimate across = r * theta1, inward = r2 - r * theta1 * theta1, around = r * theta2 + two * r1 * theta1;
        state.place = {r * c, r * s};
        state.velocity = {r1 * c - across * s, r1 * s + across * c};
        state.acceleration = {inward * c - around * s, inward * s + around * c};
    }
    /// v = ṡ t,  a = s̈ t + κ ṡ² n,  with n to the left of t.
    void take_path(State& state) {
        const auto& [s, s1, s2] = state.first;
        Pair tangent;
        Estimate curvature;
        if (const auto* circle = std::get_if<CirclePath>(&*problem_.path)) {
            const Estimate radius = certain(circle->radius), angle = certain(circle->start) + s / radius;
            tangent = {-sine(angle), cosine(angle)};
            curvature = certain(1.0) / radius;
            state.place = {certain(circle->centre.x) + radius * tangent[1],
                           certain(circle->centre.y) - radius * tangent[0]};
        } else if (const auto* line = std::get_if<LinePath>(&*problem_.path)) {
            const double size = length(line->direction);
            tangent = {certain(line->direction.x.to_double() / size), certain(line->direction.y.to_double() / size)};
            state.place = {certain(line->from.x) + s * tangent[0], certain(line->from.y) + s * tangent[1]};
        } else {
            const double x = walk_->x_at(s.value);
            const Values f = walk_->curve(x);
            const Estimate size = root(certain(1.0) + f[1] * f[1]);
            tangent = {certain(1.0) / size, f[1] / size};
            curvature = f[2] / (size * size * size);
            state.place = {certain(x), f[0]};
            state.second = f;
        }
        const Estimate towards = curvature * s1 * s1;
        state.velocity = {s1 * tangent[0], s1 * tangent[1]};
        state.acceleration = {s2 * tangent[0] - towards * tangent[1], s2 * tangent[1] + towards * tangent[0]};
    }

    /// The law, or the derivative, that is not finite there.
    std::optional<Error> why_none(const State& state, double time, const std::string& where) const {
        if (is_finite(state.place) && is_finite(state.velocity) && is_finite(state.acceleration)) return std::nullopt;
        for (std::size_t order = 0; order < 3; ++order)
            for (std::size_t i = 0; i < problem_.laws.size(); ++i)
                if (!std::isfinite(values_of(i, time).at(order).value))
                    return MotionFaults::not_finite(problem_.laws[i], order,
                                                    std::isinf(values_of(i, time).at(order).value), time);
        if (const auto* graph = problem_.path ? std::get_if<GraphPath>(&*problem_.path) : nullptr)
            return MotionFaults::path_ends(*graph, time);
        return Error{ErrorCode::bad_input, where, {lang::point_motion::these_numbers_are_too_large}};
    }

    // ----- over the interval

    double speed_at(double time) {
        const State state = state_at(time);
        return nearest::hypot(state.velocity[0].value, state.velocity[1].value);
    }
    std::optional<Error> sample() {
        constexpr int samples = 240;
        const double from = problem_.from.to_double(), to = problem_.to.to_double(), at = problem_.at.to_double();
        double way = 0, last = from;
        for (int i = 0; i <= samples; ++i) {
            const double time = i == samples ? to : from + (to - from) * i / samples;
            const State state = state_at(time);
            if (auto why = why_none(state, time, problem_.where_from)) return why;
            if (problem_.form != MotionForm::path) {
                if (at > last && at <= time) found_.way = way + way_between(last, at);
                way += way_between(last, time);
                last = time;
            }
            found_.course.push_back(at_of(state, time, problem_.form == MotionForm::path ? state.first[0].value : way));
        }
        return std::nullopt;
    }
    /// A pole, or the end of a root, may lie between samples.
    std::optional<Error> gap_between_samples() const {
        for (std::size_t order = 0; order < 3; ++order)
            for (std::size_t i = 0; i < problem_.laws.size(); ++i)
                if (const auto gap = gap_within(found_.laws[i].by_order.at(order), problem_.constants,
                                                problem_.from.to_double(), problem_.to.to_double()))
                    return MotionFaults::not_finite(problem_.laws[i], order, gap->is_infinite, gap->at);
        const auto* graph = problem_.path ? std::get_if<GraphPath>(&*problem_.path) : nullptr;
        if (graph == nullptr) return std::nullopt;
        const double per = graph->f.law.variable_unit.to_double();
        const auto by_x = [](const auto& a, const auto& b) { return a.place.x < b.place.x; };
        const auto [least, most] = std::minmax_element(found_.course.begin(), found_.course.end(), by_x);
        for (const Expression& each : found_.of_path->by_order) {
            if (!(least->place.x < most->place.x)) break;
            const auto gap = gap_within(each, problem_.constants, least->place.x / per, most->place.x / per);
            if (!gap) continue;
            const auto beyond = [&](const auto& at) {
                return (at.place.x - gap->at * per) * (found_.course.front().place.x - gap->at * per) <= 0;
            };
            const auto there = std::find_if(found_.course.begin(), found_.course.end(), beyond);
            return MotionFaults::path_ends(*graph,
                                           there == found_.course.end() ? problem_.to.to_double() : there->time);
        }
        return std::nullopt;
    }
    /// Gauss quadrature with five nodes; speed has corners only where the point is at rest.
    double way_between(double from, double to) {
        if (!(to > from)) return 0;
        constexpr std::array<double, 3> places{0, 0.53846931010568309, 0.90617984593866399};
        constexpr std::array<double, 3> weights{0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
        constexpr int parts = 4;
        double sum = 0;
        for (int part = 0; part < parts; ++part) {
            const double half = (to - from) / (2 * parts), middle = from + half * (2 * part + 1);
            sum += half * weights[0] * speed_at(middle);
            for (std::size_t i = 1; i < 3; ++i)
                sum += half * weights.at(i) *
                       (speed_at(middle + half * places.at(i)) + speed_at(middle - half * places.at(i)));
        }
        return sum;
    }
    static PointMotionSolution::At at_of(const State& state, double time, double way) {
        PointMotionSolution::At at;
        at.time = time;
        at.way = way;
        at.place = {cleaned(state.place[0]), cleaned(state.place[1])};
        at.velocity = {cleaned(state.velocity[0]), cleaned(state.velocity[1])};
        const VectorOf<double> a{cleaned(state.acceleration[0]), cleaned(state.acceleration[1])};
        at.speed = nearest::hypot(at.velocity.x, at.velocity.y);
        at.rests = at.speed == 0;
        if (at.rests) return at;
        at.along = dot(at.velocity, a) / at.speed;
        at.across = std::abs(cross(at.velocity, a)) / at.speed;
        return at;
    }

    // ----- at the instant

    /// Converts doubles to exact numbers. Removes a component of the acceleration, along or across the velocity, that
    /// is within rounding, so that predicates of the board need not decide it.
    void settle(const State& state) {
        const auto exact = [](const Pair& pair) {
            return Vector{Exact::from_double(cleaned(pair[0])), Exact::from_double(cleaned(pair[1]))};
        };
        found_.place = exact(state.place);
        found_.velocity = exact(state.velocity);
        found_.acceleration = exact(state.acceleration);
        if (problem_.form == MotionForm::path) found_.way = state.first[0].value;
        const Vector &v = found_.velocity, &a = found_.acceleration;
        found_.rests = v.is_zero();
        found_.straight = found_.rests || a.is_zero();
        const Pair &vs = state.velocity, &as = state.acceleration;
        if (!found_.straight && (vs[0] * as[1] - vs[1] * as[0]).is_zero()) {
            found_.acceleration = (dot(a, v) / dot(v, v)) * v;
            found_.straight = true;
        } else if (!found_.rests && (vs[0] * as[0] + vs[1] * as[1]).is_zero()) {
            found_.acceleration = a - (dot(a, v) / dot(v, v)) * v;
        }
        settle_polar(state);
    }
    void settle_polar(const State& state) {
        if (problem_.form == MotionForm::polar) {
            const auto& [r, r1, r2] = state.first;
            const auto& [theta, theta1, theta2] = state.second;
            found_.r = cleaned(r);
            found_.theta = cleaned(theta);
            found_.polar_velocity = {cleaned(r1), cleaned(r * theta1)};
            found_.polar_acceleration = {cleaned(r2 - r * theta1 * theta1),
                                         cleaned(r * theta2 + certain(2.0) * r1 * theta1)};
            return;
        }
        const Pair& z = state.place;
        found_.r = length(found_.place);
        found_.at_pole = found_.place.is_zero();
        if (found_.at_pole) return;
        found_.theta = nearest::atan2(found_.place.y.to_double(), found_.place.x.to_double());
        const Estimate r = root(z[0] * z[0] + z[1] * z[1]);
        const auto components = [&](const Pair& of) {
            return std::array{cleaned((z[0] * of[0] + z[1] * of[1]) / r), cleaned((z[0] * of[1] - z[1] * of[0]) / r)};
        };
        found_.polar_velocity = components(state.velocity);
        found_.polar_acceleration = components(state.acceleration);
    }

    const PointProblem& problem_;
    std::optional<Walk> walk_;
    PointMotionSolution found_;
};

// ----- values for tables and results

std::vector<ProblemValue> values_of(const PointProblem& problem, const PointMotionSolution& found,
                                    const PointCheck& check) {
    using enum QuantityKind;
    std::vector<ProblemValue> values;
    const auto add = [&](const char* key, Words name, const char* symbol, QuantityKind kind, double value,
                         double numeric) {
        values.push_back({key, std::move(name), symbol, kind, value, numeric, false});
    };
    const auto both = [](const Vector& v) { return VectorOf<double>{v.x.to_double(), v.y.to_double()}; };
    const VectorOf<double> place = both(found.place), v = both(found.velocity), a = both(found.acceleration);
    add("x", {lang::point_motion::abscissa}, "x", length, place.x, check.place.x);
    add("y", {lang::point_motion::ordinate}, "y", length, place.y, check.place.y);
    add("way", {lang::point_motion::way}, "s", length, found.way, check.way);
    add("velocity x", {lang::point_motion::velocity_x}, "v_x", velocity, v.x, check.velocity.x);
    add("velocity y", {lang::point_motion::velocity_y}, "v_y", velocity, v.y, check.velocity.y);
    add("speed", {lang::point_motion::speed}, "v", velocity, found.speed, check.speed);
    add("acceleration x", {lang::point_motion::acceleration_x}, "a_x", acceleration, a.x, check.acceleration.x);
    add("acceleration y", {lang::point_motion::acceleration_y}, "a_y", acceleration, a.y, check.acceleration.y);
    add("acceleration", {lang::point_motion::acceleration}, "a", acceleration, found.acceleration_length,
        check.acceleration_length);
    if (!found.rests) {
        add("tangential acceleration", {lang::point_motion::tangential_acceleration}, "a_t", acceleration, found.along,
            check.along);
        add("normal acceleration", {lang::point_motion::normal_acceleration}, "a_n", acceleration, found.across,
            check.across);
    }
    if (found.centre) {
        add("radius of curvature", {lang::point_motion::radius_of_curvature}, "ρ", length, found.radius, check.radius);
        add("centre of curvature x", {lang::point_motion::centre_of_curvature_x}, "x_C", length,
            found.centre->x.to_double(), check.centre.x);
        add("centre of curvature y", {lang::point_motion::centre_of_curvature_y}, "y_C", length,
            found.centre->y.to_double(), check.centre.y);
    }
    add("radius", {lang::point_motion::radius}, "r", length, found.r, check.r);
    if (found.at_pole) return values;
    add("angle", {lang::point_motion::angle}, "θ", angle, found.theta, check.theta);
    add("radial velocity", {lang::point_motion::radial_velocity}, "v_r", velocity, found.polar_velocity[0],
        check.polar_velocity[0]);
    add("transverse velocity", {lang::point_motion::transverse_velocity}, "v_θ", velocity, found.polar_velocity[1],
        check.polar_velocity[1]);
    add("radial acceleration", {lang::point_motion::radial_acceleration}, "a_r", acceleration,
        found.polar_acceleration[0], check.polar_acceleration[0]);
    add("transverse acceleration", {lang::point_motion::transverse_acceleration}, "a_θ", acceleration,
        found.polar_acceleration[1], check.polar_acceleration[1]);
    (void)problem;
    return values;
}

std::vector<Words> remarks_on(const PointProblem& problem, const PointMotionSolution& found) {
    std::vector<Words> remarks;
    if (found.rests)
        remarks.emplace_back(lang::point_motion::the_point_is_at_rest);
    else if (found.straight)
        remarks.emplace_back(lang::point_motion::the_normal_acceleration_vanishes_the_radius);
    if (found.at_pole) remarks.emplace_back(lang::point_motion::the_point_passes_the_origin);
    if (problem.form == MotionForm::polar && found.r < 0)
        remarks.emplace_back(lang::point_motion::r_is_negative_the_point_lies);
    return remarks;
}

}  // namespace

Result<ProblemSolution> solve_point_motion(const PointProblem& problem, const Mechanism& mechanism, const Pose& pose) {
    MotionOfPoint motion(problem);
    if (auto why = motion.derive()) return tl::make_unexpected(Errors{*std::move(why)});
    if (auto why = motion.follow()) return tl::make_unexpected(Errors{*std::move(why)});
    motion.construct(mechanism, pose);
    PointMotionSolution found = std::move(motion).solution();
    ProblemSolution solution;
    solution.subject = {lang::point_motion::motion_of_a_point_velocity_acceleration};
    solution.values = values_of(problem, found, check_point_motion(problem));
    if (auto why = why_no_numbers(solution.values, problem.where)) return tl::unexpected(*std::move(why));
    solution.remarks = remarks_on(problem, found);
    solution.of = std::move(found);
    return solution;
}

}  // namespace kinegraph
