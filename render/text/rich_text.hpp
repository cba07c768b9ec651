// Rich text: words with their faces and scripts, before typesetting. Independent of fonts and of positions.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "render/ink/path.hpp"

namespace kinegraph::render {

enum class Face : std::uint8_t { regular, italic, bold, bold_italic };

/// A run of text with optional stacked scripts, as in a_{BA}^t. `dots` stand over the last letter of `text`. Text,
/// subscript and superscript are plain UTF-8 from any file; they contain no markup.
struct Piece {
    std::string text;
    Face face = Face::regular;
    std::string sub;
    Face sub_face = Face::italic;
    std::string sup;
    Face sup_face = Face::regular;
    int dots = 0;
    bool coloured = false;  ///< use `colour` instead of the line's colour
    Colour colour;
};
using RichText = std::vector<Piece>;
inline void append(RichText& to, const RichText& more) { to.insert(to.end(), more.begin(), more.end()); }

/// A single run of text.
inline RichText one_piece(std::string text, Face face = Face::regular) {
    Piece piece;
    piece.text = std::move(text);
    piece.face = face;
    return {piece};
}
inline void append(RichText& to, const std::string& more) { append(to, one_piece(more)); }

/// A unit or number, with its powers as superscripts: "m/s²", "5 × 10⁻³".
RichText with_powers(const std::string& text);
/// The text without formatting: "v_B", "a_BA^t".
std::string plain(const RichText& text);
/// The text as it is typeset. The font has raised digits only for 1, 2 and 3, so Unicode superscript characters become
/// superscripts.
RichText as_set(const RichText& text);

/// Appends a point to the name of a line. Names of one or two letters are concatenated, "O₂A"; a longer name is
/// separated by a dash, so that it remains recognisable.
void append_point(RichText& line, const RichText& point);

}  // namespace kinegraph::render
