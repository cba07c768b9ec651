// Free room: raster of the page, and the spots that marks cover.
#include "render/page/free_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/number/functions.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

Occupancy::Occupancy(double width, double height)
    : columns_(static_cast<int>(std::ceil(width))),
      rows_(static_cast<int>(std::ceil(height))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

void Occupancy::block(const Box& box) {
    const int left = std::clamp(static_cast<int>(std::floor(box.min.x)), 0, columns_);
    const int right = std::clamp(static_cast<int>(std::ceil(box.max.x)), 0, columns_);
    const int top = std::clamp(static_cast<int>(std::floor(box.min.y)), 0, rows_);
    const int bottom = std::clamp(static_cast<int>(std::ceil(box.max.y)), 0, rows_);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) cells_[index(x, y)] = 1;
}
void Occupancy::block(const std::vector<Spot>& spots) {
    for (const Spot spot : spots) {
        const int x = static_cast<int>(spot.x), y = static_cast<int>(spot.y);
        if (x >= 0 && y >= 0 && x < columns_ && y < rows_) cells_[index(x, y)] = 1;
    }
}
bool Occupancy::is_free(int row, int from, int to) const {
    return from >= to ||
           std::memchr(cells_.data() + index(from, row), 1, static_cast<std::size_t>(to - from)) == nullptr;
}
std::pair<double, double> Occupancy::longest_run(double left, double right, double top, double bottom) const {
    const int from = std::clamp(static_cast<int>(std::floor(left)), 0, columns_);
    const int to = std::clamp(static_cast<int>(std::ceil(right)), 0, columns_);
    std::pair<double, double> best{0, 0};
    int start = static_cast<int>(std::ceil(top));
    const int end = static_cast<int>(std::floor(bottom));
    const auto close = [&](int y, bool at_edge) {
        const double run_top = start + (start == static_cast<int>(std::ceil(top)) ? 0 : clear);
        const double run_bottom = y - (at_edge ? 0 : clear);
        if (run_bottom - run_top > best.second - best.first) best = {run_top, run_bottom};
    };
    for (int y = start; y < end; ++y) {
        if (is_free(y, from, to)) continue;
        close(y, false);
        start = y + 1;
    }
    close(end, true);
    return best;
}

bool Occupancy::has_free(int columns, int rows) const {
    if (columns <= 0 || rows <= 0) return true;
    std::vector<int> above(static_cast<std::size_t>(columns_), 0);  // free cells above, by column
    for (int y = 0; y < rows_; ++y) {
        const char* const row = cells_.data() + index(0, y);
        int side_by_side = 0;
        for (int x = 0; x < columns_; ++x) {
            int& free = above[static_cast<std::size_t>(x)];
            free = row[x] != 0 ? 0 : free + 1;
            side_by_side = free >= rows ? side_by_side + 1 : 0;
            if (side_by_side >= columns) return true;
        }
    }
    return false;
}

FreeBoxes::FreeBoxes(const Occupancy& page)
    : columns_(page.columns_),
      rows_(page.rows_),
      inked_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1), 0) {
    const auto width = static_cast<std::size_t>(columns_) + 1;
    for (std::size_t y = 1; y <= static_cast<std::size_t>(rows_); ++y) {
        int in_row = 0;
        for (std::size_t x = 1; x < width; ++x) {
            in_row += page.cells_[(y - 1) * (width - 1) + x - 1];
            inked_[y * width + x] = inked_[(y - 1) * width + x] + in_row;
        }
    }
}
bool FreeBoxes::has(const Box& box) const {
    // std::floor and std::ceil without a function call, for non-negative values; anything else gives 0.
    const auto cell = [](int at, int most) { return static_cast<std::size_t>(std::clamp(at, 0, most)); };
    const auto down = [](double at) { return static_cast<int>(at); };
    const auto up = [](double at) { return static_cast<int>(at) + (static_cast<int>(at) < at ? 1 : 0); };
    const std::size_t left = cell(down(box.min.x), columns_), right = cell(up(box.max.x), columns_);
    const std::size_t top = cell(down(box.min.y), rows_), bottom = cell(up(box.max.y), rows_);
    const auto width = static_cast<std::size_t>(columns_) + 1;
    return inked_[bottom * width + right] - inked_[top * width + right] ==
           inked_[bottom * width + left] - inked_[top * width + left];
}

namespace {

/// Calls see() with the spots that marks cover.
template <class See>
void look_over(const std::vector<Mark>& marks, See see) {
    const auto fill = [&](const Box& box) {
        for (double y = box.min.y; y < box.max.y + 0.9; y += 0.9)
            for (double x = box.min.x; x < box.max.x + 0.9; x += 0.9)
                see(Spot{std::min(x, box.max.x), std::min(y, box.max.y)});
    };
    const auto stroke = [&](Spot from, Spot to) {
        const int pieces = std::max(1, static_cast<int>(std::ceil(length(to - from) / 0.9)));
        for (int i = 0; i <= pieces; ++i) see(from + (static_cast<double>(i) / pieces) * (to - from));
    };
    for (const Mark& mark : marks) {
        if (const auto* path = std::get_if<Path>(&mark)) {
            if (path->filled) {
                fill(box_of(std::span(&mark, 1)));
                continue;
            }
            Spot pen, start;
            for (const Segment& segment : path->segments) {
                if (const auto* m = std::get_if<MoveTo>(&segment)) {
                    pen = start = m->to;
                } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                    stroke(pen, l->to);
                    pen = l->to;
                } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                    stroke(pen, c->control_1);
                    stroke(c->control_1, c->control_2);
                    stroke(c->control_2, c->to);
                    pen = c->to;
                } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                    const double sweep = a->to - a->from;
                    const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) * a->radius / 0.9)));
                    for (int i = 0; i <= pieces; ++i) {
                        const double angle = a->from + sweep * i / pieces;
                        pen = a->centre + a->radius * Spot{nearest::cos(angle), nearest::sin(angle)};
                        see(pen);
                    }
                } else {
                    stroke(pen, start);
                }
            }
        } else if (std::holds_alternative<TextMark>(mark)) {
            fill(box_of(std::span(&mark, 1)));
        }
    }
}

}  // namespace

std::vector<Spot> covered(const std::vector<Mark>& marks) {
    std::vector<Spot> spots;
    look_over(marks, [&](Spot spot) { spots.push_back(spot); });
    return spots;
}

std::optional<Spot> free_place(const std::vector<Mark>& marks, const Box& within, Spot size) {
    // How far the lower and the upper edge are occupied, from the left.
    const std::array<double, 2> tops{within.max.y - size.y, within.min.y};
    std::array<std::vector<double>, 2> taken;
    look_over(marks, [&](Spot spot) {
        for (std::size_t edge = 0; edge < tops.size(); ++edge)
            if (spot.y > tops[edge] - clear && spot.y < tops[edge] + size.y + clear) taken[edge].push_back(spot.x);
    });
    for (std::size_t edge = 0; edge < tops.size(); ++edge) {
        std::sort(taken[edge].begin(), taken[edge].end());
        double left = within.min.x;
        for (const double x : taken[edge]) {
            if (x - clear >= left + size.x) break;
            left = std::max(left, x + clear);
        }
        if (left + size.x <= within.max.x) return Spot{left, tops[edge]};
    }
    return std::nullopt;
}

}  // namespace kinegraph::render
