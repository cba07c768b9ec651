// Rich text as TeX: letters of quantities as mathematics, prose as text, all names of a file escaped. Independent of
// positions and sizes. The fonts are those of plain LaTeX (Computer Modern in OT1 encoding).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// A part of a line between two spaces that TeX can break or stretch: it lies outside of all braces.
struct TexWord {
    std::string tex;
    std::size_t at = 0;      ///< byte offset in plain(text)
    std::size_t blanks = 0;  ///< further leading spaces, written as "\\ "
};

using NameOfColour = std::function<std::string(Colour)>;

/// The text for TeX's horizontal mode, word by word, without spaces at its ends; pieces in another colour as
/// {\color{NAME}…}. Empty if TeX has no letter for one of the characters; such text is drawn as outlines.
std::optional<std::vector<TexWord>> tex_words_of(const RichText& text, const NameOfColour& name_of);

/// The words joined by spaces.
std::string line_of(const std::vector<TexWord>& words);

/// The whole line.
std::optional<std::string> tex_of(const RichText& text, const NameOfColour& name_of);

}  // namespace kinegraph::render
