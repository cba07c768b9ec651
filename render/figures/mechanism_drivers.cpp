// Arrows of motion on the mechanism: drivers as the file gives them, angular velocities and accelerations as they are found.
#include <algorithm>
#include <array>

#include "render/figures/clutter.hpp"
#include "render/figures/mechanism_sketch.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render::drawing {

int statement_of_turning(const Solution& solution, const Quantity& sought) {
    const std::vector<Statement>& statements = solution.protocol.statements;
    const auto finds_it = [&](const Statement& statement) {
        return std::find(statement.finds.begin(), statement.finds.end(), sought) != statement.finds.end();
    };
    const auto found = std::find_if(statements.begin(), statements.end(), finds_it);
    return found == statements.end() ? -1 : static_cast<int>(found - statements.begin());
}

std::optional<PointIndex> Sketch::pivot_of_driver(const SpinDriver& spin) const {
    for (const Joint& joint : m_.joints) {
        const auto has = [&](BodyIndex b) {
            return std::find(joint.bodies.begin(), joint.bodies.end(), b) != joint.bodies.end();
        };
        if (joint.kind == JointKind::revolute && has(spin.body) && has(spin.relative_to)) return joint.point;
    }
    const std::vector<int>& corners = s_.corners[at_index(spin.body)];
    if (corners.empty()) return std::nullopt;
    return corners.front();
}

/// Towards the body's first corner, which says how far out it has room.
void Sketch::aim(Turning& turning) const {
    const auto& wheel = m_.bodies[at_index(turning.body)].circle;
    if (wheel) turning.reach = wheel->radius.to_double() / scale_;
    for (const int corner : s_.corners[at_index(turning.body)])
        if (const Spot out = spot(corner) - turning.pivot; length(out) > 1) {
            turning.arm = unit(out);
            turning.reach = length(out);
            return;
        }
}

/// An arc with an arrowhead ahead of the arm if nothing is in the way, else further on; `clutter`: what is drawn already, besides
/// the bodies.
void Sketch::draw_turning(const Turning& turning, Clutter* clutter) {
    const Spot at = turning.pivot;
    // On paper y runs down: counter-clockwise is the negative turn.
    const double turn = turning.counter_clockwise ? -1 : 1;
    double radius = 8, start = 0, sweep = 0, least = 1e300;
    for (const double tried : {std::clamp(0.4 * turning.reach, 8.0, 14.0), std::clamp(0.25 * turning.reach, 6.0, 8.0), 11.0})
        for (int step = 0; step < 9; ++step) {
            const double from = std::atan2(turning.arm.y, turning.arm.x) + turn * (2.6 / tried + 0.6 * step);
            const double by = turn * std::min(1.05, 11.0 / tried);
            double price = 0.35 * step + 0.1 * std::abs(tried - 0.4 * turning.reach);
            for (int i = 0; i <= 6; ++i) price += 2.5 * crowding(at + tried * polar_spot(from + by * i / 6), at);
            if (clutter) price += 6 * clutter->along_arc(at, tried, from, by);
            if (price < least - 1e-9) {
                least = price;
                radius = tried;
                start = from;
                sweep = by;
            }
        }
    const std::size_t first = arrows.size();
    draw_arc_arrow(arrows, at, radius, start, start + sweep, theme_.outline, letter_colour(turning.body));
    belong(arrows, first, turning.statement);
    const Spot middle = at + radius * polar_spot(start + 0.5 * sweep);
    arcs_of_drivers_.emplace_back(at, middle);
    LabelRequest request;
    request.text = turning.text;
    request.size = theme_.label;
    request.colour = letter_colour(turning.body);
    request.anchor = middle;
    request.clearance = 1.5;
    request.statement = turning.statement;
    labels.push_back(std::move(request));
    if (!clutter) return;
    constexpr int pieces = 6;
    for (int i = 0; i < pieces; ++i)
        clutter->add(at + radius * polar_spot(start + sweep * i / pieces),
                     at + radius * polar_spot(start + sweep * (i + 1) / pieces));
}

void Sketch::draw_turnings(Symbol::Letter letter) {
    Clutter clutter;
    clutter.add(ground);
    clutter.add(arrows);
    for (std::size_t b = 1; b < m_.bodies.size() && b < s_.solution.bodies.size(); ++b) {
        const BodyMotion& motion = s_.solution.bodies[b];
        const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
        if (!value || value->is_zero()) continue;
        const Symbol symbol{letter, m_.bodies[b].name, ""};
        const auto body = static_cast<BodyIndex>(b);
        const auto kind = letter == Symbol::Letter::omega ? Quantity::Kind::omega : Quantity::Kind::alpha;
        const int statement = statement_of_turning(s_.solution, {.kind = kind, .body = body});
        if (statement < 0) continue;
        Turning turning{body, shapes_[b].middle, {1, 0}, 12, value->sign() > 0, typeset(symbol, context_.language), statement};
        // About its fixed pin, else about its middle.
        const auto fixed = std::find_if(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
            return Subject::is_fixed_pin(joint) &&
                   std::find(joint.bodies.begin(), joint.bodies.end(), body) != joint.bodies.end();
        });
        if (fixed != m_.joints.end()) turning.pivot = spot(fixed->point);
        aim(turning);
        draw_turning(turning, &clutter);
    }
}

/// ω of a driven body as an arc about its pivot, the speed of a driven slide as an arrow beside it.
void Sketch::draw_drivers() {
    const auto valued = [&](const Symbol& symbol, double value, const Unit& unit_of) {
        RichText text = typeset(symbol, context_.language);
        const std::string figure = given_number(value / unit_of.si.to_double(), context_.language);
        append(text, with_powers(" = " + figure + " " + unit_of.symbol));
        return text;
    };
    const auto straight = [&](Spot start, Spot along, double value, BodyIndex body, const std::string& about) {
        if (value == 0) return;
        const Spot direction = value < 0 ? -1.0 * along : along;
        const Spot tail = start - 7.0 * direction, tip = start + 7.0 * direction;
        draw_arrow(arrows, tail, tip, theme_.outline, letter_colour(body));
        LabelRequest request;
        request.text = valued({Symbol::Letter::v, about, ""}, value, m_.units.velocity);
        request.size = theme_.label;
        request.colour = letter_colour(body);
        request.anchor = start;
        request.toward = tip;
        request.clearance = 1.5;
        labels.push_back(std::move(request));
    };
    for (const Driver& driver : m_.drivers) {
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) {
            const double omega = spin->omega.to_double();
            if (omega == 0) continue;
            Symbol symbol{Symbol::Letter::omega, m_.bodies[at_index(spin->body)].name, ""};
            if (spin->relative_to != 0) symbol.about += m_.bodies[at_index(spin->relative_to)].name;
            const std::optional<PointIndex> pivot = pivot_of_driver(*spin);
            if (!pivot) continue;
            Turning turning{spin->body, spot(*pivot), {1, 0}, 12, omega > 0, valued(symbol, omega, m_.units.angular_velocity),
                            -1};
            aim(turning);
            draw_turning(turning, nullptr);
        } else if (const auto* slide = std::get_if<SlideDriver>(&driver)) {
            const Joint& joint = m_.joints[at_index(slide->joint)];
            const Spot along = s_.guides[at_index(slide->joint)];
            Spot side = turned(along);
            if (side.y > 0 || (side.y == 0 && side.x > 0)) side = -1.0 * side;
            std::string about = joint.name;
            straight(spot(joint.point) + (slider_side_ + 5.0) * side, along, slide->speed.to_double(), joint.bodies[0], about);
        } else if (const auto* point = std::get_if<PointDriver>(&driver)) {
            const Vector direction = direction_of(point->along, s_.solution.pose);
            const Spot along = paper_direction(direction), at = spot(point->at);
            // Ahead of the point, or beside it where a body or a line runs that way.
            Spot best = at + 11.0 * along;
            double least = 1e300;
            for (const Spot aside :
                 {11.0 * along, 5.0 * turned(along), -5.0 * turned(along), 8.0 * turned(along), -8.0 * turned(along)}) {
                double price = 0.1 * length(aside - 11.0 * along);
                for (int i = -3; i <= 3; ++i) price += crowding(at + aside + 7.0 / 3 * i * along, at);
                if (price < least - 1e-9) least = price, best = at + aside;
            }
            straight(best, along, point->speed.to_double(), point->body, m_.points[at_index(point->at)].name);
        }
    }
}

}  // namespace kinegraph::render::drawing
