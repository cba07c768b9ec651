// Exercise text: the data of a file, the results it asks for, and the scales, in words. Contains no result of the
// solution.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "render/figures/figure.hpp"
#include "render/tables/answers.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// All data, one paragraph each, in the units of the file: points, wheels, guides, drivers or given velocities, masses,
/// loads.
std::vector<RichText> data_of(const DrawingContext& context);
/// The results to find: those in `ask`, otherwise those in `find`, otherwise all that the data determine. `found`: the
/// results in `ask`; with them the text names the joint with the least transmission angle.
std::vector<RichText> sought_of(const DrawingContext& context, const std::vector<RequestedResult>& found = {});
/// Whether a result is positive counter-clockwise.
bool has_turning_sense(const Mechanism& mechanism);
/// What counts positive: in statics no velocities.
Key turning_senses(const Solution& solution);
/// For the key: the positive sense of sliding, of balancing loads and of the forces in bars; one paragraph each.
std::vector<RichText> signs_of(const DrawingContext& context);
/// A result in an exercise: ω_3, "the angular velocity ω_3 of body 3".
struct AskedText {
    RichText symbol;
    RichText words;
};
AskedText asked_text(const DrawingContext& context, const Column& column);
/// The name of what a scale applies to: all force polygons together, unless their scales differ.
RichText name_of_scale(const DrawingContext& context, const Figure& figure, const std::vector<Figure>& figures);
/// Whether the solution needs the figure for the results. True for every figure unless the file asks for results by
/// name.
bool is_drawn_for_sought(const Mechanism& mechanism, const Figure& figure);
/// The scales of the figures with the results, and of the details in which results are read.
std::vector<RichText> scales_of(const DrawingContext& context, const std::vector<Figure>& figures,
                                const std::vector<Answer>& sought);
/// A remark that lists the answers too small to be distinguished from zero on the figures. Empty if there is none.
std::optional<RichText> remark_on_unreadable(const DrawingContext& context, const std::vector<Answer>& answers);

/// The heading of a section of a solution.
std::string heading_of(Topic section, Language language);

/// An amount in a unit, as in the file: "120 rpm".
RichText given_amount(const Exact& si, const Unit& unit, Language language);

}  // namespace kinegraph::render
