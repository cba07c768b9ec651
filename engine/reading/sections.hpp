// Sections of a mechanism file. Each has a reader class, which receives the sections whose names it looks up.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/point_cycles.hpp"
#include "engine/reading/form_reader.hpp"
#include "engine/reading/law_reader.hpp"
#include "engine/reading/materials.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph {

// ----- "frame" and "bodies": the bodies by name, and the points that move with each.

class BodiesSection {
public:
    BodiesSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    /// `stated`: the frame's name, where the file gives one.
    void register_bodies(JsonValue stated, JsonValue bodies);
    void read_bodies(JsonValue bodies);
    void carry(BodyIndex on, PointIndex carried);

private:
    using Kind = FormReader::Kind;

    void read_colour(JsonValue colour, BodyIndex index);
    Body& body_at(BodyIndex index) { return mechanism_.bodies[at_index(index)]; }

    FormReader& file_;
    Mechanism& mechanism_;
    std::unordered_set<std::uint64_t> carried_;  ///< (body, point)
};

// ----- "motion" of a body: given velocities and accelerations of its points.

class MotionSection {
public:
    MotionSection(FormReader& file, Mechanism& mechanism, BodiesSection& bodies)
        : file_(file), mechanism_(mechanism), bodies_(bodies) {}

    void read_motion(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// The named points move with the body, whether listed there or not.
    std::vector<GivenMotion> given_motions(BodyIndex on, const Members& motion, std::string_view key,
                                           QuantityKind kind);

    FormReader& file_;
    Mechanism& mechanism_;
    BodiesSection& bodies_;
};

// ----- "points": coordinates, or a place constructed from others by distances, lines and circles. Whether curves
// intersect is decided by the pose.

class PointsSection {
public:
    PointsSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void register_point(JsonValue member);
    void read_points(JsonValue points);

private:
    using Kind = FormReader::Kind;

    void report_cycle(const std::vector<PointIndex>& cycle, const std::vector<JsonValue>& places);
    Placement placement(JsonValue value);
    Placement point_on_line(JsonValue value);
    Placement meet(JsonValue value);
    /// For two circles left or right; for a line and a circle also the order along the line.
    Meet::Side side_of(JsonValue value, const Meet& meet);
    Curve curve(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
};

// ----- "units" and "scales": the units of bare numbers, and the scales of figures.

class UnitsSection {
public:
    UnitsSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void read_units(const Members& file);
    void read_scales(const Members& file);

private:
    using Kind = FormReader::Kind;

    void read_unit(JsonValue value, QuantityKind kind);

    FormReader& file_;
    Mechanism& mechanism_;
};

// ----- "find": requested results, including relative motions and cuts of a truss. Cuts are read last, because they
// need the whole file.

class WishesSection {
public:
    WishesSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void read_wish(JsonValue value);
    /// Cuts name bars of a truss, which depend on the whole file.
    void read_cuts();
    /// Whether bodies carry the points whose relative motion is asked for; after the bodies and joints.
    void check_observed_points();

private:
    using Kind = FormReader::Kind;

    /// Whether the motion is found through the observer. A translating observer gives no direction of a relative
    /// velocity.
    static bool is_cut(JsonValue value);
    void read_cut(JsonValue value, const TrussStructure& truss);

    FormReader& file_;
    Mechanism& mechanism_;
    std::vector<JsonValue> cuts_;
    std::vector<std::pair<JsonValue, PointIndex>> observed_;  ///< points whose relative motion is asked for
};

// ----- The profiles of a contact: given with the joint, or the circles of its bodies, or only their common tangent.

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

// ----- "joints": their kinds, bodies, guides and contacts, and the lookup of joints by name for drivers, efforts and
// loads. Which pair transmits what is in the table of pairs.

class JointsSection {
public:
    JointsSection(FormReader& file, Mechanism& mechanism, BodiesSection& bodies)
        : file_(file), mechanism_(mechanism), bodies_(bodies), contacts_(file, mechanism), profiles_(file, mechanism) {}

    void read_joints(const Members& file);
    /// The materials of touching bodies, where joints give them.
    LoadedContacts take_contacts() { return contacts_.take(); }
    /// A sliding joint by its name; none, with a fault reported. `remedy` is shown for a joint of another kind.
    JointIndex sliding_joint(JsonValue value, const Words& remedy);
    /// By its name, or else by its point.
    JointIndex hinge(JsonValue value);
    void wrong_kind(JsonValue joint, std::string_view kind, const Words& remedy);

private:
    using Kind = FormReader::Kind;

    void read_joint(JsonValue value);
    /// Null where there is none, or two, which has been reported.
    const PlanePair* pair_of(JsonValue value);
    /// Adds the name of the joint that is read next. Results are named by it, so it must be unique.
    void add_sliding_name(JsonValue value, const Joint& joint, std::string_view written);
    /// Reports a missing or misspelt kind.
    void miss_kind(JsonValue value);
    void read_joint_bodies(const Members& form, Joint& joint);
    void read_slot(const Members& form, Joint& joint);
    void check_pressure_angle(JsonValue value, const Angle& angle);

    FormReader& file_;
    Mechanism& mechanism_;
    BodiesSection& bodies_;
    ContactsOfJoints contacts_;
    ProfilesOfContact profiles_;
    bool joints_known_ = false;  ///< the list was readable, so that an unlisted name is a fault
    std::unordered_map<std::string, JointIndex> sliding_by_name_;
    std::unordered_map<std::string, std::string>
        sliding_keys_;  ///< where each name stands; the results of contacts use them too
    std::vector<std::string_view> sliding_names_;
    std::unordered_map<std::string, std::string_view> other_joints_;  ///< name → kind of joints that do not slide
};

// ----- "drivers": what drives a body, a joint or a point, with its rates or its law of motion in time.

class DriversSection {
public:
    DriversSection(FormReader& file, Mechanism& mechanism, LawReader& laws, JointsSection& joints)
        : file_(file), mechanism_(mechanism), laws_(laws), joints_(joints) {}

    void read_driver(JsonValue value);

private:
    using Kind = FormReader::Kind;

    void read_slide_driver(JsonValue value);
    void read_point_driver(JsonValue value);
    void read_spin_driver(JsonValue value);
    /// Reports {"body": 2, "speed": 150}: a body rotates.
    void turn_instead(const Members& form);
    /// FORMAT "Laws of motion", for a driver; `rates` are the keys that it replaces.
    std::optional<Law> law(const Members& form, std::initializer_list<std::string_view> rates);
    /// A driver, with the rates of its law.
    void add(Driver driver);

    FormReader& file_;
    Mechanism& mechanism_;
    LawReader& laws_;
    JointsSection& joints_;
};

// ----- "effort": the unknown that balances the loads: a couple, a force or an actuator in a joint.

class EffortsSection {
public:
    EffortsSection(FormReader& file, Mechanism& mechanism, JointsSection& joints)
        : file_(file), mechanism_(mechanism), joints_(joints) {}

    void read_effort(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// A name and its place in the file.
    struct Named {
        std::string text{};
        JsonValue at{};
    };
    Named read_couple_effort(JsonValue value);
    Named read_actuator(JsonValue value);
    Named read_force_effort(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
    JointsSection& joints_;
    std::unordered_set<std::string> effort_names_;
};

// ----- "masses" and "loads": forces, couples, springs, distributed loads, and forces on the pin of a hinge.

class LoadsSection {
public:
    LoadsSection(FormReader& file, Mechanism& mechanism, BodiesSection& bodies, JointsSection& joints)
        : file_(file), mechanism_(mechanism), bodies_(bodies), joints_(joints) {}

    void read_masses(const Members& file);
    void read_load(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// Results and figures are named by it.
    std::string name_of_load(const Members& form, std::string_view key);
    void read_force(JsonValue value);
    /// On the pin of a hinge, which then is a node of its own.
    void read_pin_load(JsonValue value);
    /// Components, or magnitude and direction, or a pressure on an area and a direction.
    void read_size(const Members& form, ForceLoad& force);
    std::optional<Exact> pressure_on_area(const Members& form);
    void read_spring(JsonValue value);
    void read_ends(const Members& form, SpringLoad& spring);
    /// The two bodies of a spring.
    std::array<BodyIndex, 2> two_bodies(JsonValue bodies);
    /// FORMAT "Forces": an elastic spring, straight or of torsion.
    void read_elastic(JsonValue value);
    void read_distributed(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
    BodiesSection& bodies_;
    JointsSection& joints_;
    std::unordered_set<std::string> load_names_;
};

}  // namespace kinegraph
