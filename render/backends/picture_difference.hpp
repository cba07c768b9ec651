// Comparison of pictures as the eye sees them: differences of antialiasing are ignored, a missing line is not. Owns PNG
// decoding and encoding and the comparison; independent of sheets, files and the command line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"
#include "render/page/page.hpp"

namespace kinegraph::render {

/// Opaque pixels, row by row from the top left.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> pixels;
    std::optional<double> dpi;  ///< dots per inch, if the file states it

    Colour at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// Limit for decoding: 72 million pixels (A3 at 600 dpi).
constexpr std::size_t most_pixels = 72'000'000;

bool is_png(std::string_view bytes);
/// Decodes any PNG to 8-bit RGB; transparent pixels are blended with white. Error: why it cannot be decoded.
tl::expected<Picture, Words> decode_png(std::string_view bytes);
std::string encode_png(const Picture& picture);

struct PictureDifference {
    /// Result for one pixel.
    enum class Verdict : unsigned char {
        same,
        forgiven,  ///< different, but only as antialiasing changes an edge
        differs,
    };
    int width = 0;  ///< the larger of both widths
    int height = 0;
    std::vector<Verdict> verdicts;
    std::size_t differing = 0;
    std::size_t forgiven = 0;
    /// The bounding columns and rows of the differences; meaningful only if there are any.
    int left = 0, top = 0, right = 0, bottom = 0;

    double share() const { return static_cast<double>(differing) / static_cast<double>(verdicts.size()); }
};

/// Compares pixel by pixel. `tolerance` (0 to 1) is the accepted distance of two colours in YIQ, where the two most
/// distant colours are 1 apart (Kotsarenko & Ramos, "Measuring perceived color difference using YIQ NTSC transmission
/// color space in mobile applications", 2010). A pixel beyond the tolerance is forgiven in two cases.
/// Edge: in at least one picture it lies on a slope of brightness, darker on one side and brighter on another
/// (Vyšniauskas, "Anti-aliased pixel and intensity slope detector", 2009), and each picture has its colour within the
/// range of the other's 3 × 3 neighbourhood.
/// Shifted ink, such as a thin line between two rows: blurred over 3 × 3 pixels, the two agree within the tolerance,
/// and neither picture is flat there while the other is not.
/// Pixels outside one of the pictures differ, if the sizes are different.
PictureDifference compare(const Picture& expected, const Picture& actual, double tolerance);

/// Expected, difference and actual side by side. The middle shows the expected picture in pale grey, differences in
/// red, forgiven pixels in amber.
Picture side_by_side(const Picture& expected, const Picture& actual, const PictureDifference& difference);

}  // namespace kinegraph::render
