// WorkedArithmetic: the arithmetic beside the sentences comes out, and nothing is said of what vanishes.
#include "constructions/verdicts/verdicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "lang/keys/sentences.hpp"
#include "render/scene/polygon_scene.hpp"
#include "render/scene/sentences.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace worked_arithmetic_test {
namespace {

using namespace kinegraph;
using tests::example;

/// All that an example says of one kind, with its numbers.
std::string said(const Solution& solution, Key sentence) {
    std::string text;
    for (const Statement& statement : solution.protocol.statements)
        if (statement.message.sentence == sentence)
            text += render::plain(render::say(statement.message, Language::en)) + "\n";
    return text;
}
bool has(const std::string& text, std::string words) {
    for (std::size_t at = 0; (at = words.find('~', at)) != std::string::npos;) words.replace(at, 1, "\u00a0");
    return text.find(words) != std::string::npos;
}

TEST(WorkedArithmetic, ComeOutInEveryExample) {
    int multiplied = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = example(name);
        for (const Statement& statement : solution.protocol.statements)
            for (const Working& working : statement.message.worked_arithmetic) {
                EXPECT_TRUE(std::isfinite(working.result.value)) << name << ' ' << name_of(working.of);
                if (working.factors.empty()) continue;
                ++multiplied;
                double product = 1;
                for (const Working::Factor& each : working.factors)
                    product *= each.squared ? each.value * each.value : each.value;
                if (working.divisor) product /= *working.divisor;
                if (!working.summands.empty()) product = 0;
                for (std::size_t i = 0; i < working.summands.size(); ++i)
                    product += working.factors[i].value * working.summands[i];
                EXPECT_NEAR(product, working.result.value, 1e-9 * std::abs(product))
                    << name << ' ' << name_of(working.of);
            }
    }
    EXPECT_GT(multiplied, 100);
}

/// An inertia in kg mm² is told in kg m², so that no power of ten divides; an angular velocity in the file's unit as
/// well.
TEST(WorkedArithmetic, UnitsOfTheFileAreBridged) {
    const Solution solution = tests::solved(R"({"kinegraph": 1,
        "units": {"length": "mm", "moment": "N m", "inertia": "kg mm²", "angular velocity": "rpm"},
        "points": {"O": [0, 0], "A": [30, 40], "B": [230, 40]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "frame": 1, "drivers": [{"body": 2, "omega": "300 rpm"}],
        "masses": {"3": {"mass": "1 kg", "centre": "A", "inertia": "4000 kg mm²"}}, "inertia forces": true,
        "effort": {"couple": "M", "body": 2}, "find": ["velocity", "acceleration", "forces"]})");
    const std::string couple = said(solution, lang::sentences::inertia_couple),
                      turning = said(solution, lang::sentences::omega_from_pair);
    EXPECT_TRUE(has(couple, "M_i~=~−0.004~·~")) << couple;
    EXPECT_TRUE(has(said(solution, lang::sentences::crank_velocity), "ω_2~=~300~rpm =~31.4~rad/s")) << turning;
    EXPECT_TRUE(has(turning, "rad/s =~−45.0~rpm")) << turning;
}

/// M = ΣF·b in the units of the file's forces and lengths, and F = M/b of the same number; across parallel bars F
/// alone.
TEST(WorkedArithmetic, MomentsOfCutsAreSumsOfForcesTimesArms) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "units": {"length": "m", "force": "kN"},
        "points": {"A": [0, 0], "B": [3, 0], "C": [6, 0], "D": [3, 4], "E": [6, 4], "F": [9, 0]},
        "bodies": {"1": ["A", "B"], "2": ["B", "C"], "3": ["C", "F"], "4": ["A", "D"], "5": ["D", "B"], "6": ["D", "C"],
                   "7": ["D", "E"], "8": ["E", "C"], "9": ["E", "F"]},
        "joints": [{"revolute": "A", "bodies": [0, 1, 4]}, {"revolute": "B", "bodies": [1, 2, 5]},
                   {"revolute": "C", "bodies": [2, 3, 6, 8]}, {"revolute": "D", "bodies": [4, 5, 6, 7]},
                   {"revolute": "E", "bodies": [7, 8, 9]}, {"revolute": "F", "bodies": [3, 9]},
                   {"contact": "F", "name": "roller", "bodies": [9, 0], "tangent": 0}],
        "loads": [{"force": "P", "pin": "B", "magnitude": "30 kN", "along": -90},
                  {"force": "Q", "pin": "E", "magnitude": "20 kN", "along": 0}],
        "find": ["forces", {"cut": ["DE", "CD", "BC"]}]})");
    const std::string about = said(solution, lang::sentences::truss_cut_moment),
                      across = said(solution, lang::sentences::truss_cut_across);
    EXPECT_TRUE(has(about, "M_C~=~−20~·~4 +~18.89~·~3 =~−23.3~kN~m; F_DE~=~23.33/4 =~5.83~kN.")) << about;
    EXPECT_TRUE(has(about, "M_D~=~18.89~·~6 =~113~kN~m; F_BC~=~113.3/4 =~28.3~kN.")) << about;
    EXPECT_TRUE(has(across, "F_CD~=~−18.89/0.8 =~−23.6~kN.")) << across;
}

/// Neither is a divisor written with a power of ten parted from it, nor a product with one broken over a line.
TEST(WorkedArithmetic, APowerOfTenIsReadWithItsNumber) {
    const Message message{lang::sentences::no_force, {}, {{{Symbol::Letter::M, "C", {}}, {{3}}, 2e6, {1.5e-6, "N m"}}}};
    const std::string words = render::plain(render::say(message, Language::en));
    EXPECT_TRUE(has(words, "M_C~=~3/(2~×~10^6) =~1.50~×~10^−6~N~m")) << words;
}

/// What is said to be turned, and with which ω, gives the term: 2 ω × v_rel.
TEST(WorkedArithmetic, ACoriolisTermHasTheDirectionThatIsTold) {
    int told = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = example(name);
        const Protocol& protocol = solution.protocol;
        const auto vector_named = [&](const Symbol& symbol) {
            const auto drawn = std::find_if(protocol.vectors.begin(), protocol.vectors.end(),
                                            [&](const DrawnVector& vector) { return vector.symbol == symbol; });
            return drawn == protocol.vectors.end() ? Vector{} : protocol.value_of(*drawn);
        };
        for (const Statement& statement : protocol.statements)
            for (const Working& working : statement.message.worked_arithmetic) {
                if (!working.turned) continue;
                SCOPED_TRACE(name + " " + name_of(working.of));
                const Vector velocity = vector_named(working.turned->velocity), coriolis = vector_named(working.of);
                const auto body = solution.mechanism.body_named(working.turned->with.about);
                ASSERT_TRUE(body);
                const Exact twice = Exact(2) * *solution.bodies.at(at_index(*body)).omega;
                EXPECT_EQ(coriolis.x, -twice * velocity.y);
                EXPECT_EQ(coriolis.y, twice * velocity.x);
                ++told;
            }
    }
    EXPECT_GT(told, 5);
}

TEST(WorkedArithmetic, OfTheFourBarAreThoseOfTheBlackboard) {
    const Solution& solution = example("four_bar");  // ω = −120 rpm, O2A 40 mm, AB 150 mm, O4B 80 mm
    EXPECT_TRUE(has(said(solution, lang::sentences::crank_velocity), "v_A~=~12.57~·~0.04 =~0.503~m/s"));
    EXPECT_TRUE(has(said(solution, lang::sentences::crank_acceleration), "a_A^n~=~12.57²~·~0.04 =~6.32~m/s^2") ||
                has(said(solution, lang::sentences::crank_acceleration), "a_A^n~=~12.57^2~·~0.04 =~6.32~m/s^2"))
        << said(solution, lang::sentences::crank_acceleration);
    EXPECT_TRUE(has(said(solution, lang::sentences::omega_from_pair), "ω_3~=~0.1963/0.15 =~1.31~rad/s"));
    EXPECT_TRUE(has(said(solution, lang::sentences::omega_from_pair), "ω_4~=~−0.3828/0.08 =~−4.78~rad/s"));
    // P_12 P_24 : P_14 P_24 = 92.2 mm : 242.2 mm, both on one side of P_24.
    EXPECT_TRUE(has(said(solution, lang::sentences::second_way), "ω_4~=~−12.57~·~92.23/242.2 =~−4.78~rad/s"))
        << said(solution, lang::sentences::second_way);
}

TEST(WorkedArithmetic, AUniformCrankHasNoTangentialPart) {
    EXPECT_FALSE(has(said(example("four_bar"), lang::sentences::crank_acceleration), "tangential"));
}

TEST(WorkedArithmetic, ABodyThatTranslatesHasNoOmegaSquared) {
    int images = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = example(name);
        for (const Statement& statement : solution.protocol.statements) {
            if (statement.message.sentence != lang::sentences::image_acceleration) continue;
            const auto& body = std::get<BodyName>(statement.message.arguments[1]);
            const BodyMotion& motion = solution.bodies.at(at_index(*solution.mechanism.body_named(body.name)));
            EXPECT_FALSE(motion.omega->is_zero()) << name << ": " << english(statement.message);
            ++images;
        }
    }
    EXPECT_GT(images, 0);
}

TEST(WorkedArithmetic, ATriangleIsOfThreeForces) {
    const Solution& solution = example("exam_2001");  // body 5: weight, inertia, the rod's force and the guide's
    EXPECT_TRUE(has(said(solution, lang::sentences::polygon_at), "body 5"));
    EXPECT_FALSE(has(said(solution, lang::sentences::triangle), "body 5"));
    EXPECT_FALSE(has(said(solution, lang::sentences::triangle_at), "body 5"));
}

TEST(WorkedArithmetic, TheInertiaForceIsAStep) {
    const Solution& solution = example("exam_2001");
    EXPECT_TRUE(has(said(solution, lang::sentences::inertia_force), "10~·~1.468 =~14.7~N"))
        << said(solution, lang::sentences::inertia_force);
}

// Area and centroid of a trapezium; the forces' resultant, and by how much a couple moves it aside.
TEST(WorkedArithmetic, ADistributedLoadAndACoupleHaveTheirNumbers) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "units": {"length": "m", "force": "kN", "moment": "kN m"},
        "frame": 0, "points": {"A": [0, 0], "C": [2, 0], "B": [6, 0], "D": [8, 0]}, "bodies": {"1": ["A", "C", "B",
        "D"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"contact": "B", "bodies": [1, 0], "tangent": 20}],
        "loads": [{"distributed": "q", "body": 1, "from": "C", "to": "D", "intensity": ["4 kN/m", "10 kN/m"],
        "along": -90},
                  {"couple": "m", "body": 1, "value": 12},
                  {"force": "P", "body": 1, "at": "D", "magnitude": 5, "along": -120}]})");
    const std::string load = said(solution, lang::sentences::distributed_load);
    EXPECT_TRUE(has(load, "7~·~6 =~42.0~kN") && has(load, "x~=~3.43~m")) << load;  // 6·(4 + 2·10)/(3·14)
    EXPECT_TRUE(has(said(solution, lang::sentences::known_resultant), "F_q, F_P"))
        << said(solution, lang::sentences::known_resultant);
    const std::string moved = said(solution, lang::sentences::inertia_moved);
    EXPECT_TRUE(has(moved, "12/46.4 =~0.259~m")) << moved;  // |(0, −42) + 5(cos 240°, sin 240°)| = 46.4
}

// M and F stand as they are told, so that d has the unit of their quotient; then that of the file.
TEST(WorkedArithmetic, AForceMovedAsideIsToldInTheUnitsOfTheFile) {
    const auto moved = [](const std::string& units, const std::string& couple) {
        return said(tests::solved(R"({"kinegraph": 1, "units": )" + units + R"(,
            "frame": 0, "points": {"A": [0, 0], "C": [2, 0], "B": [6, 0], "D": [8, 0]}, "bodies": {"1": ["A", "C",
            "B", "D"]},
            "joints": [{"revolute": "A", "bodies": [0, 1]}, {"contact": "B", "bodies": [1, 0], "tangent": 20}],
            "loads": [{"force": "Q", "body": 1, "at": "C", "magnitude": 40, "along": -90},
                      {"force": "P", "body": 1, "at": "D", "magnitude": 30, "along": 0},
                      {"couple": "m", "body": 1, "value": )" +
                                  couple + R"(}]})"),
                    lang::sentences::inertia_moved);
    };
    const std::string in_mm = moved(R"({"length": "mm", "force": "N", "moment": "N mm"})", "20");
    EXPECT_TRUE(has(in_mm, "20/50 =~0.400~mm.")) << in_mm;
    const std::string of_metres = moved(R"({"length": "mm", "force": "N", "moment": "N m"})", "2");
    EXPECT_TRUE(has(of_metres, "2/50 =~0.0400~m =~40.0~mm.")) << of_metres;
    const std::string of_kilonewtons = moved(R"({"length": "mm", "force": "kN", "moment": "N m"})", "20");
    EXPECT_TRUE(has(of_kilonewtons, "20/50 =~0.400~mm.")) << of_kilonewtons;
    const std::string of_feet = moved(R"({"length": "in", "force": "lbf", "moment": "lbf ft"})", "20");
    EXPECT_TRUE(has(of_feet, "20/50 =~0.400~ft =~4.80~in.")) << of_feet;
}

// A body whose ω a driver gives relative to another has no polygon yet: the first link of its image is set off, and
// closes it.
TEST(WorkedArithmetic, TheFirstLinkOfAnImageIsDrawnAndValued) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 300, "angle": 40},
                   "B": {"from": "A", "distance": 200, "angle": -30, "relative to": ["O", "A"]},
                   "C": {"from": "A", "to": "B", "ratio": 2}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "C"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}],
        "drivers": [{"body": 2, "omega": 1.2}, {"body": 3, "relative to": 2, "omega": 2, "alpha": -0.5}]})");
    const std::string velocity = said(solution, lang::sentences::image_velocity);
    EXPECT_TRUE(has(velocity, "3.2~·~0.2 =~0.640~m/s")) << velocity;
    EXPECT_FALSE(has(velocity, "v_CA")) << "later points follow by similar figures: " << velocity;
    const std::string acceleration = said(solution, lang::sentences::image_acceleration);
    EXPECT_TRUE(has(acceleration, "3.2^2~·~0.2 =~2.05~m/s")) << acceleration;
    EXPECT_TRUE(has(acceleration, "0.5~·~0.2 =~0.100~m/s")) << acceleration;
    const auto drawn = [&](const char* name) {
        return std::count_if(solution.protocol.vectors.begin(), solution.protocol.vectors.end(),
                             [&](const DrawnVector& vector) { return name_of(vector.symbol) == name; });
    };
    for (const char* name : {"v_BA", "a_BA_n", "a_BA_t"}) EXPECT_EQ(drawn(name), 1) << name;
}

TEST(WorkedArithmetic, AnAuxiliaryPointHasItsPlaceAndItsLever) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm", "velocity": "mm/s"},
        "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 80, "angle": 70}, "O4": [150, 20],
                   "B": {"meet": [{"circle": "A", "radius": 120}, {"circle": "O4", "radius": 100}], "near": [180, 140]},
                   "P": {"from": "A", "to": "B", "ratio": 0.4}},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B", "P"], "4": ["O4", "B"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 3, "at": "P", "along": [-3, 1], "speed": "250 mm/s"}]})");
    const std::string place = said(solution, lang::sentences::auxiliary_point);
    EXPECT_TRUE(has(place, "⟂~O_2A") && has(place, "⟂~O_4B") && has(place, "x~=~117~mm, y~=~320~mm")) << place;
    const std::string turning = said(solution, lang::sentences::omega_from_pair);
    EXPECT_TRUE(has(turning, "252.1/231.6")) << turning;  // v_PS by PS
}

/// F = M/h of a couple, ΣM/h of several.
TEST(WorkedArithmetic, ParallelForcesHaveTheirMomentAndArm) {
    const auto told = [](const std::string& loads) {
        return said(tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
            "points": {"O": [0, 0], "P": [100, 0], "B": [250, 0], "C": [250, 90]}, "bodies": {"2": ["O", "P", "B"],
            "3": ["B", "C"]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "B", "bodies": [2, 3]}, {"revolute": "C",
            "bodies": [1, 3]}],
            "loads": [)" + loads + "]}"),
                    lang::sentences::parallel_forces);
    };
    const std::string couple = R"({"couple": "Q", "body": 2, "value": -12})",
                      force = R"({"force": "P", "body": 2, "at": "P", "magnitude": 20, "along": -90})";
    EXPECT_TRUE(has(told(couple), "12/0.25 =~48.0~N")) << told(couple);
    const std::string both = told(couple + ", " + force);
    EXPECT_TRUE(has(both, "M_O") && has(both, "14/0.25 =~56.0~N")) << both;
}

// What is moved aside once, with its couple, is not moved again with the resultant.
TEST(WorkedArithmetic, AnInertiaForceIsMovedOnce) {
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 50, "angle": 75}, "O4": [160, 10], "O6": [-40, 190],
                   "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 110}], "side": "left"},
                   "C": {"from": "A", "distance": 110, "angle": 35, "relative to": ["A", "B"]},
                   "D": {"meet": [{"circle": "C", "radius": 130}, {"circle": "O6", "radius": 90}], "side": "left"}},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B", "C"], "4": ["O4", "B"], "5": ["C", "D"], "6": ["O6", "D"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"revolute": "O4", "bodies": [1, 4]}, {"revolute": "C", "bodies": [3, 5]}, {"revolute": "D",
                   "bodies": [5, 6]},
                   {"revolute": "O6", "bodies": [1, 6]}],
        "drivers": [{"body": 2, "omega": 12, "alpha": -30}], "gravity": [0, -9.81], "inertia forces": true,
        "masses": {"3": {"mass": 1.2, "centre": "C", "inertia": "3000 kg mm²"}},
        "loads": [{"couple": "Mr", "body": 6, "value": "-5 N m"}], "effort": {"couple": "Mm", "body": 2}})");
    int moved = 0, added = 0;
    for (const Statement& statement : solution.protocol.statements) {
        if (statement.message.sentence == lang::sentences::inertia_moved) ++moved;
        if (statement.message.sentence != lang::sentences::known_resultant) continue;
        EXPECT_EQ(moved, 1) << "first";
        ++added;
        for (const Argument& argument : statement.message.arguments) {
            const auto* symbols = std::get_if<Symbols>(&argument);
            for (const Symbol& each : symbols != nullptr ? *symbols : Symbols{})
                EXPECT_EQ(each.letter, Symbol::Letter::F) << name_of(each);
        }
    }
    EXPECT_EQ(moved, 1);
    EXPECT_EQ(added, 1);
    EXPECT_TRUE(solution.unsolved.empty());
}

/// Every ✓ of an equation came from a sentence that a brief solution tells.
TEST(WorkedArithmetic, KnownTermsOfEquationsAreToldInBrief) {
    int known = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = example(name);
        const std::vector<Statement>& statements = solution.protocol.statements;
        for (std::size_t which = 0; which < statements.size(); ++which) {
            const Key sentence = statements[which].message.sentence;
            if (sentence != lang::sentences::image_velocity && sentence != lang::sentences::image_acceleration)
                continue;
            const Symbol& found = std::get<Symbol>(statements[which].message.arguments[2]);
            bool is_known_term = false;
            for (const Statement& other : statements)
                if (other.equation)
                    for (const std::vector<Term>& side : other.equation->sides)
                        for (const Term& term : side)
                            is_known_term = is_known_term || (term.symbol == found && term.magnitude_known);
            EXPECT_FALSE(is_known_term && render::is_incidental(statements, which)) << name << ' ' << name_of(found);
            known += is_known_term ? 1 : 0;
        }
    }
    EXPECT_GT(known, 0);
}

TEST(WorkedArithmetic, AnImageTellsTheVelocityThatIsReadOff) {
    const Solution& solution = example("watt_six_bar");
    const std::string text = said(solution, lang::sentences::image_velocity);
    EXPECT_TRUE(has(text, "v_E~=~0.0421~m/s")) << text;
}

// In pounds and inches the mass is divided by g_c = 386.09 lb in/(lbf s²).
TEST(WorkedArithmetic, AnInertiaForceInPoundsIsDividedByTheirConstant) {
    const Solution solution =
        tests::solved(R"({"kinegraph": 1, "units": {"length": "in", "force": "lbf", "moment": "lbf in",
        "mass": "lb", "acceleration": "in/s²"}, "frame": 1, "points": {"O": [0, 0], "A": [10, 0]},
        "bodies": {"2": ["O", "A"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, "omega": 10}],
        "masses": {"2": {"mass": 3, "centre": "A", "inertia": 0}}, "inertia forces": true,
        "effort": {"couple": "M", "body": 2}})");
    const std::string text = said(solution, lang::sentences::inertia_force);
    EXPECT_TRUE(has(text, "3~·~1000/386.1 =~7.77~lbf")) << text;
}

TEST(ImagesOfBodies, AreSimilarToThem) {
    const Solution& solution = example("watt_six_bar");
    int checked = 0;
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const Polygon& polygon = solution.protocol.polygons[p];
        if (polygon.plane == Plane::force || polygon.kind != Polygon::Kind::motion) continue;
        for (const render::SceneFace& face : render::polygon_scene(solution, static_cast<int>(p)).faces) {
            std::vector<Vector> places;
            for (const PointMotion& point : solution.points)
                if (std::count(point.bodies.begin(), point.bodies.end(), face.body) > 0)
                    places.push_back(solution.pose.at(point.point));
            ASSERT_EQ(places.size(), face.corners.size());
            const auto ratio = [&](std::size_t i, std::size_t j) {
                const auto &a = face.corners[i], &b = face.corners[j];
                return std::hypot(a.x - b.x, a.y - b.y) / length(places[i] - places[j]);
            };
            for (std::size_t i = 2; i < places.size(); ++i) {
                EXPECT_NEAR(ratio(0, i), ratio(0, 1), 1e-9 * ratio(0, 1));
                EXPECT_NEAR(ratio(1, i), ratio(0, 1), 1e-9 * ratio(0, 1));
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 1);
}

}  // namespace
}  // namespace worked_arithmetic_test
