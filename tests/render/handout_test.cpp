// Questions, keys and brief solutions: what they say, what they keep to themselves, and that nothing on them covers
// anything.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "lang/keys/sentences.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/tables/answers.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"

namespace handout_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

SheetOptions of_kind(SheetKind kind, Language language = Language::en) {
    SheetOptions options;
    options.kind = kind;
    options.language = language;
    return options;
}
SheetOptions brief(Language language = Language::en) {
    SheetOptions options;
    options.detail = SolutionDetail::brief;
    options.language = language;
    return options;
}

std::set<std::string> classes_of(const std::vector<Page>& pages) {
    std::set<std::string> classes;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark)) classes.insert(group->cls);
    return classes;
}
/// Where the joints of figure 1 stand, by their ids.
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

// The acceptance of the brief solution: what a lecturer solves on two sides takes two.
TEST(Brief, ExamFitsTwoSides) {
    int exams = 0;
    for (const std::string& name : example_names()) {
        if (!name.starts_with("exam_2001")) continue;
        ++exams;
        SCOPED_TRACE(name);
        for (const Language language : {Language::en, Language::it}) {
            SheetOptions upright = brief(language);
            upright.orientation = Orientation::portrait;
            EXPECT_LE(laid_out(name, {.language = language, .detail = SolutionDetail::brief}).size(), 2U);
            // In Italian a few lines too many stand on two upright sides.
            EXPECT_LE(lay_out(example(name), upright, fonts()).size(), language == Language::it ? 3U : 2U);
        }
    }
    EXPECT_GT(exams, 0);
}

TEST(Brief, FourBarFitsOneSide) {
    for (const Language language : {Language::en, Language::it})
        for (const Orientation orientation : {Orientation::landscape, Orientation::portrait}) {
            SheetOptions options = brief(language);
            options.orientation = orientation;
            EXPECT_EQ(lay_out(example("four_bar"), options, fonts()).size(), 1U);
        }
}

TEST(Brief, HasCentresOnlyWhereTheFileAsksForThem) {
    const Solution& asked = example("four_bar");
    ASSERT_TRUE(asked.mechanism.find.stated && asked.mechanism.find.instant_centres);
    EXPECT_TRUE(classes_of(lay_out(asked, brief(), fonts())).contains("centre"));
    Solution unasked = asked;
    unasked.mechanism.find.instant_centres = false;
    const auto pages = lay_out(unasked, brief(), fonts());
    EXPECT_FALSE(classes_of(pages).contains("centre"));
    EXPECT_FALSE(says(pages, "Instant centres"));
    EXPECT_TRUE(classes_of(lay_out(unasked, {}, fonts())).contains("centre"));
}

TEST(Brief, TellsEveryAnswerOnceAndRepeatsNoSentence) {
    const Solution& solution = example("stephenson_1_driver_2");
    const auto pages = lay_out(solution, brief(), fonts());
    // The full solution, too, tells in one sentence what repeats itself.
    EXPECT_LT(words_of(pages).size(), 0.68 * static_cast<double>(words_of(lay_out(solution, {}, fonts())).size()));
    EXPECT_TRUE(says(pages, "Likewise"));
    // Of all that is found by ω = v/l one sentence is told, with the values of the others behind it.
    std::size_t sentences = 0;
    for (const Statement& statement : solution.protocol.statements)
        sentences += statement.message.sentence == lang::sentences::omega_from_pair ? 1 : 0;
    ASSERT_GT(sentences, 1U);
    const std::string words = words_of(pages);
    for (const render::Answer& answer : answers_of({solution, SheetOptions{}.theme, fonts()}, {}, false))
        EXPECT_NE(words.find(plain(typeset(answer.symbol, Language::en))), std::string::npos) << name_of(answer.symbol);
}

TEST(Brief, BarsOfTwoForcesShareABand) {
    const Solution& solution = example("scissor_lift");
    std::set<std::string> bands_with_bars;
    std::string band;
    for (const Page& page : lay_out(solution, brief(), fonts()))
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                if (group->cls == "band") band = *group->attribute("data-question");
                for (const FreeBody& body : solution.free_bodies)
                    if (!has_force_polygon(solution, body) && body.body != none &&
                        group->id.text() == "body-" + solution.mechanism.body(body.body).name)
                        bands_with_bars.insert(band);
            }
    EXPECT_EQ(bands_with_bars.size(), 1U);
}

/// The letters that stand in figures, and what the sentences outside of them say.
struct ShownAndSaid {
    std::set<std::string> letters;
    std::set<StatementIndex> said;
};
ShownAndSaid shown_and_said(const std::vector<Page>& pages) {
    ShownAndSaid all;
    for (const Page& page : pages) {
        std::vector<std::string> classes;
        for (const Mark& mark : page.marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) classes.push_back(group->cls);
            if (std::holds_alternative<GroupEnd>(mark)) classes.pop_back();
            const auto* text = std::get_if<TextMark>(&mark);
            if (text == nullptr) continue;
            const bool in_figure = std::find(classes.begin(), classes.end(), "figure") != classes.end();
            if (!in_figure && text->statement != none) all.said.insert(text->statement);
            std::istringstream words(in_figure ? text->words : std::string());
            for (std::string word; words >> word;) all.letters.insert(word);
        }
    }
    return all;
}

/// A point that is argued with is in the file, or can be seen: as a letter, or by its image in a polygon.
TEST(Brief, NamesNoPointThatNoFigureShows) {
    std::size_t said = 0;
    int turn = 0;
    for (const std::string& name : example_names())
        for (const Language language : {Language::en, Language::it}) {
            if (++turn % unless_sanitized(1, 5) != 0) continue;
            const Solution& solution = example(name);
            const ShownAndSaid sheet =
                shown_and_said(laid_out(name, {.language = language, .detail = SolutionDetail::brief}));
            said += sheet.said.size();
            const auto is_bar = [&](const std::string& bar) {
                const auto& bars = solution.truss->structure.bars;
                return std::any_of(bars.begin(), bars.end(), [&](const auto& each) { return each.name == bar; });
            };
            const auto is_known = [&](std::string point) {
                if (solution.truss && is_bar(point)) return true;
                if (point.ends_with('*')) point.pop_back();  // the same place, of another body
                const auto set = [&](Symbol::Letter letter) {
                    return plain(typeset(Symbol{letter, point, ""}, language));
                };
                const auto& joints = solution.mechanism.joints;
                return point.empty() || solution.mechanism.point_named(point) ||
                       sheet.letters.contains(set(Symbol::Letter::point)) ||
                       sheet.letters.contains(set(Symbol::Letter::image)) ||
                       std::any_of(joints.begin(), joints.end(),
                                   [&](const Joint& joint) { return joint.name == point; });
            };
            for (const StatementIndex statement : sheet.said)
                for (const Argument& argument : solution.protocol.statements[at_index(statement)].message.arguments) {
                    if (const auto* point = std::get_if<PointName>(&argument)) {
                        EXPECT_TRUE(is_known(point->name)) << name << ": " << point->name;
                    }
                    if (const auto* segment = std::get_if<kinegraph::Segment>(&argument)) {
                        EXPECT_TRUE(is_known(segment->from) && is_known(segment->to))
                            << name << ": " << segment->from << segment->to;
                    }
                }
        }
    EXPECT_GT(said, 20U);
}

TEST(Question, ShowsTheDataAndNothingOfTheSolution) {
    for (const char* name : {"four_bar", "exam_2001", "quick_return", "four_bar_weights"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        SheetOptions options = of_kind(SheetKind::question);
        options.grid = true;
        const auto pages = lay_out(solution, options, fonts());
        const std::set<std::string> classes = classes_of(pages);
        for (const char* found : {"vector", "centre", "sense", "velocity", "force"})
            EXPECT_FALSE(classes.contains(found)) << found;
        EXPECT_TRUE(classes.contains("room"));
        for (const Page& page : pages)
            for (const Mark& mark : page.marks)
                if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                    EXPECT_EQ(group->attribute("data-value"), nullptr) << group->id.text();
                    EXPECT_TRUE(group->statement == none) << group->id.text();
                }
        EXPECT_TRUE(says(pages, "Sought"));
        // No number of an answer, as the key and the tables write them.
        const std::string words = words_of(pages);
        const DrawingContext context{solution, options.theme, fonts()};
        int values = 0;
        for (const render::Answer& answer : answers_of(context, {})) {
            const std::string value = number(answer.value, 4, Language::en);
            if (value.size() < 5) continue;
            ++values;
            EXPECT_EQ(words.find(value), std::string::npos) << name_of(answer.symbol) << " = " << value;
        }
        EXPECT_GT(values, 0);
    }
}

TEST(Question, SaysEveryDatum) {
    const std::string words = words_of(lay_out(example("four_bar"), of_kind(SheetKind::question), fonts()));
    for (const char* datum : {"40 mm", "60°", "150 mm", "80 mm", "(0, 0)", "(150, 0)"})
        EXPECT_NE(words.find(datum), std::string::npos) << datum;
    // How far a guide passes beside the pin stands on the figure, too, where the figure is not as small as on an A4.
    bool offset = false;
    SheetOptions large = of_kind(SheetKind::question);
    large.paper = Paper::a3;
    for (const Page& page : lay_out(example("slider_crank_offset"), large, fonts()))
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "dimension")
                offset = offset || (group->title == "20 mm" && group->id.element.ends_with("offset"));
    EXPECT_TRUE(offset);
    const Solution& loaded = example("four_bar_weights");
    const std::string with_masses = words_of(lay_out(loaded, of_kind(SheetKind::question), fonts()));
    for (const Mass& mass : loaded.mechanism.masses)
        EXPECT_NE(with_masses.find(number((mass.mass / loaded.mechanism.units.mass.si).to_double(), 1, Language::en)),
                  std::string::npos);
}

TEST(Handouts, HaveFigureOneWhereTheSolutionHasIt) {
    for (const char* name : {"four_bar", "exam_2001", "scara", "peaucellier"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const auto joints = joints_of(lay_out(solution, {}, fonts()).front());
        ASSERT_FALSE(joints.empty());
        for (const SheetKind kind : {SheetKind::question, SheetKind::answers}) {
            const auto same = joints_of(lay_out(solution, of_kind(kind), fonts()).front());
            ASSERT_EQ(same.size(), joints.size());
            // The mechanism to its scale; where its data want more room it gives way as a whole.
            const Spot moved = same.begin()->second - joints.begin()->second;
            for (const auto& [id, at] : joints) {
                EXPECT_NEAR(same.at(id).x - at.x, moved.x, 0.01) << id;
                EXPECT_NEAR(same.at(id).y - at.y, moved.y, 0.01) << id;
            }
            if (kind == SheetKind::answers) {
                EXPECT_LT(length(moved), 0.01);
            }
        }
    }
}

TEST(Answers, HaveTheTolerancesOfTheirReadings) {
    const Solution& solution = example("four_bar");
    const SheetOptions options;
    const DrawnSheet sheet = draw_solution(solution, options, fonts());
    const DrawingContext context{solution, options.theme, fonts()};
    const std::vector<render::Answer> answers = answers_of(context, sheet.figures);
    const auto named = [&](const std::string& name) {
        const auto found = std::find_if(answers.begin(), answers.end(),
                                        [&](const render::Answer& a) { return name_of(a.symbol) == name; });
        EXPECT_NE(found, answers.end()) << name;
        return found == answers.end() ? render::Answer{} : *found;
    };
    double scale = 0;
    for (const Figure& figure : sheet.figures)
        if (figure.id == "velocity") scale = figure.scale;
    ASSERT_GT(scale, 0);
    // v_A = 4π · 0.04 m/s, normal to the crank that stands at 60° and turns clockwise.
    const render::Answer v_A = named("v_A");
    EXPECT_NEAR(v_A.value, 0.16 * 3.14159265358979, 1e-9);
    EXPECT_NEAR(v_A.tolerance.value_or(0), 0.5 * scale, 1e-9);
    EXPECT_NEAR(v_A.direction.value_or(0), 330, 1e-9);
    // What is given is no answer.
    EXPECT_TRUE(std::none_of(answers.begin(), answers.end(),
                             [](const render::Answer& a) { return name_of(a.symbol) == "omega_2"; }));
    const render::Answer omega_3 = named("omega_3");
    EXPECT_NEAR(omega_3.value, solution.bodies[2].omega->to_double(), 1e-9);
    ASSERT_TRUE(omega_3.tolerance);
    // No better than the vector that it is found from, and good enough to tell it from zero.
    EXPECT_GT(*omega_3.tolerance, 0.5 * scale / 0.15);
    EXPECT_LT(*omega_3.tolerance, std::abs(omega_3.value));
}

/// The pin of coupler and rocker belongs to both; its tangential acceleration about the rocker's pivot tells nothing of
/// the coupler.
TEST(Answers, AreReadOffVectorsAcrossTheirOwnBody) {
    for (const int turn : {20, 40, 75, 130, 200}) {
        const Solution solution = tests::solved(
            R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O2": [0, 0], "A": {"from": "O2",
            "distance": 40, "angle": )" +
            std::to_string(turn) +
            R"(}, "O4": [150, 0], "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 80}],
            "side": "left"}},
            "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]}, "joints": [{"revolute": "O2",
            "bodies": [1, 2]},
            {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4",
            "bodies": [1, 4]}],
            "drivers": [{"body": 2, "omega": -12}], "find": ["velocity", "acceleration"]})");
        const SheetOptions options;
        const DrawnSheet sheet = draw_solution(solution, options, fonts());
        double length_scale = 0, acceleration_scale = 0;
        for (const Figure& figure : sheet.figures) {
            if (figure.traits.measured == QuantityKind::length) length_scale = figure.scale;
            if (figure.id == "acceleration") acceleration_scale = figure.scale;
        }
        ASSERT_GT(acceleration_scale, 0);
        int found = 0;
        for (const render::Answer& each : answers_of({solution, options.theme, fonts()}, sheet.figures)) {
            if (each.symbol.letter != Symbol::Letter::alpha) continue;
            const bool of_coupler = solution.mechanism.body(each.quantity.body).name == "3";
            const double radius = of_coupler ? 0.15 : 0.08;  // AB, O4B, m
            ASSERT_TRUE(each.read_off) << turn;
            EXPECT_EQ(name_of(*each.read_off), of_coupler ? "a_BA_t" : "a_B_t") << turn;
            ++found;
            if (!each.detail.empty()) continue;
            EXPECT_NEAR(each.tolerance.value_or(0),
                        (0.5 * acceleration_scale + 0.5 * length_scale * std::abs(each.value)) / radius, 1e-9)
                << turn << ", " << name_of(each.symbol);
        }
        EXPECT_EQ(found, 2);
    }
}

TEST(Answers, OfBodiesThatTurnTogetherHaveOneTolerance) {
    int pairs = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.bodies.empty()) continue;
        const SheetOptions options;
        const DrawnSheet sheet = draw_solution(solution, options, fonts());
        const DrawingContext context{solution, options.theme, fonts()};
        std::map<Quantity::Kind, std::map<BodyIndex, std::optional<double>>> tolerances;
        for (const render::Answer& each : answers_of(context, sheet.figures))
            if (each.symbol.letter == Symbol::Letter::omega || each.symbol.letter == Symbol::Letter::alpha)
                tolerances[each.quantity.kind].emplace(each.quantity.body, each.tolerance);
        for (const Joint& joint : solution.mechanism.joints)
            for (const auto& [kind, of_bodies] : tolerances) {
                const auto first = of_bodies.find(joint.bodies[0]), second = of_bodies.find(joint.bodies[1]);
                if (!joint.pair().holds_rotation || first == of_bodies.end() || second == of_bodies.end()) continue;
                ++pairs;
                EXPECT_EQ(first->second.has_value(), second->second.has_value()) << name << ", " << joint.name;
                EXPECT_NEAR(first->second.value_or(0), second->second.value_or(0), 1e-12) << name << ", " << joint.name;
            }
    }
    EXPECT_GT(pairs, 5);
}

TEST(Handouts, CoverNothing) {
    std::size_t turn = 0;
    std::map<render::Fault::Kind, int> counts;
    std::size_t pixels = 0;
    std::string first;
    for (const std::string& name : example_names()) {
        ++turn;
        const Solution& solution = example(name);
        for (std::size_t kind = 0; kind < 3; ++kind) {
            if (unless_sanitized(0, 1) == 1 && turn % 3 != kind) continue;
            // Of three examples in a row each kind is seen in all languages, papers and orientations in turn.
            const std::size_t n = turn * 5 + kind * 7;
            SheetOptions options = kind == 0 ? brief() : of_kind(kind == 1 ? SheetKind::question : SheetKind::answers);
            options.language = n % 2 == 0 ? Language::en : Language::it;
            options.paper = static_cast<Paper>(n / 2 % 3);
            options.orientation = static_cast<Orientation>(n / 6 % 2);
            options.grid = kind == 1;
            options.theme = built_in_theme(theme_names()[n % theme_names().size()]).value();
            for (const Page& page : lay_out(solution, options, fonts())) {
                for (const render::Fault& fault : faults_of(page, fonts())) {
                    ++counts[fault.kind];
                    if (first.size() < 4000) first += name + " " + std::to_string(kind) + ", " + said(fault) + "\n";
                }
                if (turn % 3 == kind) pixels += pixels_in_common(page, fonts(), 100);
            }
        }
    }
    EXPECT_EQ(counts, (std::map<render::Fault::Kind, int>{})) << first;
    EXPECT_EQ(pixels, 0U);
}

class HandoutLine : public tests::CommandLine {};

TEST_F(HandoutLine, GoesToEveryFormatAndSaysWhatHasNoMeaning) {
    for (const char* file : {"q.svg", "q.png", "q.pdf"}) {
        const auto run_of =
            run("solve four_bar.json --sheet question --grid --lang it --theme print --paper letter -o " +
                std::string(file));
        EXPECT_EQ(run_of.status, 0) << run_of.err;
        EXPECT_TRUE(is_there(file));
    }
    EXPECT_EQ(run("solve four_bar.json --detail brief -o b.pdf").status, 0);
    EXPECT_EQ(run("solve four_bar.json --sheet answers -o a.svg").status, 0);
    const auto before = snapshot();
    for (const char* arguments :
         {"--grid -o x.svg", "--sheet answers --grid -o x.svg", "--sheet question --detail brief -o x.svg",
          "--sheet question --figure velocity -o x.svg", "--detail brief --figure velocity -o x.svg",
          "--sheet answers --steps -o x.svg", "--detail brief --steps -o x.svg",
          "--sheet question --with joukowsky -o x.svg", "--sheet exam -o x.svg", "--detail short -o x.svg"})
        for (const char* language : {"", " --lang it"}) {
            const auto wrong = run("solve four_bar.json " + std::string(arguments) + language);
            EXPECT_EQ(wrong.status, 2) << arguments;
            EXPECT_TRUE(tests::lines_are(wrong.err, "kinegraph: --.*")) << wrong.err;
            EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
        }
    EXPECT_EQ(changed_since(before), "");
}

}  // namespace
}  // namespace handout_test
