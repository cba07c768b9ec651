// What the type of a page says, run by run: for backends that write words and not outlines alone. Knows no format.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// A glyph and what is read where it stands; a glyph more of one character (a letter and its accent) says nothing.
struct Letter {
    Glyph glyph;
    std::string text;
};

/// A stretch of a line.
struct LiveRun {
    enum class Kind : std::uint8_t {
        set,    ///< letters of one face, size, baseline and colour, without a blank between them
        coded,  ///< a character that the font has not: its code stands in a box
        said,   ///< read and not seen: the "_" and "^" before scripts, in plain(text)'s way
        dots,   ///< over the letter before it, drawn apart: the combining characters
        blank,  ///< between words
    };
    Kind kind = Kind::blank;
    std::string text;             ///< well-formed UTF-8, without controls and without marks that change the direction
    std::vector<Letter> letters;  ///< of `set` and `coded`
    Colour colour;
};

/// A line of type: the mark that has its words, with those that follow it in other colours.
struct LiveLine {
    const TextMark* first = nullptr;
    std::vector<const TextMark*> marks;  ///< all of them
    std::vector<LiveRun> runs;           ///< in the order of reading
};

/// The line that begins with the text at marks.front(); the marks it has taken stand one behind the other. Of another
/// mark: none.
LiveLine live_line(std::span<const Mark> marks);

/// The rich text of a line as it is set; where a mark has none, its words.
RichText text_of(const TextMark& mark);

/// What a reader of the line reads: plain(text_of(mark)) without what cannot be seen or heard.
std::string reading_of(const LiveLine& line);

}  // namespace kinegraph::render
