// The instantaneous motion of one body: whatever is given of a rigid motion, in vectors or in directions, gives it back
// exactly; what no rigid body has is refused with the projections that show it; what the data leave open is said. And
// its figure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "constructions/solving/solve.hpp"
#include "engine/results/quantity_name.hpp"
#include "lang/keys/sentences.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::instantaneous_motion_test {
namespace {

using Value = std::variant<Vector, Bearing>;
using Values = std::vector<std::pair<std::string, Value>>;

Value along(const Vector& direction) { return Bearing{direction}; }

/// A body "2" with its points, and what is given of them.
struct Data {
    std::vector<std::pair<std::string, Vector>> points;
    Values velocities, accelerations;
};

Mechanism mechanism_of(const Data& data) {
    Mechanism mechanism;
    mechanism.bodies.push_back({"1", {}, {}, {}, "/bodies/1"});
    mechanism.bodies.push_back({"2", {}, {}, {}, "/bodies/2"});
    const auto index = [&](const std::string& name) { return mechanism.point_named(name).value(); };
    for (const auto& [name, place] : data.points) {
        mechanism.bodies[1].points.push_back(PointIndex(mechanism.points.size()));
        mechanism.points.push_back({name, Coordinates{place}, "/points/" + name});
    }
    InstantaneousMotion act;
    act.body = BodyIndex(1);
    for (const auto& [name, value] : data.velocities) act.velocities.push_back({index(name), value});
    for (const auto& [name, value] : data.accelerations) act.accelerations.push_back({index(name), value});
    mechanism.motion = std::move(act);
    return mechanism;
}

Solution solved(const Mechanism& mechanism) {
    auto solution = solve(mechanism);
    if (!solution) {
        ADD_FAILURE() << solution.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(solution);
}
Solution solved(const Data& data) { return solved(mechanism_of(data)); }

const InstantCentre& centre_of(const Solution& solution) { return solution.centres.at(0); }
Recorded<Vector> velocity(const Solution& solution, std::size_t point) { return solution.points.at(point).velocity; }
Recorded<Vector> acceleration(const Solution& solution, std::size_t point) {
    return solution.points.at(point).acceleration;
}
bool says(const Solution& solution, const std::string& what) {
    return std::any_of(solution.unsolved.begin(), solution.unsolved.end(), [&](const Unsolved& unsolved) {
        return english(unsolved.what) == what && english(unsolved.why).size() > 10;
    });
}
bool has_sentence(const Solution& solution, Key sentence) {
    return std::any_of(solution.protocol.statements.begin(), solution.protocol.statements.end(),
                       [&](const Statement& statement) { return statement.message.sentence == sentence; });
}

/// A rigid motion at this instant: of the place `origin` v and a, and the spins.
struct Rigid {
    Vector origin, v, a;
    Exact omega, alpha;
    Vector velocity(const Vector& place) const { return v + omega * quarter_turn(place - origin); }
    Vector acceleration(const Vector& place) const {
        return a + alpha * quarter_turn(place - origin) - omega * omega * (place - origin);
    }
};

/// Small integers, so that coincidences do happen.
class Chance {
public:
    explicit Chance(std::uint32_t seed) : engine_(seed) {}
    int in(int low, int high) { return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1)); }
    Vector vector(int reach) {
        const int x = in(-reach, reach), y = in(-reach, reach);
        return {x, y};
    }

private:
    std::mt19937 engine_;
};

/// Of a motion what is given at its points: vectors, or directions only where the vector is not zero.
Values given_of(Chance& chance, const std::vector<std::pair<std::string, Vector>>& points,
                const std::function<Vector(const Vector&)>& value) {
    Values values;
    for (const auto& [name, place] : points) {
        const Vector vector = value(place);
        switch (chance.in(0, 3)) {
            case 0: break;
            case 1: values.emplace_back(name, vector); break;
            default:
                if (!vector.is_zero()) values.emplace_back(name, along(Exact(chance.in(0, 1) == 0 ? 2 : -3) * vector));
        }
    }
    return values;
}

/// Rank of what is given, as linear conditions on (v_O, spin): vectors give two, directions one.
int rank_of(const Values& values, const std::vector<std::pair<std::string, Vector>>& points) {
    std::vector<std::array<Exact, 3>> rows;
    for (const auto& [name, value] : values) {
        const auto at =
            std::find_if(points.begin(), points.end(), [&name = name](const auto& p) { return p.first == name; });
        const auto row = [&](const Vector& n) { rows.push_back({n.x, n.y, dot(n, quarter_turn(at->second))}); };
        if (std::holds_alternative<Vector>(value)) {
            row({1, 0});
            row({0, 1});
        } else {
            row(quarter_turn(std::get<Vector>(std::get<Bearing>(value).form)));
        }
    }
    int rank = 0;
    for (std::size_t column = 0; column < 3; ++column) {
        const auto from = rows.begin() + rank;
        const auto pivot = std::find_if(from, rows.end(), [&](const auto& row) { return !row[column].is_zero(); });
        if (pivot == rows.end()) continue;
        std::iter_swap(from, pivot);
        for (auto other = from + 1; other != rows.end(); ++other) {
            const Exact factor = (*other)[column] / (*from)[column];
            for (std::size_t k = 0; k < 3; ++k) (*other)[k] -= factor * (*from)[k];
        }
        ++rank;
    }
    return rank;
}

TEST(InstantaneousMotion, WhatIsGivenOfARigidMotionGivesItBackExactly) {
    Chance chance(20260101);
    int whole = 0, with_accelerations = 0;
    for (int round = 0; round < 600; ++round) {
        const Rigid motion{chance.vector(3), chance.vector(4), chance.vector(4), chance.in(-3, 3), chance.in(-2, 2)};
        Data data;
        for (const char* name : {"A", "B", "D", "E"}) data.points.emplace_back(name, chance.vector(4));
        data.velocities = given_of(chance, data.points, [&](const Vector& place) { return motion.velocity(place); });
        data.accelerations =
            given_of(chance, data.points, [&](const Vector& place) { return motion.acceleration(place); });
        const Solution solution = solved(data);
        SCOPED_TRACE("round " + std::to_string(round));
        for (const Unsolved& unsolved : solution.unsolved)
            EXPECT_EQ(english(unsolved.why).find("no rigid motion"), std::string::npos) << english_of(unsolved);
        EXPECT_NE(solution.instantaneous_motion->found, InstantaneousMotionFigure::Found::contradiction);
        // Directions alone have no size; a vector that vanishes everywhere is then as good as any.
        const bool sized = std::any_of(data.velocities.begin(), data.velocities.end(),
                                       [](const auto& each) { return std::holds_alternative<Vector>(each.second); });
        const bool known = rank_of(data.velocities, data.points) == 3;
        ASSERT_EQ(says(solution, "velocity of body 2"), !known);
        if (!known) continue;
        ++whole;
        EXPECT_EQ(solution.bodies[1].omega, motion.omega);
        for (std::size_t p = 0; p < data.points.size(); ++p)
            EXPECT_EQ(velocity(solution, p), motion.velocity(data.points[p].second)) << data.points[p].first << sized;
        const InstantCentre& centre = centre_of(solution);
        if (!motion.omega.is_zero()) {
            ASSERT_TRUE(centre.at && !centre.at->at_infinity());
            EXPECT_EQ(motion.velocity(centre.at->place()), (Vector{}));
        } else if (motion.v.is_zero()) {
            EXPECT_TRUE(centre.everywhere);
        } else {
            ASSERT_TRUE(centre.at && centre.at->at_infinity());
            EXPECT_EQ(dot(centre.at->place(), motion.v), Exact(0));
        }
        if (data.accelerations.empty()) continue;
        ASSERT_EQ(says(solution, "acceleration of body 2"), rank_of(data.accelerations, data.points) < 3);
        if (says(solution, "acceleration of body 2")) continue;
        ++with_accelerations;
        EXPECT_EQ(solution.bodies[1].alpha, motion.alpha);
        for (std::size_t p = 0; p < data.points.size(); ++p)
            EXPECT_EQ(acceleration(solution, p), motion.acceleration(data.points[p].second)) << data.points[p].first;
        if (const auto& pole = solution.instantaneous_motion->acceleration_centre) {
            EXPECT_EQ(motion.acceleration(*pole), (Vector{}));
        }
    }
    EXPECT_GT(whole, 200);
    EXPECT_GT(with_accelerations, 60);
}

bool is_of_acceleration(const Quantity& quantity) {
    return quantity.kind == Quantity::Kind::acceleration || quantity.kind == Quantity::Kind::alpha;
}

TEST(InstantaneousMotion, AgreesWithTheCheck) {
    Chance chance(7);
    int rows = 0;
    for (int round = 0; round < 200; ++round) {
        const Rigid motion{chance.vector(9), chance.vector(9), chance.vector(9), chance.in(-9, 9), chance.in(-9, 9)};
        Data data;
        for (const char* name : {"A", "B", "D", "E"}) data.points.emplace_back(name, chance.vector(20));
        data.velocities = given_of(chance, data.points, [&](const Vector& place) { return motion.velocity(place); });
        data.accelerations =
            given_of(chance, data.points, [&](const Vector& place) { return motion.acceleration(place); });
        const Solution solution = solved(data);
        for (const CheckRow& row : solution.checks) {
            ++rows;
            // 9 rad/s on 30 m, and 81 rad/s² on it.
            EXPECT_LE(std::abs(row.difference),
                      1e-9 * (is_of_acceleration(row.quantity) ? 3000 : 300) + 1e-9 * std::abs(row.numeric))
                << round << ": " << name_of(row.quantity, solution);
        }
    }
    EXPECT_GT(rows, 1000);
}

/// A change of drawing that is exact, on places and on free vectors.
struct Change {
    std::function<Vector(const Vector&)> vector;
    Vector shift;
    int sense;  ///< −1: mirrored
    Vector place(const Vector& at) const { return vector(at) + shift; }
};

TEST(InstantaneousMotion, TurnedMirroredAndMovedItGivesTheSameTransformed) {
    const Exact c = Exact::ratio(3, 5), s = Exact::ratio(4, 5);
    const Change changes[] = {
        {[=](const Vector& v) {
             return Vector{c * v.x - s * v.y, s * v.x + c * v.y};
         },
         {7, -2},
         1},
        {[](const Vector& v) {
             return Vector{-v.x, v.y};
         },
         {0, 0},
         -1},
        {[=](const Vector& v) {
             return Vector{c * v.x + s * v.y, s * v.x - c * v.y};
         },
         {1, 1},
         -1},
    };
    Chance chance(99);
    for (int round = 0; round < 60; ++round) {
        const Rigid motion{chance.vector(3), chance.vector(4), chance.vector(4), chance.in(-3, 3), chance.in(-2, 2)};
        Data data;
        for (const char* name : {"A", "B", "D"}) data.points.emplace_back(name, chance.vector(5));
        data.velocities = given_of(chance, data.points, [&](const Vector& place) { return motion.velocity(place); });
        data.accelerations =
            given_of(chance, data.points, [&](const Vector& place) { return motion.acceleration(place); });
        // Some that no rigid body has, too: verdicts do not turn either.
        if (round % 3 == 0)
            for (auto& each : data.velocities)
                if (auto* vector = std::get_if<Vector>(&each.second)) vector->x += 1;
        const Solution before = solved(data);
        for (const Change& change : changes) {
            Data moved = data;
            for (auto& [name, place] : moved.points) place = change.place(place);
            for (Values* values : {&moved.velocities, &moved.accelerations})
                for (auto& [name, value] : *values) {
                    if (auto* vector = std::get_if<Vector>(&value))
                        *vector = change.vector(*vector);
                    else
                        value = along(change.vector(std::get<Vector>(std::get<Bearing>(value).form)));
                }
            const Solution after = solved(moved);
            SCOPED_TRACE("round " + std::to_string(round));
            ASSERT_EQ(after.unsolved.size(), before.unsolved.size());
            EXPECT_EQ(after.instantaneous_motion->found, before.instantaneous_motion->found);
            ASSERT_EQ(after.bodies[1].omega.has_value(), before.bodies[1].omega.has_value());
            if (before.bodies[1].omega) {
                EXPECT_EQ(*after.bodies[1].omega, Exact(change.sense) * *before.bodies[1].omega);
            }
            for (std::size_t p = 0; p < data.points.size(); ++p) {
                ASSERT_EQ(velocity(after, p).has_value(), velocity(before, p).has_value());
                if (velocity(before, p)) {
                    EXPECT_EQ(*velocity(after, p), change.vector(*velocity(before, p)));
                }
                ASSERT_EQ(acceleration(after, p).has_value(), acceleration(before, p).has_value());
                if (acceleration(before, p)) {
                    EXPECT_EQ(*acceleration(after, p), change.vector(*acceleration(before, p)));
                }
            }
            const auto &one = centre_of(before).at, &other = centre_of(after).at;
            ASSERT_EQ(one.has_value(), other.has_value());
            if (one && !one->at_infinity()) {
                EXPECT_EQ(other->place(), change.place(one->place()));
            } else if (one) {
                EXPECT_EQ(cross(other->place(), change.vector(one->place())), Exact(0));
            }
        }
    }
}

TEST(InstantaneousMotion, WhatNoRigidBodyHasIsRefusedWithBothProjections) {
    Chance chance(3);
    int refused = 0;
    for (int round = 0; round < 200; ++round) {
        const Rigid motion{chance.vector(3), chance.vector(4), {}, chance.in(-3, 3), 0};
        const Vector a = chance.vector(5), b = chance.vector(5), off = chance.vector(3);
        if (a == b) continue;
        const Exact wrong = dot(off, b - a);
        const Data data{{{"A", a}, {"B", b}}, {{"A", motion.velocity(a)}, {"B", motion.velocity(b) + off}}, {}};
        const Solution solution = solved(data);
        if (wrong.is_zero()) {
            EXPECT_TRUE(solution.unsolved.empty());
            continue;
        }
        ++refused;
        EXPECT_TRUE(says(solution, "velocity of body 2"));
        EXPECT_TRUE(says(solution, "instant centre 1,2"));
        EXPECT_FALSE(solution.bodies[1].omega);
        EXPECT_FALSE(centre_of(solution).at);
        ASSERT_TRUE(solution.instantaneous_motion->differing);
        const Vector of_first = *solution.instantaneous_motion->differing->of_first;
        const Vector of_second = *solution.instantaneous_motion->differing->of_second;
        EXPECT_EQ(dot(of_second - of_first, b - a), wrong);
        EXPECT_EQ(cross(of_first, b - a), Exact(0)) << "along the join";
        EXPECT_EQ(dot(motion.velocity(a) - of_first, b - a), Exact(0)) << "and at right angles below the tip";
    }
    EXPECT_GT(refused, 100);
}

const std::vector<std::pair<std::string, Vector>> triangle{{"A", {0, 0}}, {"B", {4, 0}}, {"D", {1, 2}}};

TEST(InstantaneousMotion, EqualVelocitiesAreATranslation) {
    const Solution solution = solved(Data{triangle, {{"A", Vector{2, 1}}, {"B", Vector{2, 1}}}, {}});
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_EQ(solution.bodies[1].omega, Exact(0));
    EXPECT_EQ(velocity(solution, 2), (Vector{2, 1}));
    ASSERT_TRUE(centre_of(solution).at->at_infinity());
    EXPECT_EQ(solution.instantaneous_motion->found, InstantaneousMotionFigure::Found::translation);
    EXPECT_TRUE(has_sentence(solution, lang::sentences::act_translation));
}

TEST(InstantaneousMotion, TheJoinOfTheTipsMeetsThatOfThePoints) {
    const Solution same = solved(Data{triangle, {{"A", Vector{0, 3}}, {"B", Vector{0, 1}}}, {}});
    EXPECT_EQ(same.instantaneous_motion->found, InstantaneousMotionFigure::Found::tips);
    EXPECT_EQ(centre_of(same).at->place(), (Vector{6, 0})) << "beyond the slower point";
    EXPECT_EQ(same.bodies[1].omega, Exact::ratio(-1, 2));
    const Solution opposite = solved(Data{triangle, {{"A", Vector{0, 3}}, {"B", Vector{0, -1}}}, {}});
    EXPECT_EQ(opposite.instantaneous_motion->found, InstantaneousMotionFigure::Found::tips);
    EXPECT_EQ(centre_of(opposite).at->place(), (Vector{3, 0})) << "between them";
    EXPECT_EQ(opposite.bodies[1].omega, Exact(-1));
}

TEST(InstantaneousMotion, APointAtRestIsTheCentre) {
    const Solution solution = solved(Data{triangle, {{"A", Vector{}}, {"B", Vector{0, 8}}}, {}});
    EXPECT_EQ(centre_of(solution).at->place(), (Vector{0, 0}));
    EXPECT_EQ(velocity(solution, 2), (Vector{-4, 2}));
    EXPECT_EQ(solution.instantaneous_motion->found, InstantaneousMotionFigure::Found::point_at_rest);
    // Alone it still says where the centre is.
    const Solution alone = solved(Data{triangle, {{"D", Vector{}}}, {}});
    EXPECT_EQ(centre_of(alone).at->place(), (Vector{1, 2}));
    EXPECT_FALSE(says(alone, "instant centre 1,2"));
    EXPECT_TRUE(says(alone, "velocity of body 2"));
}

TEST(InstantaneousMotion, TwoPointsAtRestAreABodyAtRest) {
    const Solution solution = solved(Data{triangle, {{"A", Vector{}}, {"B", Vector{}}}, {}});
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_TRUE(centre_of(solution).everywhere);
    EXPECT_EQ(velocity(solution, 2), (Vector{}));
    // Three directions whose perpendiculars have no common point: the same.
    const Solution lines =
        solved(Data{triangle, {{"A", along({1, 0})}, {"B", along({0, 1})}, {"D", along({1, 7})}}, {}});
    EXPECT_TRUE(lines.unsolved.empty());
    EXPECT_TRUE(centre_of(lines).everywhere);
    EXPECT_TRUE(has_sentence(lines, lang::sentences::act_rest_by_lines));
}

TEST(InstantaneousMotion, DirectionsAloneGiveTheCentreAndNoSize) {
    const Solution solution = solved(Data{triangle, {{"A", along({1, 0})}, {"B", along({1, 1})}}, {}});
    EXPECT_EQ(centre_of(solution).at->place(), (Vector{0, 4}));
    EXPECT_FALSE(solution.bodies[1].omega);
    EXPECT_FALSE(says(solution, "instant centre 1,2"));
    EXPECT_TRUE(says(solution, "velocity of body 2"));
    const Solution parallel = solved(Data{triangle, {{"A", along({1, 1})}, {"B", along({-2, -2})}}, {}});
    EXPECT_TRUE(centre_of(parallel).at->at_infinity());
    EXPECT_EQ(parallel.bodies[1].omega, Exact(0)) << "it translates, however fast";
    EXPECT_TRUE(says(parallel, "velocity of body 2"));
    const Solution one_line = solved(Data{triangle, {{"A", along({0, 1})}, {"B", along({0, 2})}}, {}});
    EXPECT_FALSE(centre_of(one_line).at) << "it is somewhere on AB";
    EXPECT_TRUE(says(one_line, "instant centre 1,2"));
}

TEST(InstantaneousMotion, TooLittleIsSaid) {
    for (const Values& values : {Values{}, Values{{"A", Vector{1, 2}}}, Values{{"A", along({1, 2})}},
                                 Values{{"A", Vector{0, 1}}, {"B", along({0, 1})}}}) {
        const Solution solution = solved(Data{triangle, values, {{"A", Vector{1, 1}}}});
        EXPECT_TRUE(says(solution, "velocity of body 2"));
        EXPECT_TRUE(says(solution, "instant centre 1,2"));
        EXPECT_TRUE(says(solution, "acceleration of body 2"));
        EXPECT_FALSE(solution.bodies[1].omega);
    }
    const Solution known = solved(Data{triangle, {{"A", Vector{1, 2}}}, {}});
    EXPECT_EQ(velocity(known, 0), (Vector{1, 2})) << "what is given is known";
    EXPECT_FALSE(velocity(known, 1));
}

TEST(InstantaneousMotion, MoreThanNeededIsHeldAgainstTheRest) {
    const Values fits{{"A", Vector{0, 0}}, {"B", Vector{0, 4}}, {"D", Vector{-2, 1}}};
    const Solution good = solved(Data{triangle, fits, {}});
    EXPECT_TRUE(good.unsolved.empty());
    EXPECT_TRUE(has_sentence(good, lang::sentences::act_agrees));
    const Solution bad = solved(Data{triangle, {{"A", Vector{0, 0}}, {"B", Vector{0, 4}}, {"D", Vector{-2, 3}}}, {}});
    EXPECT_TRUE(says(bad, "velocity of body 2"));
    EXPECT_TRUE(bad.instantaneous_motion->differing) << "on AD or BD they differ";
    const Solution astray =
        solved(Data{triangle, {{"A", Vector{0, 0}}, {"B", Vector{0, 4}}, {"D", along({1, 1})}}, {}});
    EXPECT_TRUE(says(astray, "velocity of body 2"));
    EXPECT_TRUE(has_sentence(astray, lang::sentences::act_misses));
    // On one line projections are equal and the tips still are on no line.
    const Solution bent = solved(Data{{{"A", {0, 0}}, {"B", {1, 0}}, {"D", {2, 0}}},
                                      {{"A", Vector{0, 1}}, {"B", Vector{0, 2}}, {"D", Vector{0, 5}}},
                                      {}});
    EXPECT_TRUE(says(bent, "velocity of body 2"));
    EXPECT_FALSE(bent.instantaneous_motion->differing);
    EXPECT_FALSE(bent.bodies[1].omega || velocity(bent, 0)) << "nothing of what contradicts itself is a result";
}

TEST(InstantaneousMotion, TwoNamesOfOnePlaceMoveAlike) {
    const std::vector<std::pair<std::string, Vector>> points{{"A", {0, 0}}, {"A'", {0, 0}}, {"B", {4, 0}}};
    EXPECT_TRUE(says(solved(Data{points, {{"A", Vector{1, 2}}, {"A'", Vector{1, 2}}}, {}}), "velocity of body 2"))
        << "two names of one point say no more than one";
    const Solution alike = solved(Data{points, {{"A", Vector{1, 2}}, {"A'", Vector{1, 2}}, {"B", Vector{1, 6}}}, {}});
    EXPECT_TRUE(alike.unsolved.empty());
    EXPECT_EQ(alike.bodies[1].omega, Exact(1));
    const Solution unlike = solved(Data{points, {{"A", Vector{1, 2}}, {"A'", Vector{1, 3}}, {"B", Vector{1, 6}}}, {}});
    EXPECT_TRUE(says(unlike, "velocity of body 2"));
    const Solution crossing = solved(Data{points, {{"A", Vector{1, 2}}, {"A'", along({2, 1})}}, {}});
    EXPECT_TRUE(says(crossing, "velocity of body 2"));
    EXPECT_EQ(crossing.instantaneous_motion->found, InstantaneousMotionFigure::Found::contradiction);
    // Two directions at one place: it can only be at rest.
    const Solution still = solved(Data{points, {{"A", along({1, 2})}, {"A'", along({2, 1})}}, {}});
    EXPECT_EQ(centre_of(still).at->place(), (Vector{0, 0}));
    EXPECT_EQ(velocity(still, 0), (Vector{}));
}

TEST(InstantaneousMotion, AccelerationsByDirectionsAlone) {
    // ω = 0, α = 2 about the origin: a = 2 z∧r. Three directions and no size have no answer but zero; with ω they do.
    const Rigid motion{{0, 0}, {1, -1}, {3, 1}, 2, -1};
    Values velocities{{"A", motion.velocity({0, 0})}, {"B", motion.velocity({4, 0})}};
    Values accelerations;
    for (const auto& [name, place] : triangle) accelerations.emplace_back(name, along(motion.acceleration(place)));
    const Solution solution = solved(Data{triangle, velocities, accelerations});
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_TRUE(has_sentence(solution, lang::sentences::auxiliary_point));
    for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(acceleration(solution, p), motion.acceleration(triangle[p].second));
    // Parallel directions at A and B: α at once. a_A = (2, −4), so a_B = a_A + (−4ω², 4α) ∥ (1, −2) wants 4α = 8ω².
    const Rigid parallel{{0, 0}, {1, 0}, {2, -4}, 1, 2};
    velocities = {{"A", parallel.velocity({0, 0})}, {"B", parallel.velocity({4, 0})}};
    accelerations.clear();
    for (const auto& [name, place] : triangle) accelerations.emplace_back(name, along(parallel.acceleration(place)));
    const Solution other = solved(Data{triangle, velocities, accelerations});
    EXPECT_TRUE(other.unsolved.empty());
    EXPECT_TRUE(has_sentence(other, lang::sentences::alpha_from_parallels));
    EXPECT_EQ(other.bodies[1].alpha, Exact(2));
    for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(acceleration(other, p), parallel.acceleration(triangle[p].second));
}

TEST(InstantaneousMotion, AccelerationsThatDoNotDifferByTheNormalPartAreRefused) {
    const Values velocities{{"A", Vector{0, 0}}, {"B", Vector{0, 4}}};
    EXPECT_TRUE(solved(Data{triangle, velocities, {{"A", Vector{1, 1}}, {"B", Vector{-3, 9}}}}).unsolved.empty());
    const Solution bad = solved(Data{triangle, velocities, {{"A", Vector{1, 1}}, {"B", Vector{-2, 9}}}});
    EXPECT_TRUE(says(bad, "acceleration of body 2"));
    EXPECT_FALSE(bad.bodies[1].alpha);
    EXPECT_EQ(bad.bodies[1].omega, Exact(1)) << "the velocities stand";
    EXPECT_EQ(velocity(bad, 2), (Vector{-2, 1}));
}

TEST(InstantaneousMotion, OfTheLargestAndTheSmallestNumbers) {
    const Exact tiny = Exact::from_decimal("1e-60").value(), huge = Exact::from_decimal("1e60").value();
    for (const Exact& length : {tiny, Exact(1), huge})
        for (const Exact& speed : {tiny, Exact(1), huge}) {
            const Data data{{{"A", {0, 0}}, {"B", {length, 0}}, {"D", {0, length}}},
                            {{"A", Vector{speed, speed}}, {"B", along({1, 3})}},
                            {{"A", Vector{speed, 0}}, {"B", along({1, -1})}}};
            const Solution solution = solved(data);
            EXPECT_TRUE(solution.unsolved.empty());
            EXPECT_EQ(solution.bodies[1].omega, Exact(2) * speed / length);
            EXPECT_EQ(velocity(solution, 1), (Vector{speed, Exact(3) * speed}));
            ASSERT_FALSE(solution.checks.empty());
            for (const CheckRow& row : solution.checks)
                EXPECT_TRUE(std::isfinite(row.graphical)) << name_of(row.quantity, solution);
        }
}

TEST(InstantaneousMotion, FindsWhatIsAsked) {
    Mechanism mechanism = mechanism_of({triangle, {{"A", along({1, 0})}, {"B", along({1, 1})}}, {}});
    mechanism.find.stated = mechanism.find.instant_centres = true;
    const Solution centre = solved(mechanism);
    EXPECT_TRUE(centre.unsolved.empty()) << "directions are enough for the centre";
    EXPECT_EQ(centre_of(centre).at->place(), (Vector{0, 4}));
    mechanism = mechanism_of({triangle, {{"A", Vector{1, 0}}, {"B", along({1, 1})}}, {}});
    mechanism.find.stated = mechanism.find.velocity = true;
    const Solution velocities = solved(mechanism);
    EXPECT_TRUE(velocities.centres.empty());
    EXPECT_EQ(velocity(velocities, 1), (Vector{1, 1}));
    EXPECT_FALSE(has_sentence(velocities, lang::sentences::act_perpendiculars));
    mechanism.find.acceleration = true;
    EXPECT_TRUE(says(solved(mechanism), "acceleration of body 2")) << "none is given";
}

// --- the figure
// --------------------------------------------------------------------------------------------------------------

const render::Fonts& fonts() {
    static const render::Fonts opened = render::Fonts::open().value();
    return opened;
}

/// The axes of the velocities by name, with the length that their value wants, mm.
std::map<std::string, std::pair<double, double>> lengths_of(const render::Figure& figure) {
    std::map<std::string, std::pair<double, double>> lengths;
    for (std::size_t i = 0; i + 1 < figure.marks.size(); ++i) {
        const auto* group = std::get_if<render::GroupBegin>(&figure.marks[i]);
        if (group == nullptr || group->cls != "velocity") continue;
        std::map<std::string, std::string> attributes(group->attributes.begin(), group->attributes.end());
        const auto& axis = std::get<render::Axis>(figure.marks[i + 1]);
        lengths[attributes.at("data-name")] = {
            render::length(axis.tip - axis.tail),
            std::stod(attributes.at("data-value")) / std::stod(attributes.at("data-scale"))};
    }
    return lengths;
}

TEST(InstantaneousMotion, WhatIsMeasuredOnTheFigureIsTheVelocity) {
    const Solution solution = solved(Data{triangle, {{"A", Vector{2, 1}}, {"B", along({1, 1})}}, {}});
    const render::Theme theme;
    const auto lengths =
        lengths_of(render::instantaneous_motion_figure({solution, theme, fonts(), Language::en}, 150, 120));
    ASSERT_EQ(lengths.size(), 3U);
    for (const auto& [name, length] : lengths) EXPECT_NEAR(length.first, length.second, 1e-6) << name;
}

TEST(InstantaneousMotion, EveryCaseIsDrawnInBothLanguages) {
    const std::vector<Data> cases{
        {triangle, {}, {}},
        {triangle, {{"A", Vector{}}, {"B", Vector{}}}, {}},
        {triangle, {{"A", Vector{2, 1}}, {"B", Vector{2, 1}}}, {}},
        {triangle, {{"A", Vector{2, 1}}, {"B", Vector{-2, 3}}}, {}},
        {triangle, {{"A", along({2, 1})}, {"B", along({-2, 3})}}, {}},
        {triangle, {{"A", Vector{1, 1}}, {"B", Vector{1, Exact::ratio(1001, 1000)}}}, {}},
        {triangle, {{"A", Vector{0, 1}}, {"B", Vector{0, Exact::ratio(1001, 1000)}}}, {}},
        {{{"A", {0, 0}}}, {{"A", Vector{1, 1}}}, {}},
        {{{"A", {0, 0}}, {"B", {0, 0}}}, {{"A", Vector{1, 1}}, {"B", Vector{1, 2}}}, {}},
        {triangle, {{"A", Vector{0, 0}}, {"B", Vector{0, 4}}}, {{"A", Vector{1, 1}}, {"B", along({1, 2})}}},
        {{{"A", {0, 0}}, {"B", {Exact::from_decimal("1e60").value(), 0}}},
         {{"A", Vector{0, Exact::from_decimal("1e-60").value()}},
          {"B", Vector{0, Exact::from_decimal("1e60").value()}}},
         {}},
    };
    for (const Data& data : cases)
        for (const auto language : {Language::en, Language::it}) {
            render::SheetOptions options;
            options.language = language;
            const Solution solution = solved(data);
            const auto pages = render::lay_out(solution, options, fonts());
            ASSERT_FALSE(pages.empty());
            for (const render::Page& page : pages) {
                const render::Box box = render::box_of(page.marks);
                for (const double edge : {box.min.x, box.min.y, page.width - box.max.x, page.height - box.max.y})
                    EXPECT_GE(edge, 0) << "case " << &data - cases.data();
            }
        }
}

}  // namespace
}  // namespace kinegraph::instantaneous_motion_test
