// Names of bars.
#include "engine/results/result_names.hpp"

#include <algorithm>

#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

const TrussStructure::Bar* bar_of(const TrussStructure& truss, BodyIndex body) {
    const auto found = std::find_if(truss.bars.begin(), truss.bars.end(),
                                    [&](const TrussStructure::Bar& bar) { return bar.body == body; });
    return found == truss.bars.end() ? nullptr : &*found;
}

/// Whether a requested force at a joint refers to bars by their body numbers.
bool are_asked_by_number(const Mechanism& mechanism, const TrussStructure& truss) {
    const std::vector<Column> columns = asked_columns(mechanism);
    return std::any_of(columns.begin(), columns.end(), [&](const Column& column) {
        const Quantity& quantity = column.quantity;
        return quantity.kind != Quantity::Kind::bar && (bar_of(truss, quantity.body) || bar_of(truss, quantity.other));
    });
}

}  // namespace

const std::string* name_of_bar(const Solution& solution, BodyIndex body) {
    if (!solution.truss) return nullptr;
    const TrussStructure& truss = solution.truss->structure;
    const TrussStructure::Bar* bar = bar_of(truss, body);
    return bar != nullptr && !are_asked_by_number(solution.mechanism, truss) ? &bar->name : nullptr;
}

}  // namespace kinegraph
