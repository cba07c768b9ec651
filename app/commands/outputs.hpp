// Outputs: what -o and --format ask for, and the drawings that go there: themes, typefaces, pages as bytes. Shared by
// the commands that draw.
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

/// How SVG and PDF carry their words: as outlines alone, or so that they can be selected, searched and read aloud.
enum class Lettering { outlines, live };

struct Target {
    std::string path;
    Format format = Format::svg;
    bool standard() const { return path == "-"; }
    bool is_drawn() const { return format != Format::json && format != Format::csv; }
    bool is_page() const { return format == Format::html; }  ///< live: laid out by itself
    std::string path_of_page(std::size_t page) const;        ///< OUT.svg, OUT-2.svg, OUT-3.svg …
};

/// What is to be written, or why the command line cannot be meant so. Without `outputs` a stated `format` goes to
/// standard output.
tl::expected<std::vector<Target>, Words> targets_of(const std::vector<std::string>& outputs, const std::string& format,
                                                    const std::string& file, std::span<const Format> formats);

/// A built-in theme, or that of a file; else it has been said what is wrong.
tl::expected<render::Theme, Status> theme_of(const std::string& name, const std::string& file, Language language);

/// What a live page of that theme turns to on dark screens: a built-in theme of colours goes with the dark one, what
/// was chosen otherwise is shown as it is.
std::optional<render::Theme> dark_beside(const std::string& theme);

/// The names of further pages are known only late; none may be another output's, or the mechanism file's. Says so where
/// one is.
bool names_clash(const std::vector<Output>& outputs, const std::string& file, Language language);

/// Type; where PNG or PDF is asked for, cairo.
class Press {
public:
    /// All that the targets need; else it has been said what is missing. `language`: of that, and of the remarks.
    static tl::expected<Press, Status> open(const std::vector<Target>& targets, Language language,
                                            Lettering lettering = Lettering::outlines);
    /// What their sheets need to be laid out, for one that may be open already: for a further sheet, which does not
    /// remember the one before.
    static tl::expected<void, Status> prepare(std::optional<Press>& press, Language language,
                                              Lettering lettering = Lettering::outlines);
    /// What is needed to print them. (Loading it takes longer than to lay out a sheet.)
    tl::expected<void, Status> prepare_to_print(const std::vector<Target>& targets);
    const render::Fonts& fonts() const { return *fonts_; }
    /// Adds the pages' bytes for a drawn target, and to `remarks` what standard output cannot carry.
    void print(const std::vector<render::Page>& pages, const Target& target, double dpi, std::vector<Output>& outputs,
               std::vector<std::string>& remarks) const;
    /// The characters that the font has not got.
    void remark_missing(std::vector<std::string>& remarks) const;

private:
    std::vector<std::string> svg_of(std::span<const render::Page> pages) const;

    Language language_ = Language::en;
    std::optional<render::Fonts> fonts_;
    mutable render::GlyphPaths glyph_paths_;  ///< of these fonts: a memory, as they have theirs
    Lettering lettering_ = Lettering::outlines;
};

}  // namespace kinegraph::app
