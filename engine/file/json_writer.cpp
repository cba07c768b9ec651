#include "engine/file/json_writer.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include "engine/file/json_text.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {

JsonWriter& JsonWriter::open(char bracket, Entries entries) {
    begin_entry();
    text_ += bracket;
    open_.push_back({bracket, entries == Entries::on_lines});
    if (open_.back().on_lines) ++lines_;
    return *this;
}

JsonWriter& JsonWriter::close() {
    KG_ASSERT(!open_.empty(), "what is closed is open");
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.on_lines) --lines_;
    if (closed.on_lines && !closed.is_empty) begin_line(2 * lines_);
    text_ += closed.bracket == '{' ? '}' : ']';
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    begin_entry();
    append_text(name);
    text_ += style_ == Style::script ? ":" : ": ";
    is_value_ = true;
    return *this;
}

JsonWriter& JsonWriter::on_line(int indent) {
    indent_ = indent;
    return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
    begin_entry();
    append_text(text);
    return *this;
}

JsonWriter& JsonWriter::value(double number) {
    begin_entry();
    if (!std::isfinite(number)) {
        text_ += "null";
        return *this;
    }
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number == 0 ? 0.0 : number);
    KG_ASSERT(end.ec == std::errc{}, "a double fits 32 characters");
    text_.append(digits, end.ptr);
    return *this;
}

JsonWriter& JsonWriter::value(int number) { return json(std::to_string(number)); }

JsonWriter& JsonWriter::json(std::string_view text) {
    begin_entry();
    text_ += text;
    return *this;
}

std::string JsonWriter::take() { return std::exchange(text_, {}); }

void JsonWriter::begin_entry() {
    if (std::exchange(is_value_, false) || open_.empty()) return;
    Open& around = open_.back();
    const int indent = indent_ < 0 && around.on_lines ? 2 * lines_ : indent_;
    indent_ = -1;
    if (!around.is_empty) text_ += indent < 0 && style_ == Style::document ? ", " : ",";
    around.is_empty = false;
    if (indent >= 0) begin_line(indent);
}

void JsonWriter::begin_line(int indent) { text_.append(1, '\n').append(static_cast<std::size_t>(indent), ' '); }

void JsonWriter::append_text(std::string_view text) {
    if (style_ == Style::document) return append_json_text(text_, text);
    for (const char c : json_text(text))
        if (c == '<')
            text_ += "\\u003c";  // so that neither "</script>" nor "<!--" appears
        else
            text_ += c;
}

}  // namespace kinegraph
