// A pose while it is drawn: the places so far, on which grid they lie where they are inexact, which of them hang on a
// root, and the faults. It knows no construction.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/file/error.hpp"

namespace kinegraph::drafting {

/// What may be lost to earlier roots before a small value is taken for what it looks like: 24 of the compass's bits.
constexpr int bits_in_doubt = 24;

/// Numbers longer than this, numerator and denominator together (some 150 digits), make every number behind them as
/// long and show nothing on any drawing.
constexpr std::size_t most_bits = 1024;

/// z = x·y as complex numbers: y turned by x's angle, |x| times as long.
Vector turned(const Vector& x, const Vector& y);
/// floor(log2 |value|) or one more; for choosing grids only.
int magnitude(const Exact& value);
/// The same of a vector's length.
int magnitude_of_length(const Vector& a);
/// tan of a whole number of degrees or of radians is rational at the multiples of 45° only (of 0 in radians).
bool is_rational(const Angle& angle);
Words length_text(double metres, const Unit& unit);

class Draft {
public:
    /// `of_slack` (m): what misses by no more fits, because the data are rounded; 0 where they are exact.
    Draft(const Mechanism& of, int bits, int size_exponent, std::size_t longest_given, Exact of_slack);

    const Mechanism& mechanism;
    int grid;     ///< coordinates are multiples of 2^-grid where they are inexact
    bool rounds;  ///< some number of the file is too long to be kept
    Exact slack;
    Exact estimated_size;
    Pose pose;
    std::vector<bool> is_touched;  ///< by PointIndex: the place depends on a leftover, its own or an earlier one
    std::vector<bool> is_placed;   ///< by PointIndex
    std::vector<double> rough_x;   ///< by PointIndex, for a first look only
    Errors errors;

    /// Faults are told in the order of the file, whatever the order in which the points need each other.
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
    /// from → to; nothing, and said, where they coincide.
    std::optional<Vector> direction_between(const Bearing::Between& between, const std::string& where);
    bool is_small(const Vector& a) const;
    Vector on_grid(const Vector& a) const { return {rounded(a.x, grid), rounded(a.y, grid)}; }
    Exact grid_step() const { return Exact::power_of_two(-grid); }
    /// `by_root`: it hangs on an earlier one.
    void set(const NamedPoint& named, const Vector& exact_place, const Exact& own_leftover, bool by_root);
    /// distance·direction/|direction|, with the bound on its miss.
    std::pair<Vector, Exact> along(const Vector& direction, const Exact& distance) const;
    /// through + factor·direction; the factor goes to the grid where the place is inexact anyway, so the point keeps to
    /// the line.
    Vector on_line(const Vector& through, const Vector& direction, const Exact& factor, bool inexact) const;
};

}  // namespace kinegraph::drafting
