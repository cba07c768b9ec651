#include "problems/positions/positions.hpp"

#include <complex>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Complex = std::complex<double>;

VectorOf<double> vector_of(Complex z) { return {z.real(), z.imag()}; }
Complex complex_of(const Vector& v) { return {v.x.to_double(), v.y.to_double()}; }
/// Not by the operator, which each compiler scales in its own way.
Complex quotient(Complex z, Complex by) { return z * std::conj(by) / std::norm(by); }

}  // namespace

DisplacementCheck check_displacement(const PositionsProblem& problem, std::size_t from, std::size_t to) {
    const auto &first = problem.positions.at(from).places, &second = problem.positions.at(to).places;
    const Complex turn =
        quotient(complex_of(second[1]) - complex_of(second[0]), complex_of(first[1]) - complex_of(first[0]));
    DisplacementCheck check;
    check.angle = nearest::atan2(turn.imag(), turn.real());
    check.way = vector_of(complex_of(second[0]) - complex_of(first[0]));
    check.pole = vector_of(quotient(complex_of(second[0]) - turn * complex_of(first[0]), 1.0 - turn));
    return check;
}

std::pair<VectorOf<double>, double> check_pivot(const PositionsProblem& problem, std::size_t point) {
    const auto place = [&](std::size_t position) {
        return complex_of(problem.positions.at(position).places.at(point));
    };
    // Relative to the first place, which reduces cancellation.
    const Complex b = place(1) - place(0), c = place(2) - place(0);
    const double area = 2 * (b.real() * c.imag() - b.imag() * c.real());
    const Complex centre = Complex(0, 1) * (b * std::norm(c) - c * std::norm(b)) / area;
    return {vector_of(place(0) + centre), nearest::hypot(centre.real(), centre.imag())};
}

}  // namespace kinegraph
