#include "constructions/verdicts/verdicts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/mechanism/rounding.hpp"
#include "engine/solution/found_elements.hpp"

namespace kinegraph {
namespace {

std::size_t at(Plane plane) { return static_cast<std::size_t>(plane); }

/// An element as a vector: a finite point as its place, a point at infinity as its direction, a scalar as (x, 0).
Vector as_vector(const Value& value) {
    if (const auto* p = std::get_if<ProjectivePoint>(&value)) return p->at_infinity() ? Vector{p->x, p->y} : p->place();
    if (const auto* v = std::get_if<Vector>(&value)) return *v;
    return {std::get<Exact>(value), 0};
}

class Noise {
public:
    Noise(const Solution& solution, const FinerPose& finer)
        : protocol_(solution.protocol), mechanism_(solution.mechanism), pose_(solution.pose), draw_finer_(finer) {
        largest_.vector[at(Plane::drawing)] = magnitude_of(pose_.size);
        for (std::size_t i = 0; i < protocol_.values.size(); ++i)
            std::visit([&](const auto& made) { largest_.note(protocol_.program.strokes[i].plane, made); },
                       protocol_.values[i]);
    }

    bool vanishes(const DrawnVector& drawn) const {
        const auto value = [&](const std::vector<Value>& values) {
            return as_vector(values[at_index(drawn.tip)]) - as_vector(values[at_index(drawn.tail)]);
        };
        return is_noise(value, largest_.vector[at(plane_of(drawn.tip))]);
    }

    void clean(ElementIndex element, Exact& value) const {
        if (is_noise([&](const auto& values) { return as_vector(values[at_index(element)]); },
                     largest_.beside_scalar(plane_of(element))))
            value = 0;
    }
    void clean(ElementIndex element, Vector& value) const {
        const Magnitude<Exact>& unit = largest_.vector[at(plane_of(element))];
        clean_components(element, unit, value.x, value.y);
    }
    void clean(ElementIndex element, ProjectivePoint& point) const {
        clean_components(element,
                         point.at_infinity() ? magnitude_of(Vector{point.x, point.y})
                                             : magnitude_of(Vector{point.w, 0}) * largest_.vector[0],
                         point.x, point.y);
    }

private:
    Plane plane_of(ElementIndex element) const { return protocol_.program.strokes[at_index(element)].plane; }

    void clean_components(ElementIndex element, const Magnitude<Exact>& unit, Exact& x, Exact& y) const {
        if (is_noise([&](const auto& values) { return Vector{as_vector(values[at_index(element)]).x, 0}; }, unit))
            x = 0;
        if (is_noise([&](const auto& values) { return Vector{0, as_vector(values[at_index(element)]).y}; }, unit))
            y = 0;
    }

    template <class Read>
    bool is_noise(const Read& read, const Magnitude<Exact>& unit) const {
        const Vector value = read(protocol_.values);
        if (value.is_zero()) return false;
        const Magnitude<Exact> size = magnitude_of(value);
        if (!protocol_.shifted.empty() && size.is_below(unit, protocol_.program.doubtful_bits)) {
            std::vector<Vector> shifted;
            for (const std::vector<Value>& values : protocol_.shifted) shifted.push_back(read(values));
            if (is_zero_within(value, shifted)) return true;
        }
        if (pose_.exact || !size.is_below(unit, pose_.bits / 2)) return false;
        // As the board's predicates: a value that shrinks with a finer pose is zero, one that stays is not.
        return magnitude_of(read(finer())).order <= size.order - pose_.bits / 2;
    }
    const std::vector<Value>& finer() const {
        if (finer_.empty()) {
            const Pose pose = draw_finer_();
            finer_ = trimmed_values(protocol_.program, givens_of(protocol_.program, mechanism_, pose),
                                    digits_to_compare(pose.bits));
        }
        return finer_;
    }

    const Protocol& protocol_;
    const Mechanism& mechanism_;
    const Pose& pose_;
    const FinerPose& draw_finer_;
    mutable std::vector<Value> finer_;  // values on the finer pose, evaluated on first use
    Largest<Exact> largest_;
};

/// A value of the equations, and the scale to which it is compared.
struct Reading {
    double* value;
    double unit;
};

/// The values of equations in a fixed order, the same for one mechanism in any pose.
class Readings {
public:
    Readings(Equations& equations, double size) : e_(equations), size_(size) {
        fastest_ = quickest_ = 0;
        for (const Equations::Letter& letter : e_.letters) {
            fastest_ = std::max(fastest_, std::abs(letter.rate.value_or(0)) / of(letter));
            quickest_ = std::max(quickest_, std::abs(letter.acceleration.value_or(0)) / of(letter));
        }
        quickest_ = std::max(quickest_, fastest_ * fastest_);
    }

    std::vector<Reading> all() {
        for (Equations::Letter& letter : e_.letters) {
            if (letter.role == Equations::Letter::Role::given) continue;
            add(letter.value, of(letter));
            add(letter.rate, fastest_ * of(letter));
            add(letter.acceleration, quickest_ * of(letter));
        }
        add_ratios();
        add_matrix(e_.jacobian, e_.unknowns);
        add_matrix(e_.drive, e_.free);
        for (Equations::BodyState& body : e_.bodies) {
            add(body.omega, fastest_);
            add(body.alpha, quickest_);
            add_vector(body.velocity, fastest_ * size_);
            add_vector(body.acceleration, quickest_ * size_);
        }
        return std::move(found_);
    }

private:
    /// An angle is compared with a radian, a length with the drawing's size.
    double of(const Equations::Letter& letter) const { return letter.is_angle ? 1 : size_; }
    void add(double& value, double unit) { found_.push_back({&value, unit}); }
    void add(std::optional<double>& value, double unit) {
        if (value) add(*value, unit);
    }
    void add_vector(std::optional<std::array<double, 2>>& vector, double unit) {
        if (!vector) return;
        for (double& component : *vector) add(component, unit);
    }
    void add_ratios() {
        for (std::size_t j = 0; j < e_.ratios.size(); ++j)
            for (std::size_t k = 0; k < e_.ratios[j].size(); ++k)
                add(e_.ratios[j][k], of(e_.letter(e_.unknowns[j])) / of(e_.letter(e_.free[k])));
        for (std::size_t j = 0; j < e_.second_ratios.size(); ++j)
            for (std::size_t k = 0; k < e_.second_ratios[j].size(); ++k)
                for (std::size_t l = 0; l < e_.second_ratios[j][k].size(); ++l)
                    add(e_.second_ratios[j][k][l],
                        of(e_.letter(e_.unknowns[j])) / (of(e_.letter(e_.free[k])) * of(e_.letter(e_.free[l]))));
    }
    /// Each entry is compared with the largest of its row, in the unit of its column.
    void add_matrix(std::vector<std::vector<double>>& rows, const std::vector<Equations::LetterIndex>& columns) {
        for (std::vector<double>& row : rows) {
            double largest = 0;
            for (std::size_t j = 0; j < row.size(); ++j)
                largest = std::max(largest, std::abs(row[j]) * of(e_.letter(columns[j])));
            for (std::size_t j = 0; j < row.size(); ++j) add(row[j], largest / of(e_.letter(columns[j])));
        }
    }

    Equations& e_;
    double size_, fastest_, quickest_;
    std::vector<Reading> found_;
};

/// The values of the same equations in another pose; empty if that pose has other equations.
std::vector<double> values_elsewhere(const Mechanism& mechanism, const Pose& pose, std::size_t count) {
    Equations there = equations_of(mechanism, pose);
    std::vector<double> values;
    for (const Reading& each : Readings(there, pose.size.to_double()).all()) values.push_back(*each.value);
    if (values.size() != count) values.clear();
    return values;
}

}  // namespace

void forget_noise(Solution& solution, const FinerPose& finer) {
    if (solution.protocol.shifted.empty() && solution.pose.exact) return;
    const Noise noise(solution, finer);
    for_each_found(solution, [&](const ElementIndex& element, auto& value) { noise.clean(element, value); });
    for (DrawnVector& drawn : solution.protocol.vectors) drawn.vanishes = noise.vanishes(drawn);
}

void forget_noise(Equations& equations, const Solution& solution, const FinerPose& finer) {
    const Pose& pose = solution.pose;
    std::vector<Reading> readings = Readings(equations, pose.size.to_double()).all();
    const auto forget = [&](int bits, const auto& is_noise) {
        const auto is_doubtful = [&](const Reading& each) {
            return *each.value != 0 && std::abs(*each.value) <= std::ldexp(each.unit, -bits);
        };
        if (std::none_of(readings.begin(), readings.end(), is_doubtful)) return;
        const auto noise = is_noise();
        for (std::size_t i = 0; i < readings.size(); ++i)
            if (is_doubtful(readings[i]) && noise(i)) *readings[i].value = 0;
    };
    if (pose.is_rounded()) {
        forget(solution.protocol.program.doubtful_bits, [&] {
            std::vector<std::vector<double>> shifted;
            for (const ShiftedDrawing& each : *pose.shifted)
                shifted.push_back(values_elsewhere(each.mechanism, each.pose, readings.size()));
            return [&readings, shifted = std::move(shifted)](std::size_t i) {
                double spread = 0;
                for (const std::vector<double>& values : shifted)
                    if (!values.empty()) spread = std::max(spread, std::abs(values[i] - *readings[i].value));
                return is_zero_within(std::abs(*readings[i].value), spread);
            };
        });
    }
    if (pose.exact) return;
    forget(pose.bits / 2, [&] {
        return [&readings, bits = pose.bits / 2,
                values = values_elsewhere(solution.mechanism, finer(), readings.size())](std::size_t i) {
            return !values.empty() && std::abs(values[i]) <= std::ldexp(std::abs(*readings[i].value), -bits);
        };
    });
}

}  // namespace kinegraph
