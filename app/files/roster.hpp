// Reads a roster: the names of students, from a CSV file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph::app {

/// One name for each line that is not empty: its fields, separated by commas, semicolons or tabs and possibly quoted,
/// joined in order. A first line of headings (name, surname, student, id, e-mail …, in English or Italian) is skipped.
/// Error, with the line: not UTF-8, control characters, a quote that is not closed, a number of fields that differs
/// from the heading, a name of more than 200 characters, a duplicate name, no name at all.
tl::expected<std::vector<std::string>, Words> read_roster(std::string_view text);

}  // namespace kinegraph::app
