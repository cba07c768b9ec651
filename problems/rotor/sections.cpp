// The worked solution of balancing: data, unbalances and couples in a table, the couple polygon, the force polygon,
// what is left, the bearings.
#include "problems/rotor/rotor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/rotor.hpp"
#include "render/equations/equation_text.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using Row = std::vector<Formula>;

class RotorText {
public:
    explicit RotorText(const DrawingContext& context)
        : language_(context.language),
          mechanism_(context.solution.mechanism),
          units_(mechanism_.units),
          problem_(mechanism_.problem->as<RotorProblem>()),
          found_(context.solution.problem->as<RotorSolution>()) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        said.emplace_back(problem_.has_planes() ? lang::rotor::the_rotor_turns : lang::rotor::the_disc_turns);
        said.push_back(wanted());
        if (problem_.bearings)
            said.emplace_back(lang::rotor::it_runs_in_bearings, bearing(0), bearing(1), length(bearing_plane(0).z),
                              length(bearing_plane(1).z),
                              amount(problem_.omega.to_double(), QuantityKind::angular_velocity, units_, 5));
        return said;
    }
    EquationItem data() const {
        const bool planes = problem_.has_planes();
        std::vector<Row> rows{
            {Formula(), head("m", units_.mass.symbol), head("r", units_.length.symbol), head("θ", "°")}};
        if (planes) rows.front().push_back(head("z", units_.length.symbol));
        const auto place = [&](Row& row, const std::optional<std::size_t>& plane) {
            if (planes) row.push_back(number(problem_.z_of(plane), units_.length));
        };
        for (std::size_t i = 0; i < problem_.masses.size(); ++i) {
            const RotorMass& each = problem_.masses[i];
            rows.push_back({Formula::upright(each.name), number(each.mass, units_.mass),
                            number(each.radius, units_.length), degrees(i)});
            place(rows.back(), each.plane);
        }
        for (const RotorCorrection& each : problem_.corrections) {
            const std::string letter = problem_.name_of(each);
            rows.push_back({Formula::letter(letter), each.mass ? number(*each.mass, units_.mass) : symbol("m", letter),
                            each.radius ? number(*each.radius, units_.length) : symbol("r", letter),
                            symbol("θ", letter)});
            place(rows.back(), each.plane);
        }
        return table(std::move(rows));
    }

    std::vector<Words> unbalances() const {
        std::vector<Words> said;
        said.emplace_back(lang::rotor::each_mass_pulls_outwards);
        if (problem_.is_dynamic())
            said.emplace_back(lang::rotor::the_reference_plane, name(0));
        else if (problem_.has_planes())
            said.emplace_back(lang::rotor::couples_about_the_plane, name(0));
        return said;
    }
    EquationItem products() const {
        const bool planes = problem_.has_planes();
        const Unit unbalance = unit_of_unbalance(units_), couple = unit_of_couple(units_);
        std::vector<Row> rows{{Formula(), equal("U", {"m", "r"}, unbalance.symbol), head("θ", "°")}};
        if (planes) {
            rows.front().push_back(head("l", units_.length.symbol));
            rows.front().push_back(Formula::letter("U") + Formula::letter("l") + bracketed(couple.symbol));
        }
        for (std::size_t i = 0; i < problem_.masses.size(); ++i) {
            const RotorSolution::Unbalance& each = found_.unbalances[i];
            rows.push_back({Formula::upright(problem_.masses[i].name), number(each.size, unbalance), degrees(i)});
            if (!planes) continue;
            rows.back().push_back(number(each.arm, units_.length));
            rows.back().push_back(number(each.size * each.arm, couple));
        }
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i) {
            const std::string letter = name(i);
            rows.push_back({Formula::letter(letter), symbol("U", letter), symbol("θ", letter)});
            if (!planes) continue;
            rows.back().push_back(number(arm(i), units_.length));
            rows.back().push_back(arm(i).is_zero() ? Formula::upright("0") : symbol("U", letter) + symbol("l", letter));
        }
        return table(std::move(rows));
    }

    std::vector<Words> couples() const {
        const RotorSolution::Correction& b = found_.corrections[1];
        std::vector<Words> said;
        said.emplace_back(lang::rotor::the_correction_has_no_arm, name(0), name(1));
        if (b.vanishes) {
            said.emplace_back(lang::rotor::the_couple_polygon_closes, name(1));
            return said;
        }
        said.emplace_back(lang::rotor::the_couple_of_the_correction, name(1),
                          in_unit(b.unbalance * std::abs(arm(1).to_double()), unit_of_couple(units_)));
        said.emplace_back(lang::rotor::divided_by_the_arm, name(1), length(arm(1)),
                          in_unit(b.unbalance, unit_of_unbalance(units_)), angle(b.angle));
        add_size(1, said);
        return said;
    }
    std::vector<Words> forces() const {
        const RotorSolution::Correction& a = found_.corrections[0];
        std::vector<Words> said;
        if (a.vanishes)
            said.emplace_back(lang::rotor::the_force_polygon_closes,
                              problem_.has_planes() ? Words(lang::rotor::in_the_plane, name(0)) : Words());
        else if (problem_.is_dynamic() && !found_.corrections[1].vanishes)
            said.emplace_back(lang::rotor::the_force_polygon_with_b, name(0), name(1),
                              in_unit(a.unbalance, unit_of_unbalance(units_)), angle(a.angle));
        else
            said.emplace_back(lang::rotor::the_closing_side, name(0), in_unit(a.unbalance, unit_of_unbalance(units_)),
                              angle(a.angle));
        add_size(0, said);
        return said;
    }
    std::vector<Words> left() const {
        if (found_.couple_left->is_zero()) return {{lang::rotor::no_couple_is_left, name(0)}};
        return {{lang::rotor::the_couple_is_left, name(0),
                 in_unit(kinegraph::length(*found_.couple_left), unit_of_couple(units_)),
                 angle(nearest::atan2(found_.couple_left->y.to_double(), found_.couple_left->x.to_double()))}};
    }
    std::vector<Words> bearings() const {
        std::vector<Words> said;
        said.emplace_back(lang::rotor::the_bearings_hold, bearing(0));
        said.emplace_back(lang::rotor::so_the_bearings_press, bearing(0), bearing(1), reaction(0), reaction(1));
        if (found_.couple_left && !found_.couple_left->is_zero())
            said.emplace_back(lang::rotor::after_static_balancing, bearing(0), bearing(1),
                              amount(*found_.reaction_left, QuantityKind::force, units_));
        else
            said.emplace_back(lang::rotor::after_balancing_nothing);
        return said;
    }

private:
    static EquationItem table(std::vector<Row> rows) { return {EquationItem::Kind::table, {}, {}, std::move(rows)}; }
    /// As sentences have it: a single letter below is italic.
    static Formula symbol(const char* letter, const std::string& index) {
        Formula set;
        set.kind = Formula::Kind::text;
        set.text = symbol_of(letter + ("_" + index));
        return set;
    }
    static Formula bracketed(const std::string& unit) { return Formula::upright("  [" + unit + "]"); }
    static Formula head(const char* letter, const std::string& unit) {
        return Formula::letter(letter) + bracketed(unit);
    }
    static Formula equal(const char* letter, std::array<const char*, 2> product, const std::string& unit) {
        return Formula::letter(letter) + Formula::sign("=") + Formula::letter(product[0]) +
               Formula::letter(product[1]) + bracketed(unit);
    }
    Formula number(const Exact& si, const Unit& unit) const {
        return Formula::upright(in(numeral((si / unit.si).to_double(), as_given), language_));
    }
    /// The angle of a mass as a number, 0 … 360.
    Formula degrees(std::size_t mass) const {
        const Bearing& bearing = problem_.masses[mass].angle;
        double radians = 0;
        if (const auto* stated = std::get_if<Angle>(&bearing.form)) {
            radians = (stated->in_degrees ? stated->value * pi() / 180 : stated->value).to_double();
        } else {
            const Vector& along = std::get<Vector>(bearing.form);
            radians = nearest::atan2(along.y.to_double(), along.x.to_double());
        }
        return Formula::upright(in(numeral(radians * 180 / pi().to_double(), as_given), language_));
    }
    std::string name(std::size_t correction) const { return problem_.name_of(problem_.corrections[correction]); }
    /// Of a correction, from the reference plane.
    Exact arm(std::size_t correction) const {
        return problem_.z_of(problem_.corrections[correction].plane) - problem_.z_of(problem_.corrections[0].plane);
    }
    const RotorPlane& bearing_plane(std::size_t i) const { return problem_.planes[problem_.bearings->at(i)]; }
    const std::string& bearing(std::size_t i) const { return bearing_plane(i).name; }
    Words length(const Exact& si) const { return amount(si.to_double(), QuantityKind::length, units_, as_given); }
    Words angle(double radians) const {
        return amount(radians < 0 ? radians + 2 * pi().to_double() : radians, QuantityKind::angle, units_);
    }
    static Words in_unit(double si, const Unit& unit) {
        return numeral(si / unit.si.to_double()) + std::string("\u00A0" + unit.symbol);
    }
    Words reaction(std::size_t i) const {
        const RotorSolution::Reaction& each = found_.reactions[i];
        const Words force = amount(each.force, QuantityKind::force, units_);
        return each.vanishes ? force : Words(lang::rotor::at_the_angle, force, bearing(i), angle(each.angle));
    }
    Words wanted() const {
        if (problem_.is_dynamic()) return {lang::rotor::it_is_to_be_balanced_in_two, name(0), name(1)};
        if (problem_.has_planes()) return {lang::rotor::it_is_to_be_balanced_in_one, name(0)};
        return {lang::rotor::it_is_to_be_balanced_by_one_mass};
    }
    /// The mass at a given radius, or the radius of a given mass.
    void add_size(std::size_t i, std::vector<Words>& said) const {
        const RotorCorrection& given = problem_.corrections[i];
        const RotorSolution::Correction& found = found_.corrections[i];
        if (found.vanishes) return;
        if (found.mass)
            said.emplace_back(lang::rotor::at_the_radius_it_is, name(i), length(*given.radius),
                              amount(*found.mass, QuantityKind::mass, units_));
        if (found.radius)
            said.emplace_back(lang::rotor::the_mass_stands_at, name(i),
                              amount(given.mass->to_double(), QuantityKind::mass, units_, as_given),
                              amount(*found.radius, QuantityKind::length, units_));
    }

    Language language_;
    const Mechanism& mechanism_;
    const Units& units_;
    const RotorProblem& problem_;
    const RotorSolution& found_;
};

ProblemFigure polygon_of(const DrawingContext& context, RotorFigure which, double height) {
    return {id_of(which), [&context, which](double x, double y) { return rotor_polygon(context, which, x, y); },
            height};
}
ProblemFigure view_of(const DrawingContext& context, const char* id,
                      Figure (*draw)(const DrawingContext&, RotorShown, double, double), double height) {
    return {id, [&context, draw](double x, double y) { return draw(context, RotorShown::found, x, y); }, height,
            [&context, draw](double x, double y) { return draw(context, RotorShown::given, x, y); }};
}

}  // namespace

std::vector<ProblemSection> rotor_sections(const DrawingContext& context) {
    const RotorText text(context);
    const auto& problem = context.solution.mechanism.problem->as<RotorProblem>();
    const auto& found = context.solution.problem->as<RotorSolution>();
    ProblemSection given{
        "given", {lang::common::heading_given}, {view_of(context, "end-view", rotor_end_view, 0.9)}, text.given()};
    if (has_side_view(problem)) given.figures.push_back(view_of(context, "side-view", rotor_side_view, 0.8));
    given.pieces.push_back({1, text.data()});
    ProblemSection products{"unbalances", {lang::rotor::heading_unbalances}, {}, text.unbalances()};
    products.pieces.push_back({products.sentences.size(), text.products()});
    std::vector<ProblemSection> sections{std::move(given), std::move(products)};
    // A polygon without sides of masses is not drawn.
    const auto polygon = [&](ProblemSection& of, RotorFigure which, const RotorPolygon& drawn, double height) {
        const bool has_masses = std::any_of(drawn.sides.begin(), drawn.sides.end(),
                                            [](const RotorPolygon::Side& each) { return each.mass.has_value(); });
        if (has_masses) of.figures.push_back(polygon_of(context, which, height));
    };
    if (problem.is_dynamic()) {
        ProblemSection& couples = sections.emplace_back(ProblemSection{
            "couples", {lang::rotor::heading_couples, problem.name_of(problem.corrections[0])}, {}, text.couples()});
        polygon(couples, RotorFigure::couples, found.balance.couples, 0.75);
    }
    ProblemSection& forces =
        sections.emplace_back(ProblemSection{"forces", {lang::rotor::heading_forces}, {}, text.forces()});
    polygon(forces, RotorFigure::forces, found.balance.forces, 0.75);
    if (found.couple_left) {
        ProblemSection& left =
            sections.emplace_back(ProblemSection{"left", {lang::rotor::heading_couple_left}, {}, text.left()});
        polygon(left, RotorFigure::couples_left, found.couples_left, 0.7);
    }
    if (problem.bearings) {
        ProblemSection& bearings =
            sections.emplace_back(ProblemSection{"bearings", {lang::rotor::heading_bearings}, {}, text.bearings()});
        polygon(bearings, RotorFigure::bearing_couples, found.held->couples, 0.65);
        polygon(bearings, RotorFigure::bearing_forces, found.held->forces, 0.65);
    }
    sections.push_back(hypotheses_section({{lang::rotor::the_shaft_is_rigid}}));
    return sections;
}

}  // namespace kinegraph::render
