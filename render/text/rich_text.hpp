// Rich text: words with their faces and scripts, before they are set. Knows no font and no place.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "render/ink/path.hpp"

namespace kinegraph::render {

enum class Face : std::uint8_t { regular, italic, bold, bold_italic };

/// A stretch of text with optional scripts, stacked: a_{BA}^t, the dots of a derivative over the last letter of `text`.
/// Text, subscript and superscript are plain UTF-8 from any file; nothing in them is markup.
struct Piece {
    std::string text;
    Face face = Face::regular;
    std::string sub;
    Face sub_face = Face::italic;
    std::string sup;
    Face sup_face = Face::regular;
    int dots = 0;
    bool coloured = false;  ///< true: `colour` instead of the line's
    Colour colour;
};
using RichText = std::vector<Piece>;
inline void append(RichText& to, const RichText& more) { to.insert(to.end(), more.begin(), more.end()); }

/// One stretch of text in one face.
inline RichText one_piece(std::string text, Face face = Face::regular) {
    Piece piece;
    piece.text = std::move(text);
    piece.face = face;
    return {piece};
}
inline void append(RichText& to, const std::string& more) { append(to, one_piece(more)); }

/// A unit or number with its powers as superscripts: "m/s²", "5 × 10⁻³".
RichText with_powers(const std::string& text);
/// What the rich text says without its setting: "v_B", "a_BA^t".
std::string plain(const RichText& text);
/// The text as it is set: digits raised by their characters, which the font has only for 1, 2 and 3, are superscripts.
RichText as_set(const RichText& text);

}  // namespace kinegraph::render
