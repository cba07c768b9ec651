// Loads libraries on the first use, only in the runs that need them.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph::app {

/// The symbol NAME exported by the module NAME.so. The module is searched beside the program (in a build folder) or in
/// lib/kinegraph (installed), and stays loaded until the end of the run. Thread-safe. `purpose`: what the module does,
/// for the message if it cannot be loaded.
tl::expected<const void*, Words> late_library(const std::string& name, const Words& purpose);

}  // namespace kinegraph::app
