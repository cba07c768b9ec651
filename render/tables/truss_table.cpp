#include "render/tables/truss_table.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/functions.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/checked_numbers.hpp"
#include "render/tables/long_names.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {
namespace {

/// Left edges of the columns bar, spaces, force, sense as fractions of the width; the force is right-aligned in its
/// column.
struct Columns {
    double spaces, force_end, sense;
};
RichText head_of_force(const DrawingContext& context) {
    RichText force = one_piece(word(lang::sheet::axial_force, context.language));
    append(force, one_piece(" " + context.solution.mechanism.units.force.symbol));
    return force;
}
/// Keeps the heads apart in a narrow column.
Columns columns_of(const DrawingContext& context, double width) {
    constexpr double widest = 96, apart = 1.6;
    const double used = std::min(width, widest);
    const auto wide = [&](const RichText& text) { return context.fonts.shape(text, context.theme.small).width; };
    const double spaces = 0.18 * used;
    const double before = has_plan(context.solution)
                              ? spaces + wide(one_piece(word(lang::sheet::spaces, context.language))) + apart
                              : spaces;
    const double force_end = std::max(0.55 * used, before + wide(head_of_force(context)));
    return {spaces, force_end, std::max(0.62 * used, force_end + apart)};
}

void put(Block& block, const DrawingContext& context, const RichText& text, double x, bool ends_there, double size,
         Colour colour, double baseline) {
    const ShapedLine shaped = context.fonts.shape(text, size);
    set_text(block.marks, shaped, {ends_there ? x - shaped.width : x, baseline}, colour, "text");
}

Block head_of(const DrawingContext& context, double width) {
    const Columns columns = columns_of(context, width);
    const Theme& theme = context.theme;
    Block head;
    head.marks.emplace_back(line({0, 0}, {width, 0}, {theme.outline, theme.text, {}, false}));
    const auto words = [&](Key key) { return one_piece(word(key, context.language)); };
    put(head, context, words(lang::sheet::bar), 0, false, theme.small, theme.secondary, 3.4);
    if (has_plan(context.solution))
        put(head, context, words(lang::sheet::spaces), columns.spaces, false, theme.small, theme.secondary, 3.4);
    put(head, context, head_of_force(context), columns.force_end, true, theme.small, theme.secondary, 3.4);
    put(head, context, words(lang::sheet::sense), columns.sense, false, theme.small, theme.secondary, 3.4);
    head.marks.emplace_back(line({0, 4.8}, {width, 4.8}, {theme.thin, theme.text, {}, false}));
    head.width = width;
    head.height = 5;
    return head;
}

Key sense_word(const Truss& truss, std::size_t bar, double value) {
    if (truss.bars[bar].force->is_zero())
        return truss.bars[bar].idle_by_rule ? lang::sheet::idle_by_rule : lang::sheet::idle;
    return value > 0 ? lang::sheet::tension : lang::sheet::compression;
}

/// On the plan; without one, on the polygon of the whole truss.
Measured measured_or(const std::vector<Figure>& figures, const std::string& name, bool& found) {
    const auto has_bars = [](const Figure& figure) { return figure.traits.has_bars; };
    const bool on_plan = std::any_of(figures.begin(), figures.end(), has_bars);
    for (const Figure& figure : figures)
        if (on_plan ? has_bars(figure) : figure.traits.measured == QuantityKind::force)
            if (const auto length = measured_on(figure, name)) {
                found = true;
                return *length;
            }
    return {};
}

}  // namespace

bool has_plan(const Solution& solution) { return solution.truss && solution.truss->polygon >= 0; }

std::vector<Block> bar_lines(const DrawingContext& context, double width) {
    const Truss& truss = *context.solution.truss;
    const Theme& theme = context.theme;
    const Columns columns = columns_of(context, width);
    const double si = context.solution.mechanism.units.force.si.to_double();
    // A name too long to stand before the numbers stands above them.
    constexpr double first_baseline = 3.6, row_pitch = 3.9, apart = 0.5, room_of_force = 16;
    std::vector<Block> lines{head_of(context, width)};
    for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
        Block row;
        const double value = truss.tension(bar, context.solution.pose.points) / si;
        RichText name;
        for (const int pin : truss.structure.bars[bar].pins)
            append_point(name, typeset(Symbol{Symbol::Letter::point,
                                              truss.structure.name_of(context.solution.mechanism, pin), ""},
                                       context.language));
        const double room = has_plan(context.solution) ? columns.spaces - apart : columns.force_end - room_of_force;
        const bool is_over = context.fonts.width(name, theme.body_text) > room;
        const double baseline = is_over ? first_baseline + row_pitch : first_baseline;
        set_text(row.marks, line_in_cell(name, theme.body_text, context.fonts, is_over ? width : room),
                 {0, first_baseline}, theme.text, "text");
        if (has_plan(context.solution)) {
            const std::string spaces = truss.spaces[at_index(truss.bars[bar].left)].letter + "–" +
                                       truss.spaces[at_index(truss.bars[bar].right)].letter;
            put(row, context, one_piece(spaces), columns.spaces, false, theme.body_text, theme.text, baseline);
        }
        const bool idle = truss.bars[bar].force->is_zero();
        put(row, context, one_piece(idle ? "0" : number(value, 4, context.language)), columns.force_end, true,
            theme.body_text, theme.text, baseline);
        put(row, context, one_piece(word(sense_word(truss, bar, value), context.language)), columns.sense, false,
            theme.body_text, theme.text, baseline);
        belong(row.marks, 0, truss.bars[bar].statement);
        row.width = width;
        row.height = baseline + 0.8;
        lines.push_back(std::move(row));
    }
    // Where bars and bodies are cut free, the table of their reactions has the note.
    if (has_resultants(context.solution) && context.solution.free_bodies.empty())
        lines.push_back(note_block(context, one_piece(word(lang::sheet::double_heads, context.language)), width));
    return lines;
}

std::vector<ResultRow> truss_rows(const DrawingContext& context, const std::vector<Figure>& figures) {
    const Solution& solution = context.solution;
    const Truss& truss = *solution.truss;
    const Unit& unit = solution.mechanism.units.force;
    const double si = unit.si.to_double();
    const CheckedNumbers checks(solution);
    std::vector<ResultRow> rows;
    const auto add = [&](const Quantity& quantity, const Symbol& symbol, double value, std::optional<double> numeric) {
        ResultRow row;
        row.quantity = quantity;
        row.symbol = symbol;
        row.name = name_of(symbol);
        row.drawing = value;
        row.numeric = numeric;
        row.unit = unit.symbol;
        row.group.section = Topic::forces;
        bool found = false;
        const Measured measured = measured_or(figures, row.name, found);
        if (found) row.millimetres = measured.millimetres;
        rows.push_back(std::move(row));
    };
    // What is given first: the polygon begins with it.
    for (const Truss::External& external : truss.externals) {
        if (external.joint != none) continue;
        const double value = kinegraph::length(*external.force) / si;
        add({.kind = Quantity::Kind::load, .given = external.given}, external.symbol, value, value);
    }
    for (const Truss::External& external : truss.externals) {
        if (external.joint == none) continue;
        // The check lists it as the action on the frame.
        const Joint& joint = solution.mechanism.joint(external.joint);
        const BodyIndex from =
            joint.has_own_node() && joint.pair().is_hinge() ? BodyIndex(none) : joint.other_than(frame);
        const Quantity reversed{.kind = Quantity::Kind::force, .body = frame, .other = from, .joint = external.joint};
        const auto x = checks.of(reversed.along(Quantity::Component::x)),
                   y = checks.of(reversed.along(Quantity::Component::y));
        add({.kind = Quantity::Kind::force, .body = from, .other = frame, .joint = external.joint}, external.symbol,
            kinegraph::length(*external.force) / si,
            x && y ? std::optional(nearest::hypot(*x, *y) / si) : std::nullopt);
    }
    for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
        const Quantity quantity{.kind = Quantity::Kind::bar, .body = truss.structure.bars[bar].body};
        std::optional<double> numeric = checks.of(quantity);
        if (numeric) *numeric /= si;
        add(quantity, {Symbol::Letter::F, truss.structure.bars[bar].name, {}},
            truss.tension(bar, solution.pose.points) / si, numeric);
    }
    return rows;
}

}  // namespace kinegraph::render
