// Laws of motion: their closed forms, what they ask of files, and drivers that follow them.
#include "engine/mechanism/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/drivers.hpp"
#include "tests/support/schema_gate.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::law_test {
namespace {

constexpr double pi_ = std::numbers::pi;

Law one_piece(LawForm form, int rise, int over) { return {{{form, rise, over}}, 0, ""}; }

TEST(Law, HasItsTextbookPeaks) {
    struct Case {
        LawForm form;
        double speed, acceleration;  ///< the largest, in h/T and h/T²
    };
    for (const Case& each : {Case{LawForm::constant_speed, 1, 0}, Case{LawForm::constant_acceleration, 2, 4},
                             Case{LawForm::harmonic, pi_ / 2, pi_ * pi_ / 2}, Case{LawForm::cycloidal, 2, 2 * pi_},
                             Case{LawForm::polynomial_345, 1.875, 10 / std::sqrt(3)},
                             Case{LawForm::modified_trapezoidal, 2, 8 * pi_ / (2 + pi_)}}) {
        SCOPED_TRACE(spelling_of(each.form));
        const Law law = one_piece(each.form, 3, 2);
        double speed = 0, acceleration = 0;
        const int steps = 24000;
        for (int i = 0; i <= steps; ++i) {
            const LawState here = law.at(2.0 * i / steps);
            speed = std::max(speed, std::abs(here.first));
            acceleration = std::max(acceleration, std::abs(here.second));
        }
        EXPECT_NEAR(speed, each.speed * 3 / 2, 1e-7);
        EXPECT_NEAR(acceleration, each.acceleration * 3 / 4, 1e-6);
        EXPECT_EQ(law.at(0).s, 0);
        EXPECT_NEAR(law.at(2).s, 3, 1e-15);
        EXPECT_NEAR(law.at(1).s, 1.5, 1e-15) << "it is as quick after the middle as before";
    }
}

TEST(Law, DerivativesAreThoseOfTheWay) {
    for (const std::string_view name : law_form_names) {
        SCOPED_TRACE(name);
        const Law law = one_piece(*law_form_spelt(name), -2, 3);
        const double h = 1e-5;
        for (double t = 0.01; t < 3; t += 0.0613) {
            EXPECT_NEAR((law.at(t + h).s - law.at(t - h).s) / (2 * h), law.at(t).first, 1e-8);
            if (std::abs(t - 1.5) > 1e-3) {
                EXPECT_NEAR((law.at(t + h).first - law.at(t - h).first) / (2 * h), law.at(t).second, 1e-8);
            }
            if (law.pieces[0].form != LawForm::rest) {
                EXPECT_NEAR(law.when(law.at(t).s).value(), t, 1e-6);
            }
        }
        EXPECT_FALSE(law.when(1e-3));
    }
}

TEST(Law, PiecesFollowEachOther) {
    const Law law{{{LawForm::harmonic, 2, 1}, {LawForm::rest, 0, 3}, {LawForm::cycloidal, -3, 2}}, 0, ""};
    EXPECT_EQ(law.length(), 6);
    EXPECT_EQ(law.range(), (std::pair<double, double>(-1, 2)));
    EXPECT_EQ(law.at(2.5).s, 2);
    EXPECT_EQ(law.at(2.5).first, 0);
    EXPECT_EQ(law.at(5).s, 0.5);
    EXPECT_EQ(law.at(-1).s, 0);
    EXPECT_NEAR(law.at(7).s, -1, 1e-15);
    EXPECT_EQ(law.at(1).second, 0) << "where two meet the later one's derivatives hold";
    EXPECT_EQ(law.when(2), 1) << "the first time";
}

std::string crank(const std::string& driver) {
    return R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [1, 0]}, "bodies": {"2": ["O", "A"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, )" +
           driver + "}]}";
}

TEST(Law, OfAFileIsReadAndGivesTheDrawnRates) {
    const Mechanism m = *read_mechanism(
        crank(R"("law": [{"form": "cycloidal", "turn": 90, "time": "500 ms"}], "drawn at": 0.25)"), "a.json");
    const auto& driver = std::get<SpinDriver>(m.drivers[0]);
    ASSERT_TRUE(driver.law);
    EXPECT_NEAR(driver.omega.to_double(), 2 * (pi_ / 2) / 0.5, 1e-12);
    EXPECT_NEAR(driver.alpha.to_double(), 0, 1e-12);
    EXPECT_TRUE(refused_by_schema(crank(R"("law": {"form": "3-4-5", "turn": "1 rad", "time": "2 s"})")).empty());
}

TEST(Law, FaultsOfFilesAreTold) {
    struct Case {
        const char* driver;
        const char* told;
    };
    for (const Case& each :
         {Case{R"("law": {"form": "cycloid", "turn": 1, "time": 1})", "no form of motion is called \"cycloid\""},
          Case{R"("law": {"form": "harmonic", "time": 1})", "\"turn\" is missing"},
          Case{R"("law": {"form": "harmonic", "turn": 0, "time": 1})", "it goes nowhere"},
          Case{R"("law": {"form": "rest", "turn": 1, "time": 1})", "in a rest nothing moves"},
          Case{R"("law": {"form": "harmonic", "turn": 1, "time": 0})", "must be greater than zero"},
          Case{R"("law": [])", "one piece at least"},
          Case{R"("law": {"form": "harmonic", "turn": 1, "time": 1}, "omega": 2)", "leave out \"omega\""},
          Case{R"("law": {"form": "harmonic", "turn": 1, "time": 1}, "drawn at": 2)", "no time of the law"},
          Case{R"("drawn at": 2)", "there is none"},
          Case{R"("law": {"form": "harmonic", "turn": "2 mm", "time": 1})", "is a length; an angle is wanted"},
          Case{R"("law": {"form": "harmonic", "slide": "2 mm", "time": 1})", "unknown key \"slide\""}}) {
        const auto read = read_mechanism(crank(each.driver), "a.json");
        ASSERT_FALSE(read) << each.driver;
        EXPECT_TRUE(std::any_of(
            read.error().begin(), read.error().end(),
            [&](const Error& error) { return error.message.in(Language::en).find(each.told) != std::string::npos; }))
            << each.driver << ": " << read.error().front().message.in(Language::en);
        std::set<std::string> places;
        for (const Error& error : read.error()) EXPECT_TRUE(places.insert(error.where).second) << error.where;
    }
}

TEST(Law, ACrankThatFollowsOneMovesItsSliderByTheChainRule) {
    const std::string text = tests::contents(tests::example_file("slider_crank_law"));
    const Mechanism m = *read_mechanism(text, "a.json");
    const Pose pose = *draw_pose(m);
    Cycle cycle = *Cycle::of(m, pose, 0);
    const Law& law = *law_of(m.drivers[0]);
    const Travel travel = *travel_of_law(cycle.positions(), law, {}, {});
    ASSERT_TRUE(travel.times);
    EXPECT_NEAR(travel.times->first, -0.125, 1e-15) << "time is zero as drawn";
    EXPECT_NEAR(travel.times->second, 1.375, 1e-15);
    EXPECT_TRUE(cycle.begin(travel).empty());
    const auto column = [&](const char* name) {
        for (std::size_t i = 0; i < cycle.columns().size(); ++i)
            if (cycle.columns()[i].name == name) return i;
        throw std::out_of_range(name);
    };
    const std::size_t x = column("x B"), v = column("vx B"), a = column("ax B"), omega = column("omega 2"),
                      time = column("time");
    const double r = 0.05, l = 0.15, drawn = law.at(0.125).s;
    for (int i = 0; i <= 150; ++i) {
        const auto row = cycle.row(travel.at(i / 150.0));
        ASSERT_TRUE(row) << i;
        const LawState here = law.at(0.01 * i);
        const double angle = pi_ / 6 + here.s - drawn, s = std::sin(angle), c = std::cos(angle),
                     root = std::sqrt(l * l - r * r * s * s);
        const double first = -r * s - r * r * s * c / root;
        const double second =
            -r * c - r * r * (c * c - s * s) / root - std::pow(r, 4) * s * s * c * c / std::pow(root, 3);
        EXPECT_NEAR((*row)[time], 0.01 * i - 0.125, 1e-12);
        EXPECT_NEAR((*row)[omega], here.first, 1e-12);
        EXPECT_NEAR((*row)[x], r * c + root, 1e-12);
        EXPECT_NEAR((*row)[v], first * here.first, 1e-11);
        EXPECT_NEAR((*row)[a], first * here.second + second * here.first * here.first, 1e-9);
    }
    EXPECT_LT(cycle.difference().share, 1e-9);
}

}  // namespace
}  // namespace kinegraph::law_test
