#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/loads.hpp"

#include <utility>

namespace kinegraph {
namespace {

constexpr std::array mass_rows{
    FormRow("mass", "m", values::mass).needed(lang::loads::how_much).not_negative(lang::common::a_mass),
    FormRow("centre", "P", values::point_name, "The centre of mass.").needed(lang::loads::the_centre_of_mass),
    FormRow("inertia", "J", values::inertia, "About the centre of mass.")
        .not_negative(lang::common::a_moment_of_inertia)};
constexpr Form mass_form{lang::loads::a_body_mass, mass_rows};

constexpr FormRow load_body = FormRow("body", "i", values::body_name).needed(lang::loads::the_body_on_which_it_acts);
constexpr FormRow load_at = FormRow("at", "P", values::point_name).needed(lang::loads::the_point_at_which_it_acts);
constexpr FormRow load_name =
    FormRow("force", "name", values::name).needed(lang::loads::the_force_name).called(lang::loads::the_force_name);
/// What gives the size of a force; which of them go together is in the choices.
constexpr FormRow load_value =
    FormRow("value", "[Fx, Fy]", values::forces, "The components [Fx, Fy].").called(lang::loads::a_force_fx_fy);
constexpr FormRow load_magnitude("magnitude", "F", values::force);
constexpr FormRow load_along = FormRow("along", "X", values::direction).needed(lang::loads::the_direction_of_the_force);
constexpr FormRow load_pressure("pressure", "p", values::pressure);
constexpr FormRow load_area = FormRow("area", "A", values::quantity(QuantityKind::area))
                                  .needed(lang::loads::the_area_on_which_it_presses)
                                  .not_negative(lang::common::an_area);

constexpr FormRow force_name = load_name.needed(lang::loads::the_force_name_or_couple);
constexpr std::array force_rows{force_name,     load_body,  load_at,       load_value,
                                load_magnitude, load_along, load_pressure, load_area};
constexpr std::array force_choices{
    Form::Choice{"A force by its components.", {"force", "body", "at", "value"}},
    Form::Choice{"A force by magnitude and direction.", {"force", "body", "at", "magnitude", "along"}},
    Form::Choice{"A force by a pressure on an area and its direction.",
                 {"force", "body", "at", "pressure", "area", "along"}}};
constexpr FormRow loaded_pin = leading_key("pin", "P", values::joint_name, "A hinge, by its name or its point.");
constexpr std::array pin_rows{load_name, loaded_pin, load_value, load_magnitude, load_along, load_pressure, load_area};
constexpr std::array pin_choices{
    Form::Choice{"A load on the pin of a hinge, by components.", {"force", "pin", "value"}},
    Form::Choice{"A load on the pin of a hinge, by magnitude and direction.", {"force", "pin", "magnitude", "along"}},
    Form::Choice{"A load on the pin of a hinge, by a pressure on an area.",
                 {"force", "pin", "pressure", "area", "along"}}};

constexpr FormRow two_bodies_of_load = FormRow("bodies", "[i, j]", values::two_bodies, "The two bodies i, j.")
                                           .needed(lang::loads::the_two_bodies_that_are_pulled);
constexpr FormRow ends_of_load =
    FormRow("between", "[P, Q]", values::two_points).needed(lang::loads::the_two_points_at_which_they);
constexpr FormRow spring_name = leading_key("spring", "name", values::name).called(lang::loads::the_spring_name);
constexpr FormRow stiffness_row(QuantityKind kind) {
    return FormRow("stiffness", "k", values::quantity(kind))
        .needed(lang::loads::how_stiff_the_spring)
        .not_negative(lang::loads::a_stiffness);
}
constexpr std::array couple_rows{leading_key("couple", "name", values::name).called(lang::loads::the_couple_name),
                                 load_body, FormRow("value", "M", values::moment).needed(lang::loads::the_couple_size)};
constexpr FormValue intensity = values::quantity(QuantityKind::force_per_length);
constexpr std::array distributed_rows{
    leading_key("distributed", "name", values::name).called(lang::loads::the_load_name),
    load_body,
    FormRow("from", "P", values::point_name).needed(lang::loads::the_point_where_it_begins),
    FormRow("to", "Q", values::point_name).needed(lang::loads::the_point_where_it_ends),
    FormRow("intensity", "[q0, q1]", values::list(intensity, 2, 2))
        .needed(lang::loads::the_intensities_at_both_ends_q0),
    FormRow("along", "X", values::direction).needed(lang::loads::the_direction_of_the_load)};
constexpr std::array rope_rows{load_name, two_bodies_of_load, ends_of_load,
                               FormRow("magnitude", "T", values::force).needed(lang::loads::how_hard_they_are_pulled)};
constexpr std::array spring_rows{spring_name, two_bodies_of_load, ends_of_load,
                                 stiffness_row(QuantityKind::force_per_length),
                                 FormRow("free length", "l", values::length)
                                     .needed(lang::loads::how_long_it_is_without_force)
                                     .not_negative(lang::loads::a_free_length)};
constexpr std::array torsion_rows{
    spring_name, two_bodies_of_load.needed(lang::loads::the_two_bodies_that_it_turns),
    FormRow("at", "P", values::point_name).needed(lang::loads::the_point),
    stiffness_row(QuantityKind::torsional_stiffness),
    FormRow("turned", "a", values::angle).needed(lang::loads::by_how_much_the_first_body)};

constexpr std::array<std::string_view, 4> other_loads{"couple", "bodies", "between", "pin"};
constexpr std::array<std::string_view, 1> not_of_couples{"force"};
constexpr Form force_form{lang::common::a_force, force_rows, {}, other_loads, force_choices};
constexpr Form pin_form{lang::common::a_force, pin_rows, {}, {}, pin_choices};
constexpr Form couple_form{lang::loads::a_couple, couple_rows, "A couple.", not_of_couples};
constexpr Form distributed_form{lang::loads::a_distributed_load, distributed_rows,
                                "A load along PQ; its intensity runs straight from q0 at P to q1 at Q."};
constexpr Form rope_form{lang::loads::a_force_between_two_bodies, rope_rows,
                         "A rope or spring of given force: pulls P of i and Q of j together, pushes them apart where "
                         "negative (a gas spring)."};
constexpr Form spring_form{lang::loads::a_spring, spring_rows, "An elastic spring: pulls with k (l - l0)."};
constexpr Form torsion_form{lang::loads::a_torsion_spring, torsion_rows,
                            "A torsion spring: turns i back with k times its turn against j."};
constexpr std::array load_choices{values::object(force_form),  values::object(pin_form),
                                  values::object(couple_form), values::object(distributed_form),
                                  values::object(rope_form),   values::object(spring_form),
                                  values::object(torsion_form)};

}  // namespace

constinit const FormValue forms::mass =
    values::object(mass_form).named("massOfBody", "Mass, centre of mass and moment of inertia about it.");
constinit const FormValue forms::load = values::any(load_choices).named("load", "A given force or couple.");

void LoadsSection::read_masses(const Members& file) {
    file.each("masses", [&](JsonValue member) {
        Mass mass;
        mass.where = member.pointer();
        mass.body = file_.look_up_body(member, member.key());
        if (!file_.expect(member, Kind::object, {lang::loads::mass_centre_inertia})) return;
        const Members form = file_.members(member, mass_form);
        mass.mass = form.quantity_or_default("mass");
        mass.centre = form.point("centre");
        mass.inertia = form.quantity_or_default("inertia");
        // Its acceleration is asked for, whether the body's list names it or not.
        if (mechanism_.inertia_forces) bodies_.carry(mass.body, mass.centre);
        mechanism_.masses.push_back(std::move(mass));
    });
}

void LoadsSection::read_load(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::loads::a_load})) return;
    if (value["couple"]) {
        const Members form = file_.members(value, couple_form);
        file_.one_of(form, {"couple", "force"});
        CoupleLoad couple;
        couple.where = value.pointer();
        couple.name = name_of_load(form, "couple");
        couple.body = form.body("body");
        couple.value = form.quantity_or_default("value");
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

std::string LoadsSection::name_of_load(const Members& form, std::string_view key) {
    std::string name = form.name(key);
    if (!name.empty() && !load_names_.insert(name).second)
        file_.fault(form[key], {lang::loads::two_loads_are_named_figures_go, quoted(name)});
    return name;
}

void LoadsSection::read_force(JsonValue value) {
    const Members form = file_.members(value, force_form);
    if (form.is_of_another_form()) return;
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {lang::loads::the_load_name_is_missing_force});
        return;
    }
    ForceLoad force;
    force.where = value.pointer();
    force.name = name_of_load(form, "force");
    force.body = form.body("body");
    force.at = form.point("at");
    read_size(form, force);
    mechanism_.loads.emplace_back(std::move(force));
}

void LoadsSection::read_pin_load(JsonValue value) {
    const Members form = file_.members(value, pin_form);
    ForceLoad force;
    force.where = value.pointer();
    force.name = name_of_load(form, "force");
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
        force.value = form.vector("value");
    } else if (how) {
        const auto magnitude = how.key() == "pressure" ? pressure_on_area(form) : form.quantity("magnitude");
        const auto along = form.bearing("along");
        if (magnitude && along) force.magnitude = {*magnitude, *along};
    }
    if (form["area"] && !form["pressure"]) file_.fault(form["area"], {lang::loads::area_goes_with_a_pressure_give});
}

std::optional<Exact> LoadsSection::pressure_on_area(const Members& form) {
    const auto pressure = form.quantity("pressure");
    if (!form.value("area") || !pressure) return std::nullopt;
    return *pressure * form.quantity_or_default("area");
}

void LoadsSection::read_spring(JsonValue value) {
    const Members form = file_.members(value, rope_form);
    SpringLoad spring;
    spring.where = value.pointer();
    spring.name = name_of_load(form, "force");
    read_ends(form, spring);
    spring.magnitude = form.quantity_or_default("magnitude");
    mechanism_.loads.emplace_back(std::move(spring));
}

void LoadsSection::read_ends(const Members& form, SpringLoad& spring) {
    if (const JsonValue bodies = form.value("bodies")) spring.bodies = two_bodies(bodies);
    if (const JsonValue ends = form.value("between")) {
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
    const Members form = file_.members(value, of_torsion ? torsion_form : spring_form);
    const std::string name = name_of_load(form, "spring");
    const Exact stiffness = form.quantity_or_default("stiffness");
    if (!of_torsion) {
        SpringLoad spring;
        spring.where = value.pointer();
        spring.name = name;
        read_ends(form, spring);
        spring.elastic = SpringLoad::Elastic{stiffness, form.quantity_or_default("free length")};
        mechanism_.loads.emplace_back(std::move(spring));
        return;
    }
    TorsionLoad torsion;
    torsion.where = value.pointer();
    torsion.name = name;
    if (const JsonValue bodies = form.value("bodies")) torsion.bodies = two_bodies(bodies);
    torsion.at = form.point("at");
    torsion.stiffness = stiffness;
    torsion.turned = form.quantity_or_default("turned");
    mechanism_.loads.emplace_back(std::move(torsion));
}

void LoadsSection::read_distributed(JsonValue value) {
    const Members form = file_.members(value, distributed_form);
    DistributedLoad load;
    load.where = value.pointer();
    load.name = name_of_load(form, "distributed");
    load.body = form.body("body");
    load.from = form.point("from");
    load.to = form.point("to");
    if (load.from != none && load.from == load.to) file_.fault(form["to"], {lang::loads::a_load_from_a_point});
    const JsonValue ends = form.value("intensity");
    if (ends && (!ends.is_array() || ends.size() != 2)) {
        file_.fault(ends, {lang::loads::the_intensities_at_both_ends_q0_q1, described(ends)});
    } else if (ends) {
        load.intensity = {file_.quantity_or_zero(*ends.begin(), intensity.kind),
                          file_.quantity_or_zero(*++ends.begin(), intensity.kind)};
    }
    load.along = form.bearing_or_default("along");
    mechanism_.loads.emplace_back(std::move(load));
}

}  // namespace kinegraph
