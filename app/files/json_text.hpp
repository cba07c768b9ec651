// JSON for one-line answers: quoted texts, a document on one line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::app {

/// ["…", "…"]
std::string json_quoted(const std::vector<std::string>& texts);
/// A JSON document on one line. (JSON strings contain no line feed.)
std::string on_one_line(std::string_view json);

}  // namespace kinegraph::app
