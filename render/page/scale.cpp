// Scales: see scale.hpp.
#include "render/page/scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph::render {
namespace {

/// The mantissas of scales within one decade.
constexpr double round_numbers[] = {1, 2, 2.5, 5};

}  // namespace

double decimal(double mantissa, int exponent) {
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? mantissa / power : mantissa * power;
}

double choose_scale(double extent_x, double extent_y, double room_x, double room_y, std::optional<double> asked) {
    KG_ASSERT(room_x > 0 && room_y > 0, "a figure needs room");
    if (asked) return *asked;
    const double least = std::max(extent_x / room_x, extent_y / room_y);
    if (!(least > 0) || !std::isfinite(least)) return 1;
    const int exponent = static_cast<int>(std::floor(nearest::log10(least))) - 1;
    for (int e = exponent;; ++e)
        for (const double step : round_numbers)
            if (decimal(step, e) >= least * (1 - 1e-12)) return decimal(step, e);
}

std::vector<double> scales_between(double finest, double coarsest) {
    constexpr double finer_steps[] = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    std::vector<double> scales;
    for (int e = static_cast<int>(std::floor(nearest::log10(finest))); decimal(1, e) < coarsest; ++e)
        for (const double step : finer_steps)
            if (const double scale = decimal(step, e); scale >= finest && scale < coarsest * (1 - 1e-12))
                scales.push_back(scale);
    return scales;
}

}  // namespace kinegraph::render
