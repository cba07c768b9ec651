#include "engine/reading/problem_sections.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace kinegraph {

void ContactsOfJoints::read(const Members& form, const Joint& joint, JointIndex index) {
    const JsonValue materials = form["materials"];
    if (!materials) {
        if (form["length"] && !form.has_or_misspells("materials"))
            file_.fault(form["length"],
                        {"a contact has a \"length\" where it has \"materials\"; give them, or take it out",
                         "un contatto ha \"length\" dove ha \"materials\"; assegnarli, o toglierla"});
        return;
    }
    LoadedContact contact;
    contact.joint = index;
    contact.where = materials.pointer();
    read_bodies(materials, joint, contact);
    contact.length = file_.positive(
        file_.required(form, "length", {"how long the line of contact is", "quanto è lunga la linea di contatto"}),
        QuantityKind::length, {"the length", "la lunghezza"});
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
    if (materials.is_string() || !file_.expect(materials, Kind::object,
                                               {"a material, or an object of materials by body,",
                                                "un materiale, o un oggetto con i materiali per corpo,"}))
        return;
    std::array<bool, 2> given{};
    for (const JsonValue member : materials) {
        const BodyIndex on = file_.look_up_body(member, member.key());
        if (on == none) return;
        if (!joint.connects(on)) {
            file_.fault(member, {"the body {0} is not in this joint", "il corpo {0} non è in questa coppia",
                                 quoted(member.key())});
            return;
        }
        const std::size_t i = joint.bodies[0] == on ? 0 : 1;
        given.at(i) = true;
        HertzBody& body = contact.bodies.at(i);
        body.where = member.pointer();
        if (member.is_string())
            materials_.read_by_name(member, body);
        else if (file_.expect(member, Kind::object, {"a material", "un materiale"})) {
            const Members properties =
                file_.members(member, {"material", "young", "poisson", "depth"}, {"a material", "un materiale"});
            materials_.read(properties, body);
            if (properties["depth"])
                body.depth = file_.positive(properties["depth"], QuantityKind::length, {"the depth", "la profondità"});
        }
    }
    for (std::size_t i = 0; i < 2; ++i)
        if (!given.at(i) && joint.bodies[i] != none)
            file_.fault(materials, {"the material of body {0} is missing; both bodies yield",
                                    "manca il materiale del corpo {0}; cedono entrambi i corpi",
                                    quoted(mechanism_.body(joint.bodies[i]).name)});
}

/// Hertz's theory needs curvatures: two smooth profiles, or teeth of known pressure angle.
void ContactsOfJoints::check_profiles(JsonValue materials, const Members& form, const Joint& joint) {
    if (form["tangent"]) {
        file_.fault(form["tangent"],
                    {"contact with \"materials\" asks for radii; give \"profiles\" in place of a tangent",
                     "un contatto con \"materials\" richiede i raggi; dare \"profiles\" al posto della tangente"});
        return;
    }
    for (const auto& [body, profile] : joint.profiles)
        if (std::holds_alternative<TipProfile>(profile)) {
            file_.fault(
                materials,
                {"a tip has no radius, and its pressure no bound; round it to a circle, or take \"materials\" out",
                 "una punta non ha raggio, e la pressione non ha limite; arrotondarla a un cerchio, o togliere "
                 "\"materials\""});
            return;
        }
    if (joint.pressure_angle && joint.pressure_angle->value.is_zero())
        file_.fault(
            form["pressure angle"],
            {"teeth that press each other have a pressure angle larger than 0°, else their radii vanish",
             "denti che si premono hanno un angolo di pressione maggiore di 0°, altrimenti i raggi si annullano"});
    if (joint.pair().meshes() && !form.has_or_misspells("pressure angle"))
        file_.fault(materials, {"the radii of teeth at the pitch point want a \"pressure angle\"; give it",
                                "i raggi dei denti nel punto primitivo richiedono un \"pressure angle\"; assegnarlo"});
}

}  // namespace kinegraph
