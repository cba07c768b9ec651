// The worked solution of wear by Reye's hypothesis: given data, the hypothesis and its form for this motion,
// equilibrium, torque, depth of wear.
#include <cmath>
#include <numbers>

#include "engine/solution/problem_solution.hpp"
#include "render/figures/problem_figures.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using Kind = ReyeProblem::Kind;

class ReyeText {
public:
    explicit ReyeText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(std::get<ReyeProblem>(mechanism_.problem->of)),
          found_(std::get<ReyeSolution>(context.solution.problem->of)) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        const Words force = given(problem_.force, QuantityKind::force);
        switch (problem_.kind) {
            case Kind::pad:
                said.emplace_back(
                    "A pad of length {a} = {0} and width {b} = {1}, free to tilt, is pressed by {Q} = {2} at {d} = {3} "
                    "from its end {x} = 0.",
                    "Un pattino lungo {a} = {0} e largo {b} = {1}, libero di inclinarsi, è premuto da {Q} = {2} a {d} "
                    "= {3} dal suo estremo {x} = 0.",
                    length(problem_.length), length(problem_.width), force, length(problem_.offset));
                break;
            case Kind::block:
                said.emplace_back(
                    "A block of length {a} = {0} and width {b} = {1}, guided so that it cannot tilt, is pressed by {Q} "
                    "= {2}.",
                    "Un blocco lungo {a} = {0} e largo {b} = {1}, guidato così che non si inclini, è premuto da {Q} = "
                    "{2}.",
                    length(problem_.length), length(problem_.width), force);
                break;
            case Kind::disc:
                said.emplace_back(
                    "Rings from {r_1} = {0} to {r_2} = {1} are pressed together by {Q} = {2} on {n} = {3} surfaces.",
                    "Corone da {r_1} = {0} a {r_2} = {1} sono premute da {Q} = {2} su {n} = {3} superfici.",
                    length(problem_.inner), length(problem_.outer), force, std::to_string(problem_.surfaces));
                break;
            case Kind::shoe:
                said.emplace_back(
                    "A shoe {0} a drum of radius {r} = {1}, {b} = {2} wide, from {θ_1} = {3} to {θ_2} = {4} (at {O}, "
                    "from the direction of the pivot), turns about a pivot at {h} = {5} from the drum’s centre {O}. "
                    "The force {Q} = {6} has the arm {c} = {7}; the drum turns so that the shoe is {8}.",
                    "Un ceppo {0} a un tamburo di raggio {r} = {1}, largo {b} = {2}, da {θ_1} = {3} a {θ_2} = {4} (in "
                    "{O}, dalla direzione della cerniera), ruota intorno a una cerniera a {h} = {5} dal centro {O}. La "
                    "forza {Q} = {6} ha braccio {c} = {7}; il tamburo ruota così che il ceppo è {8}.",
                    problem_.inside ? Words("in", "interno") : Words("on", "esterno"), length(problem_.radius),
                    length(problem_.width), given(problem_.from, QuantityKind::angle),
                    given(problem_.to, QuantityKind::angle), length(problem_.pivot), force, length(problem_.arm),
                    problem_.leading ? Words("leading", "avvolgente") : Words("trailing", "svolgente"));
                break;
        }
        if (problem_.friction)
            said.emplace_back("Coefficient of friction {f} = {0}.", "Coefficiente d’attrito {f} = {0}.",
                              numeral(problem_.friction->to_double(), as_given));
        if (problem_.wear)
            said.emplace_back("Coefficient of wear {k} = {0}; {1} = {2} for {t} = {3}.",
                              "Coefficiente d’usura {k} = {0}; {1} = {2} per {t} = {3}.",
                              given(*problem_.wear, QuantityKind::wear), std::string(turns() ? "{ω}" : "{v}"), speed(),
                              given(*problem_.time, QuantityKind::time));
        said.emplace_back(
            "Wear follows Reye’s hypothesis{0}.", "L’usura segue l’ipotesi di Reye{0}.",
            problem_.kind == Kind::disc ? Words("; the rings are worn in", "; le corone sono rodate") : Words());
        return said;
    }

    std::vector<Words> hypothesis() const {
        std::vector<Words> said;
        said.emplace_back(
            "The volume worn off goes with the work of friction, so the depth goes with pressure × sliding:\nΔ{h} d{A} "
            "∝ {f}{p} d{A} Δ{s}.",
            "Il volume asportato è proporzionale al lavoro d’attrito, quindi la profondità a pressione × "
            "strisciamento:\nΔ{h} d{A} ∝ {f}{p} d{A} Δ{s}.");
        switch (problem_.kind) {
            case Kind::pad:
                said.emplace_back(
                    "All points slide alike and the pad stays plane, so {p} is linear:\n{p} = {p_1}(1 + {m}{x}/{a}).",
                    "Tutti i punti strisciano ugualmente e il pattino resta piano, quindi {p} è lineare:\n{p} = "
                    "{p_1}(1 + {m}{x}/{a}).");
                break;
            case Kind::block:
                said.emplace_back("All points slide alike and wear alike, so {p} is even.",
                                  "Tutti i punti strisciano e si usurano ugualmente, quindi {p} è uniforme.");
                break;
            case Kind::disc:
                said.emplace_back("The sliding goes with {r} and the rings wear evenly, so\n{p}{r} = const.",
                                  "Lo strisciamento è proporzionale a {r} e le corone si usurano uniformemente, "
                                  "quindi\n{p}{r} = cost.");
                break;
            case Kind::shoe:
                said.emplace_back(
                    "All points slide alike; the shoe turns about its pivot, so the depth goes with the pivot’s "
                    "distance {h} sin {θ} from the normal:\n{p} = {C} sin {θ}.",
                    "Tutti i punti strisciano ugualmente; il ceppo ruota intorno alla cerniera, quindi la profondità è "
                    "proporzionale alla distanza {h} sin {θ} della cerniera dalla normale:\n{p} = {C} sin {θ}.");
                break;
        }
        return said;
    }

    std::vector<Words> equilibrium() const {
        switch (problem_.kind) {
            case Kind::pad: return pad();
            case Kind::block:
                return {{"The force is the pressure on the whole face:\n{p} = {Q}/{a}{b} = {0}.",
                         "La forza è la pressione sull’intera faccia:\n{p} = {Q}/{a}{b} = {0}.",
                         pressure(found_.first)}};
            case Kind::disc: return disc();
            case Kind::shoe: return shoe();
        }
        return {};
    }

    std::vector<Words> wear() const {
        const auto& worn = *found_.worn;
        const std::string way = turns() ? "{ω}{r}" : "{v}";
        return {{"With the coefficient of wear {k} = {0}, " + std::string(turns() ? "{ω}" : "{v}") +
                     " = {1} and {t} = {2}:\n{h} = {k}{p}" + way + "{t} = {3} at the first end, {4} at the second.",
                 "Con il coefficiente d’usura {k} = {0}, " + std::string(turns() ? "{ω}" : "{v}") +
                     " = {1} e {t} = {2}:\n{h} = {k}{p}" + way + "{t} = {3} al primo estremo, {4} al secondo.",
                 given(*problem_.wear, QuantityKind::wear), speed(), given(*problem_.time, QuantityKind::time),
                 length(worn[0]), length(worn[1])}};
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
        said.emplace_back(
            "The pressures balance the force and its moment about the end:\n{Q} = {p_1}{a}{b}({m}/2 + 1),  {Q}{d} = "
            "{p_1}{a^2}{b}({m}/3 + ½).",
            "Le pressioni equilibrano la forza e il suo momento rispetto all’estremo:\n{Q} = {p_1}{a}{b}({m}/2 + 1),  "
            "{Q}{d} = {p_1}{a^2}{b}({m}/3 + ½).");
        if (found_.lifts)
            said.emplace_back(
                "Here {d} lies outside {a}/3 … 2{a}/3: one pressure would be negative, but nothing pulls. A triangle "
                "is left, over three times the distance from the force to the nearer end, from {x} = {0} to "
                "{1}:\n{p_max} = 2{Q}/{b}({x_2} − {x_1}) = {2}.",
                "Qui {d} è fuori da {a}/3 … 2{a}/3: una pressione sarebbe negativa, ma nulla può tirare. Resta un "
                "triangolo, esteso tre volte la distanza della forza dall’estremo vicino, da {x} = {0} a {1}:\n{p_max} "
                "= 2{Q}/{b}({x_2} − {x_1}) = {2}.",
                length(found_.begin), length(found_.end), pressure(found_.greatest));
        else
            said.emplace_back(
                "{0}\n{p_1} = 2{Q}(2{a} − 3{d})/{a^2}{b} = {1},  {p_2} = 2{Q}(3{d} − {a})/{a^2}{b} = {2}.",
                "{0}\n{p_1} = 2{Q}(2{a} − 3{d})/{a^2}{b} = {1},  {p_2} = 2{Q}(3{d} − {a})/{a^2}{b} = {2}.",
                found_.m ? Words("So {m} = (3{a} − 6{d})/(3{d} − 2{a}) = {0} and",
                                 "Quindi {m} = (3{a} − 6{d})/(3{d} − 2{a}) = {0} e", numeral(found_.m->to_double()))
                         : Words("So", "Quindi"),
                pressure(found_.first), pressure(found_.second));
        said.emplace_back(
            "The resultant {R} passes through the centroid {G} of the figure of pressures, in line with {Q}.",
            "La risultante {R} passa per il baricentro {G} della figura delle pressioni, sulla retta di {Q}.");
        if (found_.friction_force)
            said.emplace_back("The friction is {f}{Q} = {0}.", "L’attrito è {f}{Q} = {0}.",
                              amount(*found_.friction_force, QuantityKind::force, mechanism_.units));
        return said;
    }
    std::vector<Words> disc() const {
        std::vector<Words> said;
        said.emplace_back(
            "Ring by ring the pressures make up the force:\n{Q} = ∫ 2π{r}{p} d{r} = 2π({p}{r})({r_2} − {r_1}),\n{p_1} "
            "= {Q}/(2π{r_1}({r_2} − {r_1})) = {0},  {p_2} = {1}.",
            "Corona per corona le pressioni fanno la forza:\n{Q} = ∫ 2π{r}{p} d{r} = 2π({p}{r})({r_2} − {r_1}),\n{p_1} "
            "= {Q}/(2π{r_1}({r_2} − {r_1})) = {0},  {p_2} = {1}.",
            pressure(found_.first), pressure(found_.second));
        said.emplace_back("The friction acts at the mean radius:\n{M} = {n}{f}{Q}({r_1} + {r_2})/2 = {0}.",
                          "L’attrito agisce al raggio medio:\n{M} = {n}{f}{Q}({r_1} + {r_2})/2 = {0}.",
                          moment(*found_.torque));
        said.emplace_back(
            "New, before it has worn in, with even pressure {p_u} = {0}, it had\n{M_u} = ⅔{n}{f}{Q}({r_2^3} − "
            "{r_1^3})/({r_2^2} − {r_1^2}) = {1}.",
            "Da nuova, prima del rodaggio, con pressione uniforme {p_u} = {0}, dava\n{M_u} = ⅔{n}{f}{Q}({r_2^3} − "
            "{r_1^3})/({r_2^2} − {r_1^2}) = {1}.",
            pressure(*found_.uniform_pressure), moment(*found_.uniform_torque));
        return said;
    }
    std::vector<Words> shoe() const {
        std::vector<Words> said;
        said.emplace_back(
            "About the pivot, pressures and friction balance the force, friction {0}:\n{Q}{c} = {C}{b}{r}({h} ∫ "
            "sin²{θ} d{θ} {1} {f} ∫ ({r} − {h} cos {θ}) sin {θ} d{θ}).",
            "Rispetto alla cerniera pressioni e attrito equilibrano la forza; l’attrito {0}:\n{Q}{c} = {C}{b}{r}({h} ∫ "
            "sin²{θ} d{θ} {1} {f} ∫ ({r} − {h} cos {θ}) sin {θ} d{θ}).",
            problem_.leading ? Words("helping it (leading)", "la aiuta (avvolgente)")
                             : Words("against it (trailing)", "la contrasta (svolgente)"),
            std::string(problem_.leading ? "−" : "+"));
        said.emplace_back(
            "So the greatest pressure and those at the ends are\n{p_max} = {0},  {p_1} = {1},  {p_2} = {2}.",
            "Quindi la pressione massima e quelle agli estremi sono\n{p_max} = {0},  {p_1} = {1},  {p_2} = {2}.",
            pressure(found_.greatest), pressure(found_.first), pressure(found_.second));
        said.emplace_back("The torque on the drum is\n{M} = {f}{C}{b}{r^2}(cos {θ_1} − cos {θ_2}) = {0}.",
                          "Il momento sul tamburo è\n{M} = {f}{C}{b}{r^2}(cos {θ_1} − cos {θ_2}) = {0}.",
                          moment(*found_.torque));
        said.emplace_back(
            "The pressures have the resultant {N} = {0}. At the centre of pressure {C}, {1} from {O} on its line, the "
            "friction {f}{N} alone makes the torque.",
            "Le pressioni hanno risultante {N} = {0}. Nel centro di pressione {C}, a {1} da {O} sulla sua retta, "
            "l’attrito {f}{N} da solo dà il momento.",
            amount(std::hypot(found_.normal_force.x, found_.normal_force.y), QuantityKind::force, mechanism_.units),
            length(found_.pressure_radius));
        if (problem_.leading && found_.locking_friction)
            said.emplace_back("From {f} = {0} on the shoe would lock itself.",
                              "Da {f} = {0} in su il ceppo si bloccherebbe da sé.", numeral(*found_.locking_friction));
        return said;
    }

    const Mechanism& mechanism_;
    const ReyeProblem& problem_;
    const ReyeSolution& found_;
};

}  // namespace

std::vector<ProblemSection> reye_sections(const DrawingContext& context) {
    const ReyeText text(context);
    const auto& found = std::get<ReyeSolution>(context.solution.problem->of);
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    ProblemFigure bodies = figure("contact", reye_contact_figure, 1.1);
    bodies.as_question = [&context](double x, double y) { return reye_question_figure(context, x, y); };
    std::vector<ProblemFigure> plots;
    if (found.torque) plots.push_back(figure("pressures", reye_pressure_figure, 0.8));
    std::vector<ProblemSection> sections{
        {"given", {"Given", "Dati"}, {std::move(bodies)}, text.given()},
        {"hypothesis", {"Reye’s hypothesis", "Ipotesi di Reye"}, {}, text.hypothesis()},
        {"pressure", {"Equilibrium", "Equilibrio"}, plots, text.equilibrium()}};
    if (found.worn) sections.push_back({"wear", {"Depth worn off", "Profondità d’usura"}, {}, text.wear()});
    sections.push_back({"hypotheses",
                        {"Hypotheses", "Ipotesi"},
                        {},
                        {{"The bodies are rigid but for what they lose, and friction is the same everywhere.",
                          "I corpi sono rigidi salvo ciò che perdono, e l’attrito è ovunque lo stesso."}}});
    return sections;
}

}  // namespace kinegraph::render
