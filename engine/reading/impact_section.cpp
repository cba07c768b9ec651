#include "engine/reading/problem_sections.hpp"

#include <cstddef>
#include <string_view>

namespace kinegraph {

std::optional<ImpactProblem> ImpactSection::read(JsonValue section) {
    const Members form =
        file_.members(section, {"bodies", "at", "normal", "restitution", "friction"}, {"\"impact\"", "\"impact\""});
    ImpactProblem problem;
    problem.where = section.pointer();
    const auto bodies = bodies_.two(form);
    if (bodies[0])
        for (std::size_t i = 0; i < 2; ++i) problem.bodies.at(i) = read_body(bodies.at(i));
    if (const JsonValue at = file_.required(
            form, "at", {"the point of impact, a point or [x, y]", "il punto d’urto, un punto o [x, y]"}))
        problem.at = file_.place(at);
    if (const JsonValue normal =
            file_.required(form, "normal", {"the direction of the line of impact", "la direzione della linea d’urto"}))
        problem.normal = file_.bearing_or_default(normal);
    const JsonValue restitution =
        file_.required(form, "restitution",
                       {"the coefficient of restitution, from 0 to 1", "il coefficiente di restituzione, da 0 a 1"});
    problem.restitution = file_.bare_number(restitution).value_or(Exact());
    if (problem.restitution.sign() < 0 || problem.restitution > Exact(1))
        file_.fault(restitution, {"the coefficient of restitution lies from 0 (plastic) to 1 (elastic)",
                                  "il coefficiente di restituzione sta fra 0 (plastico) e 1 (elastico)"});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = file_.bare_number(friction).value_or(Exact());
        if (problem.friction.sign() < 0)
            file_.fault(friction, {"the coefficient of friction must not be negative",
                                   "il coefficiente d’attrito non può essere negativo"});
    }
    if (!bodies[0]) return std::nullopt;
    if (problem.bodies[0].fixed && problem.bodies[1].fixed)
        file_.fault(form["bodies"], {"both bodies are fixed, so nothing moves; let one of them free",
                                     "entrambi i corpi sono fissi e nulla si muove; liberarne uno"});
    return problem;
}

ImpactBody ImpactSection::read_body(JsonValue member) {
    ImpactBody body;
    body.body = bodies_.body(member);
    body.where = member.pointer();
    if (!file_.expect(member, Kind::object, {"an object", "un oggetto"})) return body;
    const Members form = file_.members(
        member, {"mass", "centre", "inertia", "velocity", "omega", "pivot", "fixed", "label"}, {"a body", "un corpo"});
    if (form["label"]) mechanism_.bodies[at_index(body.body)].label = file_.words(form["label"]);
    if (const JsonValue fixed = form["fixed"];
        fixed && file_.expect(fixed, Kind::boolean, {"true or false", "true o false"}))
        body.fixed = is_true(fixed);
    if (body.fixed) {
        for (const std::string_view key : {"mass", "centre", "inertia", "velocity", "omega", "pivot"})
            if (form[key])
                file_.fault(form[key], {"a fixed body has no {0}; take it out", "un corpo fisso non ha {0}; toglierlo",
                                        quoted(key)});
        return body;
    }
    body.mass =
        file_.positive(file_.required(form, "mass", {"the mass (or \"fixed\": true)", "la massa (o \"fixed\": true)"}),
                       QuantityKind::mass, {"a mass", "una massa"});
    if (form["inertia"])
        body.inertia =
            file_.positive(form["inertia"], QuantityKind::inertia, {"a moment of inertia", "un momento d’inerzia"});
    if (form["centre"]) body.centre = file_.place(form["centre"]);
    if (form["omega"]) body.omega = file_.quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
    body.velocity =
        file_.vector(form["velocity"], QuantityKind::velocity, {"a vector [vx, vy]", "un vettore [vx, vy]"});
    if (form["omega"] && !form["inertia"] && !form["pivot"])
        file_.fault(form["omega"], {"a body that turns has an \"inertia\"; give it, or take \"omega\" out",
                                    "un corpo che ruota ha un \"inertia\"; assegnarlo, o togliere \"omega\""});
    if (const JsonValue pivot = form["pivot"]) {
        body.pivot = file_.place(pivot);
        if (form["velocity"])
            file_.fault(form["velocity"],
                        {"the velocity of a body on a pivot follows from its \"omega\"; give that",
                         "la velocità di un corpo incernierato segue dalla sua \"omega\"; assegnare quella"});
        if (!form["centre"])
            file_.fault(member, {"a body on a pivot has a \"centre\"; give it",
                                 "un corpo incernierato ha un \"centre\"; assegnarlo"});
    }
    return body;
}

}  // namespace kinegraph
