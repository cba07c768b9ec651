// Arrows of motion on the mechanism: given drivers, and computed angular velocities and accelerations.
#include <algorithm>
#include <cmath>

#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/sliding.hpp"
#include "render/mechanism/free_arc.hpp"
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

/// An arc with an arrowhead and its name, which later ones avoid.
void draw_turning(Sketch& sketch, const Turning& turning, const PlacedArc& placed, FreePaper& paper) {
    const Arc& arc = placed.arc;
    const Colour colour = sketch.theme.colour_of(turning.body).letter;
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, arc.centre, arc.radius, arc.from, arc.to, sketch.theme.outline, colour);
    belong(sketch.arrows, first, turning.statement);
    const Spot middle = arc.at(arc.from + 0.5 * (arc.to - arc.from));
    sketch.add_label(turning.text, colour, middle, clear_of_arc, turning.statement).body = turning.body;
    paper.take(arc);
    if (placed.name) paper.take(*placed.name);
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

void draw_driver(Sketch& sketch, const SpinDriver& spin, Given given, FreePaper& paper) {
    const bool is_rate = given == Given::rate;
    const double value = (is_rate ? spin.omega : spin.alpha).to_double();
    const std::optional<Spot> pivot = pivot_of_driver(sketch, spin);
    if (value == 0 || !pivot) return;
    Symbol symbol{is_rate ? Symbol::Letter::omega : Symbol::Letter::alpha, sketch.mechanism.body(spin.body).name, ""};
    if (spin.relative_to != frame) symbol.about += sketch.mechanism.body(spin.relative_to).name;
    const RichText text =
        given_value(sketch, symbol, value, is_rate ? sketch.mechanism.units.angular_velocity : per_second_squared());
    const Turning turning{spin.body, *pivot, value > 0, text, none};
    draw_turning(sketch, turning, free_arc(sketch, paper, turning), paper);
}

/// The speed of a driven slide or point, or its acceleration.
struct Straight {
    Spot of;  ///< the place that moves
    Spot along;
    double value = 0;
    Symbol symbol;
    const Unit& unit;
    std::vector<BodyIndex> bodies{};  ///< that have the place; the first gives the colour
};
Straight straight(const Sketch& sketch, Given given, Bar way, const auto& driver, std::vector<BodyIndex> bodies,
                  Symbol symbol) {
    const Units& units = sketch.mechanism.units;
    const bool is_rate = given == Given::rate;
    return {way.from,
            way.to - way.from,
            (is_rate ? driver.speed : driver.acceleration).to_double(),
            std::move(symbol),
            is_rate ? units.velocity : units.acceleration,
            std::move(bodies)};
}

constexpr double half_of_straight = 7;     // mm
constexpr double clear_of_straight = 1.5;  // between it and its name, mm

/// Whether the name has room beside an arrow, at its middle or nearer to an end.
bool has_room_beside(const FreePaper& paper, const Bar& arrow, InkBox name) {
    const Spot along = direction(arrow), across = turned(along);
    const double reach = std::abs(across.x) * name.half.x + std::abs(across.y) * name.half.y;
    for (const double at : {0.0, 0.3, -0.3, 0.6, -0.6})
        for (const double side : {1.0, -1.0}) {
            name.centre = middle(arrow) + at * half_of_straight * along + side * (clear_of_straight + reach) * across;
            if (paper.has_room_for(name)) return true;
        }
    return false;
}

/// Draws the arrow about the cheapest of some places; each has a price of its own, in units of a leader's.
void draw_straight(Sketch& sketch, const Straight& arrow, const std::vector<std::pair<Spot, double>>& places,
                   FreePaper& paper) {
    const RichText text = given_value(sketch, arrow.symbol, arrow.value, arrow.unit);
    const InkBox name = box_of_name(sketch, text);
    const Spot half = half_of_straight * (arrow.value < 0 ? -1.0 * arrow.along : arrow.along);
    Cheapest<Bar> best;
    for (const auto& [at, own] : places) {
        const Bar bar{at - half, at + half};
        double price = own + paper.price_of(bar, best.price - own);
        if (price < best.price && (paper.seems_of_another({bar.from, at, bar.to}, arrow.bodies) ||
                                   paper.is_cut_off(arrow.of, at, arrow.bodies)))
            price += read_at_another;
        if (price < best.price) best.offer(price + (has_room_beside(paper, bar, name) ? 0 : without_name), bar);
    }
    const auto& [tail, tip] = best.choice;
    const Colour colour = sketch.theme.colour_of(arrow.bodies.front()).letter;
    draw_arrow(sketch.arrows, tail, tip, sketch.theme.outline, colour);
    paper.take(best.choice);
    sketch.add_label(text, colour, middle(best.choice), clear_of_straight).toward = tip;
}

/// Beside the slide, along it, where links leave room; the acceleration rather on the other side or further out.
void draw_driver(Sketch& sketch, const SlideDriver& slide, Given given, FreePaper& paper) {
    const Joint& joint = sketch.mechanism.joint(slide.joint);
    const Spot along = sketch.guide(joint), at = sketch.spot(joint);
    const Symbol symbol = name_of_sliding(sketch.subject.solution, slide.joint, given != Given::rate);
    const Straight arrow = straight(sketch, given, {at, at + along}, slide, {joint.bodies[0], joint.bodies[1]}, symbol);
    if (arrow.value == 0) return;
    Spot side = turned(along);
    if (side.y > 0 || (side.y == 0 && side.x > 0)) side = -1.0 * side;
    if (given == Given::acceleration) side = -1.0 * side;
    constexpr double other_side = 0.2, per_millimetre = 0.06;
    const double off = sketch.measures.slider_side + 5.0;
    std::vector<std::pair<Spot, double>> places;
    for (const double out : {0.0, 6.0})
        for (const double aside : {0.0, 8.0, -8.0, 14.0, -14.0, 20.0, -20.0})
            for (const double on : {1.0, -1.0})
                places.emplace_back(at + on * (off + out) * side + aside * along,
                                    per_millimetre * (out + std::abs(aside)) + (on < 0 ? other_side : 0));
    draw_straight(sketch, arrow, places, paper);
}

/// Ahead of the point, or beside it if a body or a line lies ahead.
void draw_driver(Sketch& sketch, const PointDriver& point, Given given, FreePaper& paper) {
    const Spot along = paper_direction(direction_of(point.along, sketch.subject.solution.pose)),
               at = sketch.spot(point.at);
    const Symbol::Letter letter = given == Given::rate ? Symbol::Letter::v : Symbol::Letter::a;
    const Straight arrow =
        straight(sketch, given, {at, at + along}, point, {point.body}, along_drive(letter, point, sketch.mechanism));
    if (arrow.value == 0) return;
    constexpr double per_millimetre = 0.1;
    std::vector<std::pair<Spot, double>> places;
    for (const Spot aside :
         {11.0 * along, 5.0 * turned(along), -5.0 * turned(along), 8.0 * turned(along), -8.0 * turned(along)})
        places.emplace_back(at + aside, per_millimetre * length(aside - 11.0 * along));
    draw_straight(sketch, arrow, places, paper);
}

/// Whether a driver moves nothing here, such as one at a dead point.
bool is_undrivable(const Mobility& mobility, std::size_t driver) {
    const auto& idle = mobility.idle_drivers;
    return mobility.driven < mobility.effective &&
           std::find(idle.begin(), idle.end(), static_cast<int>(driver)) != idle.end();
}

void draw_all_drivers(Sketch& sketch, Given given, bool undrivable, FreePaper& paper) {
    const std::vector<Driver>& drivers = sketch.mechanism.drivers;
    for (std::size_t i = 0; i < drivers.size(); ++i)
        if (undrivable || !is_undrivable(sketch.subject.solution.mobility, i))
            std::visit([&](const auto& one) { draw_driver(sketch, one, given, paper); }, drivers[i]);
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

namespace {

/// The arc of a computed ω or α, if it was found and is not zero.
std::optional<Turning> found_turning(const Sketch& sketch, BodyIndex body, Symbol::Letter letter) {
    const Solution& solution = sketch.subject.solution;
    const BodyMotion& motion = solution.bodies[at_index(body)];
    const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
    if (!value || value->is_zero()) return std::nullopt;
    const Symbol symbol{letter, sketch.mechanism.body(body).name, ""};
    const Quantity turning = turning_of(body, letter);
    const StatementIndex statement = statement_of_turning(solution, turning);
    if (statement == none) return std::nullopt;
    const Unit unit = unit_of(result_kind(turning).unit, sketch.mechanism.units);
    return Turning{body, pivot_of(sketch, body), value->sign() > 0,
                   found_value(sketch, symbol, value->to_double(), unit), statement};
}

/// Computed ω or α of the bodies as arcs, each with the statement that determines it, until more names than are left
/// have no room; if only what is readable is wished, those are left out.
/// Returns whether no more than these have none; `left` is reduced by their number.
bool draw_turnings(Sketch& sketch, Symbol::Letter letter, const MotionWish& wish, std::size_t& left, FreePaper& paper) {
    const std::size_t bodies = std::min(sketch.mechanism.bodies.size(), sketch.subject.solution.bodies.size());
    for (const BodyIndex body : indices(bodies, frame.next())) {
        if (std::find(wish.left_out.begin(), wish.left_out.end(), body) != wish.left_out.end()) continue;
        const std::optional<Turning> turning = found_turning(sketch, body, letter);
        if (!turning) continue;
        const PlacedArc placed = free_arc(sketch, paper, *turning);
        const bool has_place = placed.name || left > 0;
        if (wish.only_readable && (!has_place || placed.price >= read_at_another)) continue;
        draw_turning(sketch, *turning, placed, paper);
        if (!has_place) return false;
        if (!placed.name) --left;
    }
    return true;
}

}  // namespace

bool draw_arrows_of_motion(Sketch& sketch, const MotionWish& wish) {
    FreePaper& paper = paper_of(sketch);
    if (wish.drivers) draw_all_drivers(sketch, Given::rate, wish.undrivable, paper);
    if (wish.accelerations_of_drivers) draw_all_drivers(sketch, Given::acceleration, wish.undrivable, paper);
    std::size_t left = wish.most_without_room;
    const std::size_t before = sketch.labels.size();
    const bool have_room = std::all_of(wish.found.begin(), wish.found.end(), [&](Symbol::Letter letter) {
        return draw_turnings(sketch, letter, wish, left, paper);
    });
    return have_room && (!wish.only_readable || sketch.labels.size() > before);
}

}  // namespace kinegraph::render::drawing
