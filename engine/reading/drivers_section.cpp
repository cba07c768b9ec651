#include "engine/reading/sections.hpp"

#include <utility>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

Words nothing_drives_the_frame() {
    return {"the frame does not move; drive another body", "il telaio non si muove; comandare un altro corpo"};
}

}  // namespace

void DriversSection::read_driver(JsonValue value) {
    if (!file_.expect(value, Kind::object, {"a driver", "un movente"})) return;
    if (value["joint"]) return read_slide_driver(value);
    if (value["at"] || value["along"] || value["speed"] || value["acceleration"]) return read_point_driver(value);
    read_spin_driver(value);
}

void DriversSection::read_slide_driver(JsonValue value) {
    const Members form = file_.members(value, {"joint", "speed", "acceleration", "law", "drawn at"},
                                       {"a driver of a joint", "un movente di una coppia"});
    SlideDriver driver;
    driver.where = value.pointer();
    driver.joint = joints_.sliding_joint(
        form["joint"],
        {"a driver moves a prismatic joint or a straight pin-slot; drive a \"body\" here",
         "un movente muove una coppia prismatica o un glifo rettilineo; qui comandare un corpo con \"body\""});
    if (driver.joint != none && mechanism_.joint(driver.joint).arc != none) {
        file_.fault(form["joint"],
                    {"the slot of {0} is curved; drive a \"body\" instead",
                     "il glifo di {0} è curvo; comandare invece un corpo con \"body\"", quoted(form["joint"].text())});
    }
    driver.speed = file_.quantity_or_zero(form["speed"], QuantityKind::velocity);
    driver.acceleration = file_.quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_point_driver(JsonValue value) {
    const Members form =
        file_.members(value, {"body", "at", "along", "speed", "acceleration", "law", "drawn at", "joint"},
                      {"a driver of a point", "un movente di un punto"});
    PointDriver driver;
    driver.where = value.pointer();
    if (form.has_or_misspells("joint")) return;
    if (!form.has_or_misspells("body") && !form.has_or_misspells("at") && !form.has_or_misspells("along")) {
        file_.fault(value, {"what is driven is missing: \"joint\", or \"body\", \"at\" and \"along\"",
                            "manca ciò che è comandato: \"joint\", oppure \"body\", \"at\" e \"along\""});
        return;
    }
    if (form["body"] && !form.has_or_misspells("at") && !form.has_or_misspells("along")) return turn_instead(form);
    driver.body = file_.moving_body(file_.required(form, "body", {"the body that is driven", "il corpo comandato"}),
                                    nothing_drives_the_frame());
    driver.at = file_.point(file_.required(form, "at", {"the point that is driven", "il punto comandato"}));
    driver.along = file_.bearing_or_default(
        file_.required(form, "along", {"the direction in which it is driven", "la direzione in cui è comandato"}));
    driver.speed = file_.quantity_or_zero(form["speed"], QuantityKind::velocity);
    driver.acceleration = file_.quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_spin_driver(JsonValue value) {
    const Members form = file_.members(
        value,
        {"body", "relative to", "omega", "alpha", "law", "drawn at", "joint", "at", "along", "speed", "acceleration"},
        {"a driver", "un movente"});
    for (const std::string_view key : {"joint", "at", "along", "speed", "acceleration"}) {
        if (form.has_or_misspells(key)) return;
    }
    SpinDriver driver;
    driver.where = value.pointer();
    driver.body = file_.moving_body(
        file_.required(form, "body",
                       {"the body that is driven (or give \"joint\")", "il corpo comandato (o assegnare \"joint\")"}),
        nothing_drives_the_frame());
    if (const JsonValue base = form["relative to"]) {
        driver.relative_to = file_.body(base);
        if (driver.relative_to > frame && driver.relative_to == driver.body)
            file_.fault(base, {"a body does not turn against itself; name another",
                               "un corpo non ruota rispetto a se stesso; indicarne un altro"});
    }
    driver.omega = file_.quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
    driver.alpha = file_.quantity_or_zero(form["alpha"], QuantityKind::angular_acceleration);
    driver.law = law(form, {"omega", "alpha"});
    add(std::move(driver));
}

void DriversSection::turn_instead(const Members& form) {
    for (const auto& [key, turning] : {std::pair{"speed", "omega"}, std::pair{"acceleration", "alpha"}})
        if (form[key])
            file_.fault(form[key], {"a body turns: give \"{1}\"; \"{0}\" is of a \"joint\" that slides, or of a point "
                                    "of the body, \"at\" P "
                                    "\"along\" X",
                                    "un corpo ruota: assegnare \"{1}\"; \"{0}\" è di una coppia che scorre (\"joint\") "
                                    "o di un punto del corpo, "
                                    "\"at\" P \"along\" X",
                                    std::string_view(key), std::string_view(turning)});
}

std::optional<Law> DriversSection::law(const Members& form, std::initializer_list<std::string_view> rates) {
    const JsonValue value = form["law"], drawn = form["drawn at"];
    if (!value) {
        if (drawn)
            file_.fault(drawn, {"\"drawn at\" is a time of the \"law\", and there is none",
                                "\"drawn at\" è un istante di \"law\", che manca"});
        return std::nullopt;
    }
    for (const std::string_view key : rates) {
        if (form[key])
            file_.fault(form[key], {"\"law\" gives the rates at every time; leave out {0}",
                                    "\"law\" dà velocità e accelerazione a ogni istante; togliere {0}", quoted(key)});
    }
    const bool turning = *rates.begin() == "omega";
    const std::size_t faults = file_.fault_count();
    Law law = laws_.law_of_value(
        value, turning ? LawReader::LawTerms{"turn", QuantityKind::angle, "time", QuantityKind::time}
                       : LawReader::LawTerms{"slide", QuantityKind::length, "time", QuantityKind::time});
    if (file_.fault_count() > faults) return std::nullopt;
    law.drawn = file_.quantity_or_zero(drawn, QuantityKind::time);
    if (law.drawn.sign() < 0 || law.drawn.to_double() > law.length() * (1 + 1e-12)) {
        file_.fault(drawn, {"it is no time of the law: before its beginning, or after its end",
                            "non è un istante della legge: precede il suo inizio, o segue la sua fine"});
        return std::nullopt;
    }
    return law;
}

void DriversSection::add(Driver driver) {
    if (const Law* law = law_of(driver)) {
        const auto rates = rates_at(*law, 0);
        KG_ASSERT(rates.has_value(), "a law passes through where it is drawn");
        driver = with_rates(std::move(driver), *rates);
    }
    mechanism_.drivers.push_back(std::move(driver));
}

}  // namespace kinegraph
