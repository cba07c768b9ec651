// The SVG as others draw it is the picture that we draw: rsvg-convert on first pages of every kind of figure, a browser
// on a few where there is one. With KINEGRAPH_ALL_EXAMPLES set, rsvg-convert on every page of every example.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/picture_difference.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/fonts.hpp"

namespace agreement_test {
namespace {

using kinegraph::Language;

using namespace kinegraph::render;
using kinegraph::tests::contents;
using kinegraph::tests::fonts;
namespace fs = std::filesystem;

constexpr double dpi = 150;
constexpr int far_off = 32;           // of 255, in a channel
constexpr double may_differ = 0.007;  // of the pixels: 0.5 % of sheets that are half empty, 0.6 % of full ones

/// The share of pixels of which a channel differs by more than `far_off`; those that only one picture has are such.
double share_far_off(const Picture& a, const Picture& b) {
    std::size_t count = 0;
    const int width = std::max(a.width, b.width), height = std::max(a.height, b.height);
    const auto off = [](std::uint8_t x, std::uint8_t y) { return std::abs(x - y) > far_off; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (x >= a.width || x >= b.width || y >= a.height || y >= b.height) {
                ++count;
                continue;
            }
            const Colour p = a.at(x, y), q = b.at(x, y);
            if (off(p.red, q.red) || off(p.green, q.green) || off(p.blue, q.blue)) ++count;
        }
    return static_cast<double>(count) / (static_cast<double>(width) * height);
}

/// The top left of a picture.
Picture cut(const Picture& from, int width, int height) {
    Picture part;
    part.width = std::min(width, from.width);
    part.height = std::min(height, from.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) part.pixels.push_back(from.at(x, y));
    return part;
}

std::vector<Page> sheet(const fs::path& file) {
    auto mechanism = kinegraph::read_mechanism(contents(file), file.filename().string());
    return lay_out(kinegraph::solve(std::move(mechanism).value()).value(), {}, fonts());
}

fs::path example(const std::string& name) { return fs::path(KINEGRAPH_EXAMPLES_DIR) / (name + ".json"); }

/// Each for what it draws: plain polygons, line kinds of many bodies, Coriolis terms and forces, slots, teeth, cams,
/// rolling, force triangles, free bodies of parallel forces, an instantaneous motion, centres at infinity, hatching and
/// cylinders.
std::vector<fs::path> chosen_examples() {
    std::vector<fs::path> files;
    for (const char* name :
         {"four_bar", "jansen_leg", "exam_2001", "whitworth", "planetary_train", "cam_roller_follower", "disc_in_ring",
          "pliers", "three_parallel_forces", "act_of_motion_general", "oldham_coupling", "tipper"})
        files.push_back(example(name));
    return files;
}

std::vector<fs::path> all_examples() { return kinegraph::tests::json_files(KINEGRAPH_EXAMPLES_DIR); }

/// Draws `page.svg` to `page.png` of a folder by a shell's command, page by page, and returns the worst share met.
class Agreement : public ::testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "kinegraph-agreement-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    static bool is_there(const std::string& program) {
        return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
    }

    /// `window`: the command draws a window that may be larger than the page, which stands at its top left.
    void compare(const Page& page, const std::string& command, const std::string& what, bool window = false) {
        std::ofstream(folder_ / "page.svg", std::ios::binary) << to_svg(page, fonts());
        ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && " + command + " 2>said >/dev/null").c_str()), 0)
            << what << ": " << contents(folder_ / "said");
        const auto theirs = decode_png(contents(folder_ / "page.png"));
        ASSERT_TRUE(theirs) << what << ": " << theirs.error().in(Language::en);
        const Picture ours = decode_png(to_png(page, fonts(), dpi)).value();
        const double share = share_far_off(ours, window ? cut(*theirs, ours.width, ours.height) : *theirs);
        EXPECT_LE(share, may_differ) << what;
        if (share >= worst_) {
            worst_ = share;
            where_ = what;
        }
        ++pages_;
    }
    /// Printed where the test is run by hand, and kept in its report.
    void tell() const {
        EXPECT_GT(pages_, 0);
        std::ostringstream line;
        line << pages_ << " pages, worst " << 100 * worst_ << " % (" << where_ << ")";
        RecordProperty("agreement", line.str());
        std::cout << line.str() << '\n';
    }

    fs::path folder_;
    double worst_ = 0;
    std::string where_;
    int pages_ = 0;
};

TEST_F(Agreement, WithRsvgConvert) {
    if (!is_there("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
    const bool all = std::getenv("KINEGRAPH_ALL_EXAMPLES") != nullptr;
    for (const fs::path& file : all ? all_examples() : chosen_examples()) {
        const std::vector<Page> pages = sheet(file);
        for (std::size_t i = 0; i < (all ? pages.size() : 1); ++i)
            compare(pages[i], "rsvg-convert --dpi-x 150 --dpi-y 150 --output page.png page.svg",
                    file.stem().string() + ", page " + std::to_string(i + 1));
    }
    tell();
}

TEST_F(Agreement, WithAWebBrowser) {
    std::string browser;
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (browser.empty() && is_there(name)) browser = name;
    if (browser.empty()) GTEST_SKIP() << "no Chromium here";
    for (const char* name : {"four_bar", "exam_2001", "jansen_leg"}) {
        const Page page = sheet(example(name)).front();
        // A window of the page's size in the browser's units, 96 an inch, each of them 150/96 dots.
        const auto units = [](double millimetres) {
            return std::to_string(std::lround(std::ceil(millimetres / 25.4 * 96)) + 1);
        };
        compare(page,
                browser +
                    " --headless --no-sandbox --disable-gpu --hide-scrollbars --force-device-scale-factor=1.5625" +
                    " --user-data-dir=profile --window-size=" + units(page.width) + ',' + units(page.height) +
                    " --screenshot=page.png \"file://$PWD/page.svg\"",
                name, true);
    }
    tell();
}

TEST_F(Agreement, InEveryTheme) {
    if (!is_there("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
    const auto solution =
        kinegraph::solve(kinegraph::read_mechanism(contents(example("watt_six_bar")), "watt_six_bar.json").value());
    for (const std::string_view name : theme_names()) {
        SheetOptions options;
        options.theme = built_in_theme(name).value();
        compare(lay_out(solution.value(), options, fonts()).front(),
                "rsvg-convert --dpi-x 150 --dpi-y 150 --output page.png page.svg", std::string(name));
    }
    tell();
}

TEST_F(Agreement, IsLostWhereTypeMovesByAMillimetre) {
    // The measure itself sees such a thing.
    std::vector<Page> pages = sheet(example("four_bar"));
    const Picture usual = decode_png(to_png(pages.front(), fonts(), dpi)).value();
    EXPECT_EQ(share_far_off(usual, usual), 0);
    for (Mark& mark : pages.front().marks)
        if (auto* text = std::get_if<TextMark>(&mark))
            for (Glyph& glyph : text->glyphs) glyph.origin.x += 1;
    EXPECT_GT(share_far_off(usual, decode_png(to_png(pages.front(), fonts(), dpi)).value()), may_differ);
}

}  // namespace
}  // namespace agreement_test
