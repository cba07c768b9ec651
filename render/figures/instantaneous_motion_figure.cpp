// The instantaneous motion of one body: its points with given and found velocities, and the perpendiculars (or the line
// through the tips) that meet in the centre; if no rigid body can move so, the two projections that show it. Owns what
// is shown; all positions and vectors come from the Solution.
#include <algorithm>
#include <cmath>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/bindings.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/drawn_by.hpp"

namespace kinegraph::render {
namespace {

using namespace drawing;
using Found = InstantaneousMotionFigure::Found;
using Form = Holds::Form;

constexpr double corner_mark = 1.8;      // of the mark of a right angle, mm
constexpr double longest_velocity = 34;  // mm
constexpr double shortest_drawn = 0.2;   // mm; shorter velocities would not be seen

/// A velocity, drawn as an arrow at its point.
struct VelocityArrow {
    PointIndex point = none;
    std::string name;
    Spot tip;  ///< relative to the point, in the unit of velocity, y downwards
    double value = 0;
    bool given = false;
};

/// The content of the figure, independent of its scale.
class InstantaneousMotionScene {
public:
    explicit InstantaneousMotionScene(const DrawingContext& context)
        : context_(context),
          solution_(context.solution),
          act_(*context.solution.instantaneous_motion),
          unit_(context.solution.mechanism.units.velocity) {
        for (const InstantCentre& centre : solution_.centres)
            if (centre.first == frame && centre.second == act_.body) centre_ = &centre;
        const auto add = [&](PointIndex point, const Vector& velocity, bool given) {
            const std::string& name = solution_.mechanism.points[at_index(point)].name;
            const Vector in_unit{velocity.x / unit_.si, velocity.y / unit_.si};
            shown_.push_back({point, name, paper_spot(in_unit), kinegraph::length(in_unit), given});
            longest_ = std::max(longest_, shown_.back().value);
        };
        const std::vector<GivenMotion>& given = solution_.mechanism.motion->velocities;
        for (const GivenMotion& each : given) {
            if (const auto* vector = std::get_if<Vector>(&each.value)) {
                add(each.point, *vector, true);
            } else {
                directions_.emplace_back(each.point,
                                         paper_direction(direction_of(std::get<Bearing>(each.value), solution_.pose)));
            }
        }
        for (const PointMotion& motion : solution_.points) {
            const bool already = std::any_of(shown_.begin(), shown_.end(),
                                             [&](const VelocityArrow& shown) { return shown.point == motion.point; });
            if (motion.point != none && motion.velocity && !already) add(motion.point, *motion.velocity, false);
        }
    }

    double longest() const { return longest_; }
    /// The centre if it is finite and near, so that the figure must include it.
    std::optional<Spot> centre_near(const Box& mechanism) const {
        if (centre_ == nullptr || !centre_->at || centre_->at->at_infinity()) return std::nullopt;
        const Spot at = paper_spot(centre_->at->place());
        const double size = std::max(mechanism.width(), mechanism.height());
        if (!contains(grown(mechanism, 1.2 * size), at)) return std::nullopt;
        return at;
    }

protected:
    Pen thin() const { return {context_.theme.thin, context_.theme.secondary, {}, false}; }
    static Spot tip_of(const Sketch& sketch, const VelocityArrow& shown, double scale) {
        return sketch.spot(shown.point) + (1 / scale) * shown.tip;
    }
    /// The name of the place of that tip.
    std::string tip_of(PointIndex point, const Sketch& sketch, double scale) const {
        return tip_binding(point_binding(point), velocity_binding(point),
                           scale * unit_.si.to_double() / sketch.scale());
    }
    const VelocityArrow* shown_at(PointIndex point) const {
        for (const VelocityArrow& shown : shown_)
            if (shown.point == point) return &shown;
        return nullptr;
    }
    /// The unit vector of a point's velocity or of its given line; empty if the point is at rest.
    std::optional<Spot> direction_at(PointIndex point) const {
        for (const auto& [at, along] : directions_)
            if (at == point) return along;
        const VelocityArrow* const shown = shown_at(point);
        if (shown == nullptr || !(length(shown->tip) > 0)) return std::nullopt;
        return unit(shown->tip);
    }
    /// None if the velocity is given or no statement finds it.
    StatementIndex statement_of(const VelocityArrow& shown) const {
        return shown.given ? none : statement_of_motion(solution_, Quantity::Kind::velocity, act_.body, shown.point);
    }

    const DrawingContext& context_;
    const Solution& solution_;
    const InstantaneousMotionFigure& act_;
    const Unit& unit_;
    const InstantCentre* centre_ = nullptr;
    std::vector<VelocityArrow> shown_;
    std::vector<std::pair<PointIndex, Spot>> directions_;
    double longest_ = 0;  ///< in the unit of velocity
};

/// The centre with its construction: perpendiculars to the velocities or the line through their tips, its name, and ω
/// about it.
class CentreOfMotion : InstantaneousMotionScene {
public:
    explicit CentreOfMotion(const InstantaneousMotionScene& scene) : InstantaneousMotionScene(scene) {}

    void draw(Sketch& sketch, double scale) const {
        if (centre_ == nullptr || !centre_->at) return;
        if (centre_->at->at_infinity()) return draw_parallels(sketch);
        const Spot at = sketch.spot(centre_->at->place());
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;  // out of the range of doubles
        const bool near = centre_near(unscaled_box(sketch)).has_value();
        const std::size_t join = sketch.construction.size();
        if (act_.found == Found::tips) draw_join_of_tips(sketch, at, near, scale);
        belong(sketch.construction, join, act_.centre_statement);
        std::vector<Spot> far_ends;
        for (const PointIndex point : indices_of(solution_.mechanism.points)) {
            const bool by = std::find(act_.points.begin(), act_.points.end(), point) != act_.points.end();
            const bool carried =
                std::any_of(solution_.points.begin(), solution_.points.end(),
                            [&](const PointMotion& motion) { return motion.point == point && motion.velocity; });
            if (!by && !carried) continue;
            const std::size_t ray = sketch.construction.size();
            if (act_.found != Found::tips || !by) draw_ray(sketch, point, at, near, by, far_ends);
            // Rays that found the centre appear with it; any other one appears with the velocity that is normal to it.
            const VelocityArrow* const shown = by ? nullptr : shown_at(point);
            belong(sketch.construction, ray, std::max(act_.centre_statement, shown ? statement_of(*shown) : none));
        }
        if (!near) return name_far_centre(sketch, at, far_ends);
        draw_dot(sketch, at);
        draw_spin(sketch, at);
    }

private:
    static Box unscaled_box(const Sketch& sketch) {
        const Box box = sketch.mechanism_box();
        return {sketch.scale() * box.min, sketch.scale() * box.max};
    }

    /// From a point to the centre, slightly beyond it if the ray found it; if the centre is far, to the edge of the
    /// drawing.
    void draw_ray(Sketch& sketch, PointIndex point, Spot centre, bool near, bool found_it,
                  std::vector<Spot>& far_ends) const {
        const Spot from = sketch.spot(point);
        const double whole = length(centre - from);
        if (!(whole > 2 * same_place)) return;
        const Spot along = unit(centre - from);
        const auto velocity = direction_at(point);
        if (velocity && whole > 3 * corner_mark && found_it) {
            const Spot r = corner_mark * along, v = corner_mark * *velocity;
            sketch.construction.emplace_back(polyline({from + r, from + r + v, from + v}, thin()));
            hang(sketch.construction, sketch.construction.size() - 1, toward_centre(point));
        }
        if (near) {
            sketch.construction.emplace_back(line(from, centre + (found_it ? overshoot : 0.0) * along, thin()));
            hang(sketch.construction, sketch.construction.size() - 1,
                 {Form::segment, {point_binding(point), of_centre()}, found_it ? overshoot : 0.0});
        } else if (found_it) {
            const Interval seen = within(grown(sketch.mechanism_box(), 14), from, along);
            const Spot to = from + std::min(whole, std::max(seen.to, 10.0)) * along;
            draw_arrow(sketch.construction, from, to, context_.theme.thin, context_.theme.secondary);
            hang(sketch.construction, sketch.construction.size() - 2, toward_centre(point));
            far_ends.push_back(to);
        }
    }

    static std::string of_centre() { return instantaneous_binding("centre"); }
    static Holds toward_centre(PointIndex point) {
        return {Form::with, {point_binding(point), point_binding(point), of_centre()}};
    }

    /// The lines through the tips and through the points, both to the centre.
    void draw_join_of_tips(Sketch& sketch, Spot centre, bool near, double scale) const {
        Spot first, second;
        Spot* const ends[2] = {&first, &second};
        for (std::size_t i = 0; i < 2; ++i) *ends[i] = sketch.spot(act_.points[i]);
        Spot tips[2];
        for (std::size_t i = 0; i < 2; ++i) {
            const VelocityArrow* const shown = shown_at(act_.points[i]);
            KG_ASSERT(shown, "velocities that give the centre are shown");
            tips[i] = tip_of(sketch, *shown, scale);
        }
        const std::string a = point_binding(act_.points[0]), b = point_binding(act_.points[1]);
        draw_through(sketch, {first, second}, centre, near);
        hang(sketch.construction, sketch.construction.size() - 1, {Form::through, {a, a, b}});
        const std::string tip = tip_of(act_.points[0], sketch, scale);
        draw_through(sketch, {tips[0], tips[1]}, centre, near);
        hang(sketch.construction, sketch.construction.size() - 1,
             {Form::through, {tip, tip, tip_of(act_.points[1], sketch, scale)}});
    }

    /// A line through two points and, if it is near, the centre.
    void draw_through(Sketch& sketch, const Bar& bar, Spot centre, bool near) const {
        const Spot along = unit(bar.to - bar.from);
        double from = 0, to = length(bar.to - bar.from);
        if (near) {
            const double t = dot(centre - bar.from, along);
            from = std::min(from, t);
            to = std::max(to, t);
        } else {
            const Interval seen = within(grown(sketch.mechanism_box(), longest_velocity), bar.from, along);
            if (dot(centre - bar.from, along) > 0)
                to = std::max(to, seen.to);
            else
                from = std::min(from, seen.from);
        }
        constexpr double beyond = 5;
        sketch.construction.emplace_back(
            line(bar.from + (from - beyond) * along, bar.from + (to + beyond) * along, thin()));
    }

    void draw_parallels(Sketch& sketch) const {
        const Spot towards = paper_direction(centre_->at->place());
        constexpr double reach = 22;
        const std::size_t first = sketch.construction.size();
        Spot end;
        for (const PointIndex point : act_.points) {
            const Spot from = sketch.spot(point);
            const auto velocity = direction_at(point);
            end = from + reach * towards;
            const std::size_t own = sketch.construction.size();
            if (velocity) {
                const Spot r = corner_mark * towards, v = corner_mark * *velocity;
                sketch.construction.emplace_back(polyline({from + r, from + r + v, from + v}, thin()));
            }
            draw_arrow(sketch.construction, from, end, context_.theme.thin, context_.theme.secondary);
            hang(sketch.construction, own, {Form::with, {point_binding(point), velocity_binding(point)}});
        }
        belong(sketch.construction, first, act_.centre_statement);
        LabelRequest label = name_of_centre(sketch);
        label.anchor = end;
        label.clearance = 1.2;
        sketch.labels.push_back(std::move(label));
    }

    void draw_dot(Sketch& sketch, Spot at) const {
        const std::vector<Body>& bodies = solution_.mechanism.bodies;
        LabelRequest label = name_of_centre(sketch);
        GroupBegin group{"centre",
                         sketch.id("centre", bodies[0].name + "." + bodies[at_index(act_.body)].name),
                         plain(label.text),
                         {},
                         act_.centre_statement,
                         Holds{Form::at, {of_centre()}}};
        group.cited_as = label.names.front();
        sketch.centres.emplace_back(std::move(group));
        sketch.centres.emplace_back(tinted(disc(at, 1.15, context_.theme.paper)));
        sketch.centres.emplace_back(disc(at, 0.8, context_.theme.text));
        sketch.centres.emplace_back(GroupEnd{});
        label.holds = {Form::at, {of_centre()}};
        label.anchor = at;
        label.clearance = 1.7;
        sketch.labels.push_back(std::move(label));
    }

    LabelRequest name_of_centre(const Sketch& sketch) const {
        LabelRequest label;
        label.text = typeset(symbol_of(sketch.mechanism, *centre_), context_.language);
        label.statement = act_.centre_statement;
        label.names = {name_of(symbol_of(sketch.mechanism, *centre_))};
        label.size = context_.theme.label;
        label.colour = context_.theme.text;
        return label;
    }

    /// Text such as "P_02  (A P_02 = 3.4 m)" for a centre outside the drawing.
    void name_far_centre(Sketch& sketch, Spot centre, const std::vector<Spot>& ends) const {
        const PointIndex from = act_.points.empty() ? none : act_.points.front();
        LabelRequest label = name_of_centre(sketch);
        if (from == none) return;
        const Unit& length_unit = solution_.mechanism.units.length;
        const double metres = length(centre - sketch.spot(from)) * sketch.scale();
        const RichText name = label.text;
        append(label.text, one_piece("  ("));
        append(label.text, typeset(Symbol{Symbol::Letter::point, solution_.mechanism.points[at_index(from)].name, ""},
                                   context_.language));
        append(label.text, name);
        const std::string value = number(metres / length_unit.si.to_double(), 3, context_.language);
        append(label.text, with_powers(" = " + value + " " + length_unit.symbol + ")"));
        label.anchor = ends.empty() ? sketch.spot(from) : ends.front();
        label.clearance = ends.empty() ? 6 : 1.2;
        sketch.labels.push_back(std::move(label));
    }

    /// ω as an arc about the centre, with its value.
    void draw_spin(Sketch& sketch, Spot at) const {
        const auto& omega = solution_.bodies[at_index(act_.body)].omega;
        if (!omega || omega->is_zero()) return;
        constexpr double radius = 6, half = 0.75;
        // On the side away from the mechanism, where there are no rays.
        const Box box = sketch.mechanism_box();
        const Spot away = unit(at - 0.5 * (box.min + box.max));
        const double middle = nearest::atan2(away.y, away.x);
        // Counter-clockwise is towards decreasing angles on paper.
        const double turn = omega->sign() > 0 ? -half : half;
        const BodyColour body = context_.theme.body(act_.body);
        const Symbol symbol{Symbol::Letter::omega, solution_.mechanism.bodies[at_index(act_.body)].name, ""};
        const StatementIndex statement =
            std::max(act_.centre_statement, statement_of_turning(solution_, omega_of(act_.body)));
        const std::size_t first = sketch.arrows.size();
        draw_arc_arrow(sketch.arrows, at, radius, middle - turn, middle + turn, context_.theme.outline, body.letter);
        belong(sketch.arrows, first, statement);
        const Holds held{Form::couple, {of_centre(), instantaneous_binding("omega")}};
        hang(sketch.arrows, first, held);
        const Unit& unit_of = solution_.mechanism.units.angular_velocity;
        LabelRequest label;
        label.statement = statement;
        label.text = typeset(symbol, context_.language);
        const std::string value = number((*omega / unit_of.si).to_double(), 3, context_.language);
        append(label.text, with_powers(" = " + value + " " + unit_of.symbol));
        label.size = context_.theme.label;
        label.colour = body.letter;
        label.anchor = at + radius * away;
        label.clearance = 1.5;
        label.holds = held;
        label.holds.unit = unit_of.si.to_double();
        sketch.labels.push_back(std::move(label));
    }
};

class InstantaneousMotionDrawing : public InstantaneousMotionScene {
public:
    using InstantaneousMotionScene::InstantaneousMotionScene;

    void draw(Sketch& sketch, double velocity_scale) const {
        draw_alone(sketch, act_.body);
        draw_directions(sketch);
        CentreOfMotion(*this).draw(sketch, velocity_scale);
        draw_projections(sketch, velocity_scale);
        // The construction crosses the body and must be visible above it.
        std::swap(sketch.construction, sketch.over_bodies);
        draw_velocities(sketch, velocity_scale);
        draw_acceleration_centre(sketch);
        name_points(sketch);
    }

private:
    /// Lines of action given in the file.
    void draw_directions(Sketch& sketch) const {
        constexpr double half = 15;
        for (const auto& [point, along] : directions_) {
            const Spot at = sketch.spot(point);
            sketch.construction.emplace_back(line(at - half * along, at + half * along,
                                                  {context_.theme.thin, context_.theme.text, dash_dot(), false}));
            hang(sketch.construction, sketch.construction.size() - 1, {Form::at, {point_binding(point)}});
        }
    }

    void draw_velocities(Sketch& sketch, double scale) const {
        const Theme& theme = context_.theme;
        const BodyColour body = theme.body(act_.body);
        for (const VelocityArrow& shown : shown_) {
            const Spot at = sketch.spot(shown.point), tip = tip_of(sketch, shown, scale);
            if (length(tip - at) < shortest_drawn) continue;
            const Symbol symbol{Symbol::Letter::v, shown.name, ""};
            const std::string name = name_of(symbol);
            const RichText text = typeset(symbol, context_.language);
            const std::size_t first = sketch.arrows.size();
            const Holds held = arrow_between(point_binding(shown.point), tip_of(shown.point, sketch, scale));
            sketch.arrows.emplace_back(GroupBegin{"velocity",
                                                  sketch.id("mechanism", name),
                                                  plain(text),
                                                  {{"data-name", name},
                                                   {"data-value", shortest(shown.value)},
                                                   {"data-scale", shortest(scale)},
                                                   {"data-unit", unit_.symbol}},
                                                  none,
                                                  held});
            sketch.arrows.emplace_back(Axis{at, tip});
            draw_arrow(sketch.arrows, at, tip, theme.vector, shown.given ? theme.text : body.line);
            sketch.arrows.emplace_back(GroupEnd{});
            belong(sketch.arrows, first, statement_of(shown));
            LabelRequest request;
            request.statement = statement_of(shown);
            request.names = {name};
            request.text = text;
            request.size = theme.equation;
            request.colour = shown.given ? theme.text : body.letter;
            request.anchor = at + 0.62 * (tip - at);
            request.toward = tip;
            request.clearance = 1.6;
            request.holds = held;
            sketch.labels.push_back(std::move(request));
        }
    }

    void draw_acceleration_centre(Sketch& sketch) const {
        if (!act_.acceleration_centre) return;
        const Spot at = sketch.spot(*act_.acceleration_centre);
        if (!contains(grown(sketch.mechanism_box(), 0.6 * sketch.size()), at)) return;
        const Theme& theme = context_.theme;
        sketch.centres.emplace_back(ring(at, 1.0, theme.paper, {theme.outline, theme.text, {}, false}));
        LabelRequest label;
        label.statement = act_.acceleration_centre_statement;
        belong(sketch.centres, sketch.centres.size() - 1, label.statement);
        label.holds = {Form::at, {instantaneous_binding("acceleration")}};
        hang(sketch.centres, sketch.centres.size() - 1, label.holds);
        label.text = typeset(Symbol{Symbol::Letter::point, act_.acceleration_centre_name, ""}, context_.language);
        append(label.text, one_piece(" ("));
        append(label.text, typeset(Symbol{Symbol::Letter::a, act_.acceleration_centre_name, ""}, context_.language));
        append(label.text, one_piece(" = 0)"));
        label.size = theme.label;
        label.colour = theme.text;
        label.anchor = at;
        label.clearance = 1.7;
        sketch.labels.push_back(std::move(label));
    }

    /// The projections on the line through both points, as arrows, with the perpendiculars that determine them.
    void draw_projections(Sketch& sketch, double scale) const {
        if (!act_.differing) return;
        const InstantaneousMotionFigure::Projections& differing = *act_.differing;
        const Spot first = sketch.spot(differing.first), second = sketch.spot(differing.second);
        const Spot along = unit(second - first);
        double from = 0, to = length(second - first);
        const Theme& theme = context_.theme;
        const BodyColour accent = theme.body(act_.body);
        const auto draw = [&](PointIndex point, const Vector& projection, const char* held) {
            const std::string own = tip_binding(point_binding(point), instantaneous_binding(held),
                                                scale * unit_.si.to_double() / sketch.scale());
            const Spot at = sketch.spot(point);
            const Vector in_unit{projection.x / unit_.si, projection.y / unit_.si};
            const Spot foot = at + (1 / scale) * paper_spot(in_unit);
            from = std::min(from, dot(foot - first, along));
            to = std::max(to, dot(foot - first, along));
            if (const VelocityArrow* const shown = shown_at(point)) {
                const Spot tip = tip_of(sketch, *shown, scale);
                if (length(tip - foot) > shortest_drawn) {
                    sketch.construction.emplace_back(line(tip, foot, thin()));
                    hang(sketch.construction, sketch.construction.size() - 1,
                         {Form::segment, {tip_of(point, sketch, scale), own}});
                    if (length(tip - foot) > 2 * corner_mark && length(foot - at) > 2 * corner_mark) {
                        const Spot up = corner_mark * unit(tip - foot), back = corner_mark * unit(at - foot);
                        sketch.construction.emplace_back(polyline({foot + up, foot + up + back, foot + back}, thin()));
                    }
                }
            }
            const double value = kinegraph::length(in_unit);
            const std::size_t arrow = sketch.arrows.size();
            if (length(foot - at) > shortest_drawn)
                draw_arrow(sketch.arrows, at, foot, 1.6 * theme.vector, accent.line);
            hang(sketch.arrows, arrow, arrow_between(point_binding(point), own));
            LabelRequest label;
            label.text = one_piece(number(value, 3, context_.language) + " ");
            append(label.text, with_powers(unit_.symbol));
            label.size = theme.label;
            label.colour = accent.letter;
            label.anchor = 0.5 * (at + foot);
            if (length(foot - at) > shortest_drawn) label.toward = foot;
            label.clearance = 1.6;
            sketch.labels.push_back(std::move(label));
        };
        draw(differing.first, *differing.of_first, "first");
        draw(differing.second, *differing.of_second, "second");
        sketch.construction.emplace_back(
            line(first + (from - overshoot) * along, first + (to + overshoot) * along, thin()));
        hang(sketch.construction, sketch.construction.size() - 1, {Form::at, {point_binding(differing.first)}});
    }
};

}  // namespace

Figure instantaneous_motion_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    KG_ASSERT(context.solution.instantaneous_motion, "the figure of an instantaneous motion wants one");
    const Subject subject(context.solution);
    const InstantaneousMotionDrawing act(context);
    const Mechanism& mechanism = context.solution.mechanism;
    Box extent = subject.box;
    if (const auto centre = act.centre_near(subject.box)) {
        extent.min = {std::min(extent.min.x, centre->x), std::min(extent.min.y, centre->y)};
        extent.max = {std::max(extent.max.x, centre->x), std::max(extent.max.y, centre->y)};
    }
    const double first = choose_scale(extent.width(), extent.height(), std::max(room_x - 24, 10.0),
                                      std::max(room_y - 30, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, "");
        const double reach = std::clamp(0.55 * sketch.size(), 14.0, longest_velocity);
        const double velocity_scale = choose_scale(act.longest(), 0, reach, reach, std::nullopt);
        act.draw(sketch, velocity_scale);
        Figure figure = sketch.finish(begun(context, {FigureKind::mechanism}), "m");
        figure.caption = one_piece(word(lang::sheet::instantaneous_motion, context.language));
        if (act.longest() > 0)
            figure.further_scale =
                "1 mm ≙ " + shortest(velocity_scale, context.language) + " " + mechanism.units.velocity.symbol;
        sketch.close(figure, {room_x, room_y}, trial.last || trial.asked, trial.scale, mechanism.units.length,
                     trial.strict);
        return figure;
    });
}

}  // namespace kinegraph::render
