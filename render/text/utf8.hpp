// UTF-8 decoding and encoding. Every byte that is not well formed becomes U+FFFD; nothing is read past the end.
// Independent of fonts and markup.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace kinegraph::render {

/// Unicode superscript digits and minus, with the character that each raises.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 11> raised_characters{{{"⁰", "0"},
                                                                                                  {"¹", "1"},
                                                                                                  {"²", "2"},
                                                                                                  {"³", "3"},
                                                                                                  {"⁴", "4"},
                                                                                                  {"⁵", "5"},
                                                                                                  {"⁶", "6"},
                                                                                                  {"⁷", "7"},
                                                                                                  {"⁸", "8"},
                                                                                                  {"⁹", "9"},
                                                                                                  {"⁻", "−"}}};

constexpr char32_t replacement_character = 0xFFFD;

/// Decodes the code point at `at` and advances `at` past it. Overlong forms, surrogates and values above U+10FFFF are
/// not well formed.
inline char32_t next_code_point(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(at++);
    if (lead < 0x80) return lead;
    if (lead < 0xC2 || lead > 0xF4) return replacement_character;
    const std::size_t more = lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
    char32_t code = lead & (0x3FU >> more);
    if (text.size() - at < more) return replacement_character;
    for (std::size_t i = 0; i < more; ++i) {
        if ((byte(at + i) & 0xC0) != 0x80) return replacement_character;
        code = (code << 6) | (byte(at + i) & 0x3FU);
    }
    const char32_t least = more == 1 ? 0x80 : more == 2 ? 0x800 : 0x10000;
    if (code < least || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return replacement_character;
    at += more;
    return code;
}

/// Number of code points of a text, for the columns of a table.
inline std::size_t character_count(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) next_code_point(text, at);
    return count;
}

/// The first `count` code points of a text, or all of it if it is shorter.
inline std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t at = 0;
    for (; at < text.size() && count > 0; --count) next_code_point(text, at);
    return text.substr(0, at);
}

/// Appends a code point, which must be valid.
inline void append_utf8(std::string& text, char32_t code) {
    const auto put = [&](char32_t bits) { text += static_cast<char>(static_cast<std::uint8_t>(bits)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | (code >> 18));
        put(0x80 | ((code >> 12) & 0x3F));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

/// The text with everything that is not UTF-8, or that XML 1.0 forbids, replaced by U+FFFD. Escapes nothing.
inline std::string well_formed(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const char32_t c = next_code_point(text, at);
        const bool forbidden = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0xFFFE || c == 0xFFFF;
        append_utf8(out, forbidden ? replacement_character : c);
    }
    return out;
}

}  // namespace kinegraph::render
