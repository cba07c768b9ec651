#include "app/files/json_text.hpp"

#include <kinegraph/request.hpp>

namespace kinegraph::app {

void JsonLine::begin_member() {
    if (!members_.empty()) members_ += ", ";
}
JsonLine& JsonLine::add(std::string_view key, std::string_view text) { return add_json(key, json_string(text)); }
JsonLine& JsonLine::add(std::string_view key, const std::vector<std::string>& texts) {
    return add_json(key, json_quoted(texts));
}
JsonLine& JsonLine::add_json(std::string_view key, std::string_view value) {
    begin_member();
    members_ += json_string(key);
    members_ += ": ";
    members_ += value;
    return *this;
}
JsonLine& JsonLine::add_members(std::string_view object) {
    if (object.size() <= 2) return *this;
    begin_member();
    members_ += object.substr(1, object.size() - 2);
    return *this;
}
JsonLine& JsonLine::add_members(const JsonLine& more) {
    if (more.members_.empty()) return *this;
    begin_member();
    members_ += more.members_;
    return *this;
}

std::string json_quoted(const std::vector<std::string>& texts) {
    std::vector<std::string> values;
    values.reserve(texts.size());
    for (const std::string& text : texts) values.push_back(json_string(text));
    return json_list(values);
}

std::string json_list(const std::vector<std::string>& values) {
    std::string json = "[";
    for (const std::string& value : values) {
        if (json.size() > 1) json += ", ";
        json += value;
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
