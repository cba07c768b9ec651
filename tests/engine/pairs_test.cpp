// The catalogue of pairs: what it says is what the rank finds, its schemes are trees, its page is the program's own
// output.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/chain.hpp"
#include "engine/mechanism/pair_catalogue.hpp"
#include "engine/motion/constraint_rows.hpp"
#include "engine/motion/mobility.hpp"
#include "render/tables/pair_tables.hpp"
#include "tests/support/sketch.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::pairs_test {
namespace {

using namespace sketch;
using render::TextForm;

/// One body against the frame by one pair of the kind.
Sketch single(JointKind kind) {
    Sketch s;
    s.point("P", "0", "0").point("C", "0", "1");
    switch (kind) {
        case JointKind::prismatic:
        case JointKind::pin_slot: s.joint(kind, "P", {"2", "1"}).along = at_angle("0"); break;
        case JointKind::rolling:
        case JointKind::contact:
        case JointKind::gear:
            s.touching(kind, "P", {"2", "1"}, {CircleProfile{s["C"]}, LineProfile{at_angle("0")}});
            break;
        case JointKind::revolute:
        case JointKind::weld: s.joint(kind, "P", {"2", "1"}); break;
    }
    return s;
}

TEST(Catalogue, LeavesTheFreedomsThatTheRankFinds) {
    for (const PlanePair& pair : plane_pairs) {
        const Sketch s = single(pair.kind);
        const auto pose = draw_pose(s.mechanism);
        ASSERT_TRUE(pose) << pair.key;
        const Mobility mobility = mobility_of(s.mechanism, *pose);
        EXPECT_EQ(mobility.effective, pair.freedoms()) << pair.key;
        EXPECT_EQ(mobility.gruebler, pair.freedoms()) << pair.key;
        EXPECT_EQ(static_cast<int>(constraint_rows(s.mechanism, *pose).size()), pair.reactions()) << pair.key;
    }
}

TEST(Catalogue, PutsTheCentreWhereTheRowsLeaveIt) {
    using Centre = PlanePair::Centre;
    for (const PlanePair& pair : plane_pairs) {
        const Sketch s = single(pair.kind);
        const auto pose = draw_pose(s.mechanism);
        ASSERT_TRUE(pose) << pair.key;
        // Guide and common tangent lie along x, P at the origin: a motion is the velocity there and a turn.
        bool rotates = true, translates = true;
        for (const ConstraintRow& row : constraint_rows(s.mechanism, *pose)) {
            rotates = rotates && !row.turn;
            translates = translates && (row.turn || row.along.x.is_zero());
        }
        const Centre centre = pair.centre();
        EXPECT_EQ(rotates, centre == Centre::at_point || centre == Centre::on_normal) << pair.key;
        EXPECT_EQ(translates, centre == Centre::at_infinity || centre == Centre::on_normal) << pair.key;
        const auto solution = solve(s.mechanism);
        ASSERT_TRUE(solution) << pair.key;
        ASSERT_EQ(solution->centres.size(), 1U) << pair.key;
        EXPECT_EQ(solution->centres.front().how == InstantCentre::How::primary, centre != Centre::on_normal)
            << pair.key << ": what the pair alone tells is known";
    }
}

TEST(Pairs, OnlyASleeveIsCalledASleeve) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [3, 4], "B": [7, 1]},
        "bodies": {"1": ["O", "A"], "2": ["A", "B"]}, "drivers": [{"body": 1, "omega": 2}],
        "joints": [{"revolute": "O", "bodies": [0, 1]}, {"weld": "A", "bodies": [1, 2]}]})");
    std::string said;
    for (const Statement& statement : solution.protocol.statements) said += english(statement.message) + "\n";
    EXPECT_NE(said.find("The joint at A allows no relative rotation"), std::string::npos) << said;
    EXPECT_EQ(said.find("sleeve"), std::string::npos) << said;
}

TEST(Catalogue, InSpaceMotionsAndReactionsAreSix) {
    for (const SpacePair& pair : space_pairs) {
        const auto letters = [](const SpacePair::Components& components, std::string_view of) {
            const std::string words = components.in_words();
            const std::string_view text = words;
            std::set<std::string_view> different;
            for (std::size_t i = 0; i + 2 < text.size(); ++i)
                if (of.find(text[i]) != std::string_view::npos && text[i + 1] == '_')
                    different.insert(text.substr(i, 3));
            if (text.size() >= 3) different.insert(text.substr(text.size() - 3));
            return static_cast<int>(different.size());
        };
        // On a screw one motion is two components in proportion, and so is one reaction.
        const int tied = pair.key == "helical" ? 1 : 0;
        EXPECT_EQ(letters(pair.motions, "tr") - tied, pair.freedoms) << pair.key;
        EXPECT_EQ(letters(pair.reactions, "FM") - tied, pair.reaction_count()) << pair.key;
    }
}

TEST(Schemes, AreAllTreesAndEachOnce) {
    const std::array<std::size_t, 5> cayley{1, 3, 16, 125, 1296};
    for (int bodies = 2; bodies <= 6; ++bodies) {
        const auto schemes = binary_schemes(bodies);
        ASSERT_EQ(schemes.size(), cayley.at(static_cast<std::size_t>(bodies) - 2));
        std::set<std::vector<std::array<int, 2>>> different;
        int stars = 0;
        for (const BinaryScheme& scheme : schemes) {
            ASSERT_EQ(static_cast<int>(scheme.hinges.size()), bodies - 1);
            different.insert(scheme.hinges);
            std::set<int> reached{0};
            for (int round = 0; round < bodies; ++round)
                for (const auto& [a, b] : scheme.hinges)
                    if (reached.count(a) != 0 || reached.count(b) != 0) reached.insert({a, b});
            EXPECT_EQ(static_cast<int>(reached.size()), bodies) << "the bodies hang together";
            for (int centre = 0; centre < bodies; ++centre) {
                bool star = true;
                for (const auto& [a, b] : scheme.hinges) star = star && (a == centre || b == centre);
                stars += star ? 1 : 0;
            }
        }
        EXPECT_EQ(different.size(), schemes.size());
        EXPECT_EQ(stars, bodies);
    }
}

std::string contents(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Catalogue, ThePageOfTheDocsIsTheProgramsOwn) {
    EXPECT_EQ(contents(KINEGRAPH_TESTS_DIR "/../docs/pairs.md"),
              render::pair_catalogue(Language::en, TextForm::markdown))
        << "print it again: kinegraph pairs --format markdown > docs/pairs.md";
}

TEST(Catalogue, SpeaksBothLanguages) {
    const std::string english = render::pair_catalogue(Language::en, TextForm::plain);
    const std::string italian = render::pair_catalogue(Language::it, TextForm::plain);
    EXPECT_NE(english.find("1296"), std::string::npos) << "schemes of six bodies";
    EXPECT_NE(english.find("revolute"), std::string::npos);
    EXPECT_NE(italian.find("cerniera"), std::string::npos);
    EXPECT_EQ(italian.find("revolute pair"), std::string::npos);
}

TEST(PairReport, CountsBothWaysAndListsTheSchemesOfAHinge) {
    Sketch s;
    s.point("O", "0", "0").point("A", "1", "0").point("B", "0", "1").point("C", "1", "2");
    s.revolute("O", {"1", "2"}).revolute("A", {"2", "3", "4"}).revolute("B", {"3", "1"}).revolute("C", {"4", "1"});
    const auto pose = draw_pose(s.mechanism);
    ASSERT_TRUE(pose);
    const Mobility mobility = mobility_of(s.mechanism, *pose);
    EXPECT_EQ(mobility.verdict(), Mobility::Verdict::hyperstatic);
    const std::string text = render::pair_report(s.mechanism, mobility, {}, Language::en, TextForm::plain);
    EXPECT_NE(text.find("n = 3(m − 1) − 2c₁ − c₂ = 3·3 − 2·5 − 0 = −1"), std::string::npos) << text;
    EXPECT_NE(text.find("n = 3n_c − n₁ − 2n₂ − 3n₃ = 3·3 − 0 − 2·5 − 3·0 = −1"), std::string::npos) << text;
    EXPECT_NE(text.find("(2–3)(2–4), (2–3)(3–4), (2–4)(3–4)"), std::string::npos) << text;
}

TEST(Chains, AreOpenClosedOrMixed) {
    Sketch arm;
    arm.point("O", "0", "0").point("A", "1", "0").point("B", "2", "1");
    arm.revolute("O", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"});
    const KinematicChain open = chain_of(arm.mechanism);
    EXPECT_EQ(open.kind(), KinematicChain::Kind::open);
    EXPECT_EQ(open.loops, 0);
    Sketch four_bar = arm;
    four_bar.point("C", "3", "0").revolute("C", {"4", "1"});
    const KinematicChain closed = chain_of(four_bar.mechanism);
    EXPECT_EQ(closed.kind(), KinematicChain::Kind::closed);
    EXPECT_EQ(closed.loops, 1);
    Sketch with_tail = four_bar;
    with_tail.point("D", "1", "1").revolute("D", {"3", "5"});
    const KinematicChain mixed = chain_of(with_tail.mechanism);
    EXPECT_EQ(mixed.kind(), KinematicChain::Kind::mixed);
    EXPECT_EQ(mixed.loops, 1);
}

TEST(Chains, OfEveryExampleHaveTheLoopsOfEuler) {
    // Watt's and Stephenson's six bodies make two loops; a hinge of three bodies counts as two pairs and once at each
    // body.
    const auto of = [](const char* name) {
        return chain_of(tests::solved(contents(tests::example_file(name))).mechanism);
    };
    for (const char* name : {"watt_six_bar", "stephenson_1_driver_2", "whitworth"}) {
        const KinematicChain chain = of(name);
        EXPECT_EQ(chain.loops, 2) << name;
        EXPECT_EQ(chain.parts, 1) << name;
        EXPECT_EQ(std::count(chain.pairs.begin(), chain.pairs.end(), 3), 2) << name;
        EXPECT_EQ(std::count(chain.pairs.begin(), chain.pairs.end(), 2), 4) << name;
    }
    const KinematicChain planetary = of("planetary_train");
    EXPECT_EQ(planetary.joints, 5);
    EXPECT_EQ(planetary.loops, 2);
    EXPECT_EQ(planetary.pairs, (std::vector<int>{2, 2, 3, 2}));
}

TEST(PairReport, SaysTheChainInAllFormsAndLanguages) {
    const Solution& solution = tests::example("planetary_train");
    const auto report = [&](Language language, TextForm form) {
        return render::pair_report(solution.mechanism, solution.mobility, {}, language, form);
    };
    EXPECT_NE(report(Language::en, TextForm::plain).find("kind: closed"), std::string::npos);
    EXPECT_NE(report(Language::en, TextForm::plain).find("ternary bodies: 1 (3)"), std::string::npos);
    EXPECT_NE(report(Language::it, TextForm::markdown).find("- membri ternari: 1 (3)"), std::string::npos);
    const auto json = nlohmann::json::parse(report(Language::it, TextForm::json));
    EXPECT_EQ(json.at("chain").at("kind"), "closed");
    EXPECT_EQ(json.at("chain").at("loops"), 2);
    EXPECT_EQ(json.at("bodies by pairs"), nlohmann::json::parse(R"({"2": 3, "3": 1})"));
    EXPECT_EQ(json.at("pairs").at(0).at("multiplicity"), 2);
    EXPECT_EQ(json.at("pairs").at(0).at("schemes").size(), 3u);
    EXPECT_EQ(json.at("mobility").at("gruebler"), solution.mobility.gruebler);
}

TEST(Catalogue, IsThereAsJson) {
    const auto json = nlohmann::json::parse(render::pair_catalogue(Language::en, TextForm::json));
    EXPECT_EQ(json.at("plane").size(), plane_pairs.size());
    for (const auto& pair : json.at("space")) {
        const int tied = pair.at("key") == "helical" ? 1 : 0;
        EXPECT_EQ(static_cast<int>(pair.at("motions").size()) - tied, pair.at("freedoms")) << pair;
        EXPECT_EQ(static_cast<int>(pair.at("reactions").size()), 6 - pair.at("freedoms").get<int>()) << pair;
    }
}

}  // namespace
}  // namespace kinegraph::pairs_test
