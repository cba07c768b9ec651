#include "constructions/workings/telling.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph::workings {

void Telling::tell(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor, double value,
                   const Unit& unit) {
    auto& workings = message(statement).workings;
    const auto same = [&](const Working& each) { return each.of == of; };
    if (std::any_of(workings.begin(), workings.end(), same)) return;
    double product = 1;
    for (const Working::Factor& each : factors) product *= each.squared ? each.value * each.value : each.value;
    if (divisor) product /= *divisor;
    constexpr double rounding = 1e-9;
    if (!(std::abs(product - value) <= rounding * std::abs(value))) factors.clear();
    if (factors.empty()) divisor.reset();
    workings.push_back({std::move(of), std::move(factors), divisor, {value, unit.symbol}});
}

double Telling::spin(BodyIndex body, Symbol::Letter letter) const {
    if (body == none) return 0;
    const BodyMotion& motion = solution_.bodies[at_index(body)];
    const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
    return value ? value->to_double() : 0;
}

}  // namespace kinegraph::workings
