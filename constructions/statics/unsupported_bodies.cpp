#include "constructions/statics/unsupported_bodies.hpp"

#include <utility>

#include "constructions/statics/equilibria.hpp"
#include "constructions/statics/forces/hanging_groups.hpp"

namespace kinegraph::statics {
namespace {

/// The motion of the group's body, if it has exactly one freedom.
void find_freedom(const ForceModel& model, Equilibria& all, Unsupported& loose) {
    if (all.free_motions().size() != 1) return;
    for (const auto& [member, twist] : all.free_motions().front().members) {
        if (model.is_pin(member)) continue;
        loose.centre = all.centre(twist);
        if (loose.centre) return;
        loose.along = all.direction(twist);
    }
}

}  // namespace

std::vector<Unsupported> unsupported_bodies(ForceModel& model, Board& board, const Mechanism& mechanism,
                                            const Mobility& mobility) {
    std::vector<Unsupported> found;
    if (!mechanism.drivers.empty()) return found;
    for (Group& group : floating_groups(model)) {
        const bool balanced = model.known_on(group, model.loads(), {}).vanishes();
        found.push_back({std::move(group), balanced, {}, {}});
    }
    if (mobility.effective <= static_cast<int>(mechanism.efforts.size())) return found;
    Run nothing_known;
    nothing_known.reactions.resize(model.bonds().size());
    const PlaceOnDrawing origin = board.place(PointIndex(0));
    for (Group& group : single_on_frame(model)) {
        Equilibria all(model, board, nothing_known, group, origin,
                       [&](MemberIndex member) { return model.gap(member, model.loads(), nothing_known, origin); });
        if (all.exist()) continue;
        Unsupported loose{std::move(group), false, {}, {}};
        find_freedom(model, all, loose);
        found.push_back(std::move(loose));
    }
    return found;
}

}  // namespace kinegraph::statics
