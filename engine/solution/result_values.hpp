// The results of a solution, one after the other: the only enumeration of what a solution has found. Their names, units
// and signs are in the catalogue (engine/sentences/result_catalogue.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "engine/mechanism/couplers.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// The power of a force or a couple.
inline Quantity power_of(const Quantity& action) {
    using ActionKind = Quantity::Kind;
    return {.kind = action.kind == ActionKind::load      ? ActionKind::power_of_load
                    : action.kind == ActionKind::weight  ? ActionKind::power_of_weight
                    : action.kind == ActionKind::inertia ? ActionKind::power_of_inertia
                                                         : ActionKind::power_of_effort,
            .given = action.given};
}
/// Whether forces were found and all powers vanish, since nothing moves.
inline bool has_no_power(const Solution& solution) {
    const auto is_found = [](const EffortValue& each) { return each.value.has_value(); };
    const auto rests = [](const auto& rate) { return rate && *rate == std::decay_t<decltype(*rate)>(); };
    return !solution.free_bodies.empty() && !solution.mechanism.drivers.empty() &&
           std::all_of(solution.efforts.begin(), solution.efforts.end(), is_found) &&
           std::all_of(solution.bodies.begin() + 1, solution.bodies.end(),
                       [&](const BodyMotion& each) { return rests(each.omega); }) &&
           std::all_of(solution.points.begin(), solution.points.end(), [&](const PointMotion& each) {
               return std::find(each.bodies.begin(), each.bodies.end(), frame) != each.bodies.end() ||
                      rests(each.velocity);
           });
}
/// The powers of loads, weights, inertia forces and efforts in the motion found, for `show(Quantity, Recorded<Exact>)`.
template <class Show>
void for_each_power(const Solution& solution, Show show) {
    if (!solution.virtual_work && !has_no_power(solution)) return;
    using ActionKind = Quantity::Kind;
    const Mechanism& mechanism = solution.mechanism;
    const auto show_all = [&](ActionKind kind, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const Quantity action{.kind = kind, .given = static_cast<int>(i)};
            // What has no entry vanishes.
            Recorded<Exact> power = Recorded<Exact>::zero();
            if (solution.virtual_work)
                for (const VirtualWork::Power& each : solution.virtual_work->powers)
                    if (each.quantity == action) power = each.power;
            show(power_of(action), power);
        }
    };
    show_all(ActionKind::load, mechanism.loads.size());
    if (mechanism.gravity) show_all(ActionKind::weight, mechanism.masses.size());
    if (mechanism.inertia_forces) show_all(ActionKind::inertia, mechanism.masses.size());
    show_all(ActionKind::effort, mechanism.efforts.size());
}

/// The distance of two places: a result that no stroke holds.
struct Distance {
    Vector from, to;
    ElementIndex element_from, element_to;  ///< of the record; `from` none: a point of the file

    double to_double() const { return length(to - from); }
};
/// The radius of curvature of a path, and the diameter of the inflection circle.
inline Recorded<Distance> radius_of(const PathCentre& path, const Pose& pose) {
    if (!path.centre || path.centre->at_infinity()) return {};
    return Distance{pose.at(path.point), path.centre->place(), none, path.centre.element()};
}
inline Recorded<Distance> diameter_of(const Curvature& found) {
    if (!found.inflection_centre) return {};
    const Vector pole = found.pole->place();
    if (!found.inflection_pole) return Distance{pole, pole, found.pole.element(), found.pole.element()};
    return Distance{pole, *found.inflection_pole, found.pole.element(), found.inflection_pole.element()};
}
inline Quantity angle_of(const Coupler& coupler) {
    return {.kind = Quantity::Kind::transmission_angle,
            .body = coupler.follower,
            .other = coupler.body,
            .joint = coupler.pin};
}
/// Radii of paths, diameters of inflection circles, poles of accelerations.
template <class Show>
void for_each_curvature(const Solution& solution, Show show) {
    for (const Curvature& found : solution.curvature) {
        for (const PathCentre& path : found.points)
            show({.kind = Quantity::Kind::radius, .body = found.body, .point = path.point},
                 radius_of(path, solution.pose));
        show({.kind = Quantity::Kind::inflection_diameter, .body = found.body}, diameter_of(found));
        show({.kind = Quantity::Kind::acceleration_pole, .body = found.body}, found.acceleration_pole);
    }
}
/// Efforts, also by virtual displacements.
template <class Show>
void for_each_effort(const Solution& solution, Show show) {
    const auto effort = [](Quantity::Kind kind, std::size_t given) -> Quantity {
        return {.kind = kind, .given = static_cast<int>(given)};
    };
    for (std::size_t e = 0; e < solution.efforts.size(); ++e)
        show(effort(Quantity::Kind::effort, e), solution.efforts[e].value, solution);
    for (std::size_t e = 0; solution.displacements && e < solution.mechanism.efforts.size(); ++e)
        show(effort(Quantity::Kind::virtual_effort, e), solution.displacements->found(e), solution);
}

/// Components of forces that are open otherwise, and what is given on unsupported bodies.
template <class Show>
void for_each_force_in_part(const Solution& solution, Show show) {
    for (const JointForce& action : solution.forces) {
        Quantity quantity = quantity_of(action);
        quantity.kind = Quantity::Kind::force_component;
        if (action.component) show(quantity, Recorded<Exact>(Exact::from_double(component_of(action))), action);
    }
    for (const Resultant& found : solution.resultants) {
        show({.kind = Quantity::Kind::resultant, .body = found.bodies.front()}, found.force, found);
        show({.kind = Quantity::Kind::resultant_couple, .body = found.bodies.front()}, found.couple, found);
    }
}
/// Forces in the bars of a truss, and the equations of its cuts.
template <class Show>
void for_each_bar(const Solution& solution, Show show) {
    if (!solution.truss) return;
    const Truss& truss = *solution.truss;
    const std::vector<TrussStructure::Bar>& bars = truss.structure.bars;
    const auto number = [](double value) { return Recorded<Exact>(Exact::from_double(value)); };
    for (std::size_t b = 0; b < truss.bars.size(); ++b)
        if (truss.bars[b].force)
            show({.kind = Quantity::Kind::bar, .body = bars[b].body}, number(truss.tension(b, solution.pose.points)),
                 solution);
    for (std::size_t c = 0; c < truss.cuts.size(); ++c) {
        const Truss::Cut& cut = truss.cuts[c];
        const Truss::CutNumbers numbers = truss.numbers_of(cut, solution.pose.points);
        const auto of_cut = [&](Quantity::Kind kind) -> Quantity {
            return {.kind = kind, .body = bars[at_index(cut.found)].body, .given = static_cast<int>(c)};
        };
        using enum Quantity::Kind;
        show(of_cut(cut.pivot ? cut_moment : cut_across), number(numbers.known), cut);
        show(of_cut(cut.pivot ? cut_arm : cut_sine), number(numbers.arm), cut);
    }
}

/// The relative and the transport motion of the points that are observed. `other` is the observer; where it translates
/// with a point, `seen_from` is that point.
template <class Show>
void for_each_relative_motion(const Solution& solution, Show show) {
    using Part = Quantity::Part;
    for (const RelativeMotion& motion : solution.relative_motion) {
        const RelativeMotionQuery& query = motion.query;
        const bool translates = query.translating_with != none;
        const auto part = [&](Quantity::Kind kind, Part which) -> Quantity {
            return {.kind = kind,
                    .other = translates ? none : query.observer,
                    .point = query.point,
                    .part = which,
                    .seen_from = query.translating_with};
        };
        show(part(Quantity::Kind::velocity, Part::relative), motion.relative_velocity, motion);
        show(part(Quantity::Kind::acceleration, Part::relative), motion.relative_acceleration, motion);
        show(part(Quantity::Kind::velocity, Part::transport), motion.transport_velocity, motion);
        show(part(Quantity::Kind::acceleration, Part::transport), motion.transport_acceleration, motion);
        show(part(Quantity::Kind::acceleration, Part::coriolis), motion.coriolis, motion);
    }
}

/// Calls `show(const Quantity&, const Recorded<T>&, const Of&)` for each result that is sought, known or not, T being
/// Exact or Distance for a scalar, Vector for a vector, ProjectivePoint for a place that may be at infinity: bodies in
/// the file's order, points that are not of the frame, slidings, actions at joints, efforts, centres, powers, forces in
/// bars and cuts, curvature, components and resultants of forces, transmission angles, relative motions. What says more
/// than the value comes with it: its JointForce, InstantCentre, Truss::Cut, Resultant or RelativeMotion, else the
/// solution.
template <class Show>
void for_each_sought(const Solution& solution, Show show) {
    const auto show_alone = [&](const Quantity& quantity, const auto& found) { show(quantity, found, solution); };
    for (std::size_t b = 1; b < solution.bodies.size(); ++b) {
        show_alone(omega_of(BodyIndex(b)), solution.bodies[b].omega);
        show_alone(alpha_of(BodyIndex(b)), solution.bodies[b].alpha);
    }
    for (const PointMotion& point : solution.points) {
        if (std::find(point.bodies.begin(), point.bodies.end(), frame) != point.bodies.end()) continue;
        show_alone(velocity_of(point), point.velocity);
        show_alone(acceleration_of(point), point.acceleration);
    }
    for (const Sliding& sliding : solution.sliding) {
        show_alone({.kind = Quantity::Kind::sliding_velocity, .joint = sliding.joint}, sliding.velocity);
        show_alone({.kind = Quantity::Kind::sliding_acceleration, .joint = sliding.joint}, sliding.acceleration);
        show_alone({.kind = Quantity::Kind::sliding_coriolis, .joint = sliding.joint}, sliding.coriolis);
    }
    for (const JointForce& action : solution.forces) {
        Quantity quantity = quantity_of(action);
        show(quantity, action.force, action);
        quantity.kind = Quantity::Kind::couple;
        if (solution.mechanism.joint(action.joint).pair().transmits_couple()) show(quantity, action.couple, action);
    }
    for_each_effort(solution, show);
    for (const InstantCentre& centre : solution.centres) show(quantity_of(centre), centre.at, centre);
    for_each_power(solution, show_alone);
    for_each_bar(solution, show);
    for_each_curvature(solution, show_alone);
    for_each_force_in_part(solution, show);
    for (const auto& [name, coupler] : named_couplers(solution.mechanism, 0))
        show_alone(angle_of(coupler), Recorded<Exact>(Exact::from_double(transmission_angle(coupler, solution.pose))));
    for_each_relative_motion(solution, show);
}
/// Of these the results that are known and have a name of their own: parts of a relative motion have none.
template <class See>
void for_each_result(const Solution& solution, See see) {
    for_each_sought(solution, [&](const Quantity& quantity, const auto& found, const auto& /*of*/) {
        if (found && quantity.part == Quantity::Part::whole) see(quantity, found);
    });
}

}  // namespace kinegraph
