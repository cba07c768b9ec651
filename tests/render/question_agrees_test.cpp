// What question, quiz and key say of one quantity: enough to find it, one name for it, one sense in which it is
// positive.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "constructions/positions/cycle.hpp"
#include "constructions/positions/named_results.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/content/exercise_text.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/sheet/handout.hpp"
#include "render/sheet/key_sheet.hpp"
#include "render/tables/answers.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"
#include "render/text/bound_blank.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace question_agrees_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string plainly(const std::vector<RichText>& paragraphs) {
    std::string text;
    for (const RichText& each : paragraphs) text += plain(each) + "\n";
    for (const std::string blank : {"\u00A0", "\u202F", "\u2060"})
        for (std::size_t at = text.find(blank); at != std::string::npos; at = text.find(blank))
            text.replace(at, blank.size(), blank == "\u2060" ? "" : " ");
    return text;
}
std::string data_in(const Solution& solution, Language language) {
    const Theme theme;
    return plainly(data_of({solution, theme, fonts(), language}));
}
std::vector<RequestedResult> values_asked(const Solution& solution) {
    const Theme theme;
    const DrawingContext context{solution, theme, fonts()};
    std::vector<RequestedResult> asked;
    const std::vector<NamedResult> results = *asked_results(solution);
    for (const NamedResult& each : results) {
        const Unit unit = unit_of(each.column.unit, solution.mechanism.units);
        asked.push_back(
            {each.column, each.value, unit.symbol, unit.si.to_double(), asked_text(context, each.column).symbol});
    }
    return asked;
}
std::string sought_in(const Solution& solution, Language language) {
    const Theme theme;
    return plainly(sought_of({solution, theme, fonts(), language}, values_asked(solution)));
}
std::vector<render::Answer> key_in(const Solution& solution) {
    const SheetOptions options;
    const DrawingContext context{solution, options.theme, fonts()};
    std::vector<render::Answer> key =
        key_of(context, draw_solution(solution, options, fonts()).figures, values_asked(solution));
    EXPECT_FALSE(key.empty()) << "nothing is asked for";
    return key;
}
/// What a question of a problem tells as given.
std::string given_in(const Solution& solution, Language language) {
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), language};
    const std::vector<ProblemSection> sections = sections_of_problem(context);
    std::string text;
    for (std::size_t i = 0; i + sections.front().found < sections.front().sentences.size(); ++i)
        text += unbound(in(sections.front().sentences[i], language)) + "\n";
    return text;
}

TEST(ImpactQuestion, SaysWhereTheBodiesStrike) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "units": {"length": "m"}, "impact": {"bodies": {
        "A": {"mass": 2, "centre": [0, 0], "velocity": [3, 1], "inertia": 0.05},
        "B": {"mass": 3, "centre": [0.4, 0.1], "velocity": [-1, 0], "inertia": 0.08}},
        "at": [0.2, 0.05], "normal": 0, "restitution": 0.6, "friction": 0.2}})");
    const std::string english = given_in(solution, Language::en), italian = given_in(solution, Language::it);
    EXPECT_TRUE(has(english, "centre {G_1} (0, 0) m")) << english;
    EXPECT_TRUE(has(english, "centre {G_2} (0.4, 0.1) m")) << english;
    EXPECT_TRUE(has(english, "touch at {P} (0.2, 0.05) m")) << english;
    EXPECT_TRUE(has(english, "the normal {n}, from B to A, stands at 180° to the axis {x}")) << english;
    EXPECT_TRUE(has(english, "{!J} acts on A, −{!J} on B")) << english;
    EXPECT_TRUE(has(italian, "si toccano in {P} (0,2; 0,05) m")) << italian;
    EXPECT_TRUE(has(italian, "{!J} agisce su A, −{!J} su B")) << italian;
    for (const ProblemValue& each : solution.problem->values)
        if (each.name.in(Language::en).starts_with("velocity")) {
            EXPECT_TRUE(has(each.symbol, "′") && has(each.name.in(Language::en), "afterwards"))
                << each.name.in(Language::en);
        }
}

TEST(ReyeQuestion, StatesTheHypothesisAndWhatItsResultsAre) {
    const Solution disc = tests::solved(R"json({"kinegraph": 1, "units": {"length": "mm"}, "reye": {"kind": "disc",
        "force": "3 kN", "friction": 0.25, "inner": "60 mm", "outer": "120 mm", "surfaces": 2,
        "wear": "1e-8 mm³/(N m)", "omega": "100 rad/s", "time": "60 s"}})json");
    EXPECT_TRUE(has(given_in(disc, Language::en), "Reye’s hypothesis; the rings are worn in"));
    EXPECT_TRUE(has(given_in(disc, Language::it), "ipotesi di Reye; le corone sono rodate"));
    EXPECT_TRUE(has(given_in(disc, Language::en), "Coefficient of wear {k}")) << "depths are sought";
    for (const ProblemValue& each : disc.problem->values) {
        EXPECT_TRUE(each.symbol != "M" || has(each.name.in(Language::en), "worn in"));
        EXPECT_TRUE(each.symbol != "M_u" || has(each.name.in(Language::en), "when new"));
        EXPECT_TRUE(each.symbol != "p_1" || has(each.name.in(Language::it), "al raggio interno"));
    }
    EXPECT_TRUE(has(given_in(example("contact/drum_shoe"), Language::en), "(at {O}, from the direction of the pivot)"));
}

/// Two links, the second driven from the first.
const std::string arm = R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
    "points": {"O": [0, 0], "A": {"from": "O", "distance": 300, "angle": 40}, "B": {"from": "A", "distance": 200,
    "angle": -30}},
    "bodies": {"2": ["O", "A"], "3": ["A", "B"]},
    "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}],
    "loads": [{"force": "W", "body": 3, "at": "B", "value": [0, -30]}],
    "effort": [{"couple": "Mm", "body": 2}, {"couple": "Mr", "body": 3, "from": 2}], "find": ["forces"],
    "ask": ["effort Mm", "effort Mr"]})";

TEST(Effort, SaysFromWhichBodyItActs) {
    const Solution solution = tests::solved(arm);
    EXPECT_TRUE(has(sought_in(solution, Language::en), "the couple M_r on body 3, from body 2, that balances"))
        << sought_in(solution, Language::en);
    EXPECT_TRUE(has(sought_in(solution, Language::it), "il momento equilibrante M_r sul corpo 3, dal corpo 2"));
    EXPECT_TRUE(has(sought_in(solution, Language::en), "the couple M_m on body 2 that balances"))
        << "from the frame, and its letter once";
    const Theme theme;
    EXPECT_TRUE(has(plainly(signs_of({solution, theme, fonts()})), "M_r acts on body 3 from body 2"));
}

/// A boom on a cylinder.
std::string boom(const std::string& weight, const std::string& ask) {
    return R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
    "points": {"O": [0, 0], "B": {"from": "O", "distance": 1200, "angle": 35}, "D": {"from": "O", "to": "B",
    "distance": 500}, "C": [300, -200]},
    "bodies": {"2": ["O", "D", "B"], "3": ["C"], "4": ["D"]},
    "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "C", "bodies": [1, 3]}, {"revolute": "D",
    "bodies": [2, 4]},
               {"prismatic": "D", "bodies": [4, 3], "along": ["C", "D"], "name": "cyl"}],
    "drivers": [{"joint": "cyl", "speed": "0.1 m/s"}],
    "loads": [{"force": "W", "body": 2, "at": "B", "magnitude": ")" +
           weight + R"(", "along": 90}], "effort": {"force": "Fc", "joint": "cyl"}, "ask": )" + ask + "}";
}

TEST(Effort, IsToldInTheSenseThatTheQuestionNames) {
    for (const char* weight : {"-1000 N", "2000 N"}) {
        const Solution solution = tests::solved(boom(weight, R"(["effort Fc"])"));
        const std::vector<render::Answer> key = key_in(solution);
        ASSERT_EQ(key.size(), 1U);
        EXPECT_NEAR(key[0].value, values_asked(solution)[0].value, 1e-9) << "the key as the quiz";
        const Vector along = solution.pose.at(PointIndex(2)) - solution.pose.at(PointIndex(3));
        EXPECT_NEAR(*key[0].direction, std::atan2(along.y.to_double(), along.x.to_double()) * 180 / std::numbers::pi,
                    1e-9);
        EXPECT_TRUE(has(sought_in(solution, Language::en),
                        "F_c of the actuator at D that balances, on body 4 from body 3, positive from C to D"))
            << sought_in(solution, Language::en);
        EXPECT_TRUE(has(sought_in(solution, Language::it), "sul corpo 4 dal corpo 3, positiva da C verso D"));
        const Theme theme;
        EXPECT_TRUE(
            has(plainly(signs_of({solution, theme, fonts()})), "F_c acts on body 4 and is positive from C to D"));
    }
}

TEST(Driver, IsNamedAsTheSolutionNamesWhatItGives) {
    const Solution solution = tests::solved(boom("2000 N", R"(["v B", "v cyl"])"));
    const std::string data = data_in(solution, Language::en);
    EXPECT_TRUE(has(data, "At D body 4 is driven along its guide relative to body 3: v_cyl = 0.1 m/s")) << data;
    EXPECT_TRUE(has(data, "positive from C to D")) << data;
    EXPECT_TRUE(has(sought_in(solution, Language::en), "the sliding velocity v_cyl of body 4"));
    EXPECT_TRUE(has(data_in(solution, Language::it), "il corpo 4 è comandato lungo la guida rispetto al corpo 3"));
}

/// Of a coupler the point P is driven along a line that is not its path.
const std::string driven_point = R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm", "velocity": "mm/s"},
    "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 80, "angle": 70}, "O4": [150, 20],
               "B": {"meet": [{"circle": "A", "radius": 120}, {"circle": "O4", "radius": 100}], "near": [180, 140]},
               "P": {"from": "A", "to": "B", "ratio": 0.4}},
    "bodies": {"2": ["O2", "A"], "3": ["A", "B", "P"], "4": ["O4", "B"]},
    "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
    "bodies": [3, 4]},
               {"revolute": "O4", "bodies": [1, 4]}],
    "drivers": [{"body": 3, "at": "P", "along": [-3, 1], "speed": "250 mm/s", "acceleration": "-1.5 m/s²"}],
    "ask": ["v P", "alpha 4"]})";

TEST(Driver, OfAPointGivesAComponentAndNoVelocity) {
    const Solution solution = tests::solved(driven_point);
    const std::string data = data_in(solution, Language::en);
    EXPECT_TRUE(has(data, "P (body 3) is driven along the direction of (−3, 1): components v_P^∥ = 250 mm/s")) << data;
    EXPECT_FALSE(has(data, "v_P = ")) << data;
    EXPECT_TRUE(has(data_in(solution, Language::it), "P (corpo 3) è comandato lungo la direzione di (−3; 1)"));
}

TEST(Key, HasATolerance) {
    const Solution slot = tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "A": [40, 30], "C": [100, -10], "D": [150, -60]}, "bodies": {"2": ["O", "A"],
        "3": ["D"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"pin-slot": "A", "bodies": [2, 3], "arc": "C", "name": "g"},
                   {"revolute": "D", "bodies": [1, 3]}],
        "drivers": [{"body": 2, "omega": 3, "alpha": 2}], "ask": ["omega 3", "alpha 3", "v g"]})");
    for (const render::Answer& each : key_in(slot)) EXPECT_TRUE(each.tolerance) << name_of(each.symbol);
    for (const render::Answer& each : key_in(tests::solved(driven_point)))
        EXPECT_TRUE(each.tolerance) << name_of(each.symbol);
}

/// In inches: the scales of polygons are in the file's units.
TEST(Key, ReadsWhatHasNoVectorOnItsFigureInTheFilesUnits) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1,
        "units": {"length": "in", "velocity": "in/s", "acceleration": "in/s²"},
        "points": {"O2": [0, 0], "A": [1.7, 1], "O4": [6, 0], "B": {"meet": [{"circle": "A", "radius": 7},
        {"circle": "O4", "radius": 9}], "side": "left"}},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"revolute": "O4", "bodies": [1, 4]}], "drivers": [{"body": 2, "omega": 10}], "ask": ["v B"]})");
    const SheetOptions options;
    const std::vector<Figure> drawn = draw_solution(solution, options, fonts()).figures;
    const auto polygon = std::find_if(drawn.begin(), drawn.end(), [](const Figure& figure) {
        return figure.traits.measured == QuantityKind::velocity;
    });
    ASSERT_NE(polygon, drawn.end());
    const Column column = asked_columns(solution.mechanism).front();
    EXPECT_NEAR(reading_tolerance({}, drawn, column, 1, solution.mechanism), 0.5 * polygon->scale * 0.0254, 1e-12);
}

/// Stephenson's: a dyad behind a four-bar, worse at its own pin than that.
const std::string six_bar = R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": "telaio",
    "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 50, "angle": 75}, "O4": [160, 10],
               "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 110}], "side": "left"},
               "C": {"from": "A", "distance": 110, "angle": 35, "relative to": ["A", "B"]}, "O6": [-40, 190],
               "D": {"meet": [{"circle": "C", "radius": 130}, {"circle": "O6", "radius": 90}], "side": "left"}},
    "bodies": {"2": ["O2", "A"], "3": ["A", "B", "C"], "4": ["O4", "B"], "5": ["C", "D"], "6": ["O6", "D"]},
    "joints": [{"revolute": "O2", "bodies": ["telaio", 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
    "bodies": [3, 4]},
               {"revolute": "O4", "bodies": ["telaio", 4]}, {"revolute": "C", "bodies": [3, 5]}, {"revolute": "D",
               "bodies": [5, 6]},
               {"revolute": "O6", "bodies": ["telaio", 6]}],
    "drivers": [{"body": 2, "omega": 12}], "loads": [{"couple": "Mr", "body": 6, "value": "-5 N m"}],
    "effort": {"couple": "Mm", "body": 2}, "ask": ["transmission angle"]})";

TEST(TransmissionAngle, IsTheLeastOfAllCouplersAndSaysWhere) {
    const Solution solution = tests::solved(six_bar);
    const std::vector<NamedResult> results = *asked_results(solution);
    ASSERT_EQ(results.size(), 1U);
    // By the cosine rule over a turn: the four-bar has 47.2° at B, the dyad less.
    EXPECT_NEAR(results[0].value * 180 / std::numbers::pi, 38.3, 0.1);
    EXPECT_TRUE(has(sought_in(solution, Language::en), "of the whole travel, that at D (body 5 on body 6)"))
        << sought_in(solution, Language::en);
    EXPECT_TRUE(has(sought_in(solution, Language::it), "di tutta la corsa, quello in D (corpo 5 sul corpo 6)"));
}

TEST(Angle, SaysOfWhichLineItIs) {
    std::string text = driven_point;
    const std::string asked = R"(["v P", "alpha 4"])";
    text.replace(text.find(asked), asked.size(), R"(["angle 3", "angle 4"])");
    const Solution solution = tests::solved(text);
    EXPECT_TRUE(has(sought_in(solution, Language::en), "of body 3: of AB, from A to B, from the axis x"))
        << sought_in(solution, Language::en);
    EXPECT_TRUE(has(sought_in(solution, Language::it), "del corpo 4 sull’asse x: di O_4B, da O_4 verso B"))
        << sought_in(solution, Language::it);
}

TEST(Question, SaysWhichTurningIsPositive) {
    const Solution turns = tests::solved(arm), slides = tests::solved(boom("2000 N", R"(["v B"])"));
    SheetOptions options;
    options.kind = SheetKind::question;
    EXPECT_TRUE(has(words_of(lay_out(turns, options, fonts())), "counter-clockwise"));
    EXPECT_FALSE(has(words_of(lay_out(slides, options, fonts())), "counter-clockwise"))
        << "nothing that turns is asked for";
    options.language = Language::it;
    EXPECT_TRUE(has(words_of(lay_out(turns, options, fonts())), "antiorario"));
}

/// At rest no velocities are spoken of.
TEST(Question, AtRestSpeaksOfNoVelocities) {
    SheetOptions options;
    options.kind = SheetKind::question;
    const Solution at_rest = tests::solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [2, 0]},
        "bodies": {"2": ["A", "B"]}, "joints": [{"weld": "A", "bodies": [1, 2]}],
        "loads": [{"force": "F", "body": 2, "at": "B", "value": [0, -3]}], "find": ["forces"]})");
    const std::string words = words_of(lay_out(at_rest, options, fonts()));
    EXPECT_TRUE(has(words, "counter-clockwise")) << words;
    EXPECT_FALSE(has(words, "velocit")) << words;
}

/// What a question names it defines: the parameters of an asked expression.
TEST(Data, DefinesTheParametersThatAreAskedWith) {
    const Solution solution = tests::solved(R"json({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
        "parameters": {"r": "50 mm", "n": "9 rad/s"},
        "points": {"O": [0, 0], "A": {"from": "O", "distance": "= r", "angle": 30}}, "bodies": {"2": ["O", "A"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, "omega": "= n"}],
        "ask": ["ratio = |v A|/(r*omega 2)"]})json");
    const std::string data = data_in(solution, Language::en);
    EXPECT_TRUE(has(data, "r = 50 mm.")) << data;
    EXPECT_FALSE(has(data, "n = ")) << data;
}

/// An angle of a spring is counted from somewhere.
TEST(Data, OfATorsionSpringSaysFromWhereItIsTurned) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [2, 0]},
        "bodies": {"2": ["A", "B"]}, "joints": [{"revolute": "A", "bodies": [1, 2]}], "effort": {"couple": "M", "body": 2},
        "loads": [{"spring": "t", "bodies": [2, 1], "at": "A", "stiffness": "30 N m/rad", "turned": -40}]})");
    EXPECT_TRUE(has(data_in(solution, Language::en), "is turned by −40° from where the spring is slack"));
    EXPECT_TRUE(has(data_in(solution, Language::it), "ruotato di −40° dalla posizione in cui la molla è scarica"));
}

TEST(Data, NamesTheBodiesOfASpring) {
    const std::string data = data_in(example("lever_on_springs"), Language::en);
    EXPECT_TRUE(has(data, "(body ") && has(data, "(frame)")) << data;
}

TEST(Words, OfBodiesAreThoseOfTheTrade) {
    const Solution solution = tests::solved(boom("2000 N", R"(["effort Fc"])"));
    SheetOptions options;
    options.language = Language::it;
    const std::string words = words_of(lay_out(solution, options, fonts()));
    EXPECT_TRUE(has(words, "cilindro")) << words;
    EXPECT_TRUE(has(words, "stelo")) << words;
    const std::string of_six_bar = words_of(lay_out(tests::solved(six_bar), options, fonts()));
    EXPECT_FALSE(has(of_six_bar, "telaio telaio"));
    EXPECT_FALSE(has(of_six_bar, "asta")) << "what moves between moving bodies is a coupler";
}

TEST(TitleBlock, OfAMovingPointCountsPoints) {
    const std::string words = words_of(laid_out("motion/uniform"));
    EXPECT_TRUE(has(words, "Points"));
}

TEST(TitleBlock, KeepsTheEndOfALongName) {
    SheetOptions options;
    options.author =
        "Maria Ludovica Costanza della Rovere-Montefeltro di Castelvecchio Pascoli e Borgo a Mozzano  s0123456";
    const std::vector<Page> pages = lay_out(example("four_bar"), options, fonts());
    EXPECT_TRUE(says(pages, "s0123456"));
}

class KeyFile : public tests::CommandLine {};

TEST_F(KeyFile, IsHeadedBySymbols) {
    std::string text = arm;
    const std::string first = "\"kinegraph\": 1,";
    text.replace(text.find(first), first.size(),
                 R"("kinegraph": 1, "parameters": {"W": 30}, "vary": {"W": {"choose": [30]}},)");
    text.replace(text.find("-30]"), 4, "\"= -W\"]");
    write("arm.json", text);
    const auto made = run("variants arm.json --count 1 --format svg -o out");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(has(tests::contents(folder_ / "out" / "key.csv"), "effort Mm")) << "programs read names";
    const Theme theme;
    const Solution solution = tests::solved(arm);
    const Column column = asked_columns(solution.mechanism).front();
    const RichText symbol = asked_text({solution, theme, fonts()}, column).symbol;
    const std::vector<Page> key =
        lay_out_key({"Key", {{"variant", "", true}, {column.name, "N m", false, symbol}}, {{"1", "2"}}}, {}, fonts());
    EXPECT_TRUE(says(key, "M_m"));
    EXPECT_FALSE(says(key, "effort"));
}

}  // namespace
}  // namespace question_agrees_test
