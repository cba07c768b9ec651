// Subsets: the part of a font file that some characters need, so that a file of ours can bring it along. HarfBuzz's
// subsetter, which does it, is known to subset.cpp alone.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace kinegraph::render {

/// What is needed of a font.
struct WantedType {
    std::set<char32_t> characters;
    std::set<std::uint32_t> glyphs;  ///< with the characters that stand for them
};

/// An OpenType file with what is wanted of `file` (OpenType too): glyphs with the same outlines, widths, kerning and
/// ligatures. The same bytes for the same two. Empty where `file` is no font that can be divided.
std::string font_subset(std::string_view file, const WantedType& wanted);

}  // namespace kinegraph::render
