#include "engine/reading/sections.hpp"

#include <utility>

namespace kinegraph {

void MotionSection::read_motion(JsonValue value) {
    if (!file_.expect(value, Kind::object,
                      {"an act of motion, {\"body\": …, \"velocities\": {…}},",
                       "un atto di moto, {\"body\": …, \"velocities\": {…}},"}))
        return;
    const Members form =
        file_.members(value, {"body", "velocities", "accelerations"}, {"an act of motion", "un atto di moto"});
    InstantaneousMotion motion;
    motion.where = value.pointer();
    motion.body = file_.moving_body(
        file_.required(form, "body", {"the body that moves", "il corpo che si muove"}),
        {"the frame does not move; name another body", "il telaio non si muove; indicare un altro corpo"});
    if (const JsonValue velocities = file_.required(
            form, "velocities",
            {"what is known of the velocities of its points", "ciò che si sa delle velocità dei suoi punti"})) {
        motion.velocities = given_motions(motion.body, velocities, QuantityKind::velocity);
    }
    if (const JsonValue accelerations = form["accelerations"]) {
        motion.accelerations = given_motions(motion.body, accelerations, QuantityKind::acceleration);
    }
    mechanism_.motion = std::move(motion);
}

std::vector<GivenMotion> MotionSection::given_motions(BodyIndex on, JsonValue value, QuantityKind kind) {
    std::vector<GivenMotion> motions;
    if (!file_.expect(value, Kind::object, {"an object of vectors by point", "un oggetto con i vettori per punto"}))
        return motions;
    for (const JsonValue member : value) {
        GivenMotion given;
        given.point = file_.look_up_point(member, member.key());
        bodies_.carry(on, given.point);
        if (member.is_object()) {
            const Members form =
                file_.members(member, {"along"}, {"what is known of a vector", "ciò che si sa di un vettore"});
            given.value = file_.bearing_or_default(
                file_.required(form, "along", {"the direction of the vector", "la direzione del vettore"}));
        } else {
            given.value =
                file_.vector(member, kind, {"a vector [x, y] or {\"along\": X}", "un vettore [x, y] o {\"along\": X}"})
                    .value_or(Vector{});
        }
        motions.push_back(std::move(given));
    }
    return motions;
}

}  // namespace kinegraph
