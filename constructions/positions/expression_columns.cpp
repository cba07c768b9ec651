#include "constructions/positions/expression_columns.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph {

std::size_t ExpressionColumns::add(const ResultExpression& expression, std::vector<Column>& columns) {
    Each added{expression, columns.size(), {}};
    for (const Column& part : expression.parts()) {
        const auto is_it = [&](const Column& other) { return other.name == part.name; };
        const auto found = std::find_if(columns.begin(), columns.end(), is_it);
        KG_ASSERT(found != columns.end(), "an expression is made of the columns");
        added.parts.push_back(static_cast<std::size_t>(found - columns.begin()));
    }
    columns.push_back(expression.column());
    all_.push_back(std::move(added));
    return columns.size() - 1;
}

void ExpressionColumns::fill(std::vector<double>& row, std::vector<double>& noise) {
    for (Each& each : all_) {
        std::vector<ValueWithin> parts;
        for (const std::size_t part : each.parts) parts.push_back({row[part], noise[part]});
        const auto lacks_value = [&](std::size_t part) { return is_undetermined(part); };
        const auto value = std::any_of(each.parts.begin(), each.parts.end(), lacks_value)
                               ? std::nullopt
                               : each.expression.value(parts);
        each.is_determined = value.has_value();
        row[each.column] = value ? value->value : 0;
        noise[each.column] = value ? value->error : 0;
    }
}

bool ExpressionColumns::is_undetermined(std::size_t column) const {
    const Each* each = of_column(column);
    return each != nullptr && !each->is_determined;
}

bool ExpressionColumns::lacks_part(std::size_t column, const std::vector<bool>& empty) const {
    const Each* each = of_column(column);
    return each != nullptr &&
           std::any_of(each->parts.begin(), each->parts.end(), [&](std::size_t part) { return empty[part]; });
}

const ExpressionColumns::Each* ExpressionColumns::of_column(std::size_t column) const {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const Each& each) { return each.column == column; });
    return found == all_.end() ? nullptr : &*found;
}

}  // namespace kinegraph
