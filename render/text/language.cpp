// Languages: see language.hpp.
#include "render/text/language.hpp"

#include <algorithm>
#include <cctype>

namespace kinegraph::render {
namespace {

constexpr std::array<Notation, languages.size()> notations{{
    {"en", '.', ", ", "×", "sin", "α", 0, "P"},
    {"it", ',', "; ", "∧", "sen", "ω", 1, "C"},
}};

bool same_letters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char left, unsigned char right) {
        return std::tolower(left) == std::tolower(right);
    });
}

}  // namespace

const Notation& notation(Language language) { return notations[static_cast<std::size_t>(language)]; }

Language language_of(std::string_view code) {
    for (const Language language : languages)
        if (same_letters(code, notation(language).code)) return language;
    return Language::en;
}

const std::string& in(const Words& words, Language language) {
    if (language == Language::it) return words.it.empty() ? words.en : words.it;
    return words.en.empty() ? words.it : words.en;
}

}  // namespace kinegraph::render
