// Arrows of motion on the mechanism: given drivers, and computed angular velocities and accelerations.
#include <algorithm>
#include <cmath>

#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/sliding.hpp"
#include "render/mechanism/clutter.hpp"
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

namespace {

std::string without_filling_zeros(double value, Language language, int digits) {
    std::string text = number(value, digits, language);
    const std::size_t mark = text.find_first_of(".,");
    if (mark == std::string::npos) return text;
    std::size_t end = mark + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    std::size_t keep = end;
    while (keep > mark + 1 && text[keep - 1] == '0') --keep;
    if (keep == mark + 1) keep = mark;
    text.erase(keep, end - keep);
    return text;
}

/// ω or α of a body as an arc about a point, with its name.
struct Turning {
    BodyIndex body = none;
    Spot pivot;
    bool counter_clockwise = true;
    RichText text;
    StatementIndex statement = none;
};

/// A stroke of the body that leaves the pivot. The arc touches it, and its length limits the radius.
struct Arm {
    Spot along{1, 0};
    double reach = 12;  // mm
};
/// That towards the body's first corner, then the others.
std::vector<Arm> arms_of(const Layout& layout, BodyIndex body, Spot pivot) {
    std::vector<Arm> arms;
    const auto is_new = [&](Spot along) {
        constexpr double nearly = 0.95;
        return std::none_of(arms.begin(), arms.end(), [&](const Arm& arm) { return dot(arm.along, along) > nearly; });
    };
    for (const PointIndex corner : layout.subject.corners[at_index(body)])
        if (const Spot out = layout.spot(corner) - pivot; length(out) > 1 && is_new(unit(out)))
            arms.push_back({unit(out), length(out)});
    if (const auto& wheel = layout.mechanism.body(body).circle; wheel && arms.empty())
        arms.push_back({{1, 0}, wheel->radius.to_double() / layout.scale()});
    if (arms.empty()) arms.emplace_back();
    return arms;
}

/// What is drawn besides the bodies: what an arrow must not touch, and thin lines, which it may cross, but no name.
struct Obstacles {
    Clutter heavy, thin;
};
Obstacles obstacles_in(const Sketch& sketch) {
    Obstacles obstacles;
    obstacles.heavy.add(sketch.ground);
    obstacles.heavy.add(sketch.arrows);
    obstacles.thin.add(sketch.construction);
    obstacles.thin.add(sketch.centres);
    for (const Bar& name : sketch.names_of_arcs) obstacles.thin.add(name.from, name.to);
    return obstacles;
}

/// The name of an arc: half its width and height, and its distance from the arc, mm.
struct Lettering {
    Spot half;
    double clearance;
};
constexpr double clear_of_arc = 1.5;
Lettering lettering_of(const Sketch& sketch, const RichText& text) {
    const ShapedLine shaped = sketch.context.fonts.shape(text, sketch.theme.label);
    return {{0.5 * shaped.width, 0.5 * (shaped.ascent + shaped.descent)}, clear_of_arc};
}

/// The fraction of a box about `centre` that something covers.
double covered(const Layout& layout, const Obstacles& obstacles, Spot centre, Spot half) {
    constexpr int pieces = 8;
    double sum = 0;
    for (int i = 0; i <= pieces; ++i) {
        const Spot at = centre + Spot{(2.0 * i / pieces - 1) * half.x, 0};
        sum += layout.crowding(at, {1e9, 1e9}) > 0 ? 1.0 / (pieces + 1) : 0;
    }
    for (const double row : {-0.8, 0.0, 0.8}) {
        const Spot from = centre + Spot{-half.x, row * half.y}, to = centre + Spot{half.x, row * half.y};
        sum += obstacles.heavy.along(from, to) + obstacles.thin.along(from, to);
    }
    return sum;
}

/// The best place of a name beside a spot of an arc, with its price: none where it is free.
Cheapest<Spot> room_for(const Layout& layout, const Obstacles& obstacles, Spot at, Spot outward,
                        const Lettering& name) {
    Cheapest<Spot> best;
    constexpr double aside = 0.7, per_direction = 0.2, per_cover = 4;
    double price = 0;
    for (const double turn : {0.0, aside, -aside, pi_number}) {
        const Spot u = polar_spot(angle_of(outward) + turn);
        const double to_side = 1 / std::max(std::abs(u.x), std::abs(u.y));
        const Spot centre = at + name.clearance * u + to_side * Spot{u.x * name.half.x, u.y * name.half.y};
        best.offer(price + per_cover * covered(layout, obstacles, centre, name.half), centre);
        if (best.price <= price + per_direction) break;
        price += per_direction;
    }
    return best;
}

struct PlacedArc {
    Arc arc;
    Spot name;  // the middle of its name, where there is room for it
};

/// An arc that begins or ends at an arm, or further round if that collides with something or leaves its name no room.
PlacedArc free_arc(const Layout& layout, const Turning& turning, const Obstacles& obstacles, const Lettering& name) {
    // On paper y points down, so counter-clockwise is the negative sense.
    const double turn = turning.counter_clockwise ? -1 : 1;
    Cheapest<PlacedArc> best;
    double of_arm = 0;
    for (const Arm& arm : arms_of(layout, turning.body, turning.pivot)) {
        const double wanted = 0.4 * arm.reach;
        for (const double radius : {std::clamp(wanted, 8.0, 14.0), std::clamp(0.25 * arm.reach, 6.0, 8.0), 11.0}) {
            const double by = turn * std::min(1.05, 11.0 / radius), gap = 2.6 / radius;
            for (const bool ahead : {true, false}) {
                // What drives has its arc ahead of its body, where this turns to.
                if (!ahead && turning.statement == none) break;
                for (int step = 0; step < (of_arm > 0 ? 3 : 9); ++step) {
                    const double away = gap + 0.6 * step;
                    const double from = angle_of(arm.along) + (ahead ? turn * away : -turn * away - by);
                    // Prices only increase, so the loop may stop early.
                    double price = of_arm + 0.35 * step + 0.1 * std::abs(radius - wanted) + (ahead ? 0 : 0.1);
                    for (int i = 0; i <= 6 && price < best.price; ++i)
                        price += 2.5 *
                                 layout.crowding(turning.pivot + radius * polar_spot(from + by * i / 6), turning.pivot);
                    if (price < best.price) price += 6 * obstacles.heavy.along_arc(turning.pivot, radius, from, by);
                    if (price < best.price) price += obstacles.thin.along_arc(turning.pivot, radius, from, by);
                    if (price >= best.price) continue;
                    const Arc arc{turning.pivot, radius, from, from + by};
                    const Spot outward = polar_spot(from + 0.5 * by);
                    const auto room = room_for(layout, obstacles, turning.pivot + radius * outward, outward, name);
                    best.offer(price + room.price, {arc, room.choice});
                }
            }
        }
        of_arm += 0.2;
    }
    return best.choice;
}

/// An arc with an arrowhead and its name, which later ones avoid.
void draw_turning(Sketch& sketch, const Turning& turning, Obstacles& obstacles) {
    const Lettering name = lettering_of(sketch, turning.text);
    const auto [arc, at] = free_arc(sketch, turning, obstacles, name);
    const Colour colour = sketch.theme.colour_of(turning.body).letter;
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, arc.centre, arc.radius, arc.from, arc.to, sketch.theme.outline, colour);
    belong(sketch.arrows, first, turning.statement);
    const Spot middle = arc.at(arc.from + 0.5 * (arc.to - arc.from));
    sketch.arcs_of_drivers.push_back({turning.pivot, middle});
    sketch.add_label(turning.text, colour, middle, clear_of_arc, turning.statement);
    obstacles.heavy.add_arc(arc.centre, arc.radius, arc.from, arc.to - arc.from);
    sketch.names_of_arcs.push_back({at - Spot{name.half.x, 0}, at + Spot{name.half.x, 0}});
    obstacles.thin.add(sketch.names_of_arcs.back().from, sketch.names_of_arcs.back().to);
}

std::optional<Spot> pivot_of_driver(const Layout& layout, const SpinDriver& spin) {
    for (const Joint& joint : layout.mechanism.joints)
        if (joint.pair().is_hinge() && joint.connects(spin.body) && joint.connects(spin.relative_to))
            return layout.spot(joint);
    const std::vector<PointIndex>& corners = layout.subject.corners[at_index(spin.body)];
    if (corners.empty()) return std::nullopt;
    return layout.spot(corners.front());
}

/// The body's fixed pin, or else its middle.
Spot pivot_of(const Layout& layout, BodyIndex body) {
    for (const Joint& joint : layout.mechanism.joints)
        if (is_fixed_pin(joint) && joint.connects(body)) return layout.spot(joint);
    return layout.shape(body).middle;
}

const Unit& per_second_squared() {
    static const Unit unit{"rad/s²", 1};
    return unit;
}

RichText value_of(const Sketch& sketch, const Symbol& symbol, const std::string& figure, const Unit& unit) {
    RichText text = typeset(symbol, sketch.context.language);
    append(text, with_powers(" = " + figure + " " + unit.symbol));
    return text;
}
/// "ω_2 = 10 rad/s", as the file gives it.
RichText given_value(const Sketch& sketch, const Symbol& symbol, double value, const Unit& unit) {
    return value_of(sketch, symbol, given_number(value / unit.si.to_double(), sketch.context.language), unit);
}
/// "ω_3 = 1.31 rad/s", as in the sentence that finds it.
RichText found_value(const Sketch& sketch, const Symbol& symbol, double value, const Unit& unit) {
    constexpr int digits = 3;  // as in the sentences
    return value_of(sketch, symbol, number(value / unit.si.to_double(), digits, sketch.context.language), unit);
}

/// Which property of a driver is drawn: its rate or the derivative of it.
enum class Given { rate, acceleration };

void draw_driver(Sketch& sketch, const SpinDriver& spin, Given given, Obstacles& obstacles) {
    const bool is_rate = given == Given::rate;
    const double value = (is_rate ? spin.omega : spin.alpha).to_double();
    const std::optional<Spot> pivot = pivot_of_driver(sketch, spin);
    if (value == 0 || !pivot) return;
    Symbol symbol{is_rate ? Symbol::Letter::omega : Symbol::Letter::alpha, sketch.mechanism.body(spin.body).name, ""};
    if (spin.relative_to != frame) symbol.about += sketch.mechanism.body(spin.relative_to).name;
    const RichText text =
        given_value(sketch, symbol, value, is_rate ? sketch.mechanism.units.angular_velocity : per_second_squared());
    draw_turning(sketch, {spin.body, *pivot, value > 0, text, none}, obstacles);
}

/// The speed of a driven slide or point, or its acceleration.
struct Straight {
    Spot along;
    double value = 0;
    Symbol symbol;
    const Unit& unit;
    BodyIndex body = none;
};
Straight straight(const Sketch& sketch, Given given, Spot along, const auto& driver, BodyIndex body, Symbol symbol) {
    const Units& units = sketch.mechanism.units;
    if (given == Given::rate) return {along, driver.speed.to_double(), std::move(symbol), units.velocity, body};
    return {along, driver.acceleration.to_double(), std::move(symbol), units.acceleration, body};
}

constexpr double half_of_straight = 7;  // mm

/// Draws it as an arrow about `start`.
void draw_straight(Sketch& sketch, Spot start, const Straight& arrow, Obstacles& obstacles) {
    const Spot half = half_of_straight * (arrow.value < 0 ? -1.0 * arrow.along : arrow.along);
    const Colour colour = sketch.theme.colour_of(arrow.body).letter;
    draw_arrow(sketch.arrows, start - half, start + half, sketch.theme.outline, colour);
    obstacles.heavy.add(start - half, start + half);
    sketch.add_label(given_value(sketch, arrow.symbol, arrow.value, arrow.unit), colour, start, 1.5).toward =
        start + half;
}

/// The place with the fewest collisions for an arrow; each candidate has a price of its own.
Spot free_place(const Sketch& sketch, Spot at, const Straight& arrow,
                const std::vector<std::pair<Spot, double>>& places, const Obstacles& obstacles) {
    Cheapest<Spot> best;
    for (auto [aside, price] : places) {
        const Spot half = half_of_straight * arrow.along, start = at + aside;
        for (int i = -3; i <= 3; ++i) price += sketch.crowding(start + (i / 3.0) * half, at);
        price += 6 * obstacles.heavy.along(start - half, start + half);
        best.offer(price, start);
    }
    return best.choice;
}

/// Beside the slide, along it, where links leave room; the acceleration rather on the other side or further out.
void draw_driver(Sketch& sketch, const SlideDriver& slide, Given given, Obstacles& obstacles) {
    const Joint& joint = sketch.mechanism.joint(slide.joint);
    const Spot along = sketch.guide(joint), at = sketch.spot(joint);
    const Symbol symbol = name_of_sliding(sketch.subject.solution, slide.joint, given != Given::rate);
    const Straight arrow = straight(sketch, given, along, slide, joint.bodies[0], symbol);
    if (arrow.value == 0) return;
    Spot side = turned(along);
    if (side.y > 0 || (side.y == 0 && side.x > 0)) side = -1.0 * side;
    const double off = sketch.measures.slider_side + 5.0;
    std::vector<std::pair<Spot, double>> places{
        {-off * side, 0}, {(off + 6) * side, 0.3}, {-(off + 6) * side, 0.6}, {(off + 12) * side, 0.9}};
    if (given == Given::rate) {
        constexpr double other_side = 0.2, per_millimetre = 0.04;
        places = {{off * side, 0}, {-off * side, other_side}};
        for (const double aside : {8.0, -8.0, 14.0, -14.0})
            for (const double on : {1.0, -1.0})
                places.emplace_back(on * off * side + aside * along,
                                    per_millimetre * std::abs(aside) + (on < 0 ? other_side : 0));
    }
    draw_straight(sketch, free_place(sketch, at, arrow, places, obstacles), arrow, obstacles);
}

/// Ahead of the point, or beside it if a body or a line lies ahead.
void draw_driver(Sketch& sketch, const PointDriver& point, Given given, Obstacles& obstacles) {
    const Spot along = paper_direction(direction_of(point.along, sketch.subject.solution.pose)),
               at = sketch.spot(point.at);
    const Symbol::Letter letter = given == Given::rate ? Symbol::Letter::v : Symbol::Letter::a;
    const Straight arrow =
        straight(sketch, given, along, point, point.body, along_drive(letter, point, sketch.mechanism));
    if (arrow.value == 0) return;
    std::vector<std::pair<Spot, double>> places;
    for (const Spot aside :
         {11.0 * along, 5.0 * turned(along), -5.0 * turned(along), 8.0 * turned(along), -8.0 * turned(along)})
        places.emplace_back(aside, 0.1 * length(aside - 11.0 * along));
    draw_straight(sketch, free_place(sketch, at, arrow, places, obstacles), arrow, obstacles);
}

void draw_all_drivers(Sketch& sketch, Given given, Obstacles& obstacles) {
    for (const Driver& driver : sketch.mechanism.drivers)
        std::visit([&](const auto& one) { draw_driver(sketch, one, given, obstacles); }, driver);
}

}  // namespace

std::string given_number(double value, Language language) {
    std::string six = without_filling_zeros(value, language, 6), four = without_filling_zeros(value, language, 4);
    // Six digits suit round values; for 120 rpm in rad/s four are enough.
    return four.size() + 1 < six.size() ? four : six;
}

StatementIndex statement_of_turning(const Solution& solution, const Quantity& sought) {
    const std::vector<Statement>& statements = solution.protocol.statements;
    const auto finds_it = [&](const Statement& statement) {
        return std::find(statement.finds.begin(), statement.finds.end(), sought) != statement.finds.end();
    };
    const auto found = std::find_if(statements.begin(), statements.end(), finds_it);
    return found == statements.end() ? none : StatementIndex(found - statements.begin());
}

void draw_turnings(Sketch& sketch, Symbol::Letter letter) {
    const Solution& solution = sketch.subject.solution;
    Obstacles obstacles = obstacles_in(sketch);
    for (const BodyIndex body :
         indices(std::min(sketch.mechanism.bodies.size(), solution.bodies.size()), frame.next())) {
        const BodyMotion& motion = solution.bodies[at_index(body)];
        const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
        if (!value || value->is_zero()) continue;
        const Symbol symbol{letter, sketch.mechanism.body(body).name, ""};
        const Quantity turning = turning_of(body, letter);
        const StatementIndex statement = statement_of_turning(solution, turning);
        if (statement == none) continue;
        const Unit unit = unit_of(result_kind(turning).unit, sketch.mechanism.units);
        const RichText text = found_value(sketch, symbol, value->to_double(), unit);
        draw_turning(sketch, {body, pivot_of(sketch, body), value->sign() > 0, text, statement}, obstacles);
    }
}

void draw_drivers(Sketch& sketch) {
    Obstacles obstacles = obstacles_in(sketch);
    draw_all_drivers(sketch, Given::rate, obstacles);
}

void draw_accelerations_of_drivers(Sketch& sketch) {
    Obstacles obstacles = obstacles_in(sketch);
    draw_all_drivers(sketch, Given::acceleration, obstacles);
}

}  // namespace kinegraph::render::drawing
