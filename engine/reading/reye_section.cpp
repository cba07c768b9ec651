#include "engine/reading/problem_sections.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace kinegraph {

std::optional<ReyeProblem> ReyeSection::read(JsonValue section) {
    const auto kind = read_kind(section);
    if (!kind) return std::nullopt;
    ReyeProblem problem;
    problem.kind = *kind;
    problem.where = section.pointer();
    const auto read_members = [&](std::initializer_list<std::string_view> own) {
        std::vector<std::string_view> names{"kind", "force", "friction", "wear", "time"};
        names.insert(names.end(), own.begin(), own.end());
        return file_.members(section, std::span<const std::string_view>(names), {"\"reye\"", "\"reye\""});
    };
    const bool slides = problem.kind == ReyeProblem::Kind::pad || problem.kind == ReyeProblem::Kind::block;
    const Members form =
        problem.kind == ReyeProblem::Kind::pad     ? read_members({"length", "width", "offset", "speed"})
        : problem.kind == ReyeProblem::Kind::block ? read_members({"length", "width", "speed"})
        : problem.kind == ReyeProblem::Kind::disc
            ? read_members({"inner", "outer", "surfaces", "omega"})
            : read_members({"radius", "width", "pivot", "arm", "from", "to", "inside", "sense", "omega"});
    problem.force = file_.positive(file_.required(form, "force", {"the force that presses", "la forza che preme"}),
                                   QuantityKind::force, {"the force", "la forza"});
    if (!slides)
        file_.required(
            form, "friction",
            {"the coefficient of friction, which makes the torque", "il coefficiente d’attrito, che dà il momento"});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = file_.bare_number(friction).value_or(Exact(1));
        if (problem.friction->sign() <= 0)
            file_.fault(friction, {"the coefficient of friction must be greater than zero",
                                   "il coefficiente d’attrito deve essere maggiore di zero"});
    }
    const std::string_view speed = slides ? "speed" : "omega";
    const std::initializer_list<std::string_view> of_wear{"wear", speed, "time"};
    if (std::any_of(of_wear.begin(), of_wear.end(), [&](std::string_view key) { return bool(form[key]); })) {
        const Words needs("the depth worn off needs \"wear\", {0} and \"time\"",
                          "la profondità d’usura richiede \"wear\", {0} e \"time\"", quoted(speed));
        problem.wear = file_.positive(file_.required(form, "wear", needs), QuantityKind::wear,
                                      {"the coefficient of wear", "il coefficiente d’usura"});
        problem.speed = file_.positive(file_.required(form, speed, needs),
                                       slides ? QuantityKind::velocity : QuantityKind::angular_velocity,
                                       {"the speed", "la velocità"});
        problem.time =
            file_.positive(file_.required(form, "time", needs), QuantityKind::time, {"the time", "la durata"});
    }
    if (slides)
        read_pad(form, problem);
    else if (problem.kind == ReyeProblem::Kind::disc)
        read_disc(form, problem);
    else
        read_shoe(form, problem);
    return problem;
}

std::optional<ReyeProblem::Kind> ReyeSection::read_kind(JsonValue section) {
    constexpr std::array kinds{std::pair{std::string_view("pad"), ReyeProblem::Kind::pad},
                               std::pair{std::string_view("block"), ReyeProblem::Kind::block},
                               std::pair{std::string_view("disc"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("collar"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("shoe"), ReyeProblem::Kind::shoe}};
    const Words wanted("\"pad\", \"block\", \"disc\", \"collar\" or \"shoe\"",
                       "\"pad\", \"block\", \"disc\", \"collar\" o \"shoe\"");
    const JsonValue kind = section["kind"];
    if (!kind) {
        file_.fault(section, {"\"kind\" is missing: {0}", "manca \"kind\": {0}", wanted});
        return std::nullopt;
    }
    const auto* found = std::find_if(kinds.begin(), kinds.end(),
                                     [&](const auto& each) { return kind.is_string() && each.first == kind.text(); });
    if (found == kinds.end()) {
        file_.wrong(kind, wanted);
        return std::nullopt;
    }
    return found->second;
}

void ReyeSection::read_pad(const Members& form, ReyeProblem& problem) {
    problem.length = file_.positive(
        file_.required(form, "length",
                       {"the pad’s length along the sliding", "la lunghezza del pattino lungo lo strisciamento"}),
        QuantityKind::length, {"the length", "la lunghezza"});
    problem.width = file_.positive(file_.required(form, "width", {"the pad’s width", "la larghezza del pattino"}),
                                   QuantityKind::length, {"the width", "la larghezza"});
    if (problem.kind == ReyeProblem::Kind::block) return;
    const JsonValue offset = file_.required(
        form, "offset", {"how far from its end the force acts", "a quale distanza dal suo estremo agisce la forza"});
    problem.offset = file_.quantity_or_zero(offset, QuantityKind::length);
    if (offset && (problem.offset.sign() <= 0 || problem.offset >= problem.length))
        file_.fault(offset,
                    {"the force must act over the pad, between 0 and its length; beyond, the pad tips over",
                     "la forza deve cadere sul pattino, fra 0 e la sua lunghezza; oltre, il pattino si ribalta"});
}

void ReyeSection::read_disc(const Members& form, ReyeProblem& problem) {
    const Words radius("a radius", "un raggio");
    const JsonValue inner = file_.required(form, "inner", {"the inner radius", "il raggio interno"});
    problem.inner = file_.positive(inner, QuantityKind::length, radius);
    problem.outer = file_.positive(file_.required(form, "outer", {"the outer radius", "il raggio esterno"}),
                                   QuantityKind::length, radius);
    if (inner && form["outer"] && problem.inner >= problem.outer)
        file_.fault(inner, {"the inner radius must be less than the outer one",
                            "il raggio interno deve essere minore di quello esterno"});
    if (const JsonValue surfaces = form["surfaces"]) {
        const Exact count = file_.bare_number(surfaces).value_or(Exact(1));
        constexpr int most = 1000;
        if (!is_whole_number(surfaces) || count.sign() <= 0 || count > Exact(most))
            file_.fault(surfaces, {"the number of rubbing surfaces is a whole number from 1 to 1000",
                                   "il numero di superfici è un intero da 1 a 1000"});
        else
            problem.surfaces = static_cast<int>(count.to_double());
    }
}

void ReyeSection::read_shoe(const Members& form, ReyeProblem& problem) {
    const Words length("a length", "una lunghezza");
    problem.radius = file_.positive(file_.required(form, "radius", {"the drum’s radius", "il raggio del tamburo"}),
                                    QuantityKind::length, {"a radius", "un raggio"});
    problem.width = file_.positive(file_.required(form, "width", {"the shoe’s width", "la larghezza del ceppo"}),
                                   QuantityKind::length, length);
    const JsonValue pivot = file_.required(
        form, "pivot",
        {"the distance of the pivot from the drum’s centre", "la distanza della cerniera dal centro del tamburo"});
    problem.pivot = file_.positive(pivot, QuantityKind::length, length);
    problem.arm = file_.positive(
        file_.required(form, "arm",
                       {"the arm of the force about the pivot", "il braccio della forza rispetto alla cerniera"}),
        QuantityKind::length, length);
    const Words end("the angle from the pivot to an end of the shoe", "l’angolo dalla cerniera a un estremo del ceppo");
    const JsonValue to = file_.required(form, "to", end);
    problem.from = file_.quantity_or_zero(file_.required(form, "from", end), QuantityKind::angle);
    problem.to = file_.quantity_or_zero(to, QuantityKind::angle);
    if (to && form["from"] && (problem.from.sign() < 0 || problem.to <= problem.from || problem.to > pi()))
        file_.fault(to, {"a shoe reaches from an angle not less than 0° to a larger one, at most 180°; beyond it would "
                         "part from the drum",
                         "un ceppo va da un angolo non minore di 0° a uno maggiore, al più 180°; oltre si staccherebbe "
                         "dal tamburo"});
    if (form["inside"] && file_.expect(form["inside"], Kind::boolean, {"true or false", "true o false"})) {
        problem.inside = is_true(form["inside"]);
        if (problem.inside && pivot && problem.pivot >= problem.radius)
            file_.fault(pivot, {"the pivot of an inner shoe lies within the drum",
                                "la cerniera di un ceppo interno sta dentro il tamburo"});
    }
    if (const JsonValue sense = form["sense"]) {
        if (!sense.is_string() || (sense.text() != "leading" && sense.text() != "trailing"))
            file_.wrong(sense, {"\"leading\" or \"trailing\"", "\"leading\" o \"trailing\""});
        problem.leading = sense.text() != "trailing";
    }
}

}  // namespace kinegraph
