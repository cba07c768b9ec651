#include "problems/impact/impact.hpp"

#include <cmath>

#include "engine/number/functions.hpp"
#include "engine/number/geometry.hpp"
#include "lang/keys/impact.hpp"

namespace kinegraph {
namespace {

Vector place_of(const Place& place, const Pose& pose) {
    if (const auto* point = std::get_if<PointIndex>(&place)) return pose.at(*point);
    return std::get<Vector>(place);
}
int sense_of(const Exact& value) { return value.sign(); }

class Impact {
public:
    Impact(const ImpactProblem& problem, const Pose& pose) : problem_(problem) {
        found_.at = place_of(problem.at, pose);
        found_.friction = problem.friction;
        found_.restitution = problem.restitution;
        for (std::size_t i = 0; i < 2; ++i) found_.bodies.at(i) = body_of(problem.bodies.at(i), pose);
        found_.normal = direction_of(problem.normal, pose);
        orient_normal();
        found_.tangent = quarter_turn(found_.normal);
    }

    /// Errors in the data, before anything is solved.
    std::optional<Error> set_up() {
        for (std::size_t i = 0; i < 2; ++i) {
            const ImpactBody& given = problem_.bodies.at(i);
            if (!given.pivot || !(inertia_about_pivot(given, found_.bodies.at(i))).is_zero()) continue;
            return Error{ErrorCode::bad_input, given.where, {lang::impact::this_body_has_its_centre}};
        }
        find_velocities();
        find_compliance();
        if (found_.approach.sign() >= 0) return parting();
        classify();
        return std::nullopt;
    }

    /// False if sliding jams.
    bool run() {
        while (!done_)
            if (!next_phase()) return false;
        settle();
        return true;
    }
    ImpactSolution solution() && { return std::move(found_); }

private:
    static Exact inertia_about_pivot(const ImpactBody& given, const ImpactSolution::Body& body) {
        return given.inertia.value_or(Exact()) + given.mass * squared_length(body.centre - *body.pivot);
    }
    ImpactSolution::Body body_of(const ImpactBody& given, const Pose& pose) const {
        ImpactSolution::Body body;
        body.fixed = given.fixed;
        body.centre = given.centre ? place_of(*given.centre, pose) : found_.at;
        if (given.fixed) return body;
        body.omega_before = given.omega;
        if (given.pivot) {
            body.pivot = place_of(*given.pivot, pose);
            body.before = given.omega * quarter_turn(body.centre - *body.pivot);
            if (const Exact inertia = inertia_about_pivot(given, body); !inertia.is_zero())
                body.inverse_inertia = Exact(1) / inertia;
            return body;
        }
        body.before = given.velocity.value_or(Vector{});
        body.inverse_mass = Exact(1) / given.mass;
        if (given.inertia) body.inverse_inertia = Exact(1) / *given.inertia;
        return body;
    }
    /// Towards the first body's centre, away from the second's; else as in the file.
    void orient_normal() {
        int sense = 0;
        if (!problem_.bodies[0].fixed) sense = dot(found_.bodies[0].centre - found_.at, found_.normal).sign();
        if (sense == 0 && !problem_.bodies[1].fixed)
            sense = -dot(found_.bodies[1].centre - found_.at, found_.normal).sign();
        if (sense < 0) found_.normal = -found_.normal;
    }

    /// From the body's reference point (pivot or centre) to the point of impact, turned by a quarter. ω times it is the
    /// velocity due to rotation.
    Vector lever(const ImpactSolution::Body& body) const {
        return quarter_turn(found_.at - (body.pivot ? *body.pivot : body.centre));
    }
    Vector velocity_at_contact(const ImpactSolution::Body& body, const Vector& centre, const Exact& omega) const {
        return (body.pivot ? Vector{} : centre) + omega * lever(body);
    }
    void find_velocities() {
        for (ImpactSolution::Body& body : found_.bodies)
            body.contact_before = velocity_at_contact(body, body.before, body.omega_before);
        const Vector relative = found_.bodies[0].contact_before - found_.bodies[1].contact_before;
        found_.approach = dot(relative, found_.normal);
        found_.slip = dot(relative, found_.tangent);
    }
    void find_compliance() {
        const Exact square = squared_length(found_.normal);
        for (const ImpactSolution::Body& body : found_.bodies) {
            const Exact along = dot(lever(body), found_.normal), across = dot(lever(body), found_.tangent);
            found_.a += body.inverse_mass * square + body.inverse_inertia * along * along;
            found_.b += body.inverse_inertia * along * across;
            found_.c += body.inverse_mass * square + body.inverse_inertia * across * across;
        }
    }
    Error parting() const {
        return {ErrorCode::bad_input, problem_.where,
                found_.approach.is_zero() ? Words(lang::impact::the_bodies_do_not_approach)
                                          : Words(lang::impact::the_bodies_part_at_the_point)};
    }
    void classify() {
        found_.central = true;
        const ProjectiveLine line_of_impact = finite_line_through(point_at(found_.at), found_.normal);
        for (const ImpactSolution::Body& body : found_.bodies)
            if (!body.fixed && !incident(point_at(body.centre), line_of_impact)) found_.central = false;
        found_.direct = found_.slip.is_zero();
        found_.obliquity = nearest::atan2(std::abs(found_.slip.to_double()), std::abs(found_.approach.to_double()));
    }

    // ----- phases: straight pieces of the impulse path

    Exact normal_velocity() const { return found_.approach + found_.a * normal_ + found_.b * tangential_; }
    Exact slip() const { return found_.slip + found_.b * normal_ + found_.c * tangential_; }

    bool next_phase() {
        const Exact slip_now = slip();
        ImpactSolution::Phase phase;
        Exact slope;  // dJ_t/dJ_n
        phase.sense = sense_of(slip_now);
        if (phase.sense == 0) {
            const bool sticks = found_.c.is_zero() || abs(found_.b) <= found_.friction * found_.c;
            phase.kind = sticks ? ImpactSolution::Phase::Kind::sticks : ImpactSolution::Phase::Kind::slides;
            // If slip starts again, the normal impulse determines its sense, since friction cannot prevent it.
            phase.sense = sticks ? 0 : sense_of(found_.b);
            slope = sticks ? (found_.c.is_zero() ? Exact() : -(found_.b / found_.c))
                           : -(Exact(phase.sense) * found_.friction);
        } else {
            slope = -(Exact(phase.sense) * found_.friction);
        }
        const Exact normal_rate = found_.a + found_.b * slope, slip_rate = found_.b + found_.c * slope;
        // The phase ends at the first of: end of slip, end of compression, end of restitution.
        std::optional<Exact> step;
        const auto at_most = [&](const Exact& bound) {
            if (!step || bound < *step) step = bound;
        };
        if (sense_of(slip_now) != 0 && sense_of(slip_rate) == -sense_of(slip_now)) at_most(-(slip_now / slip_rate));
        bool compresses = false;
        if (!end_) {
            if (normal_rate.sign() > 0) {
                const Exact bound = -(normal_velocity() / normal_rate);
                compresses = !step || bound <= *step;
                at_most(bound);
            }
        } else {
            at_most(*end_ - normal_);
        }
        if (!step) return false;
        normal_ += *step;
        tangential_ += slope * *step;
        if (compresses) end_ = (1 + problem_.restitution) * normal_;
        phase.ends_compression = compresses;
        phase.normal = normal_;
        phase.tangential = tangential_;
        if (!step->is_zero() || compresses) found_.phases.push_back(phase);
        done_ = end_ && normal_ == *end_;
        return true;
    }

    void settle() {
        found_.normal_impulse = normal_;
        found_.tangential_impulse = tangential_;
        found_.impulse = normal_ * found_.normal + tangential_ * found_.tangent;
        found_.separation = normal_velocity();
        found_.slip_after = slip();
        found_.kinematic_restitution = -(found_.separation / found_.approach);
        // The work of the impulse, by the mean of the velocities before and after (Kelvin).
        found_.energy_lost =
            -((normal_ * (found_.approach + found_.separation) + tangential_ * (found_.slip + found_.slip_after)) / 2);
        for (std::size_t i = 0; i < 2; ++i) settle(i);
    }
    void settle(std::size_t i) {
        ImpactSolution::Body& body = found_.bodies.at(i);
        const ImpactBody& given = problem_.bodies.at(i);
        const Vector impulse = i == 0 ? found_.impulse : -found_.impulse;
        body.omega_after = body.omega_before + body.inverse_inertia * dot(lever(body), impulse);
        body.after = body.pivot ? body.omega_after * quarter_turn(body.centre - *body.pivot)
                                : body.before + body.inverse_mass * impulse;
        body.contact_after = velocity_at_contact(body, body.after, body.omega_after);
        if (!body.fixed) found_.energy_before += energy(given, body);
        if (!body.pivot) return;
        body.reaction = given.mass * (body.after - body.before) - impulse;
        const Vector arm = body.centre - *body.pivot;
        // Centre of percussion, at J_O/(m d) from the pivot on the line to the centre: a perpendicular impulse there
        // causes no reaction at the pivot.
        if (!arm.is_zero())
            body.percussion =
                *body.pivot + (Exact(1) / (body.inverse_inertia * given.mass * squared_length(arm))) * arm;
    }
    static Exact energy(const ImpactBody& given, const ImpactSolution::Body& body) {
        if (body.pivot) return square(body.omega_before) / (2 * body.inverse_inertia);
        return (given.mass * squared_length(body.before) +
                given.inertia.value_or(Exact()) * square(body.omega_before)) /
               2;
    }

    const ImpactProblem& problem_;
    ImpactSolution found_;
    Exact normal_, tangential_;  ///< the impulse so far
    std::optional<Exact> end_;   ///< the final normal impulse, once the compression has ended
    bool done_ = false;
};

std::vector<ProblemValue> values_of(const ImpactProblem& problem, const ImpactSolution& found, const ImpactCheck& check,
                                    const Mechanism& mechanism) {
    using enum QuantityKind;
    std::vector<ProblemValue> values;
    const auto add = [&](std::string key, Words name, std::string symbol, QuantityKind kind, const Exact& value,
                         std::optional<double> numeric, const char* unit = "") {
        values.push_back(
            {std::move(key), std::move(name), std::move(symbol), kind, value.to_double(), numeric, false, unit});
    };
    const Words first = called(mechanism.body(problem.bodies[0].body));
    add("impulse x", {lang::impact::impulse_received_along_x, first}, "J_x", dimensionless, found.impulse.x,
        check.impulse[0], "N s");
    add("impulse y", {lang::impact::impulse_received_along_y, first}, "J_y", dimensionless, found.impulse.y,
        check.impulse[1], "N s");
    for (std::size_t i = 0; i < 2; ++i) {
        const ImpactSolution::Body& body = found.bodies.at(i);
        const ImpactCheck::Body& checked = check.bodies.at(i);
        if (body.fixed) continue;
        const kinegraph::Body& given = mechanism.body(problem.bodies.at(i).body);
        const std::string n = std::to_string(i + 1);
        const auto add_of = [&](const std::string& of, const char* axis, Key name, std::string symbol,
                                QuantityKind kind, const Exact& value, double numeric, const char* unit = "") {
            add(of + " " + given.name + axis, Words(name, called(given)), std::move(symbol), kind, value, numeric,
                unit);
        };
        add_of("velocity", " x", lang::impact::velocity_afterwards_along_x, "v′_" + n + "x", velocity, body.after.x,
               checked.velocity[0]);
        add_of("velocity", " y", lang::impact::velocity_afterwards_along_y, "v′_" + n + "y", velocity, body.after.y,
               checked.velocity[1]);
        if (!body.inverse_inertia.is_zero())
            add_of("angular velocity", "", lang::impact::angular_velocity_afterwards, "ω′_" + n, angular_velocity,
                   body.omega_after, checked.omega);
        if (!body.reaction) continue;
        add_of("pivot", " x", lang::impact::impulse_of_the_pivot_along_x, "R_" + n + "x", dimensionless,
               body.reaction->x, checked.reaction[0], "N s");
        add_of("pivot", " y", lang::impact::impulse_of_the_pivot_along_y, "R_" + n + "y", dimensionless,
               body.reaction->y, checked.reaction[1], "N s");
    }
    add("energy lost", {lang::impact::energy_lost}, "T", dimensionless, found.energy_lost, check.energy_lost, "J");
    return values;
}

}  // namespace

Result<ProblemSolution> solve_impact(const ImpactProblem& problem, const Mechanism& mechanism, const Pose& pose) {
    Impact impact(problem, pose);
    if (auto error = impact.set_up()) return tl::unexpected(Errors{*std::move(error)});
    if (!impact.run())
        return tl::unexpected(Errors{
            {ErrorCode::no_unique_answer, problem.where, {lang::impact::with_this_friction_the_sliding_bodies}}});
    ImpactSolution found = std::move(impact).solution();
    ProblemSolution solution;
    solution.subject = {lang::impact::impact_momentum_restitution_and_friction};
    solution.values = values_of(problem, found, check_impact(problem, found.at, found.normal, pose), mechanism);
    if (auto why = why_no_numbers(solution.values, problem.where)) return tl::unexpected(*std::move(why));
    if (found.kinematic_restitution != found.restitution)
        solution.remarks.emplace_back(lang::impact::friction_makes_the_two_coefficients);
    solution.of = std::move(found);
    return solution;
}

}  // namespace kinegraph
