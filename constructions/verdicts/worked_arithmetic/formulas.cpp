#include "constructions/verdicts/worked_arithmetic/formulas.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph::worked_arithmetic {
namespace {

constexpr double rounding = 1e-9;
const Unit per_second{"rad/s", 1};

}  // namespace

bool Telling::is_told(StatementIndex statement, const Symbol& of) {
    const auto& worked_arithmetic = message(statement).worked_arithmetic;
    return std::any_of(worked_arithmetic.begin(), worked_arithmetic.end(),
                       [&](const Working& each) { return each.of == of; });
}

void Telling::tell(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor, double value,
                   const Unit& unit) {
    if (is_told(statement, of)) return;
    double product = 1;
    for (const Working::Factor& each : factors) product *= each.squared ? each.value * each.value : each.value;
    if (divisor) product /= *divisor;
    if (!(std::abs(product - value) <= rounding * std::abs(value))) factors.clear();
    if (factors.empty()) divisor.reset();
    message(statement).worked_arithmetic.push_back({std::move(of), std::move(factors), divisor, {value, unit.symbol}});
}

void Telling::tell_also(StatementIndex statement, const Symbol& of, double value, const Unit& unit) {
    auto& worked_arithmetic = message(statement).worked_arithmetic;
    const bool is_last = !worked_arithmetic.empty() && worked_arithmetic.back().of == of &&
                         worked_arithmetic.back().result.unit != unit.symbol;
    if (is_last) worked_arithmetic.push_back({of, {}, std::nullopt, {value, unit.symbol}});
}

void Telling::tell_sum(StatementIndex statement, Symbol of, const std::vector<Product>& products, double value,
                       const Unit& unit) {
    if (is_told(statement, of)) return;
    double sum = 0, size = 0;
    for (const Product& each : products) {
        sum += each.one * each.other;
        size += std::abs(each.one * each.other);
    }
    Working working{std::move(of), {}, std::nullopt, {value, unit.symbol}};
    if (std::abs(sum - value) <= rounding * size)
        for (const Product& each : products) {
            working.factors.push_back({each.one});
            working.summands.push_back(each.other);
        }
    message(statement).worked_arithmetic.push_back(std::move(working));
}

void Telling::tell_turning(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor,
                           double value) {
    if (is_told(statement, of)) return;
    tell(statement, of, std::move(factors), divisor, value, per_second);
    const Unit& own = solution_.mechanism.units.angular_velocity;
    if (value == 0 || own.si == per_second.si) return;
    message(statement).worked_arithmetic.push_back({std::move(of), {}, std::nullopt, {in(value, own), own.symbol}});
}

void Telling::tell_given_turning(StatementIndex statement, Symbol of, double value) {
    const Unit& own = solution_.mechanism.units.angular_velocity;
    if (value == 0 || own.si == per_second.si || is_told(statement, of)) return;
    tell(statement, of, {}, std::nullopt, in(value, own), own);
    message(statement).worked_arithmetic.push_back({std::move(of), {}, std::nullopt, {value, per_second.symbol}});
}

double Telling::spin(BodyIndex body, Symbol::Letter letter) const {
    if (body == none) return 0;
    const BodyMotion& motion = solution_.bodies[at_index(body)];
    const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
    return value ? value->to_double() : 0;
}

}  // namespace kinegraph::worked_arithmetic
