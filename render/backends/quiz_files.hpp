// Quiz items as files of learning platforms: Moodle XML with cloze questions, and QTI 2.1 items with the manifest of
// their package. Guarantees:
//  - all text from users is escaped, and is never interpreted as markup, as an answer field or as a placeholder;
//  - numbers are those of the item, with a decimal point;
//  - the same items give the same bytes: no date, no generated identifier.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/page/quiz.hpp"

namespace kinegraph::render {

/// A Moodle file is its head, a question per item (`png`: its figure) and its tail. `category`: of the questions, below
/// the top of the course's question bank.
std::string moodle_head(std::string_view category);
std::string moodle_question(const QuizItem& item, std::string_view png);
std::string moodle_tail();

/// An assessmentItem that refers to the figure in the same folder.
std::string qti_item(const QuizItem& item);
/// File name of an item in a package.
std::string qti_file(const QuizItem& item);
/// imsmanifest.xml of a package of items with their figures.
std::string qti_manifest(const std::vector<QuizItem>& items);

/// Base64 (RFC 4648), without line breaks.
std::string base64(std::string_view bytes);

}  // namespace kinegraph::render
