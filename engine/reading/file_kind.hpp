// The kind of a file: a mechanism (or a problem in its place), or a cam. Each kind has its own reader. A file given to
// the wrong reader gets one fault, which names the right command, instead of one fault for every unknown key.
#pragma once

#include <optional>
#include <utility>

#include "engine/file/json_source.hpp"
#include "lang/words.hpp"

namespace kinegraph {

enum class FileKind { mechanism, cam };

/// For a file that states nothing of the wanted kind but something of the other: the member that shows it, and the
/// fault. `root` is the file's object.
std::optional<std::pair<JsonValue, Words>> fault_of_kind(JsonValue root, FileKind wanted);

}  // namespace kinegraph
