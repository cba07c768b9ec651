// The typefaces of the machine: Debian's files. Without fontconfig, so that every machine gives the same line.
#include <hb.h>

#include <cstdlib>
#include <string>

#include "lang/keys/pages.hpp"
#include "render/text/typeface.hpp"

namespace kinegraph::render {
namespace {

constexpr std::array<const char*, 4> file_names = {"STIXGeneral-Regular.otf", "STIXGeneral-Italic.otf",
                                                   "STIXGeneral-Bold.otf", "STIXGeneral-BoldItalic.otf"};
constexpr const char* debian_directory = "/usr/share/fonts/opentype/stix";

}  // namespace

tl::expected<Typefaces, Words> open_typefaces() {
    const char* chosen = std::getenv("KINEGRAPH_FONT_DIR");
    const std::string directory = chosen != nullptr && *chosen != '\0' ? chosen : debian_directory;
    Typefaces opened;
    for (std::size_t i = 0; i < opened.size(); ++i) {
        const std::string path = directory + "/" + file_names[i];
        // HarfBuzz maps the file: only what is read of it is loaded, and processes share it.
        const std::shared_ptr<hb_blob_t> mapped(hb_blob_create_from_file_or_fail(path.c_str()), hb_blob_destroy);
        if (mapped) {
            unsigned length = 0;
            const char* const bytes = hb_blob_get_data(mapped.get(), &length);
            opened[i] = typeface_of({bytes, length}, mapped);
        }
        if (!opened[i])
            return tl::unexpected(Words(lang::pages::install_the_debian_package_fonts_stix, path,
                                        mapped ? Words(lang::pages::is_no_font) : Words(lang::pages::cannot_be_read)));
    }
    return opened;
}

}  // namespace kinegraph::render
