// Numbers of twice the digits of a double, by exact sums and products (Dekker 1971, Knuth 1969). For doubles whose last
// bit is to be the same on every machine; long double has other digits on each.
#pragma once

#include <cmath>
#include <utility>

namespace kinegraph::wide {

/// The sum of two doubles, of which the second is at most half a unit in the last place of the first.
struct Wide {
    double high = 0, low = 0;

    double rounded() const { return high + low; }
    Wide operator-() const { return {-high, -low}; }
};

/// a + b exactly; |a| ≥ |b| or a = 0.
inline Wide sum_of_ordered(double a, double b) {
    const double high = a + b;
    return {high, b - (high - a)};
}
/// a + b exactly.
inline Wide sum_of(double a, double b) {
    const double high = a + b, from_b = high - a;
    return {high, (a - (high - from_b)) + (b - from_b)};
}
/// a·b exactly, if neither overflows nor underflows.
inline Wide product_of(double a, double b) {
    constexpr double splitter = 0x1p27 + 1;
    const auto split = [](double x) {
        const double far = splitter * x, upper = far - (far - x);
        return std::pair(upper, x - upper);
    };
    const auto [a_upper, a_lower] = split(a);
    const auto [b_upper, b_lower] = split(b);
    const double high = a * b;
    return {high, a_lower * b_lower - (((high - a_upper * b_upper) - a_lower * b_upper) - a_upper * b_lower)};
}

inline Wide operator+(Wide a, Wide b) {
    Wide high = sum_of(a.high, b.high);
    const Wide low = sum_of(a.low, b.low);
    high = sum_of_ordered(high.high, high.low + low.high);
    return sum_of_ordered(high.high, high.low + low.low);
}
inline Wide operator+(Wide a, double b) { return a + Wide{b}; }
inline Wide operator-(Wide a, Wide b) { return a + -b; }
inline Wide operator*(Wide a, Wide b) {
    const Wide high = product_of(a.high, b.high);
    return sum_of_ordered(high.high, high.low + (a.high * b.low + a.low * b.high));
}
inline Wide operator*(Wide a, double b) { return a * Wide{b}; }
inline Wide operator/(Wide a, Wide b) {
    const double first = a.high / b.high;
    const Wide rest = a - b * first;
    const double second = rest.high / b.high;
    const double third = (rest - b * second).high / b.high;
    return sum_of_ordered(first, second) + third;
}
inline Wide operator/(Wide a, double b) {
    const double first = a.high / b;
    const Wide taken = product_of(first, b);
    return sum_of_ordered(first, ((a.high - taken.high) - taken.low + a.low) / b);
}
inline Wide halved(Wide a) { return {a.high / 2, a.low / 2}; }
inline Wide root(Wide a) {
    if (a.high <= 0) return {};
    const double near = std::sqrt(a.high);
    return sum_of_ordered(near, (a - product_of(near, near)).high / (2 * near));
}

}  // namespace kinegraph::wide
