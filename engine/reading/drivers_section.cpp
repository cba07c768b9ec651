#include "engine/reading/sections.hpp"

#include <utility>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/drivers.hpp"

namespace kinegraph {
namespace {

Words nothing_drives_the_frame() { return {lang::drivers::the_frame_does_not_move_drive}; }

}  // namespace

void DriversSection::read_driver(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::drivers::a_driver})) return;
    if (value["joint"]) return read_slide_driver(value);
    if (value["at"] || value["along"] || value["speed"] || value["acceleration"]) return read_point_driver(value);
    read_spin_driver(value);
}

void DriversSection::read_slide_driver(JsonValue value) {
    const Members form = file_.members(value, {"joint", "speed", "acceleration", "law", "drawn at"},
                                       {lang::drivers::a_driver_of_a_joint});
    SlideDriver driver;
    driver.where = value.pointer();
    driver.joint = joints_.sliding_joint(form["joint"], {lang::drivers::a_driver_moves_a_prismatic_joint});
    if (driver.joint != none && mechanism_.joint(driver.joint).arc != none) {
        file_.fault(form["joint"], {lang::drivers::the_slot_of_is_curved_drive, quoted(form["joint"].text())});
    }
    driver.speed = file_.quantity_or_zero(form["speed"], QuantityKind::velocity);
    driver.acceleration = file_.quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_point_driver(JsonValue value) {
    const Members form =
        file_.members(value, {"body", "at", "along", "speed", "acceleration", "law", "drawn at", "joint"},
                      {lang::drivers::a_driver_of_a_point});
    PointDriver driver;
    driver.where = value.pointer();
    if (form.has_or_misspells("joint")) return;
    if (!form.has_or_misspells("body") && !form.has_or_misspells("at") && !form.has_or_misspells("along")) {
        file_.fault(value, {lang::drivers::what_is_driven_is_missing_joint});
        return;
    }
    if (form["body"] && !form.has_or_misspells("at") && !form.has_or_misspells("along")) return turn_instead(form);
    driver.body = file_.moving_body(file_.required(form, "body", {lang::drivers::the_body_that_is_driven}),
                                    nothing_drives_the_frame());
    driver.at = file_.point(file_.required(form, "at", {lang::drivers::the_point_that_is_driven}));
    driver.along = file_.bearing_or_default(file_.required(form, "along", {lang::drivers::the_direction}));
    driver.speed = file_.quantity_or_zero(form["speed"], QuantityKind::velocity);
    driver.acceleration = file_.quantity_or_zero(form["acceleration"], QuantityKind::acceleration);
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_spin_driver(JsonValue value) {
    const Members form = file_.members(
        value,
        {"body", "relative to", "omega", "alpha", "law", "drawn at", "joint", "at", "along", "speed", "acceleration"},
        {lang::drivers::a_driver});
    for (const std::string_view key : {"joint", "at", "along", "speed", "acceleration"}) {
        if (form.has_or_misspells(key)) return;
    }
    SpinDriver driver;
    driver.where = value.pointer();
    driver.body = file_.moving_body(file_.required(form, "body", {lang::drivers::the_body_that_is_driven_or}),
                                    nothing_drives_the_frame());
    if (const JsonValue base = form["relative to"]) {
        driver.relative_to = file_.body(base);
        if (driver.relative_to > frame && driver.relative_to == driver.body)
            file_.fault(base, {lang::drivers::a_body_does_not_turn_against});
    }
    driver.omega = file_.quantity_or_zero(form["omega"], QuantityKind::angular_velocity);
    driver.alpha = file_.quantity_or_zero(form["alpha"], QuantityKind::angular_acceleration);
    driver.law = law(form, {"omega", "alpha"});
    add(std::move(driver));
}

void DriversSection::turn_instead(const Members& form) {
    for (const auto& [key, turning] : {std::pair{"speed", "omega"}, std::pair{"acceleration", "alpha"}})
        if (form[key])
            file_.fault(form[key],
                        {lang::drivers::a_body_turns_give, std::string_view(key), std::string_view(turning)});
}

std::optional<Law> DriversSection::law(const Members& form, std::initializer_list<std::string_view> rates) {
    const JsonValue value = form["law"], drawn = form["drawn at"];
    if (!value) {
        if (drawn) file_.fault(drawn, {lang::drivers::drawn_at_is_a_time});
        return std::nullopt;
    }
    for (const std::string_view key : rates) {
        if (form[key]) file_.fault(form[key], {lang::drivers::law_gives_the_rates_at_every, quoted(key)});
    }
    const bool turning = *rates.begin() == "omega";
    const std::size_t faults = file_.fault_count();
    Law law = laws_.law_of_value(
        value, turning ? LawReader::LawTerms{"turn", QuantityKind::angle, "time", QuantityKind::time}
                       : LawReader::LawTerms{"slide", QuantityKind::length, "time", QuantityKind::time});
    if (file_.fault_count() > faults) return std::nullopt;
    law.drawn = file_.quantity_or_zero(drawn, QuantityKind::time);
    if (law.drawn.sign() < 0 || law.drawn.to_double() > law.length() * (1 + 1e-12)) {
        file_.fault(drawn, {lang::drivers::it_is_no_time});
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
