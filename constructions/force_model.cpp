#include "constructions/force_model.hpp"

#include <algorithm>

#include "engine/assert.hpp"
#include "engine/spring_force.hpp"

namespace kinegraph::statics {

bool in(const Group& group, MemberIndex member) { return std::find(group.begin(), group.end(), member) != group.end(); }

Symbol marked(Symbol symbol, const std::string& mark) {
    if (!mark.empty()) symbol.term += (symbol.term.empty() ? "(" : ",(") + mark + ")";
    return symbol;
}

ForceModel::ForceModel(Structure& structure, Board& board, const Motion& motion)
    : structure_(structure),
      board_(board),
      mechanism_(structure.mechanism()),
      motion_(motion),
      members_(static_cast<int>(structure.mechanism().bodies.size())) {
    for (const JointIndex joint : indices_of(mechanism_.joints)) add_joint(joint);
    for (std::size_t e = 0; e < mechanism_.efforts.size(); ++e) add_effort(static_cast<int>(e));
    bonds_of_.resize(at(members_));
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
        bonds_of_[at(bonds_[b].first)].push_back(static_cast<int>(b));
        bonds_of_[at(bonds_[b].second)].push_back(static_cast<int>(b));
    }
    joint_bonds_ = bonds_.size();
    read_loads();
}

void ForceModel::add_components(int hinge) {
    for (const Vector& along : {Vector{1, 0}, Vector{0, 1}}) {
        Bond part = bonds_[at(hinge)];
        part.kind = Bond::Kind::line;
        part.direction = board_.own_direction(along);
        part.part_of = hinge;
        const int index = static_cast<int>(bonds_.size());
        bonds_of_[at(part.first)].push_back(index);
        bonds_of_[at(part.second)].push_back(index);
        bonds_.push_back(std::move(part));
    }
}

void ForceModel::drop_components() {
    for (auto& bonds : bonds_of_) std::erase_if(bonds, [&](int b) { return bonds_[at(b)].part_of >= 0; });
    bonds_.resize(joint_bonds_);
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
        // Two bodies that touch at several joints: F_12 at A is not F_12 at B.
        int common = 0;
        for (const Joint& other : mechanism_.joints)
            common += !other.has_own_node() && !joint.has_own_node() &&
                      std::minmax(other.bodies[0], other.bodies[1]) == std::minmax(joint.bodies[0], joint.bodies[1]);
        if (common > 1) one.symbol.term = one.reverse.term = joint.name;
        bonds_.push_back(one);
    };
    if (!joint.has_own_node()) return add(member_of(joint.bodies[0]), member_of(joint.bodies[1]));
    if (joint.pair().is_hinge()) {  // a multiple or a loaded hinge: a pin of its own, without weight
        pins_.push_back(joint.point);
        pin_of_.emplace(index, members_);
        const MemberIndex pin(members_++);
        for (const BodyIndex body : joint.bodies) add(member_of(body), pin);
    } else {
        for (std::size_t b = 1; b < joint.bodies.size(); ++b) add(member_of(joint.bodies[b]), member_of(joint.bodies[0]));
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
    if (!is_of_teeth(b)) return joint.pushes && board_.along_sign(board_.push(index), force) < 0;
    // How large the force is across the tangent, seen along the normal.
    const int radial = board_.sign(board_.moment(board_.tangent(index), force));
    return material_side(index) * radial < 0;
}

std::vector<JointIndex> ForceModel::pulling_teeth(const Run& run) {
    std::vector<JointIndex> teeth;
    for (std::size_t b = 0; b < joint_bonds_; ++b)
        if (is_of_teeth(b) && pulls(b, run)) teeth.push_back(bonds_[b].joint);
    return teeth;
}

void ForceModel::turn_flanks(const std::vector<JointIndex>& teeth) {
    for (const JointIndex joint : teeth)
        if (!mirrored_gears_.insert(joint).second) mirrored_gears_.erase(joint);
    // The lines of all of them: what was drawn of them since may be wiped off.
    for (std::size_t b = 0; b < joint_bonds_; ++b) {
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

void ForceModel::add_load(Load load) {
    if (load.member == member_of(frame)) return;
    if (load.force && board_.is_zero(*load.force)) load.force.reset();
    if (load.couple && board_.is_zero(*load.couple)) load.couple.reset();
    if (load.force || load.couple) loads_.push_back(std::move(load));
}

void ForceModel::read_loads() {
    for (std::size_t l = 0; l < mechanism_.loads.size(); ++l) {
        const auto index = static_cast<int>(l);
        const auto& given = mechanism_.loads[l];
        if (const auto* force = std::get_if<ForceLoad>(&given)) {
            const Force acting = force->value ? board_.load_force(index)
                                              : board_.scale<Plane::force>(board_.load_magnitude(index), board_.load_unit(index));
            const Symbol symbol{Symbol::Letter::F, force->name, {}};
            const MemberIndex member = force->pin == none ? member_of(force->body) : MemberIndex(pin_of_.at(force->pin));
            add_load({member, symbol, AppliedForce::Kind::load, acting, board_.place(force->at), {}, index});
        } else if (const auto* couple = std::get_if<CoupleLoad>(&given)) {
            const auto& points = mechanism_.bodies[at(couple->body)].points;
            add_load({member_of(couple->body),
                      {Symbol::Letter::M, couple->name, {}},
                      AppliedForce::Kind::load,
                      {},
                      board_.place(points.empty() ? PointIndex(0) : points.front()),
                      board_.load_magnitude(index),
                      index});
        } else if (const auto* distributed = std::get_if<DistributedLoad>(&given)) {
            add_distributed(index, *distributed);
        } else if (const auto* torsion = std::get_if<TorsionLoad>(&given)) {
            add_torsion(index, *torsion);
        } else {
            add_spring(index, std::get<SpringLoad>(given));
        }
    }
    for (std::size_t m = 0; m < mechanism_.masses.size(); ++m) {
        add_weight(static_cast<int>(m));
        if (mechanism_.inertia_forces) add_inertia(static_cast<int>(m));
    }
}

void ForceModel::add_spring(int index, const SpringLoad& spring) {
    const auto [first, second] = spring.between;
    if (board_.coincide(board_.place(first), board_.place(second))) {
        missing_.push_back({{Sentence::all_forces, {}}, {Sentence::spring_without_direction, {spring.name}}});
        return;
    }
    const std::size_t before = loads_.size();
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const DirectionHandle pull = end == 0 ? board_.load_unit(index) : board_.load_unit_back(index);
        add_load({member_of(spring.bodies[end]),
                  {Symbol::Letter::F, spring.name, {}},
                  AppliedForce::Kind::spring,
                  board_.scale<Plane::force>(board_.load_magnitude(index), pull),
                  board_.place(spring.between[end]),
                  {},
                  index});
    }
    const auto name = [&](PointIndex point) { return PointName{mechanism_.point(point).name}; };
    if (spring.elastic && loads_.size() > before)
        say_of_load(loads_.back(), {Sentence::elastic_spring, {loads_.back().symbol, name(first), name(second)}}, "Hooke");
}

void ForceModel::add_distributed(int index, const DistributedLoad& load) {
    const Centroid resultant = centroid_of(load);
    const Force force = board_.scale<Plane::force>(board_.load_magnitude(index), board_.load_unit(index));
    const auto share =
        board_.scale<drawing>(board_.number(resultant.place), board_.vector(board_.place(load.from), board_.place(load.to)));
    Load acting{member_of(load.body), {Symbol::Letter::F, load.name, {}}, AppliedForce::Kind::load, {}, {}, {}, index};
    if (resultant.is_couple) {
        acting.symbol.letter = Symbol::Letter::M;
        acting.place = board_.place(load.from);
        acting.couple = board_.moment(share, force);
    } else {
        acting.force = force;
        acting.place = board_.carry(board_.place(load.from), share);
    }
    const std::size_t before = loads_.size();
    add_load(acting);
    if (loads_.size() == before) return;
    const auto name = [&](PointIndex point) { return PointName{mechanism_.point(point).name}; };
    say_of_load(acting, {resultant.is_couple ? Sentence::distributed_couple : Sentence::distributed_load,
                         {BodyName{mechanism_.body(load.body).name}, acting.symbol, name(load.from), name(load.to)}});
}

void ForceModel::add_torsion(int index, const TorsionLoad& torsion) {
    const std::size_t before = loads_.size();
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const ScalarHandle couple = board_.load_magnitude(index);
        add_load({member_of(torsion.bodies[side]),
                  {Symbol::Letter::M, torsion.name, {}},
                  AppliedForce::Kind::spring,
                  {},
                  board_.place(torsion.at),
                  side == 0 ? couple : board_.opposite(couple),
                  index});
    }
    if (loads_.size() == before) return;
    const auto name = [&](BodyIndex body) { return BodyName{mechanism_.body(body).name}; };
    say_of_load(loads_.back(),
                {Sentence::torsion_spring, {loads_.back().symbol, name(torsion.bodies[0]), name(torsion.bodies[1])}}, "Hooke");
}

std::string ForceModel::mass_name(const Mass& mass, const char* letter) const {
    return mechanism_.masses.size() == 1 ? std::string(letter) : std::string(letter) + mechanism_.bodies[at(mass.body)].name;
}

void ForceModel::add_weight(int index) {
    if (!mechanism_.gravity) return;
    const Mass& mass = mechanism_.masses[at(index)];
    add_load({member_of(mass.body),
              {Symbol::Letter::F, mass_name(mass, "g"), {}},
              AppliedForce::Kind::weight,
              board_.scale<Plane::force>(board_.mass(index), board_.gravity()),
              board_.place(mass.centre),
              {},
              index});
}

void ForceModel::add_inertia(int index) {
    const Mass& mass = mechanism_.masses[at(index)];
    const auto& track = motion_.acceleration;
    const NodeIndex centre = structure_.find(mass.centre, mass.body);
    if (track.polygon < 0 || centre == none || !track.has(centre) || !track.turns(mass.body)) {
        missing_.push_back(
            {{Sentence::all_forces, {}}, {Sentence::inertia_without_motion, {BodyName{mechanism_.bodies[at(mass.body)].name}}}});
        return;
    }
    const auto acceleration = board_.vector(board_.pole<Plane::acceleration>(), track.tip(centre));
    Load load{member_of(mass.body),
              {Symbol::Letter::F, mass_name(mass, "i"), {}},
              AppliedForce::Kind::inertia,
              board_.negate(board_.scale<Plane::force>(board_.mass(index), acceleration)),
              board_.place(mass.centre),
              {},
              index};
    const BodyName body{mechanism_.bodies[at(mass.body)].name};
    const std::string& label = structure_.node(centre).label;
    add_said(load, {Sentence::inertia_force, {body, load.symbol, Symbol{Symbol::Letter::a, label, {}}, PointName{label}}});
    const Load force = load;
    load.force.reset();
    load.symbol.letter = Symbol::Letter::M;
    load.couple = board_.opposite(board_.product(board_.inertia(index), track.spin(mass.body)));
    add_said(load, {Sentence::inertia_couple, {body, load.symbol, Symbol{Symbol::Letter::alpha, body.name, {}}}});
    move_inertia(force, load);
}

void ForceModel::move_inertia(const Load& force, const Load& couple) {
    if (force.member == member_of(frame) || board_.is_zero(*force.force) || board_.is_zero(*couple.couple)) return;
    Added one{{force.member}, force.symbol, *force.force, {}, {}, none};
    one.place = board_.carry(force.place, board_.arm(*couple.couple, *force.force));
    one.statement = say_of_load(
        force, {Sentence::inertia_moved, {BodyName{member_name(force.member)}, force.symbol, couple.symbol}}, "d’Alembert");
    shifts_.push_back({force.member, force.place, *force.force, one.place, one.statement, true});
    moved_.push_back(std::move(one));
}

void ForceModel::add_said(const Load& load, Message message) {
    const std::size_t before = loads_.size();
    add_load(load);
    if (loads_.size() > before) say_of_load(load, std::move(message), "d’Alembert");
}

StatementIndex ForceModel::say_of_load(const Load& load, Message message, const char* source) {
    Statement statement;
    statement.message = std::move(message);
    statement.section = Topic::forces;
    statement.source = source;
    if (!is_pin(load.member)) statement.bodies = {body_of(load.member)};
    return board_.state(std::move(statement));
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

bool ForceModel::is_inner(const Load& load, const Group& group) const {
    return load.kind == AppliedForce::Kind::spring && std::any_of(loads_.begin(), loads_.end(), [&](const Load& other) {
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

std::vector<Group> ForceModel::floating() const { return hanging_together(false); }

std::vector<Group> ForceModel::single_on_frame() const {
    std::vector<Group> found = hanging_together(true);
    std::erase_if(found, [&](const Group& group) {
        return std::count_if(group.begin(), group.end(), [&](MemberIndex member) { return !is_pin(member); }) != 1;
    });
    return found;
}

std::vector<Group> ForceModel::hanging_together(bool on_frame) const {
    std::vector<Group> found;
    std::set<MemberIndex> seen;
    for (const MemberIndex first : moving_members()) {
        if (!seen.insert(first).second) continue;
        Group group{first};
        bool by_effort = false, by_frame = false;
        for (std::size_t next = 0; next < group.size(); ++next)
            for (const int b : bonds_of(group[next])) {
                const Bond& bond = bonds_[at(b)];
                const MemberIndex other = bond.first == group[next] ? bond.second : bond.first;
                by_effort = by_effort || bond.effort >= 0;
                by_frame = by_frame || other == member_of(frame);
                if (other != member_of(frame) && seen.insert(other).second) group.push_back(other);
            }
        std::sort(group.begin(), group.end());
        if (!by_effort && by_frame == on_frame) found.push_back(std::move(group));
    }
    return found;
}

std::vector<Group> ForceModel::hung_on_frame() const {
    std::vector<Group> found = hanging_together(true);
    std::erase_if(found, [&](const Group& group) { return group.size() == 1 || is_body_on_bars(group); });
    return found;
}

bool ForceModel::is_body_on_bars(const Group& group) const {
    const auto is_loaded = [&](MemberIndex member) {
        return std::any_of(loads_.begin(), loads_.end(), [&](const Load& load) { return load.member == member; });
    };
    // Where several bars share a hinge of the frame, its pin stands between.
    const auto reaches_frame = [&](MemberIndex bar, const Bond& bond) {
        const MemberIndex other = bond.first == bar ? bond.second : bond.first;
        const std::vector<int>& held = bonds_of(other);
        return other == member_of(frame) ||
               (is_pin(other) && std::any_of(held.begin(), held.end(), [&](int b) { return is_on_frame(bonds_[at(b)]); }));
    };
    const auto is_bar = [&](MemberIndex member) {
        const std::vector<int>& held = bonds_of(member);
        return !is_pin(member) && held.size() == 2 && !is_loaded(member) &&
               std::all_of(held.begin(), held.end(), [&](int b) { return bonds_[at(b)].kind == Bond::Kind::pin; });
    };
    const auto hangs_on_frame = [&](MemberIndex bar) {
        const std::vector<int>& held = bonds_of(bar);
        return std::any_of(held.begin(), held.end(), [&](int b) { return reaches_frame(bar, bonds_[at(b)]); });
    };
    std::ptrdiff_t bars = 0, bodies = 0;
    for (const MemberIndex member : group) {
        if (is_bar(member) && !hangs_on_frame(member)) return false;
        bars += is_bar(member) ? 1 : 0;
        bodies += !is_pin(member) && !is_bar(member) ? 1 : 0;
    }
    // Pins that bars share are no bodies, but what a pin bears the body does not feel. Where there is no other, one pin is what
    // the bars hold.
    const bool pin_loaded =
        std::any_of(group.begin(), group.end(), [&](MemberIndex member) { return is_pin(member) && is_loaded(member); });
    return (bodies == 1 && !pin_loaded) || (bodies == 0 && bars + 1 == static_cast<std::ptrdiff_t>(group.size()));
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
