// The gate: the published schema's word on a text that our own checks have let pass. What it refuses is a gap in those checks, so
// its messages are plain. The only place that sees valijson.
#pragma once

#include <string_view>

#include "engine/error.hpp"

namespace kinegraph {

/// The first fault that the schema finds in the text, with its JSON pointer; none if the text follows the schema. `text` is
/// JSON without duplicate keys and of bounded depth.
/// Patterns are left to our own checks (std::regex recurses with the length of what it matches).
Errors refused_by_schema(std::string_view text);

}  // namespace kinegraph
