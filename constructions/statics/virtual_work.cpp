#include "constructions/statics/virtual_work.hpp"

#include <algorithm>
#include <utility>

#include "constructions/kinematics/space_diagram.hpp"
#include "constructions/statics/force_model.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

/// A place of a body with known velocity, used as base for the body's rotation.
std::optional<NodeIndex> base_of(const Structure& structure, const Track<Plane::velocity>& velocities, BodyIndex body) {
    if (velocities.polygon < 0 || !velocities.turns(body)) return std::nullopt;
    const auto& nodes = structure.nodes_of(body);
    const auto base = std::find_if(nodes.begin(), nodes.end(), [&](NodeIndex node) { return velocities.has(node); });
    if (base == nodes.end()) return std::nullopt;
    return *base;
}

/// A pin moves with any of its bodies.
BodyIndex carrier_of(const Mechanism& mechanism, const FreeBody& free) {
    if (free.body != none) return free.body;
    const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& each) {
        return each.point == free.pin && each.pair().is_hinge() && each.has_own_node();
    });
    KG_ASSERT(joint != mechanism.joints.end(), "a pin is that of a hinge");
    return *std::max_element(joint->bodies.begin(), joint->bodies.end());
}

/// Draws the powers of forces and couples and adds them.
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
        note(quantity_of(free, applied), *power);

        VirtualWork::Entry entry;
        entry.symbol = applied.symbol;
        entry.quantity = quantity_of(free, applied);
        entry.body = carrier;
        entry.elements = {at.element,    velocity.element, applied.elements.force, applied.elements.couple,
                          omega.element, power->element};
        return entry;
    }
    ElementIndex total() const { return total_->element; }
    std::vector<VirtualWork::Power> powers() && { return std::move(powers_); }

private:
    /// A spring or an actuator acts on two bodies.
    void note(const Quantity& quantity, ScalarHandle power) {
        for (VirtualWork::Power& each : powers_)
            if (each.quantity == quantity) {
                each.power = Recorded<Exact>::at(board_.sum(ScalarHandle{each.power.element()}, power).element);
                return;
            }
        powers_.push_back({quantity, Recorded<Exact>::at(power.element)});
    }

    Board& board_;
    SpaceDiagram diagram_;
    const Track<Plane::velocity>& velocities_;
    std::optional<ScalarHandle> total_;
    std::vector<VirtualWork::Power> powers_;
};

}  // namespace

std::optional<VirtualWork> virtual_work(const Structure& structure, Board& board,
                                        const Track<Plane::velocity>& velocities, const std::vector<FreeBody>& bodies) {
    VirtualWork work;
    Powers powers(structure, board, velocities);
    for (const FreeBody& free : bodies) {
        const BodyIndex carrier = carrier_of(structure.mechanism(), free);
        const std::optional<NodeIndex> base = base_of(structure, velocities, carrier);
        for (const AppliedForce& applied : free.forces) {
            if (applied.is_reaction() || applied.is_resultant()) continue;
            if (!base) return std::nullopt;
            work.entries.push_back(powers.of(applied, free, carrier, *base));
        }
    }
    if (work.entries.empty()) return std::nullopt;
    work.total_element = powers.total();
    work.powers = std::move(powers).powers();
    return work;
}

namespace {

/// Works of the given loads, and of one unit of each unknown.
class Works {
public:
    Works(Structure& structure, Board& board, const Motion& motion)
        : structure_(structure),
          mechanism_(structure.mechanism()),
          board_(board),
          diagram_(structure, board),
          velocities_(motion.velocity),
          model_(structure, board, motion) {}

    std::optional<VirtualWork> find() {
        VirtualWork work;
        for (const statics::Load& load : model_.loads()) {
            auto entry = of(load);
            if (!entry) return std::nullopt;
            work.entries.push_back(*std::move(entry));
        }
        for (const statics::Bond& bond : model_.bonds()) {
            if (bond.effort < 0) continue;
            auto share = of(bond);
            if (!share) return std::nullopt;
            work.shares.push_back(*std::move(share));
        }
        if (total_) work.total_element = total_->element;
        return work;
    }

private:
    /// A pin moves with any of its bodies.
    BodyIndex carrier_of(statics::MemberIndex member) const {
        if (!model_.is_pin(member)) return model_.body_of(member);
        FreeBody pin;
        pin.pin = model_.pin_point(member);
        return kinegraph::carrier_of(mechanism_, pin);
    }
    bool is_known(BodyIndex body) const { return body == frame || base_of(structure_, velocities_, body).has_value(); }
    /// None for the frame.
    std::optional<VectorOn<Plane::velocity>> velocity(BodyIndex body, PointOn<Plane::drawing> at) {
        if (body == frame) return std::nullopt;
        const NodeIndex base = *base_of(structure_, velocities_, body);
        const auto turned =
            board_.scale<Plane::velocity>(velocities_.spin(body), board_.turn(board_.vector(diagram_.place(base), at)));
        return board_.vector(board_.pole<Plane::velocity>(), board_.carry(velocities_.tip(base), turned));
    }
    std::optional<VirtualWork::Entry> of(const statics::Load& load) {
        const BodyIndex carrier = carrier_of(load.member);
        if (!is_known(carrier) || carrier == frame) return std::nullopt;
        const auto moved = *velocity(carrier, load.place);
        const ScalarHandle omega = velocities_.spin(carrier);
        const ScalarHandle power = load.force ? board_.power(*load.force, moved) : board_.product(*load.couple, omega);
        total_ = total_ ? board_.sum(*total_, power) : power;
        VirtualWork::Entry entry;
        entry.symbol = load.symbol;
        entry.quantity = {.kind = load.kind, .given = load.given};
        entry.body = carrier;
        entry.elements = {load.place.element,
                          moved.element,
                          load.force ? load.force->element : ElementIndex(none),
                          load.couple ? load.couple->element : ElementIndex(none),
                          omega.element,
                          power.element};
        return entry;
    }
    std::optional<VirtualWork::Share> of(const statics::Bond& bond) {
        const BodyIndex on = model_.body_of(bond.first), from = model_.body_of(bond.second);
        if (!is_known(on) || !is_known(from)) return std::nullopt;
        VirtualWork::Share share;
        share.effort = bond.effort;
        const ScalarHandle power =
            bond.kind == statics::Bond::Kind::couple ? turned(on, from, share) : shifted(bond, on, from, share);
        share.power = Recorded<Exact>::at(power.element);
        share.rests = board_.is_zero(power);
        return share;
    }
    ScalarHandle turned(BodyIndex on, BodyIndex from, VirtualWork::Share& share) {
        const auto spin = [&](BodyIndex body) { return body == frame ? board_.number(0) : velocities_.spin(body); };
        const ScalarHandle omega = from == frame ? spin(on) : board_.difference(spin(on), spin(from));
        share.omega = Recorded<Exact>::at(omega.element);
        return omega;
    }
    ScalarHandle shifted(const statics::Bond& bond, BodyIndex on, BodyIndex from, VirtualWork::Share& share) {
        const auto of = velocity(on, bond.place), against = velocity(from, bond.place);
        if (!of && !against) return board_.number(0);
        const auto seen = !against ? *of : !of ? board_.negate(*against) : board_.subtract(*of, *against);
        share.velocity = Recorded<Vector>::at(seen.element);
        return board_.power(board_.scale<Plane::force>(board_.number(1), bond.direction), seen);
    }

    const Structure& structure_;
    const Mechanism& mechanism_;
    Board& board_;
    SpaceDiagram diagram_;
    const Track<Plane::velocity>& velocities_;
    statics::ForceModel model_;
    std::optional<ScalarHandle> total_;
};

}  // namespace

std::optional<VirtualWork> works_of_displacement(Structure& structure, Board& board, const Motion& motion) {
    return Works(structure, board, motion).find();
}

}  // namespace kinegraph
