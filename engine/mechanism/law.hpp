// Law: the motion of a driver over time, or of a cam's follower over the cam's rotation, as a sequence of dwells and
// rises. Contains the pieces' closed forms only.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/number/exact.hpp"

namespace kinegraph {

/// With τ = t/T from 0 to 1 over a piece and h its rise, s = h f(τ).
enum class LawForm {
    rest,                   ///< f = 0
    constant_speed,         ///< f = τ; starts and ends with a jump of the speed
    constant_acceleration,  ///< f = 2τ² to the middle, then 1 − 2(1−τ)²: the acceleration ±4h/T²
    harmonic,               ///< f = (1 − cos πτ)/2; greatest acceleration π²/2 h/T²
    cycloidal,              ///< f = τ − sin(2πτ)/2π; greatest acceleration 2π h/T²
    polynomial_345,         ///< f = 10τ³ − 15τ⁴ + 6τ⁵; greatest acceleration 10/√3 h/T²
    modified_trapezoidal  ///< the acceleration's ramps are sines of an eighth each; its greatest value 8π/(2+π) h/T²
};

/// How files write the forms, in the order of LawForm.
inline constexpr std::array<std::string_view, 7> law_form_names{
    "rest", "constant speed", "constant acceleration", "harmonic", "cycloidal", "3-4-5", "modified trapezoidal"};
std::string_view spelling_of(LawForm form);
std::optional<LawForm> law_form_spelt(std::string_view text);

/// SI: rise in rad or m, `over` in s, or in rad of the cam's rotation; `over` is positive.
struct LawPiece {
    LawForm form = LawForm::rest;
    Exact rise, over;
};

/// Derivatives are with respect to the variable of `over`.
struct LawState {
    double s = 0, first = 0, second = 0;
};

struct Law {
    std::vector<LawPiece> pieces;
    Exact drawn;  ///< time of the law (s) in the drawn position
    std::string where;

    double length() const;  ///< of all pieces
    /// It is constant before its beginning and after its end. Where two pieces meet, the derivatives are those of the
    /// later one. Source: R. L. Norton, Cam Design and Manufacturing Handbook, ch. 3; f and its derivatives as above.
    LawState at(double t) const;
    /// The first t at which it reaches s; none: it never does.
    std::optional<double> when(double s) const;
    /// The least and the greatest s.
    std::pair<double, double> range() const;
};

}  // namespace kinegraph
