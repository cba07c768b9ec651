#include "app/files/json_text.hpp"

#include <nlohmann/json.hpp>

namespace kinegraph::app {
namespace {

std::string dumped(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string json_quoted(std::string_view text) { return dumped(text); }

std::string json_quoted(const std::vector<std::string>& texts) {
    std::string json = "[";
    for (const std::string& text : texts) {
        if (json.size() > 1) json += ", ";
        json += dumped(text);
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
