// How polygons are drawn: vectors of one line side by side, lines of the construction numbered as the sentences name
// them, leaders that are no vectors, readings with their arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "lang/keys/sentences.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/page/labels.hpp"
#include "render/scene/line_numbers.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/pages.hpp"

namespace drawn_as_in_books_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

/// How far two strokes run along one line, mm.
double shared(const DrawnAxis& a, const DrawnAxis& b) {
    constexpr double beside = 0.4;
    const Spot along = unit(a.tip - a.tail);
    if (std::abs(cross(along, b.tail - a.tail)) > beside || std::abs(cross(along, b.tip - a.tail)) > beside) return 0;
    const double from = dot(b.tail - a.tail, along), to = dot(b.tip - a.tail, along);
    return std::min(length(a.tip - a.tail), std::max(from, to)) - std::max(0.0, std::min(from, to));
}
bool fall_together(const DrawnAxis& a, const DrawnAxis& b) {
    return length(a.tail - b.tail) < 0.02 && length(a.tip - b.tip) < 0.02;
}

const DrawnAxis& axis_of(const Figure& figure, const std::string& name) {
    const auto found =
        std::find_if(figure.axes.begin(), figure.axes.end(), [&](const DrawnAxis& a) { return a.name == name; });
    if (found == figure.axes.end()) throw std::runtime_error(figure.id + " has no " + name);
    return *found;
}

TEST(DrawnAsInBooks, VectorsOfOneLineStandSideBySide) {
    const Theme theme;
    int beside = 0;
    for (const char* const name : {"planetary_train", "slider_crank_outer_dead_point", "slider_crank_inner_dead_point",
                                   "elliptic_trammel", "exam_2001", "parallel_crank"}) {
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts()};
        for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
            if (solution.protocol.polygons[p].plane == Plane::force) continue;
            const PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
            if (scene.empty()) continue;
            SCOPED_TRACE(std::string(name) + ", " + scene.id);
            const Figure figure = polygon_figure(context, scene, 130, 110);
            for (std::size_t i = 0; i < figure.axes.size(); ++i) {
                const DrawnAxis& own = figure.axes[i];
                for (std::size_t j = 0; j < i; ++j) {
                    const DrawnAxis& other = figure.axes[j];
                    if (other.detail != own.detail || fall_together(other, own)) continue;
                    EXPECT_LE(shared(other, own), 1.05) << own.name << " on " << other.name;
                }
                if (!own.detail.empty()) continue;
                // Beside its place it is as long and has its direction.
                const auto vector = std::find_if(scene.vectors.begin(), scene.vectors.end(),
                                                 [&](const SceneVector& v) { return v.name == own.name; });
                ASSERT_NE(vector, scene.vectors.end());
                const Spot place{vector->tail.x / figure.scale, -vector->tail.y / figure.scale};
                const Spot drawn = own.tip - own.tail;
                EXPECT_NEAR(drawn.x, (vector->tip.x - vector->tail.x) / figure.scale, 1e-6);
                EXPECT_NEAR(drawn.y, -(vector->tip.y - vector->tail.y) / figure.scale, 1e-6);
                beside += length(own.tail - figure.origin - place) > 1 ? 1 : 0;
            }
        }
    }
    EXPECT_GE(beside, 6);
}

TEST(DrawnAsInBooks, OppositeVectorsOfADeadPointAreTwoArrows) {
    const Solution& solution = example("slider_crank_outer_dead_point");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts()}, 0, 100, 100);
    const DrawnAxis &a = axis_of(figure, "v_A"), &ba = axis_of(figure, "v_BA");
    EXPECT_NEAR(length(a.tip - a.tail), length(ba.tip - ba.tail), 1e-6);
    EXPECT_NEAR(std::abs(cross(unit(a.tip - a.tail), ba.tail - a.tail)), 2.2, 1e-6);
}

TEST(DrawnAsInBooks, SentencesNameTheLinesByTheirNumbers) {
    const Solution& solution = example("four_bar");
    const PolygonScene scene = polygon_scene(solution, 0);
    const LineNumbers numbers(scene);
    std::set<std::string> given;
    for (const SceneLine& line : scene.lines) given.insert(numbers.before(line.statement, line.reason));
    EXPECT_TRUE(given.contains("①\u00A0"));
    EXPECT_TRUE(given.contains("②\u00A0"));
    EXPECT_EQ(numbers.before(StatementIndex(0), scene.lines.front().reason).empty(),
              scene.lines.front().statement != StatementIndex(0));
    for (const Language language : {Language::en, Language::it}) {
        SheetOptions options;
        options.language = language;
        const auto pages = lay_out(solution, options, fonts());
        for (const char* const number : {"①", "②"}) {
            int on_lines = 0, in_sentences = 0;
            for (const Page& page : pages)
                for (const TextMark* text : texts_of(page))
                    if (text->words.find(number) != std::string::npos)
                        ++(text->cls == "label" ? on_lines : in_sentences);
            // In the polygons of velocities and of accelerations.
            EXPECT_EQ(on_lines, 2) << number;
            EXPECT_GE(in_sentences, 2) << number;
        }
    }
}

/// A planet between two wheels that drive it: its two contacts are known, and nothing was drawn between them.
const char* const planet_between_two = R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
    "points": {"O": [0, 0], "C": [30, 40], "S": [18, 24], "R": [42, 56]},
    "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 30}},
               "3": {"points": ["C"], "circle": {"centre": "C", "radius": 20}}, "4": ["O", "C"],
               "5": {"points": ["O"], "circle": {"centre": "O", "radius": 70}}},
    "joints": [{"revolute": "O", "bodies": [1, 2, 4, 5]}, {"revolute": "C", "bodies": [3, 4]},
               {"rolling": "S", "bodies": [2, 3]}, {"rolling": "R", "bodies": [3, 5]}],
    "drivers": [{"body": 2, "omega": 10}, {"body": 5, "omega": -3}], "find": ["velocity", "acceleration"]})";

/// A vector of motion that a sentence argues with is drawn by then, unless the sentence says itself what it is.
void expect_vectors_drawn(const Solution& solution) {
    constexpr std::array introducing{lang::sentences::slide_velocity,
                                     lang::sentences::slide_acceleration,
                                     lang::sentences::slide_acceleration_without_coriolis,
                                     lang::sentences::slide_velocity_on_rest,
                                     lang::sentences::slide_acceleration_on_rest,
                                     lang::sentences::rolling_point_at_rest,
                                     lang::sentences::observer_velocity,
                                     lang::sentences::observer_acceleration};
    for (const StatementIndex index : indices_of(solution.protocol.statements)) {
        const Statement& statement = solution.protocol.statements[at_index(index)];
        const bool of_motion = statement.section == Topic::velocity || statement.section == Topic::acceleration;
        const Message& said = statement.message;
        if (!of_motion || std::find(introducing.begin(), introducing.end(), said.sentence) != introducing.end())
            continue;
        for (const Argument& argument : said.arguments) {
            const auto* symbol = std::get_if<Symbol>(&argument);
            if (symbol == nullptr || (symbol->letter != Symbol::Letter::v && symbol->letter != Symbol::Letter::a))
                continue;
            const std::string words = plain(say(said, Language::en));
            if (words.find(plain(typeset(*symbol, Language::en))) == std::string::npos)
                continue;  // what it is instead is said
            const auto& vectors = solution.protocol.vectors;
            EXPECT_TRUE(std::any_of(vectors.begin(), vectors.end(), [&](const DrawnVector& vector) {
                return vector.symbol == *symbol && vector.statement <= index;
            })) << words;
        }
    }
}
TEST(DrawnAsInBooks, NoSentenceArguesWithAVectorThatIsNotDrawn) {
    for (const std::string& name : tests::example_names()) {
        SCOPED_TRACE(name);
        expect_vectors_drawn(example(name));
    }
    const Solution planet = tests::solved(planet_between_two);
    expect_vectors_drawn(planet);
    std::string words;
    for (const Statement& statement : planet.protocol.statements)
        words += plain(say(statement.message, Language::en)) + "\n";
    EXPECT_NE(words.find("v_RS* goes from s* to r. ω_3 is v_RS* divided by S*R"), std::string::npos) << words;
}

TEST(DrawnAsInBooks, ALineThatStandsAloneHasNoNumber) {
    const Solution& solution = example("four_bar");
    ASSERT_EQ(solution.protocol.polygons.size(), 2U);
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        PolygonScene scene = polygon_scene(solution, static_cast<int>(p));
        ASSERT_FALSE(scene.lines.empty()) << scene.id;
        scene.lines.resize(1);
        const LineNumbers numbers(scene);
        for (const SceneLine& line : scene.lines) EXPECT_EQ(numbers.before(line.statement, line.reason), "");
    }
}

TEST(DrawnAsInBooks, LeadersEndInADot) {
    Figure figure;
    // Strokes round the point leave its name no place nearby.
    for (int i = -12; i <= 12; ++i) {
        figure.marks.emplace_back(line({-14, 1.1 * i}, {14, 1.1 * i}, {0.2, {0, 0, 0}, {}, false}));
    }
    figure.box = box_of(figure.marks);
    LabelRequest& label = figure.labels.emplace_back();
    label.text = one_piece("A");
    label.anchor = {0, 0};
    const std::size_t before = figure.marks.size();
    constexpr Colour grey{0x12, 0x34, 0x56};
    ASSERT_TRUE(place_labels(figure, fonts(), std::nullopt, Labelling::free, grey));
    std::vector<const Path*> leader;
    for (std::size_t i = before; i < figure.marks.size(); ++i)
        if (const auto* path = std::get_if<Path>(&figure.marks[i])) leader.push_back(path);
    ASSERT_EQ(leader.size(), 2u);
    EXPECT_EQ(leader[0]->pen.colour, grey);
    EXPECT_EQ(leader[1]->fill, grey);
    EXPECT_TRUE(leader[0]->stroked);
    EXPECT_LT(leader[0]->pen.width, 0.2);
    EXPECT_TRUE(leader[1]->filled);
    const Mark dot = *leader[1];
    EXPECT_LT(length(box_of(std::span(&dot, 1)).middle()), 3);
    std::vector<Mark> marks(figure.marks.begin(), figure.marks.begin() + static_cast<std::ptrdiff_t>(before) + 2);
    drop_leader(marks, grey);
    EXPECT_EQ(marks.size(), before);
}

TEST(DrawnAsInBooks, TablesOfReadingsSayWhatAMillimetreIsWorth) {
    const auto& pages = laid_out("exam_2001");
    EXPECT_TRUE(says(pages, "mm × 0.0"));
}

/// 34.3 mm at 25 N/mm are 857.5 N: forces that are read alike have one value on the sheet, however their ends were
/// rounded.
TEST(DrawnAsInBooks, OneReadingHasOneProduct) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "units": {"length": "mm", "angular velocity": "rpm"}, "frame": 1,
      "points": {"O": [0, 0], "P": {"from": "O", "distance": 65, "angle": 35}, "C": {"from": "O", "distance": 25,
      "angle": 35},
        "D": {"from": "O", "distance": 90, "angle": 35}},
      "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 25}}, "3": ["O", "P"], "4": ["P"]},
      "joints": [{"revolute": "O", "bodies": [1, 2, 3]}, {"revolute": "P", "bodies": [3, 4]},
        {"gear": "C", "bodies": [2, 4], "arm": 3, "profiles": {"4": {"circle": "P"}}, "pressure angle": 20},
        {"gear": "D", "bodies": [4, 1], "arm": 3, "profiles": {"4": {"circle": "P"}, "1": {"circle": "O"}},
        "pressure angle": 20}],
      "drivers": [{"body": 2, "omega": 1450}], "loads": [{"couple": "u", "body": 3, "value": -85}],
      "effort": {"couple": "m", "body": 2}, "scales": {"forces": "1 mm = 25 N"}})");
    const auto pages = lay_out(solution, {}, fonts());
    EXPECT_TRUE(says(pages, "858"));
    EXPECT_FALSE(says(pages, "857"));
}

/// Teeth press at the pressure angle: their line is not the pitch curves' normal, which velocities are drawn along.
TEST(DrawnAsInBooks, TheForceOfTeethHasTheirLineOfAction) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
      "points": {"O": [0, 0], "A": {"from": "O", "distance": 40, "angle": 60},
        "C": {"meet": [{"circle": "A", "radius": 130}, {"line": "O", "angle": 0}], "side": "ahead"},
        "P": {"from": "C", "distance": 25, "angle": -90}, "Q": {"from": "C", "distance": 25, "angle": 90},
        "R": {"from": "Q", "distance": 60, "angle": 0}},
      "bodies": {"2": ["O", "A"], "3": ["A", "C"], "4": {"points": ["C"], "circle": {"centre": "C", "radius": 25}},
       "5": ["R"]},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "C",
      "bodies": [3, 4]},
        {"rolling": "P", "bodies": [4, 1], "profiles": {"1": {"line": 0}}},
        {"gear": "Q", "bodies": [4, 5], "profiles": {"5": {"line": 0}}, "pressure angle": 20},
        {"prismatic": "R", "bodies": [5, 1], "along": 0}],
      "drivers": [{"body": 2, "omega": 12}],
      "loads": [{"force": "P", "body": 5, "at": "R", "magnitude": 200, "along": 180}], "effort": {"couple": "m",
      "body": 2}})");
    const auto has_cell = [](const std::vector<Page>& pages, const std::string& words) {
        return words_of(pages).find("\n" + words + "\n") != std::string::npos;
    };
    EXPECT_TRUE(has_cell(lay_out(solution, {}, fonts()), "of action"));
    SheetOptions italian;
    italian.language = Language::it;
    EXPECT_TRUE(has_cell(lay_out(solution, italian, fonts()), "d’azione"));
}

/// A couple "m" to be found is M_m on the sheet, so it is on plots, in captions and where a number is asked for.
TEST(DrawnAsInBooks, AnEffortHasOneNameEverywhere) {
    Mechanism mechanism;
    CoupleEffort couple;
    couple.name = "m";
    ForceEffort force;
    force.name = "H";
    mechanism.efforts = {couple, force};
    Column column;
    column.kind = Column::Kind::result;
    column.quantity = {.kind = Quantity::Kind::effort, .given = 0};
    for (const Language language : {Language::en, Language::it})
        EXPECT_EQ(plain(typeset(column, mechanism, language)), "M_m");
    column.quantity.given = 1;
    for (const Language language : {Language::en, Language::it})
        EXPECT_EQ(plain(typeset(column, mechanism, language)), "F_H");
}

}  // namespace
}  // namespace drawn_as_in_books_test
