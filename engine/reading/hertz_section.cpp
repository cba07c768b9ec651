#include "engine/reading/problem_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace kinegraph {
namespace {

constexpr std::string_view flat_word = "flat";

}  // namespace

std::optional<HertzProblem> HertzSection::read(JsonValue section) {
    const std::size_t before = file_.fault_count();
    const Members form =
        file_.members(section, {"force", "bodies", "contact", "length", "turned"}, {"\"hertz\"", "\"hertz\""});
    HertzProblem problem;
    problem.force = file_.positive(
        file_.required(form, "force", {"the force that presses the bodies together", "la forza che preme i corpi"}),
        QuantityKind::force, {"the force", "la forza"});
    if (const JsonValue contact = form["contact"]) {
        problem.line = contact.text() == "line";
        if (!contact.is_string() || (contact.text() != "line" && contact.text() != "point"))
            file_.wrong(contact, {"\"point\" or \"line\"", "\"point\" o \"line\""});
    }
    if (problem.line) {
        problem.length = file_.positive(
            file_.required(form, "length", {"how long the line of contact is", "quanto è lunga la linea di contatto"}),
            QuantityKind::length, {"the length", "la lunghezza"});
        if (form["turned"])
            file_.fault(
                form["turned"],
                {"bodies that touch along a line are not turned; take \"turned\" out, or write \"contact\": \"point\"",
                 "corpi a contatto lungo una linea non sono ruotati; togliere \"turned\", o scrivere \"contact\": "
                 "\"point\""});
    } else {
        if (form["length"])
            file_.fault(form["length"],
                        {"a contact at a point has no length; take it out, or write \"contact\": \"line\"",
                         "un contatto di punto non ha lunghezza; toglierla, o scrivere \"contact\": \"line\""});
        if (form["turned"]) problem.turn = file_.quantity_or_zero(form["turned"], QuantityKind::angle);
    }
    const auto bodies = bodies_.two(form);
    if (!bodies[0]) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) problem.bodies[i] = read_body(bodies[i], problem.line);
    if (file_.fault_count() == before) check_curvatures(problem, form["bodies"]);
    return problem;
}

HertzBody HertzSection::read_body(JsonValue member, bool line) {
    HertzBody body;
    body.body = bodies_.body(member);
    body.where = member.pointer();
    if (!file_.expect(member, Kind::object, {"an object", "un oggetto"})) return body;
    const Members form =
        file_.members(member, {"radius", "radii", "flat", "inside", "material", "young", "poisson", "depth", "label"},
                      {"a body", "un corpo"});
    if (form["label"]) mechanism_.bodies[at_index(body.body)].label = file_.words(form["label"]);
    read_shape(form, line, body);
    materials_.read(form, body);
    if (const JsonValue depth = form["depth"]) {
        if (line && (body.radii[0].is_zero() || body.inside[0]))
            body.depth = file_.positive(depth, QuantityKind::length, {"the depth", "la profondità"});
        else
            file_.fault(depth, {"only a flat or concave body at a line of contact has a \"depth\"; take it out",
                                "solo un corpo piano o concavo a contatto lungo una linea ha \"depth\"; toglierla"});
    }
    return body;
}

void HertzSection::read_shape(const Members& form, bool line, HertzBody& body) {
    const JsonValue shape = file_.one_of(form, {"radius", "radii", "flat"});
    if (!shape) return;
    if (shape.key() == "flat") {
        if (!file_.expect(shape, Kind::boolean, {"true", "true"})) return;
        if (!is_true(shape))
            file_.fault(shape,
                        {"a body that is not flat has a \"radius\"", "un corpo che non è piano ha un \"radius\""});
        if (form["inside"])
            file_.fault(form["inside"],
                        {"what is flat has no inside; take it out", "ciò che è piano non è concavo; toglierlo"});
    } else if (shape.key() == "radius") {
        read_radius(shape, 0, body);
        body.radii[1] = body.radii[0];
        if (form["inside"] && file_.expect(form["inside"], Kind::boolean, {"true or false", "true o false"}))
            body.inside = {is_true(form["inside"]), is_true(form["inside"])};
    } else {
        const Words wanted("two principal radii [r1, r2], each a length or \"flat\"",
                           "due raggi principali [r1, r2], ciascuno una lunghezza o \"flat\"");
        if (line)
            file_.fault(shape, {"at a line of contact a body has one \"radius\"",
                                "lungo una linea di contatto un corpo ha un solo \"radius\""});
        if (!shape.is_array() || shape.size() != 2) {
            file_.wrong(shape, wanted);
            return;
        }
        read_radius(*shape.begin(), 0, body);
        read_radius(*++shape.begin(), 1, body);
        if (const JsonValue inside = form["inside"]) {
            if (!inside.is_array() || inside.size() != 2 || (*inside.begin()).kind() != Kind::boolean ||
                (*++inside.begin()).kind() != Kind::boolean)
                file_.wrong(inside, {"[true or false, true or false], for each radius,",
                                     "[true o false, true o false], per ciascun raggio,"});
            else
                body.inside = {is_true(*inside.begin()), is_true(*++inside.begin())};
        }
    }
}

void HertzSection::read_radius(JsonValue value, std::size_t plane, HertzBody& body) {
    if (value.is_string() && value.text() == flat_word) return;
    body.radii[plane] = file_.positive(value, QuantityKind::length, {"a radius", "un raggio"});
}

void HertzSection::check_curvatures(const HertzProblem& problem, JsonValue bodies) {
    const HertzBody& first = problem.bodies[0];
    const HertzBody& second = problem.bodies[1];
    const auto sum = [&](std::size_t plane) { return first.curvature(plane) + second.curvature(plane); };
    if (first.radii[0].is_zero() && second.radii[0].is_zero() && first.radii[1].is_zero() &&
        second.radii[1].is_zero()) {
        file_.fault(bodies, {"two flat bodies touch on their whole face; give one of them a \"radius\"",
                             "due corpi piani si toccano su tutta la faccia; dare a uno un \"radius\""});
        return;
    }
    const Words conforms(
        "the concave radius must be larger than the convex one, else the bodies do not touch at a {0} alone",
        "il raggio concavo deve essere maggiore di quello convesso, altrimenti i corpi non si toccano in {0}",
        problem.line ? Words("line", "una linea") : Words("point", "un punto"));
    const JsonValue concave = *(first.inside[0] || first.inside[1] ? bodies.begin() : ++bodies.begin());
    if (problem.line) {
        if (sum(0).sign() <= 0) file_.fault(concave, conforms);
        return;
    }
    // A and B of the gap: both must be positive. With twice their sum s and the squared difference d², s² > d².
    const Exact d1 = first.curvature(0) - first.curvature(1), d2 = second.curvature(0) - second.curvature(1);
    const double twice = 2 * problem.turn.to_double();
    const double s = (sum(0) + sum(1)).to_double();
    const double d = std::sqrt(
        std::max(0.0, square(d1).to_double() + square(d2).to_double() + 2 * (d1 * d2).to_double() * std::cos(twice)));
    constexpr double slenderest = 1e-9;  // A/B: beyond it, an ellipse is a line
    if (s - d > slenderest * (s + d)) return;
    const bool is_concave = first.inside[0] || first.inside[1] || second.inside[0] || second.inside[1];
    file_.fault(
        is_concave ? concave : bodies,
        is_concave
            ? conforms
            : Words("these bodies touch along a line; write \"contact\": \"line\" with its \"length\"",
                    "questi corpi si toccano lungo una linea; scrivere \"contact\": \"line\" con la sua \"length\""));
}

}  // namespace kinegraph
