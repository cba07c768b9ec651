// Tables: see tables.hpp. Column widths follow the words; horizontal rules of 0.35 / 0.18 / 0.35 mm, no vertical ones.
#include "render/tables/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/result_values.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/checked_numbers.hpp"
#include "render/tables/long_names.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {
namespace {

constexpr double pitch = 4.25;  // of table rows

Path rule(double from, double to, double y, double width, Colour colour) {
    return line({from, y}, {to, y}, {width, colour, {}, false});
}

void set_right(std::vector<Mark>& marks, ShapedLine shaped, double right, double baseline, Colour colour) {
    const double left = right - shaped.width;
    set_text(marks, std::move(shaped), {left, baseline}, colour, "text");
}
void set_centred(std::vector<Mark>& marks, ShapedLine shaped, double middle, double baseline, Colour colour) {
    const double left = middle - shaped.width / 2;
    set_text(marks, std::move(shaped), {left, baseline}, colour, "text");
}

/// Decimals that show five digits of the largest value of a column. Empty if plain decimals would be too long.
std::optional<int> decimals_for(double largest) {
    if (!(largest > 0)) return 1;
    if (largest >= 1e6 || largest < 1e-3) return std::nullopt;
    const int leading = static_cast<int>(std::floor(nearest::log10(largest))) + 1;
    return std::clamp(5 - leading, 0, 7);
}
/// A length read off the drawing to 0.1 mm times its scale, with the decimals that such a reading justifies.
struct Reading {
    double value = 0;
    int decimals = 0;
};
/// Value of one millimetre for a row that is read off. Rounded to seven digits, because positions on paper are rounded:
/// otherwise 34.3 mm × 25 N would give sometimes 857 N, sometimes 858 N.
std::optional<double> scale_of(const ResultRow& row) {
    if (!row.millimetres || !(*row.millimetres > 0) || row.drawing == 0) return std::nullopt;
    const double scale = std::abs(row.drawing) / *row.millimetres;
    const int decimals = 6 - static_cast<int>(std::floor(nearest::log10(scale)));
    const double power = nearest::pow(10.0, std::abs(decimals));
    return decimals < 0 ? std::round(scale / power) * power : std::round(scale * power) / power;
}
std::optional<Reading> reading_of(const ResultRow& row) {
    const std::optional<double> known = scale_of(row);
    if (!known) return std::nullopt;
    // A length has no sign: apply that of compression or clockwise rotation.
    const double sign = row.drawing < 0 ? -1 : 1, scale = *known;
    // Halves round up, as by hand, although 0.23175 as a double is slightly less.
    constexpr double slightly_more = 1 + 1e-12;
    return Reading{sign * std::round(*row.millimetres * 10) * scale / 10 * slightly_more,
                   std::clamp(static_cast<int>(-std::floor(nearest::log10(0.1 * scale) + 1e-9)), 0, 9)};
}
/// A scale without trailing zeros, 0.005 or 1.25 × 10⁻⁴; that of a file may have more digits, 1.1632.
std::string round_number(double value, Language language) {
    std::string text = number(value, 5, language);
    const char point = notation(language).decimal_mark;
    const std::string digits = text.substr(0, text.find(' '));  // without a power of ten
    if (digits.find(point) == std::string::npos) return text;
    std::size_t end = digits.find_last_not_of('0') + 1;
    if (digits[end - 1] == point) --end;
    return digits.substr(0, end) + text.substr(digits.size());
}
/// The common value of one millimetre of all rows that are read off; empty if they differ.
std::optional<double> scale_of(const std::vector<ResultRow>& rows) {
    constexpr double equal = 1e-4;
    std::optional<double> common;
    for (const ResultRow& row : rows) {
        const std::optional<double> scale = scale_of(row);
        if (!scale) continue;
        if (common && std::abs(*scale - *common) > equal * *common) return std::nullopt;
        if (!common) common = scale;
    }
    return common;
}
std::string cell(double value, std::optional<int> decimals, Language language) {
    return decimals ? fixed(value, *decimals, language) : number(value, 5, language);
}

/// An equation under construction: its terms as columns, the operator before each, and its typographic setting.
class EquationTable {
public:
    struct Setting {
        double size, line_size, least_column, gap, operation;
    };

    /// `most`: maximum width of a term beside the row names, mm. Beyond it the line of the term is broken and its
    /// symbol set smaller.
    EquationTable(const DrawingContext& context, const Equation& equation, const Setting& setting,
                  std::optional<double> most = std::nullopt)
        : context_(context), setting_(setting) {
        for (std::size_t side = 0; side < equation.sides.size(); ++side)
            for (std::size_t i = 0; i < equation.sides[side].size(); ++i) {
                const Term& term = equation.sides[side][i];
                Column column;
                column.term = &term;
                column.operation = i > 0 ? "+" : side > 0 ? "=" : "";
                const RichText symbol = typeset(term.symbol, context.language);
                column.symbol = most ? line_in_cell(symbol, setting.size, context.fonts, *most)
                                     : context.fonts.shape(symbol, setting.size);
                if (term.line.kind != LineReason::Kind::known) {
                    const RichText line = typeset(term.line, context.language);
                    column.lines = most ? lines_in_cell(line, setting.line_size, context.fonts, *most)
                                        : std::vector{context.fonts.shape(line, setting.line_size)};
                }
                column.width = std::max(setting.least_column, column.symbol.width + setting.gap);
                for (const ShapedLine& line : column.lines)
                    column.width = std::max(column.width, line.width + setting.gap);
                columns_.push_back(std::move(column));
            }
        std::vector<std::string> names{word(lang::common::magnitude, context.language),
                                       word(lang::sheet::direction, context.language)};
        if (std::any_of(columns_.begin(), columns_.end(), [](const Column& c) { return !c.lines.empty(); }))
            names.push_back(word(lang::sheet::line, context.language));
        for (const std::string& name : names) {
            names_.push_back(context.fonts.shape(one_piece(name), setting.line_size));
            names_width_ = std::max(names_width_, names_.back().width);
        }
    }

    /// The width beside a term for row names and operator.
    double beside_terms() const { return names_width_ + 2.0 + 1.1 * setting_.operation + setting_.gap / 2; }
    /// The width available to each of two terms in a row.
    double half_of(double room) const { return (room - 1.1 * setting_.operation - setting_.gap / 2) / 2; }
    /// Width with all terms in one row.
    double width() const { return width(0, columns_.size()); }
    /// Sets it in rows no wider than `most` mm; a row has at least one term.
    Block set(double most) const {
        Block block;
        for (std::size_t from = 0; from < columns_.size();) {
            const std::size_t to = end_of_row(from, most);
            Block row = set_row(from, to);
            render::move(row.marks, 0, block.height);
            block.marks.insert(block.marks.end(), std::make_move_iterator(row.marks.begin()),
                               std::make_move_iterator(row.marks.end()));
            block.width = std::max(block.width, row.width);
            block.height += row.height + (to < columns_.size() ? between_rows : 0);
            from = to;
        }
        return block;
    }

private:
    struct Column {
        const Term* term = nullptr;
        std::string operation;  // operator before it
        ShapedLine symbol;
        std::vector<ShapedLine> lines;
        double width = 0;
    };

    static constexpr double between_rows = 1.5;

    double before(std::size_t column) const {
        const std::string& operation = columns_[column].operation;
        return operation.empty() ? 0 : setting_.operation * (operation == "=" ? 1.1 : 1.0) - setting_.gap / 2;
    }
    double width(std::size_t from, std::size_t to) const {
        double x = names_width_ + 2.0;
        for (std::size_t c = from; c < to; ++c) x += before(c) + columns_[c].width;
        return x;
    }
    /// As many terms as fit; a break before an equals sign is preferred to one before a plus.
    std::size_t end_of_row(std::size_t from, double most) const {
        std::size_t to = from + 1;
        while (to < columns_.size() && width(from, to + 1) <= most) ++to;
        if (to < columns_.size())
            for (std::size_t c = to; c > from + 1; --c)
                if (columns_[c].operation == "=") return c;
        return to;
    }
    Block set_row(std::size_t from, std::size_t to) const {
        const Theme& theme = context_.theme;
        const ShapedLine tick = context_.fonts.shape(one_piece("✓"), 10),
                         question = context_.fonts.shape(one_piece("?", Face::bold), 10);
        Block block;
        block.marks.reserve((to - from) * (names_.size() + 2) + names_.size() + 2);
        block.width = width(from, to);
        std::vector<double> middles;
        double x = names_width_ + 2.0;
        for (std::size_t c = from; c < to; ++c) {
            x += before(c);
            middles.push_back(x + columns_[c].width / 2);
            x += columns_[c].width;
        }
        double baseline = 4.6;
        double end = names_width_ + 2.0;
        for (std::size_t c = from; c < to; ++c) {
            const Column& column = columns_[c];
            const double middle = middles[c - from];
            const Colour colour = theme.colour_of(column.term->body).letter;
            if (!column.operation.empty()) {
                const ShapedLine sign = context_.fonts.shape(one_piece(column.operation), setting_.size);
                set_centred(block.marks, sign, 0.5 * (end + middle - column.symbol.width / 2), baseline, theme.text);
            }
            set_centred(block.marks, column.symbol, middle, baseline, colour);
            end = middle + column.symbol.width / 2;
        }
        const double top = 6.6;
        double lowest = top;
        block.marks.emplace_back(rule(0, block.width, top, theme.thin, theme.text));
        for (std::size_t row = 0; row < names_.size(); ++row) {
            baseline = top + 3.4 + 4.1 * static_cast<double>(row);
            set_text(block.marks, names_[row], {0, baseline}, theme.secondary, "text");
            for (std::size_t c = from; c < to; ++c) {
                const Column& column = columns_[c];
                if (row < 2) {
                    const bool known = row == 0 ? column.term->magnitude_known : column.term->direction_known;
                    set_centred(block.marks, known ? tick : question, middles[c - from], baseline, theme.text);
                } else {
                    double under = baseline;
                    for (const ShapedLine& line : column.lines) {
                        set_centred(block.marks, line, middles[c - from], under, theme.secondary);
                        lowest = std::max(lowest, under);
                        under += 3.4;
                    }
                }
            }
            lowest = std::max(lowest, baseline);
        }
        block.height = lowest + 1.8;
        block.marks.emplace_back(rule(0, block.width, block.height, theme.thin, theme.text));
        return block;
    }

    const DrawingContext& context_;
    Setting setting_;
    std::vector<Column> columns_;
    std::vector<ShapedLine> names_;
    double names_width_ = 0;
};

}  // namespace

Block equation_block(const DrawingContext& context, const Equation& equation, double most, double least) {
    // The normal setting first; if it is too wide, closer, then smaller; if that is still too wide, in several rows.
    using Setting = EquationTable::Setting;
    constexpr std::array settings{Setting{12, 8.5, 11.2, 2.2, 4.4}, Setting{12, 8, 8.5, 1.6, 3.6},
                                  Setting{11, 7.5, 7, 1.3, 3.2}, Setting{10, 7, 6, 1.2, 3.0}, Setting{9, 6, 5, 1, 2.8}};
    for (const Setting& setting : settings)
        if (const EquationTable table(context, equation, setting); setting.size >= least && table.width() <= most)
            return table.set(most);
    const EquationTable in_rows(context, equation, settings[1]);
    Block block = in_rows.set(most);
    if (block.width <= most) return block;
    // A single term is too wide, for its name is a word. One term per row might be too high for a page; then two stand
    // in a row.
    constexpr double highest = 90;  // mm
    const double room = most - in_rows.beside_terms();
    Block broken = EquationTable(context, equation, settings[1], room).set(most);
    if (broken.height <= highest) return broken;
    return EquationTable(context, equation, settings[1], in_rows.half_of(room)).set(most);
}

namespace {

/// Rows of motion: drawn vectors by polygon, and ω and α by body.
class MotionRows {
public:
    MotionRows(const DrawingContext& context, const std::vector<Figure>& figures)
        : solution_(context.solution),
          units_(context.solution.mechanism.units),
          figures_(figures),
          checks_(context.solution) {}

    std::vector<ResultRow> rows() && {
        add_polygons(Plane::velocity, Polygon::Kind::motion);
        add_bodies(&BodyMotion::omega, result_kind(omega_of(frame)));
        add_polygons(Plane::acceleration, Polygon::Kind::motion);
        add_bodies(&BodyMotion::alpha, result_kind(alpha_of(frame)));
        add_polygons(Plane::velocity, Polygon::Kind::relative_motion);
        add_polygons(Plane::acceleration, Polygon::Kind::relative_motion);
        for (const Curvature& found : solution_.curvature) add_curvature(found);
        return std::move(rows_);
    }

private:
    void add_bodies(Recorded<Exact> BodyMotion::*turning, const ResultKind& kind) {
        const Unit unit = unit_of(kind.unit, units_);
        const double si = unit.si.to_double();
        const std::size_t first = rows_.size();
        for (std::size_t b = 1; b < solution_.bodies.size(); ++b) {
            const auto& value = solution_.bodies[b].*turning;
            if (!value) continue;
            ResultRow row;
            row.quantity = {.kind = kind.kind, .body = BodyIndex(b)};
            row.symbol = {kind.letter, solution_.mechanism.bodies[b].name, ""};
            row.name = name_of(row.symbol);
            row.drawing = value->to_double() / si;
            if (const auto numeric = checks_.of(row.quantity)) row.numeric = *numeric / si;
            row.unit = unit.symbol;
            row.group.section = kind.is_velocity() ? Topic::velocity : Topic::acceleration;
            add(std::move(row), first, [&](const ResultRow& other) {
                return *value == *(solution_.bodies[at_index(other.quantity.body)].*turning);
            });
        }
    }

    /// With the number of a row from `first` on that is like it; else with a new one.
    template <class IsLike>
    void add(ResultRow row, std::size_t first, IsLike is_like) {
        const auto like = std::find_if(rows_.begin() + static_cast<std::ptrdiff_t>(first), rows_.end(), is_like);
        row.arrow = like != rows_.end() ? like->arrow : ++arrows_;
        rows_.push_back(std::move(row));
    }

    /// Radii of curvature of paths that are not known in advance.
    void add_curvature(const Curvature& found) {
        const Unit& unit = units_.length;
        const double si = unit.si.to_double();
        const std::string id = legal_id("curvature-" + solution_.mechanism.body(found.body).name);
        const auto figure =
            std::find_if(figures_.begin(), figures_.end(), [&](const Figure& each) { return each.id == id; });
        const auto add = [&](const Quantity& quantity, Symbol symbol, double metres) {
            ResultRow row;
            row.quantity = quantity;
            row.symbol = std::move(symbol);
            row.name = name_of(row.symbol);
            row.drawing = metres / si;
            if (figure != figures_.end())
                if (const auto seen = measured_on(*figure, row.name)) row.millimetres = seen->millimetres;
            if (const auto numeric = checks_.of(quantity)) row.numeric = *numeric / si;
            row.unit = unit.symbol;
            row.group.section = Topic::curvature;
            rows_.push_back(std::move(row));
        };
        if (found.inflection_pole)
            add({.kind = Quantity::Kind::inflection_diameter, .body = found.body},
                {Symbol::Letter::diameter, solution_.mechanism.body(found.body).name, ""},
                diameter_of(found)->to_double());
        for (const PathCentre& path : found.points)
            if (const auto radius = radius_of(path, solution_.pose); radius && !path.is_pin)
                add({.kind = Quantity::Kind::radius, .body = found.body, .point = path.point},
                    {Symbol::Letter::radius, path.label, ""}, radius->to_double());
    }

    void add_polygons(Plane plane, Polygon::Kind kind) {
        for (std::size_t p = 0; p < solution_.protocol.polygons.size(); ++p) {
            const Polygon& polygon = solution_.protocol.polygons[p];
            if (polygon.plane == plane && polygon.kind == kind) add_polygon(polygon, static_cast<int>(p));
        }
    }
    void add_polygon(const Polygon& polygon, int index) {
        const bool is_acceleration = polygon.plane == Plane::acceleration;
        const Unit& unit = is_acceleration ? units_.acceleration : units_.velocity;
        RowGroup group{is_acceleration ? Topic::acceleration : Topic::velocity};
        if (polygon.kind == Polygon::Kind::relative_motion) group = {Topic::relative_motion, index};
        const auto figure = std::find_if(figures_.begin(), figures_.end(),
                                         [&](const Figure& each) { return each.id == legal_id(polygon.id); });
        std::map<std::string, const DrawnVector*> arrows;  // by name
        const std::size_t first = rows_.size();
        for (const int v : polygon.vectors) {
            const DrawnVector& vector = solution_.protocol.vectors[static_cast<std::size_t>(v)];
            ResultRow row;
            row.quantity = vector.quantity;
            row.symbol = vector.symbol;
            row.name = name_of(vector.symbol);
            if (!arrows.emplace(row.name, &vector).second) continue;
            const Vector value = solution_.protocol.value_of(vector);
            row.drawing = kinegraph::length(value) / unit.si.to_double();
            const auto found = figure == figures_.end() ? std::nullopt : measured_on(*figure, row.name);
            if (found && !value.is_zero()) {
                row.millimetres = found->millimetres;
                row.detail = found->detail;
            } else if (figure != figures_.end() || value.is_zero()) {
                row.millimetres = 0;
            }
            if (const auto numeric = checks_.of_vector(v)) row.numeric = *numeric / unit.si.to_double();
            row.unit = unit.symbol;
            row.group = group;
            add(std::move(row), first, [&](const ResultRow& other) {
                const DrawnVector& like = *arrows.at(other.name);
                return solution_.protocol.value_of(like) == value &&
                       (value.is_zero() ||
                        solution_.protocol.point(like.tail) - solution_.protocol.point(vector.tail) == Vector{});
            });
        }
    }

    const Solution& solution_;
    const Units& units_;
    const std::vector<Figure>& figures_;
    CheckedNumbers checks_;
    std::vector<ResultRow> rows_;
    std::size_t arrows_ = 0;  // numbered so far
};

}  // namespace

std::vector<ResultRow> result_rows(const DrawingContext& context, const std::vector<Figure>& figures) {
    return MotionRows(context, figures).rows();
}

/// The texts of its rows and the widths of its columns.
struct ResultsTable::Parts {
    static constexpr double least_gap = 1.6, name_pitch = 4.4;  // mm
    static constexpr const char* separator = ", ";
    static constexpr std::size_t columns = 6;  // quantity, mm, drawing, numeric, unit, difference
    using Widths = std::array<double, columns>;
    struct Line {
        std::array<RichText, columns> cells;
        bool begins = false;    ///< first of a group, with a rule above it
        std::size_t arrow = 0;  ///< as in its row
        double name = 0;        ///< width of the first cell, mm
    };
    /// Rows that stand in one line of the table, at the place of the first.
    struct Joined {
        std::vector<const Line*> rows;
        double name = 0;  ///< width of their names, mm

        const Line& first() const { return *rows.front(); }
    };

    Parts(const DrawingContext& drawing, const std::vector<ResultRow>& rows) : context(drawing) {
        const auto small = [](const std::string& text) { return with_powers(text); };
        const Language language = context.language;
        head.cells = {RichText{},
                      small("mm"),
                      small(word(lang::sheet::drawing, language)),
                      small(word(lang::sheet::numeric, language)),
                      small(word(lang::sheet::unit, language)),
                      small(word(lang::sheet::difference, language) + " %")};
        measure(head, context.theme.small, context.theme.small);
        // The arithmetic of the readings, "mm × 0.005", if all rows share one scale; what is read in a detail names it.
        std::vector<ResultRow> read_here;
        std::copy_if(rows.begin(), rows.end(), std::back_inserter(read_here),
                     [](const ResultRow& row) { return row.detail.empty(); });
        if (const auto scale = scale_of(read_here)) {
            product = small("mm × " + round_number(*scale, language));
            product_width = context.fonts.width(product, context.theme.small);
        }
        std::map<std::pair<RowGroup, std::string>, double> largest;  // by group and unit
        for (const ResultRow& row : rows) {
            double& most = largest[{row.group, row.unit}];
            most = std::max({most, std::abs(row.drawing), std::abs(row.numeric.value_or(0))});
        }
        lines.reserve(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Line& line = lines.emplace_back(line_of(with_worst_check(rows, i), largest[{rows[i].group, rows[i].unit}]));
            line.begins = i > 0 && rows[i].group != rows[i - 1].group;
            line.arrow = rows[i].arrow;
            measure(line, symbol_size(), context.theme.body_text);
        }
    }

    /// Rows that may share a line show the number of the check that differs most.
    static ResultRow with_worst_check(const std::vector<ResultRow>& rows, std::size_t i) {
        ResultRow row = rows[i];
        for (const ResultRow& other : rows)
            if (row.arrow != 0 && other.arrow == row.arrow && other.numeric &&
                (!row.numeric || std::abs(*other.numeric - row.drawing) > std::abs(*row.numeric - row.drawing)))
                row.numeric = other.numeric;
        return row;
    }

    double symbol_size() const { return context.theme.body_text + 0.5; }
    void measure(Line& line, double first_size, double size) {
        for (std::size_t c = 0; c < columns; ++c) {
            const double width = context.fonts.width(line.cells[c], c == 0 ? first_size : size);
            if (c == 0) line.name = width;
            widths[c] = std::max(widths[c], width);
        }
    }
    /// Width that is left to names beside the numbers, out of `width` mm. Readings have the room that those of any
    /// scale take, so that the table is as high where its page is planned as where it is drawn.
    double rest_of(double width) const {
        const auto sample = [&](const char* text) {
            return context.fonts.width(with_powers(text), context.theme.body_text);
        };
        const Widths readings{0, sample("000.0"), widths[3], 0, 0, sample("+00.00")};
        double rest = width - least_gap * (columns - 1);
        for (std::size_t c = 1; c < columns; ++c) rest -= std::max(widths[c], readings[c]);
        return rest;
    }
    /// The width that names have. Longer names, which are words, stand above their numbers; symbols get a wider column
    /// instead.
    static double room_of_names(double rest) {
        constexpr double of_symbols = 22;
        return std::max(rest, of_symbols);
    }
    /// In order; what is one arrow in as few lines as its names have room for in `rest` mm.
    std::vector<Joined> joined(double rest) const {
        constexpr double of_a_detail = 5;  // mm: a name grows by it where it is read in a detail
        const double comma = context.fonts.width(one_piece(separator), symbol_size());
        std::vector<Joined> all;
        for (const Line& line : lines) {
            const auto with = std::find_if(all.begin(), all.end(), [&](const Joined& each) {
                return line.arrow != 0 && each.first().arrow == line.arrow &&
                       each.name + comma + line.name + of_a_detail <= rest;
            });
            if (with == all.end()) {
                all.push_back({{&line}, line.name});
            } else {
                with->rows.push_back(&line);
                with->name += comma + line.name;
            }
        }
        return all;
    }
    static RichText name_of(const Joined& all) {
        RichText names;
        for (const Line* line : all.rows) {
            if (line != all.rows.front()) names.push_back(one_piece(separator).front());
            names.insert(names.end(), line->cells[0].begin(), line->cells[0].end());
        }
        return names;
    }
    /// `most`: the largest number of its group.
    Line line_of(const ResultRow& row, double most) const;
    /// Sets the marks of a line whose columns begin at `left`.
    void set(std::vector<Mark>& marks, const Joined& of, const Widths& left, double baseline) const;
    /// The same for a line whose name stands above its numbers, within `whole` mm.
    void set_over(std::vector<Mark>& marks, const Line& line, const Widths& left, double whole, double baseline) const;
    void set_numbers(std::vector<Mark>& marks, const Line& line, const Widths& left, double baseline) const;

    const DrawingContext& context;
    Line head;
    RichText product{};        ///< shown in the head; empty if there are several scales
    double product_width = 0;  ///< mm
    std::vector<Line> lines{};
    Widths widths{};
};

ResultsTable::Parts::Line ResultsTable::Parts::line_of(const ResultRow& row, double most) const {
    const Language language = context.language;
    const auto decimals = decimals_for(most);
    const bool is_scalar = result_kind(row.quantity).turns();
    const auto value = [&](double v) {
        std::string text = cell(v, decimals, language);
        // Counter-clockwise rotations get an explicit plus sign.
        return is_scalar && v > 0 && text.find_first_of("123456789") != std::string::npos ? "+" + text : text;
    };
    RichText quantity = typeset(row.symbol, language);
    for (Piece& piece : quantity)
        if (piece.face == Face::bold_italic) piece.face = Face::italic;  // the magnitude of the vector, a scalar
    if (!row.detail.empty()) quantity.push_back(one_piece(" (" + row.detail + ")").front());
    // Lengths are shown as read; quantities without a length in a figure (ω, α, couples) as the construction gives
    // them.
    const std::optional<Reading> reading = reading_of(row);
    const double drawn = reading ? reading->value : row.drawing;
    std::string difference = "–";
    // With an accuracy of 0.1 mm, a shorter length has a relative error of a fifth or more.
    constexpr double readable = 0.5;
    const bool too_short_to_read = reading && row.millimetres && !(*row.millimetres >= readable);
    if (row.numeric && !too_short_to_read) {
        const double gap = drawn - *row.numeric;
        const double percent = std::abs(gap) <= 1e-9 * most ? 0
                               : *row.numeric != 0          ? 100 * gap / std::abs(*row.numeric)
                                                            : 100;
        difference = fixed(percent, 2, language);
        if (percent >= 0.005) difference.insert(0, "+");
    }
    return {{std::move(quantity), with_powers(row.millimetres ? fixed(*row.millimetres, 1, language) : "–"),
             with_powers(reading && decimals ? fixed(drawn, std::min(*decimals, reading->decimals), language)
                                             : value(drawn)),
             with_powers(row.numeric ? value(*row.numeric) : "–"), with_powers(row.unit), with_powers(difference)}};
}

void ResultsTable::Parts::set(std::vector<Mark>& marks, const Joined& of, const Widths& left, double baseline) const {
    const double size = &of.first() == &head ? context.theme.small : symbol_size();
    set_text(marks, context.fonts.shape(name_of(of), size), {left[0], baseline}, context.theme.text, "text");
    set_numbers(marks, of.first(), left, baseline);
}

void ResultsTable::Parts::set_over(std::vector<Mark>& marks, const Line& line, const Widths& left, double whole,
                                   double baseline) const {
    set_text(marks, line_in_cell(line.cells[0], symbol_size(), context.fonts, whole), {left[0], baseline},
             context.theme.text, "text");
    set_numbers(marks, line, left, baseline + name_pitch);
}

void ResultsTable::Parts::set_numbers(std::vector<Mark>& marks, const Line& line, const Widths& left,
                                      double baseline) const {
    const Theme& theme = context.theme;
    const bool is_head = &line == &head;
    const Colour colour = is_head ? theme.secondary : theme.text;
    const auto shape = [&](std::size_t c) {
        return context.fonts.shape(line.cells[c], is_head ? theme.small : theme.body_text);
    };
    set_text(marks, shape(4), {left[4], baseline}, colour, "text");
    for (const std::size_t c : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{5}}) {
        ShapedLine shaped = shape(c);
        const bool is_of_readings = is_head && c == 1 && !product.empty();
        if (is_of_readings)
            if (ShapedLine said = context.fonts.shape(product, theme.small); said.width <= left[1] + widths[1])
                shaped = std::move(said);
        set_right(marks, std::move(shaped), left[c] + widths[c], baseline, colour);
    }
}

ResultsTable::ResultsTable(const DrawingContext& context, const std::vector<ResultRow>& rows)
    : parts_(std::make_shared<const Parts>(context, rows)) {}

std::vector<SharedBlock> ResultsTable::lines(double width) const {
    constexpr double head_height = 4.8, over_group = 0.4, under_last = 0.8;
    Parts::Widths widths = parts_->widths;
    const double rest = parts_->rest_of(width), most_of_name = Parts::room_of_names(rest);
    const auto is_over = [most_of_name](const Parts::Joined& each) { return each.name > most_of_name; };
    const std::vector<Parts::Joined> joined = parts_->joined(rest);
    widths[0] = parts_->head.name;
    for (const Parts::Joined& each : joined)
        if (!is_over(each)) widths[0] = std::max(widths[0], each.name);
    const auto total = [&] { return std::accumulate(widths.begin(), widths.end(), 0.0); };
    const auto gap_in = [&] { return std::clamp((width - total()) / 5, Parts::least_gap, 9.0); };
    // The factor of the readings stands in the head above names and lengths: they leave it room where there is some.
    constexpr double widened = 1.25;  // a fifth of it is taken from the gap between them
    const double lacks = parts_->product_width - widths[0] - gap_in() - widths[1];
    if (lacks > 0 && total() + widened * lacks + (Parts::columns - 1) * Parts::least_gap <= width)
        widths[0] += widened * lacks;
    const double gap = gap_in();
    Parts::Widths left{};
    for (std::size_t c = 1; c < Parts::columns; ++c) left[c] = left[c - 1] + widths[c - 1] + gap;
    const double whole = left.back() + widths.back();

    const auto line = [parts = parts_, left, whole, is_over](const Parts::Joined& of, double height, bool is_last) {
        const Theme& theme = parts->context.theme;
        const Parts::Line& each = of.first();
        std::vector<Mark> marks;
        marks.reserve(Parts::columns + 3);  // including rules
        const bool is_head = &each == &parts->head;
        if (is_head) marks.emplace_back(rule(0, whole, 0, theme.outline, theme.text));
        if (each.begins) marks.emplace_back(rule(0, whole, over_group, theme.thin, theme.secondary));
        const double baseline = is_head ? 3.4 : (each.begins ? over_group : 0) + 3.3;
        if (is_over(of))
            parts->set_over(marks, each, left, whole, baseline);
        else
            parts->set(marks, of, left, baseline);
        if (is_head) marks.emplace_back(rule(0, whole, head_height, theme.thin, theme.text));
        if (is_last) marks.emplace_back(rule(0, whole, height + 0.6, theme.outline, theme.text));
        return marks;
    };
    const auto add = [&](std::vector<SharedBlock>& set, const Parts::Joined& each, double height, bool is_last) {
        set.emplace_back(whole, height + (is_last ? under_last : 0), [=] { return line(each, height, is_last); });
    };
    std::vector<SharedBlock> set;
    add(set, {{&parts_->head}}, head_height, joined.empty());
    for (const Parts::Joined& each : joined)
        add(set, each, pitch + (each.first().begins ? over_group : 0) + (is_over(each) ? Parts::name_pitch : 0),
            &each == &joined.back());
    return set;
}

namespace {

Symbol symbol_of(const InstantCentre& centre, const Mechanism& mechanism) {
    return centre_symbol(mechanism, centre.first, centre.second, centre.at && centre.at->at_infinity());
}

/// The joint between two bodies, if any.
const Joint* joint_of(const InstantCentre& centre, const Mechanism& mechanism) {
    const auto holds = [](const Joint& joint, BodyIndex body) {
        return std::find(joint.bodies.begin(), joint.bodies.end(), body) != joint.bodies.end();
    };
    for (const Joint& joint : mechanism.joints)
        if (holds(joint, centre.first) && holds(joint, centre.second)) return &joint;
    return nullptr;
}

const std::string& point_name(const Mechanism& mechanism, PointIndex point) {
    return mechanism.points[at_index(point)].name;
}

/// A centre in the name of a line: its hinge if it has one, else its symbol.
RichText in_a_line(const InstantCentre& centre, const Mechanism& mechanism, Language language) {
    const Joint* joint = centre.how == InstantCentre::How::primary ? joint_of(centre, mechanism) : nullptr;
    if (joint && centre.at && !centre.at->at_infinity())
        return typeset(Symbol{Symbol::Letter::point, point_name(mechanism, joint->point), ""}, language);
    return typeset(symbol_of(centre, mechanism), language);
}

RichText how_found(const InstantCentre& centre, const Solution& solution, Language language) {
    const Mechanism& mechanism = solution.mechanism;
    const auto point = [&](PointIndex p) {
        return typeset(Symbol{Symbol::Letter::point, point_name(mechanism, p), ""}, language);
    };
    RichText text;
    if (centre.how == InstantCentre::How::unknown && !centre.at && !centre.everywhere)
        return one_piece(word(lang::sheet::not_found, language));
    if (centre.how == InstantCentre::How::primary) {
        if (const Joint* joint = joint_of(centre, mechanism)) {
            append(text, word(joint->pair().texts.found, language) + " ");
            append(text, point(joint->point));
            return text;
        }
    }
    if (centre.how == InstantCentre::How::rest) return one_piece(word(lang::sheet::found_by_rest, language));
    const auto join = [&] {
        if (!text.empty()) append(text, " " + word(lang::sheet::and_word, language) + " ");
    };
    for (const auto& [first, second] : centre.through) {
        join();
        RichText line = in_a_line(solution.centres[static_cast<std::size_t>(first)], mechanism, language);
        append_point(line, in_a_line(solution.centres[static_cast<std::size_t>(second)], mechanism, language));
        append(text, line);
    }
    const bool by_accelerations = centre.how == InstantCentre::How::accelerations,
               by_motion = by_accelerations || centre.how == InstantCentre::How::velocities;
    const bool is_normal_to_motion = by_motion && (by_accelerations || centre.first != frame);
    for (const PointIndex p : is_normal_to_motion ? std::vector<PointIndex>{} : centre.normals) {
        join();
        append(text, word(lang::sheet::normal_at, language) + " ");
        append(text, point(p));
    }
    if (text.empty() && by_motion)
        append(text, word(by_accelerations ? lang::sheet::from_accelerations : lang::sheet::from_velocities, language));
    return text;
}

RichText where_found(const InstantCentre& centre, const Solution& solution, Language language) {
    if (centre.as_one) return one_piece(word(lang::sheet::everywhere, language));
    if (centre.at && !centre.at->at_infinity()) {
        const Unit& unit = solution.mechanism.units.length;
        const Vector place = centre.at->place();
        const double w = centre.at->w.to_double() * unit.si.to_double();
        const double x = place.x.to_double() / w, y = place.y.to_double() / w;
        const double size = (solution.pose.size / unit.si).to_double();
        const auto decimals = decimals_for(std::max({std::abs(x), std::abs(y), size}));
        const auto coordinate = [&](double v) {
            return decimals ? fixed(v, std::min(*decimals, 4), language) : number(v, 5, language);
        };
        return one_piece(pair_of(coordinate(x), coordinate(y), language));
    }
    if (centre.at) {
        double angle = nearest::atan2(centre.at->y.to_double(), centre.at->x.to_double()) * 180 / nearest::acos(-1.0);
        if (angle < 0) angle += 180;
        if (angle >= 180) angle -= 180;
        return one_piece("∞, " + fixed(angle, 2, language) + "°");
    }
    if (centre.everywhere) return one_piece(word(lang::sheet::everywhere, language));
    return {};
}

/// The hinges of a body that has exactly two, and no other joint.
std::vector<const Joint*> two_hinges_of(BodyIndex body, const Mechanism& mechanism) {
    std::vector<const Joint*> found;
    for (const Joint& joint : mechanism.joints) {
        if (std::find(joint.bodies.begin(), joint.bodies.end(), body) == joint.bodies.end()) continue;
        if (!joint.pair().is_hinge() || joint.bodies.size() != 2) return {};
        found.push_back(&joint);
    }
    if (found.size() != 2) found.clear();
    return found;
}
BodyIndex other_of(const Joint& joint, BodyIndex body) { return joint.bodies[joint.bodies[0] == body ? 1 : 0]; }

/// Whether it is hinged on the frame and on a wheel that rolls or meshes with another, so that only the wheel drives
/// it, through full turns.
bool carries_wheel(BodyIndex body, const Solution& solution) {
    const std::vector<Joint>& joints = solution.mechanism.joints;
    const auto rolls = [&](BodyIndex wheel) {
        return std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
            return (joint.pair().rolls() || joint.pair().meshes()) && joint.connects(wheel);
        });
    };
    bool on_frame = false, on_wheel = false, on_other = false;
    for (const Joint& joint : joints) {
        if (!joint.connects(body)) continue;
        for (const BodyIndex other : joint.bodies) {
            if (other == body) continue;
            if (other == frame) on_frame = true;
            if (joint.connects(frame)) continue;
            (solution.mechanism.body(other).circle && rolls(other) ? on_wheel : on_other) = true;
        }
    }
    return on_frame && on_wheel && !on_other;
}

/// Whether the follower of a four-bar linkage, hinged on the frame, makes full turns as its crank does (Grashof):
/// shortest plus longest length does not exceed the sum of the others, and the frame or the follower is the shortest.
bool goes_round(BodyIndex follower, const Solution& solution) {
    const Mechanism& mechanism = solution.mechanism;
    std::vector<const Joint*> hinges;  // round the linkage, beginning with the follower's hinge on the frame
    BodyIndex body = follower;
    for (int side = 0; side < 3; ++side) {
        auto own = two_hinges_of(body, mechanism);
        if (own.empty()) return false;
        const bool at_frame = other_of(*own[0], body) == frame;
        if (side == 0) hinges.push_back(own[at_frame ? 0 : 1]);
        const Joint* const next = own[0] == hinges.back() ? own[1] : own[0];
        if ((other_of(*next, body) == frame) != (side == 2)) return false;
        hinges.push_back(next);
        body = other_of(*next, body);
    }
    if (std::find(hinges[0]->bodies.begin(), hinges[0]->bodies.end(), frame) == hinges[0]->bodies.end()) return false;
    std::array<double, 4> lengths{};  // follower, coupler, crank, frame
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector side = solution.pose.at(hinges[(i + 1) % 4]->point) - solution.pose.at(hinges[i]->point);
        lengths.at(i) = length(Spot{side.x.to_double(), side.y.to_double()});
    }
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    constexpr double rounding = 1e-12;
    const double sum = lengths[0] + lengths[1] + lengths[2] + lengths[3], longest = *most * (1 - rounding);
    return *least + longest <= sum / 2 && std::min(lengths[0], lengths[3]) <= *least * (1 + rounding);
}

/// A driven slide or an actuator between two moving bodies is a cylinder with its rod.
bool is_cylinder(JointIndex slide, const Mechanism& mechanism) {
    if (mechanism.joint(slide).connects(frame)) return false;
    const auto drives = [&](const Driver& driver) {
        const auto* of = std::get_if<SlideDriver>(&driver);
        return of != nullptr && of->joint == slide;
    };
    const auto pushes = [&](const Effort& effort) {
        const auto* of = std::get_if<ActuatorEffort>(&effort);
        return of != nullptr && of->joint == slide;
    };
    return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), drives) ||
           std::any_of(mechanism.efforts.begin(), mechanism.efforts.end(), pushes);
}

/// Points of a body that polygons distinguish from a coincident point of another body: "A* at A".
std::vector<RichText> coincident_points(BodyIndex body, const Solution& solution, Language language) {
    std::vector<RichText> all;
    std::set<std::string> told;
    const auto point = [&](const std::string& of) { return typeset(Symbol{Symbol::Letter::point, of, ""}, language); };
    const auto is_of_the_file = [&](const std::string& name) {
        return solution.mechanism.point_named(name).has_value();
    };
    for (const Image& image : solution.protocol.images) {
        const std::string& name = image.symbol.about;
        std::string place = name;  // names in a file may end with stars
        while (!is_of_the_file(place) && place.ends_with('*')) place.pop_back();
        if (image.body == body && place != name && is_of_the_file(place) && told.insert(name).second)
            all.push_back(word(lang::sheet::coincident_point, {point(name), point(place)}, language));
    }
    return all;
}

/// Properties of a body that follow from its joints.
struct RolesOfBody {
    std::vector<PointIndex> hinges;
    bool on_frame = false, slides_on_frame = false, slides = false, carries_guide = false, driven = false;
    bool is_rod = false, is_barrel = false;
    bool meshes = false, presses = false;  ///< teeth; a profile that slides on another body's
};

RolesOfBody roles_of(BodyIndex index, const Mechanism& mechanism) {
    RolesOfBody roles;
    for (const Joint& joint : mechanism.joints) {
        const auto found = std::find(joint.bodies.begin(), joint.bodies.end(), index);
        if (found == joint.bodies.end()) continue;
        const bool with_frame = std::find(joint.bodies.begin(), joint.bodies.end(), frame) != joint.bodies.end();
        if (joint.pair().is_hinge()) {
            roles.hinges.push_back(joint.point);
            roles.on_frame = roles.on_frame || with_frame;
        }
        if (joint.pair().is_sleeve()) {
            roles.slides_on_frame = roles.slides_on_frame || with_frame;
            (found == joint.bodies.begin() ? roles.slides : roles.carries_guide) = true;
            if (is_cylinder(mechanism.index_of(joint), mechanism))
                (found == joint.bodies.begin() ? roles.is_rod : roles.is_barrel) = true;
        }
        if (joint.pair().is_slot() && found != joint.bodies.begin()) roles.carries_guide = true;
        roles.meshes = roles.meshes || joint.pair().meshes();
        roles.presses = roles.presses || (joint.pair().touches() && joint.pair().slides());
    }
    for (const Driver& driver : mechanism.drivers)
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) roles.driven = roles.driven || spin->body == index;
    return roles;
}

/// Whether a driven body on the frame presses on it, and it is on the frame, too.
bool is_follower(BodyIndex index, const RolesOfBody& roles, const Mechanism& mechanism) {
    if (!roles.presses || roles.driven || !(roles.on_frame || roles.slides_on_frame)) return false;
    return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
        if (!joint.pair().touches() || !joint.pair().slides() || !joint.connects(index)) return false;
        const RolesOfBody other = roles_of(other_of(joint, index), mechanism);
        return other.driven && other.on_frame;
    });
}
/// Whether it is driven and presses on a follower.
bool is_cam(BodyIndex index, const RolesOfBody& roles, const Mechanism& mechanism) {
    return roles.driven && roles.on_frame && roles.presses &&
           std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
               if (!joint.pair().touches() || !joint.pair().slides() || !joint.connects(index)) return false;
               const BodyIndex other = other_of(joint, index);
               return other != frame && is_follower(other, roles_of(other, mechanism), mechanism);
           });
}
/// Whether all its points are on one line that is nearer to the horizontal than to the vertical.
bool lies_straight(BodyIndex index, const Solution& solution) {
    const std::vector<PointIndex>& points = solution.mechanism.body(index).points;
    if (points.size() < 2) return false;
    const Vector& first = solution.pose.at(points.front());
    const Vector along = solution.pose.at(points.back()) - first;
    return abs(along.y) < abs(along.x) && std::all_of(points.begin(), points.end(), [&](PointIndex point) {
               return cross(along, solution.pose.at(point) - first).is_zero();
           });
}

/// What a body is by its profile or in a structure that cannot move; none: neither.
std::optional<Key> kind_by_profile(BodyIndex index, const RolesOfBody& roles, const Solution& solution) {
    const Mechanism& mechanism = solution.mechanism;
    const auto& circle = mechanism.body(index).circle;
    if (roles.meshes) return roles.slides_on_frame ? lang::sheet::rack : lang::sheet::gear;
    if (is_follower(index, roles, mechanism)) return lang::sheet::follower;
    if (is_cam(index, roles, mechanism)) return lang::sheet::cam;
    if (!circle) return std::nullopt;
    const bool is_pinned = std::find(roles.hinges.begin(), roles.hinges.end(), circle->centre) != roles.hinges.end();
    return is_pinned ? lang::sheet::wheel : lang::sheet::disc;
}

/// The key of the textbook term for a body with these roles. In a structure that cannot move nothing swings or cranks.
Key kind_of_body(BodyIndex index, const RolesOfBody& roles, const Solution& solution) {
    if (const auto kind = kind_by_profile(index, roles, solution)) return *kind;
    if (solution.mobility.effective == 0 && !roles.is_barrel && !roles.is_rod)
        return lies_straight(index, solution) ? lang::sheet::beam : lang::sheet::body;
    return roles.slides_on_frame                         ? lang::sheet::slider
           : roles.is_barrel                             ? lang::sheet::cylinder
           : roles.is_rod                                ? lang::sheet::rod
           : roles.carries_guide                         ? lang::sheet::slotted_link
           : roles.slides                                ? lang::sheet::sleeve
           : roles.on_frame && roles.driven              ? lang::sheet::crank
           : goes_round(index, solution)                 ? lang::sheet::crank
           : carries_wheel(index, solution)              ? lang::sheet::arm
           : roles.on_frame && roles.hinges.size() >= 2  ? lang::sheet::rocker
           : !roles.on_frame && roles.hinges.size() >= 2 ? lang::sheet::coupler
                                                         : lang::sheet::body;
}

/// "80 mm", which no line break parts. A given length is shown as given, a derived one to four digits.
std::string length_between(PointIndex a, PointIndex b, const Solution& solution, Language language) {
    const Unit& unit = solution.mechanism.units.length;
    const Vector between = solution.pose.at(b) - solution.pose.at(a);
    const double l = length(Spot{(between.x / unit.si).to_double(), (between.y / unit.si).to_double()});
    const double nice = std::round(l * 1e6) / 1e6;
    const std::string exact = shortest(nice, language);
    return (exact.size() <= 6 ? exact : number(l, 4, language)) + "\u00a0" + unit.symbol;
}

/// The curved slots in a body: the centre and radius that its normal accelerations v²/ρ need.
std::vector<RichText> circular_slots(BodyIndex body, const Solution& solution, Language language) {
    std::vector<RichText> all;
    const Mechanism& mechanism = solution.mechanism;
    for (const Joint& joint : mechanism.joints) {
        if (joint.arc == none || joint.bodies.size() != 2 || joint.bodies[1] != body) continue;
        const Symbol centre{Symbol::Letter::point, mechanism.point(joint.arc).name, ""};
        all.push_back(
            word(lang::sheet::circular_slot,
                 {typeset(centre, language), one_piece(length_between(joint.arc, joint.point, solution, language))},
                 language));
    }
    return all;
}

/// "crank O₂A, 80 mm".
RichText describe(BodyIndex index, const Solution& solution, Language language) {
    const Mechanism& mechanism = solution.mechanism;
    const Body& body = mechanism.bodies[at_index(index)];
    const RolesOfBody roles = roles_of(index, mechanism);
    RichText text;
    if (!body.label.empty()) {
        append(text, in(body.label, language));
        append(text, " ");
    } else {
        append(text, word(kind_of_body(index, roles, solution), language) + " ");
    }
    constexpr std::size_t most_points = 6;
    std::vector<PointIndex> points = roles.hinges;
    for (const PointIndex p : body.points)
        if (std::find(points.begin(), points.end(), p) == points.end() && points.size() < most_points)
            points.push_back(p);
    RichText joined;
    for (const PointIndex p : points)
        append_point(joined, typeset(Symbol{Symbol::Letter::point, point_name(mechanism, p), ""}, language));
    append(text, joined);
    if (points.size() == 2 && !roles.slides && !roles.slides_on_frame)
        append(text, ", " + length_between(points[0], points[1], solution, language));
    for (const auto& also : {circular_slots, coincident_points})
        for (const RichText& each : also(index, solution, language)) {
            append(text, ", ");
            append(text, each);
        }
    return text;
}

}  // namespace

struct CentresTable::Parts {
    struct Line {
        RichText name;
        ShapedLine symbol;
        RichText how;
        double how_wide;  // width on one line, mm
        ShapedLine where;
        StatementIndex statement;
    };
    explicit Parts(const DrawingContext& drawing) : context(drawing) {
        const Theme& theme = context.theme;
        const Solution& solution = context.solution;
        std::vector<const InstantCentre*> centres;
        for (const InstantCentre& centre : solution.centres) centres.push_back(&centre);
        std::stable_sort(centres.begin(), centres.end(),
                         [](const InstantCentre* a, const InstantCentre* b) { return a->order < b->order; });
        for (const InstantCentre* centre : centres) {
            RichText name = typeset(symbol_of(*centre, solution.mechanism), context.language);
            ShapedLine symbol = context.fonts.shape(name, theme.derived);
            symbols = std::max(symbols, symbol.width + 2.5);
            RichText how = how_found(*centre, solution, context.language);
            if (centre->depends_on_drivers)
                append(how, " (" + word(lang::sheet::depends_on_drivers, context.language) + ")");
            const double wide = context.fonts.width(how, theme.body_text);
            lines.push_back({std::move(name), std::move(symbol), std::move(how), wide,
                             context.fonts.shape(where_found(*centre, solution, context.language), theme.body_text),
                             centre->statement});
        }
    }
    double indent(double width) const { return std::min(symbols, 0.3 * width); }
    double first_baseline(const Line& line, double width) const {
        return line.symbol.width > indent(width) - 1.5 ? 7.3 : 3.2;
    }
    static double height(double last_baseline) { return std::max(pitch, last_baseline + lead - 3.2 + 0.5); }

    Block set(const Line& line, double width) const {
        const Theme& theme = context.theme;
        Block block;
        const double room = width - indent(width);
        std::vector<ShapedLine> wrapped = lines_in_cell(line.how, theme.body_text, context.fonts, room);
        double baseline = first_baseline(line, width);
        set_text(block.marks,
                 line.symbol.width > width ? line_in_cell(line.name, theme.derived, context.fonts, width) : line.symbol,
                 {0, 3.2}, theme.text, "text");
        for (std::size_t k = 0; k < wrapped.size(); ++k) {
            // The coordinates end the last line, or stand on a line of their own.
            const bool goes_on = k + 1 < wrapped.size() || wrapped[k].width + between + line.where.width > room;
            set_text(block.marks, std::move(wrapped[k]), {indent(width), baseline}, theme.text, "text");
            if (goes_on) baseline += lead;
        }
        set_right(block.marks, line.where, width, baseline, theme.text);
        belong(block.marks, 0, line.statement);
        block.width = width;
        block.height = height(baseline);
        return block;
    }

    static constexpr double lead = 3.85, between = 3;  // mm
    const DrawingContext& context;
    double symbols = 8;
    std::vector<Line> lines;
};

CentresTable::CentresTable(const DrawingContext& context) : parts_(std::make_shared<const Parts>(context)) {}

std::vector<SharedBlock> CentresTable::lines(double width) const {
    std::vector<SharedBlock> lines;
    const double room = width - parts_->indent(width);
    constexpr double rounding = 1e-6;
    for (const Parts::Line& line : parts_->lines)
        // A short entry takes one line, and is set only when its place is final.
        if (line.how_wide + Parts::between + line.where.width < room - rounding)
            lines.emplace_back(width, Parts::height(parts_->first_baseline(line, width)),
                               [parts = parts_, &line, width] { return parts->set(line, width).marks; });
        else
            lines.emplace_back(parts_->set(line, width));
    return lines;
}

struct BodiesTable::Parts {
    struct Line {
        BodyIndex body;
        ShapedLine name;
        RichText what;
        double what_wide;  // width on one line, mm
        double left() const { return 11 + std::max(4.5, name.width + 2); }
    };
    explicit Parts(const DrawingContext& drawing) : context(drawing) {
        const Mechanism& mechanism = context.solution.mechanism;
        const double size = context.theme.body_text;
        for (const BodyIndex body : mechanism.moving_bodies()) {
            RichText what = describe(body, context.solution, context.language);
            const double wide = context.fonts.width(what, size);
            lines.push_back(
                {body, context.fonts.shape(one_piece(mechanism.body(body).name), size), std::move(what), wide});
        }
    }
    static double height(std::size_t count) { return std::max(4.4, static_cast<double>(count) * lead + 0.7); }

    Block set(const Line& each, double width) const {
        const Theme& theme = context.theme;
        Block block;
        const BodyColour colour = theme.body(each.body);
        block.marks.emplace_back(line({1, 2.1}, {8, 2.1}, {theme.link, colour.line, {}, true}));
        draw_line_kind(block.marks, 0, theme.link, colour, theme);
        // A name that would leave no room for the words takes several lines.
        constexpr double most_of_width = 0.5, of_name = 0.35;
        const bool is_long = each.left() > most_of_width * width && each.left() + each.what_wide > width;
        const double room = of_name * width, left = is_long ? 11 + room + 2 : each.left();
        const auto put = [&](std::vector<ShapedLine> shaped, double x, Colour letters) {
            double baseline = 3.2;
            for (ShapedLine& words : shaped) {
                set_text(block.marks, std::move(words), {x, baseline}, letters, "text");
                baseline += lead;
            }
            block.height = std::max(block.height, height(shaped.size()));
        };
        const std::string& name = context.solution.mechanism.body(each.body).name;
        put(is_long ? lines_in_cell(one_piece(name), theme.body_text, context.fonts, room)
                    : std::vector<ShapedLine>{each.name},
            11, colour.letter);
        put(context.fonts.wrap(each.what, theme.body_text, width - left), left, theme.text);
        block.width = width;
        return block;
    }

    static constexpr double lead = 3.85;  // mm
    const DrawingContext& context;
    std::vector<Line> lines;
};

BodiesTable::BodiesTable(const DrawingContext& context) : parts_(std::make_shared<const Parts>(context)) {}

std::vector<SharedBlock> BodiesTable::lines(double width) const {
    std::vector<SharedBlock> lines;
    constexpr double rounding = 1e-6;
    for (const Parts::Line& line : parts_->lines)
        if (line.left() + line.what_wide < width - rounding)
            lines.emplace_back(width, Parts::height(1),
                               [parts = parts_, &line, width] { return parts->set(line, width).marks; });
        else
            lines.emplace_back(parts_->set(line, width));
    return lines;
}

}  // namespace kinegraph::render
