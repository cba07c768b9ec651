// Words: a text of the command line, in every language side by side where it is written, so that no translation is
// forgotten. The library's own texts are values of the same type.
#pragma once

#include <kinegraph/error.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kinegraph::app {

struct Words : Text {
    Words() = default;
    Words(Text text) : Text(std::move(text)) {}  // NOLINT(google-explicit-constructor)
    /// The same in all languages: a name, a number, a quotation. Not for literals: these have translations.
    Words(const std::string& every) : Text{{every, every}} {}     // NOLINT(google-explicit-constructor)
    Words(std::string_view every) : Words(std::string(every)) {}  // NOLINT(google-explicit-constructor)
    Words(std::string english, std::string italian) : Text{{std::move(english), std::move(italian)}} {}
    Words(const char* english, const char* italian) : Text{{english, italian}} {}
    /// Two patterns, in which {0} … {9} are the arguments, each in the pattern's language.
    template <class... Arguments>
    Words(std::string_view english, std::string_view italian, const Arguments&... arguments)
        : Text(filled({{std::string(english), std::string(italian)}}, {Words(arguments)...})) {}

    Words& operator+=(const Words& more) {
        for (std::size_t i = 0; i < by_language.size(); ++i) by_language.at(i) += more.by_language.at(i);
        return *this;
    }
    friend Words operator+(Words first, const Words& second) { return first += second; }
};

/// The text in one language.
inline const std::string& in(const Text& words, Language language) { return words.in(language); }

}  // namespace kinegraph::app
