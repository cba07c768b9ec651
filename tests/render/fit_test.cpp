// The search for a figure's scale: what is tried in which order, and what is taken.
#include "render/figures/fit.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace fit_test {
namespace {

using namespace kinegraph::render;

/// A square of so many units, and what was tried on the way.
struct Square {
    double units = 100;
    double lettering = 0;  // mm that names add to its width, whatever the scale
    std::vector<Trial> trials{};

    Figure operator()(const Trial& trial) {
        trials.push_back(trial);
        Figure figure = Figure::empty_at(trial.scale);
        const double side = units / trial.scale;
        figure.box = rectangle(0, 0, side + (trial.strict ? 0 : lettering), side);
        return figure;
    }
};
Figure fit_square(const FitPolicy& policy, Square& square) {
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> { return square(trial); });
}

TEST(Fit, TakesTheLargestScaleAtWhichTheFigureHasRoom) {
    Square square{100, 15};
    const Figure figure = fit_square({.room = Spot{60, 60}, .first = 1}, square);
    EXPECT_EQ(figure.scale, 2.5);  // 100/2 + 15 is too wide
    ASSERT_EQ(square.trials.size(), 3u);
    EXPECT_EQ(square.trials[1].scale, 2);
    EXPECT_EQ(square.trials[1].number, 1);
}

TEST(Fit, TriesTheFilesScaleFirstAndKeepsItIfThereIsRoom) {
    FitPolicy policy{.room = Spot{60, 60}, .first = 1, .asked = 1.25};
    Square square;
    EXPECT_EQ(fit_square(policy, square).scale, 2);
    EXPECT_TRUE(square.trials.front().asked);
    EXPECT_EQ(square.trials.front().scale, 1.25);
    policy.asked = 4;
    EXPECT_EQ(fit_square(policy, square).scale, 4);
}

TEST(Fit, KeepsNamesInTheRoomWhereThatIsWanted) {
    Square square{100, 50};
    const Figure figure = fit_square({.room = Spot{60, 60}, .first = 2, .strict = true}, square);
    EXPECT_EQ(figure.scale, 2);
    EXPECT_TRUE(square.trials.front().strict);
}

TEST(Fit, HasNamesStayInTheRoomAtHalfTheScaleOfTheFigure) {
    Square square{100, 50};
    const Figure figure = fit_square({.room = Spot{60, 60}, .first = 2, .names_stay_in_room = true}, square);
    EXPECT_EQ(figure.scale, 5);  // 4 is no scale
    EXPECT_TRUE(square.trials.back().strict);
    EXPECT_LE(figure.box.width(), 60);
}

TEST(Fit, TakesTheLastTrialAsItComes) {
    Square square{100, 70};
    EXPECT_EQ(fit_square({.room = Spot{60, 60}, .first = 1, .most_trials = 2}, square).scale, 2.5);
    EXPECT_TRUE(square.trials.back().last);
    // … or the smallest that still shows ten millimetres of it.
    Square small{100, 70};
    EXPECT_EQ(fit_square({.room = Spot{60, 60}, .first = 1, .extent = 100, .least_shown = 10}, small).scale, 10);
}

TEST(Fit, SkipsWhatADrawingDoesNotFinish) {
    int asked = 0;
    const Figure figure = fit({.room = std::nullopt, .first = 1}, [&](const Trial& trial) -> std::optional<Figure> {
        ++asked;
        if (trial.scale < 5) return std::nullopt;
        return Figure::empty_at(trial.scale);
    });
    EXPECT_EQ(figure.scale, 5);
    EXPECT_EQ(asked, 4);
}

/// 130 units in 165 mm: 0.8 a millimetre has room and is none of 1, 2, 2.5 and 5.
TEST(Fit, BeginsWithTheFinestScaleThatIsAllowedWhereTheExtentsHaveRoom) {
    EXPECT_EQ(first_scale({130, 1}, {165, 100}, 0.8), 0.8);
    EXPECT_EQ(first_scale({1, 130}, {100, 165}, 0.8), 0.8);
    EXPECT_EQ(first_scale({130, 1}, {160, 100}, 0.8), 1);
    EXPECT_EQ(first_scale({130, 1}, {165, 100}, 0), 1);
    EXPECT_EQ(first_scale({130, 1}, {165, 100}, 3), 3);
}

}  // namespace
}  // namespace fit_test
