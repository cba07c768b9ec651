// Drawn figures: the drawings that a plan chose, each in its room. Chooses no room and no scale.
#pragma once

#include <map>
#include <vector>

#include "render/layout/measured_figures.hpp"
#include "render/layout/sheet_plan.hpp"

namespace kinegraph::render {

/// A figure and its room, relative to the upper left corner of its band.
struct DrawnFigure {
    std::size_t wanted = 0;
    Box room;
    int number = 0;
    double caption = 0;  ///< its height, mm
    Figure figure;
    std::vector<Mark> beside{};  ///< equations in a corner

    double height() const { return caption + figure.box.height(); }
};

class DrawnFigures {
public:
    /// By index of the band.
    using ByBand = std::map<std::size_t, std::vector<DrawnFigure>>;

    DrawnFigures(const DrawingContext& context, const WantedFigures& wanted, const Bands& bands,
                 const MeasuredFigures& measured)
        : context_(context), wanted_(wanted), bands_(bands), measured_(measured) {}

    /// Takes the drawings of a plan, numbers them, and letters their details (I, II, …).
    void take(const SheetPlan& plan);
    /// Adds optional content to the figures where their rooms have space for it.
    void enrich();

    ByBand& by_band() { return by_band_; }
    const ByBand& by_band() const { return by_band_; }

private:
    void set_in_corner(DrawnFigure& drawn, const Block& equations) const;

    const DrawingContext& context_;
    const WantedFigures& wanted_;
    const Bands& bands_;
    const MeasuredFigures& measured_;
    ByBand by_band_;
};

}  // namespace kinegraph::render
