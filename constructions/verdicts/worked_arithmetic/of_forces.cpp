#include "constructions/verdicts/worked_arithmetic/of_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/drawing/spring_force.hpp"
#include "engine/file/units.hpp"
#include "engine/number/geometry.hpp"
#include "engine/solution/forces.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::worked_arithmetic {

void OfForces::force_found(StatementIndex statement, const FreeBody& body, const AppliedForce& applied, bool in_all) {
    if (body.in_parts) return;
    if (is_by_virtual_work(statement)) return;
    const Quantity quantity = quantity_of(body, applied);
    const double force = length(applied.force), couple = applied.couple.to_double();
    if (!applied.force.is_zero()) {
        const bool nothing = magnitudes_.is_noise(quantity, force);
        if (!nothing) by_moments_of_parallels(statement, body, applied);
        telling_.tell(statement, applied.symbol, {}, std::nullopt, nothing ? 0 : in(force, units_.force), units_.force);
        if (!nothing && in_all) moved_aside(statement, body, applied);
    } else if (couple != 0) {
        Symbol symbol = applied.symbol;
        symbol.letter = Symbol::Letter::M;
        telling_.tell(statement, symbol, force_times_arm(statement, body, couple), std::nullopt,
                      in(couple, units_.moment), units_.moment);
    }
}

/// F = ΣM/h: the moments of all other forces about the line of the force that the sum gives, divided by the distance h
/// of the two parallels.
void OfForces::by_moments_of_parallels(StatementIndex statement, const FreeBody& body, const AppliedForce& found) {
    const Message& said = telling_.message(statement);
    if (said.sentence != lang::sentences::parallel_forces || std::get<Symbol>(said.arguments[1]) != found.symbol)
        return;
    const auto is_of_it = [&](const Working& told) { return told.of == found.symbol; };
    if (std::any_of(said.worked_arithmetic.begin(), said.worked_arithmetic.end(), is_of_it)) return;
    const auto other = std::find_if(body.forces.begin(), body.forces.end(), [&](const AppliedForce& each) {
        return each.symbol == std::get<Symbol>(said.arguments[2]) && each.joint != none;
    });
    if (other == body.forces.end()) return;
    std::vector<double> moments;
    for (const AppliedForce& each : body.forces) {
        if (&each == &found || &each == &*other) continue;
        for (const double part : {each.couple.to_double(), cross(each.at - other->at, each.force).to_double()})
            if (part != 0) moments.push_back(in(part, units_.moment));
    }
    const double sum = std::accumulate(moments.begin(), moments.end(), 0.0), force = length(found.force);
    if (moments.empty() || found.force.is_zero()) return;
    const double h = distance(other->at, finite_line_through(point_at(found.at), found.force));
    if (!(h > 0)) return;
    if (moments.size() > 1) {
        const std::string& about = solution_.mechanism.point(solution_.mechanism.joint(other->joint).point).name;
        Working of_all{{Symbol::Letter::M, about, {}}, {}, std::nullopt, {sum, units_.moment.symbol}};
        of_all.summands = moments;
        telling_.message(statement).worked_arithmetic.push_back(std::move(of_all));
    }
    telling_.tell(statement, found.symbol, {{std::abs(sum)}}, in(h * units_.force.si.to_double(), units_.moment),
                  in(force, units_.force), units_.force);
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

/// M = F·b, if the sentence balances a couple of two forces; b in the length unit of the moment unit.
Factors OfForces::force_times_arm(StatementIndex statement, const FreeBody& body, double couple) const {
    for (const FreeBody::Arm& arm : body.arms) {
        if (arm.statement != statement || arm.is_shift) continue;
        const double b = distance(arm.about, arm.foot);
        if (!(b > 0)) continue;
        return {{in(couple / b, units_.force)}, {in(b * units_.force.si.to_double(), units_.moment)}};
    }
    return {};
}

/// For a support that also transmits a couple: the couple at the pair, and the offset of the single force, d = M/F.
void OfForces::moved_aside(StatementIndex statement, const FreeBody& body, const AppliedForce& applied) {
    if (!applied.is_reaction() || applied.is_component) return;
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
    tell_aside(statement, std::abs(couple) / force, force);
}

/// The unit of M/F in displayed units: m for N m and N, mm for N m and kN; none if no length has such a unit.
std::optional<Unit> OfForces::unit_of_arm() const {
    const Exact size = units_.moment.si / units_.force.si;
    if (units_.length.si == size) return units_.length;
    for (const KnownUnit& each : known_units())
        if (each.kind == QuantityKind::length && each.si == size) return Unit{std::string(each.symbol), each.si};
    return std::nullopt;
}

/// d = M/F, both as displayed; then again in the file's unit if that differs.
void OfForces::tell_aside(StatementIndex statement, double arm, double force) {
    const Symbol d{Symbol::Letter::length, "d", {}};
    if (const auto unit = unit_of_arm()) {
        const double size = in(force, units_.force), aside = in(arm, *unit);
        telling_.tell(statement, d, {{aside * size}}, size, aside, *unit);
        telling_.tell_also(statement, d, in(arm, units_.length), units_.length);
    } else {
        telling_.tell(statement, d, {}, std::nullopt, in(arm, units_.length), units_.length);
    }
}

bool OfForces::is_by_virtual_work(StatementIndex statement) {
    using namespace lang::sentences;
    static constexpr std::array by_work{moments_alone,     moments_give,      components_alone,   components_give,
                                        translation_alone, translation_gives, virtual_work_alone, virtual_work_gives};
    const Key said = telling_.message(statement).sentence;
    return std::find(by_work.begin(), by_work.end(), said) != by_work.end();
}

/// If the factors' units give another unit than the result's, adds the conversion factor: 1000 for kN, 386.1 for pounds
/// and inches. A power of ten that only changes the notation goes into the first factor instead: kg mm² as kg m².
void OfForces::product(StatementIndex statement, const Symbol& of, Factors factors, const Exact& made, double value,
                       const Unit& unit) {
    const double ratio = (unit.si / made).to_double();
    constexpr double same_ratio = 1e-12;
    constexpr double plain = 1e4;
    std::optional<double> divisor;
    if (ratio > plain || ratio < 1 / plain) {
        factors.front().value /= ratio;
        return telling_.tell(statement, of, std::move(factors), divisor, in(value, unit), unit);
    }
    if (ratio > 1 + same_ratio) divisor = ratio;
    if (ratio < 1 - same_ratio) factors.push_back({1 / ratio});
    telling_.tell(statement, of, std::move(factors), divisor, in(value, unit), unit);
}

void OfForces::inertia(StatementIndex statement) {
    const Symbol of = std::get<Symbol>(telling_.message(statement).arguments[1]);
    for (const FreeBody& body : solution_.free_bodies)
        for (const AppliedForce& applied : body.forces) {
            if (applied.kind != Quantity::Kind::inertia ||
                body.body != protocol_.statements[at_index(statement)].bodies[0])
                continue;
            const Mass& mass = solution_.mechanism.masses[at_index(applied.given)];
            const double m = mass.mass.to_double(), force = length(applied.force), couple = applied.couple.to_double();
            if (of.letter == Symbol::Letter::F && force > 0)
                product(statement, of, {{in(m, units_.mass)}, {in(force / m, units_.acceleration)}},
                        units_.mass.si * units_.acceleration.si, force, units_.force);
            const double alpha = telling_.spin(body.body, Symbol::Letter::alpha);
            if (of.letter == Symbol::Letter::M && couple != 0)
                product(statement, of, {{-in(mass.inertia.to_double(), units_.inertia)}, {alpha}}, units_.inertia.si,
                        couple, units_.moment);
        }
}

void OfForces::stretched(StatementIndex statement) {
    const Key sentence = telling_.message(statement).sentence;
    if (sentence != lang::sentences::elastic_spring && sentence != lang::sentences::torsion_spring) return;
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
        telling_.tell(statement, of,
                      {{in(spring->elastic->stiffness.to_double(), units_.force)}, {stretch, false, true}},
                      std::nullopt, in(force, units_.force), units_.force);
    }
}

void OfForces::distributed(StatementIndex statement) {
    const Message& said = telling_.message(statement);
    if (said.sentence != lang::sentences::distributed_load) return;
    const Symbol of = std::get<Symbol>(said.arguments[1]);
    for (const Load& load : solution_.mechanism.loads) {
        const auto* over = std::get_if<DistributedLoad>(&load);
        if (over == nullptr || over->name != of.about) continue;
        const double ends = distance(solution_.pose.at(over->from), solution_.pose.at(over->to));
        const double mean = (over->intensity[0].to_double() + over->intensity[1].to_double()) / 2;
        const double on_each = in(mean * units_.length.si.to_double(), units_.force),
                     force = in(std::abs(mean) * ends, units_.force);
        telling_.tell(statement, of, {{std::abs(on_each)}, {in(ends, units_.length)}}, std::nullopt, force,
                      units_.force);
        telling_.tell(statement, {Symbol::Letter::length, "x", {}}, {}, std::nullopt,
                      in(centroid_of(*over).place.to_double() * ends, units_.length), units_.length);
    }
}

void OfForces::left_over(const Resultant& resultant) {
    if (resultant.vanishes) return;
    const Symbol of = std::get<Symbol>(telling_.message(resultant.statement).arguments[1]);
    if (of.letter == Symbol::Letter::F)
        telling_.tell(resultant.statement, of, {}, std::nullopt, in(length(*resultant.force), units_.force),
                      units_.force);
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
        telling_.tell(resultant.statement, std::get<Symbol>(said[3]), std::move(factors), std::nullopt, moment,
                      units_.moment);
    }
    if (of.letter != Symbol::Letter::F)
        telling_.tell(resultant.statement, of, {}, std::nullopt, in(resultant.couple->to_double(), units_.moment),
                      units_.moment);
}

void OfForces::by_ritter(const Truss::Cut& cut) {
    const Message& said = telling_.message(cut.statement);
    if (!solution_.truss->bars[at_index(cut.found)].force) return;
    const double force = in(solution_.truss->tension(at_index(cut.found), solution_.pose.points), units_.force);
    const double arm = solution_.truss->numbers_of(cut, solution_.pose.points).arm;
    const Symbol of = std::get<Symbol>(said.arguments[1]);
    if (!cut.pivot) return telling_.tell(cut.statement, of, {{force * arm}}, arm, force, units_.force);
    // The displayed force unit times the arm's unit, so that the result follows from the displayed numbers.
    Unit unit{units_.force.symbol + " " + units_.length.symbol, units_.force.si * units_.length.si};
    if (unit.si == units_.moment.si) unit = units_.moment;
    const double b = in(arm, units_.length);
    telling_.tell_sum(cut.statement, {Symbol::Letter::M, cut.pivot_name, {}}, moments_on_side(cut),
                      in(cut.moment->to_double(), unit), unit);
    telling_.tell(cut.statement, of, {{force * b}}, b, force, units_.force);
}

/// F·b of each force on one side of a cut, except those of the cut bars sought.
std::vector<Telling::Product> OfForces::moments_on_side(const Truss::Cut& cut) const {
    const Truss& truss = *solution_.truss;
    std::vector<Telling::Product> moments;
    const auto add = [&](const Vector& force, int pin) {
        const Vector from = solution_.pose.at(truss.structure.pins[at_index(pin)].point) - *cut.pivot;
        const double moment = cross(from, force).to_double(), size = length(force);
        constexpr double through = 1e-9;
        if (std::abs(moment) <= through * size * solution_.pose.size.to_double()) return;
        moments.push_back({std::copysign(in(size, units_.force), moment), in(std::abs(moment) / size, units_.length)});
    };
    const auto among = [](const std::vector<int>& some, int one) {
        return std::find(some.begin(), some.end(), one) != some.end();
    };
    for (const int pin : cut.side) {
        for (const Truss::External& external : truss.externals)
            if (external.pin == pin && external.force) add(*external.force, pin);
        for (const int bar : truss.structure.pins[at_index(pin)].bars) {
            const Recorded<Vector>& pull = truss.bars[at_index(bar)].force;
            if (!pull || among(cut.bars, bar) || among(cut.side, truss.structure.other_end(bar, pin))) continue;
            add(truss.structure.bars[at_index(bar)].pins[0] == pin ? *pull : -*pull, pin);
        }
    }
    return moments;
}

void OfForces::resultant_found(const AppliedForce& sum) {
    if (telling_.message(sum.force_statement).sentence == lang::sentences::known_resultant)
        telling_.tell(sum.force_statement, sum.symbol, {}, std::nullopt, in(length(sum.force), units_.force),
                      units_.force);
}

/// Whether this is the sentence that offsets a force.
bool OfForces::moves(StatementIndex statement, const Symbol& force) const {
    const Message& said = telling_.message(statement);
    return said.sentence == lang::sentences::inertia_moved && std::get<Symbol>(said.arguments[1]) == force;
}

void OfForces::added_up(const FreeBody& body) {
    for (const AppliedForce& sum : body.sums) {
        resultant_found(sum);
        for (const FreeBody::Arm& arm : body.arms)
            if (arm.is_shift && (arm.statement == sum.force_statement || moves(arm.statement, sum.symbol))) {
                tell_aside(arm.statement, distance(arm.about, arm.foot), length(sum.force));
            }
    }
}

void OfForces::added_up(const TakenTogether& together) {
    for (const AppliedForce& sum : together.sums) {
        resultant_found(sum);
        for (const StatementIndex each : indices_of(protocol_.statements))
            if (const auto arm = shift_of(solution_.protocol, solution_.free_bodies, each, sum))
                tell_aside(each, length(*arm), length(sum.force));
    }
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
        Working working{
            couple.symbol, {}, std::nullopt, {in(couple.total->to_double(), units_.moment), units_.moment.symbol}};
        for (const Recorded<Exact>& part : couple.parts)
            working.summands.push_back(in(part->to_double(), units_.moment));
        telling_.message(superposition.statement).worked_arithmetic.push_back(std::move(working));
    }
}

/// F = ΣM/b, if it alone has a moment about the centre.
void OfForces::by_moments(const VirtualMotion& motion) {
    const double force = length(*motion.force);
    std::optional<double> arm;
    const Key sentence = telling_.message(motion.statement).sentence;
    if (sentence == lang::sentences::moments_alone || sentence == lang::sentences::moments_give)
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
    if (said.sentence != lang::sentences::virtual_work_alone && said.sentence != lang::sentences::virtual_work_gives)
        return;
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
            ratios.push_back(
                {omega(turning.body), omega(first->body), turning.omega->to_double() / first->omega->to_double()});
    }
    if (!ratios.empty()) said.arguments.emplace_back(std::move(ratios));
}

}  // namespace kinegraph::worked_arithmetic
