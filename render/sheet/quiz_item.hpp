// Quiz items: a variant of an exercise as a question for a learning platform. Owns the question, its words and the
// tolerance of answers; the file formats are in render/backends/quiz_files.hpp. Computes no mechanics.
#pragma once

#include <vector>

#include "render/page/quiz.hpp"
#include "render/sheet/sheet.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {

/// The question with figure 1 of the handout, data and scales; one blank for each of `asked`; the sentences and
/// equations of the solution by section. `options`: those of the question.
QuizItem quiz_item_of(const Solution& solution, const std::vector<RequestedResult>& asked, const SheetOptions& options,
                      const Fonts& fonts);

}  // namespace kinegraph::render
