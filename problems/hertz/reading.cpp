#include "problems/hertz/hertz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/number/functions.hpp"
#include "engine/reading/materials.hpp"
#include "engine/reading/problem_section.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/hertz.hpp"

namespace kinegraph {
namespace {

constexpr std::string_view flat_word = "flat";

constexpr std::array hertz_body_rows{FormRow("radius", "r", values::length).one_of(),
                                     FormRow("radii", "[r1, r2]", values::list(values::number_or_text, 2, 2),
                                             "Two principal radii, each a length or \"flat\".")
                                         .one_of(),
                                     FormRow("flat", "true", values::json(R"("enum": [true])"), "A plane.").one_of(),
                                     FormRow("inside", "true", values::json(R"("anyOf": [{"type": "boolean"},
                {"type": "array", "items": {"type": "boolean"}, "minItems": 2, "maxItems": 2}])"),
                                             "Concave; of radii an array of two."),
                                     Materials::name_row,
                                     Materials::young_row,
                                     Materials::poisson_row,
                                     Materials::depth_row,
                                     FormRow("label", "\"…\"", values::texts)};
constexpr Form hertz_body_form{lang::hertz::a_body, hertz_body_rows};
constexpr FormValue hertz_body =
    values::object(hertz_body_form)
        .named("hertzBody", "One of two elastic bodies: its shape at the contact and its material.");
constexpr std::array<std::string_view, 2> kinds_of_hertz_contact{"point", "line"};
constexpr std::array hertz_rows{
    FormRow("force", "F", values::force)
        .needed(lang::hertz::the_force_that_presses_the_bodies)
        .positive(lang::common::the_force),
    ProblemBodies::row(hertz_body), FormRow("contact", "…", values::word(kinds_of_hertz_contact), "Default: point."),
    FormRow("length", "l", values::length).positive(lang::common::the_length), FormRow("turned", "a", values::angle)};
constexpr Form hertz_form{lang::hertz::hertz, hertz_rows};

/// "hertz": two bodies pressed together, with radii and materials. Curvatures without contact are reported here,
/// since the problem needs no drawing.
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

std::optional<HertzProblem> HertzSection::read(JsonValue section) {
    const std::size_t before = file_.fault_count();
    const Members form = file_.members(section, hertz_form);
    HertzProblem problem;
    problem.force = form.quantity_or_default("force");
    if (const JsonValue contact = form["contact"]) {
        problem.line = contact.text() == "line";
        if (!contact.is_string() || (contact.text() != "line" && contact.text() != "point"))
            file_.wrong(contact, {lang::hertz::point_or_line});
    }
    if (problem.line) {
        file_.required(form, "length", {lang::common::the_length_of_contact});
        problem.length = form.quantity_or_default("length");
        if (form["turned"]) file_.fault(form["turned"], {lang::hertz::bodies_that_touch_along_a_line});
    } else {
        if (form["length"]) file_.fault(form["length"], {lang::hertz::a_contact_at_a_point});
        problem.turn = form.quantity_or_default("turned");
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
    if (!file_.expect(member, Kind::object, {lang::common::an_object})) return body;
    const Members form = file_.members(member, hertz_body_form);
    if (form["label"]) mechanism_.bodies[at_index(body.body)].label = file_.words(form["label"]);
    read_shape(form, line, body);
    materials_.read(form, body);
    if (const JsonValue depth = form["depth"]) {
        if (line && (body.radii[0].is_zero() || body.inside[0]))
            body.depth = form.quantity_or_default("depth");
        else
            file_.fault(depth, {lang::hertz::only_a_flat_or_concave_body});
    }
    return body;
}

void HertzSection::read_shape(const Members& form, bool line, HertzBody& body) {
    const JsonValue shape = form.one_of();
    if (!shape) return;
    if (shape.key() == "flat") {
        if (!file_.expect(shape, Kind::boolean, {lang::hertz::true_word})) return;
        if (!is_true(shape)) file_.fault(shape, {lang::hertz::a_body_that_is_not_flat});
        if (form["inside"]) file_.fault(form["inside"], {lang::hertz::what_is_flat_has_no_inside});
    } else if (shape.key() == "radius") {
        read_radius(shape, 0, body);
        body.radii[1] = body.radii[0];
        body.inside.fill(form.flag("inside"));
    } else {
        const Words wanted(lang::hertz::two_principal_radii_r1_r2_each);
        if (line) file_.fault(shape, {lang::hertz::at_a_line_of_contact});
        if (!shape.is_array() || shape.size() != 2) {
            file_.wrong(shape, wanted);
            return;
        }
        read_radius(*shape.begin(), 0, body);
        read_radius(*++shape.begin(), 1, body);
        if (const JsonValue inside = form["inside"]) {
            if (!inside.is_array() || inside.size() != 2 || (*inside.begin()).kind() != Kind::boolean ||
                (*++inside.begin()).kind() != Kind::boolean)
                file_.wrong(inside, {lang::hertz::true_or_false_true_or_false});
            else
                body.inside = {is_true(*inside.begin()), is_true(*++inside.begin())};
        }
    }
}

void HertzSection::read_radius(JsonValue value, std::size_t plane, HertzBody& body) {
    if (value.is_string() && value.text() == flat_word) return;
    body.radii[plane] = file_.positive(value, QuantityKind::length, {lang::common::a_radius});
}

void HertzSection::check_curvatures(const HertzProblem& problem, JsonValue bodies) {
    const HertzBody& first = problem.bodies[0];
    const HertzBody& second = problem.bodies[1];
    const auto sum = [&](std::size_t plane) { return first.curvature(plane) + second.curvature(plane); };
    if (first.radii[0].is_zero() && second.radii[0].is_zero() && first.radii[1].is_zero() &&
        second.radii[1].is_zero()) {
        file_.fault(bodies, {lang::hertz::two_flat_bodies_touch_on_their});
        return;
    }
    const Words conforms(lang::hertz::the_concave_radius_must_be_larger,
                         problem.line ? Words(lang::hertz::line) : Words(lang::hertz::point));
    const JsonValue concave = *(first.inside[0] || first.inside[1] ? bodies.begin() : ++bodies.begin());
    if (problem.line) {
        if (sum(0).sign() <= 0) file_.fault(concave, conforms);
        return;
    }
    // A and B of the gap: both must be positive. With twice their sum s and the squared difference d², s² > d².
    const Exact d1 = first.curvature(0) - first.curvature(1), d2 = second.curvature(0) - second.curvature(1);
    const double twice = 2 * problem.turn.to_double();
    const double s = (sum(0) + sum(1)).to_double();
    const double d = std::sqrt(std::max(
        0.0, square(d1).to_double() + square(d2).to_double() + 2 * (d1 * d2).to_double() * nearest::cos(twice)));
    constexpr double slenderest = 1e-9;  // A/B: beyond it, an ellipse is a line
    if (s - d > slenderest * (s + d)) return;
    const bool is_concave = first.inside[0] || first.inside[1] || second.inside[0] || second.inside[1];
    file_.fault(is_concave ? concave : bodies,
                is_concave ? conforms : Words(lang::hertz::these_bodies_touch_along_a_line));
}

}  // namespace

constinit const FormValue hertz_section =
    values::object(hertz_form).named({}, "Two elastic bodies pressed together (Hertz), in place of joints.");

std::any read_hertz(FormReader& file, Mechanism& mechanism, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = HertzSection(file, mechanism).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
