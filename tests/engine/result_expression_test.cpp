// Expressions of results: random ones against values computed beside them, their errors as bounds, their dimensions,
// and what becomes of them in exercises and sweeps.
#include "engine/results/result_expression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/reading/file_text.hpp"
#include "kinegraph/kinegraph.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::result_expression_test {
namespace {

const std::string four_bar = tests::contents(tests::example_file("four_bar"));

std::vector<NamedResult> results() { return named_results(tests::solved(four_bar)); }
std::vector<Column> columns_of(const std::vector<NamedResult>& all) {
    std::vector<Column> columns;
    for (const NamedResult& each : all) columns.push_back(each.column);
    return columns;
}
std::string fault(const std::string& text) {
    const auto read = ResultExpression::read(text, columns_of(results()));
    return read ? "" : read.error().in(Language::en);
}

// --- random expressions

/// A text, and its value by the text's own making: of values of the parts that may be a little off.
struct Made {
    std::string text;
    Dimension dimension;
    bool is_vector = false;
    std::function<std::array<double, 2>(const std::vector<double>&)> value;
};

class Maker {
public:
    Maker(const std::vector<NamedResult>& results, unsigned seed) : results_(results), random_(seed) {}

    Made any(int depth) {
        if (depth == 0 || one_of(5) == 0) return leaf();
        switch (one_of(5)) {
            case 0: return sum(depth);
            case 1:
            case 2: return product(depth);
            case 3: return quotient(depth);
            default: return function(depth);
        }
    }
    Made scalar(int depth) {
        Made made = any(depth);
        return made.is_vector ? length(std::move(made)) : made;
    }

private:
    std::size_t one_of(std::size_t count) { return random_() % count; }

    std::size_t index_of(const std::string& name) const {
        for (std::size_t i = 0; i < results_.size(); ++i)
            if (results_[i].column.name == name) return i;
        throw std::runtime_error(name);
    }
    Made leaf() {
        static const std::array<std::string, 8> scalars{"omega 3", "omega 4", "alpha 4", "x B",
                                                        "y B",     "vx B",    "ay A",    "angle 3"};
        static const std::array<std::string, 4> vectors{"v A", "v B", "a A", "a B"};
        const std::size_t which = one_of(scalars.size() + vectors.size() + 1);
        if (which < scalars.size()) {
            const std::size_t i = index_of(scalars.at(which));
            const std::string quote = one_of(3) == 0 ? "'" : "";
            return {quote + scalars.at(which) + quote, dimension_of(results_[i].column.unit), false,
                    [i](const std::vector<double>& values) {
                        return std::array{values[i], 0.0};
                    }};
        }
        if (which == scalars.size() + vectors.size())
            return {"(2.5 * omega 3 / omega 3)", {}, false, [](const std::vector<double>&) {
                        return std::array{2.5, 0.0};
                    }};
        const std::string& name = vectors.at(which - scalars.size());
        const std::size_t x = index_of(name.substr(0, 1) + "x" + name.substr(1)),
                          y = index_of(name.substr(0, 1) + "y" + name.substr(1));
        return {name, dimension_of(results_[x].column.unit), true, [x, y](const std::vector<double>& values) {
                    return std::array{values[x], values[y]};
                }};
    }
    /// Of a value and a multiple of itself or, at random, of another of its kind.
    Made sum(int depth) {
        const Made a = any(depth - 1);
        Made b = any(0);
        if (b.is_vector != a.is_vector || b.dimension != a.dimension) b = a;
        const bool minus = one_of(2) == 0;
        return {"(" + a.text + (minus ? " - " : " + ") + "0.25 * " + b.text + ")", a.dimension, a.is_vector,
                [a, b, minus](const std::vector<double>& values) {
                    const auto p = a.value(values), q = b.value(values);
                    const double sign = minus ? -0.25 : 0.25;
                    return std::array{p[0] + sign * q[0], p[1] + sign * q[1]};
                }};
    }
    static Dimension together(const Dimension& a, const Dimension& b, int power) {
        return {a.length + power * b.length, a.mass + power * b.mass, a.time + power * b.time,
                a.angle + power * b.angle};
    }
    Made product(int depth) {
        const Made a = any(depth - 1), b = any(depth - 1);
        return {"(" + a.text + "*" + b.text + ")", together(a.dimension, b.dimension, 1), a.is_vector != b.is_vector,
                [a, b](const std::vector<double>& values) {
                    const auto p = a.value(values), q = b.value(values);
                    if (a.is_vector && b.is_vector) return std::array{p[0] * q[0] + p[1] * q[1], 0.0};
                    if (a.is_vector) return std::array{q[0] * p[0], q[0] * p[1]};
                    return std::array{p[0] * q[0], p[0] * q[1]};
                }};
    }
    Made quotient(int depth) {
        const Made a = any(depth - 1), b = scalar(depth - 1);
        return {"(" + a.text + " / " + b.text + ")", together(a.dimension, b.dimension, -1), a.is_vector,
                [a, b](const std::vector<double>& values) {
                    const auto p = a.value(values), q = b.value(values);
                    return std::array{p[0] / q[0], p[1] / q[0]};
                }};
    }
    static Made length(const Made& a) {
        return {"|" + a.text + "|", a.dimension, false, [a](const std::vector<double>& values) {
                    const auto p = a.value(values);
                    return std::array{a.is_vector ? std::hypot(p[0], p[1]) : std::abs(p[0]), 0.0};
                }};
    }
    Made function(int depth) {
        const Made a = scalar(depth - 1);
        const auto of = [&](const std::string& before, const std::string& after, Dimension dimension, auto apply) {
            return Made{before + a.text + after, dimension, false, [a, apply](const std::vector<double>& values) {
                            return std::array{apply(a.value(values)[0]), 0.0};
                        }};
        };
        switch (one_of(4)) {
            case 0: return of("sqrt(", "^2)", a.dimension, [](double x) { return std::abs(x); });
            case 1: {
                const Dimension square = together(a.dimension, a.dimension, 1);
                return of("(", ")^2", square, [](double x) { return x * x; });
            }
            case 2:
                if (a.dimension.is_a_number()) return of("sin(", ")", {}, [](double x) { return std::sin(x); });
                return length(a);
            default: return of("min(" + a.text + ", 2*", ")", a.dimension, [](double x) { return std::min(x, 2 * x); });
        }
    }

    const std::vector<NamedResult>& results_;
    std::mt19937 random_;
};

std::vector<double> values_of(const std::vector<NamedResult>& all) {
    std::vector<double> values;
    for (const NamedResult& each : all) values.push_back(each.value);
    return values;
}

/// The value where each part may be off by this share of its size.
std::optional<ValueWithin> value_of(const ResultExpression& expression, const std::vector<NamedResult>& all,
                                    double share) {
    std::vector<ValueWithin> parts;
    for (const Column& part : expression.parts()) {
        const double value = result_named(all, part.name)->value;
        parts.push_back({value, share * std::abs(value)});
    }
    return expression.value(parts);
}

TEST(ResultExpressions, AThousandRandomOnesHaveTheirValuesAndBounds) {
    const std::vector<NamedResult> all = results();
    const std::vector<Column> columns = columns_of(all);
    const std::vector<double> values = values_of(all);
    int held = 0;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> off(-1, 1);
    for (unsigned seed = 0; held < 1000 && seed < 5000; ++seed) {
        const Made made = Maker(all, seed).scalar(4);
        const double expected = made.value(values)[0];
        const auto read = ResultExpression::read(made.text, columns);
        ASSERT_TRUE(read) << made.text << ": " << read.error().in(Language::en);
        const auto exact = value_of(*read, all, 0);
        if (!exact || !std::isfinite(expected) || std::abs(expected) > 1e100) continue;
        ++held;
        // Rounding of the parts by some units of their last place, as in both computations.
        const auto rounded = value_of(*read, all, 1e-14);
        if (rounded) {
            EXPECT_NEAR(exact->value, expected, rounded->error) << made.text;
        }
        const auto kind = kind_of(made.dimension);
        if (kind) {
            EXPECT_EQ(read->column().unit, *kind) << made.text;
        }
        constexpr double share = 1e-6;
        const auto within = value_of(*read, all, share);
        if (!within) continue;
        std::vector<double> moved = values;
        for (double& value : moved) value *= 1 + share * off(random);
        EXPECT_LE(std::abs(made.value(moved)[0] - exact->value), within->error + (rounded ? rounded->error : 0))
            << made.text;
    }
    EXPECT_EQ(held, 1000);
}

// --- names and dimensions

TEST(ResultExpressions, FaultsSayWhatDoesNotGoTogether) {
    EXPECT_EQ(fault("omega 4 + v B"), "a vector and a number do not go together in a sum");
    EXPECT_EQ(fault("omega 4 - x B"), "an angular velocity and a length do not go together in a difference");
    EXPECT_EQ(fault("v A + v B"),
              "a vector has no value of its own; write its length, |v A + v B|, or a component of it");
    EXPECT_EQ(fault("x B/v A"), "a quotient by a vector; divide by its length, |…|");
    EXPECT_EQ(fault("sin(x B)"), "sin is taken of an angle, not of a length");
    EXPECT_EQ(fault("v B^2"), "a vector has no power; take its length, |…|, or multiply it by itself");
    EXPECT_EQ(fault("x B^x B"), "an exponent of a result is a written number such as 2 or 1/2");
    EXPECT_EQ(fault("sqrt(x B)"), "no quantity is the root of a length");
    EXPECT_EQ(fault("cosh(1)"),
              "\"cosh\" is no function of results; there are sqrt, sin, cos, tan, atan2, abs, min, max");
    EXPECT_EQ(
        fault("omegaa 4/2"),
        "no result is named \"omegaa 4\" (did you mean \"omega 4\"?); names are those of the columns of \"sweep\"");
    EXPECT_EQ(fault("(omega 4"), "a bracket is not closed");
    EXPECT_EQ(fault("omega 3 = omega 4/2"),
              "\"omega 3\" is the name of a result already; take another name for the expression");
    EXPECT_EQ(fault("a*b = omega 4/2"), "\"a*b\" cannot be the name of an expression; take letters, digits and spaces");
}

TEST(ResultExpressions, ANameWithASignStandsInQuotes) {
    std::string text = four_bar;
    for (std::size_t at = 0; (at = text.find("\"B\"", at)) != std::string::npos;) text.replace(at, 3, "\"B - C\"");
    const auto all = named_results(tests::solved(text));
    const auto value = [&](const std::string& of) { return result_of_expression(of, all); };
    ASSERT_TRUE(value("'x B - C' - x A"));
    EXPECT_DOUBLE_EQ(value("'x B - C' - x A")->value,
                     result_named(all, "x B - C")->value - result_named(all, "x A")->value);
    EXPECT_FALSE(value("x B - C - x A"));
}

TEST(ResultExpressions, HaveTheUnitOfTheirDimension) {
    const std::vector<Column> columns = columns_of(results());
    const auto column = [&](const std::string& text) { return ResultExpression::read(text, columns)->column(); };
    EXPECT_EQ(column("ratio = omega 4 / omega 3").name, "ratio");
    EXPECT_EQ(column("ratio = omega 4 / omega 3").unit, QuantityKind::dimensionless);
    EXPECT_EQ(column("omega 4^2 * x B").unit, QuantityKind::acceleration) << "a radian is a number";
    EXPECT_EQ(column("angle 3 + 10°").unit, QuantityKind::angle);
    EXPECT_EQ(column("angle 3 + pi").unit, QuantityKind::angle);
    EXPECT_EQ(column("v B * a B").si_unit, "m²/s³");
    EXPECT_EQ(column("v B").unit, QuantityKind::velocity) << "the name of a vector alone is its length";
}

// --- exercises and sweeps

TEST(ResultExpressions, AreAskedForAndRequired) {
    const std::string more = R"("ask": ["omega 4", "ratio = omega 4 / omega 3"],
        "require": ["ratio < -3", "|v B|/|v A| < 1", "y B - y A > 2 cm"], "points")";
    std::string text = four_bar;
    text.replace(text.find("\"points\""), 8, more);
    const auto file = read_mechanism(text, "four_bar.json");
    ASSERT_TRUE(file) << file.error().front().message.in(Language::en);
    const Solution solution = tests::solved(text);
    const auto asked = asked_results(solution);
    ASSERT_TRUE(asked);
    ASSERT_EQ(asked->size(), 2U);
    EXPECT_EQ(asked->back().column.name, "ratio");
    EXPECT_NEAR(asked->back().value, solution.bodies[3].omega->to_double() / solution.bodies[2].omega->to_double(),
                1e-12);
    const auto checked = MechanismFile::parse(text, "four_bar.json");
    ASSERT_TRUE(checked);
}

TEST(ResultExpressions, OfAProblemAreMadeOfItsValues) {
    const auto all = named_results(tests::example("variants/impact"));
    const NamedResult* const energy = result_named(all, "energy lost");
    const NamedResult* const impulse = result_named(all, "impulse x");
    ASSERT_TRUE(energy != nullptr && impulse != nullptr);
    ASSERT_NE(impulse->value, 0);
    const auto quotient = result_of_expression("energy lost / impulse x", all);
    ASSERT_TRUE(quotient);
    EXPECT_EQ(quotient->column.unit, QuantityKind::velocity) << "J/(N s) is m/s";
    EXPECT_DOUBLE_EQ(quotient->value, energy->value / impulse->value);
}

TEST(ResultExpressions, MayContainTheTransmissionAngle) {
    std::string text = four_bar;
    text.replace(text.find("\"points\""), 8, R"("ask": ["rest = 90° - transmission angle"], "points")");
    const auto asked = asked_results(tests::solved(text));
    ASSERT_TRUE(asked);
    ASSERT_EQ(asked->size(), 1U);
    // γ ≥ 45.57° over the cycle (as a sweep says).
    EXPECT_NEAR(asked->front().value * 180 / std::acos(-1.0), 90 - 45.57, 0.01);
}

TEST(ResultExpressions, MayBeMadeOfEarlierOnes) {
    const auto file = MechanismFile::parse(four_bar, "four_bar.json");
    ASSERT_TRUE(file);
    SweepOptions options;
    options.steps = 8;
    options.columns = "i = omega 4 / omega 2, i * i, 1 / (i - i), 2 / (1 / (i - i))";
    options.plots = {"i = omega 4 / omega 2"};  // the same once more
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep);
    const auto rows = sweep->rows();
    ASSERT_TRUE(rows && !rows->empty());
    for (const SweepRow& row : *rows) {
        ASSERT_EQ(row.size(), 5U);
        EXPECT_DOUBLE_EQ(*row[2], *row[1] * *row[1]);
        EXPECT_FALSE(row[3] || row[4]) << "what is made of no value has none";
    }
    std::string text = four_bar;
    text.replace(text.find("\"points\""), 8, R"("ask": ["i = omega 4 / omega 2", "i^2"], "points")");
    const auto asked = asked_results(tests::solved(text));
    ASSERT_TRUE(asked);
    EXPECT_DOUBLE_EQ(asked->back().value, asked->front().value * asked->front().value);
}

TEST(ResultExpressions, HaveAPoleWhereTheirDivisorVanishes) {
    const auto file = MechanismFile::parse(four_bar, "four_bar.json");
    ASSERT_TRUE(file);
    std::vector<double> before;
    for (const long steps : {36L, 100L}) {
        SweepOptions options;
        options.steps = steps;
        options.columns = "omega 3, omega 4 / omega 3, omega 3 / (omega 4 - omega 4)";
        auto sweep = Sweep::of(*file, options);
        ASSERT_TRUE(sweep);
        const auto rows = sweep->rows();
        ASSERT_TRUE(rows);
        ASSERT_EQ(sweep->columns().size(), 4U);
        std::vector<double> poles;
        for (const SweepPole& each : sweep->poles())
            if (each.column == "omega 4 / omega 3") poles.push_back(each.at);
        ASSERT_EQ(poles.size(), 2U) << "the coupler's rotation changes its sense twice";
        for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(poles[i], before[i], 1e-9 * 2 * std::acos(-1.0));
        before = poles;
        for (const SweepRow& row : *rows) {
            ASSERT_TRUE(row[1] && row[2]);
            EXPECT_FALSE(row[3]) << "a divisor that is zero everywhere leaves the cell empty";
        }
    }
}

}  // namespace
}  // namespace kinegraph::result_expression_test
