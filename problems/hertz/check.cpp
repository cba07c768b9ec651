#include "engine/number/functions.hpp"
#include "problems/hertz/hertz.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace kinegraph {
namespace {

using std::numbers::pi;

/// ∫₀^∞ f(s) ds for f that decays like a power at both ends: the trapezoidal rule on s = exp w.
template <class Function>
double over_all(Function f) {
    constexpr double step = 0.2, ends = 90;
    double sum = 0;
    for (double w = -ends; w <= ends; w += step) sum += f(nearest::exp(w)) * nearest::exp(w);
    return step * sum;
}
/// Gaussian quadrature with 48 nodes, from one end to the other.
struct Gauss {
    Gauss() {
        constexpr int n = size;
        Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
        for (int i = 1; i < n; ++i) jacobi(i, i - 1) = jacobi(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jacobi);
        nodes = eigen.eigenvalues();
        weights = 2 * eigen.eigenvectors().row(0).transpose().array().square().matrix();
    }
    template <class Function>
    double between(double from, double to, Function f) const {
        double sum = 0;
        for (int i = 0; i < size; ++i) sum += weights(i) * f(0.5 * (from + to) + 0.5 * (to - from) * nodes(i));
        return 0.5 * (to - from) * sum;
    }
    static constexpr int size = 48;
    Eigen::VectorXd nodes, weights;
};
const Gauss& gauss() {
    static const Gauss rule;
    return rule;
}

/// The maximum of a unimodal function, by golden-section search, and its position.
template <class Function>
std::pair<double, double> summit(double from, double to, Function f) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double left = to - golden * (to - from), right = from + golden * (to - from);
    double at_left = f(left), at_right = f(right);
    for (int i = 0; i < 42; ++i) {
        if (at_left < at_right) {
            from = left, left = right, at_left = at_right;
            right = from + golden * (to - from), at_right = f(right);
        } else {
            to = right, right = left, at_right = at_left;
            left = to - golden * (to - from), at_left = f(left);
        }
    }
    return {0.5 * (from + to), f(0.5 * (from + to))};
}

class CheckOfContact {
public:
    explicit CheckOfContact(const HertzProblem& problem) : problem_(problem), load_(problem.force.to_double()) {
        double compliance = 0;
        for (const HertzBody& body : problem.bodies) {
            const double nu = body.poisson.to_double();
            compliance += (1 - nu * nu) / body.young.to_double();
        }
        found_.modulus = 1 / compliance;
        if (!(load_ > 0)) return;  // lost in doubles beside far larger forces: there is no width to integrate over
        if (problem.line)
            solve_line();
        else
            solve_point();
    }
    const HertzCheck& found() const { return found_; }

private:
    /// Second derivatives of the gap as a matrix; its eigenvalues are 2A and 2B.
    Eigen::Vector2d gap() const {
        Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
        for (std::size_t i = 0; i < 2; ++i) {
            const Eigen::Matrix2d turn = Eigen::Rotation2Dd(i == 0 ? 0 : problem_.turn.to_double()).toRotationMatrix();
            const Eigen::Vector2d curvatures(problem_.bodies[i].curvature(0).to_double(),
                                             problem_.bodies[i].curvature(1).to_double());
            hessian += turn * curvatures.asDiagonal() * turn.transpose();
        }
        return 0.5 * Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian).eigenvalues();
    }

    void solve_point() {
        const Eigen::Vector2d curvature = gap();
        found_.radius = 0.5 / std::sqrt(curvature(0) * curvature(1));
        // Timoshenko and Goodier, Theory of Elasticity, art. 141; lengths over a.
        const auto denominator = [](double k, double s) { return std::sqrt((1 + s) * (k * k + s) * s); };
        const auto along = [&](double k) {
            return over_all([&](double s) { return 1 / ((1 + s) * denominator(k, s)); });
        };
        const auto across = [&](double k) {
            return over_all([&](double s) { return 1 / ((k * k + s) * denominator(k, s)); });
        };
        const double ratio = curvature(0) / curvature(1);
        double low = -14, high = 0;
        for (int i = 0; i < 60 && ratio < 1 - 1e-12; ++i) {
            const double middle = 0.5 * (low + high), k = nearest::exp(middle);
            (along(k) / across(k) < ratio ? low : high) = middle;
        }
        const double k = ratio < 1 - 1e-12 ? nearest::exp(0.5 * (low + high)) : 1;
        const double c = 3 * load_ / (4 * pi * found_.modulus);
        found_.a = nearest::cbrt(c * along(k) / curvature(0));
        found_.b = k * found_.a;
        found_.approach = c * over_all([&](double s) { return 1 / denominator(k, s); }) / found_.a;
        found_.greatest = load_ / (found_.a * found_.b * volume_of_unit_pressure());
        found_.mean = load_ / (pi * found_.a * found_.b);
        find_shear([&](double nu, double z) { return shear_below_point(nu, z); });
    }
    /// Volume of the semi-ellipsoid on the unit circle, by quadrature over its radius r = sin u.
    static double volume_of_unit_pressure() {
        return gauss().between(0, pi / 2,
                               [](double u) { return 2 * pi * nearest::sin(u) * nearest::cos(u) * nearest::cos(u); });
    }

    /// ∫ q(t)/(x − t) dt = πx on −1 … 1 with q = g √(1 − t²): g at the nodes of Chebyshev's second kind, the equation
    /// at those of the first. Then p = (E* b/2R) q.
    void solve_line() {
        constexpr int n = 41;
        Eigen::MatrixXd system(n + 1, n);
        Eigen::VectorXd right(n + 1);
        for (int r = 0; r <= n; ++r) {
            const double x = nearest::cos((2 * r + 1) * pi / (2 * (n + 1)));
            right(r) = pi * x;
            for (int k = 0; k < n; ++k) {
                const double angle = (k + 1) * pi / (n + 1), sine = nearest::sin(angle);
                system(r, k) = pi / (n + 1) * sine * sine / (x - nearest::cos(angle));
            }
        }
        const Eigen::VectorXd g = system.colPivHouseholderQr().solve(right);
        double integral = 0;
        for (int k = 0; k < n; ++k) {
            const double sine = nearest::sin((k + 1) * pi / (n + 1));
            integral += pi / (n + 1) * sine * sine * g(k);
        }
        double curvature = 0;
        for (const HertzBody& body : problem_.bodies) curvature += body.curvature(0).to_double();
        const double length = problem_.length.to_double();
        found_.radius = 1 / curvature;
        found_.b = std::sqrt(2 * load_ / (length * found_.modulus * curvature * integral));
        found_.greatest = found_.modulus * found_.b * curvature / 2 * g((n - 1) / 2);
        found_.mean = load_ / (2 * found_.b * length);
        for (std::size_t i = 0; i < 2; ++i) found_.approach += approach_of(i, load_ / length);
        find_shear([&](double, double z) { return shear_below_line(z); });
    }

    /// Flamant: the stresses of a line force, integrated over the width; y = b sin u.
    Eigen::Vector2d plane_stresses(double z) const {
        Eigen::Vector2d stress = Eigen::Vector2d::Zero();  // across, down
        const double b = found_.b;
        const auto add = [&](double from, double to) {
            const double half = 0.5 * (to - from), middle = 0.5 * (from + to);
            for (int i = 0; i < Gauss::size; ++i) {
                const double u = middle + half * gauss().nodes(i), y = b * nearest::sin(u), r2 = y * y + z * z;
                const double force =
                    found_.greatest * nearest::cos(u) * b * nearest::cos(u) * half * gauss().weights(i);
                stress -= 2 * force * z / (pi * r2 * r2) * Eigen::Vector2d(y * y, z * z);
            }
        };
        // Finer near the closest forces, within a distance comparable to the depth.
        double inner = std::min(pi / 2, 4 * z / b);
        add(0, inner);
        for (; inner < pi / 2; inner = std::min(pi / 2, 4 * inner)) add(inner, std::min(pi / 2, 4 * inner));
        return 2 * stress;
    }
    double shear_below_line(double z) const {
        const Eigen::Vector2d stress = plane_stresses(z);
        return 0.5 * std::abs(stress(0) - stress(1));
    }
    /// The strain integrated from the contact to the datum. A round body is loaded on its opposite side by the same
    /// force, and the rim between is free (Johnson 5.6).
    double approach_of(std::size_t i, double load) const {
        const HertzBody& body = problem_.bodies[i];
        const Datum datum = datum_of(problem_, i);
        const double nu = body.poisson.to_double(), young = body.young.to_double(), d = datum.depth;
        const auto strain = [&](double z) {
            Eigen::Vector2d stress = plane_stresses(z);
            if (datum.is_axis) stress += load / pi * Eigen::Vector2d(1 / d, 1 / d - 2 / (2 * d - z));
            return ((1 - nu * nu) * stress(1) - nu * (1 + nu) * stress(0)) / young;
        };
        double sum = 0, from = 0;
        for (double to = std::min(d, found_.b / 8); from < d; from = to, to = std::min(d, 3 * to))
            sum -= gauss().between(from, to, strain);
        return sum;
    }

    /// Boussinesq: the stresses of one force on the face, integrated over the ellipse; x = a sin u cos v, y = b sin u
    /// sin v.
    double shear_below_point(double nu, double z) const {
        constexpr int around = 64;  // per quarter
        double difference = 0;
        for (int i = 0; i < Gauss::size; ++i) {
            const double u = pi / 4 * (1 + gauss().nodes(i)), s = nearest::sin(u), c = nearest::cos(u);
            for (int j = 0; j < around; ++j) {
                const double v = (j + 0.5) * pi / (2 * around), x = found_.a * s * nearest::cos(v),
                             y = found_.b * s * nearest::sin(v);
                const double force = 4 * found_.greatest * c * found_.a * found_.b * s * c *
                                     (pi / 4 * gauss().weights(i)) * (pi / (2 * around));
                const double r = std::sqrt(x * x + y * y + z * z), r3 = r * r * r, sum = r + z;
                const double across = 3 * y * y * z / (r3 * r * r) -
                                      (1 - 2 * nu) * (z / r3 - 1 / (r * sum) + (r + sum) * y * y / (r3 * sum * sum));
                difference += force / (2 * pi) * (across - 3 * z * z * z / (r3 * r * r));
            }
        }
        return 0.5 * std::abs(difference);
    }

    template <class Shear>
    void find_shear(Shear shear) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double nu = problem_.bodies[i].poisson.to_double();
            if (i == 1 && nu == problem_.bodies[0].poisson.to_double()) break;
            const auto [depth, greatest] =
                summit(0.2 * found_.b, 1.2 * found_.b, [&](double z) { return shear(nu, z); });
            if (greatest <= found_.shear * (1 + 1e-9)) continue;
            found_.shear = greatest;
            found_.depth = depth;
        }
    }

    const HertzProblem& problem_;
    double load_;
    HertzCheck found_;
};

}  // namespace

Datum datum_of(const HertzProblem& problem, std::size_t body) {
    const HertzBody &own = problem.bodies[body], &other = problem.bodies[1 - body];
    const bool is_axis = !own.radii[0].is_zero() && !own.inside[0];
    if (is_axis) return {true, own.radii[0].to_double()};
    return {false, (own.depth ? *own.depth : other.radii[0]).to_double()};
}

HertzCheck check_hertz(const HertzProblem& problem) { return CheckOfContact(problem).found(); }

}  // namespace kinegraph
