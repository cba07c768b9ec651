// Rounding: numbers that programs, pocket calculators and people have rounded. Which numbers of a file are exact by
// their form and which only to its precision; the same mechanism with the latter shifted; and the one question that is
// asked of a value then: is it zero within the data? Knows no construction.
#pragma once

#include <span>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// A coordinate or length of that many significant digits was not written by a person who means every one of them.
inline constexpr int digits_of_a_program = 15;
/// Whether the file has one, and does not say how it is meant: its data then count as rounded to `inferred_share` of
/// the size.
bool looks_rounded(const Mechanism& mechanism);
Exact inferred_share();
/// What roots and sines in a file's formulas, good to 2^-200, leave open, m.
inline Exact precision_of_roots() { return Exact::power_of_two(-170); }

/// How many times the mechanism is drawn with its numbers shifted. A sum of many small errors that happens to be a
/// quarter of its typical size or less in all of them is met about once in a million.
inline constexpr int shifted_drawings = 6;

/// Every number that is not exact by its form, moved by half its precision to all of it, in a sense that hangs on the
/// number's place in the file and on `sample` alone. Coordinates and lengths move by up to `length` (m), all else by up
/// to `share`: an angle in radians, a ratio and the components of a vector relatively. Exact by their form: zero; whole
/// numbers of the file's unit, where that is not itself within the precision; of what is no length also whatever has
/// fewer digits than the precision tells.
Mechanism shifted(const Mechanism& mechanism, const Exact& length, const Exact& share, int sample);

/// Zero within the data: at most four times the largest of what the shifts do to it. `shifted`: the same value on the
/// shifted drawings.
bool is_zero_within(const Vector& value, std::span<const Vector> shifted);
/// The same of a size and how far the shifts move it.
inline bool is_zero_within(double size, double spread) {
    constexpr double times = 4;
    return size <= times * spread;
}
/// What is no smaller than this many bits below what it stands beside is not asked: ∛ of the precision's share, so that
/// what the data leave open altogether (a value amplified from them without bound) is not taken for nothing.
int bits_in_question(double share);

}  // namespace kinegraph
