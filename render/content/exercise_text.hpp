// Exercise text: the data of a file, what it seeks and the scales to draw at, in words. Says nothing that a solution
// finds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "render/figures/figure.hpp"
#include "render/tables/answers.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// All data, a paragraph each, in the file's units: points, wheels, guides, drivers or given velocities, masses, loads.
std::vector<RichText> data_of(const DrawingContext& context);
/// What is asked for: by `ask`, else what the file states in `find`, else all that its data allow.
/// `found`: the results asked for, of which the joint where a transmission angle is least is told.
std::vector<RichText> sought_of(const DrawingContext& context, const std::vector<AskedValue>& found = {});
/// Whether anything is sought that counts counter-clockwise positive.
bool has_turning_sense(const Mechanism& mechanism);
/// For the key: in which sense what slides, and what balances, is positive, and the forces in bars; a paragraph each.
std::vector<RichText> signs_of(const DrawingContext& context);
/// A result as an exercise asks for it: ω_3, "the angular velocity ω_3 of body 3".
struct AskedText {
    RichText symbol;
    RichText words;
};
AskedText asked_text(const DrawingContext& context, const Column& column);
/// What a figure's scale is said of: of all polygons of forces together, unless they differ in their scales.
RichText name_of_scale(const DrawingContext& context, const Figure& figure, const std::vector<Figure>& figures);
/// Whether the solution needs the figure for what is sought: all, unless the file asks for results by name.
bool is_drawn_for_sought(const Mechanism& mechanism, const Figure& figure);
/// The scales of the figures that a solution is drawn at for what is sought, and those of the details in which that is
/// read.
std::vector<RichText> scales_of(const DrawingContext& context, const std::vector<Figure>& figures,
                                const std::vector<Answer>& sought);
/// Which of the answers no reading tells from zero; nothing where all can be read.
std::optional<RichText> remark_on_unreadable(const DrawingContext& context, const std::vector<Answer>& answers);

/// The heading of a section of a solution.
std::string heading_of(Topic section, Language language);

/// An amount in a unit, as given: "120 rpm".
RichText given_amount(const Exact& si, const Unit& unit, Language language);

}  // namespace kinegraph::render
