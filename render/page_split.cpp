// How the room of a page is split: compositions of the figures, a few shares of the lengths, every part its own best.
#include "render/page_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/assert.hpp"

namespace kinegraph::render {
namespace {

void compositions(int n, int parts_left, std::vector<int>& now, std::vector<std::vector<int>>& all) {
    if (n == 0) {
        all.push_back(now);
        return;
    }
    if (parts_left == 0) return;
    for (int k = 1; k <= n; ++k) {
        now.push_back(k);
        compositions(n - k, parts_left - 1, now, all);
        now.pop_back();
    }
}
/// Shares of a length among n, a few of them.
using Shares = std::vector<std::vector<double>>;
const Shares& shares(std::size_t n) {
    static const std::array<Shares, 6> of{
        Shares{{1}},
        Shares{{0.5, 0.5}, {0.56, 0.44}, {0.44, 0.56}, {0.62, 0.38}, {0.38, 0.62}, {0.68, 0.32}, {0.32, 0.68}},
        Shares{{0.34, 0.33, 0.33},
               {0.4, 0.3, 0.3},
               {0.3, 0.4, 0.3},
               {0.3, 0.3, 0.4},
               {0.46, 0.27, 0.27},
               {0.27, 0.46, 0.27},
               {0.27, 0.27, 0.46}},
        Shares{std::vector<double>(4, 1.0 / 4)},
        Shares{std::vector<double>(5, 1.0 / 5)},
        Shares{std::vector<double>(6, 1.0 / 6)}};
    KG_ASSERT(n >= 1 && n <= of.size(), "a page holds six figures at most");
    return of[n - 1];
}

void cut_at_block(Box& cell, const Box& block) {
    if (cell.max.y > block.min.y - 4 && cell.max.x > block.min.x - 4) cell.max.y = block.min.y - 4;
}

}  // namespace

double use_of(double size) { return std::log(size) - 40 / size; }

double worth(const Wanted& wanted, const Box& cell, std::optional<double> force_scale) {
    if (wanted.empty) return cell.width() > 60 && cell.height() > 30 ? 0 : -6;
    const double width = cell.width(), height = cell.height() - 8;
    if (wanted.fills) {
        const double room_x = width - wanted.rim_x, room_y = height - wanted.rim_y;
        if (room_x < 5 || room_y < 5) return -6;
        const double enlarged = std::min(room_x / wanted.extent_x, room_y / wanted.extent_y);
        return wanted.weight * use_of(std::max(12.0, std::max(wanted.extent_x, wanted.extent_y) * enlarged));
    }
    if (wanted.items > 1) {
        // In rows, each with names above and tables below.
        double best = -6;
        for (int rows = 1; rows <= wanted.items; ++rows) {
            const int across = (wanted.items + rows - 1) / rows;
            const double room_x = width - wanted.rim_x - 12 * (across - 1), room_y = height - wanted.rim_y - 14 * rows;
            if (room_x < 12 || room_y < 12) continue;
            const double extent_x = wanted.extent_x / rows, extent_y = wanted.extent_y * rows;
            double scale = choose_scale(extent_x, extent_y, room_x, room_y, std::nullopt);
            if (wanted.asked && !force_scale) scale = std::max(scale, *wanted.asked);
            scale = std::max(scale, force_scale.value_or(0));
            const double air = std::log(std::max(extent_x / room_x, extent_y / room_y) / scale);
            best = std::max(best, wanted.weight * use_of(std::max(wanted.extent_x, wanted.extent_y) / scale) + 0.04 * air);
        }
        return best;
    }
    const auto drawn = [&](double w, double h) -> double {
        const double room_x = w - wanted.rim_x, room_y = h - wanted.rim_y;
        if (room_x < 12 || room_y < 12) return -6;
        double scale = choose_scale(wanted.extent_x, wanted.extent_y, room_x, room_y, std::nullopt);
        double penalty = 0;
        if (wanted.asked) {
            if (*wanted.asked < std::max(wanted.extent_x / room_x, wanted.extent_y / room_y)) penalty = 3;
            scale = *wanted.asked;
        }
        if (wanted.to_force_scale && force_scale) scale = std::max(scale, *force_scale);
        // The step of the scale first, then the air that it leaves.
        const double air = std::log(std::max(wanted.extent_x / room_x, wanted.extent_y / room_y) / scale);
        return wanted.weight * use_of(std::max(wanted.extent_x, wanted.extent_y) / scale) + 0.04 * air - penalty;
    };
    if (wanted.equations.empty()) return drawn(width, height);
    double stack_width = 0, stack_height = 0;
    for (const Block& block : wanted.equations) {
        stack_width = std::max(stack_width, block.width);
        stack_height += block.height + 4;
    }
    // A corner of a polygon is often free: counted as half.
    return std::max({drawn(width - stack_width - 4, height), drawn(width, height - stack_height),
                     drawn(width - 0.5 * stack_width, height - 0.25 * stack_height) - 0.1});
}

Split best_split(const WantedFigures& figures, std::size_t first, std::size_t count, const Box& area, const SheetFormat& format) {
    std::vector<std::vector<int>> all;
    std::vector<int> now;
    compositions(static_cast<int>(count), 3, now, all);
    Split best, split;
    std::vector<Box> cells, best_cells;  // of a part
    for (const bool transposed : {false, true})
        for (const auto& composition : all) {
            if (transposed && (composition.size() == 1 || composition.size() == count)) continue;  // met already
            for (const auto& outer : shares(composition.size())) {
                // Every part its own best inner shares.
                split.value = 0;
                split.cells.clear();
                std::size_t index = first;
                const double whole = transposed ? area.height() : area.width();
                double at = transposed ? area.min.y : area.min.x;
                for (std::size_t part = 0; part < composition.size(); ++part) {
                    const double extent = outer[part] * (whole - gap * static_cast<double>(composition.size() - 1));
                    const auto parts = static_cast<std::size_t>(composition[part]);
                    double most = -1e300;
                    for (const auto& inner : shares(parts)) {
                        const double across = (transposed ? area.width() : area.height()) - gap * static_cast<double>(parts - 1);
                        double along = transposed ? area.min.x : area.min.y;
                        double value = 0;
                        cells.clear();
                        for (std::size_t k = 0; k < parts; ++k) {
                            const double size = inner[k] * across;
                            Box cell = transposed ? rectangle(along, at, along + size, at + extent)
                                                  : rectangle(at, along, at + extent, along + size);
                            cut_at_block(cell, format.block);
                            value += worth(figures.list[index + k], cell, figures.force_scale);
                            cells.push_back(cell);
                            along += size + gap;
                        }
                        if (value > most + 1e-9) {
                            most = value;
                            best_cells.swap(cells);
                        }
                    }
                    split.value += most;
                    split.cells.insert(split.cells.end(), best_cells.begin(), best_cells.end());
                    at += extent + gap;
                    index += parts;
                }
                if (split.value > best.value + 1e-9) best = split;
            }
        }
    return best;
}

}  // namespace kinegraph::render
