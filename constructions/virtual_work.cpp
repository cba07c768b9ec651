#include "constructions/virtual_work.hpp"

#include <algorithm>
#include <utility>

#include "constructions/space_diagram.hpp"
#include "engine/assert.hpp"

namespace kinegraph {
namespace {

/// A place of a body with its velocity: about it the body turns as seen from there.
std::optional<NodeIndex> base_of(const Structure& structure, const Track<Plane::velocity>& velocities, BodyIndex body) {
    if (velocities.polygon < 0 || !velocities.turns(body)) return std::nullopt;
    const auto& nodes = structure.nodes_of(body);
    const auto base = std::find_if(nodes.begin(), nodes.end(), [&](NodeIndex node) { return velocities.has(node); });
    if (base == nodes.end()) return std::nullopt;
    return *base;
}

/// A pin moves with any of the bodies that it holds together.
BodyIndex carrier_of(const Mechanism& mechanism, const FreeBody& free) {
    if (free.body != none) return free.body;
    const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& each) {
        return each.point == free.pin && each.pair().is_hinge() && each.has_own_node();
    });
    KG_ASSERT(joint != mechanism.joints.end(), "a pin is that of a hinge");
    return *std::max_element(joint->bodies.begin(), joint->bodies.end());
}

/// Draws the powers of forces and couples and adds them up.
class Powers {
public:
    Powers(const Structure& structure, Board& board, const Track<Plane::velocity>& velocities)
        : board_(board), diagram_(structure, board), velocities_(velocities) {}

    /// v_X = v_A + ω ∧ AX;  P = F·v_X + M ω.
    VirtualWork::Entry of(const AppliedForce& applied, const FreeBody& free, BodyIndex carrier, NodeIndex base) {
        const PointOn<Plane::drawing> at{applied.elements.at};
        const ScalarHandle omega = velocities_.spin(carrier);
        const auto turned = board_.scale<Plane::velocity>(omega, board_.turn(board_.vector(diagram_.place(base), at)));
        const auto tip = board_.carry(velocities_.tip(base), turned);
        const auto velocity = board_.vector(board_.pole<Plane::velocity>(), tip);
        std::optional<ScalarHandle> power;
        const auto add = [&](ScalarHandle part) { power = power ? board_.sum(*power, part) : part; };
        if (applied.elements.force != none) add(board_.power(VectorOn<Plane::force>{applied.elements.force}, velocity));
        if (applied.elements.couple != none) add(board_.product(ScalarHandle{applied.elements.couple}, omega));
        total_ = total_ ? board_.sum(*total_, *power) : *power;

        VirtualWork::Entry entry;
        entry.symbol = applied.symbol;
        entry.quantity = quantity_of(free, applied);
        entry.body = carrier;
        entry.elements = {at.element,    velocity.element, applied.elements.force, applied.elements.couple,
                          omega.element, power->element};
        return entry;
    }
    ElementIndex total() const { return total_->element; }

private:
    Board& board_;
    SpaceDiagram diagram_;
    const Track<Plane::velocity>& velocities_;
    std::optional<ScalarHandle> total_;
};

}  // namespace

std::optional<VirtualWork> virtual_work(const Structure& structure, Board& board, const Track<Plane::velocity>& velocities,
                                        const std::vector<FreeBody>& bodies) {
    VirtualWork work;
    Powers powers(structure, board, velocities);
    for (const FreeBody& free : bodies) {
        const BodyIndex carrier = carrier_of(structure.mechanism(), free);
        const std::optional<NodeIndex> base = base_of(structure, velocities, carrier);
        for (const AppliedForce& applied : free.forces) {
            if (applied.kind == AppliedForce::Kind::reaction || applied.kind == AppliedForce::Kind::resultant) continue;
            if (!base) return std::nullopt;
            work.entries.push_back(powers.of(applied, free, carrier, *base));
        }
    }
    if (work.entries.empty()) return std::nullopt;
    work.total_element = powers.total();
    return work;
}

}  // namespace kinegraph
