// Free room: raster of the page, and the spots that marks cover.
#include "render/page/free_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/number/functions.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

Occupancy::Occupancy(Spot origin, Spot size, const std::vector<Spot>& inked)
    : origin_(origin), columns_(static_cast<int>(std::ceil(size.x))), rows_(static_cast<int>(std::ceil(size.y))) {
    const auto cell_of = [](Spot spot) { return Cell{static_cast<int>(spot.x), static_cast<int>(spot.y)}; };
    const auto is_within = [&](Spot spot) { return spot.x >= 0 && spot.y >= 0 && spot.x < columns_ && spot.y < rows_; };
    first_ = {columns_, rows_};
    end_ = {0, 0};
    for (const Spot& each : inked) {
        const Spot spot = each - origin;
        if (!is_within(spot)) continue;
        const Cell cell = cell_of(spot);
        first_ = {std::min(first_.x, cell.x), std::min(first_.y, cell.y)};
        end_ = {std::max(end_.x, cell.x + 1), std::max(end_.y, cell.y + 1)};
    }
    if (end_.x == 0) first_ = end_;
    const std::size_t width = corners_in_a_row();
    inked_.assign(width * (static_cast<std::size_t>(end_.y - first_.y) + 1), 0);
    for (const Spot& each : inked) {
        const Spot spot = each - origin;
        if (!is_within(spot)) continue;
        const Cell cell = cell_of(spot);
        inked_[(static_cast<std::size_t>(cell.y - first_.y) + 1) * width + static_cast<std::size_t>(cell.x - first_.x) +
               1] = 1;
    }
    for (std::size_t row = width; row < inked_.size(); row += width) {
        int in_row = 0;
        for (std::size_t corner = row + 1; corner < row + width; ++corner) {
            in_row += inked_[corner];
            inked_[corner] = in_row + inked_[corner - width];
        }
    }
}

int Occupancy::inked_in(int left, int right, int top, int bottom) const {
    const auto at = [&](int x, int y) {
        return inked_[static_cast<std::size_t>(std::clamp(y, first_.y, end_.y) - first_.y) * corners_in_a_row() +
                      static_cast<std::size_t>(std::clamp(x, first_.x, end_.x) - first_.x)];
    };
    return at(right, bottom) - at(right, top) - at(left, bottom) + at(left, top);
}

bool Occupancy::is_free(const Box& box) const {
    // std::floor and std::ceil without a function call, for non-negative values; anything else gives 0.
    const auto down = [](double at, int most) { return std::clamp(static_cast<int>(at), 0, most); };
    const auto up = [](double at, int most) {
        return std::clamp(static_cast<int>(at) + (static_cast<int>(at) < at ? 1 : 0), 0, most);
    };
    const Spot min = box.min - origin_, max = box.max - origin_;
    return inked_in(down(min.x, columns_), up(max.x, columns_), down(min.y, rows_), up(max.y, rows_)) == 0;
}

bool Occupancy::has_free(int columns, int rows) const {
    if (columns <= 0 || rows <= 0) return true;
    if (columns > columns_ || rows > rows_) return false;
    // Beside everything that is inked.
    if (columns <= std::max(first_.x, columns_ - end_.x) || rows <= std::max(first_.y, rows_ - end_.y)) return true;
    for (int y = 0; y + rows <= rows_; ++y)
        for (int x = 0; x + columns <= columns_; ++x)
            if (inked_in(x, x + columns, y, y + rows) == 0) return true;
    return false;
}

namespace {

/// In how many pieces of a millimetre or less something is looked at; what is longer than every paper, in the trials of
/// a figure, is looked at in longer ones.
int pieces_of(double length, int least) {
    constexpr double piece = 0.9, most = 2000;
    return std::max(least, static_cast<int>(std::ceil(std::min(length / piece, most))));
}

/// Calls see() with the spots that marks cover.
template <class See>
void look_over(std::span<const Mark> marks, See see) {
    const auto fill = [&](const Box& box) {
        const int rows = pieces_of(box.height(), 0), columns = pieces_of(box.width(), 0);
        const double down = std::max(0.9, box.height() / std::max(rows, 1));
        const double right = std::max(0.9, box.width() / std::max(columns, 1));
        for (int row = 0; row <= rows; ++row)
            for (int column = 0; column <= columns; ++column)
                see(Spot{std::min(box.min.x + column * right, box.max.x), std::min(box.min.y + row * down, box.max.y)});
    };
    const auto stroke = [&](Spot from, Spot to) {
        const int pieces = pieces_of(length(to - from), 1);
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
                    const int pieces = pieces_of(std::abs(sweep) * a->radius, 2);
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

std::vector<Spot> covered(std::span<const Mark> marks) {
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
