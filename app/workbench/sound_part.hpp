// The part of a mechanism file that has no fault, so that an unfinished drawing can be shown.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <kinegraph/mechanism.hpp>

namespace kinegraph::app {

/// The position of the file without the members that `faults` name and those that depend on them; none where the text
/// is not JSON, or nothing of it is sound.
std::optional<DrawnPosition> sound_position(std::string_view text, const std::string& name, Diagnostics faults);

}  // namespace kinegraph::app
