// Rich text as TeX: letters of quantities as mathematics, prose as text, whatever a file may name escaped. Knows no place and no
// size; the fonts are those that plain LaTeX brings along (Computer Modern in its OT1 encoding).
#pragma once

#include <optional>
#include <string>
#include <string_view>

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
    // Blanks at the ends, also those that are told to stay: "\\ ".
    const std::string_view told = "\\ ";
    std::string_view inner = tex;
    while (inner.starts_with(' ') || inner.starts_with(told)) inner.remove_prefix(inner.front() == ' ' ? 1 : told.size());
    while (inner.ends_with(' ')) inner.remove_suffix(inner.ends_with(told) ? told.size() : 1);
    return std::string(inner);
}

}  // namespace kinegraph::render
