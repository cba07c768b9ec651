// Gaps of an expression: where it is not finite or not real, sought over a whole interval and not only where it is
// evaluated. Interval arithmetic and bisection (Moore, Interval Analysis): what cannot vanish on an interval has no
// pole there.
#pragma once

#include <optional>

#include "engine/file/expression.hpp"

namespace kinegraph {

struct ExpressionGap {
    double at = 0;            ///< the variable there, within 1e-9 of the interval
    bool is_infinite = true;  ///< a pole; else a root, a logarithm or an inverse function of what it has no value for
};
/// One within [from, to]; nothing where there is none. An expression that is too entangled to be decided within some
/// thousand intervals has none that is told.
std::optional<ExpressionGap> gap_within(const Expression& of, const NamedConstants& constants, double from, double to);

}  // namespace kinegraph
