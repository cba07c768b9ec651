// The worked solution of wear by Reye's hypothesis: given data, the hypothesis and its form for this motion,
// equilibrium, torque, depth of wear.
#include "problems/reye/reye.hpp"

#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/reye.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using Kind = ReyeProblem::Kind;

class ReyeText {
public:
    explicit ReyeText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(mechanism_.problem->as<ReyeProblem>()),
          found_(context.solution.problem->as<ReyeSolution>()) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        const Words force = given(problem_.force, QuantityKind::force);
        switch (problem_.kind) {
            case Kind::pad:
                said.emplace_back(lang::reye::a_pad_of_length, length(problem_.length), length(problem_.width), force,
                                  length(problem_.offset));
                break;
            case Kind::block:
                said.emplace_back(lang::reye::a_block_of_length, length(problem_.length), length(problem_.width),
                                  force);
                break;
            case Kind::disc:
                said.emplace_back(lang::reye::rings_from_r_1_to_r, length(problem_.inner), length(problem_.outer),
                                  force, std::to_string(problem_.surfaces));
                break;
            case Kind::shoe:
                said.emplace_back(lang::reye::a_shoe_a_drum_of_radius,
                                  problem_.inside ? Words(lang::reye::shoe_inside) : Words(lang::reye::shoe_outside),
                                  length(problem_.radius), length(problem_.width),
                                  given(problem_.from, QuantityKind::angle), given(problem_.to, QuantityKind::angle),
                                  length(problem_.pivot), force, length(problem_.arm),
                                  problem_.leading ? Words(lang::reye::leading) : Words(lang::reye::trailing));
                break;
        }
        if (problem_.friction)
            said.emplace_back(lang::reye::coefficient_of_friction_f, numeral(problem_.friction->to_double(), as_given));
        if (problem_.wear)
            said.emplace_back(lang::reye::coefficient_of_wear_k_for_t, given(*problem_.wear, QuantityKind::wear),
                              std::string(turns() ? "{ω}" : "{v}"), speed(), given(*problem_.time, QuantityKind::time));
        said.emplace_back(lang::reye::wear_follows_reye_hypothesis,
                          problem_.kind == Kind::disc ? Words(lang::reye::the_rings_are_worn) : Words());
        return said;
    }

    std::vector<Words> hypothesis() const {
        std::vector<Words> said;
        said.emplace_back(lang::reye::the_volume_worn_off_goes);
        switch (problem_.kind) {
            case Kind::pad: said.emplace_back(lang::reye::all_points_slide_alike); break;
            case Kind::block: said.emplace_back(lang::reye::all_points_slide_alike_and_wear); break;
            case Kind::disc: said.emplace_back(lang::reye::the_sliding_goes_with_r); break;
            case Kind::shoe: said.emplace_back(lang::reye::all_points_slide_alike_the_shoe); break;
        }
        return said;
    }

    std::vector<Words> equilibrium() const {
        switch (problem_.kind) {
            case Kind::pad: return pad();
            case Kind::block: return {{lang::reye::the_force_is_the_pressure, pressure(found_.first)}};
            case Kind::disc: return disc();
            case Kind::shoe: return shoe();
        }
        return {};
    }

    std::vector<Words> wear() const {
        const auto& worn = *found_.worn;
        return {{lang::reye::with_the_coefficient_of_wear_k, given(*problem_.wear, QuantityKind::wear), speed(),
                 given(*problem_.time, QuantityKind::time), length(worn[0]), length(worn[1]),
                 std::string(turns() ? "{ω}" : "{v}"), std::string(turns() ? "{ω}{r}" : "{v}")}};
    }

private:
    bool turns() const { return problem_.kind == Kind::disc || problem_.kind == Kind::shoe; }
    Words speed() const {
        return given(*problem_.speed, turns() ? QuantityKind::angular_velocity : QuantityKind::velocity);
    }
    Words given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, mechanism_.units, as_given);
    }
    Words length(const Exact& si) const { return given(si, QuantityKind::length); }
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units); }
    Words pressure(double si) const { return amount(si, QuantityKind::pressure, mechanism_.units); }
    Words moment(double si) const { return amount(si, QuantityKind::moment, mechanism_.units); }

    std::vector<Words> pad() const {
        std::vector<Words> said;
        said.emplace_back(lang::reye::the_pressures_balance_the_force);
        if (found_.lifts)
            said.emplace_back(lang::reye::here_d_lies_outside_a_3, length(found_.begin), length(found_.end),
                              pressure(found_.greatest));
        else
            said.emplace_back(lang::reye::p_1_2_q_2,
                              found_.m ? Words(lang::reye::so_m_3_a_6_d, numeral(found_.m->to_double()))
                                       : Words(lang::reye::so_pressures),
                              pressure(found_.first), pressure(found_.second));
        said.emplace_back(lang::reye::the_resultant_r_passes_through);
        if (found_.friction_force)
            said.emplace_back(lang::reye::the_friction_is_f_q,
                              amount(*found_.friction_force, QuantityKind::force, mechanism_.units));
        return said;
    }
    std::vector<Words> disc() const {
        std::vector<Words> said;
        said.emplace_back(lang::reye::ring_by_ring_the_pressures_make, pressure(found_.first), pressure(found_.second));
        said.emplace_back(lang::reye::the_friction_acts_at_the_mean, moment(*found_.torque));
        said.emplace_back(lang::reye::new_before_it_has_worn, pressure(*found_.uniform_pressure),
                          moment(*found_.uniform_torque));
        return said;
    }
    std::vector<Words> shoe() const {
        std::vector<Words> said;
        said.emplace_back(
            lang::reye::about_the_pivot_pressures_and_friction,
            problem_.leading ? Words(lang::reye::helping_it_leading) : Words(lang::reye::against_it_trailing),
            std::string(problem_.leading ? "−" : "+"));
        said.emplace_back(lang::reye::so_the_greatest_pressure_and_those, pressure(found_.greatest),
                          pressure(found_.first), pressure(found_.second));
        said.emplace_back(lang::reye::the_torque_on_the_drum, moment(*found_.torque));
        said.emplace_back(
            lang::reye::the_pressures_have_the_resultant_n,
            amount(nearest::hypot(found_.normal_force.x, found_.normal_force.y), QuantityKind::force, mechanism_.units),
            length(found_.pressure_radius));
        if (problem_.leading && found_.locking_friction)
            said.emplace_back(lang::reye::from_f_on_the_shoe, numeral(*found_.locking_friction));
        return said;
    }

    const Mechanism& mechanism_;
    const ReyeProblem& problem_;
    const ReyeSolution& found_;
};

}  // namespace

std::vector<ProblemSection> reye_sections(const DrawingContext& context) {
    const ReyeText text(context);
    const auto& found = context.solution.problem->as<ReyeSolution>();
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    ProblemFigure bodies = figure("contact", reye_contact_figure, 1.1);
    bodies.as_question = [&context](double x, double y) { return reye_question_figure(context, x, y); };
    std::vector<ProblemFigure> plots;
    if (found.torque) plots.push_back(figure("pressures", reye_pressure_figure, 0.8));
    std::vector<ProblemSection> sections{{"given", {lang::common::heading_given}, {std::move(bodies)}, text.given()},
                                         {"hypothesis", {lang::reye::reye_hypothesis}, {}, text.hypothesis()},
                                         {"pressure", {lang::reye::equilibrium}, plots, text.equilibrium()}};
    if (found.worn) sections.push_back({"wear", {lang::reye::heading_depth_worn_off}, {}, text.wear()});
    sections.push_back(hypotheses_section({{lang::reye::the_bodies_are_rigid}}));
    return sections;
}

}  // namespace kinegraph::render
