// Expressions of results as they are printed: ω₄/ω₂, |v_B|, y_B − y_A.
#pragma once

#include "engine/results/result_expression.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// Its own name, or the expression.
RichText symbol_of(const ResultExpression& expression, const Mechanism& mechanism, Language language);
/// "ratio = ω₄/ω₂"; without a name of its own, the expression.
RichText equation_of(const ResultExpression& expression, const Mechanism& mechanism, Language language);

}  // namespace kinegraph::render
