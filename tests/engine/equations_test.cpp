// The closure equations: written from the loops in symbols, evaluated, and held against the constructions, closed forms
// and the numbers of the course.
#include "engine/equations/equations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <stdexcept>

#include "engine/results/results.hpp"
#include "engine/solution/solution.hpp"
#include "render/equations/equation_text.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::equations_test {
namespace {

using Letter = Equations::Letter;

std::string equations_json(const Equations& equations) {
    JsonWriter json;
    write_equations(equations, json);
    return json.take();
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

const Letter& named(const Equations& equations, const std::string& name) {
    for (const Letter& letter : equations.letters)
        if (letter.name == name) return letter;
    throw std::runtime_error("no letter is named " + name);
}
double ratio(const Equations& equations, const std::string& of, const std::string& by, bool second = false) {
    for (std::size_t j = 0; j < equations.unknowns.size(); ++j)
        for (std::size_t k = 0; k < equations.free.size(); ++k)
            if (equations.letter(equations.unknowns[j]).name == of && equations.letter(equations.free[k]).name == by)
                return second ? equations.second_ratios[j][k][k].value() : equations.ratios[j][k].value();
    throw std::runtime_error("no ratio of " + of + " by " + by);
}

/// The largest difference between what polygons and equations say, each over what is large of its kind.
struct Agreement {
    double worst = 0;
    int compared = 0, missing = 0;
    std::string where;
};
Agreement agreement(const Solution& solution, const Equations& equations) {
    double fastest = 0, speed = 0, rush = 0;
    const double size = solution.pose.size.to_double();
    for (const BodyMotion& body : solution.bodies)
        fastest = std::max(fastest, std::abs(body.omega.value_or(Exact(0)).to_double()));
    for (const PointMotion& point : solution.points) {
        speed = std::max(speed, length(point.velocity.value_or(Vector{})));
        rush = std::max(rush, length(point.acceleration.value_or(Vector{})));
    }
    fastest = std::max(fastest, speed / size);
    speed = std::max(speed, fastest * size);
    double spin = std::max(fastest * fastest, rush / size);
    for (const BodyMotion& body : solution.bodies)
        spin = std::max(spin, std::abs(body.alpha.value_or(Exact(0)).to_double()));
    rush = std::max(rush, spin * size);
    Agreement found;
    const auto hold = [&](const std::string& what, double drawn, const std::optional<double>& written, double large) {
        if (!written) {
            ++found.missing;
            found.where += " " + what;
            return;
        }
        ++found.compared;
        const double off = large > 0 ? std::abs(drawn - *written) / large : std::abs(drawn - *written);
        if (off > found.worst) found.worst = off, found.where = what;
    };
    for (const BodyIndex body : solution.mechanism.moving_bodies()) {
        const BodyMotion& drawn = solution.bodies[at_index(body)];
        const Equations::BodyState& state = equations.bodies[at_index(body)];
        const std::string& name = solution.mechanism.body(body).name;
        if (drawn.omega) hold("omega " + name, drawn.omega->to_double(), state.omega, fastest);
        if (drawn.alpha) hold("alpha " + name, drawn.alpha->to_double(), state.alpha, spin);
    }
    for (const PointMotion& point : solution.points) {
        if (point.point == none) continue;
        const Vector& place = solution.pose.at(point.point);
        const Equations::BodyState& state = equations.bodies[at_index(point.bodies.front())];
        const auto both = [&](const char* what, const Vector& drawn,
                              const std::optional<std::array<double, 2>>& written, double large) {
            const std::string name = std::string(what) + " " + point.label;
            hold(name + " x", drawn.x.to_double(), written ? std::optional((*written)[0]) : std::nullopt, large);
            hold(name + " y", drawn.y.to_double(), written ? std::optional((*written)[1]) : std::nullopt, large);
        };
        if (point.velocity) both("velocity", *point.velocity, state.velocity_of(place), speed);
        if (point.acceleration) both("acceleration", *point.acceleration, state.acceleration_of(place), rush);
    }
    return found;
}

/// Loops close as drawn.
double gap(const Equations& equations) {
    double worst = 0;
    for (const Equations::Loop& loop : equations.loops) {
        double x = 0, y = 0, longest = 1e-30;
        for (const Equations::Side& side : loop.sides) {
            double angle = side.angle.quarters * std::numbers::pi / 2;
            for (const int letter : side.angle.letters) angle += equations.letter(letter).value;
            const double own = equations.letter(side.length).value * (side.on_the_right ? -1 : 1);
            x += own * std::cos(angle);
            y += own * std::sin(angle);
            longest = std::max(longest, std::abs(own));
        }
        worst = std::max(worst, std::hypot(x, y) / longest);
    }
    return worst;
}

class EquationsOfExample : public testing::TestWithParam<std::string> {};

TEST_P(EquationsOfExample, GiveTheMotionOfThePolygons) {
    const Solution& solution = tests::example(GetParam());
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    if (!equations.why_not.empty()) {
        const bool open =
            std::any_of(solution.mechanism.joints.begin(), solution.mechanism.joints.end(),
                        [](const Joint& joint) { return joint.pair().touches() && joint.profiles.size() < 2; });
        EXPECT_TRUE(solution.mechanism.motion || open || solution.mechanism.joints.empty())
            << equations.why_not.in(Language::en);
        return;
    }
    EXPECT_LT(gap(equations), 1e-11);
    const Mobility& mobility = solution.mobility;
    EXPECT_EQ(static_cast<int>(equations.unknowns.size()) - equations.rank, mobility.effective - mobility.driven);
    const Agreement found = agreement(solution, equations);
    EXPECT_LT(found.worst, 1e-9) << found.where;
    if (equations.is_regular()) {
        EXPECT_EQ(found.missing, 0) << found.where;
    }
}

INSTANTIATE_TEST_SUITE_P(All, EquationsOfExample, testing::ValuesIn(tests::example_names()),
                         [](const auto& each) { return each.param; });

TEST(EquationsOfRandomMechanisms, GiveTheMotionOfThePolygons) {
    // KINEGRAPH_RANDOM_MECHANISMS=2000 takes as many once.
    const char* const asked = std::getenv("KINEGRAPH_RANDOM_MECHANISMS");
    const int count = asked != nullptr ? std::stoi(asked) : unless_sanitized(120, 12);
    int compared = 0;
    double worst = 0;
    for (int seed = 1; seed <= count; ++seed) {
        const RandomMechanism drawn = random_mechanism(static_cast<std::uint64_t>(seed) * 17);
        const Solution solution = tests::solved(drawn.text);
        const Equations equations = equations_of(solution.mechanism, solution.pose);
        ASSERT_TRUE(equations.why_not.empty()) << equations.why_not.in(Language::en);
        EXPECT_LT(gap(equations), 1e-11);
        const Mobility& mobility = solution.mobility;
        ASSERT_EQ(static_cast<int>(equations.unknowns.size()) - equations.rank, mobility.effective - mobility.driven)
            << drawn.text;
        const Agreement found = agreement(solution, equations);
        ASSERT_LT(found.worst, 1e-9) << found.where << " " << drawn.recipe << drawn.text;
        if (equations.is_regular()) {
            ASSERT_EQ(found.missing, 0) << found.where << drawn.text;
        }
        compared += found.compared;
        worst = std::max(worst, found.worst);
    }
    EXPECT_GT(compared, 16 * count);
    if (asked != nullptr)
        std::cout << count << " mechanisms, " << compared << " values, worst difference " << worst << "\n";
}

/// The loops of the course's slider-crank: λ = 1/3, α = 60°.
TEST(EquationsOfSliderCrank, HaveTheNumbersOfTheCourse) {
    const Solution& solution = tests::example("slider_crank");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    ASSERT_EQ(equations.loops.size(), 1U);
    EXPECT_EQ(spelt(equations, equations.loops.front()), "a e^{i alpha} + b e^{i beta} = c");
    EXPECT_NEAR(degrees(named(equations, "theta 3").value), -16.78, 0.005);
    EXPECT_NEAR(named(equations, "s B").value, 0.16861, 5e-6);
    EXPECT_NEAR(ratio(equations, "s B", "theta 2"), -0.05084, 5e-6);
    EXPECT_NEAR(ratio(equations, "s B", "theta 2", true), -0.01669, 5e-6);
    // β' = −λ cos α / cos β.
    const double beta = named(equations, "theta 3").value;
    EXPECT_NEAR(ratio(equations, "theta 3", "theta 2"), -0.5 / 3 / std::cos(beta), 1e-12);
    ASSERT_TRUE(equations.determinant);
    EXPECT_NEAR(std::abs(*equations.determinant), 0.15 * std::cos(beta), 1e-12);
    // b > a: the crank turns fully; the slider rests at c = a + b and c = b − a.
    const Equations::Solved& solved = equations.loops.front().solved;
    EXPECT_EQ(solved.kind, Equations::Solved::Kind::turn_and_slide);
    ASSERT_TRUE(solved.dead_points);
    EXPECT_TRUE(solved.dead_points->empty());
    ASSERT_EQ(solved.standstills.size(), 2U);
    EXPECT_NEAR(solved.standstills[0].first, 0, 1e-9);
    EXPECT_NEAR(solved.standstills[0].second, 0.2, 1e-12);
    EXPECT_NEAR(std::abs(solved.standstills[1].first), std::numbers::pi, 1e-9);
    EXPECT_NEAR(solved.standstills[1].second, 0.1, 1e-12);
}

/// A crank longer than its rod: det J = b cos β vanishes at sin α = ± b/a, and α goes no further.
TEST(EquationsOfSliderCrank, TellThatALongCrankMakesNoFullTurn) {
    const Solution& solution = tests::example("slider_crank_long_crank");
    ASSERT_TRUE(solution.equations);
    const Equations& equations = *solution.equations;
    ASSERT_TRUE(equations.loops.front().solved.dead_points);
    const std::vector<double>& dead = *equations.loops.front().solved.dead_points;
    ASSERT_EQ(dead.size(), 4U);
    for (const double each : dead) EXPECT_NEAR(std::abs(std::sin(each)), 0.8, 1e-12);
}

/// A four-bar whose bars are these, drawn at 30°, which only a sine knows.
Solution four_bar(const std::vector<Setting>& bars, const std::string& side) {
    constexpr const char* file = R"json({"kinegraph": 1, "units": {"length": "mm"},
        "parameters": {"a": "20 mm", "b": "60 mm", "c": "20 mm", "d": "60 mm", "th": "30°"},
        "points": {"O2": [0, 0], "A": ["= a*cos(th)", "= a*sin(th)"], "O4": ["= d", 0],
                   "B": {"meet": [{"circle": "A", "radius": "= b"}, {"circle": "O4", "radius": "= c"}],
                   "side": "left"}},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [0, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [0, 4]}],
        "drivers": [{"body": 2, "omega": 10}], "find": ["velocity", "acceleration", "equations"]})json";
    std::string text = file;
    text.replace(text.find("left"), 4, side);
    auto mechanism = read_mechanism(text, "four_bar.json", bars);
    if (!mechanism) throw std::runtime_error(mechanism.error().front().message.in(Language::en));
    auto solution = solve(*std::move(mechanism));
    if (!solution) throw std::runtime_error(solution.error().front().message.in(Language::en));
    return *std::move(solution);
}
std::string told(const Solution& solution, Language language) {
    return render::as_text(render::equation_items(solution, language));
}

/// Where the shortest and the longest bar are as long as the two others the bars come to lie in one line, and go on
/// beyond it.
TEST(EquationsAtChangePoints, TellThatTheCrankPasses) {
    const std::vector<Setting> parallelogram, other{{"a", "40 mm"}, {"b", "70 mm"}, {"c", "90 mm"}};
    for (const auto& [bars, side] :
         {std::pair(parallelogram, "left"), std::pair(parallelogram, "right"), std::pair(other, "left")}) {
        const Solution solution = four_bar(bars, side);
        const Equations::Solved& solved = solution.equations->loops.front().solved;
        ASSERT_TRUE(solved.dead_points);
        EXPECT_TRUE(solved.dead_points->empty());
        const bool twice = bars.empty();
        ASSERT_EQ(solved.change_points.size(), twice ? 2U : 1U);
        EXPECT_NEAR(solved.change_points.front(), 0, 1e-9);
        EXPECT_NEAR(solved.change_points.back(), twice ? std::numbers::pi : 0, 1e-9);
        const std::string english = told(solution, Language::en), italian = told(solution, Language::it);
        const std::string places = twice ? "0°; 180°: change points" : "0°: a change point";
        EXPECT_NE(english.find("det J = 0 at α = " + places +
                               ", where the branch is a choice; the driven body passes and makes full turns."),
                  std::string::npos)
            << english;
        EXPECT_EQ(english.find("no full turn"), std::string::npos);
        const std::string posti = twice ? "0°; 180°: punti di biforcazione" : "0°: un punto di biforcazione";
        EXPECT_NE(italian.find("det J = 0 per α = " + posti +
                               ", dove il ramo è una scelta; il membro movente vi passa e compie giri completi."),
                  std::string::npos)
            << italian;
    }
    // A crank longer by a hundredth goes no further.
    const Solution stopped = four_bar({{"a", "40.01 mm"}, {"b", "70 mm"}, {"c", "90 mm"}}, "left");
    EXPECT_EQ(stopped.equations->loops.front().solved.dead_points->size(), 2U);
    EXPECT_TRUE(stopped.equations->loops.front().solved.change_points.empty());
    EXPECT_NE(told(stopped, Language::en).find("its body makes no full turn"), std::string::npos);
}

/// What the compass leaves over is no velocity: the coupler of a parallelogram translates, in the results and in the
/// equations.
TEST(EquationsOfAParallelogram, HaveNoNoise) {
    const Solution solution = four_bar({}, "left");
    ASSERT_FALSE(solution.pose.exact);
    EXPECT_TRUE(solution.bodies[2].omega->is_zero());
    EXPECT_TRUE(solution.bodies[2].alpha->is_zero());
    EXPECT_TRUE(solution.bodies[3].alpha->is_zero());
    const Equations& equations = *solution.equations;
    EXPECT_EQ(named(equations, "theta 3").rate, 0.0);
    EXPECT_EQ(named(equations, "theta 3").acceleration, 0.0);
    EXPECT_EQ(named(equations, "theta 4").rate, 10.0);
    EXPECT_EQ(named(equations, "theta 4").acceleration, 0.0);
    EXPECT_EQ(ratio(equations, "theta 3", "theta 2"), 0.0);
    EXPECT_EQ(ratio(equations, "theta 4", "theta 2", true), 0.0);
    const std::string text = told(solution, Language::en);
    EXPECT_EQ(text.find("10⁻"), std::string::npos) << text;
    for (const char* const noise : {"e-1", "e-2", "e-3"})
        EXPECT_EQ(equations_json(equations).find(noise), std::string::npos) << equations_json(equations);
}

TEST(EquationsAtDeadPoints, TellWhatCannotBeDriven) {
    for (const char* const name : {"slider_driven_dead_point"}) {
        const Solution& solution = tests::example(name);
        const Equations equations = equations_of(solution.mechanism, solution.pose);
        EXPECT_FALSE(equations.is_regular());
        ASSERT_TRUE(equations.determinant);
        EXPECT_EQ(*equations.determinant, 0);
        ASSERT_EQ(equations.cannot_be_driven.size(), 1U);
        EXPECT_EQ(equations.cannot_be_driven, equations.free);
    }
}

/// Grashof's crank-rocker turns fully; of the same links with a shorter frame side the crank stops where b and c are
/// stretched.
TEST(EquationsOfFourBar, FollowTheLawOfCosines) {
    const Solution& solution = tests::example("four_bar");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    const Equations::Loop& loop = equations.loops.front();
    EXPECT_EQ(loop.solved.kind, Equations::Solved::Kind::two_turns);
    EXPECT_EQ(spelt(equations, loop), "a e^{i alpha} + b e^{i beta} = d + c e^{i gamma}");
    const double b = equations.letter(loop.sides[at_index(loop.solved.first)].length).value;
    const double c = equations.letter(loop.sides[at_index(loop.solved.second)].length).value, p = loop.solved.resultant;
    const double beta = named(equations, "theta 3").value, gamma = named(equations, "theta 4").value;
    EXPECT_NEAR(std::cos(beta - loop.solved.direction), (b * b + p * p - c * c) / (2 * b * p), 1e-12);
    EXPECT_NEAR(std::cos(gamma - loop.solved.direction), (b * b - p * p - c * c) / (2 * c * p), 1e-12);
    // γ'/α' = a sin(α − β) / (c sin(γ − β)).
    const double a = 0.04, alpha = named(equations, "theta 2").value;
    EXPECT_NEAR(ratio(equations, "theta 4", "theta 2"), a * std::sin(alpha - beta) / (c * std::sin(gamma - beta)),
                1e-9);
    EXPECT_NEAR(std::abs(*equations.determinant), std::abs(b * c * std::sin(gamma - beta)), 1e-12);
}

/// A ladder that slips down a wall: x² + y² = l², so that ẏ = −(x/y) ẋ.
TEST(EquationsOfLadder, AreThoseOfTheCircle) {
    const Solution& solution = tests::example("elliptic_trammel");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    ASSERT_EQ(equations.free.size(), 1U);
    const Letter& x = equations.letter(equations.free.front());
    for (const int unknown : equations.unknowns) {
        const Letter& y = equations.letter(unknown);
        if (!y.is_angle) {
            EXPECT_NEAR(ratio(equations, y.name, x.name), -x.value / y.value, 1e-12);
        }
    }
}

/// A rod that slides through a pin of another: s e^{iγ} = a e^{iα} − d, so s γ' = a cos(α − γ), s' = −a sin(α − γ).
TEST(EquationsOfRodOnRod, AreThoseOfTheResultant) {
    const Solution& solution = tests::example("inverted_slider_crank");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    const Equations::Loop& loop = equations.loops.front();
    ASSERT_EQ(loop.solved.kind, Equations::Solved::Kind::turn_with_slide);
    const Equations::Side& rod = loop.sides[at_index(loop.solved.first)];
    const Letter &s = equations.letter(rod.length), &gamma = equations.letter(rod.angle.letters.front());
    const Letter &crank = named(equations, "theta 2"), &a = equations.letter(loop.sides.front().length);
    EXPECT_NEAR(loop.solved.resultant, s.value, 1e-12);
    EXPECT_NEAR(ratio(equations, gamma.name, "theta 2"), a.value * std::cos(crank.value - gamma.value) / s.value,
                1e-12);
    EXPECT_NEAR(ratio(equations, s.name, "theta 2"), -a.value * std::sin(crank.value - gamma.value), 1e-12);
}

/// Norton's inverted slider-crank: rod and arm c are square to each other, so b² = p² − c², and the arm gives the
/// angle.
constexpr const char* rod_at_an_arm = R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
  "points": {"O2": [0, 0], "O4": [120, 0], "A": {"from": "O2", "distance": 50, "angle": 110},
    "B": {"meet": [{"line": "A", "angle": -10}, {"circle": "O4", "radius": 40}], "side": "behind"}},
  "bodies": {"2": ["O2", "A"], "3": ["A"], "4": ["O4", "B"]},
  "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
    {"prismatic": "B", "bodies": [4, 3], "along": ["A", "B"]}, {"revolute": "O4", "bodies": [4, 1]}],
  "drivers": [{"body": 2, "omega": 18, "alpha": -60}]})";

TEST(EquationsOfRodAtAnArm, AreThoseOfARightTriangle) {
    const Solution solution = tests::solved(rod_at_an_arm);
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    const Equations::Loop& loop = equations.loops.front();
    ASSERT_EQ(loop.solved.kind, Equations::Solved::Kind::turn_with_offset_slide);
    const double b = equations.letter(loop.sides[at_index(loop.solved.first)].length).value;
    const double c = equations.letter(loop.sides[at_index(loop.solved.second)].length).value;
    EXPECT_NEAR(std::hypot(b, c), loop.solved.resultant, 1e-12);
    // b vanishes where A is c from O4: 50² + 120² − 2·50·120 cos α = c², for no α.
    ASSERT_TRUE(loop.solved.dead_points);
    EXPECT_TRUE(loop.solved.dead_points->empty());
}

TEST(EquationsOfRodAtAnArm, SayTheRightTriangleAndKeepNumbersApartInBothLanguages) {
    auto mechanism = read_mechanism(rod_at_an_arm, "rod.json");
    ASSERT_TRUE(mechanism);
    mechanism->find.equations = true;
    const auto solved = solve(*std::move(mechanism));
    ASSERT_TRUE(solved);
    const Solution& solution = *solved;
    const std::string english = render::as_text(render::equation_items(solution, Language::en));
    const std::string italian = render::as_text(render::equation_items(solution, Language::it));
    const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
    EXPECT_TRUE(has(english, "right triangle")) << english;
    EXPECT_TRUE(has(italian, "triangolo rettangolo")) << italian;
    EXPECT_TRUE(has(english, "  b = √(p^2 − c^2) = 143.18 mm\n")) << english;
    EXPECT_TRUE(has(english, "  sin (β − σ) = c/p = 0.155\n")) << english;
    EXPECT_TRUE(has(english, "  β = −10°\n"));
    EXPECT_FALSE(has(english, "Newton"));
    EXPECT_FALSE(has(italian, "Newton"));
    EXPECT_TRUE(has(english, "[46.985, 0.98481; 137.1, −0.17365]")) << english;
    EXPECT_TRUE(has(italian, "[[46,985; 0,98481]; [137,1; −0,17365]]")) << italian;
    EXPECT_TRUE(has(english, "det J = − b = −143.18")) << english;
}

/// Willis: (ω_2 − ω_4) R_2 = −(ω_3 − ω_4) R_3, and the planet on the fixed ring.
TEST(EquationsOfGears, AreWillisLaws) {
    const Solution& solution = tests::example("planetary_train");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    EXPECT_TRUE(equations.loops.empty());
    ASSERT_EQ(equations.laws.size(), 2U);
    EXPECT_NEAR(ratio(equations, "theta 4", "theta 2"), 30.0 / (30 + 70), 1e-12);
}

TEST(EquationsOfContacts, HoldToTheFirstOrderWhereOnlyTheTangentIsKnown) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "C": [3, 0], "P": [1, 1]},
      "bodies": {"2": {"points": ["O", "P"]}, "3": {"points": ["C", "P"]}},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "C", "bodies": [1, 3]},
                 {"contact": "P", "bodies": [2, 3], "tangent": 30}],
      "drivers": [{"body": 2, "omega": 2}], "find": ["velocity"]})");
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    ASSERT_TRUE(equations.why_not.empty()) << equations.why_not.in(Language::en);
    EXPECT_EQ(equations.by_tangent.size(), 1U);
    EXPECT_LT(gap(equations), 1e-11);
    EXPECT_TRUE(equations.second_ratios.empty());
    const Agreement found = agreement(solution, equations);
    EXPECT_LT(found.worst, 1e-9) << found.where;
    EXPECT_EQ(found.missing, 0) << found.where;
    EXPECT_GE(found.compared, 4);
    EXPECT_FALSE(equations.bodies[2].alpha) << "the profiles' curvatures are not known";
}

TEST(EquationsAsJson, HaveTheKeysOfTheFormat) {
    const std::string text =
        equations_json(equations_of(tests::example("slider_crank").mechanism, tests::example("slider_crank").pose));
    for (const char* const key :
         {"\"unknowns\": [\"theta 3\", \"s B\"]", "\"jacobian\": [[", "\"determinant\": ",
          "\"velocity ratios\": {\"theta 3\": {\"theta 2\": ", "\"loops\": [\"a e^{i alpha} + b e^{i beta} = c\"]"})
        EXPECT_NE(text.find(key), std::string::npos) << key << text;
}

}  // namespace
}  // namespace kinegraph::equations_test
