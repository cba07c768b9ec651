// The equations of a closure in doubles, solved by Newton's method near a given position; storage is allocated once.
// BranchWalk keeps track of the branch.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/motion/closure.hpp"
#include "engine/motion/place_rules.hpp"
#include "engine/number/elimination.hpp"

namespace kinegraph::closing {

/// A position along a course.
struct State {
    double s = 0;              ///< the course's coordinate, rad or m
    std::vector<double> q, v;  ///< by the closure's columns, in its unit and rad; v = dq/ds
    double slack = 1;  ///< the last pivot over the first: near 0 where the drivers do not determine the velocities
    int sign = 0;      ///< of the leading rows' determinant
};

/// The largest |value|; 0 if empty.
double largest(const std::vector<double>& values);

class NumericClosure {
public:
    using Row = ClosureRowOf<double>;

    NumericClosure() = default;
    /// `shares`: by driver, its coordinate in the rows divided by the course's coordinate.
    NumericClosure(const Closure& closure, std::vector<double> shares);

    const std::vector<Row>& rows() const { return rows_; }
    const std::vector<Closure::Body>& bodies() const { return bodies_; }
    const std::vector<double>& shares() const { return shares_; }
    const std::vector<bool>& frozen() const { return frozen_; }
    const BodyPlaces& places() const { return places_; }
    std::size_t columns() const { return jacobian_.columns(); }
    /// The drawn position.
    State drawn() const;
    /// Derivative of a row's right side with respect to the course's coordinate.
    double rate(const Row& row) const { return row.driver >= 0 ? shares_[at_index(row.driver)] : 0; }

    void set_places(const std::vector<double>& q);
    /// Adds the gradient of a row, at the current places, to a line of `columns()` elements: n · dD and the terms of
    /// the rotations, with dD = dP − dQ.
    void write(const Row& row, double* into) const;
    /// Factors the matrix at the current places.
    void factor();

    // Rows that determine the motion.
    /// Numerical rank of the rows at the current places, with or without those of the drivers; factors them.
    std::size_t rank(bool with_drivers);
    /// Of the matrix factored last.
    std::size_t rank_factored() const { return jacobian_.rank(); }
    /// Its last leading pivot over the first.
    double slack() const { return jacobian_.pivot_share(leading_.size() - 1); }
    /// Freezes columns without one of the first `rank` pivots of the matrix factored last: they are undetermined.
    void freeze_beyond(std::size_t rank);
    void unfreeze();
    /// Selects the rows of the first `count` pivots of the matrix factored last: they are independent as long as their
    /// determinant keeps its sign.
    void take_leading_rows(std::size_t count);
    /// Reserves space for `count` rows.
    void expect_leading_rows(std::size_t count) { leading_.resize(count); }
    /// Whether no row is left over, so that every sign of the determinant is meaningful.
    bool all_rows_lead() const { return leading_.size() == rows_.size(); }
    /// −1, 0, 1: sign of their determinant, at the current places, as factored last.
    int sign_of_leading_rows();

    // Newton's method.
    /// From state.q; the matrix is kept as long as it converges. q, slack and the places are then those of the
    /// position. False: there is no solution near.
    bool close(State& state);
    /// With a given value of the unknown in a column; the course's coordinate is unknown instead. slope: ds over that
    /// unknown, v: dq over it.
    bool close_at(std::size_t column, State& state, double& slope);
    /// Computes v with the matrix factored last.
    void look_along(State& state);
    /// The correction of q for these residuals by row, with the matrix factored last. Overwrites the residuals.
    const std::vector<double>& correction(std::vector<double>& excesses);

private:
    void write_excesses(double s);
    void write_jacobian();
    void put(double* into, BodyIndex body, const Spot& direction, double turning) const;
    const BodyPlaceOf<double>& now(BodyIndex body) const { return places_[at_index(body)]; }

    std::vector<Row> rows_;
    std::vector<Closure::Body> bodies_;
    std::vector<double> shares_;
    BodyPlaces places_;
    std::vector<bool> frozen_;          ///< by column: undetermined, and at rest
    std::vector<std::size_t> leading_;  ///< as many rows as there are columns that move, independent as drawn
    Elimination jacobian_, square_;
    std::vector<double> right_, delta_;
};

}  // namespace kinegraph::closing
