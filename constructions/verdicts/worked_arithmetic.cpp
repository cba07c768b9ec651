// Adds the worked arithmetic of each statement, in order of appearance: motion, then the final result of a statement,
// then sums of forces.
#include "constructions/verdicts/verdicts.hpp"

#include <algorithm>

#include "constructions/verdicts/worked_arithmetic/of_forces.hpp"
#include "constructions/verdicts/worked_arithmetic/of_motion.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

class Workings {
public:
    explicit Workings(Solution& solution)
        : solution_(solution), protocol_(solution.protocol), telling_(solution), motion_(telling_), forces_(telling_) {}

    void add() {
        for (Statement& statement : protocol_.statements) leave_out_what_vanishes(statement.message);
        name_polygons();
        motion_.add_slidings();
        for (const DrawnVector& vector : protocol_.vectors)
            if (vector.statement != none && protocol_.polygons[at_index(vector.polygon)].plane != Plane::force)
                motion_.drawn(vector);
        for (const StatementIndex each : indices_of(protocol_.statements)) found(each);
        for (const SecondWay& way : solution_.second_way) motion_.carried_over(way);
        for (const Curvature& curvature : solution_.curvature) motion_.of_curvature(curvature);
        add_sums_of_forces();
    }

private:
    // --- terms that sentences omit

    bool turns(const Argument& argument) const {
        const Symbol& symbol = std::get<Symbol>(argument);
        const auto body = solution_.mechanism.body_named(symbol.about);
        if (!body) return true;
        return !telling_.magnitudes().is_noise(turning_of(*body, symbol.letter), telling_.spin(*body, symbol.letter));
    }
    /// Removes ω² if nothing turns, and α if the rotation is uniform.
    void leave_out_what_vanishes(Message& message) const {
        auto& arguments = message.arguments;
        if (message.sentence == lang::sentences::crank_acceleration && !turns(arguments[5])) arguments.pop_back();
        if (message.sentence != lang::sentences::image_acceleration) return;
        const bool omega = turns(arguments[4]), alpha = turns(arguments[5]);
        if (!omega && !alpha)
            message = {lang::sentences::translating_acceleration, {arguments[1], arguments[0], arguments[2]}};
        else if (!omega)
            message = {lang::sentences::image_acceleration_without_omega,
                       {arguments[0], arguments[1], arguments[2], arguments[3], arguments[5]}};
        else if (!alpha)
            arguments.pop_back();
    }

    /// A polygon of three forces is called a triangle.
    void name_polygons() {
        for (Statement& statement : protocol_.statements) {
            Key& sentence = statement.message.sentence;
            if (sentence != lang::sentences::triangle && sentence != lang::sentences::triangle_at) continue;
            const auto index = StatementIndex(static_cast<int>(&statement - protocol_.statements.data()));
            if (forces_on(statement.bodies, bodies_at(index)) > 3)
                sentence =
                    sentence == lang::sentences::triangle ? lang::sentences::polygon : lang::sentences::polygon_at;
        }
    }
    /// The bodies for a sentence: under all loads, or under those that it is about.
    const std::vector<FreeBody>& bodies_at(StatementIndex statement) const {
        if (solution_.superposition)
            for (const Superposition::Part& part : solution_.superposition->parts)
                if (!(statement < part.first) && statement < part.end) return part.bodies;
        return solution_.free_bodies;
    }
    /// Number of external forces on bodies taken together.
    static int forces_on(const std::vector<BodyIndex>& bodies, const std::vector<FreeBody>& cut_free) {
        const auto among = [&](BodyIndex body) {
            return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
        };
        int count = 0;
        for (const FreeBody& body : cut_free) {
            if (!among(body.body)) continue;
            for (const AppliedForce& applied : body.forces)
                if (!applied.force.is_zero() && !(applied.from != none && among(applied.from))) ++count;
        }
        return count;
    }

    // --- final result of a statement

    void found(StatementIndex statement) {
        const Key sentence = telling_.message(statement).sentence;
        if (sentence == lang::sentences::inertia_force || sentence == lang::sentences::inertia_couple)
            return forces_.inertia(statement);
        for (const Quantity& quantity : protocol_.statements[at_index(statement)].finds) {
            const ResultKind& kind = result_kind(quantity);
            if (kind.turns()) motion_.turning_found(statement, quantity, kind.letter);
        }
        const std::vector<FreeBody>& bodies = bodies_at(statement);
        if (&bodies == &solution_.free_bodies)
            for (const Quantity& quantity : protocol_.statements[at_index(statement)].finds)
                if (quantity.kind == Quantity::Kind::effort) forces_.nothing_to_balance(statement, quantity.given);
        for (const FreeBody& body : bodies)
            for (const AppliedForce& applied : body.forces)
                if (applied.force_statement == statement)
                    forces_.force_found(statement, body, applied, &bodies == &solution_.free_bodies);
    }
    /// Sums over all forces, and results from them.
    void add_sums_of_forces() {
        for (const Resultant& resultant : solution_.resultants) forces_.left_over(resultant);
        if (solution_.truss)
            for (const Truss::Cut& cut : solution_.truss->cuts) forces_.by_ritter(cut);
        for (const FreeBody& body : solution_.free_bodies) forces_.added_up(body);
        for (const TakenTogether& together : solution_.taken_together) forces_.added_up(together);
        if (solution_.superposition) forces_.superposed(*solution_.superposition);
        for (const StatementIndex each : indices_of(protocol_.statements)) {
            forces_.stretched(each);
            forces_.distributed(each);
        }
        for (const VirtualMotion& motion : solution_.virtual_motions) forces_.by_virtual_work(motion);
    }

    Solution& solution_;
    Protocol& protocol_;
    worked_arithmetic::Telling telling_;
    worked_arithmetic::OfMotion motion_;
    worked_arithmetic::OfForces forces_;
};

}  // namespace

void add_worked_arithmetic(Solution& solution) { Workings(solution).add(); }

}  // namespace kinegraph
