// How figures share a room: held against the search as it reads, step by step for each room anew.
#include "render/layout/figure_shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "render/content/sheet_parts.hpp"

namespace kinegraph::render {
namespace {

using Sizes = std::vector<std::vector<FigureSize>>;

/// Of a few figures at a few scales each; a coarser one may take more, for letters crowd, and some may be left out.
Sizes random_sizes(std::mt19937& random) {
    const auto some = [&](int low, int high) {
        return static_cast<double>(std::uniform_int_distribution(low, high)(random));
    };
    Sizes sizes(std::uniform_int_distribution<std::size_t>(1, 4)(random));
    for (std::vector<FigureSize>& figure : sizes) {
        double scale = 1, x = some(40, 120), y = some(30, 90), worth = some(1, 5);
        for (std::size_t i = 0, count = static_cast<std::size_t>(some(1, 6)); i < count; ++i) {
            figure.push_back({x, y, worth, scale, some(0, 20)});
            scale *= 2, x += some(-30, 3), y += some(-20, 3), worth -= 0.1 * some(0, 9);
        }
        if (some(0, 4) == 0) figure.push_back({});
    }
    return sizes;
}

double along(const FigureSize& size, FigureShares::Order order) {
    return order.stacked ? size.y : size.x + (order.cornered ? size.wider : 0);
}

/// Each as large as the room is wide enough for; then, until they fit, the one that loses least for what it gives.
std::optional<std::vector<std::size_t>> searched(const Sizes& sizes, Spot room, FigureShares::Order order) {
    const double whole = order.stacked ? room.y : room.x, wide = order.stacked ? room.x : room.y;
    const auto next = [&](std::size_t f, std::size_t i) {
        while (i < sizes[f].size() && (order.stacked ? sizes[f][i].x : sizes[f][i].y) > wide) ++i;
        return i;
    };
    std::vector<std::size_t> taken;
    for (std::size_t f = 0; f < sizes.size(); ++f) {
        taken.push_back(next(f, 0));
        if (taken[f] == sizes[f].size()) return std::nullopt;
    }
    for (;;) {
        double sum = 0;
        for (std::size_t f = 0; f < sizes.size(); ++f)
            if (const double own = along(sizes[f][taken[f]], order); own > 0) sum += own + (sum > 0 ? gap : 0);
        if (sum <= whole) return taken;
        std::optional<std::size_t> smaller;
        double least = 0;
        for (std::size_t f = 0; f < sizes.size(); ++f) {
            const std::size_t coarser = next(f, taken[f] + 1);
            if (coarser == sizes[f].size()) continue;
            const FigureSize &now = sizes[f][taken[f]], &then = sizes[f][coarser];
            const double price = (now.worth - then.worth) / std::max(along(now, order) - along(then, order), 0.1);
            if (!smaller || price < least) smaller = f, least = price;
        }
        if (!smaller) return std::nullopt;
        taken[*smaller] = next(*smaller, taken[*smaller] + 1);
    }
}

TEST(FigureShares, AreThoseOfASearchInEachRoom) {
    std::mt19937 random(7);
    int found = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Sizes sizes = random_sizes(random);
        const FigureShares shares(sizes);
        for (int room = 0; room < 60; ++room) {
            const Spot size{std::uniform_real_distribution(20.0, 400.0)(random),
                            std::uniform_real_distribution(20.0, 250.0)(random)};
            const FigureShares::Order order{room % 2 == 0, room % 4 > 1};
            const auto expected = searched(sizes, size, order);
            const auto share = shares.in(size, order);
            ASSERT_EQ(expected.has_value(), share.has_value());
            if (!share) continue;
            ++found;
            EXPECT_EQ(*expected, shares.taken_in(size, order));
            double worth = 0;
            for (std::size_t f = 0; f < sizes.size(); ++f) worth += sizes[f][(*expected)[f]].worth;
            EXPECT_EQ(share->worth, worth);
            EXPECT_LE(share->worth, shares.most_worth_in(size));
        }
    }
    EXPECT_GT(found, 1000);
}

TEST(FigureShares, OfNoFiguresHaveRoomEverywhere) {
    const FigureShares none;
    const auto share = none.in({1, 1}, {});
    ASSERT_TRUE(share);
    EXPECT_EQ(share->worth, 0);
    EXPECT_EQ(share->shown, 0);
    EXPECT_TRUE(none.taken_in({1, 1}, {}).empty());
    EXPECT_FALSE(none.in({-1, 1}, {}));
}

}  // namespace
}  // namespace kinegraph::render
