// Fit: searches for the finest scale at which a figure with its labels has room, by drawing it at ever coarser scales.
// Depends on no figure's content.
#pragma once

#include <functional>
#include <optional>

#include "render/page/figure.hpp"
#include "render/page/scale.hpp"

namespace kinegraph::render {

/// One attempt to draw a figure.
struct Trial {
    double scale = 1;
    int number = 0;       ///< from 0
    bool last = false;    ///< its result is accepted in any case
    bool strict = false;  ///< names must accept any position in the room
    bool asked = false;   ///< the scale is that of the file
};

/// Limits on the scale of a figure beside its room.
struct ScaleWish {
    double finest = 0;              ///< units per mm; 0: the finest with room
    std::optional<double> asked{};  ///< tried first, in units per mm; kept if the figure has room at it
    bool strict = false;            ///< names keep to the room even where they stand worse
    /// At no coarser scale than the finest that is allowed: without room at that, the figure is empty and at any_scale.
    bool exactly = false;
    /// Of vectors that have a scale of their own: how long the longest of them is at least, mm. 0: as the room allows.
    double arrow = 0;
    /// The scale of these vectors, units per mm: the coarsest, or that of all if no length is asked for. 0: any.
    double vectors = 0;
    /// The steps of the solution stand beside it: what they say a small figure need not say, too.
    bool has_steps = false;
};

struct FitPolicy {
    std::optional<Spot> room;       ///< that the figure must fit into, mm; none: `draw` decides whether it fits
    double first = 1;               ///< first scale, units per mm
    std::optional<double> asked{};  ///< scale in the file, tried first
    bool strict = false;            ///< names keep to the room in every trial
    bool exactly = false;           ///< see ScaleWish::exactly: there is one trial
    int most_trials = 12;           ///< before the last one
    double extent = 0;              ///< of the figure in units; if given, the last trial is the coarsest one …
    double least_shown = 0;         ///< … that shows at least this many mm of it
    /// Stops at half the size at which the figure without names has room, because names do not shrink; names accept any
    /// position there.
    bool names_stay_in_room = false;
};

/// The scale to try first: `finest` if the extents have room at it, otherwise the finest of the series at which they
/// have.
double first_scale(Spot extents, Spot room, double finest);

/// `draw` returns nothing to reject a trial; the next coarser scale follows. It must return a figure for the last
/// trial.
Figure fit(const FitPolicy& policy, const std::function<std::optional<Figure>(const Trial&)>& draw);

}  // namespace kinegraph::render
