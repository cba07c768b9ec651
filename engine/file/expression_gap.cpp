#include "engine/file/expression_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kinegraph {
namespace {

using Kind = Expression::Kind;

/// All values that an expression may take on an interval, or more; and what may be wrong there.
struct Range {
    double low = 0, high = 0;
    bool has_pole = false, leaves_domain = false;

    bool holds(double value) const { return low <= value && value <= high; }
    bool is_doubtful() const { return has_pole || leaves_domain || !std::isfinite(low) || !std::isfinite(high); }
};

Range sum(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
Range product(const Range& a, const Range& b) {
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
}

/// base^n for a whole n.
Range whole_power(const Range& base, double n) {
    if (n < 0 && base.holds(0)) return {-1, 1, true, false};
    const double first = std::pow(base.low, n), last = std::pow(base.high, n);
    Range range{std::min(first, last), std::max(first, last)};
    if (n > 0 && std::fmod(n, 2) == 0 && base.holds(0)) range.low = 0;
    return range;
}
Range power(const Range& base, const Range& exponent) {
    if (exponent.low == exponent.high && std::floor(exponent.low) == exponent.low)
        return whole_power(base, exponent.low);
    if (base.low < 0) return {-1, 1, false, true};
    if (base.low == 0 && exponent.low < 0) return {-1, 1, true, false};
    const auto [low, high] = std::minmax({std::pow(base.low, exponent.low), std::pow(base.low, exponent.high),
                                          std::pow(base.high, exponent.low), std::pow(base.high, exponent.high)});
    return {low, high};
}

/// Whether some offset + k·period, k whole, lies in it.
bool holds_any(const Range& range, double offset, double period) {
    return std::floor((range.high - offset) / period) >= std::ceil((range.low - offset) / period);
}
Range cosine(const Range& of) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto [low, high] = std::minmax({std::cos(of.low), std::cos(of.high)});
    return {holds_any(of, std::numbers::pi, turn) ? -1 : low, holds_any(of, 0, turn) ? 1 : high};
}
Range even(const Range& of, double first, double last) {
    return {of.holds(0) ? std::min({first, last, 1.0}) : std::min(first, last), std::max(first, last)};
}

Range function(Elementary which, const Range& of) {
    constexpr double quarter = std::numbers::pi / 2;
    const auto rising = [&](double (*f)(double)) { return Range{f(of.low), f(of.high)}; };
    switch (which) {
        case Elementary::sin: return cosine({of.low - quarter, of.high - quarter});
        case Elementary::cos: return cosine(of);
        case Elementary::tan:
            if (holds_any(of, quarter, std::numbers::pi)) return {-1, 1, true, false};
            return rising(std::tan);
        case Elementary::asin:
            if (of.low < -1 || of.high > 1) return {-1, 1, false, true};
            return rising(std::asin);
        case Elementary::acos:
            if (of.low < -1 || of.high > 1) return {-1, 1, false, true};
            return {std::acos(of.high), std::acos(of.low)};
        case Elementary::atan: return rising(std::atan);
        case Elementary::sinh: return rising(std::sinh);
        case Elementary::cosh: return even(of, std::cosh(of.low), std::cosh(of.high));
        case Elementary::tanh: return rising(std::tanh);
        case Elementary::exp: return rising(std::exp);
        case Elementary::log:
            if (of.low < 0) return {-1, 1, false, true};
            if (of.low == 0) return {-1, 1, true, false};
            return rising(std::log);
        case Elementary::abs:
            return {of.holds(0) ? 0 : std::min(std::abs(of.low), std::abs(of.high)),
                    std::max(std::abs(of.low), std::abs(of.high))};
    }
    return {};
}

class Search {
public:
    Search(const Expression& of, const NamedConstants& constants, double whole)
        : of_(of), constants_(constants), whole_(whole) {}

    std::optional<ExpressionGap> find(double from, double to) {
        constexpr int most = 4000;
        constexpr double fine = 1e-9;
        if (++asked_ > most) return std::nullopt;
        const Range here = range(of_, {from, to});
        if (!here.is_doubtful()) return std::nullopt;
        const double middle = from + (to - from) / 2;
        if (to - from > fine * whole_ && middle > from && middle < to) {
            // Where values are larger a pole is nearer.
            const bool left = size_at(from + (middle - from) / 2) > size_at(middle + (to - middle) / 2);
            const auto found = left ? find(from, middle) : find(middle, to);
            if (found) return found;
            return left ? find(middle, to) : find(from, middle);
        }
        if (here.has_pole) return ExpressionGap{middle, true};
        for (const double at : {from, middle, to})
            if (!std::isfinite(estimate(of_, constants_, at).value)) return ExpressionGap{at, !here.leaves_domain};
        return std::nullopt;
    }

private:
    /// Infinite where it has no value.
    double size_at(double variable) const {
        const double size = std::abs(estimate(of_, constants_, variable).value);
        return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
    }
    Range range(const Expression& of, const Range& variable) const {
        switch (of.kind) {
            case Kind::number:
            case Kind::pi:
            case Kind::constant: {
                const double value = estimate(of, constants_, 0).value;
                return {value, value};
            }
            case Kind::variable: return variable;
            case Kind::sum:
            case Kind::product: {
                Range all = range(of.parts.front(), variable);
                for (std::size_t i = 1; i < of.parts.size() && !all.is_doubtful(); ++i) {
                    const Range each = range(of.parts[i], variable);
                    if (each.is_doubtful()) return each;
                    all = of.kind == Kind::sum ? sum(all, each) : product(all, each);
                }
                return all;
            }
            case Kind::power: {
                const Range base = range(of.parts[0], variable), exponent = range(of.parts[1], variable);
                if (base.is_doubtful()) return base;
                return exponent.is_doubtful() ? exponent : power(base, exponent);
            }
            case Kind::function: {
                const Range argument = range(of.parts[0], variable);
                return argument.is_doubtful() ? argument : function(of.function, argument);
            }
        }
        return {};
    }

    const Expression& of_;
    const NamedConstants& constants_;
    double whole_;
    int asked_ = 0;
};

}  // namespace

std::optional<ExpressionGap> gap_within(const Expression& of, const NamedConstants& constants, double from, double to) {
    return Search(of, constants, to - from).find(from, to);
}

}  // namespace kinegraph
