// Drawn by: see drawn_by.hpp.
#include "render/scene/drawn_by.hpp"

namespace kinegraph::render {

int statement_of_velocity(const Protocol& protocol, const std::string& label) {
    for (const DrawnVector& vector : protocol.vectors)
        if (vector.role == DrawnVector::Role::absolute && vector.symbol == Symbol{Symbol::Letter::v, label, ""})
            return vector.statement;
    return -1;
}

int statement_of_force(const Solution& solution, const ForceStatements& statements, const Symbol& symbol) {
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& applied : body.forces)
            if (applied.symbol == symbol) return statements.force(body, applied);
    return -1;
}

}  // namespace kinegraph::render
