#include "engine/mechanism/pair.hpp"

namespace kinegraph {
namespace {

using Meeting = PlanePair::Meeting;

constexpr std::array rows{
    PlanePair{
        .kind = JointKind::revolute,
        .key = "revolute",
        .called = "a revolute",
        .form = R"({"revolute": P, "bodies": [i, j]})",
        .members = {},
        .meeting = Meeting::common_point,
        .holds_normal = true,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = true,
    },
    PlanePair{
        .kind = JointKind::prismatic,
        .key = "prismatic",
        .called = "a prismatic joint",
        .form = R"({"prismatic": P, "bodies": [i, j], "along": X})",
        .members = {"along"},
        .meeting = Meeting::guide,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = true,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::pin_slot,
        .key = "pin-slot",
        .called = "a pin-slot",
        .form = R"({"pin-slot": P, "bodies": [i, j], "along": X})",
        .members = {"along", "arc"},
        .meeting = Meeting::guide,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::rolling,
        .key = "rolling",
        .called = "a rolling joint",
        .form = R"({"rolling": P, "bodies": [i, j], "profiles": {…}})",
        .members = {"profiles", "tangent"},
        .meeting = Meeting::profiles,
        .holds_normal = true,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::contact,
        .key = "contact",
        .called = "a contact",
        .form = R"({"contact": P, "bodies": [i, j], "profiles": {…}})",
        .members = {"profiles", "tangent", "pushes"},
        .meeting = Meeting::profiles,
        .holds_normal = true,
        .holds_tangent = false,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::gear,
        .key = "gear",
        .called = "a gear",
        .form = R"({"gear": P, "bodies": [i, j], "profiles": {…}, "pressure angle": a})",
        .members = {"profiles", "tangent", "pressure angle", "arm"},
        .meeting = Meeting::profiles,
        .holds_normal = false,
        .holds_tangent = true,
        .holds_rotation = false,
        .joins_many = false,
    },
    PlanePair{
        .kind = JointKind::weld,
        .key = "weld",
        .called = "a weld",
        .form = R"({"weld": P, "bodies": [i, j]})",
        .members = {},
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
