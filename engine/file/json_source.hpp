// JsonSource: the text of a JSON file as a lossless tree: members in the file's order, numbers as they are written, the
// place of every value. Owns syntax, depth and duplicate keys; independent of mechanisms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "engine/file/error.hpp"

namespace kinegraph {

class JsonSource;
class JsonTreeBuilder;

/// A value of a JsonSource. The source must outlive it and must not move. A default-constructed one is "not there" and
/// converts to false.
class JsonValue {
public:
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

    JsonValue() = default;
    explicit operator bool() const { return source_ != nullptr; }
    Kind kind() const;
    bool is_array() const { return kind() == Kind::array; }
    bool is_object() const { return kind() == Kind::object; }
    bool is_string() const { return kind() == Kind::string; }
    bool is_number() const { return kind() == Kind::number; }

    /// A string's characters, a number's literal as the file writes it, "true", "false", "null"; empty for array and
    /// object.
    std::string_view text() const;
    /// The name of this member of an object.
    std::string_view key() const;
    /// Its position in the file: earlier values have smaller numbers.
    std::uint32_t order() const { return node_; }
    /// Number of elements or members, duplicates included.
    std::size_t size() const;
    /// The first member with this key, or "not there". A linear search: not for large objects.
    JsonValue operator[](std::string_view key) const;
    /// The JSON pointer, with control characters escaped and very long names cut.
    std::string pointer() const;

    class Iterator;
    Iterator begin() const;
    Iterator end() const;

private:
    friend class JsonSource;
    friend class JsonTreeBuilder;
    JsonValue(const JsonSource* source, std::uint32_t node) : source_(source), node_(node) {}
    const JsonSource* source_ = nullptr;
    std::uint32_t node_ = 0;
};

class JsonSource {
public:
    /// Errors: invalid JSON, with line and column; more than 64 levels.
    static Result<JsonSource> read(std::string_view text);

    JsonValue root() const { return {this, 0}; }
    /// The second and further members of one object that have the same key.
    std::vector<JsonValue> duplicates() const;

private:
    friend class JsonValue;
    friend class JsonTreeBuilder;
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    /// Forty bytes, so that a file of ten megabytes needs some hundred.
    struct Node {
        JsonValue::Kind kind = JsonValue::Kind::null;
        std::uint32_t key_at = 0, key_size = 0, text_at = 0, text_size = 0;
        std::uint32_t parent = none, first_child = none, next = none;
        std::uint32_t index = 0;  ///< among its parent's children
        std::uint32_t size = 0;
    };
    std::string_view slice(std::uint32_t at, std::uint32_t size) const {
        return std::string_view(characters_).substr(at, size);
    }

    std::vector<Node> nodes_;  ///< in the file's order, the root first
    std::string characters_;   ///< of all keys, strings and numbers
    std::vector<std::uint32_t> duplicates_;
};

class JsonValue::Iterator {
public:
    using difference_type = std::ptrdiff_t;  // NOLINT(readability-identifier-naming): the standard library's name
    using value_type = JsonValue;            // NOLINT(readability-identifier-naming)
    Iterator() = default;
    explicit Iterator(JsonValue at) : at_(at) {}
    JsonValue operator*() const { return at_; }
    Iterator& operator++();
    Iterator operator++(int) {
        Iterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_.order() == b.at_.order(); }

private:
    JsonValue at_;
};

}  // namespace kinegraph
