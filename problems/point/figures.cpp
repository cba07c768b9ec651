#include "problems/point/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lang/keys/common.hpp"
#include "lang/keys/point_motion.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/figures/xy_plot.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

Box box_of_places(const std::vector<Spot>& spots) {
    Box box{spots.front(), spots.front()};
    for (const Spot spot : spots) box.include(spot);
    return box;
}
double size_of(const Box& box) { return std::max(box.width(), box.height()); }

/// Common parts of all figures of a point.
class PointPen {
public:
    PointPen(const DrawingContext& context, Spot room)
        : context_(context),
          theme_(context.theme),
          problem_(problem_of<PointProblem>(context)),
          found_(solution_of<PointMotionSolution>(context)),
          room_(room) {}

protected:
    const BodyColour& path() const { return theme_.body(BodyIndex(1)); }
    const BodyColour& speeds() const { return theme_.body(BodyIndex(3)); }
    const BodyColour& accelerations() const { return theme_.body(BodyIndex(4)); }
    Pen thin(const std::vector<double>& kind = {}) const { return {theme_.thin, theme_.secondary, kind, false}; }

    void name(const std::string& text, Spot at, Colour colour, std::optional<Spot> toward = std::nullopt,
              double clearance = 2.2) {
        name(formula(text), at, colour, toward, clearance);
    }
    void name(RichText text, Spot at, Colour colour, std::optional<Spot> toward, double clearance) {
        figure_.labels.push_back({.text = std::move(text),
                                  .size = theme_.label,
                                  .colour = colour,
                                  .anchor = at,
                                  .toward = toward,
                                  .clearance = clearance});
    }
    void vector(const std::string& data_name, const std::string& text, Spot tail, Spot reach, double value,
                const char* unit, const BodyColour& colour, const std::vector<double>& kind = {}) {
        if (length(reach) < 0.3) return;
        figure_.marks.emplace_back(
            GroupBegin{"vector",
                       id_in(figure_, legal_id(data_name)),
                       data_name,
                       {{"data-name", data_name}, {"data-value", shortest(value)}, {"data-unit", unit}},
                       none});
        draw_arrow(figure_.marks, tail, tail + reach, kind.empty() ? theme_.vector : theme_.outline, colour.line, kind);
        figure_.marks.emplace_back(Axis{tail, tail + reach});
        figure_.marks.emplace_back(GroupEnd{});
        name(vector_formula(text), tail + 0.8 * reach, colour.letter, tail + reach, 2.2);
    }
    /// Five positions at equal intervals of time.
    static std::vector<std::size_t> ticks(std::size_t count) {
        std::vector<std::size_t> found;
        constexpr std::size_t parts = 6;
        for (std::size_t i = 0; i <= parts; ++i) found.push_back(i * (count - 1) / parts);
        return found;
    }
    std::string per_millimetre(double scale, const Unit& unit) const {
        return "1 mm ≙ " + shortest(scale / unit.si.to_double(), context_.language) + " " + unit.symbol;
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const PointProblem& problem_;
    const PointMotionSolution& found_;
    Spot room_;
    Figure figure_;
};

class Trajectory : PointPen {
public:
    Trajectory(const DrawingContext& context, Spot room, bool as_question)
        : PointPen(context, room), as_question_(as_question) {}

    Figure draw() {
        measure();
        figure_ = begun("trajectory", "trajectory",
                        as_question_ ? Words(lang::point_motion::trajectory)
                                     : Words(lang::point_motion::trajectory_velocity_and_acceleration),
                        scale_, "m", context_.language);
        at_ = spot_of(found_.place, scale_);
        draw_axes();
        if (!as_question_) draw_curvature();
        draw_path();
        if (!as_question_) draw_vectors();
        figure_.marks.emplace_back(ring(at_, 1.1, theme_.paper, {2 * theme_.outline, path().line, {}, false}));
        figure_.labels.push_back({.text = one_piece(problem_.point, Face::italic),
                                  .size = theme_.label,
                                  .colour = path().letter,
                                  .anchor = at_});
        return finished(std::move(figure_), context_, room_);
    }

private:
    /// The extent of the trajectory, with origin and circle of curvature unless these would make it too small.
    void measure() {
        std::vector<Spot> spots{spot_of(found_.place, 1)};
        for (const auto& each : found_.course) spots.push_back(spot_of(each.place, 1));
        Box extent = box_of_places(spots);
        const double own = size_of(extent) > 0 ? size_of(extent) : 1;
        const auto include_if_near = [&](const std::vector<Spot>& more, double most) {
            Box wider = extent;
            for (const Spot spot : more) wider.include(spot);
            const bool near = size_of(wider) <= most * own;
            if (near) extent = wider;
            return near;
        };
        shows_origin_ = include_if_near({{0, 0}}, 1.8);
        if (found_.centre && !as_question_) {
            const Spot centre = spot_of(*found_.centre, 1), radius{found_.radius, found_.radius};
            shows_circle_ = include_if_near({centre - radius, centre + radius}, 1.6);
        }
        scale_ = choose_scale(std::max(extent.width(), 1e-9 * own), extent.height(), std::max(room_.x - 32, 20.0),
                              std::max(room_.y - 24, 15.0), std::nullopt);
        box_ = {(1 / scale_) * extent.min, (1 / scale_) * extent.max};
    }
    void draw_axes() {
        if (!shows_origin_) return;
        const Pen pen = thin();
        const double right = std::max(box_.max.x, 0.0) + 7, up = std::min(box_.min.y, 0.0) - 7;
        figure_.marks.emplace_back(line({std::min(box_.min.x, 0.0) - 3, 0}, {right, 0}, pen));
        figure_.marks.emplace_back(line({0, std::max(box_.max.y, 0.0) + 3}, {0, up}, pen));
        draw_arrow(figure_.marks, {right - 4, 0}, {right, 0}, theme_.thin, theme_.secondary);
        draw_arrow(figure_.marks, {0, up + 4}, {0, up}, theme_.thin, theme_.secondary);
        name("{x}", {right, 0}, theme_.secondary, std::nullopt, 1.2);
        name("{y}", {0, up}, theme_.secondary, std::nullopt, 1.2);
        name("{O}", {0, 0}, theme_.secondary, std::nullopt, 1.2);
        if (problem_.form == PointProblem::Form::polar && length(at_) > 4) {
            figure_.marks.emplace_back(line({0, 0}, at_, thin(dash_dot())));
            name("{r}", 0.5 * at_, theme_.secondary, at_, 1.2);
        }
    }
    void draw_path() {
        std::vector<Spot> spots;
        for (const auto& each : found_.course) spots.push_back(spot_of(each.place, scale_));
        figure_.marks.emplace_back(
            GroupBegin{"curve", id_in(figure_, "path"), problem_.point, {{"data-name", problem_.point}}, none});
        figure_.marks.emplace_back(polyline(spots, {2 * theme_.outline, path().line, {}, true}));
        figure_.marks.emplace_back(GroupEnd{});
        for (const std::size_t i : ticks(spots.size())) figure_.marks.emplace_back(disc(spots[i], 0.55, path().line));
        name(in(Words(lang::point_motion::time_is), context_.language) +
                 amount(problem_.from.to_double(), QuantityKind::time, units(), context_.language, as_given),
             spots.front(), path().letter);
        // Half-way between the beginning and the point, along the path.
        std::vector<Spot> gone;
        for (std::size_t i = 0; i < spots.size() && found_.course[i].time <= problem_.at.to_double(); ++i)
            gone.push_back(spots[i]);
        if (gone.size() > 2 && length(gone.back() - gone.front()) > 6) {
            const std::size_t middle = gone.size() / 2;
            name("{s}", gone[middle], path().letter, gone[middle + 1], 1.4);
        }
    }
    const Units& units() const { return context_.solution.mechanism.units; }

    void draw_curvature() {
        if (found_.rests) return;
        const Spot t = unit(spot_of(found_.velocity, 1)),
                   n = found_.straight ? turned(t) : unit(spot_of(*found_.normal, 1));
        constexpr double reach = 24;
        figure_.marks.emplace_back(line(at_ - 0.6 * reach * t, at_ + 1.2 * reach * t, thin()));
        name("{t}", at_ + 1.2 * reach * t, theme_.secondary, std::nullopt, 1.2);
        const double inward = found_.centre && shows_circle_ ? std::max(reach, found_.radius / scale_ + 3) : reach;
        figure_.marks.emplace_back(line(at_ - 0.4 * reach * n, at_ + inward * n, thin(dash_dot())));
        name("{n}", at_ + inward * n, theme_.secondary, std::nullopt, 1.2);
        if (!found_.centre) return;
        const Spot centre = spot_of(*found_.centre, scale_);
        const double radius = found_.radius / scale_;
        if (shows_circle_) {
            figure_.marks.emplace_back(circle(centre, radius, thin(dashes())));
            figure_.marks.emplace_back(ring(centre, 0.9, theme_.paper, {theme_.outline, theme_.text, {}, false}));
            name("{C}", centre, theme_.text);
            if (radius > 8) name("{ρ}", 0.5 * (centre + at_), theme_.text, at_, 1.4);
        } else if (constexpr double along = 20, seen = 0.01; along * along > 2 * radius * seen) {
            // A flatter arc is not told from its tangent, and its centre may lie beyond all paper.
            const double from = angle_of(at_ - centre), half = std::min(pi, along / radius);
            figure_.marks.emplace_back(arc(centre, radius, from - half, from + half, thin(dashes())));
        }
    }
    void draw_vectors() {
        const double speed_scale = scale_for(found_.speed, 24, units().velocity);
        const double acceleration_scale = scale_for(found_.acceleration_length, 22, units().acceleration);
        std::string further;
        if (found_.speed > 0) further = per_millimetre(speed_scale, units().velocity);
        if (found_.acceleration_length > 0)
            further += (further.empty() ? "" : ", ") + per_millimetre(acceleration_scale, units().acceleration);
        figure_.further_scale = further;
        if (found_.acceleration_length > 0) {
            const Spot a = spot_of(found_.acceleration, acceleration_scale);
            const bool in_parts = !found_.rests && !found_.straight && !found_.tangential->is_zero();
            if (in_parts) {
                const Spot along = spot_of(*found_.tangential, acceleration_scale),
                           across = spot_of(*found_.normal, acceleration_scale);
                figure_.marks.emplace_back(line(at_ + a, at_ + along, thin(dashes())));
                figure_.marks.emplace_back(line(at_ + a, at_ + across, thin(dashes())));
                vector("a_t", "{a_t}", at_, along, std::abs(found_.along), "m/s²", accelerations(), dashes());
                vector("a_n", "{a_n}", at_, across, found_.across, "m/s²", accelerations(), dashes());
            }
            const char* said = in_parts || found_.rests ? "{a}" : found_.straight ? "{a} = {a_t}" : "{a} = {a_n}";
            vector("a", said, at_, a, found_.acceleration_length, "m/s²", accelerations());
        }
        if (found_.speed > 0)
            vector("v", "{v}", at_, spot_of(found_.velocity, speed_scale), found_.speed, "m/s", speeds());
    }
    static double scale_for(double value, double longest, const Unit& unit) {
        if (value <= 0) return 1;
        return choose_scale(value / unit.si.to_double(), 0, longest, 1, std::nullopt) * unit.si.to_double();
    }

    bool as_question_;
    bool shows_origin_ = false, shows_circle_ = false;
    double scale_ = 1;
    Box box_;
    Spot at_;
};

class Hodograph : PointPen {
public:
    using PointPen::PointPen;

    Figure draw() {
        const Unit& unit = context_.solution.mechanism.units.velocity;
        const double si = unit.si.to_double();
        std::vector<Spot> spots{{0, 0}, spot_of(found_.velocity, si)};
        for (const auto& each : found_.course) spots.push_back(spot_of(each.velocity, si));
        Box extent = box_of_places(spots);
        if (size_of(extent) == 0) extent.include(Spot{1, 0});
        const double scale = choose_scale(extent.width(), extent.height(), room_.x - 34, room_.y - 24, std::nullopt);
        figure_ = begun("velocity", "hodograph", {lang::common::hodograph}, scale, unit.symbol, context_.language);
        std::vector<Spot> curve;
        for (const auto& each : found_.course) curve.push_back(spot_of(each.velocity, si * scale));
        figure_.marks.emplace_back(GroupBegin{"curve", GroupId("hodograph", "path"), "v", {{"data-name", "v"}}, none});
        figure_.marks.emplace_back(polyline(curve, {theme_.outline, speeds().line, dashes(), false}));
        figure_.marks.emplace_back(GroupEnd{});
        for (const std::size_t i : ticks(curve.size())) figure_.marks.emplace_back(disc(curve[i], 0.55, speeds().line));
        const Spot tip = spot_of(found_.velocity, si * scale);
        if (!found_.acceleration.is_zero()) {
            const Spot a = unit_of(found_.acceleration);
            draw_arrow(figure_.marks, tip, tip + 13 * a, theme_.outline, accelerations().line);
            name("{a}", tip + 10 * a, accelerations().letter, tip + 13 * a);
        }
        vector("v", "{v}", {0, 0}, tip, found_.speed / si, unit.symbol.c_str(), speeds());
        figure_.marks.emplace_back(disc({0, 0}, 0.8, theme_.text));
        name("{o}", {0, 0}, theme_.text);
        return finished(std::move(figure_), context_, room_);
    }

private:
    static Spot unit_of(const Vector& v) { return unit(spot_of(v, 1)); }
};

/// PC : v = v : a_n, in the right triangle N′VC with the altitude PV.
class CurvatureCentre : PointPen {
public:
    using PointPen::PointPen;

    Figure draw() {
        choose();
        const double metres = speed_scale_ * speed_scale_ / acceleration_scale_;
        figure_ = begun("curvature", "curvature-centre", {lang::point_motion::the_centre_of_curvature_by_similar},
                        metres, "m", context_.language);
        const Units& units = context_.solution.mechanism.units;
        figure_.further_scale = per_millimetre(speed_scale_, units.velocity) + ", " +
                                per_millimetre(acceleration_scale_, units.acceleration);
        const Spot p{0, 0}, v = spot_of(found_.velocity, speed_scale_),
                            a = spot_of(*found_.normal, acceleration_scale_);
        const Spot centre = (found_.radius / metres) * unit(a);
        figure_.marks.emplace_back(line(-0.35 * v, 1.35 * v, thin()));
        figure_.marks.emplace_back(line(-1.35 * a, centre + 5 * unit(a), thin(dash_dot())));
        name("{t}", 1.35 * v, theme_.secondary, std::nullopt, 1.2);
        name("{n}", centre + 5 * unit(a), theme_.secondary, std::nullopt, 1.2);
        figure_.marks.emplace_back(line(-1 * a, v, {theme_.outline, theme_.secondary, {}, false}));
        figure_.marks.emplace_back(line(v, centre, {theme_.outline, theme_.secondary, {}, false}));
        right_angle(v, unit(centre - v), unit(-1 * a - v));
        vector("v", "{v}", p, v, found_.speed, "m/s", speeds());
        vector("a_n", "{a_n}", p, a, found_.across, "m/s²", accelerations());
        draw_arrow(figure_.marks, p, -1 * a, theme_.outline, accelerations().line, dashes());
        name("−{a_n}", -0.6 * a, accelerations().letter, -1 * a);
        figure_.marks.emplace_back(ring(p, 1.1, theme_.paper, {2 * theme_.outline, path().line, {}, false}));
        figure_.labels.push_back({.text = one_piece(problem_.point, Face::italic),
                                  .size = theme_.label,
                                  .colour = path().letter,
                                  .anchor = p});
        figure_.marks.emplace_back(ring(centre, 0.9, theme_.paper, {theme_.outline, theme_.text, {}, false}));
        name("{C}", centre, theme_.text);
        name("{V}", v, theme_.text);
        name("{N}′", -1 * a, theme_.text);
        return finished(std::move(figure_), context_, room_);
    }

private:
    void right_angle(Spot corner, Spot along, Spot across) {
        constexpr double side = 2.2;
        figure_.marks.emplace_back(
            polyline({corner + side * along, corner + side * (along + across), corner + side * across}, thin()));
    }
    /// The greatest length of v for which the figure fits.
    void choose() {
        const Units& units = context_.solution.mechanism.units;
        const double speed_si = units.velocity.si.to_double(), acceleration_si = units.acceleration.si.to_double();
        for (const double longest : {26.0, 22.0, 18.0, 15.0, 12.0, 10.0, 8.0}) {
            speed_scale_ = choose_scale(found_.speed / speed_si, 0, longest, 1, std::nullopt) * speed_si;
            acceleration_scale_ =
                choose_scale(found_.across / acceleration_si, 0, 0.6 * longest, 1, std::nullopt) * acceleration_si;
            const Spot v = spot_of(found_.velocity, speed_scale_), a = spot_of(*found_.normal, acceleration_scale_);
            const double metres = speed_scale_ * speed_scale_ / acceleration_scale_;
            const Box box = box_of_places({-0.35 * v, 1.35 * v, -1.35 * a, a, (found_.radius / metres + 5) * unit(a)});
            if (box.width() <= room_.x - 20 && box.height() <= room_.y - 16) return;
        }
    }
    double speed_scale_ = 1, acceleration_scale_ = 1;
};

/// One quantity over time, with its value at the instant.
struct Curve {
    std::string symbol;
    double PointMotionSolution::At::*value = nullptr;
    double at_instant = 0;
};
Figure over_time(const DrawingContext& context, const char* id, const Words& caption, QuantityKind kind,
                 const std::vector<Curve>& curves, Spot room) {
    const PointMotionSolution& found = solution_of<PointMotionSolution>(context);
    const Units& units = context.solution.mechanism.units;
    double largest = 0;
    for (const auto& each : found.course)
        for (const Curve& curve : curves) largest = std::max(largest, std::abs(each.*curve.value));
    const Unit unit = suitable_unit(largest, kind, units);
    const double si = unit.si.to_double();
    XyPlot plot;
    plot.id = id;
    plot.caption = one_piece(in(caption, context.language));
    plot.x_name = symbol_of("t");
    plot.x_unit = "s";
    if (curves.size() == 1) plot.y_name = symbol_of(curves[0].symbol);
    plot.y_unit = unit.symbol;
    const bool defined = kind != QuantityKind::acceleration || !found.rests;
    for (const Curve& curve : curves) {
        XyCurve drawn{symbol_of(curve.symbol), curve.symbol, {}};
        for (const auto& each : found.course)
            if (kind != QuantityKind::acceleration || !each.rests)
                drawn.values.push_back({each.time, each.*curve.value / si});
        if (drawn.values.empty()) drawn.values = {{found.course.front().time, 0}, {found.course.back().time, 0}};
        plot.curves.push_back(std::move(drawn));
        if (defined)
            plot.marks.push_back({plot.curves.size() - 1,
                                  {problem_of<PointProblem>(context).at.to_double(), curve.at_instant / si},
                                  one_piece(amount(curve.at_instant, kind, units, context.language))});
    }
    return xy_plot_figure(context, plot, room.x, room.y);
}

}  // namespace

Figure trajectory_figure(const DrawingContext& context, double room_x, double room_y) {
    return Trajectory(context, {room_x, room_y}, false).draw();
}
Figure trajectory_question_figure(const DrawingContext& context, double room_x, double room_y) {
    return Trajectory(context, {room_x, room_y}, true).draw();
}
Figure hodograph_figure(const DrawingContext& context, double room_x, double room_y) {
    return Hodograph(context, {room_x, room_y}).draw();
}
Figure curvature_centre_figure(const DrawingContext& context, double room_x, double room_y) {
    return CurvatureCentre(context, {room_x, room_y}).draw();
}
Figure way_figure(const DrawingContext& context, double room_x, double room_y) {
    return over_time(context, "way", {lang::point_motion::way_over_time}, QuantityKind::length,
                     {{"s", &PointMotionSolution::At::way, solution_of<PointMotionSolution>(context).way}},
                     {room_x, room_y});
}
Figure speed_figure(const DrawingContext& context, double room_x, double room_y) {
    return over_time(context, "speed", {lang::point_motion::speed_over_time}, QuantityKind::velocity,
                     {{"v", &PointMotionSolution::At::speed, solution_of<PointMotionSolution>(context).speed}},
                     {room_x, room_y});
}
Figure components_figure(const DrawingContext& context, double room_x, double room_y) {
    const PointMotionSolution& found = solution_of<PointMotionSolution>(context);
    return over_time(context, "components", {lang::point_motion::components_of_the_acceleration_over_time},
                     QuantityKind::acceleration,
                     {{"a_t", &PointMotionSolution::At::along, found.along},
                      {"a_n", &PointMotionSolution::At::across, found.across}},
                     {room_x, room_y});
}

}  // namespace kinegraph::render
