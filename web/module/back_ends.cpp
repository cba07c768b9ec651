// The back ends of the library that the module for the browser replaces: the browser itself draws PNG and prints PDF,
// no page asks for archives or derivatives, and the fonts are part of the module. app/late/back_ends.cpp is the
// program's counterpart.
#include "engine/file/expression.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/library.hpp"
#include "render/backends/archive.hpp"
#include "render/backends/backends.hpp"
#include "render/text/typeface.hpp"

// The font files, in the order of render::Face (web/module/fonts.S).
extern "C" const char stix_regular[], stix_regular_end[], stix_italic[], stix_italic_end[], stix_bold[],
    stix_bold_end[], stix_bold_italic[], stix_bold_italic_end[];

namespace kinegraph {

tl::expected<void, Words> render::open_painter() { return tl::unexpected(Words(lang::library::by_the_browser)); }
std::string render::to_png(const Page& /*page*/, const Glyphs& /*glyphs*/, double /*dpi*/) {
    KG_ASSERT(false, "no painter was opened");
    return {};
}
std::string render::to_pdf(const std::vector<Page>& /*pages*/, const Glyphs& /*glyphs*/) {
    KG_ASSERT(false, "no painter was opened");
    return {};
}
std::string render::to_live_pdf(const std::vector<Page>& pages, const Glyphs& glyphs) { return to_pdf(pages, glyphs); }

tl::expected<std::string, Words> render::packed(const std::vector<Packed>& /*files*/) {
    return tl::unexpected(Words(lang::library::by_the_program));
}

tl::expected<Expression, Error> derivative(const Expression& /*of*/, const NamedConstants& /*constants*/) {
    return tl::unexpected(Error{ErrorCode::output, "", Words(lang::library::motion_by_the_program)});
}

tl::expected<render::Typefaces, Words> render::open_typefaces() {
    constexpr auto face = [](const char* first, const char* last) {
        return typeface_of({first, static_cast<std::size_t>(last - first)}, nullptr);
    };
    Typefaces opened{face(stix_regular, stix_regular_end), face(stix_italic, stix_italic_end),
                     face(stix_bold, stix_bold_end), face(stix_bold_italic, stix_bold_italic_end)};
    for (const auto& each : opened) KG_ASSERT(each != nullptr, "the module was built with the fonts");
    return opened;
}

}  // namespace kinegraph
