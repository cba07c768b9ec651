// How the room of a page is split: compositions of the figures, a few shares of the lengths, every part its own best.
#include "render/sheet/page_split.hpp"

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

double use_of(double size) {
    constexpr double least = 30, price = 0.1;  // for each mm that it is smaller
    return std::log(size) - 40 / size - price * std::max(0.0, least - size);
}
double size_at(const Wanted& wanted, double scale) { return std::max(wanted.extent_x, wanted.extent_y) / scale; }
double worth_at(const Wanted& wanted, double scale) { return wanted.weight * use_of(size_at(wanted, scale)); }

double coarsest_worth(const Wanted& wanted, double needed) {
    if (wanted.empty || wanted.fills || wanted.asked || wanted.items > 1) return any_scale;
    // The size that is worth it, by halving.
    double least = 1e-3, enough = 1e4;
    if (wanted.weight * use_of(enough) < needed) return 0;
    for (int i = 0; i < 40; ++i) {
        const double size = std::sqrt(least * enough);
        (wanted.weight * use_of(size) < needed ? least : enough) = size;
    }
    return std::max(wanted.extent_x, wanted.extent_y) / enough;
}

double caption_height(const Wanted& wanted, double width) { return wanted.caption_width > width ? 11 : 7; }

std::optional<Division> best_division(const Wanted& wanted, const Box& room, double whole) {
    const double coarsest = coarsest_worth(wanted, worth_at(wanted, whole) - with_steps_price);
    std::optional<Division> best;
    const auto look_at = [&](const Box& figure_room, Spot corner, std::size_t arrangement) {
        const double scale = wanted.expected(figure_room.width(), figure_room.height()).scale;
        if (scale <= coarsest && (!best || scale < best->scale)) best = {figure_room, corner, arrangement, scale};
    };
    for (std::size_t k = 0; k < wanted.equations.size(); ++k) {
        const Block& block = wanted.equations[k];
        if (room.width() - block.width > 45 && block.height + 2 <= room.height())
            look_at(rectangle(room.min.x, room.min.y, room.max.x - block.width - 5, room.max.y),
                    {room.max.x - block.width, room.min.y + 2}, k);
        if (block.width <= room.width() && room.height() - block.height > 40)
            look_at(rectangle(room.min.x, room.min.y + block.height + 4, room.max.x, room.max.y), room.min, k);
    }
    return best;
}

double worth(const Wanted& wanted, const Box& cell, std::optional<double> force_scale) {
    if (wanted.empty) return cell.width() > 60 && cell.height() > 30 ? 0 : -6;
    const double width = cell.width(), height = cell.height() - caption_height(wanted, cell.width());
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
            best = std::max(best, worth_at(wanted, scale) + 0.04 * air);
        }
        return best;
    }
    constexpr double nothing = -6;
    const auto drawn = [&](double w, double h) -> double {
        if (w <= 0 || h <= 0) return nothing;
        const double room_x = std::max(w - wanted.rim_x, 12.0), room_y = std::max(h - wanted.rim_y, 12.0);
        auto [scale, lacks_details] = wanted.expected(w, h);
        if (scale == any_scale) return nothing;
        double penalty = lacks_details ? details_price : 0;
        if (wanted.asked) {
            if (*wanted.asked < std::max(wanted.extent_x / room_x, wanted.extent_y / room_y)) penalty += 3;
            scale = *wanted.asked;
        }
        if (wanted.to_force_scale && force_scale) scale = std::max(scale, *force_scale);
        // The step of the scale first, then the air that it leaves.
        const double air = std::log(std::max(wanted.extent_x / room_x, wanted.extent_y / room_y) / scale);
        return worth_at(wanted, scale) + 0.04 * air - penalty;
    };
    const double alone = drawn(width, height);
    if (!wanted.has_equations || alone <= nothing) return alone;
    double most = alone - with_steps_price;
    const double whole = wanted.asked.value_or(wanted.expected(width, height).scale);
    if (const auto division = best_division(wanted, rectangle(0, 0, width, height), whole))
        most = std::max(most, drawn(division->figure_room.width(), division->figure_room.height()));
    // A corner of a polygon is often free, as long as nobody has looked: counted as half.
    const Block& stack = wanted.equations.front();
    const bool taken = std::any_of(wanted.no_corner.begin(), wanted.no_corner.end(),
                                   [&](Spot room) { return width <= room.x + 1 && height <= room.y + 1; });
    return taken ? most : std::max(most, drawn(width - 0.5 * stack.width, height - 0.25 * stack.height) - 0.1);
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
