#include "engine/reading/sections.hpp"
#include "lang/keys/drivers.hpp"

#include <utility>

namespace kinegraph {
namespace {

constexpr std::array known_direction_rows{
    FormRow("along", "X", values::direction).needed(lang::drivers::the_direction_of_the_vector)};
constexpr Form known_direction{lang::drivers::what_is_known_of_a_vector, known_direction_rows,
                               "Of this vector only the direction is known."};
constexpr std::array velocity_choices{values::velocities, values::object(known_direction)};
constexpr std::array acceleration_choices{values::accelerations, values::object(known_direction)};
constexpr FormValue known_velocity = values::any(velocity_choices),
                    known_acceleration = values::any(acceleration_choices);

constexpr std::array motion_rows{FormRow("body", "i", values::body_name).needed(lang::drivers::the_body_that_moves),
                                 FormRow("velocities", "{…}", values::map(known_velocity).with(values::by_point),
                                         "Point → [vx, vy] or {\"along\": X}.")
                                     .needed(lang::drivers::what_is_known_of_the_velocities)
                                     .called(lang::drivers::an_object_of_vectors_by_point),
                                 FormRow("accelerations", "{…}", values::map(known_acceleration).with(values::by_point),
                                         "Point → [ax, ay] or {\"along\": X}.")
                                     .called(lang::drivers::an_object_of_vectors_by_point)};

}  // namespace

constinit const Form forms::motion_of_body{lang::drivers::an_instantaneous_motion, motion_rows,
                                           "One rigid body's instantaneous motion, instead of joints and drivers."};

void MotionSection::read_motion(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::drivers::an_instantaneous_motion_body_velocities})) return;
    const Members form = file_.members(value, forms::motion_of_body);
    InstantaneousMotion motion;
    motion.where = value.pointer();
    motion.body = file_.moving_body(form.value("body"), {lang::drivers::the_frame_does_not_move_name});
    motion.velocities = given_motions(motion.body, form, "velocities", QuantityKind::velocity);
    motion.accelerations = given_motions(motion.body, form, "accelerations", QuantityKind::acceleration);
    mechanism_.motion = std::move(motion);
}

std::vector<GivenMotion> MotionSection::given_motions(BodyIndex on, const Members& motion, std::string_view key,
                                                      QuantityKind kind) {
    std::vector<GivenMotion> motions;
    motion.each(key, [&](JsonValue member) {
        GivenMotion given;
        given.point = file_.look_up_point(member, member.key());
        bodies_.carry(on, given.point);
        if (member.is_object()) {
            given.value = file_.members(member, known_direction).bearing_or_default("along");
        } else {
            given.value = file_.vector(member, kind, {lang::drivers::a_vector_x_y_or_along}).value_or(Vector{});
        }
        motions.push_back(std::move(given));
    });
    return motions;
}

}  // namespace kinegraph
