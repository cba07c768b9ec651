#include "constructions/positions/givens_here.hpp"

#include <cmath>
#include <variant>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

bool is_between(const Bearing& bearing) { return std::holds_alternative<Bearing::Between>(bearing.form); }

Spot direction(const Places& places, PointIndex from, PointIndex to) {
    const Spot way = places.points[at_index(to)] - places.points[at_index(from)];
    return (1 / nearest::hypot(way.x, way.y)) * way;
}
Spot direction(const Places& places, const Bearing& bearing) {
    const auto& ends = std::get<Bearing::Between>(bearing.form);
    return direction(places, ends.from, ends.to);
}

}  // namespace

GivensHere::GivensHere(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism) {
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const auto& pushes = mechanism.joints[k].pushes;
        senses_.push_back(pushes && dot(*pushes, pose.normals[k]).sign() < 0 ? -1 : 1);
    }
}

bool GivensHere::hangs(const Given& given) const {
    switch (given.kind) {
        case Given::Kind::place:
        case Given::Kind::guide:
        case Given::Kind::guide_unit:
        case Given::Kind::normal:
        case Given::Kind::other_normal:
        case Given::Kind::tangent:
        case Given::Kind::push: return true;
        case Given::Kind::load_unit:
        case Given::Kind::load_unit_back: {
            const Load& load = mechanism_.loads[at_index(given.index)];
            if (const auto* distributed = std::get_if<DistributedLoad>(&load)) return is_between(distributed->along);
            const auto* force = std::get_if<ForceLoad>(&load);
            return force == nullptr || is_between(force->magnitude->second);
        }
        case Given::Kind::load_magnitude: {
            const Load& load = mechanism_.loads[at_index(given.index)];
            const auto* spring = std::get_if<SpringLoad>(&load);
            return std::holds_alternative<TorsionLoad>(load) || (spring != nullptr && spring->elastic);
        }
        case Given::Kind::effort_unit:
            return is_between(std::get<ForceEffort>(mechanism_.efforts[at_index(given.index)]).along);
        default: return false;
    }
}

double GivensHere::turned(const TorsionLoad& torsion, const Positions& positions) {
    return torsion.turned.to_double() + positions.turn(torsion.bodies[0]) - positions.turn(torsion.bodies[1]);
}

ValueOf<double> GivensHere::value(const Given& given, const Places& places, const Positions& positions) const {
    const std::size_t i = at_index(given.index);
    switch (given.kind) {
        case Given::Kind::place: return PointOf<double>{places.points[i].x, places.points[i].y, 1};
        case Given::Kind::guide: return places.guides[i];
        case Given::Kind::guide_unit: return unit_vector(places.guides[i]);
        case Given::Kind::normal: return places.normals[i];
        case Given::Kind::tangent: return places.tangents[i];
        case Given::Kind::push: return senses_[i] * places.normals[i];
        case Given::Kind::other_normal: {
            const Spot &n = places.normals[i], &t = places.tangents[i];
            return (2 * dot(n, t) / squared_length(t)) * t - n;
        }
        case Given::Kind::effort_unit: return direction(places, std::get<ForceEffort>(mechanism_.efforts[i]).along);
        default: return value_of_load(given, places, positions);
    }
}

ValueOf<double> GivensHere::value_of_load(const Given& given, const Places& places, const Positions& positions) const {
    const Load& load = mechanism_.loads[at_index(given.index)];
    if (const auto* force = std::get_if<ForceLoad>(&load)) return direction(places, force->magnitude->second);
    if (const auto* distributed = std::get_if<DistributedLoad>(&load)) return direction(places, distributed->along);
    if (const auto* torsion = std::get_if<TorsionLoad>(&load))
        return -torsion->stiffness.to_double() * turned(*torsion, positions);
    const auto& ends = std::get<SpringLoad>(load).between;
    if (given.kind == Given::Kind::load_magnitude) {
        const SpringLoad::Elastic& elastic = *std::get<SpringLoad>(load).elastic;
        const Spot apart = places.points[at_index(ends[1])] - places.points[at_index(ends[0])];
        return elastic.stiffness.to_double() * (nearest::hypot(apart.x, apart.y) - elastic.free_length.to_double());
    }
    return given.kind == Given::Kind::load_unit ? direction(places, ends[0], ends[1])
                                                : direction(places, ends[1], ends[0]);
}

}  // namespace kinegraph
