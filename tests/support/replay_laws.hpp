// What must hold of every record: it holds no stroke that nothing needs, and whoever replays it gets what it was made
// with.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph::tests {

/// Strokes that neither a drawing, nor a result, nor a verdict needs.
int idle_strokes(const Solution& solution);

/// Replayed in Exact, every element is identical and no guard flips.
void expect_identical_replay(const Solution& solution);
/// Replayed in doubles: by how much the worst result differs, as a part of the largest of its kind; infinite where a
/// guard flips.
double difference_in_doubles(const Solution& solution);
/// What doubles may lose.
constexpr double loss_in_doubles = 1e-9;

/// The mechanism with other speeds, accelerations, loads and masses.
Mechanism with_other_givens(Mechanism mechanism);
/// With those the record gives what a fresh solution gives; true if it does, false where a guard flips, which is then
/// named.
bool expect_fresh_solution(const Solution& solution);

}  // namespace kinegraph::tests
