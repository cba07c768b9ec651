// Contact, wear and impact, read.
#include "engine/problem_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinegraph {
namespace {

constexpr std::array materials{
    Material{"steel", 207e9, "0.292"},   Material{"stainless steel", 190e9, "0.305"}, Material{"cast iron", 100e9, "0.211"},
    Material{"bronze", 111e9, "0.349"},  Material{"brass", 106e9, "0.324"},           Material{"aluminium", 71.7e9, "0.333"},
    Material{"titanium", 114e9, "0.34"}, Material{"glass", 46.2e9, "0.245"},          Material{"nylon", 2.9e9, "0.35"},
};

constexpr std::string_view flat_word = "flat";

}  // namespace

std::span<const Material> known_materials() { return materials; }

bool ProblemReader::states_problem(const Members& file) {
    return std::any_of(problem_keys.begin(), problem_keys.end(), [&](std::string_view key) {
        return key == "motion" ? is_motion_of_a_point(file[key]) : file.has_or_misspells(key);
    });
}

std::shared_ptr<const Problem> ProblemReader::read_problem(const Members& file, Mechanism& mechanism) {
    JsonValue section;
    for (const std::string_view key : problem_keys) {
        if (!file[key] || (key == "motion" && !is_motion_of_a_point(file[key]))) continue;
        if (section)
            fault(file[key], {"{0} and {1} do not go together; take one of them out",
                              "{0} e {1} non stanno insieme; toglierne una", quoted(key), quoted(section.key())});
        else
            section = file[key];
    }
    if (!section) return nullptr;
    for (const std::string_view key :
         {"joints", "drivers", "motion", "masses", "gravity", "inertia forces", "loads", "effort", "find", "scales"}) {
        if (file[key] && !(key == "motion" && is_motion_of_a_point(file[key])))
            fault(file[key], {"{0} and {1} do not go together; take one of them out",
                              "{0} e {1} non stanno insieme; toglierne una", quoted(key), quoted(section.key())});
    }
    if (section.key() == "positions") {
        if (!expect(section, Kind::array, {"an array of positions", "un array di posizioni"})) return nullptr;
    } else if (!expect(section, Kind::object, {"an object", "un oggetto"})) {
        return nullptr;
    }
    const auto shared = [](auto problem) -> std::shared_ptr<const Problem> {
        if (!problem) return nullptr;
        return std::make_shared<const Problem>(Problem{*std::move(problem)});
    };
    if (section.key() == "reye") return shared(read_reye(section));
    if (section.key() == "positions") return shared(read_positions(section));
    if (section.key() == "motion") return shared(read_point_motion(section));
    return section.key() == "hertz" ? shared(read_hertz(section, mechanism)) : shared(read_impact(section, mechanism));
}

BodyIndex ProblemReader::problem_body(JsonValue member, Mechanism& mechanism) {
    for (std::size_t i = 1; i < mechanism.bodies.size(); ++i)
        if (mechanism.bodies[i].name == member.key()) return BodyIndex(i);
    check_name(member, member.key());
    Body added;
    added.name = member.key();
    added.where = member.pointer();
    mechanism.bodies.push_back(std::move(added));
    return BodyIndex(mechanism.bodies.size() - 1);
}

std::array<JsonValue, 2> ProblemReader::two_bodies(const Members& section) {
    const Words wanted("an object of two bodies by name", "un oggetto con due corpi per nome");
    const JsonValue bodies = required(section, "bodies", wanted);
    if (!bodies || !expect(bodies, Kind::object, wanted)) return {};
    if (bodies.size() != 2) {
        fault(bodies,
              {"two bodies touch; {0} are given", "si toccano due corpi; ne sono dati {0}", std::to_string(bodies.size())});
        return {};
    }
    return {*bodies.begin(), *++bodies.begin()};
}

// ----- hertz

std::optional<HertzProblem> ProblemReader::read_hertz(JsonValue section, Mechanism& mechanism) {
    const std::size_t before = faults_.size();
    const Members form = members(section, {"force", "bodies", "contact", "length", "turned"}, {"\"hertz\"", "\"hertz\""});
    HertzProblem problem;
    problem.force =
        positive(required(form, "force", {"the force that presses the bodies together", "la forza che preme i corpi"}),
                 QuantityKind::force, {"the force", "la forza"});
    if (const JsonValue contact = form["contact"]) {
        problem.line = contact.text() == "line";
        if (!contact.is_string() || (contact.text() != "line" && contact.text() != "point"))
            wrong(contact, {"\"point\" or \"line\"", "\"point\" o \"line\""});
    }
    if (problem.line) {
        problem.length =
            positive(required(form, "length", {"how long the line of contact is", "quanto è lunga la linea di contatto"}),
                     QuantityKind::length, {"the length", "la lunghezza"});
        if (form["turned"])
            fault(form["turned"],
                  {"bodies that touch along a line are not turned; take \"turned\" out, or write \"contact\": \"point\"",
                   "corpi a contatto lungo una linea non sono ruotati; togliere \"turned\", o scrivere \"contact\": \"point\""});
    } else {
        if (form["length"])
            fault(form["length"], {"a contact at a point has no length; take it out, or write \"contact\": \"line\"",
                                   "un contatto di punto non ha lunghezza; toglierla, o scrivere \"contact\": \"line\""});
        if (form["turned"]) problem.turn = quantity_or_zero(form["turned"], QuantityKind::angle);
    }
    const auto bodies = two_bodies(form);
    if (!bodies[0]) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) problem.bodies[i] = read_hertz_body(bodies[i], problem.line, mechanism);
    if (faults_.size() == before) check_curvatures(problem, form["bodies"]);
    return problem;
}

HertzBody ProblemReader::read_hertz_body(JsonValue member, bool line, Mechanism& mechanism) {
    HertzBody body;
    body.body = problem_body(member, mechanism);
    body.where = member.pointer();
    if (!expect(member, Kind::object, {"an object", "un oggetto"})) return body;
    const Members form = members(member, {"radius", "radii", "flat", "inside", "material", "young", "poisson", "depth", "label"},
                                 {"a body", "un corpo"});
    if (form["label"]) mechanism.bodies[at_index(body.body)].label = words(form["label"]);
    read_shape(form, line, body);
    read_material(form, body);
    if (const JsonValue depth = form["depth"]) {
        if (line && (body.radii[0].is_zero() || body.inside[0]))
            body.depth = positive(depth, QuantityKind::length, {"the depth", "la profondità"});
        else
            fault(depth, {"only a flat or concave body at a line of contact has a \"depth\"; take it out",
                          "solo un corpo piano o concavo a contatto lungo una linea ha \"depth\"; toglierla"});
    }
    return body;
}

void ProblemReader::read_shape(const Members& form, bool line, HertzBody& body) {
    const JsonValue shape = one_of(form, {"radius", "radii", "flat"});
    if (!shape) return;
    if (shape.key() == "flat") {
        if (!expect(shape, Kind::boolean, {"true", "true"})) return;
        if (!is_true(shape))
            fault(shape, {"a body that is not flat has a \"radius\"", "un corpo che non è piano ha un \"radius\""});
        if (form["inside"])
            fault(form["inside"], {"what is flat has no inside; take it out", "ciò che è piano non è concavo; toglierlo"});
    } else if (shape.key() == "radius") {
        read_radius(shape, 0, body);
        body.radii[1] = body.radii[0];
        if (form["inside"] && expect(form["inside"], Kind::boolean, {"true or false", "true o false"}))
            body.inside = {is_true(form["inside"]), is_true(form["inside"])};
    } else {
        const Words wanted("two principal radii [r1, r2], each a length or \"flat\"",
                           "due raggi principali [r1, r2], ciascuno una lunghezza o \"flat\"");
        if (line)
            fault(shape, {"at a line of contact a body has one \"radius\"",
                          "lungo una linea di contatto un corpo ha un solo \"radius\""});
        if (!shape.is_array() || shape.size() != 2) {
            wrong(shape, wanted);
            return;
        }
        read_radius(*shape.begin(), 0, body);
        read_radius(*++shape.begin(), 1, body);
        if (const JsonValue inside = form["inside"]) {
            if (!inside.is_array() || inside.size() != 2 || (*inside.begin()).kind() != Kind::boolean ||
                (*++inside.begin()).kind() != Kind::boolean)
                wrong(inside,
                      {"[true or false, true or false], for each radius,", "[true o false, true o false], per ciascun raggio,"});
            else
                body.inside = {is_true(*inside.begin()), is_true(*++inside.begin())};
        }
    }
}

void ProblemReader::read_radius(JsonValue value, std::size_t plane, HertzBody& body) {
    if (value.is_string() && value.text() == flat_word) return;
    body.radii[plane] = positive(value, QuantityKind::length, {"a radius", "un raggio"});
}

void ProblemReader::read_material(const Members& form, HertzBody& body) {
    body.young = 1;
    if (const JsonValue name = form["material"]) {
        for (const std::string_view key : {"young", "poisson"})
            if (form[key])
                fault(form[key], {"{0} and \"material\" do not go together; take one of them out",
                                  "{0} e \"material\" non stanno insieme; toglierne una", quoted(key)});
        return read_named_material(name, body);
    }
    body.young = positive(
        required(form, "young", {"Young’s modulus (or give a \"material\")", "il modulo di Young (o dare un \"material\")"}),
        QuantityKind::pressure, {"Young’s modulus", "il modulo di Young"});
    const JsonValue ratio = required(
        form, "poisson", {"Poisson’s ratio (or give a \"material\")", "il coefficiente di Poisson (o dare un \"material\")"});
    body.poisson = bare_number(ratio).value_or(Exact());
    if (ratio && (body.poisson.sign() < 0 || body.poisson >= Exact::ratio(1, 2)))
        fault(ratio, {"Poisson’s ratio must lie from 0 to less than 0.5, where a body could not be compressed at all",
                      "il coefficiente di Poisson deve stare fra 0 e meno di 0.5, dove un corpo non sarebbe comprimibile"});
}

void ProblemReader::read_named_material(JsonValue name, HertzBody& body) {
    std::vector<std::string_view> names;
    for (const Material& each : materials) names.push_back(each.name);
    const auto* found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name.text(); });
    if (!name.is_string() || found == materials.end()) {
        fault(name, {"no material is known as {0}{1}; known are {2} (or give \"young\" and \"poisson\")",
                     "nessun materiale è noto come {0}{1}; sono noti {2} (o dare \"young\" e \"poisson\")", quoted(name.text()),
                     did_you_mean(speller_.nearest(name.text(), names)), listed(names)});
        return;
    }
    body.young = Exact::from_double(found->young);
    body.poisson = *Exact::from_decimal(found->poisson);
}

void ProblemReader::read_contact(const Members& form, const Joint& joint, JointIndex index) {
    const JsonValue materials = form["materials"];
    if (!materials) {
        if (form["length"] && !form.has_or_misspells("materials"))
            fault(form["length"], {"a contact has a \"length\" where it has \"materials\"; give them, or take it out",
                                   "un contatto ha \"length\" dove ha \"materials\"; assegnarli, o toglierla"});
        return;
    }
    LoadedContact contact;
    contact.joint = index;
    contact.where = materials.pointer();
    read_bodies_of_contact(materials, joint, contact);
    contact.length =
        positive(required(form, "length", {"how long the line of contact is", "quanto è lunga la linea di contatto"}),
                 QuantityKind::length, {"the length", "la lunghezza"});
    check_profiles_of_contact(materials, form, joint);
    contacts_.push_back(std::move(contact));
}

/// One material by name for both, or an object: by body a name or {"material" | "young", "poisson"}.
void ProblemReader::read_bodies_of_contact(JsonValue materials, const Joint& joint, LoadedContact& contact) {
    if (joint.bodies.size() != 2) return;
    for (std::size_t i = 0; i < 2; ++i) {
        contact.bodies.at(i).body = joint.bodies[i];
        contact.bodies.at(i).young = 1;
        contact.bodies.at(i).where = materials.pointer();
        if (materials.is_string()) read_named_material(materials, contact.bodies.at(i));
        if (materials.is_string() && contact.bodies.at(i).young == Exact(1)) return;  // once said is enough
    }
    if (materials.is_string() ||
        !expect(materials, Kind::object,
                {"a material, or an object of materials by body,", "un materiale, o un oggetto con i materiali per corpo,"}))
        return;
    std::array<bool, 2> given{};
    for (const JsonValue member : materials) {
        const BodyIndex on = look_up_body(member, member.key());
        if (on == none) return;
        if (!joint.connects(on)) {
            fault(member, {"the body {0} is not in this joint", "il corpo {0} non è in questa coppia", quoted(member.key())});
            return;
        }
        const std::size_t i = joint.bodies[0] == on ? 0 : 1;
        given.at(i) = true;
        HertzBody& body = contact.bodies.at(i);
        body.where = member.pointer();
        if (member.is_string())
            read_named_material(member, body);
        else if (expect(member, Kind::object, {"a material", "un materiale"})) {
            const Members properties = members(member, {"material", "young", "poisson", "depth"}, {"a material", "un materiale"});
            read_material(properties, body);
            if (properties["depth"])
                body.depth = positive(properties["depth"], QuantityKind::length, {"the depth", "la profondità"});
        }
    }
    for (std::size_t i = 0; i < 2; ++i)
        if (!given.at(i) && joint.bodies[i] != none)
            fault(materials, {"the material of body {0} is missing; both bodies yield",
                              "manca il materiale del corpo {0}; cedono entrambi i corpi",
                              quoted(body_names_.at(at_index(joint.bodies[i])))});
}

/// Hertz asks for curvatures: two smooth profiles, or teeth whose pressure angle is known.
void ProblemReader::check_profiles_of_contact(JsonValue materials, const Members& form, const Joint& joint) {
    if (form["tangent"]) {
        fault(form["tangent"], {"contact with \"materials\" asks for radii; give \"profiles\" in place of a tangent",
                                "un contatto con \"materials\" richiede i raggi; dare \"profiles\" al posto della tangente"});
        return;
    }
    for (const auto& [body, profile] : joint.profiles)
        if (std::holds_alternative<TipProfile>(profile)) {
            fault(materials,
                  {"a tip has no radius, and its pressure no bound; round it to a circle, or take \"materials\" out",
                   "una punta non ha raggio, e la pressione non ha limite; arrotondarla a un cerchio, o togliere \"materials\""});
            return;
        }
    if (joint.pressure_angle && joint.pressure_angle->value.is_zero())
        fault(form["pressure angle"],
              {"teeth that press each other have a pressure angle larger than 0°, else their radii vanish",
               "denti che si premono hanno un angolo di pressione maggiore di 0°, altrimenti i raggi si annullano"});
    if (joint.pair().meshes() && !form.has_or_misspells("pressure angle"))
        fault(materials, {"the radii of teeth at the pitch point want a \"pressure angle\"; give it",
                          "i raggi dei denti nel punto primitivo richiedono un \"pressure angle\"; assegnarlo"});
}

void ProblemReader::check_curvatures(const HertzProblem& problem, JsonValue bodies) {
    const HertzBody& first = problem.bodies[0];
    const HertzBody& second = problem.bodies[1];
    const auto sum = [&](std::size_t plane) { return first.curvature(plane) + second.curvature(plane); };
    if (first.radii[0].is_zero() && second.radii[0].is_zero() && first.radii[1].is_zero() && second.radii[1].is_zero()) {
        fault(bodies, {"two flat bodies touch on their whole face; give one of them a \"radius\"",
                       "due corpi piani si toccano su tutta la faccia; dare a uno un \"radius\""});
        return;
    }
    const Words conforms("the concave radius must be larger than the convex one, else the bodies do not touch at a {0} alone",
                         "il raggio concavo deve essere maggiore di quello convesso, altrimenti i corpi non si toccano in {0}",
                         problem.line ? Words("line", "una linea") : Words("point", "un punto"));
    const JsonValue concave = *(first.inside[0] || first.inside[1] ? bodies.begin() : ++bodies.begin());
    if (problem.line) {
        if (sum(0).sign() <= 0) fault(concave, conforms);
        return;
    }
    // A and B of the gap: both must be positive. With twice their sum s and the squared difference d², s² > d².
    const Exact d1 = first.curvature(0) - first.curvature(1), d2 = second.curvature(0) - second.curvature(1);
    const double twice = 2 * problem.turn.to_double();
    const double s = (sum(0) + sum(1)).to_double();
    const double d =
        std::sqrt(std::max(0.0, square(d1).to_double() + square(d2).to_double() + 2 * (d1 * d2).to_double() * std::cos(twice)));
    constexpr double slenderest = 1e-9;  // A/B: beyond it, an ellipse is a line
    if (s - d > slenderest * (s + d)) return;
    const bool is_concave = first.inside[0] || first.inside[1] || second.inside[0] || second.inside[1];
    fault(is_concave ? concave : bodies,
          is_concave ? conforms
                     : Words("these bodies touch along a line; write \"contact\": \"line\" with its \"length\"",
                             "questi corpi si toccano lungo una linea; scrivere \"contact\": \"line\" con la sua \"length\""));
}

// ----- reye

std::optional<ReyeProblem::Kind> ProblemReader::read_kind_of_reye(JsonValue section) {
    constexpr std::array kinds{std::pair{std::string_view("pad"), ReyeProblem::Kind::pad},
                               std::pair{std::string_view("block"), ReyeProblem::Kind::block},
                               std::pair{std::string_view("disc"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("collar"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("shoe"), ReyeProblem::Kind::shoe}};
    const Words wanted("\"pad\", \"block\", \"disc\", \"collar\" or \"shoe\"",
                       "\"pad\", \"block\", \"disc\", \"collar\" o \"shoe\"");
    const JsonValue kind = section["kind"];
    if (!kind) {
        fault(section, {"\"kind\" is missing: {0}", "manca \"kind\": {0}", wanted});
        return std::nullopt;
    }
    const auto* found =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& each) { return kind.is_string() && each.first == kind.text(); });
    if (found == kinds.end()) {
        wrong(kind, wanted);
        return std::nullopt;
    }
    return found->second;
}

std::optional<ReyeProblem> ProblemReader::read_reye(JsonValue section) {
    const auto kind = read_kind_of_reye(section);
    if (!kind) return std::nullopt;
    ReyeProblem problem;
    problem.kind = *kind;
    problem.where = section.pointer();
    const auto read = [&](std::initializer_list<std::string_view> own) {
        std::vector<std::string_view> keys{"kind", "force", "friction", "wear", "time"};
        keys.insert(keys.end(), own.begin(), own.end());
        return members(section, std::span<const std::string_view>(keys), {"\"reye\"", "\"reye\""});
    };
    const bool slides = problem.kind == ReyeProblem::Kind::pad || problem.kind == ReyeProblem::Kind::block;
    const Members form = problem.kind == ReyeProblem::Kind::pad     ? read({"length", "width", "offset", "speed"})
                         : problem.kind == ReyeProblem::Kind::block ? read({"length", "width", "speed"})
                         : problem.kind == ReyeProblem::Kind::disc
                             ? read({"inner", "outer", "surfaces", "omega"})
                             : read({"radius", "width", "pivot", "arm", "from", "to", "inside", "sense", "omega"});
    problem.force = positive(required(form, "force", {"the force that presses", "la forza che preme"}), QuantityKind::force,
                             {"the force", "la forza"});
    if (!slides)
        required(form, "friction",
                 {"the coefficient of friction, which makes the torque", "il coefficiente d’attrito, che dà il momento"});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = bare_number(friction).value_or(Exact(1));
        if (problem.friction->sign() <= 0)
            fault(friction, {"the coefficient of friction must be greater than zero",
                             "il coefficiente d’attrito deve essere maggiore di zero"});
    }
    const std::string_view speed = slides ? "speed" : "omega";
    const std::initializer_list<std::string_view> of_wear{"wear", speed, "time"};
    if (std::any_of(of_wear.begin(), of_wear.end(), [&](std::string_view key) { return bool(form[key]); })) {
        const Words needs("the depth worn off needs \"wear\", {0} and \"time\"",
                          "la profondità d’usura richiede \"wear\", {0} e \"time\"", quoted(speed));
        problem.wear =
            positive(required(form, "wear", needs), QuantityKind::wear, {"the coefficient of wear", "il coefficiente d’usura"});
        problem.speed = positive(required(form, speed, needs), slides ? QuantityKind::velocity : QuantityKind::angular_velocity,
                                 {"the speed", "la velocità"});
        problem.time = positive(required(form, "time", needs), QuantityKind::time, {"the time", "la durata"});
    }
    if (slides)
        read_pad(form, problem);
    else if (problem.kind == ReyeProblem::Kind::disc)
        read_disc(form, problem);
    else
        read_shoe(form, problem);
    return problem;
}

void ProblemReader::read_pad(const Members& form, ReyeProblem& problem) {
    problem.length = positive(
        required(form, "length", {"the pad’s length along the sliding", "la lunghezza del pattino lungo lo strisciamento"}),
        QuantityKind::length, {"the length", "la lunghezza"});
    problem.width = positive(required(form, "width", {"the pad’s width", "la larghezza del pattino"}), QuantityKind::length,
                             {"the width", "la larghezza"});
    if (problem.kind == ReyeProblem::Kind::block) return;
    const JsonValue offset =
        required(form, "offset", {"how far from its end the force acts", "a quale distanza dal suo estremo agisce la forza"});
    problem.offset = quantity_or_zero(offset, QuantityKind::length);
    if (offset && (problem.offset.sign() <= 0 || problem.offset >= problem.length))
        fault(offset, {"the force must act over the pad, between 0 and its length; beyond, the pad tips over",
                       "la forza deve cadere sul pattino, fra 0 e la sua lunghezza; oltre, il pattino si ribalta"});
}

void ProblemReader::read_disc(const Members& form, ReyeProblem& problem) {
    const Words radius("a radius", "un raggio");
    const JsonValue inner = required(form, "inner", {"the inner radius", "il raggio interno"});
    problem.inner = positive(inner, QuantityKind::length, radius);
    problem.outer = positive(required(form, "outer", {"the outer radius", "il raggio esterno"}), QuantityKind::length, radius);
    if (inner && form["outer"] && problem.inner >= problem.outer)
        fault(inner,
              {"the inner radius must be less than the outer one", "il raggio interno deve essere minore di quello esterno"});
    if (const JsonValue surfaces = form["surfaces"]) {
        const Exact count = bare_number(surfaces).value_or(Exact(1));
        constexpr int most = 1000;
        if (!is_whole_number(surfaces) || count.sign() <= 0 || count > Exact(most))
            fault(surfaces, {"the number of rubbing surfaces is a whole number from 1 to 1000",
                             "il numero di superfici è un intero da 1 a 1000"});
        else
            problem.surfaces = static_cast<int>(count.to_double());
    }
}

void ProblemReader::read_shoe(const Members& form, ReyeProblem& problem) {
    const Words length("a length", "una lunghezza");
    problem.radius = positive(required(form, "radius", {"the drum’s radius", "il raggio del tamburo"}), QuantityKind::length,
                              {"a radius", "un raggio"});
    problem.width =
        positive(required(form, "width", {"the shoe’s width", "la larghezza del ceppo"}), QuantityKind::length, length);
    const JsonValue pivot = required(
        form, "pivot", {"the distance of the pivot from the drum’s centre", "la distanza della cerniera dal centro del tamburo"});
    problem.pivot = positive(pivot, QuantityKind::length, length);
    problem.arm =
        positive(required(form, "arm", {"the arm of the force about the pivot", "il braccio della forza rispetto alla cerniera"}),
                 QuantityKind::length, length);
    const Words end("the angle from the pivot to an end of the shoe", "l’angolo dalla cerniera a un estremo del ceppo");
    const JsonValue to = required(form, "to", end);
    problem.from = quantity_or_zero(required(form, "from", end), QuantityKind::angle);
    problem.to = quantity_or_zero(to, QuantityKind::angle);
    if (to && form["from"] && (problem.from.sign() < 0 || problem.to <= problem.from || problem.to > pi()))
        fault(to,
              {"a shoe reaches from an angle not less than 0° to a larger one, at most 180°; beyond it would part from the drum",
               "un ceppo va da un angolo non minore di 0° a uno maggiore, al più 180°; oltre si staccherebbe dal tamburo"});
    if (form["inside"] && expect(form["inside"], Kind::boolean, {"true or false", "true o false"})) {
        problem.inside = is_true(form["inside"]);
        if (problem.inside && pivot && problem.pivot >= problem.radius)
            fault(pivot,
                  {"the pivot of an inner shoe lies within the drum", "la cerniera di un ceppo interno sta dentro il tamburo"});
    }
    if (const JsonValue sense = form["sense"]) {
        if (!sense.is_string() || (sense.text() != "leading" && sense.text() != "trailing"))
            wrong(sense, {"\"leading\" or \"trailing\"", "\"leading\" o \"trailing\""});
        problem.leading = sense.text() != "trailing";
    }
}

// ----- impact

std::optional<ImpactProblem> ProblemReader::read_impact(JsonValue section, Mechanism& mechanism) {
    const Members form = members(section, {"bodies", "at", "normal", "restitution", "friction"}, {"\"impact\"", "\"impact\""});
    ImpactProblem problem;
    problem.where = section.pointer();
    const auto bodies = two_bodies(form);
    if (bodies[0])
        for (std::size_t i = 0; i < 2; ++i) problem.bodies.at(i) = read_impact_body(bodies.at(i), mechanism);
    if (const JsonValue at =
            required(form, "at", {"the point of impact, a point or [x, y]", "il punto d’urto, un punto o [x, y]"}))
        problem.at = place(at);
    if (const JsonValue normal =
            required(form, "normal", {"the direction of the line of impact", "la direzione della linea d’urto"}))
        problem.normal = bearing_or_default(normal);
    const JsonValue restitution = required(
        form, "restitution", {"the coefficient of restitution, from 0 to 1", "il coefficiente di restituzione, da 0 a 1"});
    problem.restitution = bare_number(restitution).value_or(Exact());
    if (problem.restitution.sign() < 0 || problem.restitution > Exact(1))
        fault(restitution, {"the coefficient of restitution lies from 0 (plastic) to 1 (elastic)",
                            "il coefficiente di restituzione sta fra 0 (plastico) e 1 (elastico)"});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = bare_number(friction).value_or(Exact());
        if (problem.friction.sign() < 0)
            fault(friction,
                  {"the coefficient of friction must not be negative", "il coefficiente d’attrito non può essere negativo"});
    }
    if (!bodies[0]) return std::nullopt;
    if (problem.bodies[0].fixed && problem.bodies[1].fixed)
        fault(form["bodies"], {"both bodies are fixed, so nothing moves; let one of them free",
                               "entrambi i corpi sono fissi e nulla si muove; liberarne uno"});
    return problem;
}

ImpactBody ProblemReader::read_impact_body(JsonValue member, Mechanism& mechanism) {
    ImpactBody body;
    body.body = problem_body(member, mechanism);
    body.where = member.pointer();
    if (!expect(member, Kind::object, {"an object", "un oggetto"})) return body;
    const Members form =
        members(member, {"mass", "centre", "inertia", "velocity", "omega", "pivot", "fixed", "label"}, {"a body", "un corpo"});
    if (form["label"]) mechanism.bodies[at_index(body.body)].label = words(form["label"]);
    if (const JsonValue fixed = form["fixed"]; fixed && expect(fixed, Kind::boolean, {"true or false", "true o false"}))
        body.fixed = is_true(fixed);
    if (body.fixed) {
        for (const std::string_view key : {"mass", "centre", "inertia", "velocity", "omega", "pivot"})
            if (form[key])
                fault(form[key], {"a fixed body has no {0}; take it out", "un corpo fisso non ha {0}; toglierlo", quoted(key)});
        return body;
    }
    body.mass = positive(required(form, "mass", {"the mass (or \"fixed\": true)", "la massa (o \"fixed\": true)"}),
                         QuantityKind::mass, {"a mass", "una massa"});
    if (form["inertia"])
        body.inertia = positive(form["inertia"], QuantityKind::inertia, {"a moment of inertia", "un momento d’inerzia"});
    if (form["centre"]) body.centre = place(form["centre"]);
    if (form["omega"]) body.omega = quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
    body.velocity = vector(form["velocity"], QuantityKind::velocity, {"a vector [vx, vy]", "un vettore [vx, vy]"});
    if (form["omega"] && !form["inertia"] && !form["pivot"])
        fault(form["omega"], {"a body that turns has an \"inertia\"; give it, or take \"omega\" out",
                              "un corpo che ruota ha un \"inertia\"; assegnarlo, o togliere \"omega\""});
    if (const JsonValue pivot = form["pivot"]) {
        body.pivot = place(pivot);
        if (form["velocity"])
            fault(form["velocity"], {"the velocity of a body on a pivot follows from its \"omega\"; give that",
                                     "la velocità di un corpo incernierato segue dalla sua \"omega\"; assegnare quella"});
        if (!form["centre"])
            fault(member, {"a body on a pivot has a \"centre\"; give it", "un corpo incernierato ha un \"centre\"; assegnarlo"});
    }
    return body;
}

}  // namespace kinegraph
