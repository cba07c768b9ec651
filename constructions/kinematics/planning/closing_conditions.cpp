#include "constructions/kinematics/planning/closing_conditions.hpp"

#include <utility>
#include <variant>

namespace kinegraph::planning {

std::optional<Closing> ClosingConditions::moved_condition(std::size_t assumed) {
    std::size_t steps = known_.plan().steps.size();
    Track<Plane::velocity> moved = draw_response(structure_, board_, known_.plan(), assumed);
    std::vector<Closing> all = conditions(moved);
    // The search may have added known places that the response does not contain yet.
    while (known_.plan().steps.size() > steps) {
        steps = known_.plan().steps.size();
        moved = draw_response(structure_, board_, known_.plan(), assumed);
        all = conditions(moved);
    }
    std::optional<Closing> first;
    for (const Closing& condition : all) {
        if (!is_broken(structure_, board_, moved, condition)) continue;
        const bool line_at_rest =
            condition.locus &&
            (condition.locus->base == none ||
             board_.is_zero(board_.vector(board_.pole<Plane::velocity>(), moved.tip(condition.locus->base))));
        if (line_at_rest) return condition;
        if (!first) first = condition;
    }
    return first;
}

std::optional<Closing> ClosingConditions::moved_condition_at(JointIndex index, std::size_t assumed) {
    const Joint& joint = mechanism_.joints[at(index)];
    if (joint.bodies.size() != 2 || !known_.body_known(joint.bodies[0]) || !known_.body_known(joint.bodies[1]))
        return std::nullopt;
    const KnownMotion::State before = known_.state();
    const std::size_t steps = known_.plan().steps.size();
    if (see_places_of(index) && known_.plan().steps.size() > steps) {
        if (auto closing = moved_condition(assumed)) return closing;
    }
    known_.restore(before);
    return std::nullopt;
}

bool ClosingConditions::see_places_of(JointIndex index) {
    const Joint& joint = mechanism_.joints[at(index)];
    const BodyIndex body = joint.bodies[0];
    if (joint.pair().is_sleeve() || joint.pair().rolls())
        return known_.known_on(joint.point, body) != none && known_.known_on(joint.point, joint.bodies[1]) != none;
    for (const Passage& passage : structure_.passages_of(body)) {
        if (passage.joint == index)
            return known_.known_on(passage.own, body) != none && known_.known_on(passage.others, passage.other) != none;
    }
    return false;
}

std::vector<Closing> ClosingConditions::conditions(const Track<Plane::velocity>& moved) {
    std::vector<Closing> found;
    for (const BodyIndex body : mechanism_.moving_bodies()) {
        add_rigidity(body, moved, found);
        if (moved.turns(body)) add_equal_spins(body, moved, found);
    }
    loci_.look_at_carried_places_alone(true);
    for (const NodeIndex node : indices_of(structure_.nodes())) {
        if (!moved.has(node) || structure_.node(node).bodies.front() == frame) continue;
        std::vector<Locus> loci;
        loci_.own_loci(node, none, loci);
        for (Locus& locus : loci) {
            if (locus.kind == Locus::Kind::rotation || (locus.base != none && !moved.has(locus.base))) continue;
            Closing condition;
            condition.locus = std::move(locus);
            found.push_back(std::move(condition));
        }
    }
    add_driven_slides(moved, found);
    add_rollings(moved, found);
    return found;
}

void ClosingConditions::add_rigidity(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
    NodeIndex base = none;
    const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
    for (const NodeIndex node : nodes) {
        if (!moved.has(node)) continue;
        if (base == none) {
            base = node;
            continue;
        }
        if (!known_.apart(base, node)) continue;
        Locus locus = loci_.rotation(body, base, node);
        Closing projections;
        projections.locus = locus;
        found.push_back(projections);
        if (!moved.turns(body)) continue;
        locus.kind = Locus::Kind::image;
        Closing image;
        image.locus = locus;
        found.push_back(image);
    }
}

void ClosingConditions::add_rollings(const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
    for (const BodyIndex body : mechanism_.moving_bodies()) {
        for (const Rolling& rolling : structure_.rollings_of(body)) {
            Locus locus;
            locus.kind = Locus::Kind::roll;
            locus.body = body;
            locus.joint = rolling.joint;
            locus.node = structure_.find(rolling.point, body);
            locus.base = structure_.find(rolling.point, rolling.other);
            if (rolling.other > body || locus.node == none || locus.base == none || locus.node == locus.base) continue;
            if (!moved.has(locus.node) || !moved.has(locus.base)) continue;
            for (const bool across : {false, true}) {
                locus.across = across;
                Closing condition;
                condition.locus = locus;
                found.push_back(std::move(condition));
            }
        }
    }
}

void ClosingConditions::add_driven_slides(const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
    for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
        const auto* slide = std::get_if<SlideDriver>(&mechanism_.drivers[d]);
        if (slide == nullptr || !use_driver_[d]) continue;
        const Joint& joint = mechanism_.joints[at(slide->joint)];
        Locus locus;
        locus.kind = Locus::Kind::driven_slide;
        locus.node = structure_.find(joint.point, joint.bodies[0]);
        locus.base = structure_.find(joint.point, joint.bodies[1]);
        if (locus.node == none || locus.base == none || !moved.has(locus.node) || !moved.has(locus.base)) continue;
        locus.body = joint.bodies[0];
        locus.joint = slide->joint;
        locus.guide = joint.bodies[1];
        locus.driver = static_cast<int>(d);
        Closing condition;
        condition.locus = locus;
        found.push_back(condition);
    }
}

void ClosingConditions::add_equal_spins(BodyIndex body, const Track<Plane::velocity>& moved,
                                        std::vector<Closing>& found) {
    Closing condition;
    condition.body = body;
    for (const auto& [other, joint] : structure_.same_spin(body)) {
        if (other > body || !moved.turns(other)) continue;
        condition.other = other;
        condition.joint = joint;
        found.push_back(condition);
    }
    condition.joint = none;
    for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
        const auto* spin = std::get_if<SpinDriver>(&mechanism_.drivers[d]);
        if (spin == nullptr || !use_driver_[d] || spin->body != body || !moved.turns(spin->relative_to)) continue;
        condition.other = spin->relative_to;
        condition.driver = static_cast<int>(d);
        found.push_back(condition);
    }
}

}  // namespace kinegraph::planning
