// Operands: of what expressions of results are made, and the results that are themselves expressions of others.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/results/result_expression.hpp"

namespace kinegraph {

/// The mechanical advantage: the load over the input force or couple, where there is one of each and nothing else acts.
/// Of a force the load is its magnitude. It has the sign of the effort, of two couples that of their quotient.
/// The kinetic energy of all masses; where one driver moves them, the inertia or mass that has it at the driver's rate.
std::vector<ResultExpression> defined_results(const Mechanism& mechanism);

std::vector<Column> parameter_columns(const Mechanism& mechanism);

/// All columns that an expression of results may be made of: possible results, the least transmission angle, defined
/// results, the file's parameters; of a problem without joints the parameters alone. `driver`: of whose couplers the
/// transmission angles are.
std::vector<Column> operands_of_expressions(const Mechanism& mechanism, int driver = 0);

/// Those of the operands that texts of columns and expressions are made of. A text may name an expression of an earlier
/// one; what cannot be read has none.
std::vector<Column> operands_in(std::span<const std::string> texts, const std::vector<Column>& operands);

}  // namespace kinegraph
