// Pictures compared as the eye does, and PNG files of all kinds, hostile ones included.
#include "render/backends/picture_difference.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>

#include "render/backends/backends.hpp"

namespace picture_difference_test {
namespace {

using kinegraph::Language;

using namespace kinegraph::render;
using Verdict = PictureDifference::Verdict;

constexpr Colour white{255, 255, 255}, black{0, 0, 0};

Picture blank(int width, int height, Colour colour = white) {
    return {width, height, std::vector<Colour>(static_cast<std::size_t>(width * height), colour), std::nullopt};
}
Colour& pixel(Picture& picture, int x, int y) {
    return picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
}

/// An inch of paper with what is drawn on it, 100 pixels wide.
Picture drawn(std::vector<Mark> marks) {
    static const Fonts fonts = Fonts::open().value();
    Page page;
    page.width = page.height = 25.4;
    page.marks = std::move(marks);
    return decode_png(to_png(page, fonts, 100)).value();
}
Path stroke(Spot from, Spot to, Colour colour = black) {
    Path path;
    path.segments = {MoveTo{from}, LineTo{to}};
    path.stroked = true;
    path.pen = {0.25, colour, {}, false};
    return path;
}
constexpr double dot = 0.254;  // mm a pixel

TEST(PictureDifference, APictureIsItself) {
    const Picture picture = drawn({stroke({3, 2}, {20, 17})});
    const PictureDifference difference = compare(picture, picture, 0);
    EXPECT_EQ(difference.differing, 0U);
    EXPECT_EQ(difference.forgiven, 0U);
    EXPECT_EQ(difference.share(), 0);
}

TEST(PictureDifference, SaysWhichPixelsDiffer) {
    const Picture expected = blank(20, 10);
    Picture actual = expected;
    pixel(actual, 4, 7) = pixel(actual, 9, 2) = black;
    for (const bool swapped : {false, true}) {
        const PictureDifference difference = swapped ? compare(actual, expected, 0.1) : compare(expected, actual, 0.1);
        EXPECT_EQ(difference.differing, 2U);
        EXPECT_DOUBLE_EQ(difference.share(), 0.01);
        EXPECT_EQ((std::array{difference.left, difference.top, difference.right, difference.bottom}),
                  (std::array{4, 2, 9, 7}));
        EXPECT_EQ(difference.verdicts[7 * 20 + 4], Verdict::differs);
        EXPECT_EQ(difference.verdicts[7 * 20 + 5], Verdict::same);
    }
}

TEST(PictureDifference, ToleranceIsAShareOfTheFarthestColours) {
    const auto differ = [](Colour a, Colour b, double tolerance) {
        return compare(blank(3, 3, a), blank(3, 3, b), tolerance).differing == 9;
    };
    EXPECT_TRUE(differ({255, 0, 0}, {0, 255, 255}, 0.999));
    EXPECT_FALSE(differ({255, 0, 0}, {0, 255, 255}, 1));
    EXPECT_TRUE(differ(black, white, 0.96));
    EXPECT_FALSE(differ(black, white, 0.97));
    EXPECT_TRUE(differ({100, 100, 100}, {101, 100, 100}, 0));
    EXPECT_FALSE(differ({100, 100, 100}, {112, 112, 112}, 0.1));
    EXPECT_TRUE(differ({100, 100, 100}, {140, 140, 140}, 0.1));
    // The eye sees lightness before hue: equal steps in blue count for less.
    EXPECT_FALSE(differ({100, 100, 100}, {100, 100, 140}, 0.1));
    EXPECT_TRUE(differ({200, 64, 15}, {11, 68, 132}, 0.1)) << "two bodies' colours";
}

TEST(PictureDifference, ALineMovedByPartOfAPixelIsForgiven) {
    for (const Spot to : {Spot{22, 17}, Spot{20, 23}, Spot{23, 4}}) {
        const Picture expected = drawn({stroke({3, 2}, to)});
        constexpr double part = dot / 4;
        const Picture actual = drawn({stroke({3 + part, 2 - part}, {to.x + part, to.y - part})});
        ASSERT_FALSE(expected.pixels == actual.pixels);
        const PictureDifference difference = compare(expected, actual, 0.1);
        EXPECT_LE(difference.differing, 2U) << "its two ends are cut square";
        EXPECT_GT(difference.forgiven, 10U);
    }
}

TEST(PictureDifference, ALineThatIsGoneIsNot) {
    for (const Spot to : {Spot{22, 17}, Spot{20, 23}, Spot{23, 2}, Spot{3, 22}}) {
        const Picture with = drawn({stroke({3, 2}, to)});
        // A pixel's width of 17 mm and more: every pixel of its length at least.
        EXPECT_GE(compare(with, drawn({}), 0.1).differing, 67U);
        EXPECT_GE(compare(drawn({}), with, 0.1).differing, 67U);
    }
}

TEST(PictureDifference, NotEvenAFaintOne) {
    const Picture expected = blank(30, 30);
    Picture actual = expected;
    for (int x = 3; x < 27; ++x) pixel(actual, x, 12) = {0xD8, 0xD8, 0xD8};
    EXPECT_EQ(compare(expected, actual, 0.1).differing, 24U);
    EXPECT_EQ(compare(actual, expected, 0.1).differing, 24U);
}

TEST(PictureDifference, NeitherIsALineOfAnotherColourOrElsewhere) {
    const Picture expected = drawn({stroke({3, 2}, {22, 17})});
    EXPECT_GE(compare(expected, drawn({stroke({3, 2}, {22, 17}, {200, 64, 15})}), 0.1).differing, 67U);
    EXPECT_GE(compare(expected, drawn({stroke({3, 2 + 3 * dot}, {22, 17 + 3 * dot})}), 0.1).differing, 67U);
    Path dashed = stroke({3, 2}, {22, 17});
    dashed.pen.dashes = {2, 1};
    EXPECT_GE(compare(expected, drawn({dashed}), 0.1).differing, 20U);
}

TEST(PictureDifference, AHardEdgeMovedByAPixelDiffers) {
    Picture expected = blank(12, 12), actual = blank(12, 12);
    for (int x = 0; x < 12; ++x) pixel(expected, x, 5) = pixel(actual, x, 6) = black;
    EXPECT_EQ(compare(expected, actual, 0.1).differing, 24U);
}

TEST(PictureDifference, OtherSizesDifferWhereOnlyOneReaches) {
    const PictureDifference difference = compare(blank(10, 6), blank(8, 9), 0.1);
    EXPECT_EQ(difference.width, 10);
    EXPECT_EQ(difference.height, 9);
    EXPECT_EQ(difference.differing, 90U - 8 * 6);
    const Picture shown = side_by_side(blank(10, 6), blank(8, 9), difference);
    EXPECT_EQ(shown.width, 3 * 10 + 2 * 8);
    EXPECT_EQ(shown.height, 9);
}

TEST(PictureDifference, IsShownBetweenTheTwo) {
    const Picture expected = blank(5, 5);
    Picture actual = expected;
    pixel(actual, 1, 3) = black;
    const Picture shown = side_by_side(expected, actual, compare(expected, actual, 0.1));
    EXPECT_EQ(shown.at(1, 3), white);
    EXPECT_EQ(shown.at(2 * 13 + 1, 3), black);
    EXPECT_EQ(shown.at(13 + 1, 3), (Colour{0xD0, 0x00, 0x20}));
    EXPECT_EQ(shown.at(13 + 2, 3), white);
}

TEST(Picture, PngGoesOutAndIn) {
    Picture picture = blank(7, 5, {200, 64, 15});
    pixel(picture, 6, 4) = {1, 2, 3};
    const auto again = decode_png(encode_png(picture));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->width, 7);
    EXPECT_EQ(again->height, 5);
    EXPECT_EQ(again->pixels, picture.pixels);
    EXPECT_FALSE(again->dpi);
}

TEST(Picture, KnowsItsResolution) {
    static const Fonts fonts = Fonts::open().value();
    Page small;
    small.width = small.height = 10;
    for (const double dpi : {96.0, 150.0, 300.0, 601.0})
        EXPECT_EQ(decode_png(to_png(small, fonts, dpi)).value().dpi, dpi);
}

TEST(Picture, WhatIsTransparentLiesOnWhite) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 1;
    image.format = PNG_FORMAT_RGBA;
    std::string bytes(1000, '\0');
    png_alloc_size_t size = bytes.size();
    const std::array<png_byte, 4> clear{0, 0, 0, 0};
    ASSERT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, clear.data(), 0, nullptr), 0);
    EXPECT_EQ(decode_png(bytes.substr(0, size)).value().at(0, 0), white);
}

/// A PNG's beginning that promises a size, with its sum of check right.
std::string promising(std::uint32_t width, std::uint32_t height) {
    const auto number = [](std::uint32_t n) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(n >> shift & 255);
        return bytes;
    };
    const std::string header = "IHDR" + number(width) + number(height) + std::string("\x08\x02\x00\x00\x00", 5);
    std::uint32_t sum = 0xFFFFFFFF;
    for (const char c : header) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? sum >> 1 ^ 0xEDB88320 : sum >> 1;
    }
    return "\x89PNG\r\n\x1a\n" + number(13) + header + number(~sum) + number(0) + "IDAT";
}

TEST(Picture, HostileFilesAreRefused) {
    EXPECT_FALSE(decode_png(""));
    EXPECT_FALSE(decode_png("GIF89a"));
    const auto wide = decode_png(promising(1'000'000'000, 1'000'000'000));
    ASSERT_FALSE(wide);
    const auto large = decode_png(promising(60'000, 60'000));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().in(Language::en).find("60000 × 60000"), std::string::npos)
        << large.error().in(Language::en);
    EXPECT_FALSE(decode_png(promising(5000, 5000)));
    EXPECT_FALSE(decode_png(promising(0, 0)));
}

TEST(Picture, CutOrSpoiltFilesAreRefusedOrRead) {
    const std::string bytes = encode_png(drawn({stroke({3, 2}, {20, 17})}));
    for (std::size_t end = 0; end + 12 < bytes.size(); end += 7) EXPECT_FALSE(decode_png(bytes.substr(0, end))) << end;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::string spoilt = bytes;
        spoilt[at] = static_cast<char>(spoilt[at] ^ 0x55);
        const auto picture = decode_png(spoilt);
        if (!picture) continue;
        EXPECT_EQ(picture->pixels.size(),
                  static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height));
    }
}

}  // namespace
}  // namespace picture_difference_test
