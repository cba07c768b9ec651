// Quantities: each number of the check stands beside its own, each force is found by the statement that says so, what
// differs is said and what is rounding is not shown; and names of the file mean nothing to the tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "constructions/verdicts/check_rows.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/solution/magnitudes.hpp"
#include "lang/keys/sentences.hpp"
#include "render/sheet/sheet.hpp"
#include "render/tables/checked_numbers.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::render::quantities_test {
namespace {

using tests::example;
using tests::example_names;
using tests::fonts;
using tests::solved;
using Kind = Quantity::Kind;

/// A hydraulic cylinder between a crank and a rocker, hinged on both: its guide's point D is the crank's, too.
const char* const cylinder = R"({
  "kinegraph": 1,
  "units": {"length": "mm"},
  "frame": 1,
  "points": {"O": [0, 0], "D": [300, 200], "F": [900, 0], "E": [800, 500], "J": [550, 350]},
  "bodies": {"2": ["O", "D"], "3": ["F", "E"], "4": ["D"], "5": ["E"]},
  "joints": [
    {"revolute": "O", "bodies": [1, 2]},
    {"revolute": "D", "bodies": [2, 4]},
    {"revolute": "F", "bodies": [1, 3]},
    {"revolute": "E", "bodies": [3, 5]},
    {"prismatic": "J", "bodies": [5, 4], "along": ["D", "E"]}
  ],
  "drivers": [{"body": 2, "omega": 1}, {"joint": "J", "speed": 0.5}],
  "find": ["velocity", "acceleration", {"relative motion": "E", "observer": 4}]
})";

/// A four-bar driven, and held, by a motor between its crank and its coupler.
const char* const motor = R"({
  "kinegraph": 1,
  "frame": 1,
  "points": {"A": [0, 0], "B": [1, 2], "C": [4, 3], "D": [5, 0]},
  "bodies": {"2": ["A", "B"], "3": ["B", "C"], "4": ["C", "D"]},
  "joints": [
    {"revolute": "A", "bodies": [1, 2]},
    {"revolute": "B", "bodies": [2, 3]},
    {"revolute": "C", "bodies": [3, 4]},
    {"revolute": "D", "bodies": [4, 1]}
  ],
  "drivers": [{"body": 2, "relative to": 3, "omega": 1}],
  "loads": [{"force": "Q", "body": 4, "at": "C", "value": [10, 5]}],
  "effort": {"couple": "M", "body": 2, "from": 3}
})";

std::string reversed_motor() {
    std::string text = motor;
    const std::string own = R"("body": 2, "from": 3})";
    return text.replace(text.find(own), own.size(), R"("body": 3, "from": 2})");
}

std::vector<ResultRow> all_rows(const Solution& solution) {
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    std::vector<ResultRow> rows = result_rows(context, {});
    for (ResultRow& row : force_rows(context, {})) rows.push_back(std::move(row));
    return rows;
}

// --- each beside its own
// -------------------------------------------------------------------------------------------------------

TEST(CheckedNumbers, OfACylinderHingedOnAMovingBodyTakeItsOwnTurning) {
    const Solution solution = solved(cylinder);
    int coriolis = 0;
    for (const ResultRow& row : all_rows(solution)) {
        ASSERT_TRUE(row.numeric) << row.name;
        EXPECT_NEAR(row.drawing, *row.numeric, 1e-12) << row.name;
        if (row.quantity.part != Quantity::Part::coriolis) continue;
        ++coriolis;
        // 2 · 0.9133903 rad/s · 0.5 m/s: of the cylinder, not of the crank, which turns at 1 rad/s.
        EXPECT_NEAR(*row.numeric, 0.9133903306116229, 1e-12) << row.name;
    }
    EXPECT_EQ(coriolis, 2) << "in the polygon of all points and in that of the relative motion";
    EXPECT_TRUE(solution.remarks.empty()) << english(solution.remarks.front());
}

/// M (ω_2 − ω_3) + Q·v_C = 0 with ω_2 − ω_3 = 1 rad/s: ω_4 = 1/3 rad/s, v_C = (−1, −1/3) m/s, so M = 35/3 N m on
/// body 2.
TEST(CheckedNumbers, OfACoupleBetweenTwoMovingBodiesHaveOneSense) {
    for (const auto& [text, expected] :
         {std::pair(std::string(motor), 35.0 / 3), std::pair(reversed_motor(), -35.0 / 3)}) {
        const Solution solution = solved(text);
        EXPECT_EQ(solution.virtual_work->total, Exact(0));
        EXPECT_NEAR(solution.efforts.front().value->to_double(), expected, 1e-12);
        int rows = 0;
        for (const ResultRow& row : all_rows(solution)) {
            if (row.quantity.kind != Kind::effort) continue;
            ++rows;
            EXPECT_NEAR(row.drawing, expected, 1e-12);
            EXPECT_NEAR(row.numeric.value(), expected, 1e-12);
        }
        EXPECT_EQ(rows, 1);
        // On its two bodies it counts oppositely, by the check too.
        int bodies = 0;
        for (const FreeBody& body : solution.free_bodies)
            for (const AppliedForce& applied : body.forces)
                if (applied.kind == Quantity::Kind::effort) {
                    ++bodies;
                    EXPECT_NEAR(applied.couple.to_double(), applied.numeric_couple.value(), 1e-12)
                        << body.body.number();
                }
        EXPECT_GE(bodies, 2);
    }
}

/// The written names are the results file's, told from the quantities alone.
TEST(Quantities, HaveTheNamesOfTheResultsFile) {
    const Solution solution = solved(cylinder);
    std::set<std::string> names;
    for (const CheckRow& row : solution.checks) EXPECT_TRUE(names.insert(name_of(row.quantity, solution)).second);
    for (const char* name : {"omega 4", "alpha 5", "velocity D x", "acceleration E y", "sliding J velocity x",
                             "sliding J acceleration y", "sliding J coriolis x"})
        EXPECT_TRUE(names.contains(name)) << name;
    const Solution& shaper = example("quick_return");
    names.clear();
    for (const CheckRow& row : shaper.checks) EXPECT_TRUE(names.insert(name_of(row.quantity, shaper)).second);
    EXPECT_TRUE(names.contains("velocity A on 2 x") && names.contains("velocity A on 4 x"));
    EXPECT_FALSE(names.contains("velocity A x"));
    const Solution held = solved(motor);
    names.clear();
    for (const CheckRow& row : held.checks) EXPECT_TRUE(names.insert(name_of(row.quantity, held)).second);
    for (const char* name : {"centre 1,3 y", "force B 3 on 2 x", "force B 2 on 3 y", "effort M", "virtual power"})
        EXPECT_TRUE(names.contains(name)) << name;
}

// --- forces and the statements that find them
// ----------------------------------------------------------------------------------

class StatedForces : public testing::TestWithParam<const char*> {};

TEST_P(StatedForces, AreFoundByTheStatementThatSaysSo) {
    const Solution& solution = example(GetParam());
    ASSERT_FALSE(solution.free_bodies.empty());
    for (const FreeBody& body : solution.free_bodies) {
        StatementIndex last;
        for (const AppliedForce& applied : body.forces) {
            const bool sought = applied.is_reaction() || applied.kind == Quantity::Kind::effort;
            ASSERT_EQ(applied.force_statement != none, sought) << name_of(applied.symbol);
            if (!sought) continue;
            last = std::max(last, applied.force_statement);
            const Statement& statement = solution.protocol.statements[at_index(applied.force_statement)];
            EXPECT_EQ(statement.section, Topic::forces);
            if (applied.is_reaction()) {
                EXPECT_NE(applied.line_statement, none);
                EXPECT_LE(applied.line_statement, applied.force_statement) << name_of(applied.symbol);
            }
            if (body.in_parts) continue;
            Quantity own = quantity_of(body, applied), reverse = own;
            std::swap(reverse.body, reverse.other);
            EXPECT_TRUE(std::any_of(statement.finds.begin(), statement.finds.end(), [&](const Quantity& found) {
                return found == own || found == reverse;
            })) << name_of(applied.symbol);
        }
        EXPECT_GE(body.statement, last);
        for (const FreeBody::Meet& meet : body.meets) EXPECT_NE(meet.statement, none) << meet.name;
    }
    for (const DrawnVector& vector : solution.protocol.vectors)
        if (solution.protocol.polygons[static_cast<std::size_t>(vector.polygon)].plane == Plane::force) {
            EXPECT_NE(vector.quantity.kind, Kind::unnamed) << name_of(vector.symbol);
        }
}

INSTANTIATE_TEST_SUITE_P(Quantities, StatedForces,
                         testing::Values("sluice_gate", "tipper", "exam_2001", "gas_force", "cutting_force",
                                         "toggle_clamp", "three_parallel_forces", "four_force_body", "beam",
                                         "four_bar_weights", "four_bar_inertia"),
                         [](const testing::TestParamInfo<const char*>& each) { return std::string(each.param); });

// --- what differs is said
// ------------------------------------------------------------------------------------------------------

std::vector<Comparison::Moved> all_move(const Solution& solution) {
    std::vector<Comparison::Moved> bodies(solution.mechanism.bodies.size(), {true, true});
    bodies.front().moves = false;
    return bodies;
}

TEST(Disagreements, AreNoneInTheExamples) {
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const Comparison comparison = compare_with_check(solution);
        for (const Message& message : disagreements(solution, comparison.bodies))
            ADD_FAILURE() << name << ": " << english(message);
    }
}

TEST(Disagreements, AreSaidWithTheWorstOfTheirKind) {
    const Solution& solution = example("four_bar_weights");
    const Magnitudes magnitudes(solution);
    std::set<Kind> kinds;
    for (std::size_t i = 0; i < solution.checks.size(); ++i) {
        const Quantity& quantity = solution.checks[i].quantity;
        const double largest = magnitudes.of(quantity);
        ASSERT_GT(largest, 0);
        kinds.insert(quantity.kind);
        for (const double share : {3e-6, -3e-6, 3e-7}) {
            Solution doctored = solution;
            doctored.checks[i].numeric += share * largest;
            const auto said = disagreements(doctored, all_move(solution));
            ASSERT_EQ(said.size(), std::abs(share) > 1e-6 ? 1u : 0u) << name_of(quantity, solution);
            if (said.empty()) continue;
            EXPECT_EQ(said.front().sentence, lang::sentences::check_differs);
            EXPECT_EQ(said.front().arguments.size(), 3u);
            EXPECT_EQ(std::get<std::string>(said.front().arguments[0]), name_of(quantity, solution));
            EXPECT_NEAR(std::get<Amount>(said.front().arguments[2]).value, -share * largest, 1e-3 * largest * 1e-6);
        }
    }
    EXPECT_TRUE(kinds.contains(Kind::omega) && kinds.contains(Kind::velocity) && kinds.contains(Kind::force));

    // The worst is named, the others are counted; what is not a number at all is worst.
    Solution doctored = solution;
    std::vector<std::size_t> velocities;
    for (std::size_t i = 0; i < solution.checks.size(); ++i)
        if (solution.checks[i].quantity.kind == Kind::velocity) velocities.push_back(i);
    ASSERT_GE(velocities.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) doctored.checks[velocities[k]].numeric += 1 + static_cast<double>(k);
    auto said = disagreements(doctored, all_move(solution));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(std::get<std::string>(said[0].arguments[0]), name_of(solution.checks[velocities[2]].quantity, solution));
    EXPECT_EQ(std::get<Count>(said[0].arguments.at(3)).value, 2);
    doctored.checks[velocities[0]].numeric = std::nan("");
    said = disagreements(doctored, all_move(solution));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(std::get<std::string>(said[0].arguments[0]), name_of(solution.checks[velocities[0]].quantity, solution));
}

/// As it was printed without a word: −100 % in a part of an acceleration, while all rows of `checks` agree.
TEST(Disagreements, OfDrawnVectorsAreSaid) {
    const Solution solution = solved(cylinder);
    std::size_t vector = 0;
    while (solution.protocol.vectors.at(vector).quantity.part != Quantity::Part::coriolis) ++vector;
    Solution doctored = solution;
    doctored.numeric_moduli[vector] = 1;
    const auto said = disagreements(doctored, all_move(solution));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(std::get<Symbol>(said[0].arguments[0]), solution.protocol.vectors[vector].symbol);
    EXPECT_NEAR(std::get<Amount>(said[0].arguments[1]).value, 0.9133903306116229, 1e-12);
}

TEST(Disagreements, AboutWhatMovesAreSaid) {
    const Solution& solution = example("four_bar");
    std::vector<Comparison::Moved> bodies = all_move(solution);
    bodies[3] = {false, false};
    auto said = disagreements(solution, bodies);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].sentence, lang::sentences::check_stands_still);
    EXPECT_EQ(std::get<BodyName>(said[0].arguments[0]).name, solution.mechanism.bodies[3].name);

    Solution locked = solution;
    locked.mobility.determined[3] = false;
    EXPECT_TRUE(disagreements(locked, bodies).empty()) << "of what is not determined, how it turns may still be found";
    locked.mobility.determined[3] = true;
    locked.mobility.determined[2] = false;
    bodies = all_move(solution);
    said = disagreements(locked, bodies);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].sentence, lang::sentences::check_moves);
    bodies[2].moves = false;  // both say that it stands still
    EXPECT_TRUE(disagreements(locked, bodies).empty());
}

/// Where nothing found moves, a velocity is small against the one that is asked for.
TEST(Disagreements, AreMeasuredByWhatDrives) {
    Solution solution = example("four_bar");
    solution.protocol = {};
    solution.numeric_moduli.clear();
    const double driven = std::abs(std::get<SpinDriver>(solution.mechanism.drivers.front()).omega.to_double());
    for (const double numeric : {1e-16 * driven, 1e-3 * driven}) {
        solution.checks = {{{.kind = Kind::omega, .body = BodyIndex(2)}, 0, numeric, -numeric}};
        EXPECT_EQ(disagreements(solution, all_move(solution)).size(), numeric < 1e-9 * driven ? 0u : 1u);
    }
}

// --- what is rounding is nothing
// -----------------------------------------------------------------------------------------------

TEST(CheckedNumbers, BelowTheRoundingOfTheCheckAreNothing) {
    Solution solution = example("four_bar");
    const Magnitudes magnitudes(solution);
    ASSERT_FALSE(solution.checks.empty());
    for (CheckRow& row : solution.checks) {
        const double largest = magnitudes.of(row.quantity);
        for (const auto& [share, is_noise] :
             {std::pair(1e-10, true), std::pair(-1e-16, true), std::pair(1e-8, false)}) {
            row.numeric = share * largest;
            const CheckedNumbers numbers(solution);
            EXPECT_EQ(numbers.of(row.quantity), is_noise ? 0 : row.numeric) << name_of(row.quantity, solution);
        }
        row.numeric = row.graphical;
    }
}

/// A parallelogram's coupler does not turn; forces of 1e13 N stand beside a couple that vanishes.
TEST(CheckedNumbers, OfWhatDoesNotTurnAreNothingWhereTheCheckHasAlmostNothing) {
    Solution solution = example("parallel_crank");
    int still = 0;
    for (CheckRow& row : solution.checks) {
        if (row.quantity.kind != Kind::omega || row.graphical != 0) continue;
        ++still;
        row.numeric = 1.8e-13;
        EXPECT_EQ(CheckedNumbers(solution).of(row.quantity), 0);
    }
    EXPECT_GE(still, 1);

    Solution loaded = example("four_bar_weights");
    for (FreeBody& body : loaded.free_bodies)
        for (AppliedForce& applied : body.forces) {
            applied.force = Exact::from_decimal("1e13").value() * applied.force;
            applied.numeric_force = 1.8e-3;
            EXPECT_EQ(CheckedNumbers(loaded).force_of(body, applied), 0) << name_of(applied.symbol);
        }
}

// --- names mean nothing
// --------------------------------------------------------------------------------------------------------

/// A four-bar whose points, bodies, joint, load and effort bear words of the tables.
const char* const reserved_names = R"({
  "kinegraph": 1,
  "frame": 1,
  "points": {"A": [0, 0], "magnitude": [1, 2], "total": [4, 3], "D": [5, 0], "SUM": [2, 3]},
  "bodies": {"magnitude": ["A", "magnitude"], "SUM": ["magnitude", "total", "SUM"], "total": ["total", "D"]},
  "joints": [
    {"revolute": "A", "bodies": [1, "magnitude"]},
    {"revolute": "magnitude", "bodies": ["magnitude", "SUM"], "name": "sum"},
    {"revolute": "total", "bodies": ["SUM", "total"]},
    {"revolute": "D", "bodies": ["total", 1]}
  ],
  "drivers": [{"body": "magnitude", "omega": 1}],
  "loads": [{"force": "power", "body": "SUM", "at": "SUM", "value": [10, 5]}],
  "effort": {"couple": "direction", "body": "magnitude"}
})";

/// The same with names that mean nothing and are as wide: their letters in another order.
std::string unreserved_names() {
    std::string text = reserved_names;
    for (const auto& [word, anagram] :
         {std::pair("magnitude", "magnitued"), std::pair("SUM", "MUS"), std::pair("\"sum\"", "\"mus\""),
          std::pair("total", "latot"), std::pair("power", "rewop"), std::pair("direction", "noitcerid")})
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
            text.replace(at, std::string(anagram).size(), anagram);
    return text;
}

std::map<std::string, int> words_on(const std::string& text, const SheetOptions& options) {
    std::map<std::string, int> count;
    for (const Page& page : lay_out(solved(text), options, fonts()))
        for (const Mark& mark : page.marks)
            if (const auto* written = std::get_if<TextMark>(&mark)) ++count[written->words];
    return count;
}

TEST(Names, OfTheFileTakeNoTableAway) {
    for (const Paper paper : {Paper::a3, Paper::a4})
        for (const Orientation orientation : {Orientation::portrait, Orientation::landscape}) {
            SheetOptions options;
            options.paper = paper;
            options.orientation = orientation;
            options.joukowsky = true;
            const auto plain = words_on(unreserved_names(), options), reserved = words_on(reserved_names, options);
            for (const char* words : {"power, W", "line", "numeric"})
                ASSERT_TRUE(plain.contains(words) && reserved.contains(words)) << words;
            EXPECT_EQ(plain.at("power, W"), 1) << "the lever has its table once";
            EXPECT_EQ(reserved.at("power, W"), 1);
            // The third row of a table of forces or of motion, which a long one has for each of its pieces; no name of
            // the file is such.
            EXPECT_GE(plain.at("line"), 2);
            EXPECT_GE(reserved.at("line"), 2);
            EXPECT_EQ(reserved.at("numeric"), plain.at("numeric"));
        }
}

}  // namespace
}  // namespace kinegraph::render::quantities_test
