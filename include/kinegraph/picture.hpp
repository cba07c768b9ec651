/// \file
/// Comparison of pictures, for tests of drawings.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <kinegraph/error.hpp>
#include <kinegraph/solution.hpp>

namespace kinegraph {

/// A PNG picture. An immutable value; several threads may use the same one.
class PngPicture {
public:
    /// Whether the bytes begin like a PNG.
    static bool is_png(std::string_view bytes);
    /// Decodes a PNG; transparent pixels become those on white paper. Fails for other data, and for more than 72
    /// million pixels.
    static Expected<PngPicture> decode(std::string_view bytes);

    int width() const;                  ///< pixels
    int height() const;                 ///< pixels
    std::optional<double> dpi() const;  ///< dots per inch, if the file states them

    /// \cond private
    struct State;
    const State& state() const { return *state_; }
    /// \endcond

private:
    explicit PngPicture(Shared<const State> state) : state_(std::move(state)) {}
    Shared<const State> state_;
};

/// The visible differences of two pictures.
struct PictureComparison {
    int width = 0;              ///< pixels; the larger of the two pictures
    int height = 0;             ///< pixels
    std::size_t differing = 0;  ///< pixels that differ
    std::size_t forgiven = 0;   ///< pixels that differ only as antialiasing of an edge does
    int left = 0;               ///< first column with a difference, if there is one
    int right = 0;              ///< last column with a difference
    int top = 0;                ///< first row with a difference
    int bottom = 0;             ///< last row with a difference
    std::string side_by_side;   ///< PNG: expected, difference (red), actual; empty if not requested

    /// Fraction of pixels that differ, from 0 to 1.
    double share() const {
        return static_cast<double>(differing) / (static_cast<double>(width) * static_cast<double>(height));
    }
};

/// Compares two pictures. `tolerance` (0 to 1) is the allowed distance of two colours, relative to the largest possible
/// distance. `draws`: whether side_by_side is wanted.
/// Source of the method: colour distance in YIQ (Kotsarenko and Ramos 2010), edges by their slope (Vyšniauskas 2009).
PictureComparison compare_pictures(const PngPicture& expected, const PngPicture& actual, double tolerance = 0.1,
                                   bool draws = true);

}  // namespace kinegraph
