// Markup: see markup.hpp. Indentation is that of pugixml, which reads these files.
#include "render/backends/markup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinegraph::render {
namespace {

constexpr std::size_t longest_number = 40;

struct Pair {
    char tens, ones;
};
/// Table of two-digit numbers: halves the number of divisions.
constexpr auto pairs = [] {
    std::array<Pair, 100> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all.at(i) = {static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)};
    return all;
}();

char* put_pair(char* at, std::uint64_t below_hundred) {
    std::memcpy(at, &pairs[static_cast<std::size_t>(below_hundred)], 2);
    return at + 2;
}

/// Without leading zeros.
char* put_whole(char* at, std::uint64_t number) {
    if (number >= 100) {
        at = put_whole(at, number / 100);
        return put_pair(at, number % 100);
    }
    if (number >= 10) return put_pair(at, number);
    *at = static_cast<char>('0' + number);
    return at + 1;
}

template <int digits>
constexpr std::int64_t power_of_ten = 10 * power_of_ten<digits - 1>;
template <>
constexpr std::int64_t power_of_ten<0> = 1;

/// Two digits at a time while any are left; division by a constant compiles to a multiplication.
template <int digits>
char* put_decimals(char* at, std::uint64_t rest) {
    if constexpr (digits > 0) {
        static_assert(digits % 2 == 0, "decimals are written in pairs");
        constexpr auto part = static_cast<std::uint64_t>(power_of_ten<digits - 2>);
        if (rest != 0) return put_decimals<digits - 2>(put_pair(at, rest / part), rest % part);
    }
    return at;
}

}  // namespace

void Bytes::grow(std::size_t more) {
    constexpr std::size_t least = 512;
    capacity_ = std::max({2 * capacity_, least, size_ + more});
    std::unique_ptr<char[]> larger(new char[capacity_]);  // not filled with zeros first
    if (size_ > 0) std::memcpy(larger.get(), bytes_.get(), size_);
    bytes_ = std::move(larger);
}

template <int digits>
void Bytes::put_decimal(std::int64_t units) {
    char* const first = room(longest_number);
    char* at = first;
    auto left = static_cast<std::uint64_t>(units);
    if (units < 0) {
        *at++ = '-';
        left = 0 - left;
    }
    constexpr auto one = static_cast<std::uint64_t>(power_of_ten<digits>);
    at = put_whole(at, left / one);
    if (const std::uint64_t rest = left % one; rest != 0) {
        *at++ = '.';
        at = put_decimals<digits>(at, rest);
        if (at[-1] == '0') --at;
    }
    size_ += static_cast<std::size_t>(at - first);
}
template void Bytes::put_decimal<0>(std::int64_t);
template void Bytes::put_decimal<4>(std::int64_t);
template void Bytes::put_decimal<6>(std::int64_t);

template <int digits>
void Bytes::put_number(double value) {
    const double scaled = value * static_cast<double>(power_of_ten<digits>);
    KG_ASSERT(std::abs(scaled) < 9e15, "a coordinate of a page is finite and of a size that paper has");
    put_decimal<digits>(static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5)));
}
template void Bytes::put_number<4>(double);
template void Bytes::put_number<6>(double);
template void Bytes::put_number<8>(double);

Markup::Markup() { bytes_.put(R"(<?xml version="1.0" encoding="UTF-8"?>)"); }
Markup::Markup(std::size_t depth) : depth_(depth) {}

void Markup::line_break(std::size_t depth) {
    if (!after_words_) {
        bytes_.put('\n');
        for (std::size_t i = 0; i < depth; ++i) bytes_.put(' ');
    }
    after_words_ = false;
}

void Markup::begin(std::string_view element) {
    close_tag();
    line_break(depth_ + open_.size());
    bytes_.put('<');
    bytes_.put(element);
    open_.push_back(element);
    in_tag_ = true;
}

void Markup::end() {
    KG_ASSERT(!open_.empty(), "an element that ends has begun");
    const std::string_view element = open_.back();
    open_.pop_back();
    if (in_tag_) {
        bytes_.put(" />");
        in_tag_ = false;
        return;
    }
    line_break(depth_ + open_.size());
    bytes_.put("</");
    bytes_.put(element);
    bytes_.put('>');
}

void Markup::attribute(std::string_view name, std::string_view value) {
    open_value(name);
    escaped<true>(value);
    close_value();
}

void Markup::words(std::string_view text) {
    close_tag();
    escaped<false>(text);
    after_words_ = true;
}

template <bool in_attribute>
void Markup::escaped(std::string_view text) {
    std::size_t plain = 0;  // start of the text that needs no escape
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string_view escape;
        switch (text[i]) {
            case '&': escape = "&amp;"; break;
            case '<': escape = "&lt;"; break;
            case '>':
                if (!in_attribute) escape = "&gt;";
                break;
            case '"':
                if (in_attribute) escape = "&quot;";
                break;
            case '\t':
                if (in_attribute) escape = "&#09;";
                break;
            case '\n':
                if (in_attribute) escape = "&#10;";
                break;
            case '\r':
                if (in_attribute) escape = "&#13;";
                break;
            default: break;
        }
        if (escape.empty()) continue;
        bytes_.put(text.substr(plain, i - plain));
        bytes_.put(escape);
        plain = i + 1;
    }
    bytes_.put(text.substr(plain));
}

}  // namespace kinegraph::render
