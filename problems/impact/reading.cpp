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
    const Members form =
        file_.members(section, {"bodies", "at", "normal", "restitution", "friction"}, {lang::impact::impact});
    ImpactProblem problem;
    problem.where = section.pointer();
    const auto bodies = bodies_.two(form);
    if (bodies[0])
        for (std::size_t i = 0; i < 2; ++i) problem.bodies.at(i) = read_body(bodies.at(i));
    if (const JsonValue at = file_.required(form, "at", {lang::impact::the_point_of_impact_a_point}))
        problem.at = file_.place(at);
    if (const JsonValue normal = file_.required(form, "normal", {lang::impact::the_direction_of_the_line}))
        problem.normal = file_.bearing_or_default(normal);
    const JsonValue restitution =
        file_.required(form, "restitution", {lang::impact::the_coefficient_of_restitution_from_0});
    problem.restitution = file_.bare_number(restitution).value_or(Exact());
    if (problem.restitution.sign() < 0 || problem.restitution > Exact(1))
        file_.fault(restitution, {lang::impact::the_coefficient_of_restitution_lies});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = file_.bare_number(friction).value_or(Exact());
        if (problem.friction.sign() < 0) file_.fault(friction, {lang::impact::the_coefficient_of_friction_must_not});
    }
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
    const Members form = file_.members(
        member, {"mass", "centre", "inertia", "velocity", "omega", "pivot", "fixed", "label"}, {lang::impact::a_body});
    if (form["label"]) mechanism_.bodies[at_index(body.body)].label = file_.words(form["label"]);
    if (const JsonValue fixed = form["fixed"];
        fixed && file_.expect(fixed, Kind::boolean, {lang::common::true_or_false}))
        body.fixed = is_true(fixed);
    if (body.fixed) {
        for (const std::string_view key : {"mass", "centre", "inertia", "velocity", "omega", "pivot"})
            if (form[key]) file_.fault(form[key], {lang::impact::a_fixed_body_has_no_take, quoted(key)});
        return body;
    }
    body.mass = file_.positive(file_.required(form, "mass", {lang::impact::the_mass_or_fixed_true}), QuantityKind::mass,
                               {lang::common::a_mass});
    if (form["inertia"])
        body.inertia = file_.positive(form["inertia"], QuantityKind::inertia, {lang::common::a_moment_of_inertia});
    if (form["centre"]) body.centre = file_.place(form["centre"]);
    if (form["omega"]) body.omega = file_.quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
    body.velocity = file_.vector(form["velocity"], QuantityKind::velocity, {lang::impact::a_vector_vx_vy});
    if (form["omega"] && !form["inertia"] && !form["pivot"])
        file_.fault(form["omega"], {lang::impact::a_body_that_turns});
    if (const JsonValue pivot = form["pivot"]) {
        body.pivot = file_.place(pivot);
        if (form["velocity"]) file_.fault(form["velocity"], {lang::impact::the_velocity_of_a_body});
        if (!form["centre"]) file_.fault(member, {lang::impact::a_body_on_a_pivot});
    }
    return body;
}

}  // namespace

std::any read_impact(FormReader& file, Mechanism& mechanism, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = ImpactSection(file, mechanism).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
