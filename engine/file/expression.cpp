// Parsing, dimension checks, printing and evaluation of expressions.
#include "engine/file/expression.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/file/error.hpp"
#include "engine/file/scanner.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

using Kind = Expression::Kind;
using ParsedExpression = tl::expected<Expression, Words>;

constexpr std::size_t longest_expression = 1000;
constexpr int deepest_expression = 100;
constexpr double highest_degree = 1000;
constexpr std::size_t most_bits_folded = 2000;
constexpr double longest_derivative = 4000;

constexpr std::array<std::pair<std::string_view, Elementary>, 12> functions{{{"sin", Elementary::sin},
                                                                             {"cos", Elementary::cos},
                                                                             {"tan", Elementary::tan},
                                                                             {"asin", Elementary::asin},
                                                                             {"acos", Elementary::acos},
                                                                             {"atan", Elementary::atan},
                                                                             {"sinh", Elementary::sinh},
                                                                             {"cosh", Elementary::cosh},
                                                                             {"tanh", Elementary::tanh},
                                                                             {"exp", Elementary::exp},
                                                                             {"log", Elementary::log},
                                                                             {"abs", Elementary::abs}}};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<signed char>(c) < 0;
}

/// Greek and accented letters may occur in names; unit signs (`°`, `²`, `·`) may not.
std::size_t known_name_length(std::string_view text) {
    std::size_t length = 0;
    for (std::size_t k = 1; k <= text.size(); ++k) {
        if (!is_letter(text[k - 1]) && !is_digit(text[k - 1])) break;
        if (is_parameter_name(text.substr(0, k)) || text.substr(0, k) == "pi" || elementary_called(text.substr(0, k)) ||
            std::find(formula_words().begin(), formula_words().end(), text.substr(0, k)) != formula_words().end())
            length = k;
    }
    return length;
}

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
    double degree = 1;
    switch (of.kind) {
        case Kind::sum:
            for (const Expression& part : of.parts) degree = std::max(degree, degree_of(part));
            return degree;
        case Kind::product:
            degree = 0;
            for (const Expression& part : of.parts) degree += degree_of(part);
            return degree;
        case Kind::power: {
            const auto exponent = number_of(of.parts[1]);
            return degree_of(of.parts[0]) * (exponent ? std::max(1.0, std::abs(exponent->to_double())) : 1.0);
        }
        case Kind::function: return degree_of(of.parts[0]);
        case Kind::number:
        case Kind::pi:
        case Kind::constant:
        case Kind::variable: break;
    }
    return 1;
}

/// Upper bounds on the numbers of leaves of an expression and its derivatives.
struct Size {
    double itself = 1, first = 0, second = 0;
};
Size size_of(const Expression& of) {
    Size size;
    switch (of.kind) {
        case Kind::variable: return {1, 1, 0};
        case Kind::sum:
            size = {0, 0, 0};
            for (const Expression& part : of.parts) {
                const Size each = size_of(part);
                size = {size.itself + each.itself, size.first + each.first, size.second + each.second};
            }
            return size;
        case Kind::product: {
            size = {0, 0, 0};
            std::vector<Size> each;
            for (const Expression& part : of.parts) each.push_back(size_of(part));
            for (const Size& part : each) size.itself += part.itself;
            double varying = 0;
            for (const Size& part : each) {
                if (part.first == 0) continue;
                varying += 1;
                size.first += size.itself + part.first;
                size.second += size.itself + part.second + part.first;
            }
            size.second += varying * (varying - 1) * size.itself + varying * size.first;
            return size;
        }
        case Kind::power:
        case Kind::function: {
            size = {1, 0, 0};
            for (const Expression& part : of.parts) {
                const Size each = size_of(part);
                size = {size.itself + each.itself, size.first + each.first, size.second + each.second};
            }
            if (size.first == 0) return {size.itself, 0, 0};
            return {size.itself, 2 * size.itself + size.first, 3 * size.itself + 3 * size.first + size.second};
        }
        case Kind::number:
        case Kind::pi:
        case Kind::constant: break;
    }
    return size;
}

// ----- the grammar

class Reader : Scanner {
public:
    Reader(std::string_view text, std::string_view variable, const LookUp& look_up, NamedConstants& constants)
        : Scanner(text), variable_(variable), look_up_(look_up), constants_(constants) {}

    ParsedExpression whole() {
        ParsedExpression result = sum();
        if (!result) return result;
        skip();
        if (at_ < text_.size()) return unexpected_here();
        return result;
    }

private:
    tl::unexpected<Words> unexpected_here() const {
        if (rest().empty()) return refused({lang::expressions::the_expression_ends_where_a_number});
        if (rest().starts_with("−") || rest().starts_with("–")) return refused({lang::expressions::a_minus_is_written});
        if (rest().starts_with("·") || rest().starts_with("×") || is_letter(rest()[0]) || rest()[0] == '(' ||
            is_digit(rest()[0]))
            return refused({lang::expressions::a_product_is_written, quoted(rest())});
        return refused({lang::expressions::is_not_understood_here_brackets_numbers, quoted(rest())});
    }
    bool too_deep() {
        if (++depth_ <= deepest_expression) return false;
        return true;
    }
    static tl::unexpected<Words> deeper_than_read() {
        return refused({lang::expressions::an_expression_with_more_than_brackets, std::to_string(deepest_expression)});
    }

    ParsedExpression sum() {
        if (too_deep()) return deeper_than_read();
        ParsedExpression first = product();
        std::vector<Expression> terms;
        while (first) {
            const bool plus = takes('+');
            if (!plus && !takes('-')) break;
            ParsedExpression other = product();
            if (!other) return other;
            terms.push_back(plus ? *std::move(other) : negated(*std::move(other)));
        }
        --depth_;
        if (!first || terms.empty()) return first;
        terms.insert(terms.begin(), *std::move(first));
        return folded(Expression::of(Kind::sum, std::move(terms)));
    }
    ParsedExpression product() {
        ParsedExpression first = factor();
        std::vector<Expression> factors;
        while (first) {
            const bool times = takes('*');
            if (!times && !takes('/')) break;
            ParsedExpression other = factor();
            if (!other) return other;
            if (!times) {
                if (other->is_number(0)) return by_zero();
                other = other->kind == Kind::number
                            ? Expression::number(1 / other->value)
                            : Expression::of(Kind::power, {*std::move(other), Expression::number(-1)});
            }
            factors.push_back(*std::move(other));
        }
        if (!first || factors.empty()) return first;
        factors.insert(factors.begin(), *std::move(first));
        return folded(Expression::of(Kind::product, std::move(factors)));
    }
    static tl::unexpected<Words> by_zero() { return refused({lang::expressions::the_expression_divides_by_zero}); }
    static Expression negated(Expression of) {
        if (of.kind == Kind::number) return Expression::number(-of.value);
        if (of.kind == Kind::product && of.parts[0].kind == Kind::number) {
            of.parts[0].value = -of.parts[0].value;
            return of;
        }
        if (of.kind == Kind::product) {
            of.parts.insert(of.parts.begin(), Expression::number(-1));
            return of;
        }
        return Expression::of(Kind::product, {Expression::number(-1), std::move(of)});
    }
    ParsedExpression factor() {
        bool negative = false;
        for (;;) {
            if (takes('-')) {
                negative = !negative;
            } else if (!takes('+')) {
                break;
            }
        }
        ParsedExpression result = power();
        if (result && negative) return negated(*std::move(result));
        return result;
    }
    ParsedExpression power() {
        ParsedExpression base = operand();
        if (!base || !takes('^')) return base;
        if (too_deep()) return deeper_than_read();
        ParsedExpression exponent = factor();
        --depth_;
        if (!exponent) return exponent;
        return raised(*std::move(base), *std::move(exponent));
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

    ParsedExpression operand() {
        skip();
        if (takes('(')) {
            ParsedExpression inner = sum();
            if (inner && !takes(')')) return refused({lang::expressions::a_bracket_is_not_closed});
            return inner;
        }
        if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) return number();
        const std::size_t length = known_name_length(rest());
        if (length == 0) return unexpected_here();
        const std::string_view name = text_.substr(at_, length);
        at_ += length;
        skip();
        if (at_ < text_.size() && text_[at_] == '(') return function(name);
        if (name == variable_) return Expression::of(Kind::variable);
        if (name == "pi") return Expression::of(Kind::pi);
        return constant(name);
    }
    ParsedExpression function(std::string_view name) {
        const auto known = elementary_called(name);
        if (!known && name != "sqrt" && name != "ln") {
            if (name == variable_ || look_up_(name)) return unexpected_here();
            return refused({lang::expressions::is_no_function_known_here_there, quoted(name)});
        }
        takes('(');
        ParsedExpression argument = sum();
        if (!argument) return argument;
        if (!takes(')')) return refused({lang::expressions::a_bracket_is_not_closed});
        if (name == "sqrt") return raised(*std::move(argument), Expression::number(Exact::ratio(1, 2)));
        return Expression::of(known.value_or(Elementary::log), *std::move(argument));
    }
    ParsedExpression constant(std::string_view name) {
        const auto found = std::find_if(constants_.begin(), constants_.end(),
                                        [&](const NamedConstant& each) { return each.name == name; });
        if (found != constants_.end()) return Expression::named(static_cast<std::size_t>(found - constants_.begin()));
        auto value = look_up_(name);
        if (!value) return refused(std::move(value.error()));
        add(std::string(name), std::string(name), *value);
        return Expression::named(constants_.size() - 1);
    }
    void add(std::string name, std::string as_written, const Measured& value) {
        Exact in_radians = value.value;
        static const Exact degree = pi() / 180;
        for (int i = 0; i < std::abs(value.dimension.angle); ++i)
            in_radians = value.dimension.angle > 0 ? in_radians * degree : in_radians / degree;
        constants_.push_back({std::move(name), std::move(as_written), std::move(in_radians), value.dimension});
    }

    ParsedExpression number() {
        std::size_t end = at_;
        const auto digits = [&] {
            while (end < text_.size() && is_digit(text_[end])) ++end;
        };
        digits();
        if (end < text_.size() && text_[end] == '.') {
            ++end;
            digits();
        }
        if (end + 1 < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
            std::size_t exponent = end + 1;
            if (text_[exponent] == '-' || text_[exponent] == '+') ++exponent;
            if (exponent < text_.size() && is_digit(text_[exponent])) {
                end = exponent;
                digits();
            }
        }
        const std::string_view digits_of = text_.substr(at_, end - at_);
        auto value = read_decimal(digits_of);
        if (!value) return refused(std::move(value.error()));
        at_ = end;
        const std::string_view unit = takes_unit();
        if (unit.empty()) return Expression::number(*std::move(value));
        const std::string spelt = std::string(digits_of) + " " + std::string(unit);
        const auto quantity = read_measured(spelt, look_up_);
        if (!quantity) return refused(quantity.error());
        add({}, unit == "°" ? std::string(digits_of) + "°" : spelt, *quantity);
        return Expression::named(constants_.size() - 1);
    }
    /// The longest unit at this position that ends at a word boundary.
    std::string_view takes_unit() {
        std::size_t from = at_;
        while (from < text_.size() && text_[from] == ' ') ++from;
        constexpr std::size_t longest_unit = 16;
        for (std::size_t length = std::min(longest_unit, text_.size() - from); length > 0; --length) {
            const std::string_view spelt = text_.substr(from, length);
            // In "2t" the t is the time, not a tonne.
            if (spelt.find('*') != std::string_view::npos || spelt.ends_with(' ') || spelt == variable_ ||
                unit_spelt(spelt) == nullptr)
                continue;
            const std::size_t behind = from + length;
            const bool goes_on = behind < text_.size() && is_letter(spelt.back()) &&
                                 (is_letter(text_[behind]) || is_digit(text_[behind])) &&
                                 static_cast<signed char>(spelt.back()) >= 0 &&
                                 static_cast<signed char>(text_[behind]) >= 0;
            if (goes_on) continue;
            at_ = behind;
            return spelt;
        }
        return {};
    }

    std::string_view variable_;
    const LookUp& look_up_;
    NamedConstants& constants_;
    int depth_ = 0;
};

// ----- dimensions

Words described_as(const Dimension& dimension) { return described({.value = Exact(), .dimension = dimension}); }

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
                    whole = {whole.length + each->length, whole.mass + each->mass, whole.time + each->time, 0};
                }
                return whole;
            }
            case Kind::power: return of_power(expression);
            case Kind::function: {
                Found argument = of(expression.parts[0]);
                if (!argument || argument->is_a_number()) return argument;
                return refused({lang::expressions::is_taken_of_a_number, name_of(expression.function),
                                spelt(expression.parts[0]), described_as(*argument)});
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
            return refused({lang::expressions::is_and_is_they_do_not, spelt(sum.parts[0]), described_as(*first),
                            spelt(sum.parts[i]), described_as(*other)});
        }
        return first;
    }
    Found of_power(const Expression& power) const {
        Found base = of(power.parts[0]), exponent = of(power.parts[1]);
        if (!base) return base;
        if (!exponent) return exponent;
        if (!exponent->is_a_number())
            return refused(
                {lang::expressions::an_exponent_must_be_a_bare, spelt(power.parts[1]), described_as(*exponent)});
        if (base->is_a_number()) return base;
        if (power.parts[1].kind != Kind::number)
            return refused({lang::expressions::is_so_its_exponent_must, spelt(power.parts[0]), described_as(*base)});
        const mpq_class& to = power.parts[1].value.rational();
        const long top = to.get_num().get_si(), below = to.get_den().get_si();
        const auto times = [&](int each) { return static_cast<int>(each * top / below); };
        if (base->length * top % below != 0 || base->mass * top % below != 0 || base->time * top % below != 0)
            return refused({lang::expressions::no_quantity_is_that_root, spelt(power.parts[0]), described_as(*base)});
        return Dimension{times(base->length), times(base->mass), times(base->time), 0};
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

std::string_view name_of(Elementary function) {
    const auto* const found =
        std::find_if(functions.begin(), functions.end(), [&](const auto& each) { return each.second == function; });
    return found->first;
}
std::optional<Elementary> elementary_called(std::string_view name) {
    const auto* const found =
        std::find_if(functions.begin(), functions.end(), [&](const auto& each) { return each.first == name; });
    if (found == functions.end() || found->second == Elementary::abs) return std::nullopt;
    return found->second;
}
Expression Expression::number(Exact value) {
    Expression made;
    made.value = std::move(value);
    return made;
}
Expression Expression::of(Kind kind, std::vector<Expression> parts) {
    Expression made;
    made.kind = kind;
    made.parts = std::move(parts);
    return made;
}
Expression Expression::of(Elementary function, Expression argument) {
    Expression made;
    made.kind = Kind::function;
    made.function = function;
    made.parts.push_back(std::move(argument));
    return made;
}
Expression Expression::named(std::size_t constant) {
    Expression made;
    made.kind = Kind::constant;
    made.constant = constant;
    return made;
}
bool depends_on_variable(const Expression& of) {
    return of.kind == Kind::variable || std::any_of(of.parts.begin(), of.parts.end(), depends_on_variable);
}

tl::expected<Expressed, Words> read_expression(std::string_view text, const ExpressionForm& form, const LookUp& look_up,
                                               NamedConstants& constants) {
    if (text.size() > longest_expression)
        return refused({lang::expressions::an_expression_of_more_than_characters, std::to_string(longest_expression)});
    ParsedExpression tree = Reader(text, form.variable, look_up, constants).whole();
    if (!tree) return refused(std::move(tree.error()));
    if (size_of(*tree).second > longest_derivative)
        return refused({lang::expressions::its_derivatives_would_fill_pages_write});
    Expressed law;
    law.is_bare = !has_units(*tree, constants);
    const Dimensions dimensions(constants, form.variable, law.is_bare ? Dimension{} : plain_dimension(form.of));
    const auto found = dimensions.of(*tree);
    if (!found) return refused(found.error());
    if (!law.is_bare && *found != plain_dimension(form.is))
        return refused({lang::expressions::is_is_wanted_here, quoted(text), described_as(*found), with_article(form.is),
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

/// f(u), and the factor by which an error of u is multiplied.
std::pair<double, double> value_and_slope(Elementary function, double u) {
    switch (function) {
        case Elementary::sin: return {std::sin(u), std::cos(u)};
        case Elementary::cos: return {std::cos(u), -std::sin(u)};
        case Elementary::tan: return {std::tan(u), 1 + std::tan(u) * std::tan(u)};
        case Elementary::asin: return {std::asin(u), 1 / std::sqrt(1 - u * u)};
        case Elementary::acos: return {std::acos(u), -1 / std::sqrt(1 - u * u)};
        case Elementary::atan: return {std::atan(u), 1 / (1 + u * u)};
        case Elementary::sinh: return {std::sinh(u), std::cosh(u)};
        case Elementary::cosh: return {std::cosh(u), std::sinh(u)};
        case Elementary::tanh: return {std::tanh(u), 1 - std::tanh(u) * std::tanh(u)};
        case Elementary::exp: return {std::exp(u), std::exp(u)};
        case Elementary::log: return {u > 0 ? std::log(u) : std::numeric_limits<double>::quiet_NaN(), 1 / u};
        case Elementary::abs: return {std::abs(u), u < 0 ? -1.0 : 1.0};
    }
    return {0, 0};
}
double second_slope(Elementary function, double u) {
    const double root = std::sqrt(1 - u * u), tangent = std::tan(u), hyperbolic = std::tanh(u);
    switch (function) {
        case Elementary::sin: return -std::sin(u);
        case Elementary::cos: return -std::cos(u);
        case Elementary::tan: return 2 * tangent * (1 + tangent * tangent);
        case Elementary::asin: return u / (root * root * root);
        case Elementary::acos: return -u / (root * root * root);
        case Elementary::atan: return -2 * u / ((1 + u * u) * (1 + u * u));
        case Elementary::sinh: return std::sinh(u);
        case Elementary::cosh: return std::cosh(u);
        case Elementary::tanh: return -2 * hyperbolic * (1 - hyperbolic * hyperbolic);
        case Elementary::exp: return std::exp(u);
        case Elementary::log: return -1 / (u * u);
        case Elementary::abs: return 0;
    }
    return 0;
}

Estimate power_of(const Estimate& base, const Estimate& exponent) {
    const double value = std::pow(base.value, exponent.value);
    double noise = unit_roundoff * std::abs(value);
    if (base.noise > 0 && exponent.value != 0) {
        const double slope = exponent.value * std::pow(base.value, exponent.value - 1);
        noise += std::isfinite(slope) ? std::abs(slope) * base.noise : 0;
    }
    if (exponent.noise > 0 && base.value > 0) noise += std::abs(value * std::log(base.value)) * exponent.noise;
    return {value, noise};
}

Jet times(const Jet& a, const Jet& b) {
    return {a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2]};
}
/// The jet of f(u) from f, f′, f″ at u and the jet of u.
Jet composed(double value, double first, double second, const Jet& u) {
    if (u[1] == 0 && u[2] == 0) return {value, 0, 0};
    return {value, first * u[1], second * u[1] * u[1] + first * u[2]};
}
Jet power_of(const Jet& base, const Jet& exponent, bool constant_exponent) {
    if (constant_exponent) {
        const double n = exponent[0];
        const double value = std::pow(base[0], n);
        const double first = n == 0 ? 0 : n * std::pow(base[0], n - 1);
        const double second = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(base[0], n - 2);
        return composed(value, first, second, base);
    }
    const Jet logarithm = composed(base[0] > 0 ? std::log(base[0]) : std::numeric_limits<double>::quiet_NaN(),
                                   1 / base[0], -1 / (base[0] * base[0]), base);
    const Jet u = times(exponent, logarithm);
    const double value = std::exp(u[0]);
    return composed(value, value, value, u);
}

}  // namespace

Estimate estimate(const Expression& of, const NamedConstants& constants, double variable) {
    switch (of.kind) {
        case Kind::number: return {of.value.to_double(), unit_roundoff * std::abs(of.value.to_double())};
        case Kind::pi: return {std::numbers::pi, unit_roundoff};
        case Kind::constant: {
            const double value = constants[of.constant].value.to_double();
            return {value, unit_roundoff * std::abs(value)};
        }
        case Kind::variable: return {variable, unit_roundoff * std::abs(variable)};
        case Kind::sum: {
            Estimate sum;
            for (const Expression& part : of.parts) {
                const Estimate each = estimate(part, constants, variable);
                sum.value += each.value;
                sum.noise += each.noise + unit_roundoff * std::abs(each.value);
            }
            return sum;
        }
        case Kind::product: {
            Estimate product{1, 0};
            for (const Expression& part : of.parts) {
                const Estimate each = estimate(part, constants, variable);
                product.noise = std::abs(product.value) * each.noise + std::abs(each.value) * product.noise;
                product.value *= each.value;
                product.noise += unit_roundoff * std::abs(product.value);
            }
            return product;
        }
        case Kind::power:
            return power_of(estimate(of.parts[0], constants, variable), estimate(of.parts[1], constants, variable));
        case Kind::function: {
            const Estimate argument = estimate(of.parts[0], constants, variable);
            const auto [value, slope] = value_and_slope(of.function, argument.value);
            const double carried = std::isfinite(slope) ? std::abs(slope) * argument.noise : 0;
            return {value, carried + unit_roundoff * std::abs(value)};
        }
    }
    return {};
}

Jet jet(const Expression& of, const NamedConstants& constants, double variable) {
    switch (of.kind) {
        case Kind::number: return {of.value.to_double(), 0, 0};
        case Kind::pi: return {std::numbers::pi, 0, 0};
        case Kind::constant: return {constants[of.constant].value.to_double(), 0, 0};
        case Kind::variable: return {variable, 1, 0};
        case Kind::sum: {
            Jet sum{};
            for (const Expression& part : of.parts) {
                const Jet each = jet(part, constants, variable);
                for (std::size_t i = 0; i < sum.size(); ++i) sum.at(i) += each.at(i);
            }
            return sum;
        }
        case Kind::product: {
            Jet product{1, 0, 0};
            for (const Expression& part : of.parts) product = times(product, jet(part, constants, variable));
            return product;
        }
        case Kind::power:
            return power_of(jet(of.parts[0], constants, variable), jet(of.parts[1], constants, variable),
                            !depends_on_variable(of.parts[1]));
        case Kind::function: {
            const Jet argument = jet(of.parts[0], constants, variable);
            const auto [value, slope] = value_and_slope(of.function, argument[0]);
            return composed(value, slope, second_slope(of.function, argument[0]), argument);
        }
    }
    return {};
}

}  // namespace kinegraph
