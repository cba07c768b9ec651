// The sections of a file that state a problem in place of joints: "hertz", "reye", "impact", "positions", and the "motion" of a
// point (the last two in motion_reader.cpp); and the "materials" of a joint. Each fault where it stands; what only numbers can
// tell (curvatures that leave no contact) is told here too, since these problems need no drawing.
#pragma once

#include <memory>

#include "engine/law_reader.hpp"
#include "engine/problem.hpp"

namespace kinegraph {

/// What the reader of a mechanism file is built on, beside the forms.
class ProblemReader : protected LawReader {
public:
    /// The keys of a joint that say what its bodies are made of; of joints whose bodies touch.
    static constexpr std::array<std::string_view, 2> contact_keys{"materials", "length"};
    /// Of the joint that will have that index, where it has materials.
    void read_contact(const Members& form, const Joint& joint, JointIndex index);

protected:
    /// The keys of such sections; `motion` is one where it is a point's.
    static constexpr std::array<std::string_view, 5> problem_keys{"hertz", "reye", "impact", "positions", "motion"};
    static bool is_motion_of_a_point(JsonValue motion);
    static bool states_problem(const Members& file);
    /// The section of the file, or null where it states none or one that cannot be read. Its bodies are added to `mechanism`.
    std::shared_ptr<const Problem> read_problem(const Members& file, Mechanism& mechanism);
    LoadedContacts contacts_;

private:
    void read_bodies_of_contact(JsonValue materials, const Joint& joint, LoadedContact& contact);
    void check_profiles_of_contact(JsonValue materials, const Members& form, const Joint& joint);
    void read_named_material(JsonValue name, HertzBody& body);
    /// The body of that name, added where the file has none.
    BodyIndex problem_body(JsonValue member, Mechanism& mechanism);
    /// The two members of "bodies", or "not there".
    std::array<JsonValue, 2> two_bodies(const Members& section);

    std::optional<HertzProblem> read_hertz(JsonValue section, Mechanism& mechanism);
    HertzBody read_hertz_body(JsonValue member, bool line, Mechanism& mechanism);
    void read_shape(const Members& form, bool line, HertzBody& body);
    void read_radius(JsonValue value, std::size_t plane, HertzBody& body);
    void read_material(const Members& form, HertzBody& body);
    void check_curvatures(const HertzProblem& problem, JsonValue bodies);

    std::optional<ReyeProblem::Kind> read_kind_of_reye(JsonValue section);
    std::optional<ReyeProblem> read_reye(JsonValue section);
    void read_pad(const Members& form, ReyeProblem& problem);
    void read_disc(const Members& form, ReyeProblem& problem);
    void read_shoe(const Members& form, ReyeProblem& problem);

    std::optional<ImpactProblem> read_impact(JsonValue section, Mechanism& mechanism);
    ImpactBody read_impact_body(JsonValue member, Mechanism& mechanism);

    // engine/motion_reader.cpp
    std::optional<PointProblem> read_point_motion(JsonValue section);
    void read_laws(const Members& form, PointProblem& problem);
    StatedLaw read_law(JsonValue value, const std::string& symbol, QuantityKind of, QuantityKind is, NamedConstants& constants);
    void read_path(JsonValue value, PointProblem& problem);
    /// An angle or a vector: these problems have no points that a direction could lie between.
    Vector own_direction(JsonValue value);
    void read_times(const Members& form, PointProblem& problem);
    void read_constants(JsonValue constants);
    std::optional<Measured> read_constant(JsonValue member);
    tl::expected<Measured, Words> look_up_constant(std::string_view name);
    std::optional<PositionsProblem> read_positions(JsonValue section);
    void read_position(JsonValue value, PositionsProblem& problem);
    /// What is rounded alone is moved along the join; more is a fault.
    void keep_distance(JsonValue at, const PositionsProblem& problem, PositionsProblem::Position& position);

    std::vector<std::pair<std::string_view, std::optional<Measured>>> law_constants_;  ///< none: faulty
    std::string_view law_variable_ = "t";
};

/// Young's modulus (Pa) and Poisson's ratio of a material known by name. Shigley, Mechanical Engineering Design, table A–5;
/// nylon: Ashby, Materials Selection in Mechanical Design, appendix A.
struct Material {
    std::string_view name;
    double young = 0;
    const char* poisson = "0";
};
std::span<const Material> known_materials();

}  // namespace kinegraph
