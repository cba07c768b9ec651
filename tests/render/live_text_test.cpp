// Live text: what a reader reads of an SVG or a PDF is what the page says, where it says it, in a font that comes
// along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <pugixml.hpp>
#include <regex>

#include "render/backends/backends.hpp"
#include "render/backends/live_text.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/sheet.hpp"
#include "render/text/subset.hpp"
#include "render/text/utf8.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace live_text_test {
namespace {

using kinegraph::Language;

using namespace kinegraph::render;
using namespace kinegraph::pages;
namespace tests = kinegraph::tests;

std::string live_svg(const Page& page) { return to_live_svg({&page, 1}, fonts()).front(); }

/// The texts of an SVG, each as it reads.
std::vector<std::string> readings(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str(), pugi::parse_default | pugi::parse_ws_pcdata));
    std::vector<std::string> texts;
    for (const auto& found : document.select_nodes("//text")) {
        std::string& text = texts.emplace_back();
        for (const auto& piece : found.node().select_nodes(".//text()")) text += piece.node().value();
    }
    return texts;
}

/// What the lines of a page say, by its marks alone.
std::vector<std::string> lines_of(const Page& page) {
    std::vector<std::string> lines;
    for (const TextMark* text : texts_of(page))
        if (!text->words.empty()) lines.push_back(well_formed(plain(as_set(text->text))));
    return lines;
}

Page page_of(const RichText& text) {
    Page page;
    set_text(page.marks, fonts().shape(text, 12), {10, 10}, {0, 0, 0}, "text");
    return page;
}
Page page_of(const std::string& words, Face face = Face::regular) { return page_of(one_piece(words, face)); }
std::string reading(const RichText& text) { return readings(live_svg(page_of(text))).at(0); }
std::string reading(const std::string& words) { return reading(one_piece(words)); }

Piece symbol(const std::string& text, const std::string& sub, const std::string& sup = "", int dots = 0) {
    Piece piece;
    piece.text = text;
    piece.face = Face::italic;
    piece.sub = sub;
    piece.sup = sup;
    piece.dots = dots;
    return piece;
}

std::vector<Page> sheet(const std::string& name, Language language) {
    SheetOptions options;
    options.language = language;
    return lay_out(example(name), options, fonts());
}

TEST(LiveText, AnSvgReadsAsItsSheet) {
    for (const auto& [name, language] :
         {std::pair{"four_bar", Language::en}, {"quick_return", Language::it}, {"contact/ball_on_plane", Language::it}})
        for (const Page& page : sheet(name, language)) {
            ASSERT_FALSE(lines_of(page).empty()) << name;
            EXPECT_EQ(readings(live_svg(page)), lines_of(page)) << name;
        }
}

TEST(LiveText, SymbolsReadAsOneWritesThem) {
    EXPECT_EQ(reading(RichText{symbol("v", "B"), symbol(" = ", "")}), "v_B = ");
    EXPECT_EQ(reading(RichText{symbol("a", "BA", "t")}), "a_BA^t");
    EXPECT_EQ(reading(RichText{symbol("ω", "3", "", 1)}), "ω\u0307_3");
    EXPECT_EQ(reading(RichText{symbol("s", "", "", 2)}), "s\u0308");
    EXPECT_EQ(reading("5 × 10⁻³ m/s²"), "5\u00A0×\u00A010^−3 m/s^2");
    EXPECT_EQ(reading("the office confirms it"), "the office confirms it");
}

TEST(LiveText, NamesOfAnyFileStayTheirOwn) {
    EXPECT_EQ(reading("<b>&\"]]>'"), "<b>&\"]]>'");
    EXPECT_EQ(reading("e\u0301\u00E9"), "e\u0301\u00E9");
    EXPECT_EQ(reading("漢字 B"), "漢字 B");        // drawn as their codes, read as themselves
    EXPECT_EQ(reading("a\u202Eb\u200Bc"), "abc");  // no mark of ours turns what others read
    EXPECT_EQ(reading("a\nb\tc"), "a b c");
    EXPECT_EQ(reading("\xFF\xC3"), "\uFFFD\uFFFD");
}

TEST(LiveText, EachStretchBeginsWhereItsOutlinesDo) {
    const Page page = page_of({symbol("Two words", ""), symbol(" v", "BA"), symbol(" m", "", "2")});
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(live_svg(page).c_str()));
    const auto& mark = std::get<TextMark>(page.marks.at(0));
    std::size_t found = 0;
    double y = 0;
    for (const auto& selected : document.select_nodes("//text/tspan[not(@fill='none')]")) {
        const auto span = selected.node();
        if (span.attribute("y")) y = span.attribute("y").as_double();
        const double x = span.attribute("x").as_double();
        const auto at = std::find_if(mark.glyphs.begin(), mark.glyphs.end(), [&](const Glyph& glyph) {
            return std::abs(glyph.origin.x - x) < 1e-4 && std::abs(glyph.origin.y - y) < 1e-4;
        });
        ASSERT_NE(at, mark.glyphs.end()) << span.child_value();
        const double size = span.attribute("font-size") ? span.attribute("font-size").as_double()
                                                        : span.parent().attribute("font-size").as_double();
        EXPECT_NEAR(size, at->size, 1e-6);
        ++found;
    }
    EXPECT_EQ(found, 6U);  // Two, words, v, BA, m, 2
}

TEST(LiveText, LinesInSeveralColoursAreOneText) {
    RichText text = one_piece("red");
    text.front().coloured = true;
    text.front().colour = {255, 0, 0};
    append(text, " and black");
    const std::string svg = live_svg(page_of(text));
    EXPECT_EQ(readings(svg), std::vector<std::string>{"red and black"});
    EXPECT_NE(svg.find("fill=\"#000000\">black"), std::string::npos) << svg;
}

/// The parts of a font that two words need do all that the font does for them.
TEST(LiveText, SubsetsSetTheSameLine) {
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "kinegraph-font-XXXXXX").string();
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string words = "officina AVATAR ω è";
    WantedType wanted;
    for (std::size_t at = 0; at < words.size();) wanted.characters.insert(next_code_point(words, at));
    const char* names[] = {"STIXGeneral-Regular.otf", "STIXGeneral-Italic.otf", "STIXGeneral-Bold.otf",
                           "STIXGeneral-BoldItalic.otf"};
    for (std::uint8_t face = 0; face < 4; ++face) {
        const std::string part = font_subset(fonts().file(face), wanted);
        EXPECT_LT(part.size(), 30000U);
        EXPECT_GT(part.size(), 500U);
        EXPECT_EQ(part, font_subset(fonts().file(face), wanted));
        std::ofstream(fs::path(folder) / names[face], std::ios::binary) << part;
    }
    const char* before = std::getenv("KINEGRAPH_FONT_DIR");
    const std::string kept = before != nullptr ? before : "";
    ::setenv("KINEGRAPH_FONT_DIR", folder.c_str(), 1);
    const auto opened = Fonts::open();
    before != nullptr ? ::setenv("KINEGRAPH_FONT_DIR", kept.c_str(), 1) : ::unsetenv("KINEGRAPH_FONT_DIR");
    fs::remove_all(folder);
    ASSERT_TRUE(opened);
    for (const Face face : {Face::regular, Face::italic, Face::bold, Face::bold_italic}) {
        const ShapedLine whole = fonts().shape(one_piece(words, face), 10),
                         part = opened->shape(one_piece(words, face), 10);
        EXPECT_EQ(whole.width, part.width);
        ASSERT_EQ(whole.parts.at(0).glyphs.size(), part.parts.at(0).glyphs.size());
        for (std::size_t i = 0; i < whole.parts.at(0).glyphs.size(); ++i) {
            const Glyph &a = whole.parts.at(0).glyphs[i], &b = part.parts.at(0).glyphs[i];
            EXPECT_EQ(a.origin, b.origin);
            EXPECT_EQ(fonts().outline(a.face, a.index).segments.size(),
                      opened->outline(b.face, b.index).segments.size());
        }
    }
    EXPECT_TRUE(opened->missing().empty());
}

TEST(LiveText, TheFontComesAlongUnderANameOfItsOwn) {
    const std::string one = live_svg(page_of("one")), other = live_svg(page_of("other", Face::bold));
    const std::regex family("font-family=\"(Kinegraph-[0-9a-f]{8}), STIXGeneral, serif\"");
    std::smatch in_one, in_other;
    ASSERT_TRUE(std::regex_search(one, in_one, family));
    ASSERT_TRUE(std::regex_search(other, in_other, family));
    EXPECT_NE(in_one.str(1), in_other.str(1));
    EXPECT_NE(one.find("@font-face{font-family:\"" + in_one.str(1) + "\""), std::string::npos);
    EXPECT_NE(one.find("data:font/otf;base64,T1RUTw"), std::string::npos);  // "OTTO"
    EXPECT_EQ(live_svg(Page{}).find("@font-face"), std::string::npos);
}

TEST(LiveText, TheSameBytesTwice) {
    const std::vector<Page> pages = sheet("quick_return", Language::en);
    EXPECT_EQ(to_live_svg(pages, fonts()), to_live_svg(pages, fonts()));
    EXPECT_EQ(to_live_pdf(pages, fonts()), to_live_pdf(pages, fonts()));
    EXPECT_EQ(to_live_svg(pages, fonts()).at(1), live_svg(pages.at(1)));  // whatever stands before it
}

TEST(LiveText, APdfSaysItsLanguageAndThatItIsTagged) {
    const std::string pdf = to_live_pdf(sheet("four_bar", Language::it), fonts());
    EXPECT_NE(pdf.find("/Lang (it)"), std::string::npos);
    EXPECT_NE(pdf.find("/MarkInfo << /Marked true >>"), std::string::npos);
    EXPECT_NE(pdf.find("/DisplayDocTitle true"), std::string::npos);
    EXPECT_NE(pdf.find("/S /Figure"), std::string::npos);
    EXPECT_NE(pdf.find("/S /P"), std::string::npos);
    EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
    const std::string outlines = to_pdf(sheet("four_bar", Language::it), fonts());
    EXPECT_EQ(outlines.find("/Lang"), std::string::npos);
    EXPECT_EQ(outlines.find("/StructTreeRoot"), std::string::npos);
}

class LiveFiles : public tests::CommandLine {
protected:
    static bool has(const std::string& program) {
        return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
    }
};

std::string without_blanks(std::string text) {
    const auto blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\f' || c == '\t'; };
    for (const char* const wide : {"\u00A0", "\u2009", "\u202F"})
        for (std::size_t at = text.find(wide); at != std::string::npos; at = text.find(wide))
            text.erase(at, std::string(wide).size());
    text.erase(std::remove_if(text.begin(), text.end(), blank), text.end());
    return text;
}

TEST_F(LiveFiles, APdfReadsAsItsSheet) {
    if (!has("pdftotext")) GTEST_SKIP() << "no pdftotext (poppler-utils)";
    for (const Language language : {Language::en, Language::it}) {
        const std::vector<Page> pages = sheet("four_bar", language);
        write("a.pdf", to_live_pdf(pages, fonts()));
        ASSERT_EQ(run("--version", "pdftotext -raw a.pdf a.txt &&").status, 0);
        const std::string text = without_blanks(tests::contents(folder_ / "a.txt"));
        std::string said;
        for (const Page& page : pages) {
            for (const TextMark* mark : texts_of(page)) {
                if (mark->words.empty()) continue;
                const std::string line = without_blanks(plain(as_set(mark->text)));
                said += line;
                if (mark->angle == 0) {
                    EXPECT_NE(text.find(line), std::string::npos) << line;
                }
            }
        }
        std::string read = text;
        std::sort(said.begin(), said.end());
        std::sort(read.begin(), read.end());
        EXPECT_EQ(read, said);
    }
}

TEST_F(LiveFiles, ThePictureIsThatOfTheOutlines) {
    ASSERT_EQ(run("solve four_bar.json -o live.svg --text live").status, 0);
    ASSERT_EQ(run("solve four_bar.json -o plain.svg --text outlines").status, 0);
    ASSERT_EQ(run("solve four_bar.json -o default.svg").status, 0);
    EXPECT_EQ(tests::contents(folder_ / "plain.svg"), tests::contents(folder_ / "default.svg"));
    EXPECT_EQ(tests::contents(folder_ / "plain.svg").find("<text"), std::string::npos);
    if (!has("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert (librsvg2-bin)";
    EXPECT_EQ(run("diff plain.svg live.svg --threshold 0.1%").status, 0);
}

TEST_F(LiveFiles, TheOptionIsForWordsThatCanBeLive) {
    const tests::Outcome picture = run("solve four_bar.json -o a.png --dpi 30 --text live");
    EXPECT_EQ(picture.status, 0);
    EXPECT_NE(picture.err.find("--text says how SVG and PDF carry their words"), std::string::npos) << picture.err;
    EXPECT_EQ(run("solve four_bar.json -o a.svg --text loud").status, 2);
    EXPECT_EQ(run("sweep four_bar.json -o a.pdf --steps 4 --text live").status, 0);
    EXPECT_NE(tests::contents(folder_ / "a.pdf").find("/Lang (en)"), std::string::npos);
}

}  // namespace
}  // namespace live_text_test
