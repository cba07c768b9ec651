// Scenes of polygons: what is shown, of which quantity and by which statement, as values and without a drawing.
#include "render/scene/polygon_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace polygon_scene_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using tests::example;

const SceneVector& vector_of(const PolygonScene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.vectors.begin(), scene.vectors.end(), [&](const auto& v) { return v.name == name; });
    if (found == scene.vectors.end()) throw std::runtime_error(scene.id + " has no " + name);
    return *found;
}
double length_of(const SceneVector& vector) {
    return std::hypot(vector.tip.x - vector.tail.x, vector.tip.y - vector.tail.y);
}

TEST(PolygonScene, HasItsVectorsInTheUnitTheyAreToldIn) {
    const Solution& solution = example("four_bar");
    ASSERT_EQ(solution.protocol.polygons.size(), 2U);
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
        ASSERT_FALSE(scene.vectors.empty()) << scene.id;
        for (const SceneVector& vector : scene.vectors)
            EXPECT_NEAR(length_of(vector), vector.value, 1e-12 * scene.size()) << scene.id << ' ' << vector.name;
    }
}

TEST(PolygonScene, IsStraightWhereItsVectorsHaveOneDirectionOrItsOpposite) {
    EXPECT_TRUE(polygon_scene(example("parallel_crank"), 0).is_straight());
    EXPECT_TRUE(polygon_scene(example("planetary_train"), 0).is_straight());
    for (const int polygon : {0, 1}) EXPECT_FALSE(polygon_scene(example("four_bar"), polygon).is_straight());
}

TEST(PolygonScene, SaysByWhichStatementAVelocityIsDrawn) {
    const Solution& solution = example("four_bar");
    const PolygonScene scene = polygon_scene(solution, 0);
    ASSERT_EQ(scene.kind, PolygonScene::Kind::velocity);
    const SceneVector &a = vector_of(scene, "v_A"), &b = vector_of(scene, "v_B"), &relative = vector_of(scene, "v_BA");
    EXPECT_LT(a.statement, b.statement);
    EXPECT_EQ(b.statement, relative.statement);
    // Both lines that meet in b are of its statement, and end there.
    int lines = 0;
    for (const SceneLine& line : scene.lines) {
        if (line.statement != b.statement) continue;
        ++lines;
        EXPECT_EQ(line.meet.x, b.tip.x);
        EXPECT_EQ(line.meet.y, b.tip.y);
        const double across =
            line.along.x * (line.meet.y - line.support.y) - line.along.y * (line.meet.x - line.support.x);
        EXPECT_NEAR(across, 0, 1e-12);
    }
    EXPECT_EQ(lines, 2);
    // The pole and the images a and b stand where the vectors end.
    ASSERT_EQ(scene.images.front().kind, SceneImage::Kind::pole);
    const auto image = std::find_if(scene.images.begin(), scene.images.end(),
                                    [](const SceneImage& each) { return each.symbol.about == "B"; });
    ASSERT_NE(image, scene.images.end());
    EXPECT_EQ(image->at.x, b.tip.x);
    EXPECT_EQ(image->statement, b.statement);
}

TEST(PolygonScene, JoinsForcesWithTheirInnerSidesFallingOut) {
    const Solution& solution = example("sluice_gate");
    int of_bodies = 0, of_all = 0;
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
        if (scene.kind == PolygonScene::Kind::forces) {
            ++of_bodies;
            ASSERT_FALSE(scene.vectors.empty()) << scene.id;
            EXPECT_EQ(scene.faces.size(), 1u) << scene.id;
            for (const SceneVector& side : scene.vectors) {
                EXPECT_FALSE(side.falls_out) << side.name;
                EXPECT_NE(side.statement, none) << side.name;
            }
        }
        if (scene.kind != PolygonScene::Kind::closure) continue;
        ++of_all;
        EXPECT_EQ(vector_of(scene, "F_g").statement, none) << "it is given";
        EXPECT_FALSE(vector_of(scene, "F_g").falls_out);
        EXPECT_TRUE(vector_of(scene, "F_21").falls_out);
        EXPECT_NE(vector_of(scene, "F_21").statement, none);
    }
    EXPECT_GT(of_bodies, 0);
    EXPECT_GT(of_all, 0);
}

/// The two errors that the sentence of a trial names are shown, however far the trials miss: a motor between crank and
/// rod turns the slider of a crank at rest faster than the true one.
TEST(PolygonScene, ShowsTheErrorsOfItsTrials) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 70},
        "B": {"meet": [{"circle": "A", "radius": 150}, {"line": [0, -15], "angle": 0}], "side": "ahead"}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 3, "relative to": 2, "omega": 4}]})");
    ASSERT_EQ(solution.protocol.trials.misses.size(), 4U);
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
        EXPECT_EQ(scene.misses.size(), 2U) << scene.id;
        for (const int trial : {1, 2})
            EXPECT_GE(std::count_if(scene.images.begin(), scene.images.end(),
                                    [&](const SceneImage& each) { return each.trial == trial; }),
                      2)
                << scene.id << ", trial " << trial;
    }
}

}  // namespace
}  // namespace polygon_scene_test
