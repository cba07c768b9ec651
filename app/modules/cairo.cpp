// kinegraph_cairo.so: the library's PNG and PDF, for the program to load when it is asked for one.
#include "app/modules/cairo.hpp"

#include <exception>

#include "render/backends/backends.hpp"

namespace kinegraph::app {
namespace {

template <class Drawing>
CairoFunctions::Bytes bytes_or_fault(Drawing&& drawing) {
    try {
        return drawing();
    } catch (const std::exception& fault) {
        return tl::unexpected(std::string(fault.what()));
    }
}

CairoFunctions::Bytes png(const render::Page& page, const render::Glyphs& glyphs, double dpi) {
    return bytes_or_fault([&] { return render::to_png(page, glyphs, dpi); });
}

CairoFunctions::Bytes pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) {
    return bytes_or_fault([&] { return render::to_pdf(pages, glyphs); });
}

CairoFunctions::Bytes live_pdf(const std::vector<render::Page>& pages, const render::Glyphs& glyphs) {
    return bytes_or_fault([&] { return render::to_live_pdf(pages, glyphs); });
}

}  // namespace
}  // namespace kinegraph::app

extern "C" [[gnu::visibility("default")]] const kinegraph::app::CairoFunctions kinegraph_cairo{
    kinegraph::app::png, kinegraph::app::pdf, kinegraph::app::live_pdf};
