#include "render/equations/equation_block.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "render/equations/prose.hpp"
#include "render/page/set_formula.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

constexpr double widest_between = 4, least_between = 1.6;  // columns of a table, mm

using Table = std::vector<std::vector<Formula>>;

/// The lines of a table, with columns as wide as their content.
std::vector<Block> lines_of(const DrawingContext& context, const Table& rows, double between = widest_between) {
    constexpr double under_head = 1.4, under_line = 0.4, under_table = 1.3;
    std::vector<std::vector<SetLine>> cells;
    std::vector<double> wide;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::vector<SetLine>& line = cells.emplace_back();
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            line.push_back(formula_line(rows[r][c], context.fonts, context.theme.small,
                                        r == 0 ? context.theme.secondary : context.theme.text));
            if (wide.size() <= c) wide.push_back(0);
            wide[c] = std::max(wide[c], line.back().block.width);
        }
    }
    double whole = -between;
    for (const double each : wide) whole += each + between;
    // Lines of letters have equal heights, with or without dots and subscripts; taller lines take the height they need.
    const double even_up = 0.9 * millimetres(context.theme.small), even_down = 0.25 * millimetres(context.theme.small);
    std::vector<Block> lines;
    for (std::size_t r = 0; r < cells.size(); ++r) {
        Block line;
        double x = 0, up = even_up, down = even_down;
        for (const SetLine& cell : cells[r]) {
            up = std::max(up, cell.baseline);
            down = std::max(down, cell.block.height - cell.baseline);
        }
        for (std::size_t c = 0; c < cells[r].size(); ++c) {
            set(line.marks, std::move(cells[r][c].block), {x, up - cells[r][c].baseline});
            x += wide[c] + between;
        }
        line.width = whole;
        line.height = up + down + (r == 0 ? under_head : r + 1 == cells.size() ? under_table : under_line);
        if (r == 0) {
            const double y = line.height - under_head / 2;
            line.marks.emplace_back(
                render::line({0, y}, {whole, y}, {context.theme.thin, context.theme.text, {}, false}));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

constexpr double any_width = 1e9;  // mm

Block formula_within(const DrawingContext& context, const Formula& formula, double measure) {
    return formula_block(formula, context.fonts, context.theme.derived, measure, context.theme.text);
}
/// Blocks of natural width, set once.
const std::vector<Block>& natural_of(const DrawingContext& context, const EquationItem& item, NaturalBlocks& natural) {
    const auto [found, fresh] = natural.try_emplace(&item);
    if (fresh && item.kind == EquationItem::Kind::formula)
        found->second.push_back(formula_within(context, item.formula, any_width));
    else if (fresh)
        found->second = lines_of(context, item.rows);
    return found->second;
}

/// With columns that move closer together to fit the measure.
std::vector<Block> closer_lines_of(const DrawingContext& context, const Table& rows, double measure) {
    std::vector<Block> wide = lines_of(context, rows);
    const double excess = wide.front().width - measure;
    if (excess <= 0) return wide;
    const auto gaps = static_cast<double>(std::max<std::size_t>(rows.front().size(), 2) - 1);
    return lines_of(context, rows, std::max(least_between, widest_between - excess / gaps));
}

/// The first column and those from `from` to before `to`.
Table columns_of(const Table& rows, std::size_t from, std::size_t to) {
    Table part;
    for (const std::vector<Formula>& row : rows) {
        std::vector<Formula>& cells = part.emplace_back();
        for (std::size_t c = 0; c < row.size(); ++c)
            if (c == 0 || (c >= from && c < to)) cells.push_back(row[c]);
    }
    return part;
}

/// To fit the measure, first the columns move closer, then everything is set smaller, as long as it can be read. A
/// table that is still too wide is set in parts, one below the other, each with the first column. `add`: a block, and
/// whether it stays with the block after it.
void add_table(const DrawingContext& context, const EquationItem& item, double measure, NaturalBlocks& natural,
               const std::function<void(Block, bool)>& add) {
    const auto add_lines = [&](std::vector<Block> lines) {
        constexpr std::size_t short_table = 6;  // lines, which stay together
        const std::size_t together = lines.size() <= short_table ? lines.size() : 2;
        for (std::size_t i = 0; i < lines.size(); ++i) add(std::move(lines[i]), i + 1 < together);
    };
    const std::vector<Block>& wide = natural_of(context, item, natural);
    if (wide.front().width <= measure) {
        add_lines(wide);
        return;
    }
    const double least_type = context.theme.block;  // pt; no other text of a sheet is smaller
    const auto set_within = [&](std::vector<Block> lines) {
        for (Block& line : lines) {
            const double share = std::min(1.0, measure / line.width);
            line = scaled(std::move(line), share);
        }
        add_lines(std::move(lines));
    };
    std::vector<Block> closer = closer_lines_of(context, item.rows, measure);
    const std::size_t columns = item.rows.front().size();
    if (columns <= 2 || closer.front().width * least_type <= measure * context.theme.small) {
        set_within(std::move(closer));
        return;
    }
    for (std::size_t from = 1, to = columns; from < columns; from = to, to = columns) {
        closer = closer_lines_of(context, columns_of(item.rows, from, to), measure);
        for (; closer.front().width > measure && to > from + 1;)
            closer = closer_lines_of(context, columns_of(item.rows, from, --to), measure);
        set_within(std::move(closer));
    }
}

}  // namespace

std::vector<Block> equation_blocks(const DrawingContext& context, std::span<const EquationItem> items, double measure,
                                   NaturalBlocks& natural) {
    constexpr double indent = 3, air = 1.3;
    std::vector<Block> blocks;
    bool announced = false;  // a sentence stays with the formula after it, the head of a table with its rows
    const auto add = [&](Block block, bool stays = false) {
        if (!std::exchange(announced, stays)) {
            blocks.push_back(std::move(block));
            return;
        }
        Block& before = blocks.back();
        const double width = block.width, height = block.height;
        set(before.marks, std::move(block), {0, before.height});
        before.width = std::max(before.width, width);
        before.height += height;
    };
    for (const EquationItem& item : items) {
        switch (item.kind) {
            case EquationItem::Kind::heading: break;
            case EquationItem::Kind::words:
                add(paragraph_block(context, measure, formula(item.words)));
                announced = item.announces;
                break;
            case EquationItem::Kind::formula: {
                const Block& wide = natural_of(context, item, natural).front();
                const bool fits = wide.width <= measure - indent;
                Block alone = fits ? wide : formula_within(context, item.formula, measure - indent);
                Block block{{}, measure, alone.height + air};
                set(block.marks, std::move(alone), {indent, 0});
                add(std::move(block));
                break;
            }
            case EquationItem::Kind::table: add_table(context, item, measure, natural, add); break;
        }
    }
    return blocks;
}

}  // namespace kinegraph::render
