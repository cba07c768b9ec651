#include "render/figures/xy_plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "render/mechanism/paper.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

/// A step of 1, 2 or 5 × 10ⁿ with at most `most` steps in a range.
double step_of(double range, int most) {
    const double rough = range / most;
    const int exponent = static_cast<int>(std::floor(nearest::log10(rough)));
    for (const double mantissa : {1.0, 2.0, 5.0})
        if (decimal(mantissa, exponent) >= rough * (1 - 1e-9)) return decimal(mantissa, exponent);
    return decimal(1, exponent + 1);
}

struct Scaled {
    double least = 0, most = 0, step = 1;
    double width() const { return most - least; }
};

/// Whole steps that include all values and zero.
Scaled scaled_to(const XyPlot& plot, double Spot::*axis, int at_most) {
    Scaled found;
    for (const XyCurve& curve : plot.curves)
        for (const Spot& value : curve.values) {
            found.least = std::min(found.least, value.*axis);
            found.most = std::max(found.most, value.*axis);
        }
    if (found.width() <= 0) found.most = found.least + 1;
    found.step = step_of(found.width(), at_most);
    found.least = std::floor(found.least / found.step + 1e-9) * found.step;
    found.most = std::ceil(found.most / found.step - 1e-9) * found.step;
    return found;
}

class Plot {
public:
    Plot(const DrawingContext& context, const XyPlot& plot, Spot room)
        : context_(context),
          theme_(context.theme),
          plot_(plot),
          room_(room),
          x_(scaled_to(plot, &Spot::x, std::max(3, static_cast<int>(room.x / 12)))),
          y_(scaled_to(plot, &Spot::y, std::max(3, static_cast<int>(room.y / 9)))) {
        // The text above a mark needs space.
        for (const XyMark& mark : plot.marks)
            if (mark.at.y > y_.most - 0.5 * y_.step) {
                y_.most += y_.step;
                break;
            }
    }

    Figure draw() {
        figure_.data_figure = "plot";
        figure_.id = plot_.id;
        figure_.unit = plot_.y_unit;
        figure_.has_scale = false;
        figure_.caption = plot_.caption;
        double widest = 0;
        for (int i = 0; i * y_.step <= y_.width() * (1 + 1e-9); ++i)
            widest = std::max(widest, shaped(tick(y_.least + i * y_.step, y_.step)).width);
        arrange_legend(room_.x - widest - 18);
        constexpr double below = 9, beside = 2.5, right = 4;
        const double above = 1.5 + legend_line * static_cast<double>(std::max<std::size_t>(legend_.size(), 1));
        frame_ = rectangle(widest + beside, above, room_.x - right, std::max(room_.y - below, above + 12));
        if (plot_.square) {
            const double unit = std::max(x_.width() / frame_.width(), y_.width() / frame_.height());
            frame_.max = {frame_.min.x + x_.width() / unit, frame_.min.y + y_.width() / unit};
        }
        figure_.marks.emplace_back(group_of(figure_, false));
        draw_x();
        draw_y();
        // The first curve is on top.
        for (std::size_t i = plot_.curves.size(); i-- > 0;) draw_curve(i);
        for (const XyMark& mark : plot_.marks) draw_mark(mark);
        draw_legend();
        figure_.marks.emplace_back(GroupEnd{});
        figure_.box = box_of(figure_.marks);
        return std::move(figure_);
    }

private:
    ShapedLine shaped(const std::string& words) const { return context_.fonts.shape(one_piece(words), theme_.small); }
    Spot at(Spot value) const {
        return {frame_.min.x + (value.x - x_.least) / x_.width() * frame_.width(),
                frame_.max.y - (value.y - y_.least) / y_.width() * frame_.height()};
    }
    std::string tick(double value, double step) const {
        if (std::abs(value) < 1e-9 * step) value = 0;
        const int decimals = std::clamp(-static_cast<int>(std::floor(nearest::log10(step) + 1e-9)), 0, 6);
        return std::abs(value) >= 1e5 || step < 1e-5 ? number(value, 3, context_.language)
                                                     : fixed(value, decimals, context_.language);
    }
    void text(const ShapedLine& line, Spot origin, double aligned, Colour colour) {
        set_text(figure_.marks, line, {origin.x - aligned * line.width, origin.y}, colour, "text");
    }
    void begin_axis(const char* cls, Spot from, Spot to, const Scaled& range, const std::string& unit) {
        figure_.marks.emplace_back(
            GroupBegin{cls,
                       id_in(figure_, cls),
                       "",
                       {{"data-from", shortest(range.least)}, {"data-to", shortest(range.most)}, {"data-unit", unit}},
                       none});
        figure_.marks.emplace_back(line(from, to, {theme_.outline, theme_.text, {}, false}));
        figure_.marks.emplace_back(Axis{from, to});
    }
    Pen grid(double value, double step) const {
        return {theme_.thin, std::abs(value) < 1e-9 * step ? theme_.secondary : theme_.faint, {}, false};
    }
    void draw_x() {
        begin_axis("axis-x", {frame_.min.x, frame_.max.y}, frame_.max, x_, plot_.x_unit);
        for (int i = 0; i * x_.step <= x_.width() * (1 + 1e-9); ++i) {
            const double x = x_.least + i * x_.step;
            const Spot foot = at({x, y_.least});
            figure_.marks.emplace_back(line(foot, {foot.x, frame_.min.y}, grid(x, x_.step)));
            text(shaped(tick(x, x_.step)), {foot.x, foot.y + 3.6}, 0.5, theme_.text);
        }
        RichText name = plot_.x_name;
        if (!plot_.x_unit.empty()) append(name, with_powers("  [" + plot_.x_unit + "]"));
        text(context_.fonts.shape(name, theme_.small), {frame_.max.x + 1, frame_.max.y + 7.4}, 1, theme_.secondary);
        figure_.marks.emplace_back(GroupEnd{});
    }
    void draw_y() {
        begin_axis("axis-y", {frame_.min.x, frame_.max.y}, frame_.min, y_, plot_.y_unit);
        for (int i = 0; i * y_.step <= y_.width() * (1 + 1e-9); ++i) {
            const double y = y_.least + i * y_.step;
            const Spot foot = at({x_.least, y});
            if (i > 0) figure_.marks.emplace_back(line(foot, {frame_.max.x, foot.y}, grid(y, y_.step)));
            text(shaped(tick(y, y_.step)), {foot.x - 1.2, foot.y + 1.05}, 1, theme_.text);
        }
        RichText name = plot_.y_name;
        if (!name.empty()) append(name, one_piece(" "));
        if (!plot_.y_unit.empty()) append(name, with_powers("[" + plot_.y_unit + "]"));
        const ShapedLine set = context_.fonts.shape(name, theme_.small);
        text(set, {std::max(frame_.min.x, 0.5 * set.width), frame_.min.y - 2.2}, 0.5, theme_.secondary);
        figure_.marks.emplace_back(GroupEnd{});
    }
    void draw_curve(std::size_t i) {
        const XyCurve& curve = plot_.curves[i];
        figure_.marks.emplace_back(GroupBegin{"curve",
                                              id_in(figure_, legal_id(curve.id)),
                                              plain(curve.name),
                                              {{"data-name", curve.id}, {"data-unit", plot_.y_unit}},
                                              none});
        std::vector<Spot> spots;
        for (const Spot& value : curve.values) spots.push_back(at(value));
        figure_.marks.emplace_back(
            polyline(spots, {theme_.vector, theme_.body(BodyIndex(i + 1)).line, line_kind(i), line_kind(i).empty()}));
        figure_.marks.emplace_back(GroupEnd{});
    }
    void draw_mark(const XyMark& mark) {
        const BodyColour& colour = theme_.body(BodyIndex(mark.curve + 1));
        const Spot spot = at(mark.at);
        figure_.marks.emplace_back(disc(spot, 0.8, colour.line));
        const ShapedLine words = context_.fonts.shape(mark.words, theme_.small);
        const Spot start = start_of(words, spot);
        // On a background that covers the grid.
        const Box ground = ground_of(words, start);
        named_.push_back(ground);
        figure_.marks.emplace_back(tinted(filled(
            {ground.min, {ground.max.x, ground.min.y}, ground.max, {ground.min.x, ground.max.y}}, theme_.paper)));
        set_text(figure_.marks, words, start, colour.letter, "label");
    }
    static Box ground_of(const ShapedLine& words, Spot start) {
        return rectangle(start.x - 0.4, start.y - words.ascent - 0.3, start.x + words.width + 0.4, start.y + 0.6);
    }
    /// The position of a mark's text: above the mark, or near it where it crosses the fewest curves.
    Spot start_of(const ShapedLine& words, Spot spot) const {
        const double above = spot.y - 1.8, below = spot.y + words.ascent + 1.8, level = spot.y + words.ascent / 2;
        const double right = spot.x + 1.8, left = spot.x - 1.8 - words.width, over = spot.x - words.width / 2;
        Spot best;
        std::size_t fewest = ~std::size_t{0};
        const auto offer = [&](Spot place) {
            const Spot start{std::clamp(place.x, frame_.min.x + 1, frame_.max.x - 1 - words.width),
                             std::clamp(place.y, frame_.min.y + words.ascent + 0.8, frame_.max.y - 0.8)};
            const Box ground = ground_of(words, start);
            constexpr std::size_t worse = 8;  // … than a line of the grid
            const std::size_t count = worse * lines_through(ground, spot) + grid_through(ground);
            if (count >= fewest) return;
            fewest = count;
            best = start;
        };
        for (const Spot place : {Spot{spot.x - 2, above}, Spot{over, below}, Spot{right, level}, Spot{left, level},
                                 Spot{right, above}, Spot{left, above}, Spot{right, below}, Spot{left, below}})
            offer(place);
        constexpr int directions = 32;
        for (const double away : {3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0})
            for (int k = 0; k < directions && fewest > 0; ++k)
                offer(spot + away * polar_spot(2 * std::numbers::pi * k / directions) -
                      Spot{0.5 * words.width, -0.5 * words.ascent});
        return best;
    }
    std::size_t grid_through(const Box& box) const {
        const auto is_crossed = [](const Scaled& scale, double low, double high) {
            return std::floor((high - scale.least) / scale.step) > std::floor((low - scale.least) / scale.step);
        };
        const auto value = [](const Scaled& scale, double from, double to, double place) {
            return scale.least + (place - from) / (to - from) * scale.width();
        };
        const auto x = [&](double place) { return value(x_, frame_.min.x, frame_.max.x, place); };
        const auto y = [&](double place) { return value(y_, frame_.max.y, frame_.min.y, place); };
        return (is_crossed(x_, x(box.min.x), x(box.max.x)) ? 1U : 0U) +
               (is_crossed(y_, y(box.max.y), y(box.min.y)) ? 1U : 0U);
    }
    /// The number of curve pieces, dots and texts of other marks within a box, and the mark itself.
    std::size_t lines_through(const Box& box, Spot own) const {
        std::size_t count = drawing::contains(box, own) ? 4 : 0;
        constexpr double clear = 0.6;  // half of a stroke's width and the space of the letters
        const Box inked = drawing::grown(box, clear);
        for (const XyCurve& curve : plot_.curves)
            for (std::size_t i = 0; i + 1 < curve.values.size(); ++i) {
                const Spot from = at(curve.values[i]), to = at(curve.values[i + 1]);
                const drawing::Interval inside = drawing::within(inked, from, to - from);
                if (std::max(inside.from, 0.0) <= std::min(inside.to, 1.0)) ++count;
            }
        for (const XyMark& other : plot_.marks)
            if (drawing::contains(box, at(other.at))) ++count;
        for (const Box& named : named_)
            if (box.min.x < named.max.x && named.min.x < box.max.x && box.min.y < named.max.y &&
                named.min.y < box.max.y)
                ++count;
        return count;
    }
    /// Names in rows above the frame, each with its line; as many in a row as fit.
    void arrange_legend(double room) {
        if (plot_.curves.size() < 2) return;
        double used = room + 1;
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
            const double own = context_.fonts.shape(plot_.curves[i].name, theme_.derived).width + 13;
            if (used + own > room) {
                legend_.emplace_back();
                used = 0;
            }
            legend_.back().push_back(i);
            used += own;
        }
    }
    void draw_legend() {
        double y = frame_.min.y - 2 - legend_line * static_cast<double>(legend_.size());
        for (const std::vector<std::size_t>& row : legend_) {
            y += legend_line;
            double right = frame_.max.x;
            for (std::size_t k = row.size(); k-- > 0;) {
                const std::size_t i = row[k];
                const ShapedLine name = context_.fonts.shape(plot_.curves[i].name, theme_.derived);
                right -= name.width;
                set_text(figure_.marks, name, {right, y}, theme_.body(BodyIndex(i + 1)).letter, "label");
                right -= 9;
                figure_.marks.emplace_back(
                    line({right, y - 1}, {right + 7.5, y - 1},
                         {theme_.vector, theme_.body(BodyIndex(i + 1)).line, line_kind(i), false}));
                right -= 4;
            }
        }
    }

    static constexpr double legend_line = 4.8;
    const DrawingContext& context_;
    const Theme& theme_;
    const XyPlot& plot_;
    Spot room_;
    Scaled x_, y_;
    std::vector<std::vector<std::size_t>> legend_;  ///< rows of curves
    Box frame_;
    std::vector<Box> named_;  ///< backgrounds of the texts placed so far
    Figure figure_;
};

}  // namespace

std::vector<double> line_kind(std::size_t curve) {
    if (curve == 0) return {};
    if (curve == 1) return dashes();
    return curve == 2 ? dash_dot() : std::vector<double>{0.6, 0.9};
}

Figure xy_plot_figure(const DrawingContext& context, const XyPlot& plot, double room_x, double room_y) {
    Figure figure = Plot(context, plot, {room_x, room_y}).draw();
    place_labels(figure, context.fonts, Spot{room_x, room_y}, Labelling::strict, context.theme.secondary);
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

}  // namespace kinegraph::render
