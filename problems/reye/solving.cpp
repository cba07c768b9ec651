#include "problems/reye/reye.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/reye.hpp"

namespace kinegraph {
namespace {

using std::numbers::pi;
using Kind = ReyeProblem::Kind;

class Wear {
public:
    explicit Wear(const ReyeProblem& problem) : problem_(problem), force_(problem.force.to_double()) {
        switch (problem.kind) {
            case Kind::pad: tilt(); break;
            case Kind::block: press_evenly(); break;
            case Kind::disc: turn_ring(); break;
            case Kind::shoe: turn_shoe(); break;
        }
        sample();
        if (problem.wear) wear_off();
    }
    ReyeSolution solution() && { return std::move(found_); }
    bool locks() const { return locks_; }

private:
    void tilt() {
        const Exact &a = problem_.length, &b = problem_.width, &d = problem_.offset, &q = problem_.force;
        const Exact first = 2 * q * (2 * a - 3 * d) / (a * a * b), second = 2 * q * (3 * d - a) / (a * a * b);
        found_.resultant = d;
        found_.end = a.to_double();
        found_.lifts = first.sign() < 0 || second.sign() < 0;
        if (!found_.lifts) {
            found_.first = first.to_double();
            found_.second = second.to_double();
            if (first.sign() > 0) found_.m = (3 * a - 6 * d) / (3 * d - 2 * a);
        } else if (second.sign() < 0) {
            found_.end = (3 * d).to_double();
            found_.first = (2 * q / (3 * d * b)).to_double();
        } else {
            found_.begin = (a - 3 * (a - d)).to_double();
            found_.second = (2 * q / (3 * (a - d) * b)).to_double();
        }
        found_.greatest = std::max(found_.first, found_.second);
        found_.greatest_at = found_.first >= found_.second ? 0 : a.to_double();
        rub_straight();
    }
    void press_evenly() {
        found_.end = problem_.length.to_double();
        found_.greatest = found_.first = found_.second =
            (problem_.force / (problem_.length * problem_.width)).to_double();
        found_.m = Exact();
        found_.resultant = problem_.length / 2;
        rub_straight();
    }
    void rub_straight() {
        if (problem_.friction) found_.friction_force = (*problem_.friction * problem_.force).to_double();
    }

    void turn_ring() {
        const double inner = problem_.inner.to_double(), outer = problem_.outer.to_double();
        const double f = problem_.friction->to_double() * problem_.surfaces;
        const double constant = force_ / (2 * pi * (outer - inner));
        found_.begin = inner;
        found_.end = outer;
        found_.greatest = found_.first = constant / inner;
        found_.greatest_at = inner;
        found_.second = constant / outer;
        found_.torque = f * force_ * (inner + outer) / 2;
        found_.uniform_pressure = force_ / (pi * (outer - inner) * (outer + inner));
        // (r₂³ − r₁³)/(r₂² − r₁²) without cancellation.
        found_.uniform_torque =
            2.0 / 3 * f * force_ * (outer * outer + outer * inner + inner * inner) / (outer + inner);
    }

    void turn_shoe() {
        const double r = problem_.radius.to_double(), h = problem_.pivot.to_double(), b = problem_.width.to_double();
        const double from = problem_.from.to_double(), to = problem_.to.to_double(), f = problem_.friction->to_double();
        // ∫ sin²θ, ∫ sin θ, ∫ sin θ cos θ between the ends.
        const double squares = (to - from) / 2 - (nearest::sin(2 * to) - nearest::sin(2 * from)) / 4;
        const double sines = nearest::cos(from) - nearest::cos(to);
        const double products = (nearest::sin(to) - nearest::sin(from)) * (nearest::sin(to) + nearest::sin(from)) / 2;
        const double normal = b * r * h * squares, rubbing = b * r * (r * sines - h * products);
        // If the moment of friction is negative, friction acts in the opposite sense.
        if (rubbing > 0) found_.locking_friction = normal / rubbing;
        const double moment = problem_.leading ? normal - f * rubbing : normal + f * rubbing;
        locks_ = !(moment > 0);
        const double constant = force_ * problem_.arm.to_double() / moment;
        found_.begin = from;
        found_.end = to;
        found_.first = constant * nearest::sin(from);
        found_.second = constant * nearest::sin(to);
        found_.greatest_at = std::clamp(pi / 2, from, to);
        found_.greatest = constant * nearest::sin(found_.greatest_at);
        found_.torque = f * constant * b * r * r * sines;
        const double inward = problem_.inside ? -1 : 1;
        found_.normal_force = {inward * constant * b * r * products, inward * constant * b * r * squares};
        found_.pressure_radius = r * sines / nearest::hypot(products, squares);
        constant_ = constant;
    }

    double pressure_at(double place) const {
        if (place < found_.begin || place > found_.end) return 0;
        if (problem_.kind == Kind::disc) return found_.first * found_.begin / place;
        if (problem_.kind == Kind::shoe) return constant_ * nearest::sin(place);
        const double share = (place - found_.begin) / (found_.end - found_.begin);
        return found_.first + share * (found_.second - found_.first);
    }
    void sample() {
        constexpr int samples = 60;
        for (int i = 0; i <= samples; ++i) {
            const double place = i == samples ? found_.end : found_.begin + (found_.end - found_.begin) * i / samples;
            found_.pressures.push_back({place, pressure_at(place)});
        }
    }
    /// Depth = wear coefficient × pressure × sliding distance.
    void wear_off() {
        const double turned = (*problem_.wear * *problem_.speed * *problem_.time).to_double();
        std::array<double, 2> levers{1, 1};
        if (problem_.kind == Kind::disc) levers = {found_.begin, found_.end};
        if (problem_.kind == Kind::shoe) levers = {problem_.radius.to_double(), problem_.radius.to_double()};
        found_.worn = std::array{turned * levers[0] * found_.first, turned * levers[1] * found_.second};
    }

    const ReyeProblem& problem_;
    double force_, constant_ = 0;
    bool locks_ = false;
    ReyeSolution found_;
};

/// Names of the two ends of the contact, as in each kind's data.
std::array<Words, 2> ends_of(Kind kind) {
    switch (kind) {
        case Kind::disc: return {Words(lang::reye::at_the_inner_radius), Words(lang::reye::at_the_outer_radius)};
        case Kind::shoe: return {Words(lang::reye::at_the_first_end), Words(lang::reye::at_the_second_end)};
        case Kind::pad:
        case Kind::block: break;
    }
    return {Words(lang::reye::at_the_end_where_x_0), Words(lang::reye::at_the_other_end)};
}

/// With their keys in the results file; the names for readers are complete, since a question sheet has no other text.
std::vector<ProblemValue> values_of(const ReyeProblem& problem, const ReyeSolution& found, const ReyeCheck& check) {
    using enum QuantityKind;
    std::vector<ProblemValue> values;
    const auto add = [&](const char* key, Words name, const char* symbol, QuantityKind kind, double value,
                         double numeric, bool in_file = true) {
        values.push_back({key, std::move(name), symbol, kind, value, numeric, in_file});
    };
    const std::array<Words, 2> ends = ends_of(problem.kind);
    const auto at_end = [&](std::size_t end, Key key) { return Words(key, ends.at(end)); };
    add("pressure 1", at_end(0, lang::reye::pressure), "p_1", pressure, found.first, check.first, false);
    add("pressure 2", at_end(1, lang::reye::pressure), "p_2", pressure, found.second, check.second, false);
    if (problem.kind == Kind::shoe)
        add("greatest pressure", {lang::common::greatest_pressure}, "p_max", pressure, found.greatest, check.greatest);
    if (problem.kind == Kind::pad && found.m)
        add("m", {lang::reye::relative_gain_in_pressure_from_end}, "m", dimensionless, found.m->to_double(),
            check.second / check.first - 1);
    if (found.resultant)
        add("resultant at", {lang::reye::place_x_of_the_resultant}, "x_R", length, found.resultant->to_double(),
            check.resultant);
    if (found.lifts) {
        add("contact from", {lang::reye::contact_from}, "x_1", length, found.begin, check.begin);
        add("contact to", {lang::reye::contact_to}, "x_2", length, found.end, check.end);
    }
    if (found.friction_force)
        add("friction force", {lang::reye::friction_force}, "T", force, *found.friction_force, check.friction);
    if (found.torque)
        add("torque",
            problem.kind == Kind::disc ? Words(lang::reye::torque_when_worn_in_reye)
                                       : Words(lang::reye::torque_on_the_drum),
            "M", moment, *found.torque, check.torque);
    if (found.uniform_torque) {
        add("uniform pressure", {lang::reye::pressure_when_new_uniform}, "p_u", pressure, *found.uniform_pressure,
            check.uniform_pressure);
        add("torque at uniform pressure", {lang::reye::torque_when_new_at_uniform_pressure}, "M_u", moment,
            *found.uniform_torque, check.uniform_torque);
    }
    if (problem.kind == Kind::shoe) {
        add("normal force", {lang::reye::resultant_of_the_pressures}, "N", force,
            nearest::hypot(found.normal_force.x, found.normal_force.y), check.normal);
        add("centre of pressure", {lang::reye::distance_of_the_centre_of_pressure}, "r_C", length,
            found.pressure_radius, check.pressure_radius);
        if (problem.leading && found.locking_friction)
            add("locking friction", {lang::reye::friction_from_which_the_shoe_locks}, "f_lim", dimensionless,
                *found.locking_friction, check.locking);
    }
    if (found.worn) {
        add("worn 1", at_end(0, lang::reye::depth_worn_off), "h_1", length, (*found.worn)[0], check.worn[0], false);
        add("worn 2", at_end(1, lang::reye::depth_worn_off), "h_2", length, (*found.worn)[1], check.worn[1], false);
    }
    return values;
}

}  // namespace

Result<ProblemSolution> solve_reye(const ReyeProblem& problem) {
    Wear wear(problem);
    const bool locks = wear.locks();
    ReyeSolution found = std::move(wear).solution();
    if (locks)
        return tl::unexpected(Errors{{ErrorCode::no_unique_answer,
                                      problem.where,
                                      {lang::reye::this_shoe_locks_itself, std::to_string(*found.locking_friction)}}});
    ProblemSolution solution;
    solution.subject = {lang::reye::wear_by_reye_hypothesis_pressures};
    solution.values = values_of(problem, found, check_reye(problem));
    if (auto why = why_no_numbers(solution.values, problem.where)) return tl::unexpected(*std::move(why));
    if (found.lifts) solution.remarks.emplace_back(lang::reye::the_force_lies_outside_the_middle);
    solution.of = std::move(found);
    return solution;
}

}  // namespace kinegraph
