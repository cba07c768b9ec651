#include "problems/hertz/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/hertz.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/figures/xy_plot.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using std::numbers::pi;

/// The profile of a body: its curvature in the plane of the figure (1/m, positive towards the other body), and its
/// names.
struct Profile2d {
    std::size_t which = 0;
    double curvature = 0;
};

class TouchingBodiesFigure {
public:
    TouchingBodiesFigure(const DrawingContext& context, Spot room)
        : context_(context), theme_(context.theme), problem_(problem_of<HertzProblem>(context)), room_(room) {
        for (std::size_t i = 0; i < 2; ++i) profiles_.at(i) = {i, curvature(i)};
        // The more convex body is on top: a ball on a plane or in a groove.
        if (profiles_[1].curvature > profiles_[0].curvature) std::swap(profiles_[0], profiles_[1]);
        // Rounding errors of Euler's theorem are no curvature.
        for (Profile2d& each : profiles_)
            if (std::abs(each.curvature) < 1e-12 * std::abs(profiles_[0].curvature)) each.curvature = 0;
        half_width_ = 0.5 * room_.x - 14;
        const double high = room_.y - 2 * arrow_ - 4;
        below_ = profiles_[1].curvature == 0 ? flat_depth_ : 0.4 * high;
        const double radius = 1 / profiles_[0].curvature;
        scale_ = choose_scale(2 * radius, 2 * radius, high - below_, high - below_, std::nullopt);
        top_ = 2 * radius / scale_;
    }

    Figure draw() {
        const Words caption = problem_.at && problem_.at->meshes ? Words(lang::hertz::flanks_at_the_pitch_point)
                                                                 : Words(lang::hertz::bodies_in_contact);
        Figure figure = begun("contact", "contact", caption, scale_, "m", context_.language);
        for (std::size_t i = 0; i < 2; ++i) draw_body(figure, profiles_.at(i), i == 0 ? -1 : 1);
        figure.marks.emplace_back(
            line({0, -top_ - 4}, {0, bottom_ + 4}, {theme_.thin, theme_.secondary, dash_dot(), false}));
        figure.marks.emplace_back(disc({0, 0}, 0.7, theme_.text));
        draw_force(figure, {0, -top_ - arrow_}, {0, -top_});
        draw_force(figure, {0, bottom_ + arrow_}, {0, bottom_});
        figure.by_load = 0;
        return finished(std::move(figure), context_, room_);
    }

private:
    /// In the plane across the shorter axis. If the principal planes are rotated, by Euler's theorem for the first
    /// radius of the first body.
    double curvature(std::size_t i) const {
        const HertzBody& body = problem_.bodies.at(i);
        const double first = body.curvature(0).to_double(), second = body.curvature(1).to_double();
        if (i == 0 || problem_.line) return first;
        const double c = nearest::cos(problem_.turn.to_double());
        return first * c * c + second * (1 - c * c);
    }

    /// The boundary from left to right, mm; `down`: +1 for the lower body, whose material is below.
    std::vector<Spot> profile(double curvature, int down, double depth) const {
        std::vector<Spot> spots;
        const double radius = curvature == 0 ? 0 : 1 / (std::abs(curvature) * scale_);
        if (curvature == 0) return {{-half_width_, 0}, {half_width_, 0}};
        // Limited by height and width of the room; the whole circle if it fits.
        const double most = std::min(half_width_, radius);
        double angle = most < radius ? nearest::asin(most / radius) : pi / 2;
        if (curvature > 0 && 2 * radius <= depth + 1e-9)
            angle = pi;
        else if (radius * (1 - nearest::cos(angle)) > depth)
            angle = nearest::acos(std::max(-1.0, 1 - depth / radius));
        const int bulge = curvature > 0 ? down : -down;  // direction of its centre
        constexpr int pieces = 96;
        for (int i = 0; i <= pieces; ++i) {
            const double turn = angle * (2.0 * i / pieces - 1);
            spots.push_back({radius * nearest::sin(turn), bulge * radius * (1 - nearest::cos(turn))});
        }
        return spots;
    }

    void draw_body(Figure& figure, const Profile2d& of, int down) {
        const HertzBody& body = problem_.bodies.at(of.which);
        const BodyColour& colour = theme_.body(body.body);
        const double depth = down < 0 ? top_ : below_;
        const std::vector<Spot> edge = profile(of.curvature, down, of.curvature < 0 ? below_ - flat_depth_ : depth);
        double reach = 0;
        for (const Spot& spot : edge) reach = std::max(reach, down * spot.y);
        const bool whole = of.curvature > 0 && length(edge.front() - edge.back()) < 1e-6;
        // Flat and concave bodies have some material behind the deepest point.
        const double behind = down * (of.curvature > 0 ? reach : flat_depth_);
        std::vector<Spot> area = edge;
        if (!whole) {
            area.push_back({edge.back().x, behind});
            area.push_back({edge.front().x, behind});
        }
        figure.marks.emplace_back(GroupBegin{"link", GroupId("contact", legal_id(name(of))), name(of), {}, none});
        figure.marks.emplace_back(tinted(filled(area, colour.tint)));
        figure.marks.emplace_back(polyline(edge, {2 * theme_.outline, colour.line, {}, true}));
        figure.marks.emplace_back(GroupEnd{});
        if (down > 0) bottom_ = std::max(behind, 0.0);
        if (down < 0) top_ = std::max(of.curvature > 0 ? reach : flat_depth_, flat_depth_);
        label_body(figure, of, down, edge);
    }
    std::string name(const Profile2d& of) const {
        return context_.solution.mechanism.body(problem_.bodies.at(of.which).body).name;
    }

    void label_body(Figure& figure, const Profile2d& of, int down, const std::vector<Spot>& edge) {
        const BodyColour& colour = theme_.body(problem_.bodies.at(of.which).body);
        const std::string number = std::to_string(of.which + 1);
        const Spot aside = edge[edge.size() * (of.curvature > 0 ? 11 : 12) / 14];
        const Words called_so = called(context_.solution.mechanism.body(problem_.bodies.at(of.which).body));
        figure.labels.push_back({.text = one_piece(in(called_so, context_.language)),
                                 .size = theme_.label,
                                 .colour = colour.letter,
                                 .anchor = of.curvature == 0 ? Spot{0.7 * half_width_, down * 3.5} : aside,
                                 .clearance = 1.5});
        if (of.curvature == 0) return;
        // The radius as an arrow to the profile, from the centre or from the edge of the room.
        const double radius = 1 / (std::abs(of.curvature) * scale_);
        const int bulge = of.curvature > 0 ? down : -down;
        const Spot foot = edge[edge.size() / 4];
        const Spot centre{0, bulge * radius};
        const Spot away = unit(centre - foot);
        const double shown = std::min(radius, of.curvature > 0 ? std::max(12.0, 0.5 * below_) : 12.0);
        const Spot from = foot + shown * away;
        if (shown >= radius)
            figure.marks.emplace_back(ring(centre, 0.9, theme_.paper, {theme_.outline, colour.line, {}, false}));
        draw_arrow(figure.marks, from, foot, theme_.thin, theme_.text);
        RichText words = formula(
            "{r_" + number + "} = " +
            amount(radius * scale_, QuantityKind::length, context_.solution.mechanism.units, context_.language));
        // Of a body whose principal planes are turned against the figure it is neither of its given radii.
        if (of.which == 1 && !problem_.line && !problem_.turn.is_zero())
            append(words, one_piece(" " + in(Words(lang::hertz::in_this_plane), context_.language)));
        figure.labels.push_back({.text = std::move(words),
                                 .size = theme_.derived,
                                 .colour = theme_.text,
                                 .anchor = 0.5 * (from + foot),
                                 .toward = foot,
                                 .clearance = 1.5});
    }

    void draw_force(Figure& figure, Spot tail, Spot tip) {
        draw_arrow(figure.marks, tail, tip, theme_.vector, theme_.text);
        figure.labels.push_back({.text = vector_formula("{Q}"),
                                 .size = theme_.label,
                                 .colour = theme_.text,
                                 .anchor = 0.5 * (tail + tip),
                                 .toward = tip,
                                 .clearance = 1.5});
    }

    static constexpr double arrow_ = 11, flat_depth_ = 7;
    const DrawingContext& context_;
    const Theme& theme_;
    const HertzProblem& problem_;
    Spot room_;
    std::array<Profile2d, 2> profiles_{};
    double half_width_ = 0, below_ = 0, scale_ = 1;
    double top_ = 0, bottom_ = 0;
};

class PressureFigure {
public:
    PressureFigure(const DrawingContext& context, Spot room)
        : context_(context),
          theme_(context.theme),
          found_(solution_of<HertzSolution>(context)),
          units_(context.solution.mechanism.units) {
        // The longer axis of an ellipse, or the width of a line contact, is horizontal.
        half_ = std::max(found_.a, found_.b);
        const double plan = found_.a > 0 ? 2 * found_.b : 0.8 * half_;
        const double high = 0.34 * room.y;
        scale_ = choose_scale(2 * half_, plan, room.x - 34, room.y - high - 17, std::nullopt);
        pressure_unit_ = suitable_unit(found_.greatest, QuantityKind::pressure, units_);
        pressure_scale_ = choose_scale(found_.greatest / pressure_unit_.si.to_double(), 0, high, 1, std::nullopt);
        room_ = room;
        strip_ = plan / scale_ / 2;
    }

    Figure draw() {
        const Words caption(lang::hertz::pressure_and_plan_of_the_contact);
        Figure figure = begun("pressure", "pressure", caption, scale_, "m", context_.language);
        figure.further_scale = "1 mm ≙ " + shortest(pressure_scale_, context_.language) + " " + pressure_unit_.symbol;
        const double half = half_ / scale_, high = pressure(1);
        draw_arch(figure, half, high);
        draw_heights(figure, half, high);
        draw_plan(figure, half);
        figure.by_load = found_.a > 0 ? 1.0 / 3 : 0.5;
        return finished(std::move(figure), context_, room_);
    }

private:
    double pressure(double share) const {
        return share * found_.greatest / pressure_unit_.si.to_double() / pressure_scale_;
    }
    Pen thin() const { return {theme_.thin, theme_.secondary, {}, false}; }

    void draw_arch(Figure& figure, double half, double high) {
        std::vector<Spot> arch;
        constexpr int pieces = 96;
        for (int i = 0; i <= pieces; ++i) {
            const double angle = pi * i / pieces;
            arch.push_back({-half * nearest::cos(angle), -high * nearest::sin(angle)});
        }
        const BodyColour& colour = theme_.body(BodyIndex(1));
        figure.marks.emplace_back(tinted(filled(arch, colour.tint)));
        // The pressure: arrows from the curve down to the contact area.
        for (int i = -3; i <= 3; ++i) {
            if (i == 0) continue;
            const double x = 0.27 * i * half, y = high * std::sqrt(1 - 0.27 * 0.27 * i * i);
            draw_arrow(figure.marks, {x, -y}, {x, 0}, theme_.thin, colour.line);
        }
        figure.marks.emplace_back(polyline(arch, {theme_.vector, colour.line, {}, true}));
        figure.marks.emplace_back(line({-half - 8, 0}, {half + 8, 0}, {theme_.outline, theme_.text, {}, false}));
    }

    void draw_heights(Figure& figure, double half, double high) {
        figure.marks.emplace_back(GroupBegin{"vector",
                                             GroupId("pressure", "p_0"),
                                             "p_0",
                                             {{"data-name", "p_0"},
                                              {"data-value", shortest(found_.greatest)},
                                              {"data-scale", shortest(pressure_scale_ * pressure_unit_.si.to_double())},
                                              {"data-unit", "Pa"}},
                                             none});
        figure.marks.emplace_back(Axis{{0, -high}, {0, 0}});
        draw_arrow(figure.marks, {0, -high}, {0, 0}, theme_.vector, theme_.text);
        figure.marks.emplace_back(GroupEnd{});
        name(figure, "{p_0} = ", found_.greatest, {0, -high}, std::nullopt);
        const double mean = pressure(found_.mean / found_.greatest);
        figure.marks.emplace_back(line({-half, -mean}, {half + 5, -mean}, {theme_.thin, theme_.text, dashes(), false}));
        name(figure, "{p_m} = ", found_.mean, {half + 4, -mean}, std::nullopt);
    }
    void name(Figure& figure, const std::string& symbol, double si, Spot anchor, std::optional<Spot> toward,
              QuantityKind kind = QuantityKind::pressure) {
        figure.labels.push_back({.text = formula(symbol + amount(si, kind, units_, context_.language)),
                                 .size = theme_.derived,
                                 .colour = theme_.text,
                                 .anchor = anchor,
                                 .toward = toward,
                                 .clearance = 1.4});
    }

    /// The contact area; for a line contact a piece of it with break lines at both ends.
    void draw_plan(Figure& figure, double half) {
        const Spot middle{0, 9 + strip_};
        const BodyColour& colour = theme_.body(BodyIndex(1));
        std::vector<Spot> outline;
        if (found_.a > 0) {
            constexpr int pieces = 120;
            for (int i = 0; i < pieces; ++i) {
                const double angle = 2 * pi * i / pieces;
                outline.push_back(middle + Spot{half * nearest::cos(angle), strip_ * nearest::sin(angle)});
            }
        } else {
            outline = corners_about(middle, {half, 0}, {0, strip_});
        }
        figure.marks.emplace_back(tinted(filled(outline, colour.tint)));
        if (found_.a > 0) {
            figure.marks.emplace_back(polyline(outline, {theme_.outline, colour.line, {}, true}, true));
        } else {
            for (const double side : {-1.0, 1.0})
                figure.marks.emplace_back(line(middle + Spot{side * half, -strip_}, middle + Spot{side * half, strip_},
                                               {theme_.outline, colour.line, {}, true}));
        }
        const Pen axis{theme_.thin, theme_.secondary, dash_dot(), false};
        figure.marks.emplace_back(line({-half - 4, middle.y}, {half + 4, middle.y}, axis));
        figure.marks.emplace_back(line({0, middle.y - strip_ - 3}, {0, middle.y + strip_ + 3}, axis));
        for (const double side : {-1.0, 1.0})
            figure.marks.emplace_back(line({side * half, 0}, {side * half, middle.y}, thin()));
        draw_dimensions(figure, middle, half);
    }
    void draw_dimensions(Figure& figure, Spot middle, double half) {
        const auto dimension = [&](const std::string& symbol, double si, Spot end) {
            draw_arrow(figure.marks, middle, end, theme_.outline, theme_.text);
            name(figure, symbol, si, 0.5 * (middle + end), end, QuantityKind::length);
        };
        if (found_.a == 0) {
            dimension("{b} = ", found_.b, middle + Spot{half, 0});
        } else {
            dimension("{a} = ", found_.a, middle + Spot{half, 0});
            if (found_.elliptic) dimension("{b} = ", found_.b, middle + Spot{0, strip_});
        }
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const HertzSolution& found_;
    const Units& units_;
    Spot room_;
    double half_ = 0, scale_ = 1, pressure_scale_ = 1, strip_ = 0;
    Unit pressure_unit_;
};

}  // namespace

Figure hertz_bodies_figure(const DrawingContext& context, double room_x, double room_y) {
    return TouchingBodiesFigure(context, {room_x, room_y}).draw();
}
Figure hertz_pressure_figure(const DrawingContext& context, double room_x, double room_y) {
    return PressureFigure(context, {room_x, room_y}).draw();
}

Figure hertz_stress_figure(const DrawingContext& context, double room_x, double room_y) {
    const HertzSolution& found = solution_of<HertzSolution>(context);
    const Units& units = context.solution.mechanism.units;
    const Unit stress = suitable_unit(found.greatest, QuantityKind::pressure, units);
    const Unit depth = suitable_unit(found.depth, QuantityKind::length, units);
    const double per_stress = stress.si.to_double(), per_depth = depth.si.to_double();
    XyPlot plot;
    plot.id = "stresses";
    const Words caption(lang::hertz::stresses_below_the_middle);
    plot.caption = one_piece(in(caption, context.language));
    plot.x_name = symbol_of("z");
    plot.x_unit = depth.symbol;
    plot.y_unit = stress.symbol;
    const auto add = [&](const char* name, double HertzSolution::Stress::*part) {
        XyCurve curve{symbol_of(name), name, {}};
        for (const HertzSolution::Stress& each : found.stresses)
            curve.values.push_back({each.z / per_depth, each.*part / per_stress});
        plot.curves.push_back(std::move(curve));
    };
    add("σ_z", &HertzSolution::Stress::along_z);
    const bool round = found.a > 0 && !found.elliptic;
    add(round ? "σ_r" : "σ_y", &HertzSolution::Stress::along_y);
    if (!round) add("σ_x", &HertzSolution::Stress::along_x);
    add("τ", &HertzSolution::Stress::shear);
    const std::size_t last = plot.curves.size() - 1;
    RichText words = formula("{τ_max} = " + amount(found.shear, QuantityKind::pressure, units, context.language));
    plot.marks.push_back({last, {found.depth / per_depth, found.shear / per_stress}, std::move(words)});
    return xy_plot_figure(context, plot, room_x, room_y);
}

}  // namespace kinegraph::render
