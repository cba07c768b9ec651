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

/// Where an arc has room: towards the body's first corner, whose distance limits the radius.
struct Arm {
    Spot along{1, 0};
    double reach = 12;  // mm
};
Arm arm_of(const Layout& layout, BodyIndex body, Spot pivot) {
    Arm arm;
    if (const auto& wheel = layout.mechanism.body(body).circle) arm.reach = wheel->radius.to_double() / layout.scale();
    for (const PointIndex corner : layout.subject.corners[at_index(body)])
        if (const Spot out = layout.spot(corner) - pivot; length(out) > 1) return {unit(out), length(out)};
    return arm;
}

/// An arc ahead of the arm, or further round if that collides with something. `clutter`: everything drawn so far except
/// the bodies.
Arc free_arc(const Layout& layout, const Turning& turning, const Clutter* clutter) {
    const Arm arm = arm_of(layout, turning.body, turning.pivot);
    // On paper y points down, so counter-clockwise is the negative sense.
    const double turn = turning.counter_clockwise ? -1 : 1, wanted = 0.4 * arm.reach;
    Cheapest<Arc> best;
    for (const double radius : {std::clamp(wanted, 8.0, 14.0), std::clamp(0.25 * arm.reach, 6.0, 8.0), 11.0})
        for (int step = 0; step < 9; ++step) {
            const double from = angle_of(arm.along) + turn * (2.6 / radius + 0.6 * step);
            const double by = turn * std::min(1.05, 11.0 / radius);
            double price = 0.35 * step + 0.1 * std::abs(radius - wanted);
            // Prices only increase, so the loop may stop early.
            for (int i = 0; i <= 6 && price < best.price; ++i)
                price += 2.5 * layout.crowding(turning.pivot + radius * polar_spot(from + by * i / 6), turning.pivot);
            if (clutter && price < best.price) price += 6 * clutter->along_arc(turning.pivot, radius, from, by);
            best.offer(price, {turning.pivot, radius, from, from + by});
        }
    return best.choice;
}

/// An arc with an arrowhead and its name; avoids `clutter` if given.
void draw_turning(Sketch& sketch, const Turning& turning, Clutter* clutter) {
    const Arc arc = free_arc(sketch, turning, clutter);
    const Colour colour = sketch.theme.colour_of(turning.body).letter;
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, arc.centre, arc.radius, arc.from, arc.to, sketch.theme.outline, colour);
    belong(sketch.arrows, first, turning.statement);
    const Spot middle = arc.at(arc.from + 0.5 * (arc.to - arc.from));
    sketch.arcs_of_drivers.push_back({turning.pivot, middle});
    sketch.add_label(turning.text, colour, middle, 1.5, turning.statement);
    if (clutter) clutter->add_arc(arc.centre, arc.radius, arc.from, arc.to - arc.from);
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

/// `clutter`: everything else drawn so far; null if the driver's arrow is the first.
void draw_driver(Sketch& sketch, const SpinDriver& spin, Given given, Clutter* clutter) {
    const bool is_rate = given == Given::rate;
    const double value = (is_rate ? spin.omega : spin.alpha).to_double();
    const std::optional<Spot> pivot = pivot_of_driver(sketch, spin);
    if (value == 0 || !pivot) return;
    Symbol symbol{is_rate ? Symbol::Letter::omega : Symbol::Letter::alpha, sketch.mechanism.body(spin.body).name, ""};
    if (spin.relative_to != frame) symbol.about += sketch.mechanism.body(spin.relative_to).name;
    const RichText text =
        given_value(sketch, symbol, value, is_rate ? sketch.mechanism.units.angular_velocity : per_second_squared());
    draw_turning(sketch, {spin.body, *pivot, value > 0, text, none}, clutter);
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
void draw_straight(Sketch& sketch, Spot start, const Straight& arrow, Clutter* clutter) {
    const Spot half = half_of_straight * (arrow.value < 0 ? -1.0 * arrow.along : arrow.along);
    const Colour colour = sketch.theme.colour_of(arrow.body).letter;
    draw_arrow(sketch.arrows, start - half, start + half, sketch.theme.outline, colour);
    if (clutter) clutter->add(start - half, start + half);
    sketch.add_label(given_value(sketch, arrow.symbol, arrow.value, arrow.unit), colour, start, 1.5).toward =
        start + half;
}

/// The place with the fewest collisions for an arrow; each candidate has a price of its own.
Spot free_place(const Sketch& sketch, Spot at, const Straight& arrow,
                const std::vector<std::pair<Spot, double>>& places, const Clutter* clutter) {
    Cheapest<Spot> best;
    for (auto [aside, price] : places) {
        const Spot half = half_of_straight * arrow.along, start = at + aside;
        for (int i = -3; i <= 3; ++i) price += sketch.crowding(start + (i / 3.0) * half, at);
        if (clutter) price += 6 * clutter->along(start - half, start + half);
        best.offer(price, start);
    }
    return best.choice;
}

/// Beside the slide; the acceleration on the other side or further out.
void draw_driver(Sketch& sketch, const SlideDriver& slide, Given given, Clutter* clutter) {
    const Joint& joint = sketch.mechanism.joint(slide.joint);
    const Spot along = sketch.guide(joint), at = sketch.spot(joint);
    const Symbol symbol = name_of_sliding(sketch.subject.solution, slide.joint, given != Given::rate);
    const Straight arrow = straight(sketch, given, along, slide, joint.bodies[0], symbol);
    if (arrow.value == 0) return;
    Spot side = turned(along);
    if (side.y > 0 || (side.y == 0 && side.x > 0)) side = -1.0 * side;
    const double off = sketch.measures.slider_side + 5.0;
    if (given == Given::rate) return draw_straight(sketch, at + off * side, arrow, clutter);
    const std::vector<std::pair<Spot, double>> places{
        {-off * side, 0}, {(off + 6) * side, 0.3}, {-(off + 6) * side, 0.6}, {(off + 12) * side, 0.9}};
    draw_straight(sketch, free_place(sketch, at, arrow, places, clutter), arrow, clutter);
}

/// Ahead of the point, or beside it if a body or a line lies ahead.
void draw_driver(Sketch& sketch, const PointDriver& point, Given given, Clutter* clutter) {
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
    draw_straight(sketch, free_place(sketch, at, arrow, places, clutter), arrow, clutter);
}

void draw_all_drivers(Sketch& sketch, Given given, Clutter* clutter) {
    for (const Driver& driver : sketch.mechanism.drivers)
        std::visit([&](const auto& one) { draw_driver(sketch, one, given, clutter); }, driver);
}

/// Obstacles for a further arrow besides the bodies: ground and arrows.
Clutter clutter_of(const Sketch& sketch) {
    Clutter clutter;
    clutter.add(sketch.ground);
    clutter.add(sketch.arrows);
    return clutter;
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
    Clutter clutter = clutter_of(sketch);
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
        draw_turning(sketch, {body, pivot_of(sketch, body), value->sign() > 0, text, statement}, &clutter);
    }
}

void draw_drivers(Sketch& sketch) { draw_all_drivers(sketch, Given::rate, nullptr); }

void draw_accelerations_of_drivers(Sketch& sketch) {
    Clutter clutter = clutter_of(sketch);
    draw_all_drivers(sketch, Given::acceleration, &clutter);
}

}  // namespace kinegraph::render::drawing
