// The public face as a program uses it: no internal header.
#include <kinegraph/kinegraph.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace library_test {
namespace {

using namespace kinegraph;

// Slider-crank O(0,0), A(30,40), B(150,0) mm, ω₂ = 10 rad/s: v_A = (−0.4, 0.3) m/s; v_B lies along x, so
// ω₃ = −0.3/0.12 = −5/2 rad/s and v_B = −0.4 + ω₃·0.04 = −1/2 m/s.
const std::string slider_crank = R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
    "parameters": {"w": 10},
    "points": {"O": [0, 0], "A": [30, 40], "B": [150, 0]}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
    "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
               {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
    "drivers": [{"body": 2, "omega": "= w"}]})";

Solved solved(const std::string& text, const std::vector<ParameterValue>& set = {}) {
    const auto file = MechanismFile::parse(text, "slider_crank.json", set);
    EXPECT_TRUE(file.has_value());
    auto found = file->solve();
    EXPECT_TRUE(found.has_value());
    return *found;
}

TEST(PublicFace, GivesResultsByNameExactlyAndAsDoubles) {
    const Solved found = solved(slider_crank);
    const auto omega = found.value("omega 3");
    ASSERT_TRUE(omega && omega->exact);
    EXPECT_EQ(omega->value, -2.5);
    EXPECT_EQ(omega->exact->text(), "-5/2");
    EXPECT_EQ(omega->unit, "rad/s");
    const auto velocity = found.value("vx B");
    ASSERT_TRUE(velocity && velocity->exact);
    EXPECT_EQ(velocity->exact->text(), "-1/2");
    EXPECT_EQ(velocity->in_file_unit, -0.5);
    EXPECT_EQ(found.vector("v A"), (std::array<double, 2>{-0.4, 0.3}));
    // B slides too, and "v B" is the signed speed along the guide; the vector is the point's all the same.
    EXPECT_EQ(found.vector("v B"), (std::array<double, 2>{-0.5, 0}));
    EXPECT_EQ(found.value("v B")->value, -0.5);
    // A length takes a root, and has no exact value even where it comes out whole.
    const auto speed = found.value("v A");
    ASSERT_TRUE(speed);
    EXPECT_EQ(speed->value, 0.5);
    EXPECT_FALSE(speed->exact);
    EXPECT_FALSE(found.value("omega 7"));
    EXPECT_FALSE(found.vector("omega 3"));
}

TEST(PublicFace, EvaluatesExpressions) {
    const Solved found = solved(slider_crank);
    const auto ratio = found.evaluate("omega 3 / omega 2");
    ASSERT_TRUE(ratio);
    EXPECT_EQ(ratio->value, -0.25);
    EXPECT_FALSE(ratio->exact);
    EXPECT_EQ(found.evaluate("omega 3")->exact->text(), "-5/2");
    EXPECT_EQ(found.evaluate("|v A|")->value, 0.5);
    EXPECT_EQ(found.evaluate("vx B / w")->value, -0.05) << "w is a parameter";
    const auto misspelt = found.evaluate("omga 3");
    ASSERT_FALSE(misspelt);
    EXPECT_EQ(misspelt.error().front().kind, Diagnostic::Kind::bad_input);
    EXPECT_EQ(misspelt.error().front().remedy.in(Language::en).find("did you mean \"omega 3\""), 0U);
    EXPECT_EQ(found.evaluate("1 / (omega 2 - omega 2)").error().front().kind, Diagnostic::Kind::no_unique_answer);
    EXPECT_EQ(found.evaluate("omega 3 +").error().front().kind, Diagnostic::Kind::bad_input);
}

TEST(PublicFace, PlacesPointsAndDirectionsWithoutSolving) {
    const auto file = MechanismFile::parse(R"({"kinegraph": 1, "units": {"length": "mm"}, "points": {"A": ["3 cm", 40],
        "B": {"from": "A", "to": "O", "ratio": 2}, "O": [0, 0]}, "bodies": {"2": ["O", "A", "B"], "3": ["A"]}, "joints": [
        {"revolute": "O", "bodies": [0, 2]}, {"prismatic": "A", "bodies": [3, 2], "along": ["O", "A"]}],
        "loads": [{"force": "F", "body": 2, "at": "B", "value": [0, -1]}, {"couple": "M", "body": 2, "value": 1}],
        "drivers": [{"body": 2, "at": "A", "along": 90, "speed": 1}]})",
                                           "file");
    ASSERT_TRUE(file);
    const auto drawn = file->drawn_position();
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->length_unit, "mm");
    EXPECT_EQ(drawn->metres, 0.001);
    ASSERT_EQ(drawn->points.size(), 3U);
    EXPECT_EQ(drawn->points[1].name, "B");
    EXPECT_EQ(drawn->points[1].at, (std::array<double, 2>{-30, -40}));
    std::map<std::string, double> angles;
    for (const DrawnPosition::Direction& each : drawn->directions) angles[each.place] = each.angle;
    ASSERT_EQ(angles.size(), 3U);
    EXPECT_DOUBLE_EQ(angles["/joints/1"], std::atan2(4, 3));
    EXPECT_DOUBLE_EQ(angles["/loads/0"], std::atan2(-1, 0));
    EXPECT_DOUBLE_EQ(angles["/drivers/0"], std::atan2(1, 0));
}

TEST(PublicFace, GivesEveryValueUnderItsName) {
    const Solved found = solved(slider_crank);
    const std::vector<ResultValue> all = found.values();
    ASSERT_GT(all.size(), 10u);
    for (const ResultValue& each : all) {
        const auto again = found.value(each.name);
        ASSERT_TRUE(again) << each.name;
        EXPECT_EQ(again->value, each.value) << each.name;
        EXPECT_TRUE(std::isfinite(each.value)) << each.name;
    }
}

TEST(PublicFace, SetsParameters) { EXPECT_EQ(solved(slider_crank, {{"w", "20"}}).value("omega 3")->value, -5); }

TEST(PublicFace, ToldByTheCheck) {
    const std::vector<CheckedValue> rows = solved(slider_crank).checks();
    ASSERT_FALSE(rows.empty());
    for (const CheckedValue& row : rows) EXPECT_NEAR(row.graphical, row.numeric, 1e-12) << row.name;
}

TEST(PublicFace, TellsEveryFaultWithItsPlace) {
    const auto file = MechanismFile::parse(R"({"kinegraph": 1, "points": {"A": [0, "x"]}, "bodys": {}})", "a.json");
    ASSERT_FALSE(file.has_value());
    const auto at = [&](const std::string& place) {
        return std::any_of(file.error().begin(), file.error().end(),
                           [&](const Diagnostic& each) { return each.place == place; });
    };
    EXPECT_TRUE(at("/points/A/1"));
    EXPECT_TRUE(at("/bodys"));
    for (const Diagnostic& each : file.error())
        for (const Language language : {Language::en, Language::it}) EXPECT_FALSE(each.text.in(language).empty());
    EXPECT_FALSE(MechanismFile::open("/nowhere/a.json").has_value());
}

TEST(PublicFace, SolvesAFileThatNeedsDerivativesWithoutAnyCallBefore) {
    const auto file = MechanismFile::open(KINEGRAPH_EXAMPLES_DIR "/motion/projectile.json");
    ASSERT_TRUE(file.has_value());
    EXPECT_FALSE(file->has_joints());
    const auto found = file->solve();
    ASSERT_TRUE(found.has_value());
    EXPECT_FALSE(found->values().empty());
}

TEST(PublicFace, DrawsInEveryFormat) {
    const auto drawing = draw(solved(slider_crank));
    ASSERT_TRUE(drawing.has_value());
    EXPECT_EQ(drawing->svg().size(), drawing->pages());
    EXPECT_NE(drawing->svg().front().find("<svg"), std::string::npos);
    EXPECT_NE(drawing->svg(Lettering::live).front().find("<text"), std::string::npos);
    EXPECT_EQ(drawing->png(0, 50).value().substr(1, 3), "PNG");
    EXPECT_EQ(drawing->pdf().value().substr(0, 5), "%PDF-");
    EXPECT_NE(drawing->tex().find("tikzpicture"), std::string::npos);
    EXPECT_FALSE(drawing->png(drawing->pages()).has_value());
    EXPECT_NE(live_page(solved(slider_crank)).value().html.find("<html"), std::string::npos);
}

TEST(PublicFace, DrawsOneFigureByName) {
    const Solved found = solved(slider_crank);
    const auto names = figure_names(found);
    ASSERT_TRUE(names.has_value());
    ASSERT_FALSE(names->empty());
    for (const std::string& name : *names) {
        DrawingOptions options;
        options.figure = name;
        EXPECT_TRUE(draw(found, options).has_value()) << name;
    }
    DrawingOptions options;
    options.figure = "no such figure";
    const auto none = draw(found, options);
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().front().text.in(Language::en).find(names->front()), std::string::npos);
}

TEST(PublicFace, RefusesAThemeThatIsNone) {
    DrawingOptions options;
    options.theme = "neon";
    EXPECT_FALSE(draw(solved(slider_crank), options).has_value());
    options.theme_file = R"({"paper": 7})";
    const auto wrong = draw(solved(slider_crank), options);
    ASSERT_FALSE(wrong.has_value());
    EXPECT_EQ(wrong.error().front().place, "/paper");
}

TEST(PublicFace, SolvesInOtherPositions) {
    const auto file = MechanismFile::parse(slider_crank, "slider_crank.json");
    ASSERT_TRUE(file.has_value());
    const auto found = file->solve_at({{"0°", "every 120°"}, "", 0});
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->size(), 4u);
    EXPECT_EQ((*found)[0].value("omega 3")->value, -2.5);
    EXPECT_EQ((*found)[1].value("omega 3")->value, -2.5);
    // A third of a turn on: the crank at 53.13° + 120°, the rod of √0.016 m; ω₃ = −r ω cos φ/(l cos β).
    const double r = 0.05, l = std::sqrt(0.016), phi = std::atan2(4, 3) + 2 * std::acos(-1.0) / 3;
    const double expected = -r * 10 * std::cos(phi) / std::sqrt(l * l - r * r * std::sin(phi) * std::sin(phi));
    EXPECT_NEAR((*found)[2].value("omega 3")->value, expected, 1e-12);
    std::size_t pages = 0;
    for (const Solved& each : *found) pages += draw(each)->pages();
    EXPECT_EQ(draw(*found)->pages(), pages);
    const auto wrong = file->solve_at({{"30°"}, "nobody", 0});
    ASSERT_FALSE(wrong.has_value());
    EXPECT_EQ(wrong.error().front().text.in(Language::en), "driver nobody: no driver is called so; there are 2");
    EXPECT_FALSE(file->solve_at({{"1 kg"}, "", 0}).has_value());
}

/// The place of a column among those of a sweep.
std::size_t column_named(const Sweep& sweep, const std::string& name) {
    const auto columns = sweep.columns();
    const auto place =
        std::find_if(columns.begin(), columns.end(), [&](const auto& each) { return each.name == name; });
    EXPECT_NE(place, columns.end()) << name;
    return static_cast<std::size_t>(place - columns.begin());
}

TEST(PublicFace, MovesAMechanismThroughItsCycle) {
    const auto file = MechanismFile::parse(slider_crank, "slider_crank.json");
    ASSERT_TRUE(file.has_value());
    SweepOptions options;
    options.steps = 36;
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep.has_value());
    const auto rows = sweep->rows();
    ASSERT_TRUE(rows.has_value());
    ASSERT_EQ(rows->size(), 37u);
    const std::size_t x = column_named(*sweep, "x B");
    EXPECT_EQ(sweep->columns()[x].unit, "m");
    // The crank of 50 mm and the rod of √(120² + 40²) mm: the slider's stroke is twice the crank.
    double least = rows->front()[x].value(), most = least;
    for (const auto& row : *rows) least = std::min(least, *row[x]), most = std::max(most, *row[x]);
    EXPECT_NEAR(most - least, 0.1, 1e-3);
    EXPECT_LT(sweep->largest_difference(), 1e-9);
    EXPECT_TRUE(sweep->is_complete());
    const auto again = sweep->rows();
    ASSERT_TRUE(again && again->size() == rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) EXPECT_NEAR((*again)[i][x].value(), (*rows)[i][x].value(), 1e-12);
    options.from = "1 kg";
    EXPECT_FALSE(Sweep::of(*file, options).has_value());
}

TEST(PublicFace, WritesTheRowsOfASweepPieceByPiece) {
    const auto file = MechanismFile::parse(slider_crank, "slider_crank.json");
    ASSERT_TRUE(file.has_value());
    SweepOptions options;
    options.steps = 5000;
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep.has_value());
    std::string csv, json;
    std::size_t longest = 0;
    const auto into = [&](std::string& text) {
        return [&](std::string_view piece) {
            longest = std::max(longest, piece.size());
            text += piece;
            return true;
        };
    };
    ASSERT_TRUE(sweep->write({{RowsText::Form::csv, into(csv)}, {RowsText::Form::json, into(json)}}));
    EXPECT_LT(longest, csv.size() / 4);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5002);
    EXPECT_TRUE(csv.starts_with("turn,time,angle 2,")) << csv.substr(0, 80);
    EXPECT_NE(json.find("\"largest difference\": {\"column\""), std::string::npos);
    // Whoever takes the rows can stop the sweep.
    int pieces = 0;
    ASSERT_TRUE(sweep->write({{RowsText::Form::csv, [&](std::string_view) { return ++pieces < 2; }}}));
    EXPECT_EQ(pieces, 2);
}

TEST(PublicFace, ASweepKnowsItsPolesAndItsCellsThereAreEmpty) {
    const auto file = MechanismFile::parse(R"({"kinegraph": 1, "points": {"O": [0,0],
        "H": {"from": "O", "distance": 1, "angle": 30}}, "bodies": {"2": ["O","H"]},
        "joints": [{"revolute": "O", "bodies": [0,2]}], "frame": 0, "drivers": [{"body": 2, "omega": 1}],
        "loads": [{"couple": "C", "body": 2, "value": 10}],
        "effort": {"force": "F", "body": 2, "at": "H", "along": 90}})",
                                           "pole.json");
    ASSERT_TRUE(file.has_value());
    // Found to the last digits that a double has there, whatever the rows.
    for (const long steps : {7, 36, 100, 360}) {
        SweepOptions options;
        options.steps = steps;
        auto sweep = Sweep::of(*file, options);
        ASSERT_TRUE(sweep.has_value());
        const std::size_t effort = column_named(*sweep, "effort F");
        std::vector<double> poles;
        for (const SweepPole& each : sweep->poles())
            if (each.column == "effort F") poles.push_back(each.at);
        ASSERT_EQ(poles.size(), 2u);
        EXPECT_NEAR(poles[0], std::numbers::pi / 3, 1e-9);
        EXPECT_NEAR(poles[1], std::numbers::pi * 4 / 3, 1e-9);
        const auto rows = sweep->rows();
        ASSERT_TRUE(rows && rows->size() == static_cast<std::size_t>(steps + 1));
        int empty = 0;
        for (const SweepRow& row : *rows) {
            empty += row[effort] ? 0 : 1;
            EXPECT_TRUE(row[column_named(*sweep, "Fx O 2 on 0")] && row[column_named(*sweep, "vx H")]);
        }
        EXPECT_EQ(empty, steps % 6 == 0 ? 2 : 0);
        EXPECT_TRUE(sweep->is_complete());
    }
}

TEST(PublicFace, SweepsAParameter) {
    const auto file = MechanismFile::parse(slider_crank, "slider_crank.json");
    ASSERT_TRUE(file.has_value());
    SweepOptions options;
    options.over = "w";
    options.from = "10";
    options.to = "30";
    options.step = "10";
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep.has_value());
    const auto rows = sweep->rows();
    ASSERT_TRUE(rows && rows->size() == 3);
    const std::size_t omega = column_named(*sweep, "omega 3");
    EXPECT_EQ(sweep->columns()[omega].unit, "rad/s");
    for (const auto& row : *rows) EXPECT_EQ(row[omega].value(), -row[0].value() / 4);
    EXPECT_TRUE(draw(*sweep).has_value());
    options.over = "v";
    const auto unknown = Sweep::of(*file, options);
    ASSERT_FALSE(unknown.has_value());
    EXPECT_EQ(unknown.error().front().text.in(Language::en).substr(0, 9), "over \"v\":") << "no dashes";
}

TEST(PublicFace, DrawsASweepWithItsPathsWithoutChangingItsRows) {
    const auto file = MechanismFile::open(KINEGRAPH_EXAMPLES_DIR "/sluice_gate_travel.json");
    ASSERT_TRUE(file.has_value());
    SweepOptions options;
    options.steps = 24;
    options.traces = {"O"};
    options.poses = 3;
    auto sweep = Sweep::of(*file, options);
    ASSERT_TRUE(sweep.has_value()) << sweep.error().front().text.in(Language::en);
    ASSERT_TRUE(sweep->limits()[0] && sweep->limits()[1]);
    const auto drawing = draw(*sweep);
    ASSERT_TRUE(drawing.has_value());
    const std::string svg = drawing->svg().front();
    EXPECT_NE(svg.find("data-name=\"O\""), std::string::npos);
    const auto rows = sweep->rows();
    ASSERT_TRUE(rows && rows->size() == 23u);
    const auto undrawn = Sweep::of(*file, options)->rows();
    ASSERT_TRUE(undrawn && undrawn->size() == rows->size());
    const std::size_t effort = column_named(*sweep, "effort F_G");
    for (std::size_t i = 0; i < rows->size(); ++i)
        EXPECT_NEAR((*rows)[i][effort].value() / (*undrawn)[i][effort].value(), 1, 1e-9) << i;
    options.traces = {"Nowhere"};
    EXPECT_FALSE(Sweep::of(*file, options).has_value());
}

/// The slider-crank with crank speeds of 5 to 20 rad/s.
std::string with_variants(const std::string& more = {}) {
    std::string whole = slider_crank;
    return whole.insert(
        whole.rfind('}'),
        R"(, "title": "Crank", "vary": {"w": {"from": 5, "to": 20, "step": 1}}, "ask": ["omega 3"])" + more);
}
ExerciseVariants variants_of(const std::string& text, const std::vector<ParameterValue>& set = {}) {
    auto variants = ExerciseVariants::parse(text, "v.json", 7, set);
    EXPECT_TRUE(variants.has_value());
    return *std::move(variants);
}
std::vector<ExerciseVariant> first_of(ExerciseVariants& variants, std::size_t count) {
    std::vector<ExerciseVariant> all;
    while (all.size() < count) {
        auto variant = variants.next();
        if (!variant || !*variant) break;
        all.push_back(**std::move(variant));
    }
    EXPECT_EQ(all.size(), count);
    return all;
}

TEST(PublicFace, DrawsVariantsInOneOrder) {
    ExerciseVariants first = variants_of(with_variants()), second = variants_of(with_variants());
    EXPECT_EQ(first.title().in(Language::it), "Crank");
    EXPECT_EQ(first.parameters(), std::vector<std::string>{"w"});
    for (int i = 0; i < 5; ++i) {
        const auto one = first.next(), other = second.next("other.json");
        ASSERT_TRUE(one && *one && other && *other);
        EXPECT_EQ((*one)->file, (*other)->file);
        ASSERT_EQ((*one)->asked.size(), 1u);
        EXPECT_NEAR((*one)->asked[0].value, -std::stod((*one)->values[0].value) / 4, 1e-12);
        // The file of a variant stands by itself.
        EXPECT_EQ(solved((*one)->file).value("omega 3")->value, (*one)->asked[0].value);
    }
}

TEST(PublicFace, CountsWhatTheConditionsOfAnExerciseReject) {
    // |ω₃| = w/4 > 4 rad/s leaves 17 to 20 of 5 to 20.
    ExerciseVariants variants = variants_of(with_variants(R"(, "require": ["omega 3 < -4 rad/s"])"));
    EXPECT_EQ(variants.combinations(), 16u);
    first_of(variants, 4);
    const auto end = variants.next();
    ASSERT_TRUE(end.has_value());
    EXPECT_FALSE(*end);
    EXPECT_EQ(variants.looked_at(), 16u);
    ASSERT_EQ(variants.rejections().size(), 1u);
    EXPECT_EQ(variants.rejections()[0].count, 12u);
    EXPECT_NE(variants.rejections()[0].why.in(Language::en).find("omega 3 < -4"), std::string::npos);
}

TEST(PublicFace, StopsBetweenVariants) {
    ExerciseVariants variants = variants_of(with_variants());
    const auto stopped = variants.next({}, [] { return true; });
    ASSERT_TRUE(stopped.has_value());
    EXPECT_FALSE(*stopped);
    EXPECT_EQ(variants.looked_at(), 0u);
    first_of(variants, 1);
}

TEST(PublicFace, KeysOfVariantsHaveTheirAnswers) {
    ExerciseVariants variants = variants_of(with_variants());
    const auto three = first_of(variants, 3);
    AnswerKey key;
    EXPECT_FALSE(key.drawing("Crank").has_value());
    key.add("1", "=Anna", three[0]);
    key.add("2", "", three[1]);
    std::string expected = "variant,name,w,omega 3 [rad/s]\n";
    const auto row = [](const std::string& head, const ExerciseVariant& variant) {
        const double w = std::stod(variant.values[0].value);
        std::ostringstream line;
        line << head << ',' << w << ',' << -w / 4 << '\n';
        return line.str();
    };
    EXPECT_EQ(key.csv(), expected + row("1,'=Anna", three[0]) + row("2,", three[1]));
    const auto sheet = key.drawing("Crank");
    ASSERT_TRUE(sheet.has_value());
    EXPECT_EQ(sheet->pages(), 1u);
    EXPECT_NE(sheet->svg(Lettering::live).front().find("Anna"), std::string::npos);
    AnswerKey without_names;
    without_names.add("3", "", three[2]);
    EXPECT_EQ(without_names.csv(), "variant,w,omega 3 [rad/s]\n" + row("3", three[2]));
}

TEST(PublicFace, QuestionBanksAskForTheAnswersOfTheKey) {
    ExerciseVariants variants = variants_of(with_variants());
    const auto two = first_of(variants, 2);
    QuestionBank bank("Crank", 7, {}, 40), answers("Crank", 7, {}, 0);
    EXPECT_EQ(bank.csv(), "");
    for (std::size_t i = 0; i < two.size(); ++i) {
        const QuestionBank::Files files{"q.pdf", "s.pdf", "r.json", "f.json"};
        const auto unreadable = bank.add(std::to_string(i + 1), "", two[i], files);
        ASSERT_TRUE(unreadable.has_value());
        EXPECT_TRUE(unreadable->empty());
        ASSERT_TRUE(answers.add(std::to_string(i + 1), "", two[i], files).has_value());
    }
    EXPECT_EQ(bank.csv(), answers.csv());
    EXPECT_EQ(bank.csv().substr(0, bank.csv().find('\n')),
              "variant,seed,w,omega 3,omega 3 unit,omega 3 tolerance,question,solution,results,file");
    const std::string moodle = bank.moodle();
    for (const ExerciseVariant& each : two) {
        std::ostringstream answer;
        answer << each.asked[0].value;
        EXPECT_NE(moodle.find(":NUMERICAL:=" + answer.str()), std::string::npos) << answer.str();
        EXPECT_NE(bank.csv().find("," + answer.str() + ",rad/s,"), std::string::npos) << answer.str();
    }
    EXPECT_EQ(bank.qti().value().substr(0, 2), "PK");
    EXPECT_FALSE(QuestionBank("Crank", 7, {}, 5).add("1", "", two[0]).has_value());
}

TEST(PublicFace, JoinsDrawings) {
    const auto one = draw(solved(slider_crank));
    ASSERT_TRUE(one.has_value());
    DrawingOptions steps;
    steps.steps = true;
    steps.author = "\u4e2d";  // no character of the font
    const auto other = draw(solved(slider_crank), steps);
    ASSERT_TRUE(other.has_value());
    const auto both = joined({*one, *other, *other});
    ASSERT_TRUE(both.has_value());
    std::vector<std::string> expected = one->svg();
    for (int i = 0; i < 2; ++i)
        for (const std::string& page : other->svg()) expected.push_back(page);
    EXPECT_EQ(both->svg(), expected);
    EXPECT_EQ(both->missing_characters(), std::vector<std::string>{"U+4E2D"});
    ASSERT_EQ(both->remarks().size(), 1u);
    EXPECT_EQ(both->remarks()[0].in(Language::en), remark_on_missing({"U+4E2D", "U+4E2D"}).in(Language::en));
    EXPECT_FALSE(joined({}).has_value());
}

TEST(PublicFace, ReadsRequests) {
    Request defaults;
    defaults.drawing.author = "Rossi";
    defaults.set = {{"w", "7"}};
    const Request request = Request::parse(
        R"({"id": 1.50, "mechanism": {"b": 1e2, "a": [0.10, "x"]}, "set": {"r": "45 mm"}, "want": ["svg", "json"],
            "lang": "it", "at": "30°", "grid": true, "dpi": 60})",
        defaults);
    EXPECT_TRUE(request.faults.empty());
    EXPECT_EQ(request.id, "1.50");
    // Numbers keep their digits, members their order.
    EXPECT_EQ(request.text, R"({"b": 1e2, "a": [0.10, "x"]})");
    ASSERT_EQ(request.set.size(), 2u);
    EXPECT_EQ(request.set[1].value, "45 mm");
    EXPECT_EQ(request.want, (std::vector{Request::Format::svg, Request::Format::json}));
    EXPECT_EQ(request.drawing.language, Language::it);
    EXPECT_EQ(request.drawing.author, "Rossi");
    EXPECT_EQ(request.positions.at, std::vector<std::string>{"30°"});
    EXPECT_TRUE(request.drawing.grid);
    EXPECT_EQ(request.dpi, 60);

    const Request wrong = Request::parse(R"({"id": "x", "papre": "A4", "grid": 1})");
    ASSERT_EQ(wrong.faults.size(), 3u);
    EXPECT_EQ(wrong.id, "\"x\"");
    EXPECT_EQ(wrong.faults[0].place, "/papre");
    EXPECT_EQ(wrong.faults[0].text.in(Language::en), "a line has no key \"papre\" (did you mean \"paper\"?)");
    EXPECT_EQ(wrong.faults[1].place, "/grid");
    EXPECT_EQ(wrong.faults[2].text.in(Language::en), "\"file\" or \"mechanism\" is missing");
    EXPECT_EQ(Request::parse("[").faults.size(), 1u);
    EXPECT_EQ(Request::excerpt("a\tb"), "a\\u0009b");
    EXPECT_EQ(json_string("è \"\n\t"), R"("è \"\n\u0009")");
}

TEST(PublicFace, ReadsACam) {
    const auto cam = CamFile::open(KINEGRAPH_EXAMPLES_DIR "/cams/disc_cam.json");
    ASSERT_TRUE(cam.has_value());
    EXPECT_GE(cam->profile(90).size(), 90u);
    EXPECT_TRUE(MechanismFile::parse(cam->mechanism_at(1), "cam.json").has_value());
    const auto cycle = CamCycle::of(*cam, {"60°", 24, ""});
    ASSERT_TRUE(cycle.has_value());
    EXPECT_TRUE(cycle->keeps_law());
    EXPECT_FALSE(cycle->facts().empty() || cycle->comparison().empty());
    EXPECT_TRUE(cycle->remarks().empty()) << "its law has no shock";
    const std::string csv = cycle->csv();
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 26);
    EXPECT_EQ(cycle->mechanism(), cam->mechanism_at(std::acos(-1.0) / 3));
    EXPECT_NE(draw(*cycle)->svg().back().find("data-name=\"pressure angle\""), std::string::npos);
    EXPECT_FALSE(CamCycle::of(*cam, {"400°", 24, ""}).has_value());
}

TEST(PublicFace, ComparesPictures) {
    const auto drawing = draw(solved(slider_crank));
    const auto decoded = [](const Drawing& drawn) { return PngPicture::decode(drawn.png(0, 30).value()).value(); };
    const PngPicture one = decoded(*drawing);
    EXPECT_EQ(compare_pictures(one, one).differing, 0u);
    DrawingOptions dark;
    dark.theme = "dark";
    const PictureComparison found = compare_pictures(one, decoded(*draw(solved(slider_crank), dark)));
    EXPECT_GT(found.share(), 0.5);
    EXPECT_TRUE(PngPicture::is_png(found.side_by_side));
    EXPECT_TRUE(compare_pictures(one, one, 0.1, false).side_by_side.empty());
    EXPECT_FALSE(PngPicture::decode("no picture").has_value());
}

TEST(PublicFace, ServesThreadsThatCallNothingBesides) {
    std::vector<std::string> sheets(4);
    std::vector<std::jthread> threads;
    for (std::string& sheet : sheets)
        threads.emplace_back([&sheet] {
            for (int i = 0; i < 3; ++i) sheet = draw(solved(slider_crank))->svg().front();
        });
    threads.clear();
    const std::string here = draw(solved(slider_crank))->svg().front();
    for (const std::string& sheet : sheets) EXPECT_EQ(sheet, here);
}

}  // namespace
}  // namespace library_test
