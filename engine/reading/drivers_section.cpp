#include "engine/reading/sections.hpp"

#include <utility>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/drivers.hpp"

namespace kinegraph {
namespace {

constexpr FormRow driven_speed("speed", "…", values::velocity),
    driven_acceleration("acceleration", "…", values::acceleration);
constexpr FormRow turn_law_row("law", "…", values::defined(forms::turn_law));
constexpr FormRow slide_law_row("law", "…", values::defined(forms::slide_law));
constexpr FormRow drawn_at("drawn at", "t", values::time,
                           "When, in the law, the drawn position is; its beginning if left out.");

constexpr std::array spin_rows{
    FormRow("body", "i", values::body_name).needed(lang::drivers::the_body_that_is_driven_or),
    FormRow("relative to", "j", values::body_name, "The frame if left out."),
    FormRow("omega", "…", values::angular_velocity),
    FormRow("alpha", "…", values::angular_acceleration),
    turn_law_row,
    drawn_at};
constexpr std::array slide_driver_rows{
    leading_key("joint", "name", values::joint_name, "The name of a prismatic joint or of a straight pin-slot."),
    driven_speed, driven_acceleration, slide_law_row, drawn_at};
constexpr std::array point_driver_rows{
    FormRow("body", "i", values::body_name).needed(lang::drivers::the_body_that_is_driven),
    FormRow("at", "P", values::point_name).needed(lang::drivers::the_point_that_is_driven),
    FormRow("along", "X", values::direction).needed(lang::drivers::the_direction),
    driven_speed,
    driven_acceleration,
    slide_law_row,
    drawn_at};
constexpr std::array<std::string_view, 5> not_of_spins{"joint", "at", "along", "speed", "acceleration"};
constexpr std::array<std::string_view, 1> not_of_points{"joint"};
constexpr Form spin_form{lang::drivers::a_driver, spin_rows, "A body that turns.", not_of_spins};
constexpr Form slide_driver_form{lang::drivers::a_driver_of_a_joint, slide_driver_rows,
                                 "The sliding of i along X, seen from j."};
constexpr Form point_driver_form{
    lang::drivers::a_driver_of_a_point, point_driver_rows,
    "The components of a point's velocity and acceleration along a direction fixed in the frame.", not_of_points};
constexpr std::array driver_choices{values::object(spin_form), values::object(slide_driver_form),
                                    values::object(point_driver_form)};

Words nothing_drives_the_frame() { return {lang::drivers::the_frame_does_not_move_drive}; }

}  // namespace

constinit const FormValue forms::driver =
    values::any(driver_choices).named("driver", "A given motion; what is left out is zero.");

void DriversSection::read_driver(JsonValue value) {
    if (!file_.expect(value, Kind::object, {lang::drivers::a_driver})) return;
    if (value["joint"]) return read_slide_driver(value);
    if (value["at"] || value["along"] || value["speed"] || value["acceleration"]) return read_point_driver(value);
    read_spin_driver(value);
}

void DriversSection::read_slide_driver(JsonValue value) {
    const Members form = file_.members(value, slide_driver_form);
    SlideDriver driver;
    driver.where = value.pointer();
    driver.joint = joints_.sliding_joint(form["joint"], {lang::drivers::a_driver_moves_a_prismatic_joint});
    if (driver.joint != none && mechanism_.joint(driver.joint).arc != none) {
        file_.fault(form["joint"], {lang::drivers::the_slot_of_is_curved_drive, quoted(form["joint"].text())});
    }
    driver.speed = form.quantity_or_default("speed");
    driver.acceleration = form.quantity_or_default("acceleration");
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_point_driver(JsonValue value) {
    const Members form = file_.members(value, point_driver_form);
    PointDriver driver;
    driver.where = value.pointer();
    if (form.is_of_another_form()) return;
    if (!form.has_or_misspells("body") && !form.has_or_misspells("at") && !form.has_or_misspells("along")) {
        file_.fault(value, {lang::drivers::what_is_driven_is_missing_joint});
        return;
    }
    if (form["body"] && !form.has_or_misspells("at") && !form.has_or_misspells("along")) return turn_instead(form);
    driver.body = file_.moving_body(form.value("body"), nothing_drives_the_frame());
    driver.at = form.point("at");
    driver.along = form.bearing_or_default("along");
    driver.speed = form.quantity_or_default("speed");
    driver.acceleration = form.quantity_or_default("acceleration");
    driver.law = law(form, {"speed", "acceleration"});
    add(std::move(driver));
}

void DriversSection::read_spin_driver(JsonValue value) {
    const Members form = file_.members(value, spin_form);
    if (form.is_of_another_form()) return;
    SpinDriver driver;
    driver.where = value.pointer();
    driver.body = file_.moving_body(form.value("body"), nothing_drives_the_frame());
    if (const JsonValue base = form["relative to"]) {
        driver.relative_to = file_.body(base);
        if (driver.relative_to > frame && driver.relative_to == driver.body)
            file_.fault(base, {lang::drivers::a_body_does_not_turn_against});
    }
    driver.omega = form.quantity_or_default("omega");
    driver.alpha = form.quantity_or_default("alpha");
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
    Law law = laws_.law_of_value(value, turning ? forms::turn_piece : forms::slide_piece);
    if (file_.fault_count() > faults) return std::nullopt;
    law.drawn = form.quantity_or_default("drawn at");
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
