// The worked solution of Hertz's contact: given data, equivalent bodies, contact area and pressure, stresses below,
// hypotheses.
#include "problems/hertz/hertz.hpp"

#include <cmath>
#include <numbers>

#include "lang/keys/common.hpp"
#include "lang/keys/hertz.hpp"
#include "lang/keys/notation.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

class HertzText {
public:
    explicit HertzText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(mechanism_.problem->as<HertzProblem>()),
          found_(context.solution.problem->as<HertzSolution>()) {}

    Words heading() const {
        if (!problem_.at) return {lang::common::heading_given};
        return {lang::common::contact_at, problem_.at->joint};
    }
    std::vector<Words> given() const {
        std::vector<Words> said;
        if (problem_.at) said.push_back(at_joint(*problem_.at));
        said.emplace_back(
            lang::hertz::the_force_q_presses_the_two,
            amount(problem_.force.to_double(), QuantityKind::force, mechanism_.units, problem_.at ? 4 : as_given),
            problem_.line ? Words(lang::hertz::along_a_line_of_length_l, given(problem_.length, QuantityKind::length))
                          : Words());
        for (std::size_t i = 0; i < 2; ++i) {
            const HertzBody& body = problem_.bodies.at(i);
            const std::string n = std::to_string(i + 1);
            said.push_back(called(mechanism_.body(body.body)) + lang::notation::colon +
                           formula_words("{0}, {E_" + n + "} = {1}, {ν_" + n + "} = {2}.",
                                         {shape(body, n), given(body.young, QuantityKind::pressure),
                                          numeral(body.poisson.to_double(), as_given)}));
        }
        if (found_.elliptic && !problem_.turn.is_zero())
            said.emplace_back(lang::hertz::the_first_principal_planes, given(problem_.turn, QuantityKind::angle));
        return said;
    }

    std::vector<Words> equivalents() const {
        std::vector<Words> said;
        said.emplace_back(lang::hertz::the_yielding_of_the_two_elastic, pressure(found_.modulus));
        if (!found_.elliptic) {
            said.emplace_back(lang::hertz::so_do_the_curvatures_a_concave, curvatures(), length(found_.radius));
            return said;
        }
        const double mm = mechanism_.units.length.si.to_double();
        const Words per = mechanism_.units.length.symbol;
        said.emplace_back(lang::hertz::the_gap_between_the_surfaces, numeral(found_.long_curvature * mm),
                          numeral(found_.short_curvature * mm), per);
        said.emplace_back(lang::hertz::the_effective_radius_is_r_1, length(found_.radius));
        return said;
    }

    std::vector<Words> contact() const {
        std::vector<Words> said;
        if (problem_.line) {
            said.emplace_back(lang::hertz::the_pressure_stands_as_a_semi, length(found_.b));
            said.emplace_back(lang::hertz::its_area_is_the_load, pressure(found_.mean), pressure(found_.greatest));
        } else if (found_.elliptic) {
            said.emplace_back(lang::hertz::the_face_of_contact, numeral(found_.b / found_.a));
            said.emplace_back(lang::hertz::and_its_size_from_the_load, length(found_.a), length(found_.b));
            said.emplace_back(lang::hertz::the_pressure_stands_as_a_semi_ellipsoid, pressure(found_.mean),
                              pressure(found_.greatest));
        } else {
            said.emplace_back(lang::hertz::the_pressure_stands_as_a_semi_ellipsoid_over, length(found_.a));
            said.emplace_back(lang::hertz::its_volume_is_the_load_p, pressure(found_.mean), pressure(found_.greatest));
        }
        said.push_back(approach());
        return said;
    }

    std::vector<Words> stresses() const {
        std::vector<Words> said;
        const Words body = called(mechanism_.body(problem_.bodies.at(found_.sheared).body));
        if (problem_.line)
            said.emplace_back(lang::hertz::on_the_axis_with_r_b);
        else if (found_.elliptic)
            said.emplace_back(lang::hertz::on_the_axis_the_stresses_follow);
        else
            said.emplace_back(lang::hertz::on_the_axis_with_z);
        const bool round = found_.a > 0 && !found_.elliptic;
        said.emplace_back(lang::hertz::the_greatest_shear_z_lies_below, body, pressure(found_.shear),
                          numeral(found_.shear / found_.greatest, 3), length(found_.depth),
                          numeral(found_.depth / found_.b, 3), std::string(round ? "{σ_r}" : "{σ_y}"),
                          std::string(round ? "{a}" : "{b}"));
        return said;
    }

    static std::vector<Words> hypotheses() {
        return {{lang::hertz::the_bodies_are_elastic_homogeneous}, {lang::hertz::the_contact_is_small_beside}};
    }

private:
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units); }
    Words given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, mechanism_.units, as_given);
    }
    Words pressure(double si) const { return amount(si, QuantityKind::pressure, mechanism_.units); }

    /// The joint that force and radii come from.
    Words at_joint(const AtJoint& at) const {
        if (!at.meshes) return {lang::hertz::at_the_mechanism_forces_give, at.joint};
        std::string radii;
        for (std::size_t i = 0; i < 2; ++i)
            if (at.pitch_radii.at(i) > 0)
                radii += (radii.empty() ? "" : ",  ") + std::string("{r_") + std::to_string(i + 1) + "} = {" +
                         std::to_string(i) + "} {3} {α}";
        const auto pitch = [&](std::size_t i) {
            return amount(at.pitch_radii.at(i), QuantityKind::length, mechanism_.units, 5);
        };
        return Words(lang::hertz::at_the_pitch_point_the_teeth, at.joint) +
               formula_words("\n" + radii + ",  {α} = {2}.",
                             {pitch(0), pitch(1), amount(at.pressure_angle, QuantityKind::angle, mechanism_.units),
                              lang::notation::sine_in_equations});
    }

    Words shape(const HertzBody& body, const std::string& n) const {
        const auto radius = [&](std::size_t plane, const std::string& mark) {
            const double found = body.radii.at(plane).to_double();
            const Words size = body.radii.at(plane).is_zero()
                                   ? Words(std::string("∞"))
                                   : amount(found, QuantityKind::length, mechanism_.units, problem_.at ? 4 : as_given);
            return Words("{r_" + n + "}" + mark + " = ") + size +
                   (body.inside.at(plane) ? Words(lang::hertz::concave) : Words());
        };
        if (body.radii[0].is_zero() && body.radii[1].is_zero()) return {lang::hertz::flat};
        if (body.radii[0] == body.radii[1] && body.inside[0] == body.inside[1]) return radius(0, "");
        return radius(0, "") + std::string(", ") + radius(1, "′");
    }
    /// "1/r₁ + 1/r₂".
    Words curvatures() const {
        std::string sum;
        for (std::size_t i = 0; i < 2; ++i) {
            const HertzBody& body = problem_.bodies.at(i);
            if (body.radii[0].is_zero()) continue;
            sum += body.inside[0] ? (sum.empty() ? "−" : " − ") : (sum.empty() ? "" : " + ");
            sum += "1/{r_" + std::to_string(i + 1) + "}";
        }
        return sum;
    }
    Words approach() const {
        if (!problem_.line)
            return found_.elliptic
                       ? Words(lang::hertz::points_far_from_the_contact_come, length(found_.approach))
                       : Words(lang::hertz::points_far_from_the_contact_come_nearer, length(found_.approach));
        Words sum;
        for (std::size_t i = 0; i < 2; ++i) {
            const Datum datum = datum_of(problem_, i);
            const Words name = called(mechanism_.body(problem_.bodies.at(i).body));
            if (i == 1) sum += lang::notation::semicolon;
            sum += datum.is_axis ? Words(lang::hertz::of_from_its_axis, name)
                                 : Words(lang::hertz::of_from_below_its_face, name, length(datum.depth));
        }
        return {lang::hertz::along_a_line_the_approach_depends, sum, length(found_.approach)};
    }

    const Mechanism& mechanism_;
    const HertzProblem& problem_;
    const HertzSolution& found_;
};

}  // namespace

std::vector<ProblemSection> hertz_sections(const DrawingContext& context) {
    const HertzText text(context);
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    return {{"given", text.heading(), {figure("contact", hertz_bodies_figure, 1)}, text.given()},
            {"equivalent", {lang::hertz::equivalent_body}, {}, text.equivalents()},
            {"pressure",
             {lang::hertz::contact_and_pressure},
             {figure("pressure", hertz_pressure_figure, 1)},
             text.contact()},
            {"stresses",
             {lang::hertz::stresses_below_the_surface},
             {figure("stresses", hertz_stress_figure, 0.9)},
             text.stresses()},
            hypotheses_section(HertzText::hypotheses())};
}

}  // namespace kinegraph::render
