// Type: what a line measures, what it falls back to, where scripts and dots stand. Lengths in mm.
#include "render/text/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "render/page/shapes.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/html.hpp"
#include "render/text/utf8.hpp"
#include "tests/support/fonts.hpp"

namespace text_test {
namespace {

using kinegraph::Language;

using namespace kinegraph::render;
using kinegraph::tests::fonts;

Piece piece(const std::string& text, Face face = Face::regular, const std::string& sub = "",
            const std::string& sup = "") {
    Piece made;
    made.text = text;
    made.face = face;
    made.sub = sub;
    made.sup = sup;
    return made;
}

constexpr double size = 72 / 25.4;  // points: 1 em is 1 mm

ShapedLine set(const std::string& text, Face face = Face::regular) { return fonts().shape({piece(text, face)}, size); }

std::size_t glyphs(const ShapedLine& line) {
    std::size_t count = 0;
    for (const auto& part : line.parts) count += part.glyphs.size();
    return count;
}

std::vector<Glyph> glyphs_of_size(const ShapedLine& line, double em) {
    std::vector<Glyph> found;
    for (const auto& part : line.parts) {
        for (const Glyph& glyph : part.glyphs) {
            if (std::abs(glyph.size - em) < 1e-9) found.push_back(glyph);
        }
    }
    return found;
}

TEST(Type, HasTheWidthsOfTheFont) {
    EXPECT_NEAR(set("0").width, 0.5, 1e-12);
    EXPECT_NEAR(set(" ").width, 0.25, 1e-12);
    EXPECT_NEAR(set("a b").width, set("a").width + 0.25 + set("b").width, 1e-12);
    EXPECT_NEAR(fonts().shape({piece("0")}, 2 * size).width, 1, 1e-12);
}

TEST(Type, IsKernedAndHasLigatures) {
    EXPECT_LT(set("AV").width, set("A").width + set("V").width);
    EXPECT_EQ(glyphs(set("fi")), 1U);
}

TEST(Type, MeasuresItsInk) {
    const ShapedLine line = set("Ag");
    EXPECT_NEAR(line.ascent, 0.674, 0.01);
    EXPECT_NEAR(line.descent, 0.218, 0.01);
    EXPECT_EQ(set(" ").ascent, 0);
    EXPECT_EQ(glyphs(set(" ")), 0U);
}

TEST(Type, IsTheSameTwiceAndFromAnotherOpening) {
    const Fonts other = std::move(*Fonts::open());
    const RichText text = {piece("velocity of ", Face::italic), piece("a", Face::bold_italic, "BA", "t"),
                           piece(" ≙ 中")};
    const ShapedLine first = fonts().shape(text, 9);
    ASSERT_FALSE(first.parts[0].glyphs.empty());
    for (const ShapedLine& again : {fonts().shape(text, 9), other.shape(text, 9)}) {
        EXPECT_EQ(first.width, again.width);
        ASSERT_EQ(glyphs(first), glyphs(again));
        for (std::size_t i = 0; i < first.parts[0].glyphs.size(); ++i) {
            EXPECT_EQ(first.parts[0].glyphs[i].index, again.parts[0].glyphs[i].index);
            EXPECT_EQ(first.parts[0].glyphs[i].origin.x, again.parts[0].glyphs[i].origin.x);
        }
    }
}

TEST(Type, OutlinesAreClosedAndUpright) {
    const Glyph one = set("1").parts[0].glyphs[0];
    const Outline& outline = fonts().outline(one.face, one.index);
    ASSERT_FALSE(outline.segments.empty());
    EXPECT_TRUE(std::holds_alternative<MoveTo>(outline.segments.front()));
    EXPECT_TRUE(std::holds_alternative<Close>(outline.segments.back()));
    double top = 0;
    for (const Segment& segment : outline.segments) {
        if (const auto* line = std::get_if<LineTo>(&segment)) top = std::max(top, line->to.y);
    }
    EXPECT_GT(top, 0.6);
    EXPECT_EQ(&outline, &fonts().outline(one.face, one.index));
}

TEST(Type, FallsBackSignBySign) {
    const Fonts own = std::move(*Fonts::open());
    for (const Face face : {Face::regular, Face::italic, Face::bold, Face::bold_italic}) {
        for (const std::string sign :
             {"✓", "⟂", "⊥", "∥", "≙", "∞", "≡", "∧", "−", "×", "·", "α", "ω", "°", "′", "²", "→", "è"}) {
            EXPECT_EQ(glyphs(own.shape({piece(sign, face)}, size)), 1U) << sign;
        }
    }
    EXPECT_TRUE(own.missing().empty());
    const ShapedLine mixed = own.shape({piece("a✓b", Face::italic)}, size);
    ASSERT_EQ(glyphs(mixed), 3U);
    EXPECT_EQ(mixed.parts[0].glyphs[0].face, static_cast<int>(Face::italic));
    EXPECT_EQ(mixed.parts[0].glyphs[1].face, static_cast<int>(Face::regular));
    EXPECT_EQ(mixed.parts[0].glyphs[2].face, static_cast<int>(Face::italic));
}

TEST(Type, BoxesTheCodeOfAMissingCharacterAndReportsIt) {
    const Fonts own = std::move(*Fonts::open());
    const ShapedLine line = own.shape({piece("a中b😀中")}, size);
    EXPECT_EQ(own.missing(), (std::vector<std::string>{"U+4E2D", "U+1F600"}));
    EXPECT_EQ(line.parts[0].extras.size(), 3U);
    EXPECT_EQ(glyphs(line), 2U + 6 + 7 + 6);
    EXPECT_TRUE(line.parts[0].extras[0].stroked);
    EXPECT_GT(line.width, 3);
}

TEST(Type, SurvivesAnyBytes) {
    for (const std::string bytes :
         {"\xff", "\xc3", "a\xe2\x88", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xc0\xaf", "\xf0\x9f\x98"}) {
        const ShapedLine line = set(bytes, Face::italic);
        EXPECT_GT(line.width, 0);
        EXPECT_LE(fonts().wrap({piece(bytes + " " + bytes)}, size, 1e-3).size(), 2U);
    }
    EXPECT_GT(set("\u0645\u0631\u062d\u0628\u0627 \u05e9\u05dc\u05d5\u05dd \u0915\u094d\u0937").width, 1);
    EXPECT_EQ(set("").width, 0);
    EXPECT_NEAR(set(std::string("a\0b\tc", 5)).width, set("a b c").width, 1e-12);
    EXPECT_NEAR(set("\u200b\ufeff\u200e").width, 0, 1e-12);
}

TEST(Type, JoinsAccentsWrittenApart) {
    EXPECT_EQ(set("perche\u0301").parts[0].glyphs.back().index, set("perché").parts[0].glyphs.back().index);
}

TEST(Type, HasTheNarrowSpacesThatTheFontHasNot) {
    EXPECT_NEAR(set("3\u202fm").width, set("3").width + 0.2 + set("m").width, 1e-12);
    EXPECT_NEAR(set("\u2009").width, 0.2, 1e-12);
    EXPECT_NEAR(set("\u00a0").width, 0.25, 1e-12);
}

TEST(Scripts, AreStackedAfterTheBase) {
    const ShapedLine line = fonts().shape({piece("a", Face::italic, "BA", "t")}, size);
    const auto scripts = glyphs_of_size(line, 0.7);
    ASSERT_EQ(scripts.size(), 3U);
    const double base = set("a", Face::italic).width;
    EXPECT_NEAR(scripts[0].origin.x, base, 1e-12);
    EXPECT_NEAR(scripts[0].origin.y, 0.22, 1e-12);
    EXPECT_NEAR(scripts[2].origin.y, -0.40, 1e-12);
    EXPECT_GE(scripts[2].origin.x, base);
    EXPECT_LE(scripts[2].origin.x, base + 0.15);
    EXPECT_NEAR(line.width, base + 0.7 * set("BA", Face::italic).width + 0.03, 1e-12);
}

TEST(Scripts, WiderOfTheTwoSetsTheAdvance) {
    const double sub = fonts().shape({piece("x", Face::regular, "rel")}, size).width;
    const double both = fonts().shape({piece("x", Face::regular, "rel", "m")}, size).width;
    const double wide = fonts().shape({piece("x", Face::regular, "i", "mmm")}, size).width;
    EXPECT_NEAR(both, std::max(sub, set("x").width + 0.7 * set("m").width + 0.03), 1e-12);
    EXPECT_NEAR(wide, set("x").width + 0.7 * set("mmm").width + 0.03, 1e-12);
}

TEST(Scripts, DotsHaveTheInkOfTheirLetter) {
    Piece omega = piece("ω", Face::italic);
    omega.dots = 1;
    const Colour ink{200, 100, 50};
    std::vector<Mark> marks;
    set_text(marks, fonts().shape({omega}, 10), {3, 4}, ink, "text");
    const auto& text = std::get<TextMark>(marks.front());
    ASSERT_EQ(text.extras.size(), 1u);
    EXPECT_EQ(text.extras[0].fill, ink) << "black, it could not be seen on a dark slide";
}

TEST(Scripts, DotsStandOverTheLastLetter) {
    Piece omega = piece("ω", Face::italic);
    const double ascent = fonts().shape({omega}, size).ascent;
    for (const int dots : {1, 2, 3}) {
        omega.dots = dots;
        const ShapedLine line = fonts().shape({omega}, size);
        ASSERT_EQ(line.parts[0].extras.size(), static_cast<std::size_t>(dots));
        double middle = 0;
        for (const Path& path : line.parts[0].extras) {
            const auto& circle = std::get<ArcTo>(path.segments.front());
            EXPECT_TRUE(path.filled);
            EXPECT_NEAR(circle.radius, 0.055, 1e-12);
            EXPECT_NEAR(circle.centre.y, -(ascent + 0.12), 1e-9);
            middle += circle.centre.x / dots;
        }
        EXPECT_GT(middle, line.width * 0.4);
        EXPECT_LT(middle, line.width * 0.8);
        EXPECT_NEAR(line.ascent, ascent + 0.175, 1e-9);
    }
}

TEST(Scripts, ArePlainInWords) {
    Piece omega = piece("ω", Face::italic, "3");
    omega.dots = 1;
    EXPECT_EQ(plain({piece("a", Face::italic, "BA", "t"), piece(" = "), omega}), "a_BA^t = ω\u0307_3");
    EXPECT_EQ(fonts().shape({piece("v", Face::italic, "B")}, 9).words, "v_B");
}

TEST(Colours, OnePartForEach) {
    Piece red = piece("v");
    red.coloured = true;
    red.colour = {200, 0, 0};
    const ShapedLine line = fonts().shape({piece("a"), red, piece("b"), red}, 9);
    ASSERT_EQ(line.parts.size(), 2U);
    EXPECT_FALSE(line.parts[0].coloured);
    EXPECT_EQ(line.parts[0].glyphs.size(), 2U);
    EXPECT_TRUE(line.parts[1].coloured);
    EXPECT_EQ(line.parts[1].colour, red.colour);
}

TEST(Wrap, KeepsTheMeasureAndTheWords) {
    const RichText text = {
        piece("The velocity of the pin is normal to the rocker; it ends where it meets the line of "),
        piece("v", Face::bold_italic, "BA"), piece(", which closes the polygon at "), piece("b", Face::italic),
        piece(".")};
    for (const double measure : {20.0, 35.0, 66.0, 500.0}) {
        std::string words;
        for (const ShapedLine& line : fonts().wrap(text, 9, measure)) {
            EXPECT_LE(line.width, measure + 1e-9);
            words += (words.empty() ? "" : " ") + line.words;
        }
        EXPECT_EQ(words, plain(text));
    }
    EXPECT_EQ(fonts().wrap(text, 9, 500).size(), 1U);
}

TEST(Wrap, LinesAreFull) {
    const auto lines = fonts().wrap({piece("aaa bbb ccc ddd eee fff")}, size, set("aaa bbb ccc").width);
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines[0].words, "aaa bbb ccc");
}

TEST(Wrap, LongWordStandsAlone) {
    const auto lines = fonts().wrap({piece("a incomprehensibilities b")}, size, 2);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1].words, "incomprehensibilities");
}

TEST(Wrap, DoesNotBreakWhatHoldsTogether) {
    EXPECT_EQ(fonts().wrap({piece("10\u00a0kg 3\u202fm/s")}, size, 0.1).size(), 2U);
    const auto scripted = fonts().wrap({piece("the point P 1", Face::regular, "0 0")}, size, 0.1);
    EXPECT_EQ(scripted.size(), 1U);
    // A comma after a symbol hangs on to it, whatever the pieces.
    const auto lines = fonts().wrap({piece("at "), piece("v", Face::italic, "B"), piece(", so")}, size, 0.1);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1].words, "v_B,");
}

/// The fonts have ¹, ² and ³, and no other raised digit; files and numbers have all of them.
TEST(Type, RaisesDigitsThatTheFontsHaveNot) {
    const ShapedLine raised = fonts().shape({piece("2 × 10⁻⁴⁰ m")}, size);
    Piece power = piece("10");
    power.sup = "−40";
    EXPECT_NEAR(raised.width, fonts().shape({piece("2\u00A0×\u00A0"), power, piece(" m")}, size).width, 1e-12);
    EXPECT_EQ(raised.words, "2 × 10⁻⁴⁰ m");
    EXPECT_EQ(fonts().wrap({piece("2 × 10⁵ m")}, size, 0.1).size(), 2U);
    const std::vector<std::string> missing = fonts().missing();
    for (const char* raised_by_us : {"U+2070", "U+2074", "U+2075", "U+207B"})
        EXPECT_EQ(std::count(missing.begin(), missing.end(), raised_by_us), 0) << raised_by_us;
}

/// A line ends nowhere between a number and its unit that have room on it; what is set has ordinary blanks.
TEST(Wrap, KeepsANumberWithItsUnit) {
    const std::string mass = "m = " + with_unit("0.25", "kg m²"), length = ",  b = " + with_unit("0.1831", "mm") + ".";
    const RichText text = with_powers(mass + length);
    std::size_t divided = 0;
    for (double measure = fonts().shape({piece("0.25 kg m²,")}, 9).width; measure < 60; measure += 0.5) {
        std::string all;
        const std::vector<ShapedLine> lines = fonts().wrap(text, 9, measure);
        for (const ShapedLine& line : lines) all += line.words + "|";
        EXPECT_NE(all.find("0.25 kg m^2"), std::string::npos) << all;
        EXPECT_NE(all.find("0.1831 mm."), std::string::npos) << all;
        divided += lines.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(divided, 20U);
    EXPECT_EQ(plain(text), "m = 0.25 kg m^2,  b = 0.1831 mm.");
    EXPECT_EQ(to_html(text), "m = 0.25 kg m<sup>2</sup>,  b = 0.1831 mm.");
}

TEST(Wrap, NothingIsOneEmptyLine) {
    ASSERT_EQ(fonts().wrap({}, 9, 10).size(), 1U);
    EXPECT_EQ(fonts().wrap({piece("   ")}, 9, 10).size(), 1U);
}

TEST(Shortened, KeepsWholeCharactersAndSaysAll) {
    const ShapedLine whole = set("éééééééééé", Face::bold), five = set("ééééé…", Face::bold);
    const ShapedLine cut = shaped_within({piece("éééééééééé", Face::bold)}, size, fonts(), five.width + 1e-9);
    EXPECT_NEAR(cut.width, five.width, 1e-9) << "the ellipsis is as bold as what it ends";
    EXPECT_EQ(glyphs(cut), glyphs(five));
    EXPECT_EQ(cut.words, "éééééééééé");
    EXPECT_EQ(shaped_within({piece("éééééééééé", Face::bold)}, size, fonts(), whole.width).width, whole.width);
}

TEST(Utf8, CountsAndCutsByWholeCharacters) {
    EXPECT_EQ(character_count("a≙𝛼é"), 4U);
    EXPECT_EQ(first_characters("a≙𝛼é", 3), "a≙𝛼");
    EXPECT_EQ(first_characters("a≙", 7), "a≙");
    EXPECT_EQ(first_characters("a≙", 0), "");
    // Whatever is not well formed counts byte by byte, to the very end.
    EXPECT_EQ(character_count("\x80\x80\xe2\x89"), 4U);
    EXPECT_EQ(first_characters("\x80\x80\xe2\x89", 3), "\x80\x80\xe2");
}

TEST(Opening, NamesTheFileAndThePackage) {
    ::setenv("KINEGRAPH_FONT_DIR", "/nowhere", 1);
    const auto none = Fonts::open();
    ::unsetenv("KINEGRAPH_FONT_DIR");
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().in(Language::en).find("/nowhere/STIXGeneral-Regular.otf"), std::string::npos);
    EXPECT_NE(none.error().in(Language::en).find("fonts-stix"), std::string::npos);
}

}  // namespace
}  // namespace text_test
