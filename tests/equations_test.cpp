// The closure equations: written from the loops in symbols, evaluated, and held against the constructions, closed forms and the
// numbers of the course.
#include "engine/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "engine/solution.hpp"
#include "tests/files.hpp"
#include "tests/random_mechanism.hpp"
#include "tests/solved.hpp"

namespace kinegraph {
namespace {

using Letter = Equations::Letter;

double square(double x) { return x * x; }
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
    for (const BodyMotion& body : solution.bodies) spin = std::max(spin, std::abs(body.alpha.value_or(Exact(0)).to_double()));
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
        const auto both = [&](const char* what, const Vector& drawn, const std::optional<std::array<double, 2>>& written,
                              double large) {
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
    const Solution solution = tests::example(GetParam());
    const Equations equations = equations_of(solution.mechanism, solution.pose);
    if (!equations.why_not.empty()) {
        EXPECT_TRUE(solution.act_of_motion || solution.problem || solution.mechanism.joints.empty()) << equations.why_not.en;
        return;
    }
    EXPECT_LT(gap(equations), 1e-11);
    const Mobility& mobility = solution.mobility;
    EXPECT_EQ(static_cast<int>(equations.unknowns.size()) - equations.rank, mobility.effective - mobility.driven);
    const Agreement found = agreement(solution, equations);
    EXPECT_LT(found.worst, 1e-9) << found.where;
    if (equations.is_regular()) EXPECT_EQ(found.missing, 0) << found.where;
}

std::vector<std::string> mechanisms_of_examples() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(KINEGRAPH_EXAMPLES_DIR))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}
INSTANTIATE_TEST_SUITE_P(All, EquationsOfExample, testing::ValuesIn(mechanisms_of_examples()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace kinegraph
