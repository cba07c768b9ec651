// Live text: the readable text of a page, run by run, for backends that write text and not only outlines. Independent
// of file formats.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// A glyph and its text. If one character (a letter and its accent) has several glyphs, only the first has text.
struct Letter {
    Glyph glyph;
    std::string text;
};

/// A run of a line.
struct LiveRun {
    enum class Kind : std::uint8_t {
        set,    ///< letters of one face, size, baseline and colour, without a space between them
        coded,  ///< a character missing from the font, drawn as its boxed code
        said,   ///< readable but invisible: the "_" and "^" before scripts, as in plain(text)
        dots,   ///< combining dots over the preceding letter, drawn separately
        blank,  ///< space between words
    };
    Kind kind = Kind::blank;
    std::string text;             ///< well-formed UTF-8, without control characters and bidirectional marks
    std::vector<Letter> letters;  ///< for the kinds `set` and `coded`
    Colour colour;
};

/// A line of text: the mark that carries its words, and the following marks in other colours.
struct LiveLine {
    const TextMark* first = nullptr;
    std::vector<const TextMark*> marks;  ///< all of them
    std::vector<LiveRun> runs;           ///< in reading order
};

/// The line that begins with the text mark at marks.front(); its marks are consecutive. Empty for any other mark.
LiveLine live_line(std::span<const Mark> marks);

/// The rich text of a line as typeset; the words of a mark that has no rich text.
RichText text_of(const TextMark& mark);

/// The readable text of a line: plain(text_of(mark)) without characters that can be neither seen nor heard.
std::string reading_of(const LiveLine& line);

/// Estimated width of a glyph, em, from its ink: equal white space on both sides, with a minimum.
double width_of(const Outline& outline);

/// The position on paper of a spot of a text that is not turned yet.
Spot turned(const TextMark& mark, Spot spot);
/// The outline of a glyph of a text where it stands on paper, filled.
Path filled_glyph(const TextMark& mark, const Glyph& glyph, const Outline& outline, Colour colour);

/// The document with a new catalog appended (an incremental update) that sets /Lang, /Marked (for its tags) and
/// /DisplayDocTitle. `pdf` must have a cross-reference table, as cairo 1.16 writes it; a PDF with a cross-reference
/// stream is returned unchanged.
std::string with_language(std::string pdf, std::string_view language);

}  // namespace kinegraph::render
