// Algebra: exact derivatives of expressions in symbols. It is done by GiNaC, which engine/file/algebra_ginac.cpp alone
// knows; where it comes from is said once, by the program, which loads it as a module when a file needs it, or by
// whoever links the library.
#pragma once

#include <tl/expected.hpp>

#include "engine/file/expression.hpp"

namespace kinegraph {

/// What an algebra does. Its functions may be called by many threads at once.
struct Algebra {
    /// The derivative by the variable, in an order of terms and factors that depends on the expression alone. Errors,
    /// in words: what divides by zero or is not real whatever the variable is.
    tl::expected<Expression, Words> (*derivative)(const Expression& of, const NamedConstants& constants) = nullptr;
};

/// GiNaC's.
extern const Algebra ginac_algebra;

/// Gives the algebra, or says why there is none.
using AlgebraSource = tl::expected<const Algebra*, Words> (*)();
/// Whence derivatives come from now on; said before anything is solved, by one thread.
void take_algebra_from(AlgebraSource source);
/// Error: none was named, or it cannot be loaded.
tl::expected<const Algebra*, Words> algebra();

}  // namespace kinegraph
