// Telling: how a working is written to the sentence that it belongs to. Owns that it is said once, and only where it
// comes out.
#pragma once

#include <optional>
#include <vector>

#include "engine/solution/magnitudes.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::workings {

using Factors = std::vector<Working::Factor>;

inline double in(double si, const Unit& unit) { return si / unit.si.to_double(); }

class Telling {
public:
    explicit Telling(Solution& solution) : solution_(solution), magnitudes_(solution) {}

    const Solution& solution() const { return solution_; }
    const Magnitudes& magnitudes() const { return magnitudes_; }
    Message& message(StatementIndex statement) { return solution_.protocol.statements[at_index(statement)].message; }
    /// A working is said once, and only where it comes out.
    void tell(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor, double value,
              const Unit& unit);
    /// What was told last, once more in another unit.
    void tell_also(StatementIndex statement, const Symbol& of, double value, const Unit& unit);
    /// Of a sum of products.
    struct Product {
        double one = 0, other = 0;
    };
    void tell_sum(StatementIndex statement, Symbol of, const std::vector<Product>& products, double value,
                  const Unit& unit);
    /// Of a ω, in rad/s, as sentences reckon with it; where the file has another unit, a second working of it has that
    /// one.
    void tell_turning(StatementIndex statement, Symbol of, Factors factors, std::optional<double> divisor,
                      double value);
    /// A ω that is given, in the file's unit and in rad/s; nothing is said where these are one.
    void tell_given_turning(StatementIndex statement, Symbol of, double value);
    /// ω or α of a body; 0 of none.
    double spin(BodyIndex body, Symbol::Letter letter) const;

private:
    bool is_told(StatementIndex statement, const Symbol& of);

    Solution& solution_;
    Magnitudes magnitudes_;
};

}  // namespace kinegraph::workings
