// The backends: a Page to bytes. Small and dull; nothing is decided here.
// The same page gives the same bytes on every machine: no clock, no locale, no version.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"
#include "render/backends/embedded_type.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// Path data of the glyphs of one set of fonts, by face, index and size: what one SVG has written out another need not.
/// Kept by who makes many.
class GlyphPaths {
public:
    /// Where there are very many, all are forgotten: to be called between pages.
    void keep_few();
    /// Empty where it is new.
    std::string& of(std::uint64_t glyph) { return paths_[glyph]; }

private:
    std::unordered_map<std::uint64_t, std::string> paths_;
};

/// SVG 1.1, one user unit = 1 mm; groups, ids, titles and data attributes as docs/drawing.md says; text as outlines.
std::string to_svg(const Page& page, const Fonts& fonts);
/// The same of several pages: an outline that they share is written out once.
std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts);
/// The same, beginning with the outlines that are `known` of these fonts.
std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts, GlyphPaths& known);

/// The same with text that can be selected, searched and read aloud: <text> where the outlines stand, with the parts of
/// the font that it needs in the file. What a reader reads is plain(as_set(text)) of each line.
std::vector<std::string> to_live_svg(std::span<const Page> pages, const Glyphs& glyphs);

/// To be called before a PNG or a PDF is asked for. Error: what paints them is missing, which can only be where a
/// program opens it late.
tl::expected<void, Words> open_painter();

/// PNG (RGB, or grey where the page has no colour) at `dpi` dots per inch.
std::string to_png(const Page& page, const Glyphs& glyphs, double dpi);

/// PDF with all pages in order; the glyphs used are embedded as parts of their font, no creation date of the day.
std::string to_pdf(const std::vector<Page>& pages, const Glyphs& glyphs);
/// The same for programs that read: tagged (paragraphs, figures), with its language, and every line says
/// plain(as_set(text)).
std::string to_live_pdf(const std::vector<Page>& pages, const Glyphs& glyphs);

/// LaTeX: a whole document for pdflatex with TikZ, a picture on a page of its own for each page; or, read by \input in
/// another document, the pictures alone. Colours, kinds of line and named points stand on top; words are set by TeX.
std::string to_tex(const std::vector<Page>& pages, const Glyphs& glyphs);

}  // namespace kinegraph::render
