// Languages: their differences apart from words, namely codes, the decimal mark, and textbook letters and names of
// functions. They are in the section "notation" of the files of the languages.
#pragma once

#include <string>

#include "lang/words.hpp"

namespace kinegraph::render {

/// Notation of a language, apart from its words.
struct Notation {
    std::string code;             ///< BCP 47: "en"
    char decimal_mark;            ///< 3.14 or 3,14
    std::string between_numbers;  ///< separator of a list; a semicolon where the comma is the decimal mark
    std::string cross_product;    ///< × or ∧
    std::string sine;             ///< sin or sen
    std::string alpha;            ///< the letter of angular accelerations, …
    int alpha_dots;               ///< … with this many dots over it
    std::string centre;           ///< the letter of instant centres
    std::string work;             ///< the letter of work: W or L
    // Superscripts of the parts of a relative motion.
    std::string transport;
    std::string relative;
    std::string coriolis;

    /// A superscript of a symbol as the language writes it: "tr" and "tr,2" are "e" and "e,2" in French.
    std::string term(const std::string& own) const;
};
const Notation& notation(Language language);

/// Words made by calling say() for each language.
template <class Say>
Words in_all(const Say& say) {
    Text text;
    for (const Language language : languages) text.by_language.at(static_cast<std::size_t>(language)) = say(language);
    return text;
}

}  // namespace kinegraph::render
