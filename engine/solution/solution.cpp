#include "engine/solution/solution.hpp"

#include "engine/solution/found_elements.hpp"

namespace kinegraph {

Solution::Solution() = default;
Solution::Solution(const Solution&) = default;
Solution::Solution(Solution&&) noexcept = default;
Solution& Solution::operator=(const Solution&) = default;
Solution& Solution::operator=(Solution&&) noexcept = default;
Solution::~Solution() = default;

namespace {

void read(const Value& from, Exact& value) { value = std::get<Exact>(from); }
void read(const Value& from, ProjectivePoint& value) { value = std::get<ProjectivePoint>(from); }
/// A vector from the pole may be stored in the record as its tip.
void read(const Value& from, Vector& value) {
    const auto* point = std::get_if<ProjectivePoint>(&from);
    value = point == nullptr ? std::get<Vector>(from) : point->place();
}

}  // namespace

void read_values(Solution& solution, const std::vector<Value>& values) {
    for_each_found(solution, [&](ElementIndex& element, auto& value) { read(values[at_index(element)], value); });
}

}  // namespace kinegraph
