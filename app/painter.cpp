// dlopen, and faults of the module as faults of the program.
#include "app/painter.hpp"

#include <dlfcn.h>

#include "engine/assert.hpp"

namespace kinegraph::app {
namespace {

std::string bytes_of(CairoFunctions::Bytes bytes) {
    if (!bytes) throw Fault(bytes.error());
    return *std::move(bytes);
}

}  // namespace

tl::expected<Painter, std::string> Painter::open() {
    // A bare name: the loader looks where the program's RPATH says.
    void* const module = ::dlopen("kinegraph_cairo.so", RTLD_LAZY | RTLD_LOCAL);
    if (module == nullptr)
        return tl::unexpected(std::string("PNG and PDF are drawn by a module of the program, which cannot be loaded: ") +
                              ::dlerror());
    const void* const functions = ::dlsym(module, "kinegraph_cairo");
    KG_ASSERT(functions != nullptr, "the module exports what it draws with");
    return Painter(*static_cast<const CairoFunctions*>(functions));
}

std::string Painter::to_png(const render::Page& page, const render::Glyphs& glyphs, double dpi) const {
    return bytes_of(functions_->to_png(page, glyphs, dpi));
}

std::string Painter::to_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) const {
    return bytes_of(functions_->to_pdf(pages, glyphs));
}

}  // namespace kinegraph::app
