#include "engine/json_text.hpp"

namespace kinegraph {

std::string json_text(std::string_view text) {
    std::string json = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            json += '\\';
            json += letter;
        } else if (code < 0x20 || code == 0x7f) {
            constexpr const char* digits = "0123456789abcdef";
            json += "\\u00";
            json += digits[code >> 4];
            json += digits[code & 15];
        } else {
            json += letter;
        }
    }
    return json + '"';
}

}  // namespace kinegraph
