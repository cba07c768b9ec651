// Lengths and parameters of a file, for whoever moves the mechanism with other values of them: which may be changed,
// and how the numbers of the closure and of the plans follow from them. Knows no page.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/moving.hpp"

namespace kinegraph {

/// A parameter with a value of its own, as the file (or who overrides it) writes it: 45 and "mm"; a bare number has no
/// unit.
struct WrittenParameter {
    std::string name;
    double number = 0;
    std::string unit;
};

/// The file read once more, with other values of its parameters.
struct Rereading {
    std::vector<WrittenParameter> parameters;
    std::function<Result<Mechanism>(std::span<const Setting>)> read;
};

/// Of a file's text; `set` overrides its parameters.
Rereading rereading_of(std::string text, std::string source, std::vector<Setting> set);

/// Bodies that two hinges alone hold, all they bear on the line of these: their lengths. And how far apart the frame's
/// hinges are, where it has two and nothing else.
std::vector<MovingSetting> lengths_of(const Mechanism& mechanism, const Pose& pose);

/// Adds to `moving` the parameters by which its numbers go as polynomials of the second degree (of angles as sums and
/// products of their cosines and sines), with their effects, and takes away the lengths that hang on them. They are
/// found by reading the file with other values and hold exactly, or to 1e-11 at values they were not made of; a
/// parameter of which that is not so, or which changes a law, is zero or changes nothing at all (where the crank is
/// drawn), is told among the fixed ones. `mechanism` and `pose` are those that `moving` was made of; the closure and
/// the plans are there.
void add_parameters(Moving& moving, const Mechanism& mechanism, const Pose& pose, const Rereading& rereading);

}  // namespace kinegraph
