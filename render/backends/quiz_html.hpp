// The parts of a quiz item as XHTML, alike for every platform.
#pragma once

#include <string>

#include "render/page/quiz.hpp"

namespace kinegraph::render {

/// Sections with their headings, paragraphs as a list; of a solution the steps are numbered, and the last section is
/// its answers.
std::string html_of(const std::vector<QuizSection>& sections, bool numbered);
/// The figure at its true size, taken from `source`.
std::string figure_html(const QuizItem& item, const std::string& source);
/// What is asked for: `field` is the platform's, before the unit.
std::string blank_html(const QuizBlank& blank, const std::string& field);
std::string notes_html(const QuizItem& item);
/// "Four-bar linkage 007 · Anna Rossi", as text of XML.
std::string name_html(const QuizItem& item);

}  // namespace kinegraph::render
