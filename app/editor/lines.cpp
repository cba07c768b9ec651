#include "app/editor/lines.hpp"

#include <algorithm>

namespace kinegraph::app {
namespace {

/// How many units of UTF-16 the character has that begins with this byte of UTF-8.
std::size_t units(char begins) {
    const auto byte = static_cast<unsigned char>(begins);
    return (byte & 0xC0U) == 0x80U ? 0 : byte >= 0xF0U ? 2 : 1;
}

}  // namespace

Lines::Lines(std::string_view text) : text_(text), begins_{0} {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'))) begins_.push_back(i + 1);
}

std::size_t Lines::line_of(std::size_t offset) const {
    return static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), offset) - begins_.begin()) - 1;
}

LinePlace Lines::place(std::size_t offset) const {
    LinePlace place{line_of(std::min(offset, text_.size())), 0};
    for (std::size_t i = begins_[place.line]; i < std::min(offset, text_.size()); ++i) place.utf16 += units(text_[i]);
    return place;
}

std::size_t Lines::offset(LinePlace place) const {
    if (place.line >= begins_.size()) return text_.size();
    const std::size_t begin = begins_[place.line], end = end_of_line(begin);
    std::size_t at = begin, passed = 0;
    while (at < end && passed + units(text_[at]) <= place.utf16) {
        passed += units(text_[at++]);
        while (at < end && units(text_[at]) == 0) ++at;
    }
    return at;
}

std::size_t Lines::end_of_line(std::size_t offset) const {
    const std::size_t line = line_of(std::min(offset, text_.size()));
    std::size_t end = line + 1 < begins_.size() ? begins_[line + 1] : text_.size();
    while (end > begins_[line] && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    return end;
}

}  // namespace kinegraph::app
