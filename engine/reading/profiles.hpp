// The profiles that touch in a contact: given with the joint, or the circles of its bodies, or their common tangent
// alone.
#pragma once

#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class ProfilesOfContact {
public:
    ProfilesOfContact(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void read_profiles(const Members& form, Joint& joint);

private:
    using Kind = FormReader::Kind;

    bool read_profile(JsonValue member, Joint& joint);

    FormReader& file_;
    const Mechanism& mechanism_;
};

}  // namespace kinegraph
