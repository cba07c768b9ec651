// The sheet of a problem stated in place of joints: its questions flow through columns, figures among them, then the
// results beside the numeric check. Knows no kind of problem.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// All for a Solution that has a problem. On as few pages as hold it, figures as large as that allows.
std::vector<Page> lay_out_problem(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
/// A page for each sentence, beside the figures of its question; the last has the results.
std::vector<Page> lay_out_problem_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
/// The ids of its figures, and one of them drawn for a page of its own.
std::vector<std::string> problem_figure_names(const DrawingContext& context);
std::optional<Figure> problem_figure(const DrawingContext& context, const std::string& name, double room_x,
                                     double room_y);
/// The results for a terminal.
std::string problem_table(const Solution& solution, Language language);

}  // namespace kinegraph::render
