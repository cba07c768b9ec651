// The motion of a point in words and formulas: laws, derivatives, the same in three forms, hodograph, intrinsic
// components and curvature, the course over the interval.
#include "problems/point/point.hpp"

#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/point_motion.hpp"
#include "render/equations/equation_text.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/expression_formula.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using MotionForm = PointProblem::Form;

/// Sentences, with the formulas and tables that belong to them.
struct PointSection {
    std::string question;  ///< its data-question attribute
    Words heading;
    std::vector<Words> sentences{};
    std::vector<PieceAfter> pieces{};  ///< in order of `after`
};

Formula sign(const char* text) { return Formula::sign(text); }
Formula upright(const std::string& text) { return Formula::upright(text); }

/// Notation of laws, values and places of a point's motion.
class PointPhrases {
protected:
    PointPhrases(const Solution& solution, Language language)
        : language_(language),
          mechanism_(solution.mechanism),
          problem_(mechanism_.problem->as<PointProblem>()),
          found_(solution.problem->as<PointMotionSolution>()) {}

    template <class Path>
    const Path* path() const {
        return problem_.path ? std::get_if<Path>(&*problem_.path) : nullptr;
    }
    Formula expression(const Expression& of, const char* variable = "t") const {
        return formula_of(of, problem_.constants, variable, language_);
    }
    static Formula equation(Formula left, Formula right) { return std::move(left) + sign("=") + std::move(right); }
    static Formula product(const char* name) { return Formula::letter(name, "", 1) + Formula::letter(name, "", 2); }
    static Formula crossed(const char* first, const char* second) {
        return Formula::letter(first, "", 1) + Formula::letter(second, "", 2);
    }
    static void add(PointSection& section, Formula formula) {
        section.pieces.push_back({section.sentences.size(), {EquationItem::Kind::formula, {}, std::move(formula), {}}});
    }
    Formula law_letter(std::size_t law, int order) const {
        const std::string& symbol = problem_.laws[law].symbol;
        return Formula::letter(symbol == "θ" ? "theta" : symbol, "", order);
    }
    /// Appends the value to the symbols, unless they are the value itself.
    Formula with_value(Formula symbols, const Formula& value) const {
        if (symbols.plain() == "0") return value;
        return std::move(symbols) + sign("=") + value;
    }
    Formula value_of(const StatedLaw& law, const Derived& derived, std::size_t order, double at, int dots) const {
        const Estimate found = estimate(derived.by_order.at(order), problem_.constants, at);
        const double value = found.is_zero() ? 0 : found.value * law.law.unit.to_double();
        if (law.symbol == "θ") return upright(number(value, 5, language_) + (dots == 1 ? " rad/s" : " rad/s²"));
        return upright(said(value, dots == 1 ? QuantityKind::velocity : QuantityKind::acceleration));
    }
    /// The unit of a law's number, if the law has no units of its own.
    Formula unit_of(const Expressed& law) const {
        if (!law.is_bare || law.unit == Exact(1)) return {};
        return upright("  [" + mechanism_.units.length.symbol + "]");
    }
    std::string name() const { return "{" + problem_.point + "}"; }
    Words said_constants() const {
        Words all;
        for (const NamedConstant& each : problem_.constants) {
            if (each.name.empty()) continue;
            const Formula letter = formula_of(each, Language::en);
            const Words value = said_constant(each);
            all += formula_words(all.empty() ? "{0} = {1}" : ",  {0} = {1}", {marked(letter), value});
        }
        return all.empty() ? all : all + std::string(".");
    }
    static std::string marked(const Formula& letter) {
        const Piece& piece = letter.text.front();
        return "{" + piece.text + (piece.sub.empty() ? "" : "_" + piece.sub) + "}";
    }
    Words said_constant(const NamedConstant& constant) const {
        const double value = constant.value.to_double();
        const Dimension& d = constant.dimension;
        const auto is = [&](int length, int time) { return d.length == length && d.time == time && d.mass == 0; };
        if (d.angle == 1 && is(0, 0)) return amount(value, QuantityKind::angle, mechanism_.units, 4);
        if (d.angle == 1 && is(0, -1)) return amount(value, QuantityKind::angular_velocity, mechanism_.units, 4);
        if (is(1, 0)) return amount(value, QuantityKind::length, mechanism_.units, as_given);
        if (is(1, -1)) return amount(value, QuantityKind::velocity, mechanism_.units, as_given);
        if (is(1, -2)) return amount(value, QuantityKind::acceleration, mechanism_.units, as_given);
        if (is(0, 1)) return amount(value, QuantityKind::time, mechanism_.units, as_given);
        Words said = numeral(value, 6);
        const auto put = [&](const char* symbol, int power) {
            if (power == 0) return;
            static constexpr const char* marks[] = {"⁻⁴", "⁻³", "⁻²", "⁻¹", "", "", "²", "³", "⁴"};
            said += std::string(" ") + symbol + (std::abs(power) <= 4 ? marks[power + 4] : "^" + std::to_string(power));
        };
        if (is(0, -1)) return said + std::string(" 1/s");
        put("kg", d.mass);
        put("m", d.length);
        put("s", d.time);
        return said;
    }
    std::string degrees(double radians) const {
        return amount(radians, QuantityKind::angle, mechanism_.units, language_, 4);
    }
    Formula complex_number(const Vector& v, const std::string& modulus, const std::string& unit) const {
        if (v.is_zero()) return upright("0");
        const double argument = nearest::atan2(v.y.to_double(), v.x.to_double());
        return upright(modulus) +
               Formula::power(Formula::letter("e"), Formula::letter("i") + upright(" " + degrees(argument))) +
               upright(" " + unit);
    }
    std::string said(double si, QuantityKind kind) const { return amount(si, kind, mechanism_.units, language_, 5); }
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units, 5); }
    Words speed(double si) const { return amount(si, QuantityKind::velocity, mechanism_.units, 5); }
    Words acceleration(double si) const { return amount(si, QuantityKind::acceleration, mechanism_.units, 5); }
    Words time(const Exact& si) const { return amount(si.to_double(), QuantityKind::time, mechanism_.units, as_given); }
    Words place_words(const Vector& v) const {
        const double si = mechanism_.units.length.si.to_double();
        return bound(Words(lang::common::place_with_unit, numeral(v.x.to_double() / si, 5),
                           numeral(v.y.to_double() / si, 5), mechanism_.units.length.symbol));
    }
    std::string place(const Vector& v) const { return unbound(in(place_words(v), language_)); }

    Language language_;
    const Mechanism& mechanism_;
    const PointProblem& problem_;
    const PointMotionSolution& found_;
};

class PointText : PointPhrases {
public:
    PointText(const Solution& solution, Language language) : PointPhrases(solution, language) {}

    PointSection given() const {
        PointSection section{"given", {lang::common::heading_given}, {}, {}};
        section.sentences.emplace_back(sentence_of_form());
        for (std::size_t i = 0; i < problem_.laws.size(); ++i)
            add(section, equation(law_letter(i, 0),
                                  Formula(expression(found_.laws[i].by_order[0])) + unit_of(problem_.laws[i].law)));
        if (const auto* graph = path<GraphPath>())
            add(section,
                equation(Formula::letter("y"), expression(found_.of_path->by_order[0], "x") + unit_of(graph->f.law)));
        if (const Words constants = said_constants(); !constants.empty()) section.sentences.push_back(constants);
        section.sentences.emplace_back(lang::point_motion::the_instant_is_t_the_interval, time(problem_.at),
                                       time(problem_.from), time(problem_.to));
        return section;
    }

    /// Each law, its derivatives in symbols, and their values at the instant.
    PointSection derivatives() const {
        PointSection section{"derivatives", {lang::point_motion::derivatives}, {}, {}};
        section.sentences.emplace_back(problem_.form == MotionForm::path
                                           ? Words(lang::point_motion::the_law_of_the_way)
                                           : Words(lang::point_motion::the_laws_are_derived_twice));
        for (int order = 1; order <= 2; ++order)
            for (std::size_t i = 0; i < problem_.laws.size(); ++i) {
                if (problem_.laws[i].text.empty()) continue;
                const auto k = static_cast<std::size_t>(order);
                add(section, equation(law_letter(i, order), with_value(expression(found_.laws[i].by_order.at(k)),
                                                                       value_of(problem_.laws[i], found_.laws[i], k,
                                                                                problem_.at.to_double(), order))));
            }
        if (!found_.of_path) return section;
        section.sentences.emplace_back(lang::point_motion::the_curve_is_derived_by_x,
                                       length(found_.place.x.to_double()));
        const auto& graph = *path<GraphPath>();
        for (int order = 1; order <= 2; ++order) {
            const auto k = static_cast<std::size_t>(order);
            const double unit = order == 1 ? 1 : graph.f.law.unit.to_double();
            const double value = estimate(found_.of_path->by_order.at(k), problem_.constants,
                                          found_.place.x.to_double() / graph.f.law.variable_unit.to_double())
                                     .value /
                                 unit;
            Formula said = upright(number(value, 5, language_) + (order == 2 ? " 1/m" : ""));
            add(section, equation(Formula::primed("y", "", order),
                                  with_value(expression(found_.of_path->by_order.at(k), "x"), said)));
        }
        return section;
    }

    /// Position, velocity and acceleration in coordinates, in polar components and as complex numbers.
    PointSection forms() const {
        PointSection section{"forms", {lang::point_motion::three_forms}, {}, {}};
        section.sentences.emplace_back(lang::point_motion::in_coordinates_in_components_along);
        const Formula r = Formula::letter("r"), theta = Formula::letter("theta");
        const auto dots = [](const char* name, int count) { return Formula::letter(name, "", count); };
        add(section, equation(Formula::letter("v", "r"), dots("r", 1)) + upright(",  ") +
                         equation(Formula::letter("v", "θ"), r + dots("theta", 1)));
        add(section, equation(Formula::letter("a", "r"),
                              dots("r", 2) + sign("−") + r + Formula::power(dots("theta", 1), upright("2"))) +
                         upright(",  ") +
                         equation(Formula::letter("a", "θ"),
                                  r + dots("theta", 2) + sign("+") + upright("2") + dots("r", 1) + dots("theta", 1)));
        const Formula turn = Formula::power(Formula::letter("e"), Formula::letter("i") + theta);
        add(section, equation(Formula::letter("z"),
                              Formula::letter("x") + sign("+") + Formula::letter("i") + Formula::letter("y")) +
                         sign("=") + r + turn + upright(",  ") +
                         equation(dots("z", 1), Formula::fenced(Formula::letter("v", "r") + sign("+") +
                                                                Formula::letter("i") + Formula::letter("v", "θ")) +
                                                    turn) +
                         upright(",  ") +
                         equation(dots("z", 2), Formula::fenced(Formula::letter("a", "r") + sign("+") +
                                                                Formula::letter("i") + Formula::letter("a", "θ")) +
                                                    turn));
        section.pieces.push_back({section.sentences.size(), {EquationItem::Kind::table, {}, {}, table()}});
        return section;
    }

    PointSection hodograph() const {
        PointSection section{"hodograph", {lang::common::hodograph}, {}, {}};
        section.sentences.emplace_back(lang::point_motion::the_velocities_drawn_from_one_origin);
        return section;
    }

    /// `at_the_board`: includes the construction of the centre of curvature that a figure shows.
    PointSection intrinsic(bool at_the_board) const {
        PointSection section{"curvature", {lang::point_motion::tangent_normal_curvature}, {}, {}};
        if (found_.rests) {
            section.sentences.emplace_back(lang::point_motion::v_0_at_this_instant,
                                           acceleration(found_.acceleration_length));
            return section;
        }
        const Formula v = Formula::letter("v"), a = Formula::letter("a");
        section.sentences.emplace_back(lang::point_motion::the_tangent_t_goes, speed(found_.speed),
                                       acceleration(found_.acceleration_length));
        const auto dot = [](int order) { return Formula::letter("v", "", order); };
        add(section, equation(Formula::letter("a", "t"), dot(1)) + sign("=") +
                         Formula::fraction(product("x") + sign("+") + product("y"), v) + sign("=") +
                         upright(said(found_.along, QuantityKind::acceleration)));
        add(section,
            equation(Formula::letter("a", "n"),
                     Formula::fraction(Formula::power(v, upright("2")), Formula::letter("rho"))) +
                sign("=") +
                Formula::fraction(upright("|") + crossed("x", "y") + sign("−") + crossed("y", "x") + upright("|"), v) +
                sign("=") + upright(said(found_.across, QuantityKind::acceleration)));
        if (found_.straight) {
            section.sentences.emplace_back(lang::point_motion::a_n_0_the_radius);
            return section;
        }
        if (at_the_board)
            section.sentences.emplace_back(lang::point_motion::at_the_board_a_n, "{" + problem_.point + "}");
        add(section, equation(Formula::letter("rho"),
                              Formula::fraction(Formula::power(v, upright("2")), Formula::letter("a", "n"))) +
                         sign("=") + upright(said(found_.radius, QuantityKind::length)) + upright(",  ") +
                         Formula::letter("C") + upright(" ") + upright(place(*found_.centre)));
        return section;
    }

    PointSection course() const {
        PointSection section{"course", {lang::point_motion::over_the_interval}, {}, {}};
        const PointMotionSolution::At& last = found_.course.back();
        section.sentences.emplace_back(lang::point_motion::at_the_instant_the_way, length(found_.way),
                                       length(last.way));
        return section;
    }

private:
    Words sentence_of_form() const {
        switch (problem_.form) {
            case MotionForm::cartesian: return {lang::point_motion::the_point_moves_in_the_plane, name()};
            case MotionForm::polar: return {lang::point_motion::the_point_moves_in_the_plane_the, name()};
            case MotionForm::path: break;
        }
        if (const auto* circle = path<CirclePath>())
            return {lang::point_motion::the_point_moves_along_the_circle, name(),
                    amount(circle->radius.to_double(), QuantityKind::length, mechanism_.units, as_given),
                    place_words(circle->centre),
                    amount(circle->start.to_double(), QuantityKind::angle, mechanism_.units, 5)};
        if (const auto* line = path<LinePath>())
            return {lang::point_motion::the_point_moves_along_the_line, name(), place_words(line->from),
                    amount(nearest::atan2(line->direction.y.to_double(), line->direction.x.to_double()),
                           QuantityKind::angle, mechanism_.units, 5)};
        return {lang::point_motion::the_point_moves_along_a_curve, name(),
                amount(path<GraphPath>()->start.to_double(), QuantityKind::length, mechanism_.units, as_given)};
    }

    std::vector<std::vector<Formula>> table() const {
        std::vector<std::vector<Formula>> rows;
        rows.push_back({upright(""), upright(word(lang::point_motion::cartesian, language_)),
                        upright(word(lang::point_motion::polar, language_)),
                        upright(word(lang::point_motion::complex, language_))});
        const auto row = [&](Formula letter, const Vector& v, QuantityKind kind, const std::array<double, 2>& polar,
                             bool is_place) {
            const Unit unit = suitable_unit(kinegraph::length(v), kind, mechanism_.units);
            const double si = unit.si.to_double();
            const auto digits = [&](double value) { return number(value / si, 4, language_); };
            std::vector<Formula> cells{std::move(letter)};
            cells.push_back(
                upright(pair_of(digits(v.x.to_double()), digits(v.y.to_double()), language_) + " " + unit.symbol));
            if (found_.at_pole)
                cells.push_back(upright("–"));
            else if (is_place)
                cells.push_back(upright(pair_of(digits(polar[0]) + " " + unit.symbol, degrees(polar[1]), language_)));
            else
                cells.push_back(upright(pair_of(digits(polar[0]), digits(polar[1]), language_) + " " + unit.symbol));
            cells.push_back(complex_number(v, digits(kinegraph::length(v)), unit.symbol));
            rows.push_back(std::move(cells));
        };
        row(Formula::letter("z"), found_.place, QuantityKind::length, {found_.r, found_.theta}, true);
        row(Formula::letter("z", "", 1), found_.velocity, QuantityKind::velocity, found_.polar_velocity, false);
        row(Formula::letter("z", "", 2), found_.acceleration, QuantityKind::acceleration, found_.polar_acceleration,
            false);
        return rows;
    }
};

std::vector<PointSection> point_text(const Solution& solution, Language language) {
    const PointText text(solution, language);
    return {text.given(), text.derivatives(), text.forms(), text.hodograph(), text.intrinsic(true), text.course()};
}

}  // namespace

std::vector<EquationItem> point_items(const Solution& solution, Language language) {
    const PointText text(solution, language);
    std::vector<EquationItem> items;
    for (PointSection& section : std::vector{text.given(), text.derivatives(), text.forms(), text.intrinsic(false)}) {
        items.push_back({EquationItem::Kind::heading, in(section.heading, language), {}, {}});
        auto piece = section.pieces.begin();
        const auto add_pieces = [&](std::size_t after) {
            for (; piece != section.pieces.end() && piece->after == after; ++piece)
                items.push_back(std::move(piece->item));
        };
        add_pieces(0);
        for (std::size_t k = 0; k < section.sentences.size(); ++k) {
            items.push_back({EquationItem::Kind::words, in(section.sentences[k], language), {}, {}});
            add_pieces(k + 1);
        }
    }
    return items;
}

std::vector<ProblemSection> point_sections(const DrawingContext& context) {
    const auto& found = context.solution.problem->as<PointMotionSolution>();
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    std::vector<ProblemSection> sections;
    for (PointSection& each : point_text(context.solution, context.language)) {
        ProblemSection section{each.question,         std::move(each.heading), {}, std::move(each.sentences), 0,
                               std::move(each.pieces)};
        if (section.question == "given") {
            section.figures.push_back(figure("trajectory", trajectory_figure, 1.1));
            section.figures.back().as_question = [&context](double x, double y) {
                return trajectory_question_figure(context, x, y);
            };
        }
        if (section.question == "hodograph") section.figures.push_back(figure("hodograph", hodograph_figure, 0.7));
        if (section.question == "curvature" && found.centre)
            section.figures.push_back(figure("curvature-centre", curvature_centre_figure, 0.9));
        if (section.question == "course") {
            section.figures.push_back(figure("way", way_figure, 0.6));
            section.figures.push_back(figure("speed", speed_figure, 0.6));
            section.figures.push_back(figure("components", components_figure, 0.7));
        }
        sections.push_back(std::move(section));
    }
    sections.push_back(hypotheses_section({{lang::point_motion::the_axes_are_fixed_derivatives}}));
    return sections;
}

}  // namespace kinegraph::render
