#include "engine/mechanism/law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/mechanism/law_curve.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

/// sin πx and cos πx; exactly zero where they vanish.
double sin_pi(double x) {
    x -= 2 * std::round(x / 2);
    if (std::abs(x) > 0.5) x = std::copysign(1, x) - x;
    return nearest::sin(std::numbers::pi * x);
}
double cos_pi(double x) { return sin_pi(0.5 - std::abs(x)); }

/// The first half of the modified trapezoid: a ramp over an eighth, constant over a quarter, a ramp down over an
/// eighth.
LawState first_half_of_trapezoid(double x) {
    const double most = 8 * std::numbers::pi / (2 + std::numbers::pi), four_pi = 4 * std::numbers::pi;
    const double speed_1 = most / four_pi, way_1 = speed_1 * (1.0 / 8 - 1 / four_pi);
    if (x <= 1.0 / 8) {
        return {speed_1 * (x - sin_pi(4 * x) / four_pi), speed_1 * (1 - cos_pi(4 * x)), most * sin_pi(4 * x)};
    }
    if (x <= 3.0 / 8) {
        const double u = x - 1.0 / 8;
        return {way_1 + speed_1 * u + most * u * u / 2, speed_1 + most * u, most};
    }
    const double speed_2 = speed_1 + most / 4, way_2 = way_1 + speed_1 / 4 + most / 32, u = x - 3.0 / 8;
    return {way_2 + speed_2 * u + most * (1 - cos_pi(4 * u)) / (four_pi * four_pi), speed_2 + speed_1 * sin_pi(4 * u),
            most * cos_pi(4 * u)};
}

/// f and its derivatives with respect to τ = x.
LawState unit_state(LawForm form, double x) {
    switch (form) {
        case LawForm::rest: return {};
        case LawForm::constant_speed: return {x, 1, 0};
        case LawForm::constant_acceleration:
            if (x < 0.5) return {2 * x * x, 4 * x, 4};
            return {1 - 2 * (1 - x) * (1 - x), 4 * (1 - x), -4};
        case LawForm::harmonic:
            return {(1 - cos_pi(x)) / 2, std::numbers::pi / 2 * sin_pi(x),
                    std::numbers::pi * std::numbers::pi / 2 * cos_pi(x)};
        case LawForm::cycloidal:
            return {x - sin_pi(2 * x) / (2 * std::numbers::pi), 1 - cos_pi(2 * x),
                    2 * std::numbers::pi * sin_pi(2 * x)};
        case LawForm::polynomial_345:
            return {x * x * x * (10 - 15 * x + 6 * x * x), 30 * x * x * (1 - x) * (1 - x),
                    60 * x * (1 - x) * (1 - 2 * x)};
        case LawForm::modified_trapezoidal: {
            if (x <= 0.5) return first_half_of_trapezoid(x);
            const LawState mirrored = first_half_of_trapezoid(1 - x);
            return {1 - mirrored.s, mirrored.first, -mirrored.second};
        }
    }
    return {};
}

double rise_of(const LawPiece& piece) { return piece.form == LawForm::rest ? 0 : piece.rise.to_double(); }

}  // namespace

std::string_view spelling_of(LawForm form) { return law_form_names.at(static_cast<std::size_t>(form)); }
std::optional<LawForm> law_form_spelt(std::string_view text) {
    const auto* const found = std::find(law_form_names.begin(), law_form_names.end(), text);
    if (found == law_form_names.end()) return std::nullopt;
    return static_cast<LawForm>(found - law_form_names.begin());
}

double Law::length() const {
    double sum = 0;
    for (const LawPiece& piece : pieces) sum += piece.over.to_double();
    return sum;
}

LawState Law::at(double t) const { return LawCurve(*this).at(t); }

LawCurve::LawCurve(const Law& law) {
    pieces_.reserve(law.pieces.size());
    for (const LawPiece& piece : law.pieces) {
        const double over = piece.over.to_double(), rise = rise_of(piece);
        pieces_.push_back({piece.form, over, rise, length_, length_ + over, way_});
        length_ += over;
        way_ += rise;
    }
}

LawState LawCurve::at(double t) const {
    // A time within rounding of a joint between two pieces counts as that joint.
    const double grain = 1e-14 * length_;
    if (t < -grain) return {};
    auto piece =
        std::partition_point(pieces_.begin(), pieces_.end(), [&](const Piece& each) { return t >= each.end - grain; });
    if (piece == pieces_.end()) {
        if (pieces_.empty() || t > length_ + grain) return {way_, 0, 0};
        --piece;
    }
    const LawState unit = unit_state(piece->form, std::clamp((t - piece->start) / piece->over, 0.0, 1.0));
    return {piece->way + piece->rise * unit.s, piece->rise * unit.first / piece->over,
            piece->rise * unit.second / (piece->over * piece->over)};
}

std::optional<double> Law::when(double s) const {
    const auto [least, most] = range();
    const double grain = 1e-12 * std::max(most - least, 1e-300);
    double start = 0, way = 0;
    for (const LawPiece& piece : pieces) {
        const double over = piece.over.to_double(), rise = rise_of(piece);
        if (std::abs(s - way) <= grain) return start;
        if (std::abs(s - way - rise) <= grain) return start + over;
        if ((s - way) * (s - way - rise) < 0) {
            double low = 0, high = 1;
            for (int i = 0; i < 60; ++i) {
                const double middle = (low + high) / 2;
                (unit_state(piece.form, middle).s * std::abs(rise) < std::abs(s - way) ? low : high) = middle;
            }
            return start + over * (low + high) / 2;
        }
        start += over;
        way += rise;
    }
    return std::nullopt;
}

std::pair<double, double> Law::range() const {
    double least = 0, most = 0, way = 0;
    for (const LawPiece& piece : pieces) {
        way += rise_of(piece);
        least = std::min(least, way);
        most = std::max(most, way);
    }
    return {least, most};
}

}  // namespace kinegraph
