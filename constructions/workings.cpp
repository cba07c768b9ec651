#include "constructions/workings.hpp"

#include <algorithm>
#include <cmath>

#include "engine/magnitudes.hpp"

namespace kinegraph {
namespace {

class Workings {
public:
    explicit Workings(Solution& solution)
        : solution_(solution), protocol_(solution.protocol), units_(solution.mechanism.units), magnitudes_(solution) {}

    void add() {
        for (Statement& statement : protocol_.statements) leave_out_what_vanishes(statement.message);
        name_polygons();
        add_slidings();
        for (const DrawnVector& vector : protocol_.vectors)
            if (vector.statement != none && plane_of(vector) != Plane::force) drawn(vector);
        for (const StatementIndex each : indices_of(protocol_.statements)) found(each);
        for (const SecondWay& way : solution_.second_way) carried_over(way);
        for (const Curvature& curvature : solution_.curvature) of_curvature(curvature);
        for (const Resultant& resultant : solution_.resultants) left_over(resultant);
        if (solution_.truss)
            for (const Truss::Cut& cut : solution_.truss->cuts) by_ritter(cut);
        for (const FreeBody& body : solution_.free_bodies) added_up(body);
        for (const TakenTogether& together : solution_.taken_together) added_up(together);
        if (solution_.superposition) superposed(*solution_.superposition);
        for (const StatementIndex each : indices_of(protocol_.statements)) stretched(each);
        for (const VirtualMotion& motion : solution_.virtual_motions) by_virtual_work(motion);
    }

private:
    using Factors = std::vector<Working::Factor>;
    using Role = DrawnVector::Role;

    Message& message(StatementIndex statement) { return protocol_.statements[at_index(statement)].message; }
    Plane plane_of(const DrawnVector& vector) const { return protocol_.polygons[at_index(vector.polygon)].plane; }
    const Unit& unit_of(const DrawnVector& vector) const {
        return plane_of(vector) == Plane::velocity ? units_.velocity : units_.acceleration;
    }
    static double in(double si, const Unit& unit) { return si / unit.si.to_double(); }

    /// A working is said once, and only where it comes out.
    void tell(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor, double value,
              const Unit& unit) {
        auto& workings = message(statement).workings;
        const auto same = [&](const Working& each) { return each.of == of; };
        if (std::any_of(workings.begin(), workings.end(), same)) return;
        double product = 1;
        for (const Working::Factor& each : factors) product *= each.squared ? each.value * each.value : each.value;
        if (divisor) product /= *divisor;
        constexpr double rounding = 1e-9;
        if (!(std::abs(product - value) <= rounding * std::abs(value))) factors.clear();
        if (factors.empty()) divisor.reset();
        workings.push_back({std::move(of), std::move(factors), divisor, {value, unit.symbol}});
    }

    // --- what sentences leave out --------------------------------------------------------------------------------------------

    bool turns(const Argument& argument) const {
        const Symbol& symbol = std::get<Symbol>(argument);
        const auto body = solution_.mechanism.body_named(symbol.about);
        if (!body) return true;
        const bool omega = symbol.letter == Symbol::Letter::omega;
        const Quantity quantity{.kind = omega ? Quantity::Kind::omega : Quantity::Kind::alpha, .body = *body};
        return !magnitudes_.is_noise(quantity, spin(*body, symbol.letter));
    }
    /// No ω² where nothing turns, no α where it turns uniformly.
    void leave_out_what_vanishes(Message& message) const {
        auto& arguments = message.arguments;
        if (message.sentence == Sentence::crank_acceleration && !turns(arguments[5])) arguments.pop_back();
        if (message.sentence != Sentence::image_acceleration) return;
        const bool omega = turns(arguments[4]), alpha = turns(arguments[5]);
        if (!omega && !alpha)
            message = {Sentence::translating_acceleration, {arguments[1], arguments[0], arguments[2]}};
        else if (!omega)
            message = {Sentence::image_acceleration_without_omega,
                       {arguments[0], arguments[1], arguments[2], arguments[3], arguments[5]}};
        else if (!alpha)
            arguments.pop_back();
    }

    /// A triangle is of three forces.
    void name_polygons() {
        for (Statement& statement : protocol_.statements) {
            Sentence& sentence = statement.message.sentence;
            if (sentence != Sentence::triangle && sentence != Sentence::triangle_at) continue;
            const auto index = StatementIndex(static_cast<int>(&statement - protocol_.statements.data()));
            if (forces_on(statement.bodies, bodies_at(index)) > 3)
                sentence = sentence == Sentence::triangle ? Sentence::polygon : Sentence::polygon_at;
        }
    }
    /// As a sentence has them: under all loads, or under those of which it speaks.
    const std::vector<FreeBody>& bodies_at(StatementIndex statement) const {
        if (solution_.superposition)
            for (const Superposition::Part& part : solution_.superposition->parts)
                if (!(statement < part.first) && statement < part.end) return part.bodies;
        return solution_.free_bodies;
    }
    /// From outside on bodies taken together.
    static int forces_on(const std::vector<BodyIndex>& bodies, const std::vector<FreeBody>& cut_free) {
        const auto among = [&](BodyIndex body) { return std::find(bodies.begin(), bodies.end(), body) != bodies.end(); };
        int count = 0;
        for (const FreeBody& body : cut_free) {
            if (!among(body.body)) continue;
            for (const AppliedForce& applied : body.forces)
                if (!applied.force.is_zero() && !(applied.from != none && among(applied.from))) ++count;
        }
        return count;
    }

    /// The sentences of the slidings stand in the order of these.
    void add_slidings() {
        auto velocity = solution_.sliding.begin(), acceleration = velocity;
        for (const StatementIndex statement : indices_of(protocol_.statements)) {
            Message& said = message(statement);
            if (said.sentence == Sentence::slide_velocity_on_rest) ++velocity;
            if (said.sentence == Sentence::slide_velocity) slides(statement, (velocity++)->velocity, units_.velocity);
            const bool on_rest = said.sentence == Sentence::slide_acceleration_on_rest;
            if (!on_rest && said.sentence != Sentence::slide_acceleration) continue;
            while (!acceleration->acceleration) ++acceleration;
            const Sliding& sliding = *acceleration++;
            if (on_rest) continue;
            const double coriolis = length(*sliding.coriolis);
            if (magnitudes_.is_noise({.kind = Quantity::Kind::sliding_coriolis, .joint = sliding.joint}, coriolis)) {
                said.sentence = Sentence::slide_acceleration_without_coriolis;
            } else {
                Symbol symbol = std::get<Symbol>(said.arguments[0]);
                symbol.term = "cor";
                const double omega =
                    std::abs(spin(solution_.mechanism.joints[at_index(sliding.joint)].bodies[1], Symbol::Letter::omega));
                const double speed = length(*sliding.velocity);
                tell(statement, symbol, {{2}, {omega}, {in(speed, units_.acceleration)}}, std::nullopt,
                     in(coriolis, units_.acceleration), units_.acceleration);
            }
            slides(statement, sliding.acceleration, units_.acceleration);
        }
    }
    void slides(StatementIndex statement, const Recorded<Vector>& found, const Unit& unit) {
        tell(statement, std::get<Symbol>(message(statement).arguments[0]), {}, std::nullopt, in(length(*found), unit), unit);
    }

    // --- vectors of motion ---------------------------------------------------------------------------------------------------

    /// What the statement that draws a vector says of its length.
    void drawn(const DrawnVector& vector) {
        const Message& said = message(vector.statement);
        const bool image = said.sentence == Sentence::image_velocity || said.sentence == Sentence::image_acceleration;
        const bool alike = said.sentence == Sentence::translating_velocity || said.sentence == Sentence::translating_acceleration;
        // A crank that turns uniformly has its normal part alone, which is told.
        const bool uniform = said.sentence == Sentence::crank_acceleration && said.arguments.size() == 5;
        if (alike || (vector.role == Role::absolute && (image || uniform))) return;
        const Unit& unit = unit_of(vector);
        const double si = protocol_.modulus_of(vector), value = in(si, unit);
        if (magnitudes_.is_noise(vector.quantity, si)) return tell(vector.statement, vector.symbol, {}, std::nullopt, 0, unit);
        const bool known = is_known(vector);
        Factors factors = known ? factors_of(vector, si) : Factors{};
        // A term of an equation that was known already needs no value where nothing is worked out.
        if (known && factors.empty() && protocol_.statements[at_index(vector.statement)].equation) return;
        tell(vector.statement, vector.symbol, std::move(factors), std::nullopt, value, unit);
        if (vector.role == Role::coriolis) tell_direction(vector);
    }
    void tell_direction(const DrawnVector& coriolis) {
        Working& told = message(coriolis.statement).workings.back();
        const BodyIndex turning = coriolis.seen.to.body;
        if (told.of != coriolis.symbol || told.factors.empty() || turning == none) return;
        const bool observed = protocol_.polygons[at_index(coriolis.polygon)].kind == Polygon::Kind::relative_motion;
        const Symbol omega{Symbol::Letter::omega, solution_.mechanism.bodies[at_index(turning)].name, ""};
        told.turned = {velocity_of_coriolis(coriolis.symbol, observed), omega};
    }

    /// Set off by its length, and not read off.
    bool is_known(const DrawnVector& vector) const {
        const std::optional<Equation>& equation = protocol_.statements[at_index(vector.statement)].equation;
        if (!equation) return true;
        for (const std::vector<Term>& side : equation->sides)
            for (const Term& term : side)
                if (term.symbol == vector.symbol) return term.magnitude_known;
        return false;
    }

    Factors factors_of(const DrawnVector& vector, double si) {
        const Unit& unit = unit_of(vector);
        const auto turning = [&](BodyIndex body) { return std::abs(spin(body, Symbol::Letter::omega)); };
        switch (vector.role) {
            case Role::absolute:
                // The crank of the sentence: from its pivot with its ω.
                if (message(vector.statement).sentence == Sentence::crank_velocity && turning(vector.body) > 0)
                    return {{turning(vector.body)}, {in(si / turning(vector.body), unit)}};
                return {};
            case Role::normal:
                return {{turning(vector.body), true}, {in(lever_of(vector), unit)}};
            case Role::tangential:
                return {{std::abs(spin(vector.body,
                                       plane_of(vector) == Plane::velocity ? Symbol::Letter::omega : Symbol::Letter::alpha))},
                        {in(lever_of(vector), unit)}};
            case Role::coriolis: {
                const double omega = turning(vector.seen.to.body);
                return omega > 0 ? Factors{{2}, {omega}, {in(si / (2 * omega), unit)}} : Factors{};
            }
            default:
                return {};
        }
    }
    double lever_of(const DrawnVector& vector) const {
        if (vector.seen.about == none || vector.seen.of.place == none) return 0;
        const ProjectivePoint &from = protocol_.point(vector.seen.about), &to = protocol_.point(vector.seen.of.place);
        return from.at_infinity() || to.at_infinity() ? 0 : distance(from.place(), to.place());
    }
    double spin(BodyIndex body, Symbol::Letter letter) const {
        if (body == none) return 0;
        const BodyMotion& motion = solution_.bodies[at_index(body)];
        const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
        return value ? value->to_double() : 0;
    }

    // --- what a statement ends with ------------------------------------------------------------------------------------------

    void found(StatementIndex statement) {
        const Sentence sentence = message(statement).sentence;
        if (sentence == Sentence::inertia_force || sentence == Sentence::inertia_couple) return inertia(statement);
        for (const Quantity& quantity : protocol_.statements[at_index(statement)].finds) {
            if (quantity.kind == Quantity::Kind::omega) turning_found(statement, quantity, Symbol::Letter::omega);
            if (quantity.kind == Quantity::Kind::alpha) turning_found(statement, quantity, Symbol::Letter::alpha);
        }
        const std::vector<FreeBody>& bodies = bodies_at(statement);
        for (const FreeBody& body : bodies)
            for (const AppliedForce& applied : body.forces)
                if (applied.force_statement == statement)
                    force_found(statement, body, applied, &bodies == &solution_.free_bodies);
    }

    // --- what is added up on the way -----------------------------------------------------------------------------------------
    void resultant_found(const AppliedForce& sum) {
        if (message(sum.force_statement).sentence == Sentence::known_resultant)
            tell(sum.force_statement, sum.symbol, {}, std::nullopt, in(length(sum.force), units_.force), units_.force);
    }
    void added_up(const TakenTogether& together) {
        for (const AppliedForce& sum : together.sums) resultant_found(sum);
    }
    /// Resultants, and by how much an inertia force is moved aside: d = M/F.
    void added_up(const FreeBody& body) {
        for (const AppliedForce& sum : body.sums) {
            resultant_found(sum);
            for (const FreeBody::Arm& arm : body.arms)
                if (arm.is_shift && arm.statement == sum.force_statement) {
                    const double aside = in(distance(arm.about, arm.foot), units_.length),
                                 force = in(length(sum.force), units_.force);
                    tell(arm.statement, {Symbol::Letter::length, "d", {}}, {{aside * force}}, force, aside, units_.length);
                }
        }
    }
    /// Of a cut: the moment of what acts on one side, and F = M/b.
    void by_ritter(const Truss::Cut& cut) {
        const Message& said = message(cut.statement);
        if (said.sentence != Sentence::truss_cut_moment || !solution_.truss->bars[at_index(cut.found)].force) return;
        const double moment = cut.moment->to_double();
        const double arm = solution_.truss->numbers_of(cut, solution_.pose.points).arm;
        const double force = solution_.truss->tension(at_index(cut.found), solution_.pose.points);
        const Symbol of = std::get<Symbol>(said.arguments[1]);
        tell(cut.statement, {Symbol::Letter::M, cut.pivot_name, {}}, {}, std::nullopt, in(moment, units_.moment), units_.moment);
        tell(cut.statement, of, {{in(force, units_.force) * in(arm, units_.length)}}, in(arm, units_.length),
             in(force, units_.force), units_.force);
    }
    /// Each by its part, then the sums: F = its magnitude, M = M_2 + M_3.
    void superposed(const Superposition& superposition) {
        for (const Superposition::Part& part : superposition.parts) {
            for (const FreeBody& body : part.bodies) added_up(body);
            for (const TakenTogether& together : part.together) added_up(together);
        }
        for (const Superposition::Sum& sum : superposition.sums)
            for (const int index : protocol_.polygons[at_index(sum.polygon)].vectors) {
                const DrawnVector& vector = protocol_.vectors[at_index(index)];
                if (vector.symbol == sum.symbol)
                    tell(superposition.statement, sum.symbol, {}, std::nullopt, in(protocol_.modulus_of(vector), units_.force),
                         units_.force);
            }
        for (const Superposition::CoupleSum& couple : superposition.couples) {
            Working working{
                couple.symbol, {}, std::nullopt, {in(couple.total->to_double(), units_.moment), units_.moment.symbol}};
            for (const Recorded<Exact>& part : couple.parts) working.summands.push_back(in(part->to_double(), units_.moment));
            message(superposition.statement).workings.push_back(std::move(working));
        }
    }

    /// ω = v/r, α = a^t/r of two points of the body.
    void turning_found(StatementIndex statement, const Quantity& quantity, Symbol::Letter letter) {
        const Message& said = message(statement);
        const bool omega = letter == Symbol::Letter::omega;
        const double value = spin(quantity.body, letter);
        const Symbol of{letter, solution_.mechanism.bodies[at_index(quantity.body)].name, ""};
        static const Unit per_second{"rad/s", 1}, per_second_squared{"rad/s²", 1};
        const Unit& unit = omega ? per_second : per_second_squared;
        if (said.sentence == Sentence::omega_by_fixed_guide || said.sentence == Sentence::alpha_by_fixed_guide) return;
        if (magnitudes_.is_noise(quantity, value)) return tell(statement, of, {}, std::nullopt, 0, unit);
        Factors factors;
        std::optional<double> divisor;
        if (said.sentence == Sentence::omega_from_pair || said.sentence == Sentence::alpha_from_pair)
            if (const auto lever = segment_length(std::get<Segment>(said.arguments[2]))) {
                const Unit& linear = omega ? units_.velocity : units_.acceleration;
                factors = {{in(value * *lever, linear)}};
                divisor = in(*lever, linear);
            }
        tell(statement, of, std::move(factors), divisor, value, unit);
    }
    /// Of places that the file names; a star tells apart whom a place belongs to, not where it is.
    std::optional<double> segment_length(const Segment& segment) const {
        const auto place = [&](std::string name) -> std::optional<Vector> {
            while (name.ends_with('*')) name.pop_back();
            const auto point = solution_.mechanism.point_named(name);
            return point ? std::optional(solution_.pose.at(*point)) : std::nullopt;
        };
        const auto from = place(segment.from), to = place(segment.to);
        return from && to ? std::optional(distance(*from, *to)) : std::nullopt;
    }

    /// `in_all`: under all loads.
    void force_found(StatementIndex statement, const FreeBody& body, const AppliedForce& applied, bool in_all) {
        if (body.in_parts) return;
        if (is_by_virtual_work(statement)) return;
        const Quantity quantity = quantity_of(body, applied);
        const double force = length(applied.force), couple = applied.couple.to_double();
        if (!applied.force.is_zero()) {
            const bool nothing = magnitudes_.is_noise(quantity, force);
            tell(statement, applied.symbol, {}, std::nullopt, nothing ? 0 : in(force, units_.force), units_.force);
            if (!nothing && in_all) moved_aside(statement, body, applied);
        } else if (couple != 0) {
            Symbol symbol = applied.symbol;
            symbol.letter = Symbol::Letter::M;
            tell(statement, symbol, force_times_arm(statement, body, couple), std::nullopt, in(couple, units_.moment),
                 units_.moment);
        }
    }
    /// M = F·b, where the sentence balances a couple of two forces; b in the length that makes up the unit of moments.
    Factors force_times_arm(StatementIndex statement, const FreeBody& body, double couple) const {
        for (const FreeBody::Arm& arm : body.arms) {
            if (arm.statement != statement || arm.is_shift) continue;
            const double b = distance(arm.about, arm.foot);
            if (!(b > 0)) continue;
            return {{in(couple / b, units_.force)}, {in(b * units_.force.si.to_double(), units_.moment)}};
        }
        return {};
    }

    /// Of a support that holds a couple, too: the couple at the pair, and how far aside the one force acts, d = M/F.
    void moved_aside(StatementIndex statement, const FreeBody& body, const AppliedForce& applied) {
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
        tell(statement, std::move(of), {}, std::nullopt, in(couple, units_.moment), units_.moment);
        const double arm = std::abs(couple) / force;
        tell(statement, {Symbol::Letter::length, "d", {}}, {{in(arm, units_.length) * in(force, units_.force)}},
             in(force, units_.force), in(arm, units_.length), units_.length);
    }

    bool is_by_virtual_work(StatementIndex statement) {
        const Sentence said = message(statement).sentence;
        return said == Sentence::moments_alone || said == Sentence::components_alone || said == Sentence::virtual_work_alone;
    }
    /// F = ΣM/b, where it alone has a moment about the centre.
    void by_moments(const VirtualMotion& motion) {
        const double force = length(*motion.force);
        std::optional<double> arm;
        if (message(motion.statement).sentence == Sentence::moments_alone)
            for (const FreeBody& body : solution_.free_bodies)
                for (const FreeBody::Arm& each : body.arms)
                    if (each.statement == motion.statement && each.is_sought) arm = distance(each.about, each.foot);
        Factors factors;
        if (arm) factors = {{in(force * *arm, units_.force)}};
        tell(motion.statement, motion.sought, std::move(factors), arm, in(force, units_.force), units_.force);
    }
    /// What a virtual motion gives, and the ratios of its angular velocities.
    void by_virtual_work(const VirtualMotion& motion) {
        Message& said = message(motion.statement);
        if (motion.couple)
            tell(motion.statement, motion.sought, {}, std::nullopt, in(motion.couple->to_double(), units_.moment), units_.moment);
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
                ratios.push_back(
                    {omega(turning.body), omega(first->body), turning.omega->to_double() / first->omega->to_double()});
        }
        if (!ratios.empty()) said.arguments.emplace_back(std::move(ratios));
    }

    /// F_i = −m a_G, M_i = −J α.
    void inertia(StatementIndex statement) {
        const Symbol of = std::get<Symbol>(message(statement).arguments[1]);
        for (const FreeBody& body : solution_.free_bodies)
            for (const AppliedForce& applied : body.forces) {
                if (applied.kind != AppliedForce::Kind::inertia ||
                    body.body != protocol_.statements[at_index(statement)].bodies[0])
                    continue;
                const Mass& mass = solution_.mechanism.masses[at_index(applied.given)];
                const double m = mass.mass.to_double(), force = length(applied.force), couple = applied.couple.to_double();
                if (of.letter == Symbol::Letter::F && force > 0)
                    tell(statement, of, {{m}, {force / m}}, std::nullopt, in(force, units_.force), units_.force);
                const double alpha = spin(body.body, Symbol::Letter::alpha);
                if (of.letter == Symbol::Letter::M && couple != 0)
                    tell(statement, of, {{-mass.inertia.to_double()}, {alpha}}, std::nullopt, in(couple, units_.moment),
                         units_.moment);
            }
    }

    /// A force by its magnitude, a couple with its sign.
    void left_over(const Resultant& resultant) {
        if (resultant.vanishes) return;
        const Symbol of = std::get<Symbol>(message(resultant.statement).arguments[1]);
        if (of.letter == Symbol::Letter::F)
            tell(resultant.statement, of, {}, std::nullopt, in(length(*resultant.force), units_.force), units_.force);
        const std::vector<Argument>& said = message(resultant.statement).arguments;
        if (resultant.residual_force)
            tell(resultant.statement, std::get<Symbol>(said[2]), {}, std::nullopt,
                 in(length(*resultant.residual_force), units_.force), units_.force);
        if (resultant.residual_couple) {
            Factors factors;
            const double moment = in(resultant.residual_couple->to_double(), units_.moment);
            for (const FreeBody& body : solution_.free_bodies)
                for (const FreeBody::Arm& arm : body.arms)
                    if (arm.statement == resultant.statement)
                        factors = {{std::copysign(in(length(*resultant.force), units_.moment), moment)},
                                   {distance(arm.about, arm.foot)}};
            tell(resultant.statement, std::get<Symbol>(said[3]), std::move(factors), std::nullopt, moment, units_.moment);
        }
        if (of.letter != Symbol::Letter::F)
            tell(resultant.statement, of, {}, std::nullopt, in(resultant.couple->to_double(), units_.moment), units_.moment);
    }
    /// F = k · (l − l_0), M = −k · φ.
    void stretched(StatementIndex statement) {
        const Sentence sentence = message(statement).sentence;
        if (sentence != Sentence::elastic_spring && sentence != Sentence::torsion_spring) return;
        const Symbol of = std::get<Symbol>(message(statement).arguments[0]);
        for (const Load& load : solution_.mechanism.loads) {
            if (const auto* torsion = std::get_if<TorsionLoad>(&load); torsion != nullptr && torsion->name == of.about) {
                const double stiffness = torsion->stiffness.to_double(), turned = torsion->turned.to_double();
                tell(statement, of, {{in(-stiffness, units_.moment)}, {turned}}, std::nullopt,
                     in(-stiffness * turned, units_.moment), units_.moment);
            }
            const auto* spring = std::get_if<SpringLoad>(&load);
            if (spring == nullptr || !spring->elastic || spring->name != of.about) continue;
            const double stretch = distance(solution_.pose.at(spring->between[0]), solution_.pose.at(spring->between[1])) -
                                   spring->elastic->free_length.to_double();
            const double force = spring->elastic->stiffness.to_double() * stretch;
            tell(statement, of, {{in(spring->elastic->stiffness.to_double(), units_.force)}, {stretch}}, std::nullopt,
                 in(force, units_.force), units_.force);
        }
    }

    /// ω_4 = ω_2 · P_12 P_24 / P_14 P_24.
    void carried_over(const SecondWay& way) {
        for (const StatementIndex statement : indices_of(protocol_.statements)) {
            const Message& said = message(statement);
            if (said.sentence != Sentence::second_way || !way.omega) continue;
            const Symbol of = std::get<Symbol>(said.arguments[0]);
            if (of.about != solution_.mechanism.bodies[at_index(way.body)].name) continue;
            const BodyIndex driver = *solution_.mechanism.body_named(std::get<Symbol>(said.arguments[4]).about);
            const auto from = centre_of(frame, driver), own = centre_of(frame, way.body), common = centre_of(driver, way.body);
            if (!from || !own || !common) return;
            const double value = way.omega->to_double(), far = in(distance(*own, *common), units_.length);
            double near = in(distance(*from, *common), units_.length);
            if (dot(*common - *from, *common - *own) < Exact(0)) near = -near;  // between the pivots: the senses differ
            tell(statement, of, {{spin(driver, Symbol::Letter::omega)}, {near}}, far, value, {"rad/s", 1});
            return;
        }
    }
    /// δ is read off; ρ_C = PC²/CW (Euler–Savary).
    void of_curvature(const Curvature& curvature) {
        if (!curvature.inflection_pole) return;
        const Unit& unit = units_.length;
        const Vector pole = curvature.pole->place();
        tell(curvature.inflection_statement,
             {Symbol::Letter::diameter, solution_.mechanism.bodies[at_index(curvature.body)].name, ""}, {}, std::nullopt,
             in(distance(pole, *curvature.inflection_pole), unit), unit);
        for (const PathCentre& path : curvature.points) {
            if (path.is_pin || !path.centre || path.centre->at_infinity()) continue;
            const Vector& at = solution_.pose.at(path.point);
            tell(path.statement, {Symbol::Letter::radius, path.label, ""}, {{in(distance(pole, at), unit), true}},
                 in(distance(at, path.foot->place()), unit), in(distance(at, path.centre->place()), unit), unit);
        }
    }
    std::optional<Vector> centre_of(BodyIndex first, BodyIndex second) const {
        for (const InstantCentre& centre : solution_.centres)
            if (centre.first == std::min(first, second) && centre.second == std::max(first, second) && centre.at &&
                !centre.at->at_infinity())
                return centre.at->place();
        return std::nullopt;
    }

    Solution& solution_;
    Protocol& protocol_;
    const Units& units_;
    Magnitudes magnitudes_;
};

}  // namespace

void add_workings(Solution& solution) { Workings(solution).add(); }

}  // namespace kinegraph
