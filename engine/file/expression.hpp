// Expressions of a law of motion, such as "v0*cos(alpha)*t", as a tree. Owns parsing with units, dimension checks,
// evaluation with an error bound, forward-mode automatic differentiation (used by the check only) and exact symbolic
// derivatives. The grammar: engine/file/formula_syntax.hpp. Independent of JSON and of motion.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/error.hpp"
#include "engine/file/formula.hpp"
#include "engine/file/units.hpp"
#include "engine/number/exact.hpp"
#include "lang/words.hpp"

namespace kinegraph {

/// The functions of an expression; abs occurs only in derivatives.
enum class Elementary : std::uint8_t { sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, abs };
std::string_view name_of(Elementary function);
std::optional<Elementary> elementary_called(std::string_view name);

struct Expression {
    enum class Kind : std::uint8_t {
        number,    ///< `value`
        pi,        ///< the half turn
        constant,  ///< constant number `constant` of the law
        variable,  ///< t; for a path x
        sum,       ///< of its parts
        product,   ///< of its parts; −a is (−1)·a
        power,     ///< parts[0] to parts[1]; a/b is a·b^(−1), a root the power ½
        function   ///< `function` of parts[0]
    } kind = Kind::number;
    Exact value{};
    std::size_t constant = 0;
    Elementary function = Elementary::sin;
    std::vector<Expression> parts{};

    static Expression number(Exact value);
    static Expression of(Kind kind, std::vector<Expression> parts = {});
    static Expression of(Elementary function, Expression argument);
    static Expression named(std::size_t constant);
    bool is_number(int wanted) const { return kind == Kind::number && value == Exact(wanted); }
    // NOLINTNEXTLINE(modernize-use-nullptr): as in quantity.hpp
    friend bool operator==(const Expression&, const Expression&) = default;
};

/// A named constant of a law, or a literal quantity with its unit.
struct NamedConstant {
    std::string name;  ///< empty: a literal quantity, shown as it is written
    std::string written;
    Exact value;          ///< SI, angles in radians
    Dimension dimension;  ///< in expressions its angle is ignored: a radian is a number
};
using NamedConstants = std::vector<NamedConstant>;

/// An expression in the units of the file: its value is `unit` times that of the tree.
struct Expressed {
    Expression tree{};
    /// The expression contains no length, mass or time: its variable is in `variable_unit`, its value in `unit`.
    /// Otherwise both are 1 (SI).
    bool is_bare = false;
    Exact unit = 1, variable_unit = 1;
};

/// How to parse an expression: its variable and the kind of it, the wanted kind of the value, and the units of both for
/// an expression without units.
struct ExpressionForm {
    std::string_view variable;
    QuantityKind of = QuantityKind::time;  ///< time or length
    QuantityKind is = QuantityKind::length;
    Exact length_unit = 1;  ///< of bare numbers, m
};
/// Names are looked up as in formulas; a constant that is met for the first time is added to `constants`. Errors, in
/// words that quote the place: syntax, unknown names and functions, incompatible dimensions, more than 100 nested
/// brackets, powers whose degrees multiply to more than 1000, numbers of more than 300 digits, texts of more than 1000
/// characters, and expressions whose second derivative is too long to print. These limits also bound the cost.
tl::expected<Expressed, Words> read_expression(std::string_view text, const ExpressionForm& form, const LookUp& look_up,
                                               NamedConstants& constants);

/// "a*cos(omega*t)": parses to the same expression.
std::string written(const Expression& of, const NamedConstants& constants, std::string_view variable);

/// A value in doubles and a bound on its rounding error.
struct Estimate {
    double value = 0, noise = 0;
    bool is_zero() const { return !(std::abs(value) > noise); }
};
Estimate estimate(const Expression& of, const NamedConstants& constants, double variable);

/// Value, first and second derivative with respect to the variable, by forward-mode differentiation. Not finite where
/// the expression is not finite or not real.
using Jet = std::array<double, 3>;
Jet jet(const Expression& of, const NamedConstants& constants, double variable);

bool depends_on_variable(const Expression& of);

/// The derivative, by algebra (GiNaC in algebra_ginac.cpp alone), with respect to the variable. The order of terms and
/// factors depends on the expression alone. Thread-safe. Errors, without a place: an expression that divides by zero or
/// is not real for every value of the variable.
tl::expected<Expression, Error> derivative(const Expression& of, const NamedConstants& constants);

}  // namespace kinegraph
