#include "constructions/workings/of_forces.hpp"

#include <algorithm>
#include <cmath>

#include "engine/spring_force.hpp"

namespace kinegraph::workings {

void OfForces::force_found(StatementIndex statement, const FreeBody& body, const AppliedForce& applied, bool in_all) {
    if (body.in_parts) return;
    if (is_by_virtual_work(statement)) return;
    const Quantity quantity = quantity_of(body, applied);
    const double force = length(applied.force), couple = applied.couple.to_double();
    if (!applied.force.is_zero()) {
        const bool nothing = magnitudes_.is_noise(quantity, force);
        telling_.tell(statement, applied.symbol, {}, std::nullopt, nothing ? 0 : in(force, units_.force), units_.force);
        if (!nothing && in_all) moved_aside(statement, body, applied);
    } else if (couple != 0) {
        Symbol symbol = applied.symbol;
        symbol.letter = Symbol::Letter::M;
        telling_.tell(statement, symbol, force_times_arm(statement, body, couple), std::nullopt, in(couple, units_.moment),
                      units_.moment);
    }
}

void OfForces::nothing_to_balance(StatementIndex statement, int effort) {
    const auto index = static_cast<std::size_t>(effort);
    if (index >= solution_.efforts.size()) return;
    const EffortValue& found = solution_.efforts[index];
    if (!found.value || !found.value->is_zero() || is_by_virtual_work(statement)) return;
    const bool couple = std::holds_alternative<CoupleEffort>(solution_.mechanism.efforts[index]);
    telling_.tell(statement, {couple ? Symbol::Letter::M : Symbol::Letter::F, found.name, {}}, {}, std::nullopt, 0,
                  couple ? units_.moment : units_.force);
}

/// M = F·b, where the sentence balances a couple of two forces; b in the length that makes up the unit of moments.
Factors OfForces::force_times_arm(StatementIndex statement, const FreeBody& body, double couple) const {
    for (const FreeBody::Arm& arm : body.arms) {
        if (arm.statement != statement || arm.is_shift) continue;
        const double b = distance(arm.about, arm.foot);
        if (!(b > 0)) continue;
        return {{in(couple / b, units_.force)}, {in(b * units_.force.si.to_double(), units_.moment)}};
    }
    return {};
}

/// Of a support that holds a couple, too: the couple at the pair, and how far aside the one force acts, d = M/F.
void OfForces::moved_aside(StatementIndex statement, const FreeBody& body, const AppliedForce& applied) {
    if (applied.kind != AppliedForce::Kind::reaction || applied.is_component) return;
    const auto pair = std::find_if(solution_.forces.begin(), solution_.forces.end(), [&](const JointForce& each) {
        return each.joint == applied.joint && each.on == body.body && each.from == applied.from;
    });
    if (pair == solution_.forces.end() || !pair->couple || pair->couple->is_zero()) return;
    const double couple = pair->couple->to_double(), force = length(applied.force);
    Quantity quantity = quantity_of(*pair);
    quantity.kind = Quantity::Kind::couple;
    if (magnitudes_.is_noise(quantity, couple)) return;
    Symbol of = applied.symbol;
    of.letter = Symbol::Letter::M;
    telling_.tell(statement, std::move(of), {}, std::nullopt, in(couple, units_.moment), units_.moment);
    const double arm = std::abs(couple) / force;
    telling_.tell(statement, {Symbol::Letter::length, "d", {}}, {{in(arm, units_.length) * in(force, units_.force)}},
                  in(force, units_.force), in(arm, units_.length), units_.length);
}

bool OfForces::is_by_virtual_work(StatementIndex statement) {
    const Sentence said = telling_.message(statement).sentence;
    return said == Sentence::moments_alone || said == Sentence::components_alone || said == Sentence::virtual_work_alone;
}

/// Where the factors' units make another unit than the result's, what makes the one of the other is told with them: 1000 for kN,
/// 386.1 for pounds and inches.
void OfForces::product(StatementIndex statement, const Symbol& of, Factors factors, const Exact& made, double value,
                       const Unit& unit) {
    const double ratio = (unit.si / made).to_double();
    constexpr double rounding = 1e-12;
    std::optional<double> divisor;
    if (ratio > 1 + rounding) divisor = ratio;
    if (ratio < 1 - rounding) factors.push_back({1 / ratio});
    telling_.tell(statement, of, std::move(factors), divisor, in(value, unit), unit);
}

void OfForces::inertia(StatementIndex statement) {
    const Symbol of = std::get<Symbol>(telling_.message(statement).arguments[1]);
    for (const FreeBody& body : solution_.free_bodies)
        for (const AppliedForce& applied : body.forces) {
            if (applied.kind != AppliedForce::Kind::inertia || body.body != protocol_.statements[at_index(statement)].bodies[0])
                continue;
            const Mass& mass = solution_.mechanism.masses[at_index(applied.given)];
            const double m = mass.mass.to_double(), force = length(applied.force), couple = applied.couple.to_double();
            if (of.letter == Symbol::Letter::F && force > 0)
                product(statement, of, {{in(m, units_.mass)}, {in(force / m, units_.acceleration)}},
                        units_.mass.si * units_.acceleration.si, force, units_.force);
            const double alpha = telling_.spin(body.body, Symbol::Letter::alpha);
            if (of.letter == Symbol::Letter::M && couple != 0)
                product(statement, of, {{-in(mass.inertia.to_double(), units_.inertia)}, {alpha}}, units_.inertia.si, couple,
                        units_.moment);
        }
}

void OfForces::stretched(StatementIndex statement) {
    const Sentence sentence = telling_.message(statement).sentence;
    if (sentence != Sentence::elastic_spring && sentence != Sentence::torsion_spring) return;
    const Symbol of = std::get<Symbol>(telling_.message(statement).arguments[0]);
    for (const Load& load : solution_.mechanism.loads) {
        if (const auto* torsion = std::get_if<TorsionLoad>(&load); torsion != nullptr && torsion->name == of.about) {
            const double stiffness = torsion->stiffness.to_double(), turned = torsion->turned.to_double();
            telling_.tell(statement, of, {{in(-stiffness, units_.moment)}, {turned}}, std::nullopt,
                          in(-stiffness * turned, units_.moment), units_.moment);
        }
        const auto* spring = std::get_if<SpringLoad>(&load);
        if (spring == nullptr || !spring->elastic || spring->name != of.about) continue;
        const double stretch = distance(solution_.pose.at(spring->between[0]), solution_.pose.at(spring->between[1])) -
                               spring->elastic->free_length.to_double();
        const double force = spring->elastic->stiffness.to_double() * stretch;
        telling_.tell(statement, of, {{in(spring->elastic->stiffness.to_double(), units_.force)}, {stretch}}, std::nullopt,
                      in(force, units_.force), units_.force);
    }
}

void OfForces::distributed(StatementIndex statement) {
    const Message& said = telling_.message(statement);
    if (said.sentence != Sentence::distributed_load) return;
    const Symbol of = std::get<Symbol>(said.arguments[1]);
    for (const Load& load : solution_.mechanism.loads) {
        const auto* over = std::get_if<DistributedLoad>(&load);
        if (over == nullptr || over->name != of.about) continue;
        const double ends = distance(solution_.pose.at(over->from), solution_.pose.at(over->to));
        const double mean = (over->intensity[0].to_double() + over->intensity[1].to_double()) / 2;
        const double on_each = in(mean * units_.length.si.to_double(), units_.force),
                     force = in(std::abs(mean) * ends, units_.force);
        telling_.tell(statement, of, {{std::abs(on_each)}, {in(ends, units_.length)}}, std::nullopt, force, units_.force);
        telling_.tell(statement, {Symbol::Letter::length, "x", {}}, {}, std::nullopt,
                      in(centroid_of(*over).place.to_double() * ends, units_.length), units_.length);
    }
}

void OfForces::left_over(const Resultant& resultant) {
    if (resultant.vanishes) return;
    const Symbol of = std::get<Symbol>(telling_.message(resultant.statement).arguments[1]);
    if (of.letter == Symbol::Letter::F)
        telling_.tell(resultant.statement, of, {}, std::nullopt, in(length(*resultant.force), units_.force), units_.force);
    const std::vector<Argument>& said = telling_.message(resultant.statement).arguments;
    if (resultant.residual_force)
        telling_.tell(resultant.statement, std::get<Symbol>(said[2]), {}, std::nullopt,
                      in(length(*resultant.residual_force), units_.force), units_.force);
    if (resultant.residual_couple) {
        Factors factors;
        const double moment = in(resultant.residual_couple->to_double(), units_.moment);
        for (const FreeBody& body : solution_.free_bodies)
            for (const FreeBody::Arm& arm : body.arms)
                if (arm.statement == resultant.statement)
                    factors = {{std::copysign(in(length(*resultant.force), units_.moment), moment)},
                               {distance(arm.about, arm.foot)}};
        telling_.tell(resultant.statement, std::get<Symbol>(said[3]), std::move(factors), std::nullopt, moment, units_.moment);
    }
    if (of.letter != Symbol::Letter::F)
        telling_.tell(resultant.statement, of, {}, std::nullopt, in(resultant.couple->to_double(), units_.moment), units_.moment);
}

void OfForces::by_ritter(const Truss::Cut& cut) {
    const Message& said = telling_.message(cut.statement);
    if (said.sentence != Sentence::truss_cut_moment || !solution_.truss->bars[at_index(cut.found)].force) return;
    const double moment = cut.moment->to_double();
    const double arm = solution_.truss->numbers_of(cut, solution_.pose.points).arm;
    const double force = solution_.truss->tension(at_index(cut.found), solution_.pose.points);
    const Symbol of = std::get<Symbol>(said.arguments[1]);
    telling_.tell(cut.statement, {Symbol::Letter::M, cut.pivot_name, {}}, {}, std::nullopt, in(moment, units_.moment),
                  units_.moment);
    telling_.tell(cut.statement, of, {{in(force, units_.force) * in(arm, units_.length)}}, in(arm, units_.length),
                  in(force, units_.force), units_.force);
}

void OfForces::resultant_found(const AppliedForce& sum) {
    if (telling_.message(sum.force_statement).sentence == Sentence::known_resultant)
        telling_.tell(sum.force_statement, sum.symbol, {}, std::nullopt, in(length(sum.force), units_.force), units_.force);
}

/// Whether it is the sentence that moves a force aside.
bool OfForces::moves(StatementIndex statement, const Symbol& force) const {
    const Message& said = telling_.message(statement);
    return said.sentence == Sentence::inertia_moved && std::get<Symbol>(said.arguments[1]) == force;
}

void OfForces::added_up(const FreeBody& body) {
    for (const AppliedForce& sum : body.sums) {
        resultant_found(sum);
        for (const FreeBody::Arm& arm : body.arms)
            if (arm.is_shift && (arm.statement == sum.force_statement || moves(arm.statement, sum.symbol))) {
                const double aside = in(distance(arm.about, arm.foot), units_.length),
                             force = in(length(sum.force), units_.force);
                telling_.tell(arm.statement, {Symbol::Letter::length, "d", {}}, {{aside * force}}, force, aside, units_.length);
            }
    }
}

void OfForces::added_up(const TakenTogether& together) {
    for (const AppliedForce& sum : together.sums) resultant_found(sum);
}

void OfForces::superposed(const Superposition& superposition) {
    for (const Superposition::Part& part : superposition.parts) {
        for (const FreeBody& body : part.bodies) added_up(body);
        for (const TakenTogether& together : part.together) added_up(together);
    }
    for (const Superposition::Sum& sum : superposition.sums)
        for (const int index : protocol_.polygons[at_index(sum.polygon)].vectors) {
            const DrawnVector& vector = protocol_.vectors[at_index(index)];
            if (vector.symbol == sum.symbol)
                telling_.tell(superposition.statement, sum.symbol, {}, std::nullopt,
                              in(protocol_.modulus_of(vector), units_.force), units_.force);
        }
    for (const Superposition::CoupleSum& couple : superposition.couples) {
        Working working{couple.symbol, {}, std::nullopt, {in(couple.total->to_double(), units_.moment), units_.moment.symbol}};
        for (const Recorded<Exact>& part : couple.parts) working.summands.push_back(in(part->to_double(), units_.moment));
        telling_.message(superposition.statement).workings.push_back(std::move(working));
    }
}

/// F = ΣM/b, where it alone has a moment about the centre.
void OfForces::by_moments(const VirtualMotion& motion) {
    const double force = length(*motion.force);
    std::optional<double> arm;
    if (telling_.message(motion.statement).sentence == Sentence::moments_alone)
        for (const FreeBody& body : solution_.free_bodies)
            for (const FreeBody::Arm& each : body.arms)
                if (each.statement == motion.statement && each.is_sought) arm = distance(each.about, each.foot);
    Factors factors;
    if (arm) factors = {{in(force * *arm, units_.force)}};
    telling_.tell(motion.statement, motion.sought, std::move(factors), arm, in(force, units_.force), units_.force);
}

void OfForces::by_virtual_work(const VirtualMotion& motion) {
    Message& said = telling_.message(motion.statement);
    if (motion.couple)
        telling_.tell(motion.statement, motion.sought, {}, std::nullopt, in(motion.couple->to_double(), units_.moment),
                      units_.moment);
    if (motion.force) by_moments(motion);
    if (said.sentence != Sentence::virtual_work_alone) return;
    const VirtualMotion::Turning* first = nullptr;
    const bool one_centre = std::get<Names>(said.arguments[2]).size() == 1;
    Ratios ratios;
    const auto omega = [&](BodyIndex body) {
        return Symbol{Symbol::Letter::omega, solution_.mechanism.bodies[at_index(body)].name, {}};
    };
    for (const VirtualMotion::Turning& turning : motion.bodies) {
        if (!turning.omega) continue;
        if (first == nullptr)
            first = &turning;
        else if (*turning.omega != *first->omega || !one_centre)
            ratios.push_back({omega(turning.body), omega(first->body), turning.omega->to_double() / first->omega->to_double()});
    }
    if (!ratios.empty()) said.arguments.emplace_back(std::move(ratios));
}

}  // namespace kinegraph::workings
