// The worked solution of finite displacements: the positions, each displacement, the fixed pivots.
#include "engine/solution/problem_solution.hpp"
#include "render/figures/problem_figures.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using By = Displacement::By;

class PositionsText {
public:
    explicit PositionsText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(std::get<PositionsProblem>(mechanism_.problem->of)),
          found_(std::get<PositionsSolution>(context.solution.problem->of)),
          a_(problem_.points[0]),
          b_(problem_.points[1]) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        for (std::size_t i = 0; i < problem_.positions.size(); ++i) {
            const auto& places = problem_.positions[i].places;
            said.emplace_back("Position {0}: {1} {2}, {3} {4}.", "Posizione {0}: {1} {2}, {3} {4}.",
                              std::to_string(i + 1), numbered(a_, i), place(places[0]), numbered(b_, i),
                              place(places[1]));
        }
        return said;
    }

    std::vector<Words> displacement(const Displacement& of) const {
        const std::string both = std::to_string(of.from + 1) + std::to_string(of.to + 1);
        switch (of.kind) {
            case Displacement::Kind::rest:
                return {{"Both points keep their places: the body is where it was.",
                         "I due punti restano dov’erano: il corpo non si è spostato."}};
            case Displacement::Kind::translation:
                return {
                    {"The bisectors of {0} and {1} are parallel, or the body has not turned: {2} and {3} are equal and "
                     "parallel. It is a translation, its pole at infinity:\n{d} = {4}.",
                     "Gli assi di {0} e {1} sono paralleli, o il corpo non ha ruotato: {2} e {3} sono uguali e "
                     "parallele. È una traslazione, con il polo all’infinito:\n{d} = {4}.",
                     join(a_, of), join(b_, of), body(of.from), body(of.to), place(of.way)}};
            case Displacement::Kind::rotation:
            case Displacement::Kind::general: break;
        }
        std::vector<Words> said{how(of, both)};
        said.emplace_back("It is the pole of the displacement: {P_" + both + "} {0}.",
                          "È il polo dello spostamento: {P_" + both + "} {0}.", place(*of.pole));
        said.emplace_back(
            "About it the body turns by the angle from {0} to {1}, the same for all its points:\n{φ_" + both +
                "} = {2}.",
            "Intorno ad esso il corpo ruota dell’angolo da {0} a {1}, lo stesso per tutti i suoi punti:\n{φ_" + both +
                "} = {2}.",
            body(of.from), body(of.to), angle(of.angle));
        if (of.kind == Displacement::Kind::general)
            said.emplace_back(
                "The same displacement results from the translation {0} = {1} followed by the rotation by {φ_" + both +
                    "} about {2}; another point would give another translation and the same angle.",
                "Lo stesso risulta dalla traslazione {0} = {1} e dalla rotazione di {φ_" + both +
                    "} intorno a {2}; un altro punto darebbe un’altra traslazione e lo stesso angolo.",
                join(a_, of), place(of.way), numbered(a_, of.to));
        return said;
    }

    std::vector<Words> pivots() const {
        std::vector<Words> said;
        said.emplace_back(
            "A crank turns about a point equally far from the three places of its pin: on the bisectors of 1–2 and of "
            "2–3, and so on that of 1–3.",
            "Una manovella ruota intorno a un punto equidistante dai tre luoghi del suo perno: sugli assi di 1–2 e di "
            "2–3, quindi anche su quello di 1–3.");
        for (std::size_t i = 0; i < 2; ++i) {
            const FixedPivot& pivot = found_.pivots.at(i);
            const std::string name = problem_.points.at(i), fixed = "{" + name + "_0}";
            switch (pivot.kind) {
                case FixedPivot::Kind::pivot:
                    said.emplace_back(fixed + " {0},  " + fixed + "{1} = {2}.",
                                      fixed + " {0},  " + fixed + "{1} = {2}.", place(*pivot.centre), numbered(name, 0),
                                      length(pivot.radius));
                    break;
                case FixedPivot::Kind::straight:
                    said.emplace_back("The places of {0} lie on a line: a slider guides it instead of a crank.",
                                      "I luoghi di {0} sono allineati: lo guida un corsoio anziché una manovella.",
                                      italic(name));
                    break;
                case FixedPivot::Kind::free:
                    said.emplace_back("Of {0} one bisector alone remains: its pivot may be chosen on it.",
                                      "Di {0} resta un solo asse: la cerniera si può scegliere su di esso.",
                                      italic(name));
                    break;
                case FixedPivot::Kind::fixed:
                    said.emplace_back("{0} keeps its place and is itself the pivot.",
                                      "{0} non si sposta ed è esso stesso la cerniera.", italic(name));
                    break;
            }
        }
        if (found_.pivots[0].centre && found_.pivots[1].centre)
            said.emplace_back(
                "The four-bar linkage {0} takes the body through the three positions; whether it does so without being "
                "taken apart is to be seen on its circles.",
                "Il quadrilatero articolato {0} porta il corpo nelle tre posizioni; se lo fa senza smontarlo si vede "
                "sulle sue circonferenze.",
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
                return {
                    "A point as far from {0} as from {1} lies on the bisector of {2}. The bisectors of {2} and {3} "
                    "meet in {P_" +
                        both + "}, which both positions have in common.",
                    "Un punto equidistante da {0} e da {1} sta sull’asse di {2}. Gli assi di {2} e di {3} s’incontrano "
                    "in {P_" +
                        both + "}, che le due posizioni hanno in comune.",
                    numbered(a_, of.from),
                    numbered(a_, of.to),
                    join(a_, of),
                    join(b_, of)};
            case By::joins:
                return {
                    "The bisectors of {0} and {1} coincide; then {2} and {3} meet on them, in {P_" + both + "}.",
                    "Gli assi di {0} e {1} coincidono; allora {2} e {3} s’incontrano su di essi, in {P_" + both + "}.",
                    join(a_, of),
                    join(b_, of),
                    body(of.from),
                    body(of.to)};
            case By::middle:
                return {
                    "All four places lie on one line and their bisectors coincide: half a turn about the common middle "
                    "{P_" +
                        both + "}.",
                    "I quattro luoghi sono allineati e gli assi coincidono: mezzo giro intorno al punto medio comune "
                    "{P_" +
                        both + "}."};
            case By::point: break;
        }
        return {"One of the points keeps its place: the body has turned about it, {P_" + both + "}.",
                "Uno dei punti non si è spostato: il corpo è ruotato intorno ad esso, {P_" + both + "}."};
    }
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units, 5); }
    Words angle(double si) const { return amount(si, QuantityKind::angle, mechanism_.units, 5); }
    /// "(12, 5) mm". In Italian a semicolon separates coordinates, because the comma is the decimal sign.
    Words place(const Vector& v) const {
        const double si = mechanism_.units.length.si.to_double();
        return {"({0}, {1}) {2}", "({0}; {1}) {2}", numeral(v.x.to_double() / si, 5), numeral(v.y.to_double() / si, 5),
                mechanism_.units.length.symbol};
    }

    const Mechanism& mechanism_;
    const PositionsProblem& problem_;
    const PositionsSolution& found_;
    const std::string &a_, &b_;
};

}  // namespace

std::vector<ProblemSection> positions_sections(const DrawingContext& context) {
    const PositionsText text(context);
    const auto& found = std::get<PositionsSolution>(context.solution.problem->of);
    const bool three = !found.pivots.empty();
    std::vector<ProblemSection> sections;
    ProblemFigure all{"positions", [&context](double x, double y) { return positions_question_figure(context, x, y); },
                      0.7};
    sections.push_back({"given", {"Given", "Dati"}, {std::move(all)}, text.given()});
    for (std::size_t i = 0; i < found.displacements.size(); ++i) {
        const Displacement& each = found.displacements[i];
        const std::string from = std::to_string(each.from + 1), to = std::to_string(each.to + 1);
        ProblemFigure figure{"displacement-" + from + to,
                             [&context, i](double x, double y) { return finite_displacement_figure(context, i, x, y); },
                             three ? 0.8 : 1.2};
        sections.push_back({"displacement-" + from + to,
                            {"Displacement {0} → {1}", "Spostamento {0} → {1}", from, to},
                            {std::move(figure)},
                            text.displacement(each)});
    }
    if (three) {
        ProblemFigure figure{"pivots", [&context](double x, double y) { return pivots_figure(context, x, y); }, 1.1};
        sections.push_back({"pivots", {"Fixed pivots", "Cerniere fisse"}, {std::move(figure)}, text.pivots()});
    }
    sections.push_back({"hypotheses",
                        {"Hypotheses", "Ipotesi"},
                        {},
                        {{"The body is rigid; only its positions matter, not how it goes from one to the next. Angles "
                          "are the smaller ones, counter-clockwise positive.",
                          "Il corpo è rigido; contano solo le sue posizioni, non come passa dall’una all’altra. Gli "
                          "angoli sono i minori, positivi se antiorari."}}});
    return sections;
}

}  // namespace kinegraph::render
