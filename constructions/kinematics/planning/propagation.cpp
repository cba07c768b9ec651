#include "constructions/kinematics/planning/propagation.hpp"

#include <cstddef>
#include <variant>

namespace kinegraph::planning {

void Propagation::propagate() {
    while (learn_spins() || learn_bodies() || learn_rolling_points()) {
    }
}

bool Propagation::slide_by_driver() {
    for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
        const auto* slide = std::get_if<SlideDriver>(&mechanism_.drivers[d]);
        if (slide == nullptr || !use_driver_[d]) continue;
        const Joint& joint = mechanism_.joints[at(slide->joint)];
        for (const bool inverse : {false, true}) {
            const BodyIndex body = joint.bodies[inverse ? 1 : 0], other = joint.bodies[inverse ? 0 : 1];
            if (known_.body_known(body)) continue;
            NodeIndex base = known_.known_on(joint.point, other);
            if (base == none &&
                joint.pair().holds_rotation) {  // any known place of the other body suffices: no relative rotation
                base = known_.base_of(other, none);
            }
            if (base == none || structure_.node(base).point == none) continue;
            const NodeIndex node = structure_.on(structure_.node(base).point, body);
            known_.sync();
            if (known_.known(node)) continue;
            Step step;
            step.kind = Step::Kind::slide_by_driver;
            step.body = body;
            step.other = other;
            step.joint = slide->joint;
            step.driver = static_cast<int>(d);
            step.inverse = inverse;
            step.node = node;
            step.base = base;
            known_.add_step(step);
            known_.plan().nodes[at(node)] = true;
            return true;
        }
    }
    return false;
}

void Propagation::add_places_of_higher_pairs() {
    for (const BodyIndex body : indices_of(mechanism_.bodies)) {
        for (const Rolling& rolling : structure_.rollings_of(body)) structure_.on(rolling.point, body);
        for (const Passage& passage : structure_.passages_of(body)) {
            if (mechanism_.joints[at(passage.joint)].pair().touches()) structure_.on(passage.own, body);
        }
    }
}

bool Propagation::learn_spins() {
    bool learnt = false;
    for (const BodyIndex body : indices_of(mechanism_.bodies)) {
        if (!known_.spin_known(body)) continue;
        for (const auto& [other, joint] : structure_.same_spin(body)) {
            if (known_.spin_known(other)) continue;
            Step step;
            step.kind = Step::Kind::spin_by_joint;
            step.body = other;
            step.other = body;
            step.joint = joint;
            known_.add_step(step);
            known_.plan().spins[at(other)] = learnt = true;
        }
    }
    for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
        const auto* spin = std::get_if<SpinDriver>(&mechanism_.drivers[d]);
        if (spin == nullptr || !use_driver_[d] || known_.spin_known(spin->body) == known_.spin_known(spin->relative_to))
            continue;
        Step step;
        step.kind = Step::Kind::spin_by_driver;
        step.inverse = known_.spin_known(spin->body);
        step.body = step.inverse ? spin->relative_to : spin->body;
        step.other = step.inverse ? spin->body : spin->relative_to;
        step.driver = static_cast<int>(d);
        known_.add_step(step);
        known_.plan().spins[at(step.body)] = learnt = true;
    }
    return learnt;
}

bool Propagation::learn_bodies() {
    bool learnt = false;
    for (const BodyIndex body : indices_of(mechanism_.bodies)) {
        if (known_.body_known(body)) continue;
        const NodeIndex base = known_.base_of(body, none);
        if (base == none) continue;
        if (!known_.spin_known(body)) {
            NodeIndex second = none;
            for (const NodeIndex node : structure_.nodes_of(body)) {
                if (node != base && known_.known(node) && known_.apart(base, node)) {
                    second = node;
                    break;
                }
            }
            if (second == none) continue;
            Step step;
            step.kind = Step::Kind::spin_from_pair;
            step.body = body;
            step.base = base;
            step.node = second;
            known_.add_step(step);
            known_.plan().spins[at(body)] = true;
        }
        known_.learn_body(body);
        learnt = true;
    }
    return learnt;
}

bool Propagation::learn_rolling_points() {
    bool learnt = false;
    for (const BodyIndex body : indices_of(mechanism_.bodies)) {
        if (known_.body_known(body)) continue;
        for (const Rolling& rolling : structure_.rollings_of(body)) {
            const NodeIndex node = structure_.on(rolling.point, body);
            if (known_.known(node)) continue;
            const NodeIndex base = known_.known_on(rolling.point, rolling.other);
            if (base == none || base == node) continue;
            Step step;
            step.kind = Step::Kind::roll;
            step.body = body;
            step.other = rolling.other;
            step.joint = rolling.joint;
            step.node = node;
            step.base = base;
            known_.add_step(step);
            known_.plan().nodes[at(node)] = learnt = true;
        }
    }
    return learnt;
}

}  // namespace kinegraph::planning
