#include "constructions/statics/forces/hanging_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace kinegraph::statics {
namespace {

/// Connected components of members without input forces, attached to the frame or not.
std::vector<Group> hanging_together(const ForceModel& model, bool on_frame) {
    std::vector<Group> found;
    std::set<MemberIndex> seen;
    for (const MemberIndex first : model.moving_members()) {
        if (!seen.insert(first).second) continue;
        Group group{first};
        bool by_effort = false, by_frame = false;
        for (std::size_t next = 0; next < group.size(); ++next)
            for (const int b : model.bonds_of(group[next])) {
                const Bond& bond = model.bonds()[at(b)];
                const MemberIndex other = bond.first == group[next] ? bond.second : bond.first;
                by_effort = by_effort || bond.effort >= 0;
                by_frame = by_frame || other == member_of(frame);
                if (other != member_of(frame) && seen.insert(other).second) group.push_back(other);
            }
        std::sort(group.begin(), group.end());
        if (!by_effort && by_frame == on_frame) found.push_back(std::move(group));
    }
    return found;
}

/// Whether the group is one body supported on the frame by bars.
bool is_body_on_bars(const ForceModel& model, const Group& group) {
    const auto is_loaded = [&](MemberIndex member) {
        return std::any_of(model.loads().begin(), model.loads().end(),
                           [&](const Load& load) { return load.member == member; });
    };
    // If several bars share a hinge of the frame, its pin is between bar and frame.
    const auto reaches_frame = [&](MemberIndex bar, const Bond& bond) {
        const MemberIndex other = bond.first == bar ? bond.second : bond.first;
        const std::vector<int>& held = model.bonds_of(other);
        return other == member_of(frame) || (model.is_pin(other) && std::any_of(held.begin(), held.end(), [&](int b) {
                                                 return is_on_frame(model.bonds()[at(b)]);
                                             }));
    };
    const auto is_bar = [&](MemberIndex member) {
        const std::vector<int>& held = model.bonds_of(member);
        return !model.is_pin(member) && held.size() == 2 && !is_loaded(member) &&
               std::all_of(held.begin(), held.end(),
                           [&](int b) { return model.bonds()[at(b)].kind == Bond::Kind::pin; });
    };
    const auto hangs_on_frame = [&](MemberIndex bar) {
        const std::vector<int>& held = model.bonds_of(bar);
        return std::any_of(held.begin(), held.end(), [&](int b) { return reaches_frame(bar, model.bonds()[at(b)]); });
    };
    std::ptrdiff_t bars = 0, bodies = 0;
    for (const MemberIndex member : group) {
        if (is_bar(member) && !hangs_on_frame(member)) return false;
        bars += is_bar(member) ? 1 : 0;
        bodies += !model.is_pin(member) && !is_bar(member) ? 1 : 0;
    }
    // Pins shared by bars are not bodies, and loads on a pin do not act on the body. If there is no body, one pin is
    // what the bars support.
    const bool pin_loaded = std::any_of(group.begin(), group.end(),
                                        [&](MemberIndex member) { return model.is_pin(member) && is_loaded(member); });
    return (bodies == 1 && !pin_loaded) || (bodies == 0 && bars + 1 == static_cast<std::ptrdiff_t>(group.size()));
}

}  // namespace

std::vector<Group> floating_groups(const ForceModel& model) { return hanging_together(model, false); }

std::vector<Group> hung_on_frame(const ForceModel& model) {
    std::vector<Group> found = hanging_together(model, true);
    std::erase_if(found, [&](const Group& group) { return group.size() == 1 || is_body_on_bars(model, group); });
    return found;
}

std::vector<Group> single_on_frame(const ForceModel& model) {
    std::vector<Group> found = hanging_together(model, true);
    std::erase_if(found, [&](const Group& group) {
        return std::count_if(group.begin(), group.end(), [&](MemberIndex member) { return !model.is_pin(member); }) !=
               1;
    });
    return found;
}

}  // namespace kinegraph::statics
