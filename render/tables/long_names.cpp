// Long names: see long_names.hpp.
#include "render/tables/long_names.hpp"

#include <algorithm>

namespace kinegraph::render {
namespace {

constexpr double least_of_line = 7, least_of_name = 5, finer = 0.5;  // points; subscripts of a symbol are smaller still

}  // namespace

ShapedLine line_in_cell(const RichText& text, double size, const Fonts& fonts, double room) {
    while (size - finer >= least_of_line && fonts.width(text, size) > room) size -= finer;
    return shaped_within(text, size, fonts, room);
}

std::vector<ShapedLine> lines_in_cell(const RichText& text, double size, const Fonts& fonts, double room) {
    std::vector<ShapedLine> lines = fonts.wrap(text, size, room);
    const auto is_wide = [&](const ShapedLine& line) { return line.width > room; };
    while (size - finer >= least_of_name && std::any_of(lines.begin(), lines.end(), is_wide))
        lines = fonts.wrap(text, size -= finer, room);
    for (ShapedLine& line : lines)
        if (is_wide(line)) line = shaped_within(line.text, size, fonts, room);
    return lines;
}

}  // namespace kinegraph::render
