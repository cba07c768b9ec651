// Indices: what may be said of them, and what the compiler refuses.
#include "engine/number/index.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>
#include <vector>

namespace kinegraph::index_test {
namespace {

static_assert(!std::is_convertible_v<int, BodyIndex> && !std::is_convertible_v<BodyIndex, int>);
static_assert(!std::is_constructible_v<BodyIndex, PointIndex> && !std::is_constructible_v<int, BodyIndex>);
static_assert(!std::is_invocable_v<std::equal_to<>, BodyIndex, JointIndex> &&
              !std::is_invocable_v<std::less<>, BodyIndex, int>);
static_assert(std::is_same_v<decltype(indices_of(std::vector<Statement*>{})), Indices<ListIndex<Statement*>>>);

std::vector<int> numbers(const Indices<BodyIndex>& range) {
    std::vector<int> found;
    for (const BodyIndex body : range) found.push_back(body.number());
    return found;
}

TEST(Index, NoneComesBeforeAll) {
    EXPECT_EQ(BodyIndex(), none);
    EXPECT_NE(frame, none);
    EXPECT_LT(BodyIndex(none), frame);
    EXPECT_EQ(frame.next(), BodyIndex(1));
}

TEST(Index, RunsThroughAListOnceInItsOrder) {
    EXPECT_EQ(numbers(indices<BodyIndex>(3)), (std::vector{0, 1, 2}));
    EXPECT_EQ(numbers(indices(3, BodyIndex(1))), (std::vector{1, 2}));
    EXPECT_TRUE(numbers(indices(3, BodyIndex(3))).empty());
    EXPECT_TRUE(numbers(indices(0, BodyIndex(2))).empty()) << "none are left after the last";
}

}  // namespace
}  // namespace kinegraph::index_test
