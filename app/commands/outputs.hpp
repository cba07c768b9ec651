// Outputs: reads -o and --format, and writes drawings: themes, typefaces, pages as bytes. Shared by the commands that
// draw.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/files.hpp"
#include "render/backends/backends.hpp"
#include "render/page/theme.hpp"
#include "render/text/text.hpp"

namespace kinegraph::app {

enum class Format { svg, png, pdf, tex, json, csv, html };

/// How SVG and PDF contain text: as outlines only, or so that it can be selected, searched and read aloud.
enum class Lettering { outlines, live };

struct Target {
    std::string path;
    Format format = Format::svg;
    bool standard() const { return path == "-"; }
    bool is_drawn() const { return format != Format::json && format != Format::csv; }
    bool is_page() const { return format == Format::html; }  ///< a live page, which has its own layout
    std::string path_of_page(std::size_t page) const;        ///< OUT.svg, OUT-2.svg, OUT-3.svg …
};

/// The output files, or why the options are wrong. Without `outputs`, a given `format` goes to standard output.
tl::expected<std::vector<Target>, Words> targets_of(const std::vector<std::string>& outputs, const std::string& format,
                                                    const std::string& file, std::span<const Format> formats);

/// A built-in theme or that of a file; a status after an error was reported.
tl::expected<render::Theme, Status> theme_of(const std::string& name, const std::string& file, Language language);

/// The theme of a live page on dark screens: the dark theme for a built-in theme in colours, none for any other theme.
std::optional<render::Theme> dark_beside(const std::string& theme);

/// The names of further pages are known only after layout. Returns true, and reports it, if one of them is another
/// output or the mechanism file.
bool names_clash(const std::vector<Output>& outputs, const std::string& file, Language language);

/// The output writer: owns the typefaces, and cairo if PNG or PDF is requested.
class OutputWriter {
public:
    /// Opens all that the targets need; a status after an error was reported. `language`: of errors and remarks.
    static tl::expected<OutputWriter, Status> open(const std::vector<Target>& targets, Language language,
                                                   Lettering lettering = Lettering::outlines);
    /// Opens what layout needs, unless already open. Call before each sheet: it clears the remarks of the sheet before.
    static tl::expected<void, Status> prepare(std::optional<OutputWriter>& press, Language language,
                                              Lettering lettering = Lettering::outlines);
    /// Loads what printing needs. Separate from prepare(), because loading takes longer than the layout of a sheet.
    tl::expected<void, Status> prepare_to_print(const std::vector<Target>& targets);
    const render::Fonts& fonts() const { return *fonts_; }
    /// Adds the bytes of the pages for a target, and to `remarks` what standard output cannot contain.
    void print(const std::vector<render::Page>& pages, const Target& target, double dpi, std::vector<Output>& outputs,
               std::vector<std::string>& remarks) const;
    /// Adds a remark on the characters that the font lacks.
    void remark_missing(std::vector<std::string>& remarks) const;

private:
    std::vector<std::string> svg_of(std::span<const render::Page> pages) const;

    Language language_ = Language::en;
    std::optional<render::Fonts> fonts_;
    mutable render::GlyphPaths glyph_paths_;  ///< a cache of outlines of these fonts
    Lettering lettering_ = Lettering::outlines;
};

}  // namespace kinegraph::app
