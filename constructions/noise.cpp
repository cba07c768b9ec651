#include "constructions/noise.hpp"

#include "engine/rounding.hpp"

namespace kinegraph {
namespace {

std::size_t at(Plane plane) { return static_cast<std::size_t>(plane); }

/// An element as a vector: of a finite point its place, of a point at infinity its direction, of a scalar its value in x.
Vector as_vector(const Value& value) {
    if (const auto* p = std::get_if<ProjectivePoint>(&value)) return p->at_infinity() ? Vector{p->x, p->y} : p->place();
    if (const auto* v = std::get_if<Vector>(&value)) return *v;
    return {std::get<Exact>(value), 0};
}

class Noise {
public:
    Noise(const Protocol& protocol, const Pose& pose) : protocol_(protocol) {
        largest_.vector[at(Plane::drawing)] = magnitude_of(pose.size);
        for (std::size_t i = 0; i < protocol.values.size(); ++i)
            std::visit([&](const auto& made) { largest_.note(protocol.program.strokes[i].plane, made); }, protocol.values[i]);
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
        clean_components(
            element,
            point.at_infinity() ? magnitude_of(Vector{point.x, point.y}) : magnitude_of(Vector{point.w, 0}) * largest_.vector[0],
            point.x, point.y);
    }

private:
    Plane plane_of(ElementIndex element) const { return protocol_.program.strokes[at_index(element)].plane; }

    void clean_components(ElementIndex element, const Magnitude<Exact>& unit, Exact& x, Exact& y) const {
        if (is_noise([&](const auto& values) { return Vector{as_vector(values[at_index(element)]).x, 0}; }, unit)) x = 0;
        if (is_noise([&](const auto& values) { return Vector{0, as_vector(values[at_index(element)]).y}; }, unit)) y = 0;
    }

    template <class Read>
    bool is_noise(const Read& read, const Magnitude<Exact>& unit) const {
        const Vector value = read(protocol_.values);
        if (value.is_zero()) return false;
        if (!magnitude_of(value).is_below(unit, protocol_.program.doubtful_bits)) return false;
        std::vector<Vector> shifted;
        for (const std::vector<Value>& values : protocol_.shifted) shifted.push_back(read(values));
        return is_zero_within(value, shifted);
    }

    const Protocol& protocol_;
    Largest<Exact> largest_;
};

}  // namespace

void forget_noise(Solution& solution) {
    if (solution.protocol.shifted.empty()) return;
    const Noise noise(solution.protocol, solution.pose);
    for_each_found(solution, [&](const ElementIndex& element, auto& value) { noise.clean(element, value); });
    for (DrawnVector& drawn : solution.protocol.vectors) drawn.vanishes = noise.vanishes(drawn);
}

}  // namespace kinegraph
