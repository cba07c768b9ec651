// Backends: conversion of a Page to bytes. No layout is decided here.
// The same page gives the same bytes on every machine: no clock, no locale, no version.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"
#include "render/backends/embedded_type.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

struct Picture;

/// Cache of the path data of glyphs, by face, index and size, for one set of fonts. Share it between many SVGs.
class GlyphPaths {
public:
    /// Clears the cache if it is very large. Call between pages.
    void keep_few();
    /// The path data of a glyph; empty if not computed yet.
    std::string& of(std::uint64_t glyph) { return paths_[glyph]; }

private:
    std::unordered_map<std::uint64_t, std::string> paths_;
};

/// SVG 1.1, one user unit = 1 mm. Groups, ids, titles and data attributes follow docs/drawing.md; text is drawn as
/// outlines.
std::string to_svg(const Page& page, const Fonts& fonts);
/// The same for several pages; outlines that they share are computed once.
std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts);
/// The same with an existing cache of outlines of these fonts.
std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts, GlyphPaths& known);

/// The same with text that can be selected, searched and read aloud: <text> instead of outlines, with the needed subset
/// of the font embedded. The text of each line is plain(as_set(text)).
std::vector<std::string> to_live_svg(std::span<const Page> pages, const Glyphs& glyphs);
/// The same in Times New Roman, without a font in the file: word processors read none, and know the first family only.
/// Its letters are as wide as ours.
std::vector<std::string> to_office_svg(std::span<const Page> pages, const Glyphs& glyphs);

/// Call before to_png or to_pdf. Error: the drawing library is missing, which can happen only in a program that loads
/// it on demand.
tl::expected<void, Words> open_painter();

/// PNG (RGB, or grey for a page without colour) at `dpi` dots per inch.
std::string to_png(const Page& page, const Glyphs& glyphs, double dpi);

/// PDF of all pages in order. Subsets of the fonts are embedded; the creation date is fixed.
std::string to_pdf(const std::vector<Page>& pages, const Glyphs& glyphs);
/// The same with accessibility: tags (paragraphs, figures), language, and the text plain(as_set(text)) of every line.
std::string to_live_pdf(const std::vector<Page>& pages, const Glyphs& glyphs);

/// DXF (AutoCAD 2007), one drawing for each page: mm, y upwards, a layer for each role, true arcs and circles, text
/// that is text.
std::vector<std::string> to_dxf(std::span<const Page> pages, const Glyphs& glyphs);

/// LaTeX: a complete document for pdflatex with TikZ, one picture per page; read by \input in another document, it
/// gives the pictures only. Colours, line kinds and named points are defined first; TeX typesets the words.
std::string to_tex(const std::vector<Page>& pages, const Glyphs& glyphs);
/// LaTeX for the class beamer: consecutive pages of steps with the same figure are one frame with an overlay for each,
/// whose sentences TeX sets. For pdflatex and lualatex.
std::string to_beamer(const std::vector<Page>& pages, const Glyphs& glyphs);

/// The pixels of to_png's picture, without encoding and decoding.
Picture to_picture(const Page& page, const Glyphs& glyphs, double dpi);

}  // namespace kinegraph::render
