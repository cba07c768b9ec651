#include "tests/support/force_laws.hpp"

#include "engine/solution/solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }

/// Relative to the largest force. The construction is exact; the check solves a system in doubles and loses its
/// condition number in a mechanism near a dead point (generation keeps dyads 5° away). 1e-9 allows three orders for
/// several such dyads in a row; a wrong term is of the order of the largest force.
constexpr double tolerance = 1e-9;

/// A pose by compass is exact to 2⁻¹⁰⁰ (1e-30) of its size; an intersection of lines at 5° enlarges that sixteenfold.
constexpr double leftover = 1e-25;

class HeldForces {
public:
    HeldForces(const Solution& solution, const NumericForces& numeric)
        : solution_(solution), mechanism_(solution.mechanism), numeric_(numeric) {
        size_ = solution.pose.size.to_double();
        for (const FreeBody& body : solution.free_bodies) {
            for (const AppliedForce& applied : body.forces) {
                const double force = std::max(length(applied.force), std::abs(applied.couple.to_double()) / size_);
                largest_ = std::max(largest_, force);
                if (!applied.is_reaction() && applied.kind != Quantity::Kind::effort)
                    largest_load_ = std::max(largest_load_, force);
            }
        }
    }

    void all() {
        agrees_with_equilibrium();
        action_is_reaction();
        pins_are_in_equilibrium();
        for (const FreeBody& body : solution_.free_bodies) closes(body);
        external_forces_close();
        no_power_is_lost();
        told_forces_are_all();
    }

    /// For a mechanism that is not wholly determined.
    void gives_only_what_is_determined() const {
        told_forces_are_all();
        double scale = 1;  // N: the order of the loads
        for (const NumericForces::Action& action : numeric_.actions)
            if (action.known) scale = std::max({scale, std::abs(action.force[0]), std::abs(action.force[1])});
        for (const NumericForces::Action& action : numeric_.actions) {
            const JointForce* force = found(action.joint, action.on, action.from);
            if (force == nullptr || !force->force) continue;
            const std::string what = "at " + mechanism_.joints[at(action.joint)].name + " on " + name(action.on);
            // If the system is not balanced, the check omits more forces than necessary.
            EXPECT_TRUE(action.force_known || !numeric_.balanced) << "a force " << what;
            if (!action.force_known) continue;
            EXPECT_NEAR(force->force->x.to_double(), action.force[0], tolerance * scale) << what;
            EXPECT_NEAR(force->force->y.to_double(), action.force[1], tolerance * scale) << what;
        }
        for (std::size_t e = 0; e < solution_.efforts.size(); ++e) {
            EXPECT_TRUE(!solution_.efforts[e].value || numeric_.effort_known[e] || !numeric_.balanced)
                << solution_.efforts[e].name;
        }
        for (const BodyIndex body : mechanism_.moving_bodies()) balances_if_known(body, scale);
    }

private:
    const std::string& name(BodyIndex body) const { return mechanism_.bodies[at(body)].name; }

    /// Exactly zero; in a pose by compass, negligible relative to `beside`.
    void expect_nothing(const Exact& value, double beside, const std::string& what) const {
        if (solution_.pose.exact) {
            EXPECT_EQ(value, Exact(0)) << what;
        } else {
            EXPECT_LE(std::abs(value.to_double()), leftover * beside) << what;
        }
    }
    void expect_nothing(const Vector& value, double beside, const std::string& what) const {
        expect_nothing(value.x, beside, what + ", x");
        expect_nothing(value.y, beside, what + ", y");
    }

    const JointForce* found(JointIndex joint, BodyIndex on, BodyIndex from) const {
        for (const JointForce& action : solution_.forces)
            if (action.joint == joint && action.on == on && action.from == from) return &action;
        return nullptr;
    }

    void agrees_with_equilibrium() const {
        double largest = 0;
        for (const NumericForces::Action& action : numeric_.actions)
            largest = std::max(
                {largest, std::abs(action.force[0]), std::abs(action.force[1]), std::abs(action.couple) / size_});
        // Loads that balance one another cause no forces, but rounding in the check, which is relative to the loads.
        const double scale = largest < tolerance * largest_load_ ? largest_load_ : largest;
        for (const NumericForces::Action& action : numeric_.actions) {
            const std::string what = "at " + mechanism_.joints[at(action.joint)].name + " on " + name(action.on);
            const JointForce* force = found(action.joint, action.on, action.from);
            ASSERT_TRUE(force && force->force && force->couple) << "nothing " << what;
            EXPECT_NEAR(force->force->x.to_double(), action.force[0], tolerance * scale) << what;
            EXPECT_NEAR(force->force->y.to_double(), action.force[1], tolerance * scale) << what;
            EXPECT_NEAR(force->couple->to_double(), action.couple,
                        tolerance * std::max(scale * size_, std::abs(action.couple)))
                << what;
        }
        ASSERT_EQ(solution_.efforts.size(), numeric_.efforts.size());
        for (std::size_t e = 0; e < solution_.efforts.size(); ++e) {
            ASSERT_TRUE(solution_.efforts[e].value) << solution_.efforts[e].name;
            const double value = numeric_.efforts[e];
            const bool couple = std::holds_alternative<CoupleEffort>(mechanism_.efforts[e]);
            EXPECT_NEAR(solution_.efforts[e].value->to_double(), value,
                        tolerance * std::max(couple ? scale * size_ : scale, std::abs(value)))
                << solution_.efforts[e].name;
        }
    }

    void action_is_reaction() const {
        for (const JointForce& action : solution_.forces) {
            if (action.from == none) continue;
            const JointForce* reaction = found(action.joint, action.from, action.on);
            ASSERT_TRUE(reaction) << name(action.from) << " on " << name(action.on);
            EXPECT_EQ(*action.force, -*reaction->force) << name(action.from) << " on " << name(action.on);
            EXPECT_EQ(*action.couple, -*reaction->couple) << name(action.from) << " on " << name(action.on);
        }
        for (const FreeBody& body : solution_.free_bodies) {
            if (body.body == none) continue;
            for (const AppliedForce& applied : body.forces) {
                if (!applied.is_reaction()) continue;
                const JointForce* action = found(applied.joint, body.body, applied.from);
                ASSERT_TRUE(action) << name_of(applied.symbol) << " on the free body " << name(body.body);
                EXPECT_EQ(applied.force, *action->force) << name_of(applied.symbol);
                const Vector joint = solution_.pose.at(mechanism_.joints[at(applied.joint)].point);
                EXPECT_EQ(cross(applied.at - joint, applied.force) + applied.couple, *action->couple)
                    << name_of(applied.symbol);
            }
        }
    }

    /// A pin of three bodies or more has no mass.
    void pins_are_in_equilibrium() const {
        for (std::size_t j = 0; j < mechanism_.joints.size(); ++j) {
            Vector sum;
            for (const Load& load : mechanism_.loads)
                if (const auto* push = std::get_if<ForceLoad>(&load); push != nullptr && push->pin == JointIndex(j))
                    sum = sum - given(*push);
            for (const JointForce& action : solution_.forces)
                if (action.joint == JointIndex(j) && action.from == none) sum = sum + *action.force;
            expect_nothing(sum, largest_, "the pin of " + mechanism_.joints[j].name);
        }
    }

    /// Forces and moments of a free body add up to zero; its polygon closes and draws the same forces.
    void closes(const FreeBody& body) const {
        const std::string who = body.body == none ? "pin" : "body " + name(body.body);
        Vector sum;
        Exact moment;
        std::multiset<std::string> applied_names, drawn_names;
        for (const AppliedForce& applied : body.forces) {
            sum = sum + applied.force;
            moment += cross(applied.at, applied.force) + applied.couple;
            if (!applied.force.is_zero()) applied_names.insert(name_of(applied.symbol));
        }
        expect_nothing(sum, largest_, "forces on " + who);
        expect_nothing(moment, largest_ * std::max(1.0, size_), "moments on " + who);
        if (body.polygon < 0) {
            EXPECT_TRUE(applied_names.empty()) << who << " has forces and no polygon";
            return;
        }
        const Protocol& protocol = solution_.protocol;
        const std::vector<int>& sides = protocol.polygons[at(body.polygon)].vectors;
        ASSERT_GE(sides.size(), 2u) << who;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const DrawnVector& side = protocol.vectors[at(sides[i])];
            const DrawnVector& next = protocol.vectors[at(sides[(i + 1) % sides.size()])];
            EXPECT_EQ(protocol.point(side.tip).place(), protocol.point(next.tail).place())
                << who << ": " << name_of(side.symbol) << ", " << name_of(next.symbol);
            drawn_names.insert(name_of(side.symbol));
            const auto applied = std::find_if(body.forces.begin(), body.forces.end(), [&](const AppliedForce& each) {
                return each.symbol == side.symbol &&
                       length(each.force - protocol.value_of(side)) <= leftover * largest_;
            });
            EXPECT_NE(applied, body.forces.end())
                << who << ": " << name_of(side.symbol) << " is drawn as another force";
            if (applied != body.forces.end() && solution_.pose.exact) {
                EXPECT_EQ(applied->force, protocol.value_of(side)) << who;
            }
        }
        EXPECT_EQ(protocol.point(protocol.vectors[at(sides.front())].tail).place(), Vector{}) << "begins at the pole";
        EXPECT_EQ(applied_names, drawn_names) << who;
    }

    /// In the joined polygons the forces between bodies cancel, so the external forces close among themselves.
    void external_forces_close() const {
        std::size_t in_bodies = 0, joined = 0;
        for (const FreeBody& body : solution_.free_bodies)
            if (body.polygon >= 0) in_bodies += externals(solution_.protocol.polygons[at(body.polygon)]);
        int closures = 0;
        for (const Polygon& polygon : solution_.protocol.polygons) {
            if (polygon.id.rfind("closure", 0) != 0) continue;
            ++closures;
            joined += externals(polygon);
            Vector sum;
            for (const int v : polygon.vectors) {
                const DrawnVector& drawn = solution_.protocol.vectors[at(v)];
                if (drawn.role == DrawnVector::Role::external) sum = sum + solution_.protocol.value_of(drawn);
            }
            expect_nothing(sum, largest_, polygon.id);
        }
        if (closures > 0) {
            EXPECT_EQ(joined, in_bodies) << "external forces in the joined polygon";
        }
    }
    std::size_t externals(const Polygon& polygon) const {
        return static_cast<std::size_t>(std::count_if(polygon.vectors.begin(), polygon.vectors.end(), [&](int v) {
            return solution_.protocol.vectors[at(v)].role == DrawnVector::Role::external;
        }));
    }

    // --- the loads of the file ---
    /// A body on which every force is known is in equilibrium.
    void balances_if_known(BodyIndex body, double scale) const {
        Vector sum;
        Exact moment;
        const auto force = [&](const Vector& value, PointIndex point) {
            sum = sum + value;
            moment += cross(solution_.pose.at(point), value);
        };
        for (const JointForce& action : solution_.forces) {
            if (action.on != body) continue;
            if (!action.force || !action.couple) return;
            force(*action.force, mechanism_.joints[at(action.joint)].point);
            moment += *action.couple;
        }
        for (std::size_t e = 0; e < mechanism_.efforts.size(); ++e) {
            const Effort& effort = mechanism_.efforts[e];
            const auto& value = solution_.efforts[e].value;
            if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
                if (couple->body != body && couple->from != body) continue;
                if (!value) return;
                moment += couple->body == body ? *value : -*value;
            } else if (const auto* push = std::get_if<ForceEffort>(&effort)) {
                if (push->body != body) continue;
                if (!value) return;
                force(*value * unit(direction_of(push->along, solution_.pose)), push->at);
            } else {
                const JointIndex joint = std::get<ActuatorEffort>(effort).joint;
                const Joint& slide = mechanism_.joints[at(joint)];
                if (slide.bodies[0] != body && slide.bodies[1] != body) continue;
                if (!value) return;
                force((slide.bodies[0] == body ? *value : -*value) * solution_.pose.guide_units[at(joint)],
                      slide.point);
            }
        }
        for (const Load& load : mechanism_.loads) {
            if (const auto* push = std::get_if<ForceLoad>(&load)) {
                if (push->body == body) force(given(*push), push->at);
            } else if (const auto* couple = std::get_if<CoupleLoad>(&load)) {
                if (couple->body == body) moment += couple->value;
            } else if (const auto* distributed = std::get_if<DistributedLoad>(&load)) {
                if (distributed->body != body) continue;
                for (const auto& [place, part] : parts_of(*distributed)) {
                    sum = sum + part;
                    moment += cross(place, part);
                }
            } else if (const auto* torsion = std::get_if<TorsionLoad>(&load)) {
                for (const std::size_t side : {0U, 1U})
                    if (torsion->bodies[side] == body)
                        moment += (side == 0 ? -1 : 1) * torsion->stiffness * torsion->turned;
            } else {
                const auto& spring = std::get<SpringLoad>(load);
                if (spring.bodies[0] == body) force(pull(spring), spring.between[0]);
                if (spring.bodies[1] == body) force(-pull(spring), spring.between[1]);
            }
        }
        for (const Mass& mass : mechanism_.masses) {
            if (mass.body != body) continue;
            if (mechanism_.gravity) force(mass.mass * *mechanism_.gravity, mass.centre);
            if (!mechanism_.inertia_forces) continue;
            force(inertia(mass), mass.centre);
            moment -= mass.inertia * solution_.bodies[at(body)].alpha.value();
        }
        expect_nothing(sum, scale, "forces on body " + name(body));
        expect_nothing(moment, scale, "moments on body " + name(body));
    }
    Vector given(const ForceLoad& load) const {
        if (load.value) return *load.value;
        return load.magnitude->first * unit(direction_of(load.magnitude->second, solution_.pose));
    }
    /// Simpson's rule, exact for the moments of a linear distribution.
    std::vector<std::pair<Vector, Vector>> parts_of(const DistributedLoad& load) const {
        const Vector &p = solution_.pose.at(load.from), &q = solution_.pose.at(load.to);
        const Vector per_intensity = (dot(q - p, unit(q - p)) / 6) * unit(direction_of(load.along, solution_.pose));
        const auto& [first, last] = load.intensity;
        return {{p, first * per_intensity},
                {Exact(1) / Exact(2) * (p + q), 2 * (first + last) * per_intensity},
                {q, last * per_intensity}};
    }
    /// On the first body of the spring.
    Vector pull(const SpringLoad& spring) const {
        if (spring.elastic) {
            const Vector join = solution_.pose.at(spring.between[1]) - solution_.pose.at(spring.between[0]);
            return spring.elastic->stiffness * (dot(join, unit(join)) - spring.elastic->free_length) * unit(join);
        }
        return spring.magnitude * unit(solution_.pose.at(spring.between[1]) - solution_.pose.at(spring.between[0]));
    }
    Vector inertia(const Mass& mass) const {
        for (const PointMotion& point : solution_.points) {
            if (point.point == mass.centre && std::count(point.bodies.begin(), point.bodies.end(), mass.body) > 0)
                return -mass.mass * point.acceleration.value();
        }
        ADD_FAILURE() << "no acceleration of the mass of " << name(mass.body);
        return {};
    }

    // --- power ---
    Exact omega(BodyIndex body) const { return body == frame ? Exact() : solution_.bodies[at(body)].omega.value(); }
    Vector velocity(BodyIndex body, const Vector& place) const {
        if (body == frame) return {};
        for (const PointMotion& point : solution_.points) {
            if (std::count(point.bodies.begin(), point.bodies.end(), body) > 0)
                return *point.velocity + omega(body) * quarter_turn(place - solution_.pose.at(point.point));
        }
        ADD_FAILURE() << "no velocity on " << name(body);
        return {};
    }
    Vector unit(const Vector& direction) const { return unit_along(direction, solution_.pose.bits); }

    /// Computed from the loads, masses and input forces of the file, not from the free bodies.
    void no_power_is_lost() const {
        Exact total;
        double sizes = 0;
        const auto add = [&](const Exact& power) {
            total += power;
            sizes += std::abs(power.to_double());
        };
        const Pose& pose = solution_.pose;
        const auto force = [&](BodyIndex body, PointIndex point, const Vector& value) {
            add(dot(value, velocity(body, pose.at(point))));
        };
        for (const Load& load : mechanism_.loads) {
            if (const auto* push = std::get_if<ForceLoad>(&load)) {
                force(push->pin == none ? push->body : mechanism_.joint(push->pin).bodies.back(), push->at,
                      given(*push));
            } else if (const auto* couple = std::get_if<CoupleLoad>(&load)) {
                add(couple->value * omega(couple->body));
            } else if (const auto* distributed = std::get_if<DistributedLoad>(&load)) {
                for (const auto& [place, part] : parts_of(*distributed))
                    add(dot(part, velocity(distributed->body, place)));
            } else if (const auto* torsion = std::get_if<TorsionLoad>(&load)) {
                add(-torsion->stiffness * torsion->turned * (omega(torsion->bodies[0]) - omega(torsion->bodies[1])));
            } else {
                const auto& spring = std::get<SpringLoad>(load);
                force(spring.bodies[0], spring.between[0], pull(spring));
                force(spring.bodies[1], spring.between[1], -pull(spring));
            }
        }
        for (const Mass& mass : mechanism_.masses) {
            if (mechanism_.gravity) force(mass.body, mass.centre, mass.mass * *mechanism_.gravity);
            if (!mechanism_.inertia_forces) continue;
            force(mass.body, mass.centre, inertia(mass));
            add(-mass.inertia * solution_.bodies[at(mass.body)].alpha.value() * omega(mass.body));
        }
        for (std::size_t e = 0; e < mechanism_.efforts.size(); ++e) {
            const Exact& value = *solution_.efforts[e].value;
            const Effort& effort = mechanism_.efforts[e];
            if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
                add(value * (omega(couple->body) - omega(couple->from)));
            } else if (const auto* push = std::get_if<ForceEffort>(&effort)) {
                force(push->body, push->at, value * unit(direction_of(push->along, pose)));
            } else {
                const JointIndex joint = std::get<ActuatorEffort>(effort).joint;
                const Joint& slide = mechanism_.joints[at(joint)];
                const Vector along = value * pose.guide_units[at(joint)];
                force(slide.bodies[0], slide.point, along);
                force(slide.bodies[1], slide.point, -along);
            }
        }
        expect_nothing(total, sizes, "virtual power");
        ASSERT_TRUE(solution_.virtual_work || solution_.free_bodies.empty());
        if (solution_.virtual_work)
            expect_nothing(solution_.virtual_work->total, sizes, "virtual power as it is shown");
    }

    /// What a sentence says of the forces on a body is all of it: the resultant of those that it names is what they
    /// add up to, and loads that act besides "two forces only" are named.
    void told_forces_are_all() const {
        told_forces_are_all(solution_.free_bodies, solution_.taken_together);
        if (!solution_.superposition) return;
        for (const Superposition::Part& part : solution_.superposition->parts)
            told_forces_are_all(part.bodies, part.together);
    }
    void told_forces_are_all(const std::vector<FreeBody>& bodies, const std::vector<TakenTogether>& groups) const {
        // A force that its couple moves aside is the same force.
        const auto sum_of = [&](Symbols named, const auto& is_on) {
            for (Symbol& each : named) each = where_it_acts(each);
            Vector sum{0, 0};
            for (const FreeBody& body : bodies)
                if (is_on(body))
                    for (const AppliedForce& each : body.forces)
                        if (std::find(named.begin(), named.end(), each.symbol) != named.end()) sum = sum + each.force;
            return sum;
        };
        const auto hold = [&](const std::vector<AppliedForce>& sums, const auto& is_on) {
            for (const AppliedForce& each : sums) {
                if (each.force_statement == none) continue;
                const Message& said = solution_.protocol.statements[at(each.force_statement)].message;
                if (said.sentence != lang::sentences::known_resultant) continue;
                const Vector misses = sum_of(std::get<Symbols>(said.arguments[1]), is_on) - each.force;
                expect_nothing(misses, largest_, "the resultant " + name_of(each.symbol) + " of what is named");
            }
        };
        for (const FreeBody& body : bodies) {
            hold(body.sums, [&](const FreeBody& other) { return &other == &body; });
            for (const AppliedForce& each : body.forces)
                if (!each.is_reaction() && each.kind != Quantity::Kind::effort) names_besides(body, each);
        }
        for (const TakenTogether& group : groups)
            hold(group.sums, [&](const FreeBody& body) {
                // Pins are left out of the list; the symbol of a load names its own.
                return body.body == none ||
                       std::find(group.bodies.begin(), group.bodies.end(), body.body) != group.bodies.end();
            });
    }
    void names_besides(const FreeBody& body, const AppliedForce& load) const {
        using namespace lang::sentences;
        if (solution_.superposition || body.body == none) return;  // there the load may not act
        for (const Statement& statement : solution_.protocol.statements) {
            const Key said = statement.message.sentence;
            if (statement.bodies != std::vector{body.body} || statement.section != Topic::forces ||
                (said != two_force_body && said != two_force_guide))
                continue;
            const auto* besides = std::get_if<Symbols>(&statement.message.arguments.back());
            const Symbols named = besides != nullptr ? *besides : Symbols{};
            EXPECT_NE(std::find(named.begin(), named.end(), load.symbol), named.end())
                << name_of(load.symbol) << " acts too on " << name(body.body);
        }
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const NumericForces& numeric_;
    double size_ = 1, largest_ = 0, largest_load_ = 0;
};

}  // namespace

bool wholly_known(const NumericForces& forces) {
    return forces.indeterminacy == 0 && forces.balanced &&
           std::all_of(forces.actions.begin(), forces.actions.end(), [](const auto& action) { return action.known; }) &&
           std::find(forces.effort_known.begin(), forces.effort_known.end(), false) == forces.effort_known.end();
}

void expect_laws_of_forces(const Solution& solution, const NumericForces& numeric) {
    HeldForces(solution, numeric).all();
}

void expect_determined_forces_only(const Solution& solution, const NumericForces& numeric) {
    HeldForces(solution, numeric).gives_only_what_is_determined();
}

void expect_equilibrium_of_bodies(const Solution& solution) {
    ASSERT_FALSE(solution.free_bodies.empty());
    for (const FreeBody& body : solution.free_bodies) {
        Vector sum;
        Exact moment = 0;
        for (const AppliedForce& applied : body.forces) {
            sum = sum + applied.force;
            moment = moment + cross(applied.at, applied.force) + applied.couple;
        }
        EXPECT_EQ(sum, (Vector{0, 0}));
        EXPECT_EQ(moment, Exact(0));
    }
}

}  // namespace kinegraph
