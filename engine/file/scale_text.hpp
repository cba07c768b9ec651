// Scales as a file writes them: "1:5", "1 mm = 0.01 m/s", "14 mm ≙ 16.28 MN". Independent of figures.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/file/units.hpp"
#include "engine/number/exact.hpp"

namespace kinegraph {

/// " such as "1:5" or …": how a scale for such a quantity may be written.
Words scale_example(QuantityKind kind);
/// SI units for each mm on paper.
tl::expected<Exact, Words> read_scale(std::string_view text, QuantityKind kind);

}  // namespace kinegraph
