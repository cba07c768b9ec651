// Rich text as TeX: letters of quantities as mathematics, prose as text, whatever a file may name escaped. Knows no
// place and no size; the fonts are those that plain LaTeX brings along (Computer Modern in its OT1 encoding).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// What stands on a line between two blanks that TeX sees as such: outside of every brace.
struct TexWord {
    std::string tex;
    std::size_t at = 0;      ///< where it begins in plain(text), bytes
    std::size_t blanks = 0;  ///< blanks that it begins with, behind the one before it: "\\ "
};

using NameOfColour = std::function<std::string(Colour)>;

/// The text for TeX's horizontal mode, word by word, without blanks at its ends; pieces in another colour as
/// {\color{NAME}…}. Nothing where TeX has no letter for one of its characters: then it is drawn as its outlines.
std::optional<std::vector<TexWord>> tex_words_of(const RichText& text, const NameOfColour& name_of);

/// The words with a blank between each two.
std::string line_of(const std::vector<TexWord>& words);

/// The whole line at once.
std::optional<std::string> tex_of(const RichText& text, const NameOfColour& name_of);

}  // namespace kinegraph::render
