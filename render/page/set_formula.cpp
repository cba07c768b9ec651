#include "render/page/set_formula.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double script = 0.7, raise = 0.42, fraction_axis = 0.25;  // em
constexpr double bar_gap = 0.14, bar_pen = 0.045;                   // of fractions and roots, em
constexpr double thin = 0.17;                                       // between factors, em
constexpr double column_gap = 0.9, row_gap = 0.32, bracket = 0.22, inside = 0.22;

/// Marks relative to a baseline at (0, 0), y downwards.
struct Typeset {
    double width = 0, ascent = 0, descent = 0;
    std::vector<Mark> marks{};
};

class Setter {
public:
    Setter(const Fonts& fonts, Colour colour) : fonts_(fonts), colour_(colour) {}

    Typeset set(const Formula& formula, double size) const {
        const double em = millimetres(size);
        switch (formula.kind) {
            case Formula::Kind::row: return row(formula.parts, size);
            case Formula::Kind::text:
            case Formula::Kind::sign: return words(formula.text, size);
            case Formula::Kind::fraction: return fraction(set(formula.parts[0], size), set(formula.parts[1], size), em);
            case Formula::Kind::root: return root(set(formula.parts[0], size), em);
            case Formula::Kind::power:
                return power(set(formula.parts[0], size), set(formula.parts[1], script * size), em);
            case Formula::Kind::fence: return fence(set(formula.parts[0], size), size);
            case Formula::Kind::matrix: return matrix(formula, size);
        }
        return {};
    }

    /// The boxes of a row's parts, side by side.
    Typeset row(std::span<const Formula> parts, double size) const {
        std::vector<Typeset> boxes;
        for (const Formula& part : parts) boxes.push_back(set(part, size));
        return joined(parts, boxes, size);
    }
    static Typeset joined(std::span<const Formula> parts, std::span<Typeset> boxes, double size) {
        Typeset all;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const double x = all.width + air_before(parts, i, size);
            add(all, std::move(boxes[i]), x, 0);
        }
        return all;
    }
    /// A thin space between factors, two between a matrix and its column.
    static double air_before(std::span<const Formula> parts, std::size_t i, double size) {
        const auto is = [&](std::size_t part, Formula::Kind kind) { return parts[part].kind == kind; };
        if (i == 0 || is(i, Formula::Kind::sign) || is(i - 1, Formula::Kind::sign) || parts[i].stands_close()) return 0;
        const bool matrices = is(i, Formula::Kind::matrix) && is(i - 1, Formula::Kind::matrix);
        return (matrices ? 2 : 1) * thin * millimetres(size);
    }

private:
    static void add(Typeset& to, Typeset part, double x, double y) {
        move(part.marks, x, y);
        to.marks.insert(to.marks.end(), std::make_move_iterator(part.marks.begin()),
                        std::make_move_iterator(part.marks.end()));
        to.width = std::max(to.width, x + part.width);
        to.ascent = std::max(to.ascent, part.ascent - y);
        to.descent = std::max(to.descent, part.descent + y);
    }
    Typeset words(const RichText& text, double size) const {
        const ShapedLine shaped = fonts_.shape(text, size);
        Typeset box{shaped.width, std::max(shaped.ascent, 0.45 * millimetres(size)), std::max(shaped.descent, 0.0), {}};
        set_text(box.marks, shaped, {0, 0}, colour_, "text");
        return box;
    }
    Pen pen(double em) const { return {bar_pen * em, colour_, {}, false}; }

    Typeset fraction(Typeset above, Typeset below, double em) const {
        const double width = std::max(above.width, below.width) + 0.2 * em, bar = fraction_axis * em;
        Typeset box;
        const double up = bar + bar_gap * em + above.descent, down = bar_gap * em + below.ascent - bar;
        const double x_above = (width - above.width) / 2, x_below = (width - below.width) / 2;
        add(box, std::move(above), x_above, -up);
        add(box, std::move(below), x_below, down);
        box.marks.emplace_back(line({0, -bar}, {width, -bar}, pen(em)));
        box.width = width;
        return box;
    }
    Typeset root(Typeset of, double em) const {
        const double left = 0.55 * em, top = of.ascent + bar_gap * em, low = of.descent + 0.05 * em;
        Typeset box;
        const double width = of.width;
        add(box, std::move(of), left, 0);
        box.marks.emplace_back(polyline({{0.05 * em, -0.35 * em},
                                         {0.16 * em, -0.42 * em},
                                         {0.32 * em, low},
                                         {left - 0.06 * em, -top},
                                         {left + width + 0.06 * em, -top}},
                                        pen(em)));
        box.width = left + width + 0.1 * em;
        box.ascent = top + 0.06 * em;
        box.descent = std::max(box.descent, low);
        return box;
    }
    static Typeset power(Typeset base, Typeset exponent, double em) {
        const double up = std::max(raise * em, base.ascent - 0.6 * exponent.ascent);
        const double x = base.width + 0.03 * em;
        Typeset box = std::move(base);
        add(box, std::move(exponent), x, -up);
        return box;
    }
    Typeset fence(Typeset within, double size) const {
        const double em = millimetres(size), tall = within.ascent + within.descent;
        // Round brackets grow a little with their content.
        const double grown = size * std::clamp(tall / (0.95 * em), 1.0, 1.8);
        Typeset open = words(one_piece("("), grown), close = words(one_piece(")"), grown);
        const double drop =
            grown > size ? (within.descent - within.ascent) / 2 + fraction_axis * millimetres(grown) : 0;
        Typeset box;
        const double x = open.width;
        add(box, std::move(open), 0, drop);
        const double right = x + within.width;
        add(box, std::move(within), x, 0);
        add(box, std::move(close), right, drop);
        return box;
    }
    Typeset matrix(const Formula& formula, double size) const {
        const double em = millimetres(size);
        const std::size_t columns = formula.columns, rows = (formula.parts.size() + columns - 1) / columns;
        std::vector<Typeset> cells;
        std::vector<double> wide(columns, 0), up(rows, 0.55 * em), down(rows, 0.12 * em);
        for (std::size_t i = 0; i < formula.parts.size(); ++i) {
            cells.push_back(set(formula.parts[i], size));
            wide[i % columns] = std::max(wide[i % columns], cells[i].width);
            up[i / columns] = std::max(up[i / columns], cells[i].ascent);
            down[i / columns] = std::max(down[i / columns], cells[i].descent);
        }
        double height = row_gap * em * static_cast<double>(rows - 1);
        for (std::size_t r = 0; r < rows; ++r) height += up[r] + down[r];
        Typeset box;
        double y = -fraction_axis * em - height / 2;
        const double top = y, left = inside * em + 0.08 * em;
        double right = left;
        for (std::size_t r = 0; r < rows; ++r) {
            double x = left;
            y += up[r];
            for (std::size_t c = 0; c < columns; ++c) {
                Typeset& cell = cells[r * columns + c];
                const double at = x + (wide[c] - cell.width) / 2;
                add(box, std::move(cell), at, y);
                x += wide[c] + (c + 1 < columns ? column_gap * em : 0);
            }
            right = x;
            y += down[r] + row_gap * em;
        }
        const double bottom = top + height, over = 0.1 * em, end = right + inside * em;
        for (const bool is_right : {false, true}) {
            const double x = is_right ? end : 0.08 * em, arm = is_right ? -bracket * em : bracket * em;
            box.marks.emplace_back(polyline(
                {{x + arm, top - over}, {x, top - over}, {x, bottom + over}, {x + arm, bottom + over}}, pen(1.3 * em)));
        }
        box.width = end + 0.12 * em;
        box.ascent = std::max(box.ascent, over - top + 0.05 * em);
        box.descent = std::max(box.descent, bottom + over + 0.05 * em);
        return box;
    }

    const Fonts& fonts_;
    Colour colour_;
};

/// The parts of a row, in lines that begin at a sign or at the start.
std::vector<Typeset> lines_of(const Formula& formula, const Setter& setter, double size, double measure) {
    if (formula.kind != Formula::Kind::row) return {setter.set(formula, size)};
    const std::span<const Formula> parts = formula.parts;
    std::vector<Typeset> boxes, lines;
    for (const Formula& part : parts) boxes.push_back(setter.set(part, size));
    for (std::size_t first = 0; first < parts.size();) {
        const double indent = lines.empty() ? 0 : millimetres(size);
        // As far as the measure allows, then back to the last sign before.
        std::size_t end = first, last_sign = first;
        for (double x = indent; end < parts.size(); ++end) {
            if (end > first + 1 && parts[end].kind == Formula::Kind::sign) last_sign = end;
            x += Setter::air_before(parts.subspan(first), end - first, size) + boxes[end].width;
            if (x > measure && last_sign > first) break;
        }
        if (end < parts.size()) end = last_sign;
        Typeset line =
            Setter::joined(parts.subspan(first, end - first), std::span(boxes).subspan(first, end - first), size);
        if (indent > 0) {
            move(line.marks, indent, 0);
            line.width += indent;
        }
        lines.push_back(std::move(line));
        first = end;
    }
    return lines;
}

}  // namespace

Block formula_block(const Formula& formula, const Fonts& fonts, double size, double measure, Colour colour) {
    const Setter setter(fonts, colour);
    constexpr double least = 0.6, leading = 0.5, between = 1.2, slightly_less = 0.995;
    constexpr int most_trials = 4;
    std::vector<Typeset> lines;
    double own = size;
    for (int trial = 0; trial < most_trials; ++trial) {
        lines = lines_of(formula, setter, own, measure);
        double widest = 0;
        for (const Typeset& line : lines) widest = std::max(widest, line.width);
        if (widest <= measure || own <= least * size) break;
        own = std::max(least * size, own * slightly_less * measure / widest);
    }
    Block block;
    for (Typeset& box : lines) {
        const double baseline = block.height + box.ascent;
        set(block.marks, {std::move(box.marks), box.width, 0}, {0, baseline});
        block.width = std::max(block.width, box.width);
        const bool goes_on = &box != &lines.back();
        block.height = baseline + box.descent + (goes_on ? between : leading);
    }
    if (const double factor = measure / block.width; factor < 1) block = scaled(std::move(block), factor);
    return block;
}

SetLine formula_line(const Formula& formula, const Fonts& fonts, double size, Colour colour) {
    Typeset typeset = Setter(fonts, colour).set(formula, size);
    SetLine line{{{}, typeset.width, typeset.ascent + typeset.descent}, typeset.ascent};
    set(line.block.marks, {std::move(typeset.marks), typeset.width, 0}, {0, typeset.ascent});
    return line;
}

}  // namespace kinegraph::render
