// Counts what covers each cell of a coarse raster; the largest rectangle of empty cells by a stack of heights, row by
// row.
#include "render/layout/spread_figures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/number/index.hpp"
#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double cell = 3;                // mm
constexpr int least_side = 8;             // cells; narrower white separates, and is not seen as empty
constexpr double noticed = 0.1;           // of the content: smaller white needs no change
constexpr double clearly_smaller = 0.98;  // of the white before
constexpr int rounds = 3;

struct Cell {
    int x = 0, y = 0;
    bool operator==(const Cell&) const = default;
};

class Raster {
public:
    explicit Raster(const Box& content)
        : origin_(content.min),
          columns_(static_cast<int>(content.width() / cell)),
          rows_(static_cast<int>(content.height() / cell)),
          words_((at_index(columns_) + 63) / 64),
          covers_(at_index(columns_) * at_index(rows_)),
          covered_(words_ * at_index(rows_)),
          floors_(at_index(columns_)) {}

    /// The cells that marks cover, each once.
    std::vector<Cell> cells_of(std::span<const Mark> marks) const {
        std::vector<Cell> cells;
        for (const Spot& spot : covered(marks))
            if (const Cell at = cell_of(spot); cells.empty() || cells.back() != at) cells.push_back(at);
        std::sort(cells.begin(), cells.end(),
                  [](Cell one, Cell other) { return std::pair(one.y, one.x) < std::pair(other.y, other.x); });
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        return cells;
    }
    std::vector<Cell> cells_of(const Box& box) const {
        std::vector<Cell> cells;
        const Cell first = cell_of(box.min), last = cell_of(box.max);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) cells.push_back({x, y});
        return cells;
    }
    void add(const std::vector<Cell>& cells, Cell moved, int count) {
        for (const Cell& each : cells) {
            const int x = each.x + moved.x, y = each.y + moved.y;
            if (x >= 0 && y >= 0 && x < columns_ && y < rows_) cover(at_index(x), at_index(y), count);
        }
    }
    /// The area of the largest empty rectangle, as a fraction of all; `enough`, if it is not smaller than that.
    double largest_empty(double enough) {
        const double all = static_cast<double>(covers_.size());
        std::fill(floors_.begin(), floors_.end(), 0);
        int largest = 0;
        for (int y = 0; y < rows_; ++y) {
            // Where nothing begins below this row, every rectangle goes on there.
            bool begins = y + 1 == rows_;
            for (std::size_t word = 0; word < words_ && !begins; ++word)
                begins = (~row(y)[word] & row(y + 1)[word]) != 0;
            if (begins) {
                largest = std::max(largest, largest_on_row(y));
                if (largest >= enough * all) return enough;
            }
            for (std::size_t word = 0; word < words_ && y + 1 < rows_; ++word)
                for (std::uint64_t ended = row(y)[word] & ~row(y + 1)[word]; ended != 0; ended &= ended - 1)
                    floors_[64 * word + static_cast<std::size_t>(std::countr_zero(ended))] = y + 1;
        }
        return largest / all;
    }

private:
    void cover(std::size_t x, std::size_t y, int count) {
        const int covers = covers_[y * at_index(columns_) + x] += count;
        const std::uint64_t bit = std::uint64_t{1} << (x % 64);
        std::uint64_t& word = covered_[y * words_ + x / 64];
        word = covers > 0 ? word | bit : word & ~bit;
    }
    const std::uint64_t* row(int y) const { return &covered_[at_index(y) * words_]; }
    /// The cells of the largest empty rectangle that stands on a row.
    int largest_on_row(int y) {
        int largest = 0;
        steps_.clear();
        for (int x = 0; x <= columns_; ++x) {
            const bool is_empty = x < columns_ && ((row(y)[x / 64] >> (x % 64)) & 1U) == 0;
            const int height = is_empty ? y + 1 - floors_[at_index(x)] : 0;
            if (x < columns_ && !steps_.empty() && steps_.back().height == height) continue;
            int from = x;
            for (; !steps_.empty() && steps_.back().height >= height; steps_.pop_back()) {
                from = steps_.back().from;
                if (x - from >= least_side && steps_.back().height >= least_side)
                    largest = std::max(largest, (x - from) * steps_.back().height);
            }
            steps_.push_back({from, height});
        }
        return largest;
    }
    Cell cell_of(Spot spot) const {
        return {static_cast<int>(std::floor((spot.x - origin_.x) / cell)),
                static_cast<int>(std::floor((spot.y - origin_.y) / cell))};
    }

    Spot origin_;
    int columns_, rows_;
    std::size_t words_;                   // of 64 cells, in a row
    std::vector<int> covers_;             // number of figures, or of what stands, in each cell
    std::vector<std::uint64_t> covered_;  // whether there are any, a bit for each cell
    std::vector<int> floors_;             // the first row of the empty cells of each column that end in a row
    struct Step {
        int from, height;
    };
    std::vector<Step> steps_;  // of the heights in a row, as far as they ascend
};

/// Where a figure may go, in whole cells from where it stands.
std::vector<Cell> moves_of(const MovableFigure& figure) {
    const auto cells = [](double length) { return static_cast<int>(length / cell); };
    std::vector<Cell> moves;
    constexpr double parts[] = {0, -0.5, 0.5, -1, 1};  // of the way to the end of its room
    for (const double up : parts)
        for (const double left : parts) {
            const double x = left * (left < 0 ? figure.left : figure.right),
                         y = up * (up < 0 ? figure.up : figure.down);
            if (const Cell by{cells(x), cells(y)}; by != Cell{}) moves.push_back(by);
        }
    return moves;
}

}  // namespace

std::vector<Spot> spread(std::vector<Mark>& marks, std::vector<MovableFigure> figures, const Box& content,
                         const Box& block) {
    Raster page(content);
    page.add(page.cells_of(block), {}, 1);
    std::vector<std::vector<Cell>> cells;
    std::size_t next = 0;
    const auto add = [&](std::size_t first, std::size_t end) {
        std::vector<Cell> own = page.cells_of(std::span(std::as_const(marks)).subspan(first, end - first));
        page.add(own, {}, 1);
        next = end;
        return own;
    };
    for (const MovableFigure& figure : figures) {
        add(next, figure.first);
        cells.push_back(add(figure.first, figure.end));
    }
    add(next, marks.size());
    std::vector<Spot> moved(figures.size());
    double white = page.largest_empty(1);
    for (int round = 0; round < rounds && white > noticed; ++round)
        for (std::size_t f = 0; f < figures.size(); ++f) {
            MovableFigure& figure = figures[f];
            page.add(cells[f], {}, -1);
            Cell best;
            for (const Cell& by : moves_of(figure)) {
                const double enough = clearly_smaller * white;
                page.add(cells[f], by, 1);
                if (const double left = page.largest_empty(enough); left < enough) white = left, best = by;
                page.add(cells[f], by, -1);
            }
            for (Cell& each : cells[f]) each = {each.x + best.x, each.y + best.y};
            page.add(cells[f], {}, 1);
            const double x = best.x * cell, y = best.y * cell;
            move(std::span(marks).subspan(figure.first, figure.end - figure.first), x, y);
            figure.left += x, figure.right -= x, figure.up += y, figure.down -= y;
            moved[f] = moved[f] + Spot{x, y};
        }
    return moved;
}

}  // namespace kinegraph::render
