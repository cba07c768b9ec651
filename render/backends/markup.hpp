// Markup: XML as it is written, from its first byte to its last, one element a line. Owns escaping, indentation and how
// a number looks; keeps no tree, so an element is said in the order of its bytes: name, attributes, what stands in it,
// end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/number/assert.hpp"

namespace kinegraph::render {

/// Bytes that grow at their end. A page is a hundred thousand short pieces: each costs a comparison and a copy, not a
/// call.
class Bytes {
public:
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    /// For about so many in all.
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
    /// Decimal, that many units of 10^-digits, without zeros at the end. `digits`: 0, 4, 6 or 8.
    template <int digits>
    void put_decimal(std::int64_t units);
    /// A coordinate with at most `digits` decimals, without trailing zeros: the shortest decimal of the snapped number.
    template <int digits>
    void put_number(double value);

private:
    /// Where so many bytes more have room.
    char* room(std::size_t more) {
        if (capacity_ - size_ < more) grow(more);
        return bytes_.get() + size_;
    }
    void grow(std::size_t more);

    std::unique_ptr<char[]> bytes_;  // not a string, which would blank all that it grows by
    std::size_t capacity_ = 0, size_ = 0;
};

/// Names of elements and attributes must outlive it: they are the format's own words. (Attributes' names are only
/// read.)
class Markup {
public:
    /// With the declaration, or as a part that stands within so many open elements.
    Markup();
    explicit Markup(std::size_t depth);

    /// For about so many bytes.
    void reserve(std::size_t size) { bytes_.reserve(size); }
    /// Where the next element begins: another part may be put in between.
    std::size_t place() {
        close_tag();
        return bytes_.size();
    }
    /// All that is written; every element is ended.
    std::string_view text() const { return bytes_.text(); }

    void begin(std::string_view element);
    void end();
    /// Of the element that was just begun. The value is valid UTF-8, not yet escaped.
    void attribute(std::string_view name, std::string_view value);
    /// The same put together from pieces that need no escaping, between `open` and `close`.
    Bytes& open_value(std::string_view name) {
        KG_ASSERT(in_tag_, "attributes stand before what an element holds");
        bytes_.put(' ');
        bytes_.put(name);
        bytes_.put("=\"");
        return bytes_;
    }
    void close_value() { bytes_.put('"'); }
    /// White space counts from here on to the end of the element: what follows text stands on its line.
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
    std::size_t depth_ = 0;               // of elements that another part has open
    std::vector<std::string_view> open_;  // elements
    bool in_tag_ = false;                 // `<g a="b"` stands open
    bool after_words_ = false;
};

}  // namespace kinegraph::render
