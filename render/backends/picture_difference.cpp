// Comparison of pictures: YIQ distance, slopes of brightness, range of a neighbourhood. PNG by libpng's simplified
// interface, which handles malformed files without longjmp in our code.
#include "render/backends/picture_difference.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/number/assert.hpp"
#include "lang/keys/pages.hpp"

namespace kinegraph::render {
namespace {

constexpr std::string_view signature{"\x89PNG\r\n\x1a\n", 8};

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

/// Dots per inch from the chunk pHYs: length, type, dots per metre across and down, unit 1 for the metre. Files state
/// integer dots per metre but sheets have integer dots per inch, so the result is rounded to these.
std::optional<double> resolution(std::string_view bytes) {
    std::size_t at = signature.size();
    while (at + 12 <= bytes.size()) {
        const std::uint32_t length = big_endian(bytes.substr(at));
        const std::string_view type = bytes.substr(at + 4, 4);
        if (type == "IDAT") break;
        if (type == "pHYs" && length == 9 && at + 17 <= bytes.size() && bytes[at + 16] == 1) {
            const double dpi = std::round(big_endian(bytes.substr(at + 8)) * 0.0254);
            return dpi >= 1 ? std::optional(dpi) : std::nullopt;
        }
        at += 12 + std::size_t{length};
    }
    return std::nullopt;
}

/// The brightness, Y of YIQ.
double brightness(Colour c) { return 0.29889531 * c.red + 0.58662247 * c.green + 0.11448223 * c.blue; }

/// The squared distance in YIQ, with perceptual weights of the axes.
constexpr double apart(Colour a, Colour b) {
    const double red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    const double y = 0.29889531 * red + 0.58662247 * green + 0.11448223 * blue;
    const double i = 0.59597799 * red - 0.27417610 * green - 0.32180189 * blue;
    const double q = 0.21147017 * red - 0.52261711 * green + 0.31114694 * blue;
    return 0.5053 * y * y + 0.299 * i * i + 0.1957 * q * q;
}

/// Red and cyan are the most distant colours.
constexpr double farthest_colours = apart({255, 0, 0}, {0, 255, 255});

/// The neighbourhood of a pixel, itself included, clipped to the picture.
struct Surroundings {
    Colour least{255, 255, 255}, most{0, 0, 0};
    Colour blurred;                         ///< mean with binomial weights
    bool darker = false, brighter = false;  ///< whether some neighbour is

    Surroundings(const Picture& picture, int x, int y) {
        const double own = brightness(picture.at(x, y));
        int red = 0, green = 0, blue = 0, weights = 0;
        for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u) {
                const Colour c = picture.at(u, v);
                least = {std::min(least.red, c.red), std::min(least.green, c.green), std::min(least.blue, c.blue)};
                most = {std::max(most.red, c.red), std::max(most.green, c.green), std::max(most.blue, c.blue)};
                darker = darker || brightness(c) < own;
                brighter = brighter || brightness(c) > own;
                const int weight = (u == x ? 2 : 1) * (v == y ? 2 : 1);
                weights += weight;
                red += weight * c.red;
                green += weight * c.green;
                blue += weight * c.blue;
            }
        }
        const auto mean = [weights](int sum) { return static_cast<std::uint8_t>((sum + weights / 2) / weights); };
        blurred = {mean(red), mean(green), mean(blue)};
    }
    bool slope() const { return darker && brighter; }
    double contrast() const { return apart(least, most); }
    /// Whether the colour is within `distance` (squared) of the range.
    bool hold(Colour c, double distance) const {
        const Colour near{std::clamp(c.red, least.red, most.red), std::clamp(c.green, least.green, most.green),
                          std::clamp(c.blue, least.blue, most.blue)};
        return apart(c, near) <= distance;
    }
};

bool by_antialiasing(const Picture& expected, const Picture& actual, int x, int y, double distance) {
    const Surroundings here(expected, x, y), there(actual, x, y);
    const bool edge = (here.slope() || there.slope()) && here.hold(actual.at(x, y), distance) &&
                      there.hold(expected.at(x, y), distance);
    // A quarter of the squared contrast is half of the contrast.
    const bool ink = apart(here.blurred, there.blurred) <= distance && here.contrast() >= there.contrast() / 4 &&
                     there.contrast() >= here.contrast() / 4;
    return edge || ink;
}

bool reaches(const Picture& picture, int x, int y) { return x < picture.width && y < picture.height; }

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(signature); }

tl::expected<Picture, Words> decode_png(std::string_view bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto failed = [&image] {
        const std::string why = image.message;
        png_image_free(&image);
        return tl::unexpected(Words(lang::pages::is_no_png, why));
    };
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return failed();
    if (image.width > 65535 || image.height > 65535 || std::size_t{image.width} * image.height > most_pixels) {
        const std::string size = std::to_string(image.width) + " × " + std::to_string(image.height);
        png_image_free(&image);
        return tl::unexpected(Words(lang::pages::has_pixels_72_million, size));
    }
    static_assert(sizeof(Colour) == 3, "pixels are decoded in place");
    Picture picture;
    picture.width = static_cast<int>(image.width);
    picture.height = static_cast<int>(image.height);
    picture.dpi = resolution(bytes);
    picture.pixels.resize(std::size_t{image.width} * image.height);
    image.format = PNG_FORMAT_RGB;
    const png_color white{255, 255, 255};
    if (png_image_finish_read(&image, &white, picture.pixels.data(), 0, nullptr) == 0) return failed();
    return picture;
}

std::string encode_png(const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    image.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    const bool written =
        png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0, nullptr) != 0;
    KG_ASSERT(written, image.message);
    bytes.resize(size);
    return bytes;
}

PictureDifference compare(const Picture& expected, const Picture& actual, double tolerance) {
    using Verdict = PictureDifference::Verdict;
    const double distance = tolerance * tolerance * farthest_colours;
    PictureDifference difference;
    difference.width = std::max(expected.width, actual.width);
    difference.height = std::max(expected.height, actual.height);
    difference.left = difference.width;
    difference.top = difference.height;
    difference.verdicts.reserve(static_cast<std::size_t>(difference.width) *
                                static_cast<std::size_t>(difference.height));
    const auto verdict = [&](int x, int y) {
        if (!reaches(expected, x, y) || !reaches(actual, x, y)) return Verdict::differs;
        const Colour a = expected.at(x, y), b = actual.at(x, y);
        if (a == b || apart(a, b) <= distance) return Verdict::same;
        return by_antialiasing(expected, actual, x, y, distance) ? Verdict::forgiven : Verdict::differs;
    };
    for (int y = 0; y < difference.height; ++y) {
        for (int x = 0; x < difference.width; ++x) {
            difference.verdicts.push_back(verdict(x, y));
            if (difference.verdicts.back() == Verdict::forgiven) ++difference.forgiven;
            if (difference.verdicts.back() != Verdict::differs) continue;
            ++difference.differing;
            difference.left = std::min(difference.left, x);
            difference.top = std::min(difference.top, y);
            difference.right = std::max(difference.right, x);
            difference.bottom = std::max(difference.bottom, y);
        }
    }
    return difference;
}

Picture side_by_side(const Picture& expected, const Picture& actual, const PictureDifference& difference) {
    constexpr int gap = 8;
    constexpr Colour nothing{0xD0, 0xD0, 0xD4}, red{0xD0, 0x00, 0x20}, amber{0xF5, 0xB8, 0x2E};
    const auto colour_of = [&](const Picture& picture, int x, int y) {
        return reaches(picture, x, y) ? picture.at(x, y) : nothing;
    };
    const auto marked = [&](int x, int y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(difference.width);
        switch (difference.verdicts[row + static_cast<std::size_t>(x)]) {
            case PictureDifference::Verdict::differs: return red;
            case PictureDifference::Verdict::forgiven: return amber;
            case PictureDifference::Verdict::same: break;
        }
        const auto pale = static_cast<std::uint8_t>(std::lround(204 + 0.2 * brightness(expected.at(x, y))));
        return Colour{pale, pale, pale};
    };
    Picture picture;
    picture.width = 3 * difference.width + 2 * gap;
    picture.height = difference.height;
    picture.pixels.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < difference.height; ++y) {
        for (int x = 0; x < difference.width; ++x) picture.pixels.push_back(colour_of(expected, x, y));
        picture.pixels.insert(picture.pixels.end(), gap, nothing);
        for (int x = 0; x < difference.width; ++x) picture.pixels.push_back(marked(x, y));
        picture.pixels.insert(picture.pixels.end(), gap, nothing);
        for (int x = 0; x < difference.width; ++x) picture.pixels.push_back(colour_of(actual, x, y));
    }
    return picture;
}

}  // namespace kinegraph::render
