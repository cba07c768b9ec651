#include "engine/check/equilibrium_equations.hpp"

#include <algorithm>
#include <variant>

namespace kinegraph::numeric {
namespace {

using Eigen::Index;

int reactions_of(const Joint& joint) {
    const int of_each = joint.has_own_node() ? static_cast<int>(joint.bodies.size()) : 1;  // a pin in between is in
                                                                                           // contact with each body
    switch (joint.kind) {
        case JointKind::revolute:
        case JointKind::rolling: return 2 * of_each;
        case JointKind::weld: return 3 * of_each;
        case JointKind::prismatic: return 2;
        case JointKind::pin_slot:
        case JointKind::contact:
        case JointKind::gear: return 1;
    }
    return 0;
}

}  // namespace

EquilibriumEquations::EquilibriumEquations(const Mechanism& mechanism, const Pose& pose, const GivenLoads& given)
    : mechanism_(mechanism), pose_(pose), size_(pose.size.to_double()) {
    measure_bodies(given);
    lay_out();
    write_right_side(given);
}

// --- bodies
// -------------------------------------------------------------------------------------------------------------------

/// Chooses each body's reference amid the places where forces act, and its own size, so that moments are scaled by the
/// body's own arms.
void EquilibriumEquations::measure_bodies(const GivenLoads& given) {
    std::vector<std::vector<const Vector*>> places(mechanism_.bodies.size());
    for (const Joint& joint : mechanism_.joints) {
        for (const BodyIndex body : joint.bodies) places[at_index(body)].push_back(&pose_.at(joint.point));
    }
    for (const GivenLoads::Given& each : given.all()) {
        if (each.force != Pair{}) places[at_index(each.body)].push_back(&each.place);
    }
    for (const Effort& effort : mechanism_.efforts) {
        if (const auto* force = std::get_if<ForceEffort>(&effort))
            places[at_index(force->body)].push_back(&pose_.at(force->at));
    }
    references_.resize(places.size());
    own_size_.resize(places.size(), size_);
    for (std::size_t b = 1; b < places.size(); ++b) {
        if (places[b].empty()) continue;
        Pair mean{};
        for (const Vector* place : places[b]) mean = mean + 1 / static_cast<double>(places[b].size()) * rough(*place);
        references_[b] = {Exact::from_double(mean[0]), Exact::from_double(mean[1])};
        double reach = 0, apart = 0;
        for (const Vector* place : places[b]) {
            reach = std::max(reach, length(*place - references_[b]));
            apart = std::max(apart, length(*place - *places[b].front()));
        }
        constexpr double a_point = 1e-12;  // all places coincide; the rest is rounding
        // Far from the origin the rounding of the mean would be taken for the size of such a body.
        if (apart <= a_point * size_ && reach > a_point * size_) {
            references_[b] = *places[b].front();
            reach = apart;
        }
        if (reach > a_point * size_) own_size_[b] = reach;
    }
    // An entry has the rounding error of its points relative to the body's own size; a pivot that of several entries.
    constexpr double entries = 16;
    doubt_ = entries * pose_.rounding() * size_ / *std::min_element(own_size_.begin(), own_size_.end());
}

// --- layout
// -------------------------------------------------------------------------------------------------------------------

void EquilibriumEquations::lay_out() {
    rows_ = 3 * (static_cast<Index>(mechanism_.bodies.size()) - 1);
    for (const Joint& joint : mechanism_.joints) {
        first_column_.push_back(columns_);
        first_pin_row_.push_back(rows_);
        columns_ += reactions_of(joint);
        if (joint.has_own_node()) rows_ += joint.kind == JointKind::weld ? 3 : 2;
    }
    first_effort_ = columns_;
    columns_ += static_cast<Index>(mechanism_.efforts.size());
}

std::vector<Pair> EquilibriumEquations::directions(JointIndex index, bool clockwise) const {
    const std::size_t at = at_index(index);
    switch (mechanism_.joint(index).kind) {
        case JointKind::revolute:
        case JointKind::rolling:
        case JointKind::weld: return {{1, 0}, {0, 1}};
        case JointKind::prismatic: return {quarter(unit_along(pose_.guides[at], pose_))};
        case JointKind::pin_slot:
        case JointKind::contact: return {unit_along(pose_.normals[at], pose_)};
        case JointKind::gear: {
            const Pair action = unit_along(pose_.normals[at], pose_);
            if (!clockwise) return {action};
            const Pair t = unit_along(pose_.tangents[at], pose_);
            return {2 * inner(t, action) * t + -1 * action};
        }
    }
    return {};
}

bool EquilibriumEquations::carries_couple(const Joint& joint) {
    return joint.kind == JointKind::prismatic || joint.kind == JointKind::weld;
}

// --- coefficients
// -------------------------------------------------------------------------------------------------------------

double EquilibriumEquations::moment(BodyIndex body, const Vector& place, const Pair& force) const {
    return outer(rough(place - references_[at_index(body)]), force) / own_size_[at_index(body)];
}

void EquilibriumEquations::add_force(Eigen::MatrixXd& matrix, Index column, BodyIndex body, const Vector& place,
                                     const Pair& direction) const {
    if (body == frame) return;
    const Index row = row_of(body);
    matrix(row, column) += direction[0];
    matrix(row + 1, column) += direction[1];
    matrix(row + 2, column) += moment(body, place, direction);
}

void EquilibriumEquations::add_couple(Eigen::MatrixXd& matrix, Index column, BodyIndex body, double sign) const {
    if (body != frame) matrix(row_of(body) + 2, column) += sign * size_ / own_size_[at_index(body)];
}

void EquilibriumEquations::write(Eigen::MatrixXd& matrix, JointIndex index, bool clockwise) const {
    const Joint& joint = mechanism_.joint(index);
    const Vector& place = pose_.at(joint.point);
    const auto along = directions(index, clockwise);
    Index column = first_column(index);
    if (!joint.has_own_node()) {
        for (const Pair& direction : along) {
            add_force(matrix, column, joint.bodies[0], place, direction);
            add_force(matrix, column++, joint.bodies[1], place, -1 * direction);
        }
        if (!carries_couple(joint)) return;
        add_couple(matrix, column, joint.bodies[0], 1);
        add_couple(matrix, column, joint.bodies[1], -1);
        return;
    }
    for (const BodyIndex body : joint.bodies) {
        Index pin_row = first_pin_row_[at_index(index)];
        for (const Pair& direction : along) {
            matrix(pin_row++, column) = -1;
            add_force(matrix, column++, body, place, direction);
        }
        if (!carries_couple(joint)) continue;
        matrix(pin_row, column) = -1;
        add_couple(matrix, column++, body, 1);
    }
}

void EquilibriumEquations::write(Eigen::MatrixXd& matrix, Index column, const CoupleEffort& effort) const {
    add_couple(matrix, column, effort.body, 1);
    add_couple(matrix, column, effort.from, -1);
}

void EquilibriumEquations::write(Eigen::MatrixXd& matrix, Index column, const ForceEffort& effort) const {
    add_force(matrix, column, effort.body, pose_.at(effort.at), unit_along(direction_of(effort.along, pose_), pose_));
}

void EquilibriumEquations::write(Eigen::MatrixXd& matrix, Index column, const ActuatorEffort& effort) const {
    const Joint& joint = mechanism_.joint(effort.joint);
    const Pair along = rough(pose_.guide_units[at_index(effort.joint)]);
    add_force(matrix, column, joint.bodies[0], pose_.at(joint.point), along);
    add_force(matrix, column, joint.bodies[1], pose_.at(joint.point), -1 * along);
}

Eigen::MatrixXd EquilibriumEquations::matrix(const std::vector<bool>& clockwise) const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows_, columns_);
    for (const JointIndex joint : indices_of(mechanism_.joints)) write(matrix, joint, clockwise[at_index(joint)]);
    for (std::size_t i = 0; i < mechanism_.efforts.size(); ++i)
        std::visit([&](const auto& form) { write(matrix, column_of_effort(i), form); }, mechanism_.efforts[i]);
    return matrix;
}

void EquilibriumEquations::write_right_side(const GivenLoads& given) {
    right_ = Eigen::VectorXd::Zero(rows_);
    const double unit = given.unit();
    for (const GivenLoads::Given& each : given.all()) {
        if (each.pin != none) {
            const Index row = first_pin_row_[at_index(each.pin)];
            right_[row] -= each.force[0] / unit;
            right_[row + 1] -= each.force[1] / unit;
        }
        if (each.body == frame) continue;
        const Index row = row_of(each.body);
        right_[row] -= each.force[0] / unit;
        right_[row + 1] -= each.force[1] / unit;
        right_[row + 2] -= each.couple / own_size_[at_index(each.body)] / unit;
        if (each.force != Pair{}) right_[row + 2] -= moment(each.body, each.place, 1 / unit * each.force);
    }
}

}  // namespace kinegraph::numeric
