#include "engine/reading/sections.hpp"

#include <utility>

namespace kinegraph {

void LoadsSection::read_masses(JsonValue masses) {
    if (!masses ||
        !file_.expect(masses, Kind::object, {"an object of masses by body", "un oggetto con le masse per corpo"}))
        return;
    for (const JsonValue member : masses) {
        Mass mass;
        mass.where = member.pointer();
        mass.body = file_.look_up_body(member, member.key());
        if (!file_.expect(
                member, Kind::object,
                {"{\"mass\": …, \"centre\": …, \"inertia\": …}", "{\"mass\": …, \"centre\": …, \"inertia\": …}"}))
            continue;
        const Members form =
            file_.members(member, {"mass", "centre", "inertia"}, {"a body's mass", "la massa di un corpo"});
        mass.mass = file_.not_negative(file_.required(form, "mass", {"how much it is", "quanto vale"}),
                                       QuantityKind::mass, {"a mass", "una massa"});
        mass.centre = file_.point(file_.required(form, "centre", {"the centre of mass", "il baricentro"}));
        mass.inertia =
            file_.not_negative(form["inertia"], QuantityKind::inertia, {"a moment of inertia", "un momento d’inerzia"});
        mechanism_.masses.push_back(std::move(mass));
    }
}

void LoadsSection::read_load(JsonValue value) {
    if (!file_.expect(value, Kind::object, {"a load", "un carico"})) return;
    if (value["couple"]) {
        const Members form =
            file_.members(value, {"couple", "body", "value", "force"}, {"a couple", "una coppia di forze"});
        file_.one_of(form, {"couple", "force"});
        CoupleLoad couple;
        couple.where = value.pointer();
        couple.name = name_of_load(form["couple"], {"the couple's name", "il nome della coppia di forze"});
        couple.body = file_.body(file_.required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
        couple.value = file_.quantity_or_zero(
            file_.required(form, "value", {"the couple's size", "il valore della coppia di forze"}),
            QuantityKind::moment);
        mechanism_.loads.emplace_back(std::move(couple));
    } else if (value["spring"]) {
        read_elastic(value);
    } else if (value["distributed"]) {
        read_distributed(value);
    } else if (value["bodies"] || value["between"]) {
        read_spring(value);
    } else if (value["pin"]) {
        read_pin_load(value);
    } else {
        read_force(value);
    }
}

std::string LoadsSection::name_of_load(JsonValue value, const Words& wanted) {
    std::string name = file_.new_name(value, wanted);
    if (!name.empty() && !load_names_.insert(name).second)
        file_.fault(value,
                    {"two loads are named {0}; figures go by the name, so rename one",
                     "due carichi si chiamano {0}; le figure vanno per nome, quindi rinominarne uno", quoted(name)});
    return name;
}

void LoadsSection::read_force(JsonValue value) {
    const Members form = file_.members(value,
                                       {"force", "body", "at", "value", "magnitude", "along", "pressure", "area",
                                        "couple", "bodies", "between", "pin"},
                                       {"a force", "una forza"});
    for (const std::string_view key : {"couple", "bodies", "between", "pin"})
        if (form.has_or_misspells(key)) return;
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {"the load's name is missing: \"force\" or \"couple\"",
                            "manca il nome del carico: \"force\" o \"couple\""});
        return;
    }
    ForceLoad force;
    force.where = value.pointer();
    if (const JsonValue name =
            file_.required(form, "force", {"the force's name (or \"couple\")", "il nome della forza (o \"couple\")"}))
        force.name = name_of_load(name, {"the force's name", "il nome della forza"});
    force.body = file_.body(file_.required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
    force.at = file_.point(file_.required(form, "at", {"the point at which it acts", "il punto in cui agisce"}));
    read_size(form, force);
    mechanism_.loads.emplace_back(std::move(force));
}

void LoadsSection::read_pin_load(JsonValue value) {
    const Members form = file_.members(value, {"force", "pin", "value", "magnitude", "along", "pressure", "area"},
                                       {"a force", "una forza"});
    ForceLoad force;
    force.where = value.pointer();
    if (const JsonValue name = file_.required(form, "force", {"the force's name", "il nome della forza"}))
        force.name = name_of_load(name, {"the force's name", "il nome della forza"});
    force.pin = joints_.hinge(form["pin"]);
    if (force.pin != none) {
        Joint& joint = mechanism_.joints[at_index(force.pin)];
        joint.loaded_pin = true;
        force.at = joint.point;
    }
    read_size(form, force);
    mechanism_.loads.emplace_back(std::move(force));
}

void LoadsSection::read_size(const Members& form, ForceLoad& force) {
    const JsonValue how = form["pressure"] ? file_.one_of(form, {"value", "magnitude", "pressure"})
                                           : file_.one_of(form, {"value", "magnitude"});
    if (how && how.key() == "value") {
        file_.one_of(form, {"value", "along"});
        force.value = file_.vector(how, QuantityKind::force, {"a force [Fx, Fy]", "una forza [Fx, Fy]"});
    } else if (how) {
        const auto magnitude =
            how.key() == "pressure" ? pressure_on_area(form) : file_.quantity(how, QuantityKind::force);
        const auto along =
            file_.bearing(file_.required(form, "along", {"the direction of the force", "la direzione della forza"}));
        if (magnitude && along) force.magnitude = {*magnitude, *along};
    }
    if (form["area"] && !form["pressure"])
        file_.fault(form["area"],
                    {"\"area\" goes with a \"pressure\"; give one", "\"area\" va con una \"pressure\"; assegnarla"});
}

std::optional<Exact> LoadsSection::pressure_on_area(const Members& form) {
    const auto pressure = file_.quantity(form["pressure"], QuantityKind::pressure);
    const JsonValue on = file_.required(form, "area", {"the area on which it presses", "l’area su cui preme"});
    if (!on || !pressure) return std::nullopt;
    return *pressure * file_.not_negative(on, QuantityKind::area, {"an area", "un’area"});
}

void LoadsSection::read_spring(JsonValue value) {
    const Members form = file_.members(value, {"force", "bodies", "between", "magnitude"},
                                       {"a force between two bodies", "una forza fra due corpi"});
    SpringLoad spring;
    spring.where = value.pointer();
    if (const JsonValue name = file_.required(form, "force", {"the force's name", "il nome della forza"}))
        spring.name = name_of_load(name, {"the force's name", "il nome della forza"});
    read_ends(form, spring);
    spring.magnitude = file_.quantity_or_zero(
        file_.required(form, "magnitude", {"how hard they are pulled", "quanto sono tirati"}), QuantityKind::force);
    mechanism_.loads.emplace_back(std::move(spring));
}

void LoadsSection::read_ends(const Members& form, SpringLoad& spring) {
    if (const JsonValue bodies = file_.required(
            form, "bodies", {"the two bodies that are pulled together", "i due corpi che si attraggono"}))
        spring.bodies = two_bodies(bodies);
    if (const JsonValue ends = file_.required(
            form, "between", {"the two points at which they are pulled", "i due punti in cui sono tirati"})) {
        if (ends.is_array() && ends.size() == 2) {
            const Bearing::Between points = file_.between(ends);
            spring.between = {points.from, points.to};
        } else {
            file_.fault(ends,
                        {"two points are wanted here, not {0}", "qui servono due punti, non {0}", described(ends)});
        }
    }
}

std::array<BodyIndex, 2> LoadsSection::two_bodies(JsonValue bodies) {
    if (!bodies.is_array() || bodies.size() != 2) {
        file_.fault(bodies,
                    {"two bodies are wanted here, not {0}", "qui servono due corpi, non {0}", described(bodies)});
        return {none, none};
    }
    const JsonValue second = *++bodies.begin();
    const std::array<BodyIndex, 2> both{file_.body(*bodies.begin()), file_.body(second)};
    if (both[0] != none && both[0] == both[1])
        file_.fault(second, {"the body {0} stands twice; a spring is between two bodies",
                             "il corpo {0} compare due volte; una molla sta fra due corpi", quoted(second.text())});
    return both;
}

void LoadsSection::read_elastic(JsonValue value) {
    const bool of_torsion = value["turned"] || value["at"];
    const Members form = of_torsion ? file_.members(value, {"spring", "bodies", "at", "stiffness", "turned"},
                                                    {"a torsion spring", "una molla di torsione"})
                                    : file_.members(value, {"spring", "bodies", "between", "stiffness", "free length"},
                                                    {"a spring", "una molla"});
    const std::string name = name_of_load(form["spring"], {"the spring's name", "il nome della molla"});
    const JsonValue stiffness =
        file_.required(form, "stiffness", {"how stiff the spring is", "la rigidezza della molla"});
    const Words called("a stiffness", "una rigidezza");
    if (!of_torsion) {
        SpringLoad spring;
        spring.where = value.pointer();
        spring.name = name;
        read_ends(form, spring);
        spring.elastic = SpringLoad::Elastic{
            file_.not_negative(stiffness, QuantityKind::force_per_length, called),
            file_.not_negative(
                file_.required(form, "free length", {"how long it is without force", "la lunghezza a riposo"}),
                QuantityKind::length, {"a free length", "una lunghezza a riposo"})};
        mechanism_.loads.emplace_back(std::move(spring));
        return;
    }
    TorsionLoad torsion;
    torsion.where = value.pointer();
    torsion.name = name;
    if (const JsonValue bodies =
            file_.required(form, "bodies", {"the two bodies that it turns", "i due corpi che fa ruotare"}))
        torsion.bodies = two_bodies(bodies);
    torsion.at = file_.point(
        file_.required(form, "at", {"the point about which it is wound", "il punto attorno a cui è avvolta"}));
    torsion.stiffness = file_.not_negative(stiffness, QuantityKind::torsional_stiffness, called);
    torsion.turned = file_.quantity_or_zero(
        file_.required(
            form, "turned",
            {"by how much the first body is turned from where the spring is slack, seen from the second",
             "di quanto il primo corpo, visto dal secondo, è ruotato dalla posizione in cui la molla è scarica"}),
        QuantityKind::angle);
    mechanism_.loads.emplace_back(std::move(torsion));
}

void LoadsSection::read_distributed(JsonValue value) {
    const Members form = file_.members(value, {"distributed", "body", "from", "to", "intensity", "along"},
                                       {"a distributed load", "un carico distribuito"});
    DistributedLoad load;
    load.where = value.pointer();
    load.name = name_of_load(form["distributed"], {"the load's name", "il nome del carico"});
    load.body = file_.body(file_.required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
    load.from = file_.point(file_.required(form, "from", {"the point where it begins", "il punto in cui comincia"}));
    load.to = file_.point(file_.required(form, "to", {"the point where it ends", "il punto in cui finisce"}));
    if (load.from != none && load.from == load.to)
        file_.fault(form["to"], {"a load from a point to itself has no length; name another",
                                 "un carico da un punto a se stesso non ha lunghezza; indicarne un altro"});
    const JsonValue intensity = file_.required(
        form, "intensity", {"the intensities at both ends, [q0, q1]", "le intensità ai due estremi, [q0, q1]"});
    if (intensity && (!intensity.is_array() || intensity.size() != 2)) {
        file_.fault(intensity, {"the intensities at both ends [q0, q1] are wanted here, not {0}",
                                "qui servono le intensità ai due estremi [q0, q1], non {0}", described(intensity)});
    } else if (intensity) {
        load.intensity = {file_.quantity_or_zero(*intensity.begin(), QuantityKind::force_per_length),
                          file_.quantity_or_zero(*++intensity.begin(), QuantityKind::force_per_length)};
    }
    load.along = file_.bearing_or_default(
        file_.required(form, "along", {"the direction of the load", "la direzione del carico"}));
    mechanism_.loads.emplace_back(std::move(load));
}

}  // namespace kinegraph
