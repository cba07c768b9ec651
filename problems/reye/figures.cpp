#include "problems/reye/reye.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/reye.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/figures/xy_plot.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

class ContactFigure {
public:
    /// `as_question`: without the pressures.
    ContactFigure(const DrawingContext& context, Spot room, bool as_question)
        : context_(context),
          theme_(context.theme),
          problem_(context.solution.mechanism.problem->as<ReyeProblem>()),
          found_(context.solution.problem->as<ReyeSolution>()),
          units_(context.solution.mechanism.units),
          room_(room),
          as_question_(as_question) {}

    Figure draw() {
        if (problem_.kind == ReyeProblem::Kind::disc)
            draw_disc();
        else if (problem_.kind == ReyeProblem::Kind::shoe)
            draw_shoe();
        else
            draw_pad();
        return finished(std::move(figure_), context_, room_);
    }

private:
    void begin(const Words& caption, double scale) {
        scale_ = scale;
        figure_ = begun("contact", "contact", caption, scale, "m", context_.language);
    }
    void press_to_scale(double greatest, double room) {
        const Unit unit = suitable_unit(greatest, QuantityKind::pressure, units_);
        const double si = unit.si.to_double(), chosen = choose_scale(greatest / si, 0, room, 1, std::nullopt);
        pressure_scale_ = chosen * si;
        figure_.further_scale = "1 mm ≙ " + shortest(chosen, context_.language) + " " + unit.symbol;
    }
    Pen pen(double width, Colour colour, const std::vector<double>& kind = {}) const {
        return {width, colour, kind, false};
    }
    const BodyColour& colour() const { return theme_.body(BodyIndex(1)); }
    void add(Path path) { figure_.marks.emplace_back(std::move(path)); }
    void name(const std::string& words, Spot anchor, std::optional<Spot> toward = std::nullopt,
              double clearance = 1.6) {
        name(formula(words), anchor, toward, clearance);
    }
    void name(RichText words, Spot anchor, std::optional<Spot> toward = std::nullopt, double clearance = 1.6) {
        figure_.labels.push_back({.text = std::move(words),
                                  .size = theme_.derived,
                                  .colour = theme_.text,
                                  .anchor = anchor,
                                  .toward = toward,
                                  .clearance = clearance});
    }
    std::string said(double si, QuantityKind kind) const { return amount(si, kind, units_, context_.language, 4); }
    std::string given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, units_, context_.language, as_given);
    }
    void arrow(Spot tail, Spot tip, double width, Colour ink) { draw_arrow(figure_.marks, tail, tip, width, ink); }
    void dimension(Spot from, Spot to, const std::string& words) {
        const Spot middle = 0.5 * (from + to);
        arrow(middle, from, theme_.thin, theme_.text);
        arrow(middle, to, theme_.thin, theme_.text);
        name(words, middle, to);
    }
    /// At a distance from what it measures, between two thin lines that begin `clear` of its ends. `kind`: dashes if
    /// its length is not to scale.
    void dimension_beside(Spot from, Spot to, Spot aside, const std::string& words, Spot clear = {2, 2},
                          const std::vector<double>& kind = {}) {
        const Spot away = unit(aside), middle = 0.5 * (from + to) + aside;
        for (const auto& [end, gap] : {std::pair(from, clear.x), std::pair(to, clear.y)}) {
            add(line(end + gap * away, end + aside + 1.5 * away, pen(theme_.thin, theme_.text)));
            draw_arrow(figure_.marks, middle, end + aside, theme_.thin, theme_.text, kind);
        }
        name(words, middle, to + aside);
    }

    // ----- pad and block

    void draw_pad() {
        const double a = problem_.length.to_double();
        begin(as_question_ ? Words(lang::reye::pad_and_force) : Words(lang::reye::pad_pressures_and_their_centroid),
              choose_scale(a, 0, room_.x - 30, 1, std::nullopt));
        const double sum = found_.first + found_.second;
        if (!as_question_) press_to_scale(std::max(sum, found_.greatest), std::max(room_.y - 52, 12.0));
        const double width = a / scale_;
        constexpr double high = 9;
        add(panel({{0, -high}, {width, -high}, {width, 0}, {0, 0}}, colour().tint,
                  pen(2 * theme_.outline, colour().line)));
        add(line({-6, 0}, {width + 6, 0}, pen(2 * theme_.outline, theme_.text)));
        const double at = found_.resultant->to_double() / scale_;
        arrow({at, -high - 11}, {at, -high}, theme_.vector, theme_.text);
        name(vector_formula("{Q}"), {at, -high - 6}, Spot{at, -high});
        if (problem_.kind == ReyeProblem::Kind::pad) {
            add(line({0, -high}, {0, -high - 7}, pen(theme_.thin, theme_.secondary)));
            dimension({0, -high - 5}, {at, -high - 5}, "{d} = " + given(problem_.offset, QuantityKind::length));
        }
        if (found_.friction_force) {
            arrow({width + 14, -2.5}, {width + 1, -2.5}, theme_.vector, theme_.secondary);
            name("{f}{Q}", {width + 8, -2.5}, Spot{width, -2.5});
        }
        if (!as_question_) draw_pressures(at);
    }
    void draw_pressures(double at) {
        constexpr double top = 3;
        const double left = found_.begin / scale_, right = found_.end / scale_;
        const double first = found_.first / pressure_scale_, second = found_.second / pressure_scale_;
        const std::vector<Spot> face{{left, top}, {right, top}, {right, top + second}, {left, top + first}};
        add(tinted(filled(face, colour().tint)));
        constexpr int rays = 8;
        for (int i = 0; i <= rays; ++i) {
            const double share = static_cast<double>(i) / rays, x = left + share * (right - left),
                         p = first + share * (second - first);
            if (p > 1.5 && std::abs(x - at) > 1.5) arrow({x, top + p}, {x, top}, theme_.thin, colour().line);
        }
        add(polyline(face, pen(theme_.outline, colour().line), true));
        // Each of the parallel sides is extended by the other, in opposite directions: the line through the ends meets
        // the median in the centroid.
        const Pen thin = pen(theme_.thin, theme_.secondary);
        add(line({left, top + first}, {left, top + first + second}, thin));
        add(line({right, top}, {right, top - first}, thin));
        add(line({left, top + first + second}, {right, top - first}, thin));
        add(line({left, top + first / 2}, {right, top + second / 2}, pen(theme_.thin, theme_.secondary, dash_dot())));
        const double share = first + second > 0 ? (at - left) / (right - left) : 0.5;
        const Spot centroid{at, top + first / 2 + share * (second - first) / 2};
        const double foot = top + std::max(first, second) + 11;
        arrow({at, foot}, {at, centroid.y}, theme_.vector, colour().line);
        add(ring(centroid, 0.9, theme_.paper, pen(theme_.outline, theme_.text)));
        name("{G}", centroid);
        name(vector_formula("{R} = {Q}"), {at, foot - 3}, Spot{at, foot - 8});
        if (found_.first > 0) name("{p_1}", {left, top + first / 2}, Spot{left, top});
        if (found_.second > 0) name("{p_2}", {right, top + second / 2}, Spot{right, top});
    }

    // ----- disc

    void draw_disc() {
        const double inner = problem_.inner.to_double(), outer = problem_.outer.to_double();
        const double room = std::min(room_.x - 40, room_.y - 8);
        begin({lang::reye::rubbing_face}, choose_scale(2 * outer, 0, room, 1, std::nullopt));
        const Spot centre{0, 0};
        const Pen edge = pen(2 * theme_.outline, colour().line);
        add(ring(centre, outer / scale_, colour().tint, edge));
        add(ring(centre, inner / scale_, theme_.paper, edge));
        const double reach = outer / scale_ + 4;
        add(line({-reach, 0}, {reach, 0}, pen(theme_.thin, theme_.secondary, dash_dot())));
        add(line({0, -reach}, {0, reach}, pen(theme_.thin, theme_.secondary, dash_dot())));
        const auto radius = [&](double r, double angle, const std::string& words) {
            const Spot tip = (r / scale_) * polar_spot(angle);
            arrow(centre, tip, theme_.outline, theme_.text);
            name(words, 0.75 * tip, tip);
        };
        radius(inner, -0.75 * pi, "{r_1} = " + given(problem_.inner, QuantityKind::length));
        radius(outer, -0.2 * pi, "{r_2} = " + given(problem_.outer, QuantityKind::length));
        draw_arc_arrow(figure_.marks, centre, 0.5 * (inner + outer) / scale_, 0.75 * pi, 0.35 * pi, theme_.vector,
                       theme_.text);
        name("{M}", 0.5 * (inner + outer) / scale_ * polar_spot(0.55 * pi));
    }

    // ----- shoe; the pivot to the right of the drum's centre, angles counter-clockwise

    Spot round(double radius, double angle) const {
        return {radius * nearest::cos(angle), -radius * nearest::sin(angle)};
    }
    void draw_shoe() {
        const double r = problem_.radius.to_double(), h = problem_.pivot.to_double();
        const double span = std::max(r, h) + r;
        begin(as_question_ ? Words(lang::reye::shoe_and_drum) : Words(lang::reye::shoe_drum_and_pressures),
              choose_scale(span, 2 * r, room_.x - 20, room_.y - 24, std::nullopt));
        if (!as_question_) press_to_scale(found_.greatest, 12);
        const double drum = r / scale_;
        add(circle({0, 0}, drum, pen(2 * theme_.outline, theme_.text)));
        add(disc({0, 0}, 0.7, theme_.text));
        name("{O}", {0, 0});
        draw_lining(drum);
        if (!as_question_) draw_shoe_pressures(drum);
        const Spot pin{h / scale_, 0};
        add(line({0, 0}, pin, pen(theme_.thin, theme_.secondary, dash_dot())));
        draw_pivot_on_frame(figure_.marks, pin, {0, 1}, colour().line, theme_);
        draw_shoe_force(pin, drum);
        // Above, where the frame is not.
        constexpr double beside = 6;  // mm
        dimension_beside({0, 0}, pin, {0, -beside}, "{h}");
        // Friction turns a leading shoe in the sense of its force. The pivot is on the right, so that the drum turns
        // clockwise for an inner shoe.
        const double middle = 1.25 * pi;
        const bool counter = problem_.leading != problem_.inside;
        draw_arc_arrow(figure_.marks, {0, 0}, 0.6 * drum, -middle, -middle + (counter ? -0.8 : 0.8), theme_.outline,
                       theme_.text);
        name("{ω}", round(0.6 * drum, middle));
    }
    void draw_lining(double drum) {
        constexpr double thick = 3, steps = 48;
        const double side = problem_.inside ? -thick : thick, from = found_.begin, to = found_.end;
        std::vector<Spot> band;
        for (int i = 0; i <= steps; ++i) band.push_back(round(drum, from + (to - from) * i / steps));
        for (int i = static_cast<int>(steps); i >= 0; --i)
            band.push_back(round(drum + side, from + (to - from) * i / steps));
        add(panel(band, colour().tint, pen(theme_.outline, colour().line)));
    }
    /// On the other side of the lining than the shoe.
    void draw_shoe_pressures(double drum) {
        std::vector<Spot> outline;
        const double side = problem_.inside ? 1 : -1;
        for (const ReyeSolution::At& each : found_.pressures)
            outline.push_back(round(drum + side * each.pressure / pressure_scale_, each.place));
        add(polyline(outline, pen(theme_.outline, colour().line)));
        constexpr std::size_t every = 6;
        for (std::size_t i = 0; i < outline.size(); i += every)
            if (found_.pressures[i].pressure / pressure_scale_ > 1.2)
                arrow(outline[i], round(drum, found_.pressures[i].place), theme_.thin, colour().line);
        name("{p_max} = " + said(found_.greatest, QuantityKind::pressure),
             round(drum + side * found_.greatest / pressure_scale_, found_.greatest_at), std::nullopt, 1.2);
        // The friction of the whole face acts as one force at the centre of pressure.
        const Spot along = unit({found_.normal_force.x, -found_.normal_force.y});
        const Spot centre = (found_.pressure_radius / scale_ * (problem_.inside ? -1 : 1)) * along;
        add(line({0, 0}, centre, pen(theme_.thin, theme_.secondary, dash_dot())));
        add(ring(centre, 0.9, theme_.paper, pen(theme_.outline, theme_.text)));
        name("{C}", centre);
        const double angle = angle_of(centre);
        add(arc({0, 0}, found_.pressure_radius / scale_, angle - 0.35, angle + 0.35,
                pen(theme_.thin, theme_.secondary, dashes())));
    }
    /// At the distance of the arm from the pivot: on the back of the shoe if it is long enough, otherwise on a lever
    /// beyond its end.
    Spot place_of_force(Spot pin, double drum, double arm) const {
        const double back = drum + (problem_.inside ? -3 : 3), across = length(pin);
        const double cosine = (across * across + back * back - arm * arm) / (2 * across * back);
        if (std::abs(cosine) <= 1) return round(back, nearest::acos(cosine));
        const Spot toe = round(drum + (problem_.inside ? -1.5 : 1.5), found_.end);
        return pin + arm * unit(toe - pin);
    }
    void draw_shoe_force(Spot pin, double drum) {
        const double arm = problem_.arm.to_double() / scale_, longest = 2.2 * drum;
        const Spot place = place_of_force(pin, drum, std::min(arm, longest));
        const Spot towards = unit(place - pin);
        // Perpendicular to the arm: away from the drum's centre for an inner shoe, towards it for an outer one.
        Spot across = turned(towards);
        if (dot(across, round(1, 0.5 * (found_.begin + found_.end))) < 0) across = -1 * across;
        if (!problem_.inside) across = -1 * across;
        constexpr double force = 11, clear = 4;  // mm
        arrow(place - force * across, place, theme_.vector, theme_.text);
        name(vector_formula("{Q}"), place - 6 * across, place);
        // Behind the force, where no line ends on its tip, and clear of the drum's centre.
        double behind = force + 3;
        while (std::abs(dot(pin - behind * across, across)) < clear) behind += 1;
        dimension_beside(pin, place, -behind * across, "{c}", {2, force + 1},
                         arm > longest ? dashes() : std::vector<double>{});
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const ReyeProblem& problem_;
    const ReyeSolution& found_;
    const Units& units_;
    Spot room_;
    bool as_question_;
    double scale_ = 1, pressure_scale_ = 1;
    Figure figure_;
};

}  // namespace

Figure reye_contact_figure(const DrawingContext& context, double room_x, double room_y) {
    return ContactFigure(context, {room_x, room_y}, false).draw();
}
Figure reye_question_figure(const DrawingContext& context, double room_x, double room_y) {
    return ContactFigure(context, {room_x, room_y}, true).draw();
}

Figure reye_pressure_figure(const DrawingContext& context, double room_x, double room_y) {
    const auto& problem = context.solution.mechanism.problem->as<ReyeProblem>();
    const auto& found = context.solution.problem->as<ReyeSolution>();
    const Units& units = context.solution.mechanism.units;
    const bool ring = problem.kind == ReyeProblem::Kind::disc;
    const Unit pressure = suitable_unit(found.greatest, QuantityKind::pressure, units);
    const Unit place = ring ? units.length : Unit{"°", kinegraph::pi() / 180};
    const double per_pressure = pressure.si.to_double(), per_place = place.si.to_double();
    XyPlot plot;
    plot.id = "pressures";
    const Words caption =
        ring ? Words(lang::reye::pressure_over_the_radius) : Words(lang::reye::pressure_along_the_shoe);
    plot.caption = one_piece(in(caption, context.language));
    plot.x_name = symbol_of(ring ? "r" : "θ");
    plot.x_unit = place.symbol;
    plot.y_name = symbol_of("p");
    plot.y_unit = pressure.symbol;
    const auto words = [&](const Words& name) { return one_piece(in(name, context.language)); };
    XyCurve worn{ring ? words({lang::reye::worn_in}) : symbol_of("p"), "worn", {}};
    for (const ReyeSolution::At& each : found.pressures)
        worn.values.push_back({each.place / per_place, each.pressure / per_pressure});
    plot.curves.push_back(worn);
    if (found.uniform_pressure) {
        const double even = *found.uniform_pressure / per_pressure;
        plot.curves.push_back({words({lang::reye::new_word}),
                               "uniform",
                               {{found.begin / per_place, even}, {found.end / per_place, even}}});
    }
    plot.marks.push_back({0,
                          {found.greatest_at / per_place, found.greatest / per_pressure},
                          one_piece(amount(found.greatest, QuantityKind::pressure, units, context.language))});
    return xy_plot_figure(context, plot, room_x, room_y);
}

}  // namespace kinegraph::render
