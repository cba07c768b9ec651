#include "app/files/json_text.hpp"

#include "engine/file/json_text.hpp"

namespace kinegraph::app {
namespace {

/// Escapes a line feed as "\n", the shortest form: sheets have many lines.
void quote(std::string_view text, std::string& json) { append_json_text(json, text, "\\n"); }

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

std::string json_quoted(std::string_view text) {
    std::string json;
    json.reserve(text.size() + 2);
    quote(text, json);
    return json;
}

std::string json_quoted(const std::vector<std::string>& texts) {
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
