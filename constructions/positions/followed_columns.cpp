#include "constructions/positions/followed_columns.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph {
namespace {

/// Two stretches meet in one position, whose zero or pole both have.
void add_once(std::vector<double>& places, double at, double travel) {
    constexpr double same = 1e-9;
    if (places.empty() || std::abs(places.back() - at) > same * travel) places.push_back(at);
}

/// A place of a curve; beside an end of it, or beside the drawn position, that position itself.
double place_on(const FollowedCurve& curve, double t, double travel) {
    const double at = curve.at(t);
    constexpr double rounding = 1e-12;
    for (const double special : {0.0, curve.at(0), curve.at(1)})
        if (std::abs(at - special) <= rounding * travel) return special;
    return at;
}

double travel_of_curves(const std::vector<FollowedCurve>& curves) {
    return curves.empty() ? 0 : std::abs(curves.back().at(1) - curves.front().at(0));
}

}  // namespace

FollowedColumn FollowedColumns::column(std::size_t i, bool whole) const {
    FollowedColumn found;
    found.is_followed = whole;
    const double travel = travel_of_curves(curves_);
    bool grows_up = false, grows_down = false, has_mean = true;
    double sum = 0, size = 0, way = 0;
    for (const FollowedCurve& curve : curves_) {
        for (const FollowedCurve::Crossing& each : curve.crossings(i, !whole)) {
            add_once(each.is_pole ? found.poles : found.zeros, place_on(curve, each.t, travel), travel);
            if (!each.is_pole) continue;
            has_mean = has_mean && each.is_as_root;
            grows_up = grows_up || each.before > 0 || each.after > 0;
            grows_down = grows_down || each.before < 0 || each.after < 0;
        }
        if (!whole) continue;
        for (const int sign : {-1, 1}) {
            auto& best = sign < 0 ? found.least : found.greatest;
            if (sign < 0 ? grows_down : grows_up) continue;
            const auto largest = curve.largest(i, sign);
            if (largest && (!best || sign * largest->value > sign * best->value))
                best = FollowedColumn::Extreme{place_on(curve, largest->t, travel), largest->value};
        }
        const FollowedCurve::Integrals integrals = curve.integrals(i);
        sum += integrals.value;
        size += integrals.size;
        way += curve.at(1) - curve.at(0);
    }
    if (!whole) found.zeros.clear();
    if (grows_down) found.least.reset();
    if (grows_up) found.greatest.reset();
    if (whole && way != 0 && has_mean) {
        // Where it grows at a limit, its integral up to the limit is less well known.
        const double rounding = (found.poles.empty() ? 1e-9 : 1e-7) * std::abs(size);
        found.mean = std::abs(sum) < rounding ? 0 : sum / way;
    }
    return found;
}

FollowedColumn FollowedColumns::at_limits(std::size_t i) const {
    FollowedColumn found;
    const double travel = travel_of_curves(curves_);
    for (const FollowedCurve& curve : curves_)
        for (const FollowedCurve::Crossing& each : curve.poles_at_limits(i))
            add_once(found.poles, place_on(curve, each.t, travel), travel);
    return found;
}

std::vector<std::pair<double, double>> FollowedColumns::negative(std::size_t i) const {
    std::vector<std::pair<double, double>> found;
    const double travel = travel_of_curves(curves_);
    for (const FollowedCurve& curve : curves_) {
        if (curve.nodes().empty()) continue;
        std::vector<double> ends{0};
        for (const FollowedCurve::Crossing& each : curve.crossings(i, false)) ends.push_back(each.t);
        ends.push_back(1);
        for (std::size_t k = 1; k < ends.size(); ++k) {
            if (ends[k] <= ends[k - 1]) continue;
            const auto inside = curve.value(i, (ends[k - 1] + ends[k]) / 2);
            if (!inside || *inside >= 0) continue;
            const double from = curve.at(ends[k - 1]), to = curve.at(ends[k]);
            if (!found.empty() && std::abs(found.back().second - from) <= 1e-9 * travel)
                found.back().second = to;
            else
                found.emplace_back(from, to);
        }
    }
    return found;
}

}  // namespace kinegraph
