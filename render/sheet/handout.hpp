// Handouts: the question and the key, with figure 1 at its position on the solution's sheet. Owns their layout; the
// text comes from exercise_text and from the answers.
#pragma once

#include <vector>

#include "render/sheet/sheet.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {

/// The kind of handout in the options, which must not be the solution. `asked`: the results in `ask`; without them a
/// question does not name the joint of a transmission angle.
std::vector<Page> lay_out_handout(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                  const std::vector<RequestedResult>& asked = {});

/// The key, and remarks on it.
struct LaidOutKey {
    std::vector<Page> pages;
    std::vector<RichText> remarks;  ///< on answers that cannot be read off; they are on the pages, too
};
/// `asked`: the values of the results in `ask`. Without them the key lists only answers that the solution contains as a
/// vector, ω, α, a couple or an input effort.
LaidOutKey lay_out_key_of(const Solution& solution, const std::vector<RequestedResult>& asked,
                          const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
