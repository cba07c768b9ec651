// Cams: the curve that a law asks for against closed forms, against the follower that rolls round it, and against our
// own solver.
#include "engine/mechanism/cam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/motion/closure.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::cam_test {
namespace {

using Spot = VectorOf<double>;
constexpr double pi_ = std::numbers::pi;

std::string file(const std::string& follower, const std::string& law, int base, const char* omega = "10") {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "cam": {"omega": )" + std::string(omega) +
           R"(, "base radius": )" + std::to_string(base) + R"(, "follower": )" + follower + R"(, "law": )" + law + "}}";
}
/// Up, a rest, down, a rest.
std::string dwells(const std::string& rise) {
    return R"([{"form": "cycloidal", "rise": )" + rise + R"(, "turn": 110}, {"form": "rest", "turn": 50},
        {"form": "modified trapezoidal", "rise": -)" +
           rise + R"(, "turn": 120}, {"form": "rest", "turn": 80}])";
}
Cam cam_of(const std::string& text, const std::string& name = "cam.json") {
    auto cam = read_cam(text, name);
    if (!cam) throw std::runtime_error(cam.error().front().where + ": " + cam.error().front().message.in(Language::en));
    return *std::move(cam);
}

struct Kind {
    const char* name;
    const char* follower;
    const char* rise;
    const char* omega;
};
const std::vector<Kind> kinds{
    {"roller, offset", R"({"moves": "translating", "face": "roller", "radius": 10, "offset": 8})", "24", "10"},
    {"edge", R"({"moves": "translating", "face": "knife edge", "offset": -6})", "20", "-10"},
    {"flat", R"({"moves": "translating", "face": "flat"})", "15", "-10"},
    {"rocker with roller", R"({"moves": "oscillating", "face": "roller", "radius": 8, "pivot": [90, 10], "arm": 80})",
     "20", "10"},
    {"on the right",
     R"({"moves": "oscillating", "face": "roller", "radius": 8, "pivot": [90, 10], "arm": 80, "side": "right"})", "20",
     "10"},
    {"rocker with edge", R"({"moves": "oscillating", "face": "knife edge", "pivot": [-90, 10], "arm": 80})", "20",
     "-10"},
    {"lever", R"({"moves": "oscillating", "face": "flat", "pivot": [90, 10], "offset": 5})", "12", "10"},
    {"lever on the right",
     R"({"moves": "oscillating", "face": "flat", "pivot": [90, 10], "offset": -5, "side": "right"})", "12", "-10"}};

/// What the profile leaves between itself and the follower that stands where the law has it; negative where it would
/// cut.
double clearance(const Cam& cam, const CamState& at, const Spot& profile) {
    if (cam.follower.face == Follower::Face::flat) return dot(at.outward, at.contact - profile);
    const Spot d = profile - at.trace;
    return std::hypot(d.x, d.y) - cam.follower.radius.to_double();
}

TEST(Cam, ItsProfileTouchesTheFollowerEverywhereAndCutsItNowhere) {
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const Cam cam = cam_of(file(kind.follower, dwells(kind.rise), 40, kind.omega));
        const CamGeometry geometry = *CamGeometry::of(cam);
        std::vector<Spot> profile;
        for (int i = 0; i < 3600; ++i) {
            const CamState state = geometry.at(2 * pi_ * i / 3600);
            profile.push_back(state.on_cam(state.contact, geometry.sense()));
        }
        EXPECT_NEAR(std::hypot(profile[0].x, profile[0].y), 0.04,
                    cam.follower.face == Follower::Face::knife_edge ? 1e-12 : 1e-3);
        EXPECT_TRUE(summary_of(cam, geometry).undercuts.empty());
        for (int degrees = 0; degrees < 360; degrees += 15) {
            const CamState state = geometry.at(degrees * pi_ / 180);
            const double turned = geometry.sense() * state.turn;
            double least = std::numeric_limits<double>::infinity();
            for (const Spot& on_cam : profile)
                least = std::min(least, clearance(cam, state, faced(Spot{std::cos(turned), std::sin(turned)}, on_cam)));
            EXPECT_NEAR(least, 0, 1e-6) << degrees;
        }
    }
}

TEST(Cam, OurOwnSolverFindsTheLaw) {
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const Cam cam = cam_of(file(kind.follower, dwells(kind.rise), 40, kind.omega));
        const CamGeometry geometry = *CamGeometry::of(cam);
        const bool translates = cam.follower.moves == Follower::Moves::translating;
        for (int degrees = 5; degrees < 360; degrees += 35) {
            const CamState state = geometry.at(degrees * pi_ / 180);
            const Solution solution = tests::solved(mechanism_file_of(cam, geometry, state.turn));
            EXPECT_TRUE(solution.unsolved.empty()) << degrees;
            const double speed = state.rise.first * 10, acceleration = state.rise.second * 100;
            if (translates) {
                const Sliding& slide = solution.sliding.back();
                EXPECT_NEAR(slide.velocity->y.to_double(), speed, 1e-12) << degrees;
                EXPECT_NEAR(slide.acceleration->y.to_double(), acceleration, 1e-10) << degrees;
            } else {
                const BodyMotion& body = solution.bodies.back();
                EXPECT_NEAR(body.omega->to_double(), geometry.rises() * speed, 1e-10) << degrees;
                EXPECT_NEAR(body.alpha->to_double(), geometry.rises() * acceleration, 1e-8) << degrees;
            }
        }
    }
}

TEST(Cam, AnEccentricIsFoundAgain) {
    // Harmonic all round under a flat face, s = e (1 − cos θ): a circle of radius r + e about a point e beside the
    // axis.
    const Cam cam = cam_of(
        file(R"({"moves": "translating", "face": "flat"})",
             R"([{"form": "harmonic", "rise": 20, "turn": 180}, {"form": "harmonic", "rise": -20, "turn": 180}])", 30));
    const CamGeometry geometry = *CamGeometry::of(cam);
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const CamState state = geometry.at(degrees * pi_ / 180);
        EXPECT_NEAR(state.curvature, 1 / 0.04, 1e-9);
        const Spot on_cam = state.on_cam(state.contact, geometry.sense());
        EXPECT_NEAR(std::hypot(on_cam.x, on_cam.y + 0.01), 0.04, 1e-12) << degrees;
        EXPECT_EQ(state.pressure_angle, 0);
    }
    const CamSummary summary = summary_of(cam, geometry);
    EXPECT_NEAR((*summary.face)[0], -0.01, 1e-6);
    EXPECT_NEAR((*summary.face)[1], 0.01, 1e-6);
}

TEST(Cam, ThePressureAngleIsTheTextbooks) {
    const Cam cam = cam_of(file(kinds[0].follower, dwells("24"), 40));
    const CamGeometry geometry = *CamGeometry::of(cam);
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const CamState state = geometry.at(degrees * pi_ / 180);
        const double height = std::sqrt(0.05 * 0.05 - 0.008 * 0.008) + state.rise.s;
        EXPECT_NEAR(std::tan(state.pressure_angle), (state.rise.first - 0.008) / height, 1e-12);
    }
}

TEST(Cam, UndercutIsSaid) {
    // ρ = r + s + s″ of a flat face; cycloidal: s + s″ is least where the deceleration is greatest.
    const std::string law = dwells("40");
    for (const auto& [base, is_cut] : {std::pair(20, true), std::pair(120, false)}) {
        const Cam cam = cam_of(file(R"({"moves": "translating", "face": "flat"})", law, base));
        const CamGeometry geometry = *CamGeometry::of(cam);
        double least = 1;
        for (int i = 0; i <= 7200; ++i) {
            const LawState here = cam.law.at(2 * pi_ * i / 7200);
            least = std::min(least, base * 1e-3 + here.s + here.second);
        }
        ASSERT_EQ(least <= 0, is_cut);
        EXPECT_EQ(!summary_of(cam, geometry).undercuts.empty(), is_cut) << base;
    }
    // A roller larger than the pitch curve's least radius.
    const std::string steep =
        R"([{"form": "cycloidal", "rise": 40, "turn": 60}, {"form": "cycloidal", "rise": -40, "turn": 60},
        {"form": "rest", "turn": 240}])";
    const Cam blunt = cam_of(file(R"({"moves": "translating", "face": "roller", "radius": 25})", steep, 15));
    EXPECT_FALSE(summary_of(blunt, *CamGeometry::of(blunt)).undercuts.empty());
    const Cam fine = cam_of(file(R"({"moves": "translating", "face": "roller", "radius": 2})", steep, 80));
    EXPECT_TRUE(summary_of(fine, *CamGeometry::of(fine)).undercuts.empty());
}

/// Up and down at constant speeds: the speed jumps up at 60° and 360°, down at 160° and 200°.
std::string with_jumps(const std::string& rise) {
    return R"([{"form": "rest", "turn": 60}, {"form": "constant speed", "rise": )" + rise +
           R"(, "turn": 100}, {"form": "rest", "turn": 40}, {"form": "constant speed", "rise": -)" + rise +
           R"(, "turn": 160}])";
}

TEST(Cam, WhereTheSpeedJumpsThePitchCurveHasACorner) {
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const Cam cam = cam_of(file(kind.follower, with_jumps(kind.rise), 40, kind.omega));
        const CamGeometry geometry = *CamGeometry::of(cam);
        const bool is_edge = cam.follower.face == Follower::Face::knife_edge;
        const CamSummary summary = summary_of(cam, geometry);
        ASSERT_EQ(summary.corners.size(), 4U);
        // In the order of the turn: the end, which is the beginning, then the others.
        const std::array<double, 4> turns{0, 60, 160, 200};
        const std::array<bool, 4> are_cut{false, false, true, true};
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(summary.corners[i].after.turn * 180 / pi_, turns.at(i), 1e-9);
            EXPECT_EQ(summary.corners[i].is_cut, are_cut.at(i) && !is_edge) << turns.at(i);
        }
        // Where a follower in another position reaches behind the contact, by brute force.
        constexpr int count = 3600;
        std::vector<CamState> states;
        for (int i = 0; i < count; ++i) states.push_back(geometry.at(2 * pi_ * i / count));
        for (int i = 5; i < count; i += 10) {
            const CamState& at = states[static_cast<std::size_t>(i)];
            const Spot contact = at.on_cam(at.contact, geometry.sense());
            double least = 0;
            for (const CamState& other : states) {
                const double turned = geometry.sense() * other.turn;
                least =
                    std::min(least, clearance(cam, other, faced(Spot{std::cos(turned), std::sin(turned)}, contact)));
            }
            const bool told = std::any_of(summary.undercuts.begin(), summary.undercuts.end(), [&](const auto& range) {
                return range[0] <= at.turn && at.turn <= range[1];
            });
            EXPECT_EQ(least < -1e-8, told) << at.turn * 180 / pi_;
        }
        EXPECT_EQ(summary.undercuts.empty(), is_edge);
    }
}

TEST(Cam, TheProfileGoesRoundAHollowCornerInAnArcOfTheRoller) {
    const Cam cam = cam_of(file(kinds[0].follower, with_jumps("24"), 40));
    const CamGeometry geometry = *CamGeometry::of(cam);
    const CamSummary summary = summary_of(cam, geometry);
    const CamCorner& corner = summary.corners[1];
    const Spot centre = corner.after.on_cam(corner.after.trace, geometry.sense());
    const auto distance = [](const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    EXPECT_GT(distance(corner.before.contact, corner.after.contact), 2e-3);
    const std::vector<Spot> profile = working_profile(cam, geometry, 1440);
    int on_arc = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        EXPECT_LT(distance(profile[i - 1], profile[i]), 0.5e-3);
        on_arc += std::abs(distance(profile[i], centre) - 0.01) < 1e-12;
    }
    EXPECT_GT(on_arc, 5);
}

TEST(Cam, TwoUndercutsAreTwo) {
    const std::string twice = R"([{"form": "cycloidal", "rise": 20, "turn": 45}, {"form": "rest", "turn": 60},
        {"form": "cycloidal", "rise": -20, "turn": 90}, {"form": "rest", "turn": 30}, {"form": "cycloidal",
        "rise": 20, "turn": 45},
        {"form": "cycloidal", "rise": -20, "turn": 90}])";
    const Cam cam = cam_of(file(R"({"moves": "translating", "face": "flat"})", twice, 20));
    const CamSummary summary = summary_of(cam, *CamGeometry::of(cam));
    ASSERT_GE(summary.undercuts.size(), 2U);
    for (const auto& [from, to] : summary.undercuts) EXPECT_LT(std::abs(to - from), pi_ / 2);
}

TEST(Cam, BreaksOfALawAreItsJumps) {
    const Cam cam =
        cam_of(file(R"({"moves": "translating", "face": "flat"})",
                    R"([{"form": "constant acceleration", "rise": 20, "turn": 120}, {"form": "rest", "turn": 40},
        {"form": "cycloidal", "rise": -20, "turn": 200}])",
                    30));
    const std::vector<LawBreak> breaks = breaks_of_cycle(cam.law);
    ASSERT_EQ(breaks.size(), 3U);
    const double turn = 2 * pi_ / 3, most = 4 * 0.02 / (turn * turn);
    const std::array<std::array<double, 3>, 3> expected{{{0, 0, most}, {60, most, -most}, {120, -most, 0}}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(breaks[i].at * 180 / pi_, expected.at(i)[0], 1e-12);
        EXPECT_NEAR(breaks[i].before.second, expected.at(i)[1], 1e-12);
        EXPECT_NEAR(breaks[i].after.second, expected.at(i)[2], 1e-12);
        EXPECT_FALSE(breaks[i].of_speed);
    }
}

TEST(Cam, ItsMechanismKeepsTheUnitsOfRates) {
    std::string text = file(kinds[0].follower, dwells("24"), 40, "\"-300 rpm\"");
    text.replace(text.find(R"("length": "mm")"), 14, R"("length": "mm", "angular velocity": "rpm")");
    const Cam cam = cam_of(text);
    const std::string written = mechanism_file_of(cam, *CamGeometry::of(cam), 1);
    EXPECT_NE(written.find(R"("angular velocity": "rpm")"), std::string::npos) << written;
    EXPECT_NE(written.find(R"("omega": -300})"), std::string::npos) << written;
    EXPECT_NEAR(tests::solved(written).bodies[1].omega->to_double(), -10 * pi_, 1e-12);
}

TEST(Cam, FaultsOfFilesAreTold) {
    const std::string roller = R"({"moves": "translating", "face": "roller", "radius": 10})";
    const std::string law = dwells("20");
    struct Case {
        std::string text;
        const char* told;
    };
    for (const Case& each :
         {Case{file(roller, R"([{"form": "rest", "turn": 350}])", 40), "its pieces make 350°"},
          Case{file(roller, R"([{"form": "harmonic", "rise": 1, "turn": 360}])", 40), "the rises add up to zero"},
          Case{file(roller,
                    R"([{"form": "harmonic", "rise": -1, "turn": 180}, {"form": "harmonic", "rise": 1, "turn": 180}])",
                    40),
               "begins at its lowest"},
          Case{file(roller, law, 40, "0"), "does not turn"}, Case{file(roller, law, -4), "greater than zero"},
          Case{file(R"({"moves": "sliding", "face": "roller", "radius": 10})", law, 40), "\"sliding\" is none of"},
          Case{file(R"({"moves": "translating", "face": "flat", "radius": 10})", law, 40),
               "only a roller has a radius"},
          Case{file(R"({"moves": "oscillating", "face": "roller", "radius": 10, "arm": 5})", law, 40),
               "\"pivot\" is missing"},
          Case{R"({"kinegraph": 1})", "\"cam\" is missing"}, Case{"[]", "is a JSON object"}}) {
        const auto cam = read_cam(each.text, "cam.json");
        ASSERT_FALSE(cam) << each.told;
        EXPECT_NE(cam.error().front().message.in(Language::en).find(each.told), std::string::npos)
            << cam.error().front().message.in(Language::en);
    }
    const Cam far = cam_of(
        file(R"({"moves": "oscillating", "face": "roller", "radius": 10, "pivot": [200, 0], "arm": 20})", law, 40));
    EXPECT_FALSE(CamGeometry::of(far));
    const Cam beside = cam_of(file(R"({"moves": "translating", "face": "knife edge", "offset": 50})", law, 40));
    EXPECT_FALSE(CamGeometry::of(beside));
}

TEST(Cam, TheExampleIsTheMechanismOfItsCam) {
    const std::string folder = tests::example_file("cams/disc_cam");
    const Cam cam = cam_of(tests::contents(folder), "disc_cam.json");
    EXPECT_EQ(mechanism_file_of(cam, *CamGeometry::of(cam), pi_ / 3),
              tests::contents(tests::example_file("cam_from_law")));
}

}  // namespace
}  // namespace kinegraph::cam_test
