// TikZ: words as TeX reads them, a document that pdflatex takes, and the same picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

#include "render/backends/backends.hpp"
#include "render/backends/picture_difference.hpp"
#include "render/backends/tex_words.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace tex_test {
namespace {

using kinegraph::Language;

using namespace kinegraph::render;
using namespace kinegraph::pages;
namespace tests = kinegraph::tests;

std::string tex(const RichText& text) {
    return tex_of(text, [](Colour) { return std::string("kgA"); }).value_or("(outlines)");
}
std::string tex(const std::string& words, Face face = Face::regular) { return tex(one_piece(words, face)); }

Piece symbol(const std::string& text, const std::string& sub, const std::string& sup = "", int dots = 0,
             Face face = Face::italic) {
    Piece piece;
    piece.text = text;
    piece.face = face;
    piece.sub = sub;
    piece.sup = sup;
    piece.dots = dots;
    return piece;
}
std::string tex(const Piece& piece) { return tex(RichText{piece}); }

std::string document(const RichText& text) {
    Page page;
    page.title = "%{}\\\n\\end{document}";
    set_text(page.marks, fonts().shape(text, 12), {10, 20}, {0, 0, 0}, "text");
    return to_tex({page}, fonts());
}

TEST(TexWords, QuantitiesAreMathematics) {
    EXPECT_EQ(tex(symbol("v", "B")), "$v_{B}$");
    EXPECT_EQ(tex(symbol("a", "BA", "t")), "$a_{\\mathit{BA}}^{\\mathrm{t}}$");
    EXPECT_EQ(tex(symbol("ω", "3", "", 1)), "$\\dot{\\omega }_{3}$");
    EXPECT_EQ(tex(symbol("x", "", "", 2)), "$\\ddot{x}$");
    EXPECT_EQ(tex(symbol("v", "B", "", 0, Face::bold_italic)), "$\\kgbold{v}_{B}$");
    EXPECT_EQ(tex("AB", Face::italic), "$\\mathit{AB}$");
    EXPECT_EQ(tex(with_powers("m/s²")), "m/s${}^{2}$");
    EXPECT_EQ(tex(symbol("P", "1,3")), "$P_{1{,}3}$");
    EXPECT_EQ(tex(symbol("o\u2032", "2")), "$o{}'{}_{2}$");
}

TEST(TexWords, ProseIsProse) {
    EXPECT_EQ(tex("⟂ AB, ∥ x: 3 × 2 − 1"), "$\\perp $ AB, $\\parallel $ x: 3 $\\times $ 2 $-$ 1");
    EXPECT_EQ(tex("perché è così, Grübler"), "perch\\'{e} \\`{e} cos\\`{\\i}, Gr\\\"{u}bler");
    EXPECT_EQ(tex("e\u0301"), "\\'{e}");
    EXPECT_EQ(tex("½ 30°"), "$\\frac{1}{2}$ 30${}^{\\circ}$");
    EXPECT_EQ(tex("bold", Face::bold), "\\textbf{bold}");
    EXPECT_EQ(tex("  a  b "), "a \\ b");
}

TEST(TexWords, BlanksOutsideOfBracesPartWords) {
    RichText line = one_piece("  turns\u00A0 about ");
    line.push_back(symbol("O", "2"));
    append(line, ":");
    append(line, one_piece(" in bold", Face::bold));
    const auto words = tex_words_of(line, [](Colour) { return std::string("kgA"); });
    ASSERT_TRUE(words);
    ASSERT_EQ(words->size(), 4);
    const std::string said = plain(line);
    const auto expect_word = [&](std::size_t i, const std::string& set, const std::string& begins, std::size_t blanks) {
        EXPECT_EQ((*words)[i].tex, set);
        EXPECT_EQ(said.substr((*words)[i].at, begins.size()), begins);
        EXPECT_EQ((*words)[i].blanks, blanks);
    };
    expect_word(0, "turns", "turns", 0);
    expect_word(1, "\\ about", "about", 1);
    expect_word(2, "$O_{2}$:", "O_2:", 0);
    expect_word(3, "\\textbf{in bold}", "in bold", 0);
    EXPECT_EQ(line_of(*words), "turns \\ about $O_{2}$: \\textbf{in bold}");
    EXPECT_EQ(tex(symbol("5 \u00D7 10", "", "3", 0, Face::regular)), "5 $\\times $ 10${}^{3}$");
}

TEST(TexWords, NamesOfAnyFileAreEscaped) {
    EXPECT_EQ(tex("\\input{x}%$&#_^~"),
              "\\textbackslash{}input\\{x\\}\\%\\$\\&\\#\\_\\textasciicircum{}\\textasciitilde{}");
    EXPECT_EQ(tex("<|>"), "$<$$|$$>$");
    EXPECT_EQ(tex("--``"), "-{}-{}`{}`{}");
    EXPECT_EQ(tex("a\nb\x01"), "a b");
    EXPECT_EQ(tex(symbol("F", "a_b%")), "$F_{\\mbox{\\kgscript \\textit{a\\_b\\%}}}$");
    EXPECT_EQ(tex("漢"), "(outlines)");
}

TEST(Tex, WhatTexHasNoLettersForIsDrawn) {
    const std::string drawn = document(one_piece("漢字 ✓"));
    EXPECT_NE(drawn.find("% 漢字 ✓\n"), std::string::npos);
    EXPECT_EQ(drawn.find("\\node"), std::string::npos);
    EXPECT_NE(drawn.find(".. controls"), std::string::npos);
}

/// Outside of comments: ASCII, and every brace has its fellow.
void expect_sound(const std::string& text) {
    int depth = 0;
    bool escaped = false, comment = false;
    for (const char c : text) {
        if (c == '\n') comment = false;
        if (comment) continue;
        EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7F)) << static_cast<int>(c);
        if (!escaped && c == '%') comment = true;
        if (!escaped && c == '{') ++depth;
        if (!escaped && c == '}') --depth;
        EXPECT_GE(depth, 0);
        escaped = !escaped && c == '\\';
    }
    EXPECT_EQ(depth, 0);
}

TEST(Tex, ADocumentIsSoundAndHasAPictureForEachPage) {
    for (const char* name : {"four_bar", "contact/ball_on_plane"}) {
        SheetOptions options;
        options.language = Language::it;
        const std::vector<Page> pages = lay_out(example(name), options, fonts());
        const std::string text = to_tex(pages, fonts());
        expect_sound(text);
        EXPECT_EQ(text, to_tex(pages, fonts()));
        std::size_t pictures = 0;
        for (std::size_t at = text.find("\\begin{tikzpicture}"); at != std::string::npos;
             at = text.find("\\begin{tikzpicture}", at + 1))
            ++pictures;
        EXPECT_EQ(pictures, pages.size());
    }
    expect_sound(document(one_piece("}{\\%漢")));
}

/// How many words TeX sees: blanks outside of braces part them, those behind a control word or "\\" do not.
std::size_t words_seen(const std::string& line) {
    std::size_t words = 1;
    int depth = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '\\') {
            const std::size_t name = ++i;
            while (i < line.size() && std::isalpha(static_cast<unsigned char>(line[i])) != 0) ++i;
            // What ends a control word is read again, but for the blank that does.
            if (i > name && (i == line.size() || line[i] != ' ')) --i;
            continue;
        }
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (c == ' ' && depth == 0) ++words;
    }
    return words;
}

TEST(Tex, EveryWordHasItsWidth) {
    const std::string text = to_tex(laid_out("four_bar"), fonts());
    const std::regex line(R"(\\kgline\{([0-9.]+)\}\{([0-9. ]+)\}\{(.*)\}\};\n)");
    std::size_t lines = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at, ++lines) {
        const std::string widths = (*at)[2];
        EXPECT_EQ(words_seen((*at)[3]), std::count(widths.begin(), widths.end(), ' ') + 1) << at->str();
    }
    EXPECT_GT(lines, 200);
    // A word's width with the blank behind it is the way to the next word.
    const ShapedLine shaped = fonts().shape(one_piece("turns about"), 12);
    std::smatch found;
    const std::string drawn = document(one_piece("turns about"));
    ASSERT_TRUE(std::regex_search(drawn, found, std::regex(R"(\\kgline\{12\}\{([0-9.]+) ([0-9.]+)\}\{turns about\})")));
    EXPECT_NEAR(std::stod(found[1]), fonts().width(one_piece("turns"), 12), 0.002);
    EXPECT_NEAR(std::stod(found[1]) + millimetres(12) / 4 + std::stod(found[2]), shaped.width, 0.04 * millimetres(12));
}

TEST(Tex, LettersHaveTheirWidthsOnTop) {
    const std::string text = document(one_piece("on in;"));
    EXPECT_NE(text.find("\\def\\kgroman{;"), std::string::npos);
    EXPECT_NE(text.find("i278 n500 o500 }\n\\def\\kgitalics{}\n"), std::string::npos);
}

TEST(Tex, LinksRunBetweenNamedPoints) {
    const auto page = lay_out_alone(example("four_bar"), {}, "mechanism", fonts());
    ASSERT_TRUE(page);
    const std::string text = to_tex({*page}, fonts());
    for (const char* point : {"joint-O2", "joint-A", "joint-B", "joint-O4"})
        EXPECT_NE(text.find(std::string("\\coordinate (") + point + ") at ("), std::string::npos) << point;
    EXPECT_TRUE(std::regex_search(
        text, std::regex("\\\\path\\[draw=kg[A-Z], kg full [A-Z]\\] \\(joint-A\\) -- \\(joint-B\\);")));
    EXPECT_TRUE(std::regex_search(text, std::regex("\\(joint-A\\) circle\\[radius=1\\.5\\]")));
    EXPECT_NE(text.find("{$A$}"), std::string::npos);
}

class TexFiles : public tests::CommandLine {
protected:
    /// The pages of a document as PNGs: NAME-tex-1.png and so on. Both tools belong to the packages that tests need.
    void typeset(const std::string& name, double dpi = 150) const {
        const tests::Outcome done =
            run("--version", "pdflatex -interaction=nonstopmode -halt-on-error " + name + ".tex >log && pdftoppm -r " +
                                 std::to_string(dpi) + " -png " + name + ".pdf " + name + "-tex &&");
        ASSERT_EQ(done.status, 0) << tests::contents(folder_ / "log");
    }
    /// Of the pages on average `most` percent may differ.
    void expect_same_picture(const std::vector<Page>& pages, const std::string& name, double most) {
        constexpr double dpi = 150;
        ASSERT_FALSE(pages.empty());
        double shares = 0;
        write(name + ".tex", to_tex(pages, fonts()));
        typeset(name, dpi);
        for (std::size_t i = 0; i < pages.size(); ++i) {
            SCOPED_TRACE(name + ", page " + std::to_string(i + 1));
            const auto ours = decode_png(to_png(pages[i], fonts(), dpi));
            const auto theirs =
                decode_png(tests::contents(folder_ / (name + "-tex-" + std::to_string(i + 1) + ".png")));
            ASSERT_TRUE(ours && theirs);
            shares += 100 * compare(*ours, *theirs, 0.1).share();
        }
        EXPECT_LE(shares / static_cast<double>(pages.size()), most) << name;
    }
};

/// The letters differ, for TeX has other ones, and little else. A new layout moves letters from one page to the next:
/// so the bound is for all pages of a sheet together.
TEST_F(TexFiles, PdflatexDrawsTheSamePicture) {
    struct Sheet {
        const char* example;
        SheetOptions options;
        double most;
    };
    SheetOptions dark;
    dark.language = Language::it;
    dark.theme = built_in_theme("dark").value();
    const std::vector<Sheet> sheets = {
        {"rotating_body", {}, 0.20}, {"four_bar", {}, 0.50}, {"jansen_leg", {}, 0.65}, {"scissor_lift", dark, 0.55}};
    for (const Sheet& sheet : sheets)
        expect_same_picture(lay_out(example(sheet.example), sheet.options, fonts()), sheet.example, sheet.most);
    const auto page = lay_out_alone(example("four_bar"), {}, "mechanism", fonts());
    ASSERT_TRUE(page);
    expect_same_picture({*page}, "four_bar-mechanism", 0.20);
}

TEST_F(TexFiles, PdflatexTakesWhateverAFileNames) {
    RichText all =
        one_piece("\\input{x}%$&#_^~<|>\"'`--?`!`perch\u00E9 \u2026 \u2192 \u00BD \u221A2 30\u00B0 m/s\u00B2 ");
    all.push_back(symbol("\\a%", "{$", "^\u00E9"));
    all.push_back(symbol("\u03C9", "3", "2", 3));
    all.push_back(symbol("v\u00E9", "B", "", 0, Face::bold_italic));
    all.push_back(symbol("w", "B\u03C6", "t", 0, Face::bold));
    const std::string text = document(all);
    EXPECT_NE(text.find("\\node"), std::string::npos);
    write("names.tex", text);
    typeset("names");
    write("part.tex", text);
    // Twice, with a sign that languages of babel make a command.
    write("whole.tex", R"(\documentclass{article}\usepackage{tikz}\begin{document}\catcode`\"=13 )"
                       R"(\def"{!}Text \input{part} and \input{part}.\end{document})");
    typeset("whole");
}

/// A name of thousands of letters is longer than any length that TeX knows: what of it is on the page is drawn.
TEST_F(TexFiles, NamesLongerThanTexsLengthsAreDrawnAsFarAsThePageGoes) {
    Page page;
    set_text(page.marks, fonts().shape(one_piece(std::string(4000, 'A')), 12), {10, 20}, {0, 0, 0}, "text");
    set_text(page.marks, fonts().shape(RichText{symbol("v", std::string(4000, 'B'))}, 12), {-5000, 60}, {0, 0, 0},
             "text");
    set_text(page.marks, fonts().shape(one_piece("short"), 12), {10, 90}, {0, 0, 0}, "text");
    const std::string text = to_tex({page}, fonts());
    EXPECT_NE(text.find("{short}"), std::string::npos);
    const std::size_t pictures = text.find("\\begin{tikzpicture}");
    EXPECT_EQ(text.substr(pictures).find("AAAA}"), std::string::npos);
    EXPECT_NE(text.substr(pictures).find(".. controls"), std::string::npos) << "what is on the page";
    EXPECT_LT(text.size(), 400'000U) << "and no more";
    write("long.tex", text);
    typeset("long");
}

TEST_F(TexFiles, EveryCommandThatDrawsWritesIt) {
    EXPECT_EQ(run("solve four_bar.json -o a.tex --lang it --theme dark --steps").status, 0);
    EXPECT_EQ(run("sweep four_bar.json -o b.tex --steps 4").status, 0);
    EXPECT_EQ(run("solve four_bar.json -o - --format tex >c.tex").status, 0);
    for (const char* name : {"a.tex", "b.tex", "c.tex"}) expect_sound(tests::contents(folder_ / name));
}

}  // namespace
}  // namespace tex_test
