// Efforts by virtual work in the rows of a sweep: against those of the force polygons, closed forms, the exact
// construction of a moved position; and what a position leaves open.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "constructions/positions/cycle.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/solution/displacements.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::effort_rows_test {
namespace {

/// A mechanism's file, which asks for `find`, along the way of its first driver.
class Rows {
public:
    Rows(const std::string& text, Find find) : mechanism_(*read_mechanism(text, "test.json")) {
        find.stated = true;
        mechanism_.find = std::move(find);
        pose_ = *draw_pose(mechanism_);
        cycle_.emplace(*Cycle::of(mechanism_, pose_, 0));
        travel_ = *travel_of(cycle_->positions(), std::holds_alternative<SpinDriver>(mechanism_.drivers[0]), {}, {});
        cycle_->begin(travel_);
    }
    /// NaN where there is no such column, or no row.
    double at(double coordinate, const std::string& name) {
        const auto row = cycle_->row(coordinate);
        for (std::size_t i = 0; row && i < row->size(); ++i)
            if (cycle_->columns()[i].name == name) return (*row)[i];
        return std::nan("");
    }
    Solution moved(double coordinate) {
        Positions positions = cycle_->positions();
        EXPECT_TRUE(positions.move_to(coordinate));
        Repositioned there = *Mover(mechanism_, pose_).moved(positions, Exact::from_double(coordinate));
        return solve(std::move(there.mechanism), std::move(there.pose),
                     [finer = std::move(there.finer)] { return finer; });
    }
    const Travel& travel() const { return travel_; }
    Cycle& cycle() { return *cycle_; }

private:
    Mechanism mechanism_;
    Pose pose_;
    std::optional<Cycle> cycle_;
    Travel travel_;
};
Find by_work() {
    Find find;
    find.virtual_work = true;
    return find;
}
Find by_forces() {
    Find find;
    find.velocity = find.acceleration = find.forces = true;
    return find;
}

class SameEfforts : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(SameEfforts, AsByForces) {
    const auto& [name, effort] = GetParam();
    const std::string text = tests::contents(tests::example_file(name));
    Rows works(text, by_work()), forces(text, by_forces());
    double largest = 0;
    std::vector<std::array<double, 2>> both;
    for (int i = 1; i < 24; ++i) {
        const double at = works.travel().at(i / 24.0);
        both.push_back({works.at(at, effort), forces.at(at, effort)});
        ASSERT_TRUE(std::isfinite(both.back()[1])) << at;
        largest = std::max(largest, std::abs(both.back()[1]));
    }
    for (const auto& [by_works, of_forces] : both) EXPECT_NEAR(by_works, of_forces, 1e-9 * largest);
    EXPECT_LT(works.cycle().difference().share, 1e-9);
    EXPECT_LT(works.cycle().plans(), 8) << "displacements are replayed";
}
INSTANTIATE_TEST_SUITE_P(Examples, SameEfforts,
                         testing::Values(std::pair("four_bar_weights", "effort M"),
                                         std::pair("four_bar_inertia", "effort M"), std::pair("gas_force", "effort M"),
                                         std::pair("lever_on_springs", "effort M_2"),
                                         std::pair("sluice_gate_travel", "effort F_G")));

std::string slider_crank(const std::string& more, const std::string& angle = "60") {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
      "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": )" +
           angle + R"(},
                 "B": {"meet": [{"circle": "A", "radius": 150}, {"line": [0, 0], "angle": 0}], "near": [170, 0]}},
      "bodies": {"2": {"points": ["O", "A"]}, "3": {"points": ["A", "B"]}, "4": {"points": ["B"]}},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
      "bodies": [3, 4]},
                 {"prismatic": "B", "bodies": [4, 1], "along": 0}], "drivers": [{"body": 2, "omega": 4}], )" +
           more + "}";
}
/// dc/dα of a = 50 mm, b = 150 mm.
double slide_ratio(double alpha) {
    const double beta = std::asin(-std::sin(alpha) / 3);
    return -0.05 * (std::sin(alpha) - std::cos(alpha) * std::tan(beta));
}

TEST(EffortRows, SliderCrankHasItsClosedForm) {
    Rows rows(slider_crank(R"("loads": [{"force": "F", "body": 4, "at": "B", "value": [-1000, 300]}],
                              "effort": {"couple": "M", "body": 2})"),
              by_work());
    for (const double turn : {0.0, 0.3, 1.0, 2.5, 4.0, 6.2})
        EXPECT_NEAR(rows.at(turn, "effort M"), 1000 * slide_ratio(std::numbers::pi / 3 + turn), 1e-9) << turn;
    // The motion that is not asked for has no columns.
    EXPECT_TRUE(std::isnan(rows.at(0.3, "omega 3")));
}

TEST(EffortRows, APositionThatLeavesTheEffortOpenHasNoRow) {
    // With the crank along the slide, as drawn, a force there balances no couple on the crank.
    Rows rows(slider_crank(R"("loads": [{"couple": "C", "body": 2, "value": 7}],
                              "effort": {"force": "F", "body": 4, "at": "B", "along": 0})",
                           "0"),
              by_work());
    EXPECT_NEAR(rows.at(1, "effort F"), -7 / slide_ratio(1), 1e-9);
    EXPECT_FALSE(rows.cycle().row(0));
    EXPECT_NEAR(rows.at(1e-3, "effort F"), -7 / slide_ratio(1e-3), 1e-3);
}

TEST(EffortRows, ACouplerThatTranslatesWhereItIsMovedToDoesNoWork) {
    const std::string text = R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
      "points": {"O2": [0, 0], "A": [30, 40], "O4": [120, 0],
                 "B": {"meet": [{"circle": "A", "radius": 120}, {"circle": "O4", "radius": 50}], "side": "left"}},
      "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]},
      "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                 {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
      "drivers": [{"body": 2, "omega": 5}], "loads": [{"couple": "C", "body": 2, "value": 3}],
      "effort": {"couple": "M", "body": 3}})";
    Rows rows(text, by_work());
    const Solution solution = rows.moved(0.7);
    ASSERT_TRUE(solution.displacements);
    const Displacements& found = *solution.displacements;
    EXPECT_TRUE(found.freedoms.at(0).moved->virtual_work->shares.at(0).rests) << "by the finer pose, not by its digits";
    EXPECT_FALSE(found.efforts.at(0).value);
    EXPECT_FALSE(found.balanced);
}

TEST(EffortRows, WhereNothingBalancesNoEffortHasAValue) {
    const std::string text = R"({"kinegraph": 1, "frame": 1,
      "points": {"O": [0, 0], "A": [3, 1], "P": [5, 4]}, "bodies": {"2": ["O", "A"], "3": ["A", "P"]},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}],
      "loads": [{"force": "F", "body": 3, "at": "P", "value": [2, 1]}], "effort": {"couple": "M", "body": 2},
      "find": ["virtual work"]})";
    const Solution solution = tests::solved(text);
    EXPECT_EQ(solution.displacements->freedoms.size(), 2U);
    EXPECT_FALSE(solution.displacements->balanced);
    EXPECT_FALSE(solution.displacements->efforts.at(0).value);
    EXPECT_FALSE(solution.displacements->efforts.at(0).ratio);
    EXPECT_FALSE(efforts_found(solution).at(0).value);
}

TEST(EffortRows, RandomLoadsAreBalancedAsByForces) {
    std::mt19937 random(20261123);
    std::uniform_real_distribution<double> any(-9, 9);
    const auto number = [&] { return std::to_string(any(random)); };
    for (int i = 0; i < 4; ++i) {
        std::string more = R"("masses": {"3": {"mass": 2, "centre": "A", "inertia": 0.01}}, "gravity": [0, -9.81],)";
        if (i % 2 == 1) more += R"("inertia forces": true,)";
        more += R"("loads": [{"force": "F", "body": 4, "at": "B", "value": [)" + number() + "," + number() +
                R"(]}, {"couple": "C", "body": 3, "value": )" + number() +
                R"(}, {"force": "H", "body": 3, "at": "A", "magnitude": )" + number() +
                R"(, "along": ["O", "B"]}], "effort": {"couple": "M", "body": 2})";
        Rows works(slider_crank(more), by_work()), forces(slider_crank(more), by_forces());
        for (const double turn : {-1.3, 2.9}) {
            const double expected = forces.at(turn, "effort M");
            EXPECT_NEAR(works.at(turn, "effort M"), expected, 1e-9 * std::max(1.0, std::abs(expected))) << more;
            EXPECT_NEAR(works.moved(turn).displacements->efforts.at(0).value->to_double(), expected,
                        1e-9 * std::max(1.0, std::abs(expected)));
        }
    }
}

}  // namespace
}  // namespace kinegraph::effort_rows_test
