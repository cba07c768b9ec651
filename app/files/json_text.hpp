// JSON for one-line answers: quoted texts, values copied as they were written, a document on one line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/file/json_source.hpp"

namespace kinegraph::app {

/// A text in quotes; it must be UTF-8.
std::string json_quoted(std::string_view text);
/// ["…", "…"]
std::string json_quoted(const std::vector<std::string>& texts);
/// A value with its members, unchanged: digits of numbers, order of keys, duplicate keys.
std::string copied(JsonValue value);
/// A JSON document on one line. (JSON strings contain no line feed.)
std::string on_one_line(std::string_view json);

}  // namespace kinegraph::app
