// The graph of the joints: it shows every body and every joint of the mechanism once.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/mechanism/chain.hpp"
#include "render/figures/figure_table.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/solved.hpp"

namespace joint_graph_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

Figure graph_of(const Solution& solution) {
    static const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    return draw_figure(Shown(context), {FigureKind::joint_graph}, {180, 130}, {});
}
/// The lines of the graph: its curves.
std::vector<const Path*> curves_of(const Figure& figure) {
    std::vector<const Path*> found;
    for (const Mark& mark : figure.marks)
        if (const auto* path = std::get_if<Path>(&mark);
            path != nullptr && path->segments.size() == 2 && std::holds_alternative<CurveTo>(path->segments[1]))
            found.push_back(path);
    return found;
}

class JointGraphs : public testing::TestWithParam<std::string> {};

TEST_P(JointGraphs, ShowEveryBodyAndJointOnce) {
    const Mechanism& mechanism = example(GetParam()).mechanism;
    const Figure figure = graph_of(example(GetParam()));
    std::multiset<std::string> joints, drawn, bodies, labels;
    for (const Joint& joint : mechanism.joints) joints.insert(joint.name);
    for (const Body& body : mechanism.bodies) bodies.insert(body.name);
    for (const Mark& mark : figure.marks) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (group != nullptr && group->cls == "joint") drawn.insert(group->title);
        const auto* text = std::get_if<TextMark>(&mark);
        if (text != nullptr) labels.insert(text->words);
    }
    EXPECT_EQ(drawn, joints);
    EXPECT_TRUE(std::includes(labels.begin(), labels.end(), bodies.begin(), bodies.end()));
    // A line for each pair, or for each body of a hinge that is a node of its own.
    std::size_t lines = 0;
    for (const Joint& joint : mechanism.joints) lines += joint.bodies.size() > 2 ? joint.bodies.size() : 1;
    EXPECT_EQ(curves_of(figure).size(), lines);
    EXPECT_TRUE(plain(figure.caption).ends_with(": " + std::to_string(chain_of(mechanism).loops)));
}
INSTANTIATE_TEST_SUITE_P(Examples, JointGraphs,
                         testing::Values("four_bar", "slider_crank", "exam_2001", "watt_six_bar", "planetary_train",
                                         "five_bar", "geneva_wheel", "jansen_leg", "scissor_lift"),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

/// Whatever the order of the bodies in the file, the lines of a single loop do not cross.
TEST(JointGraph, ALoopIsDrawnWithoutCrossings) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
        "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 40, "angle": 60}, "O4": [150, 0],
        "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 80}], "side": "left"}},
        "bodies": {"4": ["O4", "B"], "2": ["O2", "A"], "3": ["A", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": 12}]})");
    ASSERT_EQ(solution.mechanism.bodies[1].name, "4");
    const Figure figure = graph_of(solution);
    const std::vector<const Path*> curves = curves_of(figure);
    ASSERT_EQ(curves.size(), 4U);
    const auto ends = [](const Path& path) {
        return std::pair{std::get<MoveTo>(path.segments[0]).to, std::get<CurveTo>(path.segments[1]).to};
    };
    const auto side = [](Spot a, Spot b, Spot c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    for (const Path* one : curves)
        for (const Path* other : curves) {
            if (one == other) continue;
            const auto [a, b] = ends(*one);
            const auto [c, d] = ends(*other);
            EXPECT_FALSE(side(a, b, c) * side(a, b, d) < -1e-6 && side(c, d, a) * side(c, d, b) < -1e-6);
        }
}

}  // namespace
}  // namespace joint_graph_test
