#include "engine/solution/problem_solution.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lang/keys/problems.hpp"

namespace kinegraph {

namespace {

Words six_digits(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6);
    return decimal_words({digits.data(), end.ptr});
}

}  // namespace

std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where) {
    for (const ProblemValue& each : values)
        if (!std::isfinite(each.value) || !std::isfinite(*each.numeric))
            return Errors{{ErrorCode::bad_input, where, {lang::problems::these_numbers_are_too_far_apart, each.name}}};
    return std::nullopt;
}

std::vector<Words> remarks_on_check(const std::vector<ProblemValue>& values) {
    constexpr double allowed = 1e-6, rounding = 1e-12;  // where all of a kind are 0
    std::vector<Words> remarks;
    for (const ProblemValue& each : values) {
        if (!each.numeric) continue;
        double largest = 0;
        for (const ProblemValue& other : values)
            if (other.kind == each.kind && other.unit == each.unit) largest = std::max(largest, std::abs(other.value));
        if (std::abs(each.value - *each.numeric) <= allowed * largest + rounding) continue;
        remarks.emplace_back(lang::problems::the_check_does_not_confirm, each.name, six_digits(each.value),
                             six_digits(*each.numeric));
    }
    return remarks;
}

}  // namespace kinegraph
