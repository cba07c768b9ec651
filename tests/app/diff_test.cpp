// kinegraph diff as a user meets it: what it says, what it leaves, how it ends.
#include <gtest/gtest.h>

#include <array>

#include "render/backends/picture_difference.hpp"
#include "tests/support/command_line.hpp"

namespace diff_test {
namespace {

using namespace kinegraph::tests;
namespace render = kinegraph::render;

bool draws_svg() { return std::system("command -v rsvg-convert >/dev/null 2>&1") == 0; }

class DiffCommand : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        render::Picture picture{40, 25, std::vector<render::Colour>(1000, {255, 255, 255}), std::nullopt};
        write("white.png", encode_png(picture));
        for (int i = 0; i < 5; ++i) picture.pixels[static_cast<std::size_t>(400 + 2 * i)] = {0, 0, 0};
        write("dotted.png", encode_png(picture));
        picture = {20, 25, std::vector<render::Colour>(500, {255, 255, 255}), std::nullopt};
        write("narrow.png", encode_png(picture));
        write("broken.png", encode_png(picture).substr(0, 70));
        write("square.svg",
              R"(<svg xmlns="http://www.w3.org/2000/svg" width="25.4mm" height="25.4mm" viewBox="0 0 10 10">)"
              R"(<rect width="10" height="10" fill="#fff"/><rect x="2" y="2" width="5" height="6"/></svg>)");
        write("shorter.svg",
              R"(<svg xmlns="http://www.w3.org/2000/svg" width="25.4mm" height="25.4mm" viewBox="0 0 10 10">)"
              R"(<rect width="10" height="10" fill="#fff"/><rect x="2" y="2" width="5" height="5"/></svg>)");
    }
    render::Picture picture(const std::string& name) const {
        return render::decode_png(contents(folder_ / name)).value();
    }
};

TEST_F(DiffCommand, EqualIsZero) {
    const Outcome outcome = run("diff dotted.png dotted.png");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "dotted.png, dotted.png: the same\n");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(run("diff - dotted.png <dotted.png >/dev/null").status, 0);
}

TEST_F(DiffCommand, ADifferenceIsOneAndIsShown) {
    const Outcome outcome = run("diff white.png dotted.png -o d.png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out,
              "white.png, dotted.png: 0.5 % of the pixels differ (5 of 1000), columns 0 to 8, rows 10 to 10\n");
    EXPECT_EQ(outcome.err, "");
    const render::Picture shown = picture("d.png");
    EXPECT_EQ(shown.width, 3 * 40 + 2 * 8);
    EXPECT_EQ(shown.height, 25);
}

TEST_F(DiffCommand, TheThresholdIsAShareOfThePixels) {
    EXPECT_EQ(run("diff white.png dotted.png --threshold 0.005").status, 0);
    EXPECT_EQ(run("diff white.png dotted.png --threshold 0.5%").status, 0);
    EXPECT_EQ(run("diff white.png dotted.png --threshold 0.0049").status, 1);
    EXPECT_EQ(run("diff white.png dotted.png --threshold 0.49%").status, 1);
    EXPECT_EQ(run("diff white.png dotted.png --tolerance 1").status, 0);
}

TEST_F(DiffCommand, OtherSizesAreADifferenceWhateverTheThreshold) {
    const Outcome outcome = run("diff white.png narrow.png --threshold 1 -o d.png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(
        lines_are(outcome.out, "white.png, narrow.png: 40 × 25 pixels became 20 × 25; 50 % of the pixels differ.*"));
    EXPECT_EQ(picture("d.png").width, 3 * 40 + 2 * 8);
}

TEST_F(DiffCommand, WhatIsNoPictureIsTwoAndLeavesNothing) {
    const auto before = snapshot();
    const std::array<std::pair<const char*, const char*>, 13> rows{{
        {"diff", "kinegraph: EXPECTED is required.*"},
        {"diff white.png", "kinegraph: ACTUAL is required.*"},
        {"diff white.png absent.png -o d.png", "absent.png: cannot be read: No such file or directory"},
        {"diff white.png . -o d.png", ".: is a directory, not a picture"},
        {"diff white.png four_bar.json -o d.png", "four_bar.json: is neither PNG nor SVG"},
        {"diff white.png /dev/null -o d.png", "/dev/null: is neither PNG nor SVG"},
        {"diff broken.png white.png -o d.png", "broken.png: is no PNG that can be read: .*"},
        {"diff - -", "kinegraph: standard input can be one .*"},
        {"diff white.png dotted.png -o -", "kinegraph: the difference picture needs a file.*"},
        {"diff white.png dotted.png -o white.png", "kinegraph: -o white.png would overwrite .*"},
        {"diff white.png dotted.png -o d.svg", "kinegraph: -o d.svg: the difference picture is a PNG; .*"},
        {"diff white.png dotted.png --threshold 2", "kinegraph: --threshold.*is not a share.*"},
        {"diff white.png dotted.png --tolerance nan", "kinegraph: --tolerance.*is not a number from 0 to 1.*"},
    }};
    for (const auto& [arguments, said] : rows) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(lines_are(outcome.err, said)) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(changed_since(before), "") << arguments;
    }
}

TEST_F(DiffCommand, WhatCannotBeWrittenIsFour) {
    const Outcome outcome = run("diff white.png dotted.png -o absent/d.png");
    EXPECT_EQ(outcome.status, 4);
    EXPECT_TRUE(lines_are(outcome.err, "absent/d.png: cannot be written: .*"));
    EXPECT_EQ(outcome.out, "");
}

TEST_F(DiffCommand, WithoutRsvgConvertAnSvgIsFourAndNamesThePackage) {
    const Outcome outcome = run("diff square.svg square.svg -o d.png", "PATH=/nowhere");
    EXPECT_EQ(outcome.status, 4);
    EXPECT_TRUE(lines_are(outcome.err, "square.svg: .*install the Debian package librsvg2-bin"));
    EXPECT_FALSE(is_there("d.png"));
    EXPECT_EQ(run("diff white.png white.png", "PATH=/nowhere").status, 0);
}

TEST_F(DiffCommand, SvgsAreDrawnAndCompared) {
    if (!draws_svg()) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
    EXPECT_EQ(run("diff square.svg square.svg").out, "square.svg, square.svg: the same\n");
    const Outcome outcome = run("diff square.svg shorter.svg -o d.png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(
        outcome.out,
        "square.svg, shorter.svg: 5 % of the pixels differ (1125 of 22500), columns 30 to 104, rows 105 to 119\n");
    EXPECT_EQ(picture("d.png").height, 150);
    EXPECT_EQ(run("diff square.svg square.svg -o d.png --dpi 300").status, 0);
    EXPECT_EQ(picture("d.png").height, 300);
}

TEST_F(DiffCommand, AnSvgIsDrawnAtThePngsResolution) {
    if (!draws_svg()) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
    ASSERT_EQ(run("solve four_bar.json -o a.svg -o a.png --dpi 96").status, 0);
    const Outcome outcome = run("diff a.svg a.png --threshold 0.01%");
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("pixels became"), std::string::npos) << outcome.out;
}

TEST_F(DiffCommand, HostileSvgsAreRefused) {
    if (!draws_svg()) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
    const std::string begin = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" ";
    // Each group draws the one before ten times: ten to the eleventh rectangles, if one let it.
    std::string doubling = begin + "width=\"10\" height=\"10\"><rect id=\"g0\" width=\"1\" height=\"1\"/>";
    for (int i = 1; i < 12; ++i) {
        doubling += "<g id=\"g" + std::to_string(i) + "\">";
        for (int k = 0; k < 10; ++k) doubling += "<use xlink:href=\"#g" + std::to_string(i - 1) + "\"/>";
        doubling += "</g>";
    }
    for (const std::string& text :
         {std::string("<svg"), std::string("<html/>"), begin + "width=\"1e9\" height=\"1e9\"/>",
          begin + "width=\"0\" height=\"0\"/>", doubling + "</svg>"}) {
        write("hostile.svg", text);
        const Outcome outcome = run("diff square.svg hostile.svg -o d.png");
        EXPECT_EQ(outcome.status, 2) << text.substr(0, 200);
        EXPECT_TRUE(lines_are(outcome.err, "hostile.svg: (is no SVG that can be drawn: |drawn at 150 dpi ).*"));
        EXPECT_FALSE(is_there("d.png"));
    }
    // A file beside it is not read.
    write("hostile.svg",
          begin +
              "width=\"25.4mm\" height=\"25.4mm\"><image width=\"96\" height=\"96\" xlink:href=\"dotted.png\"/></svg>");
    write("empty.svg", begin + "width=\"25.4mm\" height=\"25.4mm\"></svg>");
    EXPECT_EQ(run("diff empty.svg hostile.svg").status, 0);
}

}  // namespace
}  // namespace diff_test
