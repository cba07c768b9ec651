// Two thousand mechanisms built on the chains of four, six and eight links (tests/support/chains.hpp): every inversion,
// every link driven, under loads. None that the check solves is refused, and each obeys the laws of motion and of
// statics, exactly.
//
// Each is named by its seed; KINEGRAPH_SEED=n runs that one alone and prints its file, KINEGRAPH_RANDOM_MECHANISMS=n so
// many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "constructions/solving/solve.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "lang/keys/phrases.hpp"
#include "tests/support/chains.hpp"
#include "tests/support/force_laws.hpp"
#include "tests/support/motion_laws.hpp"
#include "tests/support/random_loads.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/replay_laws.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::chains_random_test {
namespace {

// --- the chains
// --------------------------------------------------------------------------------------------------------------

TEST(Chains, AreAsManyAsTheBooksSay) {
    EXPECT_EQ(chains_of(4).size(), 1U);
    EXPECT_EQ(chains_of(6).size(), 2U) << "Watt and Stephenson";
    EXPECT_EQ(chains_of(8).size(), 16U);
    EXPECT_EQ(all_inversions().size(), 12U + 60U + 896U);
}

TEST(Chains, OfSixLinksAreWattsAndStephensons) {
    // Watt's two ternary links are hinged to each other, Stephenson's are not.
    std::multiset<bool> adjacent;
    for (const Chain& chain : chains_of(6)) {
        std::vector<int> ternary;
        for (int link = 0; link < 6; ++link)
            if (chain.degree(link) == 3) ternary.push_back(link);
        ASSERT_EQ(ternary.size(), 2U);
        const std::vector<int> near = chain.neighbours(ternary[0]);
        adjacent.insert(std::find(near.begin(), near.end(), ternary[1]) != near.end());
    }
    EXPECT_EQ(adjacent, (std::multiset<bool>{false, true}));
}

TEST(Chains, OfEightLinksHaveTheDegreesOfTheAtlas) {
    // Sixteen chains: nine of four ternary links, five of two ternary and a quaternary, two of two quaternary ones.
    std::map<std::vector<int>, int> count;
    for (const Chain& chain : chains_of(8)) {
        std::vector<int> more_than_binary;
        for (int link = 0; link < 8; ++link)
            if (chain.degree(link) > 2) more_than_binary.push_back(chain.degree(link));
        std::sort(more_than_binary.begin(), more_than_binary.end());
        ++count[more_than_binary];
    }
    EXPECT_EQ(count, (std::map<std::vector<int>, int>{{{3, 3, 3, 3}, 9}, {{3, 3, 4}, 5}, {{4, 4}, 2}}));
}

TEST(Chains, AreDrawnWithEveryPair) {
    std::map<std::string, int> count;
    for (std::uint64_t seed = 0; seed < all_inversions().size(); ++seed)
        for (const char* pair : {"slides", "slot", "arc", "rolls", "touches", "geared", "rack"})
            count[pair] += random_chain_mechanism(seed).recipe.find(pair) != std::string::npos ? 1 : 0;
    ASSERT_EQ(count.size(), 7U);
    for (const auto& [pair, drawn] : count) EXPECT_GE(drawn, 20) << pair;
}

// --- mechanisms
// --------------------------------------------------------------------------------------------------------------

struct Tally {
    int held = 0;  ///< motion and forces solved, in agreement with the check, obeying all laws
    int motion_only =
        0;  ///< the effort acts where it can balance nothing: motion held, and no force that is not determined
    int undetermined = 0;  ///< a dead point or a change point: the check does not solve it either
    int in_doubles = 0, roughly = 0,
        not_in_doubles = 0;  ///< replayed in doubles: as in Exact, nearly so, a verdict drowned
    int fresh = 0,
        flipped = 0;  ///< with other speeds and loads the record gave a fresh solution, or said which verdict changed
};

bool is_of_forces(const Unsolved& unsolved) { return unsolved.what.sentence == lang::phrases::all_forces; }

bool wholly_known(const NumericMotion& motion) {
    return std::all_of(motion.bodies.begin() + 1, motion.bodies.end(),
                       [](const auto& body) { return body.velocity_known && body.acceleration_known; });
}

/// A fault of ours is a failure of this mechanism, not of the run.
std::optional<Solution> solved(const std::string& text, const std::string& name) {
    auto mechanism = read_mechanism(text, name);
    if (!mechanism) {
        ADD_FAILURE() << mechanism.error().front().where << ": " << mechanism.error().front().message.in(Language::en);
        return std::nullopt;
    }
    try {
        auto solution = solve(*std::move(mechanism));
        if (solution) return *std::move(solution);
        ADD_FAILURE() << solution.error().front().message.in(Language::en);
    } catch (const std::exception& fault) {
        ADD_FAILURE() << fault.what();
    }
    return std::nullopt;
}

void hold_solution(const Solution& solution, Tally& tally) {
    for (const Unsolved& unsolved : solution.unsolved)
        EXPECT_GT(english(unsolved.why).size(), 10u) << english(unsolved.what);
    const NumericMotion motion = check_motion(solution.mechanism, solution.pose);
    const NumericForces forces = check_forces(solution.mechanism, solution.pose, motion);
    const bool free = solution.mobility.effective != 1 || solution.mobility.driven != 1;
    EXPECT_EQ(free, !wholly_known(motion)) << "the check and the rank disagree about what is determined";
    if (free) {
        EXPECT_FALSE(solution.unsolved.empty());
        ++tally.undetermined;
        return;
    }
    if (!wholly_known(forces)) {
        EXPECT_FALSE(solution.unsolved.empty());
        for (const Unsolved& unsolved : solution.unsolved) EXPECT_TRUE(is_of_forces(unsolved)) << english_of(unsolved);
        expect_laws_of_motion(solution);
        expect_determined_forces_only(solution, forces);
        ++tally.motion_only;
        return;
    }
    for (const Unsolved& unsolved : solution.unsolved) ADD_FAILURE() << english_of(unsolved);
    if (!solution.unsolved.empty()) return;
    expect_laws_of_motion(solution);
    expect_laws_of_forces(solution, forces);
    ++tally.held;
}

void hold_text(const std::string& bare_text, std::uint64_t seed, Tally& tally) {
    const std::string name = "seed " + std::to_string(seed);
    const auto bare = read_mechanism(bare_text, name);
    ASSERT_TRUE(bare) << bare.error().front().where << ": " << bare.error().front().message.in(Language::en);
    const auto pose = draw_pose(*bare);
    ASSERT_TRUE(pose) << pose.error().front().message.in(Language::en);
    const std::string text = under_random_loads(bare_text, *bare, *pose, seed, 0);
    if (std::getenv("KINEGRAPH_SEED") != nullptr) std::cerr << text;
    const auto solution = solved(text, name);
    if (!solution) {
        std::cerr << text;
        return;
    }
    hold_solution(*solution, tally);
    tests::expect_identical_replay(*solution);
    const double lost = tests::difference_in_doubles(*solution);
    constexpr double to_be_read = 1e-4;  // on paper
    ++(lost <= tests::loss_in_doubles ? tally.in_doubles : lost <= to_be_read ? tally.roughly : tally.not_in_doubles);
    constexpr std::uint64_t one_in = 4;  // a fresh solution costs as much as the first
    if (seed / 4 % one_in == 0) ++(tests::expect_fresh_solution(*solution) ? tally.fresh : tally.flipped);
    if (testing::Test::HasFailure()) std::cerr << text;
}

/// True where the drivers determine the motion, so that the laws have been held.
bool hold(std::uint64_t seed, Tally& tally) {
    const ChainMechanism random = random_chain_mechanism(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
    const int undetermined = tally.undetermined;
    hold_text(random.text, seed, tally);
    return tally.undetermined == undetermined;
}

void hold_quarter(int quarter) {
    Tally tally;
    EXPECT_TRUE(kinegraph::hold_quarter(
        quarter, unless_sanitized(2000, 200), [&](std::uint64_t seed) { return hold(seed, tally); },
        testing::Test::HasFailure))
        << "too few draws counted";
    const int counted = tally.held + tally.motion_only;
    EXPECT_LE(tally.undetermined, counted / 5 + 1) << "too few draws that the drivers determine";
    EXPECT_LE(tally.motion_only, counted / 20 + 1);
    // Near a dead point forces are many orders of size larger than the loads, and trials within trials lose as many
    // digits: mostly some of them, of one in a hundred draws all that are looked at.
    EXPECT_LE(tally.roughly, tally.in_doubles / 25 + 1);
    EXPECT_LE(tally.not_in_doubles, tally.in_doubles / 100 + 1);
    EXPECT_LE(tally.flipped, tally.fresh / 4 + 1) << "few verdicts hang on speeds and loads";
    std::cout << tally.held << " held, " << tally.motion_only << " in their motion only, " << tally.undetermined
              << " undetermined; with other givens " << tally.fresh << " as fresh solutions, " << tally.flipped
              << " with a verdict that changed; in doubles " << tally.in_doubles << " to 1e-9, " << tally.roughly
              << " less well, " << tally.not_in_doubles << " not\n";
}

TEST(RandomChains1, ObeyTheLaws) { hold_quarter(0); }
TEST(RandomChains2, ObeyTheLaws) { hold_quarter(1); }
TEST(RandomChains3, ObeyTheLaws) { hold_quarter(2); }
TEST(RandomChains4, ObeyTheLaws) { hold_quarter(3); }

}  // namespace
}  // namespace kinegraph::chains_random_test
