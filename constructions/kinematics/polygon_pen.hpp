// Draws the polygons of motion: enters their poles, vectors, images and construction lines on the board, with the
// symbols of velocities or accelerations.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {

template <Plane plane>
inline constexpr bool is_velocity = plane == Plane::velocity;

/// v_A, a_BA^n.
template <Plane plane>
Symbol motion_symbol(std::string about, std::string term = {}) {
    return {is_velocity<plane> ? Symbol::Letter::v : Symbol::Letter::a, std::move(about), std::move(term)};
}
/// ω_3, α_3.
template <Plane plane>
Symbol spin_symbol(std::string body) {
    return {is_velocity<plane> ? Symbol::Letter::omega : Symbol::Letter::alpha, std::move(body), {}};
}
template <Plane plane>
Quantity spin_quantity(BodyIndex body) {
    return is_velocity<plane> ? omega_of(body) : alpha_of(body);
}
/// The quantity that a vector of a polygon represents.
template <Plane plane>
Quantity motion_quantity(const Seen& seen, DrawnVector::Role role) {
    using Role = DrawnVector::Role;
    using Part = Quantity::Part;
    const auto part = [role] {
        switch (role) {
            case Role::relative: return Part::relative;
            case Role::normal: return Part::normal;
            case Role::tangential: return Part::tangential;
            case Role::transport: return Part::transport;
            case Role::sliding: return Part::sliding;
            case Role::coriolis: return Part::coriolis;
            default: return Part::whole;
        }
    };
    if (seen.of.body == none) return {};
    Quantity quantity{.kind = is_velocity<plane> ? Quantity::Kind::velocity : Quantity::Kind::acceleration,
                      .body = seen.of.body,
                      .point = seen.of.point,
                      .part = part()};
    if (quantity.part == Part::whole) return quantity;
    quantity.other = seen.to.body;
    quantity.seen_from = seen.to.point;
    return quantity;
}
/// a, a'.
template <Plane plane>
Symbol image_symbol(std::string label) {
    return {Symbol::Letter::image, std::move(label), is_velocity<plane> ? "" : "'"};
}
/// ε^I, ε^II.
inline Symbol closing_error(int trial) { return {Symbol::Letter::error, "", trial == 1 ? "I" : "II"}; }
template <Plane plane>
constexpr Key either(Key velocity, Key acceleration) {
    return is_velocity<plane> ? velocity : acceleration;
}

/// Begins a sentence in the section of this plane; returns its index.
template <Plane plane>
StatementIndex state(Board& board, Key sentence, std::vector<Argument> arguments, std::string source = {}) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = is_velocity<plane> ? Topic::velocity : Topic::acceleration;
    statement.source = std::move(source);
    return board.state(std::move(statement));
}

template <Plane plane>
class PolygonPen {
public:
    /// `trial` as DrawnVector::trial.
    PolygonPen(Board& board, int polygon, int trial = 0) : board_(board), polygon_(polygon), trial_(trial) {}
    /// Adds a polygon with its pole; returns its index.
    static int begin(Board& board, Polygon polygon) {
        polygon.plane = plane;
        const int index = board.add_polygon(std::move(polygon));
        PolygonPen(board, index)
            .image({Symbol::Letter::pole, is_velocity<plane> ? "v" : "a", {}}, board.template pole<plane>(), frame);
        return index;
    }

    void vector(Symbol symbol, const Seen& seen, PointOn<plane> tail, PointOn<plane> tip, BodyIndex body,
                DrawnVector::Role role) const {
        DrawnVector drawn;
        drawn.symbol = std::move(symbol);
        drawn.polygon = polygon_;
        drawn.tail = tail.element;
        drawn.tip = tip.element;
        drawn.body = body;
        drawn.role = role;
        drawn.trial = trial_;
        drawn.seen = seen;
        drawn.quantity = motion_quantity<plane>(seen, role);
        board_.draw(std::move(drawn));
    }
    /// A construction line through these points (element indices).
    void line(LineOn<plane> line, LineReason reason, std::vector<ElementIndex> points) const {
        DrawnLine drawn;
        drawn.line = line.element;
        drawn.polygon = polygon_;
        drawn.reason = std::move(reason);
        drawn.points = std::move(points);
        drawn.trial = trial_;
        board_.draw(std::move(drawn));
    }
    /// The distance of a trial's tip from the line through a place, along the perpendicular.
    void miss(PointOn<plane> through, LineOn<plane> line, PointOn<plane> tip) const {
        const auto foot = board_.meet(line, board_.through(tip, board_.perpendicular(board_.direction(line))));
        if (!foot) return;
        DrawnMiss drawn;
        drawn.symbol = closing_error(trial_);
        drawn.polygon = polygon_;
        drawn.through = through.element;
        drawn.foot = foot->element;
        drawn.tip = tip.element;
        board_.draw(std::move(drawn));
    }
    void image(Symbol symbol, PointOn<plane> tip, BodyIndex body) const {
        Image drawn;
        drawn.symbol = std::move(symbol);
        drawn.polygon = polygon_;
        drawn.point = tip.element;
        drawn.body = body;
        drawn.trial = trial_;
        board_.label(std::move(drawn));
    }

private:
    Board& board_;
    int polygon_;
    int trial_;
};

}  // namespace kinegraph
