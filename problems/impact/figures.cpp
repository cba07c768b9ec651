#include "problems/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lang/keys/impact.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/figures/xy_plot.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

void vector_mark(Figure& figure, const std::string& name, Spot tail, Spot tip, double value, const std::string& unit,
                 Colour colour) {
    figure.marks.emplace_back(GroupBegin{"vector",
                                         id_in(figure, legal_id(name)),
                                         name,
                                         {{"data-name", name}, {"data-value", shortest(value)}, {"data-unit", unit}},
                                         none});
    draw_arrow(figure.marks, tail, tip, 0.7, colour);
    figure.marks.emplace_back(Axis{tail, tip});
    figure.marks.emplace_back(GroupEnd{});
}

enum class Moment { before, after };

class CollisionFigure {
public:
    CollisionFigure(const DrawingContext& context, Moment moment, Spot room)
        : context_(context),
          theme_(context.theme),
          problem_(problem_of<ImpactProblem>(context)),
          found_(solution_of<ImpactSolution>(context)),
          moment_(moment),
          room_(room) {
        measure();
        scale_ = choose_scale(extent_.width(), extent_.height(), std::max(room.x - 46, 20.0),
                              std::max(room.y - 34, 15.0), std::nullopt);
        // Each figure has a scale of its own: those after an impact would often be shorter than the bodies are wide.
        double fastest = 0;
        for (const ImpactSolution::Body& body : found_.bodies)
            fastest = std::max(fastest, kinegraph::length(velocity_of(body)));
        const Unit& unit = context.solution.mechanism.units.velocity;
        if (fastest > 0)
            speed_scale_ =
                choose_scale(fastest / unit.si.to_double(), 0, longest_, 1, std::nullopt) * unit.si.to_double();
        origin_ = spot_of(found_.at, scale_);
        normal_ = unit_spot(found_.normal);
    }

    Figure draw() {
        Figure figure = moment_ == Moment::before
                            ? begun("contact", "contact", {lang::impact::bodies_and_velocities_before}, scale_, "m",
                                    context_.language)
                            : begun("contact", "contact-after", {lang::impact::velocities_after_the_impact}, scale_,
                                    "m", context_.language);
        const Unit& unit = context_.solution.mechanism.units.velocity;
        if (speed_scale_ > 0)
            figure.further_scale =
                "1 mm ≙ " + shortest(speed_scale_ / unit.si.to_double(), context_.language) + " " + unit.symbol;
        for (std::size_t i = 0; i < 2; ++i) draw_body(figure, i);
        draw_lines(figure);
        for (std::size_t i = 0; i < 2; ++i) draw_velocities(figure, i);
        figure.marks.emplace_back(disc(origin_, 0.8, theme_.text));
        figure.labels.push_back(
            {.text = one_piece("P", Face::italic), .size = theme_.label, .colour = theme_.text, .anchor = origin_});
        return finished(std::move(figure), context_, room_);
    }

private:
    const Vector& velocity_of(const ImpactSolution::Body& body) const {
        return moment_ == Moment::before ? body.before : body.after;
    }
    Spot unit_spot(const Vector& v) const { return unit(spot_of(v, 1)); }
    Spot spot(const Vector& place) const { return spot_of(place, scale_); }
    const Body& body(std::size_t i) const { return context_.solution.mechanism.body(problem_.bodies.at(i).body); }

    void measure() {
        const auto include = [&](const Vector& place, double radius) {
            const Spot s = spot_of(place, 1);
            const Box box{{s.x - radius, s.y - radius}, {s.x + radius, s.y + radius}};
            first_ ? extent_ = box : (extent_.include(box), extent_);
            first_ = false;
        };
        include(found_.at, 0);
        for (std::size_t i = 0; i < 2; ++i) {
            if (found_.bodies.at(i).fixed) continue;
            for (const PointIndex point : body(i).points) include(context_.solution.pose.at(point), 0);
            if (const auto round = circle_of(i)) include(round->first, round->second);
            include(found_.bodies.at(i).centre, 0);
            if (found_.bodies.at(i).pivot) include(*found_.bodies.at(i).pivot, 0);
        }
        constexpr double something = 0.05;  // m; for particles without other extent
        if (extent_.width() == 0 && extent_.height() == 0)
            extent_ = {extent_.min - Spot{something, something}, extent_.max + Spot{something, something}};
    }
    /// The circle in the file. For a central impact, the circle through the point of impact.
    std::optional<std::pair<Vector, double>> circle_of(std::size_t i) const {
        const ImpactSolution::Body& of = found_.bodies.at(i);
        if (const auto& circle = body(i).circle)
            return std::pair{context_.solution.pose.at(circle->centre), circle->radius.to_double()};
        const Vector arm = of.centre - found_.at;
        if (of.fixed || of.pivot || !body(i).points.empty() || arm.is_zero() || !cross(arm, found_.normal).is_zero())
            return std::nullopt;
        return std::pair{of.centre, kinegraph::length(arm)};
    }

    void draw_body(Figure& figure, std::size_t i) {
        const ImpactSolution::Body& of = found_.bodies.at(i);
        const BodyColour& colour = theme_.body(problem_.bodies.at(i).body);
        const Pen outline{2 * theme_.outline, colour.line, {}, true};
        figure.marks.emplace_back(GroupBegin{"link", id_in(figure, legal_id(body(i).name)), body(i).name, {}, none});
        Spot aside = spot(of.centre);
        if (of.fixed) {
            draw_ground(figure, i == 0 ? normal_ : -1 * normal_);
            aside = origin_ + 11 * turned(normal_) + 3 * (i == 0 ? normal_ : -1 * normal_);
        } else if (const auto round = circle_of(i)) {
            figure.marks.emplace_back(ring(spot(round->first), round->second / scale_, colour.tint, outline));
            aside = spot(round->first) + 0.7 * (round->second / scale_) * Spot{-1, -1};
        } else if (body(i).points.size() > 1) {
            std::vector<Spot> spots;
            for (const PointIndex point : body(i).points) spots.push_back(spot(context_.solution.pose.at(point)));
            if (spots.size() == 2)
                figure.marks.emplace_back(line(spots[0], spots[1], {theme_.link, colour.line, {}, true}));
            else
                figure.marks.emplace_back(panel(hull_of(spots), colour.tint, outline));
            aside = 0.7 * spots[1] + 0.3 * spots[0];
        } else if (of.centre != found_.at) {
            std::vector<Spot> rod{spot(of.centre), origin_};
            if (of.pivot) rod.insert(rod.begin(), spot(*of.pivot));
            figure.marks.emplace_back(polyline(rod, {theme_.link, colour.line, {}, true}));
        } else {
            figure.marks.emplace_back(
                ring(origin_ + 2.2 * (i == 0 ? normal_ : -1 * normal_), 2.2, colour.tint, outline));
            aside = origin_ + 4 * (i == 0 ? normal_ : -1 * normal_);
        }
        figure.marks.emplace_back(GroupEnd{});
        figure.labels.push_back({.text = one_piece(in(called(body(i)), context_.language)),
                                 .size = theme_.label,
                                 .colour = colour.letter,
                                 .anchor = aside,
                                 .clearance = 2.5});
        if (of.fixed) return;
        if (of.centre != found_.at) draw_centre(figure, i, colour);
        if (of.pivot) draw_pivot(figure, *of.pivot, colour);
    }
    void draw_centre(Figure& figure, std::size_t i, const BodyColour& colour) {
        const Spot centre = spot(found_.bodies.at(i).centre);
        figure.marks.emplace_back(ring(centre, 1.0, theme_.paper, {theme_.outline, colour.line, {}, false}));
        figure.marks.emplace_back(disc(centre, 0.4, colour.line));
        figure.labels.push_back({.text = formula("{G_" + std::to_string(i + 1) + "}"),
                                 .size = theme_.label,
                                 .colour = colour.letter,
                                 .anchor = centre});
        if (const auto& percussion = found_.bodies.at(i).percussion; percussion && moment_ == Moment::after) {
            const Spot there = spot(*percussion);
            if (render::length(there - centre) > room_.x) return;  // too far to be drawn
            const Pen pen{theme_.outline, theme_.secondary, {}, false};
            figure.marks.emplace_back(line(there + Spot{-1.2, -1.2}, there + Spot{1.2, 1.2}, pen));
            figure.marks.emplace_back(line(there + Spot{-1.2, 1.2}, there + Spot{1.2, -1.2}, pen));
            figure.labels.push_back({.text = one_piece("C", Face::italic),
                                     .size = theme_.label,
                                     .colour = theme_.secondary,
                                     .anchor = there});
        }
    }
    void draw_pivot(Figure& figure, const Vector& at, const BodyColour& colour) {
        constexpr Spot hanging{0, -1};
        draw_pivot_on_frame(figure.marks, spot(at), hanging, colour.line, theme_);
        figure.labels.push_back(
            {.text = one_piece("O", Face::italic), .size = theme_.label, .colour = theme_.text, .anchor = spot(at)});
    }
    void draw_ground(Figure& figure, Spot inward) {
        const Spot along = turned(normal_);
        const double half = std::min(18.0, 0.5 * room_.x - 14);
        figure.marks.emplace_back(
            line(origin_ - half * along, origin_ + half * along, {2 * theme_.outline, theme_.text, {}, false}));
        for (double at = -half + 1; at <= half - 0.5; at += 2.4) {
            const Spot foot = origin_ + at * along;
            figure.marks.emplace_back(
                line(foot, foot + 2 * inward - 1.4 * along, {theme_.thin, theme_.text, {}, false}));
        }
    }
    void draw_lines(Figure& figure) {
        const double reach = std::min(26.0, 0.5 * std::min(room_.x, room_.y));
        const Spot along = turned(normal_);
        figure.marks.emplace_back(line(origin_ - reach * normal_, origin_ + reach * normal_,
                                       {theme_.thin, theme_.secondary, dash_dot(), false}));
        figure.marks.emplace_back(line(origin_ - 0.7 * reach * along, origin_ + 0.7 * reach * along,
                                       {theme_.thin, theme_.secondary, {}, false}));
        const auto name = [&](const char* letter, Spot at) {
            figure.labels.push_back({.text = one_piece(letter, Face::italic),
                                     .size = theme_.derived,
                                     .colour = theme_.secondary,
                                     .anchor = at,
                                     .clearance = 1.2});
        };
        name("n", origin_ + reach * normal_);
        name("t", origin_ - 0.7 * reach * along);
    }
    void draw_velocities(Figure& figure, std::size_t i) {
        const ImpactSolution::Body& of = found_.bodies.at(i);
        if (of.fixed) return;
        const BodyColour& colour = theme_.body(problem_.bodies.at(i).body);
        const std::string n = std::to_string(i + 1);
        const Spot centre =
            of.centre == found_.at ? origin_ + 2.2 * (i == 0 ? normal_ : -1 * normal_) : spot(of.centre);
        const Spot reach = speed_scale_ > 0 ? spot_of(velocity_of(of), speed_scale_) : Spot{};
        if (render::length(reach) >= 0.3) {
            const std::string mark = moment_ == Moment::before ? "" : "′", name = "v_" + n;
            vector_mark(figure, name + mark, centre, centre + reach, kinegraph::length(velocity_of(of)), "m/s",
                        colour.line);
            figure.labels.push_back({.text = vector_formula("{" + name + "}" + mark),
                                     .size = theme_.label,
                                     .colour = colour.letter,
                                     .anchor = centre + 0.75 * reach,
                                     .toward = centre + reach});
        }
        draw_turn(figure, i, centre, colour);
    }
    void draw_turn(Figure& figure, std::size_t i, Spot centre, const BodyColour& colour) {
        const ImpactSolution::Body& of = found_.bodies.at(i);
        const Exact& omega = moment_ == Moment::before ? of.omega_before : of.omega_after;
        if (omega.is_zero()) return;
        const bool left = omega.sign() > 0;
        const double from = left ? 0.35 * pi : 0.65 * pi;
        const Spot about = of.pivot ? spot(*of.pivot) : centre;
        draw_arc_arrow(figure.marks, about, 5, from, left ? from - 0.7 * pi : from + 0.7 * pi, theme_.outline,
                       colour.line);
        figure.labels.push_back(
            {.text = formula("{ω_" + std::to_string(i + 1) + (moment_ == Moment::before ? "}" : "}′")),
             .size = theme_.derived,
             .colour = colour.letter,
             .anchor = about + 5 * polar_spot(left ? 0 : pi),
             .clearance = 1.5});
    }

    static constexpr double longest_ = 20;
    const DrawingContext& context_;
    const Theme& theme_;
    const ImpactProblem& problem_;
    const ImpactSolution& found_;
    Moment moment_;
    Spot room_;
    Box extent_;
    bool first_ = true;
    double scale_ = 1, speed_scale_ = 0;  ///< m and m/s for each mm; 0: nothing moves
    Spot origin_, normal_;
};

/// Vectors from one pole to scale, with the axes of the impact.
class VelocityPlane {
public:
    VelocityPlane(const DrawingContext& context, const char* id, Words caption, Spot room)
        : context_(context),
          theme_(context.theme),
          found_(solution_of<ImpactSolution>(context)),
          id_(id),
          caption_(std::move(caption)),
          room_(room),
          unit_(context.solution.mechanism.units.velocity) {}

    struct Arrow {
        std::string name, text;
        Vector tip;  ///< m/s
        Colour line, letter;
    };
    struct Side {
        Vector from, to;  ///< m/s
        RichText text;
    };
    std::vector<Arrow> arrows;
    std::vector<Side> sides;

    Figure draw() {
        Box extent;
        const double si = unit_.si.to_double();
        for (const Arrow& each : arrows) extent.include(spot_of(each.tip, si));
        for (const Side& each : sides) extent.include(spot_of(each.to, si));
        scale_ = choose_scale(extent.width(), extent.height(), room_.x - 30, room_.y - 20, std::nullopt) * si;
        Figure figure = begun("velocity", id_, caption_, scale_, "m/s", context_.language);
        figure.scale = scale_ / si;
        figure.unit = unit_.symbol;
        draw_axes(figure, {(si / scale_) * extent.min, (si / scale_) * extent.max});
        // Collinear vectors would overlap; they are drawn side by side.
        const bool side_by_side = are_collinear();
        Spot tail;
        if (!side_by_side)
            for (const Side& each : sides) draw_side(figure, each);
        for (const Arrow& each : arrows) {
            draw_arrow_of(figure, each, tail);
            if (side_by_side && !each.tip.is_zero()) tail = tail + 5 * unit(spot_of(found_.tangent, 1));
        }
        figure.marks.emplace_back(disc({0, 0}, 0.8, theme_.text));
        figure.labels.push_back(
            {.text = one_piece("o", Face::italic), .size = theme_.label, .colour = theme_.text, .anchor = {0, 0}});
        return finished(std::move(figure), context_, room_);
    }

private:
    bool are_collinear() const {
        return std::all_of(arrows.begin(), arrows.end(),
                           [&](const Arrow& each) { return cross(each.tip, found_.normal).is_zero(); });
    }
    /// Across the whole drawing.
    void draw_axes(Figure& figure, const Box& box) {
        const auto axis = [&](const Vector& direction, const char* name, const std::vector<double>& kind) {
            const Spot d = unit(spot_of(direction, 1));
            double least = -6, most = 6;
            for (const Spot corner : {box.min, box.max, Spot{box.min.x, box.max.y}, Spot{box.max.x, box.min.y}}) {
                least = std::min(least, dot(corner, d) - 4);
                most = std::max(most, dot(corner, d) + 4);
            }
            figure.marks.emplace_back(line(least * d, most * d, {theme_.thin, theme_.secondary, kind, false}));
            figure.labels.push_back({.text = one_piece(name, Face::italic),
                                     .size = theme_.derived,
                                     .colour = theme_.secondary,
                                     .anchor = most * d,
                                     .clearance = 1.2});
        };
        axis(found_.normal, "n", dash_dot());
        axis(found_.tangent, "t", {});
    }
    void draw_side(Figure& figure, const Side& side) {
        const Spot from = spot_of(side.from, scale_), to = spot_of(side.to, scale_);
        if (render::length(to - from) < 0.3) return;
        figure.marks.emplace_back(line(from, to, {theme_.outline, theme_.text, dashes(), false}));
        if (!side.text.empty())
            figure.labels.push_back({.text = side.text,
                                     .size = theme_.derived,
                                     .colour = theme_.text,
                                     .anchor = 0.5 * (from + to),
                                     .toward = to,
                                     .clearance = 1.4});
    }
    void draw_arrow_of(Figure& figure, const Arrow& arrow, Spot tail) {
        const Spot reach = spot_of(arrow.tip, scale_);
        if (render::length(reach) < 0.3) return;
        vector_mark(figure, arrow.name, tail, tail + reach, kinegraph::length(arrow.tip), "m/s", arrow.line);
        figure.labels.push_back({.text = vector_formula(arrow.text),
                                 .size = theme_.label,
                                 .colour = arrow.letter,
                                 .anchor = tail + 0.6 * reach,
                                 .toward = tail + reach});
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const ImpactSolution& found_;
    const char* id_;
    Words caption_;
    Spot room_;
    const Unit& unit_;
    double scale_ = 1;
};

/// The ends of the straight line α + β x + γ y = 0 within a box; empty if it misses the box.
std::vector<Spot> clipped(double alpha, double beta, double gamma, const Box& box) {
    std::vector<Spot> ends;
    const auto add = [&](Spot s) {
        const double tolerance = 1e-9 * (box.width() + box.height());
        if (s.x < box.min.x - tolerance || s.x > box.max.x + tolerance || s.y < box.min.y - tolerance ||
            s.y > box.max.y + tolerance)
            return;
        if (ends.empty() || length(s - ends.back()) > 1e-6 * (box.width() + box.height())) ends.push_back(s);
    };
    if (gamma != 0)
        for (const double x : {box.min.x, box.max.x}) add({x, -(alpha + beta * x) / gamma});
    if (beta != 0)
        for (const double y : {box.min.y, box.max.y}) add({-(alpha + gamma * y) / beta, y});
    if (ends.size() > 2) ends.resize(2);
    return ends;
}

}  // namespace

Figure impact_bodies_figure(const DrawingContext& context, double room_x, double room_y) {
    return CollisionFigure(context, Moment::before, {room_x, room_y}).draw();
}
Figure impact_after_figure(const DrawingContext& context, double room_x, double room_y) {
    return CollisionFigure(context, Moment::after, {room_x, room_y}).draw();
}

Figure impact_velocities_figure(const DrawingContext& context, double room_x, double room_y) {
    const ImpactSolution& found = solution_of<ImpactSolution>(context);
    const ImpactProblem& problem = problem_of<ImpactProblem>(context);
    VelocityPlane plane(context, "velocities", {lang::impact::velocities_of_the_centres}, {room_x, room_y});
    for (std::size_t i = 0; i < 2; ++i) {
        const ImpactSolution::Body& body = found.bodies.at(i);
        if (body.fixed) continue;
        const BodyColour& colour = context.theme.body(problem.bodies.at(i).body);
        const std::string n = std::to_string(i + 1);
        plane.arrows.push_back(
            {"v_" + n, "{v_" + n + "}", body.before, context.theme.secondary, context.theme.secondary});
        plane.arrows.push_back({"v_" + n + "′", "{v_" + n + "}′", body.after, colour.line, colour.letter});
        RichText change;  // of the velocity, by the impulse; a pivot adds its own
        if (!body.pivot) {
            change = vector_formula(i == 0 ? "{J}" : "−{J}");
            append(change, formula("/{m_" + n + "}"));
        }
        plane.sides.push_back({body.before, body.after, std::move(change)});
    }
    return plane.draw();
}

Figure impact_restitution_figure(const DrawingContext& context, double room_x, double room_y) {
    const ImpactSolution& found = solution_of<ImpactSolution>(context);
    const Theme& theme = context.theme;
    VelocityPlane plane(context, "restitution", {lang::impact::relative_velocity_at_the_contact}, {room_x, room_y});
    const Vector before = found.bodies[0].contact_before - found.bodies[1].contact_before;
    const Vector after = found.bodies[0].contact_after - found.bodies[1].contact_after;
    const Exact square = squared_length(found.normal);
    const auto along = [&](const Vector& v) { return (dot(v, found.normal) / square) * found.normal; };
    plane.arrows.push_back({"u", "{u}", before, theme.secondary, theme.secondary});
    plane.arrows.push_back({"u′", "{u}′", after, theme.body(BodyIndex(1)).line, theme.body(BodyIndex(1)).letter});
    plane.sides.push_back({before, along(before), {}});
    plane.sides.push_back({after, along(after), {}});
    plane.sides.push_back({Vector{}, along(before), found.direct ? RichText{} : formula("{u_n}")});
    plane.sides.push_back(
        {Vector{}, along(after), found.direct || found.slip_after.is_zero() ? RichText{} : formula("{u_n}′")});
    return plane.draw();
}

bool has_routh_figure(const DrawingContext& context) {
    const ImpactSolution& found = solution_of<ImpactSolution>(context);
    return !found.friction.is_zero() && !(found.slip.is_zero() && found.b.is_zero());
}
Figure impact_routh_figure(const DrawingContext& context, double room_x, double room_y) {
    const ImpactSolution& found = solution_of<ImpactSolution>(context);
    const double size = kinegraph::length(found.normal), f = found.friction.to_double();
    XyPlot plot;
    plot.id = "routh";
    const Words caption(lang::impact::routh_diagram_of_impulses);
    plot.caption = one_piece(in(caption, context.language));
    plot.x_name = symbol_of("J_n");
    plot.y_name = symbol_of("J_t");
    plot.x_unit = "N s";
    plot.y_unit = "N s";
    XyCurve path{one_piece(in(Words(lang::impact::path), context.language)), "path", {{0, 0}}};
    Box box;
    for (const ImpactSolution::Phase& phase : found.phases) {
        const Spot at{phase.normal.to_double() * size, phase.tangential.to_double() * size};
        path.values.push_back(at);
        box.include(at);
    }
    const double most = 1.12 * box.max.x,
                 high = std::max({std::abs(box.min.y), std::abs(box.max.y), 0.25 * most * std::min(f, 1.0)}) * 1.25;
    box = rectangle(0, -high, most, high);
    const double a = found.a.to_double(), b = found.b.to_double(), c = found.c.to_double();
    const auto add = [&](const Words& name, const char* id, std::vector<Spot> values) {
        if (values.size() > 1) plot.curves.push_back({one_piece(in(name, context.language)), id, std::move(values)});
    };
    plot.curves.push_back(path);
    // u_n = 0 and u_t = 0, in terms of impulses along unit vectors.
    add({lang::impact::compression}, "compression", clipped(found.approach.to_double() * size, a, b, box));
    add({lang::impact::sticking}, "sticking", clipped(found.slip.to_double() * size, b, c, box));
    const double reach = std::min(most, f > 0 ? high / f : most);
    add({lang::impact::friction}, "friction", {{reach, f * reach}, {0, 0}, {reach, -f * reach}});
    const XyCurve& drawn = plot.curves.front();
    for (std::size_t i = 0; i < found.phases.size(); ++i)
        plot.marks.push_back({0, drawn.values[i + 1],
                              one_piece(std::string(1, static_cast<char>('A' + static_cast<int>(i))), Face::italic)});
    return xy_plot_figure(context, plot, room_x, room_y);
}

}  // namespace kinegraph::render
