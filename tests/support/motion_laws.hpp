// The laws of plane motion for a solved mechanism: agreement with the numeric check, rigid bodies, slides on their
// guides, closed polygons, three centres on a line. All exact, except for the check and for poses by compass.
#pragma once

namespace kinegraph {

struct Solution;

/// Fails the running test if a law is violated. Tests only results that were found; `motion_is_whole` tells if all
/// were.
void expect_laws_of_motion(const Solution& solution);

/// Requires that all results were found, and tests all the laws.
void expect_whole_motion(const Solution& solution);

}  // namespace kinegraph
