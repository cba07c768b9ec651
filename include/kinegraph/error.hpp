/// \file
/// Languages, texts and diagnostics.
///
/// A function that can fail because of its caller or of the user's file returns Expected<T>: the value, or all faults
/// found, each with its place. A fault of the library itself throws an exception derived from std::logic_error; a
/// program should report it and stop the current work. Lack of memory throws std::bad_alloc.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace kinegraph {

/// Languages of sentences, sheets and messages.
enum class Language {
    en,  ///< English
    it   ///< Italian
};

/// A text in every language.
struct Text {
    std::array<std::string, 2> by_language;  ///< in the order of Language

    /// The text in one language, UTF-8.
    const std::string& in(Language language) const { return by_language[static_cast<std::size_t>(language)]; }
};

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
};

/// All faults of a file, in the file's order. Never empty in a failed Expected.
using Diagnostics = std::vector<Diagnostic>;

/// A value, or the faults that prevented it.
template <class Value>
using Expected = tl::expected<Value, Diagnostics>;

}  // namespace kinegraph
