// Derivatives in symbols, found by a module that is loaded for them. The program itself knows nothing of GiNaC.
#pragma once

#include "engine/file/algebra.hpp"

namespace kinegraph::app {

/// The module's, loaded the first time. Error: a line that says what is missing.
tl::expected<const Algebra*, Words> loaded_algebra();

}  // namespace kinegraph::app
