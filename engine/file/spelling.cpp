#include "engine/file/spelling.hpp"

#include <charconv>

#include "engine/number/assert.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/files.hpp"

namespace kinegraph {
Words described(JsonValue value) {
    switch (value.kind()) {
        case JsonValue::Kind::null: return std::string_view("null");
        case JsonValue::Kind::boolean: return value.text();
        case JsonValue::Kind::number: return {lang::files::the_number, shown(value.text(), 40)};
        case JsonValue::Kind::string: return quoted(value.text());
        case JsonValue::Kind::array:
            if (value.size() == 0) return {lang::files::an_empty_array};
            return {lang::files::an_array, std::to_string(value.size())};
        case JsonValue::Kind::object: return {lang::common::an_object};
    }
    KG_ASSERT(false, "every kind of value has a description");
}

bool is_whole_number(JsonValue value) {
    // Names of bodies are short; longer numbers are rounded by other JSON readers.
    constexpr std::size_t longest = 18;
    if (!value.is_number() || value.text().size() > longest) return false;
    const std::string_view digits = value.text().substr(value.text().starts_with('-') ? 1 : 0);
    return std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_true(JsonValue value) { return value.kind() == JsonValue::Kind::boolean && value.text() == "true"; }

Words listed(std::span<const std::string_view> words) {
    Words list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? Words(lang::files::and_word) : Words(std::string(", "));
        list += '"' + std::string(words[i]) + '"';
    }
    return list;
}

bool has_control_character(std::string_view text, bool also_blank) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool blank = c == '\t' || c == '\n' || c == '\r';
        if ((c < 0x20 && (also_blank || !blank)) || c == 0x7F) return true;
        if (c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0) return true;
    }
    return false;
}

Words did_you_mean(const std::optional<std::string>& name) {
    return name ? Words(lang::common::did_you_mean, quoted(*name)) : Words();
}

std::optional<std::uint32_t> colour_of_text(std::string_view text) {
    constexpr std::size_t length = 7;
    std::uint32_t number = 0;
    if (text.size() != length || text[0] != '#') return std::nullopt;
    const char* const end = text.data() + text.size();
    if (std::from_chars(text.data() + 1, end, number, 16).ptr != end) return std::nullopt;
    return number;
}

}  // namespace kinegraph
