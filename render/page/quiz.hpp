// Quiz item: an exercise for learning platforms, completely prepared. Text is rich, numbers are decimal strings.
// Independent of platforms and of mechanics.
#pragma once

#include <string>
#include <vector>

#include "render/page/page.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// A number that the student must enter.
struct QuizBlank {
    std::string name;       ///< of the result, as in the file: "omega 3"
    RichText words;         ///< description: "the angular velocity of body 3"
    RichText symbol;        ///< ω_3
    std::string value;      ///< decimal, in `unit`; rounding is far below the tolerance
    std::string tolerance;  ///< accepted deviation, in `unit`: decimal, "0" if exact
    std::string unit;       ///< empty: dimensionless
};

struct QuizSection {
    std::string heading;
    std::vector<RichText> paragraphs;
};

struct QuizItem {
    std::string number;  ///< of the variant: "007"
    std::string title;   ///< of the exercise
    std::string owner;   ///< name of the student; may be empty
    std::string language = "en";
    Page figure;
    std::vector<QuizSection> question;  ///< the given data
    std::string blanks_heading;
    std::vector<QuizBlank> blanks;
    std::vector<RichText> notes;        ///< instructions for filling in the blanks
    std::vector<QuizSection> solution;  ///< by step; shown after the answer
};

/// File name of an item's figure, in the same folder.
inline std::string figure_file(const QuizItem& item) { return item.number + "-figure.png"; }

}  // namespace kinegraph::render
