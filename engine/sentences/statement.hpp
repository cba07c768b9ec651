// Statements: the sentences of a solution as data. A symbol is the written form of a quantity, a message is a sentence
// that can be rendered in any language, an equation is a vector equation with what is known of each term. Independent
// of languages and fonts.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The written form of a quantity: v_B, a_BA^t, ω_3, α_3, P_13, a (image of A). See docs/notation.md.
struct Symbol {
    enum class Letter {
        point,
        image,
        pole,
        v,
        a,
        omega,
        alpha,
        centre,
        length,
        radius,
        diameter,
        error,
        F,
        M,
        speed,
        body
    };
    Letter letter = Letter::point;
    std::string about;  ///< subscript: "B", "BA" (of B relative to A), "3"; for point, image and body the name itself
    std::string term;   ///< superscript: "n", "t", "rel", "tr", "cor", "∞"
    friend bool operator==(const Symbol&, const Symbol&) = default;
};
/// Whether the file's name of a force or couple is a complete symbol: F, F_gas, F1, M4, T4. Otherwise it is the
/// subscript of F or M.
bool has_own_name(const Symbol& symbol);
/// The relative velocity of a Coriolis term: v_AA* of a_AA*^cor, v_B^rel of a_B^cor. `observed`: seen by an observer.
Symbol velocity_of_coriolis(Symbol coriolis, bool observed);
/// Plain name for ids, tables and results: "v_B", "a_BA_t", "omega_3", "P_13", "b", "b'".
std::string name_of(const Symbol& symbol);

/// The sentences of solutions. render/text/words.cpp has each in every language.
enum class Sentence {
    crank_velocity,      ///< {0} body, {1} pivot, {2} point, {3} v, {4} ω: the driven body turns about a point at rest
    crank_acceleration,  ///< {0} body, {1} pivot, {2} point, {3} a, {4} ω, {5} α (absent: it rotates uniformly)
    image_velocity,      ///< {0} point, {1} body, {2} v, {3} known point, {4} ω: the image (Rivals)
    image_acceleration,  ///< {0} point, {1} body, {2} a, {3} known point, {4} ω, {5} α (absent: it rotates uniformly)
    translating_velocity,              ///< {0} body, {1} point, {2} v: ω = 0, all points alike
    translating_acceleration,          ///< {0} body, {1} point, {2} a: it translates, all points alike
    image_acceleration_without_omega,  ///< {0} point, {1} body, {2} a, {3} known point, {4} α: ω = 0 for an instant
    two_lines_velocity,  ///< {0} tip of the point sought (image), {1} first line's reason, {2} second line's reason
    two_lines_acceleration,
    omega_from_pair,  ///< {0} omega, {1} v_BA, {2} segment BA, {3} body; where it draws v_BA, {4} {5} images of A, B
    alpha_from_pair,  ///< {0} alpha, {1} a_BA^t, {2} segment, {3} body; where it draws it, {4} {5} images of A, B, {6}
                      ///< a_BA^n
    omega_by_sleeve,  ///< {0} omega of body, {1} omega of the other, {2} joint's point: a sleeve prevents relative
                      ///< rotation
    alpha_by_sleeve,
    omega_by_joint,  ///< the same for another joint that prevents relative rotation
    alpha_by_joint,
    omega_by_fixed_guide,  ///< {0} omega, {1} body, {2} joint's point: the sleeve's guide is at rest, so it does not
                           ///< rotate
    alpha_by_fixed_guide,
    omega_by_driver,  ///< {0} omega, {1} omega of the reference body
    alpha_by_driver,
    slide_velocity,  ///< {0} v_rel read off once both ends are known: {1} point, {2} body i, {3} body j
    slide_acceleration,
    slide_acceleration_without_coriolis,  ///< {0} a_rel, {1} point, {2} body i, {3} body j: ω or v_rel vanishes
    slide_velocity_on_rest,  ///< {0} v_rel, {1} point, {2} v of the slider: the guide is at rest, so they are equal
    slide_acceleration_on_rest,
    driven_point_velocity,  ///< {0} v of a point fully known from a slide driver, {1} joint
    driven_point_acceleration,
    auxiliary_point,       ///< {0} S, {1} body: the perpendiculars to two loci meet in S
    omega_from_parallels,  ///< {0} omega, {1} segment XY, {2} body: two loci are parallel, their distance gives ω
                           ///< (auxiliary point at infinity)
    alpha_from_parallels,
    rolling_point_at_rest,  ///< {0} contact, {1} body, {2} body at rest, {3} v_P: rolls on a body at rest, so P is at
                            ///< rest
    rolling_velocity,       ///< {0} contact, {1} body, {2} other body, {3} v_P, {4} v_P*: equal velocities
    rolling_point_on_rest_acceleration,  ///< {0} contact, {1} body, {2} body at rest, {3} a_P, {6} lever: along the
                                         ///< normal
    rolling_acceleration,  ///< {0} contact, {1} body, {2} other body, {3} a_P, {4} a_P*, {5} a_PP*^n, {6} lever
    equivalent_link,       ///< {0} {1} bodies, {2} contact, {3} join of the centres of curvature: replaced by a link
    equivalent_slot,       ///< {0} round body, {1} straight body, {2} contact, {3} centre: replaced by a pin in a slot
    equivalent_tip,        ///< {0} body with the tip, {1} straight body, {2} contact
    contact_tangent,       ///< {0} {1} bodies, {2} contact: no relative velocity along the common normal
    pitch_curves,          ///< {0} {1} bodies, {2} pitch point, {3} {4} its name on each body: equal velocities along
                           ///< the tangent
    primary_revolute,      ///< {0} centre, {1} point
    primary_prismatic,     ///< {0} centre, {1} joint's point: at infinity ⟂ guide
    primary_rolling,       ///< {0} centre, {1} contact point
    primary_gear,          ///< {0} centre, {1} pitch point
    primary_weld,          ///< {0} centre, {1} point: no relative motion
    kennedy,               ///< {0} centre, {1} {2} centres of the first line, {3} {4} of the second
    kennedy_line,          ///< {0} centre, {1} {2} centres of one line, {3} point whose normal is the other
    kennedy_two_normals,   ///< {0} centre, {1} {2} points whose normals meet
    kennedy_same,          ///< {0} centre, {1} {2} two centres that coincide: the third coincides with them
    centre_by_rigidity,  ///< {0} centre, {1} centre with which it coincides because two bodies have no relative motion
    no_relative_motion,  ///< {0} bodies that no motion moves against each other in this position
    centre_from_velocities,  ///< {0} centre, {1} {2} points whose relative velocities were used
    second_way,              ///< {0} omega, {1} centre, {2} centre, {3} centre, {4} omega of the driver body
    trial_on_line,  ///< {0} image, {1} its line's reason: no rule applies, so two trial positions on its line are used
    trial_of_spin,  ///< {0} ω or α: the same for an angular velocity
    trial_closes_on_line,  ///< {0} image, {1} reason of the line it must lie on, {2} image or ω: the true value in
                           ///< proportion to the errors {3} {4}
    trial_closes_by_spin,  ///< {0} {1} ω that must agree, {2} image or ω: the true value in proportion
    relative_transport_velocity,      ///< {0} point, {1} observer body, {2} v_tr, {3} v_rel
    relative_transport_acceleration,  ///< … {2} a_tr {3} a_cor {4} a_rel
    relative_translating_velocity,    ///< {0} point, {1} origin, {2} v_tr, {3} v_rel
    relative_translating_acceleration,
    observer_velocity,  ///< {0} point, {1} observer body, {2} v, {3} v_tr, {4} v_rel: the equation that the following
                        ///< intersection solves
    observer_acceleration,  ///< … {2} a, {3} a_tr, {4} a_rel, {5} a_cor (absent: it vanishes)
    not_through_observer,   ///< {0} point, {1} observer body: a remark, the motion was found in another way
    inertia_force,          ///< {0} body, {1} F_i, {2} a_G, {3} G: equal to m a_G, opposite, through G
    inertia_couple,         ///< {0} body, {1} M_i, {2} α: J α, opposite
    two_force_body,         ///< {0} body, {1} {2} points: two forces only, so both act along their join
    two_force_guide,  ///< {0} body, {1} point, {2} guide's joint: two forces, so both act through {1} normal to the
                      ///< guide
    two_force_group,  ///< {0} bodies, {1} {2} points: taken together they carry two forces only
    zero_forces,      ///< {0} body: two forces whose lines cannot coincide, so both vanish
    two_forces_and_couple,  ///< {0} body, {1} point: two forces and a couple, so the force at {1} is parallel to the
                            ///< other one
    three_force_line,  ///< {0} body, {1} name of the meet, {2} symbol of the force whose line is found, {3} its point
    three_parallel_lines,  ///< {0} body, {1} symbol: two lines are parallel, so the third force is parallel to them
    triangle,              ///< {0} body, {1} {2} symbols found by closing the triangle
    triangle_at,           ///< {0} body, {1} name of the meet, {2} {3} symbols found
    polygon,               ///< as triangle, of more than three forces
    polygon_at,            ///< as triangle_at, of more than three forces: the known ones are added first
    parallel_forces,       ///< {0} body, {1} {2} symbols: parallel forces, by moments (funicular polygon)
    culmann,  ///< {0} body, {1} meet of the lines of {3} and {4}, {2} symbol: by moments about {1}, then the triangle
    culmann_line,       ///< {0} body, {1} {2} the meets that give Culmann's line, {3} {4} {5} symbols: {3} at {1}, the
                        ///< others at {2}
    force_and_couple,   ///< {0} body, {1} symbol of the force, equal and opposite to the rest, {2} symbol of the couple
                        ///< M = F·b
    single_reaction,    ///< {0} body, {1} symbol: what remains balances the rest
    superposition,      ///< {0} body whose loads now act alone
    superposition_sum,  ///< the partial reactions are added
    through_pin,        ///< {0} body, {1} point, {2} symbol: all that is known on it passes through {1}, so {2} does
    known_resultant,    ///< {0} body, {1} symbols that are added, {2} their resultant
    inertia_moved,      ///< {0} body, {1} F_i, {2} M_i: F_i displaced replaces both
    funicular_parallel,  ///< {0} body, {1} {2} symbols: parallel forces, by the funicular polygon; {3} meet of the
                         ///< outer strings
    funicular_far,       ///< {0} body, {1} {2} symbols: lines that intersect far away, by the funicular polygon
    funicular_several,   ///< {0} bodies, {1} {2} symbols, {3} known symbols: of several directions, by the funicular
                         ///< polygon; {4} as {3} above
    trial,               ///< {0} symbol: one trial value, then in proportion
    equations_together,  ///< {0} bodies, {1} count of their equilibrium equations, {2} symbols in the order found (or
                         ///< none): solved together
    elastic_spring,      ///< {0} F, {1} {2} points: k (l − l_0), along their join
    torsion_spring,      ///< {0} M on the first body, {1} first body, {2} second: −k φ
    distributed_load,    ///< {0} body, {1} F, {2} {3} ends: its resultant at the centroid of its diagram
    distributed_couple,  ///< {0} body, {1} M, {2} {3} ends: both halves are equal and opposite
    in_equilibrium,      ///< {0} bodies: what acts on them closes its polygon and has no moment
    resultant_force,     ///< {0} bodies, {1} R: the actions on them have a resultant force
    resultant_couple,    ///< {0} bodies, {1} M: the polygon closes, and a couple remains
    truss_whole,         ///< {0} count of bars, {1} count of pins: a truss, cut free whole before its pins
    structure_whole,     ///< {0} bodies: as many equations as unknowns on the frame, so they are cut free whole
    truss_idle_pair,     ///< {0} pin, {1} {2} bars: unloaded, two bars not in line: neither carries anything
    truss_idle_third,    ///< {0} pin, {1} bar, {2} {3} bars in line: unloaded, so the third carries nothing
    truss_idle_single,   ///< {0} pin, {1} bar: alone at an unloaded pin
    truss_stuck,         ///< {0} bars: no pin has at most two unknown bars, so a cut is used
    truss_cut_moment,    ///< {0} bars cut, {1} F of the bar found, {2} {3} the others, {4} where they meet (Ritter)
    truss_cut_across,    ///< {0} bars cut, {1} F of the bar found, {2} {3} the others, which are parallel
    truss_plan,  ///< {0} letters of the spaces outside: the forces from outside in their order, clockwise, close
    truss_pin,   ///< {0} pin, {1} bars found, {2} those in tension, {3} in compression, {4} with no force (or absent)
    truss_support,          ///< {0} pin, {1} reaction: all its bars are known
    truss_bar_and_support,  ///< {0} pin, {1} bar, {2} reaction
    truss_closes,           ///< {0} pins: all known, the polygon closes
    residual_couple,        ///< {0} body, {1} F_R, {2} the point about which its joints let it rotate, {3} M: the given
                            ///< actions rotate it
    residual_force,  ///< {0} body, {1} F_R, {2} F: its joints let it move along the line of {2}, and the given actions
                     ///< move it
    moments_alone,   ///< {0} bodies, {1} centre, {2} symbol: the only unknown with a moment about {1}
    components_alone,    ///< {0} bodies, {1} symbol: the only unknown with a component along its line
    translation_alone,   ///< {0} bodies, {1} symbol, {2} LineReason (or absent): the only unknown that does work in a
                         ///< virtual translation, parallel to {2}
    virtual_work_alone,  ///< {0} symbol, {1} bodies that turn, {2} their centres, {3} bodies that translate, {4} ratios
    elimination_alone,   ///< {0} bodies, {1} count of their equilibrium equations, {2} symbols: the same in every
                         ///< equilibrium
    no_force,            ///< {0} body, {1} symbol: no other action on it, so this vanishes
    no_force_along,      ///< {0} body, {1} symbol: not needed to balance the rest, so it vanishes; {2} balances it; {3}
                         ///< its couple, which vanishes too (or absent)
    act_given,           ///< {0} v_A or a_A: given, set off from the pole
    act_projections,     ///< {0} segment AB, {1} v_A, {2} v_B: equal projections on AB, as for any rigid body
    act_projections_acceleration,  ///< {0} segment AB, {1} a_A, {2} a_B, {3} omega: the projections on AB differ by
                                   ///< ω²·AB
    act_direction,  ///< {0} image of B, {1} v_B, {2} segment AB, {3} v_A: projections are equal, so the lines meet
    act_direction_acceleration,            ///< {0} image of B, {1} a_B, {2} segment AB, {3} a_A
    act_unequal_projections,               ///< {0} segment AB, {1} v_A, {2} v_B, {3} {4} their projections on AB
    act_unequal_projections_acceleration,  ///< {0} segment AB, {1} a_A, {2} a_B: do not differ by ω²·AB
    act_misses,                            ///< {0} v_D: the given value differs from the motion of the other points
    act_agrees,                            ///< {0} v_D: was also given, and agrees
    act_perpendiculars,                    ///< {0} centre, {1} {2} points: the perpendiculars to their velocities meet
    act_tips,           ///< {0} centre, {1} {2} parallel velocities, {3} segment AB: the join of the tips meets AB
    act_point_at_rest,  ///< {0} centre, {1} point
    act_translation,    ///< {0} body, {1} {2} equal velocities: ω = 0
    act_parallels,      ///< {0} body, {1} {2} points: directions alone, parallel perpendiculars: ω = 0
    act_rest,           ///< {0} body: nothing moves
    act_rest_by_lines,  ///< {0} body, {1} point: its perpendicular misses the centre of the others, so nothing moves
    act_velocity,       ///< {0} v_D, {1} D, {2} centre, {3} omega: normal to the ray, ω·CD; the image too
    act_acceleration_centre,  ///< {0} the place K with no acceleration, {1} point
    curvature_turning,        ///< {0} body, {1} point at rest: it is the centre of all paths
    curvature_translation,    ///< {0} body: the pole lies at infinity
    curvature_rest,           ///< {0} body: nothing moves
    curvature_rays,           ///< {0} pole, {1} {2} rays from a point to the centre of curvature of its path
    curvature_pole,           ///< {0} pole, {1} point: on the normal to its velocity, at {2} v over {3} ω
    curvature_bobillier,  ///< {0} pole, {1} join of two points, {2} that of their centres, {3} {4} their rays, {5} the
                          ///< meet
    curvature_bobillier_at_infinity,  ///< {0} pole, {1} join of two points, {2} {3} rays: the same, centres at infinity
    curvature_inflection,             ///< {0} pole, {1} point, {2} its centre, {3} the inflection pole: Euler–Savary
    curvature_inflection_straight,    ///< {0} pole, {1} point whose path is straight, {2} the inflection pole
    curvature_by_acceleration,  ///< {0} pole, {1} the inflection pole, {2} ω: the acceleration of the pole over ω²
    curvature_bresse,           ///< {0} acceleration pole, {1} pole, {2} {3} the ends of both diameters
    curvature_bresse_uniform,   ///< {0} acceleration pole, {1} body: α = 0, it is the inflection pole
    curvature_hartmann,         ///< {0} point, {1} its centre of curvature, {2} pole
    curvature_straight,         ///< {0} point: lies on the inflection circle
    curvature_at_pole,          ///< {0} point: lies in the pole
    curvature_by_normal,        ///< {0} point, {1} its centre of curvature: v²/a_n, of a body that translates
    curvature_by_normal_straight,  ///< {0} point: its acceleration has no normal part
    curvature_envelope,            ///< {0} joint of the straight line, {1} centre of its envelope, {2} pole
    // Remarks.
    off_its_circle,  ///< {0} point, {1} distance, {2} body: a contact beside the circle that its body has
    off_its_foot,  ///< {0} point, {1} distance, {2} centre: a contact beside its line, not moved because several joints
                   ///< use it
    off_its_centres,         ///< {0} point, {1} distance, {2} {3} centres: the same between two circles
    moved_to_foot,           ///< {0} point, {1} distance, {2} centre: a contact moved onto its line
    moved_to_centres,        ///< {0} point, {1} distance, {2} {3} centres: a contact moved onto the line of the centres
    taken_as_rounded,        ///< {0} distance: the file has coordinates of many digits and states no precision
    nearly_on_line,          ///< {0} point, {1} segment, {2} distance by which it misses
    nearly_parallel,         ///< {0} {1} two lines by their reasons, {2} angle by which they miss
    nearly_coincident,       ///< {0} {1} points, {2} distance
    nearly_repeated,         ///< {0} joint: its constraints nearly depend on earlier ones
    is_ill_conditioned,      ///< {0} symbol, {1} change in per cent, {2} given point, {3} distance by which it moves:
                             ///< ill-conditioned
    repeated_constraints,    ///< {0} joint, {1} count
    link_without_length,     ///< {0} body, {1} names of its pins, which all lie at one place
    strange_gravity,         ///< {0} amount: not the gravity of any planet
    lift_off,                ///< {0} joint
    change_point,            ///< {0} count of freedoms by the rank, {1} by Grübler, {2} count of branches
    branch,                  ///< {0} its number, {1} ratios
    branch_without_turning,  ///< {0} its number
    instant_only,            ///< {0} count of freedoms that have no acceleration
    bound_velocities,        ///< {0} count of freedoms, {1} count of conditions on them
    nothing_moves,           ///< no body can move, so every centre is everywhere
    still_bodies,            ///< {0} bodies at rest in every motion
    unturning_bodies,        ///< {0} bodies that never rotate
    freedoms_without_driver,  ///< {0} freedoms, {1} those that the drivers determine
    drivers_without_freedom,  ///< {0} freedoms, {1} drivers
    freedoms_without_effort,  ///< {0} freedoms, {1} input forces and couples
    efforts_without_freedom,  ///< {0} freedoms, {1} input forces and couples
    body_without_joint,       ///< {0} body, {1} the joint that may be meant, as a file writes it (or absent)
    body_of_one_joint,        ///< {0} body, {1} its joint, {2} the joint that may be missing (or absent)
    unjoined_pin,  ///< {0} {1} bodies, {2} point, {3} another point at its place (or absent), {4} the joint that may be
                   ///< missing
    off_the_frame,   ///< {0} bodies that no joint connects with {1}, the frame, {2} the joint that may be missing (or
                     ///< absent)
    rounded_givens,  ///< {0} most digits of a number in the file, {1} digits to which points are taken
    check_differs,   ///< {0} name, {1} amount by the construction, {2} amount it misses the check by, {3} count of
                     ///< others
    check_stands_still,   ///< {0} body: moves by the construction, is not determined by the check
    check_moves,          ///< {0} body: moves by the check, is not determined by the construction
    truss_without_order,  ///< {0} count of bars: no order of pins and no cut resolves the truss: bodies cut free
    truss_without_plan,   ///< {0} count of bars: bars cross, or a force acts inside: there is no plan in one figure
    // From here on phrases, without a capital and a full stop. Undetermined items:
    motion_of_body,        ///< {0} body
    velocity_of_body,      ///< {0} body
    acceleration_of_body,  ///< {0} body
    drive_of_joint,        ///< {0} joint
    drive_of_body,         ///< {0} body
    centre_of_bodies,      ///< {0} {1} bodies
    curvature_of_body,     ///< {0} body
    all_forces,
    // … and the reason:
    one_body_only,  ///< {0} body: a given instantaneous motion belongs to one body
    velocities_contradict,
    unequal_projections,             ///< {0} segment AB, {1} A, {2} amount, {3} B, {4} amount
    unequal_normal_parts,            ///< {0} {1} points: of accelerations that no rigid body can have
    two_velocities_at_one_place,     ///< {0} {1} points
    two_accelerations_at_one_place,  ///< {0} {1} points
    velocity_misses,                 ///< {0} point: the given velocity differs from that of the other points
    acceleration_misses,             ///< {0} point
    no_velocity_given,
    no_acceleration_given,
    centre_on_perpendicular,  ///< {0} point: only the perpendicular there is known of the centre
    speed_of_translation_open,
    size_open,
    turning_open,
    omega_unknown,
    acceleration_open,
    path_straight,    ///< to the second order
    point_at_rest,    ///< it is momentarily at rest
    body_translates,  ///< no pole, no inflection circle
    body_at_rest,
    pole_at_rest,  ///< it has no tangent, and the inflection circle no size
    locked,
    undrivable,
    driven_otherwise,
    no_rigid_motion,        ///< {0} {1} points whose velocities contradict each other
    hangs_on_undetermined,  ///< on bodies whose motion is not determined
    curvatures_coincide,    ///< {0} joint: its profiles have one centre of curvature
    curvatures_wanted,      ///< {0} joint: the file gives no curvatures
    nothing_drives,         ///< {0} count of freedoms
    stays_free,
    dead_point_at,  ///< {0} point
    lacks_drivers,  ///< {0} count of freedoms, {1} of those driven, {2} of missing drivers (or absent), {3} the same
                    ///< above one
    stands_still,   ///< it cannot move, and no driver moves it
    beyond_groups,  ///< no supported group of bodies leads to it
    one_line_undetermined,     ///< Kennedy gives one line at most, and the motion is not determined
    one_line_unknown,          ///< … and the velocities are not known
    spring_without_direction,  ///< {0} load's name
    inertia_without_motion,    ///< {0} body
    unbalanced,                ///< {0} count of freedoms, {1} count of efforts, {2} symbols not determined (or absent)
    too_many_efforts,          ///< {0} count of efforts, {1} count of freedoms, {2} symbols (or absent)
    indeterminate,             ///< {0} how many times, {1} joints, {2} symbols (or absent)
    effort_without_work,       ///< {0} symbols (or absent)
    not_by_equilibrium,        ///< {0} symbols (or absent)
    cut_of_bars,               ///< {0} bars: what a cut was to find
    cut_in_one_point,          ///< their lines meet in one point, or all are parallel
    cut_without_reactions,     ///< what acts on either side is not known
    count_                     ///< not a sentence
};
/// Whether it is a part of a sentence, before or after a colon.
constexpr bool is_phrase(Sentence sentence) { return sentence >= Sentence::motion_of_body; }

/// One argument of a sentence.
struct PointName {
    std::string name;
};
struct BodyName {
    /// Truss: all of it, cut free whole, or a bar of it. Pin: of a hinge, a node of its own, named by its point.
    enum class As { body, truss, pin };
    std::string name;
    As as = As::body;
};
/// The name of a joint for readers: its point, which is in the drawing, or its own name, which is not.
struct JointName {
    std::string name;
    bool own = false;
};
struct Segment {
    std::string from, to;
};  ///< the join of two points: "O2A"
/// Direction of a line: perpendicular or parallel to a segment, a guide, the normal of a contact …
struct LineReason {
    enum class Kind {
        perpendicular_to_segment,
        parallel_to_segment,
        parallel_to_guide,
        perpendicular_to_guide,
        known,
        driver_component,
        parallel_to_locus,
        given_direction,
        parallel_to_tangent,  ///< common tangent of a contact
        parallel_to_normal    ///< common normal of a contact, of pitch curves
    } kind = Kind::known;
    std::string from,
        to;                 ///< the segment's ends, or `from` the guide's joint or the point with a given direction
    bool own_name = false;  ///< `from` is the name of a joint, not of a point
    friend bool operator==(const LineReason&, const LineReason&) = default;
};
/// The lever that ω² is multiplied by at a rolling contact: from the radii R and r, or r alone on a straight line.
enum class RollingLever { on_straight, outside, inside };
/// A value with its unit; rounded only when printed.
struct Amount {
    double value = 0;
    std::string unit;
};
/// A count, which selects singular or plural.
struct Count {
    int value = 0;
};
/// ω_4/ω_2 = −3.
struct Ratio {
    Symbol above, below;
    double value = 0;
};
using Ratios = std::vector<Ratio>;
/// Names of points, joints or bodies, as a list.
using Names = std::vector<std::string>;
using Symbols = std::vector<Symbol>;
using Argument = std::variant<PointName, BodyName, JointName, Segment, LineReason, Symbol, RollingLever, Amount, Count,
                              Ratios, Names, Symbols, std::string>;

/// Its point; its own name where another sliding joint has the same point.
JointName reader_name(const Mechanism& mechanism, const Joint& joint);
/// Its name in the file.
inline JointName file_name(const Joint& joint) { return {joint.name, joint.named}; }

/// Worked arithmetic where a sentence computes a number: ω_3 = 0.196/0.15 = 1.31 rad/s.
struct Working {
    Symbol of;
    struct Factor {
        double value = 0;  ///< in units that combine to the result's unit
        bool squared = false;
    };
    std::vector<Factor> factors;  ///< none: measured in the drawing
    std::optional<double> divisor;
    Amount result;
    /// Without factors: it is their sum. With factors: each factor is multiplied by one of these: ΣF·b.
    std::vector<double> summands = {};
    /// The direction of a Coriolis term: the relative velocity turned by a quarter turn in the sense of ω.
    struct Turned {
        Symbol velocity, with;
    };
    std::optional<Turned> turned = {};
};
struct Message {
    Sentence sentence = Sentence::count_;
    std::vector<Argument> arguments;
    std::vector<Working> worked_arithmetic = {};  ///< printed after the sentence
};

/// A term of a vector equation and what is known of it before the polygon is drawn.
struct Term {
    Symbol symbol;
    bool magnitude_known = false;
    bool direction_known = true;
    LineReason line;        ///< the reason for its direction, for the table's third row
    BodyIndex body = none;  ///< the body whose colour it has
};
/// side[0] = side[1] (= side[2]): each side a sum of terms.
struct Equation {
    std::vector<std::vector<Term>> sides;
};

}  // namespace kinegraph
