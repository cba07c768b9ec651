#include "constructions/kinematics/planning/known_motion.hpp"

#include "engine/number/assert.hpp"

namespace kinegraph::planning {

void KnownMotion::sync() {
    while (plan_.nodes.size() < structure_.nodes().size()) {
        plan_.nodes.push_back(false);
        parallel_at_.push_back(0);
    }
}

KnownMotion::KnownMotion(Structure& structure, Board& board)
    : structure_(structure), board_(board), diagram_(structure, board) {
    plan_.bodies.assign(structure.mechanism().bodies.size(), false);
    plan_.spins = plan_.bodies;
    plan_.bodies[at(frame)] = plan_.spins[at(frame)] = true;
}

NodeIndex KnownMotion::known_on(PointIndex point, BodyIndex body) {
    if (point == none) return none;
    if (!body_known(body)) {
        const NodeIndex node = structure_.find(point, body);
        return node != none && known(node) ? node : none;
    }
    const NodeIndex node = structure_.on(point, body);
    sync();
    if (!known(node)) {
        if (body == frame) {
            plan_.nodes[at(node)] = true;
        } else {
            add_image(body, node);
        }
    }
    return node;
}

NodeIndex KnownMotion::base_of(BodyIndex body, NodeIndex except) const {
    NodeIndex best = none;
    for (const NodeIndex node : structure_.nodes_of(body)) {
        if (node == except || !known(node)) continue;
        if (structure_.node(node).bodies.front() == frame) return node;
        if (best == none) best = node;
    }
    return best;
}

bool KnownMotion::are_parallel(const Locus& one, const Locus& other) {
    return board_.parallel(diagram_.direction(one), diagram_.direction(other));
}

void KnownMotion::add_image(BodyIndex body, NodeIndex node) {
    Step step;
    step.kind = Step::Kind::image;
    step.body = body;
    step.node = node;
    step.base = base_of(body, node);
    KG_ASSERT(step.base != none, "a body wholly known has a known node");
    add_step(step);
    plan_.nodes[at(node)] = true;
}

void KnownMotion::learn_body(BodyIndex body) {
    plan_.bodies[at(body)] = true;
    const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
    for (const NodeIndex node : nodes) {
        if (!known(node) && structure_.node(node).of_interest) add_image(body, node);
    }
}

void KnownMotion::restore(const State& state) {
    structure_.rewind(state.mark);
    plan_ = state.plan;
    parallel_at_ = state.parallel_at;
    sync();
}

}  // namespace kinegraph::planning
