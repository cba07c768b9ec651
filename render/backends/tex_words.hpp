// Rich text as TeX: letters of quantities as mathematics, prose as text, whatever a file may name escaped. Knows no place and no
// size; the fonts are those that plain LaTeX brings along (Computer Modern in its OT1 encoding).
#pragma once

#include <optional>
#include <string>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// The text for TeX's horizontal mode, without blanks at its ends; pieces in another colour as {\color{NAME}…}, NAME from
/// `name_of`. Nothing where TeX has no letter for one of its characters: then it is drawn as its outlines.
template <class NameOfColour>
std::optional<std::string> tex_of(const RichText& text, NameOfColour&& name_of);

/// One piece, of which nothing stands in another colour.
std::optional<std::string> tex_of(const Piece& piece);

template <class NameOfColour>
std::optional<std::string> tex_of(const RichText& text, NameOfColour&& name_of) {
    std::string tex;
    for (const Piece& piece : text) {
        const auto set = tex_of(piece);
        if (!set) return std::nullopt;
        tex += piece.coloured ? "{\\color{" + name_of(piece.colour) + "}" + *set + "}" : *set;
    }
    const std::size_t first = tex.find_first_not_of(' ');
    if (first == std::string::npos) return std::string();
    // A blank that a control sign takes, "\ ", stays.
    std::size_t last = tex.find_last_not_of(' ');
    if (tex[last] == '\\' && last + 1 < tex.size()) ++last;
    return tex.substr(first, last - first + 1);
}

}  // namespace kinegraph::render
