#include "problems/positions/positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lang/keys/finite_positions.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

class PositionsFigure {
public:
    PositionsFigure(const DrawingContext& context, Spot room)
        : context_(context),
          theme_(context.theme),
          problem_(problem_of<PositionsProblem>(context)),
          found_(solution_of<PositionsSolution>(context)),
          room_(room) {
        const Spot first = spot_of(problem_.positions[0].places[0], 1);
        extent_ = {first, first};
        for (const auto& position : problem_.positions)
            for (const Vector& place : position.places) extent_.include(spot_of(place, 1));
        own_ = std::max(extent_.width(), extent_.height());
    }

    Figure question() {
        begin("positions", {lang::finite_positions::positions_of_the_body});
        for (std::size_t i = 0; i < problem_.positions.size(); ++i) draw_body(i);
        return finished(std::move(figure_), context_, room_);
    }

    Figure displacement(std::size_t index) {
        const Displacement& displacement = found_.displacements.at(index);
        const std::string both = std::to_string(displacement.from + 1) + std::to_string(displacement.to + 1);
        const bool shows = displacement.pole && include_if_near(*displacement.pole, 3);
        begin("displacement-" + both, {lang::finite_positions::displacement, std::to_string(displacement.from + 1),
                                       std::to_string(displacement.to + 1)});
        const std::optional<Spot> pole = shows ? std::optional<Spot>(spot(*displacement.pole)) : std::nullopt;
        for (std::size_t point = 0; point < 2; ++point) draw_way(displacement, point, pole);
        draw_body(displacement.from);
        draw_body(displacement.to);
        if (displacement.kind == Displacement::Kind::translation)
            for (std::size_t point = 0; point < 2; ++point) draw_translation(displacement, point);
        if (displacement.by == Displacement::By::joins && pole)
            for (const std::size_t position : {displacement.from, displacement.to})
                figure_.marks.emplace_back(line(place(position, 0), *pole, thin(dashes())));
        if (pole) draw_pole(displacement, *pole, both);
        return finished(std::move(figure_), context_, room_);
    }

    Figure pivots() {
        std::array<bool, 2> shown{};
        for (std::size_t i = 0; i < 2; ++i) {
            const FixedPivot& pivot = found_.pivots.at(i);
            shown.at(i) = pivot.centre && include_if_near(*pivot.centre, 4);
        }
        begin("pivots", {lang::finite_positions::fixed_pivots_from_three_positions});
        for (std::size_t i = 0; i < 2; ++i) draw_circle(i, shown.at(i));
        for (std::size_t i = 0; i < problem_.positions.size(); ++i) draw_body(i);
        for (std::size_t i = 0; i < 2; ++i)
            if (shown.at(i)) draw_pivot(i);
        return finished(std::move(figure_), context_, room_);
    }

private:
    Spot spot(const Vector& v) const { return spot_of(v, scale_); }
    Spot place(std::size_t position, std::size_t point) const {
        return spot(problem_.positions.at(position).places.at(point));
    }
    Pen thin(const std::vector<double>& kind = {}) const { return {theme_.thin, theme_.secondary, kind, false}; }
    void name(const std::string& text, Spot at, Colour colour, std::optional<Spot> toward = std::nullopt) {
        figure_.labels.push_back({.text = formula(text),
                                  .size = theme_.label,
                                  .colour = colour,
                                  .anchor = at,
                                  .toward = toward,
                                  .clearance = 2});
    }
    std::string numbered(std::size_t point, std::size_t position) const {
        return "{" + problem_.points.at(point) + "_" + std::to_string(position + 1) + "}";
    }

    bool include_if_near(const Vector& place, double most) {
        Box wider = extent_;
        wider.include(spot_of(place, 1));
        if (std::max(wider.width(), wider.height()) > most * own_) return false;
        extent_ = wider;
        return true;
    }
    void begin(const std::string& id, const Words& caption) {
        scale_ = choose_scale(std::max(extent_.width(), 1e-9 * own_), extent_.height(), std::max(room_.x - 36, 20.0),
                              std::max(room_.y - 24, 15.0), std::nullopt);
        figure_ = begun("positions", id.c_str(), caption, scale_, "m", context_.language);
    }
    void draw_body(std::size_t position) {
        const BodyColour& colour = theme_.body(BodyIndex(position + 1));
        const Spot a = place(position, 0), b = place(position, 1);
        figure_.marks.emplace_back(
            GroupBegin{"link", id_in(figure_, std::to_string(position + 1)), std::to_string(position + 1), {}, none});
        figure_.marks.emplace_back(line(a, b, {theme_.link, colour.line, {}, true}));
        for (const Spot pin : {a, b})
            figure_.marks.emplace_back(ring(pin, 1.2, theme_.paper, {theme_.outline, colour.line, {}, false}));
        figure_.marks.emplace_back(GroupEnd{});
        name(numbered(0, position), a, colour.letter);
        name(numbered(1, position), b, colour.letter);
    }
    /// The line between both positions of a point and its bisector, with the right angle in the middle.
    void draw_way(const Displacement& displacement, std::size_t point, std::optional<Spot> pole) {
        const Spot from = place(displacement.from, point), to = place(displacement.to, point);
        if (length(to - from) < 0.5 || displacement.kind == Displacement::Kind::translation) return;
        figure_.marks.emplace_back(line(from, to, thin(dashes())));
        if (displacement.kind == Displacement::Kind::rotation) return;
        bisect(from, to, pole);
    }
    void bisect(Spot from, Spot to, std::optional<Spot> goal) {
        const Spot middle = 0.5 * (from + to), across = unit(turned(to - from)), along = unit(to - from);
        constexpr double beyond = 4, far = 22, corner = 1.8;
        Spot end = middle + far * across;
        Spot begin = middle - far * across;
        if (goal) {
            const Spot towards = length(*goal - middle) > 1 ? unit(*goal - middle) : across;
            end = *goal + beyond * towards;
            begin = middle - beyond * towards;
        }
        figure_.marks.emplace_back(line(begin, end, thin(dash_dot())));
        const double side = goal && dot(*goal - middle, across) < 0 ? -corner : corner;
        figure_.marks.emplace_back(polyline(
            {middle + corner * along, middle + corner * along + side * across, middle + side * across}, thin()));
    }
    void draw_translation(const Displacement& displacement, std::size_t point) {
        const Spot from = place(displacement.from, point), to = place(displacement.to, point);
        draw_arrow(figure_.marks, from, to, theme_.outline, theme_.text);
        if (point == 0) name("{d}", 0.5 * (from + to), theme_.text, to);
    }
    void draw_pole(const Displacement& displacement, Spot pole, const std::string& both) {
        // The rays to the farther point, and the angle between them.
        std::size_t point = 0;
        if (length(place(displacement.from, 1) - pole) > length(place(displacement.from, 0) - pole)) point = 1;
        const Spot from = place(displacement.from, point), to = place(displacement.to, point);
        figure_.marks.emplace_back(line(pole, from, thin()));
        figure_.marks.emplace_back(line(pole, to, thin()));
        const double radius = std::clamp(0.45 * length(from - pole), 6.0, 24.0), start = angle_of(from - pole);
        if (std::abs(displacement.angle) * radius > 2) {
            draw_arc_arrow(figure_.marks, pole, radius, start, start - displacement.angle, theme_.outline, theme_.text);
            name("{φ_" + both + "}", pole + radius * polar_spot(start - 0.5 * displacement.angle), theme_.text);
        }
        figure_.marks.emplace_back(ring(pole, 1.2, theme_.paper, {2 * theme_.outline, theme_.text, {}, false}));
        name("{P_" + both + "}", pole, theme_.text);
    }

    /// Bisectors 1–2 and 2–3, and the circle through the three positions.
    void draw_circle(std::size_t point, bool shown) {
        const FixedPivot& pivot = found_.pivots.at(point);
        if (pivot.kind == FixedPivot::Kind::straight) {
            const Spot a = place(0, point), d = unit(spot_of(pivot.direction, 1));
            double least = 0, most = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                least = std::min(least, dot(place(i, point) - a, d));
                most = std::max(most, dot(place(i, point) - a, d));
            }
            figure_.marks.emplace_back(line(a + (least - 8) * d, a + (most + 8) * d, thin(dash_dot())));
            return;
        }
        if (!pivot.centre || !shown) return;
        const Spot centre = spot(*pivot.centre);
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
            bisect(place(i, point), place(i + 1, point), centre);
        // Only from the first to the last position, with a short extension.
        const double first = angle_of(place(0, point) - centre);
        double least = 0, most = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            const double turn = std::remainder(angle_of(place(i, point) - centre) - first, 2 * pi);
            least = std::min(least, turn);
            most = std::max(most, turn);
        }
        figure_.marks.emplace_back(
            arc(centre, pivot.radius / scale_, first + least - 0.15, first + most + 0.15, thin(dashes())));
    }
    void draw_pivot(std::size_t point) {
        const Spot pin = spot(*found_.pivots.at(point).centre);
        figure_.marks.emplace_back(line(pin, place(0, point), {theme_.outline, theme_.text, {}, false}));
        figure_.marks.emplace_back(
            polyline({pin, pin + Spot{-3, 5}, pin + Spot{3, 5}}, {theme_.outline, theme_.text, {}, false}, true));
        figure_.marks.emplace_back(
            line(pin + Spot{-4.5, 5}, pin + Spot{4.5, 5}, {2 * theme_.outline, theme_.text, {}, false}));
        for (int i = -2; i <= 2; ++i)
            figure_.marks.emplace_back(
                line(pin + Spot{1.8 * i, 5}, pin + Spot{1.8 * i - 1.4, 6.6}, {theme_.thin, theme_.text, {}, false}));
        figure_.marks.emplace_back(ring(pin, 1.2, theme_.paper, {theme_.outline, theme_.text, {}, false}));
        name("{" + problem_.points.at(point) + "_0}", pin, theme_.text);
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const PositionsProblem& problem_;
    const PositionsSolution& found_;
    Spot room_;
    Box extent_;
    double own_ = 1, scale_ = 1;
    Figure figure_;
};

}  // namespace

Figure positions_question_figure(const DrawingContext& context, double room_x, double room_y) {
    return PositionsFigure(context, {room_x, room_y}).question();
}
Figure finite_displacement_figure(const DrawingContext& context, std::size_t displacement, double room_x,
                                  double room_y) {
    return PositionsFigure(context, {room_x, room_y}).displacement(displacement);
}
Figure pivots_figure(const DrawingContext& context, double room_x, double room_y) {
    return PositionsFigure(context, {room_x, room_y}).pivots();
}

}  // namespace kinegraph::render
