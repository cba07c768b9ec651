#include "problems/point/point.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace kinegraph {
namespace {

using MotionForm = PointProblem::Form;
using Complex = std::complex<double>;

/// In SI.
Jet jet_of(const Expressed& law, const NamedConstants& constants, double variable) {
    const double unit = law.unit.to_double(), per = law.variable_unit.to_double();
    const Jet found = jet(law.tree, constants, variable / per);
    return {unit * found[0], unit * found[1] / per, unit * found[2] / (per * per)};
}

/// Place, velocity, acceleration.
using Motion = std::array<Complex, 3>;

class Numeric {
public:
    explicit Numeric(const PointProblem& problem) : problem_(problem) {}

    Motion at(double time) const {
        switch (problem_.form) {
            case MotionForm::cartesian: {
                const Jet x = law(0, time), y = law(1, time);
                return {Complex(x[0], y[0]), Complex(x[1], y[1]), Complex(x[2], y[2])};
            }
            case MotionForm::polar: {
                // z = r e^{iθ}, differentiated directly.
                const Jet r = law(0, time), theta = law(1, time);
                const Complex turn = std::polar(1.0, theta[0]), i(0, 1);
                const Complex first = i * theta[1], second = i * theta[2] - theta[1] * theta[1];
                return {r[0] * turn, (r[1] + r[0] * first) * turn, (r[2] + 2.0 * r[1] * first + r[0] * second) * turn};
            }
            case MotionForm::path: break;
        }
        return on_path(law(0, time));
    }
    Jet law(std::size_t i, double time) const { return jet_of(problem_.laws.at(i).law, problem_.constants, time); }

private:
    Motion on_path(const Jet& s) const {
        if (const auto* circle = std::get_if<CirclePath>(&*problem_.path)) {
            const double radius = circle->radius.to_double();
            const Complex centre(circle->centre.x.to_double(), circle->centre.y.to_double());
            const Complex turn = std::polar(radius, circle->start.to_double() + s[0] / radius), i(0, 1);
            const double first = s[1] / radius, second = s[2] / radius;
            return {centre + turn, i * first * turn, (i * second - first * first) * turn};
        }
        if (const auto* line = std::get_if<LinePath>(&*problem_.path)) {
            const Complex direction(line->direction.x.to_double(), line->direction.y.to_double());
            const Complex unit = direction / std::abs(direction);
            return {Complex(line->from.x.to_double(), line->from.y.to_double()) + s[0] * unit, s[1] * unit,
                    s[2] * unit};
        }
        return on_graph(std::get<GraphPath>(*problem_.path), s);
    }
    /// dx/ds = 1/(1 + f′²)^½, of the way s from the start: by Runge–Kutta in steps as short as the bends of the path
    /// want. Twice half a step tells the error of a step as a way along the path, which stays the same from then on.
    double x_after(const GraphPath& path, double way) const {
        const auto rate = [&](double x) {
            const double slope = jet_of(path.f.law, problem_.constants, x)[1];
            return 1 / std::sqrt(1 + slope * slope);
        };
        const auto stepped = [&](double x, double step) {
            const double a = rate(x), b = rate(x + step * a / 2), c = rate(x + step * b / 2), d = rate(x + step * c);
            return x + step * (a + 2 * b + 2 * c + d) / 6;
        };
        constexpr double longest = 1.0 / 200, shortest = 1e-22, fine = 1e-15;
        constexpr double grain = 4 * std::numeric_limits<double>::epsilon();
        double x = path.start.to_double(), done = 0, share = longest;  // shares of the way
        for (int i = 0; i < 20'000 && done < 1; ++i) {
            const bool is_last = share >= 1 - done;
            const double step = way * (is_last ? 1 - done : share);
            const double whole = stepped(x, step), halves = stepped(stepped(x, step / 2), step / 2);
            const double error = std::abs(halves - whole) / (15 * rate(halves));
            const double allowed = fine * std::abs(way) + grain * std::abs(x) / rate(x);
            if (error <= allowed || share <= shortest) {
                x = halves + (halves - whole) / 15;
                done = is_last ? 1 : done + share;
            }
            const double factor = error > 0 ? 0.9 * nearest::pow(allowed / error, 0.2) : error == 0 ? 4 : 0;
            share = std::min(longest, share * std::clamp(factor, 0.1, 4.0));
        }
        return done < 1 ? std::numeric_limits<double>::quiet_NaN() : x;
    }
    Motion on_graph(const GraphPath& path, const Jet& s) const {
        const double x = x_after(path, s[0]);
        const Jet f = jet_of(path.f.law, problem_.constants, x);
        const double way = 1 + f[1] * f[1], first = s[1] / std::sqrt(way);
        const double second = s[2] / std::sqrt(way) - f[1] * f[2] * first * first / way;
        return {Complex(x, f[0]), Complex(first, f[1] * first), Complex(second, f[2] * first * first + f[1] * second)};
    }

    const PointProblem& problem_;
};

VectorOf<double> vector_of(Complex z) { return {z.real(), z.imag()}; }

}  // namespace

PointCheck check_point_motion(const PointProblem& problem) {
    const Numeric numeric(problem);
    const double at = problem.at.to_double(), from = problem.from.to_double();
    const auto [z, v, a] = numeric.at(at);
    PointCheck check;
    check.place = vector_of(z);
    check.velocity = vector_of(v);
    check.acceleration = vector_of(a);
    check.speed = std::abs(v);
    check.acceleration_length = std::abs(a);
    // ā v = (a · v) + i (a × v)
    const Complex product = std::conj(v) * a / check.speed;
    check.along = product.real();
    check.across = std::abs(product.imag());
    check.radius = check.speed * check.speed / check.across;
    check.centre = vector_of(z + Complex(0, 1) * v * (check.speed * check.speed / (std::conj(v) * a).imag()));
    if (problem.form == MotionForm::path) {
        check.way = numeric.law(0, at)[0];
    } else {
        constexpr int halves = 1000;
        double sum = 0;
        for (int i = 0; i <= 2 * halves; ++i) {
            const double weight = i == 0 || i == 2 * halves ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * std::abs(numeric.at(from + (at - from) * i / (2 * halves))[1]);
        }
        check.way = sum * (at - from) / (6 * halves);
    }
    check.r = problem.form == MotionForm::polar ? numeric.law(0, at)[0] : std::abs(z);
    check.theta = problem.form == MotionForm::polar ? numeric.law(1, at)[0] : std::arg(z);
    const Complex back = problem.form == MotionForm::polar ? std::polar(1.0, -check.theta) : std::conj(z) / std::abs(z);
    check.polar_velocity = {(v * back).real(), (v * back).imag()};
    check.polar_acceleration = {(a * back).real(), (a * back).imag()};
    return check;
}

}  // namespace kinegraph
