#include "constructions/positions/row_check.hpp"

#include <cmath>
#include <variant>

#include "constructions/positions/givens_here.hpp"
#include "engine/check/numeric_result.hpp"
#include "engine/sentences/result_catalogue.hpp"
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
        if (row.empty[i] || (column.kind != Column::Kind::result && column.kind != Column::Kind::along)) continue;
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

std::optional<std::array<double, 2>> RowCheck::numeric_on_request(const Quantity& q,
                                                                  const NumericMotion& motion) const {
    if (q.kind == Quantity::Kind::centre) return numeric_centre(motion, q);
    if (!result_kind(q).is_of_curvature()) return std::nullopt;
    if (q.kind == Quantity::Kind::radius) return numeric_curvature(motion, q, pose_.at(q.point));
    const auto pole = numeric_centre(motion, {.kind = Quantity::Kind::centre, .body = frame, .other = q.body});
    if (!pole) return std::nullopt;
    return numeric_curvature(motion, q, exact_vector({(*pole)[0], (*pole)[1]}));
}

std::optional<double> RowCheck::numeric(const Row& row, const Column& column, const NumericMotion& motion,
                                        const NumericForces* forces) const {
    const Quantity& q = column.quantity;
    const ResultKind& kind = result_kind(q);
    const auto part = [&](const std::array<double, 2>& v) { return v[q.component == Quantity::Component::y ? 1 : 0]; };
    if (kind.on_request) {
        const auto found = numeric_on_request(q, motion);
        if (!found) return std::nullopt;
        const VectorOf<double>& origin = row.places.origin;
        const bool is_place = kind.shape == ResultKind::Shape::place;
        return part(*found) + (is_place ? part({origin.x, origin.y}) : 0);
    }
    if (kind.subject == ResultKind::Subject::effort) {
        if (!forces->effort_known[at_index(q.given)]) return std::nullopt;
        return forces->efforts[at_index(q.given)];
    }
    if (kind.subject == ResultKind::Subject::action) {
        for (const NumericForces::Action& action : forces->actions)
            if (action.known && action.joint == q.joint && action.on == q.body && action.from == q.other)
                return kind.unit == QuantityKind::moment ? action.couple : part(action.force);
        return std::nullopt;
    }
    const auto found = numeric_result(motion, mechanism_, pose_, q);
    if (!found) return std::nullopt;
    if (kind.shape != ResultKind::Shape::along) return part(*found);
    return dot(direction_of_sliding(row.places, q.joint), VectorOf<double>{(*found)[0], (*found)[1]});
}

}  // namespace kinegraph
