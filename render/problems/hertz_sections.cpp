// The worked solution of Hertz's contact: given data, equivalent bodies, contact area and pressure, stresses below,
// hypotheses.
#include <cmath>
#include <numbers>

#include "engine/check/check_problems.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/figures/problem_figures.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

class HertzText {
public:
    explicit HertzText(const DrawingContext& context)
        : mechanism_(context.solution.mechanism),
          problem_(std::get<HertzProblem>(mechanism_.problem->of)),
          found_(std::get<HertzSolution>(context.solution.problem->of)) {}

    Words heading() const {
        if (!problem_.at) return {"Given", "Dati"};
        return {"Contact at {0}", "Contatto in {0}", problem_.at->joint};
    }
    std::vector<Words> given() const {
        std::vector<Words> said;
        if (problem_.at) said.push_back(at_joint(*problem_.at));
        said.emplace_back(
            "The force {Q} = {0} presses the two bodies together{1}.",
            "La forza {Q} = {0} preme i due corpi l’uno sull’altro{1}.",
            amount(problem_.force.to_double(), QuantityKind::force, mechanism_.units, problem_.at ? 4 : as_given),
            problem_.line ? Words(", along a line of length {l} = {0}", ", lungo una linea di lunghezza {l} = {0}",
                                  given(problem_.length, QuantityKind::length))
                          : Words());
        for (std::size_t i = 0; i < 2; ++i) {
            const HertzBody& body = problem_.bodies.at(i);
            const std::string n = std::to_string(i + 1);
            said.emplace_back("{0}: {1}, {E_" + n + "} = {2}, {ν_" + n + "} = {3}.",
                              "{0}: {1}, {E_" + n + "} = {2}, {ν_" + n + "} = {3}.", called(mechanism_.body(body.body)),
                              shape(body, n), given(body.young, QuantityKind::pressure),
                              numeral(body.poisson.to_double(), as_given));
        }
        if (found_.elliptic && !problem_.turn.is_zero())
            said.emplace_back("The first principal planes of the two bodies include {θ} = {0}.",
                              "I primi piani principali dei due corpi formano {θ} = {0}.",
                              given(problem_.turn, QuantityKind::angle));
        return said;
    }

    std::vector<Words> equivalents() const {
        std::vector<Words> said;
        said.emplace_back(
            "The yielding of the two elastic half-spaces adds up:\n1/{E*} = (1 − {ν_1^2})/{E_1} + (1 − {ν_2^2})/{E_2}, "
            " {E*} = {0}.",
            "Le cedevolezze dei due semispazi elastici si sommano:\n1/{E*} = (1 − {ν_1^2})/{E_1} + (1 − "
            "{ν_2^2})/{E_2},  {E*} = {0}.",
            pressure(found_.modulus));
        if (!found_.elliptic) {
            said.emplace_back(
                "So do the curvatures, a concave one counted negative: the contact is that of one body of radius {R} "
                "and a plane.\n1/{R} = {0},  {R} = {1}.",
                "Così le curvature, negative se concave: il contatto è quello di un solo corpo di raggio {R} con un "
                "piano.\n1/{R} = {0},  {R} = {1}.",
                curvatures(), length(found_.radius));
            return said;
        }
        const double mm = mechanism_.units.length.si.to_double();
        const Words per = mechanism_.units.length.symbol;
        said.emplace_back(
            "The gap between the surfaces is {A}{x^2} + {B}{y^2}, with {x} along the longer axis of the contact. From "
            "the principal curvatures (Euler)\n{A} + {B} = ½ Σ {κ},  {B} − {A} = ½ √(({κ_1} − {κ_1}′)² + ({κ_2} − "
            "{κ_2}′)² + 2 ({κ_1} − {κ_1}′)({κ_2} − {κ_2}′) cos 2{θ}),\n{A} = {0} {2}⁻¹,  {B} = {1} {2}⁻¹.",
            "La distanza fra le superfici è {A}{x^2} + {B}{y^2}, con {x} lungo l’asse maggiore del contatto. Dalle "
            "curvature principali (Eulero)\n{A} + {B} = ½ Σ {κ},  {B} − {A} = ½ √(({κ_1} − {κ_1}′)² + ({κ_2} − "
            "{κ_2}′)² + 2 ({κ_1} − {κ_1}′)({κ_2} − {κ_2}′) cos 2{θ}),\n{A} = {0} {2}⁻¹,  {B} = {1} {2}⁻¹.",
            numeral(found_.long_curvature * mm), numeral(found_.short_curvature * mm), per);
        said.emplace_back("The effective radius is\n{R} = 1/(2√({A}{B})) = {0}.",
                          "Il raggio equivalente è\n{R} = 1/(2√({A}{B})) = {0}.", length(found_.radius));
        return said;
    }

    std::vector<Words> contact() const {
        std::vector<Words> said;
        if (problem_.line) {
            said.emplace_back(
                "The pressure stands as a semi-ellipse over the width 2{b}, for then the surfaces match where they "
                "touch:\n{b} = (4{Q}{R}/π{l}{E*})^{1/2} = {0}.",
                "La pressione è distribuita come una semiellisse sulla larghezza 2{b}: solo così le superfici "
                "combaciano dove si toccano.\n{b} = (4{Q}{R}/π{l}{E*})^{1/2} = {0}.",
                length(found_.b));
            said.emplace_back(
                "Its area is the load for each length:\n{p_m} = {Q}/2{b}{l} = {0},  {p_0} = 4{p_m}/π = {1}.",
                "La sua area è il carico per unità di lunghezza:\n{p_m} = {Q}/2{b}{l} = {0},  {p_0} = 4{p_m}/π = {1}.",
                pressure(found_.mean), pressure(found_.greatest));
        } else if (found_.elliptic) {
            said.emplace_back(
                "The face of contact is an ellipse. Its shape {k} = {b}/{a} comes from the complete elliptic integrals "
                "K, E of the modulus {e}, {e^2} = 1 − {k^2}:\n{A}/{B} = (K − E)/(E/{k^2} − K),  {k} = {0}.",
                "L’area di contatto è un’ellisse. La sua forma {k} = {b}/{a} si ha dagli integrali ellittici completi "
                "K, E di modulo {e}, {e^2} = 1 − {k^2}:\n{A}/{B} = (K − E)/(E/{k^2} − K),  {k} = {0}.",
                numeral(found_.b / found_.a));
            said.emplace_back(
                "and its size from the load\n{a} = (3{Q}(K − E)/(2π{E*}{A}{e^2}))^{1/3} = {0},  {b} = {k}{a} = {1}.",
                "e la sua grandezza dal carico\n{a} = (3{Q}(K − E)/(2π{E*}{A}{e^2}))^{1/3} = {0},  {b} = {k}{a} = {1}.",
                length(found_.a), length(found_.b));
            said.emplace_back(
                "The pressure stands as a semi-ellipsoid over it:\n{p_m} = {Q}/π{a}{b} = {0},  {p_0} = 3{p_m}/2 = {1}.",
                "La pressione è distribuita come un semiellissoide:\n{p_m} = {Q}/π{a}{b} = {0},  {p_0} = 3{p_m}/2 = "
                "{1}.",
                pressure(found_.mean), pressure(found_.greatest));
        } else {
            said.emplace_back(
                "The pressure stands as a semi-ellipsoid over a circle of radius {a}, for then the surfaces match "
                "where they touch:\n{a} = (3{Q}{R}/4{E*})^{1/3} = {0}.",
                "La pressione è distribuita come un semiellissoide su un cerchio di raggio {a}: solo così le superfici "
                "combaciano dove si toccano.\n{a} = (3{Q}{R}/4{E*})^{1/3} = {0}.",
                length(found_.a));
            said.emplace_back("Its volume is the load:\n{p_m} = {Q}/π{a^2} = {0},  {p_0} = 3{p_m}/2 = {1}.",
                              "Il suo volume è il carico:\n{p_m} = {Q}/π{a^2} = {0},  {p_0} = 3{p_m}/2 = {1}.",
                              pressure(found_.mean), pressure(found_.greatest));
        }
        said.push_back(approach());
        return said;
    }

    std::vector<Words> stresses() const {
        std::vector<Words> said;
        const Words body = called(mechanism_.body(problem_.bodies.at(found_.sheared).body));
        if (problem_.line)
            said.emplace_back(
                "On the axis, with {r} = √({b^2} + {z^2}):\n{σ_z} = −{p_0}{b}/{r},  {σ_y} = −{p_0}({r} − {z})²/{b}{r}, "
                " {σ_x} = {ν}({σ_y} + {σ_z}).",
                "Sull’asse, con {r} = √({b^2} + {z^2}):\n{σ_z} = −{p_0}{b}/{r},  {σ_y} = −{p_0}({r} − {z})²/{b}{r},  "
                "{σ_x} = {ν}({σ_y} + {σ_z}).");
        else if (found_.elliptic)
            said.emplace_back(
                "On the axis the stresses follow from incomplete elliptic integrals (Thomas and Hoersch); {σ_x} along "
                "the longer axis, {σ_y} along the shorter one.",
                "Sull’asse le tensioni si hanno con integrali ellittici incompleti (Thomas e Hoersch); {σ_x} lungo "
                "l’asse maggiore, {σ_y} lungo il minore.");
        else
            said.emplace_back(
                "On the axis, with {ζ} = {z}/{a}:\n{σ_z} = −{p_0}/(1 + {ζ^2}),\n{σ_r} = −{p_0}[(1 + {ν})(1 − {ζ} "
                "arctan 1/{ζ}) − ½/(1 + {ζ^2})].",
                "Sull’asse, con {ζ} = {z}/{a}:\n{σ_z} = −{p_0}/(1 + {ζ^2}),\n{σ_r} = −{p_0}[(1 + {ν})(1 − {ζ} arctan "
                "1/{ζ}) − ½/(1 + {ζ^2})].");
        const std::string across = found_.a > 0 && !found_.elliptic ? "{σ_r}" : "{σ_y}";
        said.emplace_back("The greatest shear {τ} = ½|" + across +
                              " − {σ_z}| lies below the surface (in {0}), where pitting begins:\n{τ_max} = {1} = {2} "
                              "{p_0} at {z} = {3} = {4} {b}.",
                          "La massima tensione tangenziale {τ} = ½|" + across +
                              " − {σ_z}| sta sotto la superficie (in {0}), dove comincia il pitting:\n{τ_max} = {1} = "
                              "{2} {p_0} a {z} = {3} = {4} {b}.",
                          body, pressure(found_.shear), numeral(found_.shear / found_.greatest, 3),
                          length(found_.depth), numeral(found_.depth / found_.b, 3));
        if (found_.a > 0 && !found_.elliptic)
            for (std::string* text : {&said.back().en, &said.back().it}) text->replace(text->rfind("{b}"), 3, "{a}");
        return said;
    }

    static std::vector<Words> hypotheses() {
        return {{"The bodies are elastic, homogeneous and isotropic; their faces are smooth and carry no friction.",
                 "I corpi sono elastici, omogenei e isotropi; le superfici sono lisce e senza attrito."},
                {"The contact is small beside the radii, so that each body yields as a half-space and the gap is of "
                 "the second degree.",
                 "Il contatto è piccolo rispetto ai raggi: ciascun corpo cede come un semispazio e la distanza è di "
                 "secondo grado."}};
    }

private:
    Words length(double si) const { return amount(si, QuantityKind::length, mechanism_.units); }
    Words given(const Exact& si, QuantityKind kind) const {
        return amount(si.to_double(), kind, mechanism_.units, as_given);
    }
    Words pressure(double si) const { return amount(si, QuantityKind::pressure, mechanism_.units); }

    /// The joint that force and radii come from.
    Words at_joint(const AtJoint& at) const {
        if (!at.meshes)
            return {
                "At {0} the mechanism’s forces give the load: the part of the action along the common normal. The "
                "radii are those of the profiles.",
                "In {0} il carico viene dalle forze del meccanismo: la componente dell’azione lungo la normale comune. "
                "I raggi sono quelli dei profili.",
                at.joint};
        std::string radii;
        for (std::size_t i = 0; i < 2; ++i)
            if (at.pitch_radii.at(i) > 0)
                radii += (radii.empty() ? "" : ",  ") + std::string("{r_") + std::to_string(i + 1) + "} = {" +
                         std::to_string(i) + "} sin {α}";
        const auto pitch = [&](std::size_t i) {
            return amount(at.pitch_radii.at(i), QuantityKind::length, mechanism_.units, 5);
        };
        return Words(
                   "At the pitch point {0} the teeth press each other along the line of action. Involute flanks have "
                   "there the radii",
                   "Nel punto primitivo {0} i denti si premono lungo la retta d’azione. I fianchi a evolvente hanno lì "
                   "i raggi",
                   at.joint) +
               Words("\n" + radii + ",  {α} = {2}.", "\n" + radii + ",  {α} = {2}.", pitch(0), pitch(1),
                     amount(at.pressure_angle, QuantityKind::angle, mechanism_.units));
    }

    Words shape(const HertzBody& body, const std::string& n) const {
        const auto radius = [&](std::size_t plane, const std::string& mark) {
            const double found = body.radii.at(plane).to_double();
            const Words size = body.radii.at(plane).is_zero()
                                   ? Words(std::string("∞"))
                                   : amount(found, QuantityKind::length, mechanism_.units, problem_.at ? 4 : as_given);
            return Words("{r_" + n + "}" + mark + " = ", "{r_" + n + "}" + mark + " = ") + size +
                   (body.inside.at(plane) ? Words(" (concave)", " (concavo)") : Words());
        };
        if (body.radii[0].is_zero() && body.radii[1].is_zero()) return {"flat", "piano"};
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
                       ? Words("Points far from the contact come nearer by\n{δ} = 3{Q}K/(2π{a}{E*}) = {0}.",
                               "I punti lontani dal contatto si accostano di\n{δ} = 3{Q}K/(2π{a}{E*}) = {0}.",
                               length(found_.approach))
                       : Words("Points far from the contact come nearer by\n{δ} = {a^2}/{R} = {0}.",
                               "I punti lontani dal contatto si accostano di\n{δ} = {a^2}/{R} = {0}.",
                               length(found_.approach));
        Words sum;
        for (std::size_t i = 0; i < 2; ++i) {
            const Datum datum = datum_of(problem_, i);
            const Words name = called(mechanism_.body(problem_.bodies.at(i).body));
            if (i == 1) sum += std::string("; ");
            sum += datum.is_axis ? Words("of {0} from its axis", "di {0} dal suo asse", name)
                                 : Words("of {0} from {1} below its face", "di {0} da {1} sotto la superficie", name,
                                         length(datum.depth));
        }
        return {
            "Along a line the approach depends on the points from which it is counted: {0}.\n{δ} = Σ {Q}(1 − "
            "{ν^2})/π{l}{E} · (2 ln 4{r}/{b} − 1), for a face (2 ln 2{d}/{b} − {ν}/(1 − {ν})):\n{δ} = {1}.",
            "Lungo una linea l’accostamento dipende dai punti fra cui si misura: {0}.\n{δ} = Σ {Q}(1 − {ν^2})/π{l}{E} "
            "· (2 ln 4{r}/{b} − 1), per una faccia (2 ln 2{d}/{b} − {ν}/(1 − {ν})):\n{δ} = {1}.",
            sum, length(found_.approach)};
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
            {"equivalent", {"Equivalent body", "Corpo equivalente"}, {}, text.equivalents()},
            {"pressure",
             {"Contact and pressure", "Contatto e pressione"},
             {figure("pressure", hertz_pressure_figure, 1)},
             text.contact()},
            {"stresses",
             {"Stresses below the surface", "Tensioni sotto la superficie"},
             {figure("stresses", hertz_stress_figure, 0.9)},
             text.stresses()},
            {"hypotheses", {"Hypotheses", "Ipotesi"}, {}, HertzText::hypotheses()}};
}

}  // namespace kinegraph::render
