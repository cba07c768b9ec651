// Counts what covers each cell of a coarse raster; the largest rectangle of empty cells by a stack of heights, row by
// row.
#include "render/layout/spread_figures.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/number/index.hpp"
#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double cell = 2.5;              // mm
constexpr int least_side = 10;            // cells; narrower white separates, and is not seen as empty
constexpr double noticed = 0.08;          // of the content: smaller white needs no change
constexpr double clearly_smaller = 0.95;  // of the white before
constexpr double most_below = 30;         // mm, than where it stands: a figure stays near its caption
constexpr int rounds = 2;

class Raster {
public:
    explicit Raster(const Box& content)
        : origin_(content.min),
          columns_(static_cast<int>(content.width() / cell)),
          rows_(static_cast<int>(content.height() / cell)),
          covers_(at_index(columns_) * at_index(rows_)) {}

    void add(const std::vector<Spot>& spots, Spot moved, int count) {
        for (const Spot& spot : spots) {
            const Spot at = (1 / cell) * (spot + moved - origin_);
            if (at.x < 0 || at.y < 0 || at.x >= columns_ || at.y >= rows_) continue;
            covers_[at_index(static_cast<int>(at.y)) * at_index(columns_) + at_index(static_cast<int>(at.x))] += count;
        }
    }
    void cover(const Box& box) {
        std::vector<Spot> spots;
        for (double y = box.min.y; y < box.max.y; y += cell)
            for (double x = box.min.x; x < box.max.x; x += cell) spots.push_back({x, y});
        add(spots, {}, 1);
    }
    /// The area of the largest empty rectangle, as a fraction of all.
    double largest_empty() const {
        struct Step {
            int from, height;
        };
        std::vector<int> heights(at_index(columns_));
        std::vector<Step> steps;
        int largest = 0;
        for (int y = 0; y < rows_; ++y) {
            for (int x = 0; x <= columns_; ++x) {
                int height = 0, from = x;
                if (x < columns_) {
                    int& own = heights[at_index(x)];
                    height = own = covers_[at_index(y) * at_index(columns_) + at_index(x)] > 0 ? 0 : own + 1;
                }
                for (; !steps.empty() && steps.back().height >= height; steps.pop_back()) {
                    from = steps.back().from;
                    if (x - from >= least_side && steps.back().height >= least_side)
                        largest = std::max(largest, (x - from) * steps.back().height);
                }
                steps.push_back({from, height});
            }
            steps.clear();
        }
        return static_cast<double>(largest) / static_cast<double>(covers_.size());
    }

private:
    Spot origin_;
    int columns_, rows_;
    std::vector<int> covers_;  // number of spots in each cell
};

/// Where a figure may go, from where it stands; its own place comes first.
std::vector<Spot> moves_of(const MovableFigure& figure) {
    const double below = std::min(figure.down, most_below);
    const double across[] = {0, -0.5 * figure.left, 0.5 * figure.right, -figure.left, figure.right};
    const double down[] = {0, -0.5 * figure.up, 0.5 * below, -figure.up, below};
    std::vector<Spot> moves{{0, 0}};
    for (const double y : down)
        for (const double x : across)
            if (std::abs(x) >= cell || std::abs(y) >= cell) moves.push_back({x, y});
    return moves;
}

}  // namespace

void spread(std::vector<Mark>& marks, std::vector<MovableFigure> figures, const Box& content, const Box& block) {
    Raster page(content);
    page.cover(block);
    page.add(covered(marks), {}, 1);
    double white = page.largest_empty();
    for (int round = 0; round < rounds && white > noticed; ++round)
        for (MovableFigure& figure : figures) {
            const std::vector<Spot> moves = moves_of(figure);
            if (moves.size() == 1) continue;
            const std::span<Mark> own = std::span(marks).subspan(figure.first, figure.end - figure.first);
            const std::vector<Spot> spots = covered({own.begin(), own.end()});
            page.add(spots, {}, -1);
            Spot best{};
            for (const Spot& by : moves) {
                page.add(spots, by, 1);
                if (const double left = page.largest_empty(); left < clearly_smaller * white) white = left, best = by;
                page.add(spots, by, -1);
            }
            move(own, best.x, best.y);
            figure.left += best.x, figure.right -= best.x, figure.up += best.y, figure.down -= best.y;
            page.add(spots, best, 1);
        }
}

}  // namespace kinegraph::render
