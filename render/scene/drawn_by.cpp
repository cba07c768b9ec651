// Drawn by: see drawn_by.hpp.
#include "render/scene/drawn_by.hpp"

#include "engine/solution/solution.hpp"

#include <algorithm>

namespace kinegraph::render {
namespace {

bool holds(const std::vector<BodyIndex>& bodies, BodyIndex body) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}
/// All bodies that share the motion of a body's point.
std::vector<BodyIndex> pinned_to(const Solution& solution, BodyIndex body, PointIndex point) {
    for (const PointMotion& motion : solution.points)
        if (motion.point == point && holds(motion.bodies, body)) return motion.bodies;
    return {body};
}

}  // namespace

StatementIndex statement_of_motion(const Solution& solution, Quantity::Kind kind, BodyIndex body, PointIndex point) {
    const std::vector<BodyIndex> bodies = pinned_to(solution, body, point);
    for (const DrawnVector& vector : solution.protocol.vectors) {
        const Quantity& drawn = vector.quantity;
        if (drawn == Quantity{.kind = kind, .body = drawn.body, .point = point} && holds(bodies, drawn.body))
            return vector.statement;
    }
    return none;
}

StatementIndex statement_of_force(const Solution& solution, const Quantity& force) {
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& applied : body.forces)
            if (quantity_of(body, applied) == force) return applied.force_statement;
    return none;
}

}  // namespace kinegraph::render
