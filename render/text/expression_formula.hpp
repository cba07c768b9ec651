// Expressions of motion laws as formulas: fractions, roots, powers, Greek letters.
#pragma once

#include <string_view>

#include "engine/file/expression.hpp"
#include "render/text/math.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// "v_0 cos(α) t": divisors stand below a bar, e^u is a power, and constants are typeset by their names in the file
/// ("omega1" is ω₁).
Formula formula_of(const Expression& of, const NamedConstants& constants, std::string_view variable, Language language);
/// The letter of a named constant; the value with its unit if it has no name.
Formula formula_of(const NamedConstant& constant, Language language);

}  // namespace kinegraph::render
