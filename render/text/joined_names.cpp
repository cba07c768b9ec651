// Names that are joined to one, such as those of the points on a line.
#include "render/text/rich_text.hpp"

#include <algorithm>
#include <string>

namespace kinegraph::render {
namespace {

/// More than one letter with its distinguishing mark (a number, a star).
bool is_word(const Piece& name) {
    constexpr std::ptrdiff_t most_letters = 2;
    const std::string number_and_primes = "0123456789*'′";
    const std::size_t last = name.text.find_last_not_of(number_and_primes);
    const std::string letters = name.text.substr(0, last == std::string::npos ? 0 : last + 1);
    const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return std::count_if(letters.begin(), letters.end(), begins_character) > most_letters;
}

}  // namespace

void append_point(RichText& line, const RichText& point) {
    if (!line.empty() && !point.empty() && (is_word(line.back()) || is_word(point.front()))) append(line, " – ");
    append(line, point);
}

}  // namespace kinegraph::render
