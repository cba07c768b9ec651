// The numeric check of a Hertzian contact. It shares nothing with the closed forms: points by Hertz's own integrals
// over the confocal ellipsoids, done by quadrature (the closed form of an approach along a line leaves out (b/r)², the
// check does not); lines by the integral equation of the pressure as a linear system (Erdogan and Gupta's
// Gauss–Chebyshev quadrature); approaches along a line by adding up the strain; stresses by Boussinesq's and Flamant's
// solutions for one force, summed over the face of contact.
#pragma once

#include "engine/mechanism/problem.hpp"

namespace kinegraph {

/// As in HertzSolution, m and Pa.
struct HertzCheck {
    double radius = 0, modulus = 0, a = 0, b = 0, mean = 0, greatest = 0, approach = 0, shear = 0, depth = 0;
};
HertzCheck check_hertz(const HertzProblem& problem);

/// From where the approach of a body at a line of contact is counted: its axis, or a depth below a flat or concave face
/// (where the file gives none, the radius of the partner).
struct Datum {
    bool is_axis = true;
    double depth = 0;  ///< m below the contact
};
Datum datum_of(const HertzProblem& problem, std::size_t body);

}  // namespace kinegraph
