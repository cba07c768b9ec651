// The reader of mechanism files: what each form of the format becomes, and that every broken file of tests/broken is
// refused with exactly the lines of the .txt beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "engine/file/json_source.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "tests/support/files.hpp"

namespace reader_test {
namespace {

using namespace kinegraph;

Exact exact(std::string_view decimal) { return *Exact::from_decimal(decimal); }

std::string text_of(const std::filesystem::path& path) { return tests::contents(path); }

std::string lines_of(const Errors& errors) {
    std::string lines;
    for (const Error& error : errors) lines += error.where + ": " + error.message.in(Language::en) + "\n";
    return lines;
}

Mechanism read(std::string_view text) {
    auto mechanism = read_mechanism(text, "test.json");
    EXPECT_TRUE(mechanism) << lines_of(mechanism.error());
    return mechanism ? std::move(*mechanism) : Mechanism{};
}

std::string refusal(std::string_view text) {
    const auto mechanism = read_mechanism(text, "test.json");
    return mechanism ? "read" : lines_of(mechanism.error());
}

/// A small mechanism with more members of the file put at its end.
std::string with(const std::string& more) {
    return R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 0], "B": [3, 1]}, "bodies": {"2": ["O", "A"],
    "3": ["A", "B"]},
               "joints": [{"revolute": "O", "bodies": [0, 2]}, {"revolute": "A", "bodies": [2, 3]},
               {"prismatic": "B", "bodies": [3, 0], "along": 0}])" +
           (more.empty() ? "" : ", " + more) + "}";
}
std::string with_points(const std::string& points) {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "points": {"O": [0, 0], "Q": [3, 4], )" + points +
           R"(}, "bodies": {}, "joints": []})";
}
std::string with_joint(const std::string& joint) {
    return R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 0], "B": [3, 1]},
               "bodies": {"2": ["O"], "3": {"points": ["A"], "circle": {"centre": "B", "radius": 2}}, "4": ["B"]},
               "joints": [)" +
           joint + "]}";
}

TEST(Reader, RefusesEveryBrokenFileInTheseWords) {
    const auto files = tests::json_files(std::filesystem::path(KINEGRAPH_TESTS_DIR) / "broken");
    ASSERT_GT(files.size(), 30U);
    for (const auto& file : files) {
        auto expected = file;
        EXPECT_EQ(refusal(text_of(file)), text_of(expected.replace_extension(".txt"))) << file.filename();
    }
}

TEST(Reader, EveryFaultHasItsOwnWordsInBothLanguages) {
    for (const auto& file : tests::json_files(std::filesystem::path(KINEGRAPH_TESTS_DIR) / "broken")) {
        const auto refused = read_mechanism(text_of(file), "test.json");
        ASSERT_FALSE(refused);
        ASSERT_FALSE(refused.error().empty());
        for (const Error& error : refused.error())
            EXPECT_NE(error.message.in(Language::en), error.message.in(Language::it)) << file.filename();
    }
}

TEST(Reader, ABodyIsDrivenByItsAngularVelocity) {
    EXPECT_EQ(refusal(with(R"("drivers": [{"body": 2, "speed": 150}])")),
              "/drivers/0/speed: a body turns: give \"omega\"; \"speed\" is of a \"joint\" that slides, or of a point "
              "of the body, "
              "\"at\" P \"along\" X\n");
}

TEST(Reader, LoadsHaveNamesOfTheirOwn) {
    EXPECT_EQ(refusal(with(
                  R"("loads": [{"force": "Q", "body": 2, "at": "A", "value": [1, 0]}, {"couple": "Q", "body": 3,
            "value": 1}])")),
              "/loads/1/couple: two loads are named \"Q\"; figures go by the name, so rename one\n");
}

TEST(Reader, OnALineAMeetIsAheadOrBehind) {
    const std::string circle = R"({"circle": "O", "radius": 2})", line = R"({"line": [0, 1], "angle": 180})";
    for (const char* side : {"ahead", "behind"}) {
        const std::string by = std::string(R"(], "side": ")") + side + "\"}";
        EXPECT_EQ(refusal(with_points("\"P\": {\"meet\": [" + line + ", " + circle + by)), "read");
        EXPECT_EQ(refusal(with_points("\"P\": {\"meet\": [" + circle + ", " + circle + by)),
                  std::string("/points/P/side: \"") + side +
                      "\" is a side on a line; of two circles take \"left\" or \"right\"\n");
    }
}

TEST(Reader, ReadsEveryExample) {
    for (const std::string& name : tests::example_names())
        EXPECT_EQ(refusal(text_of(tests::example_file(name))), "read") << name;
}

TEST(Reader, ReadsTheFileOfTheDocumentation) {
    const Mechanism m = read(R"({
  "kinegraph": 1,
  "title": {"en": "Four-bar linkage", "it": "Quadrilatero articolato"},
  "units": {"length": "mm"},
  "frame": 1,
  "points": {
    "O2": [0, 0],
    "A":  {"from": "O2", "distance": 40, "angle": 60},
    "O4": [150, 0],
    "B":  {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 80}], "side": "left"}
  },
  "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
  "joints": [
    {"revolute": "O2", "bodies": [1, 2]},
    {"revolute": "A",  "bodies": [2, 3]},
    {"revolute": "B",  "bodies": [3, 4]},
    {"revolute": "O4", "bodies": [1, 4]}
  ],
  "drivers": [{"body": 2, "omega": "-120 rpm"}],
  "find": ["instant centres", "velocity", "acceleration"]
})");
    EXPECT_EQ(m.title.in(Language::it), "Quadrilatero articolato");
    EXPECT_EQ(m.source, "test.json");
    ASSERT_EQ(m.points.size(), 4U);
    EXPECT_EQ(m.points[1].where, "/points/A");
    const auto& polar = std::get<Polar>(m.points[1].placement);
    EXPECT_EQ(polar.distance, Exact::ratio(1, 25));
    EXPECT_EQ(polar.angle.value, Exact(60));
    EXPECT_TRUE(polar.angle.in_degrees);
    const auto& meet = std::get<Meet>(m.points[3].placement);
    EXPECT_EQ(meet.side, Meet::Side::left);
    EXPECT_EQ(std::get<CircleCurve>(meet.first).radius, Exact::ratio(3, 20));
    ASSERT_EQ(m.bodies.size(), 4U);
    EXPECT_EQ(m.bodies[0].name, "1");
    // The frame carries the points of its hinges.
    EXPECT_EQ(m.bodies[0].points, (std::vector{PointIndex(0), PointIndex(2)}));
    EXPECT_EQ(m.bodies[1].points, (std::vector{PointIndex(0), PointIndex(1)}));
    EXPECT_EQ(m.joints[3].bodies, (std::vector{frame, BodyIndex(3)}));
    EXPECT_EQ(m.joints[3].name, "O4");
    EXPECT_FALSE(m.joints[3].named);
    EXPECT_EQ(std::get<SpinDriver>(m.drivers[0]).omega, Exact(-4) * pi());
    EXPECT_TRUE(m.find.stated && m.find.velocity && m.find.acceleration && m.find.instant_centres);
    EXPECT_FALSE(m.find.forces);
    EXPECT_EQ(m.point_named("O4"), PointIndex(2));
    EXPECT_EQ(m.body_named("3"), BodyIndex(2));
    EXPECT_FALSE(m.point_named("C"));
    EXPECT_EQ(m.units.length.symbol, "mm");
    EXPECT_EQ(m.units.length.si, Exact::ratio(1, 1000));
    EXPECT_EQ(m.units.angle.si, pi() / 180);
}

TEST(Reader, DecimalsAreThoseOfTheText) {
    const Mechanism m = read(
        with_points(R"("A": [0.1, 18446744073709551616], "B": ["0.1 in", -7], "C": [1E+1, 0.000000000000000000001])"));
    EXPECT_EQ(std::get<Coordinates>(m.points[2].placement).at,
              (Vector{Exact::ratio(1, 10000), exact("18446744073709551.616")}));
    EXPECT_EQ(std::get<Coordinates>(m.points[3].placement).at, (Vector{exact("0.00254"), exact("-0.007")}));
    EXPECT_EQ(std::get<Coordinates>(m.points[4].placement).at, (Vector{exact("0.01"), exact("1e-24")}));
}

TEST(Reader, APointMayBeUsedBeforeItIsDefined) {
    const Mechanism m = read(with_points(R"("A": {"from": "Z", "to": "O", "ratio": -0.5}, "Z": [1, 1])"));
    const auto& along = std::get<Along>(m.points[2].placement);
    EXPECT_EQ(along.from, PointIndex(3));
    EXPECT_TRUE(along.is_ratio);
    EXPECT_EQ(along.amount, Exact::ratio(-1, 2));
}

TEST(Reader, PointsOfEveryForm) {
    const Mechanism m = read(with_points(R"(
        "A": {"from": "O", "distance": -5, "angle": "0.5 rad", "relative to": ["O", "Q"]},
        "B": {"from": "O", "to": "Q", "distance": "-2 cm"},
        "C": {"meet": [{"line": [1, 2], "angle": 30}, {"line": "O", "to": "Q"}]},
        "D": {"meet": [{"line": "O", "parallel": ["O", "Q"]}, {"line": "Q", "perpendicular": [1, 2]}]},
        "E": {"meet": [{"circle": [0, 0], "radius": "1 ft"}, {"line": "Q", "parallel": "45°"}], "near": [1, 2]})"));
    const auto& a = std::get<Polar>(m.points[2].placement);
    EXPECT_EQ(a.relative_to->to, PointIndex(1));
    EXPECT_FALSE(a.angle.in_degrees);
    EXPECT_EQ(std::get<Along>(m.points[3].placement).amount, Exact::ratio(-1, 50));
    const auto& c = std::get<Meet>(m.points[4].placement);
    EXPECT_EQ(std::get<Vector>(std::get<LineCurve>(c.first).through).x, Exact::ratio(1, 1000));
    EXPECT_EQ(std::get<LineCurve>(c.second).by, LineCurve::By::to);
    const auto& d = std::get<Meet>(m.points[5].placement);
    EXPECT_EQ(std::get<Bearing::Between>(std::get<LineCurve>(d.first).bearing.form).to, PointIndex(1));
    // A direction has no unit: [1, 2] stays [1, 2], whatever the unit of length.
    EXPECT_EQ(std::get<Vector>(std::get<LineCurve>(d.second).bearing.form), (Vector{1, 2}));
    const auto& e = std::get<Meet>(m.points[6].placement);
    EXPECT_EQ(e.near->x, Exact::ratio(1, 1000));
    EXPECT_EQ(std::get<Angle>(std::get<LineCurve>(e.second).bearing.form).value, Exact(45));
}

TEST(Reader, FrameIsNoughtAndNeedsNoEntry) {
    const Mechanism m = read(with(""));
    EXPECT_EQ(m.bodies[0].name, "0");
    EXPECT_EQ(m.joints[0].bodies, (std::vector{frame, BodyIndex(1)}));
}

TEST(Reader, FrameMayHaveAnEntryAnywhere) {
    const Mechanism m = read(R"({"kinegraph": 1, "frame": "ground", "points": {"A": [0, 0], "B": [1, 1]},
        "bodies": {"crank": ["A"], "ground": {"points": ["B"], "label": "base"}}, "joints": [{"revolute": "A",
        "bodies": ["ground", "crank"]}]})");
    ASSERT_EQ(m.bodies.size(), 2U);
    EXPECT_EQ(m.bodies[0].name, "ground");
    EXPECT_EQ(m.bodies[0].label.in(Language::it), "base");
    EXPECT_EQ(m.bodies[0].points, (std::vector{PointIndex(1), PointIndex(0)}));
    EXPECT_EQ(m.bodies[0].where, "/bodies/ground");
}

TEST(Reader, IntegersNamePointsInArraysOnly) {
    const std::string head =
        R"({"kinegraph": 1, "points": {"1": [0, 0], "2": [1, 0]}, "bodies": {"7": [1, 2]}, "joints": [{"revolute": )";
    EXPECT_EQ(read(head + R"("1", "bodies": [0, 7]}]})").bodies[1].points, (std::vector{PointIndex(0), PointIndex(1)}));
    EXPECT_EQ(refusal(head + R"(1, "bodies": [0, 7]}]})"),
              "/joints/0/revolute: a point's name is wanted here, not the number 1\n");
}

TEST(Reader, JointsOfEveryKind) {
    EXPECT_EQ(read(with_joint(R"({"revolute": "A", "bodies": [0, 2, 3, 4]})")).joints[0].bodies.size(), 4U);
    const Mechanism slot = read(with_joint(R"({"pin-slot": "A", "bodies": [2, 3], "arc": "B", "name": "s"})"));
    EXPECT_EQ(slot.joints[0].arc, PointIndex(2));
    EXPECT_TRUE(slot.joints[0].named);
    EXPECT_EQ(slot.joints[0].name, "s");
    // A pin in a slot is two points: neither body is made to carry it.
    EXPECT_EQ(slot.bodies[1].points, (std::vector{PointIndex(0)}));
    EXPECT_EQ(read(with_joint(R"({"weld": "A", "bodies": [2, 4]})")).bodies[3].points,
              (std::vector{PointIndex(2), PointIndex(1)}));
    const Mechanism contact = read(with_joint(
        R"({"contact": "A", "bodies": [2, 3], "profiles": {"2": {"line": ["O", "A"]}}, "pushes": [0, -1]})"));
    EXPECT_TRUE(std::holds_alternative<LineProfile>(contact.joints[0].profiles.at(BodyIndex(1))));
    EXPECT_EQ(contact.joints[0].pushes->y, Exact(-1));
    // A body's own circle is its profile.
    EXPECT_EQ(std::get<CircleProfile>(contact.joints[0].profiles.at(BodyIndex(2))).centre, PointIndex(2));
    const Mechanism gear =
        read(with_joint(R"({"gear": "A", "bodies": [2, 3], "tangent": 90, "pressure angle": 20, "arm": 4})"));
    EXPECT_EQ(gear.joints[0].arm, BodyIndex(3));
    EXPECT_EQ(gear.joints[0].pressure_angle->value, Exact(20));
    EXPECT_TRUE(gear.joints[0].tangent);
    EXPECT_TRUE(gear.joints[0].profiles.empty());
    const Mechanism rolling = read(
        with_joint(R"({"rolling": "A", "bodies": [2, 3], "profiles": {"2": {"tip": true}, "3": {"circle": "O"}}})"));
    // What the joint says goes before the body's circle.
    EXPECT_EQ(std::get<CircleProfile>(rolling.joints[0].profiles.at(BodyIndex(2))).centre, PointIndex(0));
}

TEST(Reader, DriversOfEveryKind) {
    const Mechanism m = read(with(R"("units": {"velocity": "mm/s", "angular velocity": "rpm"}, "drivers": [
        {"body": 3, "relative to": "2", "omega": 30, "alpha": 2},
        {"joint": "B", "speed": 5},
        {"body": "3", "at": "B", "along": ["O", "B"], "acceleration": "1 m/s^2"}])"));
    const auto& spin = std::get<SpinDriver>(m.drivers[0]);
    EXPECT_EQ(spin.relative_to, BodyIndex(1));
    EXPECT_EQ(spin.omega, pi());
    EXPECT_EQ(spin.alpha, Exact(2));
    const auto& slide = std::get<SlideDriver>(m.drivers[1]);
    EXPECT_EQ(slide.joint, JointIndex(2));
    EXPECT_EQ(slide.speed, Exact::ratio(1, 200));
    EXPECT_TRUE(slide.acceleration.is_zero());
    const auto& point = std::get<PointDriver>(m.drivers[2]);
    EXPECT_EQ(point.acceleration, Exact(1));
    EXPECT_EQ(point.where, "/drivers/2");
}

TEST(Reader, ForcesOfEveryKind) {
    const Mechanism m = read(with(
        R"("masses": {"3": {"mass": "2 t", "centre": "B", "inertia": "5 kg cm²"}}, "gravity": [0, -9.81],
        "inertia forces": true,
        "loads": [{"force": "F", "body": 3, "at": "B", "value": ["1 kN", 2]}, {"force": "G", "body": 2, "at": "A",
        "magnitude": 3, "along": 90},
                  {"couple": "M", "body": 2, "value": "1 lbf in"}, {"force": "S", "bodies": [0, 3], "between": ["O",
                  "B"], "magnitude": 7}],
        "effort": [{"couple": "C", "body": 2, "from": 3}, {"force": "P", "body": 3, "at": "B", "along": 0},
        {"force": "Q", "joint": "B"}])"));
    EXPECT_EQ(m.masses[0].mass, Exact(2000));
    EXPECT_EQ(m.masses[0].inertia, exact("0.0005"));
    EXPECT_EQ(m.gravity->y, exact("-9.81"));
    EXPECT_TRUE(m.inertia_forces);
    EXPECT_EQ(std::get<ForceLoad>(m.loads[0]).value->x, Exact(1000));
    EXPECT_EQ(std::get<ForceLoad>(m.loads[1]).magnitude->first, Exact(3));
    EXPECT_EQ(std::get<CoupleLoad>(m.loads[2]).value, exact("4.4482216152605") * exact("0.0254"));
    EXPECT_EQ(std::get<SpringLoad>(m.loads[3]).between, (std::array<PointIndex, 2>{PointIndex(0), PointIndex(2)}));
    EXPECT_EQ(std::get<CoupleEffort>(m.efforts[0]).from, BodyIndex(2));
    EXPECT_EQ(std::get<ActuatorEffort>(m.efforts[2]).joint, JointIndex(2));
}

TEST(Reader, OneEffortMayStandAlone) {
    EXPECT_EQ(read(with(R"("effort": {"couple": "C", "body": 2})")).efforts.size(), 1U);
}

TEST(Reader, InstantaneousMotionStandsForJoints) {
    const Mechanism m = read(R"({"kinegraph": 1, "points": {"A": [0, 0], "B": [1, 0]}, "bodies": {"1": ["A", "B"]},
        "motion": {"body": 1, "velocities": {"A": [1, "20 cm/s"], "B": {"along": 30}}, "accelerations": {"A": [0,
        0]}}})");
    ASSERT_TRUE(m.motion);
    EXPECT_EQ(std::get<Vector>(m.motion->velocities[0].value).y, Exact::ratio(1, 5));
    EXPECT_TRUE(std::holds_alternative<Bearing>(m.motion->velocities[1].value));
    EXPECT_TRUE(m.joints.empty());
}

TEST(Reader, WishesAndScales) {
    const Mechanism m = read(with(
        R"("find": ["forces", {"relative motion": "B", "observer": 2}, {"relative motion": "B",
        "observer": {"translating with": "A"}}],
        "scales": {"forces": "14 mm = 16.28 MN", "mechanism": "1:5", "velocity": "1 mm ≙ 0.01 m/s",
        "centres": "1 mm=5mm"})"));
    EXPECT_TRUE(m.find.forces);
    EXPECT_EQ(m.find.relative_motion[0].observer, BodyIndex(1));
    EXPECT_EQ(m.find.relative_motion[0].translating_with, none);
    EXPECT_EQ(m.find.relative_motion[1].translating_with, PointIndex(1));
    ASSERT_EQ(m.scales.size(), 4U);
    EXPECT_EQ(m.scales[0].figure, "forces");
    EXPECT_EQ(m.scales[0].per_millimetre, exact("16280000") / 14);
    EXPECT_EQ(m.scales[1].per_millimetre, exact("0.005"));
    EXPECT_EQ(m.scales[2].per_millimetre, exact("0.01"));
    EXPECT_EQ(m.scales[3].per_millimetre, exact("0.005"));
    EXPECT_FALSE(read(with("")).find.stated);
}

TEST(Reader, TextsServeWhereALanguageIsMissing) {
    EXPECT_EQ(read(with(R"("title": "Crank")")).title.in(Language::it), "Crank");
    EXPECT_EQ(read(with(R"("title": {"en": "Crank"})")).title.in(Language::it), "Crank");
    EXPECT_EQ(read(with(R"("title": {"it": "Manovella"})")).title.in(Language::en), "Manovella");
}

TEST(Reader, FaultsComeInTheFilesOrder) {
    EXPECT_EQ(
        refusal(
            R"({"find": ["x"], "points": {"A": [0, true]}, "kinegraph": 1, "bodies": {"1": ["A", "a"]}, "joints": 3})"),
        "/find/0: \"x\" is nothing to find; what can be found is \"instant centres\", \"velocity\", \"acceleration\", "
        "\"forces\", \"curvature\", \"equations\" and \"virtual work\" and "
        "{\"relative motion\": …}\n"
        "/points/A/1: a length is wanted here, not true\n"
        "/bodies/1/1: no point is named \"a\" (did you mean \"A\"?)\n"
        "/joints: an array of joints is wanted here, not the number 3\n");
}

TEST(Reader, AnotherWordIsNoMisspeltOne) {
    const auto said_of = [](const std::string& key) {
        return refusal(R"({"kinegraph": 1, ")" + key + R"(": {}, "joints": []})");
    };
    EXPECT_NE(said_of("pionts").find("unknown key \"pionts\" (did you mean \"points\"?)"), std::string::npos);
    EXPECT_NE(said_of("bodeis").find("(did you mean \"bodies\"?)"), std::string::npos);
    EXPECT_EQ(said_of("nodes").find("did you mean"), std::string::npos) << said_of("nodes");
}

TEST(Reader, AnotherNumberIsNoSlip) {
    Speller speller;
    for (int wanted = 1; wanted < 40; ++wanted)
        for (int known = 1; known < 40; ++known) {
            const std::string a = std::to_string(wanted), b = std::to_string(known);
            const bool typed_twice = a.size() == 2 && a[0] == a[1] && b == a.substr(0, 1);
            for (const char* const before : {"", "B"}) {
                const auto meant = speller.nearest(before + a, std::array{before + b});
                EXPECT_TRUE(!meant || a.size() == b.size() || typed_twice || (b.size() == 2 && b[0] == b[1]))
                    << before << a << " is not " << *meant;
            }
        }
    EXPECT_EQ(speller.nearest("33", std::array{"2", "3", "4"}), "3");
    EXPECT_EQ(speller.nearest("12", std::array{"2", "1", "11"}), "11") << "a digit is another";
    EXPECT_EQ(speller.nearest("Ab", std::array{"A", "B"}), std::nullopt);
}

TEST(Reader, AMisspeltNameIsToldOnce) {
    // The joint with the unknown point still has its name; the driver's reference to it is sound.
    EXPECT_EQ(refusal(with_joint(R"({"prismatic": "Z", "bodies": [2, 0], "along": 0})")
                          .insert(1, R"("drivers": [{"joint": "Z", "speed": 1}], )")),
              "/joints/0/prismatic: no point is named \"Z\" (did you mean \"O\"?)\n");
    // Without a list of points no name of a point is blamed.
    EXPECT_EQ(refusal(
                  R"({"kinegraph": 1, "points": [], "bodies": {"1": ["A"]}, "joints": [{"revolute": "A", "bodies": [0,
            1]}]})"),
              "/points: an object of points by name is wanted here, not an empty array\n");
}

TEST(Reader, AByteOrderMarkIsLetPass) { EXPECT_EQ(refusal("\xEF\xBB\xBF" + with("")), "read"); }

TEST(Reader, SlashesAndTildesOfNamesAreEscapedInPointers) {
    EXPECT_EQ(read(with_points(R"("a/b~c": [1, 2])")).points[2].where, "/points/a~1b~0c");
    EXPECT_EQ(refusal(with_points(R"("a/b~c": 1)")).substr(0, 17), "/points/a~1b~0c: ");
}

/// A loop that is quadratic in the length of the file would take hours, which the time limit of the suite sees.
TEST(Reader, TenMegabytesAreRefusedLikeAShortFile) {
    std::string points = R"("P0": [0, 0])";
    std::string unknown = R"("none")";
    for (int i = 1; points.size() < 5'000'000; ++i) {
        // A chain of points, each placed by the one before, and as many names that are none.
        const std::string number = std::to_string(i);
        points.append(", \"P")
            .append(number)
            .append(R"(": {"from": "P)")
            .append(std::to_string(i - 1))
            .append(R"(", "distance": 1, "angle": 0})");
        unknown.append(", \"Q").append(number).append(1, '"');
    }
    const auto ten_million = [](char c) {
        std::string text;
        text.resize(10'000'000, c);
        return text;
    };
    const std::vector<std::string> texts{
        R"({"kinegraph": 1, "points": {)" + points + R"(}, "bodies": {"1": [)" + unknown + R"(]}, "joints": []})",
        ten_million('['), '"' + ten_million('x') + '"', "[" + ten_million('9') + "]"};
    for (const std::string& text : texts) EXPECT_FALSE(read_mechanism(text, "large.json"));
}

TEST(JsonSource, KeepsOrderLiteralsAndPlaces) {
    const auto source = JsonSource::read(R"({"b": 1.50, "a": [true, null, {"x/y": "é"}], "b": 2})");
    ASSERT_TRUE(source);
    const JsonValue root = source->root();
    ASSERT_EQ(root.size(), 3U);
    EXPECT_EQ(root["b"].text(), "1.50");
    const JsonValue inner = *std::next(root["a"].begin(), 2);
    EXPECT_EQ(inner["x/y"].text(), "é");
    EXPECT_EQ(inner["x/y"].pointer(), "/a/2/x~1y");
    EXPECT_FALSE(root["c"]);
    ASSERT_EQ(source->duplicates().size(), 1U);
    EXPECT_EQ(source->duplicates()[0].text(), "2");
}

TEST(JsonSource, KeepsLiteralsThatNoDoubleHolds) {
    const std::string digits(400, '7');
    const auto source =
        JsonSource::read("[1, -1e400, \"1e400 \\\" 3\", " + digits + ", -" + digits + ".5e+3, 1e-400, 2E5]");
    ASSERT_TRUE(source) << lines_of(source.error());
    std::vector<std::string> literals;
    for (const JsonValue value : source->root()) literals.emplace_back(value.text());
    EXPECT_EQ(literals,
              (std::vector<std::string>{"1", "-1e400", "1e400 \" 3", digits, "-" + digits + ".5e+3", "1e-400", "2E5"}));
}

/// The parser takes it for the end of the text; what stands behind it would be read by no one.
TEST(JsonSource, RefusesANulWhereverItStands) {
    using namespace std::string_literals;
    for (const std::string& text : {"[1,\n 2]\0"s, "[1,\n 2]\0{\"garbage\": 1}"s, "[1e400,\n2]\0]"s}) {
        const auto source = JsonSource::read(text);
        ASSERT_FALSE(source);
        const Words& said = source.error()[0].message;
        EXPECT_TRUE(said.in(Language::en).starts_with("line 2, column ") &&
                    said.in(Language::en).ends_with(": this is not JSON: a NUL byte"))
            << said.in(Language::en);
        EXPECT_TRUE(said.in(Language::it).ends_with(": non è JSON: un byte NUL")) << said.in(Language::it);
    }
    EXPECT_FALSE(JsonSource::read("[1,\0 2]"s));
    EXPECT_FALSE(JsonSource::read("[\"a\0b\"]"s));
}

TEST(JsonSource, TellsTheLineEvenBehindHugeNumbers) {
    const auto source = JsonSource::read("[1e400,\n -" + std::string(350, '1') + ".0,\n  x]");
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error()[0].message.in(Language::en).substr(0, 18), "line 3, column 3: ");
}

}  // namespace
}  // namespace reader_test
