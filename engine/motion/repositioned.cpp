#include "engine/motion/repositioned.hpp"

#include <cmath>
#include <utility>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

/// A file without its constructions: points by coordinates, bearings by vectors.
class Redrawing {
public:
    Redrawing(const Mechanism& mechanism, const Pose& pose, const Closure& closure,
              const std::vector<Carrier>& carriers, const std::vector<BodyPlaceOf<Exact>>& places)
        : drawn_(mechanism), pose_(pose), closure_(closure), carriers_(carriers), places_(places), moved_(mechanism) {}

    Mechanism run() && {
        for (std::size_t i = 0; i < moved_.points.size(); ++i)
            moved_.points[i].placement = Coordinates{place_of(PointIndex(i))};
        for (Joint& joint : moved_.joints) turn(joint);
        for (std::size_t i = 0; i < moved_.drivers.size(); ++i)
            if (auto* point = std::get_if<PointDriver>(&moved_.drivers[i])) point->along = {pose_.driver_directions[i]};
        return std::move(moved_);
    }

private:
    Vector place_on(BodyIndex body, PointIndex point) const {
        const BodyPlaceOf<Exact>& at = places_[at_index(body)];
        const Vector local = closure_.seen(pose_.at(point)) - closure_.bodies[at_index(body)].reference;
        const Vector place = closure_.unit * (at.at + faced(at.facing, local)) + closure_.origin;
        return body == frame ? place : on_grid(place);
    }
    /// Coarser than the error of the closure, so that vertical and horizontal directions are exact and numbers stay
    /// short.
    Vector on_grid(const Vector& place) const {
        const int grid = closure_.bits - 4 - std::ilogb(closure_.unit.to_double());
        return {rounded(place.x, grid), rounded(place.y, grid)};
    }
    Vector faced_by(BodyIndex body, const Vector& drawn) const { return faced(places_[at_index(body)].facing, drawn); }

    Vector place_of(PointIndex point) const {
        const Carrier& carrier = carriers_[at_index(point)];
        if (carrier.body != none) return place_on(carrier.body, point);
        const Joint& joint = drawn_.joint(carrier.contact);
        const auto sides = sides_of(drawn_, pose_, joint);
        KG_ASSERT(sides.has_value(), "a closure has the profiles of every contact");
        const auto centre = [&](std::size_t side) { return place_on(joint.bodies[side], (*sides)[side].centre); };
        for (std::size_t side = 0; side < 2; ++side) {
            if (!(*sides)[side].straight) continue;
            const Vector tangent = faced_by(joint.bodies[side], pose_.tangents[at_index(carrier.contact)]);
            const Vector normal = quarter_turn(unit_along(tangent, closure_.bits));
            return on_grid(centre(1 - side) - (*sides)[1 - side].reach * normal);
        }
        const Exact apart = (*sides)[0].reach - (*sides)[1].reach;
        return on_grid(((*sides)[0].reach / apart) * centre(1) - ((*sides)[1].reach / apart) * centre(0));
    }

    /// A bearing between two points stays as in the file if it is the guide's direction in every position.
    Bearing turned(const Bearing& bearing, const Vector& drawn, const Joint& joint, BodyIndex with) const {
        const Vector turned = faced_by(with, drawn);
        if (const auto* ends = std::get_if<Bearing::Between>(&bearing.form)) {
            const auto lies_on_it = [&](PointIndex point) {
                return carriers_[at_index(point)].body == with || point == joint.point;
            };
            const Vector now = coordinates(ends->to) - coordinates(ends->from);
            const double along = dot(now, turned).to_double(), size = length(now) * length(turned);
            constexpr double same = 1e-9;
            if (lies_on_it(ends->from) && lies_on_it(ends->to) && length(now) > same * pose_.size.to_double() &&
                std::abs(cross(now, turned).to_double()) < same * size)
                return {along > 0 ? *ends : Bearing::Between{ends->to, ends->from}};
        }
        return {turned};
    }
    const Vector& coordinates(PointIndex point) const {
        return std::get<Coordinates>(moved_.points[at_index(point)].placement).at;
    }

    void turn(Joint& joint) const {
        const std::size_t index = at_index(moved_.index_of(joint));
        if (joint.along) joint.along = turned(*joint.along, pose_.guides[index], joint, joint.bodies[1]);
        for (auto& [body, profile] : joint.profiles)
            if (auto* line = std::get_if<LineProfile>(&profile))
                line->along = turned(line->along, direction_of(line->along, pose_), joint, body);
        if (!joint.pushes) return;
        // Along the normal, in the sense in which it pushes as drawn.
        const Exact sense = dot(*joint.pushes, pose_.normals[index]).sign() < 0 ? -1 : 1;
        const auto sides = sides_of(drawn_, pose_, drawn_.joints[index]);
        if (!sides) return;
        for (std::size_t side = 0; side < 2; ++side) {
            if (!(*sides)[side].straight) continue;
            joint.pushes = sense * faced_by(joint.bodies[side], pose_.normals[index]);
            return;
        }
        const std::size_t side = (*sides)[0].centre != none ? 0 : 1;
        joint.pushes = sense * (coordinates((*sides)[side].centre) - coordinates(joint.point));
    }

    const Mechanism& drawn_;
    const Pose& pose_;
    const Closure& closure_;
    const std::vector<Carrier>& carriers_;
    const std::vector<BodyPlaceOf<Exact>>& places_;
    Mechanism moved_;
};

}  // namespace

Mover::Mover(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism) {
    auto closure = closure_of(mechanism, pose);
    KG_ASSERT(closure.has_value(), "positions have been found from this pose");
    drawn_ = {pose, *std::move(closure)};
    // A drawing that closes at 100 bits and not at 200 depends on a coincidence of its numbers; then nothing shrinks.
    finer_ = drawn_;
    if (auto finer = draw_pose(mechanism, 2 * pose.bits))
        if (auto closed = closure_of(mechanism, *finer)) finer_ = {*std::move(finer), *std::move(closed)};
    auto carriers = carriers_of(mechanism);
    KG_ASSERT(carriers.has_value(), "positions have been found from this pose");
    carriers_ = *std::move(carriers);
}

Mechanism Mover::mechanism_at(const Drawn& drawn, const std::vector<BodyPlaceOf<Exact>>& places) const {
    Mechanism moved = Redrawing(mechanism_, drawn.pose, drawn.closure, carriers_, places).run();
    moved.precision = drawn.pose.precision;  // its coordinates are long, but no more accurate than the file's
    return moved;
}

std::optional<Pose> Mover::pose_of(const Mechanism& moved, int bits) const {
    auto pose = draw_pose(moved, bits);
    if (!pose) return std::nullopt;
    pose->exact = false;
    for (std::size_t i = 0; i < pose->leftover.size(); ++i)
        if (carriers_[i].body != frame) pose->leftover[i] = pose->size * Exact::power_of_two(4 - bits);
    return *std::move(pose);
}

std::optional<Repositioned> Mover::moved(Positions& positions, const Exact& coordinate) const {
    const auto places = positions.refined(drawn_.closure, coordinate);
    const auto finer = places ? positions.refined(finer_.closure, coordinate) : std::nullopt;
    if (!finer) return std::nullopt;
    return moved(positions, *places, *finer);
}

std::optional<Repositioned> Mover::moved_across(const Positions& positions, const Exact& coordinate) const {
    const auto places = positions.refined_across(drawn_.closure, coordinate);
    const auto finer = places ? positions.refined_across(finer_.closure, coordinate) : std::nullopt;
    if (!finer) return std::nullopt;
    return moved(positions, *places, *finer);
}

std::optional<Repositioned> Mover::moved(const Positions& positions, const PlacesOf& places,
                                         const PlacesOf& finer) const {
    Repositioned result;
    result.mechanism = mechanism_at(drawn_, places);
    for (Load& load : result.mechanism.loads)
        if (auto* torsion = std::get_if<TorsionLoad>(&load))
            torsion->turned +=
                Exact::from_double(positions.turn(torsion->bodies[0]) - positions.turn(torsion->bodies[1]));
    auto pose = pose_of(result.mechanism, drawn_.pose.bits);
    auto finer_pose = pose ? pose_of(mechanism_at(finer_, finer), finer_.pose.bits) : std::nullopt;
    if (!finer_pose) return std::nullopt;
    result.pose = *std::move(pose);
    result.finer = *std::move(finer_pose);
    return result;
}

}  // namespace kinegraph
