// Expressions of laws as formulas: fractions, roots, powers, Greek letters.
#pragma once

#include <string_view>

#include "engine/file/expression.hpp"
#include "render/text/math.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// "v_0 cos(α) t": what is divided by stands below a bar, e^u is a power, the letters of constants as a file names them
/// ("omega1" is ω₁).
Formula formula_of(const Expression& of, const NamedConstants& constants, std::string_view variable, Language language);
/// The letter of a constant, or a quantity with its unit.
Formula formula_of(const NamedConstant& constant, Language language);

}  // namespace kinegraph::render
