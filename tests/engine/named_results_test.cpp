// Results by the names of a sweep's columns, and what a file asks for.
#include "constructions/positions/named_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "constructions/positions/cycle.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/results/result_names.hpp"
#include "tests/support/files.hpp"
#include "tests/support/schema_gate.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::named_results_test {
namespace {

Mechanism read_or_throw(const std::string& text) {
    auto mechanism = read_mechanism(text, "test.json");
    if (!mechanism) throw std::runtime_error(mechanism.error().front().message.in(Language::en));
    return *std::move(mechanism);
}
/// An example with "ask" added.
std::string asking(const std::string& example, const std::string& ask) {
    std::string text = tests::contents(tests::example_file(example));
    text.insert(text.find('{') + 1, "\"ask\": " + ask + ", ");
    return text;
}
const NamedResult* find(const std::vector<NamedResult>& results, const std::string& name) {
    const auto found =
        std::find_if(results.begin(), results.end(), [&](const auto& each) { return each.column.name == name; });
    return found == results.end() ? nullptr : &*found;
}

TEST(NamedResults, AreTheRowOfASweepInTheDrawnPosition) {
    for (const char* example :
         {"four_bar", "quick_return", "slider_crank", "gas_force", "cam_roller_follower", "sluice_gate_travel"}) {
        const Mechanism mechanism = read_or_throw(tests::contents(tests::example_file(example)));
        const Pose pose = *draw_pose(mechanism);
        auto cycle = Cycle::of(mechanism, pose, 0);
        ASSERT_TRUE(cycle) << example;
        const auto travel = own_travel(mechanism, pose);
        ASSERT_TRUE(travel) << example;
        cycle->begin(travel->second);
        const auto row = cycle->row(0);
        ASSERT_TRUE(row) << example;
        const auto results = named_results(*solve(mechanism));
        std::size_t held = 0;
        for (std::size_t i = 0; i < row->size(); ++i) {
            const Column& column = cycle->columns()[i];
            if (column.kind == Column::Kind::turn || column.kind == Column::Kind::time ||
                column.kind == Column::Kind::slid)
                continue;
            const NamedResult* result = find(results, column.name);
            ASSERT_NE(result, nullptr) << example << ": " << column.name;
            EXPECT_NEAR(result->value, (*row)[i], 1e-9 * std::max(1.0, std::abs((*row)[i])))
                << example << ": " << column.name;
            EXPECT_EQ(result->column.unit, column.unit);
            ++held;
        }
        EXPECT_GT(held, 8U) << example;
    }
}

TEST(NamedResults, KnowTheLengthsOfVectors) {
    const auto results = named_results(tests::example("four_bar"));
    const NamedResult* v = find(results, "v A");
    ASSERT_NE(v, nullptr);
    EXPECT_NEAR(v->value, 0.04 * 4 * std::acos(-1.0), 1e-12) << "120 rpm at 40 mm";
    EXPECT_EQ(v->column.unit, QuantityKind::velocity);
    EXPECT_TRUE(is_modulus(v->column));
    EXPECT_NEAR(find(results, "a B")->value, std::hypot(find(results, "ax B")->value, find(results, "ay B")->value),
                1e-9);
}

TEST(NamedResults, HaveNamesOfTheirOwnThatTheMechanismAloneTells) {
    std::size_t named = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = tests::example(name);
        std::set<std::string> possible, seen;
        for (const Column& column : possible_results(solution.mechanism)) possible.insert(column.name);
        for (const NamedResult& result : named_results(solution)) {
            EXPECT_TRUE(seen.insert(result.column.name).second) << name << ": " << result.column.name;
            EXPECT_TRUE(possible.contains(result.column.name)) << name << ": " << result.column.name;
        }
        named += seen.size();
    }
    EXPECT_GT(named, tests::example_names().size());
}

TEST(Ask, GivesTheResultsInTheOrderOfTheFile) {
    const std::string text = asking("four_bar", R"(["omega 4", "v B", "transmission angle", "angle 2"])");
    EXPECT_TRUE(refused_by_schema(text).empty());
    const Solution solution = tests::solved(text);
    const auto asked = asked_results(solution);
    ASSERT_TRUE(asked);
    ASSERT_EQ(asked->size(), 4U);
    EXPECT_EQ((*asked)[0].column.name, "omega 4");
    EXPECT_EQ((*asked)[0].value, solution.bodies[3].omega->to_double());
    EXPECT_NEAR((*asked)[1].value, 0.08 * std::abs((*asked)[0].value), 1e-12) << "v = ω r";
    // Crank and frame on one line: cos μ = (b² + c² − (d ± a)²) / 2bc, with 150, 80, 150 and 40 mm.
    const auto transmission = [](double base) {
        return std::acos((150.0 * 150 + 80 * 80 - base * base) / (2 * 150 * 80));
    };
    const double pi = std::acos(-1.0);
    const double least = std::min({transmission(110), transmission(190), pi - transmission(190)});
    EXPECT_NEAR((*asked)[2].value, least, 1e-9);
    EXPECT_NEAR(told((*asked)[3], solution.mechanism.units).value, 60, 1e-9);
    EXPECT_EQ(told((*asked)[3], solution.mechanism.units).unit, "°");
}

TEST(Ask, KnowsWhatAProblemFinds) {
    const auto asked =
        asked_results(tests::solved(asking("contact/ball_against_wall", R"(["impulse x", "energy lost"])")));
    ASSERT_TRUE(asked);
    EXPECT_EQ((*asked)[0].unit, "N s");
    const auto wrong = asked_results(tests::solved(asking("contact/ball_against_wall", R"(["impulse z"])")));
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().front().where, "/ask/0");
    EXPECT_NE(wrong.error().front().message.in(Language::en).find("\"impulse x\""), std::string::npos)
        << wrong.error().front().message.in(Language::en);
}

TEST(Ask, FaultsNameThePlaceAndTheNearest) {
    const auto fault = [](const std::string& ask) {
        const auto read = read_mechanism(asking("four_bar", ask), "test.json");
        return read ? std::string("none")
                    : read.error().front().where + ": " + read.error().front().message.in(Language::en);
    };
    EXPECT_EQ(fault(R"(["omega 3", "omega 33"])"),
              "/ask/1: no result is named \"omega 33\" (did you mean \"omega 3\"?); names are those of the columns of "
              "\"sweep\"");
    EXPECT_EQ(fault(R"(["v B", "v B"])"), "/ask/1: \"v B\" is asked for twice; take one out");
    EXPECT_EQ(fault(R"([])"), "/ask: nothing is asked for; take \"ask\" out, or name a result");
    EXPECT_EQ(fault(R"("v B")"), "/ask: an array of names of results, such as \"omega 3\" is wanted here, not \"v B\"");
    EXPECT_EQ(fault(R"([3])"), "/ask/0: the name of a result, such as \"omega 3\" is wanted here, not the number 3");
    // The mechanism may have it, but "find" does not look for it.
    const auto not_found = asked_results(tests::solved(asking("four_bar", R"(["Fx A 3 on 2"])")));
    ASSERT_FALSE(not_found);
    EXPECT_EQ(not_found.error().front().code, ErrorCode::bad_input);
}

TEST(Ask, NamesAreComparedByTheirLetters) {
    const auto meant = [](const std::string& asked) {
        const auto read = read_mechanism(asking("four_bar", "[\"" + asked + "\"]"), "test.json");
        const std::string said = read ? std::string() : read.error().front().message.in(Language::en);
        const std::size_t from = said.find("(did you mean \""), to = said.find("\"?)");
        return from == std::string::npos ? std::string("none") : said.substr(from + 15, to - from - 15);
    };
    for (const char* written : {"v_B", "vB", "v_b", "V_B", "V B"}) EXPECT_EQ(meant(written), "v B") << written;
    for (const char* written : {"omega3", "omega_3", "Omega 3", "OMEGA3"})
        EXPECT_EQ(meant(written), "omega 3") << written;
    for (const char* written : {"v_Bx", "vBx", "vx_B"}) EXPECT_EQ(meant(written), "vx B") << written;
    EXPECT_EQ(meant("omega 5"), "omega 4");
    EXPECT_EQ(meant("fx_A_3_on_2 "), "Fx A 3 on 2");
}

/// The least transmission angle of the file's first driver, in degrees; none where nothing is pushed.
std::optional<double> transmission_in(const std::string& text) {
    const Mechanism mechanism = read_or_throw(text);
    const Pose pose = *draw_pose(mechanism);
    const auto travel = own_travel(mechanism, pose);
    if (!travel) throw std::runtime_error("no travel");
    const auto found = transmission_of(mechanism, travel->first, 0, travel->second);
    return found ? std::optional(found->least * 180 / std::acos(-1.0)) : std::nullopt;
}

/// A crank rocker whose crank is turned by a pinion: the gears change the speed, not the angles.
TEST(Transmission, IsThatOfTheLinkageBehindGears) {
    const auto text = [](const std::string& more_bodies, const std::string& more_joints, int driven) {
        return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O": [0, 0], "A": [24, 32],
            "Q": [150, 0], "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "Q", "radius": 80}],
            "side": "left"}, "C": [-60, 0], "P": [-40, 0]}, "bodies": {"2": {"points": ["O", "A"],
            "circle": {"centre": "O", "radius": 40}}, "3": ["A", "B"], "4": ["Q", "B"])" +
               more_bodies + R"(}, "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]})" +
               more_joints + R"(], "drivers": [{"body": )" + std::to_string(driven) + R"(, "omega": 1}]})";
    };
    const auto plain = transmission_in(text("", "", 2));
    const auto geared =
        transmission_in(text(R"(, "5": {"points": ["C"], "circle": {"centre": "C", "radius": 20}})",
                             R"(, {"revolute": "C", "bodies": [1, 5]}, {"gear": "P", "bodies": [5, 2]})", 5));
    ASSERT_TRUE(plain && geared);
    EXPECT_NEAR(*geared, *plain, 1e-6);
    EXPECT_NE(*plain, 90);
}

/// A driver that turns the coupler needs no force along it.
TEST(Transmission, OfADrivenCouplerIsNone) {
    const auto driven_by = [](const std::string& driver) {
        return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O": [0, 0], "A": [40, 80],
            "B": [120, 120], "Q": [150, 0]}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["Q", "B"]}, "joints": [
            {"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]},
            {"revolute": "Q", "bodies": [1, 4]}], "drivers": [)" +
               driver + "]}";
    };
    EXPECT_TRUE(transmission_in(driven_by(R"({"body": 2, "omega": 1})")));
    for (const char* driver : {R"({"body": 3, "omega": 1})", R"({"body": 3, "relative to": 2, "omega": 1})",
                               R"({"body": 2, "relative to": 3, "omega": 1})"})
        EXPECT_FALSE(transmission_in(driven_by(driver))) << driver;
}

}  // namespace
}  // namespace kinegraph::named_results_test
