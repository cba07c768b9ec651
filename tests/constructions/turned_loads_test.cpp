// Turned loads: a change of a structure's loads is asked about exactly where no known program holds, and hundreds of
// loads ask no more often than a few.
#include "constructions/moving/turned_loads.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "constructions/moving/moving_rules.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::turned_loads_test {
namespace {

/// The changes that are asked about, up to the limit. `known`: the program of the solution is known.
std::vector<Mechanism> asked_of(const Solution& solution, bool known) {
    const MovingRules rules(solution.mechanism, solution.pose);
    TurnedLoads loads(solution.mechanism, solution.pose, rules.settings());
    if (known) loads.add(solution.protocol.program);
    std::vector<Mechanism> asked;
    loads.each_unplanned([&](const Mechanism& changed) {
        asked.push_back(changed);
        return true;
    });
    return asked;
}

/// What turned loads change of a program: its vectors and scalars.
std::vector<double> numbers_of(const Program& program, const Mechanism& mechanism, const Pose& pose) {
    std::vector<double> numbers;
    for (const Value& given : givens_of(program, mechanism, pose)) {
        const ValueOf<double> value = to_double(given);
        if (const auto* vector = std::get_if<VectorOf<double>>(&value))
            numbers.insert(numbers.end(), {vector->x, vector->y});
        if (const auto* scalar = std::get_if<double>(&value)) numbers.push_back(*scalar);
    }
    return numbers;
}

TEST(TurnedLoads, AreAskedAboutExactlyWhereNoProgramHolds) {
    int held = 0, flipped = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = tests::example(name);
        if (!solution.mechanism.drivers.empty()) continue;
        SCOPED_TRACE(name);
        const Program& program = solution.protocol.program;
        const auto holds = [&](const Mechanism& changed) {
            Replay fresh(program, givens_of(program, changed, solution.pose), solution.pose.size.to_double());
            return !fresh.run();
        };
        for (const Mechanism& changed : asked_of(solution, true)) EXPECT_FALSE(holds(changed));
        // Those that hold are passed over: the others come in the same order.
        const std::vector<Mechanism> asked = asked_of(solution, true);
        std::size_t next = 0;
        for (const Mechanism& changed : asked_of(solution, false)) {
            ++(holds(changed) ? held : flipped);
            if (holds(changed)) continue;
            ASSERT_LT(next, asked.size());
            EXPECT_EQ(numbers_of(program, asked[next], solution.pose), numbers_of(program, changed, solution.pose));
            ++next;
        }
    }
    EXPECT_GT(held, 100);
    EXPECT_GT(flipped, 20);
}

TEST(TurnedLoads, OfHundredsAskNoMoreOftenThanThoseOfAFew) {
    const auto asked_of_beam = [](int count) {
        std::string points, loads;
        for (int i = 0; i < count; ++i) {
            const std::string name = "L" + std::to_string(i);
            points += ", \"" + name + "\": [" + std::to_string(1 + i) + ", 0]";
            loads += (i > 0 ? ", " : "") + std::string(R"({"force": "F)") + std::to_string(i) +
                     R"(", "body": 2, "at": ")" + name + R"(", "value": [)" + std::to_string(i % 7 - 3) + ", -2]}";
        }
        return asked_of(tests::solved(R"({"kinegraph": 1, "points": {"O": [0, 0], "R": [900, 0])" + points +
                                      R"(}, "bodies": {"2": ["O", "R"]}, "joints": [{"revolute": "O", "bodies": [0, 2]},
                                      {"contact": "R", "bodies": [2, 0], "tangent": [1, 0]}], "loads": [)" +
                                      loads + R"(], "find": ["forces"]})"),
                        false)
            .size();
    };
    EXPECT_EQ(asked_of_beam(1), 3U * 28U);
    EXPECT_LE(asked_of_beam(300), 100U);
}

}  // namespace
}  // namespace kinegraph::turned_loads_test
