// Handouts: the question and the key, with figure 1 at its position on the solution's sheet. Owns their layout; the
// text comes from exercise_text and from the answers. A quiz item is a variant as a question for a learning platform
// (render/backends/quiz_files.hpp has the file formats).
#pragma once

#include <vector>

#include "render/content/title_block.hpp"
#include "render/figures/figure.hpp"
#include "render/page/quiz.hpp"
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

/// Adds blank areas, each a grid with its pole or starting point, for all figures but the first, on as many additional
/// sheets as they need.
void add_blank_rooms(const DrawingContext& context, const SheetFormat& format, const std::vector<Figure>& figures,
                     std::vector<std::vector<Mark>>& sheets);

/// The question with figure 1 of the handout, data and scales; one blank for each of `asked`; the sentences and
/// equations of the solution by section. `options`: those of the question.
QuizItem quiz_item_of(const Solution& solution, const std::vector<RequestedResult>& asked, const SheetOptions& options,
                      const Fonts& fonts);

}  // namespace kinegraph::render
