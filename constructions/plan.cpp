#include "constructions/plan.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "constructions/motion.hpp"
#include "constructions/space_diagram.hpp"
#include "engine/assert.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }

/// Trials within trials: three unknowns at once are 27 drawings, and no mechanism met so far needs more.
constexpr int deepest_nesting = 3;

/// What a step draws from, or draws: tips of nodes and angular velocities of bodies.
struct Quantities {
    std::set<NodeIndex> tips;
    std::set<BodyIndex> spins;
};

void add_inputs(const Locus& locus, Quantities& inputs) {
    if (locus.base != none) inputs.tips.insert(locus.base);
    if (locus.kind == Locus::Kind::image) inputs.spins.insert(locus.body);
    for (const Carry& carry : locus.carries) {
        if (carry.kind == Carry::Kind::image) inputs.spins.insert(carry.body);
    }
}

void add_inputs(const Closing& closing, Quantities& inputs) {
    if (closing.locus) {
        inputs.tips.insert(closing.locus->node);
        add_inputs(*closing.locus, inputs);
    } else {
        inputs.spins.insert({closing.body, closing.other});
    }
}

void add_inputs(const Step& step, Quantities& inputs) {
    switch (step.kind) {
        case Step::Kind::spin_by_joint:
        case Step::Kind::spin_by_driver:
            inputs.spins.insert(step.other);
            return;
        case Step::Kind::slide_by_driver:
        case Step::Kind::roll:
            inputs.tips.insert(step.base);
            return;
        case Step::Kind::image:
            inputs.tips.insert(step.base);
            inputs.spins.insert(step.body);
            return;
        case Step::Kind::meet:
            add_inputs(step.first, inputs);
            add_inputs(step.second, inputs);
            return;
        case Step::Kind::spin_from_pair:
            inputs.tips.insert({step.base, step.node});
            return;
        case Step::Kind::auxiliary:
        case Step::Kind::spin_from_parallels:
            add_inputs(step.first, inputs);
            add_inputs(step.second, inputs);
            return;
        case Step::Kind::assume:
            if (step.node != none) add_inputs(step.first, inputs);
            for (const Step& inner : step.trial) add_inputs(inner, inputs);
            add_inputs(step.closing, inputs);
            return;
    }
}

bool gives_spin(const Step& step) {
    return step.kind == Step::Kind::spin_by_joint || step.kind == Step::Kind::spin_by_driver ||
           step.kind == Step::Kind::spin_from_pair || step.kind == Step::Kind::spin_from_parallels ||
           (step.kind == Step::Kind::assume && step.node == none);
}

bool gives_any(const Step& step, const Quantities& wanted) {
    return gives_spin(step) ? wanted.spins.contains(step.body) : wanted.tips.contains(step.node);
}

class Planner {
public:
    Planner(Structure& structure, Board& board, const std::vector<bool>& drivers, const std::vector<bool>& determined)
        : structure_(structure),
          board_(board),
          diagram_(structure, board),
          mechanism_(structure.mechanism()),
          use_driver_(drivers),
          determined_(determined) {
        plan_.bodies.assign(mechanism_.bodies.size(), false);
        plan_.spins.assign(mechanism_.bodies.size(), false);
        plan_.bodies[at(frame)] = plan_.spins[at(frame)] = true;
    }

    Plan run() {
        add_places_of_higher_pairs();
        sync();
        for (const NodeIndex node : structure_.nodes_of(frame)) plan_.nodes[at(node)] = true;
        advance();
        while (!complete() && assume_something()) {
        }
        prune();
        sync();
        return std::move(plan_);
    }

private:
    void advance() {
        do {
            do {
                propagate();
            } while (slide_by_driver() || meet_some_node());
        } while (advance_by_auxiliaries());
    }

    /// Auxiliary points are drawn only where they lead to a point or a body of the mechanism.
    bool advance_by_auxiliaries() {
        const State before = state();
        const std::size_t reached = gains();
        while (find_auxiliary()) {
            propagate();
            while (meet_some_node()) propagate();
            if (gains() > reached) return true;
        }
        restore(before);
        return false;
    }

    std::size_t gains() const {
        std::size_t count = 0;
        for (std::size_t node = 0; node < plan_.nodes.size(); ++node) {
            const bool of_mechanism = structure_.node(NodeIndex(node)).carried;
            count += of_mechanism && plan_.nodes[node] ? 1 : 0;
        }
        for (const bool spin : plan_.spins) count += spin ? 1 : 0;
        return count;
    }

    /// Leaves out what leads to nothing: auxiliary points and places seen on a body that no later step uses.
    void prune() {
        Quantities wanted;
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            if (structure_.node(node).carried || structure_.node(node).of_interest) wanted.tips.insert(node);
        }
        for (const BodyIndex body : indices_of(mechanism_.bodies)) wanted.spins.insert(body);
        std::vector<Step> kept;
        for (std::size_t i = plan_.steps.size(); i-- > 0;) {
            Step& step = plan_.steps[i];
            if (!gives_any(step, wanted)) continue;
            add_inputs(step, wanted);
            kept.push_back(std::move(step));
        }
        std::reverse(kept.begin(), kept.end());
        plan_.steps = std::move(kept);
    }

    bool complete() const {
        for (std::size_t body = 1; body < determined_.size(); ++body) {
            if (determined_[body] && !plan_.bodies[body]) return false;
        }
        return true;
    }

    bool known(NodeIndex node) const { return at(node) < plan_.nodes.size() && plan_.nodes[at(node)]; }
    bool body_known(BodyIndex body) const { return plan_.bodies[at(body)]; }
    bool spin_known(BodyIndex body) const { return plan_.spins[at(body)]; }

    /// Makes room for nodes added since.
    void sync() {
        while (plan_.nodes.size() < structure_.nodes().size()) {
            plan_.nodes.push_back(false);
            parallel_at_.push_back(0);
        }
    }

    /// The node of a point on a body, known if it can be: on a body wholly known by an image step of its own.
    NodeIndex known_on(PointIndex point, BodyIndex body) {
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

    void add_step(const Step& step) { plan_.steps.push_back(step); }

    /// The best node to turn the image about: one at rest, else the first known.
    NodeIndex base_of(BodyIndex body, NodeIndex except) const {
        NodeIndex best = none;
        for (const NodeIndex node : structure_.nodes_of(body)) {
            if (node == except || !known(node)) continue;
            if (structure_.node(node).bodies.front() == frame) return node;
            if (best == none) best = node;
        }
        return best;
    }

    void add_image(BodyIndex body, NodeIndex node) {
        Step step;
        step.kind = Step::Kind::image;
        step.body = body;
        step.node = node;
        step.base = base_of(body, node);
        KG_ASSERT(step.base != none, "a body wholly known has a known node");
        add_step(step);
        plan_.nodes[at(node)] = true;
    }

    void learn_body(BodyIndex body) {
        plan_.bodies[at(body)] = true;
        const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
        for (const NodeIndex node : nodes) {
            if (!known(node) && structure_.node(node).of_interest) add_image(body, node);
        }
    }

    bool apart(NodeIndex a, NodeIndex b) { return !board_.coincide(diagram_.place(a), diagram_.place(b)); }
    bool are_parallel(const Locus& one, const Locus& other) {
        return board_.parallel(diagram_.direction(one), diagram_.direction(other));
    }

    bool learn_spins() {
        bool learnt = false;
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            if (!spin_known(body)) continue;
            for (const auto& [other, joint] : structure_.same_spin(body)) {
                if (spin_known(other)) continue;
                Step step;
                step.kind = Step::Kind::spin_by_joint;
                step.body = other;
                step.other = body;
                step.joint = joint;
                add_step(step);
                plan_.spins[at(other)] = learnt = true;
            }
        }
        for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
            const auto* spin = std::get_if<SpinDriver>(&mechanism_.drivers[d]);
            if (spin == nullptr || !use_driver_[d] || spin_known(spin->body) == spin_known(spin->relative_to)) continue;
            Step step;
            step.kind = Step::Kind::spin_by_driver;
            step.inverse = spin_known(spin->body);
            step.body = step.inverse ? spin->relative_to : spin->body;
            step.other = step.inverse ? spin->body : spin->relative_to;
            step.driver = static_cast<int>(d);
            add_step(step);
            plan_.spins[at(step.body)] = learnt = true;
        }
        return learnt;
    }

    bool learn_bodies() {
        bool learnt = false;
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            if (body_known(body)) continue;
            const NodeIndex base = base_of(body, none);
            if (base == none) continue;
            if (!spin_known(body)) {
                NodeIndex second = none;
                for (const NodeIndex node : structure_.nodes_of(body)) {
                    if (node != base && known(node) && apart(base, node)) {
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
                add_step(step);
                plan_.spins[at(body)] = true;
            }
            learn_body(body);
            learnt = true;
        }
        return learnt;
    }

    void propagate() {
        while (learn_spins() || learn_bodies() || learn_rolling_points()) {
        }
    }

    /// Where two bodies roll on each other and the point of one is known, so is the point of the other.
    bool learn_rolling_points() {
        bool learnt = false;
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            if (body_known(body)) continue;
            for (const Rolling& rolling : structure_.rollings_of(body)) {
                const NodeIndex node = structure_.on(rolling.point, body);
                if (known(node)) continue;
                const NodeIndex base = known_on(rolling.point, rolling.other);
                if (base == none || base == node) continue;
                Step step;
                step.kind = Step::Kind::roll;
                step.body = body;
                step.other = rolling.other;
                step.joint = rolling.joint;
                step.node = node;
                step.base = base;
                add_step(step);
                plan_.nodes[at(node)] = learnt = true;
            }
        }
        return learnt;
    }

    /// The places by which higher pairs hold their bodies, on both; the file need not list them.
    void add_places_of_higher_pairs() {
        for (const BodyIndex body : indices_of(mechanism_.bodies)) {
            for (const Rolling& rolling : structure_.rollings_of(body)) structure_.on(rolling.point, body);
            for (const Passage& passage : structure_.passages_of(body)) {
                if (mechanism_.joints[at(passage.joint)].pair().touches()) structure_.on(passage.own, body);
            }
        }
    }

    bool slide_by_driver() {
        for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
            const auto* slide = std::get_if<SlideDriver>(&mechanism_.drivers[d]);
            if (slide == nullptr || !use_driver_[d]) continue;
            const Joint& joint = mechanism_.joints[at(slide->joint)];
            for (const bool inverse : {false, true}) {
                const BodyIndex body = joint.bodies[inverse ? 1 : 0], other = joint.bodies[inverse ? 0 : 1];
                if (body_known(body)) continue;
                NodeIndex base = known_on(joint.point, other);
                if (base == none && joint.pair().holds_rotation) {  // any known place of the other serves: no relative rotation
                    base = base_of(other, none);
                }
                if (base == none || structure_.node(base).point == none) continue;
                const NodeIndex node = structure_.on(structure_.node(base).point, body);
                sync();
                if (known(node)) continue;
                Step step;
                step.kind = Step::Kind::slide_by_driver;
                step.body = body;
                step.other = other;
                step.joint = slide->joint;
                step.driver = static_cast<int>(d);
                step.inverse = inverse;
                step.node = node;
                step.base = base;
                add_step(step);
                plan_.nodes[at(node)] = true;
                return true;
            }
        }
        return false;
    }

    /// The body turns about `base`, already known.
    static Locus rotation(BodyIndex body, NodeIndex base, NodeIndex node) {
        Locus locus;
        locus.kind = Locus::Kind::rotation;
        locus.body = body;
        locus.node = node;
        locus.base = base;
        return locus;
    }

    /// The loci that hold a node itself (not shifted), through any body that carries it but `except`.
    void own_loci(NodeIndex node, BodyIndex except, std::vector<Locus>& loci) {
        const PointIndex point = structure_.node(node).point;
        const std::vector<BodyIndex> bodies = structure_.node(node).bodies;
        for (const BodyIndex body : bodies) {
            if (body == except) continue;
            if (!spin_known(body)) {
                const NodeIndex base = base_of(body, node);
                if (base != none && apart(base, node)) loci.push_back(rotation(body, base, node));
            }
            const std::vector<Slide>& sleeves = structure_.sleeves_of(body);
            for (const Slide& slide : sleeves) add_sleeve(slide, node, point, body, loci);
            for (const Passage& passage : structure_.passages_of(body)) {
                if (passage.own == point) add_passage(passage, node, body, loci);
            }
            for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
                const auto* driven = std::get_if<PointDriver>(&mechanism_.drivers[d]);
                if (driven == nullptr || !use_driver_[d] || driven->body != body || driven->at != point) continue;
                Locus locus;
                locus.kind = Locus::Kind::component;
                locus.body = body;
                locus.node = node;
                locus.driver = static_cast<int>(d);
                loci.push_back(locus);
            }
        }
    }

    /// The node of a point on the other body of a slide, where it is known and may be looked at.
    NodeIndex base_on(PointIndex point, BodyIndex other) {
        if (point == none || (thrifty_ && other != frame && structure_.find(point, other) == none)) return none;
        return known_on(point, other);
    }

    /// The locus of a node of `body` that moves past `base` in a slide or passage; the kind is left to say.
    template <class Pair>
    static Locus past(const Pair& pair, BodyIndex body, NodeIndex node, NodeIndex base) {
        Locus locus;
        locus.body = body;
        locus.node = node;
        locus.base = base;
        locus.joint = pair.joint;
        locus.guide = pair.inverse ? body : pair.other;
        locus.inverse = pair.inverse;
        return locus;
    }

    void add_sleeve(const Slide& slide, NodeIndex node, PointIndex point, BodyIndex body, std::vector<Locus>& loci) {
        const NodeIndex base = base_on(point, slide.other);
        if (base == none || base == node) return;
        Locus locus = past(slide, body, node, base);
        locus.kind = Locus::Kind::sleeve;
        loci.push_back(locus);
    }

    void add_passage(const Passage& passage, NodeIndex node, BodyIndex body, std::vector<Locus>& loci) {
        const NodeIndex base = base_on(passage.others, passage.other);
        if (base == none || base == node) return;
        Locus locus = past(passage, body, node, base);
        switch (passage.kind) {
            case Passage::Kind::slot:
                locus.kind = Locus::Kind::slot;
                break;
            case Passage::Kind::link:
                locus.kind = Locus::Kind::link;
                locus.inverse = false;  // a link is seen from either end alike
                break;
            case Passage::Kind::tangent:
                locus.kind = Locus::Kind::tangent;
                break;
            case Passage::Kind::mesh:
                locus.kind = Locus::Kind::mesh;
                break;
        }
        loci.push_back(locus);
    }

    /// A node to which loci of others can be carried, and how from there to the node sought.
    struct Reached {
        NodeIndex node = none;
        std::vector<Carry> carries;
    };

    /// The nodes whose loci can be carried to this one: on bodies whose ω is known, and over rolling contacts; near ones first.
    std::vector<Reached> reached_from(NodeIndex node) {
        std::vector<Reached> reached{{node, {}}};
        const auto reach = [&](std::size_t from, Carry::Kind kind, BodyIndex body, JointIndex joint, NodeIndex other) {
            const bool seen = std::any_of(reached.begin(), reached.end(), [&](const Reached& r) { return r.node == other; });
            if (seen || known(other)) return;
            Reached next{other, {{kind, body, joint, other, reached[from].node}}};
            next.carries.insert(next.carries.end(), reached[from].carries.begin(), reached[from].carries.end());
            reached.push_back(std::move(next));
        };
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const NodeIndex here = reached[i].node;
            const std::vector<BodyIndex> bodies = structure_.node(here).bodies;
            for (const BodyIndex body : bodies) {
                for (const Rolling& rolling : structure_.rollings_of(body)) {
                    if (rolling.point != structure_.node(here).point) continue;
                    const NodeIndex other = structure_.find(rolling.point, rolling.other);
                    if (other != none) reach(i, Carry::Kind::roll, body, rolling.joint, other);
                }
                if (!spin_known(body) || body_known(body)) continue;
                for (const NodeIndex other : structure_.nodes_of(body)) reach(i, Carry::Kind::image, body, none, other);
            }
        }
        return reached;
    }

    /// All loci of a node, through any body that carries it but `except`: its own, and those carried to it.
    std::vector<Locus> loci_of(NodeIndex node, BodyIndex except = none) {
        std::vector<Locus> loci;
        for (const Reached& reached : reached_from(node)) {
            std::vector<Locus> there;
            own_loci(reached.node, reached.node == node ? except : none, there);
            for (Locus& locus : there) {
                // A sleeve of a body whose ω is known holds every one of its points alike: nothing new.
                const bool repeats = std::any_of(reached.carries.begin(), reached.carries.end(), [&](const Carry& carry) {
                    return carry.kind == Carry::Kind::image && carry.body == locus.body;
                });
                if (repeats && locus.kind == Locus::Kind::sleeve && !loci.empty()) continue;
                locus.carries = reached.carries;
                loci.push_back(std::move(locus));
            }
        }
        return loci;
    }

    /// Nodes that may be sought: those of the file, then the places where a sleeve lets one body's known point be seen on the
    /// other.
    std::vector<NodeIndex> candidates() {
        // A* of the guide under the slider's pin is the place a book takes; the slider's under the guide's pin serves as well.
        for (const bool on_guide : {true, false}) {
            for (const BodyIndex body : indices_of(mechanism_.bodies)) {
                if (!body_known(body)) add_places_of_slides(body, on_guide);
            }
        }
        sync();
        std::vector<NodeIndex> order;
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            const auto& bodies_there = structure_.node(node).bodies;
            // On a body wholly known every place is there for the asking.
            const bool is_there =
                std::any_of(bodies_there.begin(), bodies_there.end(), [&](BodyIndex body) { return body_known(body); });
            if (!known(node) && !is_there) order.push_back(node);
        }
        return order;
    }

    /// Places at which a slide lets a known place of the other body be seen on this one.
    void add_places_of_slides(BodyIndex body, bool on_guide) {
        for (const Slide& slide : structure_.sleeves_of(body)) {
            if (slide.inverse != on_guide) continue;
            if (slide.other == frame) {
                if (structure_.nodes_of(body).empty()) structure_.on(mechanism_.joints[at(slide.joint)].point, body);
                continue;
            }
            const std::vector<NodeIndex> others = structure_.nodes_of(slide.other);
            for (const NodeIndex other : others) {
                const bool wanted = structure_.node(other).carried || !body_known(slide.other);
                if (wanted && known(other) && structure_.node(other).point != none)
                    structure_.on(structure_.node(other).point, body);
            }
        }
        for (const Passage& passage : structure_.passages_of(body)) {
            if (passage.inverse == on_guide && known_on(passage.others, passage.other) != none) structure_.on(passage.own, body);
        }
    }

    /// Where two loci meet; first with the places that the file's bodies carry, then with any place a sleeve may be seen at.
    bool meet_some_node() {
        for (const bool thrifty : {true, false}) {
            thrifty_ = thrifty;
            const std::vector<NodeIndex> nodes = candidates();
            if (meet_through_observer() || meet_among(nodes)) return true;
        }
        return false;
    }

    /// First what the file asks to be found through an observer: where the place under the point, or the point, lies by what the
    /// observer's guide lets through.
    bool meet_through_observer() {
        for (const RelativeMotionQuery& query : mechanism_.find.relative_motion) {
            if (!query.solves) continue;
            for (const NodeIndex node : indices_of(structure_.nodes())) {
                if (structure_.node(node).point != query.point || known(node)) continue;
                const std::vector<Locus> loci = loci_of(node);
                const bool seen = std::any_of(loci.begin(), loci.end(), [&](const Locus& locus) {
                    return is_seen_from(query.observer, query.point, locus);
                });
                if (seen && (meet_at(node, false) || meet_at(node, true))) return true;
            }
        }
        return false;
    }
    bool is_seen_from(BodyIndex observer, PointIndex point, const Locus& locus) const {
        return kinegraph::is_seen_from(structure_, observer, point, locus);
    }

    /// Loci of the node itself first: a meet of those is easier seen than one of loci carried from elsewhere.
    bool meet_among(const std::vector<NodeIndex>& nodes) {
        for (const bool with_carried : {false, true}) {
            for (const NodeIndex node : nodes) {
                if (meet_at(node, with_carried)) return true;
            }
        }
        return false;
    }

    bool meet_at(NodeIndex node, bool with_carried) {
        const std::vector<Locus> loci = loci_of(node);
        if (loci.size() < 2 || loci.size() == parallel_at_[at(node)]) return false;
        for (std::size_t i = 0; i < loci.size(); ++i) {
            for (std::size_t k = i + 1; k < loci.size(); ++k) {
                if (!with_carried && !(loci[i].carries.empty() && loci[k].carries.empty())) continue;
                if (are_parallel(loci[i], loci[k])) continue;
                Step step;
                step.kind = Step::Kind::meet;
                step.node = node;
                step.first = loci[i];
                step.second = loci[k];
                add_step(step);
                plan_.nodes[at(node)] = true;
                return true;
            }
        }
        if (with_carried) {
            parallel_at_[at(node)] = loci.size();
            plan_.dead_points.push_back({node, loci[0], loci[1]});
        }
        return false;
    }

    /// Class III: a body with two loci has its auxiliary (Assur) point known, or its ω where the loci are parallel.
    bool find_auxiliary() {
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (spin_known(body) || base_of(body, none) != none) continue;
            std::vector<Locus> loci;
            const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
            for (const NodeIndex node : nodes) {
                for (Locus& locus : loci_of(node, body)) loci.push_back(std::move(locus));
            }
            own_slides(body, nodes, loci);
            if (auxiliary_from(body, loci)) return true;
        }
        return false;
    }

    /// The loci that a body's own slides give its nodes.
    void own_slides(BodyIndex body, const std::vector<NodeIndex>& nodes, std::vector<Locus>& loci) {
        for (const NodeIndex node : nodes) {
            std::vector<Locus> all;
            own_loci(node, none, all);
            for (const Locus& locus : all) {
                if (locus.body == body) loci.push_back(locus);
            }
        }
    }

    bool auxiliary_from(BodyIndex body, const std::vector<Locus>& loci) {
        // Parallel loci first: they give ω at once, as a translation is seen at once.
        for (const bool want_parallel : {true, false}) {
            for (std::size_t i = 0; i < loci.size(); ++i) {
                for (std::size_t k = i + 1; k < loci.size(); ++k) {
                    if (loci[i].holds() == loci[k].holds() || are_parallel(loci[i], loci[k]) != want_parallel) continue;
                    const auto met = board_.meet(diagram_.perpendicular_at(loci[i]), diagram_.perpendicular_at(loci[k]));
                    if (!met) continue;  // the two perpendiculars coincide: the loci say the same thing twice
                    Step step;
                    step.body = body;
                    step.first = loci[i];
                    step.second = loci[k];
                    if (want_parallel) {
                        step.kind = Step::Kind::spin_from_parallels;
                        plan_.spins[at(body)] = true;
                    } else {
                        step.kind = Step::Kind::auxiliary;
                        step.node = structure_.add_auxiliary(body, loci[i], loci[k]);
                        sync();
                        plan_.nodes[at(step.node)] = true;
                    }
                    add_step(step);
                    return true;
                }
            }
        }
        return false;
    }

    // --- trials ------------------------------------------------------------------------------------------------------------
    struct State {
        Plan plan;
        std::vector<std::size_t> parallel_at;
        Structure::Mark mark;
    };
    State state() const { return {plan_, parallel_at_, structure_.mark()}; }
    void restore(const State& state) {
        structure_.rewind(state.mark);
        plan_ = state.plan;
        parallel_at_ = state.parallel_at;
        sync();
    }

    /// The last rule, with as few unknowns at once as will do.
    bool assume_something() {
        for (int depth = 1; depth <= deepest_nesting; ++depth) {
            if (assume_something(depth)) return true;
        }
        return false;
    }

    /// Of all unknowns whose trial closes, the one that needs the shortest drawing.
    bool assume_something(int depth) {
        const State before = state();
        std::optional<Step> best;
        std::size_t shortest = 0;
        for (const Step& guess : guesses()) {
            const std::size_t first = plan_.steps.size();
            if (attempt(guess, depth)) {
                const std::size_t length = plan_.steps[first].trial.size();
                if (!best || length < shortest) {
                    best = guess;
                    shortest = length;
                }
            }
            restore(before);
            if (best && depth > 1) break;
        }
        return best && attempt(*best, depth);
    }

    bool attempt(const Step& guess, int depth) {
        const std::size_t assumed = plan_.steps.size();
        add_step(guess);
        if (guess.node != none) {
            plan_.nodes[at(guess.node)] = true;
        } else {
            plan_.spins[at(guess.body)] = true;
        }
        advance();
        while (!close(assumed)) {
            if (depth == 1 || !assume_something(depth - 1)) return false;
        }
        return true;
    }

    /// Unknowns that a trial may take: a node whose line is known, then the ω of a body.
    std::vector<Step> guesses() {
        std::vector<Step> found;
        thrifty_ = true;
        const std::vector<NodeIndex> nodes = candidates();
        for (const NodeIndex node : nodes) {
            const std::vector<Locus> loci = loci_of(node);
            if (loci.empty()) continue;
            // A line that a point at rest gives is the easiest to see.
            const auto at_rest = [&](const Locus& locus) {
                return locus.base != none && structure_.node(locus.base).bodies.front() == frame;
            };
            const auto best = std::find_if(loci.begin(), loci.end(), at_rest);
            Step guess;
            guess.kind = Step::Kind::assume;
            guess.node = node;
            guess.first = best == loci.end() ? loci.front() : *best;
            found.push_back(std::move(guess));
        }
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (spin_known(body) || base_of(body, none) != none) continue;
            Step guess;
            guess.kind = Step::Kind::assume;
            guess.body = body;
            found.push_back(std::move(guess));
        }
        return found;
    }

    /// Looks for a condition that the assumption moves; finds what must be drawn from it to the condition.
    bool close(std::size_t assumed) {
        std::optional<Closing> closing = moved_condition(assumed);
        for (const JointIndex joint : indices_of(mechanism_.joints))
            if (!closing) closing = moved_condition_at(joint, assumed);
        if (!closing) return false;
        Quantities wanted;
        add_inputs(*closing, wanted);
        std::vector<Step> trial;
        for (std::size_t i = plan_.steps.size(); i-- > assumed + 1;) {
            if (!gives_any(plan_.steps[i], wanted)) continue;
            add_inputs(plan_.steps[i], wanted);
            trial.push_back(plan_.steps[i]);
        }
        std::reverse(trial.begin(), trial.end());
        plan_.steps[assumed].trial = std::move(trial);
        plan_.steps[assumed].closing = *closing;
        return true;
    }

    /// Of the conditions that the drawing breaks, one whose line stays where it is, else the first.
    std::optional<Closing> moved_condition(std::size_t assumed) {
        std::size_t steps = plan_.steps.size();
        Track<Plane::velocity> moved = draw_response(structure_, board_, plan_, assumed);
        std::vector<Closing> all = conditions(moved);
        // Looking for them may have made places known that the drawing does not show yet.
        while (plan_.steps.size() > steps) {
            steps = plan_.steps.size();
            moved = draw_response(structure_, board_, plan_, assumed);
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

    /// The same at a slide whose place is not seen yet on both of its bodies, though both are known.
    std::optional<Closing> moved_condition_at(JointIndex index, std::size_t assumed) {
        const Joint& joint = mechanism_.joints[at(index)];
        if (joint.bodies.size() != 2 || !body_known(joint.bodies[0]) || !body_known(joint.bodies[1])) return std::nullopt;
        const State before = state();
        const std::size_t steps = plan_.steps.size();
        if (see_places_of(index) && plan_.steps.size() > steps) {
            if (auto closing = moved_condition(assumed)) return closing;
        }
        restore(before);
        return std::nullopt;
    }

    /// Makes the places by which a joint holds its two known bodies known on both; false where it is no slide and no higher pair.
    bool see_places_of(JointIndex index) {
        const Joint& joint = mechanism_.joints[at(index)];
        const BodyIndex body = joint.bodies[0];
        if (joint.pair().is_sleeve() || joint.pair().rolls())
            return known_on(joint.point, body) != none && known_on(joint.point, joint.bodies[1]) != none;
        for (const Passage& passage : structure_.passages_of(body)) {
            if (passage.joint == index)
                return known_on(passage.own, body) != none && known_on(passage.others, passage.other) != none;
        }
        return false;
    }

    /// All that the bodies reached must fulfil; most of it does by the way it was drawn.
    std::vector<Closing> conditions(const Track<Plane::velocity>& moved) {
        std::vector<Closing> found;
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            add_rigidity(body, moved, found);
            if (moved.turns(body)) add_equal_spins(body, moved, found);
        }
        thrifty_ = true;
        for (const NodeIndex node : indices_of(structure_.nodes())) {
            if (!moved.has(node) || structure_.node(node).bodies.front() == frame) continue;
            std::vector<Locus> loci;
            own_loci(node, none, loci);
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

    /// Two points of a body: equal projections on their join and, where ω is known, the image ⟂ to it.
    void add_rigidity(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
        NodeIndex base = none;
        const std::vector<NodeIndex> nodes = structure_.nodes_of(body);
        for (const NodeIndex node : nodes) {
            if (!moved.has(node)) continue;
            if (base == none) {
                base = node;
                continue;
            }
            if (!apart(base, node)) continue;
            Locus locus = rotation(body, base, node);
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

    /// Points in contact in rolling: alike along the tangent and along the normal.
    void add_rollings(const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
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

    void add_driven_slides(const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
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

    void add_equal_spins(BodyIndex body, const Track<Plane::velocity>& moved, std::vector<Closing>& found) {
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

    Structure& structure_;
    Board& board_;  ///< the scratch paper
    SpaceDiagram diagram_;
    const Mechanism& mechanism_;
    std::vector<bool> use_driver_;
    std::vector<bool> determined_;
    Plan plan_;
    bool thrifty_ = false;                  ///< no places beyond those that bodies carry
    std::vector<std::size_t> parallel_at_;  ///< by NodeIndex: how many loci it had when all were found parallel
};

}  // namespace

bool is_seen_from(const Structure& structure, BodyIndex observer, PointIndex point, const Locus& locus) {
    if (locus.kind != Locus::Kind::sleeve && locus.kind != Locus::Kind::slot) return false;
    if (locus.base == none || !locus.carries.empty()) return false;
    const auto& first = structure.node(locus.node);
    const auto& second = structure.node(locus.base);
    if (first.point != point || second.point != point) return false;
    const auto on = [&](const Node& node) {
        return std::find(node.bodies.begin(), node.bodies.end(), observer) != node.bodies.end();
    };
    return on(first) != on(second);
}

Plan plan_motion(Structure& structure, Board& scratch, const std::vector<bool>& drivers, const std::vector<bool>& determined) {
    return Planner(structure, scratch, drivers, determined).run();
}

}  // namespace kinegraph
