// Where in a file's text a JSON pointer leads: what an editor wants of a fault. Knows no mechanism.
#pragma once

#include <optional>
#include <string_view>

namespace kinegraph::app {

/// Counted from 1; columns count characters.
struct PlaceInFile {
    long line = 1, column = 1;
};

/// Of a member its key, of an element of an array its beginning. Of what is not there (a key that is missing) the
/// nearest thing around it; nothing where that is the whole file. `json` must be JSON.
std::optional<PlaceInFile> place_in_file(std::string_view json, std::string_view pointer);

}  // namespace kinegraph::app
