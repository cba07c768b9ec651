#include "constructions/kinematics/planning/meets.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kinegraph::planning {

std::vector<NodeIndex> Meets::candidates() {
    // Books use A* of the guide under the slider's pin; the slider's place under the guide's pin is also tried.
    for (const bool on_guide : {true, false}) {
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            if (!known_.body_known(body)) add_places_of_slides(body, on_guide);
        }
    }
    known_.sync();
    std::vector<NodeIndex> order;
    for (const NodeIndex node : indices_of(structure_.nodes())) {
        const auto& bodies_there = structure_.node(node).bodies;
        // On a body with known motion every place is known already.
        const bool is_there = std::any_of(bodies_there.begin(), bodies_there.end(),
                                          [&](BodyIndex body) { return known_.body_known(body); });
        if (!known_.known(node) && !is_there) order.push_back(node);
    }
    return order;
}

bool Meets::meet_some_node() {
    for (const bool thrifty : {true, false}) {
        loci_.look_at_carried_places_alone(thrifty);
        const std::vector<NodeIndex> nodes = candidates();
        if (meet_through_observer() || meet_among(nodes)) return true;
    }
    return false;
}

bool Meets::find_auxiliary() {
    for (const BodyIndex body : mechanism_.moving_bodies()) {
        if (known_.spin_known(body) || known_.base_of(body, none) != none) continue;
        std::vector<Locus> loci;
        const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
        for (const NodeIndex node : nodes) {
            for (Locus& locus : loci_.loci_of(node, body)) loci.push_back(std::move(locus));
        }
        own_slides(body, nodes, loci);
        if (auxiliary_from(body, loci)) return true;
    }
    return false;
}

void Meets::add_places_of_slides(BodyIndex body, bool on_guide) {
    for (const Slide& slide : structure_.sleeves_of(body)) {
        if (slide.inverse != on_guide) continue;
        if (slide.other == frame) {
            if (structure_.nodes_of(body).empty()) structure_.on(mechanism_.joints[at(slide.joint)].point, body);
            continue;
        }
        const std::vector<NodeIndex> others = structure_.nodes_of(slide.other);
        for (const NodeIndex other : others) {
            const bool wanted = structure_.node(other).carried || !known_.body_known(slide.other);
            if (wanted && known_.known(other) && structure_.node(other).point != none)
                structure_.on(structure_.node(other).point, body);
        }
    }
    for (const Passage& passage : structure_.passages_of(body)) {
        if (passage.inverse == on_guide && known_.known_on(passage.others, passage.other) != none)
            structure_.on(passage.own, body);
    }
}

bool Meets::meet_through_observer() {
    for (const RelativeMotionQuery& query : mechanism_.find.relative_motion) {
        if (!query.solves) continue;
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            if (structure_.node(node).point != query.point || known_.known(node)) continue;
            const std::vector<Locus> loci = loci_.loci_of(node);
            const bool seen = std::any_of(loci.begin(), loci.end(), [&](const Locus& locus) {
                return kinegraph::is_seen_from(structure_, query.observer, query.point, locus);
            });
            if (seen && (meet_at(node, false) || meet_at(node, true))) return true;
        }
    }
    return false;
}

bool Meets::meet_among(const std::vector<NodeIndex>& nodes) {
    for (const bool with_carried : {false, true}) {
        for (const NodeIndex node : nodes) {
            if (meet_at(node, with_carried)) return true;
        }
    }
    return false;
}

bool Meets::meet_at(NodeIndex node, bool with_carried) {
    const std::vector<Locus> loci = loci_.loci_of(node);
    if (loci.size() < 2 || loci.size() == known_.parallel_at()[at(node)]) return false;
    for (std::size_t i = 0; i < loci.size(); ++i) {
        for (std::size_t k = i + 1; k < loci.size(); ++k) {
            if (!with_carried && !(loci[i].carries.empty() && loci[k].carries.empty())) continue;
            if (known_.are_parallel(loci[i], loci[k])) continue;
            Step step;
            step.kind = Step::Kind::meet;
            step.node = node;
            step.first = loci[i];
            step.second = loci[k];
            known_.add_step(step);
            known_.plan().nodes[at(node)] = true;
            return true;
        }
    }
    if (with_carried) {
        known_.parallel_at()[at(node)] = loci.size();
        known_.plan().dead_points.push_back({node, loci[0], loci[1]});
    }
    return false;
}

void Meets::own_slides(BodyIndex body, const std::vector<NodeIndex>& nodes, std::vector<Locus>& loci) {
    for (const NodeIndex node : nodes) {
        std::vector<Locus> all;
        loci_.own_loci(node, none, all);
        for (const Locus& locus : all) {
            if (locus.body == body) loci.push_back(locus);
        }
    }
}

bool Meets::auxiliary_from(BodyIndex body, const std::vector<Locus>& loci) {
    // Parallel loci first: they give ω at once.
    for (const bool want_parallel : {true, false}) {
        for (std::size_t i = 0; i < loci.size(); ++i) {
            for (std::size_t k = i + 1; k < loci.size(); ++k) {
                if (loci[i].holds() == loci[k].holds() || known_.are_parallel(loci[i], loci[k]) != want_parallel)
                    continue;
                const auto met =
                    board_.meet(known_.diagram().perpendicular_at(loci[i]), known_.diagram().perpendicular_at(loci[k]));
                if (!met) continue;  // the two perpendiculars coincide: the loci are equivalent
                Step step;
                step.body = body;
                step.first = loci[i];
                step.second = loci[k];
                if (want_parallel) {
                    step.kind = Step::Kind::spin_from_parallels;
                    known_.plan().spins[at(body)] = true;
                } else {
                    step.kind = Step::Kind::auxiliary;
                    step.node = structure_.add_auxiliary(body, loci[i], loci[k]);
                    known_.sync();
                    known_.plan().nodes[at(step.node)] = true;
                }
                known_.add_step(step);
                return true;
            }
        }
    }
    return false;
}

}  // namespace kinegraph::planning
