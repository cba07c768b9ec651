// Rosters: the names of students, from a CSV file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"

namespace kinegraph::app {

/// A name for each line that is not empty: its fields, parted by commas, semicolons or tabs, one after the other.
/// Fields may stand in quotes. A first line that says what the fields are (name, surname, student, id, e-mail …, in
/// English or Italian) is none. Error: no UTF-8, control characters, a quote that is not closed, other fields than the
/// heading has, a name beyond 200 characters, one that stands twice, no name at all; with the line.
tl::expected<std::vector<std::string>, Words> read_roster(std::string_view text);

}  // namespace kinegraph::app
