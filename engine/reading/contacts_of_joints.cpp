#include "engine/reading/materials.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/joints.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace kinegraph {
namespace {

constexpr std::array material_rows{Materials::name_row, Materials::young_row, Materials::poisson_row,
                                   Materials::depth_row};
constexpr Form material_form{lang::joints::a_material, material_rows};
constexpr std::array material_choices{values::defined(forms::material_name), values::object(material_form)};
constexpr FormValue one_material =
    values::any(material_choices)
        .named("material", "A material known by name, or young and poisson; depth as in a Hertz problem.");
constexpr std::array contact_material_choices{values::defined(forms::material_name),
                                              values::map(one_material, 2, 2).with(values::by_body)};

}  // namespace

constinit const FormValue forms::contact_materials =
    values::any(contact_material_choices)
        .named("contactMaterials",
               "Hertzian contact under the force found: one material for both bodies, or by body. With \"length\".");

void ContactsOfJoints::read(const Members& form, const Joint& joint, JointIndex index) {
    const JsonValue materials = form["materials"];
    if (!materials) {
        if (form["length"] && !form.has_or_misspells("materials"))
            file_.fault(form["length"], {lang::joints::a_contact_has_a_length});
        return;
    }
    LoadedContact contact;
    contact.joint = index;
    contact.where = materials.pointer();
    read_bodies(materials, joint, contact);
    file_.required(form, "length", {lang::common::the_length_of_contact});
    contact.length = form.quantity_or_default("length");
    check_profiles(materials, form, joint);
    contacts_.push_back(std::move(contact));
}

/// One material by name for both, or an object: by body a name or {"material" | "young", "poisson"}.
void ContactsOfJoints::read_bodies(JsonValue materials, const Joint& joint, LoadedContact& contact) {
    if (joint.bodies.size() != 2) return;
    for (std::size_t i = 0; i < 2; ++i) {
        contact.bodies.at(i).body = joint.bodies[i];
        contact.bodies.at(i).young = 1;
        contact.bodies.at(i).where = materials.pointer();
        if (materials.is_string()) materials_.read_by_name(materials, contact.bodies.at(i));
        if (materials.is_string() && contact.bodies.at(i).young == Exact(1)) return;  // report it only once
    }
    if (materials.is_string() || !file_.expect(materials, Kind::object, {lang::joints::a_material_or_an_object}))
        return;
    std::array<bool, 2> given{};
    for (const JsonValue member : materials) {
        const BodyIndex on = file_.look_up_body(member, member.key());
        if (on == none) return;
        if (!joint.connects(on)) {
            file_.fault(member, {lang::joints::the_body_is_not, quoted(member.key())});
            return;
        }
        const std::size_t i = joint.bodies[0] == on ? 0 : 1;
        given.at(i) = true;
        ElasticBody& body = contact.bodies.at(i);
        body.where = member.pointer();
        if (member.is_string())
            materials_.read_by_name(member, body);
        else if (file_.expect(member, Kind::object, {lang::joints::a_material})) {
            const Members properties = file_.members(member, material_form);
            materials_.read(properties, body);
            if (properties["depth"]) body.depth = properties.quantity_or_default("depth");
        }
    }
    for (std::size_t i = 0; i < 2; ++i)
        if (!given.at(i) && joint.bodies[i] != none)
            file_.fault(materials,
                        {lang::joints::the_material_of_body_is_missing, quoted(mechanism_.body(joint.bodies[i]).name)});
}

/// The theory of contact needs curvatures: two smooth profiles, or teeth of known pressure angle.
void ContactsOfJoints::check_profiles(JsonValue materials, const Members& form, const Joint& joint) {
    if (form["tangent"]) {
        file_.fault(form["tangent"], {lang::joints::contact_with_materials_asks_for_radii});
        return;
    }
    for (const auto& [body, profile] : joint.profiles)
        if (std::holds_alternative<TipProfile>(profile)) {
            file_.fault(materials, {lang::joints::a_tip_has_no_radius});
            return;
        }
    if (joint.pressure_angle && joint.pressure_angle->value.is_zero())
        file_.fault(form["pressure angle"], {lang::joints::teeth_that_press_each_other});
    if (joint.pair().meshes() && !form.has_or_misspells("pressure angle"))
        file_.fault(materials, {lang::joints::the_radii_of_teeth});
}

}  // namespace kinegraph
