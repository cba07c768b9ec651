// Fit: the one search for the scale at which a figure has room. The figure is drawn at ever smaller scales until
// everything, labels too, is within the room. Knows no figure's content.
#pragma once

#include <functional>
#include <optional>

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// What the search asks of a drawing.
struct Trial {
    double scale = 1;
    int number = 0;       ///< from 0
    bool last = false;    ///< it is taken as it comes
    bool strict = false;  ///< names must take what room there is
    bool asked = false;   ///< the scale is the file's
};

struct FitPolicy {
    std::optional<Spot> room;       ///< that a figure must be within, mm; none: the drawing says itself whether it fits
    double first = 1;               ///< the scale to begin with, units for each mm
    std::optional<double> asked{};  ///< the file's scale: tried before all others
    bool keeps_asked = false;       ///< … and taken, fit or not
    double coarsest = any_scale;    ///< beyond it, or out of its room, the figure comes empty and at any_scale
    int most_trials = 12;           ///< before the last
    double extent = 0;              ///< in units: the last trial is the smallest …
    double least_shown = 0;         ///< … that still shows so many mm of it
    bool names_stay_in_room =
        false;  ///< at half the scale at which the figure itself has room, for names do not shrink
};

/// `draw` says nothing where a trial is not worth finishing: the next smaller scale is tried then. The last has a
/// figure.
Figure fit(const FitPolicy& policy, const std::function<std::optional<Figure>(const Trial&)>& draw);

}  // namespace kinegraph::render
