// The backends: what a page promises is in the bytes, and the same bytes come twice.
#include "render/backends/backends.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <pugixml.hpp>
#include <set>

#include "tests/support/fonts.hpp"

namespace backends_test {
namespace {

using namespace kinegraph::render;
using kinegraph::tests::fonts;

TextMark label(const std::string& words, Spot at, double angle = 0) {
    Piece piece;
    piece.text = words;
    const ShapedLine line = fonts().shape({piece}, 12);
    TextMark mark;
    mark.words = words;
    mark.cls = "label";
    mark.colour = {11, 68, 132};
    mark.angle = angle;
    mark.pivot = at;
    for (Glyph glyph : line.parts.at(0).glyphs) {
        glyph.origin.x += at.x;
        glyph.origin.y += at.y;
        mark.glyphs.push_back(glyph);
    }
    mark.extras = line.parts.at(0).extras;
    return mark;
}

Path stroke(std::vector<Segment> segments) {
    Path path;
    path.segments = std::move(segments);
    path.stroked = true;
    return path;
}

Path fill(std::vector<Segment> segments, Colour colour) {
    Path path;
    path.segments = std::move(segments);
    path.filled = true;
    path.fill = colour;
    return path;
}

Page sample() {
    Page page;
    page.width = 100;
    page.height = 50;
    page.title = "Crank <1> & \"slider\"";
    GroupBegin figure;
    figure.cls = "figure";
    figure.id = GroupId("velocity");
    figure.title = "a < b & c";
    figure.attributes = {{"data-name", "<&\">"}, {"data-scale", "0.02"}};
    page.marks.emplace_back(figure);
    GroupBegin vector;
    vector.cls = "vector";
    vector.id = GroupId("velocity", "v_B");
    page.marks.emplace_back(vector);
    page.marks.emplace_back(Axis{{10, 20}, {30.12345678, 20.5}});
    page.marks.emplace_back(fill({MoveTo{{30, 20}}, LineTo{{26, 21}}, LineTo{{26, 19}}, Close{}}, {200, 64, 15}));
    page.marks.emplace_back(GroupEnd{});
    Path dashed = stroke({MoveTo{{10, 30}}, LineTo{{90, 30}}});
    dashed.pen.dashes = {5, 0.9, 0.6, 0.9};
    dashed.pen.round_ends = true;
    page.marks.emplace_back(dashed);
    page.marks.emplace_back(stroke({ArcTo{{50, 20}, 5, 0, 2 * std::numbers::pi}, Close{}}));
    page.marks.emplace_back(GroupEnd{});
    page.marks.emplace_back(label("v<&\"_B", {60, 20}));
    page.marks.emplace_back(label("vv", {60, 40}, std::numbers::pi / 2));
    return page;
}

struct Svg {
    explicit Svg(const Page& page) : text(to_svg(page, fonts())) { well_formed = document.load_string(text.c_str()); }
    pugi::xml_node find(const char* path) const { return document.select_node(path).node(); }
    std::string text;
    pugi::xml_document document;
    bool well_formed = false;
};

std::string path_data(const Path& path) {
    Page page;
    page.marks.emplace_back(path);
    return Svg(page).find("/svg/path").attribute("d").value();
}

TEST(Svg, IsWellFormedAndMeasuredInMillimetres) {
    const Svg svg(sample());
    ASSERT_TRUE(svg.well_formed);
    const auto root = svg.find("/svg");
    EXPECT_STREQ(root.attribute("width").value(), "100mm");
    EXPECT_STREQ(root.attribute("height").value(), "50mm");
    EXPECT_STREQ(root.attribute("viewBox").value(), "0 0 100 50");
    EXPECT_STREQ(root.attribute("lang").value(), "en");
    EXPECT_STREQ(root.child("title").child_value(), "Crank <1> & \"slider\"");
    EXPECT_STREQ(root.child("rect").attribute("fill").value(), "#ffffff");
}

TEST(Svg, GroupsCarryIdsTitlesAndData) {
    const Svg svg(sample());
    const auto figure = svg.find("//g[@id='velocity']");
    EXPECT_STREQ(figure.attribute("class").value(), "figure");
    EXPECT_STREQ(figure.attribute("data-name").value(), "<&\">");
    EXPECT_STREQ(figure.attribute("data-scale").value(), "0.02");
    EXPECT_STREQ(figure.child("title").child_value(), "a < b & c");
    EXPECT_TRUE(figure.select_node("g[@id='velocity-v_B' and @class='vector']"));
}

TEST(Svg, AxisIsAnInvisibleLine) {
    const Svg svg(sample());
    const auto axis = svg.find("//g[@id='velocity-v_B']/line[@class='axis']");
    EXPECT_STREQ(axis.attribute("x1").value(), "10");
    EXPECT_STREQ(axis.attribute("x2").value(), "30.12345678");
    EXPECT_STREQ(axis.attribute("y2").value(), "20.5");
    EXPECT_STREQ(axis.attribute("stroke").value(), "none");
}

TEST(Svg, LabelsKeepTheirWords) {
    const Svg svg(sample());
    const auto words = svg.find("//g[@class='label']");
    EXPECT_STREQ(words.attribute("aria-label").value(), "v<&\"_B");
    EXPECT_STREQ(words.attribute("fill").value(), "#0b4484");
    EXPECT_FALSE(words.attribute("transform"));
    EXPECT_STREQ(svg.find("//g[@aria-label='vv']").attribute("transform").value(), "rotate(90 60 40)");
}

TEST(Svg, EachOutlineStandsOnceUnderItsOwnId) {
    const Svg svg(sample());
    std::set<std::string> ids;
    for (const auto& outline : svg.document.select_nodes("/svg/defs/path")) {
        EXPECT_TRUE(ids.insert(outline.node().attribute("id").value()).second);
    }
    EXPECT_EQ(ids.size(), 6U);  // v < & " _ B
    const auto uses = svg.document.select_nodes("//use");
    EXPECT_EQ(uses.size(), 8U);
    for (const auto& use : uses) EXPECT_TRUE(ids.contains(use.node().attribute("xlink:href").value() + 1));
}

TEST(Svg, StripsWhatXmlForbids) {
    Page page;
    page.title = "a\x01\xff z";
    const Svg svg(page);
    ASSERT_TRUE(svg.well_formed);
    EXPECT_STREQ(svg.find("/svg/title").child_value(), "a\uFFFD\uFFFD z");
}

TEST(Svg, PensAreAttributes) {
    const Svg svg(sample());
    const auto dashed = svg.find("//path[@stroke-dasharray]");
    EXPECT_STREQ(dashed.attribute("stroke-dasharray").value(), "5 0.9 0.6 0.9");
    EXPECT_STREQ(dashed.attribute("stroke-width").value(), "0.18");
    EXPECT_STREQ(dashed.attribute("stroke-linecap").value(), "round");
    EXPECT_STREQ(dashed.attribute("fill").value(), "none");
}

TEST(Svg, ArcsAreArcs) {
    constexpr double pi = std::numbers::pi;
    EXPECT_EQ(path_data(stroke({ArcTo{{50, 20}, 5, 0, 2 * pi}, Close{}})), "M55 20A5 5 0 0 1 45 20A5 5 0 0 1 55 20Z");
    EXPECT_EQ(path_data(stroke({ArcTo{{0, 0}, 1, 0, pi / 2}})), "M1 0A1 1 0 0 1 0 1");
    EXPECT_EQ(path_data(stroke({ArcTo{{0, 0}, 1, 0, -pi / 2}})), "M1 0A1 1 0 0 0 0 -1");
    EXPECT_EQ(path_data(stroke({MoveTo{{1, 0}}, ArcTo{{0, 0}, 1, 0, pi / 2}, LineTo{{0, 0}}})),
              "M1 0A1 1 0 0 1 0 1L0 0");
    EXPECT_EQ(path_data(stroke({MoveTo{{3, 0}}, ArcTo{{0, 0}, 1, 0, pi / 2}})), "M3 0L1 0A1 1 0 0 1 0 1");
}

TEST(Svg, NumbersAreShortAndSnapped) {
    EXPECT_EQ(path_data(stroke({MoveTo{{0.1 + 0.2, -0.0}}, LineTo{{1.0 / 3, -1e-9}}, LineTo{{1e3, 0.00000001}}})),
              "M0.3 0L0.33333333 0L1000 0.00000001");
}

TEST(Backends, GiveTheSameBytesTwice) {
    const Page page = sample();
    const Fonts other = std::move(*Fonts::open());
    EXPECT_EQ(to_svg(page, fonts()), to_svg(page, other));
    EXPECT_EQ(to_png(page, fonts(), 96), to_png(page, other, 96));
    EXPECT_EQ(to_pdf({page, page}, fonts()), to_pdf({page, page}, other));
}

struct Picture {
    png_image header{};
    std::vector<png_byte> pixels;
    explicit Picture(const std::string& bytes) {
        header.version = PNG_IMAGE_VERSION;
        if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) return;
        is_coloured = (header.format & PNG_FORMAT_FLAG_COLOR) != 0;
        header.format = PNG_FORMAT_RGB;
        pixels.resize(PNG_IMAGE_SIZE(header));
        png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr);
    }
    std::array<int, 3> at(unsigned x, unsigned y) const {
        const png_byte* p = pixels.data() + 3 * (static_cast<std::size_t>(y) * header.width + x);
        return {p[0], p[1], p[2]};
    }
    bool is_coloured = false;
};

TEST(Png, HasTheSizeAndTheResolution) {
    const std::string bytes = to_png(sample(), fonts(), 150);
    ASSERT_GT(bytes.size(), 60U);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const Picture picture(bytes);
    EXPECT_EQ(picture.header.width, 591U);   // 100 mm
    EXPECT_EQ(picture.header.height, 296U);  // 50 mm
    EXPECT_TRUE(picture.is_coloured);
    const auto resolution = bytes.find("pHYs");
    ASSERT_NE(resolution, std::string::npos);
    EXPECT_EQ(bytes.substr(resolution + 4, 9),
              (std::string("\x00\x00\x17\x12\x00\x00\x17\x12\x01", 9)));  // 5906 a metre
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(Png, ShowsTheColoursWhereTheyAre) {
    Page page;
    page.width = page.height = 25.4;
    page.marks.emplace_back(
        fill({MoveTo{{10, 5}}, LineTo{{20, 5}}, LineTo{{20, 20}}, LineTo{{10, 20}}, Close{}}, {200, 64, 15}));
    const Picture picture(to_png(page, fonts(), 100));
    ASSERT_EQ(picture.header.width, 100U);
    EXPECT_EQ(picture.at(60, 50), (std::array{200, 64, 15}));
    EXPECT_EQ(picture.at(20, 50), (std::array{255, 255, 255}));
}

TEST(Png, IsGreyWhereThePageHasNoColour) {
    Page page;
    page.width = page.height = 25.4;
    page.marks.emplace_back(
        fill({MoveTo{{10, 5}}, LineTo{{20, 5}}, LineTo{{20, 20}}, LineTo{{10, 20}}, Close{}}, {90, 90, 90}));
    const Picture picture(to_png(page, fonts(), 100));
    EXPECT_FALSE(picture.is_coloured);
    EXPECT_EQ(picture.at(60, 50), (std::array{90, 90, 90}));
    page.marks.emplace_back(label("v", {2, 10}));
    EXPECT_TRUE(Picture(to_png(page, fonts(), 100)).is_coloured);
}

TEST(Png, FillsTypeAndTurnsIt) {
    Page page;
    page.width = page.height = 25.4;
    const auto inked = [&](const TextMark& mark) {
        page.marks = {mark};
        const Picture picture(to_png(page, fonts(), 100));
        std::array<unsigned, 4> box{100, 100, 0, 0};  // of pixels darker than half
        for (unsigned y = 0; y < 100; ++y) {
            for (unsigned x = 0; x < 100; ++x) {
                if (picture.at(x, y)[0] > 130) continue;
                box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
            }
        }
        return box;
    };
    const auto level = inked(label("HHHH", {12.7, 12.7}));
    EXPECT_GE(level[0], 49U);
    EXPECT_LE(level[3], 50U);
    EXPECT_GT(level[2] - level[0], 2 * (level[3] - level[1]));
    const auto turned = inked(label("HHHH", {12.7, 12.7}, std::numbers::pi / 2));  // clockwise: reads downwards
    EXPECT_GE(turned[1], 49U);
    EXPECT_GT(turned[3] - turned[1], 2 * (turned[2] - turned[0]));
}

TEST(Pdf, HasAFixedDateAndAllPages) {
    Page second = sample();
    second.width = 210;
    const std::string bytes = to_pdf({sample(), second}, fonts());
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_NE(bytes.find("20000101000000"), std::string::npos);
    EXPECT_NE(bytes.find("/Count 2"), std::string::npos);
}

TEST(Pdf, SurvivesATitleThatIsNoUtf8) {
    Page page;
    // cairo takes Unicode's noncharacters for no UTF-8 either.
    for (const char* title : {"a\xff", "x\ufdd0y", "x\ufdefy", "\uffff", "\U0001ffffy", "\U0010fffe"}) {
        page.title = title;
        EXPECT_FALSE(to_pdf({page}, fonts()).empty()) << title;
    }
}

}  // namespace
}  // namespace backends_test
