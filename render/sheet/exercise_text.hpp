// Exercise text: the data of a file, what it seeks and the scales to draw at, in words. Says nothing that a solution finds.
#pragma once

#include <vector>

#include "render/figures/figure.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// All data, a paragraph each, in the file's units: points, wheels, guides, drivers or given velocities, masses, loads.
std::vector<RichText> data_of(const DrawingContext& context);
/// What is asked for: what the file states, else all that its data allow.
std::vector<RichText> sought_of(const DrawingContext& context);
/// The scales of the figures that a solution is drawn at.
std::vector<RichText> scales_of(const DrawingContext& context, const std::vector<Figure>& figures);

/// An amount in a unit, as given: "120 rpm".
RichText given_amount(const Exact& si, const Unit& unit, Language language);

}  // namespace kinegraph::render
