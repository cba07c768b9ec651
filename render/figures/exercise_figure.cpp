// The mechanism of an exercise: its data as dimensions, its drivers, loads and masses with their values. Shows no
// result.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/mechanism/clutter.hpp"
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

constexpr std::size_t most_dimensions = 24;
/// Penalty for an arrow that enlarges the figure; greater than for all that it may cross.
constexpr double leaves_its_place = 10;

class ExerciseDrawing {
public:
    /// `within`: the preferred area for arrows, mm relative to the origin of coordinates.
    ExerciseDrawing(Sketch& sketch, const std::optional<Box>& within)
        : sketch_(sketch), mechanism_(sketch.mechanism), within_(within) {}

    void draw() {
        draw_in_colour(sketch_);
        clutter_.add(sketch_.bodies);
        clutter_.add(sketch_.ground);
        draw_arrows_of_motion(sketch_, {.undrivable = true, .accelerations_of_drivers = true});
        clutter_.add(sketch_.arrows);
        draw_auxiliary_points();
        for (const Load& load : mechanism_.loads) std::visit([&](const auto& each) { draw_load(each); }, load);
        if (mechanism_.motion) draw_motion(*mechanism_.motion);
    }
    bool has_arrows() const { return has_arrows_; }
    /// Beside the names of the centres, which are placed before.
    void say_masses() {
        for (const Mass& mass : mechanism_.masses) {
            RichText text = one_piece("m", Face::italic);
            text.back().sub = mechanism_.body(mass.body).name;
            text.back().sub_face = Face::regular;
            append(text, value(mass.mass, mechanism_.units.mass));
            LabelRequest& label = sketch_.add_label(std::move(text), sketch_.theme.colour_of(mass.body).letter,
                                                    sketch_.spot(mass.centre), sketch_.measures.pin_radius + 2.2);
            label.size = sketch_.theme.small;
        }
    }

private:
    /// Points that no body carries but that define positions; a dimension may end there. Distant ones are only in the
    /// text.
    void draw_auxiliary_points() {
        constexpr double radius = 0.6;
        const Box near = grown(sketch_.mechanism_box(), 0.15 * sketch_.size());
        for (const PointIndex point : indices_of(mechanism_.points)) {
            const Spot at = sketch_.spot(point);
            if (sketch_.subject.shows(point) || !contains(near, at) || shows_another_at(at)) continue;
            sketch_.construction.emplace_back(ring(at, radius, sketch_.theme.text, sketch_.thin()));
            clutter_.add(at - Spot{radius, 0}, at + Spot{radius, 0});
            sketch_.add_label(sketch_.name_of_point(point), sketch_.theme.text, at, radius + 0.8).in_file =
                mechanism_.point(point).name;
        }
    }
    bool shows_another_at(Spot at) const {
        for (const PointIndex other : indices_of(mechanism_.points))
            if (sketch_.subject.shows(other) && coincide(sketch_.spot(other), at)) return true;
        return false;
    }
    RichText value(const Exact& si, const Unit& unit) const {
        return with_powers(" = " + given_number((si / unit.si).to_double(), sketch_.context.language) + " " +
                           unit.symbol);
    }
    /// Draws an arrow that pulls or pushes at a point, where it crosses least, with its name and value. All have one
    /// length unless only a shorter one has space.
    void draw_arrow_at(Spot at, Spot along, RichText text, const BodyColour& colour) {
        constexpr double whole = 18, cut_short = 9;
        Cheapest<Bar> best;
        for (const double size : {whole, cut_short})
            for (const double stand_off : {2.4, 6.0})
                for (const bool pulls : {true, false}) {
                    const Spot tail = pulls ? at + stand_off * along : at - (stand_off + size) * along;
                    const Bar arrow{tail, tail + size * along};
                    const bool leaves = within_ && !(contains(*within_, arrow.from) && contains(*within_, arrow.to));
                    best.offer(clutter_.along(arrow.from, arrow.to) + 0.03 * stand_off +
                                   (leaves ? leaves_its_place : 0) + (size < whole ? 0.15 : 0),
                               arrow);
                }
        const Bar& arrow = best.choice;
        draw_arrow(sketch_.arrows, arrow.from, arrow.to, sketch_.theme.outline, colour.line);
        has_arrows_ = true;
        clutter_.add(arrow.from, arrow.to);
        sketch_.add_label(std::move(text), colour.letter, middle(arrow), 1.5).toward = arrow.to;
    }
    RichText named(const std::string& name, Symbol::Letter letter) const {
        return typeset(Symbol{letter, name, ""}, sketch_.context.language);
    }

    void draw_load(const ForceLoad& force) {
        const Vector direction =
            force.value ? *force.value : direction_of(force.magnitude->second, sketch_.subject.solution.pose);
        if (direction.is_zero()) return;
        RichText text = named(force.name, Symbol::Letter::F);
        const Unit& unit = mechanism_.units.force;
        double newtons = force.value ? kinegraph::length(*force.value) : force.magnitude->first.to_double();
        Spot along = paper_direction(direction);
        if (newtons < 0) along = -1.0 * along, newtons = -newtons;
        append(text, with_powers(" = " + given_number(newtons / unit.si.to_double(), sketch_.context.language) + " " +
                                 unit.symbol));
        draw_arrow_at(sketch_.spot(force.at), along, std::move(text), sketch_.theme.colour_of(force.body));
    }
    /// The arrows belong to the mechanism.
    void draw_load(const DistributedLoad& load) { name_intensities(sketch_, load); }
    /// The spiral belongs to the mechanism; its values are in the text.
    static void draw_load(const TorsionLoad& /*torsion*/) {}
    void draw_load(const CoupleLoad& couple) {
        if (couple.value.is_zero()) return;
        const BodyColour colour = sketch_.theme.colour_of(couple.body);
        const Spot at = sketch_.shape(couple.body).middle;
        constexpr double sweep = 2.4;
        const double by = couple.value.sign() > 0 ? -sweep : sweep;  // y is downwards on paper
        Cheapest<Arc> best;
        for (const double radius : {7.0, 9.0})
            for (int step = 0; step < 12; ++step) {
                const double from = step * pi_number / 6;
                best.offer(clutter_.along_arc(at, radius, from, by, best.price), {at, radius, from, from + by});
            }
        const Arc& arc = best.choice;
        draw_arc_arrow(sketch_.arrows, at, arc.radius, arc.from, arc.to, sketch_.theme.outline, colour.line);
        clutter_.add_arc(at, arc.radius, arc.from, by);
        RichText text = named(couple.name, Symbol::Letter::M);
        append(text, value(couple.value, mechanism_.units.moment));
        sketch_.add_label(std::move(text), colour.letter, arc.at(arc.from + by / 2), 1.5);
    }
    void draw_load(const SpringLoad& spring) {
        RichText text = named(spring.name, Symbol::Letter::F);
        // The force of an elastic spring is a result.
        if (!spring.elastic)
            append(text,
                   value(spring.magnitude.sign() < 0 ? -spring.magnitude : spring.magnitude, mechanism_.units.force));
        const Spot from = sketch_.spot(spring.between[0]), to = sketch_.spot(spring.between[1]);
        sketch_.add_label(std::move(text), sketch_.theme.text, 0.5 * (from + to), 3.0).toward = to;
    }
    void draw_motion(const InstantaneousMotion& motion) {
        for (const GivenMotion& given : motion.velocities) {
            const Spot at = sketch_.spot(given.point);
            RichText text = named(mechanism_.point(given.point).name, Symbol::Letter::v);
            const BodyColour colour = sketch_.theme.colour_of(motion.body);
            if (const auto* velocity = std::get_if<Vector>(&given.value)) {
                if (velocity->is_zero()) continue;
                const Unit& unit = mechanism_.units.velocity;
                append(text, with_powers(" = " +
                                         given_number(kinegraph::length(*velocity) / unit.si.to_double(),
                                                      sketch_.context.language) +
                                         " " + unit.symbol));
                draw_arrow_at(at, paper_direction(*velocity), std::move(text), colour);
            } else {
                constexpr double reach = 15;
                const Vector direction = direction_of(std::get<Bearing>(given.value), sketch_.subject.solution.pose);
                const Spot along = paper_direction(direction);
                sketch_.construction.emplace_back(line(at - reach * along, at + reach * along, sketch_.axis()));
                sketch_.add_label(std::move(text), colour.letter, at + 0.7 * reach * along, 1.5).toward =
                    at + reach * along;
            }
        }
    }

    Sketch& sketch_;
    const Mechanism& mechanism_;
    const std::optional<Box>& within_;
    Clutter clutter_;
    bool has_arrows_ = false;
};

/// The area of a figure: its greatest size and, if its position is fixed, the part of the paper it may cover, mm
/// relative to the origin of coordinates.
struct Ground {
    double scale;
    Spot room;
    std::optional<Box> within;
    bool strict = false;  ///< names that would leave the area are placed in a key
};

Box intersection(const Box& a, const Box& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}
bool encloses(const Box& outer, const Box& inner) {
    constexpr double rounding = 1e-6;  // mm
    const Box air = grown(outer, rounding);
    return contains(air, inner.min) && contains(air, inner.max);
}

/// Dimensions drawn before names are placed, and those that had no position then and are placed round the names.
struct Dimensioning {
    DimensionWish first, last;
};
Figure drawn(const DrawingContext& context, const Subject& subject, const Ground& ground, const Dimensioning& wish) {
    Sketch sketch(subject, context, ground.scale, "");
    ExerciseDrawing drawing(sketch, ground.within);
    drawing.draw();
    if (wish.first.most > 0) draw_dimensions(sketch, ground.room, wish.first);
    name_points(sketch);
    drawing.say_masses();
    Figure figure = sketch.finish(begun(context, {FigureKind::mechanism}), "m");
    figure.caption = one_piece(word(lang::sheet::mechanism_and_its_data, context.language));
    if (drawing.has_arrows()) figure.further_scale = word(lang::sheet::arrows_not_to_scale, context.language);
    Spot room = ground.room;
    if (ground.within) {
        // Names and scale bar are placed in the area, near the mechanism.
        constexpr double about = 9, under_all = 8;
        figure.box.include(intersection(*ground.within, grown(figure.box, about)));
        room = {figure.box.width(), figure.box.height() + under_all};
    }
    sketch.close(figure, room, true, ground.scale, subject.mechanism.units.length, ground.strict);
    if (wish.last.most > 0) {
        DimensionWish missing = wish.last;
        missing.left_out.merge(dimensions_of(figure));
        add_dimensions(sketch, figure, ground.room, missing);
    }
    if (ground.within) figure.box = box_of(figure.marks);
    return figure;
}

/// The dimensions that leave the area.
std::set<GroupId> dimensions_outside(const Figure& figure, const std::optional<Box>& within) {
    std::set<GroupId> outside;
    if (!within) return outside;
    const Box place{figure.origin + within->min, figure.origin + within->max};
    for (std::size_t i = 0; i < figure.marks.size(); ++i) {
        const auto* group = std::get_if<GroupBegin>(&figure.marks[i]);
        if (group == nullptr || group->cls != "dimension") continue;
        std::vector<Mark> own;
        for (std::size_t k = i + 1; !std::holds_alternative<GroupEnd>(figure.marks[k]); ++k)
            own.push_back(figure.marks[k]);
        if (!own.empty() && !encloses(place, box_of(own))) outside.insert(group->id);
    }
    return outside;
}

/// In a solution bars in compression are heavy. In a question all bars have the same style, because this would be a
/// result.
Theme theme_of(const DrawingContext& context) {
    Theme theme = context.theme;
    if (context.solution.truss) theme.bodies = {theme.colour_of(frame)};
    return theme;
}

Figure fitted_exercise(const DrawingContext& of, const Ground& ground) {
    constexpr int most_rounds = 8;
    const Theme theme = theme_of(of);
    const DrawingContext context{of.solution, theme, of.fonts, of.language, of.dimensions};
    const Subject subject(context.solution);
    const Dimensioning none{{.most = 0}, {.most = 0}};
    if (context.dimensions == Dimensions::off) return drawn(context, subject, ground, none);
    const DimensionWish all{.most = most_dimensions, .left_out = {}, .sought_far = true, .within = ground.within};
    Dimensioning wish{all, all};
    for (int round = 0; round < most_rounds; ++round) {
        Figure figure = drawn(context, subject, ground, wish);
        std::set<GroupId> covered = covered_dimensions(figure, context.fonts);
        covered.merge(dimensions_outside(figure, ground.within));
        const bool fits = figure.box.width() <= ground.room.x && figure.box.height() <= ground.room.y;
        if (covered.empty() && (fits || ground.within)) return figure;
        if (covered.empty()) break;
        // A dimension that a name covers is tried again after the names.
        for (const GroupId& each : covered)
            if (!wish.first.left_out.insert(each).second) wish.last.left_out.insert(each);
    }
    return drawn(context, subject, ground, none);
}

}  // namespace

Figure exercise_figure(const DrawingContext& context, double scale, double room_x, double room_y) {
    return fitted_exercise(context, {scale, {room_x, room_y}, std::nullopt});
}

Figure exercise_figure_within(const DrawingContext& context, double scale, const Box& within) {
    const Spot room{within.width(), within.height()};
    Figure figure = fitted_exercise(context, {scale, room, within, true});
    return figure.has_key ? fitted_exercise(context, {scale, room, within}) : figure;
}

}  // namespace kinegraph::render
