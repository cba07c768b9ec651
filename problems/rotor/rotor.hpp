// Balancing of a rigid rotor. The masses m at the radii r pull outwards with m r ω²; ω² is common to all, so that the
// polygons are drawn of the unbalances U = m r. In one plane the closing side of the force polygon is the correction
// (static balance). In two planes A and B (dynamic balance) A is the reference plane: the closing side of the polygon
// of the couples U l, l from A, is the couple of the correction in B; with it the force polygon closes by that in A.
//
// Sources: Dalby, The Balancing of Engines (1902), the reference plane and couples drawn along the radii; Norton,
// Design of Machinery, 12.1–12.3; Uicker, Pennock, Shigley, Theory of Machines and Mechanisms, chapter on balancing.
// ISO 21940: the names unbalance, correction plane.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/solution/problem_kind.hpp"

namespace kinegraph {

// ----- what a file states

/// A plane across the shaft.
struct RotorPlane {
    std::string name;
    Exact z;  ///< along the shaft, m
};
struct RotorMass {
    std::string name;
    Exact mass, radius;                ///< kg, m
    Bearing angle;                     ///< an angle from the axis x, or a vector
    std::optional<std::size_t> plane;  ///< none in a file without planes: all lie in one
};
/// A mass to be added.
struct RotorCorrection {
    std::optional<std::size_t> plane;
    std::optional<Exact> radius, mass;  ///< at most one of them is given
};
struct RotorProblem {
    std::vector<RotorPlane> planes;
    std::vector<RotorMass> masses;
    std::vector<RotorCorrection> corrections;            ///< one: static balance; two: dynamic
    std::optional<std::array<std::size_t, 2>> bearings;  ///< planes
    Exact omega;                                         ///< rad/s, where there are bearings
    std::string where;

    bool is_dynamic() const { return corrections.size() == 2; }
    bool has_planes() const { return !planes.empty(); }
    /// Of the plane where there are some, otherwise 0.
    Exact z_of(const std::optional<std::size_t>& plane) const { return plane ? planes[*plane].z : Exact(); }
    /// For symbols: the plane's name, "c" without planes.
    std::string name_of(const RotorCorrection& correction) const {
        return correction.plane ? planes[*correction.plane].name : "c";
    }
};

// ----- solution

/// A polygon of the record: each side from the tip of the one before it, the first from the pole.
struct RotorPolygon {
    struct Side {
        std::optional<std::size_t> mass;  ///< of the rotor; none: of the correction or the bearing
        std::size_t balancing = 0;        ///< its number
        ElementIndex tail = none, tip = none;
    };
    std::vector<Side> sides;  ///< the last one closes it
};
/// What two planes (or one) must hold so that both polygons close.
struct RotorBalance {
    RotorPolygon couples, forces;  ///< the first without sides in static balance
    std::vector<Vector> closing;   ///< the unbalance in each plane, kg m; {0, 0} within the rounding of the angles
};
struct RotorSolution {
    struct Unbalance {
        Vector direction;  ///< unit vector
        Exact size;        ///< m r, kg m
        Exact arm;         ///< from the reference plane, m
    };
    std::vector<Unbalance> unbalances;  ///< of the masses
    bool exact = true;                  ///< every direction is that of the file, without rounding
    RotorBalance balance;
    struct Correction {
        double unbalance = 0, angle = 0;     ///< kg m; rad, 0 … 2π
        std::optional<double> mass, radius;  ///< the one that is sought
        bool vanishes = false;
    };
    std::vector<Correction> corrections;
    RotorPolygon couples_left;          ///< static balance with planes: the couples about the correction plane
    std::optional<Vector> couple_left;  ///< its closing side reversed, kg m²
    std::optional<RotorBalance> held;   ///< by the bearings, as if they were correction planes
    struct Reaction {
        double force = 0, angle = 0;
        bool vanishes = false;
    };
    std::vector<Reaction> reactions;      ///< of the bearings on the shaft before balancing, N
    std::optional<double> reaction_left;  ///< of each bearing after static balancing, N
    Protocol record;

    bool is_balanced_already() const {
        for (const Correction& each : corrections)
            if (!each.vanishes) return false;
        return true;
    }
};

Result<ProblemSolution> solve_rotor(const RotorProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- The numeric check: doubles and trigonometric functions; sums of forces, and of moments about z = 0, solved for
// both planes at once by Cramer's rule. No reference plane, no polygon.

struct RotorCheck {
    std::vector<VectorOf<double>> corrections, reactions;  ///< kg m, N
    VectorOf<double> couple_left;
    double reaction_left = 0;
};
RotorCheck check_rotor(const RotorProblem& problem);

// ----- the kind of problem

std::any read_rotor(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue rotor_section;
extern const ProblemKind rotor_problem;

/// For readers: unbalances in kg mm, couples in kg mm², where masses are in kg and lengths in mm.
Unit unit_of_unbalance(const Units& units);
Unit unit_of_couple(const Units& units);

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> rotor_sections(const DrawingContext& context);

// ----- Figures, room in mm.

/// Whether a figure shows what is to be found.
enum class RotorShown { given, found };
/// Seen against z, x to the right: the masses at their radii, with the corrections. Id "end-view".
Figure rotor_end_view(const DrawingContext& context, RotorShown shown, double room_x, double room_y);
/// Along the shaft, z to the right: the planes, the masses at their heights, the arms from the reference plane. Id
/// "side-view".
Figure rotor_side_view(const DrawingContext& context, RotorShown shown, double room_x, double room_y);
bool has_side_view(const RotorProblem& problem);
/// The polygon of unbalances or of couples; of the corrections, or of the bearings.
enum class RotorFigure { couples, forces, couples_left, bearing_couples, bearing_forces };
/// Its id: "couple-polygon".
const char* id_of(RotorFigure figure);
Figure rotor_polygon(const DrawingContext& context, RotorFigure which, double room_x, double room_y);

}  // namespace kinegraph::render
