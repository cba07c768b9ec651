// Font subsets: the part of a font file that some characters need, to be embedded in our output. Only subset.cpp
// depends on HarfBuzz's subsetter.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace kinegraph::render {

/// What a subset must contain.
struct WantedType {
    std::set<char32_t> characters;
    std::set<std::uint32_t> glyphs;  ///< each with the characters that map to it
};

/// An OpenType file with the wanted part of `file` (OpenType too): same outlines, widths, kerning and ligatures.
/// Deterministic. Empty if `file` is not a font that can be subset.
std::string font_subset(std::string_view file, const WantedType& wanted);

}  // namespace kinegraph::render
