// The materials of contacts: of two bodies that are pressed together, and at joints of a mechanism.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "engine/mechanism/contact.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

// ----- The material of a body in contact: by name, or Young's modulus and Poisson's ratio.

class Materials {
public:
    explicit Materials(FormReader& file) : file_(file) {}

    /// From a form with "material", or "young" and "poisson".
    void read(const Members& form, ElasticBody& body);
    void read_by_name(JsonValue name, ElasticBody& body);

private:
    FormReader& file_;
};

// ----- The "materials" and the "length" of a joint with contact. Force and radii come from the mechanism.

class ContactsOfJoints {
public:
    ContactsOfJoints(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism), materials_(file) {}

    /// The keys that give the materials of a joint with contact.
    static constexpr std::array<std::string_view, 2> keys{"materials", "length"};
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
