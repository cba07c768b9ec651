// Polygon figures: what is measured on paper is the result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "render/content/wanted_figures.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/ink_map.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/tables.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace polygon_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

std::string attribute(const GroupBegin& group, const std::string& key) {
    const std::string* value = group.attribute(key);
    return value ? *value : "";
}

/// Every vector group with its axes and the figure, or detail of it, that it is drawn in.
struct VectorGroup {
    GroupBegin group;
    std::vector<Axis> axes;
    GroupBegin figure;
    double scale() const { return std::strtod(attribute(figure, "data-scale").c_str(), nullptr); }
    std::string name() const { return attribute(group, "data-name"); }
    bool in_detail() const { return attribute(figure, "data-figure") == "detail"; }
    double length() const { return render::length(axes.at(0).tip - axes.at(0).tail); }
};
std::vector<VectorGroup> vectors_of(const Figure& figure) {
    std::vector<VectorGroup> result;
    GroupBegin drawing;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            if (group->cls == "figure") drawing = *group;
            if (group->cls == "vector") result.push_back({*group, {}, drawing});
        }
        if (const auto* axis = std::get_if<Axis>(&mark)) result.back().axes.push_back(*axis);
    }
    return result;
}

/// Calls look(solution, index of the polygon, its figure) for those of all examples.
template <class Look>
void for_each_polygon_of_motion(Look look) {
    const Theme theme;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
            if (solution.protocol.polygons[p].plane != Plane::force)
                look(solution, p,
                     polygon_figure({solution, theme, fonts(), Language::en}, static_cast<int>(p), 150, 130));
    }
}

void expect_measures(const Figure& figure) {
    std::set<std::string> names, ids;
    for (const VectorGroup& each : vectors_of(figure)) {
        ASSERT_EQ(each.axes.size(), 1u) << each.group.id.text();
        const double value = std::strtod(attribute(each.group, "data-value").c_str(), nullptr);
        EXPECT_GT(value, 0);
        EXPECT_NEAR(each.length(), value / each.scale(), 1e-6) << each.group.id.text();
        EXPECT_TRUE(names.insert(each.figure.id.text() + " " + each.name()).second)
            << "twice: " << each.group.id.text();
        EXPECT_TRUE(ids.insert(each.group.id.text()).second);
        EXPECT_EQ(GroupId(each.group.id.figure, {}, each.group.id.detail), each.figure.id) << each.group.id.text();
    }
}

TEST(PolygonFigure, EveryAxisIsValueOverScaleOnEveryExample) {
    std::size_t vectors = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const Theme theme;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
            const Figure figure = polygon_figure(context, static_cast<int>(p), 150, 130);
            vectors += vectors_of(figure).size();
            expect_measures(figure);
        }
    }
    EXPECT_GT(vectors, example_names().size());
}

TEST(PolygonFigure, OfTheFourBarShowsItsVectors) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 0, 150, 100);
    std::set<std::string> names;
    for (const VectorGroup& each : vectors_of(figure)) names.insert(attribute(each.group, "data-name"));
    EXPECT_EQ(names, (std::set<std::string>{"v_A", "v_B", "v_BA"}));
    EXPECT_EQ(figure.data_figure, "velocity");
    EXPECT_EQ(figure.id, "velocity");
    EXPECT_EQ(figure.unit, "m/s");
    EXPECT_EQ(plain(figure.caption), "Velocity polygon");
    const auto* group = std::get_if<GroupBegin>(&figure.marks.front());
    ASSERT_NE(group, nullptr);
    EXPECT_EQ(attribute(*group, "data-figure"), "velocity");
    EXPECT_EQ(attribute(*group, "data-unit"), "m/s");
    EXPECT_TRUE(std::holds_alternative<GroupEnd>(figure.marks.back()));
}

TEST(PolygonFigure, KeepsToItsRoom) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    for (const double room : {60.0, 90.0, 140.0, 220.0})
        for (int p = 0; p < 2; ++p) {
            const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, p, room, 0.8 * room);
            EXPECT_LE(figure.box.width(), room) << room;
            EXPECT_LE(figure.box.height(), 0.8 * room) << room;
        }
}

TEST(PolygonFigure, TakesTheFilesUnitAndScale) {
    Solution solution = example("four_bar");
    solution.mechanism.units.velocity = {"mm/s", Exact::ratio(1, 1000)};
    solution.mechanism.scales.push_back({"velocity", Exact::ratio(1, 100), ""});  // 0.01 m/s = 10 mm/s
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    const WantedFigures wanted(context, false);
    const auto velocity = wanted.named({FigureKind::velocity_polygon, 0});
    ASSERT_TRUE(velocity);
    const Figure figure = wanted.draw_in(*velocity, {200, 150});
    EXPECT_EQ(figure.unit, "mm/s");
    EXPECT_DOUBLE_EQ(figure.scale, 10);
    expect_measures(figure);
}

TEST(PolygonFigure, ImagesAtThePoleStandWithIt) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 0, 150, 100);
    bool found = false;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) found = found || text->words == "o_v ≡ o_2 ≡ o_4";
    EXPECT_TRUE(found);
}

// --- details
// ---------------------------------------------------------------------------------------------------------------------

/// How often a label says each thing, "a_A_n = a_A" being two.
std::map<std::string, int> said_by_labels(const Figure& figure) {
    std::map<std::string, int> said;
    for (const Mark& mark : figure.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (!text || text->cls != "label") continue;
        std::string rest = text->words;
        for (std::size_t at; (at = rest.find(" = ")) != std::string::npos; rest.erase(0, at + 3))
            ++said[rest.substr(0, at)];
        ++said[rest];
    }
    return said;
}

TEST(PolygonDetail, IsLetteredOnFromThoseOfTheSheet) {
    const Solution& solution = example("stephenson_3_driver_6");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    Figure figure = polygon_figure(context, 1, 180, 130);
    const std::size_t count = figure.details.size();
    ASSERT_GT(count, 0u);
    letter_details_on(figure, context, 3);
    EXPECT_EQ(figure.details.size(), count);
    const auto read = measured_on(figure, "a_CD_n");
    ASSERT_TRUE(read.has_value());
    EXPECT_TRUE(read->detail == "IV" || read->detail == "V" || read->detail == "VI") << read->detail;
    int circles = 0, headings = 0;
    for (const Mark& mark : figure.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (!text) continue;
        EXPECT_TRUE(text->words != "I" && text->words != "Detail I");
        circles += text->words == "IV";
        headings += text->words == "Detail IV";
    }
    EXPECT_EQ(circles, 1);
    EXPECT_EQ(headings, 1);
    expect_measures(figure);
}

TEST(PolygonDetail, ShowsWhatIsTooShortBesideLongVectors) {
    const Solution& solution = example("stephenson_3_driver_6");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 1, 180, 130);
    std::map<std::string, double> in_polygon, in_detail;
    for (const VectorGroup& each : vectors_of(figure))
        (each.in_detail() ? in_detail : in_polygon)[each.name()] = each.length();
    for (const char* name : {"a_D", "a_D_n", "a_CD_n", "a_CS_n"}) {
        ASSERT_TRUE(in_polygon.count(name) && in_detail.count(name)) << name;
        EXPECT_LT(in_polygon[name], 4.6) << name;
        EXPECT_GT(in_detail[name], 4.6) << name;
    }
    EXPECT_EQ(in_detail.count("a_A"), 0u) << "long enough where it is";
    EXPECT_LE(figure.box.width(), 180);
    EXPECT_LE(figure.box.height(), 130);
}

TEST(PolygonDetail, NamesEveryVectorOnceOnEveryExample) {
    std::size_t named = 0;
    for_each_polygon_of_motion([&](const Solution& solution, std::size_t p, const Figure& figure) {
        const auto said = said_by_labels(figure);
        const auto sketches = polygon_scene(solution, static_cast<int>(p)).coriolis;
        std::map<std::string, std::set<std::pair<ElementIndex, ElementIndex>>>
            places;  // a velocity may be drawn in two
        for (const int v : solution.protocol.polygons[p].vectors) {
            const DrawnVector& vector = solution.protocol.vectors[static_cast<std::size_t>(v)];
            places[plain(typeset(vector.symbol, Language::en))].emplace(vector.tail, vector.tip);
        }
        for (const auto& [vector, where] : places)
            if (const auto found = said.find(vector); found != said.end()) {
                // Once more in the sketch that says why the Coriolis term points where it does.
                const bool sketched =
                    std::any_of(sketches.begin(), sketches.end(), [&, vector = vector](const SceneCoriolis& sketch) {
                        return plain(typeset(sketch.coriolis, Language::en)) == vector;
                    });
                EXPECT_GE(found->second, static_cast<int>(where.size())) << vector;
                EXPECT_LE(found->second, static_cast<int>(where.size()) + (sketched ? 1 : 0)) << vector;
                ++named;
            }
    });
    EXPECT_GT(named, example_names().size());
}

TEST(PolygonDetail, HasTheScaleOfTheNextSteps) {
    const Solution& solution = example("jansen_leg");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 1, 180, 130);
    int details = 0;
    for (const Mark& mark : figure.marks) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (!group || group->cls != "figure" || attribute(*group, "data-figure") != "detail") continue;
        ++details;
        const double scale = std::strtod(attribute(*group, "data-scale").c_str(), nullptr);
        EXPECT_DOUBLE_EQ(scale, choose_scale(scale, 0, 1, 1, std::nullopt)) << "1-2-2.5-5";
        EXPECT_LE(scale, figure.scale / 2.5);
    }
    EXPECT_EQ(details, 2);
}

TEST(PolygonDetail, IsReadForTheResults) {
    const Solution& solution = example("stephenson_3_driver_6");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    const Figure figure = polygon_figure(context, 1, 180, 130);
    std::map<std::string, ResultRow> rows;
    for (const ResultRow& row : result_rows(context, {figure})) rows[row.name] = row;
    EXPECT_EQ(rows.at("a_CD_n").detail, "I");
    EXPECT_EQ(rows.at("a_CS_n").detail, "II");
    EXPECT_EQ(rows.at("a_A").detail, "");
    for (const VectorGroup& each : vectors_of(figure))
        if (each.in_detail() && each.name() == "a_CD_n") {
            EXPECT_NEAR(*rows.at("a_CD_n").millimetres, each.length(), 1e-9);
        }
}

PolygonVector vector_of(const std::string& name, Spot tail, Spot tip) {
    PolygonVector vector;
    vector.tail = tail;
    vector.tip = tip;
    vector.name = name;
    vector.value = length(tip - tail);
    return vector;
}

TEST(PolygonDetail, OfNothingWhereAllIsShort) {
    PolygonParts parts;
    parts.vectors = {vector_of("v_A", {0, 0}, {4, 0}), vector_of("v_B", {0, 0}, {0, 3})};
    std::size_t letters = 0;
    EXPECT_TRUE(details_of(parts, 1, 1, letters).empty());
    parts.vectors.push_back(vector_of("v_C", {0, 0}, {80, 0}));
    EXPECT_EQ(details_of(parts, 1, 1, letters).size(), 1u) << "neighbours share one";
    EXPECT_EQ(letters, 1u);
}

TEST(PolygonDetail, StandsApartFromAnother) {
    PolygonParts parts;
    for (int i = 0; i < 12; ++i)
        parts.vectors.push_back(vector_of("v_" + std::to_string(i), {6.0 * i, 0}, {6.0 * i + 1, 0.5 * (i % 3)}));
    parts.vectors.push_back(vector_of("v_long", {0, 0}, {0, 90}));
    std::size_t letters = 0;
    const std::vector<Detail> details = details_of(parts, 1, 1, letters);
    ASSERT_FALSE(details.empty());
    for (std::size_t i = 0; i < details.size(); ++i)
        for (std::size_t j = i + 1; j < details.size(); ++j)
            EXPECT_GT(length(details[i].centre - details[j].centre), details[i].radius + details[j].radius);
}

/// A figure of the parts with its details, which share its group's kind.
Figure drawn_with_details(const DrawingContext& context, PolygonParts& parts, const std::string& kind,
                          const std::string& unit) {
    Figure figure;
    figure.id = kind;
    figure.unit = unit;
    figure.marks.emplace_back(
        GroupBegin{"figure", GroupId(kind), "", {{"data-figure", kind}, {"data-scale", "1"}, {"data-unit", unit}}});
    set_side_by_side(parts);
    std::size_t letters = 0;
    const std::vector<Detail> details = details_of(parts, 1, 1, letters);
    EXPECT_EQ(details.size(), 1u);
    draw_parts(figure, context, parts, details);
    place_labels(figure, fonts());
    figure.marks.emplace_back(GroupEnd{});
    set_details(figure, context, parts, details, {200, 150}, letters);
    return figure;
}

TEST(PolygonDetail, OfADetailIsDrawnOnceMore) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    PolygonParts parts;
    parts.vectors = {vector_of("v_A", {0, 0}, {100, 0}), vector_of("v_B", {0, 0}, {0, -4}),
                     vector_of("v_C", {0, -4}, {0.1, -4})};
    const Figure figure = drawn_with_details(context, parts, "velocity", "m/s");
    std::map<std::string, std::set<std::string>> drawn_in;
    std::map<std::string, double> longest;
    for (const VectorGroup& each : vectors_of(figure)) {
        drawn_in[each.name()].insert(each.figure.id.text());
        longest[each.name()] = std::max(longest[each.name()], each.length());
    }
    EXPECT_EQ(drawn_in["v_A"], (std::set<std::string>{"velocity"}));
    EXPECT_EQ(drawn_in["v_B"], (std::set<std::string>{"velocity", "velocity-detail-I"}));
    EXPECT_EQ(drawn_in["v_C"], (std::set<std::string>{"velocity", "velocity-detail-I", "velocity-detail-II"}));
    EXPECT_GT(longest["v_C"], 4.6);
    expect_measures(figure);
}

/// A stroke from the corner that a detail shows is the same there as in the figure: the last of those that coincide
/// that covers the others.
TEST(PolygonDetail, HasEachSideInTheLineKindOfTheFigure) {
    const Theme theme;
    const DrawingContext context{example("four_bar"), theme, fonts(), Language::en};
    for (const bool external_is_last : {false, true}) {
        PolygonParts parts;
        parts.opposites_share_label = true;
        PolygonVector inner = vector_of("F_34", {80, 0}, {0, 30}), outer = vector_of("F_12", {0, 30}, {80, 0});
        inner.internal = true;
        inner.colour = theme.colour_of(BodyIndex(4));
        outer.colour = theme.colour_of(BodyIndex(2));
        parts.vectors = {external_is_last ? inner : outer, external_is_last ? outer : inner,
                         vector_of("F_16", {80, 0}, {80, -1})};
        const Figure figure = drawn_with_details(context, parts, "forces", "N");
        int dashed = 0, whole = 0;
        for (const Mark& mark : figure.marks)
            if (const auto* path = std::get_if<Path>(&mark); path != nullptr && path->stroked) {
                dashed += path->pen.colour == inner.colour.line && !path->pen.dashes.empty() ? 1 : 0;
                whole += path->pen.colour == outer.colour.line && path->pen.dashes.empty() ? 1 : 0;
            }
        // Under the arrow a dashed line may be; in the detail it would be the only one.
        EXPECT_EQ(whole, 2) << "in the figure and in the detail";
        EXPECT_LE(dashed, 1);
    }
}

/// What stands beside a vector stands beside it in the detail, too.
TEST(PolygonDetail, HasAsideWhatIsAsideInTheFigure) {
    const Theme theme;
    const DrawingContext context{example("four_bar"), theme, fonts(), Language::en};
    PolygonParts parts;
    parts.vectors = {vector_of("F_g", {0, 80}, {0, 0}), vector_of("F_H", {0, 0}, {0, 2}),
                     vector_of("F_s", {0, 2}, {60, 80})};
    const Figure figure = drawn_with_details(context, parts, "forces", "N");
    std::map<bool, std::set<double>> upright;  // where the shafts of F_g and F_H stand; in the detail: true
    bool in_detail = false;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark); group != nullptr && group->cls == "figure")
            in_detail = attribute(*group, "data-figure") == "detail";
        const auto* path = std::get_if<Path>(&mark);
        if (path == nullptr || !path->stroked || path->pen.width != theme.vector) continue;
        const Spot from = std::get<MoveTo>(path->segments[0]).to, to = std::get<LineTo>(path->segments[1]).to;
        if (std::abs(to.x - from.x) < 1e-9) upright[in_detail].insert(from.x);
    }
    // The short one has no shaft in the figure.
    ASSERT_EQ(upright[true].size(), 2U);
    EXPECT_NEAR(*upright[true].rbegin() - *upright[true].begin(), std::abs(parts.vectors[1].aside.x), 1e-9);
    EXPECT_GT(std::abs(parts.vectors[1].aside.x), 1);
}

// --- construction
// ----------------------------------------------------------------------------------------------------------------

/// Straight thin lines of a figure.
std::vector<std::pair<Spot, Spot>> thin_lines(const Figure& figure, const Theme& theme) {
    std::vector<std::pair<Spot, Spot>> lines;
    for (const Mark& mark : figure.marks) {
        const auto* path = std::get_if<Path>(&mark);
        if (!path || !path->stroked || path->filled || path->pen.width != theme.thin || path->segments.size() != 2)
            continue;
        if (const auto* to = std::get_if<LineTo>(&path->segments[1]))
            lines.emplace_back(std::get<MoveTo>(path->segments[0]).to, to->to);
    }
    return lines;
}

TEST(PolygonConstruction, LinesAreSeenToCrossInTheTipThatTheyFind) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    for (int p = 0; p < 2; ++p) {
        const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, p, 150, 100);
        Spot b;
        for (const VectorGroup& each : vectors_of(figure))
            if (each.name() == (p == 0 ? "v_B" : "a_B")) b = each.axes[0].tip;
        int through = 0;
        for (const auto& [from, to] : thin_lines(figure, theme)) {
            const Spot along = unit(to - from);
            if (std::abs(cross(along, b - from)) > 1e-6) continue;
            ++through;
            EXPECT_GT(dot(b - from, along), 3);
            EXPECT_GT(dot(to - b, along), 3);
        }
        EXPECT_EQ(through, 2);
    }
}

/// As a′b′ with p′ on it, where no vector runs from the one to the other; a closed figure of more points has its tint.
// In words the directions of a small polygon would take as much room as its vectors. Only where the steps stand beside
// it do they say which line has which number.
TEST(PolygonConstruction, OfASmallOneTheStepsSayTheDirectionsOfNumberedLines) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    const auto said_of_first_line = [](const Figure& figure) -> std::string {
        const std::string number = "①";
        for (const Mark& mark : figure.marks)
            if (const auto* text = std::get_if<TextMark>(&mark); text && text->words.starts_with(number))
                return text->words == number ? number : number + " in words";
        return "";
    };
    const double longest = polygon_scene(solution, 0).longest;
    for (const double size : {30.0, 49.0, 51.0, 80.0}) {
        SCOPED_TRACE(size);
        ScaleWish wish{.finest = longest / size, .exactly = true};
        const Figure in_words = polygon_figure(context, 0, 200, 200, wish);
        wish.has_steps = true;
        const Figure beside_steps = polygon_figure(context, 0, 200, 200, wish);
        EXPECT_EQ(said_of_first_line(in_words), "① in words");
        EXPECT_EQ(said_of_first_line(beside_steps), size < 50 ? "①" : "① in words");
        if (size < 50)
            EXPECT_LT(beside_steps.box.width() * beside_steps.box.height(),
                      0.9 * in_words.box.width() * in_words.box.height());
        else
            EXPECT_EQ(beside_steps.box.width(), in_words.box.width());
    }
}

TEST(PolygonConstruction, TheImageOfALinkWithItsPointsOnOneLineIsALine) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "C": [150, 0], "A": {"from": "O", "distance": 50, "angle": 60},
                   "B": {"meet": [{"circle": "A", "radius": 140}, {"circle": "C", "radius": 90}], "side": "left"},
                   "P": {"from": "A", "to": "B", "distance": 70}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "P"], "4": ["C", "B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "C", "bodies": [4, 1]}],
        "drivers": [{"body": 2, "omega": 10}]})");
    const Theme theme;
    for (const auto& [polygon, lines] : {std::pair{0, 0}, std::pair{1, 1}}) {
        const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, polygon, 150, 100);
        std::map<std::string, Spot> tips;
        for (const VectorGroup& each : vectors_of(figure)) tips[each.name()] = each.axes[0].tip;
        const Spot a = tips[polygon == 0 ? "v_A" : "a_A"], b = tips[polygon == 0 ? "v_B" : "a_B"];
        int images = 0;
        for (const auto& [from, to] : thin_lines(figure, theme))
            if ((length(from - a) < 1e-6 && length(to - b) < 1e-6) ||
                (length(from - b) < 1e-6 && length(to - a) < 1e-6))
                ++images;
        EXPECT_EQ(images, lines) << "v_BA lies there already, a_BA does not";
    }
}

/// The marks of right angles: end of one leg, corner, end of the other.
std::vector<std::vector<Spot>> corners_of(const Figure& figure, const Theme& theme) {
    std::vector<std::vector<Spot>> corners;
    for (const Mark& mark : figure.marks) {
        const auto* path = std::get_if<Path>(&mark);
        if (!path || !path->stroked || path->filled || path->pen.width != theme.thin || path->segments.size() != 3)
            continue;
        std::vector<Spot> spots;
        for (const render::Segment& segment : path->segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) spots.push_back(m->to);
            if (const auto* l = std::get_if<LineTo>(&segment)) spots.push_back(l->to);
        }
        if (spots.size() == 3) corners.push_back(std::move(spots));
    }
    return corners;
}

/// A square of 1.8 mm that stands at `foot` between the directions `first` and one across it.
void expect_corner(const std::vector<Spot>& corner, Spot foot, Spot first) {
    EXPECT_NEAR(length(corner[0] - foot), 1.8, 1e-6);
    EXPECT_NEAR(dot(corner[0] - foot, first), 1.8, 1e-6);
    EXPECT_NEAR(dot(corner[2] - foot, first), 0, 1e-6);
    EXPECT_NEAR(length(corner[2] - foot), 1.8, 1e-6);
    EXPECT_NEAR(length(corner[1] - foot), 1.8 * std::sqrt(2.0), 1e-6);
}

TEST(PolygonConstruction, TheRightAngleOfNormalAndTangentialTermIsMarked) {
    const Solution& solution = example("slider_crank");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 1, 150, 120);
    const auto corners = corners_of(figure, theme);
    ASSERT_EQ(corners.size(), 1u);
    for (const VectorGroup& each : vectors_of(figure))
        if (each.name() == "a_BA_n")
            expect_corner(corners[0], each.axes[0].tip, unit(each.axes[0].tail - each.axes[0].tip));
}

TEST(PolygonConstruction, TheRightAngleToTheCoriolisTermIsMarkedWhereTheRelativeOneEnds) {
    const Solution& solution = example("inverted_slider_crank");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 1, 150, 120);
    int found = 0;
    for (const VectorGroup& each : vectors_of(figure)) {
        if (each.name() != "a_AA*_cor") continue;
        ++found;
        const auto corners = corners_of(figure, theme);
        const auto at_tail = std::find_if(corners.begin(), corners.end(), [&](const std::vector<Spot>& corner) {
            return length(corner[0] - each.axes[0].tail) < 2;
        });
        ASSERT_NE(at_tail, corners.end());
        expect_corner(*at_tail, each.axes[0].tail, unit(each.axes[0].tip - each.axes[0].tail));
    }
    EXPECT_EQ(found, 1);
}

// --- names of vectors

/// A name of the figure itself, not of its details, with the box of its ink, and where its leader ends.
struct PlacedName {
    std::vector<std::string> vectors;
    Box box;
    std::optional<Spot> end;
};
std::vector<PlacedName> names_of(const Figure& figure) {
    std::vector<PlacedName> placed;
    for (std::size_t i = 0; i < figure.marks.size(); ++i) {
        const auto* group = std::get_if<GroupBegin>(&figure.marks[i]);
        if (group != nullptr && group->cls == "figure" && i > 0) break;  // a detail
        const auto* text = std::get_if<TextMark>(&figure.marks[i]);
        if (text == nullptr || text->angle != 0) continue;
        const auto ink = ink_of(*text, fonts());
        if (!ink) continue;
        const Box box{ink->centre - ink->half, ink->centre + ink->half};
        if (text->cls != "label") {  // further pieces of the label before it
            if (!placed.empty() && text->cls == "text" && std::holds_alternative<TextMark>(figure.marks[i - 1]))
                placed.back().box.include(box);
            continue;
        }
        placed.push_back({text->names, box, std::nullopt});
        const auto* dot = i > 1 ? std::get_if<Path>(&figure.marks[i - 1]) : nullptr;
        const auto* stroke = i > 1 ? std::get_if<Path>(&figure.marks[i - 2]) : nullptr;
        if (dot != nullptr && stroke != nullptr && is_dot(*dot) && !dot->stroked && stroke->segments.size() == 2)
            placed.back().end = std::get<MoveTo>(stroke->segments[0]).to;
    }
    return placed;
}
double distance(const Box& box, const DrawnAxis& axis) {
    constexpr int steps = 400;
    double least = 1e300;
    for (int i = 0; i <= steps; ++i) {
        const Spot at = axis.tail + (static_cast<double>(i) / steps) * (axis.tip - axis.tail);
        least = std::min(least, length(Spot{std::max({box.min.x - at.x, 0.0, at.x - box.max.x}),
                                            std::max({box.min.y - at.y, 0.0, at.y - box.max.y})}));
    }
    return least;
}
bool is_one_stroke(const DrawnAxis& a, const DrawnAxis& b) {
    constexpr double seen = 0.1;
    return (length(a.tail - b.tail) < seen && length(a.tip - b.tip) < seen) ||
           (length(a.tail - b.tip) < seen && length(a.tip - b.tail) < seen);
}

/// Whether the name would be read as that of another vector: that is nearer, or as near to the end of the leader as its
/// dot is wide.
bool is_read_as_anothers(const PlacedName& name, const std::vector<DrawnAxis>& axes) {
    const auto own = std::find_if(axes.begin(), axes.end(), [&](const DrawnAxis& axis) {
        return axis.detail.empty() && axis.name == name.vectors.front();
    });
    if (own == axes.end()) return false;
    constexpr double hardly = 0.1, dot = 0.38;
    const Box from = name.end ? Box{*name.end, *name.end} : name.box;
    const double enough = name.end ? dot : distance(from, *own) - hardly;
    return std::any_of(axes.begin(), axes.end(), [&](const DrawnAxis& other) {
        return other.detail.empty() && !is_one_stroke(*own, other) && distance(from, other) < enough;
    });
}

TEST(PolygonNames, StandNearestToTheirVectorOrHaveALeaderThatEndsOnItAlone) {
    int names = 0, misread = 0;
    std::string which;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const Theme theme;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
            if (solution.protocol.polygons[p].plane == Plane::force) continue;
            const Figure figure = polygon_figure(context, static_cast<int>(p), 150, 130);
            for (const PlacedName& each : names_of(figure)) {
                if (each.vectors.empty()) continue;
                ++names;
                if (!is_read_as_anothers(each, figure.axes)) continue;
                ++misread;
                which += name + ": " + each.vectors.front() + "\n";
            }
        }
    }
    EXPECT_GT(names, 500);
    // In a knot of vectors none of its places may be clear.
    EXPECT_LE(misread, names / 300) << which;
}

TEST(PolygonNames, OfTrialsAreThoseOfSentences) {
    const Solution& solution = example("double_butterfly");
    int named = 0, unnamed = 0;
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
        for (const SceneImage& image : polygon_scene(solution, static_cast<int>(p)).images)
            if (image.kind == SceneImage::Kind::trial) ++(image.is_named ? named : unnamed);
    EXPECT_GT(named, 0);
    EXPECT_GT(unnamed, named);
}

/// A dashed side hides, and is hidden, like any other; action and reaction are one side.
TEST(PolygonSides, ThatCancelStandBesideWhatTheyWouldCover) {
    PolygonParts parts;
    parts.opposites_share_label = true;
    parts.vectors = {vector_of("F_32", {0, 0}, {0, 30}), vector_of("F_23", {0, 30}, {0, 0}),
                     vector_of("F_W", {0, 10}, {0, 50}), vector_of("F_12", {0, 50}, {40, 0})};
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) parts.vectors[i].internal = true;
    set_side_by_side(parts);
    EXPECT_GT(length(parts.vectors[0].aside), 1);
    EXPECT_EQ(length(parts.vectors[1].aside - parts.vectors[0].aside), 0);
    EXPECT_EQ(length(parts.vectors[2].aside), 0) << "what acts from outside keeps its place";
    EXPECT_EQ(length(parts.vectors[3].aside), 0);
}

// It would be read as a part of what begins there.
TEST(PolygonSides, SetAsideNoneBeginsWhereAnotherBegins) {
    int aside = 0;
    for_each_polygon_of_motion([&](const Solution& solution, std::size_t p, const Figure& figure) {
        const PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
        struct Begun {
            Spot truly, drawn;
        };
        std::vector<Begun> all;
        for (const SceneVector& vector : scene.vectors)
            for (const DrawnAxis& axis : figure.axes)
                if (axis.detail.empty() && axis.name == vector.name)
                    all.push_back({{vector.tail.x / figure.scale, -vector.tail.y / figure.scale}, axis.tail});
        for (const Begun& one : all) {
            if (length(one.drawn - one.truly) < 0.5) continue;
            ++aside;
            for (const Begun& other : all) {
                if (length(one.truly - other.truly) < 0.1) continue;
                EXPECT_GT(length(one.drawn - other.drawn), 1);
            }
        }
    });
    EXPECT_GT(aside, 5);
}

TEST(PolygonSides, AtAVerySmallAngleTheShorterIsSetAside) {
    for (const double degrees : {0.5, 1.0, 1.9, 2.1, 4.0, 8.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const Spot tip = 30 * Spot{std::cos(angle), std::sin(angle)};
        PolygonParts parts;
        parts.vectors = {vector_of("short", {0, 0}, tip), vector_of("long", {0, 0}, {50, 0})};
        set_side_by_side(parts);
        // A gap of half a shaft, 0.35 mm, at a third of the way: 2°.
        EXPECT_EQ(length(parts.vectors[0].aside) > 1, degrees < 2) << degrees;
        EXPECT_EQ(length(parts.vectors[1].aside), 0) << degrees;
        EXPECT_GE(dot(parts.vectors[0].aside, {0, 1}), 0) << degrees;  // on its own side
        parts.opposites_share_label = true;                            // forces
        parts.vectors[0].aside = {};
        set_side_by_side(parts);
        EXPECT_EQ(length(parts.vectors[0].aside), 0) << degrees;
    }
}

}  // namespace
}  // namespace polygon_test
