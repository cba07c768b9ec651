// Pictures as pixels, and how two of them differ to the eye: what only antialiasing moves is forgiven, a line that is
// gone is not. Owns PNG in and out and the comparison; knows nothing of sheets, files or the command line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"
#include "render/page/page.hpp"

namespace kinegraph::render {

/// Opaque pixels, row by row from the top left.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> pixels;
    std::optional<double> dpi;  ///< dots per inch, where the file says it

    Colour at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// The most that is decoded: 72 million pixels (A3 at 600 dpi).
constexpr std::size_t most_pixels = 72'000'000;

bool is_png(std::string_view bytes);
/// Any PNG as eight bits of red, green and blue; what is transparent lies on white. Error: why it is no picture.
tl::expected<Picture, Words> decode_png(std::string_view bytes);
std::string encode_png(const Picture& picture);

struct PictureDifference {
    /// What a pixel turned out to be.
    enum class Verdict : unsigned char {
        same,
        forgiven,  ///< different, as antialiasing makes an edge different
        differs,
    };
    int width = 0;  ///< of both pictures together
    int height = 0;
    std::vector<Verdict> verdicts;
    std::size_t differing = 0;
    std::size_t forgiven = 0;
    /// The first and last column and row that differ; only where something does.
    int left = 0, top = 0, right = 0, bottom = 0;

    double share() const { return static_cast<double>(differing) / static_cast<double>(verdicts.size()); }
};

/// Compares pixel by pixel. `tolerance` (0 to 1) is how far two colours may be apart, the farthest two colours being 1
/// apart, by the distance in YIQ (Kotsarenko & Ramos, "Measuring perceived color difference using YIQ NTSC transmission
/// color space in mobile applications", 2010). A pixel farther off is forgiven where it is
///  - an edge: on a slope of brightness, darker on one side and brighter on another (Vyšniauskas, "Anti-aliased pixel
///  and intensity
///    slope detector", 2009), in one picture at least, each picture having its colour within the range of the other's 3
///    × 3 pixels around; or
///  - the same ink in other pixels, as of a thin line between two rows: blurred over 3 × 3 pixels the two agree within
///  the
///    tolerance, and neither is flat there beside the other.
/// Where only one of them reaches, pictures of different size differ.
PictureDifference compare(const Picture& expected, const Picture& actual, double tolerance);

/// Expected, difference and actual side by side: in the middle the expected picture in pale grey, what differs red,
/// what is forgiven amber.
Picture side_by_side(const Picture& expected, const Picture& actual, const PictureDifference& difference);

}  // namespace kinegraph::render
