#include "engine/number/functions.hpp"
#include "problems/reye/reye.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace kinegraph {
namespace {

using std::numbers::pi;
using Kind = ReyeProblem::Kind;
using Function = std::function<double(double)>;

/// Simpson's rule.
double over(double from, double to, const Function& f) {
    constexpr int strips = 2000;
    const double h = (to - from) / strips;
    double sum = f(from) + f(to);
    for (int i = 1; i < strips; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
    return sum * h / 3;
}

class CheckOfWear {
public:
    explicit CheckOfWear(const ReyeProblem& problem) : problem_(problem), force_(problem.force.to_double()) {
        if (problem.friction) friction_ = problem.friction->to_double();
        Function way = [](double) { return 1.0; };
        if (problem.kind == Kind::disc) {
            check_disc();
            way = [](double r) { return r; };
        } else if (problem.kind == Kind::shoe) {
            check_shoe();
            way = [r = problem.radius.to_double()](double) { return r; };
        } else {
            check_pad();
        }
        if (!problem.wear) return;
        const double turned = problem.wear->to_double() * problem.speed->to_double() * problem.time->to_double();
        const bool ring = problem.kind == Kind::disc;
        found_.worn = {turned * found_.first * way(ring ? problem.inner.to_double() : 0),
                       turned * found_.second * way(ring ? problem.outer.to_double() : 0)};
    }
    const ReyeCheck& found() const { return found_; }

private:
    /// p = max(0, s (x − z)) for a tilt about x = z, or uniform: finds z such that the resultant lies under the force.
    void check_pad() {
        const double a = problem_.length.to_double(), b = problem_.width.to_double();
        const double wanted = problem_.kind == Kind::block ? a / 2 : problem_.offset.to_double();
        // Tilt from −∞ (the end x = a wears more) to +∞: parametrised by an angle t instead of the slope.
        const auto pressure = [&](double t, double x) {
            return std::max(0.0, nearest::cos(t) + nearest::sin(t) * (2 * x / a - 1));
        };
        // Where the face lifts, the strips of Simpson's rule end at the edge of contact.
        const auto ends = [&](double t) {
            const double zero = a / 2 * (1 - nearest::cos(t) / (nearest::sin(t) == 0 ? 1e-300 : nearest::sin(t)));
            double begin = 0, end = a;
            if (zero > 0 && zero < a) (nearest::sin(t) > 0 ? begin : end) = zero;
            return std::pair{begin, end};
        };
        const auto moment_arm = [&](double t) {
            const auto [begin, end] = ends(t);
            const double sum = over(begin, end, [&](double x) { return pressure(t, x); });
            return over(begin, end, [&](double x) { return x * pressure(t, x); }) / sum;
        };
        double low = -0.75 * pi, high = 0.75 * pi;  // excludes tilts without contact
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (moment_arm(middle) < wanted ? low : high) = middle;
        }
        const double t = 0.5 * (low + high);
        const auto [begin, end] = ends(t);
        const double scale = force_ / (b * over(begin, end, [&](double x) { return pressure(t, x); }));
        found_.first = scale * pressure(t, 0);
        found_.second = scale * pressure(t, a);
        // Below the rule's rounding error the edge of contact is the end of the face.
        found_.resultant = moment_arm(t);
        found_.begin = begin;
        found_.end = end;
        found_.greatest = std::max(found_.first, found_.second);
        found_.friction = friction_ * b * scale * over(begin, end, [&](double x) { return pressure(t, x); });
    }

    void check_disc() {
        const double inner = problem_.inner.to_double(), outer = problem_.outer.to_double();
        // Uniform depth: pressure × sliding is constant, p = 1/r up to a factor.
        const auto torque = [&](const Function& p, double& scale) {
            scale = force_ / over(inner, outer, [&](double r) { return 2 * pi * r * p(r); });
            return problem_.surfaces * friction_ * scale *
                   over(inner, outer, [&](double r) { return 2 * pi * r * r * p(r); });
        };
        double scale = 0;
        found_.torque = torque([](double r) { return 1 / r; }, scale);
        found_.first = scale / inner;
        found_.second = scale / outer;
        found_.uniform_torque = torque([](double) { return 1.0; }, found_.uniform_pressure);
    }

    /// Forces on the shoe, strip by strip, about its pivot at (h, 0); the drum's centre is the origin.
    void check_shoe() {
        const double r = problem_.radius.to_double(), h = problem_.pivot.to_double(), b = problem_.width.to_double();
        const double from = problem_.from.to_double(), to = problem_.to.to_double();
        const double outward = problem_.inside ? -1 : 1;
        // The depth worn at θ for a unit rotation of the shoe about the pivot: the displacement of its point along the
        // normal.
        const auto depth = [&](double angle) {
            const double x = r * nearest::cos(angle) - h, y = r * nearest::sin(angle);
            return std::abs(-y * nearest::cos(angle) + x * nearest::sin(angle));
        };
        const auto moment = [&](double angle, double along, double across) {
            const double fx = along * nearest::cos(angle) - across * nearest::sin(angle),
                         fy = along * nearest::sin(angle) + across * nearest::cos(angle);
            return (r * nearest::cos(angle) - h) * fy - r * nearest::sin(angle) * fx;
        };
        const double normal = over(from, to, [&](double t) { return b * r * depth(t) * moment(t, outward, 0); });
        // Friction for one sense of rotation of the drum; leading where it turns the shoe against the normal forces.
        const double rubbing =
            over(from, to, [&](double t) { return b * r * depth(t) * moment(t, 0, normal > 0 ? -1 : 1); });
        const double sense = problem_.leading ? 1 : -1;
        const double scale =
            force_ * problem_.arm.to_double() /
            (std::abs(normal) - sense * friction_ * std::abs(rubbing) * (rubbing * normal < 0 ? 1 : -1));
        found_.first = scale * depth(from);
        found_.second = scale * depth(to);
        for (int i = 0; i <= 4000; ++i)
            found_.greatest = std::max(found_.greatest, scale * depth(from + (to - from) * i / 4000));
        found_.torque = friction_ * r * scale * over(from, to, [&](double t) { return b * r * depth(t); });
        const double x = scale * over(from, to, [&](double t) { return b * r * depth(t) * nearest::cos(t); });
        const double y = scale * over(from, to, [&](double t) { return b * r * depth(t) * nearest::sin(t); });
        found_.normal = std::sqrt(x * x + y * y);
        found_.pressure_radius = found_.torque / (friction_ * found_.normal);
        found_.locking = std::abs(normal / rubbing);
    }

    const ReyeProblem& problem_;
    double force_, friction_ = 0;
    ReyeCheck found_;
};

}  // namespace

ReyeCheck check_reye(const ReyeProblem& problem) { return CheckOfWear(problem).found(); }

}  // namespace kinegraph
