// Line and column of a JSON pointer in a file, for editors. Knows no mechanism.
#pragma once

#include <optional>
#include <string_view>

namespace kinegraph::app {

/// Counted from 1; columns count characters, not bytes.
struct PlaceInFile {
    long line = 1, column = 1;
};

/// The position of a member's key or of an array element's beginning. If the pointer leads to nothing (a missing key),
/// the position of the nearest enclosing value; empty if that is the whole file. `json` must be valid JSON.
std::optional<PlaceInFile> place_in_file(std::string_view json, std::string_view pointer);

}  // namespace kinegraph::app
