// Pieces of JSON as they go into a line: texts quoted, values copied as they were written, a document on one line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/file/json_source.hpp"

namespace kinegraph::app {

/// A text in quotes; it is UTF-8 already.
std::string json_quoted(std::string_view text);
/// ["…", "…"]
std::string json_quoted(const std::vector<std::string>& texts);
/// A value and all in it, numbers with the digits they were written with, keys in their order, given twice or not.
std::string copied(JsonValue value);
/// A document of several lines, whose texts hold no line feed (JSON's never do), on one.
std::string on_one_line(std::string_view json);

}  // namespace kinegraph::app
