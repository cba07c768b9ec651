// Problems that a file states in place of joints: contact (Hertz), and what was found of them, as values in SI units. Knows no
// method: those are constructions/hertz.hpp and its like, the numeric checks engine/check_hertz.hpp and its like.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/mechanism.hpp"
#include "engine/units.hpp"

namespace kinegraph {

/// One of two elastic bodies that are pressed together.
struct HertzBody {
    BodyIndex body = none;
    /// Principal radii at the contact, m; 0: flat in that plane. A sphere has two equal ones; the second one of a cylinder that
    /// lies along a line of contact is not used.
    std::array<Exact, 2> radii{};
    std::array<bool, 2> inside{};  ///< concave: the material lies outside the radius
    Exact young;                   ///< Pa
    Exact poisson;
    std::optional<Exact> depth;  ///< line contact of a flat or concave body: down to where its approach is counted, m
    std::string where;

    /// Curvature in a principal plane, 1/m, positive where the body bulges towards the other.
    Exact curvature(std::size_t plane) const {
        if (radii[plane].is_zero()) return {};
        return inside[plane] ? -(Exact(1) / radii[plane]) : Exact(1) / radii[plane];
    }
};
struct HertzProblem {
    Exact force;  ///< N
    std::array<HertzBody, 2> bodies;
    bool line = false;
    Exact length;  ///< of a line contact, m
    Exact turn;    ///< between the first principal planes of the two bodies, rad
};
struct Problem {
    std::variant<HertzProblem> of;
};

/// One scalar result, as tables, results and checks say it.
struct ProblemValue {
    Words name;          ///< in English the key of the results file
    std::string symbol;  ///< "p_0", "σ_z": a letter and its subscript
    QuantityKind kind = QuantityKind::dimensionless;
    double value = 0;               ///< SI
    std::optional<double> numeric;  ///< by the check
    bool in_file = true;            ///< false: only tables show it
};

/// What was found of a Hertzian contact. Axes: x along the longer axis of the ellipse of contact (of a line: along the common
/// tangent, across the line), z into the bodies.
struct HertzSolution {
    Exact curvature_sum;    ///< 1/R of a line or a round point contact: the sum of both bodies' curvatures; of an ellipse A + B,
                            ///< twice
    double radius = 0;      ///< effective: R, of an ellipse (R′R″)^½
    double modulus = 0;     ///< effective: E*, Pa
    bool elliptic = false;  ///< a point contact with different principal curvatures
    double long_curvature = 0;   ///< A of the gap A x² + B y², 1/m: that of the longer axis
    double short_curvature = 0;  ///< B
    double a = 0, b = 0;  ///< half axes, a ≥ b, m; a round contact has two equal ones, of a line b is the half width and a is 0
    double mean = 0, greatest = 0;  ///< pressure, Pa
    double approach = 0;            ///< of points far from the contact, m
    double shear = 0, depth = 0;    ///< the greatest shear on the axis, Pa, and its depth, m
    std::size_t sheared = 0;        ///< in which of the two bodies it is
    /// On the axis, Pa; tension positive. σ_x and σ_y are alike under a round contact.
    struct Stress {
        double z = 0, along_x = 0, along_y = 0, along_z = 0, shear = 0;
    };
    std::vector<Stress> stresses;  ///< of the body `sheared`, from the surface down
};

struct ProblemSolution {
    Words subject;  ///< what the sheet is, for its title block
    std::variant<HertzSolution> of;
    std::vector<ProblemValue> values;
    std::vector<Words> remarks;
};

}  // namespace kinegraph
