#include "engine/reading/sections.hpp"
#include "lang/keys/loads.hpp"

#include <utility>

namespace kinegraph {
namespace {

constexpr FormRow effort_force =
    FormRow("force", "name", values::name).needed(lang::loads::the_force_name).called(lang::loads::the_force_name);
constexpr std::array couple_effort_rows{
    leading_key("couple", "name", values::name).called(lang::loads::the_couple_name),
    FormRow("body", "i", values::body_name).needed(lang::loads::the_body_on_which_it_acts),
    FormRow("from", "j", values::body_name, "The body from which it acts; the frame if left out.")};
constexpr std::array force_effort_rows{
    effort_force, FormRow("body", "i", values::body_name).needed(lang::loads::the_body_on_which_it_acts_or),
    FormRow("at", "P", values::point_name).needed(lang::loads::the_point_at_which_it_acts),
    FormRow("along", "X", values::direction).needed(lang::loads::the_direction_of_the_force)};
constexpr std::array actuator_rows{effort_force,
                                   leading_key("joint", "name", values::joint_name, "The name of a prismatic joint.")};
constexpr std::array<std::string_view, 1> not_of_couple_efforts{"force"};
constexpr std::array<std::string_view, 2> not_of_force_efforts{"couple", "joint"};
constexpr Form couple_effort_form{lang::loads::a_couple_that_balances, couple_effort_rows,
                                  "A couple, counter-clockwise positive.", not_of_couple_efforts};
constexpr Form force_effort_form{lang::loads::a_force_that_balances, force_effort_rows, "A force, positive along X.",
                                 not_of_force_efforts};
constexpr Form actuator_form{lang::loads::an_actuator, actuator_rows, "An actuator: +X on i, −X on j."};
constexpr std::array effort_choices{values::object(couple_effort_form), values::object(force_effort_form),
                                    values::object(actuator_form)};
constexpr FormValue one_effort =
    values::any(effort_choices).named("oneEffort", "An unknown force or couple that balances.");
constexpr std::array efforts_choices{values::list(one_effort), one_effort};

Words nothing_moves_the_frame() { return {lang::loads::an_effort_on_the_frame_balances}; }

}  // namespace

constinit const FormValue forms::effort = values::any(efforts_choices);

void EffortsSection::read_effort(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::loads::an_effort})) return;
    const Named name = value["couple"]  ? read_couple_effort(value)
                       : value["joint"] ? read_actuator(value)
                                        : read_force_effort(value);
    if (!name.text.empty() && !effort_names_.insert(name.text).second) {
        file_.fault(name.at, {lang::loads::two_efforts_are_named_results_go, quoted(name.text)});
    }
}

EffortsSection::Named EffortsSection::read_couple_effort(JsonValue value) {
    const Members form = file_.members(value, couple_effort_form);
    file_.one_of(form, {"couple", "force"});
    Named name{form.name("couple"), form["couple"]};
    CoupleEffort couple;
    couple.where = value.pointer();
    couple.body = form.body("body");
    if (form["from"]) couple.from = form.body("from");
    if (couple.body != none && couple.body == couple.from) {
        file_.fault(form["from"] ? form["from"] : form["body"],
                    form["from"] ? Words(lang::loads::a_couple_from_a_body) : nothing_moves_the_frame());
    }
    couple.name = name.text;
    mechanism_.efforts.emplace_back(std::move(couple));
    return name;
}

EffortsSection::Named EffortsSection::read_actuator(JsonValue value) {
    const Members form = file_.members(value, actuator_form);
    Named name{form.name("force"), form["force"]};
    ActuatorEffort actuator;
    actuator.where = value.pointer();
    const Words remedy(lang::loads::an_actuator_works_in_a_prismatic);
    actuator.joint = joints_.sliding_joint(form["joint"], remedy);
    if (actuator.joint != none) {
        const PlanePair& pair = mechanism_.joint(actuator.joint).pair();
        if (!pair.is_sleeve()) joints_.wrong_kind(form["joint"], pair.key, remedy);
    }
    actuator.name = name.text;
    mechanism_.efforts.emplace_back(std::move(actuator));
    return name;
}

EffortsSection::Named EffortsSection::read_force_effort(JsonValue value) {
    const Members form = file_.members(value, force_effort_form);
    if (form.is_of_another_form()) return {};
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {lang::loads::the_effort_name_is_missing_force});
        return {};
    }
    Named name{form.name("force"), form["force"]};
    ForceEffort force;
    force.where = value.pointer();
    force.body = file_.moving_body(form.value("body"), nothing_moves_the_frame());
    force.at = form.point("at");
    force.along = form.bearing_or_default("along");
    force.name = name.text;
    mechanism_.efforts.emplace_back(std::move(force));
    return name;
}

}  // namespace kinegraph
