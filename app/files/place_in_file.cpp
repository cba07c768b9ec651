// One pass through the text, which skips what the pointer does not name.
#include "app/files/place_in_file.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace kinegraph::app {
namespace {

/// Decodes a segment of a JSON pointer.
std::string unescaped(std::string_view segment) {
    std::string key;
    for (std::size_t i = 0; i < segment.size(); ++i) {
        const bool is_escape =
            segment[i] == '~' && i + 1 < segment.size() && (segment[i + 1] == '0' || segment[i + 1] == '1');
        key += !is_escape ? segment[i] : segment[i + 1] == '0' ? '~' : '/';
        if (is_escape) ++i;
    }
    return key;
}

class Walk {
public:
    explicit Walk(std::string_view json) : text_(json) { skip_space(); }

    /// Descends from the current value to its member or element. False if there is none; then the position is
    /// undefined.
    bool enter(const std::string& segment) {
        if (at_end()) return false;
        const char bracket = text_[at_];
        if (bracket == '{') return enter_member(segment);
        std::size_t index = 0;
        const auto [end, fault] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
        if (bracket != '[' || fault != std::errc() || end != segment.data() + segment.size()) return false;
        return enter_element(index);
    }
    /// The beginning of the member or element entered last.
    PlaceInFile place() const {
        const std::string_view before = text_.substr(0, begins_);
        const std::size_t newline = before.rfind('\n');
        const std::string_view in_line = newline == std::string_view::npos ? before : before.substr(newline + 1);
        const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
        return {1 + std::count(before.begin(), before.end(), '\n'),
                1 + std::count_if(in_line.begin(), in_line.end(), begins_character)};
    }

private:
    bool at_end() const { return at_ >= text_.size(); }
    bool is(char c) const { return !at_end() && text_[at_] == c; }
    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
    void skip_string() {
        for (++at_; !at_end() && text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        ++at_;
    }
    void skip_value() {
        int depth = 0;
        do {
            if (is('"')) {
                skip_string();
            } else {
                if (is('{') || is('[')) ++depth;
                if (is('}') || is(']')) --depth;
                ++at_;
            }
        } while (!at_end() && (depth > 0 || (text_[at_] != ',' && text_[at_] != '}' && text_[at_] != ']')));
    }
    /// Moves past a comma; false if there is none.
    bool next() {
        skip_space();
        if (!is(',')) return false;
        ++at_;
        skip_space();
        return true;
    }

    bool enter_member(const std::string& key) {
        ++at_;
        skip_space();
        if (!is('"')) return false;
        do {
            const std::size_t begins = at_;
            skip_string();
            const std::string_view name = text_.substr(begins + 1, std::max(at_, begins + 2) - begins - 2);
            skip_space();
            if (!is(':')) return false;
            ++at_;
            skip_space();
            if (name == key) {
                begins_ = begins;
                return true;
            }
            skip_value();
        } while (next() && is('"'));
        return false;
    }
    bool enter_element(std::size_t index) {
        ++at_;
        skip_space();
        if (is(']')) return false;
        for (; index > 0; --index) {
            skip_value();
            if (!next()) return false;
        }
        begins_ = at_;
        return !at_end();
    }

    std::string_view text_;
    std::size_t at_ = 0, begins_ = 0;
};

}  // namespace

std::optional<PlaceInFile> place_in_file(std::string_view json, std::string_view pointer) {
    std::optional<PlaceInFile> place;
    Walk walk(json);
    while (!pointer.empty() && pointer.front() == '/') {
        pointer.remove_prefix(1);
        const std::size_t end = std::min(pointer.find('/'), pointer.size());
        if (!walk.enter(unescaped(pointer.substr(0, end)))) return place;
        place = walk.place();
        pointer.remove_prefix(end);
    }
    return place;
}

}  // namespace kinegraph::app
