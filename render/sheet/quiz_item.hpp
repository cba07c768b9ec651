// Quiz items: a variant of an exercise as a learning platform asks it. Owns what is asked, in which words, and how far
// an answer may be off; what comes of it as bytes are the backends of quizzes (render/backends/quiz_files.hpp).
// Computes no mechanics.
#pragma once

#include <vector>

#include "render/page/quiz.hpp"
#include "render/sheet/sheet.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {

/// The question with figure 1 as the handout has it, data and scales; a blank for each of `asked`; the sentences of the
/// solution with their equations, by section. `options`: those of the question.
QuizItem quiz_item_of(const Solution& solution, const std::vector<AskedValue>& asked, const SheetOptions& options,
                      const Fonts& fonts);

}  // namespace kinegraph::render
