#include "engine/reading/sections.hpp"
#include "lang/keys/loads.hpp"

#include <utility>

namespace kinegraph {
namespace {

Words nothing_moves_the_frame() { return {lang::loads::an_effort_on_the_frame_balances}; }

}  // namespace

void EffortsSection::read_effort(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::loads::an_effort})) return;
    const Named name = value["couple"]  ? read_couple_effort(value)
                       : value["joint"] ? read_actuator(value)
                                        : read_force_effort(value);
    if (!name.text.empty() && !effort_names_.insert(name.text).second) {
        file_.fault(name.at, {lang::loads::two_efforts_are_named_results_go, quoted(name.text)});
    }
}

EffortsSection::Named EffortsSection::effort_name(JsonValue given, const Words& wanted) {
    return {given ? std::string(file_.new_name(given, wanted)) : std::string(), given};
}

EffortsSection::Named EffortsSection::read_couple_effort(JsonValue value) {
    const Members form =
        file_.members(value, {"couple", "body", "from", "force"}, {lang::loads::a_couple_that_balances});
    file_.one_of(form, {"couple", "force"});
    Named name = effort_name(form["couple"], {lang::loads::the_couple_name});
    CoupleEffort couple;
    couple.where = value.pointer();
    couple.body = file_.body(file_.required(form, "body", {lang::loads::the_body_on_which_it_acts}));
    if (const JsonValue from = form["from"]) couple.from = file_.body(from);
    if (couple.body != none && couple.body == couple.from) {
        file_.fault(form["from"] ? form["from"] : form["body"],
                    form["from"] ? Words(lang::loads::a_couple_from_a_body) : nothing_moves_the_frame());
    }
    couple.name = name.text;
    mechanism_.efforts.emplace_back(std::move(couple));
    return name;
}

EffortsSection::Named EffortsSection::read_actuator(JsonValue value) {
    const Members form = file_.members(value, {"force", "joint"}, {lang::loads::an_actuator});
    Named name =
        effort_name(file_.required(form, "force", {lang::loads::the_force_name}), {lang::loads::the_force_name});
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
    const Members form =
        file_.members(value, {"force", "body", "at", "along", "couple", "joint"}, {lang::loads::a_force_that_balances});
    if (form.has_or_misspells("couple") || form.has_or_misspells("joint")) return {};
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {lang::loads::the_effort_name_is_missing_force});
        return {};
    }
    Named name = effort_name(form["force"], {lang::loads::the_force_name});
    ForceEffort force;
    force.where = value.pointer();
    force.body = file_.moving_body(file_.required(form, "body", {lang::loads::the_body_on_which_it_acts_or}),
                                   nothing_moves_the_frame());
    force.at = file_.point(file_.required(form, "at", {lang::loads::the_point_at_which_it_acts}));
    force.along = file_.bearing_or_default(file_.required(form, "along", {lang::loads::the_direction_of_the_force}));
    force.name = name.text;
    mechanism_.efforts.emplace_back(std::move(force));
    return name;
}

}  // namespace kinegraph
