// sweep and solve --at, as a user meets them.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <tuple>

#include "tests/support/command_line.hpp"
#include "tests/support/scissor_lift.hpp"

namespace kinegraph::tests::sweep_test {
namespace {

using Json = nlohmann::json;
class Sweep : public CommandLine {};
/// The first number after `key="` from a place on.
double number_after(const std::string& text, const std::string& key, std::size_t from) {
    return std::stod(text.substr(text.find(key + "=\"", from) + key.size() + 2));
}

class SolveAt : public CommandLine {};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_F(Sweep, WritesOneRowAPositionToStandardOutput) {
    const Outcome swept = run("sweep four_bar.json --steps 36");
    EXPECT_EQ(swept.status, 0) << swept.err;
    const auto lines = lines_of(swept.out);
    ASSERT_EQ(lines.size(), 38U);
    EXPECT_EQ(lines[0],
              "turn,time,angle 2,omega 2,alpha 2,angle 3,omega 3,alpha 3,angle 4,omega 4,alpha 4"
              ",x A,y A,vx A,vy A,ax A,ay A,x B,y B,vx B,vy B,ax B,ay B")
        << "columns in the order of the results";
    EXPECT_TRUE(lines_are(
        swept.err, R"(four_bar\.json: largest difference from the numeric check: .* of the largest of its kind .*)"));
}

TEST_F(Sweep, WritesCsvAndJsonTogetherTheSameNumbers) {
    const Outcome swept = run("sweep four_bar.json --from -90° --to 1.5rad --steps 10 -o a.csv -o b.json");
    ASSERT_EQ(swept.status, 0) << swept.err;
    EXPECT_EQ(swept.out, "");
    const Json json = Json::parse(contents(folder_ / "b.json"));
    const auto lines = lines_of(contents(folder_ / "a.csv"));
    ASSERT_EQ(json["rows"].size(), 11U);
    ASSERT_EQ(lines.size(), 12U);
    EXPECT_EQ(json["driver"], "2");
    EXPECT_NEAR(json["from"], -std::numbers::pi / 2, 1e-15);
    EXPECT_EQ(json["to"], 1.5);
    EXPECT_EQ(json["columns"][0], "turn");
    for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(std::stod(lines[i + 1]), json["rows"][i][0].get<double>());
    EXPECT_LT(json["largest difference"]["share"], 1e-9);
}

TEST_F(Sweep, WritesCentrodesAndDrawsThem) {
    const Outcome swept = run("sweep four_bar.json --steps 10 --centrodes 1,3 --centrodes 2,4 -o a.json -o a.svg");
    ASSERT_EQ(swept.status, 0) << swept.err;
    const Json centrodes = Json::parse(contents(folder_ / "a.json"))["centrodes"];
    ASSERT_EQ(centrodes.size(), 2U);
    EXPECT_EQ(centrodes[0]["bodies"], Json({"1", "3"}));
    EXPECT_FALSE(centrodes[0]["to infinity"].empty());
    for (const Json& branch : centrodes[0]["branches"]) {
        EXPECT_EQ(branch["turn"].size(), branch["fixed"].size());
        EXPECT_EQ(branch["turn"].size(), branch["moving"].size());
    }
    EXPECT_NE(contents(folder_ / "a.svg").find(R"(class="centrode" data-name="1,3" data-on="moving")"),
              std::string::npos);
    const Outcome without = run("sweep four_bar.json --steps 10 -o b.json");
    EXPECT_FALSE(Json::parse(contents(folder_ / "b.json")).contains("centrodes"));
}

TEST_F(Sweep, RefusesCentrodesOfNoBodies) {
    for (const auto& [pair, said] :
         {std::pair("1,33", "--centrodes: no body is named \"33\" \\(did you mean \"3\"\\?\\)"),
          {"3", "--centrodes \"3\" is no pair of bodies; give two as \"1,3\""},
          {"1,1", "--centrodes \"1,1\": a body has no motion against itself; give two bodies"}}) {
        const Outcome swept = run("sweep four_bar.json -o a.json --centrodes " + std::string(pair));
        EXPECT_EQ(swept.status, 2) << pair;
        EXPECT_TRUE(lines_are(swept.err, "four_bar\\.json: " + std::string(said))) << swept.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "a.json"));
    }
}

TEST_F(Sweep, GoesFromLimitToLimitWhereNoTurnIsPossible) {
    write("rocker.json", spoilt("\"distance\": 40", "\"distance\": 120"));
    const Outcome swept = run("sweep rocker.json --steps 20 -o a.json");
    ASSERT_EQ(swept.status, 0) << swept.err;
    EXPECT_NE(swept.err.find("its limits"), std::string::npos) << swept.err;
    const Json json = Json::parse(contents(folder_ / "a.json"));
    EXPECT_EQ(json["rows"].size(), 19U) << "at a limit there is no row";
    EXPECT_EQ(json["limits"][0], json["from"]);
    EXPECT_EQ(json["limits"][1], json["to"]);
}

// The drawing needs the places at the limits besides, near which positions are ill-conditioned.
TEST_F(Sweep, ADrawingFromLimitToLimitChangesNoRow) {
    for (const char* const name : {"sluice_gate_travel", "scissor_lift", "stephenson_3_driver_2"}) {
        write("travel.json", contents(example_file(name)));
        const Outcome alone = run("sweep travel.json --steps 24 -o alone.csv");
        const Outcome drawn = run("sweep travel.json --steps 24 -o drawn.csv -o drawn.svg");
        EXPECT_NE(alone.err.find("its limits"), std::string::npos) << name;
        EXPECT_GT(lines_of(contents(folder_ / "alone.csv")).size(), 20U) << name;
        EXPECT_EQ(contents(folder_ / "drawn.csv"), contents(folder_ / "alone.csv")) << name;
        EXPECT_EQ(drawn.err, alone.err) << name;
        EXPECT_EQ(drawn.status, alone.status) << name;
    }
}

TEST_F(Sweep, LeavesRowsOutWhereTheAnswerIsNotOne) {
    // At 126.87° from the drawn position the parallel crank lies flat.
    const Outcome swept = run("sweep parallel_crank.json --from 126.8698976458440° --to 128° --steps 4");
    EXPECT_EQ(swept.status, 3);
    EXPECT_EQ(lines_of(swept.out).size(), 5U) << swept.out;
    EXPECT_NE(swept.err.find("left out"), std::string::npos) << swept.err;
    EXPECT_EQ(swept.out.find("nan"), std::string::npos);
    const Outcome through = run("sweep parallel_crank.json --steps 100");
    EXPECT_EQ(through.status, 0) << through.err;
    EXPECT_NE(through.err.find("a change point at 126.8699°"), std::string::npos) << through.err;
    EXPECT_NE(through.err.find("the branch is a choice"), std::string::npos) << through.err;
}

// Where sizes are so far apart that no position is found, there are no rows, no columns and no limits to tell.
TEST_F(Sweep, OfWhichNoPositionHasAnAnswerWritesNothing) {
    const auto put = [&](const char* name, const Json::json_pointer& place, const Json& value) {
        Json file = Json::parse(contents(example_file(name)));
        file[place] = value;
        write("far.json", file.dump());
    };
    for (const auto& [name, place, value] : {std::tuple("elliptic_trammel", "/points/B/meet/0/radius", 1e61),
                                             {"stephenson_2_driver_2", "/points/A/distance", 1e9},
                                             {"board_on_rollers", "/points/G/1", -1e20}}) {
        put(name, Json::json_pointer(place), value);
        const auto before = snapshot();
        for (const char* const out : {"out.csv", "out.svg"}) {
            const Outcome swept = run("sweep far.json -o " + std::string(out));
            EXPECT_EQ(swept.err.find("nan"), std::string::npos) << swept.err;
            if (swept.status == 0) continue;
            EXPECT_TRUE(swept.status == 2 || swept.status == 3) << name << ": " << swept.status << swept.err;
            EXPECT_EQ(changed_since(before), "") << name;
        }
    }
}

TEST_F(Sweep, SaysInOneLineWhatIsWrongAndWritesNothing) {
    const auto before = snapshot();
    const auto refused = [&](const std::string& arguments, const std::string& pattern) {
        const Outcome outcome = run("sweep " + arguments + " -o out.csv");
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(lines_are(outcome.err, pattern));
        EXPECT_EQ(lines_of(outcome.err).size(), 1U);
        EXPECT_EQ(changed_since(before), "") << arguments;
    };
    refused("four_bar.json --driver 3",
            R"(four_bar\.json: --driver 3: no driver is called so \(did you mean "2"\?\); there are 2)");
    refused("four_bar.json --steps 1", R"(four_bar\.json: --steps: at least 2 are needed)");
    refused("four_bar.json --from 20mm", R"(four_bar\.json: --from "20mm" is a length; an angle is wanted here)");
    refused("four_bar.json --from 1 --to 1", R"(four_bar\.json: --from and --to are the same position.*)");
    refused("four_bar.json --centroids 1,3", R"(kinegraph: .*--centroids.*)");
    refused("four_bar.json --plot x",
            R"(four_bar\.json: --plot: there is no quantity "x".*; there are turn, time, angle 2, .*)");
    refused("four_bar.json --plot 'omega 33'", R"(four_bar\.json: --plot: .* \(did you mean "omega 3"\?\).*)");
    refused("four_bar.json --step 2",
            R"(four_bar\.json: --step is of a driver that goes along.* the number of steps is --steps\))");
    refused("scara.json --driver 2 --driver 3", R"(scara\.json: --step is of a driver that goes along.*)");
    refused("scara.json --driver 2 --driver 2 --step 1", R"(scara\.json: --driver 2 is given twice)");
    refused("scara.json --driver 2 --driver 3 --step 1mm",
            R"(scara\.json: --step "1mm" is a length; an angle is wanted here)");
    refused("four_bar.json --branch 1", R"(four_bar\.json: /drivers/0: no branch is to be chosen.*)");
}

TEST_F(Sweep, DriversGoTogether) {
    const Outcome swept = run("sweep scara.json --driver 2 --to 20 --steps 10 --driver 3 --step -1° -o a.json");
    ASSERT_EQ(swept.status, 0) << swept.err;
    EXPECT_EQ(swept.err.find("rest where"), std::string::npos) << swept.err;
    const Json json = Json::parse(contents(folder_ / "a.json"));
    EXPECT_NEAR(json["along"]["3"], -0.5, 1e-15);
    const auto& columns = json["columns"];
    const auto column =
        static_cast<std::size_t>(std::find(columns.begin(), columns.end(), "angle 3") - columns.begin());
    const double turned = json["rows"][10][column].get<double>() - json["rows"][0][column].get<double>();
    EXPECT_NEAR(turned, (20 - 10) * std::numbers::pi / 180, 1e-12) << "body 3 turns against body 2";
}

TEST_F(Sweep, ADriverWithALawGoesThroughItInTime) {
    write("law.json", spoilt(R"("omega": "-120 rpm")", R"("law": {"form": "3-4-5", "turn": -90, "time": 2})"));
    const Outcome swept = run("sweep law.json --steps 4 -o law.svg -o law.csv");
    ASSERT_EQ(swept.status, 0) << swept.err;
    EXPECT_NE(swept.err.find("driver 2 follows its law, from 0 s to 2 s"), std::string::npos) << swept.err;
    const auto lines = lines_of(contents(folder_ / "law.csv"));
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[3].substr(0, lines[3].find(',', lines[3].find(',') + 1)), "-0.7853981633974483,1")
        << "half way at half time";
    EXPECT_NE(contents(folder_ / "law.svg").find("data-unit=\"s\""), std::string::npos);
    EXPECT_EQ(run("sweep law.json --from 20° -o b.csv").status, 2) << "times, not turns";
    const Outcome at = run("solve law.json --at 1s --format json");
    ASSERT_EQ(at.status, 0) << at.err;
    EXPECT_NEAR(Json::parse(at.out)["bodies"]["2"]["omega"], -15.0 / 8 * std::numbers::pi / 4, 1e-12);
    EXPECT_EQ(run("solve law.json --at 20°").status, 2) << "the law goes the other way";
}

TEST_F(Sweep, ACamIsDrawnAndItsMechanismSolved) {
    write("cam.json", contents(example_file("cams/disc_cam")));
    const Outcome drawn = run("cam cam.json --steps 24 --at 60 -o cam.csv -o at.json -o cam.svg");
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_NE(drawn.err.find("25 positions solved as mechanisms"), std::string::npos) << drawn.err;
    EXPECT_NE(drawn.err.find("largest pressure angle: 26.2°"), std::string::npos) << drawn.err;
    EXPECT_EQ(lines_of(contents(folder_ / "cam.csv")).size(), 26U);
    EXPECT_EQ(run("solve at.json --format json").status, 0);
    EXPECT_NE(contents(folder_ / "cam-2.svg").find("data-name=\"pressure angle\""), std::string::npos);
    EXPECT_EQ(run("solve at.json -o at.svg").err, "") << "its own file is no matter for remarks";
    // It is one position: the live page stands still, and says on itself which file gives the others.
    const Outcome page = run("solve at.json -o at.html");
    EXPECT_EQ(page.status, 0) << page.err;
    EXPECT_NE(page.err.find("this is one position of the cam of cam.json"), std::string::npos) << page.err;
    const std::string html = contents(folder_ / "at.html");
    EXPECT_NE(html.find("<p class=\"note\">This is one position of the cam of cam.json"), std::string::npos);
    EXPECT_EQ(html.find("\"moving\":{"), std::string::npos);
    for (const char* refused : {"sweep at.json", "solve at.json --at 10°"}) {
        const Outcome stays = run(refused);
        EXPECT_EQ(stays.status, 2) << refused;
        EXPECT_NE(stays.err.find("kinegraph cam cam.json"), std::string::npos) << stays.err;
    }
    const auto before = snapshot();
    for (const char* wrong :
         {"cam cam.json --steps 1", "cam cam.json --at 400", "cam four_bar.json", "cam none.json"}) {
        const Outcome refused = run(std::string(wrong) + " -o x.csv -o x.svg");
        EXPECT_EQ(refused.status, 2) << wrong;
        EXPECT_EQ(changed_since(before), "") << wrong;
    }
}

TEST_F(Sweep, ACornerOfAPitchCurveIsToldAndItsUndercutFails) {
    std::string text = contents(example_file("cams/disc_cam"));
    text.replace(text.find("cycloidal"), 9, "constant speed");
    write("cam.json", text);
    const Outcome told = run("cam cam.json -o cam.csv");
    EXPECT_EQ(told.status, 3);
    EXPECT_NE(told.err.find("undercut between 10"), std::string::npos) << told.err;
    EXPECT_NE(told.err.find("convex corner"), std::string::npos) << told.err;
    EXPECT_NE(told.err.find("remark: at 0° the speed of the follower jumps from 0 m/s to 0.1571 m/s"),
              std::string::npos)
        << told.err;
    EXPECT_NE(told.err.find("remark: at 110° the speed of the follower jumps from 0.1571 m/s to 0 m/s"),
              std::string::npos)
        << told.err;
    const Outcome italian = run("cam cam.json -o cam.csv --lang it");
    EXPECT_EQ(italian.status, 3);
    EXPECT_NE(italian.err.find("sottotaglio fra 10"), std::string::npos) << italian.err;
    EXPECT_NE(italian.err.find("osservazione: a 110° la velocità della punteria salta da 0,1571 m/s a 0 m/s"),
              std::string::npos)
        << italian.err;
}

/// Numbers have the minus of the trade, and nothing is −0.
TEST_F(Sweep, ACamsSpeedsHaveTheSignsOfTheTrade) {
    std::string text = contents(example_file("cams/disc_cam"));
    text.replace(text.find("3-4-5"), 5, "constant speed");  // of the fall
    write("cam.json", text);
    const std::string told = run("cam cam.json -o cam.csv").err;
    EXPECT_NE(told.find("from 0 m/s to −0."), std::string::npos) << told;
    EXPECT_NE(told.find(" m/s to 0 m/s"), std::string::npos) << told;
    EXPECT_EQ(told.find(" -"), std::string::npos) << told;
}

TEST_F(Sweep, ACamsSheetHasItsDataAndSaysItsSigns) {
    // Its follower rises clockwise: the pivot lies on the right, the contact on the left.
    write("rocker.json", R"({"kinegraph": 1, "units": {"length": "mm"}, "cam": {"omega": "200 rpm", "base radius": 35,
        "follower": {"moves": "oscillating", "face": "roller", "radius": 9, "pivot": [95, 10], "arm": 80},
        "law": [{"form": "3-4-5", "rise": 22, "turn": 120}, {"form": "rest", "turn": 40},
                {"form": "constant acceleration", "rise": -22, "turn": 130}, {"form": "rest", "turn": 70}]}})");
    ASSERT_EQ(run("cam rocker.json --at 60° -o en.svg -o at.json").status, 0);
    ASSERT_EQ(run("cam rocker.json --at 60° --lang it -o it.svg").status, 0);
    const auto sheets = [&](const std::string& name) {
        return contents(folder_ / (name + ".svg")) + contents(folder_ / (name + "-2.svg"));
    };
    const std::string english = sheets("en"), italian = sheets("it");
    for (const char* words :
         {"base circle r_b = 35 mm", "the cam turns counter-clockwise, ω_2", "oscillating roller follower r_r = 9 mm",
          "arm 80 mm", "positive away from the cam, here clockwise: ω_3 = −dβ/dt",
          "0°–120°: rise of 22°, polynomial 3-4-5", "120°–160°: dwell",
          "160°–290°: return of 22°, constant acceleration", "Cam and follower at 60°", "Rise of the follower",
          "Pressure angle", "pitch curve", "base circle", "\"225.0°\"", "data-name=\"rise angle rate\"",
          "class=\"drawn-position\" data-value=\"60"})
        EXPECT_NE(english.find(words), std::string::npos) << words;
    for (const char* words : {"circonferenza di base r_b = 35 mm", "qui in senso orario: ω_3 = −dβ/dt",
                              "120°–160°: sosta", "Camma e punteria a 60°", "Alzata della punteria", "curva primitiva"})
        EXPECT_NE(italian.find(words), std::string::npos) << words;
    EXPECT_EQ(english.find("225.5°"), std::string::npos) << "the jump is where the law has it";
    EXPECT_LT(Json::parse(run("solve at.json --format json").out)["bodies"]["3"]["omega"], 0) << "as the sheet says";
}

TEST_F(Sweep, SaysItInItalianToo) {
    const auto says = [&](const std::string& arguments, int status, const std::string& pattern) {
        const Outcome outcome = run(arguments + " --lang it -o out.csv");
        EXPECT_EQ(outcome.status, status) << arguments;
        EXPECT_TRUE(lines_are(outcome.err, pattern));
    };
    says("sweep four_bar.json --driver 3", 2,
         R"(four_bar\.json: --driver 3: nessun movente si chiama così \(forse "2"\?\); ci sono 2)");
    says("sweep four_bar.json --plot x", 2, R"(four_bar\.json: --plot: non c’è la grandezza "x".*)");
    says("sweep four_bar.json --from 20mm", 2, R"(four_bar\.json: --from "20mm" è una lunghezza; qui serve un angolo)");
    says("sweep four_bar.json -o out.txt", 2,
         R"(kinegraph: -o out\.txt: .* può essere \.svg, \.png, \.pdf, \.tex, \.dxf, \.csv, \.json, .*)");
    says("sweep four_bar.json --steps 4", 0,
         R"(four_bar\.json: massimo scarto dalla verifica numerica: [0-9],[0-9]e-[0-9]+ della .*)");
}

TEST_F(Sweep, RefusesWhatIsOutOfReach) {
    write("rocker.json", spoilt("\"distance\": 40", "\"distance\": 120"));
    const auto before = snapshot();
    const Outcome outcome = run("sweep rocker.json --to 200° -o out.csv");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(lines_are(outcome.err, R"(rocker\.json: 200° is out of reach: driver 2 stops at [0-9.]+°)"));
    EXPECT_EQ(changed_since(before), "");
    write("idle.json", spoilt(R"("omega": "-120 rpm")", R"("omega": 0)"));
    const Outcome still = run("sweep idle.json --steps 4");
    EXPECT_EQ(still.status, 0) << "at rest everywhere is an answer";
    EXPECT_EQ(lines_of(still.out)[0].find("time"), std::string::npos) << "no time passes by which to tell it";
    const Outcome dead = run("sweep slider_driven_dead_point.json");
    EXPECT_EQ(dead.status, 3);
}

TEST_F(Sweep, APlotIsReadBackFromItsAxes) {
    const Outcome swept =
        run("sweep four_bar.json --steps 36 --plot 'omega 3,omega 4' --trace B --trace 'A,on 4' --poses 3 -o s.svg -o "
            "s.json");
    ASSERT_EQ(swept.status, 0) << swept.err;
    const std::string svg = contents(folder_ / "s.svg");
    const Json json = Json::parse(contents(folder_ / "s.json"));
    const std::size_t y = svg.find("class=\"axis-y\""), curve = svg.find("data-name=\"omega 4\"");
    ASSERT_NE(y, std::string::npos);
    ASSERT_NE(curve, std::string::npos);
    const double from = number_after(svg, "data-from", y), to = number_after(svg, "data-to", y);
    const double low = number_after(svg, " y1", y), high = number_after(svg, " y2", svg.find("class=\"axis\"", y));
    // The first vertex of the curve is the first row.
    const std::string path = svg.substr(svg.find(" d=\"M", curve) + 5);
    const double height = std::stod(path.substr(path.find_first_of(" ,") + 1));
    const auto& columns = json["columns"];
    const auto column = std::find(columns.begin(), columns.end(), "omega 4") - columns.begin();
    const double value = json["rows"][0][static_cast<std::size_t>(column)];
    EXPECT_NEAR(from + (to - from) * (height - low) / (high - low), value, 1e-5 * (to - from));
    EXPECT_NE(svg.find("class=\"path\""), std::string::npos);
    EXPECT_NE(svg.find("data-figure=\"plot\""), std::string::npos);
    for (const char* more : {"--theme dark --lang it", "--theme print --orientation portrait --paper A3"})
        EXPECT_EQ(run(std::string("sweep parallel_crank.json --steps 50 ") + more + " -o t.svg").status, 0);
}

/// A crank with a couple, balanced by a vertical force at its end: it does no work where the crank is vertical.
const char* const crank_with_pole = R"({"kinegraph": 1, "points": {"O": [0, 0],
    "H": {"from": "O", "distance": 1, "angle": 30}}, "bodies": {"2": ["O", "H"]},
    "joints": [{"revolute": "O", "bodies": [0, 2]}], "frame": 0, "drivers": [{"body": 2, "omega": 1}],
    "loads": [{"couple": "C", "body": 2, "value": 10}],
    "effort": {"force": "F", "body": 2, "at": "H", "along": 90}})";

TEST_F(Sweep, APoleIsAnEmptyCellAndALineOfThePlotNeverAValueOrAZero) {
    write("pole.json", crank_with_pole);
    for (const std::string steps : {"7", "36", "100", "360", "3600"}) {
        const Outcome swept = run("sweep pole.json --steps " + steps + " -o a.json -o a.csv -o a.svg");
        ASSERT_EQ(swept.status, 0) << swept.err;
        EXPECT_NE(swept.err.find("effort F: mean without limit, least without limit, greatest without limit; it grows "
                                 "without limit at 60°, 240°"),
                  std::string::npos)
            << swept.err;
        const Json json = Json::parse(contents(folder_ / "a.json"));
        std::vector<double> poles;
        for (const Json& each : json["poles"])
            if (each["column"] == "effort F") poles.push_back(each["at"]);
        ASSERT_EQ(poles.size(), 2U);
        EXPECT_NEAR(poles[0], std::numbers::pi / 3, 1e-9);
        EXPECT_NEAR(poles[1], std::numbers::pi * 4 / 3, 1e-9);
        const auto effort = json["columns"].size() - 1;
        const auto lines = lines_of(contents(folder_ / "a.csv"));
        int empty = 0;
        for (std::size_t i = 0; i < json["rows"].size(); ++i) {
            const Json& cell = json["rows"][i][effort];
            EXPECT_EQ(cell.is_null(), lines[i + 1].ends_with(","));
            if (cell.is_null())
                ++empty;
            else
                EXPECT_LT(std::abs(cell.get<double>()), 1e4);
        }
        EXPECT_EQ(empty, std::stoi(steps) % 6 == 0 ? 2 : 0);
        const std::string svg = contents(folder_ / "a.svg");
        EXPECT_NEAR(number_after(svg, "data-value", svg.find("class=\"asymptote\"")), 60, 1e-7);
        EXPECT_NE(svg.find("without limit"), std::string::npos);
    }
    const Outcome italian = run("sweep pole.json --lang it");
    EXPECT_NE(italian.err.find("cresce senza limite a 60°, 240°"), std::string::npos) << italian.err;
}

TEST_F(Sweep, AContactThatWouldHaveToPullIsReportedWithItsLimits) {
    write("cam.json", R"({"kinegraph": 1, "units": {"length": "mm", "angular velocity": "rpm"}, "frame": 0,
        "points": {"O": [0, 0], "C": [15, 0], "P": [15, 40], "F": [0, 40], "H": [0, 75], "K": [0, 160]},
        "bodies": {"2": {"points": ["O", "C"], "circle": {"centre": "C", "radius": 40}}, "3": ["F", "H"], "0": ["K"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]},
        {"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": 0}}, "pushes": [0, 1]},
        {"prismatic": "H", "bodies": [3, 0], "along": 90}], "drivers": [{"body": 2, "omega": 500}],
        "masses": {"3": {"mass": 0.9, "centre": "H"}}, "inertia forces": true,
        "loads": [{"spring": "S", "bodies": [3, 0], "between": ["H", "K"], "stiffness": 1000, "free length": 102.5}],
        "effort": {"couple": "M", "body": 2}})");
    const Outcome swept = run("sweep cam.json --steps 50 -o a.json -o a.svg");
    ASSERT_EQ(swept.status, 0) << swept.err;
    // The spring presses with k (17.5 mm + y), the follower needs m ω² y, where y = e sin φ.
    const double omega = 500 * std::numbers::pi / 30, at = std::asin(17.5 / 15 / (0.9 * omega * omega / 1000 - 1));
    const Json found = Json::parse(contents(folder_ / "a.json"))["separations"];
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0]["joint"], "P");
    EXPECT_NEAR(found[0]["from"], at, 1e-9);
    EXPECT_NEAR(found[0]["to"], std::numbers::pi - at, 1e-9);
    EXPECT_NE(swept.err.find("the contact P can only push, and would have to pull from 52.6"), std::string::npos)
        << swept.err;
    const std::string svg = contents(folder_ / "a.svg");
    EXPECT_NEAR(number_after(svg, "data-from", svg.find("class=\"separation\"")), at * 180 / std::numbers::pi, 1e-6);
    EXPECT_NE(svg.find("lift-off of the contact P: 52.6"), std::string::npos);
}

/// What is the same in every position has no position of its own.
TEST_F(Sweep, AConstantSpeedIsSaidWithoutAPosition) {
    write("crank.json", R"({"kinegraph": 1, "frame": 0, "points": {"O": [0, 0], "H": [0.8, 0.6]},
        "bodies": {"2": ["O", "H"]}, "joints": [{"revolute": "O", "bodies": [0, 2]}],
        "drivers": [{"body": 2, "omega": 3}]})");
    ASSERT_EQ(run("sweep crank.json -o crank.svg").status, 0);
    const std::string sheet = contents(folder_ / "crank.svg");
    EXPECT_NE(sheet.find("largest speed: 3.000 m/s (H)\""), std::string::npos);
    ASSERT_EQ(run("sweep four_bar.json -o varies.svg").status, 0);
    EXPECT_NE(contents(folder_ / "varies.svg").find("largest speed: 0.6206 m/s (B) at 265.4°"), std::string::npos);
}

TEST_F(Sweep, AZeroOverAParameterIsTheSameForAnySteps) {
    // Two hanging rods of 1 m and 1 kg, a spring of 50 N/m and 1 m between their ends, 3 m between their pins: they
    // rest where 50 (2 − 2 cos t) sin t = 5 cos t.
    write("rest.json", R"({"kinegraph": 1, "frame": 0, "parameters": {"t": "20°"}, "points": {"A": [0, 0],
        "B": {"from": "A", "distance": 1, "angle": "= -t"}, "D": [3, 0],
        "C": {"from": "D", "distance": 1, "angle": "= 180 deg + t"},
        "G1": {"from": "A", "to": "B", "ratio": 0.5}, "G2": {"from": "D", "to": "C", "ratio": 0.5}},
        "bodies": {"1": ["A", "B", "G1"], "2": ["D", "C", "G2"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "D", "bodies": [0, 2]}],
        "masses": {"1": {"mass": 1, "centre": "G1"}, "2": {"mass": 1, "centre": "G2"}}, "gravity": [0, -10],
        "loads": [{"spring": "S", "bodies": [1, 2], "between": ["B", "C"], "stiffness": 50, "free length": 1}],
        "effort": [{"couple": "M1", "body": 1}, {"couple": "M2", "body": 2}], "find": ["forces"]})");
    double low = 0.1, high = 1;
    for (int i = 0; i < 100; ++i) {
        const double t = (low + high) / 2;
        (50 * (2 - 2 * std::cos(t)) * std::sin(t) < 5 * std::cos(t) ? low : high) = t;
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.2f°", low * 180 / std::numbers::pi);
    for (const std::string steps : {"5", "18", "60"}) {
        const Outcome swept =
            run("sweep rest.json --over t --from 0° --to 90° --steps " + steps + " --plot 'effort M1' -o a.svg");
        ASSERT_EQ(swept.status, 0) << swept.err;
        EXPECT_NE(contents(folder_ / "a.svg").find(std::string("aria-label=\"") + text.data()), std::string::npos)
            << steps << " " << text.data();
    }
}

TEST_F(Sweep, StrokesRatiosAndMeansAreTheSameForAnySteps) {
    int facts = 0;
    for (const char* name : {"quick_return", "slider_crank_offset", "gas_force", "exam_2001", "radial_engine",
                             "whitworth", "slider_crank_law"}) {
        write("moving.json", contents(example_file(name)));
        std::vector<std::string> expected;
        for (const std::string steps : {"36", "100", "360", "3600"}) {
            SCOPED_TRACE(name + (", " + steps));
            ASSERT_NE(run("sweep moving.json --steps " + steps + " -o a.svg").status, 2);
            const std::string svg = contents(folder_ / "a.svg");
            std::vector<std::string> found;
            for (const std::string what : {"stroke ", "time ratio", "mean ", "least transmission angle"})
                for (std::size_t at = 0; (at = svg.find("aria-label=\"" + what, at)) != std::string::npos; ++at)
                    found.push_back(svg.substr(at, svg.find('"', at + 12) - at));
            if (steps == "36") expected = found;
            EXPECT_EQ(found, expected);
            facts += static_cast<int>(found.size());
        }
    }
    EXPECT_GT(facts, 40);
}

TEST_F(Sweep, NamesWithSignsOfTheGrammarAreColumns) {
    // By the name alone, within an expression, and between quotes: the same column.
    for (const std::string name : {"B'", "B''", "1+1", "a=b", "p|q"}) {
        SCOPED_TRACE(name);
        std::string file = contents(example_file("four_bar"));
        for (std::size_t at = 0; (at = file.find("\"B\"", at)) != std::string::npos; ++at)
            file.replace(at, 3, "\"" + name + "\"");
        write("named.json", file);
        const auto column = [&](const std::string& text) {
            const Outcome outcome = run("sweep named.json --steps 4 --columns \"" + text + "\"");
            EXPECT_EQ(outcome.status, 0) << text << ": " << outcome.err;
            return outcome.out.substr(outcome.out.find('\n'));
        };
        const std::string wanted = column("v " + name);
        EXPECT_EQ(column("'v " + name + "'"), wanted);
        EXPECT_EQ(column("|'v " + name + "'|"), wanted);
        EXPECT_EQ(column("r = 1*|'v " + name + "'|"), wanted);
    }
    EXPECT_EQ(run("sweep named.json --columns \"a = b = omega 2\"").status, 2);
}

TEST_F(Sweep, ATurnBeyondTheLimitIsRefusedAtOnce) {
    write("four_bar.json", contents(example_file("four_bar")));
    for (const std::string options : {"solve four_bar.json --at 1e9°", "sweep four_bar.json --from 1e59° --to 1.1e59°",
                                      "sweep four_bar.json --to -360001°"}) {
        const Outcome outcome = run(options);
        EXPECT_EQ(outcome.status, 2) << options;
        EXPECT_NE(outcome.err.find("more than 1000 turns away"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(run("solve four_bar.json --at 36000°").status, 0);
}

TEST_F(Sweep, TheStrokeOfASlideThatIsDrivenIsItsTravel) {
    // Flat at the one limit and closed at the other, upright in between, where the foot's branch changes.
    for (const int stages : {1, 4, 9}) {
        SCOPED_TRACE(stages);
        Json lift = scissor(stages);
        lift["drivers"] = {{{"joint", "R0"}, {"speed", -0.01}}};
        lift.erase("find");
        write("lift.json", lift.dump());
        ASSERT_NE(run("sweep lift.json -o lift.svg").status, 2);
        EXPECT_NE(contents(folder_ / "lift.svg").find("stroke  s_R0: 1000 mm"), std::string::npos);
    }
}

/// A slider that turns round four times in a cycle has no one slow stroke. Its toggle passes its dead line twice.
TEST_F(Sweep, ATimeRatioIsThatOfOneStrokeForthAndOneBack) {
    const auto ratio_of = [&](const char* pivot) {
        write("press.json", std::string(R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
            "points": {"O": [-250, 100], "A": {"from": "O", "distance": 30, "angle": 40}, "C": [0, 200],
            "B": {"meet": [{"circle": "A", "radius": )") +
                                pivot + R"(}, {"circle": "C", "radius": 100}], "near": [0, 100]},
            "D": {"meet": [{"circle": "B", "radius": 120}, {"line": "C", "angle": 90}], "near": [0, -20]}},
            "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["C", "B"], "5": ["B", "D"], "6": ["D"]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4, 5]}, {"revolute": "C", "bodies": [1, 4]},
            {"revolute": "D", "bodies": [5, 6]}, {"prismatic": "D", "bodies": [6, 1], "along": 90}],
            "drivers": [{"body": 2, "omega": 10}], "find": ["velocity"]})");
        const Outcome swept = run("sweep press.json --steps 72 -o a.svg");
        EXPECT_EQ(swept.status, 0) << swept.err;
        return contents(folder_ / "a.svg").find("time ratio") != std::string::npos;
    };
    EXPECT_FALSE(ratio_of("240")) << "through the dead line and back: four turns";
    EXPECT_TRUE(ratio_of("205")) << "short of it: two";
}

/// Rows that do not close leave the extremes beside them open: the first row that closes is none.
TEST_F(Sweep, AnExtremeBesideRowsThatAreLeftOutIsNotSaid) {
    write("crank.json", R"({"kinegraph": 1, "units": {"length": "mm"}, "parameters": {"k": 3}, "frame": 1,
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 60},
        "B": {"meet": [{"circle": "A", "radius": "= k*50 mm"}, {"line": "O", "angle": 0}], "side": "ahead"}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 2, "omega": 10}]})");
    const auto first_row = [&](const char* from) {
        const Outcome swept = run(std::string("sweep crank.json --over k --from ") + from +
                                  " --to 4 --steps 8 --plot 'omega 3' -o a.csv -o a.svg");
        EXPECT_NE(swept.status, 2) << swept.err;
        const std::string svg = contents(folder_ / "a.svg");
        const std::size_t table = svg.find("Extremes");
        EXPECT_NE(table, std::string::npos);
        return svg.find("–", table) != std::string::npos;
    };
    EXPECT_TRUE(first_row("0.5")) << "below sin 60° it does not close";
    EXPECT_FALSE(first_row("1"));
}

TEST_F(Sweep, PolesOverAParameterAreFoundBetweenTheRowsAndOnThem) {
    // A couple on the crank is balanced by a force on the slider: none can, where the crank lies along the guide.
    write("crank.json", R"({"kinegraph": 1, "units": {"length": "mm"}, "parameters": {"a": "40°"}, "frame": 1,
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": "= a"},
        "B": {"meet": [{"circle": "A", "radius": 150}, {"line": "O", "angle": 0}], "near": [200, 0]}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 2, "omega": 10}], "loads": [{"couple": "M", "body": 2, "value": "10 N m"}],
        "effort": {"force": "F", "body": 4, "at": "B", "along": 0}, "find": ["velocity", "forces"]})");
    for (const std::string steps : {"33", "34", "100"}) {
        SCOPED_TRACE(steps);
        const Outcome swept = run("sweep crank.json --over a --from 10° --to 350° --steps " + steps +
                                  " --plot 'effort F' -o a.json -o a.svg");
        ASSERT_EQ(swept.status, 0) << swept.err;
        EXPECT_NE(swept.err.find("effort F grows without limit at a = 180°"), std::string::npos) << swept.err;
        const Json json = Json::parse(contents(folder_ / "a.json"));
        const auto pole = std::find_if(json["poles"].begin(), json["poles"].end(),
                                       [](const Json& each) { return each["column"] == "effort F"; });
        ASSERT_NE(pole, json["poles"].end());
        EXPECT_NEAR((*pole)["at"], std::numbers::pi, 1e-8);
        ASSERT_EQ(json["rows"].size(), std::stoul(steps) + 1) << "no row is left out";
        const std::size_t column = static_cast<std::size_t>(
            std::find(json["columns"].begin(), json["columns"].end(), "effort F") - json["columns"].begin());
        const std::size_t place = static_cast<std::size_t>(
            std::find(json["columns"].begin(), json["columns"].end(), "x B") - json["columns"].begin());
        ASSERT_LT(std::max(column, place), json["columns"].size());
        for (const Json& row : json["rows"]) {
            const double a = row[0];
            EXPECT_EQ(row[column].is_null(), std::abs(a - std::numbers::pi) < 1e-9);
            EXPECT_NEAR(row[place], 0.05 * std::cos(a) + std::sqrt(0.0225 - 0.0025 * std::sin(a) * std::sin(a)), 1e-12);
        }
        const std::string svg = contents(folder_ / "a.svg");
        EXPECT_NEAR(number_after(svg, "data-value", svg.find("class=\"asymptote\"")), 180, 1e-6);
        EXPECT_NE(svg.find("without limit"), std::string::npos);
    }
}

/// Where a coupler becomes too short or too long to close, what turns grows without limit: at both ends of the lengths
/// that close, between the rows.
TEST_F(Sweep, WhereAFileCeasesToCloseItsGrowthIsFound) {
    write("bar.json", R"({"kinegraph": 1, "frame": 1, "parameters": {"l": 5},
        "points": {"O": [0, 0], "A": [1, 2], "Q": [6, 0],
        "B": {"meet": [{"circle": "A", "radius": "= l"}, {"circle": "Q", "radius": 3}], "side": "left"}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["Q", "B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": 1}], "loads": [{"force": "W", "body": 4, "at": "B", "value": [0, -10]}],
        "effort": {"couple": "M", "body": 2}, "find": ["velocity", "forces"]})");
    const double distance = std::sqrt(29.0);
    for (const std::string steps : {"16", "37", "80"}) {
        SCOPED_TRACE(steps);
        const Outcome swept = run("sweep bar.json --over l --from 2 --to 10 --steps " + steps + " -o a.json");
        ASSERT_EQ(swept.status, 3) << swept.err;
        const Json poles = Json::parse(contents(folder_ / "a.json"))["poles"];
        for (const char* column : {"omega 4", "effort M", "vy B"}) {
            std::vector<double> found;
            for (const Json& each : poles)
                if (each["column"] == column) found.push_back(each["at"]);
            ASSERT_EQ(found.size(), 2U) << column;
            EXPECT_NEAR(found[0], distance - 3, 8e-9) << column;
            EXPECT_NEAR(found[1], distance + 3, 8e-9) << column;
        }
        EXPECT_TRUE(std::none_of(poles.begin(), poles.end(), [](const Json& each) {
            return each["column"] == "omega 2" || each["column"] == "x B";
        }));
    }
}

TEST_F(Sweep, OverASpeedTheJumpSpeedOfAFollowerIsFound) {
    // The spring presses with k (17.5 mm + y), the follower needs m ω² y; y = 12 mm.
    write("cam.json", R"({"kinegraph": 1, "units": {"length": "mm", "angular velocity": "rpm"}, "frame": 0,
        "parameters": {"n": "300 rpm"},
        "points": {"O": [0, 0], "C": [9, 12], "P": [9, 52], "F": [0, 52], "H": [0, 87], "K": [0, 160]},
        "bodies": {"2": {"points": ["O", "C"], "circle": {"centre": "C", "radius": 40}}, "3": ["F", "H"], "0": ["K"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]},
        {"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": 0}}, "pushes": [0, 1]},
        {"prismatic": "H", "bodies": [3, 0], "along": 90}], "drivers": [{"body": 2, "omega": "= n"}],
        "masses": {"3": {"mass": 0.9, "centre": "H"}}, "inertia forces": true,
        "loads": [{"spring": "S", "bodies": [3, 0], "between": ["H", "K"], "stiffness": 1000, "free length": 102.5}],
        "effort": {"couple": "M", "body": 2}})");
    const double jump = std::sqrt(1000 * 0.0295 / (0.9 * 0.012));
    for (const std::string steps : {"4", "9"}) {
        const Outcome swept =
            run("sweep cam.json --over n --from '100 rpm' --to '900 rpm' --steps " + steps + " -o a.json -o a.svg");
        ASSERT_EQ(swept.status, 0) << swept.err;
        const Json found = Json::parse(contents(folder_ / "a.json"))["separations"];
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0]["joint"], "P");
        EXPECT_NEAR(found[0]["from"], jump, 1e-7);
        EXPECT_NEAR(found[0]["to"], 900 * std::numbers::pi / 30, 1e-9);
        EXPECT_NE(swept.err.find("the contact P can only push, and would have to pull from n = 499.0"),
                  std::string::npos)
            << swept.err;
        EXPECT_NE(contents(folder_ / "a.svg").find("class=\"separation\""), std::string::npos);
    }
}

TEST_F(Sweep, ALimitBesideAChangePointIsSaidToBeRough) {
    // Crank 3, follower 4, frame 2: with a coupler of 5 there is a change point.
    const auto swept = [&](const std::string& coupler) {
        write("near.json", R"({"kinegraph": 1, "frame": "1", "points": {"O": [0, 0],
            "A": {"from": "O", "distance": 3, "angle": 50}, "Q": [2, 0],
            "B": {"meet": [{"circle": "A", "radius": )" +
                               coupler + R"(}, {"circle": "Q", "radius": 4}], "side": "left"}},
            "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["Q", "B"]},
            "joints": [{"revolute": "O", "bodies": ["1", "2"]}, {"revolute": "A", "bodies": ["2", "3"]},
            {"revolute": "B", "bodies": ["3", "4"]}, {"revolute": "Q", "bodies": ["1", "4"]}],
            "drivers": [{"body": "2", "omega": 1}]})");
        return run("sweep near.json --steps 8").err;
    };
    EXPECT_NE(swept("5.00000000000001").find("this limit is known to 1e-6 only"), std::string::npos);
    for (const char* coupler : {"5.5", "5.001", "5.000001", "5.000000001"})
        EXPECT_EQ(swept(coupler).find("known to"), std::string::npos) << coupler;
}

TEST_F(Sweep, TeethChangeFlanksWhereTheirForceChangesItsSign) {
    // The wheel's centre of mass stands at 30° − φ/2: its weight has no moment at −90°.
    write("gears.json", R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 0,
        "points": {"O": [0, 0], "Q": [60, 0], "P": [20, 0], "G": {"from": "Q", "distance": 10, "angle": 30}},
        "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 20}},
        "3": {"points": ["Q", "G"], "circle": {"centre": "Q", "radius": 40}}},
        "joints": [{"revolute": "O", "bodies": [0, 2]}, {"revolute": "Q", "bodies": [0, 3]},
        {"gear": "P", "bodies": [2, 3], "pressure angle": 20}], "drivers": [{"body": 2, "omega": 1}],
        "masses": {"3": {"mass": 2, "centre": "G"}}, "gravity": [0, -9.81], "effort": {"couple": "M", "body": 2}})");
    for (const std::string steps : {"10", "36"}) {
        const Outcome swept = run("sweep gears.json -o a.json --steps " + steps);
        ASSERT_EQ(swept.status, 0) << swept.err;
        const Json found = Json::parse(contents(folder_ / "a.json"))["flank changes"];
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0]["joint"], "P");
        EXPECT_NEAR(found[0]["at"], 4 * std::numbers::pi / 3, 1e-8);
        EXPECT_NE(swept.err.find("at 240° the teeth of P change flanks"), std::string::npos) << swept.err;
    }
}

TEST_F(SolveAt, SolvesInTheOtherPosition) {
    const Outcome at = run("solve four_bar.json --at 30° --format json");
    ASSERT_EQ(at.status, 0) << at.err;
    write("drawn.json", spoilt("\"angle\": 60", "\"angle\": 90"));
    const Outcome drawn = run("solve drawn.json --format json");
    const Json a = Json::parse(at.out), b = Json::parse(drawn.out);
    ASSERT_EQ(a["checks"].size(), b["checks"].size());
    for (std::size_t i = 0; i < a["checks"].size(); ++i) {
        EXPECT_EQ(a["checks"][i]["quantity"], b["checks"][i]["quantity"]);
        const double value = b["checks"][i]["graphical"];
        EXPECT_NEAR(a["checks"][i]["graphical"], value, 1e-12 * std::max(1.0, std::abs(value)));
    }
}

TEST_F(SolveAt, TheDrawnPositionIsAsWithoutIt) {
    const Json at = Json::parse(run("solve four_bar.json --at 0 --format json").out);
    const Json plain = Json::parse(run("solve four_bar.json --format json").out);
    EXPECT_EQ(at, plain);
}

TEST_F(SolveAt, GivesASheetOrAFileForEachPosition) {
    Outcome at = run("solve four_bar.json --at 30° --at -15° -o r.json");
    ASSERT_EQ(at.status, 0) << at.err;
    EXPECT_TRUE(is_there("r.json") && is_there("r-2.json") && !is_there("r-3.json"));
    at = run("solve four_bar.json --at every 120° -o s.json");
    ASSERT_EQ(at.status, 0) << at.err;
    EXPECT_TRUE(is_there("s.json") && is_there("s-2.json") && is_there("s-3.json") && !is_there("s-4.json"));
    at = run("solve four_bar.json --figure velocity --at every 90° -o v.svg");
    ASSERT_EQ(at.status, 0) << at.err;
    EXPECT_TRUE(is_there("v.svg") && is_there("v-4.svg") && !is_there("v-5.svg"));
    EXPECT_NE(contents(folder_ / "v-2.svg").find("(2: 90°)"), std::string::npos);
}

TEST_F(SolveAt, SaysWhatIsWrong) {
    write("rocker.json", spoilt("\"distance\": 40", "\"distance\": 120"));
    EXPECT_TRUE(lines_are(run("solve rocker.json --at 200°").err,
                          R"(rocker\.json: --at: 200° is out of reach: driver 2 stops at .*)"));
    EXPECT_TRUE(lines_are(run("solve four_bar.json --at 3kg").err,
                          R"(four_bar\.json: --at: "3kg" is a mass; an angle is wanted here)"));
    EXPECT_EQ(run("solve four_bar.json --at every 0").status, 2);
}

TEST_F(SolveAt, AChangePointIsSolvedAsIfItWereDrawn) {
    // Crank and frame in line: the crank turns by 110° from 70°.
    write("anti.json", contents(example_file("antiparallelogram")));
    const Outcome at = run("solve anti.json --at 110° --format json");
    EXPECT_EQ(at.status, 3) << "as a change point that is drawn";
    write("drawn.json", R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
        "points": {"O2": [0, 0], "O4": [60, 0], "A": [-100, 0], "B": [-40, 0]},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": 10}]})");
    const Json found = Json::parse(at.out), drawn = Json::parse(run("solve drawn.json --format json").out);
    ASSERT_EQ(found["branches"].size(), 2U);
    for (std::size_t i = 0; i < 2; ++i)
        for (const char* body : {"3", "4"})
            EXPECT_NEAR(found["branches"][i]["ratios"][body], drawn["branches"][i]["ratios"][body], 1e-12);
    EXPECT_EQ(found["unsolved"], drawn["unsolved"]);
    EXPECT_EQ(found["instant centres"].size(), drawn["instant centres"].size());
    // Beside it, too near for doubles, the motion goes on smoothly: both cranks turn alike.
    const Outcome beside = run("solve parallel_crank.json --at 126.869897645844° --format json");
    ASSERT_EQ(beside.status, 0) << beside.err;
    const Json bodies = Json::parse(beside.out)["bodies"];
    EXPECT_NEAR(bodies["4"]["omega"], bodies["2"]["omega"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace kinegraph::tests::sweep_test
