// What an exercise is handed out with: that its question can be solved from its words, that its key has what is asked
// and no more, and that figure 1 stands in one place on all sheets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/mechanism/compound_units.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/data.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/exercise_text.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/sheet/handout.hpp"
#include "render/tables/answers.hpp"
#include "render/tables/force_tables.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"

namespace question_and_key_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

/// Its slider all but rests, so that v_D is read in a detail and the couple is lost in the reading.
const std::string drag_link = R"({
  "kinegraph": 1, "units": {"length": "mm", "angular velocity": "rpm", "moment": "N m"}, "frame": 1,
  "points": {
    "O2": [0, 0], "O4": [35, 0], "A": {"from": "O2", "distance": 90, "angle": 50},
    "B": {"meet": [{"circle": "A", "radius": 110}, {"circle": "O4", "radius": 105}], "side": "left"},
    "C": {"from": "O4", "distance": 70, "angle": 180, "relative to": ["O4", "B"]},
    "D": {"meet": [{"circle": "C", "radius": 260}, {"line": "O4", "angle": 0}], "side": "ahead"}
  },
  "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B", "C"], "5": ["C", "D"], "6": ["D"]},
  "joints": [
    {"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]},
    {"revolute": "O4", "bodies": [4, 1]}, {"revolute": "C", "bodies": [4, 5]}, {"revolute": "D", "bodies": [5, 6]},
    {"prismatic": "D", "bodies": [6, 1], "along": 0, "name": "ram"}
  ],
  "drivers": [{"body": 2, "omega": "60 rpm"}],
  "loads": [{"force": "P", "body": 6, "at": "D", "magnitude": "400 N", "along": 180}],
  "effort": {"couple": "m", "body": 2},
  "scales": {"forces": "1 mm = 25 N", "closure": "1 mm = 25 N"},
  "ask": ["v D", "omega 4", "omega 5", "effort m"]
})";

const std::string overhanging_beam = R"({
  "kinegraph": 1, "units": {"length": "m", "force": "kN", "moment": "kN m"}, "frame": 0,
  "points": {"A": [0, 0], "C": [2, 0], "B": [6, 0], "D": [8, 0]},
  "bodies": {"1": ["A", "C", "B", "D"]},
  "joints": [{"revolute": "A", "bodies": [0, 1]}, {"contact": "B", "bodies": [1, 0], "tangent": 20}],
  "loads": [
    {"distributed": "q", "body": 1, "from": "C", "to": "D", "intensity": ["4 kN/m", "10 kN/m"], "along": -90},
    {"force": "P", "body": 1, "at": "D", "magnitude": 5, "along": -120}
  ]
})";

/// A dead point under load: whatever couple is asked for, none is needed.
const std::string dead_point = R"({
  "kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O": [0, 0], "A": [50, 0], "B": [200, 0]},
  "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
  "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
  "bodies": [3, 4]},
             {"prismatic": "B", "bodies": [4, 1], "along": 0}],
  "drivers": [{"body": 2, "omega": 10}], "loads": [{"force": "P", "body": 4, "at": "B", "value": [-1000, 0]}],
  "effort": {"couple": "m", "body": 2}
})";

SheetOptions of_kind(SheetKind kind, Language language = Language::en) {
    SheetOptions options;
    options.kind = kind;
    options.language = language;
    return options;
}

/// Paragraphs one a line.
std::string plainly(const std::vector<RichText>& paragraphs) {
    std::string text;
    for (const RichText& each : paragraphs) text += plain(each) + "\n";
    return text;
}
std::string data_in(const Solution& solution, Language language) {
    const Theme theme;
    return plainly(data_of({solution, theme, fonts(), language}));
}
std::string scales_in(const Solution& solution, Language language) {
    const SheetOptions options = of_kind(SheetKind::solution, language);
    const DrawingContext context{solution, options.theme, fonts(), language};
    const DrawnSheet sheet = draw_solution(solution, options, fonts());
    return plainly(
        scales_of(context, sheet.figures, answers_sought(solution.mechanism, answers_of(context, sheet.figures))));
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::map<std::string, Spot> joints_of(const Page& page) {
    std::map<std::string, Spot> joints;
    for (std::size_t k = 0; k < page.marks.size(); ++k) {
        const auto* group = std::get_if<GroupBegin>(&page.marks[k]);
        if (!group || group->cls != "joint") continue;
        std::vector<Mark> marks;
        for (std::size_t i = k + 1; !std::holds_alternative<GroupEnd>(page.marks[i]); ++i)
            marks.push_back(page.marks[i]);
        if (!marks.empty()) joints.emplace(group->id.text(), box_of(marks).middle());
    }
    return joints;
}

/// Of the joints of figure 1, mm.
double span_of(const std::map<std::string, Spot>& joints) {
    Box box{joints.begin()->second, joints.begin()->second};
    for (const auto& [id, at] : joints) box.include(at);
    return std::max(box.width(), box.height());
}
constexpr double too_small_for_data = 20;  // mm, of a mechanism

const char* const toggle_press =
    R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm", "force": "kN", "moment": "N m"}, "points": {"O": [0,
    0], "A": {"from": "O", "distance": 60, "angle": 100}, "C": [200, 150], "B": {"meet": [{"circle": "A",
    "radius": 190}, {"circle": "C", "radius": 150}], "side": "right"}, "D": {"meet": [{"line": "C", "angle": -90},
    {"circle": "B", "radius": 160}], "side": "ahead"}}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["C",
    "B"], "5": ["B", "D"], "6": ["D"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A",
    "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4, 5]}, {"revolute": "C", "bodies": [1, 4]}, {"revolute":
    "D", "bodies": [5, 6]}, {"prismatic": "D", "bodies": [6, 1], "along": -90, "name": "ram"}], "drivers":
    [{"body": 2, "omega": "-40 rpm"}], "loads": [{"force": "Q", "body": 6, "at": "D", "pressure": "80 bar",
    "area": "12 cm²", "along": 90}], "effort": {"couple": "M", "body": 2}})";

TEST(Data, SaysHowASupportRuns) {
    const Solution beam = tests::solved(overhanging_beam), roof = example("truss_roof_wind");
    EXPECT_TRUE(has(data_in(beam, Language::en), "At B body 1 rests on the frame by a roller that runs along 20°."));
    EXPECT_TRUE(has(data_in(beam, Language::it),
                    "In B il corpo 1 poggia sul telaio con un carrello che scorre in direzione 20°."));
    EXPECT_TRUE(has(data_in(roof, Language::en), "by a roller that runs along the direction of (4, −3)"));
    EXPECT_TRUE(has(data_in(roof, Language::en), "can only push bar EG, along the direction of (3, 4)"));
    EXPECT_TRUE(has(data_in(roof, Language::it), "con un carrello che scorre lungo la direzione di (4; −3)"));
}

TEST(Data, SaysWhichBodiesMeetInAHinge) {
    const Solution& roof = example("truss_roof_wind");
    EXPECT_TRUE(has(data_in(roof, Language::en), "Hinges: A (frame, AB, AG), B (AB, BC, BG)"));
    EXPECT_TRUE(has(data_in(roof, Language::it), "Cerniere: A (telaio, AB, AG), B (AB, BC, BG)"));
    const Solution pump = tests::solved(drag_link);
    EXPECT_TRUE(has(data_in(pump, Language::en), "At D body 6 slides on a guide of the frame along 0°."));
    EXPECT_TRUE(has(data_in(pump, Language::en), "on the left of the way from A to O"));
    EXPECT_TRUE(has(data_in(pump, Language::it), "In D il corpo 6 scorre su una guida del telaio in direzione 0°."));
}

/// Beyond its coordinates.
TEST(Data, NamesEveryJoint) {
    std::size_t joints = 0;
    for (const std::string& name : example_names())
        for (const Language language : {Language::en, Language::it}) {
            const Solution& solution = example(name);
            const Theme theme;
            std::string said;
            for (const RichText& each : data_of({solution, theme, fonts(), language}))
                if (!has(plain(each), word(lang::data::coordinates, language).substr(0, 8))) said += plain(each) + "\n";
            EXPECT_FALSE(has(said, "{")) << name << ": " << said;
            for (const Joint& joint : solution.mechanism.joints) {
                const std::string& point = solution.mechanism.point(joint.point).name;
                EXPECT_TRUE(has(said, plain(typeset(Symbol{Symbol::Letter::point, point, ""}, language))))
                    << name << ": " << point;
                ++joints;
            }
        }
    EXPECT_GT(joints, example_names().size());
}

TEST(Data, TellsForcesPerLengthInTheFilesUnits) {
    EXPECT_TRUE(has(data_in(tests::solved(overhanging_beam), Language::en), "from 4 kN/m to 10 kN/m"));
    EXPECT_TRUE(says(lay_out(tests::solved(overhanging_beam), of_kind(SheetKind::question), fonts()), "= 4 kN/m"));
    Units units;
    EXPECT_EQ(unit_of_force_per_length(units).symbol, "N/m");
    units.length = {"mm", Exact::ratio(1, 1000)};
    EXPECT_EQ(unit_of_force_per_length(units).symbol, "N/mm");
    EXPECT_EQ(unit_of_force_per_length(units).si, Exact(1000));
    units.force = {"kN", 1000};
    EXPECT_EQ(unit_of_force_per_length(units).symbol, "kN/m") << "nobody writes kN/mm";
    units.moment = {"N mm", Exact::ratio(1, 1000)};
    EXPECT_EQ(unit_of_torsional_stiffness(units).symbol, "N mm/rad");
}

TEST(Key, HasWhatIsAskedInTheOrderOfTheSolution) {
    const Solution solution = tests::solved(drag_link);
    const SheetOptions options = of_kind(SheetKind::answers);
    const DrawingContext context{solution, options.theme, fonts()};
    const DrawnSheet sheet = draw_solution(solution, of_kind(SheetKind::solution), fonts());
    std::vector<std::string> names;
    for (const render::Answer& each : key_of(context, sheet.figures, {})) names.push_back(name_of(each.symbol));
    EXPECT_EQ(names, (std::vector<std::string>{"v_D", "omega_4", "omega_5", "M_m"}));
    const auto pages = lay_out(solution, options, fonts());
    EXPECT_FALSE(says(pages, "Instant centres") && says(pages, "Accelerations"));
}

/// The velocities that accelerations begin with are on the way.
TEST(Key, HasWhatFindStates) {
    Solution solution = example("four_bar");
    solution.mechanism.find = Find{};
    solution.mechanism.find.stated = solution.mechanism.find.acceleration = true;
    const auto pages = lay_out(solution, of_kind(SheetKind::answers), fonts());
    EXPECT_TRUE(says(pages, "Accelerations"));
    EXPECT_FALSE(says(pages, "Velocities"));
    EXPECT_TRUE(has(scales_in(solution, Language::en), "Velocity polygon: ")) << "it is drawn all the same";
}

/// A component that is asked for is told with the tolerance of its vector, an angle before all.
TEST(Key, TellsComponentsAndAnglesByTheirValues) {
    std::string text = drag_link;
    const std::string asked = R"("ask": ["v D", "omega 4", "omega 5", "effort m"])";
    text.replace(text.find(asked), asked.size(), R"("ask": ["vx B", "angle 4"])");
    const Solution solution = tests::solved(text);
    const SheetOptions options;
    const DrawingContext context{solution, options.theme, fonts()};
    const DrawnSheet sheet = draw_solution(solution, options, fonts());
    std::vector<RequestedResult> asked_for;
    for (const Column& column : asked_columns(solution.mechanism)) asked_for.push_back({column, 0.25, "m/s"});
    const std::vector<render::Answer> key = key_of(context, sheet.figures, asked_for);
    ASSERT_EQ(key.size(), 2U);
    EXPECT_EQ(key[0].section, Topic::unnamed);
    EXPECT_EQ(key[1].section, Topic::velocity);
    ASSERT_TRUE(key[1].tolerance);
    for (const Figure& figure : sheet.figures)
        if (figure.traits.measured == QuantityKind::velocity) {
            EXPECT_NEAR(*key[1].tolerance, 0.5 * figure.scale, 1e-9);
        }
}

/// An offset slider-crank under load, at whose pins and guide forces act.
std::string loaded_slider(const std::string& ask) {
    return R"({
      "kinegraph": 1, "units": {"length": "mm", "moment": "N m"}, "frame": 1,
      "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 60},
                 "B": {"meet": [{"circle": "A", "radius": 200}, {"line": [0, 15], "angle": 0}], "side": "right"}},
      "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
      "bodies": [3, 4]},
                 {"prismatic": "B", "name": "guide", "bodies": [4, 1], "along": 0}],
      "drivers": [{"body": 2, "omega": 20}], "loads": [{"force": "P", "body": 4, "at": "B", "value": [-800, 100]},
      {"couple": "T", "body": 4, "value": 5}],
      "effort": {"couple": "M", "body": 2}, "find": ["velocity", "acceleration", "forces"], "ask": )" +
           ask + "}";
}
/// A slider on a link that turns, its guide named by two points.
std::string inverted_slider(const std::string& ask) {
    return R"({
      "kinegraph": 1, "units": {"length": "mm", "velocity": "m/s"}, "frame": 0,
      "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 60, "angle": 40}, "O4": [-35, -120],
                 "C": {"from": "O4", "to": "A", "distance": 260}, "D": {"from": "C", "distance": 90, "angle": 10}},
      "bodies": {"2": ["O2", "A"], "3": ["A"], "4": ["O4", "C", "D"]},
      "joints": [{"revolute": "O2", "bodies": [0, 2]}, {"revolute": "A", "bodies": [2, 3]},
                 {"prismatic": "A", "name": "S", "bodies": [3, 4], "along": ["O4", "C"]}, {"revolute": "O4",
                 "bodies": [0, 4]}],
      "drivers": [{"body": 2, "omega": -24, "alpha": 4}], "find": ["velocity", "acceleration"], "ask": )" +
           ask + "}";
}
/// With blanks that do not break a line as blanks.
std::string plain_of(std::string words) {
    for (const std::string blank : {"\u00A0", "\u202F", "\u2060"})
        for (std::size_t at = words.find(blank); at != std::string::npos; at = words.find(blank))
            words.replace(at, blank.size(), blank == "\u2060" ? "" : " ");
    return words;
}
/// The results by name with their values, as a program hands them to the key.
std::vector<RequestedResult> values_asked(const Solution& solution) {
    std::vector<RequestedResult> asked;
    const Theme theme;
    const DrawingContext context{solution, theme, fonts()};
    const std::vector<NamedResult> results = *asked_results(solution);
    for (const NamedResult& each : results) {
        const Unit unit = unit_of(each.column.unit, solution.mechanism.units);
        asked.push_back(
            {each.column, each.value, unit.symbol, unit.si.to_double(), asked_text(context, each.column).symbol});
    }
    return asked;
}
std::vector<render::Answer> key_in(const Solution& solution) {
    const SheetOptions options;
    const DrawingContext context{solution, options.theme, fonts()};
    return key_of(context, draw_solution(solution, options, fonts()).figures, values_asked(solution));
}

/// Each direction by the components of the force on that body.
TEST(Key, HasTheForceThatIsAskedForAndNotItsReaction) {
    const Solution solution = tests::solved(loaded_slider(
        R"(["F A 3 on 2", "F A 2 on 3", "F O 1 on 2", "F O 2 on 1", "F guide 4 on 1", "C guide 1 on 4",
        "C guide 4 on 1"])"));
    const std::vector<render::Answer> key = key_in(solution);
    ASSERT_EQ(key.size(), 7U);
    std::map<std::string, render::Answer> by_name;
    for (const render::Answer& each : key) by_name.emplace(name_of(each.symbol), each);
    ASSERT_EQ(by_name.size(), 7U) << "no row twice";
    const std::vector<NamedResult> results = named_results(solution);
    const auto value = [&](const std::string& name) {
        return std::find_if(results.begin(), results.end(),
                            [&](const NamedResult& each) { return each.column.name == name; })
            ->value;
    };
    for (const auto& [symbol, action] : std::map<std::string, std::string>{{"F_32", "A 3 on 2"},
                                                                           {"F_23", "A 2 on 3"},
                                                                           {"F_12", "O 1 on 2"},
                                                                           {"F_21", "O 2 on 1"},
                                                                           {"F_41", "guide 4 on 1"}}) {
        ASSERT_TRUE(by_name.contains(symbol) && by_name.at(symbol).direction) << symbol;
        const double angle = *by_name.at(symbol).direction * std::numbers::pi / 180, size = by_name.at(symbol).value;
        EXPECT_NEAR(size * std::cos(angle), value("Fx " + action), 1e-6) << symbol;
        EXPECT_NEAR(size * std::sin(angle), value("Fy " + action), 1e-6) << symbol;
    }
    EXPECT_EQ(by_name.at("M_14").value, value("C guide 1 on 4"));
    EXPECT_EQ(by_name.at("M_41").value, value("C guide 4 on 1"));
}

/// A scalar with a sign needs its positive sense, in question and key alike, and the name that the solution gives the
/// vector.
TEST(Sliding, IsAskedForWithBodiesAndPositiveSense) {
    const Solution inverted = tests::solved(inverted_slider(R"(["v S", "a S"])"));
    const Solution slider = tests::solved(loaded_slider(R"(["v guide"])"));
    const Theme theme;
    const auto asks = [&](const Solution& solution, Language language) {
        return plainly(sought_of({solution, theme, fonts(), language}));
    };
    EXPECT_TRUE(has(asks(inverted, Language::en), "v_AA* of body 3 relative to body 4 at A, positive from O_4 to C"));
    EXPECT_TRUE(
        has(asks(inverted, Language::it), "v_AA* del corpo 3 rispetto al corpo 4 in A, positiva da O_4 verso C"));
    EXPECT_TRUE(has(asks(slider, Language::en), "v_B of body 4 relative to the frame at B, positive along 0°"));
    EXPECT_TRUE(has(asks(slider, Language::it), "v_B del corpo 4 rispetto al telaio in B, positiva lungo 0°"));
    for (const Solution* solution : {&inverted, &slider}) {
        const std::vector<NamedResult> asked = *asked_results(*solution);
        const std::vector<render::Answer> key = key_in(*solution);
        ASSERT_EQ(key.size(), asked.size());
        EXPECT_LT(key[0].value, 0);
        EXPECT_EQ(key[0].value, asked[0].value / solution->mechanism.units.velocity.si.to_double());
        ASSERT_TRUE(key[0].direction);
    }
    const Vector guide = inverted.pose.at(PointIndex(3)) - inverted.pose.at(PointIndex(2));
    EXPECT_NEAR(*key_in(inverted)[0].direction,
                std::atan2(guide.y.to_double(), guide.x.to_double()) * 180 / std::numbers::pi, 1e-9);
    EXPECT_EQ(*key_in(slider)[0].direction, 0);
    EXPECT_TRUE(has(plainly(signs_of({inverted, theme, fonts(), Language::en})),
                    "relative to body 4 at A is positive from O_4 to C"));
}

TEST(Key, HasEachHeadingOnceInTheOrderOfTheSolution) {
    const Solution solution = tests::solved(inverted_slider(R"(["a S", "v S", "ax D", "angle 4", "vx D", "omega 4"])"));
    std::vector<Topic> sections;
    for (const render::Answer& each : key_in(solution))
        if (sections.empty() || sections.back() != each.section) sections.push_back(each.section);
    EXPECT_EQ(sections, (std::vector<Topic>{Topic::unnamed, Topic::velocity, Topic::acceleration}));
}

/// By the names of the solution, tension positive.
TEST(Bars, AreAskedForAsTheSolutionNamesThem) {
    const Solution truss =
        tests::solved(tests::contents(tests::fs::path(KINEGRAPH_EXAMPLES_DIR) / "variants" / "truss.json"));
    const Theme theme;
    for (const Language language : {Language::en, Language::it}) {
        const std::string sought = plainly(sought_of({truss, theme, fonts(), language}));
        EXPECT_TRUE(has(sought, language == Language::it ? "lo sforzo F_AD nell’asta AD, positivo di trazione"
                                                         : "the force F_AD in the bar AD, tension positive"))
            << sought;
        EXPECT_TRUE(has(plainly(signs_of({truss, theme, fonts(), language})),
                        language == Language::it ? "trazione" : "tension"));
    }
    const std::vector<render::Answer> key = key_in(truss);
    const std::vector<NamedResult> asked = *asked_results(truss);
    ASSERT_EQ(key.size(), 3U);
    for (const NamedResult& each : asked) {
        const auto row = std::find_if(key.begin(), key.end(), [&](const render::Answer& answer) {
            return answer.quantity == each.column.quantity;
        });
        ASSERT_NE(row, key.end()) << each.column.name;
        EXPECT_NEAR(row->value, each.value / truss.mechanism.units.force.si.to_double(), 1e-9)
            << "the quiz asks for the same";
    }
    EXPECT_LT(asked[0].value, 0) << "the rafter is compressed";
}

TEST(Scales, AreThoseOfWhatIsSought) {
    const Solution solution = tests::solved(drag_link);
    const std::string scales = scales_in(solution, Language::en);
    EXPECT_TRUE(has(scales, "Velocity polygon: "));
    EXPECT_FALSE(has(scales, "Acceleration")) << scales;
    EXPECT_TRUE(has(scales, "Forces: "));
    EXPECT_TRUE(has(scales_in(example("four_bar"), Language::en), "Acceleration"))
        << "where nothing is asked for by name";
}

/// The tolerance of what is read in a detail is half a millimetre at its scale, which the question names.
TEST(Scales, NameTheDetailsThatAnswersAreReadIn) {
    const Solution solution = tests::solved(drag_link);
    for (const Language language : {Language::en, Language::it}) {
        const std::string words =
            language == Language::it ? ", particolare per v_D: 1 mm ≙ " : ", detail for v_D: 1 mm ≙ ";
        const std::string scales = scales_in(solution, language);
        const std::size_t at = scales.find(words);
        ASSERT_NE(at, std::string::npos) << scales;
        const SheetOptions options = of_kind(SheetKind::solution, language);
        const DrawingContext context{solution, options.theme, fonts(), language};
        const DrawnSheet sheet = draw_solution(solution, options, fonts());
        int found = 0;
        for (const render::Answer& each : key_of(context, sheet.figures, {}))
            if (name_of(each.symbol) == "v_D") {
                ASSERT_TRUE(each.tolerance);
                EXPECT_EQ(scales.substr(at + words.size()).find(number(2 * *each.tolerance, 1, language)), 0U)
                    << scales;
                ++found;
            }
        EXPECT_GT(found, 0);
    }
}

TEST(Scales, OfATrussSayOfWhichDiagramTheyAre) {
    for (const Language language : {Language::en, Language::it}) {
        const std::string scales = scales_in(example("truss_simple"), language);
        EXPECT_TRUE(has(scales, word(lang::sheet::cremona, language) + ": ")) << scales;
        EXPECT_TRUE(has(scales, word(lang::sheet::force_polygon, language) + ": ")) << scales;
        EXPECT_FALSE(has(scales, word(lang::sheet::sought_forces_scale, language) + ": ")) << scales;
    }
}

/// Every length, angle and radius that has room, and none twice.
TEST(Question, HasItsDataAsDimensions) {
    const auto expect = [](const Solution& solution, const std::vector<std::string>& dimensions) {
        for (const Language language : {Language::en, Language::it}) {
            const Page page = lay_out(solution, of_kind(SheetKind::question, language), fonts()).front();
            for (const std::string& each : dimensions) {
                const auto texts = texts_of(page);
                EXPECT_EQ(std::count_if(texts.begin(), texts.end(),
                                        [&](const TextMark* text) { return plain_of(text->words) == each; }),
                          1)
                    << each;
            }
        }
    };
    expect(tests::solved(inverted_slider(R"(["omega 4"])")),
           {"60 mm", "90 mm", "260 mm", "35 mm", "120 mm", "10°", "40°"});
    // Its scale is stated: the discs lie in each other, and drawn smaller there is no way out for the innermost one's.
    expect(tests::solved(R"({
      "kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "scales": {"mechanism": "1:2"},
      "points": {"O": [0, 0], "S": [30, 0], "P": [50, 0], "R": [70, 0]},
      "bodies": {"2": {"points": ["O", "S"], "circle": {"centre": "O", "radius": 30}},
                 "3": {"points": ["P", "S"], "circle": {"centre": "P", "radius": 20}}, "4": ["O", "P"],
                 "5": {"points": ["O", "R"], "circle": {"centre": "O", "radius": 70}}},
      "joints": [{"revolute": "O", "bodies": [1, 2, 4, 5]}, {"revolute": "P", "bodies": [3, 4]},
                 {"rolling": "S", "bodies": [2, 3]}, {"rolling": "R", "bodies": [3, 5]}],
      "drivers": [{"body": 2, "omega": 10}, {"body": 5, "omega": 0}]})"),
           {"R 20 mm", "R 30 mm", "R 70 mm"});
}

/// By which others are placed and to which a dimension goes, though no body carries it.
TEST(Question, DrawsWhatItsDataNames) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 50, "angle": 30}, "O4": [150, 0],
                   "T": {"from": "O4", "to": "A", "ratio": 0.5}, "far": [4000, 0],
                   "B": {"meet": [{"circle": "T", "radius": 60}, {"circle": "O4", "radius": 100}], "side": "left"}},
        "bodies": {"2": ["O2", "A"], "3": ["A"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"prismatic": "B", "bodies": [3, 4], "along": ["B", "A"]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": "10 rad/s"}]})");
    const Page page = lay_out(solution, of_kind(SheetKind::question), fonts()).front();
    std::vector<std::string> names;
    for (const TextMark* text : texts_of(page)) names.push_back(plain_of(text->words));
    EXPECT_EQ(std::count(names.begin(), names.end(), "T"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "far"), 0) << "it would make the mechanism a dot";
}

/// Far centres, long captions and few pages make a mechanism small, above all in a brief solution. A question has it
/// large enough for its data.
TEST(Question, ShowsTheMechanismLargeEnough) {
    const auto span = [](const Solution& solution, SheetKind kind, SolutionDetail detail, Language language) {
        SheetOptions options = of_kind(kind);
        options.language = language;
        options.detail = detail;
        return span_of(joints_of(lay_out(solution, options, fonts()).front()));
    };
    EXPECT_GT(span(example("three_hinged_arch"), SheetKind::question, SolutionDetail::brief, Language::en),
              too_small_for_data);
    EXPECT_GT(span(example("peaucellier"), SheetKind::question, SolutionDetail::full, Language::it), 50);
    EXPECT_GT(span(tests::solved(toggle_press), SheetKind::question, SolutionDetail::full, Language::en), 50);
}

/// A short offset has its arrows and its text outside.
TEST(Question, HasAShortOffsetAsADimension) {
    const Page page =
        lay_out(tests::solved(loaded_slider(R"(["omega 3"])")), of_kind(SheetKind::question), fonts()).front();
    const auto texts = texts_of(page);
    for (const std::string each : {"15 mm", "50 mm", "200 mm", "60°"})
        EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [&](const TextMark* text) {
            return plain_of(text->words) == each;
        })) << each;
}

TEST(Question, KeepsItsListsWhole) {
    std::string text = loaded_slider(R"(["v guide", "a B", "alpha 3", "F A 3 on 2", "F guide 4 on 1", "effort M"])");
    const std::string first = "\"kinegraph\": 1,";
    text.replace(text.find(first), first.size(), R"("kinegraph": 1, "scales": {"mechanism": "1:1"},)");
    const std::vector<Page> pages = lay_out(tests::solved(text), of_kind(SheetKind::question), fonts());
    ASSERT_EQ(pages.size(), 1U);
    const auto place_of = [&](const std::string& words) {
        for (const TextMark* each : texts_of(pages.front()))
            if (each->words.find(words) != std::string::npos) return each->glyphs.front().origin.x;
        return -1.0;
    };
    EXPECT_GT(place_of("Velocity polygon:"), 0);
    EXPECT_NEAR(place_of("Mechanism:"), place_of("Velocity polygon:"), 0.1) << "in one column";
    EXPECT_NEAR(place_of("the acceleration"), place_of("the couple"), 0.1) << "in one column";
}

TEST(Question, NamesEachRoomByWhatIsDrawnInIt) {
    const Solution solution = tests::solved(loaded_slider(R"(["F A 3 on 2", "F guide 4 on 1"])"));
    for (const Language language : {Language::en, Language::it}) {
        SheetOptions options = of_kind(SheetKind::question, language);
        options.grid = true;
        std::multiset<std::string> rooms;
        for (const Page& page : lay_out(solution, options, fonts()))
            for (const Mark& mark : page.marks)
                if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "room")
                    rooms.insert(group->title);
        EXPECT_GT(rooms.size(), 1U);
        for (const std::string& each : rooms) EXPECT_EQ(rooms.count(each), 1U) << each;
    }
}

TEST(Data, TellsAShortFractionAsSuch) {
    std::string text = loaded_slider(R"(["omega 3"])");
    const std::string bodies = "},\n      \"bodies\": {\"2\": [\"O\", \"A\"], \"3\": [\"A\", \"B\"]";
    ASSERT_NE(text.find(bodies), std::string::npos);
    text.replace(text.find(bodies), bodies.size(),
                 R"(, "G": {"from": "A", "to": "B", "ratio": "= 1/3"}, "H": {"from": "A", "to": "B", "ratio": "= 1/2"}},
      "bodies": {"2": ["O", "A"], "3": ["A", "B", "G", "H"])");
    const std::string data = data_in(tests::solved(text), Language::en);
    EXPECT_TRUE(has(data, "AG = 1/3 AB")) << data;
    EXPECT_TRUE(has(data, "AH = 0.5 AB")) << data;
}

/// Bars have the names of their pins, so nothing on the sheet calls them by the file's numbers, unless a reaction is
/// asked for that is one body's on another.
TEST(Question, OfATrussHasNoNumbersOfBars) {
    const auto numbers = [](const Solution& truss) {
        std::set<std::string> found;
        const Page question = lay_out(truss, of_kind(SheetKind::question), fonts()).front();
        for (const TextMark* text : texts_of(question))
            for (const char* number : {"2", "3", "4", "5", "6", "7", "8", "9"})
                if (text->words == number) found.insert(number);
        return found;
    };
    std::string file = tests::contents(tests::example_file("truss_simple"));
    EXPECT_TRUE(numbers(tests::solved(file)).empty());
    file.insert(file.find("\"points\""), "\"ask\": [\"Fy D 1 on 4\"], ");
    const Solution by_number = tests::solved(file);
    EXPECT_EQ(numbers(by_number).size(), 8U);
    EXPECT_TRUE(has(data_in(by_number, Language::en), "Hinges: A (frame, 2, 5)"));
}

TEST(Question, OfATrussHasNoBrokenBar) {
    const Solution& solution = example("truss_roof_wind");
    std::string layer;
    int depth = 0, bars = 0;
    const Page page = lay_out(solution, of_kind(SheetKind::question), fonts()).front();
    for (const Mark& mark : page.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            if (group->cls == "links") layer = group->cls, depth = 0;
            ++depth;
        }
        if (std::holds_alternative<GroupEnd>(mark) && --depth == 0) layer.clear();
        const auto* path = std::get_if<Path>(&mark);
        if (layer == "links" && path != nullptr) {
            EXPECT_TRUE(path->pen.dashes.empty());
            ++bars;
        }
    }
    EXPECT_GT(bars, 0);
}

TEST(Key, SaysWhatNoReadingTellsFromZero) {
    const Solution solution = tests::solved(drag_link);
    for (const Language language : {Language::en, Language::it}) {
        const SheetOptions options = of_kind(SheetKind::answers, language);
        const LaidOutKey key = lay_out_key_of(solution, {}, options, fonts());
        ASSERT_EQ(key.remarks.size(), 1U);
        const std::string expected =
            language == Language::it ? "una lettura non dice nulla di M_m:" : "a reading says nothing of M_m:";
        EXPECT_TRUE(has(plain(key.remarks.front()), expected)) << plain(key.remarks.front());
    }
    EXPECT_TRUE(lay_out_key_of(example("four_bar"), {}, of_kind(SheetKind::answers), fonts()).remarks.empty());
}

TEST(FigureOne, StandsWhereTheSolutionHasIt) {
    const auto expect_in_place = [](const Solution& solution, const Page& solved, const std::string& name) {
        const auto joints = joints_of(solved);
        for (const SheetKind kind : {SheetKind::question, SheetKind::answers}) {
            const auto same = joints_of(lay_out(solution, of_kind(kind), fonts()).front());
            // A question shows larger what its solution has too small for data.
            if (kind == SheetKind::question && !joints.empty() && span_of(joints) < too_small_for_data) continue;
            for (const auto& [id, at] : joints) {
                if (!same.contains(id)) continue;
                EXPECT_LT(length(same.at(id) - at), 0.01) << name << ": " << id;
            }
        }
    };
    const Solution pump = tests::solved(drag_link);
    expect_in_place(pump, lay_out(pump, {}, fonts()).front(), "drag link");
    int turn = 0;
    for (const std::string& name : example_names())
        if (++turn % unless_sanitized(1, 4) == 0) expect_in_place(example(name), laid_out(name).front(), name);
}

TEST(Effort, ThatIsNothingIsToldAndHasItsRow) {
    const Solution solution = tests::solved(dead_point);
    for (const Language language : {Language::en, Language::it}) {
        const SheetOptions options = of_kind(SheetKind::solution, language);
        EXPECT_TRUE(says(lay_out(solution, options, fonts()), "M_m\u00A0=\u00A00"));
        const DrawingContext context{solution, options.theme, fonts(), language};
        const std::vector<ResultRow> rows = force_rows(context, {});
        EXPECT_EQ(std::count_if(rows.begin(), rows.end(),
                                [](const ResultRow& row) { return row.name == "M_m" && row.drawing == 0; }),
                  1);
    }
}

TEST(Table, SaysNothingWhereRoundedDecimalsLeaveARest) {
    // A cam's flank whose centre is off by a hundred-billionth: the follower does not speed up.
    const Solution solution = tests::solved(R"({
      "kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
      "points": {"O": [0, 0], "K": [24.1107366011, -0.6155376401957], "C": [27.32725201899, 52.66613622885],
                 "P": {"from": "C", "to": "K", "distance": 9}, "Q": [95, 10]},
      "bodies": {"2": {"points": ["O", "K"], "circle": {"centre": "K", "radius": 44.37867309816}},
                 "3": {"points": ["C", "Q"], "circle": {"centre": "C", "radius": 9}}},
      "joints": [{"revolute": "O", "bodies": [1, 2]},
                 {"contact": "P", "bodies": [3, 2], "profiles": {"2": {"circle": "K"}, "3": {"circle": "C"}}},
                 {"revolute": "Q", "bodies": [1, 3]}],
      "drivers": [{"body": 2, "omega": 20.94395102393}]})");
    ASSERT_FALSE(solution.bodies[2].alpha->is_zero()) << "the record keeps its number";
    const std::string table = results_table(solution, Language::en);
    EXPECT_FALSE(has(table, "10⁻¹³")) << table;
}

TEST(Words, AgreeInNumber) {
    const std::string table = results_table(example("four_bar"), Language::it);
    EXPECT_TRUE(has(table, "1 effettivo in questa configurazione")) << table;
}

class AnswersLine : public tests::CommandLine {};

TEST_F(AnswersLine, SaysOnTheTerminalWhatNoReadingTells) {
    write("pump.json", drag_link);
    const auto key = run("solve pump.json --sheet answers -o key.svg");
    EXPECT_EQ(key.status, 0) << key.err;
    EXPECT_TRUE(has(key.err, "remark: At this scale a reading says nothing of M_m")) << key.err;
    EXPECT_FALSE(has(run("solve pump.json --sheet question -o q.svg").err, "a reading says nothing"));
}

TEST_F(AnswersLine, SaysOfVariantsWhichAnswersNoReadingTells) {
    std::string text = drag_link;
    const std::string first = "\"kinegraph\": 1,", angle = "\"angle\": 50}";
    text.replace(text.find(angle), angle.size(), "\"angle\": \"= phi\"}");
    text.replace(text.find(first), first.size(),
                 R"("kinegraph": 1, "parameters": {"phi": "50°"}, "vary": {"phi": {"choose": ["50°"]}},)");
    write("pump.json", text);
    for (const char* language : {"en", "it"}) {
        const auto made = run("variants pump.json --count 1 --for csv --format svg --lang " + std::string(language) +
                              " -o out-" + language);
        EXPECT_EQ(made.status, 0) << made.err;
        EXPECT_TRUE(has(made.err, language == std::string("en") ? "a reading says nothing of effort m"
                                                                : "una lettura non dice nulla di effort m"))
            << made.err;
    }
}

}  // namespace
}  // namespace question_and_key_test
