#include "engine/results/json_parts.hpp"

#include <charconv>
#include <cmath>

#include "engine/file/json_text.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph::json {

std::string quoted(std::string_view text) { return json_text(text); }

void append_number(std::string& json, double value) {
    if (!std::isfinite(value)) {
        json += "null";
    } else if (value == 0) {
        json += '0';
    } else {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, value);
        KG_ASSERT(end.ec == std::errc{}, "a double fits 32 characters");
        json.append(text, end.ptr);
    }
}
std::string number(double value) {
    std::string json;
    append_number(json, value);
    return json;
}
std::string number(const Exact& value) { return number(value.to_double()); }

std::string pair(std::string_view x, std::string_view y) {
    std::string json;
    json.reserve(x.size() + y.size() + 4);
    return json.append("[").append(x).append(", ").append(y).append("]");
}
std::string pair(const Vector& v) {
    std::string json = "[";
    append_number(json, v.x.to_double());
    json += ", ";
    append_number(json, v.y.to_double());
    return json += ']';
}

std::string fraction(const Exact& value) { return quoted(value.to_fraction()); }
std::string fractions(const Vector& v) { return pair(fraction(v.x), fraction(v.y)); }

void append_member(std::string& json, std::string_view key, std::string_view value) {
    append_json_text(json, key);
    json.append(": ").append(value);
}
std::string object(const Members& members) {
    constexpr std::size_t marks = 6;  // between a key and its value, and before the next
    std::size_t size = 2;
    for (const auto& [key, value] : members) size += key.size() + value.size() + marks;
    std::string json = "{";
    json.reserve(size);
    for (const auto& [key, value] : members) {
        if (json.size() > 1) json += ", ";
        append_member(json, key, value);
    }
    return json += '}';
}
std::string lines(char open, const std::vector<std::string>& entries, char close) {
    return lines(open, entries, close, [](std::string& json, const std::string& entry) { json += entry; });
}
std::string object_of_lines(const Members& members) {
    return lines('{', members, '}',
                 [](std::string& json, const auto& member) { append_member(json, member.first, member.second); });
}

Members values_of(const ProblemSolution& found) {
    Members members;
    for (const ProblemValue& each : found.values)
        if (each.in_file) members.emplace_back(in_english(each.name), number(each.value));
    return members;
}

}  // namespace kinegraph::json
