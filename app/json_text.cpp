#include "app/json_text.hpp"

namespace kinegraph::app {
namespace {

bool stands_as_it_is(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return letter != '"' && letter != '\\' && code >= 0x20 && code != 0x7f;
}

/// Whole runs at a time: a sheet is some hundred thousand characters, of which few need more.
void quote(std::string_view text, std::string& json) {
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
            json += "\\n";
        } else {
            const auto code = static_cast<unsigned char>(letter);
            json += "\\u00";
            json += digits[code >> 4U];
            json += digits[code & 15U];
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
    while (true) {
        const std::size_t end = json.find('\n');
        line.append(json.substr(0, end));
        if (end == std::string_view::npos) return line;
        const std::size_t next = json.find_first_not_of(" \n", end);
        if (next == std::string_view::npos) return line;
        if (line.ends_with(',')) line += ' ';
        json.remove_prefix(next);
    }
}

}  // namespace kinegraph::app
