// The laws of every program: it contains no operation that nothing needs, and its replay gives the recorded values.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph::tests {

/// The number of operations that neither a drawing, nor a result, nor a guard needs.
int idle_strokes(const Solution& solution);

/// A replay in Exact gives identical elements, and no guard changes.
void expect_identical_replay(const Solution& solution);
/// The worst difference of a result replayed in doubles, relative to the largest of its kind; infinite if a guard
/// changes.
double difference_in_doubles(const Solution& solution);
/// The largest difference allowed in doubles.
constexpr double loss_in_doubles = 1e-9;

/// The mechanism with other speeds, accelerations, loads and masses.
Mechanism with_other_givens(Mechanism mechanism);
/// With other givens the replay equals a new solution. Returns false, after reporting it, if a guard changes.
bool expect_fresh_solution(const Solution& solution);

}  // namespace kinegraph::tests
