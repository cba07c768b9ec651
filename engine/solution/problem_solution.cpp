#include "engine/solution/problem_solution.hpp"

#include <cmath>

#include "lang/keys/problems.hpp"

namespace kinegraph {

std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where) {
    for (const ProblemValue& each : values)
        if (!std::isfinite(each.value) || !std::isfinite(*each.numeric))
            return Errors{{ErrorCode::bad_input, where, {lang::problems::these_numbers_are_too_far_apart, each.name}}};
    return std::nullopt;
}

}  // namespace kinegraph
