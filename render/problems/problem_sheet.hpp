// The sheet of a problem that a file states instead of joints: its questions in columns with their figures, then the
// results and the numeric check. Independent of the kind of problem.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// All functions require a Solution with a problem. Uses the fewest pages, and the largest figures for these.
std::vector<Page> lay_out_problem(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
/// One page for each sentence, beside the figures of its question; the last page has the results.
std::vector<Page> lay_out_problem_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
/// The ids of its figures, and one figure for a page of its own.
std::vector<std::string> problem_figure_names(const DrawingContext& context);
std::optional<Figure> problem_figure(const DrawingContext& context, const std::string& name, double room_x,
                                     double room_y);
/// The results as plain text for a terminal.
std::string problem_table(const Solution& solution, Language language);

}  // namespace kinegraph::render
