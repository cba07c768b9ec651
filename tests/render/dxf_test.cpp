// DXF: pairs of codes and values, a frame that has all it names, and the display list of the page as entities.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>

#include "render/backends/backends.hpp"
#include "render/backends/dxf_document.hpp"
#include "render/backends/live_text.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/figure_alone.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace dxf_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

struct Pair {
    int code;
    std::string value;
};
/// An entity or another record, with its pairs behind the first.
struct Record {
    std::string type;
    std::vector<Pair> pairs;
    std::string of(int code) const {
        for (const Pair& pair : pairs)
            if (pair.code == code) return pair.value;
        return {};
    }
    double number(int code) const { return std::stod(of(code)); }
    Spot spot(int code) const { return {number(code), number(code + 10)}; }
};

/// The records by section.
std::map<std::string, std::vector<Record>> read(const std::string& text) {
    std::map<std::string, std::vector<Record>> sections;
    std::istringstream lines(text);
    std::string code, value, section;
    while (std::getline(lines, code)) {
        EXPECT_TRUE(static_cast<bool>(std::getline(lines, value))) << "a code has a value";
        const int number = std::stoi(code);
        if (number == 0) sections[section].push_back({value, {}});
        if (number == 2 && sections[section].back().type == "SECTION") {
            section = value;
            continue;
        }
        if (number != 0 && !sections[section].empty()) sections[section].back().pairs.push_back({number, value});
    }
    return sections;
}
std::vector<Record> entities_of(const std::string& text) {
    std::vector<Record> all = read(text)["ENTITIES"];
    std::erase_if(all, [](const Record& each) { return each.type == "ENDSEC" || each.type == "SECTION"; });
    return all;
}
std::string alone(const Page& page) { return to_dxf({&page, 1}, fonts()).front(); }
std::vector<Record> entities_of(const Path& path) {
    Page page;
    page.width = 100;
    page.height = 50;
    page.marks.emplace_back(path);
    return entities_of(alone(page));
}

Pen pen(double width = 0.35) { return {width, {0xC8, 0x40, 0x0F}, {}, false}; }

TEST(Dxf, AnArcRunsTheSameWayUpwards) {
    const double quarter = std::numbers::pi / 2;
    // From the right down to the bottom, clockwise on paper.
    const auto found = entities_of(arc({40, 20}, 10, 0, quarter, pen()));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].type, "ARC");
    EXPECT_EQ(found[0].spot(10), (Spot{40, 30}));
    EXPECT_EQ(found[0].number(40), 10);
    EXPECT_EQ(found[0].number(50), 270);
    EXPECT_EQ(found[0].number(51), 0);
    const auto whole = entities_of(circle({40, 20}, 10, pen()));
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].type, "CIRCLE");
    EXPECT_EQ(whole[0].spot(10), (Spot{40, 30}));
}

TEST(Dxf, LinesPolylinesAndTheirLooks) {
    const auto straight = entities_of(line({1, 2}, {3, 4}, pen()));
    ASSERT_EQ(straight.size(), 1U);
    EXPECT_EQ(straight[0].type, "LINE");
    EXPECT_EQ(straight[0].spot(10), (Spot{1, 48}));
    EXPECT_EQ(straight[0].spot(11), (Spot{3, 46}));
    EXPECT_EQ(straight[0].of(370), "35");
    EXPECT_EQ(straight[0].of(420), std::to_string(0xC8400F));
    const auto corners = entities_of(polyline({{0, 0}, {10, 0}, {10, 10}}, pen(), true));
    ASSERT_EQ(corners.size(), 1U);
    EXPECT_EQ(corners[0].type, "LWPOLYLINE");
    EXPECT_EQ(corners[0].of(90), "3");
    EXPECT_EQ(corners[0].of(70), "1");
}

TEST(Dxf, APolylineWithArcsHasTheirBulges) {
    Path path;
    path.stroked = true;
    path.pen = pen();
    // A slot: two lines, and two half circles that turn clockwise on paper.
    const double half = std::numbers::pi / 2;
    path.segments = {MoveTo{{10, 10}}, LineTo{{30, 10}}, ArcTo{{30, 15}, 5, -half, half}, LineTo{{10, 20}},
                     ArcTo{{10, 15}, 5, half, 3 * half}};
    const auto found = entities_of(path);
    ASSERT_EQ(found.size(), 1U);
    ASSERT_EQ(found[0].type, "LWPOLYLINE");
    double turned = 0;
    for (const Pair& pair : found[0].pairs)
        if (pair.code == 42) turned += 4 * std::atan(std::stod(pair.value));
    EXPECT_NEAR(turned, -2 * std::numbers::pi, 1e-7) << "clockwise is negative";
    EXPECT_EQ(found[0].of(70), "1") << "closed";
}

TEST(Dxf, ACurveIsWithinItsTolerance) {
    Path path;
    path.stroked = true;
    path.pen = pen();
    // A quarter of a circle of 40 mm, within 11 µm of it.
    constexpr double k = 0.5522847498 * 40;
    path.segments = {MoveTo{{50, 10}}, CurveTo{{50, 10 + k}, {10 + k, 50}, {10, 50}}};
    const auto found = entities_of(path);
    ASSERT_EQ(found.size(), 1U);
    std::vector<Spot> spots;
    for (std::size_t i = 0; i + 1 < found[0].pairs.size(); ++i)
        if (found[0].pairs[i].code == 10)
            spots.push_back({std::stod(found[0].pairs[i].value), std::stod(found[0].pairs[i + 1].value)});
    ASSERT_GT(spots.size(), 5U);
    for (std::size_t i = 0; i + 1 < spots.size(); ++i)
        EXPECT_NEAR(length(0.5 * (spots[i] + spots[i + 1]) - Spot{10, 40}), 40, 0.017);
}

TEST(Dxf, DashesOfOneKindAreOneKindOfLine) {
    DxfDocument document(100, 100);
    const DxfLineKind once = document.line_kind({2, 1}), twice = document.line_kind({4, 2}),
                      other = document.line_kind({4, 1}), chain = document.line_kind({6, 1, 0.5, 1});
    EXPECT_EQ(once.name, "DASHED");
    EXPECT_EQ(twice.name, once.name);
    EXPECT_DOUBLE_EQ(twice.scale, 2);
    EXPECT_EQ(other.name, "DASHED-2");
    EXPECT_EQ(chain.name, "DASHDOT");
}

TEST(Dxf, ColoursAndWidthsAreTheNearest) {
    EXPECT_EQ(colour_index({255, 0, 0}), 10);
    EXPECT_EQ(colour_index({0, 0, 255}), 170);
    EXPECT_EQ(colour_index({0, 255, 0}), 90);
    EXPECT_EQ(colour_index({132, 132, 132}), 252);
    EXPECT_EQ(line_weight(0.18), 18);
    EXPECT_EQ(line_weight(2), 200);
    EXPECT_EQ(line_weight(0.69), 70);
    EXPECT_EQ(line_weight(5), 211);
}

TEST(Dxf, NamesOfAnyFileAreText) {
    EXPECT_EQ(dxf_text("a%%cb"), "a%%037%%037cb");
    EXPECT_EQ(dxf_text("50%"), "50%");
    EXPECT_EQ(dxf_text("a\\Pb^J\n"), "a\\U+005CPb^ J ");
    EXPECT_EQ(dxf_text("ω 漢"), "ω 漢");
}

void expect_whole_frame(const std::string& text) {
    auto sections = read(text);
    std::set<std::string> layers, kinds{"ByLayer", "ByBlock", "Continuous"}, styles, handles;
    for (const auto& [name, records] : sections)
        for (const Record& record : records) {
            const std::string handle = record.of(record.type == "DIMSTYLE" ? 105 : 5);
            if (handle.empty() || name == "HEADER") continue;
            EXPECT_TRUE(handles.insert(handle).second) << record.type << " " << handle;
        }
    for (const Record& record : sections["TABLES"]) {
        if (record.type == "LAYER") layers.insert(record.of(2));
        if (record.type == "LTYPE") kinds.insert(record.of(2));
        if (record.type == "STYLE") styles.insert(record.of(2));
    }
    for (const Record& entity : sections["ENTITIES"]) {
        if (entity.type == "SECTION" || entity.type == "ENDSEC") continue;
        EXPECT_TRUE(layers.contains(entity.of(8))) << entity.of(8);
        EXPECT_TRUE(entity.of(6).empty() || kinds.contains(entity.of(6))) << entity.of(6);
        EXPECT_TRUE(entity.type != "TEXT" || styles.contains(entity.of(7)));
        EXPECT_EQ(entity.of(330), "20") << "it belongs to the model space";
    }
    EXPECT_GT(layers.size(), 3U);
}

/// What a page draws, counted in its display list.
struct Counted {
    std::size_t circles = 0, fillings = 0, axes = 0;
};
Counted counted(const Page& page) {
    Counted all;
    const auto take = [&](const Path& path) {
        std::size_t arcs = 0, others = 0;
        double sweep = 0;
        for (const render::Segment& segment : path.segments) {
            if (const auto* one = std::get_if<ArcTo>(&segment)) {
                ++arcs;
                sweep = std::abs(one->to - one->from);
            } else if (std::holds_alternative<LineTo>(segment) || std::holds_alternative<CurveTo>(segment)) {
                ++others;
            }
        }
        const bool whole = arcs == 1 && others == 0 && sweep > 2 * std::numbers::pi - 1e-9;
        all.circles += whole && path.stroked;
        all.fillings += path.filled;
    };
    for (const Mark& mark : page.marks) {
        if (const auto* path = std::get_if<Path>(&mark)) take(*path);
        all.axes += std::holds_alternative<Axis>(mark);
    }
    return all;
}

/// ASCII letters and signs; others may be drawn.
std::string letters_of(const std::string& text) {
    std::string letters;
    for (const char c : text)
        if (c > ' ' && c < 0x7F && c != '_' && c != '^') letters += c;
    return letters;
}

class DxfOfExamples : public testing::TestWithParam<std::string> {};

TEST_P(DxfOfExamples, HasWhatThePageHas) {
    for (const Page& page : laid_out(GetParam())) {
        const std::string text = alone(page);
        EXPECT_EQ(text, alone(page));
        expect_whole_frame(text);
        std::map<std::string, std::size_t> types;
        std::map<std::string, std::size_t> letters, wanted;
        std::size_t axes = 0, fillings = 0;
        for (const Record& entity : entities_of(text)) {
            ++types[entity.type];
            axes += entity.of(8) == "axes";
            const bool is_of_words = entity.of(8) == "labels" || entity.of(8) == "text";
            fillings += entity.type == "HATCH" && !is_of_words;
            if (entity.type == "TEXT")
                for (const char c : letters_of(entity.of(1))) ++letters[std::string(1, c)];
        }
        const Counted counts = counted(page);
        EXPECT_EQ(types["CIRCLE"], counts.circles);
        EXPECT_EQ(fillings, counts.fillings);
        EXPECT_EQ(axes, counts.axes);
        // Dots over letters are drawn, not written; all else that is read is there.
        for (std::size_t i = 0; i < page.marks.size(); ++i) {
            if (!std::holds_alternative<TextMark>(page.marks[i])) continue;
            const LiveLine line = live_line(std::span(page.marks).subspan(i));
            for (const LiveRun& run : line.runs)
                if (run.kind == LiveRun::Kind::set)
                    for (const char c : letters_of(run.text)) ++wanted[std::string(1, c)];
            i += line.marks.size() - 1;
        }
        EXPECT_EQ(letters, wanted);
        EXPECT_GT(types["TEXT"], 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, DxfOfExamples,
                         testing::Values("four_bar", "slider_crank", "planetary_train", "contact/ball_on_plane",
                                         "gas_force", "sluice_gate"),
                         [](const testing::TestParamInfo<std::string>& each) {
                             std::string name = each.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

TEST(DxfOfTheFourBar, AVectorsAxisIsItsLength) {
    const auto page = lay_out_alone(example("four_bar"), {}, "velocity", fonts());
    ASSERT_TRUE(page);
    std::size_t axes = 0, compared = 0;
    double scale = 0;
    for (const Mark& mark : page->marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "figure")
            scale = std::stod(*group->attribute("data-scale"));
    ASSERT_GT(scale, 0);
    for (const Record& entity : entities_of(alone(*page))) {
        if (entity.of(8) != "axes") continue;
        ++axes;
        if (entity.of(1000) != "velocity-v_B") continue;
        for (const Mark& mark : page->marks) {
            const auto* group = std::get_if<GroupBegin>(&mark);
            if (group == nullptr || group->id.text() != "velocity-v_B") continue;
            EXPECT_NEAR(length(entity.spot(11) - entity.spot(10)) * scale, std::stod(*group->attribute("data-value")),
                        1e-7);
            ++compared;
        }
    }
    EXPECT_EQ(axes, 3U);
    EXPECT_EQ(compared, 1U);
}

class DxfFiles : public tests::CommandLine {};

TEST_F(DxfFiles, EveryCommandThatDrawsWritesIt) {
    EXPECT_EQ(run("solve four_bar.json -o a.dxf --steps").status, 0);
    EXPECT_TRUE(is_there("a-2.dxf"));
    EXPECT_EQ(run("sweep four_bar.json -o b.dxf --steps 4").status, 0);
    EXPECT_EQ(run("solve four_bar.json -o - --format dxf >c.dxf").status, 0);
    EXPECT_EQ(run("pairs -o d.dxf").status, 0);
    write("lines", R"({"file": "four_bar.json", "want": ["dxf"], "to": "e"})"
                   "\n");
    EXPECT_EQ(run("batch <lines").status, 0);
    for (const char* name : {"a.dxf", "b.dxf", "c.dxf", "d.dxf", "e.dxf"})
        expect_whole_frame(tests::contents(folder_ / name));
}

}  // namespace
}  // namespace dxf_test
