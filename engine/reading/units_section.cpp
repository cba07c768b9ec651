#include "engine/reading/sections.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "engine/file/scale_text.hpp"
#include "engine/file/units.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/units.hpp"

namespace kinegraph {

void UnitsSection::read_units(JsonValue units) {
    constexpr std::array kinds{
        std::pair{std::string_view("length"), QuantityKind::length},
        std::pair{std::string_view("angle"), QuantityKind::angle},
        std::pair{std::string_view("angular velocity"), QuantityKind::angular_velocity},
        std::pair{std::string_view("velocity"), QuantityKind::velocity},
        std::pair{std::string_view("acceleration"), QuantityKind::acceleration},
        std::pair{std::string_view("mass"), QuantityKind::mass},
        std::pair{std::string_view("force"), QuantityKind::force},
        std::pair{std::string_view("moment"), QuantityKind::moment},
        std::pair{std::string_view("inertia"), QuantityKind::inertia},
        std::pair{std::string_view("pressure"), QuantityKind::pressure},
    };
    if (units && file_.expect(units, Kind::object, {lang::units::an_object_of_units_by_quantity})) {
        const Members set = file_.members(units,
                                          {"length", "angle", "angular velocity", "velocity", "acceleration", "mass",
                                           "force", "moment", "inertia", "pressure"},
                                          {lang::units::units});
        for (const auto& [key, kind] : kinds) {
            if (set[key]) read_unit(set[key], kind);
        }
    }
    Units& all = mechanism_.units;
    const std::array<Unit*, kinds.size()> targets{
        &all.length, &all.angle, &all.angular_velocity, &all.velocity, &all.acceleration,
        &all.mass,   &all.force, &all.moment,           &all.inertia,  &all.pressure};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const KnownUnit& unit = file_.bare_unit(kinds[i].second);
        *targets[i] = {std::string(unit.symbol), unit.si};
    }
}

void UnitsSection::read_scales(JsonValue value) {
    if (!value || !file_.expect(value, Kind::object, {lang::units::an_object_of_scales_by_figure})) return;
    constexpr std::array figures{
        std::pair{std::string_view("mechanism"), QuantityKind::length},
        std::pair{std::string_view("centres"), QuantityKind::length},
        std::pair{std::string_view("velocity"), QuantityKind::velocity},
        std::pair{std::string_view("acceleration"), QuantityKind::acceleration},
        std::pair{std::string_view("body"), QuantityKind::force},
        std::pair{std::string_view("forces"), QuantityKind::force},
        std::pair{std::string_view("closure"), QuantityKind::force},
    };
    const Members form =
        file_.members(value, {"mechanism", "centres", "velocity", "acceleration", "body", "forces", "closure"},
                      {lang::units::scales});
    for (const auto& [figure, kind] : figures) {
        const JsonValue scale = form[figure];
        if (!scale) continue;
        auto per_millimetre =
            scale.is_string() ? read_scale(scale.text(), kind)
                              : tl::expected<Exact, Words>(tl::make_unexpected(Words(
                                    lang::units::a_scale_is_wanted_here_not, scale_example(kind), described(scale))));
        if (per_millimetre) {
            mechanism_.scales.push_back({std::string(figure), std::move(*per_millimetre), scale.pointer()});
        } else {
            file_.fault(scale, std::move(per_millimetre.error()));
        }
    }
    // In the file's order, whatever the order of the table.
    std::unordered_map<std::string_view, std::uint32_t> order;
    for (const JsonValue member : value) order.emplace(member.key(), member.order());
    std::sort(mechanism_.scales.begin(), mechanism_.scales.end(),
              [&](const AskedScale& a, const AskedScale& b) { return order.at(a.figure) < order.at(b.figure); });
}

void UnitsSection::read_unit(JsonValue value, QuantityKind kind) {
    if (!file_.expect(value, Kind::string, {lang::common::a_unit})) return;
    const KnownUnit* unit = unit_spelt(value.text());
    if (unit == nullptr) {
        file_.fault(value, unknown_unit_message(value.text(), kind));
    } else if (unit->kind != kind) {
        file_.fault(value, {lang::units::is_a_unit_of_the_units, quoted(value.text()), name_of(unit->kind),
                            name_of(kind), units_of(kind)});
    } else {
        file_.measure_bare_numbers_in(*unit);
    }
}

}  // namespace kinegraph
