// Results on request: instant centres, powers, transmission angles, the mechanical advantage as columns, alone and in
// expressions, against laws, closed forms and the results file; what is infinite or not determined has no number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/results/result_names.hpp"
#include "engine/results/results.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/result_values.hpp"
#include "kinegraph/kinegraph.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::results_on_request_test {
namespace {

using Json = nlohmann::json;

/// A text with a member put before its points.
std::string with(std::string text, const std::string& member) {
    return text.insert(text.find("\"points\""), member + ", ");
}
std::string example_text(const std::string& name) { return tests::contents(tests::example_file(name)); }
Json results_of(const Solution& solution) {
    return Json::parse(results_json(solution, false, [](const Message&) { return std::string(); }));
}
double value_of(const Solution& solution, const std::string& name) {
    const auto all = named_results(solution);
    const NamedResult* const found = result_named(all, name);
    EXPECT_NE(found, nullptr) << name;
    return found == nullptr ? std::nan("") : found->value;
}
bool is_power(const Column& column) {
    return result_kind(column.quantity).unit == QuantityKind::power && result_kind(column.quantity).on_request;
}

struct Rows {
    std::vector<SweepColumn> columns;
    std::vector<SweepRow> rows;
    std::vector<SweepPole> poles;

    std::optional<double> at(std::size_t row, const std::string& name) const {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i].name == name) return rows[row][i];
        ADD_FAILURE() << "there is no column " << name;
        return std::nullopt;
    }
};
Rows rows_of(const std::string& text, SweepOptions options) {
    const auto file = MechanismFile::parse(text, "test.json");
    if (!file) throw std::runtime_error(text);
    auto sweep = Sweep::of(*file, options);
    if (!sweep) throw std::runtime_error(options.columns);
    Rows found;
    found.rows = *sweep->rows();
    found.columns = sweep->columns();
    found.poles = sweep->poles();
    EXPECT_FALSE(found.rows.empty());
    for (const SweepRow& row : found.rows)
        for (const auto& cell : row) EXPECT_TRUE(!cell || std::isfinite(*cell));
    return found;
}
Rows rows_of(const std::string& text, const std::string& columns, long steps = 24) {
    SweepOptions options;
    options.columns = columns;
    options.steps = steps;
    return rows_of(text, options);
}

// --- the results file

TEST(ResultsOnRequest, AreThoseOfTheResultsFile) {
    int centres = 0, powers = 0, angles = 0;
    for (const char* name : {"four_bar", "gas_force", "four_bar_inertia", "planetary_train", "whitworth"}) {
        const Solution& solution = tests::example(name);
        const Json json = results_of(solution);
        for (const auto& [pair, centre] : json["instant centres"].items()) {
            if (!centre.contains("at")) continue;
            std::string bodies = pair;
            if (bodies.size() == 3) bodies.erase(1, 1);
            EXPECT_EQ(value_of(solution, "x P" + bodies), centre["at"][0]) << name << pair;
            EXPECT_EQ(value_of(solution, "y P" + bodies), centre["at"][1]) << name << pair;
            ++centres;
        }
        if (json.contains("power"))
            for (const auto& [section, values] : json["power"].items())
                for (const auto& [of, power] : values.items()) {
                    const std::string before = section == "weights"          ? "weight "
                                               : section == "inertia forces" ? "inertia "
                                                                             : "";
                    EXPECT_EQ(value_of(solution, "power " + before + of), power) << name;
                    ++powers;
                }
        if (json.contains("transmission angles"))
            for (const auto& [of, angle] : json["transmission angles"].items()) {
                EXPECT_EQ(value_of(solution, "transmission angle " + of), angle) << name;
                ++angles;
            }
    }
    EXPECT_GT(centres, 15);
    EXPECT_GT(powers, 4);
    EXPECT_GT(angles, 2);
}

TEST(ResultsOnRequest, HaveNamesThatTheMechanismAloneTells) {
    for (const char* name : {"four_bar", "gas_force", "four_bar_inertia", "watt_six_bar", "jansen_leg"}) {
        const Solution& solution = tests::example(name);
        const std::vector<Column> possible = possible_results(solution.mechanism);
        int seen = 0;
        for (const NamedResult& each : named_results(solution)) {
            if (!result_kind(each.column.quantity).on_request) continue;
            ++seen;
            const auto is_it = [&](const Column& other) {
                return other.name == each.column.name && other.quantity == each.column.quantity;
            };
            EXPECT_EQ(std::count_if(possible.begin(), possible.end(), is_it), 1) << name << ": " << each.column.name;
        }
        EXPECT_GT(seen, 4) << name;
    }
}

// --- centres

TEST(Centres, AreTheMeetsOfTheCranksInEveryRow) {
    const std::string text = example_text("four_bar");
    const Solution& drawn = tests::example("four_bar");
    const auto place = [&](const char* point) {
        const Vector& at = drawn.pose.at(*drawn.mechanism.point_named(point));
        return std::array{at.x.to_double(), at.y.to_double()};
    };
    const auto o2 = place("O2"), o4 = place("O4");
    const Rows found = rows_of(text, "x P13, y P13, x A, y A, x B, y B, |P13 - P14|");
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        // P13 lies on both cranks.
        const double ax = *found.at(i, "x A") - o2[0], ay = *found.at(i, "y A") - o2[1],
                     bx = *found.at(i, "x B") - o4[0], by = *found.at(i, "y B") - o4[1], across = ax * by - ay * bx;
        const double share = ((o4[0] - o2[0]) * by - (o4[1] - o2[1]) * bx) / across;
        ASSERT_TRUE(found.at(i, "x P13"));
        EXPECT_NEAR(*found.at(i, "x P13"), o2[0] + share * ax, 1e-9 * (1 + std::abs(share)));
        EXPECT_NEAR(*found.at(i, "y P13"), o2[1] + share * ay, 1e-9 * (1 + std::abs(share)));
        EXPECT_NEAR(*found.at(i, "|P13 - P14|"),
                    std::hypot(*found.at(i, "x P13") - o4[0], *found.at(i, "y P13") - o4[1]),
                    1e-9 * (1 + std::abs(share)));
    }
}

TEST(Centres, AtInfinityHaveNoNumber) {
    // The coupler of a parallelogram translates, and so does a slider against the frame.
    const Rows coupler = rows_of(example_text("parallel_crank"), "x P13, 1 / x P13, x P24", 8);
    for (std::size_t i = 0; i < coupler.rows.size(); ++i) EXPECT_FALSE(coupler.at(i, "x P13"));
    const Rows slider = rows_of(example_text("slider_crank"), "x P14, y P14, x P24", 8);
    for (std::size_t i = 0; i < slider.rows.size(); ++i) {
        EXPECT_FALSE(slider.at(i, "x P14"));
        EXPECT_FALSE(slider.at(i, "y P14"));
        EXPECT_TRUE(slider.at(i, "x P24"));
    }
    const auto asked = asked_results(tests::solved(with(example_text("slider_crank"), R"("ask": ["x P14"])")));
    ASSERT_FALSE(asked);
    EXPECT_EQ(asked.error().front().code, ErrorCode::no_unique_answer);
    EXPECT_EQ(asked.error().front().where, "/ask/0");
    EXPECT_EQ(asked.error().front().message.in(Language::en), "\"x P14\" lies at infinity in this position");
}

TEST(Centres, GoToInfinityWhereTheCrankIsAcrossTheGuide) {
    // P13 is the meet of the crank's line and the normal of the guide at B: y = x tan φ.
    const Rows found = rows_of(example_text("slider_crank"), "x B, y P13, angle 2", 36);
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto y = found.at(i, "y P13");
        if (!y) continue;
        EXPECT_NEAR(*y, *found.at(i, "x B") * std::tan(*found.at(i, "angle 2")), 1e-9 * (1 + std::abs(*y)));
    }
    std::vector<double> poles;
    for (const SweepPole& each : found.poles)
        if (each.column == "y P13") poles.push_back(each.at);
    ASSERT_EQ(poles.size(), 2U);
    EXPECT_NEAR(poles[0], std::numbers::pi / 6, 1e-8) << "drawn at 60°";
    EXPECT_NEAR(poles[1], std::numbers::pi * 7 / 6, 1e-8);
    EXPECT_FALSE(found.at(3, "y P13")) << "the row at 30°, with the crank upright";
}

TEST(Centres, AreWrittenWithACommaWherePointsLookLikeThem) {
    std::string text = example_text("slider_crank");
    for (std::size_t at = 0; (at = text.find("\"G\"", at)) != std::string::npos;) text.replace(at, 3, "\"P13\"");
    const Solution solution = tests::solved(text);
    EXPECT_EQ(value_of(solution, "x P13"), solution.pose.at(*solution.mechanism.point_named("P13")).x.to_double());
    const Json json = results_of(solution);
    EXPECT_EQ(value_of(solution, "x P1,3"), json["instant centres"]["1,3"]["at"][0]);
    const Rows found = rows_of(text, "'x P1,3', 'x P1,3' - x P13", 4);
    ASSERT_EQ(found.columns.size(), 3U);
    EXPECT_EQ(found.columns[1].name, "'x P1,3'");
    EXPECT_DOUBLE_EQ(*found.rows[0][1] - value_of(solution, "x P13"), *found.rows[0][2]);
}

// --- powers

TEST(Powers, AddUpToZero) {
    int driven = 0;
    for (const char* name : {"gas_force", "four_bar_inertia", "four_bar_weights", "engine_inertia_gas", "car_bonnet",
                             "cutting_force", "excavator_arm", "toggle_clamp", "sluice_gate_travel"}) {
        const Solution& solution = tests::example(name);
        double sum = 0, largest = 0;
        int count = 0;
        for (const NamedResult& each : named_results(solution)) {
            if (!is_power(each.column)) continue;
            sum += each.value;
            largest = std::max(largest, std::abs(each.value));
            ++count;
        }
        if (count == 0) continue;  // nothing drives it
        ++driven;
        EXPECT_NEAR(sum, 0, 1e-12 * largest) << name;
        EXPECT_GE(count, 2) << name;
    }
    EXPECT_GE(driven, 4);
}

TEST(Powers, AddUpToZeroInEveryRow) {
    for (const char* name : {"gas_force", "four_bar_inertia", "four_bar_weights", "engine_inertia_gas"}) {
        std::string names, sum;
        for (const NamedResult& each : named_results(tests::example(name))) {
            if (!is_power(each.column)) continue;
            names += (names.empty() ? "" : ", ") + each.column.name;
            sum += (sum.empty() ? "" : " + ") + each.column.name;
        }
        ASSERT_FALSE(names.empty()) << name;
        const Rows found = rows_of(example_text(name), names + ", " + sum, 16);
        for (const SweepRow& row : found.rows) {
            double largest = 1e-12;
            for (std::size_t i = 1; i + 1 < row.size(); ++i) largest = std::max(largest, std::abs(row[i].value()));
            EXPECT_NEAR(row.back().value(), 0, 1e-10 * largest) << name;
        }
    }
}

TEST(Powers, AreForceTimesVelocityAndCoupleTimesAngularVelocity) {
    const Rows found = rows_of(example_text("gas_force"), "power F_gas, vx B, power M, 'effort M' * omega 2", 24);
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        EXPECT_NEAR(*found.at(i, "power F_gas"), -2000 * *found.at(i, "vx B"), 1e-9);
        EXPECT_NEAR(*found.at(i, "power M"), -*found.at(i, "power F_gas"), 1e-9);
        EXPECT_NEAR(*found.at(i, "power M"), *found.at(i, "'effort M' * omega 2"), 1e-9);
    }
}

TEST(Powers, OfASpringAreThatOfBothItsEnds) {
    // A spring between crank and coupler: k (l − l0) dl/dt, from the rows themselves.
    const std::string text = R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 60}, "C": [-40, 20],
                   "B": {"meet": [{"circle": "A", "radius": 150}, {"line": "O", "angle": 0}], "near": [170, 0]},
                   "D": {"from": "O", "to": "A", "ratio": 0.5}, "G": {"from": "A", "to": "B", "ratio": 0.5}},
        "bodies": {"2": ["O", "A", "D"], "3": ["A", "B", "G"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 2, "omega": 10}],
        "loads": [{"spring": "S", "bodies": [2, 3], "between": ["D", "G"], "stiffness": "400 N/m",
                   "free length": 30}], "effort": {"couple": "M", "body": 2}})";
    const Rows found = rows_of(text, "power S, power M, x D, y D, x G, y G, vx D, vy D, vx G, vy G", 12);
    double largest = 0;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto of = [&](const char* name) { return found.at(i, name).value(); };
        const double dx = of("x G") - of("x D"), dy = of("y G") - of("y D"), l = std::hypot(dx, dy);
        const double rate = (dx * (of("vx G") - of("vx D")) + dy * (of("vy G") - of("vy D"))) / l;
        EXPECT_NEAR(of("power S"), -400 * (l - 0.03) * rate, 1e-10);
        EXPECT_NEAR(of("power M"), -of("power S"), 1e-10);
        largest = std::max(largest, std::abs(of("power S")));
    }
    EXPECT_GT(largest, 0.1);
}

TEST(Powers, VanishWhereTheMechanismStandsStill) {
    std::string text = example_text("gas_force");
    text.replace(text.find("\"omega\": 10"), 11, "\"omega\": 0");
    const Solution solution = tests::solved(text);
    EXPECT_EQ(value_of(solution, "power F_gas"), 0);
    EXPECT_EQ(value_of(solution, "power M"), 0);
    EXPECT_NE(value_of(solution, "effort M"), 0);
}

TEST(Powers, OfAnEffortAndALoadOfOneNameAreTold) {
    std::string text = example_text("gas_force");
    text.replace(text.find("\"F_gas\""), 7, "\"M\"");
    const Solution solution = tests::solved(text);
    EXPECT_DOUBLE_EQ(value_of(solution, "power M"), -value_of(solution, "power effort M"));
}

// --- transmission angles

TEST(TransmissionAngles, OfARowAreThoseOfItsTriangle) {
    const Rows found = rows_of(example_text("four_bar"), "transmission angle B, angle 3, angle 4", 90);
    double least = 10;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const double angle = found.at(i, "transmission angle B").value();
        const double between = found.at(i, "angle 4").value() - found.at(i, "angle 3").value();
        EXPECT_NEAR(angle, std::asin(std::min(1.0, std::abs(std::sin(between)))), 1e-7);
        least = std::min(least, angle);
    }
    const Solution solution = tests::solved(with(example_text("four_bar"), R"("ask": ["transmission angle"])"));
    const auto asked = asked_results(solution);
    ASSERT_TRUE(asked);
    EXPECT_LE(asked->front().value, least + 1e-12);
    EXPECT_NEAR(asked->front().value, least, 2e-3);
}

TEST(TransmissionAngles, OfEveryCouplerAreTold) {
    const Solution& solution = tests::example("watt_six_bar");
    const Json angles = results_of(solution)["transmission angles"];
    EXPECT_EQ(angles.size(), 2U);
    for (const auto& [name, angle] : angles.items()) {
        EXPECT_GT(angle.get<double>(), 0) << name;
        EXPECT_LE(angle.get<double>(), std::numbers::pi / 2) << name;
    }
}

TEST(TransmissionAngles, TheLeastOneOverAParameter) {
    std::string text = with(example_text("four_bar"), R"("parameters": {"k": 1})");
    SweepOptions options;
    options.over = "k";
    options.from = "1";
    options.to = "3";
    options.steps = 2;
    options.columns = "transmission angle, transmission angle B, k * omega 3";
    const Rows found = rows_of(text, options);
    ASSERT_EQ(found.rows.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(found.at(i, "transmission angle").value(), 45.57 * std::numbers::pi / 180, 1e-4);
        EXPECT_DOUBLE_EQ(found.at(i, "k * omega 3").value(),
                         static_cast<double>(i + 1) * value_of(tests::example("four_bar"), "omega 3"));
    }
}

// --- mechanical advantage

TEST(MechanicalAdvantage, IsTheLoadOverTheEffort) {
    const Rows found = rows_of(example_text("gas_force"), "mechanical advantage, effort M", 24);
    EXPECT_EQ(found.columns[1].unit, "1/m");
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto advantage = found.at(i, "mechanical advantage");
        const double effort = found.at(i, "effort M").value();
        EXPECT_EQ(advantage.has_value(), effort != 0);
        if (!advantage) continue;
        EXPECT_NEAR(*advantage, 2000 / effort, 1e-9 * std::abs(*advantage));
    }
    EXPECT_EQ(std::count_if(found.poles.begin(), found.poles.end(),
                            [](const SweepPole& each) { return each.column == "mechanical advantage"; }),
              2)
        << "the dead points of the crank";
}

TEST(MechanicalAdvantage, IsOfOneLoadAndOneEffort) {
    const auto has_one = [](const Solution& solution) {
        const auto all = named_results(solution);
        return result_named(all, "mechanical advantage") != nullptr;
    };
    EXPECT_TRUE(has_one(tests::example("gas_force")));
    EXPECT_FALSE(has_one(tests::example("four_bar_inertia")));
    EXPECT_FALSE(has_one(tests::example("four_bar")));
    const auto asked = asked_results(tests::solved(
        with(example_text("gas_force"), R"("ask": ["mechanical advantage", "2 * mechanical advantage"])")));
    ASSERT_TRUE(asked);
    EXPECT_DOUBLE_EQ((*asked)[1].value, 2 * (*asked)[0].value);
}

// --- kinetic energy

TEST(KineticEnergy, ChangesByTheWorkThatInertiaForcesTake) {
    constexpr long steps = 1440;
    const Rows found =
        rows_of(example_text("four_bar_inertia"),
                "turn, omega 2, kinetic energy, power inertia 2, power inertia 3, power inertia 4", steps);
    const auto of = [&](std::size_t row, const char* name) { return found.at(row, name).value(); };
    double largest = 0, most_off = 0;
    for (std::size_t i = 1; i + 1 < found.rows.size(); ++i) {
        const double change = (of(i + 1, "kinetic energy") - of(i - 1, "kinetic energy")) /
                              (of(i + 1, "turn") - of(i - 1, "turn")) * of(i, "omega 2");
        const double taken = of(i, "power inertia 2") + of(i, "power inertia 3") + of(i, "power inertia 4");
        largest = std::max(largest, std::abs(taken));
        most_off = std::max(most_off, std::abs(change + taken));
    }
    EXPECT_GT(largest, 1);
    // The difference of neighbours is off by the square of the step, 1/230, times what the third derivative has.
    EXPECT_LT(most_off, 2e-3 * largest);
}

TEST(KineticEnergy, IsThatOfTheReducedInertiaAtTheDriver) {
    const Rows found = rows_of(example_text("four_bar_inertia"), "kinetic energy, reduced inertia, omega 2", 24);
    EXPECT_EQ(found.columns[1].unit, "N m");
    EXPECT_EQ(found.columns[2].unit, "kg m²");
    for (std::size_t i = 0; i < found.rows.size(); ++i)
        EXPECT_NEAR(*found.at(i, "kinetic energy"),
                    *found.at(i, "reduced inertia") * std::pow(*found.at(i, "omega 2"), 2) / 2, 1e-14);
}

TEST(KineticEnergy, CountsCentresAtRestAndCentresThatOtherBodiesCarry) {
    // The crank turns about its centre; the slider's is the pin of the coupler.
    const std::string masses = R"("masses": {"2": {"mass": 3, "centre": "O", "inertia": 0.02},
                                             "4": {"mass": 0.5, "centre": "B"}})";
    const Rows found =
        rows_of(with(example_text("slider_crank"), masses), "kinetic energy, reduced inertia, omega 2, vx B, vy B", 24);
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto of = [&](const char* name) { return found.at(i, name).value(); };
        const double slides = of("vx B") * of("vx B") + of("vy B") * of("vy B");
        EXPECT_NEAR(of("kinetic energy"), 0.01 * of("omega 2") * of("omega 2") + 0.25 * slides, 1e-12);
    }
    std::string at_rest = with(example_text("slider_crank"), masses);
    const std::string key = "\"omega\": ";
    const auto digits = at_rest.find(key) + key.size();
    at_rest.replace(digits, at_rest.find_first_of(",}", digits) - digits, "0");
    const auto all = named_results(tests::solved(at_rest));
    EXPECT_EQ(result_named(all, "kinetic energy")->value, 0);
    EXPECT_EQ(result_named(all, "reduced inertia"), nullptr) << "0 over 0";
}

// --- reactions

TEST(Reactions, AreColumnsWhereTheyAreAskedFor) {
    const Rows found = rows_of(example_text("four_bar_inertia"),
                               "Fx A 3 on 2, Fx A 2 on 3, 'F A 3 on 2' * v A, 'F A 2 on 3' * v A, F O2 1 on 2", 24);
    double largest = 0;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto of = [&](const char* name) { return found.at(i, name).value(); };
        EXPECT_NEAR(of("Fx A 2 on 3"), -of("Fx A 3 on 2"), 1e-12);
        EXPECT_NEAR(of("'F A 2 on 3' * v A"), -of("'F A 3 on 2' * v A"), 1e-12);
        largest = std::max(largest, std::abs(of("'F A 2 on 3' * v A")));
    }
    EXPECT_GT(largest, 1);
    SweepOptions unknown;
    unknown.columns = "F A 1 on 3";
    const auto file = MechanismFile::parse(example_text("four_bar_inertia"), "test.json");
    ASSERT_TRUE(file);
    EXPECT_FALSE(Sweep::of(*file, unknown)) << "A does not join 1 and 3";
}

// --- trusses

TEST(BarForces, AreThoseOfTheResultsFile) {
    int bars = 0;
    for (const char* name : {"truss_simple", "truss_roof_wind"}) {
        const Solution& solution = tests::example(name);
        const Json json = results_of(solution);
        for (const auto& [of, force] : json["bars"].items()) {
            EXPECT_EQ(value_of(solution, "bar " + of), force) << name;
            ++bars;
        }
    }
    EXPECT_EQ(bars, 18);
    const Solution solution =
        tests::solved(with(example_text("truss_simple"), R"("ask": ["bar AB", "bar AB / bar AE"])"));
    const auto asked = asked_results(solution);
    ASSERT_TRUE(asked);
    EXPECT_NEAR((*asked)[0].value, 40000.0 / 3, 1e-6) << "docs/results.md";
    EXPECT_NEAR((*asked)[1].value, -0.8, 1e-12);
}

// --- parameters in expressions

std::string four_bar_with_parameters() {
    return with(example_text("four_bar"), R"("parameters": {"r": "40 mm", "phi": "30°", "k": 3, "l": "= k*r"})");
}

TEST(ParametersInExpressions, AreInSi) {
    const Solution solution =
        tests::solved(with(four_bar_with_parameters(), R"("ask": ["x B / r", "angle 3 - phi", "k * omega 3", "x B - l"],
                                       "require": ["x B / r > k - 100", "omega 3 * r < 10 m/s"])"));
    const auto asked = asked_results(solution);
    ASSERT_TRUE(asked);
    EXPECT_DOUBLE_EQ((*asked)[0].value, value_of(solution, "x B") / 0.04);
    EXPECT_NEAR((*asked)[1].value, value_of(solution, "angle 3") - std::numbers::pi / 6, 1e-12);
    EXPECT_DOUBLE_EQ((*asked)[2].value, 3 * value_of(solution, "omega 3"));
    EXPECT_NEAR((*asked)[3].value, value_of(solution, "x B") - 0.12, 1e-15);
}

TEST(ParametersInExpressions, FaultsHaveTheirPlace) {
    const auto fault = [](const std::string& ask) {
        const auto read = read_mechanism(with(four_bar_with_parameters(), R"("ask": ["omega 3", ")" + ask + "\"]"), "");
        EXPECT_FALSE(read) << ask;
        return read ? std::string() : read.error().front().where + ": " + read.error().front().message.in(Language::en);
    };
    EXPECT_EQ(fault("x B + phi"), "/ask/1: a length and an angle do not go together in a sum");
    EXPECT_EQ(fault("omega 4 - v B"), "/ask/1: a vector and a number do not go together in a difference");
    EXPECT_EQ(fault("r / l"), "/ask/1: no result stands in \"r / l\"");
}

TEST(ParametersInExpressions, FollowTheParameterOfASweep) {
    std::string text = four_bar_with_parameters();
    SweepOptions options;
    options.over = "r";
    options.from = "30 mm";
    options.to = "50 mm";
    options.steps = 2;
    options.columns = "x B / r, x B / l, x B";
    const Rows found = rows_of(text, options);
    ASSERT_EQ(found.rows.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const double r = found.rows[i][0].value();
        EXPECT_NEAR(r, 0.03 + 0.01 * static_cast<double>(i), 1e-15);
        EXPECT_DOUBLE_EQ(found.at(i, "x B / r").value(), found.at(i, "x B").value() / r);
        EXPECT_NEAR(found.at(i, "x B / l").value(), found.at(i, "x B").value() / (3 * r), 1e-12);
    }
    const Rows turning = rows_of(text, "x B / r, x B", 6);
    for (std::size_t i = 0; i < turning.rows.size(); ++i)
        EXPECT_DOUBLE_EQ(turning.at(i, "x B / r").value(), turning.at(i, "x B").value() / 0.04);
}

// --- names and texts

TEST(NamedExpressions, OfNoKindMayBePartsOfOthers) {
    const auto asked = asked_results(
        tests::solved(with(example_text("four_bar"), R"("ask": ["p = x B * vx B * x A^2", "p / x A", "1 / p"])")));
    ASSERT_TRUE(asked);
    EXPECT_NEAR((*asked)[2].value * (*asked)[0].value, 1, 1e-12);
    EXPECT_EQ((*asked)[1].unit, "m³/s");
}

TEST(SweepText, QuotesANameWithAComma) {
    const auto file = MechanismFile::parse(example_text("four_bar"), "four_bar.json");
    ASSERT_TRUE(file);
    SweepOptions options;
    options.steps = 2;
    options.columns = "max(vx A, vx B), vx B";
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep);
    std::string csv;
    ASSERT_TRUE(sweep->write({{RowsText::Form::csv, [&](std::string_view piece) {
                                   csv += piece;
                                   return true;
                               }}}));
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "turn,\"max(vx A, vx B)\",vx B");
}

// --- curvature and forces in part

/// A part of the results file that may be absent.
double number_at(const Json& document, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    return document.contains(place) && document[place].is_number() ? document[place].get<double>() : std::nan("");
}

TEST(CurvatureByName, IsThatOfTheResultsFileAlsoWhereFindDoesNotAskForIt) {
    const Json whole = results_of(tests::example("coupler_curve"));
    const Solution asked = tests::solved(
        with(example_text("four_bar"), R"("ask": ["radius B on 3", "|omega 3| * 'inflection circle 3'"])"));
    for (const auto& [solution, json] :
         {std::pair(&tests::example("coupler_curve"), whole), std::pair(&asked, results_of(asked))}) {
        int radii = 0;
        ASSERT_TRUE(json.contains("curvature"));
        for (const auto& [body, found] : json["curvature"].items()) {
            for (const auto& [point, path] : found["points"].items())
                if (path["radius"].is_number()) {
                    EXPECT_EQ(value_of(*solution, "radius " + point + " on " + body), path["radius"]) << point;
                    ++radii;
                }
            EXPECT_EQ(value_of(*solution, "inflection circle " + body),
                      number_at(found, "/inflection circle/diameter"));
            EXPECT_EQ(value_of(*solution, "x acceleration pole " + body), number_at(found, "/acceleration pole/0"));
            EXPECT_EQ(value_of(*solution, "y acceleration pole " + body), number_at(found, "/acceleration pole/1"));
        }
        EXPECT_GE(radii, 4);
    }
    EXPECT_TRUE(asked_results(asked));
    EXPECT_TRUE(tests::example("four_bar").curvature.empty()) << "it is found on request";
}

/// ρ = v³ / |v × a|, from other columns of the same row.
TEST(CurvatureByName, HasTheRadiusOfTheMotionInEveryRow) {
    const Rows found = rows_of(example_text("coupler_curve"),
                               "radius C on 3, inflection circle 3, x acceleration pole 3, y acceleration pole 3, "
                               "vx C, vy C, ax C, ay C, omega 3, alpha 3, x C, y C",
                               24);
    for (std::size_t row = 0; row < found.rows.size(); ++row) {
        const auto at = [&](const std::string& name) { return *found.at(row, name); };
        const double across = std::abs(at("vx C") * at("ay C") - at("vy C") * at("ax C"));
        const double speed = std::hypot(at("vx C"), at("vy C"));
        EXPECT_NEAR(at("radius C on 3") * across, speed * speed * speed, 1e-9 * speed * speed * speed) << row;
        // a_C = α ∧ KC − ω² KC, with K the pole of accelerations.
        const double x = at("x C") - at("x acceleration pole 3"), y = at("y C") - at("y acceleration pole 3");
        const double square = at("omega 3") * at("omega 3"), size = std::hypot(at("ax C"), at("ay C"));
        EXPECT_NEAR(-at("alpha 3") * y - square * x, at("ax C"), 1e-9 * size) << row;
        EXPECT_NEAR(at("alpha 3") * x - square * y, at("ay C"), 1e-9 * size) << row;
        EXPECT_GT(at("inflection circle 3"), 0);
    }
    EXPECT_GT(found.rows.size(), 20U);
}

TEST(ForcesInPart, HaveTheNamesOfTheChecks) {
    const Solution& plate = tests::example("plate_under_forces");
    const Json of_plate = results_of(plate)["resultant"];
    ASSERT_FALSE(of_plate.empty());
    const std::string body = of_plate.begin().key();
    EXPECT_EQ(value_of(plate, "x resultant " + body), of_plate[body]["force"][0]);
    EXPECT_EQ(value_of(plate, "y resultant " + body), of_plate[body]["force"][1]);
    EXPECT_EQ(value_of(plate, "resultant couple " + body), of_plate[body]["couple"]);
    EXPECT_NEAR(value_of(plate, "resultant " + body),
                std::hypot(of_plate[body]["force"][0].get<double>(), of_plate[body]["force"][1].get<double>()), 1e-9);
    int components = 0;
    const Solution& beam = tests::example("redundant/beam_on_two_hinges");
    const Json forces = results_of(beam)["forces"];
    for (const auto& [joint, actions] : forces.items())
        for (const auto& [action, found] : actions.items())
            if (found.contains("component")) {
                EXPECT_EQ(value_of(beam, "component " + joint + " " + action), found["component"]["value"]);
                ++components;
            }
    EXPECT_GT(components, 0);
}

TEST(SweepText, HasNoColumnOnRequestThatIsNotNamed) {
    const Rows usual = rows_of(example_text("gas_force"), "", 4);
    SweepOptions options;
    options.steps = 4;
    options.plots = {"power M", "y P13"};
    const Rows plotted = rows_of(example_text("gas_force"), options);
    ASSERT_EQ(usual.columns.size(), plotted.columns.size());
    for (std::size_t i = 0; i < usual.columns.size(); ++i) EXPECT_EQ(usual.columns[i].name, plotted.columns[i].name);
    EXPECT_EQ(usual.rows, plotted.rows);
}

/// The value at "bodies/*/omega" of a document, `*` being the subject; null: there is none.
Json at_place(const Json& document, std::string_view place, const std::string& subject) {
    const Json* here = &document;
    while (here->is_object()) {
        const std::size_t end = place.find('/');
        const std::string_view step = place.substr(0, end);
        const auto next = here->find(step == "*" ? subject : std::string(step));
        if (next == here->end()) return {};
        here = &*next;
        if (end == std::string_view::npos) return *here;
        place.remove_prefix(end + 1);
    }
    return {};
}

TEST(ResultsFile, HasEachResultWhereTheCatalogueSays) {
    std::set<std::string_view> places;
    for (const char* const name : {"exam_2001", "engine_inertia_gas", "four_bar_weights", "truss_simple"}) {
        const Solution solution = tests::solved(example_text(name));
        const Json document = results_of(solution);
        for_each_result(solution, [&](const Quantity& quantity, const auto& found) {
            const std::string_view place = result_kind(quantity).in_file;
            if (place.find('/') == std::string_view::npos) return;
            const Json value = at_place(document, place, subject_of(quantity, solution));
            Json expected;
            if constexpr (requires { found->to_double(); }) expected = found->to_double();
            if constexpr (requires { found->x; }) expected = {found->x.to_double(), found->y.to_double()};
            EXPECT_EQ(value, expected) << name << " " << place;
            places.insert(place);
        });
    }
    for (const ResultKind& kind : result_kinds())
        EXPECT_TRUE(kind.in_file.find('/') == std::string_view::npos || places.contains(kind.in_file)) << kind.in_file;
}

}  // namespace
}  // namespace kinegraph::results_on_request_test
