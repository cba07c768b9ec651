// Relative motions taken apart, and the motion found through an observer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lang/keys/sentences.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::relative_apart_test {
namespace {

using Apart = RelativeMotion::Apart;

/// The parts add up to their wholes, exactly where the pose is exact.
void expect_sums(const RelativeMotion& motion, const Pose& pose) {
    ASSERT_TRUE(motion.apart);
    const Apart& apart = *motion.apart;
    const auto same = [&](const Vector& a, const Vector& b, const char* what) {
        if (pose.exact)
            EXPECT_EQ(a, b) << what;
        else
            EXPECT_LE(length(a - b), 1e-20 * std::max(1.0, length(b))) << what;
    };
    same(*apart.origin_velocity + *apart.turning_velocity, *motion.transport_velocity, "v_tr");
    same(*apart.origin_acceleration + *apart.tangential + *apart.normal, *motion.transport_acceleration, "a_tr");
    same(*apart.velocity_along + *apart.velocity_across, *motion.relative_velocity, "v_rel");
    same(*apart.acceleration_along + *apart.acceleration_across, *motion.relative_acceleration, "a_rel");
    const Vector axis = apart.towards == none ? Vector{1, 0} : pose.at(apart.towards) - pose.at(apart.origin);
    EXPECT_NEAR(cross(axis, *apart.velocity_along).to_double(), 0, 1e-20);
    EXPECT_NEAR(dot(axis, *apart.acceleration_across).to_double(), 0, 1e-20);
}

bool says(const Solution& solution, Key sentence) {
    const auto& all = solution.protocol.statements;
    return std::any_of(all.begin(), all.end(),
                       [&](const Statement& each) { return each.message.sentence == sentence; });
}

TEST(RelativeMotionApart, IsThatOfTheExam) {
    const Solution& solution = tests::example("moving_frame");
    ASSERT_EQ(solution.relative_motion.size(), 1U);
    const RelativeMotion& motion = solution.relative_motion.front();
    expect_sums(motion, solution.pose);
    const Apart& apart = *motion.apart;
    // The exam reads v_R(A) = 0.64, v_T(A) = 0.55 m/s; ω_4 = 0, but ω̇_4 = −3.12 rad/s².
    EXPECT_NEAR(length(*motion.relative_velocity), 0.64, 0.005);
    EXPECT_NEAR(length(*motion.transport_velocity), 0.55, 0.005);
    EXPECT_TRUE(apart.omega->is_zero());
    EXPECT_NEAR(apart.alpha->to_double(), -3.12, 0.01);
    EXPECT_EQ(apart.no_coriolis, Apart::NoCoriolis::observer_does_not_turn);
    EXPECT_TRUE(apart.normal->is_zero());
    // The sleeve lets A slide along the rod alone: nothing across it.
    EXPECT_NEAR(length(*apart.velocity_across), 0, 1e-20);
    EXPECT_NEAR(length(*apart.acceleration_across), 0, 1e-20);
}

TEST(RelativeMotionApart, HasTheDriversOwnNumbersInTheMovingAxes) {
    const Solution& solution = tests::example("slider_on_moving_guide");
    const RelativeMotion& motion = solution.relative_motion.front();
    expect_sums(motion, solution.pose);
    const Apart& apart = *motion.apart;
    EXPECT_EQ(apart.no_coriolis, Apart::NoCoriolis::there_is);
    EXPECT_NEAR(length(*apart.velocity_along), 0.2, 1e-12);
    EXPECT_NEAR(length(*apart.acceleration_along), 0.5, 1e-12);
    EXPECT_NEAR(length(*motion.coriolis), 2 * 3 * 0.2, 1e-12);
    EXPECT_NEAR(length(*apart.normal), 9 * 0.09, 1e-12);
    EXPECT_NEAR(length(*apart.tangential), 2 * 0.09, 1e-12);
    EXPECT_EQ(*apart.origin_acceleration, (Vector{-1, 0}));
}

TEST(RelativeMotionApart, TellsThatAPointOfTheObserverRests) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "frame": 0, "points": {"O": [0, 0], "A": [1, 0], "B": [1, 1]},
      "bodies": {"1": {"points": ["O", "A", "B"]}}, "joints": [{"revolute": "O", "bodies": [0, 1]}],
      "drivers": [{"body": 1, "omega": 2, "alpha": 1}], "find": [{"relative motion": "B", "observer": 1}]})");
    const RelativeMotion& motion = solution.relative_motion.front();
    expect_sums(motion, solution.pose);
    EXPECT_EQ(motion.apart->no_coriolis, Apart::NoCoriolis::rests_for_observer);
}

std::string exam_through(const std::string& point, const std::string& observer) {
    std::string text = tests::contents(tests::example_file("moving_frame"));
    const std::size_t at = text.find("\"find\"");
    return text.substr(0, at) + R"("find": ["velocity", {"relative motion": ")" + point + R"(", "observer": )" +
           observer + R"(, "solve": true}]})";
}

TEST(MotionThroughAnObserver, IsFoundByTheExamsTriangle) {
    const Solution &plain = tests::example("exam_2001"), solution = tests::example("moving_frame");
    EXPECT_TRUE(says(solution, lang::sentences::observer_velocity));
    EXPECT_TRUE(says(solution, lang::sentences::observer_acceleration));
    EXPECT_TRUE(solution.unsolved.empty());
    for (std::size_t b = 0; b < plain.bodies.size(); ++b)
        EXPECT_NEAR(solution.bodies[b].omega.value_or(Exact(0)).to_double(),
                    plain.bodies[b].omega.value_or(Exact(0)).to_double(), 1e-15);
    EXPECT_FALSE(says(plain, lang::sentences::observer_velocity)) << "it was not asked to be solved so";
}

TEST(MotionThroughAnObserver, IsRemarkedWhereNoGuideGivesADirection) {
    const Solution solution = tests::solved(exam_through("C", "3"));
    EXPECT_FALSE(says(solution, lang::sentences::observer_velocity));
    EXPECT_TRUE(std::any_of(solution.remarks.begin(), solution.remarks.end(), [](const Message& each) {
        return each.sentence == lang::sentences::not_through_observer;
    }));
}

TEST(MotionThroughAnObserver, WantsOneOnABody) {
    const auto read = read_mechanism(exam_through("A", R"({"translating with": "B"})"), "test.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().front().where, "/find/1/solve");
}

}  // namespace
}  // namespace kinegraph::relative_apart_test
