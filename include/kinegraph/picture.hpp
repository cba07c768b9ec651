/// \file
/// Comparison of pictures, for tests of drawings.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <kinegraph/error.hpp>

namespace kinegraph {

/// The visible differences of two pictures.
struct PictureComparison {
    int width = 0;              ///< pixels; the larger of the two pictures
    int height = 0;             ///< pixels
    std::size_t differing = 0;  ///< pixels that differ
    std::size_t forgiven = 0;   ///< pixels that differ only as antialiasing of an edge does
    std::string side_by_side;   ///< PNG: expected, difference (red), actual

    /// Fraction of pixels that differ, from 0 to 1.
    double share() const {
        return static_cast<double>(differing) / (static_cast<double>(width) * static_cast<double>(height));
    }
};

/// Compares two PNG pictures. `tolerance` (0 to 1) is the allowed distance of two colours, relative to the largest
/// possible distance. Fails for data that are not PNG, and for more than 72 million pixels.
/// Source of the method: colour distance in YIQ (Kotsarenko and Ramos 2010), edges by their slope (Vyšniauskas 2009).
Expected<PictureComparison> compare_pictures(std::string_view expected, std::string_view actual,
                                             double tolerance = 0.1);

}  // namespace kinegraph
