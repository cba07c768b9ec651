// Languages: their differences apart from words, namely codes, the decimal mark, and textbook letters and names of
// functions. A new language needs a row here and a column in words.cpp.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "engine/file/words.hpp"

namespace kinegraph::render {

enum class Language { en, it };
inline constexpr std::array languages{Language::en, Language::it};

/// Notation of a language, apart from its words.
struct Notation {
    const char* code;             ///< BCP 47: "en"
    char decimal_mark;            ///< 3.14 or 3,14
    const char* between_numbers;  ///< separator of a list; a semicolon where the comma is the decimal mark
    const char* cross_product;    ///< × or ∧
    const char* sine;             ///< sin or sen
    const char* alpha;            ///< the letter of angular accelerations, …
    int alpha_dots;               ///< … with this many dots over it
    const char* centre;           ///< the letter of instant centres
};
const Notation& notation(Language language);

inline std::string code_of(Language language) { return notation(language).code; }
/// Language by its code, ignoring case; English for an unknown code.
Language language_of(std::string_view code);

const std::string& in(const Words& words, Language language);
/// Words made by calling say() for each language.
template <class Say>
Words in_all(const Say& say) {
    return {say(Language::en), say(Language::it)};
}

}  // namespace kinegraph::render
