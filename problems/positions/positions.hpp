// Finite displacements: the pole between two positions of a body, by bisectors, and the fixed pivot of a crank
// that guides one of its points through three positions.
//
// Sources: the pole of a finite displacement, Euler and Chasles; three positions, Burmester 1888.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/solution/problem_kind.hpp"

namespace kinegraph {

// ----- what a file states

/// Two points of a body in two or three positions.
struct PositionsProblem {
    std::array<std::string, 2> points;
    struct Position {
        std::array<Vector, 2> places;
        double moved = 0;  ///< displacement of the second point along AB that keeps its distance (m)
        std::string where;
    };
    std::vector<Position> positions;
    std::string where;
};

// ----- solution

/// The displacement of a body from one position to another.
struct Displacement {
    std::size_t from = 0, to = 1;
    enum class Kind {
        rest,         ///< both positions are the same
        translation,  ///< all points have the same displacement
        rotation,     ///< about one of the two points, which stays in place
        general       ///< about a pole that is neither of the points
    } kind = Kind::general;
    std::optional<Vector> pole;  ///< none for a translation or rest
    Vector way;                  ///< of a translation
    double angle = 0;            ///< −π … π, counter-clockwise positive
    /// How the pole was found: intersection of the perpendicular bisectors; where they coincide, intersection of the
    /// two joins, or the common midpoint; or a point that stays.
    enum class By { bisectors, joins, middle, point } by = By::bisectors;
};
/// The fixed pivot of a crank that guides one of the points through three positions: centre of the circle through them.
struct FixedPivot {
    enum class Kind {
        pivot,
        straight,
        free,
        fixed
    } kind = Kind::pivot;  ///< free: two places coincide; fixed: all three coincide
    std::optional<Vector> centre;
    Vector direction;   ///< of the straight line
    double radius = 0;  ///< length of the crank
};
struct PositionsSolution {
    std::vector<Displacement> displacements;  ///< 1→2; of three positions also 2→3, 1→3
    std::vector<FixedPivot> pivots;           ///< of three positions: of the first and of the second point
    Protocol record;
};

Result<ProblemSolution> solve_positions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- The numeric check: complex numbers, with a displacement z′ = e^{iφ}z + c, and circles through three points by
// their equations.

struct DisplacementCheck {
    VectorOf<double> pole, way;
    double angle = 0;
};
DisplacementCheck check_displacement(const PositionsProblem& problem, std::size_t from, std::size_t to);
/// The circle through the three positions of point `point`: centre and radius.
std::pair<VectorOf<double>, double> check_pivot(const PositionsProblem& problem, std::size_t point);

// ----- the kind of problem

std::any read_positions(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue positions_section;
extern const ProblemKind positions_problem;

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> positions_sections(const DrawingContext& context);

// ----- Figures: a body in two positions with the bisectors and the pole; in three positions with the fixed pivots of
// two of its points. Room in mm.

/// Only the body in its positions.
Figure positions_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure finite_displacement_figure(const DrawingContext& context, std::size_t displacement, double room_x,
                                  double room_y);
Figure pivots_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
