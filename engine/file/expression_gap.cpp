#include "engine/file/expression_gap.hpp"

#include <algorithm>
#include <boost/limits.hpp>
// Not the header of the whole library, which wants a processor that can round upwards and downwards.
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/compare.hpp>
#include <boost/numeric/interval/constants.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/rounded_arith.hpp>
#include <boost/numeric/interval/rounded_transc.hpp>
#include <boost/numeric/interval/transc.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <cmath>
#include <limits>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Kind = Expression::Kind;
namespace intervals = boost::numeric::interval_lib;

/// Bounds are rounded to nearest: a search that ends at 1e-9 of the interval needs no directed rounding. NaN gives the
/// empty interval, overflow an infinite bound; neither throws.
using Values =
    boost::numeric::interval<double,
                             intervals::policies<intervals::save_state_nothing<intervals::rounded_transc_exact<double>>,
                                                 intervals::checking_base<double>>>;

/// An enclosure of all values of an expression on an interval, and the possible faults there.
struct Range {
    Values values;
    bool has_pole = false, leaves_domain = false;

    bool is_doubtful() const {
        return has_pole || leaves_domain || !std::isfinite(values.lower()) || !std::isfinite(values.upper());
    }
};

Range pole() { return {Values::whole(), true, false}; }
Range outside_domain() { return {Values::whole(), false, true}; }

/// base^n for a whole n.
Range whole_power(const Values& base, double n) {
    if (n < 0 && zero_in(base)) return pole();
    const Values values = Values::hull(nearest::pow(base.lower(), n), nearest::pow(base.upper(), n));
    return {n > 0 && std::fmod(n, 2) == 0 && zero_in(base) ? hull(values, 0.0) : values};
}
/// Boost supports integer exponents only.
Range power(const Values& base, const Values& exponent) {
    if (singleton(exponent) && std::floor(exponent.lower()) == exponent.lower())
        return whole_power(base, exponent.lower());
    if (base.lower() < 0) return outside_domain();
    if (base.lower() == 0 && exponent.lower() < 0) return pole();
    return {
        hull(Values::hull(nearest::pow(base.lower(), exponent.lower()), nearest::pow(base.lower(), exponent.upper())),
             Values::hull(nearest::pow(base.upper(), exponent.lower()), nearest::pow(base.upper(), exponent.upper())))};
}

Range function(Elementary which, const Values& of) {
    switch (which) {
        case Elementary::sin: return {sin(of)};
        case Elementary::cos: return {cos(of)};
        case Elementary::tan: {
            const Values values = tan(of);
            return std::isfinite(values.upper() - values.lower()) ? Range{values} : pole();
        }
        case Elementary::asin: return subset(of, Values(-1, 1)) ? Range{asin(of)} : outside_domain();
        case Elementary::acos: return subset(of, Values(-1, 1)) ? Range{acos(of)} : outside_domain();
        case Elementary::atan: return {atan(of)};
        case Elementary::sinh: return {sinh(of)};
        case Elementary::cosh: return {cosh(of)};
        case Elementary::tanh: return {tanh(of)};
        case Elementary::exp: return {exp(of)};
        case Elementary::log:
            if (of.lower() < 0) return outside_domain();
            return of.lower() == 0 ? pole() : Range{log(of)};
        case Elementary::abs: return {abs(of)};
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
        const Range here = range(of_, {Values(from, to)});
        if (!here.is_doubtful()) return std::nullopt;
        const double middle = from + (to - from) / 2;
        if (to - from > fine * whole_ && middle > from && middle < to) {
            // A pole is nearer to the larger values.
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
    /// Infinite where it is undefined.
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
                return {Values(value)};
            }
            case Kind::variable: return variable;
            case Kind::sum:
            case Kind::product: {
                Range all = range(of.parts.front(), variable);
                for (std::size_t i = 1; i < of.parts.size() && !all.is_doubtful(); ++i) {
                    Range each = range(of.parts[i], variable);
                    if (each.is_doubtful()) return each;
                    all.values = of.kind == Kind::sum ? all.values + each.values : all.values * each.values;
                }
                return all;
            }
            case Kind::power: {
                Range base = range(of.parts[0], variable);
                const Range exponent = range(of.parts[1], variable);
                if (base.is_doubtful()) return base;
                return exponent.is_doubtful() ? exponent : power(base.values, exponent.values);
            }
            case Kind::function: {
                const Range argument = range(of.parts[0], variable);
                return argument.is_doubtful() ? argument : function(of.function, argument.values);
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
