#include "engine/sentences/result_catalogue.hpp"

#include <array>
#include <cstddef>
#include <variant>

#include "engine/number/assert.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;
using Subject = ResultKind::Subject;
using Shape = ResultKind::Shape;
using In = QuantityKind;
using Scale = ResultKind::Scale;
using Letter = Symbol::Letter;

constexpr std::array rows{
    ResultKind{Kind::unnamed, Subject::nothing, Shape::scalar, In::dimensionless, Scale::own, Letter::point, ""},
    ResultKind{Kind::velocity, Subject::point, Shape::vector, In::velocity, Scale::unit, Letter::v, "velocity", "",
               "velocity", "v"},
    ResultKind{Kind::acceleration, Subject::point, Shape::vector, In::acceleration, Scale::unit, Letter::a,
               "acceleration", "", "acceleration", "a"},
    ResultKind{Kind::omega, Subject::body, Shape::scalar, In::angular_velocity, Scale::unit, Letter::omega, "omega", "",
               "bodies/*/omega", "omega"},
    ResultKind{Kind::alpha, Subject::body, Shape::scalar, In::angular_acceleration, Scale::unit, Letter::alpha, "alpha",
               "", "bodies/*/alpha", "alpha"},
    ResultKind{Kind::centre, Subject::two_bodies, Shape::place, In::length, Scale::unit, Letter::centre, "centre", "",
               "at", "", true, "", lang::sheet::asked_centre},
    ResultKind{Kind::sliding_velocity, Subject::joint, Shape::along, In::velocity, Scale::unit, Letter::v, "sliding",
               " velocity", "sliding/*/velocity", "v"},
    ResultKind{Kind::sliding_acceleration, Subject::joint, Shape::along, In::acceleration, Scale::unit, Letter::a,
               "sliding", " acceleration", "sliding/*/acceleration", "a"},
    ResultKind{Kind::sliding_coriolis, Subject::joint, Shape::vector, In::acceleration, Scale::unit, Letter::a,
               "sliding", " coriolis", "sliding/*/coriolis"},
    ResultKind{Kind::force, Subject::action, Shape::vector, In::force, Scale::unit, Letter::F, "force", "", "force",
               "F"},
    ResultKind{Kind::couple, Subject::action, Shape::scalar, In::moment, Scale::unit, Letter::M, "force", " couple",
               "couple", "C"},
    ResultKind{Kind::force_component, Subject::component, Shape::scalar, In::force, Scale::unit, Letter::F, "force",
               " component", "", "component", true, "F", lang::sheet::asked_component},
    ResultKind{Kind::load, Subject::load, Shape::vector, In::force, Scale::given, Letter::F, "load"},
    ResultKind{Kind::weight, Subject::mass, Shape::vector, In::force, Scale::given, Letter::F, "weight"},
    ResultKind{Kind::inertia, Subject::mass, Shape::vector, In::force, Scale::given, Letter::F, "inertia"},
    ResultKind{Kind::effort, Subject::effort, Shape::scalar, In::force, Scale::efforts, Letter::F, "effort", "",
               "effort/*", "effort"},
    ResultKind{Kind::radius, Subject::path, Shape::scalar, In::length, Scale::unit, Letter::radius, "radius", "", "",
               "radius", true, "ρ", lang::sheet::asked_radius},
    ResultKind{Kind::inflection_diameter, Subject::body, Shape::scalar, In::length, Scale::unit, Letter::diameter,
               "inflection circle", "", "", "inflection circle", true, "δ", lang::sheet::asked_inflection_circle},
    ResultKind{Kind::acceleration_pole, Subject::body, Shape::place, In::length, Scale::unit, Letter::centre,
               "acceleration pole", "", "", "acceleration pole", true, "", lang::sheet::asked_acceleration_pole},
    ResultKind{Kind::virtual_power, Subject::nothing, Shape::scalar, In::power, Scale::given, Letter::point,
               "virtual power"},
    ResultKind{Kind::virtual_effort, Subject::effort, Shape::scalar, In::force, Scale::efforts, Letter::F, "effort",
               " by virtual work"},
    ResultKind{Kind::resultant, Subject::body, Shape::vector, In::force, Scale::given, Letter::F, "resultant", "", "",
               "resultant", true, "R", lang::sheet::asked_resultant},
    ResultKind{Kind::resultant_couple, Subject::body, Shape::scalar, In::moment, Scale::given, Letter::M, "resultant",
               " couple", "", "resultant couple", true, "M", lang::sheet::asked_resultant_couple},
    ResultKind{Kind::bar, Subject::bar, Shape::scalar, In::force, Scale::given, Letter::F, "bar", "", "bars/*", "bar",
               true, "F"},
    ResultKind{Kind::power_of_load, Subject::load, Shape::scalar, In::power, Scale::given, Letter::point, "power", "",
               "power/loads/*", "power", true, "P", lang::sheet::asked_power},
    ResultKind{Kind::power_of_weight, Subject::mass, Shape::scalar, In::power, Scale::given, Letter::point,
               "power weight", "", "power/weights/*", "power weight", true, "P", lang::sheet::asked_power_of_weight},
    ResultKind{Kind::power_of_inertia, Subject::mass, Shape::scalar, In::power, Scale::given, Letter::point,
               "power inertia", "", "power/inertia forces/*", "power inertia", true, "P",
               lang::sheet::asked_power_of_inertia},
    ResultKind{Kind::power_of_effort, Subject::effort, Shape::scalar, In::power, Scale::efforts, Letter::point, "power",
               "", "power/effort/*", "power", true, "P", lang::sheet::asked_power},
    ResultKind{Kind::transmission_angle, Subject::coupler, Shape::scalar, In::angle, Scale::given, Letter::point,
               "transmission angle", "", "transmission angles/*", "transmission angle", true, "γ",
               lang::sheet::asked_transmission_here},
    ResultKind{Kind::cut_moment, Subject::bar, Shape::scalar, In::moment, Scale::given, Letter::M, "cut", " moment"},
    ResultKind{Kind::cut_arm, Subject::bar, Shape::scalar, In::length, Scale::given, Letter::point, "cut", " arm"},
    ResultKind{Kind::cut_across, Subject::bar, Shape::scalar, In::force, Scale::given, Letter::F, "cut", " across"},
    ResultKind{Kind::cut_sine, Subject::bar, Shape::scalar, In::dimensionless, Scale::given, Letter::point, "cut",
               " sine"},
};

constexpr bool are_in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].kind != static_cast<Kind>(i)) return false;
    return true;
}
static_assert(are_in_order() && rows.size() == static_cast<std::size_t>(Kind::cut_sine) + 1);

using Reading = Tolerance::Reading;

constexpr std::array tolerances{
    Tolerance{Reading::calculated, In::dimensionless},
    Tolerance{Reading::in_scale, In::length},
    Tolerance{Reading::protractor, In::angle},
    Tolerance{Reading::calculated, In::velocity, -1},      // angular velocity
    Tolerance{Reading::calculated, In::acceleration, -1},  // angular acceleration
    Tolerance{Reading::in_scale, In::velocity},
    Tolerance{Reading::in_scale, In::acceleration},
    Tolerance{Reading::calculated, In::mass},
    Tolerance{Reading::in_scale, In::force},
    Tolerance{Reading::calculated, In::force, 1},  // moment
    Tolerance{Reading::calculated, In::inertia},
    Tolerance{Reading::calculated, In::pressure},
    Tolerance{Reading::calculated, In::time},
    Tolerance{Reading::calculated, In::area},
    Tolerance{Reading::calculated, In::force_per_length},
    Tolerance{Reading::calculated, In::torsional_stiffness},
    Tolerance{Reading::calculated, In::power},
    Tolerance{Reading::calculated, In::wear},
};
static_assert(tolerances.size() == count_of_quantity_kinds);

constexpr bool own_scales_stand_in_order() {
    for (std::size_t i = 0; i < tolerances.size(); ++i)
        if (tolerances[i].lengths == 0 && tolerances[i].scale != static_cast<In>(i)) return false;
    return true;
}
static_assert(own_scales_stand_in_order());

bool acts_as_couple(const Load& load) {
    return std::holds_alternative<CoupleLoad>(load) || std::holds_alternative<TorsionLoad>(load);
}

}  // namespace

const ResultKind& result_kind(Quantity::Kind kind) { return rows.at(static_cast<std::size_t>(kind)); }

const Tolerance& tolerance_of(QuantityKind unit) { return tolerances.at(static_cast<std::size_t>(unit)); }

std::span<const ResultKind> result_kinds() { return rows; }

QuantityKind unit_kind_of(const Quantity& quantity, const Mechanism& mechanism) {
    const ResultKind& row = result_kind(quantity);
    const bool is_couple = (quantity.kind == Kind::load && acts_as_couple(mechanism.loads[at_index(quantity.given)])) ||
                           (row.unit == QuantityKind::force && row.subject == Subject::effort &&
                            std::holds_alternative<CoupleEffort>(mechanism.efforts[at_index(quantity.given)]));
    return is_couple ? QuantityKind::moment : row.unit;
}

Unit unit_of(QuantityKind kind, const Units& units) {
    switch (kind) {
        case QuantityKind::length: return units.length;
        case QuantityKind::angle: return units.angle;
        case QuantityKind::angular_velocity: return units.angular_velocity;
        case QuantityKind::velocity: return units.velocity;
        case QuantityKind::acceleration: return units.acceleration;
        case QuantityKind::mass: return units.mass;
        case QuantityKind::force: return units.force;
        case QuantityKind::moment: return units.moment;
        case QuantityKind::inertia: return units.inertia;
        case QuantityKind::pressure: return units.pressure;
        case QuantityKind::dimensionless: return {"", 1};
        case QuantityKind::angular_acceleration:
        case QuantityKind::time:
        case QuantityKind::power:
        case QuantityKind::wear:
        case QuantityKind::area:
        case QuantityKind::force_per_length:
        case QuantityKind::torsional_stiffness: break;
    }
    const KnownUnit& si = default_unit(kind);
    return {std::string(si.symbol), si.si};
}

Quantity omega_of(BodyIndex body) { return {.kind = Kind::omega, .body = body}; }
Quantity alpha_of(BodyIndex body) { return {.kind = Kind::alpha, .body = body}; }
Quantity turning_of(BodyIndex body, Symbol::Letter letter) {
    KG_ASSERT(letter == Letter::omega || letter == Letter::alpha, "a body turns with omega and alpha");
    return letter == Letter::omega ? omega_of(body) : alpha_of(body);
}

}  // namespace kinegraph
