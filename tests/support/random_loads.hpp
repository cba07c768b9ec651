// Random loads for a random mechanism: adds to its file forces, couples, weights with and without inertia, springs, and
// input forces of every kind. The same on every machine.
#pragma once

#include <cstdint>
#include <string>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The mechanism's file with one to four loads and `efforts` input forces or couples at random places (0: the file has
/// its own). `all_kinds`: also elastic and torsion springs, distributed loads and loads on pins.
std::string under_random_loads(const std::string& text, const Mechanism& mechanism, const Pose& pose,
                               std::uint64_t seed, int efforts, bool all_kinds = false);

}  // namespace kinegraph
