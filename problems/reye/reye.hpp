// Reye's hypothesis: the worn volume is proportional to the work of friction, so the worn depth is proportional
// to pressure × sliding. The motion of the bodies during wear gives the form of the depth, equilibrium its size
// (Ferrari and Romiti, Meccanica applicata alle macchine; Shigley, Mechanical Engineering Design, 16–1 … 16–6).
//   pad:   free to tilt, the depth is linear: p = p₁(1 + m x/a), p₁ = 2Q(2a − 3d)/a²b, m = (3a − 6d)/(3d − 2a).
//          If p₁ or p₂ would be negative the face lifts. There remains a triangle of length three times the distance of
//          the force from the nearer end.
//   block: guided, the depth is uniform: p = Q/ab
//   disc:  guided, sliding is proportional to r: p r = Q/2π(r₂ − r₁), M = n f Q (r₁ + r₂)/2;
//          new, with uniform pressure, M = ⅔ n f Q (r₂³ − r₁³)/(r₂² − r₁²)
//   shoe:  turns about its pivot, the depth is proportional to the pivot's distance from the normal: p = C sin θ.
//          With N₁ = b r h ∫ sin²θ dθ and F₁ = b r ∫ sin θ (r − h cos θ) dθ, equilibrium about the pivot is
//          Q c = C (N₁ ∓ f F₁), − if friction assists the force
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/solution/problem_kind.hpp"

namespace kinegraph {

// ----- what a file states

/// A rubbing contact whose pressure follows from its wear (Reye: the volume worn off is proportional to the work of
/// friction).
struct ReyeProblem {
    enum class Kind {
        pad,    ///< a pad free to tilt, under an eccentric force
        block,  ///< the same, guided so that it wears evenly
        disc,   ///< a ring pressed on a plane that turns: clutch or collar
        shoe    ///< on a drum, turning about a pivot
    } kind = Kind::pad;
    Exact force;                    ///< N; for a shoe the force that turns it about its pivot, at the arm `arm`
    std::optional<Exact> friction;  ///< coefficient; a disc and a shoe have one
    Exact length, width, offset;    ///< pad, block: m; the offset from the end x = 0
    Exact inner, outer;             ///< disc: radii, m
    int surfaces = 1;               ///< disc
    Exact radius, pivot,
        arm;         ///< shoe: radius of the drum; distance of the pivot from the drum's centre; arm of the force about
                     ///< the pivot, m
    Exact from, to;  ///< shoe: its ends, rad, from the direction of the pivot as seen from the drum's centre
    bool inside = false, leading = true;     ///< shoe: inside the drum; friction turns it in the same sense as the
                                             ///< force
    std::optional<Exact> wear, speed, time;  ///< m²/N; m/s or, for discs and shoes, rad/s; s
    std::string where;
};

// ----- solution

/// A rubbing contact. The coordinate of pressures is x from the pad's end (m), the radius of a disc (m), or the angle
/// of a shoe (rad).
struct ReyeSolution {
    double begin = 0, end = 0;     ///< ends of the contact
    double first = 0, second = 0;  ///< pressures at both ends of the face, Pa; 0 where it lifts off
    double greatest = 0, greatest_at = 0;
    std::optional<Exact> m;          ///< pad: (p₂ − p₁)/p₁, where the whole face touches
    std::optional<Exact> resultant;  ///< pad, block: of the pressures, from the end x = 0, m
    bool lifts = false;
    std::optional<double> friction_force;                    ///< pad, block
    std::optional<double> torque;                            ///< disc, shoe; N m
    std::optional<double> uniform_pressure, uniform_torque;  ///< disc: new, before it has worn in
    std::optional<double> locking_friction;  ///< leading shoe: above this coefficient it locks without force
    VectorOf<double> normal_force;           ///< shoe: resultant of the pressures on the shoe, N; x towards the pivot
    double pressure_radius = 0;              ///< shoe: of the centre of pressure, m
    std::optional<std::array<double, 2>> worn;  ///< depth at both ends of the face, m
    struct At {
        double place = 0, pressure = 0;
    };
    std::vector<At> pressures;  ///< along the face
};

/// Errors: a self-locking leading shoe (no_unique_answer); numbers too far apart.
Result<ProblemSolution> solve_reye(const ReyeProblem& problem);

// ----- The numeric check of a contact that wears by Reye's hypothesis: the face is cut into strips; each is pressed in
// proportion to its wear, without tension. Equilibrium of the strips is solved for the motion of the worn body. No
// closed form.

/// As in ReyeSolution.
struct ReyeCheck {
    double first = 0, second = 0, greatest = 0, resultant = 0, begin = 0, end = 0, friction = 0, torque = 0;
    double uniform_pressure = 0, uniform_torque = 0, normal = 0, pressure_radius = 0, locking = 0;
    std::array<double, 2> worn{};
};
ReyeCheck check_reye(const ReyeProblem& problem);

// ----- the kind of problem

std::any read_reye(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue reye_section;
extern const ProblemKind reye_problem;

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> reye_sections(const DrawingContext& context);

// ----- Figures, room in mm.

/// A pad or block on its plane with the pressures below it and their centroid, found graphically; the face of a disc
/// with its radii; a shoe in or on its drum with the pressures and their resultant. Kind and id "contact".
Figure reye_contact_figure(const DrawingContext& context, double room_x, double room_y);
/// The same for a question: without the pressures.
Figure reye_question_figure(const DrawingContext& context, double room_x, double room_y);
/// Pressure over the radius of a disc, new and worn in, or along a shoe. Kind "plot", id "pressures".
Figure reye_pressure_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
