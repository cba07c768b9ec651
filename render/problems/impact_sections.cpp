// The worked solution of an impact: given data and class, equations of the impulses, phases, velocities afterwards,
// energy.
#include <cmath>

#include "engine/solution/problem_solution.hpp"
#include "render/figures/problem_figures.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

class ImpactText {
public:
    explicit ImpactText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(std::get<ImpactProblem>(mechanism_.problem->of)),
          found_(std::get<ImpactSolution>(context.solution.problem->of)),
          size_(kinegraph::length(found_.normal)) {}

    std::vector<Words> given() const {
        std::vector<Words> said;
        for (std::size_t i = 0; i < 2; ++i) {
            const ImpactBody& body = problem_.bodies.at(i);
            const std::string n = std::to_string(i + 1);
            const Words name = called(mechanism_.body(body.body));
            if (body.fixed) {
                said.emplace_back("{0}: fixed.", "{0}: fisso.", name);
                continue;
            }
            Words line("{0}: {m_" + n + "} = {1}", "{0}: {m_" + n + "} = {1}", name,
                       given(body.mass, QuantityKind::mass));
            if (body.inertia)
                line += Words(", {I_" + n + "} = {0}", ", {I_" + n + "} = {0}",
                              given(*body.inertia, QuantityKind::inertia));
            if (found_.bodies.at(i).centre != found_.at)
                line += Words(", centre {G_" + n + "} {0}", ", baricentro {G_" + n + "} {0}",
                              place(found_.bodies.at(i).centre));
            line += Words(", {v_" + n + "} = {0}", ", {v_" + n + "} = {0}",
                          vector(found_.bodies.at(i).before, QuantityKind::velocity, as_given));
            if (!body.omega.is_zero())
                line += Words(", {ω_" + n + "} = {0}", ", {ω_" + n + "} = {0}",
                              given(body.omega, QuantityKind::angular_velocity));
            if (body.pivot)
                line +=
                    Words("; it turns about {O} {0}", "; ruota intorno a {O} {0}", place(*found_.bodies.at(i).pivot));
            said.push_back(line + std::string("."));
        }
        said.push_back(contact());
        said.emplace_back("Restitution {e} = {0}{1}.", "Restituzione {e} = {0}{1}.",
                          numeral(found_.restitution.to_double(), as_given),
                          found_.friction.is_zero() ? Words(", no friction", ", senza attrito")
                                                    : Words(", friction {f} = {0}", ", attrito {f} = {0}",
                                                            numeral(found_.friction.to_double(), as_given)));
        said.push_back(classes());
        return said;
    }

    std::vector<Words> equations() const {
        std::vector<Words> said;
        said.emplace_back(
            "The impulse {J} acts on the first body at {P}, −{J} on the second. Momentum and moment of momentum of "
            "both change the relative velocity {u} of the points in contact by\nΔ{u_n} = {α}{J_n} + {β}{J_t},  Δ{u_t} "
            "= {β}{J_n} + {γ}{J_t},\n{α} = {0},  {β} = {1},  {γ} = {2} kg⁻¹.",
            "L’impulso {J} agisce sul primo corpo in {P}, −{J} sul secondo. Quantità di moto e momento della quantità "
            "di moto di entrambi cambiano la velocità relativa {u} dei punti a contatto di\nΔ{u_n} = {α}{J_n} + "
            "{β}{J_t},  Δ{u_t} = {β}{J_n} + {γ}{J_t},\n{α} = {0},  {β} = {1},  {γ} = {2} kg⁻¹.",
            per_mass(found_.a), per_mass(found_.b), per_mass(found_.c));
        said.emplace_back(
            "with {α} = Σ 1/{m} + ({r} × {n})²/{I}, {γ} the same with {t}, {β} = Σ ({r} × {n})({r} × {t})/{I}, {r} "
            "from the centre{0} to {P}.",
            "con {α} = Σ 1/{m} + ({r} ∧ {n})²/{I}, {γ} lo stesso con {t}, {β} = Σ ({r} ∧ {n})({r} ∧ {t})/{I}, {r} dal "
            "baricentro{0} a {P}.",
            has_pivot() ? Words(" (from the pivot {O}, with {I_O} and no 1/{m})",
                                " (dalla cerniera {O}, con {I_O} e senza 1/{m})")
                        : Words());
        said.emplace_back("Before the impact\n{u_n} = {0},  {u_t} = {1}.",
                          "Prima dell’urto\n{u_n} = {0},  {u_t} = {1}.", speed(found_.approach), speed(found_.slip));
        return said;
    }

    std::vector<Words> phases() const {
        std::vector<Words> said;
        if (found_.friction.is_zero()) {
            said.emplace_back(
                "Without friction {J_t} = 0. The compression ends where {u_n} = 0, the restitution gives back {e} "
                "times as much:\n{J_n} = −(1 + {e}){u_n}/{α} = {0}.",
                "Senza attrito {J_t} = 0. La compressione termina dove {u_n} = 0, la restituzione ne rende {e} volte "
                "tanto:\n{J_n} = −(1 + {e}){u_n}/{α} = {0}.",
                impulse(found_.normal_impulse));
        } else {
            char letter = 'A';
            for (const ImpactSolution::Phase& phase : found_.phases) {
                const bool sticks = phase.kind == ImpactSolution::Phase::Kind::sticks;
                const Words how = sticks ? Words("The contact sticks, {u_t} = 0 and d{J_t} = −({β}/{γ}) d{J_n},",
                                                 "Il contatto aderisce, {u_t} = 0 e d{J_t} = −({β}/{γ}) d{J_n},")
                                         : Words("The contact slides, d{J_t} = {0}{f} d{J_n},",
                                                 "Il contatto striscia, d{J_t} = {0}{f} d{J_n},",
                                                 std::string(phase.sense > 0 ? "−" : ""));
                const Words until = phase.ends_compression
                                        ? Words(" until the compression ends", " finché termina la compressione")
                                    : &phase == &found_.phases.back()
                                        ? Words(" until {J_n} is 1 + {e} times that of the compression",
                                                " finché {J_n} è 1 + {e} volte quello della compressione")
                                        : Words(" until the slip ends", " finché termina lo strisciamento");
                said.push_back(how + until +
                               Words(" ({0}):\n{J_n} = {1},  {J_t} = {2}.", " ({0}):\n{J_n} = {1},  {J_t} = {2}.",
                                     std::string(1, letter), impulse(phase.normal), impulse(phase.tangential)));
                ++letter;
            }
        }
        said.emplace_back("So the impulse on the first body is\n{J} = {0} N s.",
                          "Quindi l’impulso sul primo corpo è\n{J} = {0} N s.",
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
                    "{ω_" + n + "}′ = {ω_" + n + "}" + sign + "({r_" + n +
                        "} × {J})/{I_O} = {0};  the pivot answers with {R} = {1} N s.",
                    "{ω_" + n + "}′ = {ω_" + n + "}" + sign + "({r_" + n +
                        "} ∧ {J})/{I_O} = {0};  la cerniera risponde con {R} = {1} N s.",
                    amount(body.omega_after.to_double(), QuantityKind::angular_velocity, mechanism_.units),
                    vector(*body.reaction, QuantityKind::dimensionless));
                if (body.percussion)
                    said.emplace_back(
                        "The centre of percussion {C} lies at {I_O}/{m}{d} = {0} from {O}: an impulse there, across "
                        "{OG}, leaves the pivot in peace.",
                        "Il centro di percussione {C} dista {I_O}/{m}{d} = {0} da {O}: un impulso in esso, normale a "
                        "{OG}, non sollecita la cerniera.",
                        amount(kinegraph::length(*body.percussion - *body.pivot), QuantityKind::length,
                               mechanism_.units));
                continue;
            }
            Words line("{v_" + n + "}′ = {v_" + n + "}" + sign + "{J}/{m_" + n + "} = {0}",
                       "{v_" + n + "}′ = {v_" + n + "}" + sign + "{J}/{m_" + n + "} = {0}",
                       vector(body.after, QuantityKind::velocity));
            if (!body.inverse_inertia.is_zero())
                line += Words(",  {ω_" + n + "}′ = {0}", ",  {ω_" + n + "}′ = {0}",
                              amount(body.omega_after.to_double(), QuantityKind::angular_velocity, mechanism_.units));
            said.push_back(line + std::string("."));
        }
        return said;
    }

    std::vector<Words> restitution() const {
        std::vector<Words> said;
        said.emplace_back(
            "Along the normal the contact parts with {u_n}′ = {0}:\n−{u_n}′/{u_n} = {1}{2}.",
            "Lungo la normale il contatto si separa con {u_n}′ = {0}:\n−{u_n}′/{u_n} = {1}{2}.",
            speed(found_.separation), numeral(found_.kinematic_restitution.to_double()),
            found_.kinematic_restitution == found_.restitution
                ? Words(", the given {e}", ", l’{e} assegnato")
                : Words(" (Newton’s), while the impulses of the two phases stand as {e} = {0} (Poisson’s)",
                        " (di Newton), mentre gli impulsi delle due fasi stanno come {e} = {0} (di Poisson)",
                        numeral(found_.restitution.to_double(), as_given)));
        said.emplace_back(
            "The energy lost is the work of the impulse on the mean relative velocity:\n{T} = −{J} · ({u} + {u}′)/2 = "
            "{0} J of {1} J.",
            "L’energia perduta è il lavoro dell’impulso per la velocità relativa media:\n{T} = −{J} · ({u} + {u}′)/2 = "
            "{0} J su {1} J.",
            numeral(found_.energy_lost.to_double()), numeral(found_.energy_before.to_double()));
        return said;
    }

private:
    Words given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, mechanism_.units, as_given);
    }
    Words vector(const Vector& v, QuantityKind kind, int digits = 4) const {
        const Unit unit = suitable_unit(kinegraph::length(v), kind, mechanism_.units);
        const double si = unit.si.to_double();
        return Words("({0}, {1}){2}", "({0}; {1}){2}", numeral(v.x.to_double() / si, digits),
                     numeral(v.y.to_double() / si, digits), unit.symbol.empty() ? std::string() : " " + unit.symbol);
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
        const double along = std::atan2(found_.normal.y.to_double(), found_.normal.x.to_double());
        return Words(
            "The bodies touch at {P} {0}; the normal {n}, from {2} to {1}, stands at {3} to the axis {x}. The impulse "
            "{J} acts on {1}, −{J} on {2}. The axis {x} points to the right, {y} upwards, and angular velocities count "
            "counter-clockwise positive.",
            "I corpi si toccano in {P} {0}; la normale {n}, da {2} verso {1}, è inclinata di {3} sull’asse {x}. "
            "L’impulso {J} agisce su {1}, −{J} su {2}. L’asse {x} è rivolto a destra, {y} in alto, e le velocità "
            "angolari sono positive in senso antiorario.",
            place(found_.at), first, second, amount(along, QuantityKind::angle, mechanism_.units, as_given));
    }
    bool has_pivot() const { return found_.bodies[0].pivot || found_.bodies[1].pivot; }
    Words classes() const {
        return Words("The impact is {0} ({1}) and {2}.", "L’urto è {0} ({1}) e {2}.",
                     found_.central ? Words("central", "centrale") : Words("eccentric", "eccentrico"),
                     found_.central
                         ? Words("the centres lie on the line of impact", "i baricentri stanno sulla linea d’urto")
                         : Words("a centre lies off the line of impact", "un baricentro è fuori dalla linea d’urto"),
                     found_.direct ? Words("direct", "diretto")
                                   : Words("oblique, {ψ} = {0}", "obliquo, {ψ} = {0}",
                                           amount(found_.obliquity, QuantityKind::angle, mechanism_.units)));
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
    return {{"given", {"Given", "Dati"}, {figure("contact", impact_bodies_figure, 1)}, text.given(), 1},
            {"impulse", {"Impulses and velocities", "Impulsi e velocità"}, {}, text.equations()},
            {"phases", {"Course of the impact", "Corso dell’urto"}, routh, text.phases()},
            {"velocities",
             {"Velocities afterwards", "Velocità dopo l’urto"},
             {figure("velocities", impact_velocities_figure, 0.75), figure("contact-after", impact_after_figure, 0.8)},
             text.velocities()},
            {"restitution",
             {"Restitution and energy", "Restituzione ed energia"},
             {figure("restitution", impact_restitution_figure, 0.7)},
             text.restitution()},
            {"hypotheses",
             {"Hypotheses", "Ipotesi"},
             {},
             {{"The impact takes no time: places do not change, and other forces have no impulse.",
               "L’urto non dura: le posizioni non cambiano e le altre forze non hanno impulso."}}}};
}

}  // namespace kinegraph::render
