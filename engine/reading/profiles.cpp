#include "engine/reading/sections.hpp"
#include "lang/keys/joints.hpp"

#include <variant>

namespace kinegraph {
namespace {

/// A body shows one of them; the reader has one form for all, the schema an object for each.
constexpr std::array profile_rows{
    FormRow("line", "X", values::direction, "A straight line through the contact.").one_of(),
    FormRow("circle", "C", values::point_name, "The centre of a circle through the contact.").one_of(),
    FormRow("tip", "true", values::json(R"("const": true)"), "A knife edge.").one_of()};
constexpr std::array profile_choices{Form::Choice{{}, {"line"}}, Form::Choice{{}, {"circle"}},
                                     Form::Choice{{}, {"tip"}}};
constexpr Form profile_form{lang::joints::a_profile, profile_rows, {}, {}, profile_choices};
constexpr FormValue profile_value = values::object(profile_form).named("profile", "What a body shows at the contact.");

}  // namespace

constinit const FormValue forms::profiles =
    values::map(profile_value, 0, 2)
        .with(values::by_body)
        .named("profiles", "Body → what it shows at the contact; a body with a circle needs no entry.");

void ProfilesOfContact::read_profiles(const Members& form, Joint& joint) {
    const JsonValue shape = form.one_of();
    if (form["profiles"] && form["tangent"]) return;
    if (shape && shape.key() == "tangent") {
        joint.tangent = form.bearing("tangent");
        return;
    }
    if (form.has_or_misspells("tangent") || (!shape && form.has_or_misspells("profiles"))) return;
    bool complete = joint.bodies.size() == 2 && joint.bodies[0] != none && joint.bodies[1] != none;
    if (shape) {
        if (!file_.expect(shape, Kind::object, {lang::joints::an_object_of_profiles_by_body})) return;
        for (const JsonValue member : shape) complete = read_profile(member, joint) && complete;
    }
    if (!complete) return;
    const JsonValue place = shape ? shape : form.object();
    for (const BodyIndex on : joint.bodies) {
        if (joint.profiles.contains(on)) continue;
        const Body& owner = mechanism_.body(on);
        if (owner.circle) {
            if (owner.circle->centre == joint.point && joint.point != none) {
                file_.fault(place, {lang::joints::the_circle_of_body, quoted(owner.name)});
            }
            joint.profiles.emplace(on, CircleProfile{owner.circle->centre, true});
        } else {
            file_.fault(place, {lang::joints::the_profile_of_body_is_missing, quoted(owner.name)});
            complete = false;
        }
    }
    if (!complete || joint.bodies[0] == joint.bodies[1]) return;
    const Profile& first = joint.profiles.at(joint.bodies[0]);
    const Profile& second = joint.profiles.at(joint.bodies[1]);
    if (std::holds_alternative<LineProfile>(first) && std::holds_alternative<LineProfile>(second)) {
        file_.fault(place, {lang::joints::two_lines_are_no_contact_they});
    }
    if (std::holds_alternative<TipProfile>(first) && std::holds_alternative<TipProfile>(second)) {
        file_.fault(place, {lang::joints::two_tips_are_no_contact_they});
    }
}

bool ProfilesOfContact::read_profile(JsonValue member, Joint& joint) {
    const BodyIndex on = file_.look_up_body(member, member.key());
    if (on != none && !joint.connects(on)) {
        if (!joint.connects(none)) {
            file_.fault(member, {lang::joints::the_body_is_not, quoted(member.key())});
        }
        return false;
    }
    if (!file_.expect(member, Kind::object, {lang::joints::a_profile_line_circle_or_tip})) return false;
    const Members form = file_.members(member, profile_form);
    const JsonValue shape = form.one_of();
    if (!shape) return false;
    if (shape.key() == "line") {
        const auto along = file_.bearing(shape);
        if (!along) return false;
        joint.profiles.emplace(on, LineProfile{*along});
    } else if (shape.key() == "circle") {
        const PointIndex centre = file_.point(shape);
        if (centre != none && centre == joint.point)
            file_.fault(shape, {lang::joints::a_circle_about_the_contact_itself});
        joint.profiles.emplace(on, CircleProfile{centre});
    } else {
        if (!is_true(shape)) {
            file_.fault(shape, {lang::joints::a_tip_is_tip_true});
            return false;
        }
        joint.profiles.emplace(on, TipProfile{});
    }
    return on != none;
}

}  // namespace kinegraph
