// The worked solution of an impact: given data and class, equations of the impulses, phases, velocities afterwards,
// energy.
#include "problems/impact/impact.hpp"

#include <cmath>

#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/impact.hpp"
#include "lang/keys/notation.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

class ImpactText {
public:
    explicit ImpactText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(mechanism_.problem->as<ImpactProblem>()),
          found_(context.solution.problem->as<ImpactSolution>()),
          size_(kinegraph::length(found_.normal)) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        for (std::size_t i = 0; i < 2; ++i) {
            const ImpactBody& body = problem_.bodies.at(i);
            const std::string n = std::to_string(i + 1);
            const Words name = called(mechanism_.body(body.body));
            if (body.fixed) {
                said.emplace_back(lang::impact::fixed, name);
                continue;
            }
            Words line = name + lang::notation::colon +
                         formula_words("{m_" + n + "} = {0}", {given(body.mass, QuantityKind::mass)});
            if (body.inertia)
                line += formula_words(", {I_" + n + "} = {0}", {given(*body.inertia, QuantityKind::inertia)});
            if (found_.bodies.at(i).centre != found_.at)
                line += Words(lang::impact::centre_g_1, place(found_.bodies.at(i).centre), n);
            line += formula_words(", {!v_" + n + "} = {0}",
                                  {vector(found_.bodies.at(i).before, QuantityKind::velocity, as_given)});
            if (!body.omega.is_zero())
                line += formula_words(", {ω_" + n + "} = {0}", {given(body.omega, QuantityKind::angular_velocity)});
            if (body.pivot) line += Words(lang::impact::it_turns_about_o, place(*found_.bodies.at(i).pivot));
            said.push_back(line + std::string("."));
        }
        said.push_back(contact());
        said.emplace_back(lang::impact::restitution_e, numeral(found_.restitution.to_double(), as_given),
                          found_.friction.is_zero()
                              ? Words(lang::impact::no_friction)
                              : Words(lang::impact::friction_f, numeral(found_.friction.to_double(), as_given)));
        said.push_back(classes());
        return said;
    }

    std::vector<Words> equations() const {
        std::vector<Words> said;
        said.emplace_back(lang::impact::the_impulse_j_acts, per_mass(found_.a), per_mass(found_.b), per_mass(found_.c));
        said.emplace_back(lang::impact::with_1_m_r_n_i,
                          has_pivot() ? Words(lang::impact::from_the_pivot_o_with_i) : Words());
        said.emplace_back(lang::impact::before_the_impact_u_n_u, speed(found_.approach), speed(found_.slip));
        return said;
    }

    std::vector<Words> phases() const {
        std::vector<Words> said;
        if (found_.friction.is_zero()) {
            said.emplace_back(lang::impact::without_friction_j_t_0, impulse(found_.normal_impulse));
        } else {
            char letter = 'A';
            for (const ImpactSolution::Phase& phase : found_.phases) {
                const bool sticks = phase.kind == ImpactSolution::Phase::Kind::sticks;
                const Words how =
                    sticks ? Words(lang::impact::the_contact_sticks_u_t_0)
                           : Words(lang::impact::the_contact_slides_d_j_t, std::string(phase.sense > 0 ? "−" : ""));
                const Words until = phase.ends_compression            ? Words(lang::impact::until_the_compression_ends)
                                    : &phase == &found_.phases.back() ? Words(lang::impact::until_j_n_is_1_e)
                                                                      : Words(lang::impact::until_the_slip_ends);
                said.push_back(how + until +
                               Words(lang::impact::j_n_j_t, std::string(1, letter), impulse(phase.normal),
                                     impulse(phase.tangential)));
                ++letter;
            }
        }
        said.emplace_back(lang::impact::so_the_impulse_on_the_first,
                          vector(found_.impulse, QuantityKind::dimensionless));
        return said;
    }

    std::vector<Words> velocities() const {
        std::vector<Words> said;
        for (std::size_t i = 0; i < 2; ++i) {
            const ImpactSolution::Body& body = found_.bodies.at(i);
            if (body.fixed) continue;
            const std::string n = std::to_string(i + 1), sign = i == 0 ? " + " : " − ";
            if (body.pivot) {
                said.emplace_back(
                    lang::impact::r_2_j_i_o,
                    amount(body.omega_after.to_double(), QuantityKind::angular_velocity, mechanism_.units),
                    vector(*body.reaction, QuantityKind::dimensionless), n, sign);
                if (body.percussion)
                    said.emplace_back(lang::impact::the_centre_of_percussion_c_lies,
                                      amount(kinegraph::length(*body.percussion - *body.pivot), QuantityKind::length,
                                             mechanism_.units));
                continue;
            }
            Words line = formula_words("{!v_" + n + "}′ = {!v_" + n + "}" + sign + "{!J}/{m_" + n + "} = {0}",
                                       {vector(body.after, QuantityKind::velocity)});
            if (!body.inverse_inertia.is_zero())
                line += formula_words(
                    ",  {ω_" + n + "}′ = {0}",
                    {amount(body.omega_after.to_double(), QuantityKind::angular_velocity, mechanism_.units)});
            said.push_back(line + std::string("."));
        }
        return said;
    }

    std::vector<Words> restitution() const {
        std::vector<Words> said;
        said.emplace_back(
            lang::impact::along_the_normal_the_contact_parts, speed(found_.separation),
            numeral(found_.kinematic_restitution.to_double()),
            found_.kinematic_restitution == found_.restitution
                ? Words(lang::impact::the_given_e)
                : Words(lang::impact::newtons_while_the_impulses, numeral(found_.restitution.to_double(), as_given)));
        said.emplace_back(lang::impact::the_energy_lost_is_the_work, numeral(found_.energy_lost.to_double()),
                          numeral(found_.energy_before.to_double()));
        return said;
    }

private:
    Words given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, mechanism_.units, as_given);
    }
    Words vector(const Vector& v, QuantityKind kind, int digits = 4) const {
        const Unit unit = suitable_unit(kinegraph::length(v), kind, mechanism_.units);
        const double si = unit.si.to_double();
        return bound(Words(lang::impact::vector_with_unit, numeral(v.x.to_double() / si, digits),
                           numeral(v.y.to_double() / si, digits),
                           unit.symbol.empty() ? std::string() : " " + unit.symbol));
    }
    Words speed(const Exact& scaled) const {
        return amount(scaled.to_double() / size_, QuantityKind::velocity, mechanism_.units);
    }
    Words impulse(const Exact& scaled) const { return numeral(scaled.to_double() * size_) + std::string(" N s"); }
    Words per_mass(const Exact& scaled) const { return numeral(scaled.to_double() / (size_ * size_)); }
    Words place(const Vector& at) const { return vector(at, QuantityKind::length, as_given); }
    /// The point and direction of contact, and the body that the impulse J acts on.
    Words contact() const {
        const Words first = called(mechanism_.body(problem_.bodies[0].body)),
                    second = called(mechanism_.body(problem_.bodies[1].body));
        const double along = nearest::atan2(found_.normal.y.to_double(), found_.normal.x.to_double());
        return Words(lang::impact::the_bodies_touch_at_p, place(found_.at), first, second,
                     amount(along, QuantityKind::angle, mechanism_.units, as_given));
    }
    bool has_pivot() const { return found_.bodies[0].pivot || found_.bodies[1].pivot; }
    Words classes() const {
        return Words(
            lang::impact::the_impact, found_.central ? Words(lang::impact::central) : Words(lang::impact::eccentric),
            found_.central ? Words(lang::impact::the_centres_lie_on_the_line)
                           : Words(lang::impact::a_centre_lies_off_the_line),
            found_.direct
                ? Words(lang::impact::direct)
                : Words(lang::impact::oblique, amount(found_.obliquity, QuantityKind::angle, mechanism_.units)));
    }

    const Mechanism& mechanism_;
    const ImpactProblem& problem_;
    const ImpactSolution& found_;
    double size_;  ///< |n|
};

}  // namespace

std::vector<ProblemSection> impact_sections(const DrawingContext& context) {
    const ImpactText text(context);
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    std::vector<ProblemFigure> routh;
    if (has_routh_figure(context)) routh.push_back(figure("routh", impact_routh_figure, 0.8));
    return {{"given", {lang::common::heading_given}, {figure("contact", impact_bodies_figure, 1)}, text.given(), 1},
            {"impulse", {lang::impact::impulses_and_velocities}, {}, text.equations()},
            {"phases", {lang::impact::course_of_the_impact}, routh, text.phases()},
            {"velocities",
             {lang::impact::velocities_afterwards},
             {figure("velocities", impact_velocities_figure, 0.75), figure("contact-after", impact_after_figure, 0.8)},
             text.velocities()},
            {"restitution",
             {lang::impact::restitution_and_energy},
             {figure("restitution", impact_restitution_figure, 0.7)},
             text.restitution()},
            hypotheses_section({{lang::impact::the_impact_takes_no_time_places}})};
}

}  // namespace kinegraph::render
