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

    // Defined in words.cpp: inline, the many texts of the program would take a tenth of its compile time.
    Words();
    Words(const Words&);
    Words(Words&&) noexcept;
    Words& operator=(const Words&);
    Words& operator=(Words&&) noexcept;
    ~Words();
    /// The same in all languages: a name, a number, a quotation from the file. Not for literals: these have
    /// translations.
    Words(std::string every);       // NOLINT(google-explicit-constructor)
    Words(std::string_view every);  // NOLINT(google-explicit-constructor)
    Words(std::string english, std::string italian);
    Words(const char* english, const char* italian);
    /// Two patterns, in which {0} … {9} are the arguments, each in the pattern's language.
    template <class... Arguments>
    Words(std::string_view english, std::string_view italian, const Arguments&... arguments)
        : Words(english, italian, std::array<Words, sizeof...(Arguments)>{Words(arguments)...}) {}
    template <std::size_t count>
    Words(std::string_view english, std::string_view italian, const std::array<Words, count>& arguments)
        : Words(english, italian, arguments.data(), count) {}

    bool empty() const { return en.empty() && it.empty(); }
    Words& operator+=(const Words& more);
    friend Words operator+(Words first, const Words& second);
    friend bool operator==(const Words&, const Words&);

private:
    Words(std::string_view english, std::string_view italian, const Words* arguments, std::size_t count);
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
