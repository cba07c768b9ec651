// Lengths and parameters of a file that the live page can change, and how the numbers of the closure and of the plans
// depend on them.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/moving.hpp"

namespace kinegraph {

/// A parameter with a value of its own, as written in the file (or in an override): 45 and "mm"; the unit of a bare
/// number is empty.
struct WrittenParameter {
    std::string name;
    double number = 0;
    std::string unit;
};

/// What a file writes that the mechanism does not keep, and a function that reads the file again with other values of
/// its parameters.
struct Rereading {
    /// By driver: the units of its speed and of its acceleration ("rpm"); empty: of the file, or a formula.
    std::vector<std::array<std::string, 2>> rates;
    std::vector<WrittenParameter> parameters;
    std::function<Result<Mechanism>(std::span<const Setting>)> read;
};

/// For the text of a file; `set` overrides its parameters.
Rereading rereading_of(std::string text, std::string source, std::vector<Setting> set);

/// Lengths of bodies that have only two hinges, with all their points on the line of these; and the distance of the
/// frame's hinges, if it has two and nothing else.
std::vector<MovingSetting> lengths_of(const Mechanism& mechanism, const Pose& pose);

/// Adds to `moving` the parameters on which its numbers depend as polynomials of degree two (for angles: in sums and
/// products of their cosines and sines), with their effects, and removes the lengths that depend on them. The
/// coefficients are fitted by reading the file with other values. They must be exact, or accurate to 1e-11 at other
/// test values. Listed as fixed: a parameter for which this fails, which changes a law, which is zero, or which has no
/// effect (such as the drawn crank angle). `mechanism` and `pose` are those from which `moving` was made; its closure
/// and plans must exist.
void add_parameters(Moving& moving, const Mechanism& mechanism, const Pose& pose, const Rereading& rereading);

}  // namespace kinegraph
