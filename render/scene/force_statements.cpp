// Force statements, by the bodies, symbols and points that they name.
#include "render/scene/force_statements.hpp"

#include <algorithm>

#include "engine/exact.hpp"
#include "render/scene/sentences.hpp"

namespace kinegraph::render {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool names_one_of(const Message& message, const std::set<std::string>& names) {
    return std::any_of(message.arguments.begin(), message.arguments.end(), [&](const Argument& argument) {
        const auto* symbol = std::get_if<Symbol>(&argument);
        return symbol && names.contains(name_of(*symbol));
    });
}
bool names_point(const Message& message, const std::string& name) {
    return std::any_of(message.arguments.begin(), message.arguments.end(), [&](const Argument& argument) {
        const auto* point = std::get_if<PointName>(&argument);
        return point && point->name == name;
    });
}

}  // namespace

ForceStatements::ForceStatements(const Solution& solution) : solution_(solution) {
    const std::vector<Statement>& statements = solution.protocol.statements;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        const Sentence sentence = statements[i].message.sentence;
        if (sentence == Sentence::superposition_sum || (sentence == Sentence::trial && sum_ < 0)) sum_ = static_cast<int>(i);
    }
}

/// A force and its opposite on the other body are found at once.
std::set<std::string> ForceStatements::names(const FreeBody& body, const AppliedForce& applied) const {
    Symbol couple = applied.symbol;
    couple.letter = Symbol::Letter::M;
    std::set<std::string> found{name_of(applied.symbol), name_of(couple)};
    if (applied.joint < 0) return found;
    for (const FreeBody& other : solution_.free_bodies) {
        if (other.body < 0 || other.body != applied.from) continue;
        for (const AppliedForce& reaction : other.forces)
            if (reaction.joint == applied.joint && reaction.from == body.body) found.insert(name_of(reaction.symbol));
    }
    return found;
}

int ForceStatements::line(const FreeBody& body, const AppliedForce& applied) const {
    const std::vector<Statement>& statements = solution_.protocol.statements;
    if (applied.kind != AppliedForce::Kind::reaction) {
        int first = -1;
        for (const auto& [name, place] : body.meets)
            if (cross(applied.force, place - applied.at).is_zero())
                if (const int found = meet(name); found >= 0 && (first < 0 || found < first)) first = found;
        return first;
    }
    if (sum_ >= 0) return sum_;
    const std::set<std::string> own = names(body, applied);
    const std::string& point = applied.joint >= 0
                                   ? solution_.mechanism.points[at(solution_.mechanism.joints[at(applied.joint)].point)].name
                                   : applied.symbol.about;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        const Message& message = statements[i].message;
        if (statements[i].section != "forces") continue;
        if (names_one_of(message, own)) return static_cast<int>(i);
        if (!joins_two_forces(message.sentence) || !names_point(message, point)) continue;
        if (speaks_of(solution_, message, body)) return static_cast<int>(i);
        for (const FreeBody& other : solution_.free_bodies)
            if (other.body >= 0 && other.body == applied.from && speaks_of(solution_, message, other)) return static_cast<int>(i);
    }
    return polygon(body);
}

int ForceStatements::force(const FreeBody& body, const AppliedForce& applied) const {
    if (applied.kind != AppliedForce::Kind::reaction && applied.kind != AppliedForce::Kind::effort) return -1;
    if (sum_ >= 0) return sum_;
    const std::vector<Statement>& statements = solution_.protocol.statements;
    const std::set<std::string> own = names(body, applied);
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (closes_a_polygon(statements[i].message.sentence) && names_one_of(statements[i].message, own))
            return static_cast<int>(i);
    return polygon(body);
}

int ForceStatements::meet(const std::string& name) const {
    const std::vector<Statement>& statements = solution_.protocol.statements;
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (finds_a_meet(statements[i].message.sentence) && names_point(statements[i].message, name)) return static_cast<int>(i);
    return -1;
}

int ForceStatements::polygon(const FreeBody& body) const {
    if (sum_ >= 0) return sum_;
    int last = last_that_closes(body);
    if (last >= 0) return last;
    // Known from its neighbours, at the latest with the last sentence.
    const std::vector<Statement>& statements = solution_.protocol.statements;
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (statements[i].section == "forces") last = static_cast<int>(i);
    return last;
}

std::vector<const FreeBody*> ForceStatements::closed_by(std::size_t statement) const {
    std::vector<const FreeBody*> closed;
    if (sum_ >= 0) return closed;
    for (const FreeBody& body : solution_.free_bodies)
        if (last_that_closes(body) == static_cast<int>(statement)) closed.push_back(&body);
    return closed;
}

int ForceStatements::last_that_closes(const FreeBody& body) const {
    const std::vector<Statement>& statements = solution_.protocol.statements;
    int last = -1;
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (statements[i].section == "forces" && closes_a_polygon(statements[i].message.sentence) &&
            speaks_of(solution_, statements[i].message, body))
            last = static_cast<int>(i);
    return last;
}

}  // namespace kinegraph::render
