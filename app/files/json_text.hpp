// JSON on one line: an object made member by member, quoted texts, a document without its line feeds.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::app {

/// {"key": value, …}
class JsonLine {
public:
    JsonLine& add(std::string_view key, std::string_view text);
    JsonLine& add(std::string_view key, const std::vector<std::string>& texts);
    JsonLine& add(std::string_view key, std::integral auto number) { return add_json(key, std::to_string(number)); }
    /// A value that is JSON already.
    JsonLine& add_json(std::string_view key, std::string_view value);
    /// The members of an object that is JSON already, or of another.
    JsonLine& add_members(std::string_view object);
    JsonLine& add_members(const JsonLine& more);

    std::string object() const { return "{" + members_ + "}"; }

private:
    void begin_member();

    std::string members_;
};

/// ["…", "…"]
std::string json_quoted(const std::vector<std::string>& texts);
/// [a, b] of values that are JSON already.
std::string json_list(const std::vector<std::string>& values);
/// A JSON document on one line. (JSON strings contain no line feed.)
std::string on_one_line(std::string_view json);

}  // namespace kinegraph::app
