// Handouts: the question as it is handed out, and the key, with figure 1 where the solution's sheet has it. Owns how they are
// laid out; what they say is exercise_text's and the answers'.
#pragma once

#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// Of the kind that the options say, which is not the solution.
std::vector<Page> lay_out_handout(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
