// Themes: colours that colour-blind eyes and a grey printer tell apart, letters that can be read, line kinds where
// there is no colour, and files of the user's.
#include "render/page/theme.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "render/page/body_colours.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/laid_out.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace theme_test {
namespace {

using kinegraph::Language;
using kinegraph::Solution;

using namespace kinegraph::render;
using namespace kinegraph::tests;

// ----- colours as eyes see them

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i) product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}
/// sRGB without its gamma, 0 to 1.
Triple linear(Colour c) {
    const auto one = [](std::uint8_t part) {
        const double x = part / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return {one(c.red), one(c.green), one(c.blue)};
}
constexpr Matrix to_xyz{
    {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};

/// CIE L*a*b* of linear sRGB, white D65.
Triple lab(const Triple& rgb) {
    Triple xyz = times(to_xyz, rgb);
    xyz[0] /= 0.95047;
    xyz[2] /= 1.08883;
    for (double& x : xyz) x = x > 0.008856 ? std::cbrt(x) : 7.787 * x + 16.0 / 116;
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}
double lightness(Colour c) { return lab(linear(c))[0]; }
double luminance(Colour c) { return times(to_xyz, linear(c))[1]; }

/// WCAG 2.1: 1 to 21.
double contrast(Colour a, Colour b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// What a dichromat sees of linear sRGB (Machado, Oliveira & Fernandes, "A physiologically-based model for simulation
/// of color vision deficiency", 2009, severity 1).
constexpr Matrix usual{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanope{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranope{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritanope{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

double apart(Colour a, Colour b, const Matrix& eye) {
    const auto seen = [&](Colour c) {
        Triple rgb = times(eye, linear(c));
        for (double& x : rgb) x = std::clamp(x, 0.0, 1.0);
        return lab(rgb);
    };
    const Triple x = seen(a), y = seen(b);
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

Theme theme(std::string_view name) { return built_in_theme(name).value(); }

/// The first five are apart by colour alone, in grey too; a line kind tells the others from them in grey, but not in
/// polygons, whose vectors are solid.
TEST(Theme, BodiesAreApartForAllEyesAndInGrey) {
    constexpr double of_full_lines = 27, of_all = 22, in_grey = 10;
    for (const char* name : {"colour", "dark"}) {
        const Theme look = theme(name);
        for (std::size_t i = 0; i < look.bodies.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Colour a = look.bodies[i].line, b = look.bodies[j].line;
                const bool both_full = look.bodies[i].dashes.empty() && look.bodies[j].dashes.empty();
                for (const Matrix& eye : {usual, protanope, deuteranope, tritanope})
                    EXPECT_GE(apart(a, b, eye), both_full ? of_full_lines : of_all)
                        << name << ": bodies " << j << " and " << i;
                if (look.bodies[i].dashes != look.bodies[j].dashes) continue;  // the line kind tells them apart
                EXPECT_GE(std::abs(lightness(a) - lightness(b)), both_full ? in_grey : 0.9 * in_grey)
                    << name << ": bodies " << j << " and " << i;
            }
    }
    EXPECT_NEAR(apart({255, 255, 255}, {0, 0, 0}, usual), 100, 0.1);
    EXPECT_LT(apart({0x9C, 0x5A, 0x00}, {0x5E, 0x6E, 0x00}, deuteranope), 27)
        << "brown and olive: the measure sees confusion";
}

TEST(Theme, TenBodiesHaveLooksOfTheirOwn) {
    for (const std::string_view name : theme_names()) {
        const Theme look = theme(name);
        std::set<std::tuple<std::uint8_t, std::uint8_t, std::uint8_t, std::vector<double>>> looks;
        for (const BodyColour& body : look.bodies)
            EXPECT_TRUE(looks.emplace(body.line.red, body.line.green, body.line.blue, body.dashes).second) << name;
        EXPECT_GE(looks.size(), 10U) << name;
    }
}

TEST(Theme, TypeCanBeRead) {
    for (const std::string_view name : theme_names()) {
        const Theme look = theme(name);
        EXPECT_GE(contrast(look.text, look.paper), 7) << name;
        EXPECT_GE(contrast(look.secondary, look.paper), 4.5) << name;
        for (const BodyColour& body : look.bodies) {
            EXPECT_GE(contrast(body.letter, look.paper), 4.5) << name;
            EXPECT_GE(contrast(body.letter, body.tint), 4.5) << name;
            EXPECT_GE(contrast(body.line, look.paper), 2) << name;
        }
    }
    EXPECT_NEAR(contrast({255, 255, 255}, {0, 0, 0}), 21, 1e-4);
}

// ----- sheets

/// Every colour of a sheet in its marks; those of type apart.
struct Colours {
    std::vector<Colour> all, type;
    void add(Colour c) {
        if (std::find(all.begin(), all.end(), c) == all.end()) all.push_back(c);
    }
    void add(const Path& path) {
        if (path.filled) add(path.fill);
        if (path.stroked) add(path.pen.colour);
    }
    explicit Colours(const std::vector<Page>& pages) {
        for (const Page& page : pages) {
            add(page.paper);
            for (const Mark& mark : page.marks) {
                if (const auto* path = std::get_if<Path>(&mark)) add(*path);
                if (const auto* text = std::get_if<TextMark>(&mark)) {
                    add(text->colour);
                    type.push_back(text->colour);
                    for (const Path& extra : text->extras) add(extra);
                }
            }
        }
    }
};

std::vector<Page> sheet(const std::string& example, const Theme& look) {
    static const Fonts fonts = Fonts::open().value();
    const auto solution = kinegraph::solve(
        kinegraph::read_mechanism(contents(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / example), "it").value());
    SheetOptions options;
    options.theme = look;
    return lay_out(solution.value(), options, fonts);
}

constexpr std::array examples{"four_bar.json", "exam_2001.json", "sluice_gate.json", "watt_six_bar.json",
                              "whitworth.json"};

TEST(Theme, PrintIsBlackOneGreyAndThePaper) {
    for (const char* example : examples) {
        const Colours colours(sheet(example, theme("print")));
        EXPECT_LE(colours.all.size(), 3U) << example;
        EXPECT_GE(colours.all.size(), 2U) << example;
        for (const Colour c : colours.all)
            EXPECT_TRUE(c == (Colour{0, 0, 0}) || c == (Colour{0x6E, 0x6E, 0x6E}) || c == (Colour{255, 255, 255}))
                << example << ": " << int{c.red} << ' ' << int{c.green} << ' ' << int{c.blue};
    }
}

TEST(Theme, AllTypeOfASheetCanBeRead) {
    for (const std::string_view name : theme_names())
        for (const char* example : examples) {
            const Theme look = theme(name);
            const Colours colours(sheet(example, look));
            ASSERT_FALSE(colours.type.empty());
            for (const Colour c : colours.type)
                EXPECT_GE(contrast(c, look.paper), 4.5)
                    << name << ' ' << example << ": " << int{c.red} << ' ' << int{c.green};
        }
}

TEST(Theme, EveryColourOfASheetIsTheThemes) {
    // A theme of colours that nobody would choose by accident: what stays of the usual ones was written elsewhere.
    Theme odd;
    std::uint8_t next = 1;
    const auto fresh = [&next] { return Colour{next++, 3, 5}; };
    for (Colour* colour : {&odd.paper, &odd.text, &odd.secondary, &odd.skeleton, &odd.faint, &odd.accent})
        *colour = fresh();
    for (BodyColour& body : odd.bodies) body = {fresh(), fresh(), fresh(), {}};
    for (const char* example : examples) {
        const Colours colours(sheet(example, odd));
        EXPECT_GT(colours.all.size(), 3U);
        for (const Colour c : colours.all)
            EXPECT_TRUE(c.green == 3 && c.blue == 5 && c.red < next)
                << example << ": " << int{c.red} << ' ' << int{c.green} << ' ' << int{c.blue};
    }
}

/// No letter of any example is elsewhere: a dark tint is no more ink than a light one, a dashed line no less than a
/// full one.
TEST(Theme, ChangesTheLookAndNothingElse) {
    using Letters = std::tuple<std::string, double, double>;
    std::size_t turn = 0;
    for (const std::string& name : example_names()) {
        if (++turn % kinegraph::unless_sanitized(1, 4) != 0) continue;
        const auto& solution = example(name);
        const auto letters_on = [](const std::vector<Page>& pages) {
            std::vector<Letters> letters;
            for (const Page& page : pages)
                for (const Mark& mark : page.marks)
                    if (const auto* text = std::get_if<TextMark>(&mark))
                        for (const Glyph& glyph : text->glyphs)
                            letters.emplace_back(text->words, glyph.origin.x, glyph.origin.y);
            return letters;
        };
        const std::vector<Letters> usual_letters = letters_on(kinegraph::tests::laid_out(name));
        EXPECT_FALSE(usual_letters.empty()) << name;
        // Not EXPECT_EQ: it would print all letters.
        for (const char* look : {"dark", "print"})
            EXPECT_TRUE(letters_on(lay_out(solution, kinegraph::tests::options_of({.theme = look}), fonts())) ==
                        usual_letters)
                << name << ' ' << look;
    }
}

TEST(Theme, ALinkOfALineKindIsOutlinedWithItsDashesInside) {
    Theme look;
    const BodyColour body{{10, 20, 30}, {200, 210, 220}, {10, 20, 30}, {3, 1}};
    std::vector<Mark> marks{line({0, 0}, {9, 0}, {0.18, body.line, {}, false}),
                            line({0, 0}, {20, 0}, {2, body.line, {}, true})};
    draw_line_kind(marks, 0, 1, body, look);
    ASSERT_EQ(marks.size(), 4U);
    const Pen ground = std::get<Path>(marks[2]).pen, inside = std::get<Path>(marks[3]).pen;
    EXPECT_EQ(ground, (Pen{2 - 2 * look.outline, body.tint, {}, true}));
    EXPECT_EQ(inside, (Pen{2 - 2 * look.outline, body.line, {3, 1}, false}));
    draw_line_kind(marks, 0, 1, look.body(kinegraph::BodyIndex(1)), look);
    EXPECT_EQ(marks.size(), 4U) << "a full line stays as it is";
}

/// The four-bar of the examples with a colour of body 3.
Solution coloured(const std::string& colour) {
    std::string text = contents(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / "four_bar.json");
    const std::string list = R"("3": ["A", "B"])";
    const std::size_t at = text.find(list);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, list.size(), R"("3": {"points": ["A", "B"], "colour": ")" + colour + "\"}");
    return kinegraph::solve(kinegraph::read_mechanism(text, "it").value()).value();
}

TEST(BodyColours, ALineIsAsGivenOnWhiteAndEverythingCanBeSeenOnEachPaper) {
    for (const char* given : {"#000000", "#ffffff", "#ffff00", "#0b0b60", "#7a1fa2", "#15171c", "#808080"}) {
        const Solution solution = coloured(given);
        for (const char* name : {"colour", "dark"}) {
            const Theme base = theme(name), look = with_colours_of(base, solution.mechanism);
            const BodyColour body = look.colour_of(kinegraph::BodyIndex(2));
            const Colour own = colour_of_number(*solution.mechanism.bodies[2].colour);
            if (std::string_view(name) == "colour") {
                EXPECT_EQ(body.line, own) << given;
            }
            EXPECT_GE(contrast(body.line, look.paper), std::min(3.0, contrast(own, {255, 255, 255})) - 1e-9) << given;
            EXPECT_GE(contrast(body.letter, look.paper), 4.5) << given << ' ' << name;
            EXPECT_GE(contrast(body.letter, body.tint), 4.5) << given << ' ' << name;
            EXPECT_EQ(body.dashes, base.body(kinegraph::BodyIndex(2)).dashes);
            EXPECT_EQ(look.colour_of(kinegraph::BodyIndex(1)).line, base.body(kinegraph::BodyIndex(1)).line);
        }
    }
}

TEST(BodyColours, AreThoseOfTheBodyInAllFiguresAndOfNoSheetInOneInk) {
    const Solution solution = coloured("#7A1FA2");
    const auto plain_options = kinegraph::tests::options_of({});
    SheetOptions options = plain_options;
    options.theme = with_colours_of(plain_options.theme, solution.mechanism);
    const Colours with(lay_out(solution, options, fonts())), without(lay_out(solution, plain_options, fonts()));
    const auto has = [](const Colours& all, Colour c) { return std::count(all.all.begin(), all.all.end(), c) > 0; };
    const Colour own{0x7A, 0x1F, 0xA2}, themes = plain_options.theme.body(kinegraph::BodyIndex(2)).line;
    EXPECT_TRUE(has(with, own) && !has(with, themes));
    EXPECT_TRUE(!has(without, own) && has(without, themes));
    const Theme print = theme("print"), kept = with_colours_of(print, solution.mechanism);
    for (std::size_t i = 1; i < 4; ++i)
        EXPECT_EQ(kept.body(kinegraph::BodyIndex(i)).line, print.body(kinegraph::BodyIndex(i)).line);
}

TEST(BodyColours, AFaultHasItsPlaceAndItsRemedy) {
    const auto said = [](const std::string& bodies) {
        const auto read = kinegraph::read_mechanism(
            R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 0]}, "bodies": )" + bodies +
                R"(, "joints": [{"revolute": "O", "bodies": [0, 2]}], "drivers": [{"body": 2, "omega": 1}]})",
            "it");
        std::string lines;
        if (!read)
            for (const kinegraph::Error& error : read.error())
                lines += error.where + ": " + error.message.in(Language::en) + '\n';
        return lines;
    };
    for (const char* wrong : {"\"red\"", "\"#12345\"", "\"#1234567\"", "\"#12345G\"", "\"#-12345\"", "5", "null"})
        EXPECT_EQ(said(R"({"2": {"points": ["O", "A"], "colour": )" + std::string(wrong) + "}}"),
                  "/bodies/2/colour: a colour is wanted here; write it as \"#c04020\"\n");
    EXPECT_EQ(said(R"({"0": {"points": ["O"], "colour": "#c04020"}, "2": ["O", "A"]})"),
              "/bodies/0/colour: the frame is drawn as text is; take its \"colour\" out\n");
    EXPECT_EQ(said(R"({"2": {"points": ["O", "A"], "colour": "#C04020"}})"), "");
}

// ----- files of the user's

TEST(ThemeFile, ChangesWhatItNames) {
    const auto read = read_theme(R"({"based on": "dark", "text": "#FF00aa", "lines": {"link": 1.5},
        "bodies": [{"line": "#010203"}, {"dashes": [3, 1, 0.5, 1]}]})");
    ASSERT_TRUE(read);
    const Theme base = theme("dark");
    EXPECT_EQ(read->text, (Colour{0xFF, 0x00, 0xAA}));
    EXPECT_EQ(read->paper, base.paper);
    EXPECT_EQ(read->link, 1.5);
    EXPECT_EQ(read->vector, base.vector);
    ASSERT_EQ(read->bodies.size(), 2U);
    EXPECT_EQ(read->bodies[0].line, (Colour{1, 2, 3}));
    EXPECT_EQ(read->bodies[0].letter, base.bodies[0].letter);
    EXPECT_EQ(read->bodies[1].line, base.bodies[1].line);
    EXPECT_EQ(read->bodies[1].dashes, (std::vector<double>{3, 1, 0.5, 1}));
    EXPECT_EQ(&read->body(kinegraph::BodyIndex(3)), &read->bodies[0]) << "they begin again";
    EXPECT_EQ(read_theme("{}").value().text, Theme{}.text);
}

TEST(ThemeFile, TellsEveryFaultWithItsPlace) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> rows{
        {R"([])", {": a theme is a JSON object"}},
        {R"({"papr": "#FFFFFF"})", {"/papr: unknown key \"papr\" (did you mean \"paper\"?)"}},
        {R"({"wallpaper!": 1})",
         {"/wallpaper!: unknown key \"wallpaper!\"; the keys of a theme are \"based on\", \"paper\", \"text\", "
          "\"secondary\", "
          "\"skeleton\", \"faint\", \"accent\", \"bodies\" and \"lines\""}},
        {R"({"based on": "drak"})", {"/based on: no theme is named \"drak\" (did you mean \"dark\"?)"}},
        {R"({"based on": 3})",
         {"/based on: the name of a built-in theme is wanted here: \"colour\", \"print\" and \"dark\""}},
        {R"({"text": "red", "paper": "#12345", "faint": "#12345G", "secondary": "#-12345", "skeleton": 5})",
         {"/paper: a colour is wanted here, as \"#RRGGBB\"", "/text: a colour is wanted here, as \"#RRGGBB\"",
          "/secondary: a colour is wanted here, as \"#RRGGBB\"", "/skeleton: a colour is wanted here, as \"#RRGGBB\"",
          "/faint: a colour is wanted here, as \"#RRGGBB\""}},
        {R"({"bodies": []})", {"/bodies: 1 to 24 bodies are wanted here, as an array"}},
        {R"({"bodies": [{"dashes": [1]}, {"dashes": [1, 1e400]}, {"colour": 1}]})",
         {"/bodies/0/dashes: an even number of lengths is wanted here, 8 at most: dash, gap, dash, gap (mm); none for "
          "a full line",
          "/bodies/1/dashes/1: a length from 0.2 to 20 mm is wanted here",
          "/bodies/2/colour: unknown key \"colour\"; the keys of a body's look are \"line\", \"tint\", \"letter\" and "
          "\"dashes\""}},
        {R"({"lines": {"link": -1, "thn": 0.2}})",
         {"/lines/thn: unknown key \"thn\" (did you mean \"thin\"?)",
          "/lines/link: a length from 0.3 to 4 mm is wanted here"}},
        {R"({"text": "#000000", "text": "#000000"})",
         {"/text: \"text\" stands twice in this object; take one of them out"}},
    };
    for (const auto& [text, said] : rows) {
        const auto read = read_theme(text);
        ASSERT_FALSE(read) << text;
        std::vector<std::string> lines;
        for (const kinegraph::Error& error : read.error())
            lines.push_back(error.where + ": " + error.message.in(Language::en));
        EXPECT_EQ(lines, said) << text;
    }
    EXPECT_FALSE(read_theme(""));
    EXPECT_FALSE(read_theme("{"));
}

TEST_F(CommandLine, TheThemeIsBuiltInOrAFile) {
    write("mine.json", R"({"paper": "#FFF8E7"})");
    write("bad.json", R"({"papr": "#FFF8E7"})");
    for (const auto& [name, paper] :
         {std::pair{"colour", "#ffffff"}, {"dark", "#15171c"}, {"print", "#ffffff"}, {"mine.json", "#fff8e7"}}) {
        ASSERT_EQ(run(std::string("solve four_bar.json -o a.svg --theme ") + name).status, 0);
        EXPECT_NE(contents(folder_ / "a.svg").find(std::string("fill=\"") + paper), std::string::npos) << name;
    }
    const Outcome bad = run("solve four_bar.json -o b.svg --theme bad.json");
    EXPECT_EQ(bad.status, 2);
    EXPECT_EQ(bad.err, "bad.json: /papr: unknown key \"papr\" (did you mean \"paper\"?)\n");
    const Outcome absent = run("solve four_bar.json -o b.svg --theme drak");
    EXPECT_EQ(absent.status, 2);
    EXPECT_EQ(absent.err,
              "drak: cannot be read: No such file or directory (--theme is one of colour, print, dark, or the path of "
              "a theme file)\n");
    EXPECT_EQ(run("solve - --theme - -o b.svg <four_bar.json").status, 2);
    EXPECT_FALSE(is_there("b.svg"));
}

}  // namespace
}  // namespace theme_test
