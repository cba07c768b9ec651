// Words: a text in every language, kept side by side where it is made, so that none can be forgotten. What is said of a
// solution has a table of its own (render/text/words.cpp); here are the titles of files and the faults of what people
// write.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kinegraph {

/// A title, a label or a message; of a title `en` serves where a language is missing.
struct Words {
    std::string en;
    std::string it;

    // Made, copied and deleted in one place (words.cpp): inline, the thousand texts of the program took a tenth of the
    // time that it takes to compile.
    Words();
    Words(const Words&);
    Words(Words&&) noexcept;
    Words& operator=(const Words&);
    Words& operator=(Words&&) noexcept;
    ~Words();
    /// The same in all languages: a name, a number, what a file says. Not from a literal: that has a translation.
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

/// A piece of a library's English and what stands for it.
using Translation = std::pair<std::string_view, std::string_view>;
/// What a library says, piece by piece in the table's order; what the table lacks stays.
template <class Table>
std::string translated(std::string text, const Table& table) {
    for (const auto& [en, it] : table)
        for (std::size_t at = text.find(en); at != std::string::npos; at = text.find(en, at + it.size()))
            text.replace(at, en.size(), it);
    return text;
}

}  // namespace kinegraph
