// The materials of contacts: of two bodies that are pressed together, and at joints of a mechanism.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "engine/mechanism/contact.hpp"
#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/materials.hpp"

namespace kinegraph {

// ----- The material of a body in contact: by name, or Young's modulus and Poisson's ratio.

class Materials {
public:
    explicit Materials(FormReader& file) : file_(file) {}

    /// From a form with "material", or "young" and "poisson".
    void read(const Members& form, ElasticBody& body);
    void read_by_name(JsonValue name, ElasticBody& body);

    static constexpr FormRow name_row{"material", "…", values::defined(forms::material_name),
                                      "A material known by name, in place of young and poisson."};
    static constexpr FormRow young_row =
        FormRow("young", "E", values::pressure, "Young's modulus.").positive(lang::materials::young_modulus);
    static constexpr FormRow poisson_row =
        FormRow("poisson", "ν", values::number, "Poisson's ratio.").within(R"("minimum": 0, "exclusiveMaximum": 0.5)");
    static constexpr FormRow depth_row = FormRow("depth", "d", values::length).positive(lang::common::the_depth);

private:
    FormReader& file_;
};

// ----- The "materials" and the "length" of a joint with contact. Force and radii come from the mechanism.

class ContactsOfJoints {
public:
    ContactsOfJoints(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism), materials_(file) {}

    /// Reads the contact of the joint that will have that index, if it has materials.
    void read(const Members& form, const Joint& joint, JointIndex index);
    /// Moves out the contacts read so far.
    LoadedContacts take() { return std::move(contacts_); }

private:
    using Kind = FormReader::Kind;

    void read_bodies(JsonValue materials, const Joint& joint, LoadedContact& contact);
    void check_profiles(JsonValue materials, const Members& form, const Joint& joint);

    FormReader& file_;
    Mechanism& mechanism_;
    Materials materials_;
    LoadedContacts contacts_;
};

}  // namespace kinegraph
