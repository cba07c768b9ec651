// Replaces functions of the library by functions that load their back end on the first call. The library's own
// functions link the same back ends directly (CMakeLists.txt explains how and why).
#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "app/late/modules.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph {
namespace {

/// The symbol NAME exported by the module NAME.so. The module is searched beside the program (in a build folder) or in
/// lib/kinegraph (installed), and stays loaded until the end of the run. Thread-safe. `purpose`: what the module does,
/// for the message if it cannot be loaded.
tl::expected<const void*, Words> late_library(const std::string& name, const Words& purpose) {
    std::error_code ignored;
    const std::string file = name + ".so";
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path built = here / file, installed = here / KINEGRAPH_MODULE_FOLDER / file;
    void* const library = ::dlopen((exists(built, ignored) ? built : installed).c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        return tl::unexpected(Words(lang::library::by_a_module_of_the_program, purpose, std::string(::dlerror())));
    const void* const exported = ::dlsym(library, name.c_str());
    KG_ASSERT(exported != nullptr, "a module exports its functions under its own name");
    return exported;
}

template <class Module>
using Late = tl::expected<const Module*, Words>;

template <class Module>
Late<Module> late(const char* name, const Words& purpose) {
    return late_library(name, purpose).map([](const void* exported) { return static_cast<const Module*>(exported); });
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
