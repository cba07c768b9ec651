// Algebra: exact derivatives of expressions in symbols. It is done by GiNaC, which engine/file/algebra_ginac.cpp alone
// knows.
#pragma once

#include <tl/expected.hpp>

#include "engine/file/error.hpp"
#include "engine/file/expression.hpp"

namespace kinegraph {

/// The derivative by the variable, in an order of terms and factors that depends on the expression alone. May be called
/// by many threads at once. Errors, without a place: what divides by zero or is not real whatever the variable is.
tl::expected<Expression, Error> derivative(const Expression& of, const NamedConstants& constants);

}  // namespace kinegraph
