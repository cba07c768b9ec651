// The last rule: mechanisms that no dyad and no triad leads through, solved by trial values, one at a time and nested.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/motion_laws.hpp"

namespace kinegraph::trials_test {
namespace {

std::size_t at(auto index) { return at_index(index); }

Solution solved(const std::string& text) {
    auto mechanism = read_mechanism(text, "trials");
    EXPECT_TRUE(mechanism) << (mechanism ? "" : mechanism.error().front().message.in(Language::en));
    auto solution = solve(*std::move(mechanism));
    EXPECT_TRUE(solution);
    return *std::move(solution);
}

long said(const Solution& solution, Key sentence, Topic section) {
    return std::count_if(solution.protocol.statements.begin(), solution.protocol.statements.end(),
                         [&](const Statement& statement) {
                             return statement.message.sentence == sentence && statement.section == section;
                         });
}

/// The double butterfly: four ternary links joined in two pairs, the pairs by four binary links. `turned` turns it, ten
/// times as large.
std::string double_butterfly(const std::string& driver, bool turned = false) {
    const std::vector<std::pair<std::string, std::pair<int, int>>> places{
        {"P", {0, 0}},  {"A", {-30, -2}}, {"C", {35, -5}},  {"B", {-32, 14}}, {"D", {36, 30}},
        {"Q", {4, 36}}, {"E", {-10, 20}}, {"F", {-16, 33}}, {"G", {13, 17}},  {"H", {18, 38}}};
    std::ostringstream text;
    text << R"({"kinegraph": 1, "frame": 1, "units": {"length": "cm"}, "points": {)";
    const char* between = "";
    for (const auto& [name, place] : places) {
        const auto [x, y] = place;
        text << between << '"' << name << "\": [" << (turned ? 6 * x - 8 * y : x) << ", "
             << (turned ? 8 * x + 6 * y : y) << ']';
        between = ", ";
    }
    text << R"(}, "bodies": {"2": ["P", "E", "G"], "3": ["Q", "B", "F"], "4": ["Q", "D", "H"], "5": ["A", "B"],
        "6": ["C", "D"], "7": ["E", "F"], "8": ["G", "H"]},
        "joints": [{"revolute": "P", "bodies": [1, 2]}, {"revolute": "Q", "bodies": [3, 4]}, {"revolute": "A",
        "bodies": [1, 5]},
        {"revolute": "B", "bodies": [5, 3]}, {"revolute": "C", "bodies": [1, 6]}, {"revolute": "D", "bodies": [6, 4]},
        {"revolute": "E", "bodies": [2, 7]}, {"revolute": "F", "bodies": [7, 3]}, {"revolute": "G", "bodies": [2, 8]},
        {"revolute": "H", "bodies": [8, 4]}], "drivers": [)"
         << driver << "]}";
    return text.str();
}

TEST(Trials, CloseTheDoubleButterfly) {
    const Solution solution = solved(double_butterfly(R"({"body": 5, "omega": 2, "alpha": 1})"));
    expect_whole_motion(solution);
    EXPECT_TRUE(solution.pose.exact);
    for (const Topic section : {Topic::velocity, Topic::acceleration}) {
        EXPECT_EQ(said(solution, lang::sentences::trial_on_line, section), 1);
        EXPECT_EQ(said(solution, lang::sentences::trial_closes_on_line, section), 1);
    }
}

TEST(Trials, AreKeptApartFromTheSolution) {
    const Solution solution = solved(double_butterfly(R"({"body": 5, "omega": 2, "alpha": 1})"));
    const Trials& trials = solution.protocol.trials;
    for (const int trial : {1, 2}) {
        EXPECT_TRUE(std::any_of(trials.vectors.begin(), trials.vectors.end(),
                                [&](const DrawnVector& vector) { return vector.trial == trial; }));
        EXPECT_TRUE(std::any_of(trials.images.begin(), trials.images.end(),
                                [&](const Image& image) { return image.trial == trial; }));
    }
    ASSERT_FALSE(solution.protocol.vectors.empty());
    for (const DrawnVector& vector : solution.protocol.vectors) EXPECT_EQ(vector.trial, 0);
}

// On paper: d divides the way from d^I to d^II as 0 divides the way from ε^I to ε^II.
TEST(Trials, ErrorsAreDrawnAndTheTruePlaceDividesAsTheyDo) {
    const Solution solution = solved(double_butterfly(R"({"body": 5, "omega": 2, "alpha": 1})"));
    const Protocol& protocol = solution.protocol;
    ASSERT_EQ(protocol.trials.misses.size(), 4U);  // two of each polygon
    const auto place = [&](ElementIndex element) { return protocol.point(element).place(); };
    for (std::size_t first = 0; first < 4; first += 2) {
        const DrawnMiss &one = protocol.trials.misses[first], &two = protocol.trials.misses[first + 1];
        EXPECT_EQ(one.symbol.term + two.symbol.term, "III");
        const Vector error = place(one.tip) - place(one.foot), other = place(two.tip) - place(two.foot);
        EXPECT_EQ(dot(error, place(one.through) - place(one.foot)), 0);
        EXPECT_EQ(cross(error, other), 0);
        const Message& said = protocol.statements[at(one.statement)].message;
        ASSERT_EQ(said.sentence, lang::sentences::trial_closes_on_line);
        const auto* sought = std::get_if<Symbol>(&said.arguments[2]);
        ASSERT_NE(sought, nullptr);
        const auto tip = [&](const std::vector<Image>& images, int trial) {
            const auto found = std::find_if(images.begin(), images.end(), [&](const Image& image) {
                return image.symbol == *sought && image.polygon == one.polygon && image.trial == trial;
            });
            EXPECT_NE(found, images.end());
            return place(found->point);
        };
        const Vector from = tip(protocol.trials.images, 1), to = tip(protocol.trials.images, 2),
                     at = tip(protocol.images, 0);
        const Exact whole = dot(error - other, error);
        EXPECT_EQ(whole * (at - from), dot(error, error) * (to - from));
    }
}

// Far from the solution the trials would make the figure large and the solution small: their values are on both sides
// of the true one, and no point is farther from its true place than a third of the longest velocity or acceleration.
TEST(Trials, AreNearTheSolutionOnBothSides) {
    int held = 0;
    for (const char* driver : {R"({"body": 5, "omega": 2, "alpha": 1})", R"({"body": 6, "omega": 3, "alpha": -40})",
                               R"({"body": 8, "omega": -1, "alpha": 7})"}) {
        SCOPED_TRACE(driver);
        const Solution solution = solved(double_butterfly(driver));
        const Protocol& protocol = solution.protocol;
        const auto place = [&](ElementIndex element) { return protocol.point(element).place(); };
        const auto longest_of = [&](int polygon) {  // squared
            Exact longest = 0;
            for (const Image& image : protocol.images)
                if (image.polygon == polygon) longest = std::max(longest, dot(place(image.point), place(image.point)));
            return longest;
        };
        for (const Image& trial : protocol.trials.images) {
            const auto real = std::find_if(protocol.images.begin(), protocol.images.end(), [&](const Image& image) {
                return image.symbol == trial.symbol && image.polygon == trial.polygon;
            });
            ASSERT_NE(real, protocol.images.end());
            const Vector off = place(trial.point) - place(real->point);
            EXPECT_LE(9 * dot(off, off), longest_of(trial.polygon));
            ++held;
        }
        ASSERT_FALSE(protocol.trials.misses.empty());
        for (std::size_t first = 0; first < protocol.trials.misses.size(); first += 2) {
            const DrawnMiss &one = protocol.trials.misses[first], &two = protocol.trials.misses[first + 1];
            EXPECT_LT(dot(place(one.tip) - place(one.foot), place(two.tip) - place(two.foot)), 0);
        }
    }
    EXPECT_GT(held, 20);
}

TEST(Trials, DoNotDependOnWhichBodyIsDriven) {
    const Solution by_crank = solved(double_butterfly(R"({"body": 5, "omega": 2, "alpha": 1})"));
    for (const int body : {2, 3, 4, 6, 7, 8}) {
        // Driven elsewhere with the very motion that the crank gives it, the mechanism moves alike.
        const BodyMotion& motion = by_crank.bodies[at(body - 1)];
        auto mechanism =
            read_mechanism(double_butterfly(R"({"body": )" + std::to_string(body) + R"(, "omega": 1})"), "trials");
        ASSERT_TRUE(mechanism);
        auto& driver = std::get<SpinDriver>(mechanism->drivers[0]);
        driver.omega = *motion.omega;
        driver.alpha = *motion.alpha;
        const auto again = solve(*std::move(mechanism));
        ASSERT_TRUE(again);
        expect_whole_motion(*again);
        ASSERT_EQ(again->bodies.size(), 8U);
        for (std::size_t b = 1; b < again->bodies.size(); ++b) {
            EXPECT_EQ(*again->bodies[b].omega, *by_crank.bodies[b].omega) << "driven by " << body;
            EXPECT_EQ(*again->bodies[b].alpha, *by_crank.bodies[b].alpha) << "driven by " << body;
        }
    }
}

TEST(Trials, TurnWithTheDrawing) {
    const std::string driver = R"({"body": 7, "relative to": 3, "omega": 3, "alpha": -2})";
    const Solution one = solved(double_butterfly(driver)), other = solved(double_butterfly(driver, true));
    ASSERT_EQ(one.bodies.size(), 8U);
    for (std::size_t body = 1; body < one.bodies.size(); ++body) {
        EXPECT_EQ(*one.bodies[body].omega, *other.bodies[body].omega);
        EXPECT_EQ(*one.bodies[body].alpha, *other.bodies[body].alpha);
    }
}

// --- beyond eight links
// ------------------------------------------------------------------------------------------------------

using Edges = std::vector<std::pair<int, int>>;

/// Ternary links joined along the edges of a cubic graph, some edges by a binary link between: with four such links the
/// chain has one freedom, with five two. No loop of it is short where the graph's girth is large, so no dyad leads on.
std::string cubic_chain(const Edges& edges, int binaries, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<std::uint32_t>(count)); };
    int bodies = 0;
    for (const auto& [a, b] : edges) bodies = std::max({bodies, a + 1, b + 1});
    std::vector<bool> long_way(edges.size(), false);
    for (int left = binaries; left > 0;) {
        const auto edge = at(below(static_cast<int>(edges.size())));
        if (long_way[edge]) continue;
        long_way[edge] = true;
        --left;
    }
    std::ostringstream points, joints;
    int pins = 0;
    const auto pin = [&](int a, int b) {
        points << (pins > 0 ? ", " : "") << "\"P" << pins << "\": [" << below(100) - 50 << ", " << below(100) - 50
               << ']';
        joints << (pins > 0 ? ", " : "") << R"({"revolute": "P)" << pins << R"(", "bodies": [)" << a << ", " << b
               << "]}";
        ++pins;
    };
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        const auto [a, b] = edges[edge];
        if (!long_way[edge]) {
            pin(a, b);
        } else {
            pin(a, bodies);
            pin(bodies, b);
            ++bodies;
        }
    }
    std::ostringstream text;
    text << R"({"kinegraph": 1, "points": {)" << points.str() << R"(}, "bodies": {)";
    for (int body = 1; body < bodies; ++body) text << (body > 1 ? ", " : "") << '"' << body << "\": []";
    text << R"(}, "joints": [)" << joints.str() << R"(], "drivers": [)";
    for (int driver = 0; driver < binaries - 3; ++driver) {
        const int body = 1 + below(bodies - 1);
        text << (driver > 0 ? ", " : "") << R"({"body": )" << body << R"(, "relative to": )" << below(body)
             << R"(, "omega": )" << 1 + driver << R"(, "alpha": )" << 2 - driver << '}';
    }
    text << "]}";
    return text.str();
}

const std::vector<std::pair<std::string, Edges>>& cubic_graphs() {
    static const std::vector<std::pair<std::string, Edges>> graphs{
        {"prism", {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
        {"K33", {{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}}},
        {"cube", {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
        {"Petersen",
         {{0, 1},
          {1, 2},
          {2, 3},
          {3, 4},
          {4, 0},
          {5, 7},
          {6, 8},
          {7, 9},
          {8, 5},
          {9, 6},
          {0, 5},
          {1, 6},
          {2, 7},
          {3, 8},
          {4, 9}}}};
    return graphs;
}

/// So many mechanisms of each graph, wherever the drivers determine the motion; returns how many had several unknowns
/// at once.
int hold_cubic_chains(int binaries, std::uint32_t count) {
    int held = 0, nested = 0;
    for (const auto& [name, edges] : cubic_graphs()) {
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            SCOPED_TRACE(name + ", seed " + std::to_string(seed));
            const Solution solution = solved(cubic_chain(edges, binaries, seed));
            if (solution.mobility.driven < solution.mobility.effective || !solution.mobility.idle_drivers.empty())
                continue;
            ++held;
            expect_whole_motion(solution);
            const long trials = said(solution, lang::sentences::trial_on_line, Topic::velocity) +
                                said(solution, lang::sentences::trial_of_spin, Topic::velocity);
            nested += trials > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(held, static_cast<int>(cubic_graphs().size() * count) / 2) << "too few draws that the drivers determine";
    return nested;
}

TEST(Trials, LeadThroughChainsOfTenToFourteenLinks) {
    EXPECT_GT(hold_cubic_chains(4, 5), 0) << "none needed two trials";
}

TEST(Trials, LeadThroughCoupledDrivers) { hold_cubic_chains(5, 5); }

}  // namespace
}  // namespace kinegraph::trials_test
