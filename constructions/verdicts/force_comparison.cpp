#include "constructions/verdicts/check_rows.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "engine/check/check_forces.hpp"
#include "engine/drawing/spring_force.hpp"
#include "engine/number/functions.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

class ForceComparer {
public:
    ForceComparer(const Solution& solution, const NumericMotion& motion, Comparison& comparison)
        : solution_(solution), mechanism_(solution.mechanism), numeric_(motion), comparison_(comparison) {}

    void compare() {
        const NumericForces numeric = check_forces(mechanism_, solution_.pose, numeric_);
        for (const JointForce& found : solution_.forces)
            if (const auto* action = action_of(numeric, found.joint, found.on, found.from))
                compare_action(found, *action);
        if (solution_.virtual_work)
            add({.kind = Kind::virtual_power}, solution_.virtual_work->total.to_double(), numeric_power());
        for (std::size_t e = 0; e < solution_.efforts.size(); ++e)
            if (solution_.efforts[e].value && numeric.effort_known[e])
                add({.kind = Kind::effort, .given = static_cast<int>(e)}, solution_.efforts[e].value->to_double(),
                    numeric.efforts[e]);
        for (const Resultant& found : solution_.resultants) compare_resultant(found, numeric);
        if (solution_.truss) compare_bars(*solution_.truss, numeric);
        for (const FreeBody& body : solution_.free_bodies) {
            auto& actions = comparison_.actions.emplace_back();
            for (const AppliedForce& applied : body.forces) actions.push_back(action_on(body, applied, numeric));
        }
    }

private:
    using Kind = Quantity::Kind;
    using Pair = std::array<double, 2>;

    static double magnitude(const Pair& a) { return nearest::hypot(a[0], a[1]); }
    void add(const Quantity& quantity, double graphical, double independent) {
        comparison_.rows.push_back({quantity, graphical, independent, graphical - independent});
    }
    void add(const Quantity& quantity, const Vector& graphical, const Pair& independent) {
        add(quantity.along(Quantity::Component::x), graphical.x.to_double(), independent[0]);
        add(quantity.along(Quantity::Component::y), graphical.y.to_double(), independent[1]);
    }

    /// The forces of the joints at a bar's first pin and its loads there, projected on the bar.
    void compare_bars(const Truss& truss, const NumericForces& numeric) {
        const std::vector<Vector>& places = solution_.pose.points;
        for (std::size_t b = 0; b < truss.bars.size(); ++b) {
            const TrussStructure::Bar& bar = truss.structure.bars[b];
            const PointIndex first = truss.structure.pins[at_index(bar.pins[0])].point,
                             second = truss.structure.pins[at_index(bar.pins[1])].point;
            Pair end{};
            bool known = true;
            for (const NumericForces::Action& action : numeric.actions) {
                if (action.on != bar.body || mechanism_.joint(action.joint).point != first) continue;
                known = known && action.known;
                end = {end[0] + action.force[0], end[1] + action.force[1]};
            }
            for (const Load& load : mechanism_.loads) {
                const Pair given = load_at(load, bar.body, first);
                end = {end[0] + given[0], end[1] + given[1]};
            }
            if (!known || !truss.bars[b].force) continue;
            const Vector along = places[at_index(second)] - places[at_index(first)];
            const Pair unit{along.x.to_double() / kinegraph::length(along),
                            along.y.to_double() / kinegraph::length(along)};
            const double pull = -(end[0] * unit[0] + end[1] * unit[1]);
            add({.kind = Kind::bar, .body = bar.body}, truss.tension(b, places), pull);
            comparison_.bars.emplace_back(b, pull);
        }
    }

    /// The load on a body at a point.
    Pair load_at(const Load& load, BodyIndex body, PointIndex point) const {
        if (const auto* force = std::get_if<ForceLoad>(&load)) {
            if (force->body != body || force->at != point) return {};
            if (force->value) return {force->value->x.to_double(), force->value->y.to_double()};
            const Vector along = direction_of(force->magnitude->second, solution_.pose);
            const double share = force->magnitude->first.to_double() / kinegraph::length(along);
            return {share * along.x.to_double(), share * along.y.to_double()};
        }
        const auto* spring = std::get_if<SpringLoad>(&load);
        if (spring == nullptr) return {};
        Pair sum{};
        for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
            if (spring->bodies[end] != body || spring->between[end] != point) continue;
            const Vector along = solution_.pose.at(spring->between[1 - end]) - solution_.pose.at(spring->between[end]);
            const double share = pull_of(*spring, solution_.pose).to_double() / kinegraph::length(along);
            sum = {sum[0] + share * along.x.to_double(), sum[1] + share * along.y.to_double()};
        }
        return sum;
    }

    void compare_resultant(const Resultant& found, const NumericForces& numeric) {
        NumericForces::Sum sum;
        for (const BodyIndex body : found.bodies) {
            const NumericForces::Sum& on = numeric.given[at_index(body)];
            for (const std::size_t axis : {0U, 1U}) sum.force[axis] += on.force[axis];
            sum.couple += on.couple;
        }
        add({.kind = Kind::resultant, .body = found.bodies.front()}, *found.force, sum.force);
        add({.kind = Kind::resultant_couple, .body = found.bodies.front()}, found.couple->to_double(), sum.couple);
    }

    /// Null unless equilibrium determines part of it.
    static const NumericForces::Action* action_of(const NumericForces& numeric, JointIndex joint, BodyIndex on,
                                                  BodyIndex from) {
        for (const NumericForces::Action& action : numeric.actions)
            if ((action.force_known || action.couple_known || action.along) && action.joint == joint &&
                action.on == on && action.from == from)
                return &action;
        return nullptr;
    }

    void compare_action(const JointForce& found, const NumericForces::Action& action) {
        Quantity quantity = quantity_of(found);
        if (found.force && action.force_known) add(quantity, *found.force, action.force);
        quantity.kind = Kind::force_component;
        if (found.component && action.along) add(quantity, component_of(found), seen_along(found, action));
        quantity.kind = Kind::couple;
        if (found.couple && action.couple_known && (!found.couple->is_zero() || action.couple != 0))
            add(quantity, found.couple->to_double(), action.couple);
    }

    /// The numeric component, with the sign of the construction.
    static double seen_along(const JointForce& found, const NumericForces::Action& action) {
        const Vector along = unit_of_component(found);
        const double same = along.x.to_double() * (*action.along)[0] + along.y.to_double() * (*action.along)[1];
        return action.component * same;
    }

    Comparison::Action action_on(const FreeBody& body, const AppliedForce& applied,
                                 const NumericForces& numeric) const {
        switch (applied.kind) {
            case Kind::force: {
                if (const auto* action = action_of(numeric, applied.joint, body.body, applied.from)) {
                    if (action->along) return {std::abs(action->component), action->couple};
                    return {magnitude(action->force), action->couple};
                }
                // The action of a body on the pin of a multiple hinge is listed as that of the pin on the body.
                const auto* action =
                    body.body == none ? action_of(numeric, applied.joint, applied.from, none) : nullptr;
                if (action == nullptr) return {};
                return {magnitude(action->force), -action->couple};
            }
            case Kind::effort:
                if (!numeric.effort_known[at_index(applied.given)]) return {};
                return effort_on(body, mechanism_.efforts[at_index(applied.given)],
                                 numeric.efforts[at_index(applied.given)]);
            case Kind::weight:
                return {mechanism_.masses[at_index(applied.given)].mass.to_double() *
                            kinegraph::length(*mechanism_.gravity),
                        {}};
            case Kind::inertia: return inertia_of(mechanism_.masses[at_index(applied.given)]);
            case Kind::resultant: {
                const NumericForces::Sum& sum = numeric.given[at_index(body.body)];
                if (applied.force.is_zero()) return {{}, sum.couple};
                return {magnitude(sum.force), {}};
            }
            case Kind::load: {
                const Load& load = mechanism_.loads[at_index(applied.given)];
                Comparison::Action size = std::visit([&](const auto& form) { return size_of(form); }, load);
                const auto* torsion = std::get_if<TorsionLoad>(&load);
                if (torsion != nullptr && body.body == torsion->bodies[1]) size.couple = -*size.couple;
                return size;
            }
            default: return {};
        }
    }

    /// A couple between two bodies acts on one and, reversed, on the other.
    static Comparison::Action effort_on(const FreeBody& body, const Effort& effort, double value) {
        const auto* couple = std::get_if<CoupleEffort>(&effort);
        if (couple == nullptr) return {std::abs(value), {}};
        return {{}, body.body == couple->body ? value : -value};
    }

    Comparison::Action inertia_of(const Mass& mass) const {
        const auto& state = numeric_.bodies[at_index(mass.body)];
        if (!state.acceleration_known) return {};
        const Pair acceleration = numeric_.acceleration(mass.body, solution_.pose.at(mass.centre));
        return {mass.mass.to_double() * magnitude(acceleration), -mass.inertia.to_double() * state.alpha};
    }

    static Comparison::Action size_of(const ForceLoad& load) {
        return {load.value ? kinegraph::length(*load.value) : std::abs(load.magnitude->first.to_double()), {}};
    }

    static Comparison::Action size_of(const CoupleLoad& load) { return {{}, load.value.to_double()}; }

    static Comparison::Action size_of(const TorsionLoad& load) { return {{}, couple_of(load).to_double()}; }

    Comparison::Action size_of(const SpringLoad& load) const {
        return {std::abs(pull_of(load, solution_.pose).to_double()), {}};
    }

    Comparison::Action size_of(const DistributedLoad& load) const {
        const Centroid centroid = centroid_of(load);
        const double force = force_of(load, solution_.pose).to_double();
        if (!centroid.is_couple) return {std::abs(force), {}};
        const Vector apart = solution_.pose.at(load.to) - solution_.pose.at(load.from);
        const Vector along = unit_along(direction_of(load.along, solution_.pose), solution_.pose.bits);
        return {{}, (centroid.place * cross(apart, along)).to_double() * force};
    }

    /// The powers of the same loads with the velocities of the check.
    double numeric_power() const {
        double power = 0;
        for (const VirtualWork::Entry& entry : solution_.virtual_work->entries) {
            const Pair velocity = numeric_.velocity(entry.body, entry.at);
            power += entry.force.x.to_double() * velocity[0] + entry.force.y.to_double() * velocity[1] +
                     entry.couple.to_double() * numeric_.bodies[at_index(entry.body)].omega;
        }
        return power;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const NumericMotion& numeric_;
    Comparison& comparison_;
};

}  // namespace

void compare_forces(const Solution& solution, const NumericMotion& motion, Comparison& comparison) {
    ForceComparer(solution, motion, comparison).compare();
}

}  // namespace kinegraph
