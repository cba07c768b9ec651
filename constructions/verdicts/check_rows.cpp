#include "constructions/verdicts/check_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/check/check.hpp"
#include "engine/check/numeric_result.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/magnitudes.hpp"
#include "engine/solution/result_values.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

using Pair = std::array<double, 2>;

Pair minus(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
double length(const Pair& a) { return nearest::hypot(a[0], a[1]); }

class Comparer {
public:
    explicit Comparer(const Solution& solution)
        : solution_(solution),
          mechanism_(solution.mechanism),
          numeric_(check_motion(solution.mechanism, solution.pose)) {}

    Comparison compare() && {
        for_each_result(solution_,
                        [&](const Quantity& quantity, const auto& found) { compare_motion(quantity, *found); });
        for (const InstantCentre& centre : solution_.centres) compare_centre(centre);
        for_each_curvature(solution_, [&](const Quantity& quantity, const auto& found) {
            if (found) compare_curvature(quantity, found);
        });
        if (!solution_.forces.empty() || !solution_.efforts.empty() || !solution_.resultants.empty() ||
            solution_.virtual_work)
            compare_forces(solution_, numeric_, comparison_);
        for (const DrawnVector& vector : solution_.protocol.vectors) comparison_.moduli.push_back(modulus(vector));
        tell_what_moves();
        return std::move(comparison_);
    }

private:
    using Kind = Quantity::Kind;

    void add(const Quantity& quantity, double graphical, double independent) {
        comparison_.rows.push_back({quantity, graphical, independent, graphical - independent});
    }
    void add(const Quantity& quantity, const Vector& graphical, const Pair& independent) {
        add(quantity.along(Quantity::Component::x), graphical.x.to_double(), independent[0]);
        add(quantity.along(Quantity::Component::y), graphical.y.to_double(), independent[1]);
    }

    template <class Value>
    void compare_motion(const Quantity& quantity, const Value& found) {
        if (!result_kind(quantity).is_velocity() && !result_kind(quantity).is_acceleration()) return;
        const auto numeric = numeric_result(numeric_, mechanism_, solution_.pose, quantity);
        if (!numeric) return;
        if constexpr (std::is_same_v<Value, Exact>)
            add(quantity, found.to_double(), (*numeric)[0]);
        else if constexpr (std::is_same_v<Value, Vector>)
            add(quantity, found, *numeric);
    }

    /// Compares a finite centre with the place where the numeric relative velocity vanishes: P = X + z ∧ v_rel / ω_rel.
    void compare_centre(const InstantCentre& centre) {
        if (!centre.at || centre.at->at_infinity() || centre.everywhere) return;
        const auto& first = numeric_.bodies[at_index(centre.first)];
        const auto& second = numeric_.bodies[at_index(centre.second)];
        if (!first.velocity_known || !second.velocity_known) return;
        const double omega = second.omega - first.omega;
        // Below this there is almost no relative rotation, and the quotient does not determine the place.
        constexpr double least_relative_spin = 1e-6;
        if (std::abs(omega) <= least_relative_spin * std::max(std::abs(first.omega), std::abs(second.omega)) ||
            omega == 0)
            return;
        const Vector place = centre.at->place();
        const Pair relative = minus(numeric_.velocity(centre.second, place), numeric_.velocity(centre.first, place));
        const Pair found{place.x.to_double() - relative[1] / omega, place.y.to_double() + relative[0] / omega};
        add(quantity_of(centre), place, found);
    }

    /// Of a body that turns about a pole at rest the circle is a point, and the poles of velocity and acceleration are
    /// one.
    void compare_curvature(const Quantity& quantity, const auto& found) {
        const auto of = std::find_if(solution_.curvature.begin(), solution_.curvature.end(),
                                     [&](const Curvature& each) { return each.body == quantity.body; });
        const bool is_of_path = quantity.kind == Kind::radius;
        if (!is_of_path && of->kind != Curvature::Kind::general) return;
        const Vector beside = is_of_path ? solution_.pose.at(quantity.point) : of->pole->place();
        const auto numeric = numeric_curvature(numeric_, quantity, beside);
        if (!numeric) return;
        if constexpr (requires { found->to_double(); })
            add(quantity, found->to_double(), (*numeric)[0]);
        else
            add(quantity, *found, *numeric);
    }

    void tell_what_moves() {
        const double size = solution_.pose.size.to_double();
        const auto speed = [&](const NumericMotion::BodyState& state) {
            return state.velocity_known ? std::max(length(state.velocity), std::abs(state.omega) * size) : 0;
        };
        double fastest = 0;
        for (const auto& state : numeric_.bodies) fastest = std::max(fastest, speed(state));
        for (const auto& state : numeric_.bodies)
            comparison_.bodies.push_back({state.velocity_known, speed(state) > Magnitudes::noise * fastest});
    }

    /// Magnitude of a velocity or acceleration; relative ones from the motions of their two places:
    ///   a = a_to + a_cor + a_n + a_t (or a_rel),  a_cor = 2ω_to ∧ v,  a_n = v²/r,  a_t ⟂ r  (Rivals, Coriolis).
    std::optional<double> modulus(const DrawnVector& vector) {
        using Role = DrawnVector::Role;
        const auto& [of, to, about] = vector.seen;
        const bool is_velocity = solution_.protocol.polygons[at_index(vector.polygon)].plane == Plane::velocity;
        if (!is_known(of, is_velocity)) return std::nullopt;
        const Pair arm = arm_of(of), own_velocity = numeric_.velocity_at_arm(of.body, arm),
                   own_acceleration = numeric_.acceleration_at_arm(of.body, arm);
        if (vector.role == Role::absolute || vector.role == Role::transport)
            return length(is_velocity ? own_velocity : own_acceleration);
        if (!is_known(to, is_velocity)) return std::nullopt;
        const Pair other = arm_of(to), v = minus(own_velocity, numeric_.velocity_at_arm(to.body, other));
        if (is_velocity) return length(v);
        const Pair a = minus(own_acceleration, numeric_.acceleration_at_arm(to.body, other));
        const double turning = 2 * numeric_.bodies[at_index(to.body)].omega;
        const Pair coriolis{-turning * v[1], turning * v[0]};
        Pair radius{};
        if (about != none) {
            const ProjectivePoint &end = solution_.protocol.point(of.place), &centre = solution_.protocol.point(about);
            radius = {difference_to_double(end.x, centre.x), difference_to_double(end.y, centre.y)};
        }
        const double r = length(radius);
        const auto along_circle = [&](const Pair& part) {
            return std::abs(radius[0] * part[1] - radius[1] * part[0]) / r;
        };
        switch (vector.role) {
            case Role::coriolis: return length(coriolis);
            case Role::normal: return r > 0 ? length(v) * length(v) / r : length(a);
            case Role::tangential: return r > 0 ? along_circle(a) : length(a);
            case Role::sliding: return r > 0 ? along_circle(minus(a, coriolis)) : length(minus(a, coriolis));
            default: return length(a);
        }
    }
    bool is_known(const CarriedPlace& carried, bool velocity) const {
        if (carried.body == none) return false;
        const auto& state = numeric_.bodies[at_index(carried.body)];
        return velocity ? state.velocity_known : state.acceleration_known;
    }
    /// Cached: many vectors refer to few places.
    const Pair& arm_of(const CarriedPlace& carried) {
        const auto [entry, is_new] = arms_.try_emplace({carried.body, carried.place});
        if (is_new) entry->second = numeric_.arm(carried.body, solution_.protocol.point(carried.place).place());
        return entry->second;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    NumericMotion numeric_;
    std::map<std::pair<BodyIndex, ElementIndex>, Pair> arms_;
    Comparison comparison_;
};

/// The largest difference of one kind between the construction and the check.
struct Gap {
    Argument name;
    double graphical = 0, difference = 0;
    std::string unit;
    int others = 0;
};

/// The SI unit.
std::string si_unit_of(const Quantity& quantity, const Mechanism& mechanism) {
    return std::string(default_unit(unit_kind_of(quantity, mechanism)).symbol);
}

/// Differences between two numbers that should be equal, by kind.
class Gaps {
public:
    /// `moduli` as for the magnitudes.
    Gaps(const Solution& solution, const std::vector<std::optional<double>>& moduli)
        : solution_(solution), magnitudes_(solution, moduli) {}

    /// `name` returns the name of the quantity.
    template <class Name>
    void hold(const Quantity& quantity, const Name& name, double graphical, double numeric) {
        // A thousand times the relative rounding error of the check: near a dead point it loses some digits. If
        // constraints are redundant within rounded data, the two computations may use different ones.
        constexpr double times_rounding = 256;
        const double allowed = std::max(1e3 * Magnitudes::noise, times_rounding * solution_.pose.rounding());
        const double difference = graphical - numeric;
        if (std::abs(difference) <= allowed * magnitudes_.of(quantity)) return;
        const auto [at_kind, is_first] = worst_.try_emplace(quantity.kind);
        Gap& worst = at_kind->second;
        if (!is_first) ++worst.others;
        // NaN is the worst.
        if (is_first || std::abs(difference) > std::abs(worst.difference) || std::isnan(difference))
            worst = {name(), graphical, difference, si_unit_of(quantity, solution_.mechanism), worst.others};
    }
    std::vector<Message> told() const {
        std::vector<Message> messages;
        for (const auto& [kind, gap] : worst_) {
            Message message{lang::sentences::check_differs,
                            {gap.name, Amount{gap.graphical, gap.unit}, Amount{gap.difference, gap.unit}}};
            if (gap.others > 0) message.arguments.emplace_back(Count{gap.others});
            messages.push_back(std::move(message));
        }
        return messages;
    }

private:
    const Solution& solution_;
    Magnitudes magnitudes_;
    std::map<Quantity::Kind, Gap> worst_;
};

/// Whether the construction finds that the body moves.
bool moves(const Solution& solution, BodyIndex body) {
    const auto& omega = solution.bodies[at_index(body)].omega;
    if (!omega) return false;
    return !omega->is_zero() ||
           std::any_of(solution.points.begin(), solution.points.end(), [&](const PointMotion& point) {
               return point.velocity && !point.velocity->is_zero() &&
                      std::find(point.bodies.begin(), point.bodies.end(), body) != point.bodies.end();
           });
}

}  // namespace

Comparison compare_with_check(const Solution& solution) { return Comparer(solution).compare(); }

void enter(Comparison comparison, Solution& solution) {
    solution.checks = std::move(comparison.rows);
    solution.numeric_moduli = std::move(comparison.moduli);
    for (std::size_t b = 0; b < comparison.actions.size(); ++b)
        for (std::size_t f = 0; f < comparison.actions[b].size(); ++f) {
            AppliedForce& applied = solution.free_bodies[b].forces[f];
            applied.numeric_force = comparison.actions[b][f].force;
            applied.numeric_couple = comparison.actions[b][f].couple;
        }
    for (const auto& [bar, pull] : comparison.bars) solution.truss->bars[bar].numeric = pull;
}

std::vector<Message> disagreements(const Solution& solution, const std::vector<Comparison::Moved>& bodies) {
    const std::vector<std::optional<double>> moduli = moduli_of_motion(solution.protocol);
    Gaps gaps(solution, moduli);
    for (const CheckRow& row : solution.checks)
        gaps.hold(
            row.quantity, [&] { return Argument(name_of(row.quantity, solution)); }, row.graphical, row.numeric);
    for (std::size_t v = 0; v < solution.numeric_moduli.size(); ++v) {
        const DrawnVector& vector = solution.protocol.vectors[v];
        if (const auto& numeric = solution.numeric_moduli[v]; numeric && moduli[v])
            gaps.hold(
                vector.quantity, [&] { return Argument(vector.symbol); }, *moduli[v], *numeric);
    }
    std::vector<Message> messages = gaps.told();
    // A driver that imposes an impossible motion has its own message; the check then finds no motion.
    if (!solution.mobility.idle_drivers.empty() || solution.mechanism.motion) return messages;
    const std::vector<bool>& determined = solution.mobility.determined;
    for (std::size_t b = 1; b < std::min(bodies.size(), determined.size()); ++b) {
        const BodyIndex body(b);
        const BodyName name{solution.mechanism.bodies[b].name};
        // A construction may find the rotation of a body whose motion is not determined.
        if (determined[b] && moves(solution, body) && !bodies[b].determined)
            messages.push_back({lang::sentences::check_stands_still, {name}});
        if (bodies[b].determined && bodies[b].moves && !determined[b])
            messages.push_back({lang::sentences::check_moves, {name}});
    }
    return messages;
}

}  // namespace kinegraph
