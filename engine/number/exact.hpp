// Exact: the number of every construction, a rational without rounding (GMP's mpq). Owns arithmetic, the parsing of
// decimals and the certified square root. Has no units and no points; doubles are only an output (the nearest one).
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph {

/// An exact rational number, always in lowest terms. Division by zero is a fault of ours (assertion).
class Exact {
public:
    Exact() = default;
    Exact(const Exact&) = default;
    // (A move of mpq_class might throw, and then a growing vector would copy.)
    Exact(Exact&& other) noexcept { value_.swap(other.value_); }
    Exact& operator=(const Exact&) = default;
    Exact& operator=(Exact&& other) noexcept {
        value_.swap(other.value_);
        return *this;
    }
    ~Exact() = default;
    Exact(int value) : value_(value) {}  // NOLINT(google-explicit-constructor): 2 * x reads as the formula does
    explicit Exact(mpq_class value) : value_(std::move(value)) { value_.canonicalize(); }
    /// For a value that is already in lowest terms, such as any result of GMP's arithmetic on such fractions.
    static Exact in_lowest_terms(mpq_class&& value) {
        Exact result;
        result.value_.swap(value);
        return result;
    }

    /// numerator / denominator, denominator ≠ 0.
    static Exact ratio(std::int64_t numerator, std::int64_t denominator);
    /// 2^exponent, exponent of any sign.
    static Exact power_of_two(int exponent);
    /// The decimal as written: `-1.25e-3` is −1/800. Nothing if the text is no JSON-style decimal, has more than
    /// 1000 digits, or its exponent leaves ±400 (the caller refuses such numbers by their magnitude).
    static std::optional<Exact> from_decimal(std::string_view text);
    /// The double's own value (exact).
    static Exact from_double(double value);

    Exact& operator+=(const Exact& other) { return *this = *this + other; }
    Exact& operator-=(const Exact& other) { return *this = *this - other; }
    Exact& operator*=(const Exact& other) { return *this = *this * other; }
    Exact& operator/=(const Exact& other) { return *this = *this / other; }
    friend Exact operator+(const Exact& a, const Exact& b);
    friend Exact operator-(const Exact& a, const Exact& b);
    friend Exact operator*(const Exact& a, const Exact& b);
    friend Exact operator/(const Exact& a, const Exact& b);
    /// ab + cd and ab − cd: the scalar product and the determinant of CGAL's kernel (engine/number/geometry.cpp), which
    /// decide sides and angles.
    friend Exact sum_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d);
    friend Exact difference_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d);
    Exact operator-() const;

    friend bool operator==(const Exact& a, const Exact& b) { return a.value_ == b.value_; }
    friend std::strong_ordering operator<=>(const Exact& a, const Exact& b) { return cmp(a.value_, b.value_) <=> 0; }

    int sign() const { return sgn(value_); }
    bool is_zero() const { return sign() == 0; }
    /// The nearest double (ties to even); ±infinity only past the range of doubles.
    double to_double() const;
    /// "63/20", "-4".
    std::string to_fraction() const { return value_.get_str(); }
    /// Bits of numerator and denominator together: a measure of cost.
    std::size_t bits() const;
    const mpq_class& rational() const { return value_; }

private:
    mpq_class value_;
};

Exact abs(const Exact& value);
inline Exact square(const Exact& value) { return value * value; }
/// a − b to the nearest double, without reducing the difference to lowest terms, which would be most of the cost.
double difference_to_double(const Exact& a, const Exact& b);
/// Whether a/b = c/d, b and d ≠ 0.
bool is_same_ratio(const Exact& a, const Exact& b, const Exact& c, const Exact& d);
inline bool is_zero(const Exact& value) { return value.is_zero(); }
/// −1, 0, 1.
inline int sign_of(const Exact& value) { return value.sign(); }

// The same for doubles, for templates over both.
inline bool is_zero(double value) { return value == 0; }
inline int sign_of(double value) { return value == 0 ? 0 : value < 0 ? -1 : 1; }
inline double sum_of_products(double a, double b, double c, double d) { return a * b + c * d; }
inline double difference_of_products(double a, double b, double c, double d) { return a * b - c * d; }
/// Equality of rounded ratios is never certain.
inline bool is_same_ratio(double, double, double, double) { return false; }

/// value rounded to the nearest multiple of 2^-bits.
Exact rounded(const Exact& value, int bits);

/// The root of a rational ≥ 0 by integer square root: exact where the root is rational, else within 2^-bits of it.
struct Root {
    Exact value;
    Exact leftover;  ///< bound on |value − √radicand|; zero where the root is rational
};
Root square_root(const Exact& radicand, int bits);

/// π as one fixed rational within 2^-200 (so that rpm and degrees are the same number everywhere).
const Exact& pi();

/// tan of an angle in [0°, 45°], given as a fraction of the half turn, within 2^-bits; 0 and 1 exactly at the ends.
Exact tangent_in_first_octant(const Exact& half_turns, int bits);
/// The angle of (x, y) ≠ 0 from +x in degrees, in (-180°, 180°], within 2^-bits; multiples of 45° exactly.
Exact degrees_of(const Exact& y, const Exact& x, int bits);

/// A free vector or the coordinates of a finite place; the unit is the context's, the number Exact or, in replays,
/// double.
template <class Number>
struct VectorOf {
    Number x{};
    Number y{};

    bool is_zero() const { return kinegraph::is_zero(x) && kinegraph::is_zero(y); }
    friend bool is_zero(const VectorOf& a) { return a.is_zero(); }
    friend bool operator==(const VectorOf&, const VectorOf&) = default;
    friend VectorOf operator+(const VectorOf& a, const VectorOf& b) { return {a.x + b.x, a.y + b.y}; }
    friend VectorOf operator-(const VectorOf& a, const VectorOf& b) { return {a.x - b.x, a.y - b.y}; }
    friend VectorOf operator-(const VectorOf& a) { return {-a.x, -a.y}; }
    friend VectorOf operator*(const Number& s, const VectorOf& a) { return {s * a.x, s * a.y}; }
    friend Number dot(const VectorOf& a, const VectorOf& b) { return sum_of_products(a.x, b.x, a.y, b.y); }
    friend Number cross(const VectorOf& a, const VectorOf& b) { return difference_of_products(a.x, b.y, a.y, b.x); }
    friend Number squared_length(const VectorOf& a) { return dot(a, a); }
    /// A quarter turn counter-clockwise: z × a.
    friend VectorOf quarter_turn(const VectorOf& a) { return {-a.y, a.x}; }
};
using Vector = VectorOf<Exact>;
/// The nearest doubles.
inline VectorOf<double> to_double(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }
/// Unit vector along a ≠ 0.
inline VectorOf<double> unit_vector(const VectorOf<double>& a) { return (1 / nearest::hypot(a.x, a.y)) * a; }

/// Length as a double, for printing and drawing only.
double length(const Vector& a);
/// √((x − x0)² + (y − y0)²) likewise, without the two differences in lowest terms.
double distance(const Exact& x0, const Exact& y0, const Exact& x, const Exact& y);
inline double distance(const Vector& from, const Vector& to) { return distance(from.x, from.y, to.x, to.y); }

}  // namespace kinegraph
