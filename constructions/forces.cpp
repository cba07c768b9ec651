#include "constructions/forces.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

constexpr BodyIndex frame = 0;
constexpr Plane drawing = Plane::drawing;
std::size_t at(int index) { return static_cast<std::size_t>(index); }
using Place = PointOn<Plane::drawing>;
using Force = VectorOn<Plane::force>;

/// A line of action as the board has it: a place on it and its direction.
struct Action {
    Place place;
    DirectionHandle direction;
    LineOn<drawing> line;
};

/// What two bodies may exert on each other. Members: bodies of the mechanism, then the pins of multiple hinges.
struct Bond {
    enum class Kind { pin, guide, line, couple, clamp } kind = Kind::pin;
    int first = -1, second = -1;  ///< members; the force counts on `first`
    JointIndex joint = -1;
    int effort = -1;
    Place place;
    DirectionHandle direction;  ///< line: along it; guide: normal to it
    int part_of = -1;           ///< ≥ 0: a component, along x or y, of the force of this bond (a hinge)
    Symbol symbol;              ///< of the force on `first`
    Symbol reverse;             ///< of the force on `second`
};

/// What is known of a bond in one run.
struct Reaction {
    bool known = false;
    std::optional<Force> force;          ///< on the bond's first member; nothing: vanishes
    std::optional<ScalarHandle> couple;  ///< about the bond's place; nothing: vanishes
    std::optional<Action> action;        ///< its line, before or after the magnitude is known
    bool only_couple = false;            ///< a guide whose force was shown to vanish
    bool deduced = false;                ///< the line was found, not given
};

/// All that acts on a body, reduced: nothing, a couple, or a force along a line.
struct Wrench {
    std::optional<Force> force;
    Place place;
    std::optional<ScalarHandle> couple;  ///< only where there is no force

    bool vanishes() const { return !force && !couple; }
};

/// A load on one member.
struct Load {
    int member = -1;
    Symbol symbol;
    AppliedForce::Kind kind = AppliedForce::Kind::load;
    std::optional<Force> force;
    Place place;
    std::optional<ScalarHandle> couple;
};

/// What was done at one member, for its free-body diagram.
struct Resolved {
    int member = -1;
    std::vector<std::pair<std::string, Place>> meets;
};

/// One force of a body's polygon.
struct Side {
    Symbol symbol;
    Force force;
    int bond = -1;         ///< −1: a load
    bool external = true;  ///< a load, an effort or reaction of the frame
};

struct Run {
    std::vector<Reaction> reactions;  ///< by bond
    std::vector<Resolved> order;
    bool complete = false;
};

class Statics {
public:
    Statics(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility)
        : structure_(structure), board_(board), mechanism_(structure.mechanism()), motion_(motion), mobility_(mobility) {}

    ForceResults draw() {
        members_ = static_cast<int>(mechanism_.bodies.size());
        for (std::size_t j = 0; j < mechanism_.joints.size(); ++j) add_joint(static_cast<JointIndex>(j));
        for (std::size_t e = 0; e < mechanism_.efforts.size(); ++e) add_effort(static_cast<int>(e));
        bonds_of_.resize(at(members_));
        for (std::size_t b = 0; b < bonds_.size(); ++b) {
            bonds_of_[at(bonds_[b].first)].push_back(static_cast<int>(b));
            bonds_of_[at(bonds_[b].second)].push_back(static_cast<int>(b));
        }
        joint_bonds_ = bonds_.size();
        origin_ = board_.place(0);
        read_loads();
        if (!results_.unsolved.empty()) return std::move(results_);
        Run run = solve(loads_);
        for (std::size_t round = 0; round < mechanism_.joints.size() && turn_gears(run); ++round) run = solve(loads_);
        gather_components(run);
        collect(run);
        return std::move(results_);
    }

private:
    // --- what may act -------------------------------------------------------------------------------------------------------
    std::string member_name(int member) const {
        if (member < static_cast<int>(mechanism_.bodies.size())) return mechanism_.bodies[at(member)].name;
        return mechanism_.points[at(pins_[at(member - static_cast<int>(mechanism_.bodies.size()))])].name;
    }
    bool is_pin(int member) const { return member >= static_cast<int>(mechanism_.bodies.size()); }

    /// F_32: of 3 on 2.
    Symbol force_symbol(int of, int on) const {
        return {Symbol::Letter::F, relative_name_of_bodies(member_name(of), member_name(on)), {}};
    }
    static std::string relative_name_of_bodies(const std::string& of, const std::string& on) {
        return of.size() == 1 && on.size() == 1 ? of + on : of + "," + on;
    }

    void add_joint(JointIndex index) {
        const Joint& joint = mechanism_.joints[at(index)];
        Bond bond;
        bond.joint = index;
        bond.place = board_.place(joint.point);
        switch (joint.kind) {
            case JointKind::revolute:
            case JointKind::rolling:
                bond.kind = Bond::Kind::pin;
                break;
            case JointKind::prismatic:
                bond.kind = Bond::Kind::guide;
                bond.direction = board_.perpendicular(board_.guide(index));
                break;
            case JointKind::pin_slot:
            case JointKind::contact:
            case JointKind::gear:
                bond.kind = Bond::Kind::line;
                bond.direction = board_.normal(index);
                break;
            case JointKind::weld:
                bond.kind = Bond::Kind::clamp;
                break;
        }
        const auto add = [&](int first, int second) {
            Bond one = bond;
            one.first = first;
            one.second = second;
            one.symbol = force_symbol(second, first);
            one.reverse = force_symbol(first, second);
            // Two bodies that touch at several joints: F_12 at A is not F_12 at B.
            int common = 0;
            for (const Joint& other : mechanism_.joints)
                common += other.bodies.size() == 2 && joint.bodies.size() == 2 &&
                          std::minmax(other.bodies[0], other.bodies[1]) == std::minmax(joint.bodies[0], joint.bodies[1]);
            if (common > 1) one.symbol.term = one.reverse.term = joint.name;
            bonds_.push_back(one);
        };
        if (joint.bodies.size() == 2) return add(joint.bodies[0], joint.bodies[1]);
        if (joint.kind == JointKind::revolute) {  // a multiple hinge: a pin of its own, without weight
            pins_.push_back(joint.point);
            const int pin = members_++;
            for (const BodyIndex body : joint.bodies) add(body, pin);
        } else {
            for (std::size_t b = 1; b < joint.bodies.size(); ++b) add(joint.bodies[b], joint.bodies[0]);
        }
    }

    void add_effort(int index) {
        Bond bond;
        bond.effort = index;
        const Effort& effort = mechanism_.efforts[at(index)];
        if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
            bond.kind = Bond::Kind::couple;
            bond.first = couple->body;
            bond.second = couple->from;
            bond.symbol = {Symbol::Letter::M, couple->name, {}};
            const auto& points = mechanism_.bodies[at(couple->body)].points;
            bond.place = board_.place(points.empty() ? 0 : points.front());
        } else if (const auto* force = std::get_if<ForceEffort>(&effort)) {
            bond.kind = Bond::Kind::line;
            bond.first = force->body;
            bond.second = frame;
            bond.symbol = {Symbol::Letter::F, force->name, {}};
            bond.place = board_.place(force->at);
            const Bearing along = force->along;
            bond.direction = board_.direction(
                board_.given<drawing>([along](const Pose& pose) { return unit_along(direction_of(along, pose), pose.bits); }));
        } else {
            const auto& actuator = std::get<ActuatorEffort>(effort);
            const Joint& joint = mechanism_.joints[at(actuator.joint)];
            bond.kind = Bond::Kind::line;
            bond.first = joint.bodies[0];
            bond.second = joint.bodies[1];
            bond.symbol = {Symbol::Letter::F, actuator.name, {}};
            bond.place = board_.place(joint.point);
            bond.direction = board_.guide_unit(actuator.joint);
        }
        bond.reverse = bond.symbol;
        bonds_.push_back(bond);
    }

    /// Teeth only push: the force on a gear points into its own material. Where the line of action tried makes them pull, the
    /// other one, mirrored at the common tangent, is taken. True where a line was changed.
    bool turn_gears(const Run& run) {
        bool changed = false;
        for (std::size_t b = 0; b < joint_bonds_; ++b) {
            Bond& bond = bonds_[b];
            if (bond.joint < 0 || mechanism_.joints[at(bond.joint)].kind != JointKind::gear || !run.reactions[b].force) continue;
            const JointIndex joint = bond.joint;
            const Vector normal = quarter_turn(board_.pose().tangents[at(joint)]);
            const int radial = dot(board_.value(*run.reactions[b].force), normal).sign();
            if (material_side(joint) * radial >= 0) continue;
            const bool mirror = mirrored_gears_.insert(joint).second;
            if (!mirror) mirrored_gears_.erase(joint);
            const auto mirrored = [joint](const Pose& pose) {
                const Vector &d = pose.normals[at(joint)], &t = pose.tangents[at(joint)];
                return (2 * dot(d, t) / squared_length(t)) * t - d;
            };
            bond.direction = mirror ? board_.direction(board_.given<drawing>(mirrored)) : board_.normal(joint);
            changed = true;
        }
        return changed;
    }

    /// On which side of the common tangent's normal the material of bodies[0] lies: the sign of 1/x_0 − 1/x_1, x the centres'
    /// places along it (0 for a rack); 0 where the file gives only a tangent.
    int material_side(JointIndex index) const {
        const Joint& joint = mechanism_.joints[at(index)];
        const Vector normal = quarter_turn(board_.pose().tangents[at(index)]);
        const auto curvature = [&](BodyIndex body) {
            const auto profile = joint.profiles.find(body);
            const auto* circle = profile == joint.profiles.end() ? nullptr : std::get_if<CircleProfile>(&profile->second);
            if (circle == nullptr) return Exact();
            return 1 / dot(board_.pose().at(circle->centre) - board_.pose().at(joint.point), normal);
        };
        return (curvature(joint.bodies[0]) - curvature(joint.bodies[1])).sign();
    }

    // --- loads ----------------------------------------------------------------------------------------------------------------
    void add_load(Load load) {
        if (load.member == frame) return;
        if (load.force && board_.is_zero(*load.force)) load.force.reset();
        if (load.couple && board_.is_zero(*load.couple)) load.couple.reset();
        if (load.force || load.couple) loads_.push_back(std::move(load));
    }

    void read_loads() {
        for (const auto& given : mechanism_.loads) {
            if (const auto* force = std::get_if<ForceLoad>(&given)) {
                const ForceLoad& load = *force;
                const auto vector = [load](const Pose& pose) {
                    if (load.value) return *load.value;
                    return load.magnitude->first * unit_along(direction_of(load.magnitude->second, pose), pose.bits);
                };
                add_load({load.body,
                          {Symbol::Letter::F, load.name, {}},
                          AppliedForce::Kind::load,
                          board_.given<Plane::force>(vector),
                          board_.place(load.at),
                          {}});
            } else if (const auto* couple = std::get_if<CoupleLoad>(&given)) {
                const auto& points = mechanism_.bodies[at(couple->body)].points;
                add_load({couple->body,
                          {Symbol::Letter::M, couple->name, {}},
                          AppliedForce::Kind::load,
                          {},
                          board_.place(points.empty() ? 0 : points.front()),
                          board_.given(couple->value)});
            } else {
                add_spring(std::get<SpringLoad>(given));
            }
        }
        for (const Mass& mass : mechanism_.masses) {
            add_weight(mass);
            if (mechanism_.inertia_forces) add_inertia(mass);
        }
    }

    void add_spring(const SpringLoad& spring) {
        for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
            const PointIndex from = spring.between[end], to = spring.between[1 - end];
            const Exact magnitude = spring.magnitude;
            if (board_.coincide(board_.place(from), board_.place(to))) {
                results_.unsolved.push_back(
                    {"forces", "the ends of " + spring.name + " coincide at this position: its pull has no direction"});
                return;
            }
            const auto pull = [=](const Pose& pose) { return magnitude * unit_along(pose.at(to) - pose.at(from), pose.bits); };
            add_load({spring.bodies[end],
                      {Symbol::Letter::F, spring.name, {}},
                      AppliedForce::Kind::spring,
                      board_.given<Plane::force>(pull),
                      board_.place(from),
                      {}});
        }
    }

    std::string mass_name(const Mass& mass, const char* letter) const {
        return mechanism_.masses.size() == 1 ? std::string(letter) : std::string(letter) + mechanism_.bodies[at(mass.body)].name;
    }

    void add_weight(const Mass& mass) {
        if (!mechanism_.gravity) return;
        const Vector weight = mass.mass * *mechanism_.gravity;
        add_load({mass.body,
                  {Symbol::Letter::F, mass_name(mass, "g"), {}},
                  AppliedForce::Kind::weight,
                  board_.given<Plane::force>([weight](const Pose&) { return weight; }),
                  board_.place(mass.centre),
                  {}});
    }

    /// d'Alembert: −m a_G at the mass centre and −J_G α.
    void add_inertia(const Mass& mass) {
        const auto& track = motion_.acceleration;
        const NodeIndex centre = structure_.find(mass.centre, mass.body);
        if (track.polygon < 0 || centre < 0 || !track.has(centre) || !track.turns(mass.body)) {
            results_.unsolved.push_back({"forces", "the inertia forces of body " + mechanism_.bodies[at(mass.body)].name +
                                                       " need its acceleration, which is not known; give \"drivers\""});
            return;
        }
        const auto acceleration = board_.vector(board_.pole<Plane::acceleration>(), track.tip(centre));
        Load load{mass.body,
                  {Symbol::Letter::F, mass_name(mass, "i"), {}},
                  AppliedForce::Kind::inertia,
                  board_.scale<Plane::force>(board_.given(-mass.mass), acceleration),
                  board_.place(mass.centre),
                  {}};
        add_load(load);
        load.force.reset();
        load.symbol.letter = Symbol::Letter::M;
        load.couple = board_.product(board_.given(-mass.inertia), track.spin(mass.body));
        add_load(load);
    }

    // --- wrenches -----------------------------------------------------------------------------------------------------------
    Action action(Place place, DirectionHandle direction) { return {place, direction, board_.through(place, direction)}; }
    LineOn<drawing> line_of(const Wrench& wrench) { return board_.through(wrench.place, board_.direction(*wrench.force)); }

    /// Moment of a wrench about a place.
    ScalarHandle moment(const Wrench& wrench, Place about) {
        if (!wrench.force) return wrench.couple ? *wrench.couple : board_.given(0);
        return board_.moment(board_.vector(about, wrench.place), *wrench.force);
    }

    Wrench with_couple(Wrench wrench, ScalarHandle couple) {
        if (board_.is_zero(couple)) return wrench;
        if (!wrench.force) {
            wrench.couple = wrench.couple ? board_.sum(*wrench.couple, couple) : couple;
            if (board_.is_zero(*wrench.couple)) wrench.couple.reset();
            return wrench;
        }
        wrench.place = board_.carry(wrench.place, board_.arm(couple, *wrench.force));
        return wrench;
    }

    /// The sum of two: through the meet of their lines; of parallel ones by moments; a couple where equal and opposite.
    Wrench sum(const Wrench& a, const Wrench& b) {
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

    Wrench wrench_of(const Load& load) {
        Wrench wrench;
        wrench.place = load.place;
        wrench.force = load.force;
        wrench.couple = load.couple;
        return wrench;
    }

    Wrench wrench_of(const Bond& bond, const Reaction& reaction, int member) {
        Wrench wrench;
        wrench.place = bond.place;
        const bool reversed = bond.second == member;
        if (reaction.force) wrench.force = reversed ? board_.negate(*reaction.force) : *reaction.force;
        if (reaction.couple) {
            const ScalarHandle couple = reversed ? board_.difference(board_.given(0), *reaction.couple) : *reaction.couple;
            wrench = with_couple(wrench, couple);
        }
        return wrench;
    }

    /// Loads and known reactions of a member (or of several taken together), reduced.
    Wrench known_on(const std::vector<int>& group, const std::vector<Load>& loads, const Run& run) {
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

    static bool in(const std::vector<int>& group, int member) {
        return std::find(group.begin(), group.end(), member) != group.end();
    }

    /// Bonds between a group and the rest.
    std::vector<int> outer_bonds(const std::vector<int>& group) const {
        std::vector<int> outer;
        for (const int member : group) {
            for (const int b : bonds_of_[at(member)]) {
                if (in(group, bonds_[at(b)].first) != in(group, bonds_[at(b)].second)) outer.push_back(b);
            }
        }
        return outer;
    }

    // --- one run ------------------------------------------------------------------------------------------------------------
    enum class Shape { pin, guide, line, couple, clamp };

    Shape shape(int b, const Run& run) const {
        const Bond& bond = bonds_[at(b)];
        const Reaction& reaction = run.reactions[at(b)];
        if (bond.kind == Bond::Kind::couple || reaction.only_couple) return Shape::couple;
        if (reaction.action) return Shape::line;
        if (bond.kind == Bond::Kind::pin) return Shape::pin;
        if (bond.kind == Bond::Kind::guide) return Shape::guide;
        return Shape::clamp;
    }

    Run fresh() {
        Run run;
        run.reactions.resize(joint_bonds_);
        for (std::size_t b = 0; b < joint_bonds_; ++b) {
            if (bonds_[b].kind == Bond::Kind::line) run.reactions[b].action = action(bonds_[b].place, bonds_[b].direction);
        }
        fit(run);
        return run;
    }

    /// Components added since the run began: open where their hinge is, else nothing more.
    void fit(Run& run) {
        for (std::size_t b = run.reactions.size(); b < bonds_.size(); b += 2) {
            Reaction& hinge = run.reactions[at(bonds_[b].part_of)];
            Reaction parts[2];
            for (std::size_t i = 0; i < 2; ++i) {
                parts[i].known = hinge.known;
                if (!hinge.known) parts[i].action = action(bonds_[b + i].place, bonds_[b + i].direction);
            }
            hinge.known = true;
            for (Reaction& part : parts) run.reactions.push_back(part);
        }
    }

    /// A hinge whose force has no line is tried by its components.
    void split(int pin) {
        for (const Vector& along : {Vector{1, 0}, Vector{0, 1}}) {
            Bond part = bonds_[at(pin)];
            part.kind = Bond::Kind::line;
            part.direction = board_.given_direction(along);
            part.part_of = pin;
            const int index = static_cast<int>(bonds_.size());
            bonds_of_[at(part.first)].push_back(index);
            bonds_of_[at(part.second)].push_back(index);
            bonds_.push_back(std::move(part));
        }
    }

    std::vector<std::vector<int>> groups() const {
        std::vector<std::vector<int>> result;
        for (int member = 1; member < members_; ++member) result.push_back({member});
        // Bodies that slide in one another, taken together; then any two that touch.
        for (const bool only_guides : {true, false}) {
            for (const Bond& bond : bonds_) {
                if (bond.first == frame || bond.second == frame || bond.effort >= 0) continue;
                if (only_guides != (bond.kind == Bond::Kind::guide)) continue;
                result.push_back({std::min(bond.first, bond.second), std::max(bond.first, bond.second)});
            }
        }
        return result;
    }

    bool all_known(const Run& run) const {
        return std::all_of(run.reactions.begin(), run.reactions.end(), [](const Reaction& r) { return r.known; });
    }

    /// The rules, until no more follows.
    void advance(const std::vector<Load>& loads, Run& run) {
        fit(run);
        const auto all = groups();
        const auto any = [&](auto rule) { return std::any_of(all.begin(), all.end(), rule); };
        const auto direct = [&](const auto& group) { return magnitudes(group, loads, run) || lines(group, loads, run, false); };
        const auto beside_couples = [&](const auto& group) { return lines(group, loads, run, true); };
        while (!all_known(run) && (any(direct) || any(beside_couples))) {
        }
        run.complete = all_known(run);
    }

    std::vector<int> unknown_of(const std::vector<int>& group, const Run& run) const {
        std::vector<int> unknown;
        for (const int b : outer_bonds(group)) {
            if (!run.reactions[at(b)].known) unknown.push_back(b);
        }
        return unknown;
    }

    int say(Sentence sentence, std::vector<Argument> arguments, const char* source = "") {
        Statement statement;
        statement.message = {sentence, std::move(arguments)};
        statement.section = "forces";
        statement.source = source;
        return board_.state(std::move(statement));
    }
    Argument name(const std::vector<int>& group) const {
        std::string names;
        for (const int member : group) names += (names.empty() ? "" : " + ") + member_name(member);
        return BodyName{names};
    }
    PointName place_name(int b) const {
        const Bond& bond = bonds_[at(b)];
        if (bond.joint >= 0) return {mechanism_.points[at(mechanism_.joints[at(bond.joint)].point)].name};
        return {bond.symbol.about};
    }
    /// The force of a bond as it acts on a group.
    Symbol symbol_on(int b, const std::vector<int>& group) const {
        const Bond& bond = bonds_[at(b)];
        return in(group, bond.first) ? bond.symbol : bond.reverse;
    }

    // --- lines of action ------------------------------------------------------------------------------------------------------
    /// `beside_couples`: bodies that carry a couple too; tried when nothing else is left.
    bool lines(const std::vector<int>& group, const std::vector<Load>& loads, Run& run, bool beside_couples) {
        const std::vector<int> unknown = unknown_of(group, run);
        std::vector<int> pins, guides, fixed, couples;
        for (const int b : unknown) {
            switch (shape(b, run)) {
                case Shape::pin:
                    pins.push_back(b);
                    break;
                case Shape::guide:
                    guides.push_back(b);
                    break;
                case Shape::line:
                    fixed.push_back(b);
                    break;
                case Shape::couple:
                    couples.push_back(b);
                    break;
                case Shape::clamp:
                    return false;
            }
        }
        const std::size_t forces = pins.size() + guides.size() + fixed.size();
        if ((pins.empty() && guides.empty()) || couples.empty() == beside_couples) return false;
        if (forces < 2 || forces > 3 || couples.size() > 1) return false;
        if (forces == 3 && (fixed.size() != 2 || !couples.empty())) return false;
        if (forces == 2 && fixed.size() == 2) return false;
        if (!known_on(group, loads, run).vanishes()) return false;
        if (forces == 3) return concurrent(group, fixed, pins, guides, run);
        if (!couples.empty()) return parallel_to_other(group, pins, guides, fixed, run);
        return two_forces(group, pins, guides, fixed, run);
    }

    void settle_line(int b, const Action& found, Run& run) {
        Reaction& reaction = run.reactions[at(b)];
        reaction.action = found;
        reaction.deduced = true;
    }

    void vanish(int b, Run& run) {
        Reaction& reaction = run.reactions[at(b)];
        if (bonds_[at(b)].kind == Bond::Kind::guide) {
            reaction.only_couple = true;
        } else {
            reaction.known = true;
        }
    }

    /// Two forces only: equal, opposite, on one line.
    bool two_forces(const std::vector<int>& group, const std::vector<int>& pins, const std::vector<int>& guides,
                    const std::vector<int>& fixed, Run& run) {
        const auto join_direction = [&](Place p, Place q) { return board_.direction(board_.vector(p, q)); };
        if (pins.size() == 2) {
            const Bond &one = bonds_[at(pins[0])], &two = bonds_[at(pins[1])];
            if (board_.coincide(one.place, two.place)) return false;
            say(group.size() > 1 ? Sentence::two_force_group : Sentence::two_force_body,
                {name(group), place_name(pins[0]), place_name(pins[1])});
            const Action found = action(one.place, join_direction(one.place, two.place));
            settle_line(pins[0], found, run);
            settle_line(pins[1], found, run);
            return true;
        }
        if (pins.size() == 1 && guides.size() == 1) {
            say(Sentence::two_force_guide, {name(group), place_name(pins[0]), place_name(guides[0])});
            const Action found = action(bonds_[at(pins[0])].place, bonds_[at(guides[0])].direction);
            settle_line(pins[0], found, run);
            settle_line(guides[0], found, run);
            return true;
        }
        if (pins.size() == 1 && fixed.size() == 1) {
            const Action given = *run.reactions[at(fixed[0])].action;
            if (board_.on_line(bonds_[at(pins[0])].place, given.line)) {
                say(Sentence::two_force_body, {name(group), place_name(pins[0]), place_name(fixed[0])});
                settle_line(pins[0], given, run);
            } else {
                say(Sentence::zero_forces, {name(group)});
                vanish(pins[0], run);
                vanish(fixed[0], run);
            }
            return true;
        }
        if (guides.size() == 2) {
            if (board_.parallel(bonds_[at(guides[0])].direction, bonds_[at(guides[1])].direction)) return false;
            say(Sentence::zero_forces, {name(group)});
            vanish(guides[0], run);
            vanish(guides[1], run);
            return true;
        }
        // A guide and a line: the guide's reaction can take any place.
        const Action given = *run.reactions[at(fixed[0])].action;
        if (board_.parallel(bonds_[at(guides[0])].direction, given.direction)) {
            say(Sentence::two_force_guide, {name(group), place_name(fixed[0]), place_name(guides[0])});
            settle_line(guides[0], given, run);
        } else {
            say(Sentence::zero_forces, {name(group)});
            vanish(guides[0], run);
            vanish(fixed[0], run);
        }
        return true;
    }

    /// Two forces and a couple: the forces are equal and opposite, so parallel.
    bool parallel_to_other(const std::vector<int>& group, const std::vector<int>& pins, const std::vector<int>& guides,
                           const std::vector<int>& fixed, Run& run) {
        if (pins.size() != 1) return false;
        const DirectionHandle direction =
            fixed.empty() ? bonds_[at(guides[0])].direction : run.reactions[at(fixed[0])].action->direction;
        say(Sentence::two_forces_and_couple, {name(group), place_name(pins[0])});
        settle_line(pins[0], action(bonds_[at(pins[0])].place, direction), run);
        return true;
    }

    /// Three forces, two lines known: the third passes through their meet.
    bool concurrent(const std::vector<int>& group, const std::vector<int>& fixed, const std::vector<int>& pins,
                    const std::vector<int>& guides, Run& run) {
        const Action one = *run.reactions[at(fixed[0])].action, two = *run.reactions[at(fixed[1])].action;
        const auto met = board_.meet(one.line, two.line);
        if (!met) return false;
        const int third = pins.empty() ? guides[0] : pins[0];
        const Bond& bond = bonds_[at(third)];
        const bool parallel = board_.is_at_infinity(*met);
        std::optional<Action> found;
        if (!pins.empty()) {
            if (parallel) {
                found = action(bond.place, one.direction);
            } else {
                if (board_.coincide(*met, bond.place)) return false;
                found = action(bond.place, board_.direction(board_.vector(*met, bond.place)));
            }
        } else {
            if (parallel) return false;
            found = action(*met, bond.direction);
        }
        const std::string letter = parallel ? "∞" : meet_name(group, *met);
        say(Sentence::three_force_line, {name(group), PointName{letter}, symbol_on(third, group), place_name(third)}, "Culmann");
        settle_line(third, *found, run);
        return true;
    }

    // --- magnitudes
    // -------------------------------------------------------------------------------------------------------------
    void settle(int b, Force force_on_group, Place place, const std::vector<int>& group, Run& run) {
        const Bond& bond = bonds_[at(b)];
        Reaction& reaction = run.reactions[at(b)];
        reaction.known = true;
        if (board_.is_zero(force_on_group)) return;
        reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
        if (!reaction.action) reaction.action = action(place, board_.direction(*reaction.force));
        if (bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp) {
            const ScalarHandle couple = board_.moment(board_.vector(bond.place, place), *reaction.force);
            if (!board_.is_zero(couple)) reaction.couple = couple;
        }
    }

    /// A guide or a clamp takes force and couple: its real line is moved aside by their arm.
    void settle_with_couple(int b, Force force_on_group, ScalarHandle couple_on_group, const std::vector<int>& group, Run& run) {
        const Bond& bond = bonds_[at(b)];
        settle_couple(b, couple_on_group, group, run);
        if (board_.is_zero(force_on_group)) return;
        Reaction& reaction = run.reactions[at(b)];
        reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
        const Place place =
            reaction.couple ? board_.carry(bond.place, board_.arm(*reaction.couple, *reaction.force)) : bond.place;
        if (!reaction.action) reaction.action = action(place, board_.direction(*reaction.force));
    }

    void settle_couple(int b, ScalarHandle couple_on_group, const std::vector<int>& group, Run& run) {
        Reaction& reaction = run.reactions[at(b)];
        reaction.known = true;
        if (board_.is_zero(couple_on_group)) return;
        reaction.couple = in(group, bonds_[at(b)].first) ? couple_on_group : board_.difference(board_.given(0), couple_on_group);
    }

    void note(const std::vector<int>& group, Run& run) {
        for (const int member : group) {
            const bool there =
                std::any_of(run.order.begin(), run.order.end(), [&](const Resolved& r) { return r.member == member; });
            if (!there) run.order.push_back({member, {}});
        }
    }

    std::string meet_name(const std::vector<int>& group, Place place) {
        for (const auto& [known, letter] : named_meets_) {
            if (board_.coincide(known, place)) return remember(group, place, letter);
        }
        static const char* const letters[] = {"H", "K", "L", "Q", "R", "T", "U", "V", "W", "Y", "Z"};
        for (int round = 0;; ++round) {
            for (const char* letter : letters) {
                const std::string candidate = letter + (round == 0 ? std::string() : std::to_string(round));
                if (mechanism_.point_named(candidate)) continue;
                if (std::any_of(named_meets_.begin(), named_meets_.end(), [&](const auto& m) { return m.second == candidate; }))
                    continue;
                named_meets_.emplace_back(place, candidate);
                return remember(group, place, candidate);
            }
        }
    }
    std::string remember(const std::vector<int>& group, Place place, const std::string& letter) {
        for (const int member : group) meets_of_[member].emplace_back(letter, place);
        return letter;
    }

    bool magnitudes(const std::vector<int>& group, const std::vector<Load>& loads, Run& run) {
        const std::vector<int> unknown = unknown_of(group, run);
        if (unknown.empty()) return false;
        std::vector<int> pins, guides, fixed, couples, clamps;
        for (const int b : unknown) {
            switch (shape(b, run)) {
                case Shape::pin:
                    pins.push_back(b);
                    break;
                case Shape::guide:
                    guides.push_back(b);
                    break;
                case Shape::line:
                    fixed.push_back(b);
                    break;
                case Shape::couple:
                    couples.push_back(b);
                    break;
                case Shape::clamp:
                    clamps.push_back(b);
                    break;
            }
        }
        const std::size_t count = 2 * (pins.size() + guides.size()) + fixed.size() + couples.size() + 3 * clamps.size();
        if (count > 3 || couples.size() > 1) return false;
        const Wrench known = known_on(group, loads, run);
        bool done = false;
        if (unknown.size() == 1) {
            done = single(group, unknown[0], known, run);
        } else if (pins.size() == 1 && couples.size() == 1) {
            done = force_and_couple(group, pins[0], couples[0], known, run);
        } else if (pins.size() == 1 && fixed.size() == 1) {
            done = line_and_pin(group, fixed[0], pins[0], known, run);
        } else if (guides.size() == 1 && fixed.size() == 1) {
            done = line_and_guide(group, fixed[0], guides[0], known, run);
        } else if (fixed.size() == 2) {
            done = two_lines(group, fixed[0], fixed[1], couples.empty() ? -1 : couples[0], known, run);
        } else if (fixed.size() == 1 && couples.size() == 1) {
            done = force_and_couple(group, fixed[0], couples[0], known, run);
        } else if (fixed.size() == 3) {
            done = three_lines(group, fixed, known, run);
        }
        if (done) note(group, run);
        return done;
    }

    Force opposite(const Wrench& known) { return board_.negate(*known.force); }

    /// The part of −F that a line or a guide can give: all of it where the loads allow equilibrium; what is missing shows as a
    /// gap.
    Force opposite_along(const Wrench& known, DirectionHandle direction) {
        const Force unit = board_.scale<Plane::force>(board_.given(1), direction);
        return board_.scale<Plane::force>(board_.ratio(opposite(known), unit), direction);
    }

    /// What is left balances the rest.
    bool single(const std::vector<int>& group, int b, const Wrench& known, Run& run) {
        const Shape of = shape(b, run);
        say(Sentence::single_reaction, {name(group), symbol_on(b, group)});
        if (of == Shape::couple) {
            settle_couple(b, board_.difference(board_.given(0), moment(known, bonds_[at(b)].place)), group, run);
            return true;
        }
        const bool takes_couple = bonds_[at(b)].kind == Bond::Kind::guide || bonds_[at(b)].kind == Bond::Kind::clamp;
        if (of == Shape::line) {
            const Action line = *run.reactions[at(b)].action;
            if (known.force) {
                settle(b, opposite_along(known, line.direction), line.place, group, run);
            } else {
                run.reactions[at(b)].known = true;
            }
        } else if (takes_couple) {
            const ScalarHandle couple = board_.difference(board_.given(0), moment(known, bonds_[at(b)].place));
            if (known.force) {
                const Force force = of == Shape::guide ? opposite_along(known, bonds_[at(b)].direction) : opposite(known);
                settle_with_couple(b, force, couple, group, run);
            } else {
                settle_couple(b, couple, group, run);
            }
        } else if (known.force) {
            settle(b, opposite(known), bonds_[at(b)].place, group, run);
        } else {
            run.reactions[at(b)].known = true;
        }
        return true;
    }

    /// A place on a bond's line, or its own.
    Place place_of(int b, const Run& run) const {
        const Reaction& reaction = run.reactions[at(b)];
        return reaction.action ? reaction.action->place : bonds_[at(b)].place;
    }

    /// A force through a point and a couple: the force is the rest turned round, the couple their arm times it.
    bool force_and_couple(const std::vector<int>& group, int force, int couple, const Wrench& known, Run& run) {
        const Place place = place_of(force, run);
        say(Sentence::force_and_couple, {name(group), symbol_on(force, group), symbol_on(couple, group)});
        const ScalarHandle balancing = board_.difference(board_.given(0), moment(known, place));
        if (known.force) {
            const auto& line = run.reactions[at(force)].action;
            settle(force, line ? opposite_along(known, line->direction) : opposite(known), place, group, run);
        } else {
            run.reactions[at(force)].known = true;
        }
        settle_couple(couple, balancing, group, run);
        return true;
    }

    /// s·d of a force along a line, so that its moment about a place balances the known one (Ritter).
    std::optional<Force> by_moments(const Action& line, Place about, const Wrench& known) {
        const ScalarHandle lever = board_.moment(board_.vector(about, line.place), line.direction);
        if (board_.is_zero(lever)) return std::nullopt;
        const ScalarHandle size = board_.quotient(board_.difference(board_.given(0), moment(known, about)), lever);
        return board_.scale<Plane::force>(size, line.direction);
    }

    /// Closes F + X + Y = 0 with X along d, Y along e, not parallel: the force triangle.
    std::pair<Force, Force> triangle(const Wrench& known, DirectionHandle d, DirectionHandle e) {
        const auto start = board_.pole<Plane::force>();
        const auto end = known.force ? board_.carry(start, *known.force) : start;
        const auto corner = board_.meet(board_.through(end, d), board_.through(start, e));
        KG_ASSERT(corner && !board_.is_at_infinity(*corner), "the sides of a force triangle are not parallel");
        return {board_.vector(end, *corner), board_.vector(*corner, start)};
    }

    bool line_and_pin(const std::vector<int>& group, int line, int pin, const Wrench& known, Run& run) {
        const Action given = *run.reactions[at(line)].action;
        const Place place = bonds_[at(pin)].place;
        if (board_.on_line(place, given.line)) return false;  // the moment about the pin says nothing of it
        if (known.vanishes()) {
            say(Sentence::zero_forces, {name(group)});
            run.reactions[at(line)].known = run.reactions[at(pin)].known = true;
            return true;
        }
        if (known.force && !board_.parallel(board_.direction(*known.force), given.direction)) {
            const auto met = board_.meet(line_of(known), given.line);
            if (board_.coincide(*met, place)) return false;
            const std::string letter = meet_name(group, *met);
            say(Sentence::triangle_at, {name(group), PointName{letter}, symbol_on(line, group), symbol_on(pin, group)},
                "Culmann");
            const DirectionHandle through_meet = board_.direction(board_.vector(place, *met));
            const auto [along, at_pin] = triangle(known, given.direction, through_meet);
            settle_line(pin, action(place, through_meet), run);
            settle(line, along, given.place, group, run);
            settle(pin, at_pin, place, group, run);
            return true;
        }
        const auto along = by_moments(given, place, known);
        if (!along) return false;
        say(Sentence::parallel_forces, {name(group), symbol_on(line, group), symbol_on(pin, group)}, "Ritter");
        settle(line, *along, given.place, group, run);
        settle(pin, board_.negate(known.force ? board_.add(*known.force, *along) : *along), place, group, run);
        return true;
    }

    /// A guide takes its force at any place: directions give the triangle, the guide's couple the rest.
    bool line_and_guide(const std::vector<int>& group, int line, int guide, const Wrench& known, Run& run) {
        const Action given = *run.reactions[at(line)].action;
        const DirectionHandle normal = bonds_[at(guide)].direction;
        if (board_.parallel(given.direction, normal)) return false;
        say(Sentence::triangle, {name(group), symbol_on(line, group), symbol_on(guide, group)});
        const auto [along, across] = triangle(known, given.direction, normal);
        settle(line, along, given.place, group, run);
        Wrench rest = known;
        if (run.reactions[at(line)].force) rest = sum(known, wrench_at(along, given.place));
        settle_guide(guide, across, rest, group, run);
        return true;
    }

    static Wrench wrench_at(Force force, Place place) {
        Wrench wrench;
        wrench.force = force;
        wrench.place = place;
        return wrench;
    }

    /// A guide's reaction balances what is left, force and couple.
    void settle_guide(int guide, Force across, const Wrench& rest, const std::vector<int>& group, Run& run) {
        settle_with_couple(guide, across, board_.difference(board_.given(0), moment(rest, bonds_[at(guide)].place)), group, run);
    }

    bool two_lines(const std::vector<int>& group, int one, int two, int couple, const Wrench& known, Run& run) {
        const Action first = *run.reactions[at(one)].action, second = *run.reactions[at(two)].action;
        if (!board_.parallel(first.direction, second.direction)) {
            say(Sentence::triangle, {name(group), symbol_on(one, group), symbol_on(two, group)});
            const auto [x, y] = triangle(known, first.direction, second.direction);
            settle(one, x, first.place, group, run);
            settle(two, y, second.place, group, run);
            if (couple >= 0) {
                Wrench rest = sum(sum(known, nonzero(x, first.place)), nonzero(y, second.place));
                settle_couple(couple, board_.difference(board_.given(0), moment(rest, first.place)), group, run);
            }
            return true;
        }
        if (couple >= 0) return false;
        const auto x = by_moments(first, second.place, known);
        if (!x) return false;
        say(Sentence::parallel_forces, {name(group), symbol_on(one, group), symbol_on(two, group)}, "Ritter");
        settle(one, *x, first.place, group, run);
        Wrench rest;
        rest.force = known.force ? board_.add(*known.force, *x) : *x;
        settle(two, opposite_along(rest, second.direction), second.place, group, run);
        return true;
    }

    Wrench nonzero(Force force, Place place) { return board_.is_zero(force) ? Wrench{} : wrench_at(force, place); }

    /// Culmann: three lines that neither meet in one point nor are all parallel. The line through the meet of two pairs carries
    /// the sum of each pair.
    bool three_lines(const std::vector<int>& group, const std::vector<int>& fixed, const Wrench& known, Run& run) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int one = fixed[i], two = fixed[(i + 1) % 3], three = fixed[(i + 2) % 3];
            const Action a = *run.reactions[at(one)].action, b = *run.reactions[at(two)].action,
                         c = *run.reactions[at(three)].action;
            if (board_.parallel(b.direction, c.direction)) continue;
            const Place pivot = *board_.meet(b.line, c.line);
            if (board_.on_line(pivot, a.line)) return false;  // concurrent: only a force through that point is held
            const auto first = by_moments(a, pivot, known);
            if (!first) return false;
            say(Sentence::culmann,
                {name(group), PointName{meet_name(group, pivot)}, symbol_on(one, group), symbol_on(two, group),
                 symbol_on(three, group)},
                "Culmann");
            settle(one, *first, a.place, group, run);
            Wrench rest;
            rest.force = known.force ? board_.add(*known.force, *first) : *first;
            rest.place = pivot;
            if (board_.is_zero(*rest.force)) rest.force.reset();
            const auto [x, y] = triangle(rest, b.direction, c.direction);
            settle(two, x, b.place, group, run);
            settle(three, y, c.place, group, run);
            return true;
        }
        return false;
    }

    // --- superposition and trials --------------------------------------------------------------------------------------------
    Run solve(const std::vector<Load>& loads) {
        Run direct = fresh();
        advance(loads, direct);
        if (direct.complete) return direct;
        // Several loaded bodies: one after the other.
        std::vector<int> loaded;
        for (const Load& load : loads) {
            if (!in(loaded, load.member)) loaded.push_back(load.member);
        }
        if (loaded.size() < 2) {
            Run run = direct;
            close_by_trial(loads, run, 0);
            return run.complete ? run : direct;
        }
        std::vector<Run> parts;
        for (const int member : loaded) {
            std::vector<Load> own;
            std::copy_if(loads.begin(), loads.end(), std::back_inserter(own),
                         [&](const Load& load) { return load.member == member; });
            say(Sentence::superposition, {BodyName{member_name(member)}});
            Run part = fresh();
            advance(own, part);
            if (!part.complete) close_by_trial(own, part, 0);
            if (!part.complete) return direct;  // what the rules found without trials holds whatever the rest is
            parts.push_back(std::move(part));
        }
        say(Sentence::superposition_sum, {});
        return add_up(parts);
    }

    Run add_up(const std::vector<Run>& parts) {
        Run total = parts.front();
        fit(total);
        for (std::size_t p = 1; p < parts.size(); ++p) {
            Run part = parts[p];
            fit(part);
            add_to(total, part, std::nullopt);
        }
        return total;
    }

    /// a + s·b, bond by bond.
    Run combine(Run a, ScalarHandle share_a, Run b, ScalarHandle share_b) {
        fit(a);
        fit(b);
        Run total = a;
        for (Reaction& reaction : total.reactions) {
            if (reaction.force) reaction.force = board_.scale<Plane::force>(share_a, *reaction.force);
            if (reaction.couple) reaction.couple = board_.product(share_a, *reaction.couple);
        }
        add_to(total, b, share_b);
        return total;
    }

    void add_to(Run& total, const Run& b, std::optional<ScalarHandle> factor) {
        for (std::size_t i = 0; i < b.reactions.size(); ++i) {
            Reaction& sum_of = total.reactions[i];
            sum_of.known = true;
            const Reaction& more = b.reactions[i];
            if (more.force) {
                const Force scaled = factor ? board_.scale<Plane::force>(*factor, *more.force) : *more.force;
                sum_of.force = sum_of.force ? board_.add(*sum_of.force, scaled) : scaled;
                if (board_.is_zero(*sum_of.force)) sum_of.force.reset();
            }
            if (more.couple) {
                const ScalarHandle scaled = factor ? board_.product(*factor, *more.couple) : *more.couple;
                sum_of.couple = sum_of.couple ? board_.sum(*sum_of.couple, scaled) : scaled;
                if (board_.is_zero(*sum_of.couple)) sum_of.couple.reset();
            }
            sum_of.action.reset();
            sum_of.deduced = false;
        }
        for (const Resolved& resolved : b.order) note({resolved.member}, total);
    }

    /// The last rule. One unknown gets two trial values; each is drawn; what does not close
    /// then tells in which proportion they must be added, for everything is linear. Several unknowns nest.
    void close_by_trial(const std::vector<Load>& loads, Run& run, int depth) {
        constexpr int deepest = 8;
        if (depth > deepest) return;
        int tried = -1, hinge = -1;
        for (std::size_t b = 0; b < bonds_.size() && tried < 0; ++b) {
            if (run.reactions[b].known) continue;
            const Shape of = shape(static_cast<int>(b), run);
            if (of == Shape::line || of == Shape::couple) tried = static_cast<int>(b);
            if (of == Shape::pin && hinge < 0) hinge = static_cast<int>(b);
        }
        if (tried >= 0) {
            try_value(loads, run, tried, depth);
        } else if (hinge >= 0) {
            split(hinge);
            fit(run);
            close_by_trial(loads, run, depth);
        }
    }

    /// A force along the bond's own line, or its couple.
    bool try_value(const std::vector<Load>& loads, Run& run, int b, int depth) {
        say(Sentence::trial, {bonds_[at(b)].symbol}, "");
        Run first = run, second = run;
        give(first, b, 1);
        give(second, b, 2);
        for (Run* trial : {&first, &second}) {
            advance(loads, *trial);
            if (!trial->complete) close_by_trial(loads, *trial, depth + 1);
            if (!trial->complete) return false;
        }
        for (int member = 1; member < members_; ++member) {
            const auto gap_1 = gaps(member, loads, first), gap_2 = gaps(member, loads, second);
            for (std::size_t c = 0; c < gap_1.size(); ++c) {
                const ScalarHandle change = board_.difference(gap_1[c], gap_2[c]);
                if (board_.is_zero(change)) continue;
                const ScalarHandle share = board_.quotient(gap_1[c], change);
                run = combine(first, board_.difference(board_.given(1), share), second, share);
                run.complete = true;
                return true;
            }
        }
        return false;
    }

    /// Declares a bond known, of a trial size along its line or as a couple.
    void give(Run& run, int b, int size) {
        Reaction& reaction = run.reactions[at(b)];
        const Bond& bond = bonds_[at(b)];
        reaction.known = true;
        if (shape(b, run) == Shape::couple) {
            reaction.couple = board_.given(size);
            return;
        }
        reaction.force = board_.scale<Plane::force>(board_.given(size), reaction.action->direction);
        if (bond.kind != Bond::Kind::guide) return;
        const ScalarHandle turning = board_.moment(board_.vector(bond.place, reaction.action->place), *reaction.force);
        if (!board_.is_zero(turning)) reaction.couple = turning;
    }

    /// What does not close at a member: components along x and y, and the moment about one fixed place.
    std::array<ScalarHandle, 3> gaps(int member, const std::vector<Load>& loads, const Run& run) {
        const Wrench gap = known_on({member}, loads, run);
        const auto component = [&](const Vector& across) {
            if (!gap.force) return board_.given(0);
            return board_.moment(board_.given<drawing>([across](const Pose&) { return across; }), *gap.force);
        };
        return {component({0, -1}), component({1, 0}), moment(gap, origin_)};
    }

    // --- results
    // ----------------------------------------------------------------------------------------------------------------
    /// The components of a hinge that was tried by them are its force again.
    void gather_components(Run& run) {
        fit(run);
        for (std::size_t b = joint_bonds_; b < bonds_.size(); ++b) {
            Reaction& hinge = run.reactions[at(bonds_[b].part_of)];
            Reaction& part = run.reactions[b];
            if (!part.known) hinge.known = false;
            if (part.force) hinge.force = hinge.force ? board_.add(*hinge.force, *part.force) : *part.force;
            part.force.reset();
        }
        for (std::size_t member = 0; member < bonds_of_.size(); ++member) {
            std::erase_if(bonds_of_[member], [&](int b) { return bonds_[at(b)].part_of >= 0; });
        }
        bonds_.resize(joint_bonds_);
        run.reactions.resize(joint_bonds_);
    }

    void collect(const Run& run) {
        bool balanced = true;
        if (run.complete) {
            for (int member = 1; member < members_ && balanced; ++member) balanced = known_on({member}, loads_, run).vanishes();
        }
        if (!run.complete || !balanced) explain(run, balanced);
        for (std::size_t b = 0; b < bonds_.size(); ++b) collect(bonds_[b], run.reactions[b], balanced);
        if (!run.complete || !balanced) return;
        std::vector<int> order;
        for (const Resolved& resolved : run.order) order.push_back(resolved.member);
        for (int member = 1; member < members_; ++member) {
            if (!in(order, member)) order.push_back(member);
        }
        for (const int member : order) free_body(member, run);
        join_polygons();
        remark_lift_off(run);
    }

    /// A one-sided contact can push only.
    void remark_lift_off(const Run& run) {
        for (std::size_t b = 0; b < bonds_.size(); ++b) {
            const Bond& bond = bonds_[b];
            if (bond.joint < 0 || !run.reactions[b].force) continue;
            const Joint& joint = mechanism_.joints[at(bond.joint)];
            if (!joint.pushes || dot(board_.value(*run.reactions[b].force), *joint.pushes).sign() >= 0) continue;
            results_.remarks.push_back("the contact at " + joint.name + " would have to pull: there the bodies lift off");
        }
    }

    std::string reason() const {
        const int efforts = static_cast<int>(mechanism_.efforts.size());
        const auto freedoms = [](int count) { return std::to_string(count) + (count == 1 ? " freedom" : " freedoms"); };
        int repeated = 0;
        std::string joints;
        for (const Mobility::Redundant& redundant : mobility_.redundant) {
            repeated += redundant.rows;
            joints += (joints.empty() ? "" : ", ") + mechanism_.joints[at(redundant.joint)].name;
        }
        if (efforts < mobility_.effective) {
            return "the loads are not balanced: the mechanism has " + freedoms(mobility_.effective) + " and " +
                   std::to_string(efforts) + (efforts == 1 ? " effort" : " efforts") + " to hold it; give \"effort\"";
        }
        if (efforts > mobility_.effective) {
            return std::to_string(efforts) + " efforts stand against " + freedoms(mobility_.effective) +
                   "; give one for each freedom";
        }
        if (repeated > 0) {
            return "statically indeterminate, " + std::to_string(repeated) + (repeated == 1 ? " time" : " times") + ": joint " +
                   joints + " repeats what others hold already";
        }
        return "the effort does no work in the motion that is free at this position: a dead point, where a force grows without limit";
    }

    void explain(const Run& run, bool balanced) {
        if (!balanced) {
            results_.unsolved.push_back({"forces", reason()});
            return;
        }
        std::string open;
        for (std::size_t b = 0; b < bonds_.size(); ++b) {
            if (!run.reactions[b].known) open += (open.empty() ? "" : ", ") + name_of(bonds_[b].symbol);
        }
        results_.unsolved.push_back({"forces", reason() + "; not determined: " + open});
    }

    Vector value(const std::optional<Force>& force) const { return force ? board_.value(*force) : Vector{}; }
    Exact value(const std::optional<ScalarHandle>& couple) const { return couple ? board_.value(*couple) : Exact(); }

    void collect(const Bond& bond, const Reaction& reaction, bool valid) {
        if (bond.effort >= 0) {
            EffortValue result;
            result.name = std::visit([](const auto& effort) { return effort.name; }, mechanism_.efforts[at(bond.effort)]);
            if (valid && reaction.known) {
                if (bond.kind == Bond::Kind::couple) {
                    result.value = value(reaction.couple);
                } else if (reaction.force) {
                    // In units of the direction, which is a unit vector.
                    result.value =
                        board_.value(board_.ratio(*reaction.force, board_.scale<Plane::force>(board_.given(1), bond.direction)));
                } else {
                    result.value = Exact();
                }
            }
            results_.efforts.push_back(std::move(result));
            return;
        }
        JointForce on_first;
        on_first.joint = bond.joint;
        on_first.on = bond.first;
        on_first.from = is_pin(bond.second) ? -1 : bond.second;
        if (valid && reaction.known) {
            on_first.force = value(reaction.force);
            on_first.couple = value(reaction.couple);
        }
        results_.joints.push_back(on_first);
        if (is_pin(bond.second)) return;
        JointForce on_second = on_first;
        std::swap(on_second.on, on_second.from);
        if (on_second.force) on_second.force = -*on_second.force;
        if (on_second.couple) on_second.couple = -*on_second.couple;
        results_.joints.push_back(on_second);
    }

    void free_body(int member, const Run& run) {
        FreeBody body;
        if (is_pin(member)) {
            body.pin = pins_[at(member - static_cast<int>(mechanism_.bodies.size()))];
        } else {
            body.body = member;
        }
        std::vector<Side> sides;
        const auto apply = [&](AppliedForce applied, const std::optional<Force>& force, int bond) {
            if (force) {
                applied.force = board_.value(*force);
                const bool external = bond < 0 || bonds_[at(bond)].first == frame || bonds_[at(bond)].second == frame;
                sides.push_back({applied.symbol, *force, bond, external});
            }
            if (!applied.force.is_zero() || !applied.couple.is_zero()) body.forces.push_back(std::move(applied));
        };
        for (const Load& load : loads_) {
            if (load.member != member) continue;
            AppliedForce applied;
            applied.symbol = load.symbol;
            applied.kind = load.kind;
            applied.at = board_.value(load.place).place();
            applied.couple = value(load.couple);
            apply(std::move(applied), load.force, -1);
        }
        for (const int b : bonds_of_[at(member)]) {
            const Bond& bond = bonds_[at(b)];
            const Reaction& reaction = run.reactions[at(b)];
            const bool reversed = bond.second == member;
            AppliedForce applied;
            applied.symbol = reversed ? bond.reverse : bond.symbol;
            applied.kind = bond.effort >= 0 ? AppliedForce::Kind::effort : AppliedForce::Kind::reaction;
            applied.joint = bond.joint;
            applied.from = reversed ? bond.first : bond.second;
            if (is_pin(applied.from)) applied.from = -1;
            applied.at = board_.value(bond.place).place();
            applied.line_by_construction = reaction.deduced;
            std::optional<Force> force;
            if (reaction.force) force = reversed ? board_.negate(*reaction.force) : *reaction.force;
            if (reaction.couple) {
                // A force with a couple is the same force moved aside: its real line.
                if (force) {
                    const ScalarHandle couple =
                        reversed ? board_.difference(board_.given(0), *reaction.couple) : *reaction.couple;
                    applied.at = board_.value(board_.carry(bond.place, board_.arm(couple, *force))).place();
                } else {
                    applied.couple = reversed ? -board_.value(*reaction.couple) : board_.value(*reaction.couple);
                }
            }
            apply(std::move(applied), force, b);
        }
        const auto meets = meets_of_.find(member);
        if (meets != meets_of_.end()) {
            for (const auto& [letter, place] : meets->second) {
                const bool listed =
                    std::any_of(body.meets.begin(), body.meets.end(), [&](const auto& m) { return m.first == letter; });
                if (!listed) body.meets.emplace_back(letter, board_.value(place).place());
            }
        }
        if (!sides.empty()) {
            sort_round(sides);
            body.polygon = draw_polygon(member, sides);
            sides_.emplace_back(member, std::move(sides));
        }
        if (!body.forces.empty()) results_.bodies.push_back(std::move(body));
    }

    /// Counter-clockwise by direction from the first on: the polygon is convex, and neighbours lie on the far sides of common
    /// forces.
    void sort_round(std::vector<Side>& sides) const {
        const Vector first = board_.value(sides.front().force);
        const auto half = [&](const Vector& v) {
            const int turned = cross(first, v).sign();
            return turned > 0 || (turned == 0 && dot(first, v).sign() > 0) ? 0 : 1;
        };
        std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
            const Vector u = board_.value(a.force), v = board_.value(b.force);
            if (half(u) != half(v)) return half(u) < half(v);
            return cross(u, v).sign() > 0;
        });
    }

    int add_force_polygon(std::string id) {
        Polygon polygon;
        polygon.plane = Plane::force;
        polygon.id = std::move(id);
        return board_.add_polygon(std::move(polygon));
    }

    using Corner = PointOn<Plane::force>;

    void draw_side(int polygon, const Side& side, int member, Corner tail, Corner tip) {
        DrawnVector drawn;
        drawn.symbol = side.symbol;
        drawn.polygon = polygon;
        drawn.tail = tail.element;
        drawn.tip = tip.element;
        drawn.body = is_pin(member) ? -1 : member;
        drawn.role = side.external ? DrawnVector::Role::external : DrawnVector::Role::internal;
        board_.draw(std::move(drawn));
    }

    /// Tip to tail: the forces of a body in equilibrium close.
    int draw_polygon(int member, const std::vector<Side>& sides) {
        const int polygon = add_force_polygon("forces-" + member_name(member));
        place_sides(polygon, member, sides, 0, board_.pole<Plane::force>(), -1);
        return polygon;
    }

    /// Sets the sides off from `start`, beginning with the one at `from`; the side of the bond `shared` is there already.
    /// Returns the tails of the sides, in their order.
    std::vector<Corner> place_sides(int polygon, int member, const std::vector<Side>& sides, std::size_t from, Corner start,
                                    int shared) {
        std::vector<Corner> tails(sides.size());
        Face face;
        face.body = is_pin(member) ? -1 : member;
        Corner here = start;
        for (std::size_t n = 0; n < sides.size(); ++n) {
            const std::size_t i = (from + n) % sides.size();
            const Corner next = n + 1 == sides.size() ? start : board_.carry(here, sides[i].force);
            if (n + 1 == sides.size()) {
                KG_ASSERT(board_.coincide(board_.carry(here, sides[i].force), start),
                          "the forces of a body in equilibrium close");
            }
            if (shared < 0 || sides[i].bond != shared) draw_side(polygon, sides[i], member, here, next);
            tails[i] = here;
            face.corners.push_back(here.element);
            here = next;
        }
        board_.add_face(polygon, std::move(face));
        return tails;
    }

    /// The triangles laid side by side on their common forces, so that the external forces close.
    void join_polygons() {
        std::set<int> placed;
        int count = 0;
        for (std::size_t first = 0; first < sides_.size(); ++first) {
            if (placed.count(sides_[first].first) != 0 || sides_.size() < 2) continue;
            const int polygon = add_force_polygon(count == 0 ? "closure" : "closure-" + std::to_string(count + 1));
            ++count;
            struct Open {
                std::size_t index, from;
                Corner start;
                int shared;
            };
            std::vector<Open> open{{first, 0, board_.pole<Plane::force>(), -1}};
            placed.insert(sides_[first].first);
            for (std::size_t next = 0; next < open.size(); ++next) {
                const Open here = open[next];
                const auto& [member, sides] = sides_[here.index];
                const std::vector<Corner> tails = place_sides(polygon, member, sides, here.from, here.start, here.shared);
                for (std::size_t i = 0; i < sides.size(); ++i) {
                    if (sides[i].external) continue;
                    const Bond& bond = bonds_[at(sides[i].bond)];
                    const int other = bond.first == member ? bond.second : bond.first;
                    if (placed.count(other) != 0) continue;
                    for (std::size_t k = 0; k < sides_.size(); ++k) {
                        if (sides_[k].first != other) continue;
                        const auto& across = sides_[k].second;
                        for (std::size_t m = 0; m < across.size(); ++m) {
                            if (across[m].bond != sides[i].bond) continue;
                            placed.insert(other);
                            open.push_back({k, m, tails[(i + 1) % sides.size()], sides[i].bond});
                        }
                    }
                }
            }
        }
    }

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    const Motion& motion_;
    const Mobility& mobility_;
    int members_ = 0;
    std::vector<PointIndex> pins_;
    std::vector<Bond> bonds_;
    Place origin_;                 ///< about which gaps are measured
    std::size_t joint_bonds_ = 0;  ///< bonds of joints and efforts; components come after them
    std::vector<std::vector<int>> bonds_of_;
    std::vector<Load> loads_;
    std::vector<std::pair<Place, std::string>> named_meets_;
    std::map<int, std::vector<std::pair<std::string, Place>>> meets_of_;
    std::vector<std::pair<int, std::vector<Side>>> sides_;  ///< by member, in the order resolved
    std::set<JointIndex> mirrored_gears_;
    ForceResults results_;
};

}  // namespace

ForceResults draw_forces(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility) {
    return Statics(structure, board, motion, mobility).draw();
}

}  // namespace kinegraph
