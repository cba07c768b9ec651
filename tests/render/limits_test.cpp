// Limits: what is too large for a sheet or a live page, what asked twice is one, and one position of a cam.
#include <gtest/gtest.h>

#include <string>

#include <nlohmann/json.hpp>

#include "constructions/moving/moving.hpp"
#include "engine/mechanism/cam.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::limits_test {
namespace {

using Json = nlohmann::json;
using tests::solved;

/// An open chain; every two bodies have an instant centre.
Solution chain(int bodies) {
    Json points, members, joints = Json::array(), drivers = Json::array();
    for (int i = 0; i <= bodies; ++i) points["P" + std::to_string(i)] = {i, (i * i) % 3};
    for (int i = 1; i <= bodies; ++i) {
        const std::string name = std::to_string(i), before = std::to_string(i - 1);
        members[name] = {"P" + before, "P" + name};
        joints.push_back({{"revolute", "P" + before}, {"bodies", {before, name}}});
        drivers.push_back({{"body", name}, {"omega", 1 + i % 4}});
    }
    const Json file{
        {"kinegraph", 1}, {"points", points}, {"bodies", members}, {"joints", joints}, {"drivers", drivers}};
    return solved(file.dump());
}

TEST(SheetLimits, RefuseHundredsOfPages) {
    EXPECT_FALSE(render::beyond_sheet(chain(5)));
    const auto beyond = render::beyond_sheet(chain(80));
    ASSERT_TRUE(beyond);
    EXPECT_NE(beyond->in(Language::en).find("2000"), std::string::npos) << beyond->in(Language::en);
    EXPECT_NE(beyond->in(Language::en).find("\"find\""), std::string::npos) << beyond->in(Language::en);
}

/// A lever at a place; its weight acts at a point of the frame if `far` is its place.
Solution lever_at(const std::string& place, const std::string& far) {
    return solved(R"({"kinegraph": 1, "points": {"O": [)" + place +
                  R"(, 0], "A": {"from": "O", "distance": 0.5, "angle": 0},
        "Q": [)" + far +
                  R"(, 0]}, "bodies": {"2": ["O", "A"]}, "joints": [{"revolute": "O", "bodies": ["0", "2"]}],
        "loads": [{"force": "W", "body": "2", "at": "Q", "value": [0, -600]}]})");
}

// Labels were looked for without end round a pin at 10^20 m, where a millimetre more is the same double.
TEST(SheetLimits, WhatDoublesDoNotTellApartIsNotDrawn) {
    for (const char* near : {"0", "1000", "1e7"}) EXPECT_FALSE(render::beyond_doubles(lever_at(near, near))) << near;
    for (const char* far : {"1e10", "1e20", "1e59"}) {
        EXPECT_TRUE(render::beyond_doubles(lever_at(far, far))) << far;
        EXPECT_TRUE(render::beyond_doubles(lever_at("0", far))) << far;
    }
}

/// A four-bar with points on its coupler, each seen from the crank.
Solution seen_from_the_crank(int points) {
    Json file = Json::parse(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 2], "B": [5, 3], "Q": [6, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["Q", "B"]},
        "joints": [{"revolute": "O", "bodies": ["0", "2"]}, {"revolute": "A", "bodies": ["2", "3"]},
                   {"revolute": "B", "bodies": ["3", "4"]}, {"revolute": "Q", "bodies": ["0", "4"]}],
        "drivers": [{"body": "2", "omega": 1}], "find": ["velocity", "acceleration"]})");
    for (int i = 0; i < points; ++i) {
        const std::string name = "p" + std::to_string(i);
        file["points"][name] = {1 + i % 5, 2 + i};
        file["bodies"]["3"].push_back(name);
        file["find"].push_back({{"relative motion", name}, {"observer", "2"}});
    }
    return solved(file.dump());
}

// Three plans of dozens of polygons took 5 s; what is compared is counted, not timed.
TEST(SheetLimits, DozensOfPolygonsAreNotPlannedThreeTimes) {
    EXPECT_TRUE(render::is_planned_twice(seen_from_the_crank(2)));
    const Solution many = seen_from_the_crank(33);
    EXPECT_FALSE(render::beyond_sheet(many));
    EXPECT_FALSE(render::is_planned_twice(many));
}

TEST(LiveLimits, AMechanismOfManyDriversStandsStill) {
    EXPECT_TRUE(moving_of(chain(3)));
    EXPECT_FALSE(moving_of(chain(13)));
}

TEST(RelativeMotion, AskedTwiceIsOne) {
    const auto asked = [](const std::string& wishes) {
        return solved(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 2], "B": [5, 3], "Q": [6, 0]},
            "bodies": {"1": ["O", "A"], "2": ["A", "B"], "3": ["B", "Q"]},
            "joints": [{"revolute": "O", "bodies": [0, 1]}, {"revolute": "A", "bodies": [1, 2]},
                       {"revolute": "B", "bodies": [2, 3]}, {"revolute": "Q", "bodies": [0, 3]}],
            "drivers": [{"body": 1, "omega": 1}], "find": [)" +
                      wishes + "]}")
            .mechanism.find.relative_motion.size();
    };
    const std::string one = R"({"relative motion": "B", "observer": 1})",
                      other = R"({"relative motion": "B", "observer": {"translating with": "A"}})";
    EXPECT_EQ(asked(one + "," + one), 1U);
    EXPECT_EQ(asked(one + "," + other + "," + one), 2U);
}

TEST(PositionOfCam, SaysSoAndIsNotMoved) {
    const auto cam = read_cam(R"({"kinegraph": 1, "units": {"length": "mm"}, "cam": {"omega": 10, "base radius": 40,
        "follower": {"moves": "translating", "face": "roller", "radius": 8},
        "law": [{"form": "cycloidal", "rise": 10, "turn": 180}, {"form": "cycloidal", "rise": -10, "turn": 180}]}})",
                              "eccentric.json");
    ASSERT_TRUE(cam);
    const auto geometry = CamGeometry::of(*cam);
    ASSERT_TRUE(geometry);
    const Solution solution = solved(mechanism_file_of(*cam, *geometry, 1));
    EXPECT_EQ(solution.mechanism.cam_file, "eccentric.json");
    EXPECT_FALSE(moving_of(solution));
}

}  // namespace
}  // namespace kinegraph::limits_test
