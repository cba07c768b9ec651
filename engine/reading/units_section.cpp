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
namespace {

constexpr FormRow unit_row(std::string_view key, QuantityKind kind, std::string_view says = {}) {
    return FormRow(key, {}, values::unit(kind), says);
}
constexpr std::array unit_rows{
    unit_row("length", QuantityKind::length),
    unit_row("angle", QuantityKind::angle),
    unit_row("angular velocity", QuantityKind::angular_velocity),
    unit_row("velocity", QuantityKind::velocity),
    unit_row("acceleration", QuantityKind::acceleration),
    unit_row("mass", QuantityKind::mass),
    unit_row("force", QuantityKind::force),
    unit_row("moment", QuantityKind::moment),
    unit_row("inertia", QuantityKind::inertia),
    unit_row("pressure", QuantityKind::pressure, "If not set, printed in the multiple that suits."),
};

constexpr FormRow scale_row(std::string_view key, QuantityKind kind) { return FormRow(key, {}, values::scale(kind)); }
constexpr std::array scale_rows{
    scale_row("mechanism", QuantityKind::length),  scale_row("centres", QuantityKind::length),
    scale_row("velocity", QuantityKind::velocity), scale_row("acceleration", QuantityKind::acceleration),
    scale_row("body", QuantityKind::force),        scale_row("forces", QuantityKind::force),
    scale_row("closure", QuantityKind::force)};

}  // namespace

constinit const Form forms::units{lang::units::units, unit_rows};
constinit const Form forms::scales{lang::units::scales, scale_rows};

void UnitsSection::read_units(const Members& file) {
    if (const Members set = file.form("units")) {
        for (const FormRow& row : unit_rows)
            if (set[row.key]) read_unit(set[row.key], row.value.kind);
    }
    Units& all = mechanism_.units;
    const std::array<Unit*, unit_rows.size()> targets{
        &all.length, &all.angle, &all.angular_velocity, &all.velocity, &all.acceleration,
        &all.mass,   &all.force, &all.moment,           &all.inertia,  &all.pressure};
    for (std::size_t i = 0; i < unit_rows.size(); ++i) {
        const KnownUnit& unit = file_.bare_unit(unit_rows[i].value.kind);
        *targets[i] = {std::string(unit.symbol), unit.si};
    }
}

void UnitsSection::read_scales(const Members& file) {
    const Members form = file.form("scales");
    if (!form) return;
    for (const FormRow& row : scale_rows) {
        const JsonValue scale = form[row.key];
        const QuantityKind kind = row.value.kind;
        if (!scale) continue;
        auto per_millimetre =
            scale.is_string() ? read_scale(scale.text(), kind)
                              : tl::expected<Exact, Words>(tl::make_unexpected(Words(
                                    lang::units::a_scale_is_wanted_here_not, scale_example(kind), described(scale))));
        if (per_millimetre) {
            mechanism_.scales.push_back({std::string(row.key), std::move(*per_millimetre), scale.pointer()});
        } else {
            file_.fault(scale, std::move(per_millimetre.error()));
        }
    }
    // In the file's order, whatever the order of the table.
    std::unordered_map<std::string_view, std::uint32_t> order;
    for (const JsonValue member : form.object()) order.emplace(member.key(), member.order());
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
