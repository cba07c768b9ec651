// Validates a text against the published schema by valijson, which is used only here. If the schema refuses a text that
// the reader accepts, the reader lacks a check.
#pragma once

#include <string_view>

#include "engine/file/error.hpp"

namespace kinegraph {

/// The first fault that the schema finds in the text, with its JSON pointer; empty if the text follows the schema.
/// `text` is JSON without duplicate keys and of bounded depth. Patterns are not tested: std::regex recurses with the
/// length of its match.
Errors refused_by_schema(std::string_view text);

}  // namespace kinegraph
