// All elements that the results of a solution refer to, with their values. Used to renumber elements and to read values
// again. A result that refers to an element must be in one of these lists.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace found_elements {

/// An element stored beside its value.
template <class Value, class See>
void visit_pair(ElementIndex& element, Value& value, See& see) {
    if (element != none) see(element, value);
}

template <class See>
void visit(RelativeMotion& m, See& see) {
    for (auto* found : {&m.velocity, &m.transport_velocity, &m.relative_velocity, &m.acceleration,
                        &m.transport_acceleration, &m.relative_acceleration, &m.coriolis})
        found->visit(see);
}
template <class See>
void visit_parts(RelativeMotion& m, See& see) {
    if (!m.apart) return;
    for (auto* found : {&m.apart->omega, &m.apart->alpha}) found->visit(see);
    for (auto* found : {&m.apart->origin_velocity, &m.apart->turning_velocity, &m.apart->origin_acceleration,
                        &m.apart->tangential, &m.apart->normal, &m.apart->velocity_along, &m.apart->velocity_across,
                        &m.apart->acceleration_along, &m.apart->acceleration_across})
        found->visit(see);
}
template <class See>
void visit_motion(SolvedMotion& solved, See& see) {
    for (PointMotion& point : solved.points)
        for (auto* found : {&point.velocity, &point.acceleration}) found->visit(see);
    for (BodyMotion& body : solved.bodies)
        for (auto* found : {&body.omega, &body.alpha}) found->visit(see);
    for (Sliding& sliding : solved.sliding)
        for (auto* found : {&sliding.velocity, &sliding.acceleration, &sliding.coriolis}) found->visit(see);
    for (InstantCentre& centre : solved.centres) centre.at.visit(see);
    for (RelativeMotion& motion : solved.relative_motion) visit(motion, see);
    for (RelativeMotion& motion : solved.relative_motion) visit_parts(motion, see);
    for (SecondWay& way : solved.second_way) way.omega.visit(see);
}

template <class See>
void visit(FreeBody::Funicular& funicular, See& see) {
    for (auto* places : {&funicular.corners, &funicular.vertices})
        for (Recorded<Vector>& place : *places) place.visit(see);
    for (auto* place : {&funicular.pole, &funicular.dividing, &funicular.resultant}) place->visit(see);
}
template <class See>
void visit(FreeBody& body, See& see) {
    for (auto* forces : {&body.forces, &body.sums})
        for (AppliedForce& applied : *forces) {
            visit_pair(applied.elements.force, applied.force, see);
            visit_pair(applied.elements.couple, applied.couple, see);
            visit_pair(applied.elements.at, applied.at, see);
        }
    for (FreeBody::Meet& meet : body.meets) visit_pair(meet.element, meet.place, see);
    for (FreeBody::Arm& arm : body.arms) {
        visit_pair(arm.elements.about, arm.about, see);
        visit_pair(arm.elements.foot, arm.foot, see);
    }
    if (body.funicular) visit(*body.funicular, see);
}
template <class See>
void visit(TakenTogether& together, See& see) {
    for (AppliedForce& applied : together.sums) {
        visit_pair(applied.elements.force, applied.force, see);
        visit_pair(applied.elements.at, applied.at, see);
    }
    if (together.funicular) visit(*together.funicular, see);
}
template <class See>
void visit(Superposition& superposition, See& see) {
    for (Superposition::Part& part : superposition.parts) {
        for (FreeBody& body : part.bodies) visit(body, see);
        for (TakenTogether& together : part.together) visit(together, see);
    }
    for (Superposition::CoupleSum& couple : superposition.couples) {
        for (Recorded<Exact>& part : couple.parts) part.visit(see);
        couple.total.visit(see);
    }
}
template <class See>
void visit(Truss& truss, See& see) {
    for (Truss::Bar& bar : truss.bars) bar.force.visit(see);
    for (Truss::External& external : truss.externals) external.force.visit(see);
    for (Truss::Cut& made : truss.cuts) {
        made.pivot.visit(see);
        made.moment.visit(see);
    }
    if (auto& whole = truss.whole) {
        whole->force.visit(see);
        whole->through.visit(see);
        for (Truss::Whole::Meet& meet : whole->meets) meet.place.visit(see);
    }
}
template <class See>
void visit(Resultant& resultant, See& see) {
    resultant.force.visit(see);
    resultant.couple.visit(see);
    resultant.through.visit(see);
    resultant.about.visit(see);
    resultant.residual_force.visit(see);
    resultant.residual_couple.visit(see);
}
template <class See>
void visit(VirtualMotion& motion, See& see) {
    motion.force.visit(see);
    motion.couple.visit(see);
    for (VirtualMotion::Turning& turning : motion.bodies) turning.omega.visit(see);
}
template <class See>
void visit(VirtualWork& work, See& see) {
    for (VirtualWork::Entry& entry : work.entries) {
        visit_pair(entry.elements.at, entry.at, see);
        visit_pair(entry.elements.velocity, entry.velocity, see);
        visit_pair(entry.elements.force, entry.force, see);
        visit_pair(entry.elements.couple, entry.couple, see);
        visit_pair(entry.elements.omega, entry.omega, see);
        visit_pair(entry.elements.power, entry.power, see);
    }
    for (VirtualWork::Power& each : work.powers) each.power.visit(see);
    for (VirtualWork::Share& share : work.shares) {
        share.velocity.visit(see);
        for (auto* found : {&share.omega, &share.power}) found->visit(see);
    }
    visit_pair(work.total_element, work.total, see);
}
template <class See>
void visit_forces(SolvedForces& solved, See& see) {
    for (JointForce& force : solved.forces) {
        force.force.visit(see);
        force.couple.visit(see);
        force.component.visit(see);
        force.along.visit(see);
    }
    for (EffortValue& effort : solved.efforts) effort.value.visit(see);
    for (FreeBody& body : solved.free_bodies) visit(body, see);
    for (TakenTogether& together : solved.taken_together) visit(together, see);
    if (solved.superposition) visit(*solved.superposition, see);
    if (solved.truss) visit(*solved.truss, see);
    for (Resultant& resultant : solved.resultants) visit(resultant, see);
    for (VirtualMotion& motion : solved.virtual_motions) visit(motion, see);
    if (solved.virtual_work) visit(*solved.virtual_work, see);
}

template <class See>
void visit(Curvature& curvature, See& see) {
    for (Curvature::Ray& ray : curvature.rays) {
        ray.at.visit(see);
        ray.centre.visit(see);
    }
    curvature.axis_point.visit(see);
    curvature.pole.visit(see);
    for (auto* found : {&curvature.tangent, &curvature.inflection_pole, &curvature.inflection_centre,
                        &curvature.tangential_pole, &curvature.acceleration_pole})
        found->visit(see);
    for (PathCentre& path : curvature.points) {
        path.centre.visit(see);
        path.foot.visit(see);
    }
    for (EnvelopeCentre& envelope : curvature.envelopes) {
        envelope.touches.visit(see);
        envelope.centre.visit(see);
    }
}
template <class See>
void visit(InstantaneousMotionFigure& motion, See& see) {
    motion.acceleration_centre.visit(see);
    if (auto& differing = motion.differing)
        for (auto* found : {&differing->of_first, &differing->of_second, &differing->join}) found->visit(see);
}

}  // namespace found_elements

/// Calls `see(ElementIndex& element, auto& value)` for each, always in the same order; the values are Vector, Exact or
/// ProjectivePoint.
template <class See>
void for_each_found(Solution& solution, See see) {
    found_elements::visit_motion(solution, see);
    found_elements::visit_forces(solution, see);
    for (Curvature& curvature : solution.curvature) found_elements::visit(curvature, see);
    if (solution.instantaneous_motion) found_elements::visit(*solution.instantaneous_motion, see);
}

}  // namespace kinegraph
