#include "engine/solution/displacements.hpp"

#include "engine/solution/solution.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace kinegraph {
namespace {

using Pair = std::array<double, 2>;

const Equations::BodyState* state_of(const Equations& equations, BodyIndex body) {
    if (!equations.why_not.empty() || at_index(body) >= equations.bodies.size()) return nullptr;
    return &equations.bodies[at_index(body)];
}
std::optional<Pair> velocity_of(const Equations& equations, BodyIndex body, const Vector& place) {
    if (body == frame) return Pair{0, 0};
    const auto* state = state_of(equations, body);
    return state == nullptr ? std::nullopt : state->velocity_of(place);
}
std::optional<double> omega_of(const Equations& equations, BodyIndex body) {
    if (body == frame) return 0;
    const auto* state = state_of(equations, body);
    return state == nullptr ? std::nullopt : state->omega;
}
double dot(const Vector& a, const Pair& b) { return a.x.to_double() * b[0] + a.y.to_double() * b[1]; }

}  // namespace

std::vector<EffortValue> efforts_found(const Solution& solution) {
    std::vector<EffortValue> efforts = solution.efforts;
    if (!solution.displacements) return efforts;
    if (efforts.empty())
        for (const Effort& each : solution.mechanism.efforts)
            efforts.push_back({std::visit([](const auto& effort) { return effort.name; }, each), std::nullopt});
    for (std::size_t e = 0; e < efforts.size(); ++e)
        if (!efforts[e].value) efforts[e].value = solution.displacements->found(e);
    return efforts;
}

namespace {

/// Gauss–Jordan elimination: each effort is eliminated with the equation in which it does the most work.
class Elimination {
public:
    Elimination(std::vector<std::vector<Exact>> rows, std::size_t count)
        : rows_(std::move(rows)), count_(count), pivot_of_(count, rows_.size()), used_(rows_.size()) {
        for (const auto& row : rows_) {
            double largest = 0;
            for (std::size_t j = 0; j < count; ++j) largest = std::max(largest, std::abs(row[j].to_double()));
            largest_.push_back(largest);
        }
        for (std::size_t j = 0; j < count_; ++j) take(j);
    }
    bool is_used(std::size_t row) const { return used_[row]; }
    const Exact& rest(std::size_t row) const { return rows_[row][count_]; }
    /// None where it is in no equation, or always together with another one.
    std::optional<Exact> value(std::size_t j) const {
        if (pivot_of_[j] == rows_.size()) return std::nullopt;
        const std::vector<Exact>& row = rows_[pivot_of_[j]];
        for (std::size_t k = 0; k < count_; ++k)
            if (k != j && std::abs(row[k].to_double()) > noise * largest_[pivot_of_[j]]) return std::nullopt;
        return row[count_] / row[j];
    }

    static constexpr double noise = 1e-12;  ///< below this share a work is the rounding error of zero

private:
    void take(std::size_t j) {
        std::size_t best = rows_.size();
        double size = 0;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (const double own = std::abs(rows_[i][j].to_double());
                !used_[i] && own > noise * largest_[i] && (best == rows_.size() || own > size))
                best = i, size = own;
        if (best == rows_.size()) return;
        used_[best] = true;
        pivot_of_[j] = best;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (i == best || rows_[i][j].is_zero()) continue;
            const Exact share = rows_[i][j] / rows_[best][j];
            for (std::size_t k = 0; k <= count_; ++k) rows_[i][k] -= share * rows_[best][k];
            rows_[i][j] = 0;
        }
    }

    std::vector<std::vector<Exact>> rows_;
    std::size_t count_;
    std::vector<std::size_t> pivot_of_;  ///< by effort; past the end: none
    std::vector<bool> used_;
    std::vector<double> largest_;
};

}  // namespace

WorkEquations::Found WorkEquations::solved(std::size_t count) && {
    const Elimination elimination(std::move(rows), count);
    Found found;
    for (std::size_t j = 0; j < count; ++j) found.efforts.push_back(elimination.value(j));
    for (std::size_t i = 0; i < largest.size(); ++i)
        if (!elimination.is_used(i) && std::abs(elimination.rest(i).to_double()) > Elimination::noise * largest[i])
            found.balanced = false;
    return found;
}

bool is_turn(const Driver& driver) { return std::holds_alternative<SpinDriver>(driver); }

std::string coordinate_name(const Mechanism& mechanism, const Driver& driver) {
    if (const auto* spin = std::get_if<SpinDriver>(&driver))
        return "theta " + mechanism.body(spin->body).name +
               (spin->relative_to == frame ? "" : " on " + mechanism.body(spin->relative_to).name);
    if (const auto* slide = std::get_if<SlideDriver>(&driver)) return "s " + mechanism.joint(slide->joint).name;
    return "s " + mechanism.point(std::get<PointDriver>(driver).at).name;
}

std::optional<double> work_by_ratios(const Equations& equations, const VirtualWork::Entry& entry) {
    double work = 0;
    if (!entry.force.is_zero()) {
        const auto moved = velocity_of(equations, entry.body, entry.at);
        if (!moved) return std::nullopt;
        work += dot(entry.force, *moved);
    }
    if (!entry.couple.is_zero()) {
        const auto turned = omega_of(equations, entry.body);
        if (!turned) return std::nullopt;
        work += entry.couple.to_double() * *turned;
    }
    return work;
}

std::optional<double> work_by_ratios(const Equations& equations, const Mechanism& mechanism, const Pose& pose,
                                     int effort) {
    const Effort& given = mechanism.efforts[at_index(effort)];
    if (const auto* couple = std::get_if<CoupleEffort>(&given)) {
        const auto on = omega_of(equations, couple->body), from = omega_of(equations, couple->from);
        if (!on || !from) return std::nullopt;
        return *on - *from;
    }
    if (const auto* force = std::get_if<ForceEffort>(&given)) {
        const auto moved = velocity_of(equations, force->body, pose.at(force->at));
        if (!moved) return std::nullopt;
        return dot(unit_along(direction_of(force->along, pose), pose.bits), *moved);
    }
    const JointIndex index = std::get<ActuatorEffort>(given).joint;
    const Joint& joint = mechanism.joint(index);
    const auto on = velocity_of(equations, joint.bodies[0], pose.at(joint.point)),
               from = velocity_of(equations, joint.bodies[1], pose.at(joint.point));
    if (!on || !from) return std::nullopt;
    return dot(pose.guide_units[at_index(index)], Pair{(*on)[0] - (*from)[0], (*on)[1] - (*from)[1]});
}

}  // namespace kinegraph
