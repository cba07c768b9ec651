// The blank between a number and its unit: no line ends there. In a text that is not yet divided into lines it is a
// character of its own; what is set or written has an ordinary blank, so that a search for "45 mm" finds it.
#pragma once

#include <algorithm>
#include <string>

#include "render/text/language.hpp"

namespace kinegraph::render {

constexpr char bound_blank = '\x1F';  // ASCII's unit separator

/// The text with bound blanks: "(0, 28.5) mm", "kg m²".
inline std::string bound(std::string text) {
    std::replace(text.begin(), text.end(), ' ', bound_blank);
    return text;
}
inline Words bound(const Words& words) {
    return in_all([&](Language language) { return bound(words.in(language)); });
}
/// The text with ordinary blanks.
inline std::string unbound(std::string text) {
    std::replace(text.begin(), text.end(), bound_blank, ' ');
    return text;
}
/// "45 mm", with bound blanks behind the number.
inline std::string with_unit(const std::string& number, const std::string& unit) { return number + bound(' ' + unit); }

}  // namespace kinegraph::render
