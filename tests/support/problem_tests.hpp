// Shared by the tests of contact, wear and impact: their solutions by kind, and the comparison of the results with the
// checks.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/solution/problem_solution.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::tests {

/// The result of the kind that the file states.
template <class Found>
const Found& found_in(const Solution& solution) {
    return solution.problem->as<Found>();
}
/// A file that states a problem, lengths in mm; `members` are the members of its section.
inline Solution stated(const std::string& section, const std::string& members) {
    return solved(R"({"kinegraph": 1, "units": {"length": "mm"}, ")" + section + R"(": {)" + members + "}}");
}
/// Each value agrees with the check within a share of itself or of the largest value.
enum class Against { itself, largest };
inline void expect_near_check(const ProblemSolution& found, double share, Against against) {
    ASSERT_FALSE(found.values.empty());
    double largest = 0;
    for (const ProblemValue& each : found.values) largest = std::max(largest, std::abs(each.value));
    for (const ProblemValue& each : found.values)
        EXPECT_NEAR(each.value, *each.numeric, share * (against == Against::itself ? std::abs(each.value) : largest))
            << each.name.in(Language::en);
}

}  // namespace kinegraph::tests
