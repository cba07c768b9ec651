#include "constructions/positions/expression_columns.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph {

namespace {

/// The index of the one with this name.
template <class Named>
std::size_t place_of(const std::string& name, const std::vector<Named>& all) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
    KG_ASSERT(found != all.end(), "an expression is made of the columns and the parameters");
    return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

std::size_t ExpressionColumns::add(const ResultExpression& expression, std::vector<Column>& columns,
                                   const std::vector<NamedParameter>& parameters) {
    Each added{expression, columns.size(), {}};
    for (const Column& part : expression.parts()) {
        const bool is_parameter = part.kind == Column::Kind::parameter;
        added.parts.push_back(
            {is_parameter, is_parameter ? place_of(part.name, parameters) : place_of(part.name, columns)});
    }
    columns.push_back(expression.column());
    all_.push_back(std::move(added));
    return columns.size() - 1;
}

void ExpressionColumns::fill(std::vector<double>& row, std::vector<double>& noise, const std::vector<bool>& lacking,
                             const std::vector<NamedParameter>& parameters) {
    for (Each& each : all_) {
        std::vector<ValueWithin> parts;
        for (const Each::Part& part : each.parts)
            parts.push_back(part.is_parameter ? ValueWithin{parameters[part.index].value, 0}
                                              : ValueWithin{row[part.index], noise[part.index]});
        const auto lacks_value = [&](const Each::Part& part) {
            return !part.is_parameter && (lacking[part.index] || is_undetermined(part.index));
        };
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
    return each != nullptr && std::any_of(each->parts.begin(), each->parts.end(), [&](const Each::Part& part) {
               return !part.is_parameter && empty[part.index];
           });
}

const ExpressionColumns::Each* ExpressionColumns::of_column(std::size_t column) const {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const Each& each) { return each.column == column; });
    return found == all_.end() ? nullptr : &*found;
}

}  // namespace kinegraph
