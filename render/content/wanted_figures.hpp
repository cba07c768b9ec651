// Wanted figures: the figures that a solution can show, in the order of the sheet, each with its size. Chooses no
// position; computes no mechanics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_parts.hpp"
#include "render/figures/figure_table.hpp"

namespace kinegraph::render {

constexpr double hardly_readable = 10;  // mm, the longer extent of a figure

/// A figure to be placed.
struct Wanted : SizeWanted {
    FigureId id;
};

class WantedFigures {
public:
    /// `joukowsky`: with the lever, if there is one. Brief: instant centres only if the file asks for them.
    WantedFigures(const DrawingContext& context, bool joukowsky, SolutionDetail detail = SolutionDetail::full,
                  SuperposedLoads superposed = SuperposedLoads::joined);

    std::vector<Wanted> list;

    const Shown& shown() const { return shown_; }
    /// Index into list; empty if the solution cannot show it.
    std::optional<std::size_t> named(FigureId id) const;
    /// The name of a figure of the list in the command line.
    std::string name(std::size_t figure) const { return name_of(shown_.solution(), list[figure].id); }
    /// The name under which its scale is kept for other sheets, where it may show less.
    std::string kept_as(FigureId id) const {
        return name_of(shown_.solution(), {row_of(id.kind).plain.value_or(id.kind), id.of, id.part});
    }
    Figure draw(std::size_t figure, Spot room, const ScaleWish& wish) const {
        return draw_figure(shown_, list[figure].id, room, wish);
    }
    /// In a room, at the scale in the file if it has room at that.
    Figure draw_in(std::size_t figure, Spot room) const { return draw(figure, room, {0, list[figure].asked}); }
    /// With optional content. Empty and at any_scale if there is none, or no space for it.
    Figure enriched(std::size_t figure, const Figure& plain, Spot room) const;
    /// Whether a superposition is drawn by one polygon a body.
    bool joins_parts() const;
    /// The polygon of a body that joins its partial forces, "parts-3", where a superposition is drawn so.
    std::optional<FigureId> joined_parts_of(const FreeBody& body) const;
    /// Whether another figure of the superposition is drawn in place of it; it is shown if it is asked for.
    bool is_replaced(FigureId id) const;

private:
    void keep_forces_readable();

    Shown shown_;
    SuperposedLoads superposed_;
};

}  // namespace kinegraph::render
