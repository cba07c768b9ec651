#include "app/files/place_in_file.hpp"

#include <algorithm>

#include "app/files/outline.hpp"

namespace kinegraph::app {

std::optional<PlaceInFile> place_in_file(std::string_view json, std::string_view pointer) {
    const Outline outline(json);
    const std::uint32_t node = outline.at(pointer);
    if (node == Outline::none || node == outline.root()) return std::nullopt;
    const std::string_view before =
        json.substr(0, outline[node].has_key() ? outline[node].key_begin : outline[node].begin);
    const std::size_t newline = before.rfind('\n');
    const std::string_view in_line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return PlaceInFile{1 + std::count(before.begin(), before.end(), '\n'),
                       1 + std::count_if(in_line.begin(), in_line.end(), begins_character)};
}

}  // namespace kinegraph::app
