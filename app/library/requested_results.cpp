#include "app/library/requested_results.hpp"

#include "engine/mechanism/exercise.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph::app {

std::vector<render::RequestedResult> requested_results(const std::vector<NamedResult>& results, const Units& units) {
    std::vector<render::RequestedResult> asked;
    for (const NamedResult& each : results) {
        const ToldResult unit = told(each, units);
        const double size = each.unit.empty() ? unit_of(each.column.unit, units).si.to_double() : 1;
        asked.push_back({each.column, each.value, unit.unit, size});
    }
    return asked;
}

std::vector<render::RequestedResult> requested_results(const Solution& solution) {
    if (asked_of(solution.mechanism).empty()) return {};
    return requested_results(results_for(*solution.mechanism.exercise, solution), solution.mechanism.units);
}

}  // namespace kinegraph::app
