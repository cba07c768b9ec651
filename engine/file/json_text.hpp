// Text as a JSON string. Used by all JSON output.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph {

/// In quotation marks, with the characters escaped that JSON requires.
std::string json_text(std::string_view text);
/// Appends it to `json`.
/// `line_end`: how the end of a line is written, `\u000a` or `\n`.
void append_json_text(std::string& json, std::string_view text, std::string_view line_end = "\\u000a");

}  // namespace kinegraph
