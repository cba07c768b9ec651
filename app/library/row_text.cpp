#include "app/library/row_text.hpp"

#include <array>
#include <charconv>

#include "engine/file/json_text.hpp"

namespace kinegraph::app {
namespace {

/// A name that contains quotes or a comma is quoted in CSV, with the quotes doubled.
std::string csv_name(const std::string& name) {
    if (name.find_first_of("\",") == std::string::npos) return name;
    std::string text = "\"";
    for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

}  // namespace

std::string decimal_of(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value);
    return {digits.data(), end.ptr};
}

std::string json_list(const std::vector<double>& values) {
    std::string text = "[";
    for (const double each : values) text += (text.size() > 1 ? ", " : "") + decimal_of(each);
    return text + "]";
}

void RowText::head(const std::vector<Column>& columns, const std::string& before) {
    if (is_json()) text_ = "{\n  " + before + ",\n  \"columns\": [";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i > 0) text_ += is_json() ? ", " : ",";
        text_ += is_json() ? json_text(columns[i].name) : csv_name(columns[i].name);
    }
    text_ += is_json() ? "],\n  \"rows\": [" : "\n";
}

bool RowText::row(std::span<const double> values, const std::vector<bool>& empty) {
    if (is_json()) text_ += is_first_ ? "\n    [" : ",\n    [";
    is_first_ = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text_ += is_json() ? ", " : ",";
        if (empty[i])
            text_ += is_json() ? "null" : "";
        else
            text_ += decimal_of(values[i]);
    }
    text_ += is_json() ? "]" : "\n";
    constexpr std::size_t at_a_time = 1 << 16;
    return text_.size() <= at_a_time || pass_on();
}

bool RowText::tail(const std::string& after) {
    if (is_json()) text_ += std::string(is_first_ ? "]" : "\n  ]") + ",\n  " + after + "\n}\n";
    return pass_on();
}

bool RowText::pass_on() {
    const bool goes_on = to_.write(text_);
    text_.clear();
    return goes_on;
}

}  // namespace kinegraph::app
