#include "constructions/positions/followed_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

constexpr double half_turn = std::numbers::pi;

/// A multiple of `unit`, so that functions with nearly the same root are evaluated in the same places.
double rounded_to(double value, double unit) { return unit * std::round(value / unit); }
std::size_t at_step(int k) { return static_cast<std::size_t>(k); }
int sign_of_value(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// A polynomial through values at 0, 1, 2, … (Newton's form).
class ThroughSteps {
public:
    explicit ThroughSteps(std::vector<double> values) : c_(std::move(values)) {
        for (std::size_t k = 1; k < c_.size(); ++k)
            for (std::size_t i = c_.size() - 1; i >= k; --i) c_[i] = (c_[i] - c_[i - 1]) / static_cast<double>(k);
    }
    /// Its value and derivative.
    std::pair<double, double> at(double u) const {
        double p = 0, d = 0;
        for (std::size_t i = c_.size(); i-- > 0;) {
            const double away = u - static_cast<double>(i);
            d = d * away + p;
            p = p * away + c_[i];
        }
        return {p, d};
    }

private:
    std::vector<double> c_;
};

/// The value at x of the polynomial through a few points.
double through_points(const std::vector<std::pair<double, double>>& points, double x) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double term = points[i].second;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (k != i) term *= (x - points[k].first) / (points[i].first - points[k].first);
        sum += term;
    }
    return sum;
}

/// A root between two values of different signs, within 1e-14, by bisection. A place without a value ends the search.
double root_by_bisection(const std::function<std::optional<double>(double)>& g, double a, double b, bool rises) {
    constexpr double enough = 1e-14;
    while (std::abs(b - a) > enough) {
        const double t = (a + b) / 2;
        const auto here = g(t);
        if (!here || *here == 0) return t;
        ((*here > 0) == rises ? b : a) = t;
    }
    return (a + b) / 2;
}

/// The root of a smooth function between two values of different signs, from a polynomial through eight values round
/// it, none of them near: exactly on a zero or a pole a mechanism is special, and a position costly. Done again with
/// half the step until the root stays.
double smooth_root(const std::function<std::optional<double>(double)>& g, double a, double b, bool rises_here) {
    constexpr int steps = 7, most = 8;
    constexpr double same = 1e-10;
    double centre = (a + b) / 2, step = (b - a) / 4;
    std::optional<double> found;
    for (int round = 0; round < most; ++round, step /= 2) {
        std::vector<double> values;
        for (int k = 0; k <= steps; ++k) {
            const auto here = g(centre + (k - steps / 2.0) * step);
            if (!here) return root_by_bisection(g, a, b, rises_here);
            values.push_back(*here);
        }
        int change = -1;  // the change of sign nearest to the middle
        for (int k = 0; k < steps; ++k)
            if ((values[at_step(k)] > 0) != (values[at_step(k + 1)] > 0) &&
                (change < 0 || std::abs(k - steps / 2) < std::abs(change - steps / 2)))
                change = k;
        if (change < 0) return root_by_bisection(g, a, b, rises_here);
        const ThroughSteps curve(values);
        double low = change, high = change + 1;
        const bool rises = values[at_step(change + 1)] > values[at_step(change)];
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            ((curve.at(middle).first > 0) == rises ? high : low) = middle;
        }
        const double root = centre + ((low + high) / 2 - steps / 2.0) * step;
        if (found && std::abs(root - *found) < same) return root;
        found = root;
        centre = rounded_to(root, step / 16);
    }
    return root_by_bisection(g, a, b, rises_here);
}

}  // namespace

// --- the parameter

double FollowedCurve::Stretch::at(double t) const {
    const double way = to - from;
    if (starts_at_limit && ends_at_limit) {
        const double half = nearest::sin(half_turn / 2 * t);
        return t < 0.5 ? from + way * half * half : to - way * (1 - half) * (1 + half);
    }
    if (starts_at_limit) return from + way * t * t;
    if (ends_at_limit) return to - way * (1 - t) * (1 - t);
    return t == 1 ? to : from + way * t;
}

double FollowedCurve::Stretch::slope(double t) const {
    const double way = to - from;
    if (starts_at_limit && ends_at_limit) return way * half_turn / 2 * nearest::sin(half_turn * t);
    if (starts_at_limit) return 2 * way * t;
    if (ends_at_limit) return 2 * way * (1 - t);
    return way;
}

double FollowedCurve::Stretch::parameter(double place) const {
    const double share = std::clamp((place - from) / (to - from), 0.0, 1.0);
    if (starts_at_limit && ends_at_limit) return 2 / half_turn * nearest::asin(std::sqrt(share));
    if (starts_at_limit) return std::sqrt(share);
    if (ends_at_limit) return 1 - std::sqrt(1 - share);
    return share;
}

// --- samples

std::optional<FollowedCurve::Node> FollowedCurve::node(double t) const {
    auto values = evaluate_(at(t));
    if (!values) return std::nullopt;
    return Node{t, *std::move(values)};
}

std::optional<double> FollowedCurve::value(std::size_t i, double t) const {
    auto known = known_.find(t);
    if (known == known_.end()) {
        constexpr std::size_t most = 4096;
        if (known_.size() == most) known_.clear();
        known = known_.emplace(t, evaluate_(at(t))).first;
    }
    if (!known->second || !std::isfinite(known->second->values[i])) return std::nullopt;
    return known->second->values[i];
}

void FollowedCurve::sample(int intervals) {
    // At the ends there may be no answer: at a limit there is none, elsewhere only by chance. Inside, no sample is at a
    // round part of the stretch, where positions are often special.
    constexpr double beside_limit = 1e-3, beside = 1e-9, odd = 0.381966;
    std::vector<Node> base;
    const auto add = [&](double t, double instead) {
        auto found = node(t);
        if (!found) found = node(instead);
        if (found) base.push_back(*std::move(found));
    };
    add(stretch_.starts_at_limit ? beside_limit : 0, stretch_.starts_at_limit ? 2 * beside_limit : beside);
    for (int k = 0; k < intervals; ++k) {
        const double t = (k + odd) / intervals;
        add(t, t + 1e-3 / intervals);
    }
    add(stretch_.ends_at_limit ? 1 - beside_limit : 1, stretch_.ends_at_limit ? 1 - 2 * beside_limit : 1 - beside);
    nodes_.clear();
    if (base.empty()) return;
    usual_.clear();
    for (std::size_t i = 0; i < base.front().at.values.size(); ++i) {
        std::vector<double> sizes;
        for (const Node& each : base) sizes.push_back(std::abs(each.at.values[i]));
        std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
        usual_.push_back(sizes[sizes.size() / 2]);
    }
    // A function that is not smooth at all would ask for samples without end.
    constexpr int depth = 12, most_for_each = 16;
    left_ = most_for_each * intervals;
    nodes_.push_back(base.front());
    for (std::size_t k = 1; k < base.size(); ++k) refine(base[k], k + 1 < base.size() ? &base[k + 1] : nullptr, depth);
}

/// Adds the samples from the last one to `b`.
void FollowedCurve::refine(const Node& b, const Node* beyond, int depth) {
    const auto middle = node((nodes_.back().t + b.t) / 2);
    if (middle && depth > 0 && --left_ > 0 && !is_resolved(*middle, b, beyond)) {
        refine(*middle, &b, depth - 1);
        refine(b, beyond, depth - 1);
        return;
    }
    if (middle) nodes_.push_back(*middle);
    nodes_.push_back(b);
}

/// Whether a cubic through the samples around predicts each function in the middle; near a pole, its reciprocal.
bool FollowedCurve::is_resolved(const Node& middle, const Node& b, const Node* beyond) const {
    constexpr double share = 1e-5, comparable = 1e-2;
    const Node& a = nodes_.back();
    const Node* before = nodes_.size() > 1 ? &nodes_[nodes_.size() - 2] : nullptr;
    const auto predicted = [&](auto value) {
        std::vector<std::pair<double, double>> points;
        for (const Node* each : {before, &a, &b, beyond})
            if (each != nullptr) points.emplace_back(each->t, value(*each));
        return through_points(points, middle.t);
    };
    for (std::size_t i = 0; i < middle.at.values.size(); ++i) {
        const double fa = std::abs(a.at.values[i]), fb = std::abs(b.at.values[i]), here = middle.at.values[i];
        // Samples are not spent on what is a millionth of its kind: near special positions that is noise.
        constexpr double grains = 0x1p13;
        const double grain = grains * std::max({a.at.grain(i), middle.at.grain(i), b.at.grain(i)});
        const double most = std::max({fa, fb, std::abs(here)});
        const double off = predicted([&](const Node& each) { return each.at.values[i]; }) - here;
        if (std::abs(off) <= std::max(share * std::max(most, usual_[i]), grain)) continue;
        if (here == 0 || std::min(fa, fb) < comparable * most) return false;
        const double off_inverse = predicted([&](const Node& each) { return 1 / each.at.values[i]; }) - 1 / here;
        if (!(std::abs(off_inverse) <= share * std::max(1 / fa, 1 / fb))) return false;
    }
    return true;
}

// --- zeros and poles

/// A straight zero: the function keeps its sense through it, as it does not through a pole.
bool FollowedCurve::is_plain_zero(std::size_t i, std::size_t a, std::size_t b) const {
    if (a == 0 || b + 1 >= nodes_.size()) return false;
    const double rise = y(b, i) - y(a, i);
    return (y(a, i) - y(a - 1, i)) * rise > 0 && (y(b + 1, i) - y(b, i)) * rise > 0;
}

/// Whether the function grows at least as 1/x towards a pole, from both sides, so that it is no noise.
bool FollowedCurve::grows_towards(std::size_t i, double pole, double reach) const {
    constexpr double closer = 8, least = 4;  // 1/x grows by 8; half of it may be another term's
    for (const int side : {-1, 1}) {
        double last = 0;
        for (const double away : {reach, reach / closer, reach / closer / closer}) {
            const auto here = value(i, rounded_to(pole + side * away, away / 64));
            if (!here || std::abs(*here) < least * last) return false;
            last = std::abs(*here);
        }
        if (last == 0) return false;
    }
    return true;
}

/// Bisection tells which it is: towards a zero the values at both ends shrink, towards a pole they grow, at a jump they
/// stay. The reciprocal of a pole is a zero.
std::optional<FollowedCurve::Crossing> FollowedCurve::crossing_in(std::size_t i, Bracket at) const {
    const double before = at.fa, after = at.fb;
    const auto crossing = [&](double t, bool is_pole) {
        return Crossing{t, is_pole, false, sign_of_value(before), sign_of_value(after)};
    };
    double apart = std::abs(at.fa - at.fb);
    const double reach = (at.b - at.a) / 4;
    for (int turn = 0; turn < 12; ++turn) {
        for (int k = 0; k < 4; ++k) {
            double t = (at.a + at.b) / 2;
            auto here = value(i, t);
            // Only at a pole there is no value between two values. The middle may be one by chance.
            constexpr double odd = 0.381966;
            if (!here && at.b - at.a >= 1e-9) here = value(i, t = at.a + odd * (at.b - at.a));
            if (!here)
                return std::abs(at.b - at.a) < 1e-9 && grows_towards(i, t, reach) ? std::optional(crossing(t, true))
                                                                                  : std::nullopt;
            if (*here == 0) return crossing(t, false);
            if ((*here > 0) == (at.fa > 0))
                at.a = t, at.fa = *here;
            else
                at.b = t, at.fb = *here;
        }
        const double now = std::abs(at.fa - at.fb);
        const Function f = [&](double t) { return value(i, t); };
        if (now < 0.5 * apart) return crossing(smooth_root(f, at.a, at.b, at.fb > at.fa), false);
        const Function inverse = [&](double t) {
            const auto here = value(i, t);
            return here && *here != 0 ? std::optional(1 / *here) : std::nullopt;
        };
        if (now > 2 * apart) {
            const double pole = smooth_root(inverse, at.a, at.b, at.fb > at.fa);
            return grows_towards(i, pole, reach) ? std::optional(crossing(pole, true)) : std::nullopt;
        }
        apart = now;
    }
    return std::nullopt;
}

std::vector<FollowedCurve::Crossing> FollowedCurve::crossings(std::size_t i, bool poles_only) const {
    std::vector<Crossing> found;
    std::optional<std::size_t> last;  // the last sample that is not zero
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        if (y(k, i) == 0) continue;
        if (last && (y(*last, i) > 0) != (y(k, i) > 0) && k - *last <= 2 && !(poles_only && is_plain_zero(i, *last, k)))
            if (const auto crossing = crossing_in(i, {nodes_[*last].t, y(*last, i), nodes_[k].t, y(k, i)}))
                found.push_back(*crossing);
        last = k;
    }
    add_touching(i, found);
    add_at_ends(i, found);
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return found;
}

std::vector<FollowedCurve::Crossing> FollowedCurve::poles_at_limits(std::size_t i) const {
    std::vector<Crossing> found;
    add_at_ends(i, found);
    std::erase_if(found, [&](const Crossing& each) {
        return !each.is_pole || !(each.t == 0 ? stretch_.starts_at_limit : stretch_.ends_at_limit);
    });
    return found;
}

/// Those that keep the sign: an extreme of the function, or of its reciprocal, that is zero.
void FollowedCurve::add_touching(std::size_t i, std::vector<Crossing>& found) const {
    constexpr double small = 1e-9, likely = 0.1;
    for (std::size_t k = 1; k + 1 < nodes_.size(); ++k) {
        const double here = std::abs(y(k, i)), before = std::abs(y(k - 1, i)), after = std::abs(y(k + 1, i));
        const int sign = sign_of_value(y(k - 1, i));
        if (sign == 0 || sign != sign_of_value(y(k + 1, i))) continue;
        if (here != 0 && sign != sign_of_value(y(k, i))) continue;
        const bool is_pole = here > before && here > after;
        if (!is_pole && !(here < before && here < after)) continue;
        const Function f = [&](double t) -> std::optional<double> {
            const auto value_there = value(i, t);
            if (!value_there || !is_pole) return value_there;
            return *value_there == 0 ? std::nullopt : std::optional(1 / *value_there);
        };
        // A parabola says whether it comes near zero at all.
        const auto g = [&](double size) { return is_pole ? 1 / size : size; };
        const double bend = g(before) - 2 * g(here) + g(after), slope = (g(after) - g(before)) / 2;
        if (bend <= 0 || g(here) - slope * slope / (2 * bend) > likely * std::max(g(before), g(after))) continue;
        const auto extreme = stationary(f, k, -sign);
        if (extreme && std::abs(extreme->value) <= small * std::max(g(before), g(after)) &&
            (!is_pole || grows_towards(i, extreme->t, (nodes_[k + 1].t - nodes_[k - 1].t) / 4)))
            found.push_back({extreme->t, is_pole, false, sign, sign});
    }
}

void FollowedCurve::add_at_ends(std::size_t i, std::vector<Crossing>& found) const {
    if (nodes_.size() < 3) return;
    const auto add = [&](std::size_t end, std::size_t next, double t, bool is_limit) {
        const double here = y(end, i), inside = y(next, i);
        const int sign = sign_of_value(inside);
        if (is_limit) {
            // Twice as far from a limit in t a function that grows there as 1/√ of the way, as 1/t, has half the value;
            // one that grows as 1/t² has a quarter. The bounds lie between: 1.8 allows for what is added to it.
            const double away = std::abs(nodes_[end].t - t);
            const auto farther = value(i, std::abs(t - 2 * away)), farthest = value(i, std::abs(t - 4 * away));
            const auto grows = [](double near, double far) {
                return near * far > 0 && std::abs(near) > 1.8 * std::abs(far);
            };
            if (farther && farthest && grows(here, *farther) && grows(*farther, *farthest))
                found.push_back(
                    {t, true, std::abs(here) < 2.5 * std::abs(*farther), sign_of_value(here), sign_of_value(here)});
            return;
        }
        if (here == 0 && inside != 0) found.push_back({t, false, false, sign, sign});
        // The end itself can lie on a pole. There is no sample beyond it, so its size alone tells.
        constexpr double beyond_any_value = 1e6;
        if (std::abs(here) > beyond_any_value * std::abs(inside) && inside != 0)
            found.push_back({t, true, false, sign, sign});
    };
    add(0, 1, 0, stretch_.starts_at_limit);
    add(nodes_.size() - 1, nodes_.size() - 2, 1, stretch_.ends_at_limit);
}

// --- extremes

/// Where the derivative vanishes, of a polynomial through nine values round the sample; from values alone an extreme
/// would be known to half the digits. Done again with half the step until the place stays.
std::optional<FollowedCurve::Extreme> FollowedCurve::stationary(const Function& f, std::size_t node, int sign) const {
    constexpr int steps = 8, most = 8;
    const double first = nodes_.front().t, last = nodes_.back().t;
    double step = std::min(nodes_[node].t - nodes_[node - 1].t, nodes_[node + 1].t - nodes_[node].t) / 2;
    step = std::min(step, (last - first) / steps);
    double centre = nodes_[node].t;
    std::optional<Extreme> found;
    for (int round = 0; round < most; ++round) {
        constexpr int half = steps / 2;
        const double start = std::clamp(centre - half * step, first, last - steps * step);
        std::vector<double> values;
        for (int k = 0; k <= steps; ++k) {
            const auto here = f(start + k * step);
            if (!here) return found;
            values.push_back(sign * *here);
        }
        const auto best = std::max_element(values.begin(), values.end()) - values.begin();
        if (best == 0 || best == steps) {
            if (found) return found;
            const double moved = start + static_cast<double>(best) * step;
            if (moved <= first || moved >= last) return std::nullopt;
            centre = moved;
            continue;
        }
        const ThroughSteps curve(std::move(values));
        double low = static_cast<double>(best) - 1, high = low + 2;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (curve.at(middle).second > 0 ? low : high) = middle;
        }
        const double u = (low + high) / 2, t = start + u * step;
        const bool stays = found && std::abs(t - found->t) < 1e-10;
        found = Extreme{t, sign * curve.at(u).first};
        if (stays) break;
        centre = t;
        if (round > 0) step /= 2;
    }
    return found;
}

std::optional<FollowedCurve::Extreme> FollowedCurve::largest(std::size_t i, int sign) const {
    if (nodes_.empty()) return std::nullopt;
    Extreme best{nodes_.front().t, y(0, i)};
    double least = sign * best.value;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        least = std::min(least, sign * y(k, i));
        if (sign * y(k, i) > sign * best.value) best = {nodes_[k].t, y(k, i)};
    }
    constexpr double alike = 1e-12;
    const double rounding = alike * std::max(std::abs(best.value), std::abs(least));
    if (sign * best.value - least <= rounding) return Extreme{nodes_.front().t, y(0, i)};
    const double at_nodes = sign * best.value;
    const Function f = [&](double t) { return value(i, t); };
    std::optional<Extreme> found;
    const auto take = [&](const Extreme& each) {
        if (!found || sign * each.value > sign * found->value + rounding) found = each;
    };
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const double here = sign * y(k, i);
        if (k == 0 || k + 1 == nodes_.size()) {
            if (here >= at_nodes - rounding) take({nodes_[k].t, y(k, i)});
            continue;
        }
        const double before = sign * y(k - 1, i), after = sign * y(k + 1, i);
        if (here < before || here <= after) continue;
        // How much higher it may be between the samples: twice what the largest difference beside it says.
        if (here + 2 * std::max(here - before, here - after) < at_nodes) continue;
        take(stationary(f, k, sign).value_or(Extreme{nodes_[k].t, y(k, i)}));
    }
    return found ? found : best;
}

// --- the integral

FollowedCurve::Integrals FollowedCurve::integrals(std::size_t i) const {
    std::vector<double> values, sizes;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        values.push_back(y(k, i) * stretch_.slope(nodes_[k].t));
        sizes.push_back(std::abs(values.back()));
    }
    return {integral(values), integral(sizes)};
}

/// Of a function of t given at the samples. Each interval by the polynomial through the six samples around it.
double FollowedCurve::integral(const std::vector<double>& g) const {
    constexpr double away = 0.7745966692414834;  // √(3/5): Gauss's three points
    double sum = 0;
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
        std::vector<std::pair<double, double>> points;
        for (std::size_t n = k < 3 ? 0 : k - 3; n < std::min(k + 3, nodes_.size()); ++n)
            points.emplace_back(nodes_[n].t, g[n]);
        const double middle = (nodes_[k - 1].t + nodes_[k].t) / 2, half = (nodes_[k].t - nodes_[k - 1].t) / 2;
        sum += half *
               (5 * through_points(points, middle - half * away) + 8 * through_points(points, middle) +
                5 * through_points(points, middle + half * away)) /
               9;
    }
    // Beside a limit, where there are no samples, along the straight line through the last two.
    const auto beyond = [&](std::size_t end, std::size_t inside, double way) {
        const double slope = (g[end] - g[inside]) / std::abs(nodes_[end].t - nodes_[inside].t);
        return way * (g[end] + slope * way / 2);
    };
    if (nodes_.size() > 1)
        sum += beyond(0, 1, nodes_.front().t) + beyond(nodes_.size() - 1, nodes_.size() - 2, 1 - nodes_.back().t);
    return sum;
}

}  // namespace kinegraph
