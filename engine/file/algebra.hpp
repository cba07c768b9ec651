// Algebra: exact symbolic derivatives of expressions, by GiNaC. Only engine/file/algebra_ginac.cpp includes GiNaC.
#pragma once

#include <tl/expected.hpp>

#include "engine/file/error.hpp"
#include "engine/file/expression.hpp"

namespace kinegraph {

/// The derivative with respect to the variable. The order of terms and factors depends on the expression alone.
/// Thread-safe. Errors, without a place: an expression that divides by zero or is not real for every value of the
/// variable.
tl::expected<Expression, Error> derivative(const Expression& of, const NamedConstants& constants);

}  // namespace kinegraph
