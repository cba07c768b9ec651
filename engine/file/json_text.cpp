#include "engine/file/json_text.hpp"

namespace kinegraph {

namespace {

bool stands_as_it_is(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return letter != '"' && letter != '\\' && code >= 0x20 && code != 0x7f;
}

}  // namespace

/// Copies runs of plain characters: a sheet has some hundred thousand, of which few need escaping.
void append_json_text(std::string& json, std::string_view text, std::string_view line_end) {
    constexpr std::string_view digits = "0123456789abcdef";
    json += '"';
    while (true) {
        std::size_t plain = 0;
        while (plain < text.size() && stands_as_it_is(text[plain])) ++plain;
        json.append(text.substr(0, plain));
        if (plain == text.size()) break;
        const char letter = text[plain];
        text.remove_prefix(plain + 1);
        if (letter == '"' || letter == '\\') {
            json += '\\';
            json += letter;
        } else if (letter == '\n') {
            json += line_end;
        } else {
            const auto code = static_cast<unsigned char>(letter);
            json += "\\u00";
            json += digits[code >> 4U];
            json += digits[code & 15U];
        }
    }
    json += '"';
}

std::string json_text(std::string_view text) {
    std::string json;
    json.reserve(text.size() + 2);
    append_json_text(json, text);
    return json;
}

}  // namespace kinegraph
