/// \file
/// Languages, texts and diagnostics.
///
/// A function that can fail because of its caller or of the user's file returns Expected<T>: the value, or all faults
/// found, each with its place. A fault of the library itself throws an exception derived from std::logic_error; a
/// program should report it and stop the current work. Lack of memory throws std::bad_alloc.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace kinegraph {

/// Languages of sentences, sheets and messages.
enum class Language {
    en,  ///< English
    it,  ///< Italian
    fr,  ///< French
    de,  ///< German
    es   ///< Spanish
};
/// All languages, in the order of Language.
inline constexpr std::array languages{Language::en, Language::it, Language::fr, Language::de, Language::es};
/// BCP 47: "en".
std::string code_of(Language language);
/// The language of a code, upper or lower case; English for an unknown code.
Language language_named(std::string_view code);

/// A text in every language.
struct Text {
    std::array<std::string, languages.size()> by_language;  ///< in the order of Language

    /// The text in one language, UTF-8.
    const std::string& in(Language language) const { return by_language[static_cast<std::size_t>(language)]; }
    /// Whether it is empty in every language.
    bool empty() const {
        for (const std::string& each : by_language)
            if (!each.empty()) return false;
        return true;
    }
};
/// A pattern with its places {0} to {9} filled by the arguments, each in the pattern's language. A place without an
/// argument stays as it is.
Text filled(const Text& pattern, const std::vector<Text>& arguments);

/// One fault: what is wrong, where, and what to do.
struct Diagnostic {
    /// The kind of fault. The command line's exit statuses follow from it.
    enum class Kind {
        bad_input,         ///< the file or the arguments are wrong
        cannot_meet,       ///< curves that should meet do not meet
        no_unique_answer,  ///< a dead point, a change point, or a mechanism that cannot move
        output             ///< a library or a font needed for drawing is missing
    };
    Kind kind = Kind::bad_input;  ///< the kind of the fault
    std::string place;            ///< JSON pointer into the file ("/joints/2/bodies/1"); empty: the whole file
    Text text;                    ///< one line, without the file's name and without a full stop
    Text fault = {};              ///< its first part: what is wrong
    Text remedy = {};             ///< its second part: what to do, or what is wanted; empty if it has none
};

/// All faults of a file, in the file's order. Never empty in a failed Expected.
using Diagnostics = std::vector<Diagnostic>;

/// A value, or the faults that prevented it.
template <class Value>
using Expected = tl::expected<Value, Diagnostics>;

}  // namespace kinegraph
