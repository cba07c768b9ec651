// The worked solution of finite displacements: the positions, each displacement, the fixed pivots.
#include "problems/positions/positions.hpp"

#include "lang/keys/common.hpp"
#include "lang/keys/finite_positions.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using By = Displacement::By;

class PositionsText {
public:
    explicit PositionsText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(mechanism_.problem->as<PositionsProblem>()),
          found_(context.solution.problem->as<PositionsSolution>()),
          a_(problem_.points[0]),
          b_(problem_.points[1]) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        for (std::size_t i = 0; i < problem_.positions.size(); ++i) {
            const auto& places = problem_.positions[i].places;
            said.emplace_back(lang::finite_positions::position, std::to_string(i + 1), numbered(a_, i),
                              place(places[0]), numbered(b_, i), place(places[1]));
        }
        return said;
    }

    std::vector<Words> displacement(const Displacement& of) const {
        const std::string both = std::to_string(of.from + 1) + std::to_string(of.to + 1);
        switch (of.kind) {
            case Displacement::Kind::rest: return {{lang::finite_positions::both_points_keep_their_places}};
            case Displacement::Kind::translation:
                return {{lang::finite_positions::the_bisectors_of_and_are_parallel, join(a_, of), join(b_, of),
                         body(of.from), body(of.to), place(of.way)}};
            case Displacement::Kind::rotation:
            case Displacement::Kind::general: break;
        }
        std::vector<Words> said{how(of, both)};
        said.emplace_back(lang::finite_positions::it_is_the_pole, place(*of.pole), both);
        said.emplace_back(lang::finite_positions::about_it_the_body_turns, body(of.from), body(of.to), angle(of.angle),
                          both);
        if (of.kind == Displacement::Kind::general)
            said.emplace_back(lang::finite_positions::the_same_displacement_results, join(a_, of), place(of.way),
                              numbered(a_, of.to), both);
        return said;
    }

    std::vector<Words> pivots() const {
        std::vector<Words> said;
        said.emplace_back(lang::finite_positions::a_crank_turns_about_a_point);
        for (std::size_t i = 0; i < 2; ++i) {
            const FixedPivot& pivot = found_.pivots.at(i);
            const std::string name = problem_.points.at(i), fixed = "{" + name + "_0}";
            switch (pivot.kind) {
                case FixedPivot::Kind::pivot:
                    said.push_back(formula_words(fixed + " {0},  " + fixed + "{1} = {2}.",
                                                 {place(*pivot.centre), numbered(name, 0), length(pivot.radius)}));
                    break;
                case FixedPivot::Kind::straight:
                    said.emplace_back(lang::finite_positions::the_places_of_lie, italic(name));
                    break;
                case FixedPivot::Kind::free:
                    said.emplace_back(lang::finite_positions::of_one_bisector_alone_remains, italic(name));
                    break;
                case FixedPivot::Kind::fixed:
                    said.emplace_back(lang::finite_positions::keeps_its_place_and_is_itself, italic(name));
                    break;
            }
        }
        if (found_.pivots[0].centre && found_.pivots[1].centre)
            said.emplace_back(lang::finite_positions::the_four_bar_linkage_takes,
                              "{" + a_ + "_0}{" + a_ + "}{" + b_ + "}{" + b_ + "_0}");
        return said;
    }

private:
    static std::string italic(const std::string& name) { return "{" + name + "}"; }
    static std::string numbered(const std::string& name, std::size_t position) {
        return "{" + name + "_" + std::to_string(position + 1) + "}";
    }
    static std::string join(const std::string& name, const Displacement& of) {
        return numbered(name, of.from) + numbered(name, of.to);
    }
    std::string body(std::size_t position) const { return numbered(a_, position) + numbered(b_, position); }
    Words how(const Displacement& of, const std::string& both) const {
        switch (of.by) {
            case By::bisectors:
                return {lang::finite_positions::a_point_as_far,
                        numbered(a_, of.from),
                        numbered(a_, of.to),
                        join(a_, of),
                        join(b_, of),
                        both};
            case By::joins:
                return {lang::finite_positions::the_bisectors_of_and_coincide_then,
                        join(a_, of),
                        join(b_, of),
                        body(of.from),
                        body(of.to),
                        both};
            case By::middle: return {lang::finite_positions::all_four_places_lie, both};
            case By::point: break;
        }
        return {lang::finite_positions::one_of_the_points_keeps, both};
    }
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units, 5); }
    Words angle(double si) const { return amount(si, QuantityKind::angle, mechanism_.units, 5); }
    /// "(12, 5) mm". In Italian a semicolon separates coordinates, because the comma is the decimal sign.
    Words place(const Vector& v) const {
        const double si = mechanism_.units.length.si.to_double();
        return bound(Words(lang::common::place_with_unit, numeral(v.x.to_double() / si, 5),
                           numeral(v.y.to_double() / si, 5), mechanism_.units.length.symbol));
    }

    const Mechanism& mechanism_;
    const PositionsProblem& problem_;
    const PositionsSolution& found_;
    const std::string &a_, &b_;
};

}  // namespace

std::vector<ProblemSection> positions_sections(const DrawingContext& context) {
    const PositionsText text(context);
    const auto& found = context.solution.problem->as<PositionsSolution>();
    const bool three = !found.pivots.empty();
    std::vector<ProblemSection> sections;
    ProblemFigure all{"positions", [&context](double x, double y) { return positions_question_figure(context, x, y); },
                      0.7};
    sections.push_back({"given", {lang::common::heading_given}, {std::move(all)}, text.given()});
    for (std::size_t i = 0; i < found.displacements.size(); ++i) {
        const Displacement& each = found.displacements[i];
        const std::string from = std::to_string(each.from + 1), to = std::to_string(each.to + 1);
        ProblemFigure figure{"displacement-" + from + to,
                             [&context, i](double x, double y) { return finite_displacement_figure(context, i, x, y); },
                             three ? 0.8 : 1.2};
        sections.push_back({"displacement-" + from + to,
                            {lang::finite_positions::displacement, from, to},
                            {std::move(figure)},
                            text.displacement(each)});
    }
    if (three) {
        ProblemFigure figure{"pivots", [&context](double x, double y) { return pivots_figure(context, x, y); }, 1.1};
        sections.push_back({"pivots", {lang::finite_positions::fixed_pivots}, {std::move(figure)}, text.pivots()});
    }
    sections.push_back(hypotheses_section({{lang::finite_positions::the_body_is_rigid_only}}));
    return sections;
}

}  // namespace kinegraph::render
