#include "engine/reading/problem_section.hpp"
#include "lang/keys/problems.hpp"

#include <string>
#include <utility>

namespace kinegraph {

BodyIndex ProblemBodies::body(JsonValue member) {
    for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i)
        if (mechanism_.bodies[i].name == member.key()) return BodyIndex(i);
    file_.check_name(member, member.key());
    Body added;
    added.name = member.key();
    added.where = member.pointer();
    mechanism_.bodies.push_back(std::move(added));
    return BodyIndex(mechanism_.bodies.size() - 1);
}

std::array<JsonValue, 2> ProblemBodies::two(const Members& section) {
    const JsonValue bodies = section.expected("bodies");
    if (!bodies) return {};
    if (bodies.size() != 2) {
        file_.fault(bodies, {lang::problems::two_bodies_touch_are_given, std::to_string(bodies.size())});
        return {};
    }
    return {*bodies.begin(), *++bodies.begin()};
}

}  // namespace kinegraph
