// Curvature: closed forms, what holds for any motion, what is left unchanged when the drawing is moved, turned,
// mirrored, scaled, and what has no curvature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/results/quantity_name.hpp"
#include "engine/results/results.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::curvature_test {
namespace {

using tests::solved;
using Kind = Curvature::Kind;

const Curvature& of_body(const Solution& solution, const char* name) {
    for (const Curvature& found : solution.curvature)
        if (solution.mechanism.body(found.body).name == name) return found;
    throw std::out_of_range(std::string("no curvature of body ") + name);
}
const PathCentre& path_of(const Solution& solution, const char* body, const char* point) {
    for (const PathCentre& path : of_body(solution, body).points)
        if (solution.mechanism.point(path.point).name == point) return path;
    throw std::out_of_range(std::string("no path of ") + point);
}
Exact squared_radius(const Solution& solution, const PathCentre& path) {
    return squared_length(path.centre->place() - solution.pose.at(path.point));
}

/// A trammel of length 1 at 3-4-5: A and B on the axes, pole (4/5, 3/5). C lies on the circle about the rod's middle
/// through both.
std::string trammel(const std::string& more_points = "", const std::string& more_names = "") {
    return R"({"kinegraph": 1, "frame": 1, "points": {"A": [0.8, 0], "B": [0, 0.6], "M": [0.4, 0.3], "C": [0.7,
    -0.1])" +
           more_points + R"(}, "bodies": {"2": ["A"], "3": ["A", "B", "M", "C")" + more_names + R"(], "4": ["B"]},
        "joints": [{"prismatic": "A", "bodies": [2, 1], "along": 0}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 90}],
        "drivers": [{"joint": "A", "speed": 1}], "find": ["curvature"]})";
}

TEST(Curvature, OfATrammelHasCardansCircle) {
    const Solution solution = solved(trammel(R"(, "P": [0.8, 0.6])", R"(, "P")"));
    const Curvature& rod = of_body(solution, "3");
    ASSERT_EQ(rod.kind, Kind::general);
    EXPECT_EQ(rod.pole->place(), (Vector{Exact::ratio(4, 5), Exact::ratio(3, 5)}));
    EXPECT_EQ(*rod.inflection_pole, (Vector{0, 0}))
        << "the moving centrode has the guides' meet on it, a diameter away";
    EXPECT_EQ(*rod.inflection_centre, (Vector{Exact::ratio(2, 5), Exact::ratio(3, 10)}));
    EXPECT_EQ(rod.rays.size(), 2U) << "by Bobillier, both centres at infinity";
    for (const char* straight : {"A", "B", "C"})
        EXPECT_TRUE(path_of(solution, "3", straight).centre->at_infinity()) << straight << " goes on a straight line";
    const PathCentre& middle = path_of(solution, "3", "M");
    EXPECT_EQ(middle.centre->place(), (Vector{0, 0})) << "on a circle about the guides' meet";
    EXPECT_EQ(squared_radius(solution, middle), Exact::ratio(1, 4));
    EXPECT_FALSE(path_of(solution, "3", "P").centre) << "it lies in the pole";
    EXPECT_EQ(of_body(solution, "2").kind, Kind::translation);
    EXPECT_TRUE(path_of(solution, "2", "A").centre->at_infinity());
    EXPECT_TRUE(solution.unsolved.empty());
}

TEST(Curvature, OfASliderCrankFollowsItsClosedForm) {
    // Crank at right angles to the rod's pole ray: crank 3, rod 5, crank upright: A (0, 3), B (4, 0), pole (4, ∞)? So
    // at 3-4-5.
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [3, 4], "B": [15, 0], "M": [9, 2]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "M"], "4": ["B"]}, "joints": [{"revolute": "O", "bodies": [1, 2]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4,
        1], "along": 0}],
        "drivers": [{"body": 2, "omega": 1}], "find": ["curvature"]})");
    const Curvature& rod = of_body(solution, "3");
    // The pole above B on the crank's line; A's foot on the inflection circle at AW = AP²/AO (Euler and Savary).
    EXPECT_EQ(rod.pole->place(), (Vector{15, 20}));
    const Vector a{3, 4}, to_pole{12, 16};
    const Exact share = Exact(4);  // AP/OA, away from O
    const Vector foot = a - share * to_pole;
    // J: level with B, and over the foot across the ray: (J − W)·(3, 4) = 0, J.y = 0.
    const Exact x = (foot.x * Exact(3) + foot.y * Exact(4)) / Exact(3);
    EXPECT_EQ(*rod.inflection_pole, (Vector{x, 0}));
    EXPECT_EQ(path_of(solution, "3", "A").centre->place(), (Vector{0, 0}));
    EXPECT_TRUE(path_of(solution, "3", "B").centre->at_infinity());
}

/// What holds of any body: the circle passes the pole, the acceleration pole lies on it, conjugate points obey Euler
/// and Savary, and the accelerations, of which Bobillier's construction knows nothing, confirm the inflection pole: a_P
/// = ω² PJ.
void expect_laws(const Solution& solution, const std::string& trace) {
    for (const Curvature& found : solution.curvature) {
        if (found.kind != Kind::general) continue;
        const Vector pole = found.pole->place();
        const Vector diameter = *found.inflection_pole - pole;
        const double size = solution.pose.exact ? 0 : 1e-20 * length(diameter);
        const auto vanishes = [&](const Exact& value, double unit) {
            return solution.pose.exact ? value.is_zero() : std::abs(value.to_double()) <= 1e-20 * unit;
        };
        const Vector to_acceleration = *found.acceleration_pole - pole;
        EXPECT_TRUE(vanishes(dot(to_acceleration, to_acceleration - diameter), squared_length(diameter).to_double()))
            << trace << ": the acceleration pole is on the inflection circle, " << size;
        for (const PathCentre& path : found.points) {
            if (!path.centre || path.centre->at_infinity() || !path.foot) continue;
            const Vector at = solution.pose.at(path.point);
            const Vector to_pole = pole - at, to_centre = path.centre->place() - at, to_foot = path.foot->place() - at;
            const double unit = squared_length(to_pole).to_double() + length(to_centre) * length(to_foot);
            EXPECT_TRUE(vanishes(squared_length(to_pole) - dot(to_centre, to_foot), unit)) << trace << ": PC² = CC₀·CW";
            EXPECT_TRUE(vanishes(cross(to_pole, to_centre), unit)) << trace << ": the ray passes the pole";
        }
    }
}

TEST(Curvature, OfRandomMechanismsObeysItsLawsAndTheCheck) {
    int bobillier = 0, held = 0;
    for (std::uint64_t seed = 1; seed <= unless_sanitized(150, 25); ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        auto mechanism = read_mechanism(random.text, "seed " + std::to_string(seed));
        ASSERT_TRUE(mechanism);
        mechanism->find = {};
        mechanism->find.stated = mechanism->find.curvature = true;
        const auto solution = solve(*std::move(mechanism));
        ASSERT_TRUE(solution);
        const std::string trace = "seed " + std::to_string(seed) + " (" + random.recipe + ")";
        expect_laws(*solution, trace);
        for (const Curvature& found : solution->curvature) bobillier += found.rays.empty() ? 0 : 1;
        for (const CheckRow& row : solution->checks) {
            if (row.quantity.kind != Quantity::Kind::radius && row.quantity.kind != Quantity::Kind::inflection_diameter)
                continue;
            ++held;
            // v²/a_n of the check loses what a_n is small beside a.
            const double size = std::max(std::abs(row.numeric), solution->pose.size.to_double());
            const double amplified = std::max(1.0, std::abs(row.numeric) / solution->pose.size.to_double());
            EXPECT_LE(std::abs(row.difference), 1e-9 * size * amplified)
                << trace << ": " << name_of(row.quantity, *solution);
        }
    }
    EXPECT_GT(bobillier, 20) << "most couplers have two known paths";
    EXPECT_GT(held, 300);
}

/// A four-bar of rational places (crank (3, 4), coupler (12, 5) long), its drawing mapped: z ↦ m·z + t, mirrored
/// before.
struct Map {
    Vector turn{1, 0};
    bool mirrors = false;
    Vector move{};

    Vector of(const Vector& v) const {
        const Vector at = mirrors ? Vector{v.x, -v.y} : v;
        return Vector{turn.x * at.x - turn.y * at.y, turn.x * at.y + turn.y * at.x} + move;
    }
};
std::string decimal(const Exact& value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10f", value.to_double());
    return text;
}
Solution four_bar(const Map& map) {
    const auto at = [&](int x, int y) {
        const Vector place = map.of({x, y});
        return "[" + decimal(place.x) + ", " + decimal(place.y) + "]";
    };
    return solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": )" + at(0, 0) + R"(, "Q": )" + at(14, 0) +
                  R"(, "A": )" + at(3, 4) + R"(, "B": )" + at(15, 9) + R"(, "C": )" + at(7, 11) +
                  R"(}, "bodies": {"2": ["O", "A"], "3": ["A", "B", "C"], "4": ["Q", "B"]}, "joints": [{"revolute": "O",
        "bodies": [1, 2]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": )" +
                  (map.mirrors ? "-2" : "2") + R"(, "alpha": )" + (map.mirrors ? "-3" : "3") +
                  R"(}], "find": ["curvature"]})");
}

TEST(Curvature, GoesWithTheDrawing) {
    const Solution drawn = four_bar({});
    const Curvature& as_drawn = of_body(drawn, "3");
    for (const Map& map :
         {Map{{1, 0}, false, {5, -7}}, Map{{Exact::ratio(3, 5), Exact::ratio(4, 5)}}, Map{{1, 0}, true},
          Map{{Exact::ratio(5, 2), 0}}, Map{{Exact::ratio(-4, 5), Exact::ratio(3, 5)}, true, {1, 2}}}) {
        const Solution mapped = four_bar(map);
        const Curvature& found = of_body(mapped, "3");
        EXPECT_EQ(found.pole->place(), map.of(as_drawn.pole->place()));
        EXPECT_EQ(*found.inflection_pole, map.of(*as_drawn.inflection_pole));
        EXPECT_EQ(*found.tangential_pole, map.of(*as_drawn.tangential_pole));
        EXPECT_EQ(*found.acceleration_pole, map.of(*as_drawn.acceleration_pole));
        EXPECT_EQ(path_of(mapped, "3", "C").centre->place(), map.of(path_of(drawn, "3", "C").centre->place()));
    }
}

TEST(Curvature, DoesNotHangOnTheDriversSpeed) {
    const std::string text = tests::contents(tests::example_file("coupler_curve"));
    std::string slow = text;
    slow.replace(slow.find("\"10 rad/s\""), 10, "\"-1 rad/s\", \"alpha\": 7");
    const Solution a = solved(text), b = solved(slow);
    EXPECT_EQ(path_of(a, "3", "C").centre->place(), path_of(b, "3", "C").centre->place());
    EXPECT_EQ(*of_body(a, "3").inflection_pole, *of_body(b, "3").inflection_pole);
    EXPECT_NE(*of_body(a, "3").acceleration_pole, *of_body(b, "3").acceleration_pole) << "which does";
}

TEST(Curvature, OfWhatTranslatesOrRests) {
    // A parallelogram: all points of the coupler move on circles as large as the cranks'.
    const Solution parallel =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "Q": [9, 0], "A": [3, 4], "B": [12, 4],
        "C": [5, 6]}, "bodies": {"2": ["O", "A"], "3": ["A", "B", "C"], "4": ["Q", "B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": 2}], "find": ["curvature"]})");
    EXPECT_EQ(of_body(parallel, "3").kind, Kind::translation);
    EXPECT_EQ(path_of(parallel, "3", "C").centre->place(), (Vector{2, 2}));
    EXPECT_EQ(path_of(parallel, "3", "A").centre->place(), (Vector{0, 0}));
    const std::string json = results_json(parallel, false, english);
    EXPECT_NE(json.find(R"("3": {"translation": true, "reason": "it translates: its pole is at infinity")"),
              std::string::npos)
        << json;

    const Solution still =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [3, 4]}, "bodies": {"2": ["O", "A"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, "omega": 0}],
        "find": ["curvature"]})");
    EXPECT_EQ(of_body(still, "2").kind, Kind::rest);
    EXPECT_NE(results_json(still, false, english)
                  .find(R"("A": {"radius": null, "reason": "it stands still at this instant"})"),
              std::string::npos);
    EXPECT_TRUE(still.unsolved.empty());
}

TEST(Curvature, OfTwoCranksOnOneHingeIsATurnAboutIt) {
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [3, 4], "B": [4, -3], "C": [6, 2]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "C"], "4": ["O", "B"]}, "joints": [{"revolute": "O",
        "bodies": [1, 2, 4]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}],
        "drivers": [{"body": 2, "omega": 2, "alpha": 1}], "find": ["curvature"]})");
    EXPECT_EQ(of_body(solution, "3").kind, Kind::turning);
    EXPECT_EQ(path_of(solution, "3", "C").centre->place(), (Vector{0, 0}));
}

TEST(Curvature, OfAWheelOnARailIsTheCycloids) {
    // ρ = 2·PC for a point of the rim at any place; the inflection circle has the radius's diameter; the rail's contact
    // is the pole.
    const Solution wheel =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"P": [0, 0], "M": [0, 5], "C": [3, 9], "T": [0, 10]},
        "bodies": {"2": {"points": ["M", "C", "T"], "circle": {"centre": "M", "radius": 5}}},
        "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": 0}}}],
        "drivers": [{"body": 2, "omega": -2, "alpha": 1}], "find": ["curvature"]})");
    const Curvature& found = of_body(wheel, "2");
    EXPECT_EQ(found.pole->place(), (Vector{0, 0}));
    EXPECT_EQ(*found.inflection_pole, (Vector{0, 5}));
    EXPECT_TRUE(path_of(wheel, "2", "M").centre->at_infinity());
    EXPECT_EQ(squared_radius(wheel, path_of(wheel, "2", "C")), Exact(4 * 90));
    EXPECT_EQ(squared_radius(wheel, path_of(wheel, "2", "T")), Exact(4 * 100));
}

TEST(Curvature, OfALineIsThatOfItsEnvelope) {
    // The trammel's rod as a guide: it envelops an astroid, of radius 3·l·sin·cos at its touching point.
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0.8, 0], "B": [0, 0.6], "M": [0.4, 0.3]},
        "bodies": {"2": ["A"], "3": ["A", "B", "M"], "4": ["B"], "5": ["M"]}, "joints": [{"prismatic": "A",
        "bodies": [2, 1], "along": 0},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4,
        1], "along": 90},
        {"prismatic": "M", "bodies": [5, 3], "along": ["A", "B"]}],
        "drivers": [{"joint": "A", "speed": 1}, {"joint": "M", "speed": 2}], "find": ["curvature"]})");
    const Curvature& rod = of_body(solution, "3");
    ASSERT_EQ(rod.envelopes.size(), 1U);
    const Vector radius = *rod.envelopes[0].centre - *rod.envelopes[0].touches;
    EXPECT_EQ(squared_length(radius), Exact::ratio(36 * 36, 625)) << "3 · 4/5 · 3/5";
}

TEST(Curvature, IsWrittenAsTheFormatSays) {
    const Solution& solution = tests::example("coupler_curve");
    const std::string json = results_json(solution, false, english);
    for (const char* key :
         {R"("curvature": {)", R"("3": {"pole": [)", R"("pole tangent": [)", R"("inflection circle": {"centre": [)",
          R"("diameter": )", R"("acceleration pole": [)", R"("points": {"A": {"centre": [)", R"("radius": )"})
        EXPECT_NE(json.find(key), std::string::npos) << key << "\n" << json;
    ASSERT_FALSE(of_body(solution, "3").points.empty());
    for (const PathCentre& path : of_body(solution, "3").points)
        EXPECT_TRUE(path.is_pin || path.statement != none) << path.label << " comes with its sentence";
}

}  // namespace
}  // namespace kinegraph::curvature_test
