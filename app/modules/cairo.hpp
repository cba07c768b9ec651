// The seam between the program and kinegraph_cairo.so, the module that draws PNG and PDF. cairo brings thirty
// libraries, those of X11 among them, which take longer to load than most runs take; so they are loaded by those runs
// alone that need them.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/page/page.hpp"
#include "render/text/glyphs.hpp"

namespace kinegraph::app {

/// What the module exports, under the name `kinegraph_cairo`. A fault of ours comes back as its text: program and
/// module may have a C++ library each, and no exception has to find its way from one to the other.
struct CairoFunctions {
    using Bytes = tl::expected<std::string, std::string>;
    Bytes (*to_png)(const render::Page& page, const render::Glyphs& glyphs, double dpi);
    Bytes (*to_pdf)(const std::vector<render::Page>& pages, const render::Glyphs& glyphs);
    Bytes (*to_live_pdf)(const std::vector<render::Page>& pages, const render::Glyphs& glyphs);
};

}  // namespace kinegraph::app
