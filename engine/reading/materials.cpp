#include "lang/keys/materials.hpp"
#include "engine/reading/materials.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace kinegraph {
namespace {

/// Young's modulus (Pa) and Poisson's ratio of a material known by name. Shigley, Mechanical Engineering Design, table
/// A–5; nylon: Ashby, Materials Selection in Mechanical Design, appendix A.
struct Material {
    std::string_view name;
    double young = 0;
    const char* poisson = "0";
};

constexpr std::array materials{
    Material{"steel", 207e9, "0.292"},     Material{"stainless steel", 190e9, "0.305"},
    Material{"cast iron", 100e9, "0.211"}, Material{"bronze", 111e9, "0.349"},
    Material{"brass", 106e9, "0.324"},     Material{"aluminium", 71.7e9, "0.333"},
    Material{"titanium", 114e9, "0.34"},   Material{"glass", 46.2e9, "0.245"},
    Material{"nylon", 2.9e9, "0.35"},
};

constexpr std::array material_names = [] {
    std::array<std::string_view, materials.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = materials[i].name;
    return names;
}();

}  // namespace

constinit const FormValue forms::material_name = values::word(material_names);

void Materials::read(const Members& form, ElasticBody& body) {
    body.young = 1;
    if (const JsonValue name = form["material"]) {
        for (const std::string_view key : {"young", "poisson"})
            if (form[key]) file_.not_together(form[key], "material");
        return read_by_name(name, body);
    }
    file_.required(form, "young", {lang::materials::young_modulus_or_give_a_material});
    body.young = form.quantity_or_default("young");
    const JsonValue ratio = file_.required(form, "poisson", {lang::materials::poisson_ratio_or_give_a_material});
    body.poisson = form.number("poisson").value_or(Exact());
    if (ratio && (body.poisson.sign() < 0 || body.poisson >= Exact::ratio(1, 2)))
        file_.fault(ratio, {lang::materials::poisson_ratio_must_lie_from_0});
}

void Materials::read_by_name(JsonValue name, ElasticBody& body) {
    const auto* found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name.text(); });
    if (!name.is_string() || found == materials.end()) {
        file_.fault(name, {lang::materials::no_material_is_known_as_known, quoted(name.text()),
                           did_you_mean(file_.speller().nearest(name.text(), material_names)), listed(material_names)});
        return;
    }
    body.young = Exact::from_double(found->young);
    body.poisson = *Exact::from_decimal(found->poisson);
}

}  // namespace kinegraph
