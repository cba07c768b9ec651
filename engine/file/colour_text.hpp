// A colour as files write it: "#RRGGBB".
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace kinegraph {

/// 0xRRGGBB; nothing where the text is no colour.
inline std::optional<std::uint32_t> colour_of_text(std::string_view text) {
    constexpr std::size_t length = 7;
    std::uint32_t number = 0;
    if (text.size() != length || text[0] != '#') return std::nullopt;
    const char* const end = text.data() + text.size();
    if (std::from_chars(text.data() + 1, end, number, 16).ptr != end) return std::nullopt;
    return number;
}

}  // namespace kinegraph
