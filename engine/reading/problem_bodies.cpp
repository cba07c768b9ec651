#include "engine/reading/problem_sections.hpp"

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
    const Words wanted("an object of two bodies by name", "un oggetto con due corpi per nome");
    const JsonValue bodies = file_.required(section, "bodies", wanted);
    if (!bodies || !file_.expect(bodies, Kind::object, wanted)) return {};
    if (bodies.size() != 2) {
        file_.fault(bodies, {"two bodies touch; {0} are given", "si toccano due corpi; ne sono dati {0}",
                             std::to_string(bodies.size())});
        return {};
    }
    return {*bodies.begin(), *++bodies.begin()};
}

}  // namespace kinegraph
