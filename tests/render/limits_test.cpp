// Limits: what is too large for a sheet or a live page, what asked twice is one, and one position of a cam.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "constructions/moving/moving.hpp"
#include "engine/mechanism/cam.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "tests/support/files.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/through_all.hpp"

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

/// The places of the numbers of a file, those with a unit among them.
std::vector<Json::json_pointer> numbers_of(const Json& file) {
    std::vector<Json::json_pointer> places;
    const Json leaves = file.flatten();
    for (const auto& [place, value] : leaves.items()) {
        const bool with_unit = value.is_string() && value.get<std::string>().find_first_of("-0123456789") == 0;
        const bool is_data = place != "/kinegraph" && place != "/frame" && place.find("/bodies") == std::string::npos;
        if (is_data && (value.is_number() || with_unit)) places.emplace_back(place);
    }
    return places;
}
/// The same number with a power of ten.
Json times_power(const Json& number, const std::string& power) {
    const std::string text = number.is_string() ? number.get<std::string>() : number.dump();
    const std::size_t end = std::min(text.find_first_not_of("-0123456789."), text.size());
    const std::string scaled = text.substr(0, end) + "e" + power;
    return number.is_string() ? Json(scaled + text.substr(end)) : Json::parse(scaled);
}

// A coordinate that no format writes ended the program where values of one figure differ by more than 10^12.
TEST(SheetLimits, NumbersOfAnySizeAreDrawnOrRefused) {
    const std::vector<std::string> powers{"-59", "18", "-13", "9", "-20", "40"};
    int drawn = 0, refused = 0;
    std::size_t turn = 0;
    for (const std::string name : {"lever_on_springs", "sluice_gate_mirrored", "excavator_arm", "engine_inertia_gas",
                                   "motion/projectile", "three_hinged_arch", "joint_contact/driven_wheel"}) {
        const Json file = Json::parse(tests::contents(tests::example_file(name)));
        const auto places = numbers_of(file);
        ASSERT_FALSE(places.empty()) << name;
        for (const auto& place : places) {
            const std::string power = powers[turn++ % powers.size()];
            SCOPED_TRACE(name + (" " + place.to_string()) + " e" + power);
            Json changed = file;
            changed[place] = times_power(file[place], power);
            const auto far = tests::through_all(changed.dump(), tests::fonts());
            drawn += far.drawn;
            refused += far.solved && !far.drawn;
        }
    }
    EXPECT_GT(drawn, 50);
    EXPECT_GT(refused, 5);
}

// At 10^42 mm a circle and a line meet by a rounding, which a finer drawing does not repeat.
TEST(SheetLimits, WhatDoesNotCloseOnAFinerDrawingIsAnswered) {
    Json file = Json::parse(tests::contents(tests::example_file("whitworth")));
    file["points"]["A"]["distance"] = 1e42;
    EXPECT_TRUE(tests::through_all(file.dump(), tests::fonts()).solved);
}

/// A lever on two springs, of which the weak one moves the reaction far away by the couple of the other.
TEST(SheetLimits, WhatACoupleMovesFarAwayLeavesItsBodyToBeSeen) {
    Json file = Json::parse(tests::contents(tests::example_file("lever_on_springs")));
    for (const char* stiffness : {"1e-3 N/m", "1e-9 N/m"}) {
        file["loads"][0]["stiffness"] = stiffness;
        const auto page = render::lay_out_alone(solved(file.dump()), {}, "body-2", tests::fonts());
        ASSERT_TRUE(page) << stiffness;
        EXPECT_LT(page->width, 300) << stiffness;
        EXPECT_FALSE(render::beyond_paper(*page)) << stiffness;
        std::vector<render::Mark> link;
        for (std::size_t i = 0, open = 0; i < page->marks.size(); ++i) {
            const auto* const group = std::get_if<render::GroupBegin>(&page->marks[i]);
            if (group != nullptr && (open > 0 || group->cls == "link")) ++open;
            if (open > 0) link.push_back(page->marks[i]);
            if (open > 0 && std::holds_alternative<render::GroupEnd>(page->marks[i])) --open;
        }
        ASSERT_FALSE(link.empty()) << stiffness;
        EXPECT_GT(render::box_of(link).height(), 20) << "the lever is seen, " << stiffness;
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
    Json loaded = Json::parse(tests::contents(tests::example_file("beam")));
    EXPECT_TRUE(render::is_planned_twice(solved(loaded.dump())));
    for (int i = 0; i < 60; ++i) {
        loaded["loads"].push_back(loaded["loads"][0]);
        loaded["loads"].back()["force"] = "G" + std::to_string(i);
    }
    EXPECT_FALSE(render::is_planned_twice(solved(loaded.dump())));
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

// Beside a point 45 million kilometres away the centres of curvature of a cam and its roller are one: nothing is known
// of other positions, and the page took it for a fault of its own.
TEST(LiveLimits, AMechanismThatDoesNotCloseStandsStill) {
    Json file = Json::parse(tests::contents(tests::example_file("variants/cam")));
    EXPECT_TRUE(moving_of(solved(file.dump())));
    file["points"]["H"]["distance"] = 45e12;
    EXPECT_FALSE(moving_of(solved(file.dump())));
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
