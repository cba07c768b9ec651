#include "constructions/statics/force_model.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

bool in(const Group& group, MemberIndex member) { return std::find(group.begin(), group.end(), member) != group.end(); }

Symbol marked(Symbol symbol, const std::string& mark) {
    if (!mark.empty()) symbol.term += (symbol.term.empty() ? "(" : ",(") + mark + ")";
    return symbol;
}

ForceModel::ForceModel(Structure& structure, Board& board, const Motion& motion)
    : board_(board),
      mechanism_(structure.mechanism()),
      members_(static_cast<int>(structure.mechanism().bodies.size())) {
    for (const JointIndex joint : indices_of(mechanism_.joints)) add_joint(joint);
    for (std::size_t e = 0; e < mechanism_.efforts.size(); ++e) add_effort(static_cast<int>(e));
    bonds_of_.resize(at(members_));
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
        bonds_of_[at(bonds_[b].first)].push_back(static_cast<int>(b));
        bonds_of_[at(bonds_[b].second)].push_back(static_cast<int>(b));
    }
    loads_ = loads_of_members(structure, board, motion, pin_of_);
}

std::string ForceModel::member_name(MemberIndex member) const {
    return is_pin(member) ? mechanism_.point(pin_point(member)).name : mechanism_.body(body_of(member)).name;
}

Quantity ForceModel::quantity_at(std::size_t bond, bool on_first) const {
    const Bond& at = bonds_[bond];
    if (at.effort >= 0) return {.kind = Quantity::Kind::effort, .given = at.effort};
    return {.kind = Quantity::Kind::force,
            .body = body_of(on_first ? at.first : at.second),
            .other = body_of(on_first ? at.second : at.first),
            .joint = at.joint};
}

Symbol ForceModel::force_symbol(MemberIndex of, MemberIndex on) const {
    return {Symbol::Letter::F, relative_name_of_bodies(member_name(of), member_name(on)), {}};
}

std::string ForceModel::relative_name_of_bodies(const std::string& of, const std::string& on) {
    return of.size() == 1 && on.size() == 1 ? of + on : of + "," + on;
}

void ForceModel::add_joint(JointIndex index) {
    const Joint& joint = mechanism_.joints[at(index)];
    Bond bond;
    bond.joint = index;
    bond.place = board_.place(joint.point);
    const bool couple = joint.pair().transmits_couple();
    if (joint.pair().holds_point()) {
        bond.kind = couple ? Bond::Kind::clamp : Bond::Kind::pin;
    } else {
        bond.kind = couple ? Bond::Kind::guide : Bond::Kind::line;
        bond.direction = couple ? board_.perpendicular(board_.guide(index)) : board_.normal(index);
    }
    const auto add = [&](MemberIndex first, MemberIndex second) {
        Bond one = bond;
        one.first = first;
        one.second = second;
        one.symbol = force_symbol(second, first);
        one.reverse = force_symbol(first, second);
        // Two bodies that touch at several joints: F_12 at A differs from F_12 at B.
        int common = 0;
        for (const Joint& other : mechanism_.joints)
            common += !other.has_own_node() && !joint.has_own_node() &&
                      std::minmax(other.bodies[0], other.bodies[1]) == std::minmax(joint.bodies[0], joint.bodies[1]);
        if (common > 1) one.symbol.term = one.reverse.term = joint.name;
        bonds_.push_back(one);
    };
    if (!joint.has_own_node()) return add(member_of(joint.bodies[0]), member_of(joint.bodies[1]));
    if (joint.pair().is_hinge()) {  // a multiple or a loaded hinge has its own pin, without weight
        pins_.push_back(joint.point);
        const MemberIndex pin(members_++);
        pin_of_.emplace(index, pin);
        for (const BodyIndex body : joint.bodies) add(member_of(body), pin);
    } else {
        for (std::size_t b = 1; b < joint.bodies.size(); ++b)
            add(member_of(joint.bodies[b]), member_of(joint.bodies[0]));
    }
}

void ForceModel::add_effort(int index) {
    Bond bond;
    bond.effort = index;
    const Effort& effort = mechanism_.efforts[at(index)];
    if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
        bond.kind = Bond::Kind::couple;
        bond.first = member_of(couple->body);
        bond.second = member_of(couple->from);
        bond.symbol = {Symbol::Letter::M, couple->name, {}};
        const auto& points = mechanism_.bodies[at(couple->body)].points;
        bond.place = board_.place(points.empty() ? PointIndex(0) : points.front());
    } else if (const auto* force = std::get_if<ForceEffort>(&effort)) {
        bond.kind = Bond::Kind::line;
        bond.first = member_of(force->body);
        bond.second = member_of(frame);
        bond.symbol = {Symbol::Letter::F, force->name, {}};
        bond.place = board_.place(force->at);
        bond.direction = board_.effort_unit(index);
    } else {
        const auto& actuator = std::get<ActuatorEffort>(effort);
        const Joint& joint = mechanism_.joints[at(actuator.joint)];
        bond.kind = Bond::Kind::line;
        bond.first = member_of(joint.bodies[0]);
        bond.second = member_of(joint.bodies[1]);
        bond.symbol = {Symbol::Letter::F, actuator.name, {}};
        bond.place = board_.place(joint.point);
        bond.direction = board_.guide_unit(actuator.joint);
    }
    bond.reverse = bond.symbol;
    bonds_.push_back(bond);
}

bool ForceModel::is_of_teeth(std::size_t bond) const {
    return bonds_[bond].joint != none && mechanism_.joints[at(bonds_[bond].joint)].pair().meshes();
}

bool ForceModel::pulls(std::size_t b, const Run& run) {
    if (bonds_[b].joint == none || !run.reactions[b].force) return false;
    const JointIndex index = bonds_[b].joint;
    const Joint& joint = mechanism_.joints[at(index)];
    const Force& force = *run.reactions[b].force;
    if (joint.pushes) return board_.along_sign(board_.push(index), force) < 0;
    if (!is_of_teeth(b) && !is_between_round_profiles(joint)) return false;
    // The sign of the component across the tangent, along the normal.
    const int radial = board_.sign(board_.moment(board_.tangent(index), force));
    return material_side(index) * radial < 0;
}

bool ForceModel::is_between_round_profiles(const Joint& joint) {
    const auto is_round = [](const auto& each) { return std::holds_alternative<CircleProfile>(each.second); };
    return joint.pair().touches() && joint.profiles.size() == 2 &&
           std::any_of(joint.profiles.begin(), joint.profiles.end(), is_round);
}

std::vector<JointIndex> ForceModel::pulling_teeth(const Run& run) {
    std::vector<JointIndex> teeth;
    for (std::size_t b = 0; b < bonds_.size(); ++b)
        if (is_of_teeth(b) && pulls(b, run)) teeth.push_back(bonds_[b].joint);
    return teeth;
}

void ForceModel::turn_flanks(const std::vector<JointIndex>& teeth) {
    for (const JointIndex joint : teeth)
        if (!mirrored_gears_.insert(joint).second) mirrored_gears_.erase(joint);
    // Computes the lines of all teeth again: earlier board elements may have been rewound.
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
        if (!is_of_teeth(b)) continue;
        const JointIndex joint = bonds_[b].joint;
        bonds_[b].direction = mirrored_gears_.contains(joint) ? board_.other_normal(joint) : board_.normal(joint);
    }
}

int ForceModel::material_side(JointIndex index) {
    const Joint& joint = mechanism_.joints[at(index)];
    const auto curvature = [&](BodyIndex body) {
        const auto profile = joint.profiles.find(body);
        const auto* circle = profile == joint.profiles.end() ? nullptr : std::get_if<CircleProfile>(&profile->second);
        if (circle == nullptr) return board_.number(0);
        const auto radius = board_.vector(board_.place(circle->centre), board_.place(joint.point));
        return board_.quotient(board_.number(1), board_.moment(radius, board_.tangent(index)));
    };
    return board_.sign(board_.difference(curvature(joint.bodies[0]), curvature(joint.bodies[1])));
}

Action ForceModel::action(PlaceOnDrawing place, DirectionHandle direction) {
    return {place, direction, board_.through(place, direction)};
}

LineOn<drawing> ForceModel::line_of(const Wrench& wrench) {
    return board_.through(wrench.place, board_.direction(*wrench.force));
}

ScalarHandle ForceModel::moment(const Wrench& wrench, PlaceOnDrawing about) {
    if (!wrench.force) return wrench.couple ? *wrench.couple : board_.number(0);
    return board_.moment(board_.vector(about, wrench.place), *wrench.force);
}

Wrench ForceModel::with_couple(Wrench wrench, ScalarHandle couple) {
    if (board_.is_zero(couple)) return wrench;
    if (!wrench.force) {
        wrench.couple = wrench.couple ? board_.sum(*wrench.couple, couple) : couple;
        if (board_.is_zero(*wrench.couple)) wrench.couple.reset();
        return wrench;
    }
    wrench.place = board_.carry(wrench.place, board_.arm(couple, *wrench.force));
    return wrench;
}

Wrench ForceModel::sum(const Wrench& a, const Wrench& b) {
    if (a.vanishes()) return b;
    if (b.vanishes()) return a;
    if (!a.force && !b.force) return with_couple(a, *b.couple);
    if (!a.force) return with_couple(b, *a.couple);
    if (!b.force) return with_couple(a, *b.couple);
    Wrench total;
    total.force = board_.add(*a.force, *b.force);
    const auto first = line_of(a), second = line_of(b);
    if (!board_.parallel(first, second)) {
        total.place = *board_.meet(first, second);
        return total;
    }
    total.place = a.place;
    const ScalarHandle couple = moment(b, a.place);
    if (board_.is_zero(*total.force)) total.force.reset();
    return with_couple(total, couple);
}

Wrench ForceModel::wrench_of(const Load& load) {
    Wrench wrench;
    wrench.place = load.place;
    wrench.force = load.force;
    wrench.couple = load.couple;
    return wrench;
}

Wrench ForceModel::wrench_of(const Bond& bond, const Reaction& reaction, MemberIndex member) {
    Wrench wrench;
    wrench.place = bond.place;
    const bool reversed = bond.second == member;
    if (reaction.force) wrench.force = reversed ? board_.negate(*reaction.force) : *reaction.force;
    if (reaction.couple) {
        const ScalarHandle couple = reversed ? board_.opposite(*reaction.couple) : *reaction.couple;
        wrench = with_couple(wrench, couple);
    }
    return wrench;
}

Wrench ForceModel::known_on(const Group& group, const std::vector<Load>& loads, const Run& run) {
    Wrench total;
    for (const Load& load : loads) {
        if (in(group, load.member)) total = sum(total, wrench_of(load));
    }
    for (const int b : outer_bonds(group)) {
        const Reaction& reaction = run.reactions[at(b)];
        if (reaction.known)
            total = sum(total, wrench_of(bonds_[at(b)], reaction,
                                         in(group, bonds_[at(b)].first) ? bonds_[at(b)].first : bonds_[at(b)].second));
    }
    return total;
}

bool ForceModel::is_inner(const Load& load, const Group& group, const std::vector<Load>& loads) {
    return std::any_of(loads.begin(), loads.end(), [&](const Load& other) {
        return other.kind == load.kind && other.given == load.given && other.member != load.member &&
               in(group, other.member);
    });
}

std::array<ScalarHandle, 3> ForceModel::gap(MemberIndex member, const std::vector<Load>& loads, const Run& run,
                                            PlaceOnDrawing about) {
    const Wrench left = known_on({member}, loads, run);
    const auto component = [&](const Vector& across) {
        if (!left.force) return board_.number(0);
        return board_.moment(board_.own_direction(across), *left.force);
    };
    return {component({0, -1}), component({1, 0}), moment(left, about)};
}

std::vector<int> ForceModel::outer_bonds(const Group& group) const {
    std::vector<int> outer;
    for (const MemberIndex member : group) {
        for (const int b : bonds_of_[at(member)]) {
            if (in(group, bonds_[at(b)].first) != in(group, bonds_[at(b)].second)) outer.push_back(b);
        }
    }
    return outer;
}

}  // namespace kinegraph::statics
