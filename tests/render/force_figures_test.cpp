// Force figures: vectors have the length of their value, triangles and closed polygon one scale, every force of a free
// body is in place, letters cover neither each other nor an arrow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "lang/keys/common.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/caption.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/sentences.hpp"
#include "render/sheet/sheet.hpp"
#include "render/tables/force_tables.hpp"
#include "tests/support/pages.hpp"

namespace force_figures_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

/// The examples whose files name loads or masses, but for trusses, whose bars are not cut free, and where virtual work
/// alone is sought. Every start of the program asks for them, so none is solved for it.
std::vector<std::string> loaded_examples() {
    std::vector<std::string> names;
    for (const std::string& name : example_names()) {
        const std::string text = contents(example_file(name));
        if (name.starts_with("truss_") || text.find("\"find\": [\"virtual work\"]") != std::string::npos) continue;
        if (text.find("\"loads\"") != std::string::npos || text.find("\"mass\"") != std::string::npos)
            names.push_back(name);
    }
    return names;
}

TEST(LoadedExamples, AreThoseWithFreeBodies) {
    std::vector<std::string> with_bodies;
    for (const std::string& name : example_names())
        if (!example(name).free_bodies.empty()) with_bodies.push_back(name);
    EXPECT_EQ(loaded_examples(), with_bodies);
}

struct Drawn {
    std::string figure, id, name;
    double value = 0, scale = 0;
    Axis axis;
};
std::vector<Drawn> vectors_of(const std::vector<Mark>& marks) {
    std::vector<Drawn> vectors;
    std::string figure;
    double scale = 0;
    const GroupBegin* last = nullptr;
    for (const Mark& mark : marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            last = group;
            for (const auto& [key, text] : group->attributes) {
                if (key == "data-figure") figure = text;
                if (key == "data-scale") scale = std::strtod(text.c_str(), nullptr);
            }
        }
        if (const auto* axis = std::get_if<Axis>(&mark)) {
            Drawn drawn{figure, last->id.text(), "", 0, scale, *axis};
            for (const auto& [key, text] : last->attributes) {
                if (key == "data-name") drawn.name = text;
                if (key == "data-value") drawn.value = std::strtod(text.c_str(), nullptr);
            }
            vectors.push_back(drawn);
        }
    }
    return vectors;
}

/// Corners of the true ink of a label, turned with it.
struct Ink {
    std::string words;
    Spot pivot, low{1e300, 1e300}, high{-1e300, -1e300};
    double angle = 0;
};
std::vector<Ink> labels_of(const std::vector<Mark>& marks) {
    std::vector<Ink> inks;
    for (const Mark& mark : marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (!text || text->cls != "label") continue;
        Ink ink;
        ink.words = text->words, ink.pivot = text->pivot, ink.angle = text->angle;
        for (const Glyph& glyph : text->glyphs)
            for (const render::Segment& segment : fonts().outline(glyph.face, glyph.index).segments) {
                const auto add = [&](Spot s) {
                    const Spot at{glyph.origin.x + glyph.size * s.x, glyph.origin.y - glyph.size * s.y};
                    ink.low = {std::min(ink.low.x, at.x), std::min(ink.low.y, at.y)};
                    ink.high = {std::max(ink.high.x, at.x), std::max(ink.high.y, at.y)};
                };
                if (const auto* m = std::get_if<MoveTo>(&segment)) add(m->to);
                if (const auto* l = std::get_if<LineTo>(&segment)) add(l->to);
            }
        if (ink.low.x <= ink.high.x) inks.push_back(ink);
    }
    return inks;
}
bool holds(const Ink& ink, Spot spot) {
    const Spot d = spot - ink.pivot;
    const Spot at{ink.pivot.x + d.x * std::cos(ink.angle) + d.y * std::sin(ink.angle),
                  ink.pivot.y - d.x * std::sin(ink.angle) + d.y * std::cos(ink.angle)};
    return at.x > ink.low.x && at.x < ink.high.x && at.y > ink.low.y && at.y < ink.high.y;
}

void expect_true_and_clean(const Figure& figure) {
    SCOPED_TRACE(figure.id);
    const auto inks = labels_of(figure.marks);
    std::set<std::string> ids;
    for (const Drawn& vector : vectors_of(figure.marks)) {
        EXPECT_TRUE(ids.insert(vector.id).second) << vector.id;
        EXPECT_NEAR(length(vector.axis.tip - vector.axis.tail), vector.value / vector.scale, 1e-6) << vector.name;
        const int pieces = 200;
        for (int i = 0; i <= pieces; ++i) {
            const Spot at = vector.axis.tail + (static_cast<double>(i) / pieces) * (vector.axis.tip - vector.axis.tail);
            for (const Ink& ink : inks) {
                EXPECT_FALSE(holds(ink, at)) << ink.words << " on " << vector.name;
                if (::testing::Test::HasFailure()) return;
            }
        }
    }
    for (const Ink& a : inks)
        for (const Ink& b : inks) {
            if (&a == &b || a.angle != 0 || b.angle != 0) continue;
            const double x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
            const double y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
            EXPECT_FALSE(x > 0 && y > 0) << a.words << " over " << b.words;
        }
}

std::ptrdiff_t labels_that_name(const Figure& figure, const std::string& name) {
    return std::count_if(figure.marks.begin(), figure.marks.end(), [&](const Mark& mark) {
        const auto* text = std::get_if<TextMark>(&mark);
        return text && text->cls == "label" &&
               std::find(text->names.begin(), text->names.end(), name) != text->names.end();
    });
}

class LoadedExample : public testing::TestWithParam<std::string> {};

TEST_P(LoadedExample, FiguresMeasureTheirValuesAndLettersStandClear) {
    const Solution& solution = example(GetParam());
    const Theme theme;
    for (const Language language : {Language::en, Language::it}) {
        const DrawingContext context{solution, theme, fonts(), language};
        expect_true_and_clean(mechanism_with_forces(context, 180, 130));
        if (has_force_polygons(solution)) expect_true_and_clean(force_polygons_figure(context, 180, 110));
        for (const int polygon : closed_polygons(solution)) {
            const Figure figure = closed_polygon_figure(context, polygon, 130, 130);
            EXPECT_EQ(figure.data_figure, "closure");
            expect_true_and_clean(figure);
        }
        for (std::size_t i = 0; i < solution.free_bodies.size(); ++i) {
            const Figure figure = free_body_figure(context, i, 120, 90);
            EXPECT_EQ(figure.data_figure, "body");
            EXPECT_LE(figure.box.width(), 120);
            EXPECT_LE(figure.box.height(), 90);
            expect_true_and_clean(figure);
            std::size_t forces = 0;
            for (const AppliedForce& applied : solution.free_bodies[i].forces)
                forces += applied.force.is_zero() ? 0 : 1;
            // A resultant has its line and its name: with an arrow it would be added to its parts. One force that a
            // couple moves aside has an arrow there.
            const std::vector<AppliedForce>& all = solution.free_bodies[i].forces;
            for (const AppliedForce& sum : solution.free_bodies[i].sums)
                if (std::any_of(all.begin(), all.end(),
                                [&](const AppliedForce& each) { return each.force == sum.force; }))
                    ++forces;
                else
                    EXPECT_EQ(labels_that_name(figure, name_of(sum.symbol)), 1) << name_of(sum.symbol);
            const auto shown = std::count_if(figure.marks.begin(), figure.marks.end(), [](const Mark& mark) {
                const auto* group = std::get_if<GroupBegin>(&mark);
                return group && (group->cls == "vector" || group->cls == "sense");
            });
            EXPECT_EQ(static_cast<std::size_t>(shown), forces) << "every force is in place";
            const bool thin = std::any_of(figure.marks.begin(), figure.marks.end(), [](const Mark& mark) {
                const auto* group = std::get_if<GroupBegin>(&mark);
                return group && group->cls == "sense";
            });
            const std::string says_so = word(lang::sheet::thin_arrows_not_to_scale, language);
            const bool said = figure.further_scale.find(says_so) != std::string::npos;
            EXPECT_EQ(said, thin) << figure.id;
            std::set<std::string> values;
            for (const Ink& ink : labels_of(figure.marks)) {
                const bool has_value = ink.words.find(" = ") != std::string::npos;
                EXPECT_TRUE(!has_value || values.insert(ink.words).second) << ink.words << " twice on " << figure.id;
            }
        }
    }
}

// What is carried over to the closed polygon is drawn at its scale, but for polygons that would be small there: finer,
// if at all.
TEST_P(LoadedExample, TrianglesAndClosedPolygonHaveOneScaleButForSmallOnes) {
    const Solution& solution = example(GetParam());
    for (const Paper paper : {Paper::a4, Paper::a3}) {
        std::set<double> scales, of_closed;
        std::map<double, double> longest;  // vector of force polygons, by scale
        std::set<std::string> bodies;
        for (const Page& page : lay_out(solution, {paper, Language::en, {}}, fonts())) {
            for (const Drawn& vector : vectors_of(page.marks))
                if (vector.figure == "forces")
                    longest[vector.scale] = std::max(longest[vector.scale], std::abs(vector.value));
            for (const Mark& mark : page.marks)
                if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "figure") {
                    const std::string* kind = group->attribute("data-figure");
                    const std::string* scale = group->attribute("data-scale");
                    if (kind && *kind == "body") bodies.insert(group->id.text());
                    if (kind && scale && (*kind == "forces" || *kind == "closure"))
                        (*kind == "closure" ? of_closed : scales).insert(std::strtod(scale->c_str(), nullptr));
                }
        }
        EXPECT_FALSE(has_force_polygons(solution) && longest.empty() && of_closed.empty());
        EXPECT_LE(of_closed.size(), 1u);
        // A polygon that is finer would be less than 40 mm long at the common scale.
        double common = longest.empty() ? 0 : longest.rbegin()->first;
        if (!of_closed.empty()) common = std::max(common, *of_closed.begin());
        for (const auto& [scale, value] : longest) {
            if (scale < common) {
                EXPECT_LT(value / common, 40) << scale;
            }
        }
        if (!of_closed.empty() && !scales.empty()) {
            EXPECT_EQ(*of_closed.begin(), std::max(*scales.rbegin(), common)) << "that of the largest";
        }
        ASSERT_FALSE(solution.free_bodies.empty());
        for (const FreeBody& body : solution.free_bodies)
            if (body.body > frame) {
                EXPECT_TRUE(bodies.contains(legal_id("body-" + solution.mechanism.bodies[at_index(body.body)].name)));
            }
    }
}

TEST_P(LoadedExample, TheTableHasItsNumbersFromTheCheck) {
    const Solution& solution = example(GetParam());
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    std::vector<Figure> figures;
    if (has_force_polygons(solution)) figures.push_back(force_polygons_figure(context, 180, 110));
    for (const int polygon : closed_polygons(solution))
        figures.push_back(closed_polygon_figure(context, polygon, 130, 130));
    const auto rows = force_rows(context, figures);
    EXPECT_FALSE(rows.empty());
    for (const ResultRow& row : rows) {
        ASSERT_TRUE(row.numeric) << row.name;
        EXPECT_NEAR(row.drawing, *row.numeric, 1e-9 * std::max(1.0, std::abs(row.drawing))) << row.name;
        if (row.group.section == Topic::forces && !row.group.couples) {
            EXPECT_TRUE(row.millimetres) << row.name << " is drawn to scale";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ForceFigures, LoadedExample, testing::ValuesIn(loaded_examples()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(ForceSheet, OfTheSluiceGateHasTheSegmentsOfTheNotes) {
    const Solution& solution = example("sluice_gate");
    std::map<std::string, double> millimetres;
    const auto pages = lay_out(solution, {Paper::a3, Language::en, {}}, fonts());
    EXPECT_LE(pages.size(), 2u);
    for (const Page& page : pages)
        for (const Drawn& vector : vectors_of(page.marks))
            if (vector.figure == "closure" || vector.figure == "forces")
                millimetres[vector.name] = length(vector.axis.tip - vector.axis.tail);
    // Drawn by hand with F_g of 14 mm: 6, 12, 24, 27, 17 and 18 mm.
    EXPECT_NEAR(millimetres.at("F_g"), 14, 1e-6);
    EXPECT_NEAR(millimetres.at("F_01"), 6, 0.5);
    EXPECT_NEAR(millimetres.at("F_21"), 12, 0.5);
    EXPECT_NEAR(millimetres.at("F_43"), 24, 0.5);
    EXPECT_NEAR(millimetres.at("F_03"), 27, 0.5);
    EXPECT_NEAR(millimetres.at("F_05"), 17, 0.5);
    EXPECT_NEAR(millimetres.at("F_G"), 18, 0.5);
}

TEST(ForceSheet, ExternalForcesOfTheClosedPolygonAddUpToNothing) {
    const Solution& solution = example("sluice_gate");
    const auto polygons = closed_polygons(solution);
    ASSERT_EQ(polygons.size(), 1u);
    const Polygon& polygon = solution.protocol.polygons[static_cast<std::size_t>(polygons.front())];
    Vector sum;
    for (const int index : polygon.vectors) {
        const DrawnVector& vector = solution.protocol.vectors[static_cast<std::size_t>(index)];
        if (vector.role == DrawnVector::Role::external) sum = sum + solution.protocol.value_of(vector);
    }
    EXPECT_TRUE(sum.is_zero());
}

TEST(ForceSheet, SaysWhereASliderTips) {
    const Solution& solution = example("exam_2001");
    bool said = false;
    for (const Page& page : lay_out(solution, {}, fonts()))
        for (const Mark& mark : page.marks)
            if (const auto* text = std::get_if<TextMark>(&mark))
                said = said || text->words.find("passes outside") != std::string::npos;
    EXPECT_TRUE(said);
}

bool says(const Figure& figure, std::string_view words) {
    return std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark& mark) {
        const auto* text = std::get_if<TextMark>(&mark);
        return text && text->words.find(words) != std::string::npos;
    });
}

std::string words_of(const Figure& figure) {
    std::string words;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) words += " | " + text->words;
    return words;
}

TEST(ForceSheet, PointsToAConcurrencyOutsideOfTheDrawing) {
    const Solution& solution = example("beam");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    for (const Figure& figure : {mechanism_with_forces(context, 180, 130), free_body_figure(context, 0, 120, 90)})
        EXPECT_TRUE(says(figure, "H  (AH = 11.5")) << figure.id << words_of(figure);
}

/// A slider-crank under gas and inertia forces: both are on one line at the slider, oppositely; what is known on rod
/// and slider has a couple, too, and meets the guide's force some eight cranks' lengths away.
Solution engine() {
    return solved(R"({"kinegraph": 1,
        "units": {"length": "mm", "moment": "N m", "force": "N", "inertia": "kg mm²", "angular velocity": "rpm"},
        "frame": 1,
        "points": {"O": [0, 0], "A": {"from": "O", "distance": "50 mm", "angle": "60°"},
                   "B": {"meet": [{"circle": "A", "radius": "200 mm"}, {"line": [0, 15], "angle": 0}], "side": "right"},
                   "G": {"from": "A", "to": "B", "ratio": 0.3333}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "G"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "name": "guide", "bodies": [4, 1],
                   "along": 0}],
        "drivers": [{"body": 2, "omega": "1500 rpm"}],
        "masses": {"3": {"mass": "1.2 kg", "centre": "G", "inertia": "4000 kg mm²"}, "4": {"mass": "0.9 kg",
        "centre": "B"}},
        "inertia forces": true, "loads": [{"force": "F_gas", "body": 4, "at": "B", "magnitude": "1131 N",
        "along": 180}],
        "effort": {"couple": "M", "body": 2}, "find": ["velocity", "acceleration", "forces"]})");
}

TEST(ForceSheet, OppositeForcesOnOneLineAreNoDoubleArrow) {
    const Solution solution = engine();
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    std::size_t all = 0;
    for (std::size_t body = 0; body < solution.free_bodies.size(); ++body) {
        const auto vectors = vectors_of(free_body_figure(context, body, 160, 120).marks);
        all += vectors.size();
        for (const Drawn& one : vectors)
            for (const Drawn& other : vectors) {
                const Spot along = one.axis.tip - one.axis.tail, against = other.axis.tip - other.axis.tail;
                const bool opposite = dot(along, against) < 0 && std::abs(cross(along, against)) < 0.05 * length(along);
                EXPECT_FALSE(opposite && length(one.axis.tail - other.axis.tail) < 1.5)
                    << one.name << ' ' << other.name;
            }
    }
    EXPECT_GT(all, 2U);
}

TEST(ForceSheet, ShowsByHowMuchAResultantIsMovedAside) {
    const Solution solution = engine();
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    EXPECT_TRUE(says(mechanism_with_forces(context, 180, 130), "d = 24.9"));
    const std::vector<Statement>& statements = solution.protocol.statements;
    int resultants = 0, moved = 0;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        const Message& said = statements[i].message;
        if (said.sentence == lang::sentences::known_resultant) {
            ++resultants;
            EXPECT_FALSE(is_incidental(statements, i)) << "the next sentence moves it";
        }
        if (said.sentence == lang::sentences::inertia_moved && statements[i].bodies.size() > 1) {
            ++moved;
            EXPECT_EQ(name_of(said.worked_arithmetic.front().of), "d");
            // Both factors as they are told before, N m and N: the quotient is in m, then in the file's unit.
            const Working &in_metres = said.worked_arithmetic.at(0), &in_own_unit = said.worked_arithmetic.at(1);
            EXPECT_EQ(in_metres.result.unit, "m");
            EXPECT_NEAR(in_metres.factors.at(0).value, 21.36, 0.01);
            EXPECT_NEAR(in_own_unit.result.value, 24.9, 0.05);
        }
        EXPECT_NE(said.sentence, lang::sentences::triangle_at) << "a meet that no sheet has";
    }
    EXPECT_EQ(resultants, 1);
    EXPECT_EQ(moved, 1);
}

/// It goes round, and no bar swings.
TEST(ForceSheet, CallsWhatCarriesAPlanetAnArm) {
    const Solution solution = solved(R"({"kinegraph": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "S": [30, 0], "P": [50, 0], "R": [70, 0]},
        "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 30}},
                   "3": {"points": ["P"], "circle": {"centre": "P", "radius": 20}}, "4": ["O", "P"],
                   "5": {"points": ["O"], "circle": {"centre": "O", "radius": 70}}},
        "joints": [{"revolute": "O", "bodies": [0, 2, 4, 5]}, {"revolute": "P", "bodies": [3, 4]},
                   {"rolling": "S", "bodies": [2, 3]},
                   {"rolling": "R", "bodies": [3, 5], "profiles": {"3": {"circle": "P"}, "5": {"circle": "O"}}}],
        "drivers": [{"body": 2, "omega": 10}, {"body": 5, "omega": 0}], "find": ["velocity"]})");
    std::string words;
    for (const Page& page : lay_out(solution, {}, fonts()))
        for (const Mark& mark : page.marks)
            if (const auto* text = std::get_if<TextMark>(&mark)) words += text->words + "\n";
    EXPECT_NE(words.find("arm OP"), std::string::npos) << words;
    EXPECT_EQ(words.find("rocker"), std::string::npos) << words;
}

/// The marks of each figure of a page, from its group on to where that ends.
std::vector<std::vector<Mark>> figures_of(const Page& page) {
    std::vector<std::vector<Mark>> figures;
    int depth = 0;  // within a figure
    for (const Mark& mark : page.marks) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (depth == 0 && group != nullptr && group->cls == "figure") figures.emplace_back();
        if (depth > 0 || (group != nullptr && group->cls == "figure")) figures.back().push_back(mark);
        if (depth > 0 || (group != nullptr && group->cls == "figure"))
            depth += group != nullptr ? 1 : std::holds_alternative<GroupEnd>(mark) ? -1 : 0;
    }
    return figures;
}

/// Whether each vector of a figure has the length of its value, or else its value at its name.
void expect_lengths_or_values(const std::vector<Mark>& figure, const Unit& unit, int& thin) {
    const std::vector<Ink> inks = labels_of(figure);
    for (const Drawn& vector : vectors_of(figure))
        if (vector.scale > 0) {
            EXPECT_NEAR(length(vector.axis.tip - vector.axis.tail), std::abs(vector.value) / vector.scale, 1e-6)
                << vector.name;
        }
    for (const Mark& mark : figure) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (group == nullptr || group->cls != "sense") continue;
        ++thin;
        const double value = std::strtod(group->attribute("data-value")->c_str(), nullptr);
        const std::string words = " = " + number(value, 4, Language::en) + " " + unit.symbol;
        EXPECT_TRUE(std::any_of(
            inks.begin(), inks.end(),
            [&](const Ink& ink) { return ink.words.starts_with("F") && ink.words.find(words) != std::string::npos; }))
            << group->id.text() << words;
    }
}

/// What is off the scale of its figure says how large it is, and the caption says that it is off.
TEST(ForcePages, HaveVectorsToScaleOrWithValueAndNotice) {
    const std::string notice = word(lang::sheet::thin_arrows_not_to_scale, Language::en);
    int off_scale = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        for (const Page& page : pages::laid_out(name)) {
            int figures = 0, notices = 0;
            for (const std::vector<Mark>& figure : figures_of(page)) {
                int thin = 0;
                expect_lengths_or_values(figure, example(name).mechanism.units.force, thin);
                figures += thin > 0 ? 1 : 0;
                off_scale += thin;
            }
            std::string words;  // a caption may be on several lines
            for (const TextMark* text : pages::texts_of(page)) words += text->words + " ";
            for (std::size_t at = words.find(notice); at != std::string::npos; at = words.find(notice, at + 1))
                ++notices;
            EXPECT_EQ(notices, figures);
        }
    }
    EXPECT_GT(off_scale, 5);
}

/// A stroke of a funicular polygon, or the number that names one.
struct OnStrings {
    std::vector<std::string> on;
    Spot from, to;  // of a stroke
    Ink ink{};      // of a number
    bool has_leader = false;
};
bool is_of_strings(const Holds& holds) {
    return holds.form == Holds::Form::segment && holds.on.size() == 2 &&
           std::all_of(holds.on.begin(), holds.on.end(), [](const std::string& on) {
               return on.find('V') != std::string::npos && on.find('.') != std::string::npos;
           });
}
bool is_dot(const Mark& mark) {
    const auto* path = std::get_if<Path>(&mark);
    return path != nullptr && path->filled && !path->stroked;
}
double distance_from(const Ink& ink, const std::vector<Spot>& points) {
    double least = 1e300;
    for (const Spot at : points)
        least = std::min(least, length(Spot{std::max({0.0, ink.low.x - at.x, at.x - ink.high.x}),
                                            std::max({0.0, ink.low.y - at.y, at.y - ink.high.y})}));
    return least;
}
double distance_from(const Ink& ink, const OnStrings& string) {
    std::vector<Spot> points;
    constexpr int pieces = 400;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(string.from + (static_cast<double>(i) / pieces) * (string.to - string.from));
    return distance_from(ink, points);
}
bool on_one_line(const OnStrings& one, const OnStrings& other) {
    const Spot along = unit(one.to - one.from);
    return std::abs(cross(along, other.from - one.from)) < 0.05 && std::abs(cross(along, other.to - one.from)) < 0.05;
}

/// Numbers of strings are told apart by where they stand only.
TEST(ForcePages, HaveEachNumberAtItsString) {
    int numbers = 0;
    for (const std::string& name : example_names())
        for (const Page& page : pages::laid_out(name))
            for (const std::vector<Mark>& figure : figures_of(page)) {
                SCOPED_TRACE(name);
                std::vector<OnStrings> strings, numbered;
                bool leader = false;  // the mark before is the dot of one
                for (const Mark& mark : figure) {
                    const auto* path = std::get_if<Path>(&mark);
                    if (path != nullptr && is_of_strings(path->holds) && path->segments.size() == 2)
                        strings.push_back({path->holds.on, std::get<MoveTo>(path->segments[0]).to,
                                           std::get<LineTo>(path->segments[1]).to});
                    if (const auto* text = std::get_if<TextMark>(&mark);
                        text != nullptr && text->cls == "label" && is_of_strings(text->holds))
                        numbered.push_back({text->holds.on, {}, {}, labels_of({mark}).front(), leader});
                    leader = is_dot(mark);
                }
                for (const OnStrings& number : numbered) {
                    ++numbers;
                    // The string with its extension, which ends where that of the number does.
                    const auto own = std::find_if(strings.begin(), strings.end(), [&](const OnStrings& string) {
                        return std::all_of(number.on.begin(), number.on.end(), [&](const std::string& end) {
                            return std::any_of(strings.begin(), strings.end(), [&](const OnStrings& part) {
                                return on_one_line(string, part) &&
                                       std::find(part.on.begin(), part.on.end(), end) != part.on.end();
                            });
                        });
                    });
                    ASSERT_NE(own, strings.end()) << number.ink.words;
                    double away = 1e300;
                    for (const OnStrings& part : strings)
                        if (on_one_line(*own, part)) away = std::min(away, distance_from(number.ink, part));
                    for (const OnStrings& other : strings)
                        if (!number.has_leader && !on_one_line(*own, other)) {
                            EXPECT_LT(away, distance_from(number.ink, other)) << number.ink.words;
                        }
                }
            }
    EXPECT_GT(numbers, 20);
}

/// Points on the strokes of a path.
std::vector<Spot> points_on(const Path& path) {
    std::vector<Spot> points;
    constexpr int pieces = 24;
    for (const render::Segment& segment : path.segments) {
        const Spot from = points.empty() ? Spot{} : points.back();
        for (int i = 1; i <= pieces; ++i) {
            const double t = static_cast<double>(i) / pieces, u = 1 - t;
            if (const auto* l = std::get_if<LineTo>(&segment)) points.push_back(u * from + t * l->to);
            if (const auto* c = std::get_if<CurveTo>(&segment))
                points.push_back(u * u * u * from + 3 * u * u * t * c->control_1 + 3 * u * t * t * c->control_2 +
                                 t * t * t * c->to);
            if (const auto* a = std::get_if<ArcTo>(&segment))
                points.push_back(a->centre + a->radius * polar_spot(u * a->from + t * a->to));
        }
        if (const auto* m = std::get_if<MoveTo>(&segment)) points.push_back(m->to);
    }
    return points;
}

TEST(ForcePages, HaveTheNameOfEachCoupleAtItsArc) {
    int several = 0;  // names in figures of several couples
    for (const std::string& name : loaded_examples())
        for (const Page& page : pages::laid_out(name))
            for (const std::vector<Mark>& figure : figures_of(page)) {
                SCOPED_TRACE(name);
                std::map<std::vector<std::string>, std::vector<Spot>> arcs;
                for (const Mark& mark : figure)
                    if (const auto* path = std::get_if<Path>(&mark);
                        path != nullptr && path->holds.form == Holds::Form::couple)
                        for (const Spot point : points_on(*path)) arcs[path->holds.on].push_back(point);
                bool leader = false;  // the mark before is the dot of one
                for (const Mark& mark : figure) {
                    const auto* text = std::get_if<TextMark>(&mark);
                    const bool has_leader = std::exchange(leader, is_dot(mark));
                    if (text == nullptr || text->holds.form != Holds::Form::couple || has_leader) continue;
                    const Ink ink = labels_of({mark}).front();
                    ASSERT_TRUE(arcs.contains(text->holds.on)) << ink.words;
                    for (const auto& [couple, arc] : arcs) {
                        if (couple == text->holds.on) continue;
                        ++several;
                        EXPECT_LT(distance_from(ink, arcs.at(text->holds.on)), distance_from(ink, arc)) << ink.words;
                    }
                }
            }
    EXPECT_GT(several, 5);
}

/// The names of all resultants of a solution.
std::set<std::string> resultants_of(const Solution& solution) {
    std::set<std::string> names;
    const auto take = [&](const auto& all) {
        for (const auto& each : all)
            for (const AppliedForce& sum : each.sums)
                if (sum.is_resultant()) names.insert(name_of(sum.symbol));
    };
    take(solution.free_bodies);
    take(solution.taken_together);
    if (solution.superposition)
        for (const Superposition::Part& part : solution.superposition->parts) take(part.bodies), take(part.together);
    for (const Resultant& each : solution.resultants)
        if (each.polygon >= 0)
            names.insert(name_of(
                solution.protocol.vectors[at_index(solution.protocol.polygons[at_index(each.polygon)].vectors.back())]
                    .symbol));
    return names;
}

/// In no body's colour, solid and with two heads wherever they are drawn; nothing else has two heads.
TEST(ForcePages, HaveResultantsByOneRule) {
    const Colour own = Theme().colour_of(none).line;
    std::map<std::string, int> seen;  // by kind of figure
    for (const std::string& name : example_names()) {
        const std::set<std::string> resultants = resultants_of(example(name));
        for (const Page& page : pages::laid_out(name))
            for (const std::vector<Mark>& figure : figures_of(page)) {
                const std::string* kind = std::get<GroupBegin>(figure.front()).attribute("data-figure");
                const GroupBegin* vector = nullptr;
                int heads = 0;
                for (const Mark& mark : figure) {
                    if (const auto* group = std::get_if<GroupBegin>(&mark))
                        vector = group->cls == "vector" || group->cls == "sense" ? group : nullptr, heads = 0;
                    if (vector == nullptr) continue;
                    const std::string& of = *vector->attribute("data-name");
                    const bool is_resultant = resultants.contains(of);
                    if (const auto* path = std::get_if<Path>(&mark)) {
                        heads += path->filled ? 1 : 0;
                        if (is_resultant) {
                            EXPECT_EQ(path->filled ? path->fill : path->pen.colour, own) << vector->id.text();
                            EXPECT_TRUE(path->pen.dashes.empty()) << vector->id.text();
                        }
                    }
                    if (!std::holds_alternative<GroupEnd>(mark)) continue;
                    EXPECT_EQ(heads > 1, is_resultant) << name << ' ' << vector->id.text();
                    if (is_resultant) ++seen[*kind];
                    vector = nullptr;
                }
            }
    }
    EXPECT_GT(seen["forces"], 5);
    EXPECT_GT(seen["body"], 2) << "forces moved aside, and what is left over on a body without supports";
}

/// Beside two columns of parallel sides: a name of the inner one has its place before the resultant, not beyond it.
TEST(ForcePages, HaveRoomForNamesBetweenParallelSidesAndTheirResultant) {
    constexpr double highest_name = 6;  // mm; two lines of a subscript and a superscript
    int seen = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (!has_force_polygons(solution)) continue;
        const Theme theme;
        const Figure figure = force_polygons_figure({solution, theme, fonts(), Language::en}, 180, 110);
        const std::set<std::string> resultants = resultants_of(solution);
        for (const Drawn& sum : vectors_of(figure.marks)) {
            if (!resultants.contains(sum.name)) continue;
            const Spot off = sum.axis.tip - sum.axis.tail, along = (1 / length(off)) * off;
            std::set<long> columns;  // tenths of a millimetre from the resultant
            for (const Drawn& side : vectors_of(figure.marks)) {
                const Spot tail = side.axis.tail - sum.axis.tail, tip = side.axis.tip - sum.axis.tail;
                const bool beside = std::max(dot(along, tail), dot(along, tip)) > 0.1 &&
                                    std::min(dot(along, tail), dot(along, tip)) < length(off) - 0.1;
                if (side.name != sum.name && beside && std::abs(cross(along, tip - tail)) < 0.01)
                    columns.insert(std::lround(10 * std::abs(cross(along, tail))));
            }
            while (!columns.empty() && *columns.rbegin() > 200) columns.erase(*columns.rbegin());  // another polygon's
            if (columns.size() < 2) continue;
            ++seen;
            EXPECT_GT(*columns.begin(), 10 * highest_name) << name << ' ' << sum.name;
        }
    }
    EXPECT_GT(seen, 0);
}

/// The distance of a slider's force from its joint is a dimension or a remark.
TEST(ForcePages, SayOnceHowFarASlidersForcePassesItsJoint) {
    const Solution& solution = example("exam_2001");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    int dimensions = 0, remarks = 0;
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i) {
        const Figure full = free_body_figure(context, i, 160, 120),
                     brief = free_body_figure(context, i, 160, 120, false);
        if (says(full, "d = ")) {
            ++dimensions;
            EXPECT_FALSE(says(full, " m from ")) << words_of(full);
        }
        remarks += says(brief, " m from ") ? 1 : 0;
    }
    EXPECT_GT(dimensions, 0);
    EXPECT_GT(remarks, 0);
}

/// What two heads mean is said on every sheet that has them.
TEST(ForcePages, SayWhatDoubleHeadsMean) {
    const std::string words = word(lang::sheet::double_heads, Language::en);
    int sheets = 0;
    for (const std::string& name : example_names()) {
        bool has = false;
        std::string said;
        for (const Page& page : pages::laid_out(name)) {
            for (const std::vector<Mark>& figure : figures_of(page)) {
                const std::set<std::string> resultants = resultants_of(example(name));
                for (const Mark& mark : figure)
                    if (const auto* group = std::get_if<GroupBegin>(&mark))
                        if (const std::string* of = group->attribute("data-name")) has |= resultants.contains(*of);
            }
            for (const TextMark* text : pages::texts_of(page)) said += text->words + " ";
        }
        if (!has) continue;
        ++sheets;
        EXPECT_NE(said.find(words), std::string::npos) << name;
    }
    EXPECT_GT(sheets, 5);
}

/// A force that its couple moves aside is in place of both: with the name of the first it would be added twice.
TEST(ForcePages, HaveAnotherNameForAForceMovedAside) {
    int moved = 0;
    const auto expect_apart = [&](const std::vector<FreeBody>& bodies, bool may_move) {
        for (const FreeBody& body : bodies)
            for (const AppliedForce& sum : body.sums) {
                for (const AppliedForce& applied : body.forces) EXPECT_NE(name_of(sum.symbol), name_of(applied.symbol));
                if (!is_moved_aside(sum.symbol)) continue;
                ++moved;
                EXPECT_TRUE(may_move) << "no sentence about these loads alone moves it";
                EXPECT_TRUE(std::any_of(body.forces.begin(), body.forces.end(), [&](const AppliedForce& applied) {
                    return applied.symbol == where_it_acts(sum.symbol) && applied.force == sum.force;
                })) << name_of(sum.symbol);
            }
    };
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        expect_apart(solution.free_bodies, true);
        if (solution.superposition)
            for (const Superposition::Part& part : solution.superposition->parts) expect_apart(part.bodies, false);
    }
    EXPECT_GT(moved, 2);
}

/// Its sentence and its free body have both places; the lines of action only a line that is used there.
TEST(ForcePages, ShowAForceMovedAsideWhereItsLineIsUsed) {
    const Solution& solution = example("engine_inertia_gas");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    EXPECT_FALSE(says(mechanism_with_forces(context, 180, 130), "F′_i3"));
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i)
        for (const AppliedForce& sum : solution.free_bodies[i].sums) {
            EXPECT_EQ(says(free_body_figure(context, i, 160, 120), "F′_i3"), is_moved_aside(sum.symbol));
        }
}

TEST(ForceSheet, SaysTheSizeOfAForceTooSmallToDraw) {
    const Solution& solution = example("pliers");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::it};
    EXPECT_TRUE(says(free_body_figure(context, 1, 160, 90), "F_hand = 100,0 N"));
}

TEST(ForceSheet, KeepsTheNamesOfTheFile) {
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::F, "F_gas", ""}, Language::en)), "F_gas");
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::F, "32", ""}, Language::en)), "F_32");
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::M, "M", ""}, Language::en)), "M");
    EXPECT_EQ(name_of(Symbol{Symbol::Letter::F, "F_gas", ""}), "F_gas");
    EXPECT_EQ(name_of(Symbol{Symbol::Letter::M, "C", ""}), "M_C");
}

TEST(ForceResults, AsTextListReactionsAndEfforts) {
    const std::string text = results_table(example("sluice_gate"), Language::en);
    for (const char* words : {"Reactions", "Fx [MN]", "A: 0 on 1", "Efforts", "F_G"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    EXPECT_NE(results_table(example("sluice_gate"), Language::it).find("Reazioni"), std::string::npos);
}

/// On the live page they come and go with the table: alone they would be heads without rows.
TEST(ForceEquations, HaveTheNamesOfTheirRowsByTheSentenceOfATable) {
    const Theme theme;
    std::size_t named = 0;
    for (const std::string& name : loaded_examples()) {
        const Solution& solution = example(name);
        if (!has_force_polygons(solution)) continue;
        const DrawingContext context{solution, theme, fonts()};
        const Figure figure = force_polygons_figure(context, 180, 110);
        std::set<StatementIndex> tables;
        for (const Mark& mark : figure.marks)
            if (const auto* text = std::get_if<TextMark>(&mark); text != nullptr && text->words == "?")
                tables.insert(text->statement);
        for (const Mark& mark : figure.marks) {
            const auto* text = std::get_if<TextMark>(&mark);
            if (text == nullptr || text->words != lang::common::magnitude.in(Language::en)) continue;
            ++named;
            EXPECT_NE(text->statement, none) << name;
            EXPECT_TRUE(tables.contains(text->statement)) << name;
        }
    }
    EXPECT_GT(named, 5U);
}

/// Below the equation of a polygon what an earlier sentence found is known, whichever body it was found on; and the
/// sentence that the equation stands under is about its body.
TEST(ForceEquations, AskForNothingThatIsFoundAlready) {
    // Moments of the whole give the roller's reaction before the tie's bodies are cut free.
    const Solution portal = solved(R"({"kinegraph": 1, "frame": 0,
        "points": {"A": [0, 0], "B": [6, 0], "C": [3, 5], "D": [0, 4], "E": [6, 4]},
        "bodies": {"1": ["A", "D", "C"], "2": ["C", "E", "B"], "3": ["D", "E"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "C", "bodies": [1, 2]},
        {"contact": "B", "bodies": [2, 0], "tangent": 0, "pushes": [0, 1]}, {"revolute": "D", "bodies": [1, 3]},
        {"revolute": "E", "bodies": [2, 3]}],
        "loads": [{"force": "H", "body": 1, "at": "D", "value": [4, 0]},
        {"force": "Q", "body": 2, "at": "E", "value": [-1, -9]}]})");
    std::vector<const Solution*> solutions{&portal};
    for (const std::string& name : loaded_examples()) solutions.push_back(&example(name));
    const Theme theme;
    int equations = 0;
    for (const Solution* solution : solutions) {
        const DrawingContext context{*solution, theme, pages::fonts()};
        const LoadCase loads(*solution);
        for (std::size_t i = 0; i < solution->protocol.statements.size(); ++i)
            for (const FreeBody* body : solved_by(loads, StatementIndex(i))) {
                if (body->body != none) {
                    EXPECT_EQ(solution->protocol.statements[i].bodies, std::vector{body->body});
                }
                const Block block = force_equation_block(context, loads, *body, true);
                if (!(block.width > 0)) continue;
                const auto marks = std::count_if(block.marks.begin(), block.marks.end(), [](const Mark& mark) {
                    const auto* text = std::get_if<TextMark>(&mark);
                    return text != nullptr && text->words == "?";
                });
                // Of a force that this sentence finds, its magnitude is sought, and its direction at most.
                const auto found =
                    std::count_if(body->forces.begin(), body->forces.end(), [&](const AppliedForce& each) {
                        return each.force_statement == StatementIndex(i) && !each.force.is_zero();
                    });
                EXPECT_GE(marks, found) << solution->mechanism.source << ", statement " << i;
                EXPECT_LE(marks, 2 * found) << solution->mechanism.source << ", statement " << i;
                ++equations;
            }
    }
    EXPECT_GT(equations, 20);
}

/// Nearly equal forces that are opposite have their resultant far from the mechanism. What lies on its line alone stays
/// out of the figure, which it would make as wide as the distance.
TEST(LinesOfAction, ThatPassOutsideAreNotDrawn) {
    const Solution portal = solved(R"({"kinegraph": 1, "frame": 0,
        "points": {"A": [0, 0], "B": [6, 0], "C": [3, 5], "D": [0, 4], "E": [6, 4], "M": [4.5, 4.5]},
        "bodies": {"1": ["A", "D", "C"], "2": ["C", "M", "E", "B"], "3": ["D", "E"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "C", "bodies": [1, 2]},
        {"contact": "B", "bodies": [2, 0], "tangent": 0, "pushes": [0, 1]}, {"revolute": "D", "bodies": [1, 3]},
        {"revolute": "E", "bodies": [2, 3]}],
        "loads": [{"force": "H", "body": 1, "at": "D", "value": [4, 0]},
        {"force": "Q", "body": 2, "at": "M", "value": [0, -9.486833]}]})");
    const Theme theme;
    const DrawingContext context{portal, theme, pages::fonts()};
    const Figure figure = mechanism_with_forces(context, 1000, 200, all_loads, {.finest = 0.1, .exactly = true});
    ASSERT_EQ(figure.scale, 0.1);
    constexpr double links = 60, arrows = 30;  // mm, of 6 m; on either side, with their names
    EXPECT_LT(figure.box.width(), links + 2 * arrows + 40);
}

/// The shafts of the arrows of a figure of the mechanism, with its origin at that of coordinates.
std::vector<drawing::Bar> shafts_of(const Figure& figure) {
    std::vector<drawing::Bar> shafts;
    bool within = false;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) within = group->cls == "arrows";
        if (std::holds_alternative<GroupEnd>(mark)) within = false;
        const auto* path = std::get_if<Path>(&mark);
        if (!within || path == nullptr || !path->stroked || path->segments.size() != 2) continue;
        const auto* from = std::get_if<MoveTo>(path->segments.data());
        const auto* to = std::get_if<LineTo>(&path->segments[1]);
        if (from && to) shafts.push_back({from->to - figure.origin, to->to - figure.origin});
    }
    return shafts;
}

/// On the axis of a cylinder are its rod and barrel, and beyond them other bodies.
TEST(LinesOfAction, HaveTheForceOfACylinderBesideIt) {
    using namespace drawing;
    const Theme theme;
    std::size_t cylinders = 0;
    for (const char* const name : {"tipper", "tipper_mirrored", "excavator_arm", "scissor_lift"}) {
        const Solution& solution = example(name);
        const Figure figure = mechanism_with_forces({solution, theme, fonts()}, 180, 140, all_loads, {});
        const Subject subject(solution);
        const Layout layout(subject, theme, figure.places);
        for (const Cylinder& cylinder : layout.cylinders()) {
            ++cylinders;
            double half = 0;
            for (const Spot corner : corners_of_barrel(layout, cylinder))
                half = std::max(half, std::abs(cross(direction(cylinder.barrel), corner - cylinder.barrel.from)));
            constexpr double parallel = 0.02, near = 4;  // mm, with the width of strokes
            const auto shafts = shafts_of(figure);
            EXPECT_TRUE(std::any_of(shafts.begin(), shafts.end(), [&](const Bar& shaft) {
                const double away = drawing::distance(middle(shaft), cylinder.barrel);
                return std::abs(cross(direction(shaft), direction(cylinder.barrel))) < parallel && away > half &&
                       away < half + near;
            })) << name;
            EXPECT_TRUE(std::none_of(shafts.begin(), shafts.end(), [&](const Bar& shaft) {
                return std::abs(cross(direction(shaft), direction(cylinder.barrel))) < parallel &&
                       drawing::distance(cylinder.piston, shaft) < 1;
            })) << name;
        }
    }
    EXPECT_EQ(cylinders, 6U);
}

/// Two arrows on the short way between the points that they pull together would make a bar in tension of it.
TEST(LinesOfAction, HaveTheForcesOfAHandOutside) {
    using namespace drawing;
    const Theme theme;
    const Solution& pliers = example("pliers");
    const Figure figure = mechanism_with_forces({pliers, theme, fonts()}, 150, 100, all_loads, {});
    const Subject subject(pliers);
    const Layout layout(subject, theme, figure.places);
    const auto spot = [&](const char* name) {
        for (const PointIndex point : indices_of(pliers.mechanism.points))
            if (pliers.mechanism.point(point).name == name) return layout.spot(point);
        return Spot{};
    };
    const Bar way{spot("K"), spot("L")};
    int beyond = 0;
    for (const Bar& shaft : shafts_of(figure)) {
        if (std::abs(cross(direction(way), shaft.from - way.from)) > 1) continue;
        EXPECT_GT(drawing::distance(middle(shaft), way), 3);
        ++beyond;
    }
    EXPECT_EQ(beyond, 2);
}

}  // namespace
}  // namespace force_figures_test
