// What a file states: a mechanism (or a problem in its place), or a cam. Each kind has a reader of its own; a file that
// is given to the other one has one fault, which says the command it is for, in place of one for every key of a form
// that nobody meant.
#pragma once

#include <optional>
#include <utility>

#include "engine/file/json_source.hpp"
#include "engine/file/words.hpp"

namespace kinegraph {

enum class FileKind { mechanism, cam };

/// Of a file that states nothing of the wanted kind but something of the other: the member that does, and the fault.
/// `root` is the file's object.
std::optional<std::pair<JsonValue, Words>> fault_of_kind(JsonValue root, FileKind wanted);

}  // namespace kinegraph
