/// \file
/// The version of the library, by semantic versioning (https://semver.org).
#pragma once

// CMake reads the version of the project from these three lines.
#define KINEGRAPH_VERSION_MAJOR 0  ///< incompatible changes
#define KINEGRAPH_VERSION_MINOR 1  ///< additions; before 1.0 also incompatible changes
#define KINEGRAPH_VERSION_PATCH 0  ///< corrections

#include <string_view>

namespace kinegraph {

/// The version of the linked library, "MAJOR.MINOR.PATCH". Compare it with the macros to detect a header of another
/// release.
std::string_view version();

}  // namespace kinegraph
