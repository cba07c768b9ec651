#include "render/tables/equation_block.hpp"

#include <algorithm>

#include "render/page/set_formula.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/prose.hpp"

namespace kinegraph::render {
namespace {

constexpr double between = 4, never = 1e4;  // columns of a table; wide enough for any formula

/// A table's lines, its columns as wide as what stands in them, all of it smaller where the measure asks.
std::vector<Block> lines_of(const DrawingContext& context, const std::vector<std::vector<Formula>>& rows, double measure) {
    std::vector<std::vector<Block>> cells;
    std::vector<double> wide;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::vector<Block>& line = cells.emplace_back();
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            line.push_back(formula_block(rows[r][c], context.fonts, context.theme.small, never,
                                         r == 0 ? context.theme.secondary : context.theme.text));
            if (wide.size() <= c) wide.push_back(0);
            wide[c] = std::max(wide[c], line.back().width);
        }
    }
    double whole = -between;
    for (const double each : wide) whole += each + between;
    const double factor = std::min(1.0, measure / whole);
    std::vector<Block> lines;
    for (std::size_t r = 0; r < cells.size(); ++r) {
        Block line;
        double x = 0;
        for (const Block& cell : cells[r]) line.height = std::max(line.height, cell.height);
        for (std::size_t c = 0; c < cells[r].size(); ++c) {
            set(line.marks, cells[r][c], {x, line.height - cells[r][c].height});
            x += wide[c] + between;
        }
        line.width = whole;
        line.height += r == 0 ? 1.4 : 0.9;
        if (r == 0)
            line.marks.emplace_back(render::line({0, line.height - 0.7}, {whole, line.height - 0.7},
                                                 {context.theme.thin, context.theme.text, {}, false}));
        lines.push_back(scaled(std::move(line), factor));
    }
    return lines;
}

}  // namespace

std::vector<Block> equation_blocks(const DrawingContext& context, const std::vector<EquationItem>& items, double measure) {
    constexpr double indent = 3, air = 1.3;
    std::vector<Block> blocks;
    for (const EquationItem& item : items) {
        switch (item.kind) {
            case EquationItem::Kind::heading:
                break;
            case EquationItem::Kind::words:
                blocks.push_back(paragraph_block(context, measure, one_piece(item.words)));
                break;
            case EquationItem::Kind::formula: {
                const Block set_alone =
                    formula_block(item.formula, context.fonts, context.theme.derived, measure - indent, context.theme.text);
                Block block;
                set(block.marks, set_alone, {indent, 0});
                block.width = measure;
                block.height = set_alone.height + air;
                blocks.push_back(std::move(block));
                break;
            }
            case EquationItem::Kind::table:
                for (Block& line : lines_of(context, item.rows, measure)) blocks.push_back(std::move(line));
                break;
        }
    }
    return blocks;
}

}  // namespace kinegraph::render
