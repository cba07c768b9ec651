// Reading, dimension checks, printing and evaluation of expressions.
#include "engine/file/expression.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/file/error.hpp"
#include "engine/file/formula_syntax.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

using Kind = Expression::Kind;
using ParsedExpression = tl::expected<Expression, Words>;

constexpr double highest_degree = 1000;
constexpr std::size_t most_bits_folded = 2000;
constexpr double longest_derivative = 4000;

/// In the order of Elementary.
constexpr std::array<std::string_view, 12> names_of_functions{"sin",  "cos",  "tan",  "asin", "acos", "atan",
                                                              "sinh", "cosh", "tanh", "exp",  "log",  "abs"};

// ----- size

bool is_constant_number(const Expression& of) {
    return of.kind == Kind::number ||
           (of.kind == Kind::product && std::all_of(of.parts.begin(), of.parts.end(), is_constant_number));
}
std::optional<Exact> number_of(const Expression& of) {
    if (of.kind == Kind::number) return of.value;
    if (!is_constant_number(of)) return std::nullopt;
    Exact product = 1;
    for (const Expression& part : of.parts) product *= *number_of(part);
    return product;
}

/// The highest power to which a number inside may be raised when an algebra system expands products.
double degree_of(const Expression& of) {
    if (of.parts.empty()) return 1;
    if (of.kind == Kind::power) {
        const auto exponent = number_of(of.parts[1]);
        return degree_of(of.parts[0]) * (exponent ? std::max(1.0, std::abs(exponent->to_double())) : 1.0);
    }
    double degree = 0;
    for (const Expression& part : of.parts)
        degree = of.kind == Kind::product ? degree + degree_of(part) : std::max(degree, degree_of(part));
    return degree;
}

/// Upper bounds on the numbers of leaves of an expression and its derivatives.
struct Size {
    double itself = 1, first = 0, second = 0;
};
Size size_of(const Expression& of) {
    if (of.kind == Kind::variable) return {1, 1, 0};
    if (of.parts.empty()) return {};
    std::vector<Size> each;
    Size all{0, 0, 0};
    for (const Expression& part : of.parts) {
        const Size& size = each.emplace_back(size_of(part));
        all = {all.itself + size.itself, all.first + size.first, all.second + size.second};
    }
    if (of.kind == Kind::sum) return all;
    if (of.kind == Kind::product) {
        Size product{all.itself, 0, 0};
        double varying = 0;
        for (const Size& part : each) {
            if (part.first == 0) continue;
            varying += 1;
            product.first += all.itself + part.first;
            product.second += all.itself + part.second + part.first;
        }
        product.second += varying * (varying - 1) * all.itself + varying * product.first;
        return product;
    }
    all.itself += 1;
    if (all.first == 0) return {all.itself, 0, 0};
    return {all.itself, 2 * all.itself + all.first, 3 * all.itself + 3 * all.first + all.second};
}

// ----- reading

/// Makes the expression of a tree of syntax.
class LawReader {
public:
    LawReader(std::string_view text, std::string_view variable, const LookUp& look_up, NamedConstants& constants)
        : text_(text), variable_(variable), look_up_(look_up), constants_(constants) {}

    ParsedExpression whole() {
        // In "2t" the t is the time, not a tonne.
        return of(read_syntax(text_, {.is_unit = [this](std::string_view spelt) { return spelt != variable_; }}));
    }

private:
    ParsedExpression of(const Syntax& node) {
        switch (node.kind) {
            case Syntax::Kind::number: return number(node);
            case Syntax::Kind::name: return name(node.text);
            case Syntax::Kind::function: return function(node);
            case Syntax::Kind::sum:
            case Syntax::Kind::product:
            case Syntax::Kind::power:
            case Syntax::Kind::negative: return operation(node);
            case Syntax::Kind::fault: break;
        }
        for (const Syntax& part : node.parts)
            if (ParsedExpression read = of(part); !read) return read;
        return refused(words_of(node, SyntaxOf::expression));
    }
    ParsedExpression operation(const Syntax& node) {
        const bool is_sum = node.kind == Syntax::Kind::sum;
        std::vector<Expression> parts;
        for (const Syntax& each : node.parts) {
            ParsedExpression part = of(each);
            if (part && each.is_inverse) part = is_sum ? negated(*std::move(part)) : inverse(*std::move(part));
            if (!part) return part;
            parts.push_back(*std::move(part));
        }
        if (node.kind == Syntax::Kind::negative) return negated(std::move(parts[0]));
        if (node.kind == Syntax::Kind::power) return raised(std::move(parts[0]), std::move(parts[1]));
        return folded(Expression::of(is_sum ? Kind::sum : Kind::product, std::move(parts)));
    }
    static tl::unexpected<Words> by_zero() { return refused({lang::expressions::the_expression_divides_by_zero}); }
    static ParsedExpression inverse(Expression of) {
        if (of.is_number(0)) return by_zero();
        if (of.kind == Kind::number) return Expression::number(1 / of.value);
        return Expression::of(Kind::power, {std::move(of), Expression::number(-1)});
    }
    static Expression negated(Expression of) {
        if (of.kind == Kind::number) return Expression::number(-of.value);
        if (of.kind != Kind::product) return Expression::of(Kind::product, {Expression::number(-1), std::move(of)});
        if (of.parts[0].kind == Kind::number)
            of.parts[0].value = -of.parts[0].value;
        else
            of.parts.insert(of.parts.begin(), Expression::number(-1));
        return of;
    }
    static ParsedExpression raised(Expression base, Expression exponent) {
        if (const auto number = number_of(exponent)) {
            if (abs(*number) > Exact(static_cast<int>(highest_degree)) || number->bits() > 64)
                return refused({lang::expressions::an_exponent_must_be_a_fraction,
                                std::to_string(static_cast<int>(highest_degree))});
            exponent = Expression::number(*number);
            if (base.is_number(0) && number->sign() <= 0) return by_zero();
        }
        return folded(Expression::of(Kind::power, {std::move(base), std::move(exponent)}));
    }
    /// Evaluates constant subexpressions, as long as the numbers stay printable.
    static ParsedExpression folded(Expression of) {
        if (degree_of(of) > highest_degree)
            return refused({lang::expressions::powers_upon_each_other_that_come,
                            std::to_string(static_cast<int>(highest_degree))});
        const auto is_number = [](const Expression& part) { return part.kind == Kind::number; };
        if (!std::all_of(of.parts.begin(), of.parts.end(), is_number)) return of;
        Exact value = of.kind == Kind::product ? Exact(1) : Exact();
        if (of.kind == Kind::power) {
            const Exact& exponent = of.parts[1].value;
            if (exponent.rational().get_den() != 1) return of;
            const long times = std::labs(exponent.rational().get_num().get_si());
            value = 1;
            if (static_cast<double>(of.parts[0].value.bits()) * static_cast<double>(times) > 4.0 * most_bits_folded)
                return too_long();
            for (long i = 0; i < times; ++i) value *= of.parts[0].value;
            if (exponent.sign() < 0) value = 1 / value;
        } else {
            for (const Expression& part : of.parts) of.kind == Kind::sum ? value += part.value : value *= part.value;
        }
        if (value.bits() > most_bits_folded) return too_long();
        return Expression::number(std::move(value));
    }
    static tl::unexpected<Words> too_long() {
        return refused({lang::expressions::a_number_of_more_than_digits, std::to_string(most_bits_folded * 3 / 20)});
    }

    ParsedExpression number(const Syntax& node) {
        auto value = measured(node);
        if (!value) return refused(std::move(value.error()));
        if (node.unit == nullptr) return Expression::number(std::move(value->value));
        const std::string_view between = node.unit_text == "°" ? "" : " ";
        return added({}, std::string(node.text).append(between).append(node.unit_text), *std::move(value));
    }
    ParsedExpression name(std::string_view name) {
        if (name == variable_) return Expression::of(Kind::variable);
        if (name == "pi") return Expression::of(Kind::pi);
        const auto found = std::find_if(constants_.begin(), constants_.end(),
                                        [&](const NamedConstant& each) { return each.name == name; });
        if (found != constants_.end()) return Expression::named(static_cast<std::size_t>(found - constants_.begin()));
        auto value = look_up_(name);
        if (!value) return refused(std::move(value.error()));
        return added(std::string(name), std::string(name), *std::move(value));
    }
    Expression added(std::string name, std::string as_written, Measured value) {
        const Dimension dimension = value.dimension;
        constants_.push_back({std::move(name), std::move(as_written), in_radians(std::move(value)).value, dimension});
        return Expression::named(constants_.size() - 1);
    }
    ParsedExpression function(const Syntax& node) {
        const std::string_view name = node.text;
        const auto known = name == "ln" ? Elementary::log : elementary_called(name);
        if (!known && name != "sqrt") {
            const std::string_view bracket = text_.substr(text_.find('(', node.at));
            if (name == variable_ || look_up_(name))
                return refused({lang::expressions::a_product_is_written, quoted(bracket)});
            return refused({lang::expressions::is_no_function_known_here_there, quoted(name)});
        }
        std::vector<Expression> arguments;
        for (const Syntax& each : node.parts) {
            ParsedExpression argument = of(each);
            if (!argument) return argument;
            arguments.push_back(*std::move(argument));
        }
        if (arguments.size() > 1)
            return refused({lang::expressions::is_written_with_between_the_brackets, name, std::string(name) + "(x)",
                            lang::expressions::one_value});
        if (!known) return raised(std::move(arguments[0]), Expression::number(Exact::ratio(1, 2)));
        return Expression::of(*known, std::move(arguments[0]));
    }

    std::string_view text_, variable_;
    const LookUp& look_up_;
    NamedConstants& constants_;
};

// ----- dimensions

/// A radian is a number.
Dimension without_angle(Dimension of) {
    of.angle = 0;
    return of;
}

class Dimensions {
public:
    Dimensions(const NamedConstants& constants, std::string_view variable, Dimension of_variable)
        : constants_(constants), variable_(variable), of_variable_(of_variable) {}

    using Found = tl::expected<Dimension, Words>;
    Found of(const Expression& expression) const {
        switch (expression.kind) {
            case Kind::number:
            case Kind::pi: return Dimension{};
            case Kind::constant: return without_angle(constants_[expression.constant].dimension);
            case Kind::variable: return of_variable_;
            case Kind::sum: return of_sum(expression);
            case Kind::product: {
                Dimension whole;
                for (const Expression& part : expression.parts) {
                    Found each = of(part);
                    if (!each) return each;
                    whole = whole * *each;
                }
                return whole;
            }
            case Kind::power: return of_power(expression);
            case Kind::function: {
                Found argument = of(expression.parts[0]);
                if (!argument || argument->is_a_number()) return argument;
                return refused({lang::expressions::is_taken_of_a_number, name_of(expression.function),
                                spelt(expression.parts[0]), described(*argument)});
            }
        }
        return Dimension{};
    }

private:
    std::string spelt(const Expression& expression) const { return quoted(written(expression, constants_, variable_)); }
    Found of_sum(const Expression& sum) const {
        Found first = of(sum.parts[0]);
        if (!first) return first;
        for (std::size_t i = 1; i < sum.parts.size(); ++i) {
            Found other = of(sum.parts[i]);
            if (!other) return other;
            if (*other == *first || sum.parts[i].is_number(0)) continue;
            return refused({lang::expressions::is_and_is_they_do_not, spelt(sum.parts[0]), described(*first),
                            spelt(sum.parts[i]), described(*other)});
        }
        return first;
    }
    Found of_power(const Expression& power) const {
        Found base = of(power.parts[0]), exponent = of(power.parts[1]);
        if (!base) return base;
        if (!exponent) return exponent;
        if (!exponent->is_a_number())
            return refused(
                {lang::expressions::an_exponent_must_be_a_bare, spelt(power.parts[1]), described(*exponent)});
        if (base->is_a_number()) return base;
        if (power.parts[1].kind != Kind::number)
            return refused({lang::expressions::is_so_its_exponent_must, spelt(power.parts[0]), described(*base)});
        const mpq_class& to = power.parts[1].value.rational();
        if (const auto whole = power_of(*base, to.get_num().get_si(), to.get_den().get_si())) return *whole;
        return refused({lang::expressions::no_quantity_is_that_root, spelt(power.parts[0]), described(*base)});
    }

    const NamedConstants& constants_;
    std::string_view variable_;
    Dimension of_variable_;
};

bool has_units(const Expression& of, const NamedConstants& constants) {
    if (of.kind == Kind::constant) return !without_angle(constants[of.constant].dimension).is_a_number();
    return std::any_of(of.parts.begin(), of.parts.end(),
                       [&](const Expression& part) { return has_units(part, constants); });
}

Dimension plain_dimension(QuantityKind kind) {
    if (kind == QuantityKind::time) return {.time = 1};
    if (kind == QuantityKind::length) return {.length = 1};
    return {};
}

}  // namespace

// ----- trees

std::string_view name_of(Elementary function) { return names_of_functions.at(static_cast<std::size_t>(function)); }
std::optional<Elementary> elementary_called(std::string_view name) {
    const auto* const found = std::find(names_of_functions.begin(), names_of_functions.end(), name);
    const auto function = static_cast<Elementary>(found - names_of_functions.begin());
    if (found == names_of_functions.end() || function == Elementary::abs) return std::nullopt;
    return function;
}
Expression Expression::number(Exact value) { return {.value = std::move(value)}; }
Expression Expression::of(Kind kind, std::vector<Expression> parts) {
    return {.kind = kind, .parts = std::move(parts)};
}
Expression Expression::of(Elementary function, Expression argument) {
    Expression made{.kind = Kind::function, .function = function};
    made.parts.push_back(std::move(argument));
    return made;
}
Expression Expression::named(std::size_t constant) { return {.kind = Kind::constant, .constant = constant}; }
bool depends_on_variable(const Expression& of) {
    return of.kind == Kind::variable || std::any_of(of.parts.begin(), of.parts.end(), depends_on_variable);
}

tl::expected<Expressed, Words> read_expression(std::string_view text, const ExpressionForm& form, const LookUp& look_up,
                                               NamedConstants& constants) {
    ParsedExpression tree = LawReader(text, form.variable, look_up, constants).whole();
    if (!tree) return refused(std::move(tree.error()));
    if (size_of(*tree).second > longest_derivative)
        return refused({lang::expressions::its_derivatives_would_fill_pages_write});
    Expressed law;
    law.is_bare = !has_units(*tree, constants);
    const Dimensions dimensions(constants, form.variable, law.is_bare ? Dimension{} : plain_dimension(form.of));
    const auto found = dimensions.of(*tree);
    if (!found) return refused(found.error());
    if (!law.is_bare && *found != plain_dimension(form.is))
        return refused({lang::expressions::is_is_wanted_here, quoted(text), described(*found), with_article(form.is),
                        form.of == QuantityKind::time ? Words(lang::expressions::is_a_time, form.variable)
                                                      : Words(lang::expressions::is_a_length, form.variable)});
    if (law.is_bare) {
        if (form.is == QuantityKind::length) law.unit = form.length_unit;
        if (form.of == QuantityKind::length) law.variable_unit = form.length_unit;
    }
    law.tree = *std::move(tree);
    return law;
}

// ----- as text

namespace {

/// Precedence of a subexpression: sum, product, power, operand.
enum class Tight { sum, product, power, piece };

class Spelling {
public:
    Spelling(const NamedConstants& constants, std::string_view variable) : constants_(constants), variable_(variable) {}

    std::string within(const Expression& of, Tight place) const {
        const std::string text = spelt(of);
        return tightness(of) < place ? "(" + text + ")" : text;
    }

private:
    Tight tightness(const Expression& of) const {
        switch (of.kind) {
            case Kind::sum: return Tight::sum;
            case Kind::product: return Tight::product;
            case Kind::power: return divides(of) ? Tight::product : Tight::power;
            case Kind::number:
                return of.value.sign() < 0                  ? Tight::sum
                       : of.value.rational().get_den() != 1 ? Tight::product
                                                            : Tight::piece;
            case Kind::constant: return constants_[of.constant].name.empty() ? Tight::product : Tight::piece;
            case Kind::pi:
            case Kind::variable:
            case Kind::function: break;
        }
        return Tight::piece;
    }
    /// Whether the factor is printed in the denominator.
    static bool divides(const Expression& of) {
        return of.kind == Kind::power && of.parts[1].kind == Kind::number && of.parts[1].value.sign() < 0;
    }
    std::string divisor(const Expression& of) const {
        const Exact exponent = -of.parts[1].value;
        if (exponent == Exact(1)) return within(of.parts[0], Tight::power);
        return within(Expression::of(Kind::power, {of.parts[0], Expression::number(exponent)}), Tight::power);
    }
    std::string spelt(const Expression& of) const {
        switch (of.kind) {
            case Kind::number: return of.value.to_fraction();
            case Kind::pi: return "pi";
            case Kind::constant: return constants_[of.constant].written;
            case Kind::variable: return std::string(variable_);
            case Kind::sum: return sum(of);
            case Kind::product: return product(of);
            case Kind::power:
                if (of.parts[1].kind == Kind::number && of.parts[1].value == Exact::ratio(1, 2))
                    return "sqrt(" + spelt(of.parts[0]) + ")";
                if (divides(of)) return "1/" + divisor(of);
                return within(of.parts[0], Tight::piece) + "^" + within(of.parts[1], Tight::piece);
            case Kind::function: return std::string(name_of(of.function)) + "(" + spelt(of.parts[0]) + ")";
        }
        return {};
    }
    std::string sum(const Expression& of) const {
        std::string text;
        for (const Expression& part : of.parts) {
            const std::string each = within(part, Tight::product);
            const bool negative = spelt(part).starts_with('-');
            const std::string bare = negative ? spelt(part).substr(1) : each;
            text += text.empty() ? (negative ? "-" + bare : bare) : (negative ? " - " : " + ") + bare;
        }
        return text;
    }
    std::string product(const Expression& of) const {
        std::string text;
        for (const Expression& part : of.parts) {
            if (text.empty() && part.is_number(-1) && of.parts.size() > 1) {
                text = "-";
                continue;
            }
            const bool first = text.empty() || text == "-";
            if (divides(part)) {
                text += (first ? "1/" : "/") + divisor(part);
                continue;
            }
            if (!first && part.kind == Kind::number && part.value.rational().get_num() == 1 &&
                part.value.rational().get_den() != 1) {
                text += "/" + part.value.rational().get_den().get_str();
                continue;
            }
            if (!first) text += "*";
            const bool leads = text.empty() && part.kind == Kind::number;
            text += leads ? spelt(part) : within(part, Tight::power);
        }
        return text;
    }

    const NamedConstants& constants_;
    std::string_view variable_;
};

}  // namespace

std::string written(const Expression& of, const NamedConstants& constants, std::string_view variable) {
    return Spelling(constants, variable).within(of, Tight::sum);
}

// ----- values

namespace {

constexpr double unit_roundoff = 4 * std::numeric_limits<double>::epsilon();
constexpr double not_real = std::numeric_limits<double>::quiet_NaN();

/// f, f′ and f″ at u.
Jet derivatives(Elementary function, double u) {
    const double root = std::sqrt(1 - u * u);
    switch (function) {
        case Elementary::sin: return {nearest::sin(u), nearest::cos(u), -nearest::sin(u)};
        case Elementary::cos: return {nearest::cos(u), -nearest::sin(u), -nearest::cos(u)};
        case Elementary::tan: {
            const double tan = nearest::tan(u), slope = 1 + tan * tan;
            return {tan, slope, 2 * tan * slope};
        }
        case Elementary::asin: return {nearest::asin(u), 1 / root, u / (root * root * root)};
        case Elementary::acos: return {nearest::acos(u), -1 / root, -u / (root * root * root)};
        case Elementary::atan: return {nearest::atan(u), 1 / (1 + u * u), -2 * u / ((1 + u * u) * (1 + u * u))};
        case Elementary::sinh: return {nearest::sinh(u), nearest::cosh(u), nearest::sinh(u)};
        case Elementary::cosh: return {nearest::cosh(u), nearest::sinh(u), nearest::cosh(u)};
        case Elementary::tanh: {
            const double tanh = nearest::tanh(u), slope = 1 - tanh * tanh;
            return {tanh, slope, -2 * tanh * slope};
        }
        case Elementary::exp: return {nearest::exp(u), nearest::exp(u), nearest::exp(u)};
        case Elementary::log: return {u > 0 ? nearest::log(u) : not_real, 1 / u, -1 / (u * u)};
        case Elementary::abs: return {std::abs(u), u < 0 ? -1.0 : 1.0, 0};
    }
    return {};
}

// Sums, products, powers and functions of estimates and of jets.

Estimate rounded_value(double value) { return {value, unit_roundoff * std::abs(value)}; }
Estimate plus(const Estimate& a, const Estimate& b) {
    return {a.value + b.value, a.noise + (b.noise + unit_roundoff * std::abs(b.value))};
}
Estimate times(const Estimate& a, const Estimate& b) {
    const double value = a.value * b.value;
    return {value, std::abs(a.value) * b.noise + std::abs(b.value) * a.noise + unit_roundoff * std::abs(value)};
}
Estimate applied(Elementary function, const Estimate& u) {
    const auto [value, slope, second] = derivatives(function, u.value);
    const double carried = std::isfinite(slope) ? std::abs(slope) * u.noise : 0;
    return {value, carried + unit_roundoff * std::abs(value)};
}
Estimate raised(const Estimate& base, const Estimate& exponent, bool /*constant_exponent*/) {
    const double value = nearest::pow(base.value, exponent.value);
    double noise = unit_roundoff * std::abs(value);
    if (base.noise > 0 && exponent.value != 0) {
        const double slope = exponent.value * nearest::pow(base.value, exponent.value - 1);
        noise += std::isfinite(slope) ? std::abs(slope) * base.noise : 0;
    }
    if (exponent.noise > 0 && base.value > 0) noise += std::abs(value * nearest::log(base.value)) * exponent.noise;
    return {value, noise};
}

Jet plus(const Jet& a, const Jet& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Jet times(const Jet& a, const Jet& b) {
    return {a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2]};
}
/// The jet of f(u) from f, f′, f″ at u and the jet of u.
Jet composed(const Jet& f, const Jet& u) {
    if (u[1] == 0 && u[2] == 0) return {f[0], 0, 0};
    return {f[0], f[1] * u[1], f[2] * u[1] * u[1] + f[1] * u[2]};
}
Jet applied(Elementary function, const Jet& u) { return composed(derivatives(function, u[0]), u); }
Jet raised(const Jet& base, const Jet& exponent, bool constant_exponent) {
    if (constant_exponent) {
        const double n = exponent[0];
        const double value = nearest::pow(base[0], n);
        const double first = n == 0 ? 0 : n * nearest::pow(base[0], n - 1);
        const double second = n == 0 || n == 1 ? 0 : n * (n - 1) * nearest::pow(base[0], n - 2);
        return composed({value, first, second}, base);
    }
    return applied(Elementary::exp, times(exponent, applied(Elementary::log, base)));
}

/// The values of the leaves of an expression.
template <class Number>
struct Leaves {
    const NamedConstants& constants;
    Number variable, pi;
    Number (*known)(double);
};
template <class Number>
Number value_of(const Expression& of, const Leaves<Number>& leaves) {
    const auto joined = [&](Number value, Number (*join)(const Number&, const Number&)) {
        for (const Expression& part : of.parts) value = join(value, value_of(part, leaves));
        return value;
    };
    switch (of.kind) {
        case Kind::number: return leaves.known(of.value.to_double());
        case Kind::pi: return leaves.pi;
        case Kind::constant: return leaves.known(leaves.constants[of.constant].value.to_double());
        case Kind::variable: return leaves.variable;
        case Kind::sum: return joined({}, plus);
        case Kind::product: return joined({1}, times);
        case Kind::power:
            return raised(value_of(of.parts[0], leaves), value_of(of.parts[1], leaves),
                          !depends_on_variable(of.parts[1]));
        case Kind::function: return applied(of.function, value_of(of.parts[0], leaves));
    }
    return {};
}

}  // namespace

Estimate estimate(const Expression& of, const NamedConstants& constants, double variable) {
    return value_of<Estimate>(of,
                              {constants, rounded_value(variable), {std::numbers::pi, unit_roundoff}, rounded_value});
}
Jet jet(const Expression& of, const NamedConstants& constants, double variable) {
    const auto known = [](double value) -> Jet { return {value, 0, 0}; };
    return value_of<Jet>(of, {constants, {variable, 1, 0}, known(std::numbers::pi), known});
}

}  // namespace kinegraph
