// Markup: a streaming XML writer, one element per line. Owns escaping, indentation and the format of numbers. It keeps
// no tree: write an element in the order of its bytes, namely name, attributes, content, end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/number/assert.hpp"

namespace kinegraph::render {

/// A growing byte buffer. A page consists of a hundred thousand short pieces, so appending is inline: one comparison
/// and one copy.
class Bytes {
public:
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    /// `size`: the expected total number of bytes.
    void reserve(std::size_t size) {
        if (capacity_ < size) grow(size - size_);
    }
    std::string_view text() const { return {bytes_.get(), size_}; }

    void put(char c) { *room(1) = c, ++size_; }
    void put(std::string_view text) {
        if (text.empty()) return;
        std::memcpy(room(text.size()), text.data(), text.size());
        size_ += text.size();
    }
    /// The decimal units · 10^-digits, without trailing zeros. `digits`: 0, 4, 6 or 8.
    template <int digits>
    void put_decimal(std::int64_t units);
    /// A coordinate with at most `digits` decimals, without trailing zeros: the shortest decimal of the snapped number.
    template <int digits>
    void put_number(double value);

private:
    /// Pointer to space for `more` further bytes.
    char* room(std::size_t more) {
        if (capacity_ - size_ < more) grow(more);
        return bytes_.get() + size_;
    }
    void grow(std::size_t more);

    std::unique_ptr<char[]> bytes_;  // not a std::string, which would zero-initialise on growth
    std::size_t capacity_ = 0, size_ = 0;
};

/// Names of elements and attributes are not copied: element names must outlive the writer.
class Markup {
public:
    /// A whole document with its XML declaration; or a part to be inserted at a depth of `depth` open elements.
    Markup();
    explicit Markup(std::size_t depth);

    /// `size`: the expected number of bytes.
    void reserve(std::size_t size) { bytes_.reserve(size); }
    /// Byte offset of the next element, at which another part may be inserted.
    std::size_t place() {
        close_tag();
        return bytes_.size();
    }
    /// Everything written. All elements must be closed.
    std::string_view text() const { return bytes_.text(); }

    void begin(std::string_view element);
    void end();
    /// An attribute of the element just begun. The value is valid UTF-8 and is escaped here.
    void attribute(std::string_view name, std::string_view value);
    /// An attribute whose value is appended to the returned buffer, up to close_value(). The pieces must need no
    /// escaping.
    Bytes& open_value(std::string_view name) {
        KG_ASSERT(in_tag_, "attributes stand before what an element holds");
        bytes_.put(' ');
        bytes_.put(name);
        bytes_.put("=\"");
        return bytes_;
    }
    void close_value() { bytes_.put('"'); }
    /// Appends text. White space is significant from here to the end of the element, so what follows stays on the same
    /// line.
    void words(std::string_view text);

private:
    void close_tag() {
        if (in_tag_) bytes_.put('>');
        in_tag_ = false;
    }
    void line_break(std::size_t depth);
    template <bool in_attribute>
    void escaped(std::string_view text);

    Bytes bytes_;
    std::size_t depth_ = 0;               // number of enclosing elements, for a part
    std::vector<std::string_view> open_;  // names of the open elements
    bool in_tag_ = false;                 // a start tag is open: `<g a="b"`
    bool after_words_ = false;
};

}  // namespace kinegraph::render
