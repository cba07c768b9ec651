// The results file: its keys and shapes literally as docs/results.md has them, numbers that come back, nothing that is
// no JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/results/results.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::results_test {
namespace {

using Json = nlohmann::ordered_json;

Exact decimal(const char* text) { return *Exact::from_decimal(text); }

/// Frame 1, crank 2 and block 4 that share A without a pin, and a guide's point Q that no body carries.
Solution sample() {
    Solution solution;
    solution.mechanism.points = {{"O", Coordinates{}, ""}, {"A", Coordinates{}, ""}, {"Q", Coordinates{}, ""}};
    for (const char* name : {"1", "2", "4"}) {
        Body body;
        body.name = name;
        solution.mechanism.bodies.push_back(body);
    }
    Joint slide;
    slide.kind = JointKind::prismatic;
    slide.name = "D";
    slide.point = PointIndex(1);
    slide.bodies = {BodyIndex(1), BodyIndex(2)};
    solution.mechanism.joints = {slide};
    solution.pose.points = {{0, 0}, {decimal("0.1"), decimal("-0.7")}, {1, 2}};
    solution.pose.leftover = {0, 0, 0};
    solution.mobility.gruebler = 1;
    solution.mobility.effective = 2;
    solution.points = {{PointIndex(0), {frame, BodyIndex(1)}, "O", Vector{}, Vector{}},
                       {PointIndex(1), {BodyIndex(1)}, "A", Vector{decimal("0.55"), 0}, std::nullopt},
                       {PointIndex(1), {BodyIndex(2)}, "A*", Vector{0, Exact::ratio(1, 3)}, Vector{1, 2}}};
    solution.bodies = {{Exact(0), Exact(0)}, {Exact::ratio(-1, 2), std::nullopt}, {}};
    solution.sliding = {{JointIndex(0), Vector{1, 2}, std::nullopt, Vector{3, 4}}};
    return solution;
}

TEST(Results, AreWrittenAsTheFormatSays) {
    Solution solution = sample();
    InstantCentre finite;
    finite.first = frame;
    finite.second = BodyIndex(1);
    finite.at = ProjectivePoint{decimal("0.25"), -2, 1};
    InstantCentre far = finite;
    far.second = BodyIndex(2);
    far.at = ProjectivePoint{-3, 4, 0};
    InstantCentre everywhere;
    everywhere.first = BodyIndex(1);
    everywhere.second = BodyIndex(2);
    everywhere.everywhere = true;
    solution.centres = {finite, far, everywhere};
    solution.checks = {{{.kind = Quantity::Kind::omega, .body = BodyIndex(1)}, -0.5, -0.5, -0.0}};
    solution.unsolved = {{{lang::phrases::motion_of_body, {BodyName{"\"3\""}}}, {lang::phrases::stands_still, {}}}};
    EXPECT_EQ(results_json(solution, false, english), R"({
  "mobility": {"gruebler": 1, "effective": 2, "verdict": "mechanism"},
  "points": {
    "O": {"at": [0, 0], "velocity": [0, 0], "acceleration": [0, 0]},
    "A": {"at": [0.1, -0.7], "on": {"2": {"velocity": [0.55, 0]}, "4": {"velocity": [0, 0.3333333333333333],)"
                                                      R"( "acceleration": [1, 2]}}},
    "Q": {"at": [1, 2]}
  },
  "bodies": {
    "2": {"omega": -0.5}
  },
  "sliding": {
    "D": {"velocity": [1, 2], "coriolis": [3, 4]}
  },
  "instant centres": {
    "1,2": {"at": [0.25, -2]},
    "1,4": {"towards": [0.6, -0.8]},
    "2,4": {"everywhere": true}
  },
  "checks": [
    {"quantity": "omega 2", "graphical": -0.5, "numeric": -0.5, "difference": 0}
  ],
  "unsolved": [
    {"what": "motion of body \"3\"", "why": "dead point: it can only stand still here, and no driver moves it"}
  ]
}
)");
}

TEST(Results, ExactAddsFractionsOrTheBoundOfWhatIsLeftOver) {
    Solution solution = sample();
    const Json exact = Json::parse(results_json(solution, true, english));
    EXPECT_EQ(exact["points"]["A"]["exact"], Json::parse(R"({"at": ["1/10", "-7/10"]})"));
    EXPECT_EQ(exact["points"]["A"]["on"]["4"]["exact"]["velocity"], Json::parse(R"(["0", "1/3"])"));
    EXPECT_EQ(exact["bodies"]["2"], Json::parse(R"({"omega": -0.5, "exact": {"omega": "-1/2"}})"));
    EXPECT_EQ(exact["sliding"]["D"]["exact"]["coriolis"], Json::parse(R"(["3", "4"])"));

    solution.pose.exact = false;
    solution.pose.leftover[1] = Exact::power_of_two(-100);
    solution.points[1].velocity = Vector{Exact::ratio(1, 3) + Exact::power_of_two(-110), 0};
    const Json left = Json::parse(results_json(solution, true, english));
    EXPECT_FALSE(left["points"]["A"].contains("exact")) << left["points"]["A"];
    EXPECT_EQ(left["points"]["A"]["leftover"], "7.888609052210118e-31");
    EXPECT_FALSE(left["points"]["A"]["on"]["2"].contains("exact")) << "it hangs on the compass";
    EXPECT_EQ(left["bodies"]["2"]["exact"]["omega"], "-1/2") << "too short to hang on the compass";
    EXPECT_FALSE(Json::parse(results_json(solution, false, english))["points"]["A"].contains("leftover"));
}

TEST(Results, APointAtInfinityHasNoSense) {
    Solution solution = sample();
    const auto towards = [&solution](const Exact& x, const Exact& y) {
        InstantCentre centre;
        centre.second = BodyIndex(1);
        centre.at = ProjectivePoint{x, y, 0};
        solution.centres = {centre};
        return Json::parse(results_json(solution, false, english))["instant centres"]["1,2"]["towards"];
    };
    EXPECT_EQ(towards(0, -7), Json::parse("[0, 1]"));
    EXPECT_EQ(towards(-7, 0), Json::parse("[1, 0]"));
    EXPECT_EQ(towards(-1, 0), Json::parse("[1, 0]"));
    EXPECT_EQ(towards(decimal("-3e300"), decimal("4e300")), Json::parse("[0.6, -0.8]"));
    const auto exact = Json::parse(results_json(solution, true, english))["instant centres"]["1,2"];
    EXPECT_EQ(exact, Json::parse(R"({"towards": [0.6, -0.8], "exact": {"towards": ["3", "-4"]}})"));
    solution.pose.exact = false;
    EXPECT_EQ(towards(Exact::power_of_two(-110), -1), Json::parse("[0, 1]")) << "upright but for the compass";
}

TEST(Results, NoNumberIsNoJson) {
    Solution solution = sample();
    solution.bodies[1].omega = decimal("1e400");
    solution.checks = {{{.kind = Quantity::Kind::omega, .body = BodyIndex(1)},
                        std::numeric_limits<double>::infinity(),
                        std::nan(""),
                        -0.0}};
    const Json json = Json::parse(results_json(solution, false, english));
    EXPECT_TRUE(json["bodies"]["2"]["omega"].is_null());
    EXPECT_TRUE(json["checks"][0]["numeric"].is_null());
    EXPECT_FALSE(std::signbit(json["checks"][0]["difference"].get<double>()));
}

TEST(Results, NamesAreEscaped) {
    Solution solution = sample();
    solution.mechanism.points[0].name = "O\"\\\n\xe2\x82\x82";
    solution.remarks = {{lang::sentences::lift_off, {PointName{"a\ttab"}}}};
    const Json json = Json::parse(results_json(solution, false, english));
    EXPECT_TRUE(json["points"].contains("O\"\\\n\xe2\x82\x82"));
    EXPECT_EQ(json["remarks"][0], "The contact at a\ttab would have to pull: there the bodies lift off.");
}

TEST(Results, ForcesAreThereWhereTheyAreAskedFor) {
    Solution solution = sample();
    EXPECT_FALSE(Json::parse(results_json(solution, false, english)).contains("forces"));
    solution.mechanism.find.stated = true;
    solution.mechanism.find.forces = true;
    const Json json = Json::parse(results_json(solution, false, english));
    EXPECT_EQ(json["forces"], Json::object());
    EXPECT_EQ(json["effort"], Json::object());
}

TEST(Results, RelativeMotionNamesItsObserver) {
    Solution solution = sample();
    RelativeMotion seen;
    seen.query = {PointIndex(1), BodyIndex(1), none, ""};
    seen.coriolis = Vector{0, 2};
    RelativeMotion translating;
    translating.query = {PointIndex(1), frame, PointIndex(0), ""};
    translating.relative_velocity = Vector{1, 0};
    solution.relative_motion = {seen, translating};
    const Json json = Json::parse(results_json(solution, false, english))["relative motion"];
    EXPECT_EQ(json[0], Json::parse(R"({"point": "A", "observer": "2", "coriolis": [0, 2]})"));
    EXPECT_EQ(json[1],
              Json::parse(R"({"point": "A", "observer": {"translating with": "O"}, "relative velocity": [1, 0]})"));
}

}  // namespace
}  // namespace kinegraph::results_test
