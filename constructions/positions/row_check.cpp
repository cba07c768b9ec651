#include "constructions/positions/row_check.hpp"

#include <cmath>
#include <variant>

#include "constructions/positions/givens_here.hpp"
#include "engine/solution/sliding.hpp"

namespace kinegraph {
namespace {

Vector exact_vector(const VectorOf<double>& a) { return {Exact::from_double(a.x), Exact::from_double(a.y)}; }

}  // namespace

VectorOf<double> direction_of_sliding(const Places& places, JointIndex joint) {
    const std::size_t i = at_index(joint);
    return direction_of_sliding(places.guides[i], places.tangents[i], places.normals[i]);
}

void RowCheck::compare(const Row& row) {
    put_into_pose(row);
    const NumericMotion motion = check_motion(mechanism_, pose_);
    std::optional<NumericForces> forces;
    if (row.has_forces) forces = check_forces(mechanism_, pose_, motion);
    for (std::size_t i = 0; i < row.columns.size(); ++i) {
        const Column& column = row.columns[i];
        if (column.kind != Column::Kind::result && column.kind != Column::Kind::along) continue;
        const auto found = numeric(row, column, motion, forces ? &*forces : nullptr);
        const auto heard = [&](double value) { return std::abs(value) < row.noise[i] ? 0 : value; };
        if (found) off_.hold(i, column, heard(row.values[i]), heard(*found), row.positions.coordinate());
    }
}

void RowCheck::put_into_pose(const Row& row) {
    for (std::size_t i = 0; i < drawn_.loads.size(); ++i)
        if (const auto* torsion = std::get_if<TorsionLoad>(&drawn_.loads[i]))
            std::get<TorsionLoad>(mechanism_.loads[i]).turned =
                Exact::from_double(GivensHere::turned(*torsion, row.positions));
    const auto put = [](const std::vector<VectorOf<double>>& from, std::vector<Vector>& to) {
        for (std::size_t i = 0; i < from.size(); ++i)
            if (from[i].x != 0 || from[i].y != 0 || !to[i].is_zero()) to[i] = exact_vector(from[i]);
    };
    put(row.places.points, pose_.points);
    put(row.places.guides, pose_.guides);
    put(row.places.normals, pose_.normals);
    put(row.places.tangents, pose_.tangents);
    for (std::size_t i = 0; i < row.places.guides.size(); ++i)
        if (drawn_.joints[i].along) pose_.guide_units[i] = exact_vector(unit_vector(row.places.guides[i]));
}

std::optional<double> RowCheck::numeric(const Row& row, const Column& column, const NumericMotion& motion,
                                        const NumericForces* forces) const {
    const Quantity& q = column.quantity;
    const auto part = [&](const std::array<double, 2>& v) { return v[q.component == Quantity::Component::x ? 0 : 1]; };
    switch (q.kind) {
        case Quantity::Kind::omega:
        case Quantity::Kind::alpha: {
            const auto& state = motion.bodies[at_index(q.body)];
            if (!(q.kind == Quantity::Kind::omega ? state.velocity_known : state.acceleration_known))
                return std::nullopt;
            return q.kind == Quantity::Kind::omega ? state.omega : state.alpha;
        }
        case Quantity::Kind::velocity:
        case Quantity::Kind::acceleration: {
            const auto& state = motion.bodies[at_index(q.body)];
            const Vector& place = pose_.at(q.point);
            if (!(q.kind == Quantity::Kind::velocity ? state.velocity_known : state.acceleration_known))
                return std::nullopt;
            return part(q.kind == Quantity::Kind::velocity ? motion.velocity(q.body, place)
                                                           : motion.acceleration(q.body, place));
        }
        case Quantity::Kind::sliding_velocity:
        case Quantity::Kind::sliding_acceleration: return numeric_sliding(row, q, motion);
        case Quantity::Kind::force:
        case Quantity::Kind::couple:
            for (const NumericForces::Action& action : forces->actions)
                if (action.known && action.joint == q.joint && action.on == q.body && action.from == q.other)
                    return q.kind == Quantity::Kind::couple ? action.couple : part(action.force);
            return std::nullopt;
        default:
            if (!forces->effort_known[at_index(q.given)]) return std::nullopt;
            return forces->efforts[at_index(q.given)];
    }
}

std::optional<double> RowCheck::numeric_sliding(const Row& row, const Quantity& q, const NumericMotion& motion) const {
    const Joint& joint = drawn_.joint(q.joint);
    const BodyIndex i = joint.bodies[0], j = joint.bodies[1];
    const auto &slider = motion.bodies[at_index(i)], &guide = motion.bodies[at_index(j)];
    const Vector& place = pose_.at(joint.point);
    const VectorOf<double> along = direction_of_sliding(row.places, q.joint);
    const auto apart = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
        return VectorOf<double>{a[0] - b[0], a[1] - b[1]};
    };
    if (!slider.velocity_known || !guide.velocity_known) return std::nullopt;
    const VectorOf<double> velocity = apart(motion.velocity(i, place), motion.velocity(j, place));
    if (q.kind == Quantity::Kind::sliding_velocity) return dot(along, velocity);
    if (!slider.acceleration_known || !guide.acceleration_known) return std::nullopt;
    const VectorOf<double> coriolis = 2 * guide.omega * quarter_turn(velocity);
    return dot(along, apart(motion.acceleration(i, place), motion.acceleration(j, place)) - coriolis);
}

}  // namespace kinegraph
