// How the room of a page is split among figures: all columns and rows of cells, valued by the size of what they would hold.
#pragma once

#include <optional>
#include <vector>

#include "render/sheet/sheet_parts.hpp"
#include "render/sheet/wanted_figures.hpp"

namespace kinegraph::render {

/// Cells of a page, columns of them or rows.
struct Split {
    std::vector<Box> cells;
    double value = -1e300;
};

/// What a figure of this size (mm) is worth: in steps of the scale, and small ones hardly anything.
double use_of(double size);
constexpr double with_steps_price = 0.5;  ///< of equations that stand with the steps, not beside their polygon
constexpr double details_price = 1;       ///< of a polygon that lacks its details
/// How large a figure is at a scale, mm, without its letters; what that is worth.
double size_at(const Wanted& wanted, double scale);
double worth_at(const Wanted& wanted, double scale);
/// The coarsest scale at which a figure is worth as much as is needed; any_scale where its scale does not tell.
double coarsest_worth(const Wanted& wanted, double needed);
/// How large a figure would be drawn in a cell, and what that is worth. `force_scale`: as WantedFigures has it.
double worth(const Wanted& wanted, const Box& cell, std::optional<double> force_scale);

/// What a caption takes of a cell's height.
double caption_height(const Wanted& wanted, double width);
/// A room divided between a figure and its equations.
struct Division {
    Box figure_room;
    Spot corner;  ///< of the equations
    std::size_t arrangement = 0;
    double scale = 0;  ///< expected of the figure
};
/// The division that leaves the figure largest; none where it would come so small that the equations had better stand with the
/// steps. `whole`: the figure's scale in the whole room.
std::optional<Division> best_division(const Wanted& wanted, const Box& room, double whole);
/// The split of an area among `count` figures from `first` on that is worth most, no cell over the title block.
Split best_split(const WantedFigures& figures, std::size_t first, std::size_t count, const Box& area, const SheetFormat& format);

}  // namespace kinegraph::render
