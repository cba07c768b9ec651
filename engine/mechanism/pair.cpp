#include "engine/mechanism/pair.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph {
namespace {

using Meeting = PlanePair::Meeting;

constexpr std::array rows{
    PlanePair{
        .kind = JointKind::revolute,
        .key = "revolute",
        .texts = {lang::sheet::pair_revolute, lang::sheet::reaction_revolute, lang::sheet::fixed_revolute,
                  lang::sheet::centre_revolute, lang::sheet::found_revolute, lang::sheet::freedoms_revolute},
        .form = R"({"revolute": P, "bodies": [i, j]})",
        .meeting = Meeting::common_point,
        .holds_normal = true,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = true,
    },
    PlanePair{
        .kind = JointKind::prismatic,
        .key = "prismatic",
        .texts = {lang::sheet::pair_prismatic, lang::sheet::reaction_prismatic, lang::sheet::fixed_prismatic,
                  lang::sheet::centre_prismatic, lang::sheet::found_prismatic, lang::sheet::freedoms_prismatic},
        .form = R"({"prismatic": P, "bodies": [i, j], "along": X})",
        .meeting = Meeting::guide,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = true,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::pin_slot,
        .key = "pin-slot",
        .texts = {lang::sheet::pair_pin_slot, lang::sheet::reaction_pin_slot, lang::sheet::fixed_pin_slot,
                  lang::sheet::centre_pin_slot, lang::sheet::found_pin_slot, lang::sheet::freedoms_pin_slot},
        .form = R"({"pin-slot": P, "bodies": [i, j], "along": X})",
        .meeting = Meeting::guide,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::rolling,
        .key = "rolling",
        .texts = {lang::sheet::pair_rolling, lang::sheet::reaction_rolling, lang::sheet::fixed_rolling,
                  lang::sheet::centre_rolling, lang::sheet::found_rolling, lang::sheet::freedoms_rolling},
        .form = R"({"rolling": P, "bodies": [i, j], "profiles": {…}})",
        .meeting = Meeting::profiles,
        .holds_normal = true,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::contact,
        .key = "contact",
        .texts = {lang::sheet::pair_contact, lang::sheet::reaction_contact, lang::sheet::fixed_contact,
                  lang::sheet::centre_contact, lang::sheet::found_contact, lang::sheet::freedoms_contact},
        .form = R"({"contact": P, "bodies": [i, j], "profiles": {…}})",
        .meeting = Meeting::profiles,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::gear,
        .key = "gear",
        .texts = {lang::sheet::pair_gear, lang::sheet::reaction_gear, lang::sheet::fixed_gear, lang::sheet::centre_gear,
                  lang::sheet::found_gear, lang::sheet::freedoms_gear},
        .form = R"({"gear": P, "bodies": [i, j], "profiles": {…}, "pressure angle": a})",
        .meeting = Meeting::profiles,
        .holds_normal = false,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::weld,
        .key = "weld",
        .texts = {lang::sheet::pair_weld, lang::sheet::reaction_weld, lang::sheet::fixed_weld, lang::sheet::centre_weld,
                  lang::sheet::found_weld},
        .form = R"({"weld": P, "bodies": [i, j]})",
        .meeting = Meeting::common_point,
        .holds_normal = true,
        .holds_tangent = true,
        .holds_rotation = true,
        .joins_many = false,
    },
};

constexpr bool kinds_are_in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].kind != static_cast<JointKind>(i)) return false;
    return true;
}
static_assert(kinds_are_in_order(), "a row is looked up by its kind");

}  // namespace

constinit const std::array<PlanePair, rows.size()> plane_pairs = rows;

}  // namespace kinegraph
