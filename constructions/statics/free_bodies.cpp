#include "constructions/statics/free_bodies.hpp"

#include <cmath>
#include <set>

#include "constructions/statics/free_bodies/cut_bodies.hpp"
#include "constructions/statics/free_bodies/found_values.hpp"
#include "constructions/statics/free_bodies/superposing.hpp"
#include "constructions/statics/free_bodies/unsupported_resultants.hpp"
#include "engine/number/geometry.hpp"

namespace kinegraph::statics {

void note_first_use_of_lines(std::vector<FreeBody>& bodies, const Pose& pose) {
    // With rounded data a line passes through a place if the distance is within their precision, slightly amplified.
    constexpr double amplified = 64;
    const auto passes = [&](const AppliedForce& applied, const Vector& place) {
        if (applied.force.is_zero()) return true;
        const ProjectiveLine line = finite_line_through(point_at(applied.at), applied.force);
        return incident(point_at(place), line) ||
               (pose.is_rounded() && distance(place, line) <= amplified * pose.precision.to_double());
    };
    for (FreeBody& body : bodies) {
        for (AppliedForce& applied : body.forces) {
            if (applied.is_reaction() || applied.is_resultant()) continue;
            for (const FreeBody::Meet& meet : body.meets) {
                if (!passes(applied, meet.place)) continue;
                if (applied.line_statement == none || meet.statement < applied.line_statement)
                    applied.line_statement = meet.statement;
            }
        }
    }
}

ForceResults cut_free(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                      const Run& run, const NamedMeets& meets, const std::vector<Unsupported>& loose, bool one_by_one) {
    ForceResults results;
    const UnderLoads under{&model.loads()};
    ForcePolygons polygons(model, board);
    IntermediateConstructions constructions(model, board, mechanism, meets, under);
    UnsupportedResultants resultants(model, board, mechanism, polygons, constructions, results);
    for (const Unsupported& each : loose) resultants.resultant(each);
    const std::set<MemberIndex>& unbalanced = resultants.unbalanced();
    ForceDeterminacy determinacy(model, board, mechanism, mobility, under);
    std::set<MemberIndex> open = determinacy.out_of_equilibrium(run);
    for (const MemberIndex member : unbalanced) open.erase(member);
    const bool balanced = open.empty(), complete = determinacy.is_complete(run, unbalanced);
    if (!complete || !balanced) determinacy.explain(run, balanced, results);
    FoundValues values(model, board, mechanism, constructions, results);
    open.insert(unbalanced.begin(), unbalanced.end());
    for (std::size_t b = 0; b < model.bonds().size(); ++b) {
        const Bond& bond = model.bonds()[b];
        values.collect_bond(bond, run.reactions[b], open.count(bond.first) == 0 && open.count(bond.second) == 0);
    }
    if ((!complete && run.redundant.empty()) || !balanced) return results;
    CutBodies bodies(model, board, polygons, constructions, under, one_by_one, results);
    if (one_by_one) bodies.draw_bodies(run, unbalanced);
    for (const VirtualMotion& drawn : run.virtual_motions) values.virtual_motion(drawn);
    if (complete && one_by_one) polygons.join_polygons();
    bodies.cut_together(run);
    if (complete && one_by_one && !run.parts.empty())
        results.superposition = Superposing(model, board, mechanism, mobility, meets).superpose(run);
    determinacy.remark_teeth(run, results);
    determinacy.remark_lift_off(run, results);
    return results;
}

}  // namespace kinegraph::statics
