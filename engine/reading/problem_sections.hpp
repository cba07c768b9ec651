// Sections of a mechanism file that state a problem in place of joints, or the materials of contacts.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/file/expression.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

// ----- "reye": wear of a pad, a block, a disc, a collar or the shoe of a drum brake.

class ReyeSection {
public:
    explicit ReyeSection(FormReader& file) : file_(file) {}

    std::optional<ReyeProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    std::optional<ReyeProblem::Kind> read_kind(JsonValue section);
    void read_pad(const Members& form, ReyeProblem& problem);
    void read_disc(const Members& form, ReyeProblem& problem);
    void read_shoe(const Members& form, ReyeProblem& problem);

    FormReader& file_;
};

// ----- "positions": two or three positions of a body, by the places of two of its points.

class PositionsSection {
public:
    explicit PositionsSection(FormReader& file) : file_(file) {}

    std::optional<PositionsProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_position(JsonValue value, PositionsProblem& problem);
    /// Moves the point along the join if the distances differ by rounding only; a larger difference is a fault.
    void keep_distance(JsonValue at, const PositionsProblem& problem, PositionsProblem::Position& position);

    FormReader& file_;
};

// ----- The material of a body in contact: by name, or Young's modulus and Poisson's ratio.

class Materials {
public:
    explicit Materials(FormReader& file) : file_(file) {}

    /// From a form with "material", or "young" and "poisson".
    void read(const Members& form, HertzBody& body);
    void read_by_name(JsonValue name, HertzBody& body);

private:
    FormReader& file_;
};

// ----- The "bodies" of a problem in place of joints: an object by name. A body that the file does not list is added.

class ProblemBodies {
public:
    ProblemBodies(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    /// The two members of "bodies", or "not there".
    std::array<JsonValue, 2> two(const Members& section);
    /// The body of a member's name, added where the file has none.
    BodyIndex body(JsonValue member);

private:
    using Kind = FormReader::Kind;

    FormReader& file_;
    Mechanism& mechanism_;
};

// ----- "hertz": two bodies pressed together, with radii and materials. Curvatures without contact are reported here,
// since the problem needs no drawing.

class HertzSection {
public:
    HertzSection(FormReader& file, Mechanism& mechanism)
        : file_(file), mechanism_(mechanism), bodies_(file, mechanism), materials_(file) {}

    std::optional<HertzProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    HertzBody read_body(JsonValue member, bool line);
    void read_shape(const Members& form, bool line, HertzBody& body);
    void read_radius(JsonValue value, std::size_t plane, HertzBody& body);
    void check_curvatures(const HertzProblem& problem, JsonValue bodies);

    FormReader& file_;
    Mechanism& mechanism_;
    ProblemBodies bodies_;
    Materials materials_;
};

// ----- "impact": two colliding bodies, with masses, velocities, restitution and friction.

class ImpactSection {
public:
    ImpactSection(FormReader& file, Mechanism& mechanism)
        : file_(file), mechanism_(mechanism), bodies_(file, mechanism) {}

    std::optional<ImpactProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    ImpactBody read_body(JsonValue member);

    FormReader& file_;
    Mechanism& mechanism_;
    ProblemBodies bodies_;
};

// ----- The "materials" and the "length" of a joint with contact: Hertz's problem at a joint. Force and radii come from
// the mechanism.

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

// ----- The "constants" of the laws of a point's motion, by name: numbers, quantities of any dimension, formulas of
// earlier constants.

class LawConstants {
public:
    explicit LawConstants(FormReader& file) : file_(file) {}

    void read(JsonValue constants);
    /// A constant or a parameter of the file; an error without words has already been reported. `variable`: what else
    /// an expression may name, for the remedy.
    tl::expected<Measured, Words> look_up(std::string_view name, std::string_view variable);

private:
    using Kind = FormReader::Kind;

    std::optional<Measured> read_one(JsonValue member);

    FormReader& file_;
    std::vector<std::pair<std::string_view, std::optional<Measured>>> constants_;  ///< none: faulty
};

// ----- The "motion" of a point: its laws as expressions in t, along axes, by radius and angle, or along a path.

class PointMotionSection {
public:
    explicit PointMotionSection(FormReader& file) : file_(file), constants_(file) {}

    /// Whether a "motion" is that of a point, not of a body.
    static bool is_stated_by(JsonValue motion);
    std::optional<PointProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    void read_laws(const Members& form, PointProblem& problem);
    StatedLaw read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is,
                       NamedConstants& constants);
    void read_path(JsonValue value, PointProblem& problem);
    /// An angle or a vector: these problems have no points to define a direction.
    Vector own_direction(JsonValue value);
    void read_times(const Members& form, PointProblem& problem);

    FormReader& file_;
    LawConstants constants_;
};

// ----- The section of a file that states a problem in place of joints: "hertz", "reye", "impact", "positions", or the
// "motion" of a point. Owns which sections may be combined; each problem has its own source file.

class ProblemSection {
public:
    ProblemSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    static bool is_in(const Members& file);
    /// Null where the file has none or it is unreadable. Adds its bodies to the mechanism.
    std::shared_ptr<const Problem> read(const Members& file);

private:
    using Kind = FormReader::Kind;

    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
