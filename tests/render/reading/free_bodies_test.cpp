// What a student reads off a free body: it is large enough to show where its forces act, and forces that are
// drawn beside each other stand in the order of their lines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "engine/number/functions.hpp"
#include "render/figures/figure.hpp"
#include "render/mechanism/paper.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace free_bodies_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

/// A rack that a gear drives, under its weight and its inertia: the guide's force passes 16 mm beside the weight, which
/// turns it the other way if it is drawn on the other side, and the pitch point is 150 mm away.
Solution rack() {
    return solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"C": [0, 120], "P": [0, 0], "Q": [0, 180], "L": [-150, 180]},
        "bodies": {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 120}}, "3": {"points": ["L"]}},
        "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": 0}}},
                   {"gear": "Q", "bodies": [2, 3], "pressure angle": 20,
                    "profiles": {"2": {"circle": "C"}, "3": {"line": 0}}},
                   {"prismatic": "L", "bodies": [3, 1], "along": 0, "name": "guide"}],
        "drivers": [{"joint": "guide", "speed": 0.6, "acceleration": 1.5}],
        "masses": {"2": {"mass": 12, "centre": "C", "inertia": 0.05}, "3": {"mass": 4, "centre": "L"}},
        "gravity": [0, -9.81], "inertia forces": true, "effort": {"force": "F", "joint": "guide"}})");
}

/// A ladder with friction at both ends: two of its lines meet three times its length away.
Solution ladder() {
    return solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "m"},
        "points": {"A": [2, 0], "B": [0, 4], "F": [1.8, 0.4], "G": [1, 2], "M": [0.5, 3]},
        "bodies": {"2": ["A", "F", "G", "M", "B"]},
        "joints": [{"contact": "A", "bodies": [2, 1], "tangent": 15},
                   {"contact": "B", "bodies": [2, 1], "tangent": 105}],
        "masses": {"2": {"mass": 15, "centre": "G"}}, "gravity": [0, -9.81],
        "loads": [{"force": "F_W", "body": 2, "at": "M", "magnitude": 700, "along": -90}],
        "effort": {"force": "F", "body": 2, "at": "F", "along": 180}, "find": ["forces"]})");
}

/// Rooms of a sheet, from a crowded column to a page of its own, mm.
constexpr Spot rooms[] = {{22, 45}, {39, 43}, {49, 53}, {84, 86}, {112, 112}};

/// The diagonal of the box round its points and its circle, m.
double across(const Solution& solution, const FreeBody& body) {
    Box box{{1e300, 1e300}, {-1e300, -1e300}};
    std::vector<PointIndex> points = solution.mechanism.body(body.body).points;
    for (const Joint& joint : solution.mechanism.joints)
        if (joint.connects(body.body)) points.push_back(joint.point);
    for (const PointIndex point : points) {
        const Vector at = solution.pose.at(point);
        box.include(Spot{at.x.to_double(), at.y.to_double()});
    }
    if (const auto& circle = solution.mechanism.body(body.body).circle) {
        const Vector at = solution.pose.at(circle->centre);
        const Spot centre{at.x.to_double(), at.y.to_double()};
        box.include(drawing::grown(Box{centre, centre}, circle->radius.to_double()));
    }
    return std::hypot(box.width(), box.height());
}
/// The diagonal of the box round the places of all that is drawn at it, m.
double reach(const Solution& solution, const FreeBody& body) {
    const auto spot = [](const Vector& at) { return Spot{at.x.to_double(), at.y.to_double()}; };
    const Spot first = spot(solution.pose.at(solution.mechanism.body(body.body).points[0]));
    Box box{first, first};
    for (const AppliedForce& applied : body.forces) box.include(spot(applied.at));
    for (const AppliedForce& sum : body.sums) box.include(spot(sum.at));
    for (const FreeBody::Arm& arm : body.arms) box.include(spot(arm.foot));
    return std::hypot(box.width(), box.height());
}

struct Arrow {
    Vector at, force;
    Axis drawn;
};
/// The arrows to scale, with the forces that they show.
std::vector<Arrow> arrows_of(const Figure& figure, const FreeBody& body) {
    std::map<std::string, Axis> by_name;
    const GroupBegin* last = nullptr;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) last = group;
        if (const auto* axis = std::get_if<Axis>(&mark))
            for (const auto& [key, text] : last->attributes)
                if (key == "data-name") by_name.emplace(text, *axis);
    }
    std::vector<Arrow> arrows;
    for (const AppliedForce& applied : body.forces)
        if (const auto found = by_name.find(name_of(applied.symbol)); found != by_name.end())
            arrows.push_back({applied.at, applied.force, found->second});
    return arrows;
}
int sense(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Of two parallel arrows, the one whose force turns the other's point counter-clockwise does so on paper.
int expect_in_order(const std::vector<Arrow>& arrows, double size) {
    int compared = 0;
    for (const Arrow& one : arrows)
        for (const Arrow& other : arrows) {
            const Vector d = other.at - one.at;
            const double force = kinegraph::length(one.force), along = kinegraph::length(other.force);
            const double arm = cross(one.force, d).to_double() / force;
            const double turned = cross(one.force, other.force).to_double() / force / along;
            // Smaller distances are those of one line, rounded.
            if (std::abs(turned) > 1e-9 || std::abs(arm) < 1e-6 * size) continue;
            const Spot way = one.drawn.tip - one.drawn.tail;
            EXPECT_EQ(sense(-cross(way, other.drawn.tail - one.drawn.tail)), sense(arm));
            ++compared;
        }
    return compared;
}

/// `in_order`: counts the pairs of arrows compared.
void expect_readable(const Solution& solution, int& bodies, int& in_order) {
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i) {
        const FreeBody& body = solution.free_bodies[i];
        if (body.body == none || solution.mechanism.body(body.body).points.empty()) continue;
        const double size = across(solution, body);
        if (size == 0) continue;
        for (const Spot room : rooms) {
            const Figure figure = free_body_figure(context, i, room.x, room.y);
            SCOPED_TRACE(figure.id + " in " + std::to_string(room.x));
            // Smaller only where its forces would else lie farther apart than a column is wide, in steps of 1, 2, 5.
            constexpr double least = 12, far = 100 / 2.5, rounding = 1e-6;  // mm
            EXPECT_TRUE(size / figure.places > least - rounding || reach(solution, body) / figure.places > far)
                << size / figure.places;
            in_order += expect_in_order(arrows_of(figure, body), size);
            ++bodies;
        }
    }
}

TEST(ReadingFreeBodies, AreLargeEnoughAndForcesStandInOrder) {
    int bodies = 0, in_order = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        expect_readable(example(name), bodies, in_order);
    }
    EXPECT_GT(bodies, 100);
    EXPECT_GT(in_order, 20);
}

TEST(ReadingFreeBodies, TurnAsTheirForcesDo) {
    int bodies = 0, in_order = 0;
    const Solution solution = rack();
    ASSERT_FALSE(solution.free_bodies.empty());
    expect_readable(solution, bodies, in_order);
    EXPECT_GT(in_order, 0);
}

TEST(ReadingFreeBodies, DoNotShrinkForAFarMeet) {
    int bodies = 0, in_order = 0;
    const Solution solution = ladder();
    ASSERT_FALSE(solution.free_bodies.empty());
    expect_readable(solution, bodies, in_order);
    EXPECT_GT(bodies, 0);
}

}  // namespace
}  // namespace free_bodies_test
