// Cycles: rows against closed forms over whole turns, against mechanisms drawn where they are moved to, and laws of the
// whole.
#include "constructions/positions/cycle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "engine/motion/repositioned.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::cycle_test {
namespace {

constexpr double pi_ = std::numbers::pi;

struct Swept {
    std::unique_ptr<Mechanism> mechanism;
    std::unique_ptr<Pose> pose;
    std::optional<Cycle> cycle;
    Travel travel;

    std::map<std::string, double> at(double coordinate) {
        std::map<std::string, double> named;
        const auto row = cycle->row(coordinate);
        if (!row) return named;
        for (std::size_t i = 0; i < row->size(); ++i) named[cycle->columns()[i].name] = (*row)[i];
        return named;
    }
};
Swept swept(const std::string& text) {
    Swept made;
    made.mechanism = std::make_unique<Mechanism>(*read_mechanism(text, "test.json"));
    made.pose = std::make_unique<Pose>(*draw_pose(*made.mechanism));
    auto cycle = Cycle::of(*made.mechanism, *made.pose, 0);
    if (!cycle) throw std::runtime_error(cycle.error().front().message.in(Language::en));
    made.cycle.emplace(*std::move(cycle));
    const bool turns = std::holds_alternative<SpinDriver>(made.mechanism->drivers[0]);
    made.travel = *travel_of(made.cycle->positions(), turns, {}, {});
    EXPECT_TRUE(made.cycle->begin(made.travel).empty());
    return made;
}
Swept swept_example(const std::string& name) { return swept(tests::contents(tests::example_file(name))); }

TEST(Cycle, PlacesAreKnownAtLimitsToo) {
    // The rod of 150 mm lies along A's guide there, B at the crossing of the guides: drawn 90 mm above it.
    Swept s = swept_example("elliptic_trammel");
    ASSERT_TRUE(s.travel.starts_at_limit && s.travel.ends_at_limit);
    const double way = s.travel.to - s.travel.from;
    for (const auto& [limit, inward] : {std::pair(s.travel.from, way), std::pair(s.travel.to, -way)}) {
        EXPECT_FALSE(s.cycle->row(limit));
        const auto places = s.cycle->at_limit(limit, inward);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::string& name = s.cycle->columns()[i].name;
            if (name == "s B") {
                EXPECT_NEAR(places[i].value(), -0.09, 1e-7);
            }
            if (name == "s A") {
                EXPECT_NEAR(places[i].value(), limit, 1e-7);
            }
            if (name == "v B") {
                EXPECT_FALSE(places[i]);
            }
        }
    }
}

// A driver stops where a coupler lies along the link that it drives, so that it cannot turn it.
TEST(Cycle, TheTransmissionAngleVanishesWhereTheDriverStops) {
    for (const char* const name : {"sluice_gate_travel", "stephenson_3_driver_2", "slider_crank_long_crank"}) {
        const Swept s = swept_example(name);
        ASSERT_TRUE(s.travel.starts_at_limit && s.travel.ends_at_limit) << name;
        const auto found = transmission_of(*s.mechanism, s.cycle->positions(), 0, s.travel);
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(found->least, 0, 1e-5) << name;
        EXPECT_TRUE(found->at == s.travel.from || found->at == s.travel.to) << name << ": " << found->at;
    }
}

TEST(Cycle, LookingAtALimitMovesNothing) {
    Swept s = swept_example("sluice_gate_travel");
    const double way = s.travel.to - s.travel.from;
    const double here = s.cycle->positions().coordinate();
    s.cycle->at_limit(s.travel.from, way);
    s.cycle->at_limit(s.travel.to, -way);
    EXPECT_EQ(s.cycle->positions().coordinate(), here);
    for (int i = 1; i < 24; ++i) EXPECT_FALSE(s.at(s.travel.from + way * i / 24).empty()) << i;
}

TEST(Cycle, ASliderCrankFollowsItsClosedForm) {
    const double r = 0.04, l = 0.15, omega = 10;
    Swept s = swept(R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O": [0, 0],
        "A": {"from": "O", "distance": 40, "angle": 0}, "B": {"meet": [{"circle": "A", "radius": 150}, {"line": "O",
        "angle": 0}],
        "side": "right"}}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]}, "joints": [{"revolute": "O",
        "bodies": [1, 2]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4,
        1], "along": 0}],
        "drivers": [{"body": 2, "omega": 10}]})");
    for (int degrees = 0; degrees <= 360; ++degrees) {
        const double a = degrees * pi_ / 180;
        auto row = s.at(a);
        ASSERT_FALSE(row.empty()) << degrees;
        // c(α), its derivatives by α: Λ and Λ′.
        const double root = std::sqrt(l * l - r * r * std::sin(a) * std::sin(a));
        const double c = r * std::cos(a) + root;
        const double first = -r * std::sin(a) - r * r * std::sin(a) * std::cos(a) / root;
        const double second = -r * std::cos(a) - r * r * std::cos(2 * a) / root -
                              std::pow(r, 4) * std::pow(std::sin(a) * std::cos(a), 2) / std::pow(root, 3);
        EXPECT_NEAR(row["x B"], c, 1e-9 * l);
        EXPECT_NEAR(row["s B"], c - (r + l), 1e-9 * l);
        EXPECT_NEAR(row["vx B"], omega * first, 1e-9 * omega * r);
        EXPECT_NEAR(row["v B"], omega * first, 1e-9 * omega * r);
        EXPECT_NEAR(row["ax B"], omega * omega * second, 1e-9 * omega * omega * r);
        EXPECT_NEAR(row["omega 3"], -omega * r * std::cos(a) / root, 1e-9 * omega);
        EXPECT_NEAR(row["time"], a / omega, 1e-12);
        EXPECT_NEAR(row["angle 2"], a, 1e-12) << "goes on past a full turn";
    }
    EXPECT_LT(s.cycle->difference().share, 1e-9);
}

/// Where a column passes zero, by halving.
double zero_of(Swept& s, const std::string& column, double from, double to) {
    const bool rises = s.at(from)[column] < 0;
    for (int i = 0; i < 50; ++i) {
        const double middle = (from + to) / 2;
        ((s.at(middle)[column] < 0) == rises ? from : to) = middle;
    }
    return from;
}

TEST(Cycle, QuickReturnsHaveTheirTimeRatio) {
    // The lever turns round where it touches the crank's circle: sin φ = O2A/O2O4.
    Swept s = swept_example("quick_return");
    const double phi = std::asin(60.0 / 150);
    // O2A stands at 30°; the crank is square to the lever where it points ∓φ beyond the horizontal.
    const double drawn = pi_ / 6;
    const double one = zero_of(s, "omega 4", -phi - drawn - 0.3, -phi - drawn + 0.3);
    const double other = zero_of(s, "omega 4", pi_ + phi - drawn - 0.3, pi_ + phi - drawn + 0.3);
    const double slow = other - one;
    EXPECT_NEAR(slow / (2 * pi_ - slow), (pi_ + 2 * phi) / (pi_ - 2 * phi), 1e-9);
    // Whitworth: the lever makes whole turns; half of one where the crank turns by π − 2 asin(e/r).
    Swept w = swept_example("whitworth");
    const double e = 40, r = 100, start = std::atan2(r * std::sin(pi_ / 4) + e, r * std::cos(pi_ / 4));
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double a = pi_ / 4 + degrees * pi_ / 180;
        const double lever = std::atan2(r * std::sin(a) + e, r * std::cos(a));
        EXPECT_NEAR(std::remainder(w.at(degrees * pi_ / 180)["angle 4"] - lever, 2 * pi_), 0, 1e-9) << start;
    }
}

TEST(Cycle, ARowIsWhatAFileDrawnThereGives) {
    const std::string text = tests::contents(tests::example_file("four_bar_inertia"));
    Swept s = swept(text);
    for (const int degrees : {-170, -33, 30, 95, 180}) {
        std::string there = text;
        const std::size_t at = there.find("\"angle\": 60");
        ASSERT_NE(at, std::string::npos);
        there.replace(at, 11, "\"angle\": " + std::to_string(60 + degrees));
        const Solution solution = tests::solved(there);
        auto row = s.at(degrees * pi_ / 180);
        ASSERT_FALSE(row.empty());
        for (std::size_t body = 1; body < solution.bodies.size(); ++body) {
            const std::string& name = solution.mechanism.bodies[body].name;
            EXPECT_NEAR(row["omega " + name], solution.bodies[body].omega->to_double(), 1e-10 * 10);
            EXPECT_NEAR(row["alpha " + name], solution.bodies[body].alpha->to_double(), 1e-10 * 100);
        }
        EXPECT_NEAR(row["effort M"], solution.efforts[0].value->to_double(), 1e-10);
        // And exactly, in that position.
        Positions positions = s.cycle->positions();
        const Exact coordinate = Exact(degrees) * pi() / 180;
        ASSERT_TRUE(positions.move_to(coordinate.to_double()));
        Repositioned moved = *Mover(*s.mechanism, *s.pose).moved(positions, coordinate);
        const Solution exact = solve(std::move(moved.mechanism), std::move(moved.pose),
                                     [finer = std::move(moved.finer)] { return finer; });
        EXPECT_TRUE(exact.unsolved.empty());
        EXPECT_NEAR(exact.efforts[0].value->to_double(), solution.efforts[0].value->to_double(), 1e-15);
    }
}

TEST(Cycle, TheWorkOfAConservativeCycleIsNothing) {
    Swept s = swept_example("four_bar_inertia");
    const int steps = 360;
    double work = 0, most = 0;
    for (int i = 0; i < steps; ++i) {
        const double moment = s.at(2 * pi_ * i / steps)["effort M"];
        work += moment * 2 * pi_ / steps;
        most = std::max(most, std::abs(moment));
    }
    // A smooth function of a whole turn: equal steps add up to its integral.
    EXPECT_GT(most, 0.1);
    EXPECT_LT(std::abs(work), 1e-10 * most);
}

TEST(Cycle, TheGenevaWheelFollowsItsClosedFormWhileThePinIsInTheSlot) {
    // ω₃/ω₂ = r (r − d cos θ)/(r² + d² − 2 r d cos θ) with θ the crank's angle from the line of centres, from −45° to
    // 45°.
    Swept s = swept_example("geneva_wheel");
    const double r = 0.05, d = r * std::sqrt(2.0), drawn = 20 * pi_ / 180, omega = s.at(0)["omega 2"];
    for (int degrees = -45; degrees <= 45; degrees += 3) {
        const double a = degrees * pi_ / 180, apart = r * r + d * d - 2 * r * d * std::cos(a);
        auto row = s.at(a - drawn);
        ASSERT_FALSE(row.empty()) << degrees;
        EXPECT_NEAR(row["omega 3"], omega * r * (r - d * std::cos(a)) / apart, 1e-9 * std::abs(omega)) << degrees;
        EXPECT_NEAR(row["alpha 3"], omega * omega * r * d * (d * d - r * r) * std::sin(a) / (apart * apart),
                    1e-8 * omega * omega)
            << degrees;
    }
}

TEST(Cycle, APlanetaryTrainKeepsItsRatioOverManyTurns) {
    Swept s = swept_example("planetary_train");
    const double omega = s.at(0)["omega 2"];
    for (const double turns : {0.3, 7.1, 40.6}) {
        auto row = s.at(2 * pi_ * turns);
        ASSERT_FALSE(row.empty());
        EXPECT_NEAR(row["omega 4"], 0.3 * omega, 1e-9 * std::abs(omega));
        EXPECT_NEAR(row["angle 4"] - s.at(0)["angle 4"], 0.3 * 2 * pi_ * turns, 1e-9);
    }
}

TEST(Cycle, TheSluiceGatesActuatorDoesTheWorkOfItsWeight) {
    Swept s = swept_example("sluice_gate_travel");
    const double weight = 1.66e6 * 9.81;
    ASSERT_TRUE(s.travel.starts_at_limit && s.travel.ends_at_limit);
    // At every position F ds = m g dy, the height by differences of places alone; and as drawn the notes' 17.7 mm at 14
    // mm ≙ m g.
    EXPECT_NEAR(s.at(0)["effort F_G"], -weight * 17.746 / 14, 1e-4 * weight);
    for (double share = 0.02; share < 0.99; share += 0.04) {
        const double at = s.travel.from + share * (s.travel.to - s.travel.from), h = 1e-3;
        const double rise = (s.at(at + h)["y O"] - s.at(at - h)["y O"]) / (2 * h);
        EXPECT_NEAR(s.at(at)["effort F_G"] / weight, rise, 1e-5 * std::max(1.0, std::abs(rise))) << at;
    }
}

TEST(Cycle, JansensFootWalksOnALevelPath) {
    // Jansen's eleven numbers: the foot's stride is level to a fraction of its height of step while it bears.
    Swept s = swept_example("jansen_leg");
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9;
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < 360; ++i) {
        auto row = s.at(2 * pi_ * i / 360);
        places.push_back({row["x F"], row["y F"]});
        low = std::min(low, row["y F"]), high = std::max(high, row["y F"]);
        left = std::min(left, row["x F"]), right = std::max(right, row["x F"]);
    }
    const double lift = high - low, stride = right - left;
    int bearing = 0;
    double first = 1e9, last = -1e9;
    for (const auto& [x, y] : places) {
        if (y - low > 0.06 * lift) continue;
        ++bearing;
        first = std::min(first, x), last = std::max(last, x);
    }
    EXPECT_GT(last - first, 0.75 * stride) << "on the ground over three quarters of the stride";
    EXPECT_GT(bearing, 120) << "for more than a third of the turn";
}

TEST(Cycle, EveryExampleThatIsDrivenIsSweptAndAgreesWithTheCheck) {
    std::size_t swept = 0;
    for (const std::string& name : tests::example_names()) {
        SCOPED_TRACE(name);
        const auto mechanism = read_mechanism(tests::contents(tests::example_file(name)), name);
        if (mechanism->drivers.empty()) continue;
        const Pose pose = *draw_pose(*mechanism);
        auto cycle = Cycle::of(*mechanism, pose, 0);
        if (!cycle) {
            EXPECT_EQ(cycle.error().front().code, ErrorCode::no_unique_answer)
                << cycle.error().front().message.in(Language::en);
            continue;
        }
        const bool turns = std::holds_alternative<SpinDriver>(mechanism->drivers[0]);
        auto travel = travel_of(cycle->positions(), turns, {}, {});
        if (!travel) travel = Travel{0, cycle->positions().size() / 4, false, false, {}};
        cycle->begin(*travel);
        int rows = 0;
        const int steps = 60;
        for (int i = 1; i < steps; ++i) {
            const auto row = cycle->row(travel->from + i * (travel->to - travel->from) / steps);
            if (!row) continue;
            ++rows;
            for (const double value : *row) ASSERT_TRUE(std::isfinite(value));
        }
        ++swept;
        EXPECT_GE(rows, steps - 4);
        EXPECT_LT(cycle->difference().share, 1e-7)
            << cycle->columns()[at_index(std::max(cycle->difference().column, 0))].name << " at "
            << cycle->difference().coordinate;
    }
    EXPECT_GT(swept, tests::example_names().size() / 4);
}

/// The file with another origin.
Mechanism shifted(Mechanism mechanism, const Vector& by) {
    const auto shift = [&](Place& place) {
        if (auto* given = std::get_if<Vector>(&place)) *given = *given + by;
    };
    for (NamedPoint& point : mechanism.points) {
        if (auto* given = std::get_if<Coordinates>(&point.placement)) given->at = given->at + by;
        auto* meet = std::get_if<Meet>(&point.placement);
        if (meet == nullptr) continue;
        if (meet->near) meet->near = *meet->near + by;
        for (Curve* curve : {&meet->first, &meet->second})
            if (auto* circle = std::get_if<CircleCurve>(curve))
                shift(circle->centre);
            else
                shift(std::get<LineCurve>(*curve).through);
    }
    return mechanism;
}

// Doubles would have lost all digits of a length there.
TEST(Cycle, IsTheSameFarFromTheOrigin) {
    const Vector far{Exact(1'000'000'000), Exact(-300'000'000)};  // m
    const double coarse = 1e-6;                                   // of places so far, in doubles
    std::size_t compared = 0;
    for (const std::string& name : tests::example_names()) {
        SCOPED_TRACE(name);
        const auto mechanism = read_mechanism(tests::contents(tests::example_file(name)), name);
        if (mechanism->drivers.empty()) continue;
        const Mechanism moved = shifted(*mechanism, far);
        const Pose pose = *draw_pose(*mechanism);
        const auto moved_pose = draw_pose(moved);
        ASSERT_TRUE(moved_pose) << moved_pose.error().front().message.in(Language::en);
        auto cycle = Cycle::of(*mechanism, pose, 0), away = Cycle::of(moved, *moved_pose, 0);
        ASSERT_EQ(cycle.has_value(), away.has_value());
        if (!cycle) continue;
        const bool turns = std::holds_alternative<SpinDriver>(mechanism->drivers[0]);
        const auto travel = travel_of(cycle->positions(), turns, {}, {});
        const auto same_travel = travel_of(away->positions(), turns, {}, {});
        ASSERT_EQ(travel.has_value(), same_travel.has_value());
        if (!travel) continue;
        const double size = cycle->positions().size(), unit = turns ? 1 : size;
        constexpr double known = 1e-6;  // beside a change point; else to 1e-9
        EXPECT_NEAR(travel->from, same_travel->from, known * unit);
        EXPECT_NEAR(travel->to, same_travel->to, known * unit);
        cycle->begin(*travel);
        away->begin(*travel);
        ASSERT_EQ(cycle->columns().size(), away->columns().size());
        for (const double share : {0.31, 0.77}) {
            const auto row = cycle->row(travel->at(share)), there = away->row(travel->at(share));
            ASSERT_EQ(row.has_value(), there.has_value());
            if (!row) continue;
            double largest = 0;
            for (const double value : *row) largest = std::max(largest, std::abs(value));
            for (std::size_t i = 0; i < row->size(); ++i) {
                const Column& column = cycle->columns()[i];
                const bool is_x = column.kind == Column::Kind::place_x, is_y = column.kind == Column::Kind::place_y;
                const double shift = is_x ? far.x.to_double() : is_y ? far.y.to_double() : 0;
                EXPECT_NEAR((*row)[i] + shift, (*there)[i], is_x || is_y ? coarse : 1e-9 * largest) << column.name;
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, tests::example_names().size() / 4);
}

}  // namespace
}  // namespace kinegraph::cycle_test
