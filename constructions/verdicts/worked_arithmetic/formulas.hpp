// Writes worked arithmetic to the sentence to which it belongs: once, and only if it gives the value found.
#pragma once

#include <optional>
#include <vector>

#include "engine/solution/magnitudes.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::worked_arithmetic {

using Factors = std::vector<Working::Factor>;

inline double in(double si, const Unit& unit) { return si / unit.si.to_double(); }

class Telling {
public:
    explicit Telling(Solution& solution) : solution_(solution), magnitudes_(solution) {}

    const Solution& solution() const { return solution_; }
    const Magnitudes& magnitudes() const { return magnitudes_; }
    Message& message(StatementIndex statement) { return solution_.protocol.statements[at_index(statement)].message; }
    /// Adds `of` = factors / divisor = value, unless it is already there or does not give the value.
    void tell(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor, double value,
              const Unit& unit);
    /// Adds the last value again in another unit.
    void tell_also(StatementIndex statement, const Symbol& of, double value, const Unit& unit);
    /// A term of a sum of products.
    struct Product {
        double one = 0, other = 0;
    };
    void tell_sum(StatementIndex statement, Symbol of, const std::vector<Product>& products, double value,
                  const Unit& unit);
    /// For an ω, computed in rad/s as the sentences do; if the file has another unit, a second entry gives the value in
    /// it.
    void tell_turning(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor,
                      double value);
    /// For a given ω, in the file's unit and in rad/s; adds nothing if these are the same.
    void tell_given_turning(StatementIndex statement, Symbol of, double value);
    /// ω or α of a body; 0 if it has none.
    double spin(BodyIndex body, Symbol::Letter letter) const;

private:
    bool is_told(StatementIndex statement, const Symbol& of);

    Solution& solution_;
    Magnitudes magnitudes_;
};

}  // namespace kinegraph::worked_arithmetic
