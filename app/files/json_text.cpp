#include "app/files/json_text.hpp"

#include <kinegraph/request.hpp>

namespace kinegraph::app {

std::string json_quoted(const std::vector<std::string>& texts) {
    std::string json = "[";
    for (const std::string& text : texts) {
        if (json.size() > 1) json += ", ";
        json += json_string(text);
    }
    return json + ']';
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
