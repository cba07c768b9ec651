// Positions: closed forms of limits and of places, branches kept through change points, and random mechanisms there and
// back.
#include "engine/motion/positions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "engine/motion/repositioned.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"

namespace kinegraph::positions_test {
namespace {

constexpr double pi_ = std::numbers::pi;

Mechanism read(const std::string& text) {
    auto mechanism = read_mechanism(text, "test.json");
    if (!mechanism) throw std::runtime_error(mechanism.error().front().message.in(Language::en) + "\n" + text);
    return *std::move(mechanism);
}
Mechanism example(const std::string& name) { return read(tests::contents(tests::example_file(name))); }

struct Drawn {
    Mechanism mechanism;
    Pose pose;
    Positions positions;
};
Drawn drawn(Mechanism mechanism, int driver = 0) {
    auto pose = draw_pose(mechanism);
    if (!pose) throw std::runtime_error(pose.error().front().message.in(Language::en));
    auto positions = Positions::of(mechanism, *pose, driver);
    if (!positions) throw std::runtime_error(positions.error().front().message.in(Language::en));
    return {std::move(mechanism), *std::move(pose), *std::move(positions)};
}

using Spot = VectorOf<double>;
Spot rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }

/// A four-bar by its lengths (mm), crank a at an angle in degrees; the crank drives.
std::string four_bar(double a, double b, double c, double d, double angle) {
    const auto n = [](double value) { return std::to_string(value); };
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O2": [0, 0], "A": {"from": "O2",
    "distance": )" +
           n(a) + R"(, "angle": )" + n(angle) + R"(}, "O4": [)" + n(d) +
           R"(, 0], "B": {"meet": [{"circle": "A", "radius": )" + n(b) + R"(}, {"circle": "O4", "radius": )" + n(c) +
           R"(}], "side": "left"}}, "bodies": {"2": ["O2", "A"], "3": ["A", "B"], )" +
           R"("4": ["O4", "B"]}, "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2,
           3]}, )" +
           R"({"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}], "drivers": [{"body": 2,
           "omega": 1}]})";
}

/// The crank's angle at which coupler and follower lie on one line: O4A = b + c, or |b − c|.
double limit_angle(double a, double reach, double d) {
    return std::acos((a * a + d * d - reach * reach) / (2 * a * d));
}

TEST(Positions, FourBarsOfEveryKindTurnOrStopWhereTheyMust) {
    struct Case {
        const char* kind;
        double a, b, c, d, angle;
        bool turns;
    };
    for (const Case& each :
         {Case{"crank-rocker", 40, 150, 80, 150, 60, true}, Case{"drag link", 100, 110, 120, 50, 60, true},
          Case{"double rocker", 80, 40, 120, 130, 60, false}, Case{"rocker-crank", 80, 100, 40, 110, 70, false},
          Case{"non-Grashof, all rock", 80, 90, 100, 140, 60, false},
          Case{"non-Grashof, coupler longest", 80, 180, 100, 90, 60, false}}) {
        SCOPED_TRACE(each.kind);
        Drawn d = drawn(read(four_bar(each.a, each.b, each.c, each.d, each.angle)));
        ASSERT_EQ(d.positions.move_to(2 * pi_), each.turns);
        if (each.turns) {
            EXPECT_NEAR(std::remainder(d.positions.turn(BodyIndex(3)), 2 * pi_), 0, 1e-12);
            continue;
        }
        // O4A may be b + c at most and |b − c| at least; the rocker stops at the first of these that it comes to.
        const double start = each.angle * pi_ / 180;
        for (const double way : {1.0, -1.0}) {
            ASSERT_FALSE(d.positions.move_to(way * 2 * pi_));
            const double stopped = std::abs(std::remainder(start + *d.positions.limit(), 2 * pi_));
            const double longest = limit_angle(each.a, each.b + each.c, each.d);
            const double shortest = limit_angle(each.a, std::abs(each.b - each.c), each.d);
            const double off = std::isnan(longest) ? std::abs(stopped - shortest)
                               : std::isnan(shortest)
                                   ? std::abs(stopped - longest)
                                   : std::min(std::abs(stopped - longest), std::abs(stopped - shortest));
            EXPECT_LT(off, 1e-9) << "stopped at " << stopped * 180 / pi_;
            EXPECT_EQ(d.positions.coordinate(), 0) << "nothing moved";
        }
    }
}

TEST(Positions, LimitsBesideAChangePointAreFound) {
    // Crank 3, follower 4, frame 2: with a coupler of 5 the crank passes a change point, with a longer one it stops
    // beside it on either side, where O4A is the difference of coupler and follower.
    for (const std::string longer : {"0.1", "0.001", "0.00001", "0.0000001", "0.00000001", "0.000000001",
                                     "0.0000000001", "0.00000000001", "0.000000000001", "0.0000000000001"}) {
        // 5.000…1 − 4 would lose the digits of what is longer.
        const double more = std::stod(longer);
        Mechanism mechanism = read(
            R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": {"from": "O", "distance": 3, "angle": 50},
            "Q": [2, 0], "B": {"meet": [{"circle": "A", "radius": 5)" +
            longer.substr(1) +
            R"(}, {"circle": "Q", "radius": 4}], "side": "left"}}, "bodies": {"2": ["O", "A"], "3": ["A", "B"],
            "4": ["Q", "B"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]}],
            "drivers": [{"body": 2, "omega": 1}]})");
        const double angle = 2 * std::asin(std::sqrt(more * (2 + more) / 24)), drawn_at = 50 * pi_ / 180;
        for (const double end : {-2 * pi_, 2 * pi_}) {
            Drawn there = drawn(mechanism);
            ASSERT_FALSE(there.positions.move_to(end)) << longer;
            EXPECT_NEAR(there.positions.limit().value(), (end < 0 ? angle : 2 * pi_ - angle) - drawn_at, 1e-9)
                << longer;
        }
    }
}

TEST(Positions, ADriverStopsWhereGuidesBecomeParallel) {
    // The pin of a slide along the crank, and of a slide on the frame: it goes to infinity as the crank turns there.
    Drawn d = drawn(read(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [2, 3], "C": [5, 1]},
        "bodies": {"2": ["O", "A"], "3": ["C"], "4": ["C"]}, "joints": [{"revolute": "O", "bodies": [1, 2]},
        {"prismatic": "C", "bodies": [3, 2], "along": [-3, 3], "name": "S"}, {"revolute": "C", "bodies": [3, 4]},
        {"prismatic": "C", "bodies": [4, 1], "along": [3, 1]}], "drivers": [{"body": 2, "omega": 1}]})"));
    const double back = std::atan2(1, 3) - std::atan2(3, -3);  // by which the one guide has the direction of the other
    ASSERT_FALSE(d.positions.move_to(2 * pi_));
    EXPECT_TRUE(d.positions.is_limit_far());
    EXPECT_NEAR(d.positions.limit().value(), back + pi_, 1e-9);
    ASSERT_FALSE(d.positions.move_to(-2 * pi_));
    EXPECT_TRUE(d.positions.is_limit_far());
    EXPECT_NEAR(d.positions.limit().value(), back, 1e-9);
}

TEST(Positions, AParallelogramGoesThroughItsChangePointsAndSaysSo) {
    Drawn d = drawn(example("parallel_crank"));
    const double start = std::atan2(40.0, 30.0);
    // Also exactly at the change point, and on from there.
    for (const double turn : {0.5, pi_ - start, 3.0, 2 * pi_ - start, 6.0, 12.0}) {
        ASSERT_TRUE(d.positions.move_to(turn));
        EXPECT_NEAR(d.positions.turn(BodyIndex(3)), turn, 1e-9);  // body 4, the other crank
        EXPECT_NEAR(d.positions.turn(BodyIndex(2)), 0, 1e-9);
    }
    ASSERT_GE(d.positions.change_points().size(), 2U);
    EXPECT_NEAR(d.positions.change_points()[0], pi_ - start, 1e-6);
    EXPECT_NEAR(d.positions.change_points()[1], 2 * pi_ - start, 1e-6);
    ASSERT_TRUE(d.positions.move_to(0));
    EXPECT_NEAR(d.positions.turn(BodyIndex(3)), 0, 1e-9);
}

TEST(Positions, AChangePointThatIsDrawnIsLeftAlongABranch) {
    // A folded parallelogram a, b: ω4/ω2 = 1, or −(b + a)/(b − a), the antiparallelogram.
    const Mechanism mechanism = example("change_point_parallelogram");
    const Pose pose = *draw_pose(mechanism);
    for (const double way : {1.0, -1.0}) {
        auto parallel = *Positions::of(mechanism, pose, 0);
        ASSERT_TRUE(parallel.branch());
        EXPECT_EQ(parallel.branch()->of, 2U);
        EXPECT_TRUE(parallel.is_singular());
        for (const double turn : {0.3, 2.0, 3.5, 7.0}) {
            ASSERT_TRUE(parallel.move_to(way * turn));
            EXPECT_NEAR(parallel.turn(BodyIndex(3)), way * turn, 1e-9) << "the bodies move least in the parallelogram";
        }
        EXPECT_NEAR(parallel.change_points().front(), 0, 1e-9);
        auto crossed = *Positions::of(mechanism, pose, Course{.driver = 0, .branch = 1 - parallel.branch()->index});
        ASSERT_TRUE(crossed.move_to(way * 0.02));
        // a = 40, b = 100: ω4/ω2 = −140/60 where it is folded.
        EXPECT_NEAR(crossed.turn(BodyIndex(3)) / (way * 0.02), -140.0 / 60, 0.01);
        Places places;
        ASSERT_TRUE(crossed.move_to(way * 1.2));
        crossed.read(places);
        // The antiparallelogram is symmetric: B is the mirror image of A's partner, so tan(φ2/2) tan(φ4/2) = −(b −
        // a)/(b + a).
        const double second = way * 1.2, fourth = crossed.turn(BodyIndex(3));
        EXPECT_NEAR(std::tan(fourth / 2) / std::tan(second / 2), -140.0 / 60, 1e-9);
        ASSERT_TRUE(crossed.move_to(0));
        EXPECT_NEAR(crossed.turn(BodyIndex(3)), 0, 1e-6) << "and back";
    }
    const auto third = Positions::of(mechanism, pose, Course{.driver = 0, .branch = 2});
    ASSERT_FALSE(third);
    EXPECT_EQ(third.error().front().code, ErrorCode::no_unique_answer);
    const Mechanism plain = example("four_bar");
    EXPECT_FALSE(Positions::of(plain, *draw_pose(plain), Course{.driver = 0, .branch = 0}))
        << "there is none to choose";
}

TEST(Positions, ADeadPointThatIsDrawnIsRefused) {
    const Mechanism mechanism = example("slider_driven_dead_point");
    const auto positions = Positions::of(mechanism, *draw_pose(mechanism), 0);
    ASSERT_FALSE(positions);
    EXPECT_EQ(positions.error().front().code, ErrorCode::no_unique_answer);
}

TEST(Positions, TwoDriversMoveTogether) {
    // Two links in a row: the tip is where both turns say.
    const Mechanism mechanism = example("scara");
    const Pose pose = *draw_pose(mechanism);
    auto positions = *Positions::of(mechanism, pose, Course{.driver = 0, .along = {{1, Exact::ratio(-3, 2)}}});
    const auto place = [&](const char* name) { return rough(pose.at(*mechanism.point_named(name))); };
    const auto relative = std::get<SpinDriver>(mechanism.drivers[1]).relative_to;
    for (const double turn : {0.4, 2.9, -5.0}) {
        ASSERT_TRUE(positions.move_to(turn));
        Places places;
        positions.read(places);
        const double second = relative == frame ? -1.5 * turn : turn - 1.5 * turn;
        const Spot a = faced(Spot{std::cos(turn), std::sin(turn)}, place("A") - place("O"));
        const Spot b = faced(Spot{std::cos(second), std::sin(second)}, place("B") - place("A"));
        const Spot tip = places.points[at_index(*mechanism.point_named("B"))] - place("O");
        EXPECT_NEAR(tip.x, a.x + b.x, 1e-12);
        EXPECT_NEAR(tip.y, a.y + b.y, 1e-12);
    }
}

TEST(Positions, GearsKeepTheirRatioOverManyTurns) {
    Drawn d = drawn(example("planetary_train"));
    const double turn = 40 * pi_ + 1;
    ASSERT_TRUE(d.positions.move_to(turn));
    // Willis: sun 30, ring 70 at rest: arm/sun = 30/100; the planet turns by −(70 − 20)/20 of the arm.
    EXPECT_NEAR(d.positions.turn(BodyIndex(3)), 0.3 * turn, 1e-9);
    EXPECT_NEAR(d.positions.turn(BodyIndex(2)), -2.5 * 0.3 * turn, 1e-9);
}

TEST(Positions, AWheelRollsAsFarAsItTurns) {
    Drawn d = drawn(example("disc_on_line"));
    Places before, after;
    d.positions.read(before);
    ASSERT_TRUE(d.positions.move_to(7));
    d.positions.read(after);
    const auto& joint = d.mechanism.joints.front();
    const double way = after.points[at_index(joint.point)].x - before.points[at_index(joint.point)].x;
    const auto& pose = d.pose;
    for (const auto& [body, profile] : joint.profiles) {
        const auto* circle = std::get_if<CircleProfile>(&profile);
        if (circle == nullptr) continue;
        const double radius = length(pose.at(circle->centre) - pose.at(joint.point));
        EXPECT_NEAR(std::abs(way), 7 * radius, 1e-12);
    }
}

TEST(Positions, TheGenevaWheelFollowsItsPin) {
    Drawn d = drawn(example("geneva_wheel"));
    const double r = 50, e = 70.710678118654752, start = 20 * pi_ / 180;
    const auto wheel = [&](double angle) { return std::atan2(r * std::sin(angle), r * std::cos(angle) - e); };
    for (int degrees = -45; degrees <= 45; ++degrees) {
        const double angle = degrees * pi_ / 180;
        ASSERT_TRUE(d.positions.move_to(angle - start));
        EXPECT_NEAR(std::remainder(d.positions.turn(BodyIndex(2)) - (wheel(angle) - wheel(start)), 2 * pi_), 0, 1e-12);
    }
}

/// All places of all points, and of what the joints show.
double apart(const Places& a, const Places& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i)
        most = std::max(most, std::hypot(a.points[i].x - b.points[i].x, a.points[i].y - b.points[i].y));
    return most;
}

TEST(Positions, RandomMechanismsGoThereAndBack) {
    const int count = unless_sanitized(500, 60);
    int moved = 0, drawn_so = 0;
    for (std::uint64_t seed = 0; moved < count && seed < 700; ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        const Mechanism mechanism = read(random.text);
        const Pose pose = *draw_pose(mechanism);
        ++drawn_so;
        auto positions = Positions::of(mechanism, pose, 0);
        if (!positions) continue;
        Places start, there, again;
        positions->read(start);
        const bool turns = std::holds_alternative<SpinDriver>(mechanism.drivers[0]);
        const double size = pose.size.to_double();
        double goal = (seed % 2 == 0 ? 1 : -1) * (turns ? 1.0 : size / 2);
        if (!positions->move_to(goal)) {
            ASSERT_TRUE(positions->limit());
            ASSERT_LE(std::abs(*positions->limit()), std::abs(goal) * (1 + 1e-9));
            goal = *positions->limit() * 0.9;
            ASSERT_TRUE(positions->move_to(goal)) << "to " << goal << " before the limit " << *positions->limit();
        }
        positions->read(there);
        ASSERT_TRUE(positions->move_to(0));
        positions->read(again);
        EXPECT_LT(apart(start, again), 1e-9 * size);
        ASSERT_TRUE(positions->move_to(goal));
        positions->read(again);
        EXPECT_LT(apart(there, again), 1e-9 * size);
        ++moved;
        if (HasFailure()) break;
    }
    EXPECT_GE(moved, std::min(count, drawn_so * 9 / 10)) << "too many could not be moved at all";
}

TEST(Positions, AMovedMechanismIsClosedToItsLastBit) {
    int compared = 0;
    for (const char* name :
         {"four_bar", "quick_return", "planetary_train", "disc_on_line", "cam_roller_follower", "jansen_leg"}) {
        SCOPED_TRACE(name);
        Drawn d = drawn(example(name));
        const Exact coordinate = Exact::ratio(1, 3);
        ASSERT_TRUE(d.positions.move_to(coordinate.to_double()));
        const Repositioned moved = *Mover(d.mechanism, d.pose).moved(d.positions, coordinate);
        for (const auto& [pose, drawn_pose, bits] :
             {std::tuple(moved.pose, d.pose, 100), std::tuple(moved.finer, *draw_pose(d.mechanism, 200), 200)}) {
            // Two points that one body carries keep their distance.
            const Exact most = square(d.pose.size) * Exact::power_of_two(-bits + 8);
            for (const Body& body : d.mechanism.bodies)
                for (std::size_t k = 1; k < body.points.size(); ++k) {
                    const auto carriers = *carriers_of(d.mechanism);
                    const auto own = [&](PointIndex p) {
                        for (const Joint& joint : d.mechanism.joints)
                            if (joint.point == p && !joint.pair().has_common_point()) return false;
                        return true;
                    };
                    if (!own(body.points[0]) || !own(body.points[k])) continue;
                    const auto squared = [&](const Pose& of) {
                        return squared_length(of.at(body.points[0]) - of.at(body.points[k]));
                    };
                    EXPECT_LT(abs(squared(pose) - squared(drawn_pose)), most) << bits << " bits, body " << body.name;
                    ++compared;
                }
        }
    }
    EXPECT_GT(compared, 6);
}

/// Whether two points that one body carries keep their distance from pose to pose, within 2^-bits of the size.
bool is_rigid(const Mechanism& mechanism, const Pose& before, const Pose& after, int bits) {
    for (const Body& body : mechanism.bodies)
        for (std::size_t k = 1; k < body.points.size(); ++k) {
            const auto squared = [&](const Pose& of) {
                return squared_length(of.at(body.points[0]) - of.at(body.points[k]));
            };
            if (abs(squared(after) - squared(before)) > square(before.size) * Exact::power_of_two(8 - bits))
                return false;
        }
    return true;
}

// Sizes so far apart that doubles close a position badly or not at all: it is refined to its last bit or not at all,
// and no number in between ends the program.
TEST(Positions, OfSizesFarApartAreRefinedToTheLastBitOrNotAtAll) {
    int refined = 0, refused = 0;
    for (const auto& [name, place] : {std::pair("cam_roller_follower", "/points/O/1"),
                                      {"cam_knife_edge", "/points/O/1"},
                                      {"cam_flat_follower", "/points/O/1"},
                                      {"planetary_train", "/points/O/0"},
                                      {"rack_and_pinion", "/points/G/0"},
                                      {"four_bar", "/points/O4/0"}})
        for (const double value : {1e3, 1e6, 1e9, 1e12, -1e20, 1e30, 1e61}) {
            SCOPED_TRACE(std::string(name) + " " + place + " " + std::to_string(value));
            nlohmann::json file = nlohmann::json::parse(tests::contents(tests::example_file(name)));
            file[nlohmann::json::json_pointer(place)] = value;
            const Mechanism mechanism = read(file.dump());
            const auto pose = draw_pose(mechanism);
            if (!pose) continue;
            auto positions = Positions::of(mechanism, *pose, 0);
            if (!positions) continue;
            for (const double coordinate : {0.0, 1e-3, -0.3, 2.0}) {
                if (!positions->move_to(coordinate) || positions->is_singular()) continue;
                const auto moved = Mover(mechanism, *pose).moved(*positions, Exact::from_double(coordinate));
                ++(moved ? refined : refused);
                EXPECT_TRUE(!moved || is_rigid(mechanism, *pose, moved->pose, 100)) << coordinate;
            }
        }
    EXPECT_GT(refined, 10);
    EXPECT_GT(refused, 3);
}

TEST(Positions, PassesAreCountedAndAreAsManyFarFromTheOrigin) {
    const auto bits_of_one = [](const std::string& origin) {
        std::string text = tests::contents(tests::example_file("slider_crank_long_crank"));
        text.replace(text.find("[0, 0]"), 6, "[" + origin + ", 0]");
        const Mechanism mechanism = *read_mechanism(text, "test.json");
        const Pose pose = *draw_pose(mechanism);
        Positions positions = *Positions::of(mechanism, pose, 0);
        EXPECT_EQ(positions.refined_bits(), 0u);
        EXPECT_TRUE(positions.move_to(0.1));
        const Closure closure = *closure_of(mechanism, pose);
        EXPECT_TRUE(positions.refined(closure, Exact::from_double(positions.coordinate())));
        const std::size_t once = positions.refined_bits();
        EXPECT_TRUE(positions.refined(closure, Exact::from_double(positions.coordinate())));
        EXPECT_EQ(positions.refined_bits(), 2 * once);
        return once;
    };
    const std::size_t near = bits_of_one("0");
    EXPECT_GT(near, 100u);
    EXPECT_LT(bits_of_one("1e61"), 2 * near);
}

}  // namespace
}  // namespace kinegraph::positions_test
