// "joints": their kinds, bodies, guides and contacts, and how drivers, efforts and loads find them by name. Which pair
// transmits what is the table of pairs'.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/reading/bodies_section.hpp"
#include "engine/reading/contacts_of_joints.hpp"
#include "engine/reading/profiles.hpp"

namespace kinegraph {

class JointsSection {
public:
    JointsSection(FormReader& file, Mechanism& mechanism, BodiesSection& bodies)
        : file_(file), mechanism_(mechanism), bodies_(bodies), contacts_(file, mechanism), profiles_(file, mechanism) {}

    void read_joints(const Members& file);
    /// Of what touching bodies are made, where joints say so.
    LoadedContacts take_contacts() { return contacts_.take(); }
    /// A sliding joint by its name, or none with a fault; `remedy` is for those who name a joint of another kind.
    JointIndex sliding_joint(JsonValue value, const Words& remedy);
    /// By its name, or else by its point.
    JointIndex hinge(JsonValue value);
    void wrong_kind(JsonValue joint, std::string_view kind, const Words& remedy);

private:
    using Kind = FormReader::Kind;

    void read_joint(JsonValue value);
    /// Null where there is none, or two, which has been said.
    const PlanePair* pair_of(JsonValue value);
    /// Of the joint that is read next; results go by it, so it is given once.
    void add_sliding_name(JsonValue value, const Joint& joint, std::string_view written);
    /// The key that is meant to be the kind is misspelt, or there is none.
    void miss_kind(JsonValue value);
    /// What a joint of this kind may say: of its kind, of its bodies, of what is its own.
    static std::vector<std::string_view> keys_of(const PlanePair& pair);
    void read_joint_bodies(const Members& form, Joint& joint);
    void read_slot(const Members& form, Joint& joint);
    void check_pressure_angle(JsonValue value, const Angle& angle);

    FormReader& file_;
    Mechanism& mechanism_;
    BodiesSection& bodies_;
    ContactsOfJoints contacts_;
    ProfilesOfContact profiles_;
    bool joints_known_ = false;  ///< the list could be read, so that a name that is not in it is a fault
    std::unordered_map<std::string, JointIndex> sliding_by_name_;
    std::unordered_map<std::string, std::string>
        sliding_keys_;  ///< where each name stands; contacts have results under theirs too
    std::vector<std::string_view> sliding_names_;
    std::unordered_map<std::string, std::string_view> other_joints_;  ///< name → kind of those that do not slide
};

}  // namespace kinegraph
