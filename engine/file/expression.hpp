// Expressions of a law of motion: "v0*cos(alpha)*t" as a tree, read with its units, told apart by dimension, evaluated
// with how far rounding may have led, and derived automatically by the rules of differentiation carried along with the
// values (which only the check uses). Exact derivatives in symbols are an algebra's (engine/file/algebra.hpp). Knows
// nothing of JSON nor of motion.
//
//   sum      = product { ("+" | "-") product }
//   product  = factor { ("*" | "/") factor }
//   factor   = ("+" | "-") factor | power
//   power    = operand [ "^" factor ]
//   operand  = number [ unit ] | name | function "(" sum ")" | "(" sum ")"
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

#include "engine/file/formula.hpp"
#include "engine/file/units.hpp"
#include "engine/file/words.hpp"
#include "engine/number/exact.hpp"

namespace kinegraph {

/// Functions that an expression may have; abs comes of derivatives alone.
enum class Elementary : std::uint8_t { sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, abs };
std::string_view name_of(Elementary function);
std::optional<Elementary> elementary_called(std::string_view name);

struct Expression {
    enum class Kind : std::uint8_t {
        number,    ///< `value`
        pi,        ///< the half turn
        constant,  ///< number `constant` of the law's
        variable,  ///< t; of a path x
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

/// A letter of a law, or a quantity that stands in it with its unit.
struct NamedConstant {
    std::string name;  ///< empty: a quantity, which is called as it is written
    std::string written;
    Exact value;          ///< SI, angles in radians
    Dimension dimension;  ///< in expressions its angle counts for nothing: a radian is a number
};
using NamedConstants = std::vector<NamedConstant>;

/// As a file means it: the value is `unit` times that of the tree.
struct Expressed {
    Expression tree{};
    /// No length, mass or time stands in it: its variable counts in `variable_unit`, its value in `unit`. Else both are
    /// 1 (SI).
    bool is_bare = false;
    Exact unit = 1, variable_unit = 1;
};

/// How an expression is to be read: its variable and what that is, what it shall be, and in which unit either is where
/// the expression has no units.
struct ExpressionForm {
    std::string_view variable;
    QuantityKind of = QuantityKind::time;  ///< time or length
    QuantityKind is = QuantityKind::length;
    Exact length_unit = 1;  ///< of bare numbers, m
};
/// Names are looked up as formulas look them up; what is met first is added to `constants`. Errors, in words that quote
/// the place: syntax, unknown names and functions, dimensions that do not go together, more than 100 brackets within
/// each other, powers whose degrees multiply to more than 1000, numbers of more than 300 digits, texts of more than
/// 1000 characters, and expressions whose second derivative would be longer than any page. Costs no more than that.
tl::expected<Expressed, Words> read_expression(std::string_view text, const ExpressionForm& form, const LookUp& look_up,
                                               NamedConstants& constants);

/// "a*cos(omega*t)": reads again as the same.
std::string written(const Expression& of, const NamedConstants& constants, std::string_view variable);

/// A value in doubles and how far its rounding may have led.
struct Estimate {
    double value = 0, noise = 0;
    bool is_zero() const { return !(std::abs(value) > noise); }
};
Estimate estimate(const Expression& of, const NamedConstants& constants, double variable);

/// Value, first and second derivative by the variable, each rule applied to numbers as the value is computed. Not
/// finite where the expression is not, or not real.
using Jet = std::array<double, 3>;
Jet jet(const Expression& of, const NamedConstants& constants, double variable);

bool depends_on_variable(const Expression& of);

}  // namespace kinegraph
