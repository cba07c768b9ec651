// Faults of the module as faults of the program.
#include "app/commands/painter.hpp"

#include "app/commands/module.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph::app {
namespace {

std::string bytes_of(CairoFunctions::Bytes bytes) {
    if (!bytes) throw Fault(bytes.error());
    return *std::move(bytes);
}

}  // namespace

tl::expected<Painter, Words> Painter::open() {
    return open_module_as<CairoFunctions>("kinegraph_cairo", {"PNG and PDF are drawn", "PNG e PDF sono disegnati"})
        .map([](const CairoFunctions* functions) { return Painter(*functions); });
}

std::string Painter::to_png(const render::Page& page, const render::Glyphs& glyphs, double dpi) const {
    return bytes_of(functions_->to_png(page, glyphs, dpi));
}

std::string Painter::to_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) const {
    return bytes_of(functions_->to_pdf(pages, glyphs));
}

std::string Painter::to_live_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) const {
    return bytes_of(functions_->to_live_pdf(pages, glyphs));
}

}  // namespace kinegraph::app
