#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/loads.hpp"

#include <utility>

namespace kinegraph {

void LoadsSection::read_masses(JsonValue masses) {
    if (!masses || !file_.expect(masses, Kind::object, {lang::loads::an_object_of_masses_by_body})) return;
    for (const JsonValue member : masses) {
        Mass mass;
        mass.where = member.pointer();
        mass.body = file_.look_up_body(member, member.key());
        if (!file_.expect(member, Kind::object, {lang::loads::mass_centre_inertia})) continue;
        const Members form = file_.members(member, {"mass", "centre", "inertia"}, {lang::loads::a_body_mass});
        mass.mass = file_.not_negative(file_.required(form, "mass", {lang::loads::how_much}), QuantityKind::mass,
                                       {lang::common::a_mass});
        mass.centre = file_.point(file_.required(form, "centre", {lang::loads::the_centre_of_mass}));
        mass.inertia = file_.not_negative(form["inertia"], QuantityKind::inertia, {lang::common::a_moment_of_inertia});
        mechanism_.masses.push_back(std::move(mass));
    }
}

void LoadsSection::read_load(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::loads::a_load})) return;
    if (value["couple"]) {
        const Members form = file_.members(value, {"couple", "body", "value", "force"}, {lang::loads::a_couple});
        file_.one_of(form, {"couple", "force"});
        CoupleLoad couple;
        couple.where = value.pointer();
        couple.name = name_of_load(form["couple"], {lang::loads::the_couple_name});
        couple.body = file_.body(file_.required(form, "body", {lang::loads::the_body_on_which_it_acts}));
        couple.value =
            file_.quantity_or_zero(file_.required(form, "value", {lang::loads::the_couple_size}), QuantityKind::moment);
        mechanism_.loads.emplace_back(std::move(couple));
    } else if (value["spring"]) {
        read_elastic(value);
    } else if (value["distributed"]) {
        read_distributed(value);
    } else if (value["bodies"] || value["between"]) {
        read_spring(value);
    } else if (value["pin"]) {
        read_pin_load(value);
    } else {
        read_force(value);
    }
}

std::string LoadsSection::name_of_load(JsonValue value, const Words& wanted) {
    std::string name = file_.new_name(value, wanted);
    if (!name.empty() && !load_names_.insert(name).second)
        file_.fault(value, {lang::loads::two_loads_are_named_figures_go, quoted(name)});
    return name;
}

void LoadsSection::read_force(JsonValue value) {
    const Members form = file_.members(value,
                                       {"force", "body", "at", "value", "magnitude", "along", "pressure", "area",
                                        "couple", "bodies", "between", "pin"},
                                       {lang::common::a_force});
    for (const std::string_view key : {"couple", "bodies", "between", "pin"})
        if (form.has_or_misspells(key)) return;
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {lang::loads::the_load_name_is_missing_force});
        return;
    }
    ForceLoad force;
    force.where = value.pointer();
    if (const JsonValue name = file_.required(form, "force", {lang::loads::the_force_name_or_couple}))
        force.name = name_of_load(name, {lang::loads::the_force_name});
    force.body = file_.body(file_.required(form, "body", {lang::loads::the_body_on_which_it_acts}));
    force.at = file_.point(file_.required(form, "at", {lang::loads::the_point_at_which_it_acts}));
    read_size(form, force);
    mechanism_.loads.emplace_back(std::move(force));
}

void LoadsSection::read_pin_load(JsonValue value) {
    const Members form = file_.members(value, {"force", "pin", "value", "magnitude", "along", "pressure", "area"},
                                       {lang::common::a_force});
    ForceLoad force;
    force.where = value.pointer();
    if (const JsonValue name = file_.required(form, "force", {lang::loads::the_force_name}))
        force.name = name_of_load(name, {lang::loads::the_force_name});
    force.pin = joints_.hinge(form["pin"]);
    if (force.pin != none) {
        Joint& joint = mechanism_.joints[at_index(force.pin)];
        joint.loaded_pin = true;
        force.at = joint.point;
    }
    read_size(form, force);
    mechanism_.loads.emplace_back(std::move(force));
}

void LoadsSection::read_size(const Members& form, ForceLoad& force) {
    const JsonValue how = form["pressure"] ? file_.one_of(form, {"value", "magnitude", "pressure"})
                                           : file_.one_of(form, {"value", "magnitude"});
    if (how && how.key() == "value") {
        file_.one_of(form, {"value", "along"});
        force.value = file_.vector(how, QuantityKind::force, {lang::loads::a_force_fx_fy});
    } else if (how) {
        const auto magnitude =
            how.key() == "pressure" ? pressure_on_area(form) : file_.quantity(how, QuantityKind::force);
        const auto along = file_.bearing(file_.required(form, "along", {lang::loads::the_direction_of_the_force}));
        if (magnitude && along) force.magnitude = {*magnitude, *along};
    }
    if (form["area"] && !form["pressure"]) file_.fault(form["area"], {lang::loads::area_goes_with_a_pressure_give});
}

std::optional<Exact> LoadsSection::pressure_on_area(const Members& form) {
    const auto pressure = file_.quantity(form["pressure"], QuantityKind::pressure);
    const JsonValue on = file_.required(form, "area", {lang::loads::the_area_on_which_it_presses});
    if (!on || !pressure) return std::nullopt;
    return *pressure * file_.not_negative(on, QuantityKind::area, {lang::common::an_area});
}

void LoadsSection::read_spring(JsonValue value) {
    const Members form =
        file_.members(value, {"force", "bodies", "between", "magnitude"}, {lang::loads::a_force_between_two_bodies});
    SpringLoad spring;
    spring.where = value.pointer();
    if (const JsonValue name = file_.required(form, "force", {lang::loads::the_force_name}))
        spring.name = name_of_load(name, {lang::loads::the_force_name});
    read_ends(form, spring);
    spring.magnitude = file_.quantity_or_zero(
        file_.required(form, "magnitude", {lang::loads::how_hard_they_are_pulled}), QuantityKind::force);
    mechanism_.loads.emplace_back(std::move(spring));
}

void LoadsSection::read_ends(const Members& form, SpringLoad& spring) {
    if (const JsonValue bodies = file_.required(form, "bodies", {lang::loads::the_two_bodies_that_are_pulled}))
        spring.bodies = two_bodies(bodies);
    if (const JsonValue ends = file_.required(form, "between", {lang::loads::the_two_points_at_which_they})) {
        if (ends.is_array() && ends.size() == 2) {
            const Bearing::Between points = file_.between(ends);
            spring.between = {points.from, points.to};
        } else {
            file_.fault(ends, {lang::loads::two_points_are_wanted_here_not, described(ends)});
        }
    }
}

std::array<BodyIndex, 2> LoadsSection::two_bodies(JsonValue bodies) {
    if (!bodies.is_array() || bodies.size() != 2) {
        file_.fault(bodies, {lang::loads::two_bodies_are_wanted_here_not, described(bodies)});
        return {none, none};
    }
    const JsonValue second = *++bodies.begin();
    const std::array<BodyIndex, 2> both{file_.body(*bodies.begin()), file_.body(second)};
    if (both[0] != none && both[0] == both[1])
        file_.fault(second, {lang::loads::the_body_stands_twice_a_spring, quoted(second.text())});
    return both;
}

void LoadsSection::read_elastic(JsonValue value) {
    const bool of_torsion = value["turned"] || value["at"];
    const Members form = of_torsion ? file_.members(value, {"spring", "bodies", "at", "stiffness", "turned"},
                                                    {lang::loads::a_torsion_spring})
                                    : file_.members(value, {"spring", "bodies", "between", "stiffness", "free length"},
                                                    {lang::loads::a_spring});
    const std::string name = name_of_load(form["spring"], {lang::loads::the_spring_name});
    const JsonValue stiffness = file_.required(form, "stiffness", {lang::loads::how_stiff_the_spring});
    const Words called(lang::loads::a_stiffness);
    if (!of_torsion) {
        SpringLoad spring;
        spring.where = value.pointer();
        spring.name = name;
        read_ends(form, spring);
        spring.elastic = SpringLoad::Elastic{
            file_.not_negative(stiffness, QuantityKind::force_per_length, called),
            file_.not_negative(file_.required(form, "free length", {lang::loads::how_long_it_is_without_force}),
                               QuantityKind::length, {lang::loads::a_free_length})};
        mechanism_.loads.emplace_back(std::move(spring));
        return;
    }
    TorsionLoad torsion;
    torsion.where = value.pointer();
    torsion.name = name;
    if (const JsonValue bodies = file_.required(form, "bodies", {lang::loads::the_two_bodies_that_it_turns}))
        torsion.bodies = two_bodies(bodies);
    torsion.at = file_.point(file_.required(form, "at", {lang::loads::the_point}));
    torsion.stiffness = file_.not_negative(stiffness, QuantityKind::torsional_stiffness, called);
    torsion.turned = file_.quantity_or_zero(file_.required(form, "turned", {lang::loads::by_how_much_the_first_body}),
                                            QuantityKind::angle);
    mechanism_.loads.emplace_back(std::move(torsion));
}

void LoadsSection::read_distributed(JsonValue value) {
    const Members form = file_.members(value, {"distributed", "body", "from", "to", "intensity", "along"},
                                       {lang::loads::a_distributed_load});
    DistributedLoad load;
    load.where = value.pointer();
    load.name = name_of_load(form["distributed"], {lang::loads::the_load_name});
    load.body = file_.body(file_.required(form, "body", {lang::loads::the_body_on_which_it_acts}));
    load.from = file_.point(file_.required(form, "from", {lang::loads::the_point_where_it_begins}));
    load.to = file_.point(file_.required(form, "to", {lang::loads::the_point_where_it_ends}));
    if (load.from != none && load.from == load.to) file_.fault(form["to"], {lang::loads::a_load_from_a_point});
    const JsonValue intensity = file_.required(form, "intensity", {lang::loads::the_intensities_at_both_ends_q0});
    if (intensity && (!intensity.is_array() || intensity.size() != 2)) {
        file_.fault(intensity, {lang::loads::the_intensities_at_both_ends_q0_q1, described(intensity)});
    } else if (intensity) {
        load.intensity = {file_.quantity_or_zero(*intensity.begin(), QuantityKind::force_per_length),
                          file_.quantity_or_zero(*++intensity.begin(), QuantityKind::force_per_length)};
    }
    load.along = file_.bearing_or_default(file_.required(form, "along", {lang::loads::the_direction_of_the_load}));
    mechanism_.loads.emplace_back(std::move(load));
}

}  // namespace kinegraph
