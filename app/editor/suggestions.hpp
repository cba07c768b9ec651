// What an editor is told about a place in a mechanism file: what may be written there, and what a key means.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/file_schema.hpp"
#include "app/files/outline.hpp"

namespace kinegraph::app {

/// What may be written in place of the bytes from `begin` to `end`.
struct Suggestion {
    enum class Kind { key, word, unit, name };
    Kind kind = Kind::word;
    std::string label;    ///< without quotes
    std::string written;  ///< with what else has to stand there: quotes, a colon
    std::size_t begin = 0, end = 0;
    std::string says{};      ///< what it means; may be empty
    bool is_needed = false;  ///< a key without which the object is not whole
};
/// What may stand at the byte: keys, words, units, and the names that the file gives to points, bodies, joints and
/// parameters. Empty where nothing is known.
std::vector<Suggestion> suggestions_at(const Outline& outline, std::size_t offset, const FileSchema& schema);

/// What the key at a byte means.
struct Meaning {
    std::size_t begin = 0, end = 0;  ///< of the key
    std::string key, says;
};
/// Empty where there is no key, or it is a name that the file gives.
std::optional<Meaning> meaning_at(const Outline& outline, std::size_t offset, const FileSchema& schema);

}  // namespace kinegraph::app
