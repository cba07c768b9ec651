// The text of a mechanism file derived from another one: with other parameter values, without some sections. Works on
// JSON only.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/file/json_source.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The file in a plain layout (short values on one line, two spaces per level), members in their order: parameters with
/// the values of `set` (a number where possible), without the members named in `without`. Numbers keep their spelling.
std::string file_with(const JsonSource& file, std::span<const Setting> set, std::span<const std::string_view> without);

}  // namespace kinegraph
