// The mechanism to scale, and the velocities on it: which layers, at which scale, within which room. Takes every place from the
// Solution and computes no mechanics.
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/assert.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/drawn_by.hpp"

namespace kinegraph::render {

namespace drawing {

Figure Sketch::finish(std::string kind, std::string figure_id, std::string unit_name) {
    Figure figure;
    figure.kind = std::move(kind);
    figure.id = std::move(figure_id);
    figure.scale = scale_;
    figure.unit = std::move(unit_name);
    // Each layer is a group that says what role its marks play; links, joints, centres and vectors have groups of their own
    // within.
    struct Layer {
        const char* role;
        std::vector<Mark>& marks;
    };
    for (const auto& [role, marks] : {Layer{"tint", tints}, Layer{"construction", construction}, Layer{"ground", ground},
                                      Layer{"links", bodies}, Layer{"construction", over_bodies}, Layer{"joints", pins},
                                      Layer{"arrows", arrows}, Layer{"centres", centres}, Layer{"dimensions", dimensions}}) {
        if (marks.empty()) continue;
        figure.marks.emplace_back(GroupBegin{role, {}, {}, {}});
        for (Mark& mark : marks) figure.marks.push_back(std::move(mark));
        figure.marks.emplace_back(GroupEnd{});
        marks.clear();
    }
    figure.labels = std::move(labels);
    figure.box = box_of(figure.marks);
    return figure;
}

/// Scale bar below, labels placed, all in its group, its top left corner at the origin.
void Sketch::close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit, bool strict) {
    // Too large already: not worth placing names, which stay as they are asked for.
    if (!fixed && (figure.box.width() > room.x || figure.box.height() > room.y)) return;
    const double target = std::min(30.0, std::max(8.0, room.x / 4));
    std::vector<Mark> bar;
    draw_scale_bar(bar, context_.fonts, theme_, {0, 0}, target, bar_scale, bar_unit.si.to_double(), bar_unit.symbol,
                   context_.language);
    figure.marks.insert(
        figure.marks.begin(),
        GroupBegin{"figure",
                   figure.id,
                   plain(figure.caption),
                   {{"data-figure", figure.kind}, {"data-scale", shortest(figure.scale)}, {"data-unit", figure.unit}}});
    figure.marks.emplace_back(GroupEnd{});
    place_labels(figure, context_.fonts, Spot{room.x, room.y - 8}, strict ? Labelling::strict : Labelling::free);
    const Box size_of_bar = box_of(bar);
    move(bar, figure.box.min.x - size_of_bar.min.x, figure.box.max.y + 3 - size_of_bar.min.y);
    const Box at = box_of(bar);
    figure.marks.pop_back();
    for (Mark& mark : bar) figure.marks.push_back(std::move(mark));
    figure.marks.emplace_back(GroupEnd{});
    figure.box.max = {std::max(figure.box.max.x, at.max.x), std::max(figure.box.max.y, at.max.y)};
    figure.move(-figure.box.min.x, -figure.box.min.y);
}

}  // namespace drawing

using namespace drawing;

namespace {

/// What a mechanism's figure shows besides the mechanism.
struct Shows {
    bool centres = false;
    std::optional<Symbol::Letter> turnings{};
};

Figure figure_of_mechanism(const DrawingContext& context, double room_x, double room_y, const Shows& shows,
                           double coarsest = any_scale) {
    const bool with_centres = shows.centres;
    const Subject subject(context.solution);
    const std::optional<double> asked = asked_scale(context.solution.mechanism, "mechanism");
    // Symbols and names need a rim; the first guess leaves the least that they take.
    Box extent = subject.box;
    if (with_centres) {
        const Box near = grown(subject.box, 0.6 * subject.size());
        for (const InstantCentre& centre : context.solution.centres) {
            if (!centre.at || centre.at->at_infinity()) continue;
            const Spot at = paper_spot(centre.at->place());
            if (!contains(near, at)) continue;
            extent.min = {std::min(extent.min.x, at.x), std::min(extent.min.y, at.y)};
            extent.max = {std::max(extent.max.x, at.x), std::max(extent.max.y, at.y)};
        }
    }
    const double first =
        choose_scale(extent.width(), extent.height(), std::max(room_x - 10, 10.0), std::max(room_y - 18, 10.0), asked);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = first,
                           .asked = asked,
                           .keeps_asked = true,
                           .coarsest = coarsest,
                           .names_stay_in_room = true};
    return fit(policy, [&](const Trial& trial) -> Figure {
        const auto with_dimensions = [&](Dimensions dimensions, const std::set<std::string>& left_out) {
            Sketch sketch(subject, context, trial.scale, "");
            sketch.draw_drivers();
            sketch.draw_compass();
            sketch.draw_in_colour();
            if (with_centres) sketch.draw_centres();
            sketch.draw_equivalent_linkages();
            if (shows.turnings) sketch.draw_turnings(*shows.turnings);
            if (dimensions != Dimensions::off) sketch.draw_dimensions({room_x, room_y}, dimensions == Dimensions::on, left_out);
            const bool dimensioned = !sketch.dimensions.empty();
            sketch.draw_points(true);
            Figure figure = sketch.finish("mechanism", "mechanism", "m");
            figure.caption = one_piece(word(with_centres ? "mechanism and instant centres" : "mechanism", context.language));
            sketch.close(figure, {room_x, room_y}, trial.last || trial.asked, trial.scale,
                         context.solution.mechanism.units.length, trial.strict);
            return std::pair{std::move(figure), dimensioned};
        };
        if (context.dimensions != Dimensions::automatic) return with_dimensions(context.dimensions, {}).first;
        // Dimensions that are not asked for never cost the mechanism a step of its scale; one that a name's leader covers is left
        // out, and the rest placed anew.
        constexpr int most_rounds = 4;
        std::set<std::string> left_out;
        for (int round = 0; round < most_rounds; ++round) {
            auto [figure, dimensioned] = with_dimensions(Dimensions::automatic, left_out);
            if (!dimensioned) return std::move(figure);
            if (!figure.labels.empty() || figure.box.width() > room_x || figure.box.height() > room_y) break;
            std::set<std::string> covered = covered_dimensions(figure, context.fonts);
            if (covered.empty()) return std::move(figure);
            left_out.merge(covered);
        }
        return with_dimensions(Dimensions::off, {}).first;
    });
}

}  // namespace

Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres, double coarsest) {
    return figure_of_mechanism(context, room_x, room_y, {with_centres}, coarsest);
}

Figure mechanism_with_turnings(const DrawingContext& context, Symbol::Letter letter, double room_x, double room_y) {
    return figure_of_mechanism(context, room_x, room_y, {false, letter});
}

Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y) {
    const Solution& solution = context.solution;
    const Subject subject(solution);
    const Theme& theme = context.theme;
    struct Shown {
        const PointMotion* motion;
        BodyIndex body;
        double value;
    };
    std::vector<Shown> shown;
    const auto name_of_point = [&](const PointMotion& motion) {
        return motion.label.empty() ? solution.mechanism.points[at_index(motion.point)].name : motion.label;
    };
    double longest = 0;
    for (const PointMotion& motion : solution.points) {
        if (motion.point < 0 || !motion.velocity || motion.velocity->is_zero()) continue;
        BodyIndex body = -1;
        for (const BodyIndex one : motion.bodies)
            if (one != 0 && body < 0) body = one;
        // The polygon's colour for the same vector, where it is drawn there.
        for (const DrawnVector& drawn : solution.protocol.vectors)
            if (drawn.role == DrawnVector::Role::absolute && drawn.symbol.letter == Symbol::Letter::v &&
                drawn.symbol.about == name_of_point(motion) && drawn.body >= 0) {
                body = drawn.body;
                break;
            }
        const double value = length(*motion.velocity);
        longest = std::max(longest, value);
        shown.push_back({&motion, body, value});
    }
    const std::optional<double> asked = asked_scale(solution.mechanism, "body");
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room_x - 30, 10.0),
                                      std::max(room_y - 36, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y}, .first = first, .names_stay_in_room = true};
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, "velocities-");
        sketch.draw_in_grey();
        const double reach = std::clamp(0.5 * sketch.size(), 15.0, 50.0);
        const double velocity_scale = choose_scale(longest, 0, reach, reach, asked);
        Box view = grown(sketch.mechanism_box(), 0.25 * sketch.size());
        const Pen thin{theme.thin, theme.secondary, {}, false};
        struct Ray {
            Spot from, to;
            int statement;
        };
        std::vector<Ray> rays;
        for (const Shown& one : shown) {
            const Spot at = sketch.spot(one.motion->point);
            const Spot tip = at + Spot{one.motion->velocity->x.to_double() / velocity_scale,
                                       -one.motion->velocity->y.to_double() / velocity_scale};
            bool squared_off = false;
            for (const InstantCentre& centre : solution.centres) {
                const std::vector<BodyIndex>& carriers = one.motion->bodies;
                if (!centre.at || centre.first != 0 || centre.everywhere || centre.at->at_infinity()) continue;
                if (std::find(carriers.begin(), carriers.end(), centre.second) == carriers.end()) continue;
                const Spot pole = sketch.spot(centre.at->place());
                const double whole = length(pole - at);
                if (!std::isfinite(whole) || whole < 0.1) continue;
                const Interval seen = within(view, at, unit(pole - at));
                rays.push_back({at, at + std::clamp(whole, 0.0, std::max(seen.to, 8.0)) * unit(pole - at), centre.statement});
                if (whole <= seen.to) sketch.draw_pole(centre);
                // The right angle between ray and velocity, once at each point.
                constexpr double corner = 1.8;
                if (!squared_off && length(tip - at) > 3 * corner) {
                    const Spot r = corner * unit(pole - at), v = corner * unit(tip - at);
                    sketch.construction.emplace_back(polyline({at + r, at + r + v, at + v}, thin));
                    squared_off = true;
                }
            }
            const Symbol symbol{Symbol::Letter::v, name_of_point(*one.motion), ""};
            const BodyColour colour = theme.colour_of(one.body);
            const std::string name = name_of(symbol);
            const RichText text = typeset(symbol, context.language);
            const int statement = statement_of_velocity(solution.protocol, name_of_point(*one.motion));
            sketch.arrows.emplace_back(GroupBegin{"vector",
                                                  sketch.id("", name),
                                                  plain(text),
                                                  {{"data-name", name}, {"data-value", shortest(one.value)}},
                                                  statement});
            draw_arrow(sketch.arrows, at, tip, theme.vector, colour.line, colour.dashes);
            sketch.arrows.emplace_back(Axis{at, tip});
            sketch.arrows.emplace_back(GroupEnd{});
            LabelRequest request;
            request.text = text;
            request.size = theme.equation;
            request.colour = colour.letter;
            request.anchor = 0.5 * (at + tip);
            request.toward = tip;
            request.clearance = 1.6;
            request.statement = statement;
            sketch.labels.push_back(std::move(request));
        }
        for (const Ray& ray : rays) {
            sketch.construction.emplace_back(line(ray.from, ray.to, thin));
            belong(sketch.construction, sketch.construction.size() - 1, ray.statement);
        }
        Figure figure = sketch.finish("body", "velocities", "m/s");
        figure.scale = velocity_scale;
        figure.caption = one_piece(word("velocities on the mechanism", context.language));
        sketch.close(figure, {room_x, room_y}, trial.last, velocity_scale, solution.mechanism.units.velocity, trial.strict);
        return figure;
    });
}

}  // namespace kinegraph::render
