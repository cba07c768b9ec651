// Redundant structures: what every equilibrium has alike is given, exactly, and only that. Closed forms of the
// examples, and random plates on too many hinges against a solve of this file's own: equations of equilibrium over
// fractions, and their null space.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/results/results.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/near_the_check.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::redundant_test {
namespace {

using tests::solved;

Solution redundant(const std::string& name) { return tests::example("redundant/" + name); }

const JointForce& action(const Solution& solution, const std::string& joint, const std::string& on) {
    for (const JointForce& each : solution.forces)
        if (solution.mechanism.joint(each.joint).name == joint && solution.mechanism.body(each.on).name == on)
            return each;
    throw std::out_of_range("no action at " + joint + " on " + on);
}
std::string why(const Solution& solution) {
    std::string all;
    for (const Unsolved& each : solution.unsolved) all += english_of(each);
    return all;
}
std::vector<Key> sentences_of(const Solution& solution) {
    std::vector<Key> said;
    for (const Statement& each : solution.protocol.statements) said.push_back(each.message.sentence);
    return said;
}
bool says(const Solution& solution, Key sentence) {
    const auto said = sentences_of(solution);
    return std::find(said.begin(), said.end(), sentence) != said.end();
}

// --- closed forms
// ------------------------------------------------------------------------------------------------------------

TEST(Redundant, OfABeamOnTwoHingesTheVerticalReactionsStand) {
    // B · 4 = 12 · 1 + 8 · 2, A = 12 + 8 − B; of the horizontal ones only the sum is known.
    const Solution solution = redundant("beam_on_two_hinges");
    for (const auto& [joint, value] : {std::pair{"A", 13000}, std::pair{"B", 7000}}) {
        const JointForce &on_2 = action(solution, joint, "2"), &on_1 = action(solution, joint, "1");
        EXPECT_FALSE(on_2.force) << joint;
        ASSERT_TRUE(on_2.component && on_1.component) << joint;
        EXPECT_EQ(*on_2.component, (Vector{0, value})) << joint;
        EXPECT_EQ(*on_1.component, (Vector{0, -value})) << joint;
        EXPECT_EQ(unit_of_component(on_2), (Vector{0, 1})) << joint;
    }
    EXPECT_TRUE(says(solution, lang::sentences::moments_alone));
    EXPECT_LT(tests::worst_difference(solution), 1e-9);
    EXPECT_NE(why(solution).find("statically indeterminate, 1 time"), std::string::npos) << why(solution);
    EXPECT_NE(why(solution).find("A,x"), std::string::npos) << why(solution);
    EXPECT_EQ(why(solution).find("A,y"), std::string::npos) << why(solution);
}

TEST(Redundant, TheResultsHaveTheComponentInPlaceOfTheForce) {
    const Solution solution = redundant("beam_on_two_hinges");
    const auto json =
        nlohmann::ordered_json::parse(results_json(solution, false, [](const Message& m) { return english(m); }));
    EXPECT_EQ(json["forces"]["B"]["1 on 2"].dump(),
              R"({"component":{"along":[0,1],"value":7000},"at":[4,0],"couple":0})");
    EXPECT_EQ(json["forces"]["B"]["2 on 1"]["component"]["value"], -7000);
    bool checked = false;
    for (const auto& row : json["checks"]) checked = checked || row["quantity"] == "force B 1 on 2 component";
    EXPECT_TRUE(checked);
    EXPECT_EQ(json["unsolved"].size(), 1U);
}

TEST(Redundant, TheEffortOfAThirdCrankIsFoundByVirtualWork) {
    // All wheels turn alike, the rod translates: M_2 + 900 + 900 − 120 · 9.81 · 0.15 = 0.
    const Solution solution = redundant("coupled_wheels");
    ASSERT_TRUE(solution.efforts.at(0).value);
    EXPECT_EQ(*solution.efforts[0].value, Exact(-1800) + *Exact::from_decimal("176.58"));
    EXPECT_TRUE(says(solution, lang::sentences::virtual_work_alone));
    // On the wheel the rod's force has the arm of the crank for its part across it: 900/0.25.
    const JointForce& on_3 = action(solution, "B", "3");
    ASSERT_TRUE(on_3.component);
    EXPECT_EQ(*on_3.component, (Vector{2880, -2160}));
    EXPECT_EQ(unit_of_component(on_3), (Vector{Exact::ratio(4, 5), Exact::ratio(-3, 5)}));
    ASSERT_TRUE(solution.virtual_work) << "the effort is known, so the works add up";
    EXPECT_TRUE(solution.virtual_work->total.is_zero());
    EXPECT_LT(tests::worst_difference(solution), 1e-9);
    EXPECT_FALSE(solution.unsolved.empty());
}

TEST(Redundant, AMovablePulleyHalvesTheWeightThoughItsHookIsGuided) {
    const Solution solution = redundant("movable_pulley");
    EXPECT_EQ(*solution.efforts.at(0).value, Exact(300));
    const JointForce& rope = action(solution, "P", "3");
    ASSERT_TRUE(rope.component);
    EXPECT_EQ(*rope.component, (Vector{0, 300}));
    EXPECT_FALSE(action(solution, "guide", "2").force);
    EXPECT_LT(tests::worst_difference(solution), 1e-9);
}

TEST(Redundant, EverySentenceOfMomentsHasItsArmOnTheSheet) {
    int held = 0;
    for (const char* name : {"beam_on_two_hinges", "coupled_wheels", "movable_pulley"}) {
        const Solution solution = redundant(name);
        for (const StatementIndex index : indices_of(solution.protocol.statements)) {
            const Message& said = solution.protocol.statements[at_index(index)].message;
            if (said.sentence != lang::sentences::moments_alone) continue;
            const std::string& centre = std::get<PointName>(said.arguments[1]).name;
            const Vector about = solution.pose.at(*solution.mechanism.point_named(centre));
            int arms = 0;
            for (const FreeBody& body : solution.free_bodies)
                for (const FreeBody::Arm& arm : body.arms) {
                    if (arm.statement != index || !arm.is_sought) continue;
                    ++arms;
                    EXPECT_EQ(arm.name, centre) << name;
                    EXPECT_EQ(arm.about, about) << name;
                    EXPECT_TRUE(std::any_of(body.forces.begin(), body.forces.end(),
                                            [&](const AppliedForce& each) {
                                                return each.is_component &&
                                                       cross(each.force, each.at - arm.foot).is_zero() &&
                                                       dot(each.force, arm.foot - arm.about).is_zero();
                                            }))
                        << name << ": the arm ends square on the line of what is sought";
                }
            EXPECT_EQ(arms, 1) << name << ": " << english(said);
            ++held;
        }
    }
    EXPECT_GE(held, 8);
}

TEST(Redundant, AGuideMayHaveItsForceAndNotItsCouple) {
    // Two clamps in a row along one guide: both couples share the load's moment, the forces across do too; what a lone
    // guide across bears is determined.
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "P": [1, 2]},
        "bodies": {"2": ["A", "B", "P"]},
        "joints": [{"prismatic": "A", "bodies": [2, 1], "along": 0, "name": "flat"},
                   {"prismatic": "B", "bodies": [2, 1], "along": 90, "name": "upright"}],
        "loads": [{"force": "F", "body": 2, "at": "P", "value": [30, -100]}]})");
    const JointForce &flat = action(solution, "flat", "2"), &upright = action(solution, "upright", "2");
    ASSERT_TRUE(flat.force && upright.force);
    EXPECT_EQ(*flat.force, (Vector{0, 100}));
    EXPECT_EQ(*upright.force, (Vector{-30, 0}));
    EXPECT_FALSE(flat.couple || upright.couple);
    EXPECT_NE(why(solution).find("statically indeterminate, 1 time"), std::string::npos) << why(solution);
    EXPECT_LT(tests::worst_difference(solution), 1e-9);
}

TEST(Redundant, WhatIsLeftOpenHasNoNumber) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "P": [1, 2]},
        "bodies": {"2": ["A", "B", "P"]}, "joints": [{"weld": "A", "bodies": [1, 2]}, {"weld": "B", "bodies": [1, 2]}],
        "loads": [{"force": "F", "body": 2, "at": "P", "value": [30, -100]}]})");
    for (const JointForce& each : solution.forces) EXPECT_FALSE(each.force || each.component || each.couple);
    EXPECT_NE(why(solution).find("statically indeterminate, 3 times"), std::string::npos) << why(solution);
}

// --- a body that its joints do not hold
// --------------------------------------------------------------------------------------

std::string lever(const std::string& joint, const std::string& loads) {
    return R"({"kinegraph": 1, "frame": 1, "points": {"A": [1, 0], "P": [4, 4], "Q": [1, 2]}, "bodies": {"2": ["A",
    "P", "Q"]},
        "joints": [)" +
           joint + R"(], "loads": [)" + loads + "]}";
}

TEST(Unheld, ABodyOnAHingeTurnsByWhatIsLeftAboutIt) {
    const Solution solution = solved(lever(R"({"revolute": "A", "bodies": [1, 2]})",
                                           R"({"force": "F", "body": 2, "at": "P", "value": [0, -50]},
                                              {"force": "G", "body": 2, "at": "Q", "value": [30, 0]})"));
    EXPECT_TRUE(solution.unsolved.empty()) << why(solution);
    ASSERT_EQ(solution.resultants.size(), 1U);
    const Resultant& found = solution.resultants[0];
    EXPECT_EQ(*found.force, (Vector{30, -50}));
    EXPECT_EQ(*found.couple, Exact(-50 * 4 - 30 * 2));
    EXPECT_EQ(*found.about, (Vector{1, 0}));
    EXPECT_EQ(*found.residual_couple, Exact(-50 * 3 - 30 * 2));
    EXPECT_GE(found.polygon, 0);
    ASSERT_EQ(solution.free_bodies.size(), 1U);
    ASSERT_EQ(solution.free_bodies[0].arms.size(), 1U);
    const FreeBody::Arm& arm = solution.free_bodies[0].arms[0];
    EXPECT_EQ(cross(arm.foot - arm.about, *found.force), *found.residual_couple) << "the force at its arm";
    EXPECT_EQ(sentences_of(solution), std::vector<Key>{lang::sentences::residual_couple});
    EXPECT_FALSE(action(solution, "A", "2").force) << "no equilibrium, no reaction";
}

TEST(Unheld, ABodyInAGuideSlidesByWhatIsLeftAlongIt) {
    const Solution solution = solved(lever(R"({"prismatic": "A", "bodies": [2, 1], "along": 0})",
                                           R"({"force": "F", "body": 2, "at": "P", "value": [7, -50]})"));
    EXPECT_TRUE(solution.unsolved.empty()) << why(solution);
    ASSERT_EQ(solution.resultants.size(), 1U);
    EXPECT_EQ(*solution.resultants[0].residual_force, (Vector{7, 0}));
    EXPECT_TRUE(says(solution, lang::sentences::residual_force));
}

TEST(Unheld, ABodyOnAHingeMayBeInEquilibriumAllTheSame) {
    const Solution solution = solved(
        lever(R"({"revolute": "A", "bodies": [1, 2]})", R"({"force": "F", "body": 2, "at": "Q", "value": [0, -50]})"));
    EXPECT_TRUE(solution.unsolved.empty()) << why(solution);
    EXPECT_EQ(*action(solution, "A", "2").force, (Vector{0, 50}));
}

/// A group of many members is not asked for what is the same in every equilibrium: one sentence names its joints.
TEST(Redundant, ALargeGroupIsToldInOneSentence) {
    std::string points = R"("P0": [0, 0])", bodies, joints = R"({"revolute": "P0", "bodies": [1, 2]})";
    constexpr int last = 27;
    for (int body = 2; body <= last; ++body) {
        const std::string number = std::to_string(body), from = "P" + std::to_string(body - 2),
                          to = "P" + std::to_string(body - 1);
        points += ", \"" + to + "\": [" + std::to_string(body - 1) + ", 0]";
        bodies += (body > 2 ? ", \"" : "\"") + number + "\": [\"" + from + "\", \"" + to + "\"]";
        joints += ", {\"revolute\": \"" + to + "\", \"bodies\": [1, " + number +
                  (body < last ? ", " + std::to_string(body + 1) : "") + "]}";
    }
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {)" + points + R"(}, "bodies": {)" + bodies +
               R"(}, "joints": [)" + joints + R"(], "loads": [{"couple": "M", "body": 5, "value": 3}]})");
    ASSERT_EQ(solution.unsolved.size(), 1u);
    EXPECT_NE(why(solution).find("statically indeterminate, 26 times"), std::string::npos) << why(solution);
}

// --- at random
// ---------------------------------------------------------------------------------------------------------------

struct Hinge {
    int first = 0, second = 0;  ///< bodies, 0 the frame
    int x = 0, y = 0;
};
struct Plates {
    int bodies = 0;
    std::vector<Hinge> hinges;
    struct Push {
        int body, hinge;  ///< at the place of this hinge
        int fx, fy;
    };
    std::vector<Push> pushes;
};

Plates random_plates(unsigned seed) {
    std::mt19937 random(seed);
    const auto up_to = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
    Plates plates;
    plates.bodies = 1 + up_to(2);
    std::vector<std::pair<int, int>> taken;
    const int count = (3 * plates.bodies + 1) / 2 + up_to(2);
    while (static_cast<int>(plates.hinges.size()) < count) {
        Hinge hinge{up_to(plates.bodies), up_to(plates.bodies), up_to(3), up_to(3)};
        // Every body has a hinge, and joints have different places.
        if (static_cast<int>(plates.hinges.size()) < plates.bodies)
            hinge.second = static_cast<int>(plates.hinges.size()) + 1;
        const std::pair place{hinge.x, hinge.y};
        if (hinge.first == hinge.second || std::find(taken.begin(), taken.end(), place) != taken.end()) continue;
        taken.push_back(place);
        plates.hinges.push_back(hinge);
    }
    for (int n = 0; n <= up_to(1); ++n) {
        const int hinge = up_to(count - 1);
        const Hinge& at = plates.hinges[static_cast<std::size_t>(hinge)];
        plates.pushes.push_back({std::max(at.first, at.second), hinge, up_to(20) - 10, up_to(20) - 10});
    }
    return plates;
}

std::string file_of(const Plates& plates) {
    std::string points, bodies, joints, loads;
    const auto part = [](std::string& to, const std::string& more) { to += (to.empty() ? "" : ", ") + more; };
    const auto name = [](std::size_t hinge) { return "P" + std::to_string(hinge); };
    for (std::size_t i = 0; i < plates.hinges.size(); ++i) {
        const Hinge& h = plates.hinges[i];
        part(points, "\"" + name(i) + "\": [" + std::to_string(h.x) + ", " + std::to_string(h.y) + "]");
        part(joints, R"({"revolute": ")" + name(i) + R"(", "bodies": [)" + std::to_string(h.first + 1) + ", " +
                         std::to_string(h.second + 1) + "]}");
    }
    for (int b = 1; b <= plates.bodies; ++b) {
        std::string own;
        for (std::size_t i = 0; i < plates.hinges.size(); ++i)
            if (plates.hinges[i].first == b || plates.hinges[i].second == b) part(own, "\"" + name(i) + "\"");
        part(bodies, "\"" + std::to_string(b + 1) + "\": [" + own + "]");
    }
    for (std::size_t i = 0; i < plates.pushes.size(); ++i) {
        const Plates::Push& p = plates.pushes[i];
        part(loads, R"({"force": "L)" + std::to_string(i) + R"(", "body": )" + std::to_string(p.body + 1) +
                        R"(, "at": ")" + name(static_cast<std::size_t>(p.hinge)) + R"(", "value": [)" +
                        std::to_string(p.fx) + ", " + std::to_string(p.fy) + "]}");
    }
    return R"({"kinegraph": 1, "frame": 1, "points": {)" + points + R"(}, "bodies": {)" + bodies + R"(}, "joints": [)" +
           joints + R"(], "loads": [)" + loads + R"(], "find": ["forces"]})";
}

/// A x + b = 0 over fractions: rows Σ F_x, Σ F_y, Σ M_O of each body, columns x and y of each hinge on its second body.
class OwnSolve {
public:
    explicit OwnSolve(const Plates& plates) : columns_(2 * plates.hinges.size()) {
        rows_.assign(3 * static_cast<std::size_t>(plates.bodies), std::vector<Exact>(columns_ + 1));
        const auto add = [&](int body, std::size_t column, int sign, const Vector& along, const Hinge& at) {
            if (body == 0) return;
            const std::size_t row = 3 * static_cast<std::size_t>(body - 1);
            rows_[row][column] += sign * along.x;
            rows_[row + 1][column] += sign * along.y;
            rows_[row + 2][column] += sign * cross({at.x, at.y}, along);
        };
        for (std::size_t i = 0; i < plates.hinges.size(); ++i)
            for (const std::size_t axis : {0U, 1U}) {
                const Vector unit = axis == 0 ? Vector{1, 0} : Vector{0, 1};
                add(plates.hinges[i].second, 2 * i + axis, 1, unit, plates.hinges[i]);
                add(plates.hinges[i].first, 2 * i + axis, -1, unit, plates.hinges[i]);
            }
        for (const Plates::Push& p : plates.pushes)
            add(p.body, columns_, 1, {p.fx, p.fy}, plates.hinges[static_cast<std::size_t>(p.hinge)]);
        eliminate();
    }
    bool exists() const { return exists_; }
    bool determined() const { return free_.empty(); }
    /// c · x of a hinge where no null vector changes it.
    std::optional<Exact> along(std::size_t hinge, const Vector& c) const {
        Exact value;
        for (const std::size_t free : free_)
            if (!(c.x * change(2 * hinge, free) + c.y * change(2 * hinge + 1, free)).is_zero()) return std::nullopt;
        return c.x * particular(2 * hinge) + c.y * particular(2 * hinge + 1);
    }
    /// Some direction across which the null space moves a hinge's force; none: it does not move, or both ways.
    std::optional<Vector> common(std::size_t hinge) const {
        for (const std::size_t free : free_) {
            const Vector move{change(2 * hinge, free), change(2 * hinge + 1, free)};
            if (move.is_zero()) continue;
            const Vector across{-move.y, move.x};
            return along(hinge, across) ? std::optional(across) : std::nullopt;
        }
        return std::nullopt;
    }

private:
    void eliminate() {
        std::size_t next = 0;
        row_of_.assign(columns_, rows_.size());
        for (std::size_t c = 0; c < columns_; ++c) {
            std::size_t found = next;
            while (found < rows_.size() && rows_[found][c].is_zero()) ++found;
            if (found == rows_.size()) {
                free_.push_back(c);
                continue;
            }
            std::swap(rows_[next], rows_[found]);
            const Exact pivot = rows_[next][c];
            for (Exact& each : rows_[next]) each = each / pivot;
            for (std::size_t r = 0; r < rows_.size(); ++r) {
                const Exact factor = rows_[r][c];
                if (r == next || factor.is_zero()) continue;
                for (std::size_t k = 0; k <= columns_; ++k) rows_[r][k] -= factor * rows_[next][k];
            }
            row_of_[c] = next++;
        }
        for (std::size_t r = next; r < rows_.size(); ++r) exists_ = exists_ && rows_[r][columns_].is_zero();
    }
    Exact particular(std::size_t c) const {
        return row_of_[c] == rows_.size() ? Exact(0) : -rows_[row_of_[c]][columns_];
    }
    Exact change(std::size_t c, std::size_t free) const {
        if (row_of_[c] == rows_.size()) return Exact(c == free ? 1 : 0);
        return -rows_[row_of_[c]][free];
    }

    std::size_t columns_;
    std::vector<std::vector<Exact>> rows_;
    std::vector<std::size_t> row_of_, free_;
    bool exists_ = true;
};

/// True where something is open and something is not.
bool hold_plates(unsigned seed) {
    const Plates plates = random_plates(seed);
    const OwnSolve own(plates);
    if (!own.exists() || own.determined()) return false;
    const std::string text = file_of(plates);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + text);
    const Solution solution = solved(text);
    EXPECT_FALSE(solution.unsolved.empty());
    bool some = false;
    for (const JointForce& each : solution.forces) {
        const auto hinge = static_cast<std::size_t>(each.joint.number());
        const Hinge& h = plates.hinges[hinge];
        if (solution.mechanism.body(each.on).name != std::to_string(h.second + 1)) continue;
        const std::optional<Exact> x = own.along(hinge, {1, 0}), y = own.along(hinge, {0, 1});
        const std::optional<Vector> common = own.common(hinge);
        EXPECT_EQ(each.force.has_value(), x && y) << hinge;
        EXPECT_EQ(each.component.has_value(), !(x && y) && common) << hinge;
        if (each.force && x && y) {
            EXPECT_EQ(*each.force, (Vector{*x, *y})) << hinge;
        }
        if (each.component && common) {
            EXPECT_EQ(dot(*each.component, *common), *own.along(hinge, *common)) << hinge;
            EXPECT_TRUE(cross(*each.component, *common).is_zero()) << hinge;
            EXPECT_TRUE(cross(*each.along, *common).is_zero()) << hinge;
        }
        some = some || each.force || each.component;
    }
    // Loads and lengths are of the order of ten: where nothing is left but zeros, they are what these must be small
    // against.
    for (const CheckRow& row : solution.checks) EXPECT_NEAR(row.graphical, row.numeric, 1e-8);
    return some;
}

TEST(Redundant, AtRandomWhatTheNullSpaceLeavesAloneIsGivenAndNoMore) {
    int counted = 0;
    const int tried = unless_sanitized(400, 60);
    for (int seed = 1; seed <= tried && !HasFailure(); ++seed)
        counted += hold_plates(static_cast<unsigned>(seed)) ? 1 : 0;
    EXPECT_GE(counted, tried / 20) << "too few draws counted";
}

}  // namespace
}  // namespace kinegraph::redundant_test
