// Languages: what differs between them besides words — their codes, the decimal mark, letters and names of functions as
// each language's textbooks have them. Whoever adds one gives it a row here and a column in words.cpp.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "engine/file/words.hpp"

namespace kinegraph::render {

enum class Language { en, it };
inline constexpr std::array languages{Language::en, Language::it};

/// How a language writes, apart from its words.
struct Notation {
    const char* code;             ///< BCP 47: "en"
    char decimal_mark;            ///< 3.14 or 3,14
    const char* between_numbers;  ///< of a list: a semicolon where the comma is the decimal one
    const char* cross_product;    ///< of vectors: × or ∧
    const char* sine;             ///< sin or sen
    const char* alpha;            ///< the letter of angular accelerations …
    int alpha_dots;               ///< … with so many dots over it
    const char* centre;           ///< the letter of instant centres
};
const Notation& notation(Language language);

inline std::string code_of(Language language) { return notation(language).code; }
/// By its code in small or large letters; English where there is none of that code.
Language language_of(std::string_view code);

const std::string& in(const Words& words, Language language);
/// Words of what `say` says in each language.
template <class Say>
Words in_all(const Say& say) {
    return {say(Language::en), say(Language::it)};
}

}  // namespace kinegraph::render
