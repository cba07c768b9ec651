// Gaps of an expression: places where it is not finite or not real, searched over a whole interval and not only at
// samples. Interval arithmetic and bisection (Moore, Interval Analysis): where the denominator cannot vanish on an
// interval, there is no pole.
#pragma once

#include <optional>

#include "engine/file/expression.hpp"

namespace kinegraph {

struct ExpressionGap {
    double at = 0;            ///< the variable there, within 1e-9 of the interval
    bool is_infinite = true;  ///< a pole; otherwise the argument of a root, logarithm or inverse function is outside
                              ///< its domain
};
/// A gap within [from, to]; empty where none is found. Gives up after some thousand intervals; an expression that is
/// too complicated to decide by then counts as having none.
std::optional<ExpressionGap> gap_within(const Expression& of, const NamedConstants& constants, double from, double to);

}  // namespace kinegraph
