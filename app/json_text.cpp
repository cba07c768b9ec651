#include "app/json_text.hpp"

namespace kinegraph::app {
namespace {

void quote(std::string_view text, std::string& json) {
    constexpr std::string_view digits = "0123456789abcdef";
    json += '"';
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            json += '\\';
            json += letter;
        } else if (letter == '\n') {
            json += "\\n";
        } else if (code < 0x20 || code == 0x7f) {
            json += "\\u00";
            json += digits[code >> 4U];
            json += digits[code & 15U];
        } else {
            json += letter;
        }
    }
    json += '"';
}

void copy(JsonValue value, std::string& json) {
    if (value.is_string()) return quote(value.text(), json);
    if (!value.is_array() && !value.is_object()) {
        json += value.text();
        return;
    }
    json += value.is_array() ? '[' : '{';
    bool first = true;
    for (const JsonValue each : value) {
        if (!first) json += ", ";
        first = false;
        if (value.is_object()) {
            quote(each.key(), json);
            json += ": ";
        }
        copy(each, json);
    }
    json += value.is_array() ? ']' : '}';
}

}  // namespace

std::string quoted(std::string_view text) {
    std::string json;
    json.reserve(text.size() + 2);
    quote(text, json);
    return json;
}

std::string quoted(const std::vector<std::string>& texts) {
    std::string json = "[";
    for (const std::string& text : texts) {
        if (json.size() > 1) json += ", ";
        quote(text, json);
    }
    return json + ']';
}

std::string copied(JsonValue value) {
    std::string json;
    copy(value, json);
    return json;
}

std::string on_one_line(std::string_view json) {
    std::string line;
    line.reserve(json.size());
    for (std::size_t at = 0; at < json.size(); ++at) {
        if (json[at] != '\n') {
            line += json[at];
            continue;
        }
        while (at + 1 < json.size() && (json[at + 1] == ' ' || json[at + 1] == '\n')) ++at;
        if (line.ends_with(',')) line += ' ';
    }
    return line;
}

}  // namespace kinegraph::app
