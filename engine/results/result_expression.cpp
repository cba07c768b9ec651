#include "engine/results/result_expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/file/error.hpp"
#include "engine/file/formula_syntax.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/exercise.hpp"
#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/exercises.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

using Node = ResultExpression::Node;

constexpr std::string_view signs_of_grammar = "+-*/^()|,'=<>\"";
/// An apostrophe within a name is part of it: v B'.
constexpr std::string_view signs_that_end_a_name = "+-*/^()|,=<>\"";

std::string_view without_blanks(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

/// What a part of an expression is.
struct ValueKind {
    bool is_vector = false;
    Dimension dimension{};
    bool is_in_radians = false;  ///< a number that contains π: beside an angle it is one
};
/// A node and its kind.
struct Typed {
    Node node;
    ValueKind kind;
};
using Read = tl::expected<Typed, Words>;

Dimension product_of(const Dimension& a, const Dimension& b, int power) {
    return {a.length + power * b.length, a.mass + power * b.mass, a.time + power * b.time, a.angle + power * b.angle};
}

/// Of a unit that has no kind, such as "N s" or "J".
Dimension dimension_of_unit(std::string_view unit) {
    Dimension whole;
    while (!unit.empty()) {
        const std::size_t end = std::min(unit.find(' '), unit.size());
        const std::string_view factor = unit.substr(0, end);
        unit.remove_prefix(std::min(end + 1, unit.size()));
        if (factor == "J") {
            whole = product_of(whole, kinegraph::dimension_of(QuantityKind::moment), 1);
            continue;
        }
        const auto measured = read_measured("1 " + std::string(factor), {});
        KG_ASSERT(measured.has_value(), "units of results are made of those of files");
        whole = product_of(whole, measured->dimension, 1);
    }
    return whole;
}
Dimension dimension_of(const Column& column) {
    if (column.dimension) return *column.dimension;
    return column.si_unit.empty() ? kinegraph::dimension_of(column.unit) : dimension_of_unit(column.si_unit);
}

/// Makes the tree and checks its dimensions.
class ExpressionReader {
public:
    explicit ExpressionReader(std::span<const Column> known) : known_(known) {
        for (const Column& column : known) {
            names_.push_back(column.name);
            if (!column.vector.empty()) names_.push_back(column.vector);
        }
    }

    Read read(std::string_view text) {
        const Grammar grammar{.name_length = [](std::string_view rest) { return name_length(rest); },
                              .has_quoted_names = true,
                              .has_bars = true};
        const Syntax syntax = read_syntax(text, grammar);
        if (const Syntax* fault = first_fault(syntax)) return refused(words_of(*fault, SyntaxOf::expression));
        return of(syntax);
    }
    std::vector<Column> parts() && { return std::move(parts_); }
    /// The value with that name, whatever signs it contains; the length of a vector. None: nothing is named so.
    std::optional<Read> named(std::string_view name) {
        if (is_vector_named(name)) {
            Read vector = result(name);
            if (!vector) return vector;
            Node length{.kind = Node::Kind::function, .text = "abs"};
            length.parts.push_back(std::move(vector->node));
            return Typed{std::move(length), ValueKind{.dimension = vector->kind.dimension}};
        }
        const auto is_it = [&](const Column& column) { return column.name == name && !is_vector(column); };
        if (std::none_of(known_.begin(), known_.end(), is_it)) return std::nullopt;
        return result(name);
    }

private:
    bool is_vector_named(std::string_view name) const {
        return std::any_of(known_.begin(), known_.end(), [&](const Column& column) {
            return result_kind(column.quantity).shape == ResultKind::Shape::vector && column.vector == name;
        });
    }
    /// A function, or all that stands before the next sign; a name of a result where it ends before.
    static std::size_t name_length(std::string_view rest) {
        const std::size_t word = word_length(rest);
        if (word == 0) return 0;
        const std::string_view behind = without_blanks(rest.substr(word));
        if (behind.starts_with('(')) return word;
        return without_blanks(rest.substr(0, rest.find_first_of(signs_that_end_a_name))).size();
    }

    Read of(const Syntax& syntax) {
        switch (syntax.kind) {
            case Syntax::Kind::number: return number(syntax);
            case Syntax::Kind::name: return result(syntax.text);
            case Syntax::Kind::function: return function(syntax);
            case Syntax::Kind::sum: return sum(syntax);
            case Syntax::Kind::product: return product(syntax);
            case Syntax::Kind::power: return power(syntax);
            case Syntax::Kind::negative: {
                Read part = of(syntax.parts[0]);
                if (!part) return part;
                Node node{.kind = Node::Kind::negative};
                node.parts.push_back(std::move(part->node));
                return Typed{std::move(node), part->kind};
            }
            case Syntax::Kind::fault: break;
        }
        KG_ASSERT(false, "faults of syntax are refused before");
    }

    static Read number(const Syntax& syntax) {
        auto value = read_measured(std::string(syntax.text) + " " + std::string(syntax.unit_text), {});
        if (syntax.unit == nullptr) value = read_measured(syntax.text, {});
        const std::string_view unit = syntax.unit == nullptr ? "" : syntax.unit_text;
        const std::string written =
            std::string(syntax.text) + (unit.empty() || unit == "°" ? "" : " ") + std::string(unit);
        if (!value) return refused(std::move(value.error()));
        const double number = in_si(*value).to_double();
        return Typed{Node{.kind = Node::Kind::number, .number = number, .text = written},
                     ValueKind{.dimension = value->dimension}};
    }

    Read result(std::string_view name) {
        if (name == "pi")
            return Typed{Node{.kind = Node::Kind::number, .number = std::numbers::pi, .text = "π"},
                         ValueKind{.is_in_radians = true}};
        const auto is_called = [&](const Column& column) { return column.name == name; };
        const auto scalar = std::find_if(known_.begin(), known_.end(), is_called);
        if (scalar != known_.end() && !is_vector(*scalar))
            return Typed{Node{.kind = Node::Kind::scalar, .x = part(*scalar)},
                         ValueKind{.dimension = dimension_of(*scalar)}};
        std::vector<const Column*> components;
        for (const Column& column : known_)
            if (column.vector == name) components.push_back(&column);
        if (components.size() == 2)
            return Typed{Node{.kind = Node::Kind::vector, .x = part(*components[0]), .y = part(*components[1])},
                         ValueKind{.is_vector = true, .dimension = kinegraph::dimension_of(components[0]->unit)}};
        Speller speller;
        return refused(
            {lang::exercises::no_result_is_named_names, quoted(name),
             did_you_mean(speller.nearest(name, std::vector<std::string_view>(names_.begin(), names_.end())))});
    }
    /// The length of a vector, which in an expression is the vector.
    static bool is_vector(const Column& column) {
        return column.kind == Column::Kind::result && column.quantity.component == Quantity::Component::whole &&
               result_kind(column.quantity).shape == ResultKind::Shape::vector;
    }
    std::size_t part(const Column& column) {
        const auto found =
            std::find_if(parts_.begin(), parts_.end(), [&](const Column& other) { return other.name == column.name; });
        if (found != parts_.end()) return static_cast<std::size_t>(found - parts_.begin());
        parts_.push_back(column);
        return parts_.size() - 1;
    }

    /// Of two values that are added or compared; none: they do not go together.
    static std::optional<ValueKind> together(ValueKind a, ValueKind b) {
        const Dimension angle{.angle = 1};
        if (a.is_vector != b.is_vector) return std::nullopt;
        if (a.is_in_radians && b.dimension == angle) a.dimension = angle;
        if (b.is_in_radians && a.dimension == angle) b.dimension = angle;
        if (a.dimension == b.dimension) return ValueKind{a.is_vector, a.dimension, a.is_in_radians && b.is_in_radians};
        a.dimension.angle = b.dimension.angle = 0;
        if (a.dimension == b.dimension && !a.dimension.is_a_number()) return a;
        return std::nullopt;
    }
    static Words apart(const ValueKind& a, const ValueKind& b) {
        if (a.is_vector != b.is_vector) return lang::expressions::a_vector_and_a_number;
        return {lang::common::do_not_go_together, described(a.dimension), described(b.dimension)};
    }

    Read sum(const Syntax& syntax) {
        Read first = of(syntax.parts[0]);
        if (!first) return first;
        Typed whole{Node{.kind = Node::Kind::sum, .is_inverse = {false}}, first->kind};
        whole.node.parts.push_back(std::move(first->node));
        for (std::size_t i = 1; i < syntax.parts.size(); ++i) {
            Read other = of(syntax.parts[i]);
            if (!other) return other;
            const bool minus = syntax.parts[i].is_inverse;
            const auto kind = together(whole.kind, other->kind);
            if (!kind)
                return refused({minus ? lang::expressions::in_a_difference : lang::expressions::in_a_sum,
                                apart(whole.kind, other->kind)});
            whole.kind = *kind;
            whole.node.parts.push_back(std::move(other->node));
            whole.node.is_inverse.push_back(minus);
        }
        return whole;
    }
    Read product(const Syntax& syntax) {
        Typed whole{Node{.kind = Node::Kind::product}, ValueKind{}};
        for (const Syntax& each : syntax.parts) {
            Read factor = of(each);
            if (!factor) return factor;
            if (each.is_inverse && factor->kind.is_vector) return refused({lang::expressions::a_quotient_by_a_vector});
            whole.kind = {whole.kind.is_vector != factor->kind.is_vector,
                          product_of(whole.kind.dimension, factor->kind.dimension, each.is_inverse ? -1 : 1),
                          whole.kind.is_in_radians || factor->kind.is_in_radians};
            whole.node.parts.push_back(std::move(factor->node));
            whole.node.is_inverse.push_back(each.is_inverse);
        }
        whole.kind.is_in_radians = whole.kind.is_in_radians && whole.kind.dimension.is_a_number();
        return whole;
    }
    Read power(const Syntax& syntax) {
        Read base = of(syntax.parts[0]);
        if (!base) return base;
        if (base->kind.is_vector) return refused({lang::expressions::a_vector_has_no_power});
        const auto exponent = evaluate("= " + std::string(syntax.parts[1].text), [](std::string_view) {
            return tl::expected<Measured, Words>(tl::make_unexpected(Words()));
        });
        if (!exponent || !exponent->dimension.is_a_number())
            return refused({lang::expressions::an_exponent_of_a_result});
        const double number = exponent->value.to_double();
        Dimension raised;
        for (int Dimension::*const of : {&Dimension::length, &Dimension::mass, &Dimension::time, &Dimension::angle}) {
            const double to = number * base->kind.dimension.*of;
            // ω^(1/2) is the root of a number of 1/s.
            if (to != std::round(to) && of != &Dimension::angle)
                return refused({lang::expressions::no_quantity_is_the_root, described(base->kind.dimension)});
            constexpr double highest = 100;
            if (std::abs(to) > highest)
                return refused(
                    {lang::expressions::a_power_of_a_unit_beyond, std::to_string(static_cast<int>(highest))});
            raised.*of = to == std::round(to) ? static_cast<int>(to) : 0;
        }
        Node node{.kind = Node::Kind::power, .number = number, .text = std::string(syntax.parts[1].text)};
        node.parts.push_back(std::move(base->node));
        return Typed{std::move(node), ValueKind{.dimension = raised}};
    }

    Read function(const Syntax& syntax) {
        const std::string_view name = syntax.text;
        const bool is_extreme = name == "min" || name == "max",
                   is_circular = name == "sin" || name == "cos" || name == "tan";
        if (!is_extreme && !is_circular && name != "abs" && name != "sqrt" && name != "atan2")
            return refused({lang::expressions::is_no_function_of_results, quoted(name)});
        const std::size_t wanted = name == "atan2" ? 2 : 1;
        if (!is_extreme && syntax.parts.size() != wanted)
            return refused({lang::expressions::is_written_with_between_the_brackets, name,
                            std::string(wanted == 2 ? "atan2(y, x)" : std::string(name) + "(x)"),
                            wanted == 1 ? Words(lang::expressions::one_value) : Words(lang::expressions::two_values)});
        Node node{.kind = Node::Kind::function, .text = std::string(name)};
        std::optional<ValueKind> kind;
        for (const Syntax& each : syntax.parts) {
            Read argument = of(each);
            if (!argument) return argument;
            if (argument->kind.is_vector && name != "abs")
                return refused({lang::expressions::is_taken_of_a_number_not_of_a_vector, name});
            const auto common = kind ? together(*kind, argument->kind) : argument->kind;
            if (!common)
                return refused({lang::expressions::kind_in_unit, apart(*kind, argument->kind), std::string(name)});
            kind = *common;
            node.parts.push_back(std::move(argument->node));
        }
        return kind_of_function(name, *kind, std::move(node));
    }
    static Read kind_of_function(std::string_view name, ValueKind kind, Node node) {
        kind.is_vector = false;
        if (name == "sqrt") {
            Dimension& d = kind.dimension;
            if (d.length % 2 != 0 || d.mass % 2 != 0 || d.time % 2 != 0)
                return refused({lang::expressions::no_quantity_is_the_root, described(d)});
            d = {d.length / 2, d.mass / 2, d.time / 2, d.angle % 2 == 0 ? d.angle / 2 : 0};
        } else if (name == "atan2") {
            kind = {.dimension = {.angle = 1}};
        } else if (name != "abs" && name != "min" && name != "max") {
            if (!kind.dimension.is_a_number() && kind.dimension != Dimension{.angle = 1})
                return refused({lang::expressions::is_taken_of_an_angle_not, name, described(kind.dimension)});
            kind = {};
        }
        return Typed{std::move(node), kind};
    }

    std::span<const Column> known_;
    std::vector<std::string> names_;
    std::vector<Column> parts_;
};

/// A number, or a vector, with a bound on its error.
struct WithinError {
    double x = 0, y = 0, error_x = 0, error_y = 0;
    bool is_vector = false;
};

class ValueOfNode {
public:
    explicit ValueOfNode(std::span<const ValueWithin> parts) : parts_(parts) {}

    /// Not finite where it is not determined.
    WithinError of(const Node& node) const {
        switch (node.kind) {
            case Node::Kind::number: return {.x = node.number};
            case Node::Kind::scalar: return {.x = parts_[node.x].value, .error_x = parts_[node.x].error};
            case Node::Kind::vector:
                return {parts_[node.x].value, parts_[node.y].value, parts_[node.x].error, parts_[node.y].error, true};
            case Node::Kind::sum: return sum(node);
            case Node::Kind::product: return product(node);
            case Node::Kind::power: return power(of(node.parts[0]), node.number);
            case Node::Kind::negative: {
                WithinError value = of(node.parts[0]);
                value.x = -value.x;
                value.y = -value.y;
                return value;
            }
            case Node::Kind::function: return function(node);
        }
        KG_ASSERT(false, "a node is of one kind");
    }

private:
    static constexpr double undetermined = std::numeric_limits<double>::quiet_NaN();

    WithinError sum(const Node& node) const {
        WithinError whole = of(node.parts[0]);
        for (std::size_t i = 1; i < node.parts.size(); ++i) {
            const WithinError other = of(node.parts[i]);
            const double sign = node.is_inverse[i] ? -1 : 1;
            whole.x += sign * other.x;
            whole.y += sign * other.y;
            whole.error_x += other.error_x;
            whole.error_y += other.error_y;
        }
        return whole;
    }
    /// |ab − a′b′| ≤ |a| δb + |b| δa + δa δb.
    static double error_of_product(double a, double error_a, double b, double error_b) {
        return std::abs(a) * error_b + std::abs(b) * error_a + error_a * error_b;
    }
    static WithinError times(const WithinError& a, const WithinError& b) {
        if (a.is_vector && b.is_vector)
            return {.x = a.x * b.x + a.y * b.y,
                    .error_x = error_of_product(a.x, a.error_x, b.x, b.error_x) +
                               error_of_product(a.y, a.error_y, b.y, b.error_y)};
        if (a.is_vector) return times(b, a);
        return {a.x * b.x, a.x * b.y, error_of_product(a.x, a.error_x, b.x, b.error_x),
                error_of_product(a.x, a.error_x, b.y, b.error_y), b.is_vector};
    }
    /// |1/b − 1/b′| ≤ δb/(|b| (|b| − δb)).
    static WithinError reciprocal(const WithinError& b) {
        const double size = std::abs(b.x);
        if (!(size > b.error_x)) return {.x = undetermined};
        return {.x = 1 / b.x, .error_x = b.error_x / (size * (size - b.error_x))};
    }
    WithinError product(const Node& node) const {
        WithinError whole{.x = 1};
        for (std::size_t i = 0; i < node.parts.size(); ++i) {
            const WithinError factor = of(node.parts[i]);
            whole = times(whole, node.is_inverse[i] ? reciprocal(factor) : factor);
        }
        return whole;
    }
    static WithinError power(const WithinError& base, double exponent) {
        if (exponent == 0) return {.x = 1};
        const double size = std::abs(base.x);
        if (exponent < 0 && !(size > base.error_x)) return {.x = undetermined};
        const bool is_whole = exponent == std::round(exponent);
        double x = base.x;
        if (!is_whole && x < 0) {
            if (size > base.error_x) return {.x = undetermined};
            x = 0;
        }
        // Between the ends of the interval a power is monotonic, but for zero, which lies between.
        const double value = nearest::pow(x, exponent);
        const double far = std::abs(nearest::pow(size + base.error_x, exponent)),
                     near = std::abs(nearest::pow(std::max(0.0, size - base.error_x), exponent));
        return {.x = value, .error_x = std::max(std::abs(far - std::abs(value)), std::abs(std::abs(value) - near))};
    }

    WithinError function(const Node& node) const {
        const WithinError a = of(node.parts[0]);
        const std::string& name = node.text;
        if (name == "abs") {
            if (!a.is_vector) return {.x = std::abs(a.x), .error_x = a.error_x};
            return {.x = std::sqrt(a.x * a.x + a.y * a.y),
                    .error_x = std::sqrt(a.error_x * a.error_x + a.error_y * a.error_y)};
        }
        if (name == "sqrt") return power(a, 0.5);
        if (name == "sin") return {.x = nearest::sin(a.x), .error_x = a.error_x};
        if (name == "cos") return {.x = nearest::cos(a.x), .error_x = a.error_x};
        if (name == "tan") {
            const WithinError cosine{.x = nearest::cos(a.x), .error_x = a.error_x};
            return times({.x = nearest::sin(a.x), .error_x = a.error_x}, reciprocal(cosine));
        }
        if (name == "atan2") {
            const WithinError b = of(node.parts[1]);
            const double square = a.x * a.x + b.x * b.x;
            if (!(std::sqrt(square) > a.error_x + b.error_x)) return {.x = undetermined};
            return {.x = nearest::atan2(a.x, b.x),
                    .error_x = (std::abs(b.x) * a.error_x + std::abs(a.x) * b.error_x) / square};
        }
        WithinError best = a;
        for (std::size_t i = 1; i < node.parts.size(); ++i) {
            const WithinError other = of(node.parts[i]);
            if (std::isnan(other.x)) return other;
            best.x = name == "min" ? std::min(best.x, other.x) : std::max(best.x, other.x);
            best.error_x = std::max(best.error_x, other.error_x);
        }
        return best;
    }

    std::span<const ValueWithin> parts_;
};

/// "m²/s³" of "m^2/s^3".
std::string with_raised_digits(const std::string& unit) {
    static constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit[i] != '^') {
            text += unit[i];
            continue;
        }
        for (; i + 1 < unit.size() && is_digit(unit[i + 1]); ++i)
            text += raised.at(static_cast<std::size_t>(unit[i + 1] - '0'));
    }
    return text;
}

}  // namespace

tl::expected<ResultExpression, Words> ResultExpression::read(std::string_view text, std::span<const Column> known) {
    ExpressionReader reader(known);
    const std::string_view whole = without_blanks(text);
    std::optional<Read> alone = reader.named(whole);
    const NamedExpression named = alone ? NamedExpression{whole, whole} : named_expression(text);
    if (!alone && named.text.size() > 2 && named.text.starts_with('\'') && named.text.ends_with('\''))
        alone = reader.named(named.text.substr(1, named.text.size() - 2));
    const auto is_taken = [&](const Column& column) { return column.name == named.name; };
    if (named.name != named.text) {
        if (named.name.empty() || named.name.find_first_of(signs_of_grammar) != std::string_view::npos)
            return refused({lang::expressions::cannot_be_the_name_of_an_expression, quoted(named.name)});
        if (std::any_of(known.begin(), known.end(), is_taken))
            return refused({lang::expressions::is_the_name_of_a_result, quoted(named.name)});
    }
    if (!alone) alone = reader.named(named.text);
    Read read = alone ? std::move(*alone) : reader.read(named.text);
    if (!read) return refused(std::move(read.error()));
    if (read->kind.is_vector) return refused({lang::expressions::a_vector_has_no_value, std::string(named.text)});
    ResultExpression expression;
    expression.is_named_ = named.name != named.text;
    expression.root_ = std::move(read->node);
    expression.parts_ = std::move(reader).parts();
    const auto is_parameter = [](const Column& part) { return part.kind == Column::Kind::parameter; };
    if (std::all_of(expression.parts_.begin(), expression.parts_.end(), is_parameter))
        return refused({lang::expressions::no_result_stands_in, quoted(named.text)});
    const auto kind = kind_of(read->kind.dimension);
    expression.column_ = {Column::Kind::named,
                          {},
                          std::string(named.name),
                          kind.value_or(QuantityKind::dimensionless),
                          std::string(text)};
    expression.column_.dimension = read->kind.dimension;
    if (kind) return expression;
    Dimension without_angle = read->kind.dimension;
    without_angle.angle = 0;
    if (!without_angle.is_a_number()) expression.column_.si_unit = with_raised_digits(base_units(without_angle));
    return expression;
}

std::optional<ValueWithin> ResultExpression::value(std::span<const ValueWithin> of_parts) const {
    const WithinError found = ValueOfNode(of_parts).of(root_);
    if (!std::isfinite(found.x) || !std::isfinite(found.error_x)) return std::nullopt;
    return ValueWithin{found.x == 0 ? 0 : found.x, found.error_x};
}

bool is_expression(std::string_view text) { return text.find_first_of(signs_of_grammar) != std::string_view::npos; }

NamedExpression named_expression(std::string_view text) {
    bool in_quotes = false;
    const auto names = [&](char c) {
        in_quotes = in_quotes != (c == '\'');
        return c == '=' && !in_quotes;
    };
    const auto sign = static_cast<std::size_t>(std::find_if(text.begin(), text.end(), names) - text.begin());
    if (sign == text.size()) return {without_blanks(text), without_blanks(text)};
    return {without_blanks(text.substr(0, sign)), without_blanks(text.substr(sign + 1))};
}

std::optional<ResultExpression> expression_called(std::string_view name, const Mechanism& mechanism) {
    for (ResultExpression& each : defined_results(mechanism))
        if (each.column().name == name) return std::move(each);
    if (!mechanism.exercise || mechanism.exercise->expressions.empty()) return std::nullopt;
    std::vector<Column> known = operands_of_expressions(mechanism);
    for (const std::string& text : mechanism.exercise->expressions) {
        auto read = ResultExpression::read(text, known);
        if (!read) continue;
        if (read->column().name == name) return *std::move(read);
        known.push_back(read->column());
    }
    return std::nullopt;
}

}  // namespace kinegraph
