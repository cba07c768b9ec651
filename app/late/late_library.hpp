// Libraries that are opened late: by the runs that need them, when they first do.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"

namespace kinegraph::app {

/// What the module NAME.so exports under the name NAME. It is looked for beside the program, as built, or in
/// lib/kinegraph, as installed, and stays open to the end of the run. Any thread may call this, any number of times.
/// `purpose`: what it does, for the message where it cannot be opened.
tl::expected<const void*, Words> late_library(const std::string& name, const Words& purpose);

}  // namespace kinegraph::app
