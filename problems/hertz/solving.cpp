#include "problems/hertz/hertz.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "engine/results/results.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/hertz.hpp"

namespace kinegraph {
namespace {

using boost::math::ellint_rd;
using boost::math::ellint_rf;
using std::numbers::pi;

/// Elliptic integrals in doubles, not in the machine's widest type, so that every machine has the same last digit.
/// Carlson's forms take square roots only.
constexpr boost::math::policies::policy<boost::math::policies::promote_double<false>> in_doubles;

/// The root of a function with one change of sign between two ends, by bisection to the precision of doubles.
template <class Function>
double root_between(double low, double high, Function f) {
    const bool rises = f(high) > 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        ((f(middle) > 0) == rises ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

/// (K − E)/e² and ((a/b)² E − K)/e² for an ellipse with b/a = k, without the cancellation of these differences near the
/// circle, where both tend to π/4.
struct Shape {
    double along, across;  ///< (K − E)/e², ((a/b)² E − K)/e²
    double complete;       ///< K
};
Shape shape_of(double k) {
    const double k2 = k * k;
    return {ellint_rd(0.0, k2, 1.0, in_doubles) / 3, ellint_rd(0.0, 1.0, k2, in_doubles) / 3,
            ellint_rf(0.0, k2, 1.0, in_doubles)};
}

class Contact {
public:
    explicit Contact(const HertzProblem& problem) : problem_(problem), load_(problem.force.to_double()) {
        Exact compliance;
        for (const HertzBody& body : problem.bodies) compliance += (1 - square(body.poisson)) / body.young;
        found_.modulus = (Exact(1) / compliance).to_double();
        const auto& [first, second] = problem.bodies;
        found_.curvature_sum = first.curvature(0) + second.curvature(0);
        if (problem.line)
            touch_along_line();
        else
            touch_at_point();
        find_greatest_shear();
    }
    HertzSolution solution() && { return std::move(found_); }

private:
    void touch_along_line() {
        const double l = problem_.length.to_double();
        found_.radius = (Exact(1) / found_.curvature_sum).to_double();
        found_.short_curvature = found_.curvature_sum.to_double() / 2;
        found_.b = std::sqrt(4 * load_ * found_.radius / (pi * l * found_.modulus));
        found_.greatest = 2 * load_ / (pi * found_.b * l);
        found_.mean = pi / 4 * found_.greatest;
        for (std::size_t i = 0; i < 2; ++i) found_.approach += approach_at_line(i, load_ / l);
    }
    double approach_at_line(std::size_t i, double load) const {
        const HertzBody& body = problem_.bodies[i];
        const double nu = body.poisson.to_double(), compliance = load * (1 - nu * nu) / (pi * body.young.to_double());
        const auto datum = datum_of(problem_, i);
        return compliance * (datum.is_axis ? 2 * nearest::log(4 * datum.depth / found_.b) - 1
                                           : 2 * nearest::log(2 * datum.depth / found_.b) - nu / (1 - nu));
    }

    void touch_at_point() {
        const auto& [first, second] = problem_.bodies;
        const Exact d1 = first.curvature(0) - first.curvature(1), d2 = second.curvature(0) - second.curvature(1);
        found_.elliptic = !d1.is_zero() || !d2.is_zero();
        if (!found_.elliptic) {
            found_.radius = (Exact(1) / found_.curvature_sum).to_double();
            found_.long_curvature = found_.short_curvature = found_.curvature_sum.to_double() / 2;
            found_.a = found_.b = nearest::cbrt(3 * load_ * found_.radius / (4 * found_.modulus));
            found_.approach = found_.a * found_.a / found_.radius;
        } else {
            // Two surfaces turned by θ against each other: Johnson 4.4, Euler's theorem on both surfaces.
            found_.curvature_sum += first.curvature(1) + second.curvature(1);
            const double sum = found_.curvature_sum.to_double(), twice = 2 * problem_.turn.to_double();
            const double difference = std::sqrt(std::max(0.0, square(d1).to_double() + square(d2).to_double() +
                                                                  2 * (d1 * d2).to_double() * nearest::cos(twice)));
            found_.long_curvature = (sum - difference) / 4;
            found_.short_curvature = (sum + difference) / 4;
            found_.radius = 1 / (2 * std::sqrt(found_.long_curvature * found_.short_curvature));
            touch_in_ellipse();
        }
        found_.greatest = 3 * load_ / (2 * pi * found_.a * found_.b);
        found_.mean = 2.0 / 3 * found_.greatest;
    }
    void touch_in_ellipse() {
        const double ratio = found_.long_curvature / found_.short_curvature;
        const auto excess = [&](double logarithm) {
            const Shape shape = shape_of(nearest::exp(logarithm));
            return shape.along / shape.across - ratio;
        };
        constexpr double slenderest = -14;  // ln(b/a), below the smallest ratio that the reader accepts
        const double k = excess(0) <= 0 ? 1 : nearest::exp(root_between(slenderest, 0, excess));
        const Shape shape = shape_of(k);
        // A = p₀ b (K − E)/(E* e² a²) with p₀ = 3Q/2πab:  a³ = 3Q (K − E)/(2π E* A e²).
        found_.a = nearest::cbrt(3 * load_ * shape.along / (2 * pi * found_.modulus * found_.long_curvature));
        found_.b = k * found_.a;
        found_.approach = 3 * load_ * shape.complete / (2 * pi * found_.a * found_.modulus);
    }

    /// In both bodies; closed form for a line, else where the derivative of the shear vanishes.
    void find_greatest_shear() {
        for (std::size_t i = 0; i < 2; ++i) {
            const double nu = problem_.bodies[i].poisson.to_double();
            const double z = depth_of_greatest_shear(nu);
            const double shear = hertz_stress(found_, nu, z).shear;
            if (shear <= found_.shear * (1 + 1e-12)) continue;
            found_.shear = shear;
            found_.depth = z;
            found_.sheared = i;
        }
        const double nu = problem_.bodies[found_.sheared].poisson.to_double();
        constexpr int samples = 90;
        for (int i = 0; i <= samples; ++i)
            found_.stresses.push_back(hertz_stress(found_, nu, 3 * found_.b * i / samples));
    }
    double depth_of_greatest_shear(double nu) const {
        // (1 + ζ²)^{3/2} = ζ³ + 2ζ, squared ζ⁴ + ζ² = 1: ζ² = (√5 − 1)/2.
        if (problem_.line) return found_.b * std::sqrt((std::sqrt(5.0) - 1) / 2);
        const auto slope = [&](double z) {
            const double h = 1e-4 * found_.b;
            return hertz_stress(found_, nu, z - h).shear - hertz_stress(found_, nu, z + h).shear;
        };
        return root_between(0.2 * found_.b, 1.2 * found_.b, slope);
    }

    const HertzProblem& problem_;
    double load_;
    HertzSolution found_;
};

HertzSolution::Stress stress_below_line(const HertzSolution& c, double nu, double z) {
    const double root = nearest::hypot(c.b, z), p = c.greatest / c.b;
    HertzSolution::Stress s;
    s.along_z = -p * c.b * c.b / root;
    // (b² + 2z²)/r − 2z = (r − z)²/r, which avoids cancellation at large depths.
    s.along_y = -p * (root - z) * (root - z) / root;
    s.along_x = nu * (s.along_y + s.along_z);
    return s;
}
HertzSolution::Stress stress_below_circle(const HertzSolution& c, double nu, double z) {
    const double zeta = z / c.a, over = 1 / (1 + zeta * zeta);
    const double angle = z > 0 ? nearest::atan2(c.a, z) : pi / 2;
    HertzSolution::Stress s;
    s.along_z = -c.greatest * over;
    s.along_x = s.along_y = -c.greatest * ((1 + nu) * (1 - zeta * angle) - 0.5 * over);
    return s;
}
HertzSolution::Stress stress_below_ellipse(const HertzSolution& c, double nu, double z) {
    const double k = c.b / c.a, e2 = (1 - k) * (1 + k), zeta = z / c.a;
    if (e2 < 1e-6) return stress_below_circle(c, nu, z);
    const double reach = nearest::hypot(c.a, z), t = nearest::hypot(c.b, z) / reach, in_k = 1 / (k * k);
    // F(φ, e) and F − E with tan φ = a/z.
    const double sine = c.a / reach, cosine = z / reach, delta2 = 1 - e2 * sine * sine;
    const double first = sine * ellint_rf(cosine * cosine, delta2, 1.0, in_doubles);
    const double less = e2 * sine * sine * sine / 3 * ellint_rd(cosine * cosine, delta2, 1.0, in_doubles);
    const double along = zeta * less, across = zeta * (in_k * (first - less) - first);
    const double x = -0.5 * (1 - t) + along, x_nu = 1 - in_k * t + across;
    const double y = 0.5 + 0.5 / t - in_k * t + across, y_nu = -1 + t + along;
    const double factor = 2 * c.greatest * k / e2;
    HertzSolution::Stress s;
    s.along_x = factor * (x + nu * x_nu);
    s.along_y = factor * (y + nu * y_nu);
    s.along_z = -0.5 * factor * (1 - t * t) / t;
    return s;
}

/// Assumptions of the theory that this contact violates.
std::vector<Words> remarks_on(const HertzProblem& problem, const HertzSolution& found) {
    std::vector<Words> remarks;
    double least = 0;
    for (const HertzBody& body : problem.bodies)
        for (const Exact& radius : body.radii)
            if (!radius.is_zero() && (least == 0 || radius.to_double() < least)) least = radius.to_double();
    constexpr double small = 0.1;  // relative to a radius: there the slope of the surfaces is a tenth
    if (const double widest = std::max(found.a, found.b); widest > small * least)
        remarks.emplace_back(lang::hertz::the_contact_is_not_small_beside);
    if (problem.line && problem.length.to_double() < 10 * found.b)
        remarks.emplace_back(lang::hertz::the_line_of_contact_is_not);
    return remarks;
}

std::vector<ProblemValue> values_of(const HertzProblem& problem, const HertzSolution& found, const HertzCheck& check) {
    using enum QuantityKind;
    std::vector<ProblemValue> values{
        {"effective radius", {lang::hertz::effective_radius}, "R", length, found.radius, check.radius},
        {"effective modulus", {lang::hertz::effective_modulus}, "E*", pressure, found.modulus, check.modulus},
    };
    if (problem.line) {
        values.push_back({"half width", {lang::hertz::half_width}, "b", length, found.b, check.b});
    } else if (found.elliptic) {
        values.push_back({"semi-axis a", {lang::hertz::semi_axis}, "a", length, found.a, check.a});
        values.push_back({"semi-axis b", {lang::hertz::semi_axis_b}, "b", length, found.b, check.b});
        values.push_back({"contact radius",
                          {lang::hertz::contact_radius},
                          "c",
                          length,
                          std::sqrt(found.a * found.b),
                          std::sqrt(check.a * check.b)});
    } else {
        values.push_back({"contact radius", {lang::hertz::contact_radius}, "a", length, found.a, check.a});
    }
    values.push_back({"mean pressure", {lang::hertz::mean_pressure}, "p_m", pressure, found.mean, check.mean});
    values.push_back(
        {"greatest pressure", {lang::common::greatest_pressure}, "p_0", pressure, found.greatest, check.greatest});
    values.push_back({"approach", {lang::hertz::approach}, "δ", length, found.approach, check.approach});
    values.push_back({"greatest shear", {lang::hertz::greatest_shear}, "τ_max", pressure, found.shear, check.shear});
    values.push_back(
        {"depth of greatest shear", {lang::hertz::depth_of_greatest_shear}, "z_τ", length, found.depth, check.depth});
    return values;
}

}  // namespace

HertzSolution::Stress hertz_stress(const HertzSolution& contact, double poisson, double z) {
    HertzSolution::Stress stress = contact.a == 0     ? stress_below_line(contact, poisson, z)
                                   : contact.elliptic ? stress_below_ellipse(contact, poisson, z)
                                                      : stress_below_circle(contact, poisson, z);
    stress.z = z;
    stress.shear = 0.5 * std::abs(stress.along_y - stress.along_z);
    return stress;
}

Result<ProblemSolution> solve_hertz(const HertzProblem& problem, const HertzProblem& checked) {
    ProblemSolution solution;
    HertzSolution found = Contact(problem).solution();
    solution.values = values_of(problem, found, check_hertz(checked));
    for (const ProblemValue& each : solution.values)
        if (!std::isfinite(each.value) || !std::isfinite(*each.numeric) || !(each.value > 0))
            return tl::unexpected(
                Errors{{ErrorCode::bad_input, "/hertz", {lang::hertz::these_numbers_are_too_far_apart, each.name}}});
    solution.subject = {lang::hertz::hertzian_contact_pressure_approach};
    solution.remarks = remarks_on(problem, found);
    solution.of = std::move(found);
    return solution;
}

namespace {

void hertz_results(const Solution& solution, bool /*exact*/, JsonWriter& json) {
    json.open('{', JsonWriter::Entries::on_lines);
    write_values(*solution.problem, json);
    json.close();
}

}  // namespace

const ProblemKind hertz_problem{.key = "hertz",
                                .section = &hertz_section,
                                .read = read_hertz,
                                .solve = [](const Problem& problem, const Mechanism&,
                                            const Pose&) { return solve_hertz(problem.as<HertzProblem>()); },
                                .add_at_joints = find_contacts,
                                .results = hertz_results};

}  // namespace kinegraph
