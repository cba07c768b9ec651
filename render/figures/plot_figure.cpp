#include "render/figures/plot_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/number/functions.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/expression_symbol.hpp"
#include "render/figures/xy_plot.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/extremes.hpp"

namespace kinegraph::render {
namespace {

/// Distance of ticks: 1, 2 or 5 × 10ⁿ; for degrees a fraction of a turn.
double tick_step(double range, int most, bool degrees) {
    if (degrees)
        for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0})
            if (range / step <= most) return step;
    const double rough = range / most;
    const int exponent = static_cast<int>(std::floor(nearest::log10(rough)));
    for (const double mantissa : {1.0, 2.0, 5.0})
        if (decimal(mantissa, exponent) >= rough * (1 - 1e-9)) return decimal(mantissa, exponent);
    return decimal(1, exponent + 1);
}

struct Range {
    double least = 1e300, most = -1e300;
    void take(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    double width() const { return most - least; }
};

class PlotFigure {
public:
    PlotFigure(const DrawingContext& context, const CycleTable& table, const std::vector<std::size_t>& columns,
               int number, Spot room, const PlotNotes& notes)
        : context_(context),
          theme_(context.theme),
          table_(table),
          columns_(columns),
          notes_(notes),
          id_("plot-" + std::to_string(number)),
          room_(room),
          over_(table.over()),
          x_unit_(table.parameter ? table.parameter->unit
                                  : unit_of(table.columns[over_].unit, context.solution.mechanism)),
          y_unit_(unit_of(table.columns[columns.front()], context.solution.mechanism)) {
        for (const double end : {table.travel.at(0), table.travel.at(1)}) x_.take(in_x(end));
        for (const std::size_t column : columns) take_values(column);
        const bool is_flat = y_.most < y_.least || std::all_of(columns.begin(), columns.end(), [&](std::size_t column) {
                                 return is_constant(table, column);
                             });
        if (is_flat) {
            // A constant is drawn in the middle; rounding errors are shown as zero.
            double middle = y_.most < y_.least ? 0 : (y_.most + y_.least) / 2;
            if (std::abs(middle) <= in_y(rounding_of(table, columns.front()))) middle = 0;
            const double half = middle == 0 ? 1 : std::abs(middle) / 2;
            y_ = {middle - half, middle + half};
        }
        y_step_ = tick_step(y_.width(), std::max(2, static_cast<int>(room.y / 9)), y_unit_.symbol == "°");
        const double lowest = y_.least;
        y_ = {std::floor(y_.least / y_step_ - 1e-9) * y_step_, std::ceil(y_.most / y_step_ + 1e-9) * y_step_};
        // The label of the least value stands below its mark and needs space above the numbers of the axis.
        constexpr double letters = 4;
        if (!is_flat && lowest < 0 && lowest - y_.least < letters / std::max(room.y - 15, 12.0) * y_.width())
            y_.least -= y_step_;
        x_step_ = tick_step(x_.width(), std::max(3, static_cast<int>(room.x / 11)), x_unit_.symbol == "°");
    }

    Figure draw() {
        figure_.data_figure = "plot";
        figure_.id = id_;
        figure_.unit = y_unit_.symbol;
        figure_.has_scale = false;
        figure_.caption = notes_.caption;
        for (std::size_t i = 0; i < columns_.size() && notes_.caption.empty(); ++i) {
            if (i > 0) append(figure_.caption, one_piece(", "));
            append(figure_.caption, name(i));
        }
        place_frame();
        figure_.marks.emplace_back(group_of(figure_, false));
        draw_separations();
        draw_grid();
        draw_upright_lines();
        for (std::size_t i = 0; i < columns_.size(); ++i) draw_curve(i);
        if (columns_.size() > 1) draw_legend();
        figure_.marks.emplace_back(GroupEnd{});
        figure_.box = box_of(figure_.marks);
        return std::move(figure_);
    }

private:
    /// The values of a column that the plot shows: all of them or, where it has poles, all but the twentieth nearest to
    /// each infinity.
    void take_values(std::size_t column) {
        std::vector<double> values;
        for (const auto& row : table_.rows)
            if (!is_pole(column, row[over_])) values.push_back(in_y(row[column]));
        if (values.empty()) return;
        std::sort(values.begin(), values.end());
        const bool has_poles =
            column < table_.followed.columns.size() && !table_.followed.columns[column].poles.empty();
        const std::size_t left_out = has_poles ? values.size() / 20 : 0;
        const bool down = has_poles && is_unbounded(table_, column, true);
        const bool up = has_poles && is_unbounded(table_, column, false);
        y_.take(values[down ? left_out : 0]);
        y_.take(values[values.size() - 1 - (up ? left_out : 0)]);
        has_poles_ = has_poles_ || has_poles;
    }
    bool is_pole(std::size_t column, double at) const {
        return column < table_.followed.columns.size() &&
               table_.followed.columns[column].is_pole(at, table_.travel.at(1) - table_.travel.at(0));
    }
    double in_x(double si) const { return si / x_unit_.si.to_double(); }
    double in_y(double si) const { return si / y_unit_.si.to_double(); }
    RichText name(std::size_t curve) const {
        return typeset(table_.columns[columns_[curve]], context_.solution.mechanism, context_.language);
    }
    Colour colour(std::size_t curve) const { return theme_.body(BodyIndex(curve + 1)).line; }
    Colour letters(std::size_t curve) const { return theme_.body(BodyIndex(curve + 1)).letter; }
    Spot at(double x, double y) const {
        return {frame_.min.x + (x - x_.least) / x_.width() * frame_.width(),
                frame_.max.y - (y - y_.least) / y_.width() * frame_.height()};
    }
    std::string tick(double value, double step) const {
        const int decimals = std::clamp(-static_cast<int>(std::floor(nearest::log10(step) + 1e-9)), 0, 6);
        return std::abs(value) >= 1e5 || step < 1e-5 ? number(value, 3, context_.language)
                                                     : fixed(value == 0 ? 0 : value, decimals, context_.language);
    }

    void place_frame() {
        double widest = 0;
        for (double y = y_.least; y <= y_.most + y_step_ / 2; y += y_step_)
            widest = std::max(
                widest, context_.fonts.shape(one_piece(tick(near_zero(y, y_step_), y_step_)), theme_.small).width);
        // Above the frame names and unit, below it the numbers and the quantity.
        constexpr double above = 6, below = 9, beside = 2.5, right = 4;
        frame_ = rectangle(widest + beside, above, room_.x - right, std::max(room_.y - below, above + 12));
    }
    static double near_zero(double value, double step) { return std::abs(value) < 1e-9 * step ? 0 : value; }

    void axis(const char* cls, Spot from, Spot to, const Range& range, const std::string& unit) {
        figure_.marks.emplace_back(
            GroupBegin{cls,
                       id_in(figure_, cls),
                       "",
                       {{"data-from", shortest(range.least)}, {"data-to", shortest(range.most)}, {"data-unit", unit}},
                       none});
        figure_.marks.emplace_back(line(from, to, {theme_.outline, theme_.text, {}, false}));
        figure_.marks.emplace_back(Axis{from, to});
    }
    void text(const RichText& words, double size, Spot origin, double aligned, Colour colour) {
        const ShapedLine shaped = context_.fonts.shape(words, size);
        set_text(figure_.marks, shaped, {origin.x - aligned * shaped.width, origin.y}, colour, "text");
    }

    void draw_grid() {
        const Pen faint{theme_.thin, theme_.faint, {}, false};
        const double ends = frame_.max.x + 1;
        axis("axis-x", {frame_.min.x, frame_.max.y}, {frame_.max.x, frame_.max.y}, x_, x_unit_.symbol);
        for (double x = std::ceil(x_.least / x_step_ - 1e-9) * x_step_; x <= x_.most + 1e-9 * x_step_; x += x_step_) {
            const Spot foot = at(x, y_.least);
            figure_.marks.emplace_back(line(foot, {foot.x, frame_.min.y}, faint));
            text(one_piece(tick(near_zero(x, x_step_), x_step_)), theme_.small, {foot.x, foot.y + 3.6}, 0.5,
                 theme_.text);
        }
        RichText coordinate = name_of_coordinate();
        if (!x_unit_.symbol.empty()) append(coordinate, with_powers("  [" + x_unit_.symbol + "]"));
        text(coordinate, theme_.small, {ends, frame_.max.y + 7.4}, 1, theme_.secondary);
        figure_.marks.emplace_back(GroupEnd{});
        axis("axis-y", {frame_.min.x, frame_.max.y}, frame_.min, y_, y_unit_.symbol);
        for (double y = y_.least; y <= y_.most + 1e-9 * y_step_; y += y_step_) {
            const Spot foot = at(x_.least, y);
            const bool is_zero = std::abs(y) < 1e-9 * y_step_;
            if (foot.y < frame_.max.y - 0.01)
                figure_.marks.emplace_back(line(foot, {frame_.max.x, foot.y},
                                                is_zero ? Pen{theme_.thin, theme_.secondary, {}, false} : faint));
            text(one_piece(tick(near_zero(y, y_step_), y_step_)), theme_.small, {foot.x - 1.2, foot.y + 1.05}, 1,
                 theme_.text);
        }
        if (!y_unit_.symbol.empty())
            text(with_powers("[" + y_unit_.symbol + "]"), theme_.small, {frame_.min.x, frame_.min.y - 2.2}, 0.5,
                 theme_.secondary);
        figure_.marks.emplace_back(GroupEnd{});
    }

    RichText name_of_coordinate() const {
        if (table_.parameter) return one_piece(table_.driver, Face::italic);
        const bool over_time = table_.travel.times.has_value();
        RichText coordinate = one_piece(over_time ? "t" : table_.turns ? "Δφ" : "s", Face::italic);
        if (over_time) return coordinate;
        coordinate.front().sub = table_.driver;
        coordinate.front().sub_face = Face::regular;
        return coordinate;
    }

    /// Behind everything, where a contact would have to pull.
    void draw_separations() {
        for (const Separation& each : table_.followed.separations) {
            const double from = std::clamp(in_x(std::min(each.from, each.to)), x_.least, x_.most);
            const double to = std::clamp(in_x(std::max(each.from, each.to)), x_.least, x_.most);
            figure_.marks.emplace_back(
                GroupBegin{"separation", {}, "", {{"data-from", shortest(from)}, {"data-to", shortest(to)}}, none});
            const std::vector<Spot> corners{at(from, y_.least), at(to, y_.least), at(to, y_.most), at(from, y_.most)};
            figure_.marks.emplace_back(tinted(filled(corners, theme_.body(BodyIndex(1)).tint)));
            figure_.marks.emplace_back(GroupEnd{});
        }
    }

    /// The drawn position as a thin line, dead and change points and poles as dashed ones.
    void draw_upright_lines() {
        const auto upright = [&](double coordinate, const char* cls, const Pen& pen) {
            const double x = in_x(coordinate);
            if (x < x_.least - 1e-9 || x > x_.most + 1e-9) return;
            figure_.marks.emplace_back(GroupBegin{cls, {}, "", {{"data-value", shortest(x)}}, none});
            figure_.marks.emplace_back(line(at(x, y_.least), at(x, y_.most), pen));
            figure_.marks.emplace_back(GroupEnd{});
        };
        const Pen thin{theme_.thin, theme_.text, {}, false};
        if (!table_.parameter)
            upright(notes_.drawn, "drawn-position", thin);
        else if (table_.parameter->drawn)
            upright(*table_.parameter->drawn, "drawn-position", thin);
        const Pen broken{theme_.outline, theme_.secondary, dashes(), false};
        std::vector<double> poles;  // at a limit of the travel its own line is enough
        for (const std::size_t column : columns_) {
            if (column >= table_.followed.columns.size()) continue;
            for (const double each : table_.followed.columns[column].poles)
                if (std::find(poles.begin(), poles.end(), each) == poles.end()) poles.push_back(each);
        }
        std::erase_if(poles, [&](double each) {
            return (table_.travel.starts_at_limit && each == table_.travel.from) ||
                   (table_.travel.ends_at_limit && each == table_.travel.to);
        });
        for (const double each : poles) upright(each, "asymptote", broken);
        if (table_.travel.times) return;  // limits and change points are positions, but this axis is time
        if (table_.travel.starts_at_limit) upright(table_.travel.from, "dead-point", broken);
        if (table_.travel.ends_at_limit) upright(table_.travel.to, "dead-point", broken);
        for (const double each : table_.travel.change_points) upright(each, "change-point", broken);
    }

    void draw_curve(std::size_t curve) {
        const std::size_t column = columns_[curve];
        figure_.marks.emplace_back(
            GroupBegin{"curve",
                       id_in(figure_, legal_id(table_.columns[column].name)),
                       plain(name(curve)),
                       {{"data-name", table_.columns[column].name}, {"data-unit", y_unit_.symbol}},
                       none});
        Path path;
        path.stroked = true;
        path.pen = {theme_.vector, colour(curve), line_kind(curve), path.pen.dashes.empty()};
        const double rounding = rounding_of(table_, column);
        std::optional<Spot> last;  // in the units of the axes; none: the curve begins anew
        std::size_t gap = 0;
        for (const auto& row : table_.rows) {
            while (gap < table_.left_out.size() && lies_before(table_.left_out[gap], row[over_])) {
                last.reset();
                ++gap;
            }
            if (is_pole(column, row[over_])) {
                last.reset();
                continue;
            }
            const Spot here{in_x(row[over_]), in_y(std::abs(row[column]) < rounding ? 0 : row[column])};
            if (last && has_pole_between(column, *last, here)) last.reset();
            draw_piece(path, last, here);
            last = here;
        }
        if (path.segments.size() > 1) figure_.marks.emplace_back(std::move(path));
        mark_extremes(curve);
        figure_.marks.emplace_back(GroupEnd{});
    }
    /// Adds the piece of a curve from `last` to `here`, cut where it leaves the frame beside a pole.
    void draw_piece(Path& path, const std::optional<Spot>& last, Spot here) const {
        const auto is_inside = [&](Spot spot) { return !has_poles_ || (spot.y >= y_.least && spot.y <= y_.most); };
        const auto edge_towards = [&](Spot inside, Spot outside) {
            const double y = outside.y > y_.most ? y_.most : y_.least;
            const double share = (y - inside.y) / (outside.y - inside.y);
            return at(inside.x + share * (outside.x - inside.x), y);
        };
        if (is_inside(here)) {
            if (!last)
                path.segments.emplace_back(MoveTo{at(here.x, here.y)});
            else if (!is_inside(*last))
                path.segments.emplace_back(MoveTo{edge_towards(here, *last)});
            if (last) path.segments.emplace_back(LineTo{at(here.x, here.y)});
        } else if (last && is_inside(*last)) {
            path.segments.emplace_back(LineTo{edge_towards(*last, here)});
        }
    }
    bool has_pole_between(std::size_t column, Spot a, Spot b) const {
        if (column >= table_.followed.columns.size()) return false;
        const auto [from, to] = std::minmax({a.x, b.x});
        const std::vector<double>& poles = table_.followed.columns[column].poles;
        return std::any_of(poles.begin(), poles.end(),
                           [&, from = from, to = to](double each) { return in_x(each) > from && in_x(each) < to; });
    }
    bool lies_before(double a, double b) const { return table_.travel.at(1) > table_.travel.at(0) ? a < b : a > b; }

    void mark(std::size_t curve, Spot spot, const std::string& words, bool is_zero) {
        if (is_zero)
            figure_.marks.emplace_back(ring(spot, 0.7, theme_.paper, {theme_.thin, colour(curve), {}, false}));
        else
            figure_.marks.emplace_back(disc(spot, 0.7, colour(curve)));
        figure_.labels.push_back({.text = one_piece(words),
                                  .size = theme_.small,
                                  .colour = is_zero ? theme_.secondary : letters(curve),
                                  .anchor = spot,
                                  .clearance = 1.1});
    }

    /// Marks the largest and the least value and the zeros of a curve that is not constant.
    void mark_extremes(std::size_t curve) {
        const std::size_t column = columns_[curve];
        if (table_.rows.size() < 3 || is_constant(table_, column)) return;
        const auto [least, most] = extremes_of(table_, column);
        for (const bool below : {false, true}) {
            const Extreme& each = below ? least : most;
            if (each.value == 0 || is_unbounded(table_, column, below) || is_beside_gap(table_, each)) continue;
            mark(curve, at(in_x(each.at), in_y(each.value)), number(in_y(each.value), 4, context_.language), false);
        }
        const std::vector<double> zeros = zeros_of(table_, column);
        // With more zeros labels would be too crowded.
        constexpr std::size_t most_zeros = 4;
        if (zeros.size() > most_zeros) return;
        for (const double zero : zeros) {
            const double x = in_x(zero);
            const bool is_close = x_unit_.symbol.empty() || x_unit_.symbol == "°";
            mark(curve, at(x, 0), number(x, 4, context_.language) + (is_close ? "" : " ") + x_unit_.symbol, true);
        }
    }

    /// Names in a row above the frame, each with its line.
    void draw_legend() {
        double right = frame_.max.x;
        for (std::size_t i = columns_.size(); i-- > 0;) {
            const ShapedLine shaped = context_.fonts.shape(name(i), theme_.label);
            right -= shaped.width;
            set_text(figure_.marks, shaped, {right, frame_.min.y - 2}, letters(i), "label");
            right -= 9;
            figure_.marks.emplace_back(line({right, frame_.min.y - 3}, {right + 7.5, frame_.min.y - 3},
                                            {theme_.vector, colour(i), line_kind(i), false}));
            right -= 4;
        }
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const CycleTable& table_;
    const std::vector<std::size_t>& columns_;
    const PlotNotes& notes_;
    std::string id_;
    Spot room_;
    std::size_t over_;  ///< column of the abscissa
    Unit x_unit_, y_unit_;
    Range x_, y_;
    double x_step_ = 1, y_step_ = 1;
    bool has_poles_ = false;
    Box frame_;
    Figure figure_;
};

}  // namespace

Unit unit_of(QuantityKind kind, const Mechanism& mechanism) {
    if (kind == QuantityKind::angle) return {"°", kinegraph::pi() / 180};
    return unit_of(kind, mechanism.units);
}
Unit unit_of(const Column& column, const Mechanism& mechanism) {
    if (!column.si_unit.empty()) return {column.si_unit, 1};
    return unit_of(column.unit, mechanism);
}

namespace {

/// What stands behind the letter of a result on request: "C13", "K3", "Fgas".
std::string subject_on_paper(const Quantity& q, const Mechanism& mechanism, Language language) {
    std::string subject = subject_on_request(q, mechanism);
    if (q.kind == Quantity::Kind::centre) subject.replace(0, 1, notation(language).centre);
    if (q.kind == Quantity::Kind::acceleration_pole) subject.insert(0, "K");
    std::erase(subject, '_');
    return subject;
}

}  // namespace

RichText typeset(const Column& column, const Mechanism& mechanism, Language language) {
    const Quantity& q = column.quantity;
    const std::string axis = q.component == Quantity::Component::whole ? ""
                             : q.component == Quantity::Component::x   ? "x"
                                                                       : "y";
    const auto symbol = [](std::string letter, std::string sub, Face sub_face, int dots = 0) {
        Piece piece;
        piece.text = std::move(letter);
        piece.face = Face::italic;
        piece.sub = std::move(sub);
        piece.sub_face = sub_face;
        piece.dots = dots;
        return RichText{piece};
    };
    const auto body = [&](BodyIndex index) { return mechanism.body(index).name; };
    const auto along = [&](const std::string& of) { return of + (axis.empty() ? "" : " " + axis); };
    switch (column.kind) {
        case Column::Kind::turn: return symbol("φ", "", Face::regular);
        case Column::Kind::time: return symbol("t", "", Face::regular);
        case Column::Kind::angle: return symbol("φ", body(q.body), Face::regular);
        case Column::Kind::place_x: return symbol("x", mechanism.point(q.point).name, Face::italic);
        case Column::Kind::place_y: return symbol("y", mechanism.point(q.point).name, Face::italic);
        case Column::Kind::slid: return symbol("s", mechanism.joint(q.joint).name, Face::italic);
        case Column::Kind::parameter: return one_piece(column.name, Face::italic);
        case Column::Kind::along:
            return symbol(std::string(*result_kind(q).column), mechanism.joint(q.joint).name, Face::italic);
        case Column::Kind::named:
            if (column.said) return with_powers(column.said->in(language));
            if (!column.expression.empty())
                if (const auto read = ResultExpression::read(column.expression, operands_of_expressions(mechanism)))
                    return symbol_of(*read, mechanism, language);
            return with_powers(column.name);
        case Column::Kind::result: break;
    }
    const ResultKind& kind = result_kind(q);
    if (kind.on_request) {
        const std::string subject = subject_on_paper(q, mechanism, language);
        return kind.sign.empty() ? symbol(axis, subject, Face::regular)
                                 : symbol(std::string(kind.sign), along(subject), Face::regular);
    }
    const RichText letter = typeset(Symbol{kind.letter, "", ""}, language);
    switch (kind.subject) {
        case ResultKind::Subject::body: return symbol(letter[0].text, body(q.body), Face::regular, letter[0].dots);
        case ResultKind::Subject::point:
            return symbol(letter[0].text, along(mechanism.point(q.point).name), Face::italic);
        case ResultKind::Subject::action: {
            const std::string pair = (q.other == none ? "" : body(q.other)) + body(q.body);
            return symbol(std::string(*kind.column), along(pair), Face::regular);
        }
        default: {
            // Named as on the sheet: a couple "m" is M with the index m.
            const Effort& effort = mechanism.efforts[at_index(q.given)];
            const std::string name = std::visit([](const auto& each) { return each.name; }, effort);
            const bool is_couple = unit_kind_of(q, mechanism) == QuantityKind::moment;
            return typeset(Symbol{is_couple ? Symbol::Letter::M : Symbol::Letter::F, name, ""}, language);
        }
    }
}

Figure plot_figure(const DrawingContext& context, const CycleTable& table, const std::vector<std::size_t>& columns,
                   int number, double room_x, double room_y, const PlotNotes& notes) {
    Figure figure = PlotFigure(context, table, columns, number, {room_x, room_y}, notes).draw();
    place_labels(figure, context.fonts, Spot{room_x, room_y}, Labelling::strict, context.theme.secondary);
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

}  // namespace kinegraph::render
