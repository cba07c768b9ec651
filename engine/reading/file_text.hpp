// Texts about mechanism files: one derived from another, with other parameter values or without some sections, and the
// JSON Schema.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/file/json_source.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Form;

/// The file in a plain layout (short values on one line, two spaces per level), members in their order: parameters with
/// the values of `set` (a number where possible), without the members named in `without`. Numbers keep their spelling.
std::string file_with(const JsonSource& file, std::span<const Setting> set, std::span<const std::string_view> without);

/// The JSON Schema of the mechanism file (draft 7), for editors that complete and check as one types; the reader does
/// not validate with it. `file`: the form of the whole file.
std::string json_schema_of(const Form& file);

}  // namespace kinegraph
