// The "materials" and the "length" of a joint whose bodies touch: Hertz's problem at a joint, whose force and radii the
// mechanism gives.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/reading/materials.hpp"

namespace kinegraph {

class ContactsOfJoints {
public:
    ContactsOfJoints(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism), materials_(file) {}

    /// The keys of a joint that say what its bodies are made of; of joints whose bodies touch.
    static constexpr std::array<std::string_view, 2> keys{"materials", "length"};
    /// Of the joint that will have that index, where it has materials.
    void read(const Members& form, const Joint& joint, JointIndex index);
    /// Those that were read.
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
