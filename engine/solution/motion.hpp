// What was found of the motion: velocities, accelerations, instant centres, relative motion. Values in SI units, each
// with the element of the record that holds it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/number/geometry.hpp"
#include "engine/number/recorded.hpp"
#include "engine/sentences/quantity.hpp"

namespace kinegraph {

/// A point as carried by one body, or by several that a pin holds together there.
struct PointMotion {
    PointIndex point = none;
    std::vector<BodyIndex> bodies;
    std::string label;  ///< "A"; "A*" where other bodies carry the same place without a pin
    Recorded<Vector> velocity, acceleration;
};
struct BodyMotion {
    Recorded<Exact> omega, alpha;
};
/// The motion of i relative to j at a sliding joint or a contact.
struct Sliding {
    JointIndex joint = none;
    Recorded<Vector> velocity, acceleration, coriolis;
};
/// The equivalent linkage of a contact of round or straight profiles, valid up to accelerations: a link between the
/// centres of curvature, or the one centre as a pin in a straight slot parallel to the other's line (a tip is its own
/// centre).
struct EquivalentLinkage {
    enum class Kind { link, slot } kind = Kind::link;
    JointIndex joint = none;
    std::array<BodyIndex, 2> bodies{none, none};   ///< slot: the pin's body, then the slot's
    std::array<PointIndex, 2> places{none, none};  ///< link: its ends on these bodies; slot: the pin, twice
};
/// An instant centre P_ij.
struct InstantCentre {
    BodyIndex first = frame, second = frame;  ///< frame first, then in the file's order
    enum class How { unknown, primary, kennedy, velocities, accelerations, rest } how = How::unknown;
    Recorded<ProjectivePoint> at;     ///< finite or at infinity
    bool everywhere = false;          ///< the bodies have no relative motion
    bool as_one = false;              ///< … in any position: their joints make them one rigid body
    bool depends_on_drivers = false;  ///< several freedoms: valid for this ratio of the drivers
    std::vector<std::pair<int, int>>
        through;  ///< the lines used: pairs of indices into Solution::centres (P_ik, P_kj); empty for primary ones
    std::vector<PointIndex> normals;  ///< … or normals at these points
    int order = 0;                    ///< position in the order found
    StatementIndex statement = none;
};
/// The motion of a point seen by an observer.
struct RelativeMotion {
    RelativeMotionQuery query;
    Recorded<Vector> velocity, transport_velocity, relative_velocity;
    Recorded<Vector> acceleration, transport_acceleration, relative_acceleration, coriolis;
    /// The transport terms split at the origin O′ of the moving axes, a place of the observer's body: a_tr = a_O′ + α ∧
    /// O′P − ω² O′P.
    struct Apart {
        PointIndex origin = none, towards = none;  ///< the axis x′ points from the origin to the other point; without
                                                   ///< one: along x
        Recorded<Exact> omega, alpha;
        Recorded<Vector> origin_velocity, turning_velocity;  ///< v_tr = v_O′ + ω ∧ O′P
        Recorded<Vector> origin_acceleration, tangential, normal;
        /// The relative velocity and acceleration, split along x′ and y′.
        Recorded<Vector> velocity_along, velocity_across, acceleration_along, acceleration_across;
        /// Why there is no Coriolis term.
        enum class NoCoriolis {
            there_is,
            observer_does_not_turn,
            rests_for_observer
        } no_coriolis = NoCoriolis::there_is;
    };
    std::optional<Apart> apart;  ///< for observers on bodies, where accelerations are known
};
/// An angular velocity found a second time, from instant centres.
struct SecondWay {
    BodyIndex body = none;
    Recorded<Exact> omega;
    bool agrees = false;  ///< with the polygon, by an exact predicate
};
/// The parts of a figure of one body's instantaneous motion besides its velocities and centre.
struct InstantaneousMotionFigure {
    BodyIndex body = none;
    enum class Found {
        nothing,         ///< neither centre nor translation is known
        perpendiculars,  ///< the perpendiculars at `points` meet in the centre
        tips,  ///< parallel velocities at `points`: the line of their tips meets the line of the points in the centre
        point_at_rest,  ///< the one of `points` is the centre
        translation,    ///< the perpendiculars at `points` are parallel
        rest,           ///< the body does not move
        contradiction   ///< no rigid motion has the given values at `points`
    } found = Found::nothing;
    std::vector<PointIndex> points;
    /// Two velocities with different projections on the line of their points (first → second): the projections, m/s.
    struct Projections {
        PointIndex first = none, second = none;
        Recorded<Vector> of_first, of_second;
        Recorded<Vector> join;
        StatementIndex statement = none;  ///< the statement of the difference
    };
    std::optional<Projections> differing;
    Recorded<Vector> acceleration_centre;  ///< the place of the body whose acceleration vanishes, m
    std::string acceleration_centre_name;  ///< "K", or the first of K2, K3 … that is not a point of the file
    StatementIndex centre_statement = none, acceleration_centre_statement = none;
};

/// Of all points and bodies.
struct SolvedMotion {
    std::vector<PointMotion> points;  ///< in the file's order of points
    std::vector<BodyMotion> bodies;   ///< by BodyIndex
    std::vector<Sliding> sliding;
    std::vector<EquivalentLinkage> equivalent_linkages;  ///< of the contacts, as used to draw the motion
    std::vector<InstantCentre> centres;                  ///< all n(n−1)/2, in the order of their keys
    std::vector<RelativeMotion> relative_motion;
    std::vector<SecondWay> second_way;
    std::optional<InstantaneousMotionFigure>
        instantaneous_motion;  ///< if the file gives the instantaneous motion of one body
};

/// The quantities of these values.
Quantity velocity_of(const PointMotion& motion);
Quantity acceleration_of(const PointMotion& motion);
Quantity quantity_of(const InstantCentre& centre);

}  // namespace kinegraph
