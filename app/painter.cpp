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

tl::expected<Painter, Words> Painter::open() {
    // A bare name: the loader looks where the program's RPATH says.
    void* const module = ::dlopen("kinegraph_cairo.so", RTLD_LAZY | RTLD_LOCAL);
    if (module == nullptr)
        return tl::unexpected(Words("PNG and PDF are drawn by a module of the program, which cannot be loaded: {0}",
                                    "PNG e PDF sono disegnati da un modulo del programma, che non si può caricare: {0}",
                                    std::string(::dlerror())));
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
