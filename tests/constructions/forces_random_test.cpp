// A thousand random mechanisms under random loads, each resolved by construction and by the numeric equilibrium, and
// held against the laws of statics, exactly: every body closes in force and moment, the joined polygon too, action is
// reaction turned round, and no power is lost.
//
// Each is named by its seed; KINEGRAPH_SEED=n runs that one alone and prints its file, KINEGRAPH_RANDOM_MECHANISMS=n so
// many.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

#include "constructions/solving/solve.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "tests/support/force_laws.hpp"
#include "tests/support/random_loads.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::forces_random_test {
namespace {

/// A fault of ours is a failure of this mechanism, not of the run.
std::optional<Solution> solved(const Mechanism& mechanism) {
    try {
        auto solution = solve(mechanism);
        if (solution) return *std::move(solution);
        ADD_FAILURE() << solution.error().front().message.in(Language::en);
    } catch (const std::exception& fault) {
        ADD_FAILURE() << fault.what();
    }
    return std::nullopt;
}

/// True where the seed gives a mechanism that the check resolves wholly; then everything has been held.
bool hold(std::uint64_t seed) {
    const RandomMechanism random = random_mechanism(seed);
    if (random.bodies > 10) return false;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
    const auto bare = read_mechanism(random.text, "seed " + std::to_string(seed));
    if (!bare) return ADD_FAILURE() << bare.error().front().message.in(Language::en), false;
    const auto pose = draw_pose(*bare);
    if (!pose) return ADD_FAILURE() << pose.error().front().message.in(Language::en), false;
    std::string text = under_random_loads(random.text, *bare, *pose, seed, random.freedoms);
    text.insert(text.rfind("\n}"), ",\n  \"find\": [\"velocity\", \"acceleration\", \"forces\"]");
    if (std::getenv("KINEGRAPH_SEED") != nullptr) std::cerr << text;
    const auto mechanism = read_mechanism(text, "seed " + std::to_string(seed));
    if (!mechanism)
        return ADD_FAILURE() << mechanism.error().front().where << ": "
                             << mechanism.error().front().message.in(Language::en) << text,
               false;
    const auto solution = solved(*mechanism);
    if (!solution) return std::cerr << text, false;
    const NumericForces numeric =
        check_forces(solution->mechanism, solution->pose, check_motion(solution->mechanism, solution->pose));
    if (!wholly_known(numeric)) {
        // A dead point of the effort, mostly. It says why, and gives no force that equilibrium does not determine.
        EXPECT_FALSE(solution->unsolved.empty());
        for (const Unsolved& unsolved : solution->unsolved)
            EXPECT_GT(english(unsolved.why).size(), 10u) << english(unsolved.what);
        expect_determined_forces_only(*solution, numeric);
        if (testing::Test::HasFailure()) std::cerr << text;
        return false;
    }
    for (const Unsolved& unsolved : solution->unsolved) ADD_FAILURE() << english_of(unsolved);
    if (solution->unsolved.empty()) expect_laws_of_forces(*solution, numeric);
    if (testing::Test::HasFailure()) std::cerr << text;
    return true;
}

void hold_quarter(int quarter) {
    EXPECT_TRUE(kinegraph::hold_quarter(quarter, default_random_count, hold, testing::Test::HasFailure))
        << "too few draws counted";
}

TEST(RandomForces1, ObeyTheLaws) { hold_quarter(0); }
TEST(RandomForces2, ObeyTheLaws) { hold_quarter(1); }
TEST(RandomForces3, ObeyTheLaws) { hold_quarter(2); }
TEST(RandomForces4, ObeyTheLaws) { hold_quarter(3); }

/// A weight at a point where all joints of its body are; springs whose pull the bodies between their ends take among
/// themselves, so that all other forces vanish.
TEST(RandomForces, FoundWrongOnce) {
    for (const std::uint64_t seed : {789U, 1460U, 1941U, 5423U, 6790U}) EXPECT_TRUE(hold(seed)) << seed;
}

}  // namespace
}  // namespace kinegraph::forces_random_test
