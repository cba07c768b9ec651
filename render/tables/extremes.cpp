#include "render/tables/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph::render {
namespace {

std::vector<double> values_of(const CycleTable& table, std::size_t column) {
    std::vector<double> values;
    values.reserve(table.rows.size());
    for (const auto& row : table.rows) values.push_back(row[column]);
    return values;
}

/// The extreme near row i, refined by a parabola if the neighbouring rows lie on a smooth curve.
Extreme refined(const CycleTable& table, const std::vector<double>& y, std::size_t i) {
    const auto at = [&](std::size_t k) { return table.rows[k][table.over()]; };
    const Extreme as_it_is{at(i), y[i]};
    if (i < 2 || i + 2 >= y.size()) return as_it_is;
    const double step = at(i + 1) - at(i);
    for (std::size_t k = i - 2; k < i + 2; ++k)
        if (std::abs(at(k + 1) - at(k) - step) > 1e-6 * std::abs(step)) return as_it_is;
    const auto bend = [&](std::size_t k) { return y[k - 1] - 2 * y[k] + y[k + 1]; };
    const double here = bend(i);
    for (const double beside : {bend(i - 1), bend(i + 1)})
        if (beside * here <= 0 || std::abs(beside) < 0.5 * std::abs(here) || std::abs(beside) > 2 * std::abs(here))
            return as_it_is;
    const double off = std::clamp((y[i - 1] - y[i + 1]) / (2 * here), -0.5, 0.5);
    return {at(i) + off * step, y[i] - (y[i - 1] - y[i + 1]) * off / 4};
}

}  // namespace

std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const auto row = [&](auto found) { return static_cast<std::size_t>(found - values.begin()); };
    return {refined(table, values, row(least)), refined(table, values, row(most))};
}

const FollowedColumn* followed_of(const CycleTable& table, std::size_t column) {
    const std::vector<FollowedColumn>& all = table.followed.columns;
    return column < all.size() && all[column].is_followed ? &all[column] : nullptr;
}

bool is_unbounded(const CycleTable& table, std::size_t column, bool below) {
    const FollowedColumn* followed = followed_of(table, column);
    return followed != nullptr && !(below ? followed->least : followed->greatest);
}

std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, std::size_t column) {
    auto found = extremes_of(table, values_of(table, column));
    if (const FollowedColumn* followed = followed_of(table, column)) {
        if (followed->least) found.first = {followed->least->at, followed->least->value};
        if (followed->greatest) found.second = {followed->greatest->at, followed->greatest->value};
    }
    for (const auto& limit : table.limits) {
        if (!limit[column]) continue;
        const Extreme there{limit[table.over()].value_or(0), *limit[column]};
        if (there.value < found.first.value) found.first = there;
        if (there.value > found.second.value) found.second = there;
    }
    const double rounding = rounding_of(table, column);
    for (Extreme* each : {&found.first, &found.second})
        if (std::abs(each->value) < rounding) each->value = 0;
    return found;
}

bool is_beside_gap(const CycleTable& table, const Extreme& extreme) {
    // An extreme between two rows was found there.
    const auto place = [&](const std::vector<double>& row) { return row[table.over()]; };
    if (std::none_of(table.rows.begin(), table.rows.end(), [&](const auto& row) { return place(row) == extreme.at; }))
        return false;
    return std::any_of(table.left_out.begin(), table.left_out.end(), [&](double gap) {
        return std::none_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
            return (place(row) - gap) * (place(row) - extreme.at) < 0;  // stands between the two
        });
    });
}

std::vector<double> zeros_of(const CycleTable& table, std::size_t column) {
    if (const FollowedColumn* followed = followed_of(table, column)) return followed->zeros;
    const std::vector<double> values = values_of(table, column);
    const double rounding = rounding_of(table, column);
    const auto is_zero = [&](std::size_t i) { return std::abs(values[i]) <= rounding; };
    const auto at = [&](std::size_t i) { return table.rows[i][table.over()]; };
    const double way =
        table.rows.empty() ? 0 : std::abs(table.rows.back()[table.over()] - table.rows.front()[table.over()]);
    std::vector<double> zeros;
    // At a jump of a law, two rows have the same position; a zero of both is one zero.
    const auto add = [&](double zero) {
        const double at_place = std::abs(zero) < 1e-9 * way ? 0 : zero;
        if (zeros.empty() || zeros.back() != at_place) zeros.push_back(at_place);
    };
    const auto stays_towards = [&](std::size_t i, bool forth) {
        const auto next = [&](std::size_t k) { return forth ? k + 1 : k - 1; };
        const auto ends = [&](std::size_t k) { return forth ? k + 1 == values.size() : k == 0; };
        for (std::size_t k = i; !ends(k) && is_zero(next(k)); k = next(k))
            if (at(next(k)) != at(i)) return true;
        return false;
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_zero(i)) {
            if (!stays_towards(i, false) && !stays_towards(i, true)) add(at(i));
        } else if (i > 0 && !is_zero(i - 1) && values[i - 1] * values[i] < 0) {
            add(at(i - 1) + values[i - 1] / (values[i - 1] - values[i]) * (at(i) - at(i - 1)));
        }
    }
    return zeros;
}

double rounding_of(const CycleTable& table, std::size_t column) {
    // Noise is zero in the rows of a followed column; beside a pole the largest value says nothing of it.
    if (followed_of(table, column) != nullptr) return 0;
    double largest = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].unit != table.columns[column].unit || table.columns[i].kind == Column::Kind::turn)
            continue;
        for (const auto& row : table.rows) largest = std::max(largest, std::abs(row[i]));
    }
    constexpr double share = 1e-9;
    return share * largest;
}

bool is_constant(const CycleTable& table, std::size_t column) {
    const auto [least, most] = extremes_of(table, values_of(table, column));
    const double largest = std::max(std::abs(least.value), std::abs(most.value));
    return most.value - least.value <= std::max(1e-9 * largest, rounding_of(table, column));
}

}  // namespace kinegraph::render
