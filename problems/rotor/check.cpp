#include "problems/rotor/rotor.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

double angle_in_doubles(const Bearing& bearing) {
    if (const auto* angle = std::get_if<Angle>(&bearing.form))
        return angle->value.to_double() * (angle->in_degrees ? std::numbers::pi / 180 : 1);
    const Vector& along = std::get<Vector>(bearing.form);
    return nearest::atan2(along.y.to_double(), along.x.to_double());
}

/// A sum of vectors, with the lengths of all.
struct Sum {
    VectorOf<double> total;
    double lengths = 0;

    void add(double factor, const VectorOf<double>& v) {
        total = total + factor * v;
        lengths += std::abs(factor) * nearest::hypot(v.x, v.y);
    }
    /// Zero where the rounding of its terms explains it.
    VectorOf<double> settled() const {
        constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
        return nearest::hypot(total.x, total.y) <= roundings * lengths ? VectorOf<double>{} : total;
    }
};

/// Forces at the places a and b that hold the pulls at their places.
struct Pull {
    VectorOf<double> force;
    double place = 0;
};
std::array<VectorOf<double>, 2> held_at(double a, double b, const std::vector<Pull>& pulls) {
    // F_a + F_b = −Σ F,  a F_a + b F_b = −Σ z F
    const double determinant = b - a;
    Sum at_a, at_b;
    for (const Pull& each : pulls) {
        at_a.add(each.place / determinant, each.force);
        at_a.add(-b / determinant, each.force);
        at_b.add(a / determinant, each.force);
        at_b.add(-each.place / determinant, each.force);
    }
    return {at_a.settled(), at_b.settled()};
}

}  // namespace

RotorCheck check_rotor(const RotorProblem& problem) {
    std::vector<Pull> pulls;
    for (const RotorMass& each : problem.masses) {
        const double angle = angle_in_doubles(each.angle), size = each.mass.to_double() * each.radius.to_double();
        pulls.push_back(
            {{size * nearest::cos(angle), size * nearest::sin(angle)}, problem.z_of(each.plane).to_double()});
    }
    const auto place = [&](std::size_t correction) {
        return problem.z_of(problem.corrections[correction].plane).to_double();
    };
    RotorCheck check;
    if (problem.is_dynamic()) {
        const auto both = held_at(place(0), place(1), pulls);
        check.corrections = {both[0], both[1]};
    } else {
        Sum force, couple;
        for (const Pull& each : pulls) {
            force.add(-1, each.force);
            couple.add(each.place, each.force);
            couple.add(-place(0), each.force);
        }
        check.corrections = {force.settled()};
        check.couple_left = couple.settled();
    }
    if (!problem.bearings) return check;
    const double square = problem.omega.to_double() * problem.omega.to_double();
    const double c = problem.planes[problem.bearings->at(0)].z.to_double(),
                 d = problem.planes[problem.bearings->at(1)].z.to_double();
    for (const VectorOf<double>& each : held_at(c, d, pulls)) check.reactions.push_back(square * each);
    check.reaction_left = square * nearest::hypot(check.couple_left.x, check.couple_left.y) / std::abs(d - c);
    return check;
}

}  // namespace kinegraph
