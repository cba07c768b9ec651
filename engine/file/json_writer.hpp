// JsonWriter: a JSON document, written in one pass. Owns commas, line ends, quotation marks and the form of numbers.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/number/exact.hpp"
#include "engine/number/index.hpp"

namespace kinegraph {

class JsonWriter {
public:
    enum class Style {
        document,  ///< {"a": 1, "b": [2, 3]}
        script     ///< {"a":1,"b":[2,3]}: for a script element, so that no "<" is in a text
    };
    /// Where the entries of an object or array stand. On lines, they are indented by two spaces for each bracket round
    /// them that has its entries on lines.
    enum class Entries { in_a_row, on_lines };

    /// `lines`: how many brackets with entries on lines stand round what is written.
    explicit JsonWriter(Style style = Style::document, int lines = 0) : style_(style), lines_(lines) {}

    /// An object by '{', an array by '['.
    JsonWriter& open(char bracket, Entries entries = Entries::in_a_row);
    JsonWriter& close();
    JsonWriter& key(std::string_view name);
    /// The next entry begins a line, with that many spaces before it.
    JsonWriter& on_line(int indent);

    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
    /// The shortest decimal that reads back as the same double; −0 is 0. JSON has no infinities: they are null.
    JsonWriter& value(double number);
    JsonWriter& value(int number);
    JsonWriter& value(std::size_t number) { return json(std::to_string(number)); }
    JsonWriter& value(std::same_as<bool> auto truth) { return json(truth ? "true" : "false"); }
    JsonWriter& value(std::nullopt_t /*nothing*/) { return json("null"); }
    JsonWriter& value(const Exact& number) { return value(number.to_double()); }
    /// [x, y]
    template <class Number>
    JsonWriter& value(const VectorOf<Number>& v) {
        return open('[').value(v.x).value(v.y).close();
    }
    template <class Value>
    JsonWriter& value(const std::optional<Value>& found) {
        return found ? value(*found) : value(std::nullopt);
    }
    template <class List>
    requires requires(const List& list) { list.begin(); }
    JsonWriter& value(const List& all) {
        open('[');
        for (const auto& each : all) value(each);
        return close();
    }
    template <class Of>
    JsonWriter& value(ListIndex<Of> index) {
        return value(index.number());
    }
    /// What another has written.
    JsonWriter& value(const JsonWriter& whole) { return json(whole.text_); }
    /// As a fraction between quotation marks.
    JsonWriter& fraction(const Exact& number) { return value(number.to_fraction()); }
    JsonWriter& fraction(const Vector& v) { return open('[').fraction(v.x).fraction(v.y).close(); }
    /// A value that is JSON already.
    JsonWriter& json(std::string_view text);

    template <class... Value>
    JsonWriter& member(std::string_view name, const Value&... of) {
        return key(name).value(of...);
    }

    template <class... Value>
    JsonWriter& values(const Value&... each) {
        (value(each), ...);
        return *this;
    }
    /// An array by that name, whose entries each() writes.
    template <class List, class Each>
    JsonWriter& list(std::string_view name, const List& all, Each each) {
        key(name).open('[');
        for (const auto& item : all) each(item);
        return close();
    }

    /// Whether the object or array that is open has no entry yet.
    bool is_empty() const { return open_.back().is_empty; }
    std::size_t size() const { return text_.size(); }
    /// What is written, or what has been since the last time.
    std::string take();

private:
    struct Open {
        char bracket = '{';
        bool on_lines = false, is_empty = true;
    };
    void begin_entry();
    void begin_line(int indent);
    void append_text(std::string_view text);

    Style style_;
    std::string text_;
    std::vector<Open> open_;
    int lines_ = 0;          // of the open ones, those with entries on lines
    int indent_ = -1;        // of the next entry's line
    bool is_value_ = false;  // a key is written, its value is next
};

}  // namespace kinegraph
