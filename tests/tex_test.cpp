// TikZ: words as TeX reads them, a document that pdflatex takes, and the same picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "render/backends/backends.hpp"
#include "render/backends/tex_words.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/command_line.hpp"
#include "tests/pages.hpp"

namespace {

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
    EXPECT_EQ(tex(symbol("v", "B", "", 0, Face::bold_italic)), "{\\boldmath$v_{B}$}");
    EXPECT_EQ(tex("AB", Face::italic), "$\\mathit{AB}$");
    EXPECT_EQ(tex(with_powers("m/s²")), "m/s${}^{2}$");
    EXPECT_EQ(tex(symbol("P", "1,3")), "$P_{1{,}3}$");
}

TEST(TexWords, ProseIsProse) {
    EXPECT_EQ(tex("⟂ AB, ∥ x: 3 × 2 − 1"), "$\\perp $ AB, $\\parallel $ x: 3 $\\times $ 2 $-$ 1");
    EXPECT_EQ(tex("perché è così, Grübler"), "perch\\'{e} \\`{e} cos\\`{\\i}, Gr\\\"{u}bler");
    EXPECT_EQ(tex("e\u0301"), "\\'{e}");
    EXPECT_EQ(tex("½ 30°"), "$\\frac{1}{2}$ 30${}^{\\circ}$");
    EXPECT_EQ(tex("bold", Face::bold), "\\textbf{bold}");
    EXPECT_EQ(tex("  a  b "), "a \\ b");
}

TEST(TexWords, NamesOfAnyFileAreEscaped) {
    EXPECT_EQ(tex("\\input{x}%$&#_^~"), "\\textbackslash{}input\\{x\\}\\%\\$\\&\\#\\_\\textasciicircum{}\\textasciitilde{}");
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

TEST(Tex, LinksRunBetweenNamedPoints) {
    const auto page = lay_out_alone(example("four_bar"), {}, "mechanism", fonts());
    ASSERT_TRUE(page);
    const std::string text = to_tex({*page}, fonts());
    for (const char* point : {"joint-O2", "joint-A", "joint-B", "joint-O4"})
        EXPECT_NE(text.find(std::string("\\coordinate (") + point + ") at ("), std::string::npos) << point;
    EXPECT_TRUE(std::regex_search(text, std::regex("\\\\path\\[draw=kg[A-Z], kg full [A-Z]\\] \\(joint-A\\) -- \\(joint-B\\);")));
    EXPECT_TRUE(std::regex_search(text, std::regex("\\(joint-A\\) circle\\[radius=1\\.5\\]")));
    EXPECT_NE(text.find("{$A$}"), std::string::npos);
}

class TexFiles : public tests::CommandLine {
protected:
    /// The pages of a document as PNGs; whether the machine has what that takes.
    bool typesets() const {
        return std::system("command -v pdflatex >/dev/null 2>&1 && command -v pdftoppm >/dev/null 2>&1") == 0;
    }
    void typeset(const std::string& name) const {
        const tests::Outcome done =
            run("--version", "pdflatex -interaction=nonstopmode -halt-on-error " + name + ".tex >log && pdftoppm -r 150 -png " +
                                 name + ".pdf " + name + "-tex &&");
        ASSERT_EQ(done.status, 0) << tests::contents(folder_ / "log");
    }
};

TEST_F(TexFiles, PdflatexDrawsTheSamePicture) {
    // Of pages dense with small type, letters alone differ by more: 1.3 % of the four-bar's one page, 1.8 % at most.
    ASSERT_EQ(run("solve '" KINEGRAPH_EXAMPLES_DIR "/rotating_body.json' -o sheet.tex -o sheet.png").status, 0);
    ASSERT_EQ(run("solve four_bar.json -o figure.tex -o figure.png --figure mechanism").status, 0);
    if (!typesets()) GTEST_SKIP() << "no pdflatex (texlive-latex-base, texlive-pictures) or no pdftoppm (poppler-utils)";
    typeset("sheet");
    typeset("figure");
    for (const char* pair : {"sheet.png sheet-tex-1.png", "sheet-2.png sheet-tex-2.png", "figure.png figure-tex-1.png"}) {
        const tests::Outcome same = run(std::string("diff ") + pair + " --threshold 1%");
        EXPECT_EQ(same.status, 0) << same.out;
    }
}

TEST_F(TexFiles, PdflatexTakesWhateverAFileNames) {
    RichText all = one_piece("\\input{x}%$&#_^~<|>\"'`--?`!`perch\u00E9 \u2026 \u2192 \u00BD \u221A2 30\u00B0 m/s\u00B2 ");
    all.push_back(symbol("\\a%", "{$", "^\u00E9"));
    all.push_back(symbol("\u03C9", "3", "2", 3));
    all.push_back(symbol("v\u00E9", "B", "", 0, Face::bold_italic));
    all.push_back(symbol("w", "B\u03C6", "t", 0, Face::bold));
    const std::string text = document(all);
    EXPECT_NE(text.find("\\node"), std::string::npos);
    if (!typesets()) GTEST_SKIP() << "no pdflatex (texlive-latex-base, texlive-pictures) or no pdftoppm (poppler-utils)";
    write("names.tex", text);
    typeset("names");
    write("part.tex", text);
    write("whole.tex", "\\documentclass{article}\\usepackage{tikz}\\begin{document}Text \\input{part} text.\\end{document}");
    typeset("whole");
}

TEST_F(TexFiles, EveryCommandThatDrawsWritesIt) {
    EXPECT_EQ(run("solve four_bar.json -o a.tex --lang it --theme dark --steps").status, 0);
    EXPECT_EQ(run("sweep four_bar.json -o b.tex --steps 4").status, 0);
    EXPECT_EQ(run("solve four_bar.json -o - --format tex >c.tex").status, 0);
    for (const char* name : {"a.tex", "b.tex", "c.tex"}) expect_sound(tests::contents(folder_ / name));
}

}  // namespace
