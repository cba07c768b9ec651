// What a beginner gets wrong: said with the likely remedy where more is free than is driven, and nowhere else.
#include <gtest/gtest.h>

#include "constructions/verdicts/verdicts.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::tests::likely_mistakes_test {
namespace {

/// A four-bar linkage whose bodies, joints and further members are given.
std::string four_bar(const std::string& bodies, const std::string& joints, const std::string& more = "") {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
        "points": {"O2": [0, 0], "A": [20, 30], "B": [100, 60], "C": [100, 60], "O4": [120, 0], "D": [60, 90]},
        "bodies": {)" +
           bodies + R"(}, "joints": [)" + joints + R"(], "drivers": [{"body": 2, "omega": 3}])" + more + "}";
}
const std::string bodies = R"("2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"])";
const std::string crank = R"({"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]})";
const std::string pin_b = R"({"revolute": "B", "bodies": [3, 4]})";
const std::string pin_o4 = R"({"revolute": "O4", "bodies": [1, 4]})";

std::vector<std::string> remarks(const std::string& text) {
    const Solution solution = solved(text);
    std::vector<std::string> all;
    for (const Message& each : likely_mistakes(solution.mechanism, solution.pose, solution.mobility))
        all.push_back(english(each));
    return all;
}
using Lines = std::vector<std::string>;

TEST(LikelyMistakes, NoneWhereAllIsDriven) {
    EXPECT_EQ(remarks(four_bar(bodies, crank + "," + pin_b + "," + pin_o4)), Lines{});
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const auto said = likely_mistakes(solution.mechanism, solution.pose, solution.mobility);
        EXPECT_TRUE(said.empty()) << name << ": " << english(said.front());
    }
}

TEST(LikelyMistakes, AFrameJointThatIsMissing) {
    EXPECT_EQ(remarks(four_bar(bodies, crank + "," + pin_b)),
              Lines{"Body 4 has one joint only, B, and nothing else holds or drives it; give it another, perhaps "
                    "{\"revolute\": \"O4\", \"bodies\": [\"1\", \"4\"]}."});
}

TEST(LikelyMistakes, APointThatTwoBodiesShareWithoutAPin) {
    EXPECT_EQ(remarks(four_bar(bodies, crank + "," + pin_o4)),
              Lines{"Bodies 3 and 4 meet in B, but no joint joins them there; if they are pinned, add "
                    "{\"revolute\": \"B\", \"bodies\": [\"3\", \"4\"]}."});
}

TEST(LikelyMistakes, TwoPointsAtOnePlace) {
    EXPECT_EQ(
        remarks(four_bar(R"("2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "C"])", crank + "," + pin_o4)),
        Lines{"Bodies 3 and 4 meet in B, where C lies too, but no joint joins them there; if they are pinned, add "
              "{\"revolute\": \"B\", \"bodies\": [\"3\", \"4\"]}."});
}

TEST(LikelyMistakes, ABodyWithoutAJoint) {
    EXPECT_EQ(remarks(four_bar(bodies + R"(, "5": ["D"])", crank + "," + pin_b + "," + pin_o4)),
              Lines{"Body 5 has no joint, so nothing holds it; give it one, perhaps "
                    "{\"revolute\": \"D\", \"bodies\": [\"1\", \"5\"]}."});
}

TEST(LikelyMistakes, BodiesThatNothingConnectsWithTheFrame) {
    const std::string ring = R"({"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]},
                                {"revolute": "D", "bodies": [2, 4]})";
    EXPECT_EQ(remarks(four_bar(bodies, ring)),
              Lines{"No joint connects bodies 2, 3, 4 with the frame, 1; give the one that does, "
                    "perhaps {\"revolute\": \"O2\", \"bodies\": [\"1\", \"2\"]}."});
}

TEST(Gravity, OfNoPlanetIsARemark) {
    const auto said = [](const std::string& unit, const std::string& gravity, Language language) {
        const std::string more = R"("masses": {"2": {"mass": 1, "centre": "A"}}, "gravity": [0, )" + gravity + "]";
        std::string text = four_bar(bodies, crank + "," + pin_b + "," + pin_o4, ", " + more);
        const std::string length = R"("length": "mm")";
        text.replace(text.find(length), length.size(), length + R"(, "acceleration": ")" + unit + "\"");
        std::vector<std::string> all;
        for (const Message& each : solved(text).remarks)
            if (each.sentence == lang::sentences::strange_gravity) all.push_back(render::tell(each, language));
        return all;
    };
    EXPECT_EQ(
        said("mm/s²", "-9.81", Language::en),
        Lines{"Gravity is 9.81 mm/s², as on no planet; if that is not meant, write it with its unit: \"9.81 m/s²\"."});
    EXPECT_EQ(
        said("mm/s²", "-9.81", Language::it),
        Lines{
            "La gravità è 9,81 mm/s², come su nessun pianeta; se non è voluto, scriverla con l’unità: \"9.81 m/s²\"."});
    EXPECT_EQ(said("m/s²", "-9810", Language::en).size(), 1U);
    for (const std::string gravity : {"-9.81", "\"-162 cm/s²\"", "0", "-25"})
        EXPECT_EQ(said("m/s²", gravity, Language::en), Lines{});
}

TEST(Lengths, ALinkWhosePinsCoincideIsNamed) {
    const auto said = [](const Solution& solution, Language language) {
        std::vector<std::string> all;
        for (const Message& each : solution.remarks)
            if (each.sentence == lang::sentences::link_without_length) all.push_back(render::tell(each, language));
        return all;
    };
    const std::string bars = four_bar(bodies, crank + "," + pin_b + "," + pin_o4);
    std::string text = bars;
    const std::string crank_pin = R"("A": [20, 30])";
    text.replace(text.find(crank_pin), crank_pin.size(), R"("A": [0, 0])");
    const Solution without = solved(text);
    EXPECT_EQ(said(without, Language::en), Lines{"Link 2 has no length: its pins O2, A lie at one place."});
    EXPECT_EQ(said(without, Language::it), Lines{"Il corpo 2 non ha lunghezza: i suoi perni O2, A coincidono."});
    EXPECT_EQ(said(solved(bars), Language::en), Lines{});
    for (const std::string& name : example_names()) EXPECT_EQ(said(example(name), Language::en), Lines{}) << name;
}

TEST(LikelyMistakes, ComeBeforeTheCallForDrivers) {
    const Solution forgotten = solved(four_bar(bodies, crank + "," + pin_b));
    ASSERT_FALSE(forgotten.remarks.empty());
    EXPECT_EQ(forgotten.remarks.front().sentence, lang::sentences::body_of_one_joint);
    ASSERT_FALSE(forgotten.unsolved.empty());
    EXPECT_EQ(english(forgotten.unsolved.front().why), "the mechanism has 3 freedoms and 1 of them driven");
}

TEST(LikelyMistakes, TheDriversThatLackAreCounted) {
    // Two cranks more, each driven by nothing but held by both its joints.
    const std::string five = R"("2": ["O2", "A"], "3": ["A", "B"], "4": ["B", "D"], "5": ["D", "O4"])";
    const std::string joints = crank + R"(, {"revolute": "B", "bodies": [3, 4]}, {"revolute": "D", "bodies": [4, 5]},
                                         {"revolute": "O4", "bodies": [1, 5]})";
    const Solution one_more = solved(four_bar(five, joints));
    ASSERT_FALSE(one_more.unsolved.empty());
    EXPECT_EQ(english(one_more.unsolved.front().why),
              "the mechanism has 2 freedoms and 1 of them driven; give one driver more");
}

/// A five-bar linkage under a load: two freedoms.
std::string five_bar(const std::string& more) {
    return R"({"kinegraph": 1, "points": {"A": [0, 0], "B": [1, 3], "C": [3, 5], "D": [6, 3], "E": [7, 0]},
        "bodies": {"2": ["A", "B"], "3": ["B", "C"], "4": ["C", "D"], "5": ["D", "E"]}, "frame": 1,
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [2, 3]},
        {"revolute": "C", "bodies": [3, 4]}, {"revolute": "D", "bodies": [4, 5]}, {"revolute": "E", "bodies": [1, 5]}],
        "loads": [{"force": "F", "body": 3, "at": "C", "value": [0, -5]}])" +
           more + "}";
}

TEST(LikelyMistakes, AFreedomWithoutItsEffort) {
    const std::string one = R"({"couple": "M", "body": 2})", other = R"({"couple": "N", "body": 5})";
    EXPECT_EQ(
        remarks(five_bar(", \"effort\": " + one)),
        Lines{"2 freedoms in this position and 1 input force or couple: equilibrium needs one for each freedom."});
    EXPECT_EQ(remarks(five_bar(", \"effort\": [" + one + "," + other + "]")), Lines{});
    EXPECT_EQ(remarks(five_bar(", \"effort\": [" + one + "," + other + R"(, {"couple": "L", "body": 3}])")),
              Lines{"3 input forces or couples for 2 freedoms in this position: equilibrium does not determine all of "
                    "them."});
}

TEST(LikelyMistakes, AFreedomWithoutItsDriver) {
    EXPECT_EQ(remarks(five_bar(R"(, "drivers": [{"body": 2, "omega": 1}])")),
              Lines{"2 freedoms in this position, of which the drivers determine 1: the motion of the rest is open; "
                    "give a driver for each."});
    EXPECT_EQ(remarks(five_bar(R"(, "drivers": [{"body": 2, "omega": 1}, {"body": 5, "omega": 1},
                                                {"body": 3, "omega": 1}])")),
              Lines{"3 drivers for 2 freedoms in this position: not all of them can be given; take out what the others "
                    "determine."});
}

}  // namespace
}  // namespace kinegraph::tests::likely_mistakes_test
