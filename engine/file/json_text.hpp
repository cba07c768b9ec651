// A text as JSON writes it. Shared by all who print JSON.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph {

/// In quotation marks, with what JSON does not let stand escaped.
std::string json_text(std::string_view text);
/// The same, behind what `json` holds.
/// `line_end`: how the end of a line is written, `\u000a` or `\n`.
void append_json_text(std::string& json, std::string_view text, std::string_view line_end = "\\u000a");

}  // namespace kinegraph
