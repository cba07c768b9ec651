// What the forms of several sections share, and the forms of the sections. Each section's rows stand beside its reader.
#pragma once

#include <array>

#include "engine/reading/form.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph {

namespace values {

inline constexpr FormValue length = quantity(QuantityKind::length);
inline constexpr FormValue angle = quantity(QuantityKind::angle);
inline constexpr FormValue angular_velocity = quantity(QuantityKind::angular_velocity);
inline constexpr FormValue angular_acceleration = quantity(QuantityKind::angular_acceleration);
inline constexpr FormValue velocity = quantity(QuantityKind::velocity);
inline constexpr FormValue acceleration = quantity(QuantityKind::acceleration);
inline constexpr FormValue mass = quantity(QuantityKind::mass);
inline constexpr FormValue force = quantity(QuantityKind::force);
inline constexpr FormValue moment = quantity(QuantityKind::moment);
inline constexpr FormValue inertia = quantity(QuantityKind::inertia);
inline constexpr FormValue pressure = quantity(QuantityKind::pressure);
inline constexpr FormValue time = quantity(QuantityKind::time);

inline constexpr FormValue number = json(R"("type": ["number", "string"], "pattern": "^ *=")")
                                        .named("number", "A bare number, or a formula that gives one.");
inline constexpr FormValue number_or_text = json(R"("type": ["number", "string"])");
inline constexpr FormValue parameter = json(R"("type": ["number", "string"], "minLength": 1)");
inline constexpr FormValue text = json(R"("type": "string")");
inline constexpr FormValue some_text = json(R"("type": "string", "minLength": 1)");
inline constexpr FormValue flag = json(R"("type": "boolean")");

inline constexpr FormValue name =
    json(R"("type": "string", "minLength": 1, "pattern": "^(?!.* on )[^,\\u0000-\\u001f\\u007f-\\u009f]+$")")
        .named("name", "A name: no comma, no \" on \", no control character.");
inline constexpr FormValue point_name =
    json(R"("type": "string", "minLength": 1)").named("pointName", "The name of a point.");
inline constexpr FormValue point_in_array =
    json(R"("type": ["string", "integer"], "minLength": 1)")
        .named("pointInArray", "The name of a point; in an array an integer will do.");
inline constexpr FormValue body_name = json(R"("type": ["string", "integer"], "minLength": 1)")
                                           .named("bodyName", "The name of a body; an integer will do.");
inline constexpr FormValue joint_name =
    json(R"("type": "string", "minLength": 1)").named("jointName", "The name of a joint, or that of its point.");
inline constexpr FormValue two_bodies = list(body_name, 2, 2);
inline constexpr FormValue expression =
    json(R"json("type": ["string", "number"], "examples": ["v0*t", "R*cos(omega*t)"])json")
        .named("expression",
               "An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi, sqrt, "
               "sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.");

inline constexpr FormValue coordinates = list(length, 2, 2).named("coordinates", "Coordinates [x, y].");
inline constexpr std::array place_choices{point_name, coordinates};
inline constexpr FormValue place = any(place_choices).named("place", "A point's name or its coordinates.");
inline constexpr FormValue sense =
    list(number, 2, 2).named("sense", "A vector [dx, dy] of which only the direction counts; not [0, 0].");
inline constexpr FormValue two_points =
    list(point_in_array, 2, 2).named("twoPoints", "From the first point to the second.");
inline constexpr FormValue two_texts = list(point_name, 2, 2);
inline constexpr std::array direction_choices{angle, two_texts, sense};
inline constexpr FormValue direction =
    any(direction_choices)
        .named("direction", "A direction: an angle from +x, two points (first → second), or a vector [dx, dy].");
inline constexpr FormValue forces = list(force, 2, 2), velocities = list(velocity, 2, 2),
                           accelerations = list(acceleration, 2, 2);

inline constexpr FormValue texts =
    FormValue{.shape = FormValue::Shape::texts}.named("words", "A text, or one for each language.");

/// Of a map whose keys are bodies.
inline constexpr std::string_view by_body = R"("propertyNames": {"$ref": "#/definitions/bodyName"})";

/// Of a map whose keys are points.
inline constexpr std::string_view by_point = R"("propertyNames": {"$ref": "#/definitions/pointName"})";

/// Of a circle.
inline constexpr FormRow radius =
    FormRow("radius", "r", length).needed(lang::common::the_radius_of_the_circle).positive(lang::common::a_radius);

}  // namespace values

namespace forms {

/// The whole file, with the sections of all kinds of problems.
const Form& mechanism();
extern const Form units, scales;
extern const FormValue point, body, joint, profiles, driver, turn_law, slide_law, load, effort, wish, variation;
extern const FormValue mass;
extern const Form motion_of_body;
extern const Form turn_piece, slide_piece, piece_of_lift, piece_of_swing;  ///< of laws of drivers and cams
extern const FormValue material_name, contact_materials;

}  // namespace forms

}  // namespace kinegraph
