// Exercises: what a file says of its variants, the lattice of values and its order, and variants themselves, with their
// conditions held against the numeric check.
#include "engine/mechanism/exercise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

#include "constructions/positions/variants.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/reading/file_text.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/sheet/key_sheet.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/files.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/schema_gate.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::exercise_test {
namespace {

const std::vector<std::string> names{"four_bar",    "slider_crank", "quick_return", "six_bar", "planetary_train",
                                     "sluice_gate", "truss",        "cam",          "impact",  "exam"};

std::string example_text(const std::string& name) { return tests::contents(tests::example_file("variants/" + name)); }

/// A crank with some parameters, and members of the file in their place.
std::string crank(const std::string& more, const std::string& parameters = "", const std::string& omega = "k") {
    return R"({"kinegraph": 1, "parameters": {"r": "40 mm", "phi": "60°", "k": 3)" + parameters + "}, " + more +
           R"(, "points": {"O": [0, 0], "A": {"from": "O", "distance": "= r", "angle": "= phi"}},
           "bodies": {"2": ["O", "A"]},
              "joints": [{"revolute": "O", "bodies": [0, 2]}], "drivers": [{"body": 2, "omega": "= )" +
           omega + "\"}]}";
}
std::vector<std::string> faults(const std::string& more, const std::string& parameters = "",
                                const std::string& omega = "k", const std::vector<Setting>& set = {}) {
    std::vector<std::string> lines;
    const auto read = read_mechanism(crank(more, parameters, omega), "test.json", set);
    if (!read)
        for (const Error& each : read.error()) lines.push_back(each.where + ": " + each.message.in(Language::en));
    return lines;
}
Mechanism read(const std::string& text) {
    auto mechanism = read_mechanism(text, "test.json");
    if (!mechanism)
        throw std::runtime_error(mechanism.error().front().where + ": " +
                                 mechanism.error().front().message.in(Language::en));
    return *std::move(mechanism);
}
const auto always = [](const Solution&, Condition::Polygon) { return true; };

/// How many variants of each example are looked at: few, or as many as bench/variants_bench.sh asks for; then of all
/// examples.
std::size_t asked_for() {
    const char* const count = std::getenv("KINEGRAPH_VARIANTS");
    return count == nullptr ? 0 : std::strtoul(count, nullptr, 10);
}
std::size_t count_of(int usual, int sanitized) {
    return asked_for() > 0 ? asked_for() : static_cast<std::size_t>(unless_sanitized(usual, sanitized));
}

// --- vary
// ---------------------------------------------------------------------------------------------------------------------

TEST(Vary, GoesInExactStepsInTheUnitOfTheFile) {
    const Mechanism m = read(crank(
        R"("vary": {"r": {"from": "35 mm", "to": "61 mm", "step": "0.5 cm"},
            "phi": {"choose": ["30°", "45°"]}, "k": {"from": 0.1, "to": 0.4, "step": 0.1}})"));
    const std::vector<Variation>& vary = m.exercise->vary;
    ASSERT_EQ(vary.size(), 3U);
    EXPECT_EQ(vary[0].count, 6U) << "the last is no more than \"to\"";
    EXPECT_EQ(vary[0].value(0), "35 mm");
    EXPECT_EQ(vary[0].value(5), "60 mm");
    EXPECT_EQ(vary[1].value(1), "45°");
    EXPECT_EQ(vary[2].count, 4U) << "no rounding: 0.1 + 3 · 0.1 is 0.4";
    EXPECT_EQ(vary[2].value(2), "0.3");
    EXPECT_EQ(Lattice::size(vary), 48U);
    // No decimal in inches: told in the step's unit; nor in that: as a fraction.
    const Mechanism inches = read(crank(R"("vary": {"r": {"from": "1 in", "to": "3 in", "step": "1 mm"}})"));
    EXPECT_EQ(inches.exercise->vary[0].value(1), "26.4 mm");
    const Mechanism radians = read(crank(R"("vary": {"phi": {"from": "1°", "to": "3 rad", "step": "1 rad"}})"));
    const std::string second = radians.exercise->vary[0].value(1);
    EXPECT_TRUE(second.starts_with("= ")) << second;
    EXPECT_NEAR(read_measured(second, {})->value.to_double(), 1 + 180 / std::acos(-1.0), 1e-12);
}

TEST(Vary, FaultsNameThePlaceAndTheRemedy) {
    using Lines = std::vector<std::string>;
    EXPECT_EQ(faults(R"("vary": {"R": {"choose": [1]}})"),
              Lines{"/vary/R: no parameter is named \"R\" (did you mean \"r\"?); what varies stands among the "
                    "\"parameters\", with a "
                    "value of its own"});
    EXPECT_EQ(faults(R"("vary": {"r": {"choose": ["30°"]}})"),
              Lines{"/vary/r/choose/0: 30° is an angle; the parameter’s own value is a length"});
    EXPECT_EQ(faults(R"("vary": {"r": {"choose": ["10 mm", "1 cm"]}})"),
              Lines{"/vary/r/choose/1: 1 cm stands twice; two copies would be the same"});
    EXPECT_EQ(faults(R"("vary": {"k": {"from": 2, "to": 1, "step": 1}})"),
              Lines{"/vary/k/to: \"to\" lies before \"from\"; exchange them"});
    EXPECT_EQ(faults(R"("vary": {"k": {"from": 1, "to": 2, "step": 0}})"),
              Lines{"/vary/k/step: \"step\" must be greater than zero"});
    EXPECT_EQ(faults(R"("vary": {"k": {"from": 1, "to": 2, "step": 1e-7}})"),
              Lines{"/vary/k/step: more than 1000000 values; take a larger step"});
    EXPECT_EQ(faults(R"("vary": {"k": {"from": "= 1", "to": 2, "step": 1}})"),
              Lines{"/vary/k/from: a number or a quantity is wanted here; a formula stands among the \"parameters\""});
    const std::string same =
        "/vary/u: nothing hangs on \"u\": copies that differ in it alone would be the same; write \"= u\" "
        "where it counts, or take it out of \"vary\"";
    EXPECT_EQ(faults(R"("vary": {"u": {"choose": [1, 2]}}, "require": ["u > 1"])", R"(, "u": 1)"), Lines{same});
    EXPECT_EQ(faults(R"("vary": {"u": {"choose": [1, 2]}})", R"(, "u": 1, "w": "= 2*u")"), Lines{same}) << "nor on w";
    EXPECT_EQ(faults(R"("vary": {"u": {"choose": [1, 2]}})", R"(, "u": 1, "w": "= 2*u", "q": "= w")", "q"), Lines{});
    EXPECT_EQ(faults(R"("vary": {"w": {"choose": [1, 2]}})", R"(, "u": 1, "w": "= 2*u")", "w"),
              Lines{"/vary/w: \"w\" is a formula, and what varies has a value of its own; let vary what it hangs on, "
                    "or give it a value"});
    EXPECT_EQ(faults(R"("vary": {"k": {"from": 1, "to": 2}})").size(), 1U);
    EXPECT_EQ(faults(R"("vary": {})").size(), 1U);
    EXPECT_EQ(faults(R"("vary": {"k": {"choose": []}})").size(), 1U);
}

TEST(Vary, WhatIsSetFromOutsideIsToldAsSuch) {
    const std::string vary = R"("vary": {"phi": {"choose": ["30°", "60°"]}})";
    EXPECT_EQ(faults(vary, "", "k", {{"phi", "0"}}),
              std::vector<std::string>{
                  ": --set phi=0 is a bare number; the file’s own value, and all that \"vary\" gives it, is an "
                  "angle: set such a one"});
    EXPECT_EQ(faults(vary, "", "k", {{"phi", "0°"}}), std::vector<std::string>{});
    // A value in place of a formula cuts off what the formula hangs on.
    EXPECT_EQ(faults(R"("vary": {"u": {"choose": [1, 2]}})", R"(, "u": 1, "w": "= 2*u")", "w", {{"w", "3"}}),
              std::vector<std::string>{});
}

// --- require
// ------------------------------------------------------------------------------------------------------------------

TEST(Require, ReadsComparisonsOfParametersAndResults) {
    const auto decided = [](const std::string& condition) {
        const Mechanism m = read(crank("\"require\": [\"" + condition + "\"]"));
        return m.exercise->require.front().holds;
    };
    EXPECT_EQ(decided("r >= 2*k*1 mm + 34 mm"), true) << "exactly equal";
    EXPECT_EQ(decided("r > 40 mm"), false);
    EXPECT_EQ(decided("r ≤ 4 cm"), true);
    EXPECT_EQ(decided("0.1 + 0.2 = 0.3"), true);
    EXPECT_EQ(decided("sqrt(k)^2 = 3"), true) << "what roots leave open is zero";
    EXPECT_EQ(decided("phi between 60° and 1.1 rad"), true);
    EXPECT_EQ(decided("k between 4 and 5"), false);
    EXPECT_EQ(decided("omega 2 > 2"), std::nullopt) << "the solution tells";
}

TEST(Require, HoldsOfResultsInTheirUnits) {
    const Solution solution = tests::solved(crank(
        R"("require": ["omega 2 > 20 rpm", "omega 2 = 3", "|v A| <= 0.1 m/s", "abs(vx A) between 0.1 and 0.11",
        "vx A > vy A",
            "v A = k*r/1 s", "angle 2 <= 59°"])"));
    const auto results = results_for(*solution.mechanism.exercise, solution);
    std::vector<bool> held;
    for (const Condition& each : solution.mechanism.exercise->require) {
        const auto fits = holds(each, solution, results);
        ASSERT_TRUE(fits) << each.text << ": " << fits.error().front().message.in(Language::en);
        held.push_back(*fits);
    }
    // v = 0.12 m/s, its components −0.12 sin 60° and 0.12 cos 60°.
    EXPECT_EQ(held, (std::vector<bool>{true, true, false, true, false, true, false}));
    EXPECT_TRUE(crank_turns_fully(solution.mechanism, solution.pose));
}

TEST(Require, FaultsNameThePlaceAndTheRemedy) {
    const auto first = [](const std::string& condition) {
        const auto lines = faults("\"require\": [\"" + condition + "\"]");
        return lines.size() == 1 ? lines.front() : std::to_string(lines.size()) + " faults";
    };
    EXPECT_EQ(
        first("omega 22 > 1"),
        "/require/0: \"omega 22\" is neither a result nor a formula of the parameters (did you mean \"omega 2\"?)");
    EXPECT_EQ(first("omega 2 > 1 m"), "/require/0: \"omega 2\" is an angular velocity, and \"1 m\" is a length");
    EXPECT_EQ(first("omega 2 > vx A"), "/require/0: \"omega 2\" is an angular velocity, and \"vx A\" is a velocity");
    EXPECT_NE(first("r > 3").find("the bare number wants a unit"), std::string::npos) << first("r > 3");
    EXPECT_EQ(first("0 < k < 5"),
              "/require/0: one comparison at a time; write \"… between … and …\", or two conditions");
    EXPECT_EQ(first("k between 1"), "/require/0: \"between\" wants two limits: \"… between … and …\"");
    EXPECT_EQ(first("omega 2 between 1 rad/s and 5 rpm"),
              "/require/0: never holds, for \"1 rad/s\" is more than \"5 rpm\"; exchange the limits");
    EXPECT_EQ(first("k between 2 and 1"), "/require/0: never holds, for \"2\" is more than \"1\"; exchange the limits");
    EXPECT_EQ(faults(R"("require": ["omega 2 between k and 1", "omega 2 between 1 and 1"])").size(), 0U)
        << "k may vary";
    for (const std::string sign : {"!=", "==", "<>", "≠", "=>"})
        EXPECT_EQ(first("r " + sign + " 35 mm"), "/require/0: " + sign +
                                                     " is not among the comparisons; they are >, >=, <, <=, =, "
                                                     "and \"… between … and …\"");
    EXPECT_EQ(first("> 5"), "/require/0: a side of the condition is empty");
    EXPECT_NE(first("crank turn fully").find("(did you mean \"crank turns fully\"?)"), std::string::npos);
    EXPECT_NE(first("k > 1/0").find("divides by zero"), std::string::npos) << first("k > 1/0");
}

// --- the order of draws
// -------------------------------------------------------------------------------------------------------

TEST(Shuffle, GoesThroughAllNumbersOnce) {
    for (const std::uint64_t size : {1U, 2U, 3U, 17U, 256U, 1000U}) {
        const Shuffle shuffle(7, size);
        std::set<std::uint64_t> seen;
        for (std::uint64_t i = 0; i < size; ++i) seen.insert(shuffle.at(i));
        EXPECT_EQ(seen.size(), size);
        EXPECT_EQ(*seen.rbegin(), size - 1);
    }
    // The same on every machine.
    const Shuffle large(7, Lattice::most);
    EXPECT_EQ(large.at(0), Shuffle(7, Lattice::most).at(0));
    EXPECT_NE(large.at(0), Shuffle(8, Lattice::most).at(0));
    EXPECT_LT(large.at(Lattice::most - 1), Lattice::most);
}

// --- variants
// -----------------------------------------------------------------------------------------------------------------

std::vector<Variant> drawn(const std::string& text, std::uint64_t seed, std::size_t count) {
    auto variants = Variants::of(text, "test.json", {}, seed);
    if (!variants) throw std::runtime_error(variants.error().front().message.in(Language::en));
    std::vector<Variant> all;
    while (all.size() < count) {
        auto next = variants->next(always);
        if (!next)
            throw std::runtime_error(next.error().front().where + ": " + next.error().front().message.in(Language::en));
        if (!*next) break;
        all.push_back(**std::move(next));
    }
    return all;
}
std::vector<std::string> values_of(const Variant& variant) {
    std::vector<std::string> values;
    for (const Setting& each : variant.values) values.push_back(each.value);
    return values;
}

/// The results with the numbers of the check in place of those of the construction.
std::vector<NamedResult> by_check(const Variant& variant, std::size_t& held) {
    const Solution& solution = variant.solution;
    std::vector<NamedResult> results = results_for(*solution.mechanism.exercise, solution);
    const auto numeric = [&](const Quantity& quantity) -> std::optional<double> {
        for (const CheckRow& row : solution.checks)
            if (row.quantity == quantity) return row.numeric;
        return std::nullopt;
    };
    if (solution.problem) {
        for (NamedResult& each : results)
            for (const ProblemValue& value : solution.problem->values)
                if (value.key == each.column.name && value.numeric) each.value = *value.numeric, ++held;
        return results;
    }
    for (NamedResult& each : results) {
        const Quantity& q = each.column.quantity;
        if (each.column.kind != Column::Kind::result) continue;
        if (is_modulus(each.column)) {
            const auto x = numeric(q.along(Quantity::Component::x)), y = numeric(q.along(Quantity::Component::y));
            if (x && y) each.value = std::hypot(*x, *y), ++held;
        } else if (const auto found = numeric(q)) {
            each.value = *found;
            ++held;
        }
    }
    return results;
}

TEST(Variants, OfEveryTeachingExampleAreSolvedAndMeetTheirConditionsByTheCheck) {
    for (const std::string& name : names) {
        const std::string text = example_text(name);
        EXPECT_TRUE(refused_by_schema(text).empty()) << name;
        std::set<std::vector<std::string>> seen;
        const auto variants = drawn(text, 7, count_of(12, 2));
        ASSERT_EQ(variants.size(), count_of(12, 2)) << name;
        for (const Variant& each : variants) {
            EXPECT_TRUE(seen.insert(values_of(each)).second) << name << ": two are the same";
            EXPECT_TRUE(each.solution.unsolved.empty()) << name;
            EXPECT_EQ(each.results.size(), asked_of(each.solution.mechanism).size());
            std::size_t held = 0;
            const auto checked = by_check(each, held);
            EXPECT_GT(held, 2U) << name;
            for (const Condition& condition : each.solution.mechanism.exercise->require) {
                if (condition.kind == Condition::Kind::crank_turns_fully ||
                    condition.kind == Condition::Kind::polygon_readable)
                    continue;
                EXPECT_TRUE(condition.holds ? *condition.holds : *holds(condition, each.solution, checked))
                    << name << ": " << condition.text;
            }
        }
    }
}

TEST(Variants, CranksTurnFullyByGrashof) {
    const auto variants = drawn(example_text("four_bar"), 3, 8);
    ASSERT_EQ(variants.size(), 8U);
    for (const Variant& each : variants) {
        std::map<std::string, double> v;
        for (const Setting& set : each.values) v[set.name] = read_measured(set.value, {})->value.to_double();
        const double longest = std::max({v["d"], v["l"], v["s"]});
        EXPECT_LT(v["r"] + longest, v["d"] + v["l"] + v["s"] - longest) << "the crank is the shortest link";
    }
}

TEST(Variants, DoNotHangOnHowManyAreWanted) {
    const std::string text = example_text("planetary_train");
    const auto few = drawn(text, 7, 3), many = drawn(text, 7, 9), others = drawn(text, 8, 3);
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(values_of(few[i]), values_of(many[i]));
    EXPECT_NE(values_of(few[0]), values_of(others[0]));
    // The same on every machine.
    EXPECT_EQ(values_of(few[0]), (std::vector<std::string>{"2 mm", "24", "18", "120°", "12 rad/s"}));
}

TEST(Variants, AreCountedWhereTheConditionsLeaveTooFew) {
    auto variants =
        Variants::of(crank(
                         R"("vary": {"k": {"from": 1, "to": 10, "step": 1}, "r": {"choose": ["10 mm", "20 mm"]}},
            "require": ["omega 2 > 7", "r < 15 mm"])"),
                     "test.json", {}, 1);
    ASSERT_TRUE(variants);
    std::size_t count = 0;
    while (*variants->next(always)) ++count;
    EXPECT_EQ(count, 3U) << "8, 9, 10 with 10 mm";
    EXPECT_TRUE(variants->is_exhausted());
    std::uint64_t rejected = 0;
    for (const auto& each : variants->rejections()) rejected += each.count;
    EXPECT_EQ(rejected, 17U);
    EXPECT_EQ(variants->rejections().size(), 2U);
}

TEST(Variants, AFileOfTheirOwnSolvesToTheSame) {
    for (const char* name : {"slider_crank", "impact", "truss"}) {
        const std::string text = example_text(name);
        const auto source = JsonSource::read(text);
        constexpr std::array<std::string_view, 2> without{"vary", "require"};
        const auto variants = drawn(text, 5, 2);
        ASSERT_EQ(variants.size(), 2U);
        for (const Variant& each : variants) {
            const std::string own = file_with(*source, each.values, without);
            EXPECT_EQ(own.find("\"vary\""), std::string::npos);
            const auto asked = asked_results(tests::solved(own, name));
            ASSERT_TRUE(asked);
            ASSERT_FALSE(asked->empty());
            for (std::size_t i = 0; i < asked->size(); ++i) EXPECT_EQ((*asked)[i].value, each.results[i].value) << name;
        }
    }
}

TEST(Variants, HaveSheetsWithoutFaults) {
    using namespace render;
    const auto expect_none = [](const Variant& variant, SheetKind kind, const char* name) {
        SheetOptions options;
        options.kind = kind;
        const std::vector<Page> sheets = lay_out(variant.solution, options, tests::fonts());
        pages::expect_clean(sheets);
        for (const Page& page : sheets)
            for (const render::Fault& fault : faults_of(page, tests::fonts()))
                ADD_FAILURE() << name << ": " << said(fault);
    };
    // As the command chooses them: polygons that are to be read can be.
    const IsReadable is_readable = [](const Solution& solution, Condition::Polygon polygon) {
        return render::is_readable(solution, polygon, {}, tests::fonts());
    };
    const std::vector<std::string> few{"four_bar", "impact", "cam"};
    for (const std::string& name : asked_for() > 0 ? names : few) {
        auto variants = Variants::of(example_text(name), "test.json", {}, 7);
        ASSERT_TRUE(variants) << name;
        const std::size_t count = count_of(2, 1);
        for (std::size_t i = 0; i < count; ++i) {
            const auto variant = variants->next(is_readable);
            ASSERT_TRUE(variant && *variant) << name << ": only " << i;
            expect_none(**variant, SheetKind::question, name.c_str());
            if (asked_for() > 0 || !(*variant)->solution.problem)
                expect_none(**variant, SheetKind::solution, name.c_str());
        }
        if (asked_for() > 0) std::printf("%s: %zu variants\n", name.c_str(), count);
    }
}

TEST(Variants, QuestionsOfProblemsKeepBackWhatIsFound) {
    const Variant variant = drawn(example_text("impact"), 7, 1).front();
    render::SheetOptions options;
    options.kind = render::SheetKind::question;
    const auto question = render::lay_out(variant.solution, options, tests::fonts());
    EXPECT_EQ(question.size(), 1U);
    EXPECT_TRUE(pages::says(question, "Bodies, and velocities before"));
    EXPECT_TRUE(pages::says(question, "energy lost")) << "it is sought";
    EXPECT_FALSE(pages::says(question, "impulse x")) << "it is not";
    for (const char* found : {"and after", "ψ", "oblique", "Results"})
        EXPECT_FALSE(pages::says(question, found)) << found;
}

TEST(Questions, OfAllProblemsAreOneCleanPage) {
    render::SheetOptions options;
    options.kind = render::SheetKind::question;
    for (const std::string& name : tests::example_names("contact")) {
        SCOPED_TRACE(name);
        const Solution& solution = tests::example("contact/" + name);
        ASSERT_FALSE(solution.problem->values.empty());
        const auto question = render::lay_out(solution, options, tests::fonts());
        EXPECT_EQ(question.size(), 1U);
        pages::expect_clean(question);
        for (const char* found : {"and after", "pressures and", "and pressures", "Results"})
            EXPECT_FALSE(pages::says(question, found)) << found;
        for (const ProblemValue& each : solution.problem->values)
            EXPECT_TRUE(pages::says(question, each.name.in(Language::en))) << "sought: " << each.name.in(Language::en);
    }
}

TEST(Variants, HaveAPrintableKeyOnAsManyPagesAsItNeeds) {
    render::KeyTable table{"Key", {{"variant", "", true}}, {}};
    for (int c = 0; c < 30; ++c) table.columns.push_back({"omega " + std::to_string(c), "rad/s", false});
    for (int r = 0; r < 100; ++r) {
        table.rows.push_back({std::to_string(r + 1)});
        for (int c = 0; c < 30; ++c) table.rows.back().push_back(std::to_string(1000 * c + r) + ".5");
    }
    const auto sheets = render::lay_out_key(table, {}, tests::fonts());
    EXPECT_GT(sheets.size(), 4U);
    pages::expect_clean(sheets);
    std::size_t cells = 0;
    for (const render::Page& page : sheets)
        for (const render::TextMark* text : pages::texts_of(page)) cells += text->words.ends_with(".5") ? 1 : 0;
    EXPECT_EQ(cells, 3000U) << "none is lost";
}

}  // namespace
}  // namespace kinegraph::exercise_test
