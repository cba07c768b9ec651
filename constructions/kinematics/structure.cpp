#include "constructions/kinematics/structure.hpp"

#include <algorithm>

namespace kinegraph {
namespace {

/// Shape of the given profile of the joint's first or second body.
bool is_straight(const Joint& joint, std::size_t side) {
    return std::holds_alternative<LineProfile>(joint.profiles.at(joint.bodies[side]));
}
PointIndex centre_of(const Joint& joint, std::size_t side) {
    const auto* circle = std::get_if<CircleProfile>(&joint.profiles.at(joint.bodies[side]));
    return circle == nullptr ? joint.point : circle->centre;
}

/// The body whose point at a joint has the name without star: the slider, not the guide; of two touching bodies the
/// moving one.
BodyIndex plainly_named(const Joint& joint) {
    return joint.pair().touches() && joint.bodies.front() == frame ? joint.bodies.back() : joint.bodies.front();
}

/// For each point, the groups of bodies that revolutes and welds join there.
class Carriers {
public:
    explicit Carriers(const Mechanism& mechanism) : groups_(mechanism.points.size()) {
        for (const BodyIndex body : indices_of(mechanism.bodies))
            for (const PointIndex point : mechanism.body(body).points) add(point, body);
        for (const Joint& joint : mechanism.joints) {
            if (joint.pair().has_common_point()) {
                for (const BodyIndex body : joint.bodies) unite(joint.point, joint.bodies.front(), body);
            }
        }
        // The pin of a slot belongs to its body. The point of a sleeve belongs to the slider if no other body carries
        // it.
        for (const Joint& joint : mechanism.joints) {
            if (joint.pair().is_slot() || (joint.pair().is_sleeve() && groups_[at_index(joint.point)].empty())) {
                add(joint.point, joint.bodies.front());
            }
        }
    }
    const std::vector<std::vector<BodyIndex>>& groups(PointIndex point) const { return groups_[at_index(point)]; }

private:
    std::vector<BodyIndex>& add(PointIndex point, BodyIndex body) {
        auto& groups = groups_[at_index(point)];
        for (auto& group : groups) {
            if (std::find(group.begin(), group.end(), body) != group.end()) return group;
        }
        return groups.emplace_back(1, body);
    }
    void unite(PointIndex point, BodyIndex first, BodyIndex second) {
        add(point, first);
        add(point, second);
        auto& groups = groups_[at_index(point)];
        const auto holding = [&](BodyIndex body) {
            return std::find_if(groups.begin(), groups.end(),
                                [&](const auto& g) { return std::find(g.begin(), g.end(), body) != g.end(); });
        };
        const auto one = holding(first), two = holding(second);
        if (one == two) return;
        one->insert(one->end(), two->begin(), two->end());
        std::sort(one->begin(), one->end());
        groups.erase(two);
    }
    std::vector<std::vector<std::vector<BodyIndex>>> groups_;
};

}  // namespace

Structure::Structure(const Mechanism& mechanism, Board& scratch)
    : mechanism_(mechanism),
      nodes_of_(mechanism.bodies.size()),
      nodes_at_(mechanism.points.size()),
      sleeves_(mechanism.bodies.size()),
      passages_(mechanism.bodies.size()),
      rollings_(mechanism.bodies.size()),
      same_spin_(mechanism.bodies.size()),
      guided_(mechanism.bodies.size()) {
    for (const Joint& joint : mechanism.joints)
        if (joint.connects(frame))
            for (const BodyIndex body : joint.bodies) guided_[at_index(body)] = body != frame;
    const Carriers carriers(mechanism);
    for (const PointIndex point : indices_of(mechanism.points)) {
        auto groups = carriers.groups(point);
        // The slider's point has the plain name, the guide's the name with a star.
        const auto is_slider = [&](const std::vector<BodyIndex>& group) {
            return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
                return (joint.pair().has_guide() || joint.pair().touches()) && joint.point == point &&
                       std::find(group.begin(), group.end(), plainly_named(joint)) != group.end();
            });
        };
        std::stable_partition(groups.begin(), groups.end(), is_slider);
        for (auto& group : groups) {
            Node node;
            node.point = point;
            node.bodies = std::move(group);
            add(std::move(node));
        }
    }
    for (const JointIndex index : indices_of(mechanism.joints)) {
        const Joint& joint = mechanism.joint(index);
        if (joint.pair().is_sleeve()) {
            sleeves_[at_index(joint.bodies[0])].push_back({index, joint.bodies[1], false});
            sleeves_[at_index(joint.bodies[1])].push_back({index, joint.bodies[0], true});
        }
        if (joint.pair().rolls()) {
            rollings_[at_index(joint.bodies[0])].push_back({index, joint.bodies[1], joint.point});
            rollings_[at_index(joint.bodies[1])].push_back({index, joint.bodies[0], joint.point});
        }
        curvatures_.push_back(finds_curvatures(joint, scratch));
        add_passages(index);
        if (joint.pair().holds_rotation) {
            for (std::size_t k = 1; k < joint.bodies.size(); ++k) {
                same_spin_[at_index(joint.bodies[0])].emplace_back(joint.bodies[k], index);
                same_spin_[at_index(joint.bodies[k])].emplace_back(joint.bodies[0], index);
            }
        }
    }
}

void Structure::add_passage(Passage::Kind kind, JointIndex joint, BodyIndex slider, PointIndex place, BodyIndex guide,
                            PointIndex guides_place) {
    passages_[at_index(slider)].push_back({kind, joint, guide, place, guides_place, false});
    passages_[at_index(guide)].push_back({kind, joint, slider, guides_place, place, true});
}

/// To second order a contact moves like its equivalent linkage: two circles as a link between their centres, a circle
/// on a straight line as its centre in a slot parallel to the line. A tip is a circle of zero radius.
void Structure::add_passages(JointIndex index) {
    using Kind = Passage::Kind;
    const Joint& joint = mechanism_.joints[at_index(index)];
    if (joint.pair().is_slot() || joint.pair().meshes()) {
        const Kind kind = joint.pair().meshes() ? Kind::mesh : Kind::slot;
        add_passage(kind, index, joint.bodies[0], joint.point, joint.bodies[1], joint.point);
    }
    if (!joint.pair().touches() || !joint.pair().slides()) return;
    const auto add = [&](Kind kind, std::size_t slider, PointIndex place, PointIndex guides_place) {
        add_passage(kind, index, joint.bodies[slider], place, joint.bodies[1 - slider], guides_place);
    };
    if (!curvatures_[at_index(index)]) return add(Kind::tangent, 0, joint.point, joint.point);
    for (const std::size_t line : {1U, 0U}) {
        if (!is_straight(joint, line)) continue;
        const PointIndex pin = centre_of(joint, 1 - line);
        return add(Kind::slot, 1 - line, pin, pin);
    }
    add(Kind::link, 0, centre_of(joint, 0), centre_of(joint, 1));
}

bool Structure::finds_curvatures(const Joint& joint, Board& scratch) {
    if (!joint.pair().asks_curvatures()) return false;
    if (!joint.profiles.contains(joint.bodies[0]) || !joint.profiles.contains(joint.bodies[1])) return false;
    if (is_straight(joint, 0) || is_straight(joint, 1)) return true;
    return !scratch.coincide(scratch.place(centre_of(joint, 0)), scratch.place(centre_of(joint, 1)));
}

NodeIndex Structure::add(Node node) {
    const NodeIndex index(nodes_.size());
    if (node.point != none) {
        auto& here = nodes_at_[at_index(node.point)];
        node.label = mechanism_.points[at_index(node.point)].name + std::string(here.size(), '*');
        here.push_back(index);
    }
    for (const BodyIndex body : node.bodies) nodes_of_[at_index(body)].push_back(index);
    nodes_.push_back(std::move(node));
    return index;
}

NodeIndex Structure::find(PointIndex point, BodyIndex body) const {
    for (const NodeIndex candidate : nodes_at_[at_index(point)]) {
        const auto& bodies = node(candidate).bodies;
        if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) return candidate;
    }
    return none;
}

NodeIndex Structure::on(PointIndex point, BodyIndex body, bool of_interest) {
    if (const NodeIndex found = find(point, body); found != none) {
        Node& there = nodes_[at_index(found)];
        there.of_interest = there.of_interest || of_interest;
        return found;
    }
    Node node;
    node.point = point;
    node.bodies = {body};
    node.carried = false;
    node.of_interest = of_interest;
    return add(std::move(node));
}

void Structure::rewind(const Mark& mark) {
    while (nodes_.size() > mark.nodes) {
        const Node& last = nodes_.back();
        if (last.point != none) nodes_at_[at_index(last.point)].pop_back();
        for (const BodyIndex body : last.bodies) nodes_of_[at_index(body)].pop_back();
        nodes_.pop_back();
    }
    auxiliaries_.resize(mark.auxiliaries);
    named_auxiliaries_ = mark.named;
}

NodeIndex Structure::add_auxiliary(BodyIndex body, const Locus& first, const Locus& second) {
    Node node;
    node.bodies = {body};
    node.carried = node.of_interest = false;
    node.auxiliary = static_cast<int>(auxiliaries_.size());
    auxiliaries_.push_back({first, second});
    do {
        node.label = named_auxiliaries_ == 0 ? "S" : "S" + std::to_string(named_auxiliaries_ + 1);
        ++named_auxiliaries_;
    } while (mechanism_.point_named(node.label));
    return add(std::move(node));
}

}  // namespace kinegraph
