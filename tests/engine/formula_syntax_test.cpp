// The syntax of formulas and expressions: trees, names that contain blanks, faults with their kind and place, limits.
#include "engine/file/formula_syntax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "engine/file/expression.hpp"
#include "engine/file/formula.hpp"

namespace kinegraph::formula_syntax_test {
namespace {

using Kind = Syntax::Kind;
using Fault = Syntax::Fault;

/// The tree with a pair of brackets around each operation and function.
std::string bracketed(const Syntax& of) {
    const auto all = [&](std::string_view sign, std::string_view inverse) {
        std::string text = bracketed(of.parts.front());
        for (std::size_t i = 1; i < of.parts.size(); ++i)
            text += std::string(of.parts[i].is_inverse ? inverse : sign) + bracketed(of.parts[i]);
        return '(' + text + ')';
    };
    switch (of.kind) {
        case Kind::number: return std::string(of.text) + (of.unit == nullptr ? "" : " " + std::string(of.unit_text));
        case Kind::name: return '<' + std::string(of.text) + '>';
        case Kind::function: return std::string(of.text) + all(", ", ", ");
        case Kind::sum: return all(" + ", " - ");
        case Kind::product: return all("*", "/");
        case Kind::power: return all("^", "^");
        case Kind::negative: return "(-" + bracketed(of.parts.front()) + ')';
        case Kind::fault: break;
    }
    return "fault";
}
std::string tree_of(const std::string& text, const Grammar& grammar = {}) {
    const Syntax tree = read_syntax(text, grammar);
    return bracketed(tree);
}

/// Names of results: they contain blanks and signs.
Grammar of_results() {
    static const std::vector<std::string> names{"omega 2", "omega 4", "v B", "v B - C", "F A 3 on 2",
                                                "y B",     "y A",     "N",   "abs",     "P 1.2"};
    const auto longest = [](std::string_view rest) {
        std::size_t length = 0;
        for (const std::string& name : names)
            if (rest.starts_with(name)) length = std::max(length, name.size());
        return length;
    };
    return {.name_length = longest, .has_quoted_names = true, .has_bars = true};
}

TEST(FormulaSyntax, BindsAsMathematicsDoes) {
    EXPECT_EQ(tree_of("a + b*c - d/e/f"), "(<a> + (<b>*<c>) - (<d>/<e>/<f>))");
    EXPECT_EQ(tree_of("-2^2"), "(-(2^2))");
    EXPECT_EQ(tree_of("2^-3^x"), "(2^(-(3^<x>)))");
    EXPECT_EQ(tree_of("- - +a*-b"), "(<a>*(-<b>))");
    EXPECT_EQ(tree_of("atan2 (y, -(x + 1))"), "atan2(<y>, (-(<x> + 1)))");
    EXPECT_EQ(tree_of("2.5e-3 mm + 60° - 2 N m/rad*3t"), "(2.5e-3 mm + 60 ° - (2 N m/rad*3 t))");
    EXPECT_EQ(tree_of("2 N*m + 2 m²*ω_1"), "((2 N*<m>) + (2 m²*<ω_1>))");
}

TEST(FormulaSyntax, ReadsTheLongestName) {
    const Grammar grammar = of_results();
    EXPECT_EQ(tree_of("omega 4 / omega 2", grammar), "(<omega 4>/<omega 2>)");
    EXPECT_EQ(tree_of("|v B|", grammar), "abs(<v B>)");
    EXPECT_EQ(tree_of("|v B - C|*2 + |y B - |y A||", grammar), "((abs(<v B - C>)*2) + abs((<y B> - abs(<y A>))))");
    EXPECT_EQ(tree_of("'F A 3 on 2' * v B", grammar), "(<F A 3 on 2>*<v B>)");
    EXPECT_EQ(tree_of("v B - 'C'", grammar), "(<v B> - <C>)");
    EXPECT_EQ(tree_of("abs(P 1.2) - 2 N*m", grammar), "(abs(<P 1.2>) - (2 N*fault))") << "no name m";
    EXPECT_EQ(tree_of("3 mm*N + y B - y A", grammar), "((3 mm*<N>) + <y B> - <y A>)");
}

TEST(FormulaSyntax, NamesAUnitThatIsThere) {
    EXPECT_EQ(tree_of("2t*t", {.is_unit = [](std::string_view spelt) { return spelt != "t"; }}), "fault");
    EXPECT_EQ(tree_of("2 t*t"), "(2 t*<t>)");
    EXPECT_EQ(tree_of("2 mmx"), "fault") << "a unit ends where its word ends";
    EXPECT_EQ(tree_of("2 m2"), "fault");
    EXPECT_EQ(tree_of("12 cm^2", {.is_unit = [](std::string_view spelt) { return spelt == "cm"; }}), "(12 cm^2)");
}

/// A random tree with the fewest brackets that its text needs, and with all of them.
class Trees {
public:
    explicit Trees(unsigned seed) : random_(seed) {}
    struct Written {
        std::string text, tree;
        int tightness = 0;  ///< sum, product, sign, power, operand
    };
    Written next(int depth) {
        if (depth == 0 || choice(6) == 0) {
            const std::array<Written, 5> leaves{
                {{"7", "7", 4}, {"x_1", "<x_1>", 4}, {"0.5 mm", "0.5 mm", 4}, {"2e3", "2e3", 4}, {"α", "<α>", 4}}};
            return leaves.at(choice(leaves.size()));
        }
        switch (choice(5)) {
            case 0: return joined(depth, 0, " + ", " - ");
            case 1: return joined(depth, 1, "*", "/");
            case 2: {
                const Written of = within(next(depth - 1), 3);
                return {"-" + of.text, "(-" + of.tree + ")", 2};
            }
            case 3: {
                const Written base = within(next(depth - 1), 4), exponent = within(next(depth - 1), 2);
                // "2 mm^2" would be an area.
                const std::string text = base.text.ends_with('m') ? "(" + base.text + ")" : base.text;
                return {text + "^" + exponent.text, "(" + base.tree + "^" + exponent.tree + ")", 3};
            }
            default: {
                const Written a = next(depth - 1), b = next(depth - 1);
                return {"f( " + a.text + ",\t" + b.text + ")", "f(" + a.tree + ", " + b.tree + ")", 4};
            }
        }
    }

private:
    Written joined(int depth, int tightness, const std::string& sign, const std::string& inverse) {
        Written all = within(next(depth - 1), tightness + 1);
        for (std::size_t more = 1 + choice(3); more > 0; --more) {
            const Written part = within(next(depth - 1), tightness + 1);
            const std::string& by = choice(2) == 0 ? sign : inverse;
            all.text += by + part.text;
            all.tree += by + part.tree;
        }
        return {all.text, "(" + all.tree + ")", tightness};
    }
    static Written within(Written of, int tightness) {
        if (of.tightness < tightness) of.text = "(" + of.text + ")";
        return of;
    }
    std::size_t choice(std::size_t of) { return random_() % of; }
    std::mt19937 random_;
};

/// Each node knows what it was made of.
void expect_places(const std::string& text, const Syntax& of) {
    EXPECT_EQ(text.substr(of.at, of.text.size()), of.text) << text;
    for (const Syntax& part : of.parts) {
        EXPECT_GE(part.at, of.at) << text;
        expect_places(text, part);
    }
}

TEST(FormulaSyntax, IsReadAsItIsWritten) {
    Trees trees(20261127);
    for (int i = 0; i < 2000; ++i) {
        const Trees::Written written = trees.next(5);
        const Syntax tree = read_syntax(written.text, {.text = SyntaxOf::formula});
        ASSERT_EQ(bracketed(tree), written.tree) << written.text;
        ASSERT_EQ(first_fault(tree), nullptr) << written.text;
        expect_places(written.text, tree);
    }
}

TEST(FormulaSyntax, FindsTheFirstFaultInItsPlace) {
    struct Case {
        std::string text;
        Fault fault;
        std::size_t at;
    };
    for (const Case& each : {Case{"", Fault::ends, 0},
                             Case{" 2 + ", Fault::ends, 5},
                             Case{"2 + )", Fault::unexpected, 4},
                             Case{"a − b", Fault::foreign_minus, 2},
                             Case{"a·b", Fault::foreign_times, 1},
                             Case{"a × b", Fault::foreign_times, 2},
                             Case{"2 x", Fault::behind_number, 2},
                             Case{"(2 x", Fault::behind_number, 3},
                             Case{"a (b)", Fault::no_fault, 0},
                             Case{"(a) (b)", Fault::behind_value, 4},
                             Case{"a 3", Fault::behind_value, 2},
                             Case{"a ,", Fault::unexpected, 2},
                             Case{"f(a", Fault::bracket_open, 3},
                             Case{"((a) + 2", Fault::bracket_open, 8},
                             Case{"|a", Fault::bar_open, 2},
                             Case{"2*'a", Fault::quote_open, 3},
                             Case{"f(2 +, (", Fault::unexpected, 5},
                             Case{"a'b'", Fault::behind_value, 1},
                             Case{std::string(101, '(') + "1", Fault::nested_brackets, 101},
                             Case{std::string(100, '(') + "1" + std::string(100, ')'), Fault::no_fault, 0},
                             Case{std::string(1001, '1'), Fault::too_long, 0}}) {
        Grammar grammar{.has_quoted_names = true, .has_bars = true};
        const Syntax tree = read_syntax(each.text, grammar);
        const Syntax* const fault = first_fault(tree);
        ASSERT_EQ(fault == nullptr, each.fault == Fault::no_fault) << each.text;
        if (fault == nullptr) continue;
        EXPECT_EQ(fault->fault, each.fault) << each.text;
        EXPECT_EQ(fault->at, each.at) << each.text;
        EXPECT_EQ(fault->text, std::string_view(each.text).substr(each.at)) << each.text;
    }
}

TEST(FormulaSyntax, SaysEachFaultOfAFormulaAndOfAnExpression) {
    const auto said = [](const std::string& text, SyntaxOf of) {
        const Syntax tree = read_syntax(text, {.text = of, .has_quoted_names = true, .has_bars = true});
        const Syntax* const fault = first_fault(tree);
        return fault == nullptr ? "" : words_of(*fault, of).in(Language::en);
    };
    EXPECT_EQ(said("2*", SyntaxOf::formula), "the formula ends where a number, a name or a bracket is wanted");
    EXPECT_EQ(said("2*", SyntaxOf::expression), "the expression ends where a number, a name or a bracket is wanted");
    EXPECT_EQ(said("2 × a", SyntaxOf::formula), "a product is written \"*\" in a formula");
    EXPECT_EQ(said("2 x + 1", SyntaxOf::expression), "\"x + 1\": a product is written \"*\" in an expression");
    EXPECT_EQ(said("2 * ]", SyntaxOf::formula),
              "\"]\" is not understood here; +, -, *, /, ^, brackets, numbers with units and names are");
    EXPECT_EQ(said("|a", SyntaxOf::expression), "a bar \"|\" is not closed");
    EXPECT_EQ(said("'a", SyntaxOf::expression), "a quotation mark ' is not closed");
    EXPECT_EQ(said("(a", SyntaxOf::expression), "a bracket is not closed");
    std::string powers = "2";
    for (int i = 0; i < 100; ++i) powers += "^2";
    EXPECT_EQ(said(powers, SyntaxOf::formula), "");
    powers += "^2";
    EXPECT_EQ(said(powers, SyntaxOf::formula), "too many powers upon each other");
    EXPECT_EQ(said(powers, SyntaxOf::expression),
              "an expression with more than 100 brackets within each other; write it shorter, with constants");
    EXPECT_EQ(said(std::string(1001, '1'), SyntaxOf::expression),
              "an expression of more than 1000 characters; shorten it");
    EXPECT_EQ(said(std::string(1001, '1'), SyntaxOf::formula), "");
    EXPECT_EQ(said(std::string(100'001, '1'), SyntaxOf::formula),
              "a formula of more than 100000 characters; name a part of it as a parameter");
}

TEST(FormulaSyntax, IsRefusedByItsFirstFault) {
    const LookUp nothing = [](std::string_view name) -> tl::expected<Measured, Words> {
        return tl::make_unexpected(Words("no " + std::string(name)));
    };
    const auto formula = [&](const std::string& text) {
        return evaluate("=" + text, nothing).error().in(Language::en);
    };
    EXPECT_EQ(formula("1/0 + )"), "the formula divides by zero");
    EXPECT_EQ(formula(") + 1/0"),
              "\") + 1/0\" is not understood here; +, -, *, /, ^, brackets, numbers with units and names are");
    EXPECT_EQ(formula("(x + (2"), "no x");
    EXPECT_EQ(formula("((2 + x"), "no x");
    EXPECT_EQ(formula("(2 y + x"), "unknown unit \"y\"");
    const auto expression = [&](const std::string& text) {
        NamedConstants constants;
        return read_expression(text, {.variable = "t"}, nothing, constants).error().in(Language::en);
    };
    EXPECT_EQ(expression("1/0 + )"), "the expression divides by zero");
    EXPECT_EQ(expression("t(3)"), "\"(3)\": a product is written \"*\" in an expression");
    EXPECT_EQ(expression("(2 t + 3 t)"), "\"t + 3 t)\": a product is written \"*\" in an expression");
    EXPECT_EQ(expression("sin(t, 2)"), "sin is written sin(x), with one value between the brackets");
    EXPECT_EQ(expression("cot(t"),
              "\"cot\" is no function known here; there are sqrt, sin, cos, tan, asin, acos, atan, "
              "sinh, cosh, tanh, exp, log");
}

}  // namespace
}  // namespace kinegraph::formula_syntax_test
