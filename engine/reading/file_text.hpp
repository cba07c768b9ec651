// The text of a mechanism file made of another one: with values for its parameters, without some of its sections. Knows
// no mechanism.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/file/json_source.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The file in a plain layout (what fits stands on one line, two spaces for each level), its members in their order:
/// parameters with the values of `set`, a number where the value is one, and without the members of the names
/// `without`. Numbers stay as they are written.
std::string file_with(const JsonSource& file, std::span<const Setting> set, std::span<const std::string_view> without);

}  // namespace kinegraph
