#include "constructions/check_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/check.hpp"
#include "engine/check_forces.hpp"

namespace kinegraph {
namespace {

using Pair = std::array<double, 2>;

constexpr BodyIndex frame = 0;
std::size_t at(int index) { return static_cast<std::size_t>(index); }
Pair minus(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
double length(const Pair& a) { return std::hypot(a[0], a[1]); }

class Comparer {
public:
    explicit Comparer(const Solution& solution)
        : solution_(solution), mechanism_(solution.mechanism), numeric_(check_motion(solution.mechanism, solution.pose)) {}

    Comparison compare() && {
        for (BodyIndex body = 1; at(body) < mechanism_.bodies.size(); ++body) compare_turning(body);
        for (const PointMotion& point : solution_.points) compare_point(point);
        for (const Sliding& sliding : solution_.sliding) compare_sliding(sliding);
        for (const InstantCentre& centre : solution_.centres) compare_centre(centre);
        if (!solution_.forces.empty() || !solution_.efforts.empty() || solution_.virtual_work) compare_forces();
        std::vector<std::optional<double>> moduli;
        for (const DrawnVector& vector : solution_.protocol.vectors) moduli.push_back(modulus(vector));
        return {std::move(rows_), std::move(moduli)};
    }

private:
    const std::string& body_name(BodyIndex body) const { return mechanism_.bodies[at(body)].name; }

    void add(std::string quantity, double graphical, double independent) {
        rows_.push_back({std::move(quantity), graphical, independent, graphical - independent});
    }
    void add(const std::string& quantity, const Vector& graphical, const Pair& independent) {
        add(quantity + " x", graphical.x.to_double(), independent[0]);
        add(quantity + " y", graphical.y.to_double(), independent[1]);
    }

    void compare_turning(BodyIndex body) {
        const auto& state = numeric_.bodies[at(body)];
        const BodyMotion& found = solution_.bodies[at(body)];
        if (found.omega && state.velocity_known) add("omega " + body_name(body), found.omega->to_double(), state.omega);
        if (found.alpha && state.acceleration_known) add("alpha " + body_name(body), found.alpha->to_double(), state.alpha);
    }

    void compare_point(const PointMotion& point) {
        const BodyIndex body = point.bodies.front();
        if (body == frame) return;
        const auto& state = numeric_.bodies[at(body)];
        const std::string& letter = mechanism_.points[at(point.point)].name;
        const std::string name = is_of_several_bodies(point.point) ? letter + " on " + body_name(body) : letter;
        const Vector& place = solution_.pose.at(point.point);
        if (point.velocity && state.velocity_known) add("velocity " + name, *point.velocity, numeric_.velocity(body, place));
        if (point.acceleration && state.acceleration_known)
            add("acceleration " + name, *point.acceleration, numeric_.acceleration(body, place));
    }
    /// A pin and the point of the slot under it move differently under one letter.
    bool is_of_several_bodies(PointIndex point) const {
        return std::count_if(solution_.points.begin(), solution_.points.end(),
                             [&](const PointMotion& each) { return each.point == point; }) > 1;
    }

    void compare_sliding(const Sliding& sliding) {
        const Joint& joint = mechanism_.joints[at(sliding.joint)];
        const BodyIndex i = joint.bodies[0], j = joint.bodies[1];
        const auto& slider = numeric_.bodies[at(i)];
        const auto& guide = numeric_.bodies[at(j)];
        const Vector& place = solution_.pose.at(joint.point);
        if (!slider.velocity_known || !guide.velocity_known) return;
        const Pair velocity = minus(numeric_.velocity(i, place), numeric_.velocity(j, place));
        if (sliding.velocity) add("sliding " + joint.name + " velocity", *sliding.velocity, velocity);
        if (!slider.acceleration_known || !guide.acceleration_known || !sliding.acceleration) return;
        const Pair coriolis{-2 * guide.omega * velocity[1], 2 * guide.omega * velocity[0]};
        const Pair acceleration = minus(minus(numeric_.acceleration(i, place), numeric_.acceleration(j, place)), coriolis);
        add("sliding " + joint.name + " acceleration", *sliding.acceleration, acceleration);
        add("sliding " + joint.name + " coriolis", *sliding.coriolis, coriolis);
    }

    /// A finite centre against the place where the numeric relative velocity vanishes: P = X + z ∧ v_rel / ω_rel.
    void compare_centre(const InstantCentre& centre) {
        if (!centre.at || centre.at->at_infinity() || centre.everywhere) return;
        const auto& first = numeric_.bodies[at(centre.first)];
        const auto& second = numeric_.bodies[at(centre.second)];
        if (!first.velocity_known || !second.velocity_known) return;
        const double omega = second.omega - first.omega;
        // Below this the two bodies hardly turn against each other, and the quotient says nothing about the place.
        constexpr double least_relative_spin = 1e-6;
        if (std::abs(omega) <= least_relative_spin * std::max(std::abs(first.omega), std::abs(second.omega)) || omega == 0)
            return;
        const Vector place = centre.at->place();
        const Pair relative = minus(numeric_.velocity(centre.second, place), numeric_.velocity(centre.first, place));
        const Pair found{place.x.to_double() - relative[1] / omega, place.y.to_double() + relative[0] / omega};
        add("centre " + body_name(centre.first) + "," + body_name(centre.second), place, found);
    }

    void compare_forces() {
        const NumericForces numeric = check_forces(mechanism_, solution_.pose, numeric_);
        for (const JointForce& found : solution_.forces)
            for (const NumericForces::Action& action : numeric.actions) compare_action(found, action);
        if (solution_.virtual_work) add("virtual power", solution_.virtual_work->total.to_double(), numeric_power());
        for (std::size_t e = 0; e < solution_.efforts.size(); ++e)
            if (solution_.efforts[e].value && numeric.effort_known[e])
                add("effort " + solution_.efforts[e].name, solution_.efforts[e].value->to_double(), numeric.efforts[e]);
    }
    void compare_action(const JointForce& found, const NumericForces::Action& action) {
        if (!found.force || !action.known) return;
        if (action.joint != found.joint || action.on != found.on || action.from != found.from) return;
        const std::string name = "force " + mechanism_.joints[at(found.joint)].name + " " +
                                 (found.from < 0 ? "pin" : body_name(found.from)) + " on " + body_name(found.on);
        add(name, *found.force, action.force);
        if (!found.couple->is_zero() || action.couple != 0) add(name + " couple", found.couple->to_double(), action.couple);
    }
    /// The powers of the same loads with the velocities of the check.
    double numeric_power() const {
        double power = 0;
        for (const VirtualWork::Entry& entry : solution_.virtual_work->entries) {
            const Pair velocity = numeric_.velocity(entry.body, entry.at);
            power += entry.force.x.to_double() * velocity[0] + entry.force.y.to_double() * velocity[1] +
                     entry.couple.to_double() * numeric_.bodies[at(entry.body)].omega;
        }
        return power;
    }

    /// Of velocities and accelerations; relative ones from the motions of their two places:
    ///   a = a_to + a_cor + a_n + a_t (or a_rel),  a_cor = 2ω_to ∧ v,  a_n = v²/r,  a_t ⟂ r  (Rivals, Coriolis).
    std::optional<double> modulus(const DrawnVector& vector) const {
        using Role = DrawnVector::Role;
        const auto& [of, to, about] = vector.seen;
        const bool is_velocity = solution_.protocol.polygons[at(vector.polygon)].plane == Plane::velocity;
        if (!is_known(of, is_velocity)) return std::nullopt;
        const Pair own_velocity = numeric_.velocity(of.body, place_of(of.place)),
                   own_acceleration = numeric_.acceleration(of.body, place_of(of.place));
        if (vector.role == Role::absolute || vector.role == Role::transport)
            return length(is_velocity ? own_velocity : own_acceleration);
        if (!is_known(to, is_velocity)) return std::nullopt;
        const Pair v = minus(own_velocity, numeric_.velocity(to.body, place_of(to.place)));
        if (is_velocity) return length(v);
        const Pair a = minus(own_acceleration, numeric_.acceleration(to.body, place_of(to.place)));
        const double turning = 2 * numeric_.bodies[at(to.body)].omega;
        const Pair coriolis{-turning * v[1], turning * v[0]};
        Pair radius{};
        if (about >= 0) {
            const Vector join = place_of(of.place) - place_of(about);
            radius = {join.x.to_double(), join.y.to_double()};
        }
        const double r = length(radius);
        const auto along_circle = [&](const Pair& part) { return std::abs(radius[0] * part[1] - radius[1] * part[0]) / r; };
        switch (vector.role) {
            case Role::coriolis:
                return length(coriolis);
            case Role::normal:
                return r > 0 ? length(v) * length(v) / r : length(a);
            case Role::tangential:
                return r > 0 ? along_circle(a) : length(a);
            case Role::sliding:
                return r > 0 ? along_circle(minus(a, coriolis)) : length(minus(a, coriolis));
            default:
                return length(a);
        }
    }
    bool is_known(const CarriedPlace& carried, bool velocity) const {
        if (carried.body < 0) return false;
        const auto& state = numeric_.bodies[at(carried.body)];
        return velocity ? state.velocity_known : state.acceleration_known;
    }
    Vector place_of(int element) const { return solution_.protocol.point(element).place(); }

    const Solution& solution_;
    const Mechanism& mechanism_;
    NumericMotion numeric_;
    std::vector<CheckRow> rows_;
};

}  // namespace

Comparison compare_with_check(const Solution& solution) { return Comparer(solution).compare(); }

}  // namespace kinegraph
