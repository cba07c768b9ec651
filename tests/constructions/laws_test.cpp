// Laws: a mechanism moved, turned, mirrored or scaled moves as its original does, exactly; the board's algebra; and
// what a mechanism that cannot give an answer says instead of a number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "constructions/positions/cycle.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/board/board.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/results/results.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/sketch.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::laws_test {
namespace {

using namespace sketch;
using Drawing = PointOn<Plane::drawing>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Solution solved(const Mechanism& mechanism) {
    auto solution = solve(mechanism);
    if (!solution) {
        ADD_FAILURE() << solution.error().front().where << ": " << solution.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(solution);
}
Mechanism from_text(const std::string& text) {
    auto mechanism = read_mechanism(text, "law");
    if (!mechanism) {
        ADD_FAILURE() << mechanism.error().front().where << ": " << mechanism.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(mechanism);
}

// --- moving, turning, mirroring, scaling
// -----------------------------------------------------------------------------------------

/// place → scale · turned (mirrored place) + shift. Mirrored in the x axis; turned by the angle of the unit vector
/// `turn`.
struct Similarity {
    Vector turn{1, 0};
    bool mirrored = false;
    Exact scale = 1;
    Vector shift;

    Vector direction(const Vector& v) const {
        const Vector w = mirrored ? Vector{v.x, -v.y} : v;
        return {turn.x * w.x - turn.y * w.y, turn.y * w.x + turn.x * w.y};
    }
    Vector free(const Vector& v) const { return scale * direction(v); }
    Vector place(const Vector& p) const { return free(p) + shift; }
    Exact spin(const Exact& omega) const { return mirrored ? -omega : omega; }
    Angle angle(const Angle& a) const { return {mirrored ? -a.value : a.value, a.in_degrees}; }
};

Bearing moved(const Similarity& by, Bearing bearing) {
    if (auto* vector = std::get_if<Vector>(&bearing.form)) *vector = by.direction(*vector);
    if (auto* angle = std::get_if<Angle>(&bearing.form)) *angle = by.angle(*angle);
    return bearing;
}

/// The file of the moved mechanism, as its author would write it.
Mechanism moved(const Similarity& by, Mechanism mechanism) {
    for (NamedPoint& point : mechanism.points) {
        if (auto* given = std::get_if<Coordinates>(&point.placement)) given->at = by.place(given->at);
        if (auto* polar = std::get_if<Polar>(&point.placement)) {
            polar->distance *= by.scale;
            polar->angle = by.angle(polar->angle);
        }
        if (auto* along = std::get_if<Along>(&point.placement); along != nullptr && !along->is_ratio)
            along->amount *= by.scale;
        if (auto* meet = std::get_if<Meet>(&point.placement)) {
            for (Curve* curve : {&meet->first, &meet->second}) {
                if (auto* circle = std::get_if<CircleCurve>(curve)) circle->radius *= by.scale;
            }
            if (by.mirrored && meet->side != Meet::Side::either)
                meet->side = meet->side == Meet::Side::left ? Meet::Side::right : Meet::Side::left;
        }
    }
    for (Joint& joint : mechanism.joints) {
        if (joint.along) joint.along = moved(by, *joint.along);
    }
    for (Driver& driver : mechanism.drivers) {
        if (auto* spin = std::get_if<SpinDriver>(&driver)) {
            spin->omega = by.spin(spin->omega);
            spin->alpha = by.spin(spin->alpha);
        } else if (auto* slide = std::get_if<SlideDriver>(&driver)) {
            slide->speed *= by.scale;
            slide->acceleration *= by.scale;
        } else if (auto* point = std::get_if<PointDriver>(&driver)) {
            point->along = moved(by, point->along);
            point->speed *= by.scale;
            point->acceleration *= by.scale;
        }
    }
    return mechanism;
}

/// Equal: exactly, or where points were found by compass to `tolerance` of what is large here.
class Comparison {
public:
    Comparison(const Solution& original, double tolerance) : tolerance_(tolerance) {
        for (const BodyMotion& body : original.bodies) {
            for (const auto& spin : {body.omega, body.alpha}) {
                if (spin) large_ = std::max(large_, std::abs(spin->to_double()));
            }
        }
        for (const PointMotion& point : original.points) {
            for (const auto& vector : {point.velocity, point.acceleration}) {
                if (vector) large_ = std::max(large_, length(*vector));
            }
        }
    }
    bool equal(const Exact& a, const Exact& b, double beside = 0) const {
        if (tolerance_ == 0) return a == b;
        return std::abs((a - b).to_double()) <= tolerance_ * std::max(large_, beside);
    }
    bool equal(const Vector& a, const Vector& b) const {
        const double beside = tolerance_ == 0 ? 0 : length(a);
        return equal(a.x, b.x, beside) && equal(a.y, b.y, beside);
    }
    bool parallel(const Vector& a, const Vector& b) const {
        if (tolerance_ == 0) return cross(a, b).is_zero();
        return std::abs(cross(a, b).to_double()) <= tolerance_ * length(a) * length(b);
    }

private:
    double tolerance_ = 0, large_ = 1;
};

void expect_moved(const Similarity& by, const Solution& original, const Solution& image, double tolerance) {
    const Comparison same(original, tolerance);
    ASSERT_EQ(original.points.size(), image.points.size());
    ASSERT_EQ(original.centres.size(), image.centres.size());
    ASSERT_EQ(original.sliding.size(), image.sliding.size());
    EXPECT_EQ(original.unsolved.size(), image.unsolved.size());
    EXPECT_EQ(original.mobility.effective, image.mobility.effective);
    // The plan looks at structure and incidences: it does not know where the drawing lies.
    EXPECT_EQ(original.protocol.program.strokes.size(), image.protocol.program.strokes.size());
    for (std::size_t i = 0; i < original.bodies.size(); ++i) {
        const BodyMotion &a = original.bodies[i], &b = image.bodies[i];
        ASSERT_TRUE(a.omega && b.omega && a.alpha && b.alpha);
        EXPECT_TRUE(same.equal(by.spin(*a.omega), *b.omega)) << "omega of body " << i;
        EXPECT_TRUE(same.equal(by.spin(*a.alpha), *b.alpha)) << "alpha of body " << i;
    }
    for (std::size_t i = 0; i < original.points.size(); ++i) {
        const PointMotion &a = original.points[i], &b = image.points[i];
        ASSERT_TRUE(a.velocity && b.velocity && a.acceleration && b.acceleration) << a.label;
        EXPECT_TRUE(same.equal(by.free(*a.velocity), *b.velocity)) << "velocity of " << a.label;
        EXPECT_TRUE(same.equal(by.free(*a.acceleration), *b.acceleration)) << "acceleration of " << a.label;
    }
    for (std::size_t i = 0; i < original.sliding.size(); ++i) {
        EXPECT_TRUE(same.equal(by.free(*original.sliding[i].velocity), *image.sliding[i].velocity));
        EXPECT_TRUE(same.equal(by.free(*original.sliding[i].acceleration), *image.sliding[i].acceleration));
        EXPECT_TRUE(same.equal(by.free(*original.sliding[i].coriolis), *image.sliding[i].coriolis));
    }
    for (std::size_t i = 0; i < original.centres.size(); ++i) {
        const InstantCentre &a = original.centres[i], &b = image.centres[i];
        const std::string what =
            "centre of bodies " + std::to_string(a.first.number()) + " and " + std::to_string(a.second.number());
        EXPECT_EQ(a.everywhere, b.everywhere) << what;
        ASSERT_EQ(a.at.has_value(), b.at.has_value()) << what;
        if (!a.at) continue;
        ASSERT_EQ(a.at->at_infinity(), b.at->at_infinity()) << what;
        if (a.at->at_infinity()) {
            EXPECT_TRUE(same.parallel(by.direction(a.at->place()), b.at->place())) << what;
        } else {
            EXPECT_TRUE(same.equal(by.place(a.at->place()), b.at->place())) << what;
        }
    }
}

bool drives_along(const Mechanism& mechanism) {
    for (const Driver& driver : mechanism.drivers) {
        if (!std::holds_alternative<SpinDriver>(driver)) return true;
    }
    return false;
}

constexpr int mechanisms_moved = unless_sanitized(120, 20);

void hold_for_random_mechanisms(
    const Similarity& by, bool by_compass, double tolerance,
    const std::function<bool(const Mechanism&)>& serves = [](const Mechanism&) { return true; }) {
    int held = 0;
    for (std::uint64_t seed = 10000; held < mechanisms_moved && !testing::Test::HasFailure(); ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        if (random.by_compass != by_compass) continue;
        const Mechanism mechanism = from_text(random.text);
        if (!serves(mechanism)) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        expect_moved(by, solved(mechanism), solved(moved(by, mechanism)), tolerance);
        ++held;
    }
}

const Vector pythagorean{Exact::ratio(3, 5), Exact::ratio(4, 5)};

TEST(Similar, Moved) { hold_for_random_mechanisms({{1, 0}, false, 1, at("12.5", "-0.037")}, false, 0); }
TEST(Similar, TurnedByAPythagoreanAngle) { hold_for_random_mechanisms({pythagorean, false, 1, {}}, false, 0); }
TEST(Similar, TurnedByAQuarter) { hold_for_random_mechanisms({{0, 1}, false, 1, {}}, false, 0); }
TEST(Similar, Mirrored) { hold_for_random_mechanisms({{1, 0}, true, 1, {}}, false, 0); }
TEST(Similar, MirroredTurnedAndMoved) { hold_for_random_mechanisms({pythagorean, true, 1, at("3", "-4")}, false, 0); }
TEST(Similar, ScaledExactlyWhereOnlySpinsAreDriven) {
    // A driven slide needs the guide's unit vector: a root, which is rounded to the drawing's size.
    hold_for_random_mechanisms({pythagorean, false, Exact::ratio(7, 3), at("1", "2")}, false, 0,
                               [](const Mechanism& mechanism) { return !drives_along(mechanism); });
}
TEST(Similar, ScaledTo1e12WhereSlidesAreDriven) {
    hold_for_random_mechanisms({{1, 0}, false, Exact::ratio(7, 3), at("1", "2")}, false, 1e-12, drives_along);
}
TEST(Similar, MirroredTo1e12ByCompass) { hold_for_random_mechanisms({{1, 0}, true, 1, {}}, true, 1e-12); }
TEST(Similar, ScaledTo1e12ByCompass) {
    hold_for_random_mechanisms({{1, 0}, true, Exact::ratio(7, 3), at("1", "-2")}, true, 1e-12);
}

TEST(Similar, FourBarByCompassTurnedByAPythagoreanAngle) {
    const Mechanism four_bar =
        from_text(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [0.02, 0.03], "Q": [0.15, 0.01],
        "B": {"meet": [{"circle": "A", "radius": 0.15}, {"circle": "Q", "radius": 0.08}], "side": "left"}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["Q", "B"]}, "frame": 1,
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
        {"revolute": "Q", "bodies": [1, 4]}], "drivers": [{"body": 2, "omega": 5, "alpha": -3}]})");
    const Similarity by{pythagorean, false, 1, at("0.7", "-0.9")};
    const Solution original = solved(four_bar);
    EXPECT_FALSE(original.pose.exact);
    expect_moved(by, original, solved(moved(by, four_bar)), 1e-12);
}

struct Travelled {
    bool stops = false;
    double from = 0, to = 0;
    std::vector<std::map<std::string, double>> rows;  ///< by name of the column
};
/// The cycle of the first driver with three of its rows; empty if it has no travel. `sense`: −1 from its end to its
/// beginning.
Travelled travelled(const Mechanism& mechanism, int sense) {
    Travelled found;
    const Pose pose = *draw_pose(mechanism);
    auto cycle = Cycle::of(mechanism, pose, 0);
    if (!cycle) return found;
    std::optional<double> to;
    auto travel = travel_of(cycle->positions(), true, {}, {});
    if (travel && !travel->ends_at_limit) to = sense * travel->to, travel = travel_of(cycle->positions(), true, 0, to);
    if (!travel) return found;
    cycle->begin(*travel);
    found.stops = travel->ends_at_limit;
    found.from = travel->from, found.to = travel->to;
    if (found.stops && sense < 0) std::swap(found.from, found.to);
    for (const double share : {0.23, 0.61, 0.87}) {
        std::map<std::string, double>& row = found.rows.emplace_back();
        if (const auto values = cycle->row(found.from + share * (found.to - found.from)))
            for (std::size_t i = 0; i < values->size(); ++i) row[cycle->columns()[i].name] = (*values)[i];
    }
    return found;
}

// The whole cycle is that of the mirrored, turned, scaled and moved mechanism: limits, also those at which a place goes
// to infinity, and rows.
TEST(Similar, CyclesAreTheImagesOfOneAnother) {
    const Similarity by{pythagorean, true, Exact::ratio(7, 3), at("1", "2")};
    const int most = unless_sanitized(60, 10);
    constexpr double known = 1e-6;  // limits beside a change point
    int held = 0, stopped = 0;
    for (std::uint64_t seed = 20000; held < most; ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        const Mechanism mechanism = from_text(random.text);
        if (random.by_compass || drives_along(mechanism)) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        const Travelled original = travelled(mechanism, 1), image = travelled(moved(by, mechanism), -1);
        ++held;
        ASSERT_EQ(original.rows.size(), image.rows.size());
        ASSERT_EQ(original.stops, image.stops);
        stopped += original.stops ? 1 : 0;
        EXPECT_NEAR(original.from, -image.from, known);
        EXPECT_NEAR(original.to, -image.to, known);
        for (std::size_t r = 0; r < original.rows.size(); ++r) {
            EXPECT_EQ(original.rows[r].size(), image.rows[r].size());
            for (const auto& [name, value] : original.rows[r]) {
                if (!name.starts_with("omega ") && !name.starts_with("alpha ")) continue;
                ASSERT_TRUE(image.rows[r].contains(name));
                EXPECT_NEAR(value, -image.rows[r].at(name), known * std::max(1.0, std::abs(value))) << name;
            }
        }
    }
    EXPECT_GT(stopped, held / 4);
}

// Drawn anew in a position on its way, a mechanism goes the same way.
TEST(Similar, ATravelIsTheSameFromEachOfItsPositions) {
    const int most = unless_sanitized(60, 10);
    constexpr double known = 2e-6;  // limits beside a change point, twice
    int held = 0, stopped = 0;
    for (std::uint64_t seed = 30000; held < most; ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        const Mechanism mechanism = from_text(random.text);
        if (mechanism.drivers.size() != 1) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        const bool turns = std::holds_alternative<SpinDriver>(mechanism.drivers[0]);
        const Pose pose = *draw_pose(mechanism);
        auto positions = Positions::of(mechanism, pose, 0);
        if (!positions) continue;
        const auto travel = travel_of(*positions, turns, {}, {});
        if (!travel) continue;
        ++held;
        const Mover mover(mechanism, pose);
        for (const double share : {0.13, 0.71}) {
            const double here = travel->at(share);
            ASSERT_TRUE(positions->move_to(here));
            if (positions->is_singular()) continue;
            const auto redrawn = mover.moved(*positions, Exact::from_double(here));
            ASSERT_TRUE(redrawn);
            const auto from_there = Positions::of(redrawn->mechanism, redrawn->pose, 0);
            ASSERT_TRUE(from_there);
            const auto again = travel_of(*from_there, turns, {}, {});
            ASSERT_TRUE(again);
            ASSERT_EQ(again->ends_at_limit, travel->ends_at_limit);
            if (!travel->ends_at_limit) continue;
            ++stopped;
            EXPECT_NEAR(again->from + here, travel->from, known);
            EXPECT_NEAR(again->to + here, travel->to, known);
        }
    }
    EXPECT_GT(stopped, held / 4);
}

TEST(Similar, FasterDriversScaleVelocitiesAndSquareAccelerations) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Mechanism mechanism = from_text(random_mechanism(seed).text);
        Mechanism faster = mechanism;
        // The same path run through k times as fast: speeds by k, accelerations by k².
        const Exact k = Exact::ratio(-5, 2);
        for (Driver& driver : faster.drivers) {
            if (auto* spin = std::get_if<SpinDriver>(&driver)) spin->omega *= k, spin->alpha *= square(k);
            if (auto* slide = std::get_if<SlideDriver>(&driver)) slide->speed *= k, slide->acceleration *= square(k);
            if (auto* point = std::get_if<PointDriver>(&driver)) point->speed *= k, point->acceleration *= square(k);
        }
        const Solution slow = solved(mechanism), fast = solved(faster);
        ASSERT_FALSE(slow.points.empty());
        for (std::size_t i = 0; i < slow.points.size(); ++i) {
            EXPECT_EQ(k * *slow.points[i].velocity, *fast.points[i].velocity) << "seed " << seed;
            EXPECT_EQ(square(k) * *slow.points[i].acceleration, *fast.points[i].acceleration) << "seed " << seed;
        }
    }
}

// --- centres of what moves and of what cannot
// --------------------------------------------------------------------------------------------------------

/// Two bodies by name, in the order of the alphabet.
using NamedPair = std::pair<std::string, std::string>;
std::map<NamedPair, InstantCentre> centres_of(const Solution& solution) {
    std::map<NamedPair, InstantCentre> named;
    for (const InstantCentre& centre : solution.centres) {
        const auto name = [&](BodyIndex body) { return solution.mechanism.body(body).name; };
        named[std::minmax(name(centre.first), name(centre.second))] = centre;
    }
    return named;
}

/// The determinant of three projective points relative to the size of its terms, and the same for two.
bool vanishes(const Exact& value, const Exact& beside, bool exact) {
    return exact ? value.is_zero() : abs(value) <= Exact::power_of_two(-60) * beside;
}
ProjectivePoint by_size(ProjectivePoint p, const Solution& solution) {
    if (p.at_infinity()) return p;
    p.x /= solution.pose.size;
    p.y /= solution.pose.size;
    return p;
}
Exact largest(const ProjectivePoint& p) { return std::max({abs(p.x), abs(p.y), abs(p.w)}); }
bool are_collinear(const ProjectivePoint& p, const ProjectivePoint& q, const ProjectivePoint& r, bool exact) {
    const Exact determinant =
        p.x * (q.y * r.w - r.y * q.w) - p.y * (q.x * r.w - r.x * q.w) + p.w * (q.x * r.y - r.x * q.y);
    return vanishes(determinant, largest(p) * largest(q) * largest(r), exact);
}
bool are_one_point(const ProjectivePoint& p, const ProjectivePoint& q, bool exact) {
    const Exact beside = largest(p) * largest(q);
    return vanishes(p.x * q.y - q.x * p.y, beside, exact) && vanishes(p.x * q.w - q.x * p.w, beside, exact) &&
           vanishes(p.y * q.w - q.y * p.w, beside, exact);
}

/// Aronhold and Kennedy, also of bodies that cannot move: if two of three are at rest against each other, the third
/// body has one and the same centre with both.
void expect_three_centres_on_a_line(const Solution& solution) {
    const bool exact = solution.pose.exact;
    const auto centres = centres_of(solution);
    std::set<std::string> names;
    for (const Body& body : solution.mechanism.bodies) names.insert(body.name);
    const auto of = [&](const std::string& i, const std::string& j) { return centres.at(std::minmax(i, j)); };
    const auto at = [&](const InstantCentre& centre) { return by_size(*centre.at, solution); };
    for (auto i = names.begin(); i != names.end(); ++i)
        for (auto j = std::next(i); j != names.end(); ++j)
            for (auto k = names.begin(); k != names.end(); ++k) {
                if (k == i || k == j) continue;
                const InstantCentre ij = of(*i, *j), ik = of(*i, *k), jk = of(*j, *k);
                const std::string what = "bodies " + *i + ", " + *j + ", " + *k;
                if (ij.depends_on_drivers || ik.depends_on_drivers || jk.depends_on_drivers) continue;
                if (ij.everywhere) {
                    EXPECT_EQ(ik.everywhere, jk.everywhere) << what;
                    const bool both = ik.at && jk.at && !ik.everywhere && !jk.everywhere;
                    EXPECT_TRUE(!both || are_one_point(at(ik), at(jk), exact)) << what;
                } else if (ij.at && ik.at && jk.at && !ik.everywhere && !jk.everywhere && *j < *k) {
                    EXPECT_TRUE(are_collinear(at(ij), at(ik), at(jk), exact)) << what;
                }
            }
}

/// `image`: of the same mechanism, turned, given in another order, or asked for less.
void expect_same_centres(const Solution& original, const Solution& image, const Similarity& by) {
    const bool exact = original.pose.exact;
    const auto there = centres_of(image);
    ASSERT_EQ(there.size(), original.centres.size());
    for (const auto& [names, a] : centres_of(original)) {
        const InstantCentre& b = there.at(names);
        const std::string what = "centre " + names.first + "," + names.second;
        EXPECT_EQ(a.everywhere, b.everywhere) << what;
        ASSERT_EQ(a.at.has_value(), b.at.has_value()) << what;
        if (!a.at) continue;
        ASSERT_EQ(a.at->at_infinity(), b.at->at_infinity()) << what;
        ProjectivePoint expected = *a.at;
        const Vector place = a.at->at_infinity() ? by.direction(a.at->place()) : by.place(a.at->place());
        expected = {place.x, place.y, a.at->at_infinity() ? Exact(0) : Exact(1)};
        EXPECT_TRUE(are_one_point(by_size(expected, original), by_size(*b.at, original), exact)) << what;
    }
}

/// The file with its bodies and joints in another order, and with links of two pins between points of its bodies: each
/// takes a freedom, so that parts of it or the whole become rigid.
class VariedFile {
public:
    VariedFile(const std::string& text, Random& random) : random_(random), file_(Json::parse(text)) {}

    void add_link() {
        std::vector<std::pair<std::string, std::string>> carried;
        for (const auto& [body, points] : file_["bodies"].items())
            for (const auto& point : points) carried.emplace_back(body, point.get<std::string>());
        for (const auto& point : {file_["points"].begin().key()}) carried.emplace_back("1", point);
        const auto any = [&] { return carried[index(random_.whole(0, static_cast<int>(carried.size()) - 1))]; };
        const auto from = any(), to = any();
        if (from.first == to.first || from.second == to.second) return;
        const std::string name = "link " + std::to_string(++links_);
        file_["bodies"][name] = {from.second, to.second};
        for (const auto& [body, point] : {from, to})
            file_["joints"].push_back(
                {{"revolute", point}, {"bodies", {body, name}}, {"name", name + " " + std::to_string(++pins_)}});
    }
    void drive_nothing() { file_.erase("drivers"); }
    std::string text() const { return file_.dump(); }
    std::string reordered() {
        Json other = file_;
        other["bodies"] = Json::object();
        std::vector<std::pair<std::string, Json>> bodies;
        for (const auto& [name, points] : file_["bodies"].items()) bodies.emplace_back(name, points);
        shuffle(bodies);
        for (const auto& [name, points] : bodies) other["bodies"][name] = points;
        std::vector<Json> joints(file_["joints"].begin(), file_["joints"].end());
        shuffle(joints);
        other["joints"] = joints;
        return other.dump();
    }

private:
    using Json = nlohmann::ordered_json;
    template <class List>
    void shuffle(List& list) {
        for (std::size_t i = list.size(); i > 1; --i)
            std::swap(list[i - 1], list[index(random_.whole(0, static_cast<int>(i) - 1))]);
    }

    Random& random_;
    Json file_;
    int links_ = 0, pins_ = 0;
};

/// Its drivers rest, and have for accelerations what were their speeds.
Mechanism started_from_rest(Mechanism mechanism) {
    for (Driver& driver : mechanism.drivers)
        std::visit(
            [](auto& given) {
                if constexpr (requires { given.omega; })
                    given.alpha = std::exchange(given.omega, 0);
                else
                    given.acceleration = std::exchange(given.speed, 0);
            },
            driver);
    return mechanism;
}

/// What a file asks for: the centres alone, or everything.
Solution with_find(Mechanism mechanism, bool all) {
    mechanism.find = {};
    mechanism.find.stated = mechanism.find.instant_centres = true;
    mechanism.find.velocity = mechanism.find.acceleration = all;
    return solved(mechanism);
}

/// Mechanisms with up to three links too many, half of them without drivers.
void hold_centres(int quarter) {
    int immobile = 0, rigid_parts = 0, mobile = 0, driven = 0;
    const int count = unless_sanitized(500, 40);
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
        const auto seed = static_cast<std::uint64_t>(40000 + 4 * n + quarter);
        Random random(seed);
        const RandomMechanism drawn = random_mechanism(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + drawn.recipe);
        VariedFile file(drawn.text, random);
        for (int links = random.whole(0, 3); links > 0; --links) file.add_link();
        if (random.chance(50)) file.drive_nothing();
        const Mechanism mechanism = from_text(file.text());
        const Solution solution = with_find(mechanism, true);
        expect_three_centres_on_a_line(solution);
        expect_same_centres(solution, with_find(mechanism, false), {});
        expect_same_centres(solution, with_find(from_text(file.reordered()), true), {});
        expect_same_centres(solution, with_find(started_from_rest(mechanism), false), {});
        const Similarity by{pythagorean, true, 1, at("3", "-4")};
        if (solution.pose.exact) expect_same_centres(solution, with_find(moved(by, mechanism), true), by);
        const bool moves = solution.mobility.effective > 0;
        const auto as_one = std::count_if(solution.centres.begin(), solution.centres.end(),
                                          [](const InstantCentre& each) { return each.everywhere; });
        EXPECT_TRUE(moves || as_one == static_cast<int>(solution.centres.size()));
        ++(moves ? mobile : immobile);
        rigid_parts += moves && as_one > 0 ? 1 : 0;
        driven += mechanism.drivers.empty() ? 0 : 1;
        if (testing::Test::HasFailure()) std::cerr << file.text() << "\n";
    }
    EXPECT_GT(immobile, count / 10);
    EXPECT_GT(rigid_parts, count / 20);
    EXPECT_GT(mobile, count / 4);
    EXPECT_GT(driven, count / 4);
}

TEST(Centres1, AreOnALineWhateverIsAskedInAnyOrder) { hold_centres(0); }
TEST(Centres2, AreOnALineWhateverIsAskedInAnyOrder) { hold_centres(1); }
TEST(Centres3, AreOnALineWhateverIsAskedInAnyOrder) { hold_centres(2); }
TEST(Centres4, AreOnALineWhateverIsAskedInAnyOrder) { hold_centres(3); }

TEST(Centres, OfATriangleAreEverywhereAndItIsSaid) {
    const Solution solution = solved(from_text(R"({"kinegraph": 1, "points": {"A": [0, 0], "B": [5, 0], "C": [1, 4]},
        "bodies": {"2": ["A", "C"], "3": ["B", "C"]}, "frame": 1, "joints": [{"revolute": "A", "bodies": [1, 2]},
        {"revolute": "B", "bodies": [1, 3]}, {"revolute": "C", "bodies": [2, 3]}]})"));
    ASSERT_EQ(solution.centres.size(), 3U);
    for (const InstantCentre& centre : solution.centres) EXPECT_TRUE(centre.everywhere && centre.as_one && centre.at);
    ASSERT_EQ(solution.remarks.size(), 1U);
    EXPECT_EQ(solution.remarks.front().sentence, lang::sentences::nothing_moves);
    EXPECT_TRUE(solution.unsolved.empty());
}

/// At rest the accelerations are as the velocities will be; the centre is found whatever else is asked.
TEST(Centres, OfFreedomsThatBeginToMoveAreThoseOfTheirAccelerations) {
    const auto with = [](const std::string& rates, bool all) {
        return centres_of(with_find(from_text(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [-1, 2], "C": [1.5, 4],
            "B": [4, 2], "Q": [3, 0]}, "bodies": {"2": ["O", "A"], "3": ["A", "C"], "4": ["C", "B"], "5": ["Q", "B"]},
            "frame": 1, "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "C", "bodies": [3, 4]}, {"revolute": "B", "bodies": [4, 5]},
            {"revolute": "Q", "bodies": [1, 5]}], "drivers": [)" +
                                              rates + "]}"),
                                    all));
    };
    const auto moving = with(R"({"body": 2, "omega": 1}, {"body": 5, "omega": 2})", true);
    for (const bool all : {false, true}) {
        const auto resting = with(R"({"body": 2, "omega": 0, "alpha": 1}, {"body": 5, "omega": 0, "alpha": 2})", all);
        for (const auto& [names, centre] : moving) {
            ASSERT_TRUE(centre.at && resting.at(names).at) << names.first << names.second;
            EXPECT_EQ(resting.at(names).at->place(), centre.at->place()) << names.first << names.second;
        }
        EXPECT_EQ(resting.at({"1", "3"}).how, InstantCentre::How::accelerations);
    }
}

/// Kennedy's line over a slider in its dead centre is that of the neighbouring positions; the pair rests in passing.
TEST(Centres, OfASliderInItsDeadCentreAreEverywhereWithoutVelocitiesToo) {
    const Mechanism mechanism = from_text(R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [2, 0], "B": [7, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]}, "frame": 1,
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 2, "omega": 1}]})");
    for (const bool all : {false, true}) {
        const auto centres = centres_of(with_find(mechanism, all));
        EXPECT_TRUE(centres.at({"1", "4"}).everywhere);
        EXPECT_FALSE(centres.at({"1", "4"}).as_one);
        EXPECT_EQ(centres.at({"1", "3"}).at->place(), at("7", "0"));
    }
}

// --- the board
// -------------------------------------------------------------------------------------------------------------------

Pose pose_of(const Mechanism& mechanism, int bits = 100) {
    auto pose = draw_pose(mechanism, bits);
    if (!pose) {
        ADD_FAILURE() << pose.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(pose);
}

/// A board over a sketch's pose, with the finer pose at hand.
/// However many digits it has.
Sketch exactly(Sketch drawn) {
    drawn.mechanism.precision = Exact(0);
    return drawn;
}

struct Table {
    Sketch sketch;
    Pose pose, fine;
    Board board;
    explicit Table(Sketch drawn)
        : sketch(exactly(std::move(drawn))),
          pose(pose_of(sketch.mechanism)),
          fine(pose_of(sketch.mechanism, 200)),
          board(sketch.mechanism, pose, [this]() -> const Pose& { return fine; }) {}
    Drawing operator()(const std::string& name) { return board.place(sketch[name]); }
    LineOn<Plane::drawing> join(const std::string& p, const std::string& q) {
        return board.join((*this)(p), (*this)(q));
    }
    DirectionHandle direction(const std::string& p, const std::string& q) {
        return board.direction(board.vector((*this)(p), (*this)(q)));
    }
    bool last_was_decided_finer() const { return board.program().guards.back().how == Guard::How::by_finer_pose; }
    /// Nothing asks a number off the board: whoever wants one replays its program.
    ProjectivePoint value(Drawing point) const {
        const Program& program = board.program();
        return std::get<ProjectivePoint>(
            evaluate(program, givens_of(program, sketch.mechanism, pose), pose).values[at_index(point.element)]);
    }
};

bool same(const ProjectivePoint& p, const ProjectivePoint& q) {
    return (p.x * q.y - q.x * p.y).is_zero() && (p.x * q.w - q.x * p.w).is_zero() && (p.y * q.w - q.y * p.w).is_zero();
}

TEST(BoardLaw, DecimalsAreCollinearThoughDoublesAreNot) {
    const double x = 0.1, y = 0.7, u = 0.3, w = 2.1;
    EXPECT_NE(x * w - u * y, 0) << "a machine where doubles would do";
    Sketch s;
    s.point("O", "0", "0")
        .point("A", "0.1", "0.7")
        .point("B", "0.3", "2.1")
        .point("C", "0.3", "2.1000000000000000000000001");
    Table table(s);
    EXPECT_TRUE(table.board.on_line(table("B"), table.join("O", "A")));
    EXPECT_FALSE(table.board.on_line(table("C"), table.join("O", "A")));
    EXPECT_TRUE(table.board.parallel(table.direction("O", "A"), table.direction("A", "B")));
}

Sketch quadrangle(std::uint64_t seed) {
    Random random(seed);
    Sketch s;
    for (const char* name : {"A", "B", "C", "D"}) {
        const auto coordinate = [&] { return Exact::ratio(random.whole(-999, 999), 100); };
        const Exact x = coordinate();
        s.point(name, Coordinates{{x, coordinate()}});
    }
    return s;
}

TEST(BoardLaw, MeetCommutesAndIsDualToJoin) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Table t(quadrangle(seed));
        const auto ab = t.join("A", "B"), cd = t.join("C", "D");
        const auto there = t.board.meet(ab, cd), back = t.board.meet(cd, ab);
        ASSERT_TRUE(there && back);
        EXPECT_TRUE(same(t.value(*there), t.value(*back)));
        EXPECT_TRUE(t.board.on_line(*there, ab));
        EXPECT_TRUE(t.board.on_line(*there, cd));
        // Two joins from A meet in A; the meet joined to A is the line it came from.
        const auto a = t.board.meet(t.join("A", "B"), t.join("A", "C"));
        ASSERT_TRUE(a);
        EXPECT_TRUE(t.board.coincide(*a, t("A")));
        EXPECT_FALSE(t.board.meet(t.board.join(*there, t("A")), ab)) << "the same line has no one meet";
        EXPECT_FALSE(t.board.meet(t.join("A", "B"), t.join("B", "A"))) << "the join commutes";
    }
}

TEST(BoardLaw, ParallelsMeetAtInfinityAndGoOnFromThere) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Table t(quadrangle(seed));
        const auto ab = t.join("A", "B");
        const auto beside = t.board.through(t("C"), t.direction("A", "B"));
        const auto far = t.board.meet(ab, beside);
        ASSERT_TRUE(far);
        EXPECT_TRUE(t.board.is_at_infinity(*far));
        EXPECT_TRUE(same(t.value(*far), t.value(t.board.at_infinity(t.direction("A", "B")))));
        // Joined to D it gives the parallel through D; two such points give the line at infinity, which meets CD at its
        // own.
        const auto through_d = t.board.join(t("D"), *far);
        EXPECT_TRUE(t.board.parallel(through_d, ab));
        const auto other = t.board.at_infinity(t.direction("A", "C"));
        const auto horizon = t.board.join(*far, other);
        EXPECT_TRUE(t.board.is_at_infinity(horizon));
        const auto of_cd = t.board.meet(horizon, t.join("C", "D"));
        ASSERT_TRUE(of_cd);
        EXPECT_TRUE(same(t.value(*of_cd), t.value(t.board.at_infinity(t.direction("C", "D")))));
        EXPECT_FALSE(t.board.meet(horizon, horizon));
    }
}

/// O2O4BA with equal opposite sides, turned by 17°: parallel through irrational roots only.
Sketch parallelogram() {
    Sketch s;
    s.point("O2", "0", "0").polar("O4", "O2", "0.12", "17").polar("A", "O2", "0.05", "77.3");
    s.meet("B", s.circle("A", "0.12"), s.circle("O4", "0.05"), Meet::Side::left);
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    return s.spin("2", "3", "-2");
}

/// An isosceles trapezium, its legs at 60° to the base, turned by 17°: AB ∥ O2O4 through irrational roots, and no
/// corner of a parallelogram that the pose could complete.
Sketch trapezium(const char* coupler) {
    Sketch s;
    s.point("O2", "0", "0").polar("O4", "O2", "0.12", "17").polar("A", "O2", "0.05", "77");
    return s.meet("B", s.circle("A", coupler), s.circle("O4", "0.05"), Meet::Side::left);
}

TEST(BoardLaw, ParallelThroughRootsIsDecidedByTheFinerPose) {
    Table t(trapezium("0.07"));
    EXPECT_FALSE(t.pose.exact);
    EXPECT_TRUE(t.board.parallel(t.direction("O2", "O4"), t.direction("A", "B")));
    EXPECT_TRUE(t.last_was_decided_finer());
    const auto far = t.board.meet(t.join("O2", "O4"), t.join("A", "B"));
    ASSERT_TRUE(far);
    EXPECT_TRUE(t.board.is_at_infinity(*far)) << "the verdict is used, not the number";
    EXPECT_FALSE(t.board.parallel(t.direction("O2", "O4"), t.direction("O2", "A")));
    EXPECT_FALSE(t.last_was_decided_finer()) << "nothing suspicious about 60°";
}

TEST(BoardLaw, WhatStaysOnTheFinerPoseIsNotZero) {
    Table t(trapezium("0.0700000000000000000000001"));
    EXPECT_FALSE(t.board.parallel(t.direction("O2", "O4"), t.direction("A", "B")));
    EXPECT_TRUE(t.last_was_decided_finer());
}

TEST(BoardLaw, SidesOfAParallelogramFoundByCompassAreParallel) {
    Table t(parallelogram());
    EXPECT_FALSE(t.pose.exact);
    EXPECT_TRUE(t.board.parallel(t.direction("O2", "O4"), t.direction("A", "B")));
    EXPECT_TRUE(t.board.parallel(t.join("O2", "A"), t.join("O4", "B")));
    const auto far = t.board.meet(t.join("O2", "A"), t.join("O4", "B"));
    ASSERT_TRUE(far);
    EXPECT_TRUE(t.board.is_at_infinity(*far));
}

TEST(BoardLaw, ParallelogramTurnedBy17DegreesTranslatesItsCoupler) {
    const Solution solution = solved(parallelogram().mechanism);
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_NEAR(solution.bodies[2].omega->to_double(), 0, 1e-25);
    EXPECT_NEAR(solution.bodies[3].omega->to_double(), 3, 1e-25);
    for (const InstantCentre& centre : solution.centres) {
        const bool of_coupler_or_cranks = (centre.first == frame && centre.second == BodyIndex(2)) ||
                                          (centre.first == BodyIndex(1) && centre.second == BodyIndex(3));
        EXPECT_EQ(centre.at && centre.at->at_infinity(), of_coupler_or_cranks)
            << centre.first.number() << "," << centre.second.number();
    }
}

// --- no answer, with its reason
// ----------------------------------------------------------------------------------------------------

std::string reasons(const Solution& solution) {
    std::string all;
    for (const Unsolved& unsolved : solution.unsolved) all += english_of(unsolved) + "\n";
    return all;
}
void expect_no_nonsense(const Solution& solution) {
    for (const CheckRow& row : solution.checks) {
        EXPECT_TRUE(std::isfinite(row.graphical) && std::isfinite(row.numeric)) << name_of(row.quantity, solution);
        EXPECT_LT(std::abs(row.graphical), 1e9) << name_of(row.quantity, solution);
    }
    const std::string json = results_json(solution, true, english);
    for (const char* word : {"nan", "inf"}) EXPECT_EQ(json.find(word), std::string::npos) << json;
    for (const Unsolved& unsolved : solution.unsolved)
        EXPECT_GT(english(unsolved.why).size(), 10u) << english(unsolved.what);
}
bool says(const Solution& solution, const std::string& words) {
    return reasons(solution).find(words) != std::string::npos;
}

Sketch slider_crank_stretched(const char* angle) {
    Sketch s;
    s.point("O", "0", "0").polar("A", "O", "0.05", angle);
    s.meet("B", s.circle("A", "0.15"), s.line("O", angle), Meet::Side::right);
    s.revolute("O", {"1", "2"})
        .revolute("A", {"2", "3"})
        .revolute("B", {"3", "4"})
        .prismatic("B", {"4", "1"}, at_angle(angle));
    return s;
}

TEST(NoAnswer, DeadPointDrawnByCompassIsSeen) {
    for (const char* angle : {"0", "23.7", "101.3", "-64.81"}) {
        Sketch s = slider_crank_stretched(angle);
        s.slide(3, "0.5");
        const Solution solution = solved(s.mechanism);
        EXPECT_FALSE(solution.unsolved.empty()) << angle;
        EXPECT_TRUE(says(solution, "dead point")) << reasons(solution);
        EXPECT_EQ(solution.mobility.driven, 0);
        expect_no_nonsense(solution);
    }
}

TEST(NoAnswer, TheCrankDrivesThroughTheSamePosition) {
    for (const char* angle : {"0", "23.7", "101.3"}) {
        Sketch s = slider_crank_stretched(angle);
        s.spin("2", "4", "1");
        const Solution solution = solved(s.mechanism);
        EXPECT_TRUE(solution.unsolved.empty()) << reasons(solution);
        ASSERT_FALSE(solution.points.empty());
        for (const PointMotion& point : solution.points) {
            ASSERT_TRUE(point.velocity) << point.label;
            EXPECT_EQ(length(*point.velocity) < 1e-25, point.label != "A") << point.label;
        }
        expect_no_nonsense(solution);
    }
}

/// A four-bar whose crank and coupler are stretched out on a line at 33.3°: its rocker is at the end of its swing.
Sketch rocker_at_its_end() {
    Sketch s;
    s.point("O2", "0", "0").polar("A", "O2", "0.04", "33.3").polar("B", "A", "0.15", "33.3").point("O4", "0.17", "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    return s;
}

TEST(NoAnswer, ARockerCannotDriveFromTheEndOfItsSwing) {
    Sketch s = rocker_at_its_end();
    s.spin("4", "2", "1");
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "dead point")) << reasons(solution);
    expect_no_nonsense(solution);
}

TEST(NoAnswer, ARockerThatIsToldToRestAtTheEndOfItsSwingLeavesTheCrankFree) {
    Sketch s = rocker_at_its_end();
    s.spin("4", "0");
    const Solution solution = solved(s.mechanism);
    EXPECT_FALSE(solution.unsolved.empty());
    EXPECT_FALSE(solution.bodies[1].omega) << "the crank may turn or not";
    expect_no_nonsense(solution);
}

Sketch four_bar_with_a_third_leg() {
    Sketch s;
    s.point("O2", "0", "0").point("A", "0.02", "0.03").point("B", "0.12", "0.09").point("O4", "0.15", "0");
    s.point("C", "0.08", "0.1").point("O6", "0.06", "-0.01");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    s.revolute("C", {"3", "5"}).revolute("O6", {"1", "5"});
    return s;
}

TEST(NoAnswer, ALockedMechanismIsCalledSo) {
    Sketch s = four_bar_with_a_third_leg();
    s.spin("2", "5");
    const Solution solution = solved(s.mechanism);
    EXPECT_EQ(solution.mobility.gruebler, 0);
    EXPECT_EQ(solution.mobility.effective, 0);
    EXPECT_TRUE(says(solution, "locked")) << reasons(solution);
    expect_no_nonsense(solution);
}

TEST(NoAnswer, WithoutDriversNothingIsFreeOfReasons) {
    Sketch s = rocker_at_its_end();
    s.mechanism.find.stated = s.mechanism.find.velocity = true;
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "drive")) << reasons(solution);
    expect_no_nonsense(solution);
}

TEST(NoAnswer, OneDriverOfTwoFreedomsIsTooFew) {
    Sketch s;
    s.point("O", "0", "0").point("A", "0.3", "0.1").point("B", "0.5", "0.4");
    s.revolute("O", {"1", "2"}).revolute("A", {"2", "3"});
    s.mechanism.bodies[2].points.push_back(s["B"]);
    s.spin("2", "1");
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "2 freedoms")) << reasons(solution);
    EXPECT_TRUE(solution.bodies[1].omega);
    EXPECT_FALSE(solution.bodies[2].omega);
    expect_no_nonsense(solution);
}

Sketch exact_parallelogram() {
    Sketch s;
    s.point("O2", "0", "0").point("A", "0.03", "0.04").point("B", "0.15", "0.04").point("O4", "0.12", "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    return s;
}

TEST(Drivers, RepeatedInAgreementAreNoFault) {
    Sketch s = exact_parallelogram();
    s.spin("2", "5", "2").spin("4", "5", "2");
    const Solution solution = solved(s.mechanism);
    EXPECT_EQ(solution.mobility.idle_drivers, std::vector<int>{1});
    EXPECT_TRUE(solution.unsolved.empty()) << reasons(solution);
}

TEST(Drivers, ThatContradictInSpeedAreNamed) {
    Sketch s = exact_parallelogram();
    s.spin("2", "5", "2").spin("4", "6", "2");
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "driver of body 4")) << reasons(solution);
    expect_no_nonsense(solution);
}

TEST(Drivers, ThatContradictInAccelerationAreNamed) {
    Sketch s = exact_parallelogram();
    s.spin("2", "5", "2").spin("4", "5", "3");
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "driver of body 4")) << reasons(solution);
}

TEST(Drivers, OfASlideRepeatedInAgreementAreNoFault) {
    Sketch s;
    s.point("P", "0", "0").prismatic("P", {"2", "1"}, {at("3", "4")});
    s.slide(0, "5", "2");
    s.mechanism.drivers.emplace_back(PointDriver{BodyIndex(1), s["P"], {at("3", "4")}, 5, 2, "/drivers/1"});
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(solution.unsolved.empty()) << reasons(solution);
}

TEST(Drivers, OfASlideThatContradictAreNamed) {
    Sketch s;
    s.point("P", "0", "0").prismatic("P", {"2", "1"}, {at("3", "4")});
    s.slide(0, "5", "2");
    s.mechanism.drivers.emplace_back(PointDriver{BodyIndex(1), s["P"], {at("3", "4")}, 4, 2, "/drivers/1"});
    const Solution solution = solved(s.mechanism);
    EXPECT_TRUE(says(solution, "driver of body 2")) << reasons(solution);
    expect_no_nonsense(solution);
}

TEST(Redundant, TripleParallelCrankMovesAndIsRemarked) {
    Sketch s = exact_parallelogram();
    s.point("C", "0.09", "0.04").point("O5", "0.06", "0");
    s.revolute("C", {"3", "5"}).revolute("O5", {"1", "5"});
    s.spin("2", "5", "-1");
    const Solution solution = solved(s.mechanism);
    EXPECT_EQ(solution.mobility.gruebler, 0);
    EXPECT_EQ(solution.mobility.effective, 1);
    EXPECT_TRUE(solution.unsolved.empty()) << reasons(solution);
    ASSERT_EQ(solution.remarks.size(), 1u);
    for (const int turning : {1, 3, 4}) EXPECT_EQ(*solution.bodies[index(turning)].omega, 5);
    EXPECT_TRUE(solution.bodies[2].omega->is_zero());
    for (const CheckRow& row : solution.checks)
        EXPECT_NEAR(row.difference, 0, 1e-12) << name_of(row.quantity, solution);
}

}  // namespace
}  // namespace kinegraph::laws_test
