// The check of the forces: solves the equations of equilibrium (engine/check/equilibrium_equations.hpp). Owns the
// selection of bodies where not every body can be in equilibrium, and the choice of a gear's line of action.
#include "engine/check/check_forces.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/check/determined_system.hpp"
#include "engine/check/equilibrium_equations.hpp"
#include "engine/check/given_loads.hpp"
#include "engine/check/plane_pair.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph::numeric {
namespace {

using Eigen::Index;

class Equilibrium {
public:
    Equilibrium(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion)
        : mechanism_(mechanism), pose_(pose), given_(mechanism, pose, motion), equations_(mechanism, pose, given_) {}

    NumericForces run() {
        std::vector<bool> clockwise(mechanism_.joints.size(), false);
        Solved solved = solve(clockwise);
        // The other line changes only the radial component. With wheels on their axles the choice does not depend on
        // that, so one round suffices. Wheels without a fixed axle may need a few more.
        for (std::size_t round = 0; round <= mechanism_.joints.size() && turn_gears(solved, clockwise); ++round)
            solved = solve(clockwise);
        return report(solved, clockwise);
    }

private:
    struct Solved {
        Eigen::VectorXd values;
        std::vector<bool> known;  ///< by unknown
        /// By unknown, for it and the next: the direction in their plane along which the component is the same in every
        /// equilibrium.
        std::vector<std::optional<Pair>> common;
        int indeterminacy = 0;
        bool balanced = true;
        double residual = 0;
    };

    // --- solving
    // ---------------------------------------------------------------------------------------------------------------
    Solved solve(const std::vector<bool>& clockwise) const {
        const Eigen::MatrixXd matrix = equations_.matrix(clockwise);
        // A body of unknown acceleration has no usable inertia equations.
        std::vector<bool> used(static_cast<std::size_t>(equations_.rows()), true);
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (given_.lacks_inertia(body)) leave_out(EquilibriumEquations::row_of(body), used);
        }
        Solved solved;
        const DeterminedSystem all(matrix, equations_.doubt());
        solved.indeterminacy = static_cast<int>(equations_.columns() - all.rank());
        const bool every = std::find(used.begin(), used.end(), false) == used.end();
        if (!every) return solve_part(matrix, used, solved);

        solved.values = all.solve(equations_.right_side());
        const Eigen::VectorXd miss = all.residual(equations_.right_side(), solved.values);
        if (note_balance(miss, solved)) {
            solved.known = all.determined();
            solved.common = common_directions(all);
            return solved;
        }
        leave_out_unbalanced(miss, solved.values, used);
        return solve_part(matrix, used, solved);
    }
    /// Some bodies are left out; solves for the others. The equations with zero residual in the least-squares solution
    /// are satisfied without the rest, so one pass finds the part that is in equilibrium by itself.
    Solved solve_part(const Eigen::MatrixXd& matrix, std::vector<bool>& used, Solved solved) const {
        for (;;) {
            const auto count = static_cast<Index>(std::count(used.begin(), used.end(), true));
            Eigen::MatrixXd part(count, equations_.columns());
            Eigen::VectorXd right(count);
            std::vector<Index> row_in_all;
            for (Index i = 0; i < equations_.rows(); ++i) {
                if (!used[static_cast<std::size_t>(i)]) continue;
                const auto row = static_cast<Index>(row_in_all.size());
                if (equations_.columns() > 0)
                    part.row(row) = matrix.row(i);  // Eigen addresses the row even where it has no element
                right[row] = equations_.right_side()[i];
                row_in_all.push_back(i);
            }
            const DeterminedSystem some(part, equations_.doubt());
            solved.values = some.solve(right);
            Eigen::VectorXd miss = Eigen::VectorXd::Zero(equations_.rows());
            const Eigen::VectorXd part_miss = some.residual(right, solved.values);
            for (std::size_t i = 0; i < row_in_all.size(); ++i) miss[row_in_all[i]] = part_miss[static_cast<Index>(i)];
            if (note_balance(miss, solved)) {
                solved.known = some.determined();
                solved.common = common_directions(some);
                return solved;
            }
            leave_out_unbalanced(miss, solved.values, used);
        }
    }
    /// By unknown; stored at the first component of a force with two.
    std::vector<std::optional<Pair>> common_directions(const DeterminedSystem& system) const {
        std::vector<std::optional<Pair>> common(static_cast<std::size_t>(equations_.columns()));
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            const auto width = static_cast<Index>(equations_.directions(index, false).size());
            if (width != 2) continue;
            const Index ends = joint.has_own_node() ? static_cast<Index>(joint.bodies.size()) : 1;
            const Index step = width + (EquilibriumEquations::carries_couple(joint) ? 1 : 0);
            for (Index end = 0; end < ends; ++end) {
                const Index column = equations_.first_column(index) + end * step;
                common[static_cast<std::size_t>(column)] = system.common_direction(column);
            }
        }
        return common;
    }
    double nothing() const { return DeterminedSystem::nothing(equations_.doubt()); }
    double tolerance(const Eigen::VectorXd& values) const {
        return nothing() * std::max(largest(equations_.right_side()), largest(values));
    }
    /// True where no residual remains. The first imbalance found is the one reported.
    bool note_balance(const Eigen::VectorXd& miss, Solved& solved) const {
        const double left = largest(miss);
        const bool holds = left <= tolerance(solved.values);
        if (solved.balanced) solved.residual = left / std::max(1.0, largest(equations_.right_side()));
        solved.balanced = solved.balanced && holds;
        return holds;
    }
    static void leave_out(Index first, std::vector<bool>& used) {
        for (Index k = 0; k < 3; ++k) used[static_cast<std::size_t>(first + k)] = false;
    }
    /// Leaves out whole bodies: if one equation of a body fails, the body is not at rest and its other equations are
    /// invalid too.
    void leave_out_unbalanced(const Eigen::VectorXd& miss, const Eigen::VectorXd& values,
                              std::vector<bool>& used) const {
        const double tolerated = tolerance(values);
        for (Index i = 0; i < equations_.rows(); ++i) {
            if (std::abs(miss[i]) <= tolerated) continue;
            if (equations_.is_of_body(i)) {
                leave_out(i - i % 3, used);
            } else {
                used[static_cast<std::size_t>(i)] = false;
            }
        }
    }

    // --- gears
    // -----------------------------------------------------------------------------------------------------------------
    /// Teeth only push, so the radial component of a gear's force separates the wheels: on bodies[0] it points into its
    /// own material. With n the normal of the pitch curves and 1/x their curvatures (x the centre's coordinate along n;
    /// 0 for a rack) the material of bodies[0] lies on the side sign(1/x_0 − 1/x_1) of n: two external wheels curve
    /// apart, and a wheel inside a ring is curved more than the ring. Of the two lines of action, chooses the one on
    /// which the tangential force from equilibrium is combined with a radial force of that sign. (Joints given only by
    /// "tangent" do not state where their material lies and keep the line turned counter-clockwise.) True where a line
    /// was changed.
    bool turn_gears(const Solved& solved, std::vector<bool>& clockwise) const {
        bool changed = false;
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            const std::size_t at = at_index(index);
            const Index column = equations_.first_column(index);
            if (!joint.pair().meshes() || !solved.known[static_cast<std::size_t>(column)]) continue;
            const double force = solved.values[column];
            if (std::abs(force) <= nothing() * largest(solved.values)) continue;
            const Pair n = quarter(unit_along(pose_.tangents[at], pose_));
            const double radial = force * inner(n, equations_.directions(index, clockwise[at]).front());
            const double material = curvature(joint, joint.bodies[0], n) - curvature(joint, joint.bodies[1], n);
            if (radial * material >= 0) continue;
            clockwise[at] = !clockwise[at];
            changed = true;
        }
        return changed;
    }
    double curvature(const Joint& joint, BodyIndex body, const Pair& n) const {
        const auto found = joint.profiles.find(body);
        if (found == joint.profiles.end()) return 0;
        const auto* circle = std::get_if<CircleProfile>(&found->second);
        if (circle == nullptr) return 0;
        return 1 / inner(n, rough(pose_.at(circle->centre) - pose_.at(joint.point)));
    }

    // --- answer
    // ----------------------------------------------------------------------------------------------------------------
    /// The action of a joint whose unknowns begin at `column`; advances `column` past them.
    NumericForces::Action action_at(Index& column, JointIndex index, const std::vector<Pair>& along,
                                    const Solved& solved) const {
        const auto known = [&](Index each) { return static_cast<bool>(solved.known[static_cast<std::size_t>(each)]); };
        const bool has_couple = EquilibriumEquations::carries_couple(mechanism_.joint(index));
        NumericForces::Action action;
        action.joint = index;
        const Index first = column;
        action.force_known = true;
        for (const Pair& direction : along) {
            action.force_known = action.force_known && known(column);
            action.force = action.force + given_.unit() * solved.values[column++] * direction;
        }
        action.couple_known = !has_couple || known(column);
        if (has_couple) action.couple = unit_of_couple() * solved.values[column++];
        action.known = action.force_known && action.couple_known;
        if (const auto& common = solved.common[static_cast<std::size_t>(first)]; common && !action.force_known) {
            action.along = common;
            action.component = inner(action.force, *common);
        }
        if (!action.force_known) action.force = {};
        if (!action.couple_known) action.couple = 0;
        return action;
    }
    NumericForces report(const Solved& solved, const std::vector<bool>& clockwise) const {
        NumericForces forces;
        forces.indeterminacy = solved.indeterminacy;
        forces.balanced = solved.balanced;
        forces.residual = solved.residual;
        forces.given.resize(mechanism_.bodies.size());
        for (const GivenLoads::Given& each : given_.all()) {
            const auto& on = each.pin == none ? each.body : mechanism_.joint(each.pin).bodies.back();
            NumericForces::Sum& sum = forces.given[at_index(on)];
            sum.force = sum.force + each.force;
            sum.couple += each.couple + outer(rough(each.place), each.force);
        }
        const auto known = [&](Index column) {
            return static_cast<bool>(solved.known[static_cast<std::size_t>(column)]);
        };
        for (const JointIndex index : indices_of(mechanism_.joints)) {
            const Joint& joint = mechanism_.joint(index);
            const auto along = equations_.directions(index, clockwise[at_index(index)]);
            Index column = equations_.first_column(index);
            const auto next_action = [&] { return action_at(column, index, along, solved); };
            if (joint.has_own_node()) {
                for (const BodyIndex body : joint.bodies) {
                    forces.actions.push_back(next_action());
                    forces.actions.back().on = body;
                }
                continue;
            }
            auto action = next_action();
            action.on = joint.bodies[0];
            action.from = joint.bodies[1];
            forces.actions.push_back(action);
            std::swap(action.on, action.from);
            action.force = {0 - action.force[0], 0 - action.force[1]};  // no −0
            action.couple = 0 - action.couple;
            action.component = 0 - action.component;
            forces.actions.push_back(action);
        }
        for (std::size_t i = 0; i < mechanism_.efforts.size(); ++i) {
            const Index column = equations_.column_of_effort(i);
            const bool is_couple = std::holds_alternative<CoupleEffort>(mechanism_.efforts[i]);
            const double unit = is_couple ? unit_of_couple() : given_.unit();
            forces.effort_known.push_back(known(column));
            forces.efforts.push_back(known(column) ? unit * solved.values[column] : 0);
        }
        return forces;
    }

    double unit_of_couple() const { return given_.unit() * pose_.size.to_double(); }

    const Mechanism& mechanism_;
    const Pose& pose_;
    GivenLoads given_;
    EquilibriumEquations equations_;
};

}  // namespace
}  // namespace kinegraph::numeric

namespace kinegraph {

NumericForces check_forces(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion) {
    KG_ASSERT(motion.bodies.size() == mechanism.bodies.size(), "the motion is this mechanism's");
    return numeric::Equilibrium(mechanism, pose, motion).run();
}

}  // namespace kinegraph
