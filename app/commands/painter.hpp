// PNG and PDF, drawn by a module that is loaded for them. The program itself knows nothing of cairo.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/modules/cairo.hpp"
#include "engine/file/words.hpp"

namespace kinegraph::app {

/// The module, loaded. It stays so to the end of the run.
class Painter {
public:
    /// Error: a line that says what is missing.
    static tl::expected<Painter, Words> open();

    std::string to_png(const render::Page& page, const render::Glyphs& glyphs, double dpi) const;
    std::string to_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) const;
    std::string to_live_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) const;

private:
    explicit Painter(const CairoFunctions& functions) : functions_(&functions) {}
    const CairoFunctions* functions_;
};

}  // namespace kinegraph::app
