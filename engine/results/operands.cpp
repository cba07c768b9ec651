#include "engine/results/operands.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/mechanism/problem.hpp"
#include "engine/results/result_names.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph {
namespace {

/// The load alone, if one force or couple acts and has a magnitude of its own.
std::optional<Measured> only_load(const Mechanism& mechanism) {
    const bool weighs = mechanism.gravity || mechanism.inertia_forces;
    if (mechanism.loads.size() != 1 || (weighs && !mechanism.masses.empty())) return std::nullopt;
    const Load& load = mechanism.loads.front();
    if (const auto* couple = std::get_if<CoupleLoad>(&load))
        return Measured{.value = couple->value, .dimension = dimension_of(QuantityKind::moment)};
    const auto* force = std::get_if<ForceLoad>(&load);
    if (force == nullptr) return std::nullopt;
    if (force->magnitude)
        return Measured{.value = abs(force->magnitude->first), .dimension = dimension_of(QuantityKind::force)};
    const double size = std::sqrt(dot(*force->value, *force->value).to_double());
    return Measured{.value = Exact::from_double(size), .dimension = dimension_of(QuantityKind::force)};
}

/// The shortest that reads back as the same double, without an exponent.
std::string decimal_of(double value) {
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
    return {digits.data(), end.ptr};
}

}  // namespace

std::vector<ResultExpression> defined_results(const Mechanism& mechanism) {
    const auto load = only_load(mechanism);
    if (!load || load->value.is_zero() || mechanism.efforts.size() != 1) return {};
    const std::string effort = std::visit([](const auto& each) { return each.name; }, mechanism.efforts.front());
    const std::string unit(default_unit(*kind_of(load->dimension)).symbol);
    auto read = ResultExpression::read(
        "mechanical advantage = (" + decimal_of(load->value.to_double()) + " " + unit + ") / 'effort " + effort + "'",
        constructed_results(mechanism));
    if (!read) return {};  // the name of the effort contains a quote
    read->call(lang::sheet::mechanical_advantage);
    return {*std::move(read)};
}

std::vector<Column> parameter_columns(const Mechanism& mechanism) {
    std::vector<Column> columns;
    for (const NamedParameter& each : mechanism.parameters) {
        Column column{
            Column::Kind::parameter, {}, each.name, kind_of(each.dimension).value_or(QuantityKind::dimensionless)};
        column.dimension = each.dimension;
        columns.push_back(std::move(column));
    }
    return columns;
}

std::vector<Column> operands_of_expressions(const Mechanism& mechanism, int driver) {
    std::vector<Column> known;
    if (!stands_for_joints(mechanism)) {
        known = possible_results(mechanism, driver);
        known.push_back(transmission_column());
    }
    for (Column& each : parameter_columns(mechanism)) known.push_back(std::move(each));
    return known;
}

std::vector<Column> operands_in(std::span<const std::string> texts, const std::vector<Column>& operands) {
    std::vector<Column> known = operands, found;
    for (const std::string& text : texts) {
        const auto is_it = [&](const Column& each) { return each.name == text; };
        if (const auto named = std::find_if(known.begin(), known.end(), is_it); named != known.end()) {
            found.push_back(*named);
        } else if (const auto read = ResultExpression::read(text, known)) {
            found.insert(found.end(), read->parts().begin(), read->parts().end());
            known.push_back(read->column());
        }
    }
    return found;
}

}  // namespace kinegraph
