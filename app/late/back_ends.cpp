// Replaces functions of the library by functions that load their back end on the first call. The library's own
// functions link the same back ends directly (CMakeLists.txt explains how and why).
#include "app/late/late_library.hpp"
#include "app/late/modules.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph {
namespace {

template <class Module>
using Late = tl::expected<const Module*, Words>;

template <class Module>
Late<Module> late(const char* name, const Words& purpose) {
    return app::late_library(name, purpose).map([](const void* exported) {
        return static_cast<const Module*>(exported);
    });
}

const Late<app::CairoModule>& cairo() {
    static const auto module = late<app::CairoModule>("kinegraph_cairo", {lang::library::png_and_pdf_are_drawn});
    return module;
}
const app::CairoModule& opened_cairo() {
    KG_ASSERT(cairo(), "the painter was opened");
    return **cairo();
}
const Late<app::TypeModule>& type() {
    static const auto module = late<app::TypeModule>("kinegraph_type", {lang::library::type_is_set});
    return module;
}
const Late<app::GinacModule>& ginac() {
    static const auto module =
        late<app::GinacModule>("kinegraph_ginac", {lang::library::derivatives_in_symbols_are_found});
    return module;
}
const Late<app::ZipModule>& zip() {
    static const auto module = late<app::ZipModule>("kinegraph_zip", {lang::library::archives_are_packed});
    return module;
}

}  // namespace

tl::expected<void, Words> render::open_painter() {
    if (!cairo()) return tl::unexpected(cairo().error());
    return {};
}
std::string render::to_png(const Page& page, const Glyphs& glyphs, double dpi) {
    return opened_cairo().to_png(page, glyphs, dpi);
}
std::string render::to_pdf(const std::vector<Page>& pages, const Glyphs& glyphs) {
    return opened_cairo().to_pdf(pages, glyphs);
}
std::string render::to_live_pdf(const std::vector<Page>& pages, const Glyphs& glyphs) {
    return opened_cairo().to_live_pdf(pages, glyphs);
}

tl::expected<render::Typefaces, Words> render::open_typefaces() {
    if (!type()) return tl::unexpected(type().error());
    return (*type())->open_typefaces();
}
std::string render::font_subset(std::string_view file, const WantedType& wanted) {
    KG_ASSERT(type(), "the file is a typeface's, which came of the same module");
    return (*type())->font_subset(file, wanted);
}

tl::expected<Expression, Error> derivative(const Expression& of, const NamedConstants& constants) {
    if (!ginac()) return tl::unexpected(Error{ErrorCode::output, "", ginac().error()});
    return (*ginac())->derivative_of(of, constants);
}

tl::expected<std::string, Words> render::packed(const std::vector<Packed>& files) {
    if (!zip()) return tl::unexpected(zip().error());
    return (*zip())->packed_files(files);
}

}  // namespace kinegraph
