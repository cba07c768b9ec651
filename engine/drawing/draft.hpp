// A pose under construction: the places so far, the grid for inexact ones, which of them depend on a root, and the
// faults. Owns no construction.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/file/error.hpp"

namespace kinegraph::drafting {

/// Precision that earlier roots may lose before a small value is trusted: 24 bits of the compass.
constexpr int bits_in_doubt = 24;

/// Longer numbers, numerator and denominator together (some 150 digits), would make every later number as long without
/// any visible effect on a drawing.
constexpr std::size_t most_bits = 1024;

/// z = x·y as complex numbers: y turned by x's angle, |x| times as long.
Vector turned(const Vector& x, const Vector& y);
/// floor(log2 |value|) or one more. Only for the choice of grids.
int magnitude(const Exact& value);
/// The same for a vector's length.
int magnitude_of_length(const Vector& a);
/// Whether the tangent is rational. For a whole number of degrees or radians it is so only at the multiples of 45° (at
/// 0 for radians).
bool is_rational(const Angle& angle);
Words length_text(double metres, const Unit& unit);

class Draft {
public:
    /// `of_slack` (m): a miss up to this fits, because the data are rounded; 0 where they are exact.
    Draft(const Mechanism& of, int bits, int size_exponent, std::size_t longest_given, Exact of_slack);

    const Mechanism& mechanism;
    int grid;     ///< inexact coordinates are multiples of 2^-grid
    bool rounds;  ///< some number of the file is too long to be kept exactly
    Exact slack;
    Exact estimated_size;
    Pose pose;
    std::vector<bool> is_touched;  ///< by PointIndex: the place depends on a leftover, its own or an earlier one
    std::vector<bool> is_placed;   ///< by PointIndex
    std::vector<double> rough_x;   ///< by PointIndex, only for a first estimate
    Errors errors;

    /// The faults in the order of the file, whatever the order in which points are placed.
    Errors in_order_of_file();
    void measure();
    bool touched(PointIndex point) const { return is_touched[at_index(point)]; }

    Words in_file_units(double metres) const { return length_text(metres, mechanism.units.length); }
    Amount amount(double metres) const;
    std::string name_of(const Place& place) const;
    const std::string& name_of(PointIndex point) const { return mechanism.point(point).name; }
    bool fail(std::string where, Words message, ErrorCode code = ErrorCode::bad_input);
    Vector at(const Place& place) const;
    bool touched(const Place& place) const;
    bool touched(const Bearing::Between& between) const;
    /// from → to; empty, with a fault reported, where they coincide.
    std::optional<Vector> direction_between(const Bearing::Between& between, const std::string& where);
    bool is_small(const Vector& a) const;
    Vector on_grid(const Vector& a) const { return {rounded(a.x, grid), rounded(a.y, grid)}; }
    Exact grid_step() const { return Exact::power_of_two(-grid); }
    /// `by_root`: whether the place depends on an earlier root.
    void set(const NamedPoint& named, const Vector& exact_place, const Exact& own_leftover, bool by_root);
    /// distance·direction/|direction|, with the bound on its error.
    std::pair<Vector, Exact> along(const Vector& direction, const Exact& distance) const;
    /// through + factor·direction. Where the place is inexact, the factor is rounded to the grid, so that the point
    /// stays on the line.
    Vector on_line(const Vector& through, const Vector& direction, const Exact& factor, bool inexact) const;
};

}  // namespace kinegraph::drafting
