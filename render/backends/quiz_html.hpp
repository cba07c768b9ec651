// Parts of a quiz item as XHTML, common to all platforms.
#pragma once

#include <string>

#include "render/page/quiz.hpp"

namespace kinegraph::render {

/// Sections with headings and their paragraphs as lists. `numbered`, for a solution: the steps are numbered, and the
/// last section contains the answers.
std::string html_of(const std::vector<QuizSection>& sections, bool numbered);
/// The figure at its true size; `source` is its URL.
std::string figure_html(const QuizItem& item, const std::string& source);
/// One blank: `field` is the platform's answer field, placed before the unit.
std::string blank_html(const QuizItem& item, const QuizBlank& blank, const std::string& field);
std::string notes_html(const QuizItem& item);
/// "Four-bar linkage 007 · Anna Rossi", escaped for XML.
std::string name_html(const QuizItem& item);

}  // namespace kinegraph::render
