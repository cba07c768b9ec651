// Rounding: numbers that programs, pocket calculators and people have rounded. Decides which numbers of a file are
// exact by their form and which only to its precision, shifts the latter, and decides whether a value is zero within
// the data.
#pragma once

#include <span>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// A coordinate or length with so many significant digits was computed by a program and is rounded.
inline constexpr int digits_of_a_program = 15;
/// Whether the file has such a number but states no precision: its data then count as rounded to `inferred_share` of
/// the size.
bool looks_rounded(const Mechanism& mechanism);
Exact inferred_share();
/// Error of roots and sines in a file's formulas, which are accurate to 2^-200, m.
inline Exact precision_of_roots() { return Exact::power_of_two(-170); }

/// Number of shifted copies of the mechanism. A sum of many small errors is at most a quarter of its typical size in
/// all of them about once in a million.
inline constexpr int shifted_drawings = 6;

/// Shifts every number that is not exact by its form, by half its precision up to all of it. The sign and size depend
/// only on the number's place in the file and on `sample`. Coordinates and lengths move by up to `length` (m), all else
/// by up to `share`: an angle in radians, a ratio and the components of a vector relatively. Exact by their form: zero;
/// whole numbers of the file's unit, unless that unit is itself within the precision; and, except for lengths, numbers
/// with fewer digits than the precision has.
Mechanism shifted(const Mechanism& mechanism, const Exact& length, const Exact& share, int sample);

/// Zero within the data: at most four times the largest effect of the shifts. `shifted`: the same value on the shifted
/// drawings.
bool is_zero_within(const Vector& value, std::span<const Vector> shifted);
/// The same for a magnitude and its change under the shifts.
inline bool is_zero_within(double size, double spread) {
    constexpr double times = 4;
    return size <= times * spread;
}
/// Values not smaller than this many bits below their reference magnitude are never taken for zero: ∛ of the
/// precision's share. So a value that the data leave undetermined (error amplified without bound) does not count as
/// zero.
int bits_in_question(double share);

}  // namespace kinegraph
