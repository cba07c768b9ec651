// The backends: a Page to bytes. Small and dull; nothing is decided here.
// The same page gives the same bytes on every machine: no clock, no locale, no version.
#pragma once

#include <string>
#include <vector>

#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// SVG 1.1, one user unit = 1 mm; groups, ids, titles and data attributes as docs/format.md says; text as outlines.
std::string to_svg(const Page& page, const Fonts& fonts);
/// The same of several pages: an outline that they share is written out once.
std::vector<std::string> to_svg(const std::vector<Page>& pages, const Fonts& fonts);

/// PNG (RGB, or grey where the page has no colour) at `dpi` dots per inch.
std::string to_png(const Page& page, const Glyphs& glyphs, double dpi);

/// PDF with all pages in order; the glyphs used are embedded as parts of their font, no creation date of the day.
std::string to_pdf(const std::vector<Page>& pages, const Glyphs& glyphs);

}  // namespace kinegraph::render
