// The gate: the published schema's word on a text, by valijson, which only this sees. What it refuses and the reader
// reads is a gap in the reader's own checks.
#pragma once

#include <string_view>

#include "engine/file/error.hpp"

namespace kinegraph {

/// The first fault that the schema finds in the text, with its JSON pointer; none if the text follows the schema.
/// `text` is JSON without duplicate keys and of bounded depth. Patterns are left to our own checks (std::regex recurses
/// with the length of what it matches).
Errors refused_by_schema(std::string_view text);

}  // namespace kinegraph
