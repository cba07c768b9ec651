// Contact at joints of a solved mechanism: the load is the normal force found, radii are those of profiles and teeth;
// what presses nothing is said; faults of the file; pages, figures and results.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/results/results.hpp"
#include "problems/hertz/hertz.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/files.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/problem_tests.hpp"
#include "tests/support/schema_gate.hpp"
#include "tests/support/through_all.hpp"

namespace kinegraph::contacts_test {
namespace {

using namespace pages;
using std::numbers::pi;
using tests::solved;

const SolvedContact& only_contact(const Solution& solution) {
    const std::vector<SolvedContact>& all = solution.contacts->at_joints;
    EXPECT_EQ(all.size(), 1u);
    return all.front();
}
const HertzProblem& stated_at(const Solution& solution) { return only_contact(solution).stated->as<HertzProblem>(); }
const HertzSolution& found_at(const Solution& solution) { return only_contact(solution).found->as<HertzSolution>(); }
double reduced(double e1, double nu1, double e2, double nu2) {
    return 1 / ((1 - nu1 * nu1) / e1 + (1 - nu2 * nu2) / e2);
}

/// Half width and greatest pressure of a line contact.
void expect_line(const HertzSolution& found, double load, double radius, double modulus, double length) {
    const double b = std::sqrt(4 * load * radius / (pi * length * modulus));
    EXPECT_NEAR(found.radius, radius, 1e-12 * radius);
    EXPECT_NEAR(found.b, b, 1e-12 * b);
    EXPECT_NEAR(found.greatest, 2 * load / (pi * b * length), 1e-12 * found.greatest);
}

TEST(Contacts, RollerPressesItsCamWithTheForceOfTheTriangle) {
    const Solution& solution = tests::example("joint_contact/cam_and_roller");
    // 33, 44, 55: the normal leans by 0.8 of 800 N.
    EXPECT_NEAR(stated_at(solution).force.to_double(), 1000, 1e-9);
    EXPECT_EQ(*solution.efforts.front().value, Exact::ratio(264, 10));
    expect_line(found_at(solution), 1000, 0.04 * 0.015 / 0.055, reduced(207e9, 0.292, 100e9, 0.211), 0.02);
    tests::expect_near_check(*only_contact(solution).found, 1e-4, tests::Against::itself);
    EXPECT_TRUE(solution.contacts->remarks.empty());
}

TEST(Contacts, WheelPressesItsRailWithTheNormalPartAlone) {
    const Solution& solution = tests::example("joint_contact/driven_wheel");
    // 30 kN of weight, and 6 kN along the rail that only friction takes.
    EXPECT_NEAR(length(*solution.forces.front().force), std::hypot(30e3, 6e3), 1e-6);
    EXPECT_NEAR(stated_at(solution).force.to_double(), 30e3, 1e-9);
    expect_line(found_at(solution), 30e3, 0.45, reduced(207e9, 0.292, 207e9, 0.292), 0.04);
}

TEST(Contacts, TeethHaveTheRadiiOfTheirInvolutesAtThePitchPoint) {
    const Solution& solution = tests::example("joint_contact/spur_gears");
    const double alpha = 20 * pi / 180, load = 60 / 0.03 / std::cos(alpha);
    EXPECT_NEAR(stated_at(solution).force.to_double(), load, 1e-9 * load);
    EXPECT_NEAR(stated_at(solution).bodies[0].radii[0].to_double(), 0.03 * std::sin(alpha), 1e-15);
    EXPECT_NEAR(stated_at(solution).bodies[1].radii[0].to_double(), 0.06 * std::sin(alpha), 1e-15);
    expect_line(found_at(solution), load, 0.02 * std::sin(alpha), reduced(207e9, 0.292, 111e9, 0.349), 0.025);
}

/// A roller of radius 10 mm pushed downwards by a guided follower onto what `profile` says, at [0, 0].
std::string roller_on(const std::string& points, const std::string& body, const std::string& joint, const char* force) {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "points": {"P": [0, 0], "R": [0, 10], "H": [0, 40])" +
           points + R"(}, "bodies": {"1": {"points": ["R", "H"], "circle": {"centre": "R", "radius": 10}}, "2": )" +
           body + R"(}, "joints": [{"contact": "P", "bodies": [1, 2], "materials": "steel", "length": 20)" + joint +
           R"(}, {"prismatic": "H", "bodies": [1, 0], "along": 90}, {"prismatic": "P", "bodies": [2, 0], "along": 0,
           "name": "Q"}],
              "drivers": [{"joint": "Q", "speed": 1}], "loads": [{"force": "F", "body": 1, "at": "H", "value": [0, )" +
           force + R"(]}],
              "effort": {"force": "T", "body": 2, "at": "P", "along": 0}})";
}

TEST(Contacts, AConcavePartnerIsTheLargerCircleOnTheSameSide) {
    const Solution hollow = solved(
        roller_on(R"(, "C": [0, 25])", R"({"points": ["C"], "circle": {"centre": "C", "radius": 25}})", "", "-500"));
    EXPECT_TRUE(stated_at(hollow).bodies[1].inside[0]);
    EXPECT_FALSE(stated_at(hollow).bodies[0].inside[0]);
    expect_line(found_at(hollow), 500, 1 / (1 / 0.01 - 1 / 0.025), reduced(207e9, 0.292, 207e9, 0.292), 0.02);
    const Solution flat = solved(roller_on("", R"(["P"])", R"(, "profiles": {"2": {"line": 0}})", "-500"));
    EXPECT_TRUE(stated_at(flat).bodies[1].radii[0].is_zero());
    expect_line(found_at(flat), 500, 0.01, reduced(207e9, 0.292, 207e9, 0.292), 0.02);
    const Solution alike =
        solved(roller_on("", R"({"points": ["R"], "circle": {"centre": "R", "radius": 10}})", "", "-500"));
    EXPECT_TRUE(alike.contacts->at_joints.empty());
    EXPECT_NE(alike.contacts->remarks.front().in(Language::en).find("not larger than the convex one"),
              std::string::npos);
}

TEST(Contacts, WhatPressesNothingIsSaid) {
    const auto remark = [](const std::string& text) {
        const Solution solution = solved(text);
        EXPECT_TRUE(solution.contacts->at_joints.empty());
        return solution.contacts->remarks.at(0);
    };
    const auto on_flat = [](const char* force) {
        return roller_on("", R"(["P"])", R"(, "profiles": {"2": {"line": 0}})", force);
    };
    EXPECT_NE(remark(on_flat("500")).in(Language::en).find("would have to draw the bodies together"),
              std::string::npos);
    EXPECT_NE(remark(on_flat("500")).in(Language::it).find("dovrebbe attrarre i corpi fra loro"), std::string::npos);
    std::string deep = on_flat("-500");
    deep.replace(deep.find("\"steel\""), 7,
                 R"({"1": {"material": "steel", "depth": 5}, "2": {"material": "steel", "depth": 5}})");
    EXPECT_EQ(solved(deep).contacts->remarks.size(), 1u) << "a depth is of use on the flat body alone";
    EXPECT_EQ(stated_at(solved(deep)).bodies[1].depth, Exact::ratio(5, 1000));
    std::string unloaded = on_flat("-500");
    const std::size_t loads = unloaded.find("\"loads\"");
    unloaded.replace(loads, unloaded.find("\"effort\"") - loads, "");
    EXPECT_NE(remark(unloaded).in(Language::en).find("was not found"), std::string::npos);
}

// The check integrates over the width of the contact: without end where its load is lost beside far larger forces.
TEST(Contacts, ALoadThatTheCheckLosesIsStillAnswered) {
    std::string text = tests::contents(tests::example_file("joint_contact/driven_wheel"));
    text.replace(text.find("-30 kN"), 6, "-30e-40 kN");
    const Solution solution = solved(text);
    EXPECT_NEAR(stated_at(solution).force.to_double() * 1e36, 3, 1e-9);
    expect_line(found_at(solution), 3e-36, 0.45, reduced(207e9, 0.292, 207e9, 0.292), 0.04);
}

TEST(Contacts, FaultsAreToldWhereTheyStand) {
    const auto fault = [](const std::string& from, const std::string& to) {
        std::string text = tests::contents(tests::example_file("joint_contact/spur_gears"));
        EXPECT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
        const auto mechanism = read_mechanism(text, "gears.json");
        EXPECT_FALSE(mechanism) << to;
        return mechanism ? Error{} : mechanism.error().front();
    };
    const std::string given = R"("materials": {"2": "steel", "3": "bronze"}, "length": 25)", at = "/joints/2/materials";
    EXPECT_EQ(fault(given, R"("materials": {"2": "steel", "3": "bronse"}, "length": 25)").where, at + "/3");
    EXPECT_NE(fault(given, R"("materials": {"2": "steel", "3": "bronse"}, "length": 25)")
                  .message.in(Language::en)
                  .find("did you mean \"bronze\""),
              std::string::npos);
    EXPECT_EQ(fault(given, R"("materials": {"2": "steel"}, "length": 25)").where, at);
    EXPECT_EQ(fault(given, R"("materials": {"2": "steel", "1": "steel"}, "length": 25)").where, at + "/1");
    EXPECT_EQ(fault(given, R"("materials": {"2": "steel", "3": {"young": 1e9, "poisson": 0.5}}, "length": 25)").where,
              at + "/3/poisson");
    EXPECT_EQ(fault(given, R"("materials": "steel")").where, "/joints/2");
    EXPECT_EQ(fault(given, R"("materials": "steel", "length": -1)").where, "/joints/2/length");
    EXPECT_EQ(fault(given, R"("length": 25)").where, "/joints/2/length");
    EXPECT_EQ(fault(R"("pressure angle": 20, )", "").where, at);
    EXPECT_EQ(fault(R"("pressure angle": 20)", R"("pressure angle": 0)").where, "/joints/2/pressure angle");
    EXPECT_EQ(fault(R"({"revolute": "O2", )", R"({"materials": "steel", "revolute": "O2", )").where,
              "/joints/0/materials");
}

class ContactSheets : public testing::TestWithParam<const char*> {};

TEST_P(ContactSheets, FollowTheMechanismInBothLanguages) {
    const Solution& solution = tests::example(std::string("joint_contact/") + GetParam());
    const std::string joint = solution.mechanism.joint(only_contact(solution).joint).name;
    for (const Language language : {Language::en, Language::it}) {
        SheetOptions options;
        options.language = language;
        const std::vector<Page> sheets = lay_out(solution, options, fonts());
        expect_clean(sheets);
        for (const Page& page : sheets) expect_sound_groups(page);
        EXPECT_TRUE(says(sheets, (language == Language::en ? "Contact at " : "Contatto in ") + joint));
        const std::string last = std::to_string(sheets.size());
        EXPECT_TRUE(says(sheets.back(), last + "/" + last)) << "its pages are counted with the others";
        EXPECT_NE(results_table(solution, language)
                      .find(language == Language::en ? "greatest pressure" : "pressione massima"),
                  std::string::npos);
    }
    for (const char* figure : {"contact-", "pressure-", "stresses-"})
        EXPECT_TRUE(lay_out_alone(solution, {}, figure + joint, fonts())) << figure;
    EXPECT_TRUE(lay_out_alone(solution, {}, "mechanism", fonts()));
    EXPECT_FALSE(lay_out_alone(solution, {}, "contact-" + joint + "x", fonts()));
}

TEST_P(ContactSheets, FollowTheSchemaAndComeThroughAll) {
    const std::string text = tests::contents(tests::example_file(std::string("joint_contact/") + GetParam()));
    const Errors refused = refused_by_schema(text);
    EXPECT_TRUE(refused.empty()) << refused.front().where;
    EXPECT_TRUE(tests::through_all(text, fonts()).drawn);
}

TEST_P(ContactSheets, HaveResultsUnderTheirJointAndChecks) {
    const Solution& solution = tests::example(std::string("joint_contact/") + GetParam());
    const std::string joint = solution.mechanism.joint(only_contact(solution).joint).name;
    const auto results =
        nlohmann::json::parse(results_json(solution, false, [](const Message&) { return std::string(); }));
    const auto& contact = results.at("hertz").at(joint);
    EXPECT_EQ(contact.at("force"), stated_at(solution).force.to_double());
    EXPECT_EQ(contact.at("greatest pressure"), found_at(solution).greatest);
    EXPECT_EQ(contact.size(), 1 + only_contact(solution).found->values.size());
    bool checked = false;
    for (const auto& row : results.at("checks")) {
        EXPECT_NEAR(row.at("graphical"), row.at("numeric"), 1e-5 + 1e-5 * std::abs(row.at("graphical").get<double>()));
        checked = checked || row.at("quantity") == "hertz " + joint + " half width";
    }
    EXPECT_TRUE(checked);
}

TEST(Contacts, StepsGoOnToTheContact) {
    const Solution& solution = tests::example("joint_contact/spur_gears");
    const std::vector<Page> steps = lay_out_steps(solution, {}, fonts());
    expect_clean(steps);
    EXPECT_TRUE(says(steps.back(), "Results and numeric check"));
    EXPECT_TRUE(says(steps.front(), "1/" + std::to_string(steps.size())));
}

INSTANTIATE_TEST_SUITE_P(Examples, ContactSheets, testing::Values("cam_and_roller", "driven_wheel", "spur_gears"));

}  // namespace
}  // namespace kinegraph::contacts_test
