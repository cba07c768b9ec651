// Words: a text in every language, side by side where it is written, so that no translation is forgotten. The texts of
// solutions are in a table of their own (render/text/words.cpp); here are the titles of files and the messages about
// faults in files.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kinegraph {

/// A title, a label or a message. For a title, `en` is the fallback where a language is missing.
struct Words {
    std::string en;
    std::string it;

    Words() = default;
    /// The same in all languages: a name, a number, a quotation from the file. Not for literals: these have
    /// translations.
    Words(std::string every) : en(every), it(std::move(every)) {}  // NOLINT(google-explicit-constructor)
    Words(std::string_view every) : Words(std::string(every)) {}   // NOLINT(google-explicit-constructor)
    Words(std::string english, std::string italian) : en(std::move(english)), it(std::move(italian)) {}
    /// Takes literals, without a temporary string: GCC 12 wrongly reports that moving one reads past its end.
    Words(const char* english, const char* italian) : en(english), it(italian) {}
    /// Two patterns, in which {0} … {9} are the arguments, each in the pattern's language.
    template <class... Arguments>
    Words(std::string_view english, std::string_view italian, const Arguments&... arguments) {
        const std::array<Words, sizeof...(Arguments)> words{Words(arguments)...};
        std::array<std::string_view, sizeof...(Arguments)> of_each{};
        for (std::size_t i = 0; i < words.size(); ++i) of_each[i] = words[i].en;
        en = filled(english, of_each.data(), of_each.size());
        for (std::size_t i = 0; i < words.size(); ++i) of_each[i] = words[i].it;
        it = filled(italian, of_each.data(), of_each.size());
    }

    bool empty() const { return en.empty() && it.empty(); }
    Words& operator+=(const Words& more) {
        en += more.en;
        it += more.it;
        return *this;
    }
    friend Words operator+(Words first, const Words& second) { return first += second; }
    friend bool operator==(const Words&, const Words&) = default;

private:
    static std::string filled(std::string_view pattern, const std::string_view* arguments, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            const bool place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}' &&
                               pattern[i + 1] >= '0' && static_cast<std::size_t>(pattern[i + 1] - '0') < count;
            if (!place) {
                text += pattern[i];
                continue;
            }
            text += arguments[pattern[i + 1] - '0'];
            i += 2;
        }
        return text;
    }
};

/// A fragment of a library's English message and its replacement.
using Translation = std::pair<std::string_view, std::string_view>;
/// Translates a library's message: replaces fragments in the table's order; other text stays.
template <class Table>
std::string translated(std::string text, const Table& table) {
    for (const auto& [en, it] : table)
        for (std::size_t at = text.find(en); at != std::string::npos; at = text.find(en, at + it.size()))
            text.replace(at, en.size(), it);
    return text;
}

}  // namespace kinegraph
