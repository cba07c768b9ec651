#include "app/library/row_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kinegraph::app {
namespace {

/// By bisection.
double end_of_answers(double inside, double outside, const std::function<bool(double)>& has_answer) {
    constexpr double last_digits = 0x1p-48;
    const double enough = last_digits * std::max({std::abs(inside), std::abs(outside), std::abs(outside - inside)});
    while (std::abs(outside - inside) > enough) {
        const double middle = (inside + outside) / 2;
        (has_answer(middle) ? inside : outside) = middle;
    }
    return (inside + outside) / 2;
}

/// The nodes of a curve, and the samples that lead on to its ends: there the functions vary as the root of the
/// distance, and the parameter is that root.
std::vector<FollowedCurve::Node> nodes_of(const std::vector<SampledRow>& rows, std::size_t first, std::size_t end,
                                          const FollowedCurve::Stretch& stretch,
                                          const FollowedCurve::Evaluate& evaluate) {
    constexpr double closest = 1e-3;
    std::vector<FollowedCurve::Node> nodes;
    const auto add = [&](double t) {
        if (auto values = evaluate(stretch.at(t))) nodes.push_back({t, *std::move(values)});
    };
    for (std::size_t i = first; i < end; ++i) nodes.push_back({stretch.parameter(rows[i].at), rows[i].values});
    const double from = nodes.front().t, to = 1 - nodes.back().t;
    if (stretch.starts_at_limit)
        for (double t = closest; t < 0.75 * from; t *= 2) add(t);
    if (stretch.ends_at_limit)
        for (double t = closest; t < 0.75 * to; t *= 2) add(1 - t);
    std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return nodes;
}

}  // namespace

std::vector<AnswersEnd> ends_of_answers(const std::vector<double>& rows, const std::vector<double>& without,
                                        const std::function<bool(double)>& has_answer, std::size_t most) {
    std::vector<std::pair<double, bool>> all;
    for (const double each : rows) all.emplace_back(each, true);
    for (const double each : without) all.emplace_back(each, false);
    std::sort(all.begin(), all.end());
    std::vector<AnswersEnd> ends;
    for (std::size_t i = 1; i < all.size() && ends.size() < most; ++i) {
        if (all[i - 1].second == all[i].second) continue;
        const auto [inside, outside] =
            all[i].second ? std::pair(all[i].first, all[i - 1].first) : std::pair(all[i - 1].first, all[i].first);
        ends.push_back({inside, end_of_answers(inside, outside, has_answer)});
    }
    return ends;
}

std::vector<FollowedCurve> curves_through(const std::vector<SampledRow>& rows, const std::vector<double>& gaps,
                                          const std::vector<AnswersEnd>& ends,
                                          const FollowedCurve::Evaluate& evaluate) {
    const auto have_gap = [&](double from, double to) {
        return std::any_of(gaps.begin(), gaps.end(),
                           [&](double each) { return (each > from && each < to) || (each < from && each > to); });
    };
    // The edge beside a row on the side away from another.
    const auto edge_beside = [&](double row, double away_from) -> std::optional<double> {
        for (const AnswersEnd& each : ends)
            if (each.row == row && (each.edge > row) == (row > away_from)) return each.edge;
        return std::nullopt;
    };
    std::vector<FollowedCurve> curves;
    for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
        for (end = first + 1; end < rows.size() && !have_gap(rows[end - 1].at, rows[end].at);) ++end;
        if (end - first < 3) continue;
        const double from = rows[first].at, to = rows[end - 1].at;
        const auto before = edge_beside(from, to), after = edge_beside(to, from);
        const FollowedCurve::Stretch stretch{before.value_or(from), after.value_or(to), before.has_value(),
                                             after.has_value()};
        curves.emplace_back(stretch, evaluate);
        curves.back().take(nodes_of(rows, first, end, stretch, evaluate));
    }
    return curves;
}

}  // namespace kinegraph::app
