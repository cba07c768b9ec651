// Lines that grow between two steps of a film: how long what is drawn of them is, in which order they come, and that
// nothing else moves.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "render/sheet/growth.hpp"

namespace kinegraph::render::growth_test {
namespace {

constexpr double pi = 3.14159265358979;

Path stroke(std::vector<Segment> segments) {
    Path path;
    path.segments = std::move(segments);
    path.stroked = true;
    return path;
}
std::vector<Path> strokes() {
    return {stroke({MoveTo{{0, 0}}, LineTo{{30, 40}}}),
            stroke({MoveTo{{0, 0}}, LineTo{{10, 0}}, MoveTo{{0, 5}}, LineTo{{10, 5}}}),
            stroke({ArcTo{{5, 5}, 10, 0, 2 * pi}}),
            stroke({MoveTo{{15, 5}}, ArcTo{{5, 5}, 10, 0, -pi / 2}, LineTo{{5, -40}}}),
            stroke({MoveTo{{0, 0}}, LineTo{{10, 0}}, LineTo{{10, 10}}, Close{}}),
            stroke({MoveTo{{0, 0}}, CurveTo{{0, 20}, {40, 20}, {40, 0}}, LineTo{{60, 0}}})};
}

TEST(Growth, KnowsLengths) {
    const std::vector<Path> all = strokes();
    EXPECT_NEAR(length_of(all[0]), 50, 1e-12);
    EXPECT_NEAR(length_of(all[1]), 20, 1e-12);
    EXPECT_NEAR(length_of(all[2]), 20 * pi, 1e-9);
    EXPECT_NEAR(length_of(all[3]), 5 * pi + 35, 1e-9);
    EXPECT_NEAR(length_of(all[4]), 20 + std::sqrt(200), 1e-12);
    Path filled = all[0];
    filled.stroked = false;
    filled.filled = true;
    EXPECT_EQ(length_of(filled), 0);
}

// Law: what is drawn is as long as it should be; of a curve within the error of sixteen chords.
TEST(Growth, DrawsAsMuchAsIsAskedFor) {
    for (const Path& path : strokes()) {
        const double whole = length_of(path);
        for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9, 1.0}) {
            Path filled = path;
            filled.filled = true;
            const Path part = beginning_of(filled, share * whole);
            EXPECT_NEAR(length_of(part), share * whole, 0.02 * whole) << share;
            EXPECT_FALSE(part.filled);
        }
    }
}

TEST(Growth, FollowsTheOrderOfStatements) {
    const StatementIndex first(0), second(1);
    std::vector<Mark> marks;
    const auto add = [&](StatementIndex statement, double y) {
        Path path = stroke({MoveTo{{0, y}}, LineTo{{10, y}}});
        path.statement = statement;
        marks.emplace_back(path);
    };
    add(none, 0);
    marks.emplace_back(GroupBegin{"vector", {}, "", {}, second});
    add(none, 1);
    TextMark label;
    label.words = "v";
    marks.emplace_back(label);
    marks.emplace_back(GroupEnd{});
    add(first, 2);
    const Grows grows = [](StatementIndex statement) { return statement != none; };
    EXPECT_EQ(length_that_grows(marks, grows), 20);
    const auto drawn = [&](double share) {
        std::string heights;
        for (const Mark& mark : grown(marks, grows, share)) {
            if (std::holds_alternative<TextMark>(mark)) heights += "v";
            if (const auto* path = std::get_if<Path>(&mark)) {
                const double y = std::get<MoveTo>(path->segments.front()).to.y;
                heights +=
                    std::to_string(static_cast<int>(y)) + "(" + std::to_string(std::lround(length_of(*path))) + ")";
            }
        }
        return heights;
    };
    EXPECT_EQ(drawn(0), "0(10)");
    EXPECT_EQ(drawn(0.25), "0(10)2(5)");
    EXPECT_EQ(drawn(0.75), "0(10)1(5)2(10)");
    EXPECT_EQ(drawn(1), "0(10)1(10)v2(10)");
    EXPECT_EQ(grown(marks, grows, 1).size(), marks.size());
}

}  // namespace
}  // namespace kinegraph::render::growth_test
