// The title block in the corner of the frame.
#include "render/title_block.hpp"

#include <algorithm>
#include <array>

#include "render/caption.hpp"
#include "render/shapes.hpp"
#include "render/tables.hpp"
#include "render/wanted_figures.hpp"

namespace kinegraph::render {

std::string title_of(const Solution& solution, Language language) {
    const std::string& given = in(solution.mechanism.title, language);
    return given.empty() ? word("untitled", language) : given;
}

void draw_title_block(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                      const std::vector<Figure>& figures, std::size_t index, std::size_t count) {
    const Solution& solution = context.solution;
    const Theme& theme = context.theme;
    const Pen edge{theme.outline, theme.text, {}, false}, inner_pen{theme.thin, theme.text, {}, false};
    const double cells_width = format.large ? 25 : 17.5, cells_left = format.block.max.x - 3 * cells_width;
    const double half = format.block.min.y + format.block.height() / 2;
    marks.emplace_back(line({format.block.min.x, format.block.min.y}, {format.block.max.x, format.block.min.y}, edge));
    marks.emplace_back(line({format.block.min.x, format.block.min.y}, {format.block.min.x, format.block.max.y}, edge));
    marks.emplace_back(line({cells_left, format.block.min.y}, {cells_left, format.block.max.y}, inner_pen));
    marks.emplace_back(
        line({cells_left + cells_width, format.block.min.y}, {cells_left + cells_width, format.block.max.y}, inner_pen));
    marks.emplace_back(
        line({cells_left + 2 * cells_width, format.block.min.y}, {cells_left + 2 * cells_width, format.block.max.y}, inner_pen));
    marks.emplace_back(line({cells_left, half}, {format.block.max.x, half}, inner_pen));

    const Units& units = solution.mechanism.units;
    std::string units_text = units.length.symbol + (has_motion(solution) || !has_forces(solution) ? ", s" : "");
    if (has_forces(solution)) units_text += ", " + units.force.symbol;
    std::string scale = "–";
    for (const Figure& figure : figures)
        if (figure.kind == "mechanism") scale = ratio_words(figure.scale, context.language);
    std::string file = solution.mechanism.source;
    if (const std::size_t slash = file.find_last_of('/'); slash != std::string::npos) file = file.substr(slash + 1);
    const std::array<std::pair<std::string, std::string>, 6> cells{
        std::pair{word("block scale", context.language), scale},
        {word("block size", context.language), format.name},
        {word("block sheet", context.language), std::to_string(index) + "/" + std::to_string(count)},
        {word("block units", context.language), units_text},
        {word("block readings", context.language), fixed(0.1, 1, context.language) + " mm"},
        {word("block bodies", context.language), std::to_string(solution.mechanism.bodies.size())}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double x = cells_left + static_cast<double>(i % 3) * cells_width + 1.6;
        const double top = i < 3 ? format.block.min.y : half;
        const double height = format.block.height() / 2;
        set_text(marks, context.fonts.shape(one_piece(cells[i].first), theme.block), {x, top + 0.34 * height}, theme.secondary,
                 "text");
        double size = format.large ? theme.derived : theme.body_text;
        ShapedLine value = context.fonts.shape(one_piece(cells[i].second), size);
        while (value.width > cells_width - 3 && size > 4) value = context.fonts.shape(one_piece(cells[i].second), size -= 0.5);
        set_text(marks, value, {x, top + 0.82 * height}, theme.text, "text");
    }

    const double left = format.block.min.x + 3.5, width = cells_left - left - 2;
    double size = format.large ? theme.title : 13;
    std::vector<ShapedLine> lines = context.fonts.wrap(one_piece(title_of(solution, context.language), Face::bold), size, width);
    const auto too_wide = [&] {
        return lines.size() > 2 || std::any_of(lines.begin(), lines.end(), [&](const ShapedLine& l) { return l.width > width; });
    };
    while (too_wide() && size > 4)
        lines = context.fonts.wrap(one_piece(title_of(solution, context.language), Face::bold), size -= 0.5, width);
    const double lead = millimetres(size) * 1.15;
    double baseline = format.block.min.y + (lines.size() > 1 ? 1.5 : 2.8) + millimetres(size) * 0.72;
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 2); ++i) {
        set_text(marks, lines[i], {left, baseline}, theme.text, "text");
        baseline += lead;
    }
    const bool acceleration = std::any_of(solution.protocol.polygons.begin(), solution.protocol.polygons.end(),
                                          [](const Polygon& p) { return p.plane == Plane::acceleration; });
    const std::string subtitle = word(is_mixed(solution)                   ? "subtitle mixed"
                                      : has_forces(solution)               ? "subtitle forces"
                                      : solution.protocol.polygons.empty() ? "subtitle pose"
                                      : acceleration                       ? "subtitle acceleration"
                                                                           : "subtitle velocity",
                                      context.language);
    const auto small_print = [&](const std::string& words, double at) {
        double print = format.large ? theme.body_text : 7.5;
        ShapedLine shaped = context.fonts.shape(one_piece(words), print);
        while (shaped.width > width && print > 3) shaped = context.fonts.shape(one_piece(words), print -= 0.5);
        set_text(marks, shaped, {left, at}, theme.secondary, "text");
    };
    if (lines.size() == 1) small_print(subtitle, format.block.max.y - (file.empty() ? 3.2 : 5.4));
    if (!file.empty()) small_print(file, format.block.max.y - 2.0);
}

}  // namespace kinegraph::render
