// Quiz items: a variant of an exercise as a learning platform asks it. Owns what is asked, in which words, and how far an answer
// may be off; what comes of it as bytes are the backends of quizzes (render/backends/quiz_files.hpp). Computes no mechanics.
#pragma once

#include <string>
#include <vector>

#include "engine/column.hpp"
#include "render/page/quiz.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// A result that is asked for, in SI, and the unit in which it is to be told.
struct AskedValue {
    Column column;
    double value = 0;
    std::string unit;      ///< its symbol; empty: a bare number
    double unit_size = 1;  ///< SI
};

/// The question with figure 1 as the handout has it, data and scales; a blank for each of `asked`; the sentences of the solution
/// with their equations, by section. `options`: those of the question.
QuizItem quiz_item_of(const Solution& solution, const std::vector<AskedValue>& asked, const SheetOptions& options,
                      const Fonts& fonts);

}  // namespace kinegraph::render
