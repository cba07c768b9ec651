/// \file
/// The version of the library, by semantic versioning (https://semver.org).
#pragma once

// CMake reads the version of the project from these three lines.
#define KINEGRAPH_VERSION_MAJOR 0  ///< changes that a program must follow
#define KINEGRAPH_VERSION_MINOR 1  ///< additions; before 1.0 also changes
#define KINEGRAPH_VERSION_PATCH 0  ///< corrections

#include <string_view>

namespace kinegraph {

/// The version of the library that is linked, "MAJOR.MINOR.PATCH". A program that compares it with the macros of the
/// header learns whether both are of one release.
std::string_view version();

}  // namespace kinegraph
