// The seam between the program and kinegraph_type.so, the module that shapes type and draws its outlines. HarfBuzz
// brings ten libraries; results and messages do without them.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "render/text/typeface.hpp"

namespace kinegraph::app {

/// What the module exports, under the name `kinegraph_type`.
struct TypeFunctions {
    tl::expected<render::Typefaces, Words> (*open_typefaces)();
};

}  // namespace kinegraph::app
