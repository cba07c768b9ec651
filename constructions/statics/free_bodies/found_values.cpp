#include "constructions/statics/free_bodies/found_values.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace kinegraph::statics {

void FoundValues::collect_bond(const Bond& bond, const Reaction& reaction, bool valid) {
    if (bond.effort >= 0) {
        EffortValue result;
        result.name = std::visit([](const auto& effort) { return effort.name; }, mechanism_.efforts[at(bond.effort)]);
        if (valid && reaction.known) {
            if (bond.kind == Bond::Kind::couple) {
                result.value = recorded(reaction.couple);
            } else if (reaction.force) {
                // The direction is a unit vector.
                const Force unit = board_.scale<Plane::force>(board_.number(1), bond.direction);
                result.value = Recorded<Exact>::at(board_.ratio(*reaction.force, unit).element);
            } else {
                result.value = Recorded<Exact>::zero();
            }
        }
        results_.efforts.push_back(std::move(result));
        return;
    }
    JointForce on_first;
    on_first.joint = bond.joint;
    on_first.on = model_.body_of(bond.first);
    on_first.from = model_.body_of(bond.second);
    if (valid && reaction.known) {
        on_first.force = recorded(reaction.force);
        on_first.couple = recorded(reaction.couple);
    } else if (valid) {
        if (reaction.alike == Reaction::Alike::force) on_first.force = recorded(reaction.force);
        if (reaction.alike == Reaction::Alike::component) {
            on_first.component = recorded(reaction.force);
            on_first.along = Recorded<Vector>::at(reaction.along->element);
        }
        const bool bears_none = bond.kind != Bond::Kind::guide && bond.kind != Bond::Kind::clamp;
        if (reaction.couple_alike || (bears_none && reaction.alike != Reaction::Alike::nothing))
            on_first.couple = recorded(reaction.couple);
    }
    results_.joints.push_back(on_first);
    if (model_.is_pin(bond.second)) return;
    JointForce on_second = on_first;
    std::swap(on_second.on, on_second.from);
    if (on_second.force && reaction.force) on_second.force = recorded(board_.negate(*reaction.force));
    if (on_second.component && reaction.force) on_second.component = recorded(board_.negate(*reaction.force));
    if (on_second.couple && reaction.couple) on_second.couple = recorded(board_.opposite(*reaction.couple));
    results_.joints.push_back(on_second);
}

void FoundValues::virtual_motion(const VirtualMotion& drawn) {
    kinegraph::VirtualMotion motion;
    motion.statement = drawn.statement;
    motion.sought = drawn.sought;
    if (drawn.along)
        motion.force = recorded(drawn.force);
    else
        motion.couple = recorded(drawn.couple);
    for (const VirtualMotion::Turning& turning : drawn.members) {
        if (model_.is_pin(turning.member)) continue;
        motion.bodies.push_back({model_.body_of(turning.member), {}});
        if (turning.omega) motion.bodies.back().omega = Recorded<Exact>::at(turning.omega->element);
        if (turning.centre) take_moments(drawn, turning);
    }
    results_.virtual_motions.push_back(std::move(motion));
}

void FoundValues::take_moments(const VirtualMotion& drawn, const VirtualMotion::Turning& turning) {
    const auto free = std::find_if(results_.bodies.begin(), results_.bodies.end(),
                                   [&](const FreeBody& each) { return each.body == model_.body_of(turning.member); });
    if (free == results_.bodies.end()) return;
    const auto add = [&](Force force, PlaceOnDrawing place, bool is_sought) {
        if (board_.on_line(*turning.centre, board_.through(place, board_.direction(force)))) return;
        FreeBody::Arm arm = constructions_.arm_about(*turning.centre, force, place, drawn.statement, is_sought);
        arm.name = turning.name;
        free->arms.push_back(std::move(arm));
    };
    for (const Load& load : model_.loads())
        if (load.member == turning.member && load.force) add(*load.force, load.place, false);
    for (const VirtualMotion::Known& known : drawn.known)
        if (known.member == turning.member) add(known.force, known.place, false);
    const Bond& bond = model_.bonds()[at(drawn.bond)];
    const bool bears = bond.first == turning.member || bond.second == turning.member;
    if (bears && drawn.along && drawn.force)
        add(board_.scale<Plane::force>(board_.number(1), *drawn.along), bond.place, true);
}

}  // namespace kinegraph::statics
