// The JSON Schema of the mechanism file: the text of engine/reading/mechanism.schema.json, compiled into the library so
// that no file is needed. The reader does not validate with it.
#pragma once

#include <string_view>

namespace kinegraph {

extern const std::string_view mechanism_schema_text;

}  // namespace kinegraph
