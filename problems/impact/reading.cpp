#include "problems/impact/impact.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/reading/problem_section.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/impact.hpp"

namespace kinegraph {
namespace {

constexpr std::array impact_body_rows{
    FormRow("mass", "m", values::mass).positive(lang::common::a_mass),
    FormRow("centre", "P", values::place),
    FormRow("inertia", "J", values::inertia).positive(lang::common::a_moment_of_inertia),
    FormRow("velocity", "[vx, vy]", values::velocities, "Of the centre of mass, [vx, vy], before the impact.")
        .called(lang::impact::a_vector_vx_vy),
    FormRow("omega", "…", values::angular_velocity),
    FormRow("pivot", "P", values::place),
    FormRow("fixed", "true", values::flag, "At rest, whatever hits it."),
    FormRow("label", "\"…\"", values::texts)};
constexpr Form impact_body_form{lang::impact::a_body, impact_body_rows};
constexpr FormValue impact_body =
    values::object(impact_body_form).named("impactBody", "One of two bodies that hit each other.");
constexpr std::array impact_rows{
    ProblemBodies::row(impact_body),
    FormRow("at", "P", values::place).needed(lang::impact::the_point_of_impact_a_point),
    FormRow("normal", "X", values::direction).needed(lang::impact::the_direction_of_the_line),
    FormRow("restitution", "e", values::number, "From 0 to 1.")
        .needed(lang::impact::the_coefficient_of_restitution_from_0)
        .within(R"("minimum": 0, "maximum": 1)"),
    FormRow("friction", "f", values::number, "Coefficient of friction. Default: 0.").within(R"("minimum": 0)")};
constexpr Form impact_form{lang::impact::impact, impact_rows};

/// "impact": two colliding bodies, with masses, velocities, restitution and friction.
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

std::optional<ImpactProblem> ImpactSection::read(JsonValue section) {
    const Members form = file_.members(section, impact_form);
    ImpactProblem problem;
    problem.where = section.pointer();
    const auto bodies = bodies_.two(form);
    if (bodies[0])
        for (std::size_t i = 0; i < 2; ++i) problem.bodies.at(i) = read_body(bodies.at(i));
    problem.at = form.place("at");
    problem.normal = form.bearing_or_default("normal");
    problem.restitution = form.number("restitution").value_or(Exact());
    if (problem.restitution.sign() < 0 || problem.restitution > Exact(1))
        file_.fault(form["restitution"], {lang::impact::the_coefficient_of_restitution_lies});
    problem.friction = form.number("friction").value_or(Exact());
    if (problem.friction.sign() < 0)
        file_.fault(form["friction"], {lang::impact::the_coefficient_of_friction_must_not});
    if (!bodies[0]) return std::nullopt;
    if (problem.bodies[0].fixed && problem.bodies[1].fixed)
        file_.fault(form["bodies"], {lang::impact::both_bodies_are_fixed_so_nothing});
    return problem;
}

ImpactBody ImpactSection::read_body(JsonValue member) {
    ImpactBody body;
    body.body = bodies_.body(member);
    body.where = member.pointer();
    if (!file_.expect(member, Kind::object, {lang::common::an_object})) return body;
    const Members form = file_.members(member, impact_body_form);
    if (form["label"]) mechanism_.bodies[at_index(body.body)].label = file_.words(form["label"]);
    body.fixed = form.flag("fixed");
    if (body.fixed) {
        for (const std::string_view key : {"mass", "centre", "inertia", "velocity", "omega", "pivot"})
            if (form[key]) file_.fault(form[key], {lang::impact::a_fixed_body_has_no_take, quoted(key)});
        return body;
    }
    file_.required(form, "mass", {lang::impact::the_mass_or_fixed_true});
    body.mass = form.quantity_or_default("mass");
    if (form["inertia"]) body.inertia = form.quantity_or_default("inertia");
    if (form["centre"]) body.centre = form.place("centre");
    if (form["omega"]) body.omega = form.quantity_or_default("omega");
    body.velocity = form.vector("velocity");
    if (form["omega"] && !form["inertia"] && !form["pivot"])
        file_.fault(form["omega"], {lang::impact::a_body_that_turns});
    if (const JsonValue pivot = form["pivot"]) {
        body.pivot = form.place("pivot");
        if (form["velocity"]) file_.fault(form["velocity"], {lang::impact::the_velocity_of_a_body});
        if (!form["centre"]) file_.fault(member, {lang::impact::a_body_on_a_pivot});
    }
    return body;
}

}  // namespace

constinit const FormValue impact_section =
    values::object(impact_form).named({}, "Two rigid bodies that hit each other, in place of joints.");

std::any read_impact(FormReader& file, Mechanism& mechanism, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = ImpactSection(file, mechanism).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
