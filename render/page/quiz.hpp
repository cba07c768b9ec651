// A quiz item: an exercise as a learning platform asks it, with nothing left to decide. Text is rich, numbers are as
// they are written; it knows no platform and no mechanics.
#pragma once

#include <string>
#include <vector>

#include "render/page/page.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// A number that is asked for.
struct QuizBlank {
    std::string name;       ///< of the result, as the file asks for it: "omega 3"
    RichText words;         ///< what it is: "the angular velocity of body 3"
    RichText symbol;        ///< ω_3
    std::string value;      ///< a decimal, in `unit`; rounded far below the tolerance
    std::string tolerance;  ///< by how much a right answer may be off, in `unit`: a decimal, "0" where it is exact
    std::string unit;       ///< empty: a bare number
};

struct QuizSection {
    std::string heading;
    std::vector<RichText> paragraphs;
};

struct QuizItem {
    std::string number;  ///< of the variant: "007"
    std::string title;   ///< of the exercise
    std::string owner;   ///< whose it is; may be empty
    std::string language = "en";
    Page figure;
    std::vector<QuizSection> question;  ///< what is given
    std::string blanks_heading;
    std::vector<QuizBlank> blanks;
    std::vector<RichText> notes;        ///< how the blanks are to be filled in
    std::vector<QuizSection> solution;  ///< by step, said when it is answered
};

/// The name of an item's figure, beside it.
inline std::string figure_file(const QuizItem& item) { return item.number + "-figure.png"; }

}  // namespace kinegraph::render
