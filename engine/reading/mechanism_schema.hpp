// The JSON Schema of the mechanism file, word for word engine/reading/mechanism.schema.json, built into the library so
// that reading a file needs no other. The text only: validating by it is the reader's business.
#pragma once

#include <string_view>

namespace kinegraph {

extern const std::string_view mechanism_schema_text;

}  // namespace kinegraph
