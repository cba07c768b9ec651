// Quiz items as files of learning platforms: Moodle XML with cloze questions, and items of QTI 2.1 with the manifest of
// their package. What these files promise:
//  - every text of a user is escaped: nothing in a name is read as markup, as a field to be filled in, or as a place of
//  one;
//  - numbers stand as the item has them, with a decimal point;
//  - the same items are the same bytes: no date, no identifier made up.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/page/quiz.hpp"

namespace kinegraph::render {

/// A file is its head, a question for each item (`png`: its figure) and its tail. `category`: where the questions go,
/// below the top of the course's bank.
std::string moodle_head(std::string_view category);
std::string moodle_question(const QuizItem& item, std::string_view png);
std::string moodle_tail();

/// An assessmentItem, which refers to the figure beside it.
std::string qti_item(const QuizItem& item);
/// The name of an item in a package.
std::string qti_file(const QuizItem& item);
/// imsmanifest.xml of a package of items, each with its figure.
std::string qti_manifest(const std::vector<QuizItem>& items);

/// RFC 4648, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace kinegraph::render
