#include "constructions/positions/conditions.hpp"

#include <algorithm>
#include <cmath>

#include "constructions/positions/cycle.hpp"
#include "constructions/positions/named_results.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph {
namespace {

/// The two sides of a comparison as doubles, in SI.
class Sides {
public:
    Sides(const Condition& condition, const Solution& solution, const std::vector<NamedResult>& results)
        : condition_(condition), solution_(solution), results_(results) {}

    Result<double> value(const Operand& side) const {
        const auto fails = [](Error error) { return tl::unexpected(Errors{std::move(error)}); };
        if (!side.result.empty()) {
            const NamedResult* found = result_named(results_, side.result);
            if (found == nullptr) return fails(missing_result(solution_, results_, side.result, condition_.where));
            return side.absolute ? std::abs(found->value) : found->value;
        }
        const NamedResult* kin = other_result();
        if (kin == nullptr) return fails(missing_result(solution_, results_, other_name(), condition_.where));
        const QuantityKind kind = kin->column.unit;
        const Unit unit = unit_of(kind, solution_.mechanism.units);
        const KnownUnit bare_unit{kind, unit.symbol, unit.si};  // the parsed side refers to it
        const auto read = as_quantity(*side.measured, kind, bare_unit);
        if (!read)
            return fails({ErrorCode::bad_input,
                          condition_.where,
                          {lang::common::is_and, quoted(kin->column.name), with_article(kind), quoted(side.text),
                           described(*side.measured)}});
        return read->in_si().to_double();
    }

private:
    std::string other_name() const {
        for (const Operand* side : {&condition_.left, &condition_.right, &condition_.upper})
            if (!side->result.empty()) return side->result;
        return {};
    }
    const NamedResult* other_result() const { return result_named(results_, other_name()); }

    const Condition& condition_;
    const Solution& solution_;
    const std::vector<NamedResult>& results_;
};

bool compares(Condition::Relation relation, double left, double right) {
    const bool equal = std::abs(left - right) <= 1e-9 * std::max(std::abs(left), std::abs(right));
    switch (relation) {
        case Condition::Relation::less: return left < right && !equal;
        case Condition::Relation::at_most: return left < right || equal;
        case Condition::Relation::equal: return equal;
        case Condition::Relation::at_least: return left > right || equal;
        case Condition::Relation::greater: return left > right && !equal;
    }
    return false;
}

}  // namespace

Result<bool> holds(const Condition& condition, const Solution& solution, const std::vector<NamedResult>& results) {
    const Sides sides(condition, solution, results);
    const auto left = sides.value(condition.left), right = sides.value(condition.right);
    if (!left) return tl::unexpected(left.error());
    if (!right) return tl::unexpected(right.error());
    if (condition.kind == Condition::Kind::compares) return compares(condition.relation, *left, *right);
    const auto upper = sides.value(condition.upper);
    if (!upper) return tl::unexpected(upper.error());
    return compares(Condition::Relation::at_least, *left, *right) &&
           compares(Condition::Relation::at_most, *left, *upper);
}

std::optional<Error> missing_polygon(const Solution& solution, const Condition& condition) {
    const auto moves = [&](auto vector) {
        return std::any_of(solution.points.begin(), solution.points.end(),
                           [&](const PointMotion& each) { return (each.*vector).has_value(); });
    };
    const auto refused = [&](Words why) { return Error{ErrorCode::bad_input, condition.where, std::move(why)}; };
    if (condition.kind != Condition::Kind::polygon_readable || !solution.unsolved.empty()) return std::nullopt;
    switch (condition.polygon) {
        case Condition::Polygon::velocity:
            if (moves(&PointMotion::velocity)) return std::nullopt;
            return refused({lang::positions::no_velocity_polygon_is_drawn});
        case Condition::Polygon::acceleration:
            if (moves(&PointMotion::acceleration)) return std::nullopt;
            return refused({lang::positions::no_acceleration_polygon_is_drawn});
        case Condition::Polygon::force:
            if (!solution.forces.empty()) return std::nullopt;
            return refused({lang::positions::no_force_polygon_is_drawn});
    }
    return std::nullopt;
}

Errors missing_in(const Solution& solution, const std::vector<NamedResult>& results) {
    const Exercise& exercise = *solution.mechanism.exercise;
    Errors missing;
    if (const auto asked = asked_of_results(solution, results); !asked) missing = asked.error();
    for (const Condition& each : exercise.require) {
        for (const Operand* side : {&each.left, &each.right, &each.upper})
            if (!side->result.empty() && result_named(results, side->result) == nullptr)
                missing.push_back(missing_result(solution, results, side->result, each.where));
        if (auto error = missing_polygon(solution, each)) missing.push_back(*std::move(error));
    }
    return missing;
}

Errors missing_in(const Solution& solution) {
    const auto& exercise = solution.mechanism.exercise;
    if (!exercise || (exercise->ask.empty() && exercise->require.empty()) || !solution.unsolved.empty()) return {};
    return missing_in(solution, results_for(*exercise, solution));
}

bool crank_turns_fully(const Mechanism& mechanism, const Pose& pose) {
    if (mechanism.drivers.empty() || !turns(mechanism.drivers.front())) return false;
    const auto positions = Positions::of(mechanism, pose, Course{0});
    if (!positions) return false;
    const auto travel = travel_of(*positions, true, std::nullopt, std::nullopt);
    return travel && !travel->starts_at_limit && !travel->ends_at_limit;
}

}  // namespace kinegraph
