#include "engine/reading/sections.hpp"
#include "lang/keys/drivers.hpp"

#include <utility>

namespace kinegraph {

void MotionSection::read_motion(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::drivers::an_act_of_motion_body_velocities})) return;
    const Members form =
        file_.members(value, {"body", "velocities", "accelerations"}, {lang::drivers::an_act_of_motion});
    InstantaneousMotion motion;
    motion.where = value.pointer();
    motion.body = file_.moving_body(file_.required(form, "body", {lang::drivers::the_body_that_moves}),
                                    {lang::drivers::the_frame_does_not_move_name});
    if (const JsonValue velocities =
            file_.required(form, "velocities", {lang::drivers::what_is_known_of_the_velocities})) {
        motion.velocities = given_motions(motion.body, velocities, QuantityKind::velocity);
    }
    if (const JsonValue accelerations = form["accelerations"]) {
        motion.accelerations = given_motions(motion.body, accelerations, QuantityKind::acceleration);
    }
    mechanism_.motion = std::move(motion);
}

std::vector<GivenMotion> MotionSection::given_motions(BodyIndex on, JsonValue value, QuantityKind kind) {
    std::vector<GivenMotion> motions;
    if (!file_.expect(value, Kind::object, {lang::drivers::an_object_of_vectors_by_point})) return motions;
    for (const JsonValue member : value) {
        GivenMotion given;
        given.point = file_.look_up_point(member, member.key());
        bodies_.carry(on, given.point);
        if (member.is_object()) {
            const Members form = file_.members(member, {"along"}, {lang::drivers::what_is_known_of_a_vector});
            given.value =
                file_.bearing_or_default(file_.required(form, "along", {lang::drivers::the_direction_of_the_vector}));
        } else {
            given.value = file_.vector(member, kind, {lang::drivers::a_vector_x_y_or_along}).value_or(Vector{});
        }
        motions.push_back(std::move(given));
    }
    return motions;
}

}  // namespace kinegraph
