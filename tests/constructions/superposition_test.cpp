// Loads that no order of bodies resolves at once, drawn one after the other, and what spares it: a guide whose reaction
// passes a pin. What is added up on the way, Culmann's diagonal, arms and strings are on the sheet, wherever a sentence
// speaks of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "lang/keys/sentences.hpp"
#include "render/scene/load_case.hpp"
#include "render/sheet/sheet.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/told.hpp"

namespace superposition_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

const Vector& force_on(const Solution& solution, const char* on, const char* from) {
    const Mechanism& mechanism = solution.mechanism;
    for (const JointForce& each : solution.forces)
        if (each.on == mechanism.body_named(on) && each.from == mechanism.body_named(from)) return *each.force;
    throw std::out_of_range(std::string("no force of ") + from + " on " + on);
}
std::vector<Key> sentences_of(const Solution& solution) {
    std::vector<Key> said;
    for (const Statement& statement : solution.protocol.statements)
        if (statement.section == Topic::forces) said.push_back(statement.message.sentence);
    return said;
}
bool says(const Solution& solution, Key sentence) {
    const std::vector<Key> said = sentences_of(solution);
    return std::find(said.begin(), said.end(), sentence) != said.end();
}

// --- the engine: one order of bodies
// -----------------------------------------------------------------------------------------

/// The moments about A of rod and piston give the wall's reaction, their sum the rest: exactly.
TEST(Engine, HasTheForcesOfItsClosedForm) {
    const Solution& solution = example("engine_inertia_gas");
    EXPECT_TRUE(solution.unsolved.empty());
    const Exact mm = Exact::ratio(1, 1000), omega = 300;
    const Vector a{24 * mm, 32 * mm}, rod{126 * mm, Exact(-32) * mm};
    const Exact omega_3 = -(omega * a.x) / rod.x, alpha_3 = (omega * omega * a.y + omega_3 * omega_3 * rod.y) / rod.x;
    const auto acceleration = [&](const Exact& share) {
        return Vector{-(omega * omega * a.x) - share * (alpha_3 * rod.y + omega_3 * omega_3 * rod.x),
                      -(omega * omega * a.y) + share * (alpha_3 * rod.x - omega_3 * omega_3 * rod.y)};
    };
    const Exact share = Exact::ratio(3, 10), m_3 = Exact::ratio(3, 5), m_4 = Exact::ratio(9, 20),
                inertia = Exact::ratio(12, 10000);
    const Vector at_g = acceleration(share);
    const Vector inertia_force{-(m_3 * at_g.x), -(m_3 * at_g.y)};
    const Exact along = Exact(-8000) - m_4 * acceleration(1).x;
    const Exact turning =
        share * (rod.x * inertia_force.y - rod.y * inertia_force.x) - inertia * alpha_3 - rod.y * along;
    const Exact wall = -(turning / rod.x);
    const Vector at_a{-inertia_force.x - along, -inertia_force.y - wall};
    EXPECT_EQ(force_on(solution, "4", "1"), (Vector{0, wall}));
    EXPECT_EQ(force_on(solution, "3", "2"), at_a);
    EXPECT_EQ(*solution.efforts.front().value, a.x * at_a.y - a.y * at_a.x);
    EXPECT_NEAR(wall.to_double(), 1570.618415166520, 1e-9);
    EXPECT_NEAR(solution.efforts.front().value->to_double(), -256.065454208894, 1e-9);
}

TEST(Engine, NeedsNoSuperposition) {
    const Solution& solution = example("engine_inertia_gas");
    EXPECT_FALSE(solution.superposition);
    EXPECT_FALSE(says(solution, lang::sentences::superposition));
    EXPECT_FALSE(says(solution, lang::sentences::moments_give));
    EXPECT_TRUE(says(solution, lang::sentences::through_pin));
    ASSERT_EQ(solution.taken_together.size(), 1U);
    const TakenTogether& together = solution.taken_together.front();
    EXPECT_EQ(names_of(solution.mechanism, together), "3 + 4");
    ASSERT_EQ(together.sums.size(), 1U);
    // Inertia of rod and piston and the gas force, as one.
    const Vector sum = force_on(solution, "4", "1") + force_on(solution, "3", "2");
    EXPECT_EQ(together.sums.front().force, -sum);
}

/// Who asks for forces alone needs the accelerations on the way.
TEST(Engine, HasItsInertiaWhereForcesAloneAreAsked) {
    std::string text = contents(example_file("engine_inertia_gas"));
    text.insert(text.rfind('}'), ", \"find\": [\"forces\"]");
    const Solution solution = solved(text);
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_EQ(force_on(solution, "4", "1"), force_on(example("engine_inertia_gas"), "4", "1"));
}

/// F_i with its couple is F_i alone, moved aside by J α/F.
TEST(Engine, MovesTheInertiaForceAside) {
    const Solution& solution = example("engine_inertia_gas");
    for (const FreeBody& body : solution.free_bodies)
        for (const FreeBody::Arm& arm : body.arms)
            if (arm.is_shift) {
                EXPECT_EQ(solution.mechanism.body(body.body).name, "3");
                EXPECT_NEAR(length(arm.foot - arm.about), 0.015239468854626, 1e-12);
                return;
            }
    ADD_FAILURE() << "no arm moves it";
}

// --- superposition
// -----------------------------------------------------------------------------------------------------------

class Superposed : public testing::TestWithParam<const char*> {};

/// What the loads cause one by one adds up to what they cause together: on every body, exactly.
TEST_P(Superposed, PartsAddUp) {
    const Solution& solution = example(GetParam());
    ASSERT_TRUE(solution.superposition);
    const Superposition& found = *solution.superposition;
    EXPECT_EQ(found.parts.size(), 3U);
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& whole : body.forces) {
            if (!whole.is_reaction()) continue;
            Vector sum;
            for (const Superposition::Part& part : found.parts)
                for (const FreeBody& alone : part.bodies)
                    for (const AppliedForce& share : alone.forces)
                        if (alone.body == body.body && share.joint == whole.joint && share.from == whole.from)
                            sum = sum + share.force;
            EXPECT_EQ(sum, whole.force) << name_of(whole.symbol);
        }
    for (const Superposition::CoupleSum& couple : found.couples) {
        Exact sum = 0;
        for (const Recorded<Exact>& part : couple.parts) sum = sum + *part;
        EXPECT_EQ(sum, *couple.total);
    }
}

/// Each body is in equilibrium under what acts on it alone: its polygon closes, and its moments vanish.
TEST_P(Superposed, EachPartIsInEquilibrium) {
    const Solution& solution = example(GetParam());
    ASSERT_FALSE(solution.superposition->parts.empty());
    for (const Superposition::Part& part : solution.superposition->parts) {
        ASSERT_FALSE(part.bodies.empty());
        for (const FreeBody& body : part.bodies) {
            Vector sum;
            Exact moment = 0;
            for (const AppliedForce& applied : body.forces) {
                sum = sum + applied.force;
                moment = moment + cross(applied.at, applied.force) + applied.couple;
                const bool is_marked = applied.symbol.term == "(" + name_of(solution.mechanism, part) + ")";
                EXPECT_EQ(is_marked, applied.is_reaction() || applied.kind == Quantity::Kind::effort)
                    << name_of(applied.symbol);
            }
            EXPECT_TRUE(sum.is_zero());
            EXPECT_TRUE(moment.is_zero());
        }
    }
}

std::set<std::string> figures_on(const std::vector<Page>& pages) {
    std::set<std::string> figures;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "figure")
                figures.insert(group->id.text());
    return figures;
}

/// The polygon of a body closes with its loads and the sums of its reactions; each sum spans its parts, tip to tail,
/// and there is a part for each load that causes one.
TEST_P(Superposed, JoinsThePartsOfABodyInOnePolygon) {
    const Solution& solution = example(GetParam());
    const Protocol& protocol = solution.protocol;
    const auto is_part = [](const DrawnVector& vector) { return vector.symbol.term.starts_with("("); };
    EXPECT_EQ(solution.superposition->joined.size(), 3U);
    for (const Superposition::Joined& joined : solution.superposition->joined) {
        const Polygon& polygon = protocol.polygons[at_index(joined.polygon)];
        SCOPED_TRACE(polygon.id);
        ElementIndex here = protocol.vectors[at_index(polygon.vectors.front())].tail;
        const ElementIndex start = here;
        Vector outer;
        std::size_t parts = 0, sums = 0;
        ElementIndex begin = none;
        for (const int index : polygon.vectors) {
            const DrawnVector& vector = protocol.vectors[at_index(index)];
            if (is_part(vector) || vector.quantity.kind != Quantity::Kind::force) {
                EXPECT_EQ(vector.tail, here) << name_of(vector.symbol);
                here = vector.tip;
                if (is_part(vector) && begin == none) begin = vector.tail;
                parts += is_part(vector) ? 1 : 0;
            }
            if (is_part(vector)) continue;
            outer = outer + protocol.value_of(vector);
            if (vector.quantity.kind != Quantity::Kind::force) continue;
            EXPECT_EQ(vector.tail, begin) << "a sum begins with its parts: " << name_of(vector.symbol);
            EXPECT_EQ(vector.tip, here) << "and ends with them: " << name_of(vector.symbol);
            begin = none;
            ++sums;
        }
        EXPECT_TRUE(outer.is_zero());
        EXPECT_TRUE((protocol.point(here).place() - protocol.point(start).place()).is_zero());
        EXPECT_GE(sums, 2U);
        EXPECT_GE(parts, 3U);
    }
}

TEST_P(Superposed, HasTheLinesOfEachLoadAndOnePolygonOfEachBody) {
    const std::set<std::string> figures = figures_on(lay_out(example(GetParam()), {}, fonts()));
    for (const char* id : {"lines-load-2", "lines-load-3", "lines-load-4", "parts-2", "parts-3", "parts-4"})
        EXPECT_TRUE(figures.contains(id)) << id;
    for (const char* id : {"forces-3-load-3", "body-3-load-3", "sum-F_12"}) EXPECT_FALSE(figures.contains(id)) << id;
}

TEST_P(Superposed, HasAFigureOfLinesAndOneOfPolygonsForEachLoad) {
    const Solution& solution = example(GetParam());
    SheetOptions options;
    options.superposed = SuperposedLoads::each;
    const std::set<std::string> figures = figures_on(lay_out(solution, options, fonts()));
    for (const char* id :
         {"lines-load-2", "lines-load-3", "lines-load-4", "forces-3-load-3", "forces-4-load-4", "sum-F_12", "sum-F_14"})
        EXPECT_TRUE(figures.contains(id)) << id;
}

/// In steps each load has pages of its own: what opens them shows its lines, what closes a polygon that polygon.
TEST_P(Superposed, EachLoadHasPagesOfItsOwn) {
    const Solution& solution = example(GetParam());
    const std::set<std::string> joined = figures_on(lay_out_steps(solution, {}, fonts()));
    for (const char* id : {"lines-load-2", "lines-load-3", "lines-load-4", "parts-3", "parts-4"})
        EXPECT_TRUE(joined.contains(id)) << id;
    SheetOptions options;
    options.superposed = SuperposedLoads::each;
    const std::set<std::string> each = figures_on(lay_out_steps(solution, options, fonts()));
    for (const char* id : {"lines-load-2", "lines-load-3", "lines-load-4", "forces-3-load-3", "sum-F_12"})
        EXPECT_TRUE(each.contains(id)) << id;
}

TEST_P(Superposed, SaysItsSums) {
    const Solution& solution = example(GetParam());
    const Message& said = solution.protocol.statements[at_index(solution.superposition->statement)].message;
    ASSERT_EQ(said.sentence, lang::sentences::superposition_sum);
    const auto couple = std::find_if(said.worked_arithmetic.begin(), said.worked_arithmetic.end(),
                                     [](const Working& each) { return each.of.letter == Symbol::Letter::M; });
    ASSERT_NE(couple, said.worked_arithmetic.end());
    double sum = 0;
    for (const double part : couple->summands) sum += part;
    EXPECT_NEAR(sum, couple->result.value, 1e-12);
    EXPECT_GE(said.worked_arithmetic.size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Examples, Superposed, testing::Values("four_bar_weights", "four_bar_inertia"),
                         [](const testing::TestParamInfo<const char*>& each) { return std::string(each.param); });

// --- the funicular polygon
// ---------------------------------------------------------------------------------------------------

/// Each string is parallel to its ray, and ends on the lines of the forces between whose rays it lies.
TEST(Funicular, HasStringsParallelToItsRays) {
    const Solution& solution = example("three_parallel_forces");
    ASSERT_EQ(solution.free_bodies.size(), 1U);
    ASSERT_TRUE(solution.free_bodies.front().funicular);
    const FreeBody::Funicular& found = *solution.free_bodies.front().funicular;
    ASSERT_EQ(found.vertices.size(), found.corners.size() + 1);
    for (std::size_t i = 0; i < found.corners.size(); ++i) {
        const Vector string = *found.vertices[i + 1] - *found.vertices[i], ray = *found.corners[i] - *found.pole;
        EXPECT_TRUE(cross(string, ray).is_zero()) << i;
        EXPECT_FALSE(string.is_zero());
    }
    const Vector closing = *found.vertices.front() - *found.vertices.back();
    EXPECT_TRUE(cross(closing, *found.dividing - *found.pole).is_zero());
    // The closing line parts the known force into the reactions.
    EXPECT_EQ(*found.dividing - *found.corners.back(), (Vector{0, -240}));
    EXPECT_EQ(*found.corners.front() - *found.dividing, (Vector{0, 840}));
}

// --- what a sentence names is drawn
// ------------------------------------------------------------------------------------------

/// The names that labels carry, on a sheet.
std::set<std::string> lettered(const std::vector<Page>& pages) {
    std::set<std::string> names;
    for (const Page& page : pages)
        for (const TextMark* text : pages::texts_of(page)) {
            if (text->cls != "label") continue;
            names.insert(text->names.begin(), text->names.end());
            names.insert(text->words);
        }
    return names;
}
/// Sentences whose forces are drawn as lines of action, sides of polygons, or arrows.
bool names_lines(Key sentence) {
    using namespace lang::sentences;
    constexpr std::array all{inertia_force,    inertia_moved,
                             three_force_line, three_parallel_lines,
                             triangle,         triangle_at,
                             polygon,          polygon_at,
                             parallel_forces,  culmann,
                             culmann_line,     force_and_couple,
                             single_reaction,  through_pin,
                             known_resultant,  funicular_parallel,
                             funicular_far,    funicular_parallel_one};
    return std::find(all.begin(), all.end(), sentence) != all.end();
}
/// Whether it vanishes: then there is nothing to be drawn.
bool vanishes(const Message& message, const Symbol& symbol) {
    return std::any_of(message.worked_arithmetic.begin(), message.worked_arithmetic.end(),
                       [&](const Working& each) { return each.of == symbol && each.result.value == 0; });
}
bool is_of_a_force(const Solution& solution, const Symbol& symbol) {
    if (symbol.letter != Symbol::Letter::F) return false;
    const auto drawn = [&](const std::vector<FreeBody>& bodies) {
        return std::any_of(bodies.begin(), bodies.end(), [&](const FreeBody& body) {
            const auto is_it = [&](const AppliedForce& applied) {
                return applied.symbol == symbol && !applied.force.is_zero();
            };
            return std::any_of(body.forces.begin(), body.forces.end(), is_it) ||
                   std::any_of(body.sums.begin(), body.sums.end(), is_it);
        });
    };
    if (drawn(solution.free_bodies)) return true;
    return solution.superposition &&
           std::any_of(solution.superposition->parts.begin(), solution.superposition->parts.end(),
                       [&](const auto& part) { return drawn(part.bodies); });
}

class ForceSentence : public testing::TestWithParam<std::string> {};

TEST_P(ForceSentence, HasTheLinesThatItNamesOnTheSheet) {
    const Solution& solution = example(GetParam());
    if (solution.free_bodies.empty()) return;  // a truss has figures of its own
    const std::set<std::string> names = lettered(lay_out(solution, {}, fonts()));
    ASSERT_FALSE(names.empty());
    for (const Statement& statement : solution.protocol.statements) {
        if (statement.section != Topic::forces || !names_lines(statement.message.sentence)) continue;
        for (const Argument& argument : statement.message.arguments) {
            const auto* symbol = std::get_if<Symbol>(&argument);
            if (symbol && is_of_a_force(solution, *symbol) && !vanishes(statement.message, *symbol)) {
                EXPECT_TRUE(names.contains(name_of(*symbol)) || names.contains(plain(typeset(*symbol, Language::en))))
                    << name_of(*symbol) << " of: " << english(statement.message);
            }
            const auto* point = std::get_if<PointName>(&argument);
            if (point && !solution.mechanism.point_named(point->name)) {
                EXPECT_TRUE(std::any_of(names.begin(), names.end(),
                                        [&](const std::string& name) {
                                            return name == point->name || name.find(point->name + " ") == 0 ||
                                                   name.ends_with(" " + point->name);
                                        }))
                    << point->name << " of: " << english(statement.message);
            }
        }
    }
}

/// The line that joins two meets is a line of action there, with the diagonal that it gives in the polygon.
TEST(CulmannsLine, IsDrawnWithItsDiagonal) {
    const Solution& solution = example("four_force_body");
    const std::vector<Page> pages = lay_out(solution, {}, fonts());
    EXPECT_TRUE(lettered(pages).contains("F_HK"));
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& sum : body.sums) {
            if (name_of(sum.symbol) != "F_HK") continue;
            for (const FreeBody::Meet& meet : body.meets)
                EXPECT_TRUE(cross(sum.force, meet.place - sum.at).is_zero()) << meet.name;
            return;
        }
    ADD_FAILURE() << "no force along HK";
}

std::vector<std::string> with_forces() {
    std::vector<std::string> names;
    for (const std::string& name : example_names()) {
        const std::string text = contents(example_file(name));
        if (name.starts_with("truss_") || text.find("\"find\": [\"virtual work\"]") != std::string::npos) continue;
        if (text.find("\"loads\"") != std::string::npos || text.find("\"mass\"") != std::string::npos)
            names.push_back(name);
    }
    return names;
}
TEST(ForceSentences, NameLinesInTheExamples) {
    std::size_t sentences = 0;
    for (const std::string& name : with_forces())
        for (const Statement& statement : example(name).protocol.statements)
            sentences += statement.section == Topic::forces && names_lines(statement.message.sentence) ? 1 : 0;
    EXPECT_GT(sentences, with_forces().size());
}
INSTANTIATE_TEST_SUITE_P(Examples, ForceSentence, testing::ValuesIn(with_forces()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

// --- arms
// --------------------------------------------------------------------------------------------------------------------

/// M = F · b wherever a couple is balanced by two forces: the arm is drawn, and the product is said.
TEST(CoupleOfTwoForces, SaysForceTimesArm) {
    const Solution& solution = example("gas_force");
    for (const Statement& statement : solution.protocol.statements)
        for (const Working& working : statement.message.worked_arithmetic) {
            if (working.of.letter != Symbol::Letter::M) continue;
            ASSERT_EQ(working.factors.size(), 2U);
            EXPECT_NEAR(working.factors[0].value * working.factors[1].value, -101.678108, 1e-5);
            EXPECT_NEAR(std::abs(working.factors[0].value), 2088.931867, 1e-5);
            for (const FreeBody& body : solution.free_bodies)
                for (const FreeBody::Arm& arm : body.arms)
                    EXPECT_NEAR(length(arm.foot - arm.about), working.factors[1].value, 1e-12);
            return;
        }
    ADD_FAILURE() << "no product";
}

}  // namespace
}  // namespace superposition_test
