#include "constructions/positions/named_results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constructions/positions/cycle.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/result_values.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;
using Kind = Quantity::Kind;

bool has_several_carriers(const Solution& solution, const PointMotion& motion) {
    return std::count_if(solution.points.begin(), solution.points.end(), [&](const PointMotion& other) {
               return other.point == motion.point && other.bodies.front() != frame;
           }) > 1;
}

/// Name of a point or a sliding joint in a solution.
std::string name_in_column(const Quantity& q, const Solution& solution) {
    const Mechanism& m = solution.mechanism;
    const ResultKind::Subject subject = result_kind(q).subject;
    if (subject == ResultKind::Subject::point) {
        const bool several =
            std::any_of(solution.points.begin(), solution.points.end(), [&](const PointMotion& motion) {
                return motion.point == q.point && has_several_carriers(solution, motion);
            });
        return m.point(q.point).name + (several ? " on " + m.body(q.body).name : "");
    }
    const bool has_name_there = subject == ResultKind::Subject::joint || subject == ResultKind::Subject::coupler;
    return has_name_there ? subject_of(q, solution) : std::string();
}

double angle_of(const Body& body, const Pose& pose) {
    const auto line = line_of(body, pose);
    if (!line) return 0;
    const Spot along = to_double(pose.at((*line)[1]) - pose.at((*line)[0]));
    return nearest::atan2(along.y, along.x);
}

/// The values of a solution in its own position.
class Reading {
public:
    explicit Reading(const Solution& solution) : solution_(solution), found_(found_values(solution, true)) {}

    std::vector<NamedResult> all() {
        for (Column& column : columns_found(solution_, true)) {
            if (column.kind == Column::Kind::slid) continue;
            const double value = value_of(column);
            results_.push_back({std::move(column), value});
        }
        for (const FoundValue& each : found_)
            if (each.quantity.component == Quantity::Component::x) add_modulus(each);
        add_efforts();
        if (solution_.problem)
            for (const ProblemValue& each : solution_.problem->values)
                results_.push_back({{Column::Kind::named, {}, each.key, each.kind}, each.value, each.unit});
        return std::move(results_);
    }

private:
    double value_of(const Column& column) const {
        const Quantity& q = column.quantity;
        const Pose& pose = solution_.pose;
        switch (column.kind) {
            case Column::Kind::angle: return angle_of(solution_.mechanism.body(q.body), pose);
            case Column::Kind::place_x: return pose.at(q.point).x.to_double();
            case Column::Kind::place_y: return pose.at(q.point).y.to_double();
            default: break;
        }
        const auto found =
            std::find_if(found_.begin(), found_.end(), [&](const FoundValue& each) { return each.quantity == q; });
        if (column.kind == Column::Kind::along) return dot(direction_of_sliding(pose, q.joint), found->vector);
        if (q.component == Quantity::Component::whole) return found->scalar;
        return q.component == Quantity::Component::x ? found->vector.x : found->vector.y;
    }
    /// Adds those that virtual work gives, but reactions do not.
    void add_efforts() {
        const std::vector<EffortValue> efforts = efforts_found(solution_);
        for (std::size_t e = 0; e < efforts.size(); ++e) {
            if (!efforts[e].value || (e < solution_.efforts.size() && solution_.efforts[e].value)) continue;
            std::vector<Column> column;
            add_columns({.kind = Kind::effort, .given = static_cast<int>(e)}, solution_.mechanism, {}, column);
            results_.push_back({std::move(column.front()), efforts[e].value->to_double()});
        }
    }
    void add_modulus(const FoundValue& each) {
        if (result_kind(each.quantity).shape != ResultKind::Shape::vector) return;
        Column column = modulus_column(each.quantity, solution_.mechanism, name_in_column(each.quantity, solution_));
        const auto is_taken = [&](const NamedResult& other) { return other.column.name == column.name; };
        if (std::any_of(results_.begin(), results_.end(), is_taken)) return;
        // std::hypot is not used: its last digit depends on the library.
        results_.push_back({std::move(column), std::sqrt(dot(each.vector, each.vector))});
    }

    const Solution& solution_;
    std::vector<FoundValue> found_;
    std::vector<NamedResult> results_;
};

}  // namespace

namespace {

/// An expression of these results; none: it is not determined.
std::optional<NamedResult> value_of(const ResultExpression& expression, const std::vector<NamedResult>& results) {
    std::vector<ValueWithin> parts;
    for (const Column& part : expression.parts()) {
        const NamedResult* found = result_named(results, part.name);
        if (found == nullptr) return std::nullopt;
        parts.push_back({found->value, 0});
    }
    const auto value = expression.value(parts);
    if (!value) return std::nullopt;
    return NamedResult{expression.column(), value->value, expression.column().si_unit};
}

/// Why a result that was found has no number in this position; none: it was not found.
std::optional<Words> why_infinite(const Solution& solution, const std::vector<NamedResult>& results,
                                  const std::string& name) {
    if (stands_for_joints(solution.mechanism)) return std::nullopt;
    const std::vector<Column> possible = possible_results(solution.mechanism);
    const auto column =
        std::find_if(possible.begin(), possible.end(), [&](const Column& each) { return each.name == name; });
    for (const InstantCentre& centre : solution.centres)
        if (column != possible.end() && centre.at && centre.at->at_infinity() &&
            quantity_of(centre) == column->quantity.along(Quantity::Component::whole))
            return Words(lang::positions::is_at_infinity, quoted(name));
    for (const ResultExpression& each : defined_results(solution.mechanism)) {
        const bool has_parts = std::all_of(each.parts().begin(), each.parts().end(), [&](const Column& part) {
            return result_named(results, part.name) != nullptr;
        });
        if (each.column().name == name && has_parts) return Words(lang::positions::is_not_determined, quoted(name));
    }
    return std::nullopt;
}

}  // namespace

const NamedResult* result_named(const std::vector<NamedResult>& results, const std::string& name) {
    const auto found =
        std::find_if(results.begin(), results.end(), [&](const NamedResult& r) { return r.column.name == name; });
    return found == results.end() ? nullptr : &*found;
}

std::vector<FoundValue> found_values(const Solution& solution, bool with_reactions) {
    std::vector<FoundValue> values;
    const auto add = [&](const Quantity& quantity, const auto& found) {
        values.push_back({quantity, found.element()});
        if constexpr (requires { found->element_to; }) {
            values.back().scalar = found->to_double();
            values.back().element = found->element_to;
            values.back().from = found->element_from;
        } else if constexpr (requires { found->place(); }) {
            const Vector place = found->place();
            values.back().vector = to_double(place);
            values.back().exact = quantity.component == Quantity::Component::x ? place.x : place.y;
        } else if constexpr (requires { found->x; }) {
            values.back().vector = to_double(*found);
            values.back().exact = quantity.component == Quantity::Component::x ? found->x : found->y;
        } else {
            values.back().scalar = found->to_double();
            values.back().exact = *found;
        }
    };
    std::vector<Quantity> actions;
    const auto is_reaction = [&](const Quantity& of) {
        return std::any_of(actions.begin(), actions.end(), [&](const Quantity& other) {
            return other.joint == of.joint && other.body == of.other && other.other == of.body;
        });
    };
    for_each_result(solution, [&](const Quantity& quantity, const auto& found) {
        const ResultKind& kind = result_kind(quantity);
        if (!kind.column) return;
        if constexpr (requires { found->at_infinity(); })
            if (found->at_infinity()) return;
        if (kind.subject == ResultKind::Subject::action) {
            if (!with_reactions && is_reaction(quantity)) return;
            actions.push_back(quantity);
        }
        if (kind.shape == ResultKind::Shape::scalar || kind.shape == ResultKind::Shape::along)
            return add(quantity, found);
        add(quantity.along(Quantity::Component::x), found);
        add(quantity.along(Quantity::Component::y), found);
    });
    return values;
}

std::vector<Column> columns_found(const Solution& solution, bool with_reactions) {
    std::vector<Column> columns;
    for (const FoundValue& each : found_values(solution, with_reactions))
        add_columns(each.quantity, solution.mechanism, name_in_column(each.quantity, solution), columns);
    return columns;
}

std::vector<NamedResult> named_results(const Solution& solution) {
    std::vector<NamedResult> results = Reading(solution).all();
    for (const ResultExpression& each : defined_results(solution.mechanism))
        if (auto found = value_of(each, results)) results.push_back(*std::move(found));
    return results;
}

std::vector<NamedResult> parameters_of(const Mechanism& mechanism) {
    std::vector<NamedResult> all;
    for (Column& column : parameter_columns(mechanism))
        all.push_back({std::move(column), mechanism.parameters[all.size()].value});
    return all;
}

std::optional<Exact> exact_value(const NamedResult& result, const Solution& solution) {
    const Pose& pose = solution.pose;
    const auto certain = [&](const Exact& value) {
        return pose.is_certain(value) ? std::optional(value) : std::nullopt;
    };
    const Quantity& q = result.column.quantity;
    switch (result.column.kind) {
        case Column::Kind::place_x: return certain(pose.at(q.point).x);
        case Column::Kind::place_y: return certain(pose.at(q.point).y);
        case Column::Kind::result: break;
        default: return std::nullopt;
    }
    for (const FoundValue& each : found_values(solution, true))
        if (each.quantity == q && each.exact) return certain(*each.exact);
    return std::nullopt;
}

Error missing_result(const Solution& solution, const std::vector<NamedResult>& results, const std::string& name,
                     const std::string& where) {
    for (const std::string& text :
         solution.mechanism.exercise ? solution.mechanism.exercise->expressions : std::vector<std::string>())
        if (named_expression(text).name == name && solution.unsolved.empty())
            if (auto found = result_of_expression(text, results); !found)
                return {ErrorCode::no_unique_answer, where, std::move(found.error().message)};
    if (auto why = why_infinite(solution, results, name)) return {ErrorCode::no_unique_answer, where, *std::move(why)};
    if (!solution.unsolved.empty())
        return {ErrorCode::no_unique_answer, where, {lang::positions::is_not_found_in_this_position, quoted(name)}};
    Speller speller;
    std::vector<std::string_view> names;
    for (const NamedResult& each : results) names.emplace_back(each.column.name);
    return {ErrorCode::bad_input,
            where,
            {lang::positions::there_is_no_result_what, quoted(name), did_you_mean(speller.nearest(name, names))}};
}

namespace {

std::vector<Column> columns_of(const std::vector<NamedResult>& results) {
    std::vector<Column> columns;
    for (const NamedResult& each : results) {
        columns.push_back(each.column);
        columns.back().si_unit = each.unit;
    }
    return columns;
}

}  // namespace

tl::expected<NamedResult, Error> result_of_expression(std::string_view text, const std::vector<NamedResult>& results) {
    const auto read = ResultExpression::read(text, columns_of(results));
    if (!read) return tl::unexpected(Error{ErrorCode::bad_input, "", read.error()});
    auto value = value_of(*read, results);
    if (!value)
        return tl::unexpected(
            Error{ErrorCode::no_unique_answer, "", Words(lang::positions::is_not_determined, quoted(text))});
    return *std::move(value);
}

std::optional<NamedResult> least_transmission_angle(const Solution& solution) {
    const auto travel = own_travel(solution.mechanism, solution.pose);
    if (!travel) return std::nullopt;
    const auto found = transmission_of(solution.mechanism, travel->first, 0, travel->second);
    if (!found) return std::nullopt;
    NamedResult result{transmission_column(), found->least};
    result.column.quantity = {.body = found->driven, .other = found->coupler, .joint = found->pin};
    return result;
}

std::vector<NamedResult> results_for(const Exercise& exercise, const Solution& solution) {
    std::vector<NamedResult> results = named_results(solution);
    const auto is_it = [](const std::string& name) { return name.find(transmission_angle_name) != std::string::npos; };
    const bool wanted = std::any_of(exercise.ask.begin(), exercise.ask.end(),
                                    [&](const AskedResult& each) { return is_it(each.name); }) ||
                        std::any_of(exercise.require.begin(), exercise.require.end(), [&](const Condition& each) {
                            return is_it(each.left.result) || is_it(each.right.result) || is_it(each.upper.result);
                        });
    if (wanted || std::any_of(exercise.expressions.begin(), exercise.expressions.end(), is_it))
        if (auto found = least_transmission_angle(solution)) results.push_back(*std::move(found));
    if (!exercise.expressions.empty())
        for (NamedResult& each : parameters_of(solution.mechanism)) results.push_back(std::move(each));
    for (const std::string& text : exercise.expressions)
        if (result_named(results, text) == nullptr)
            if (auto found = result_of_expression(text, results)) results.push_back(*std::move(found));
    return results;
}

namespace {

NamedResult as_asked(const Solution& solution, NamedResult result) {
    const auto quantity = solution.truss ? bar_of(result.column, solution.mechanism) : std::nullopt;
    if (!quantity) return result;
    const std::vector<TrussStructure::Bar>& bars = solution.truss->structure.bars;
    const auto bar =
        std::find_if(bars.begin(), bars.end(), [&](const auto& each) { return each.body == quantity->body; });
    result.column.quantity = *quantity;
    result.value = solution.truss->tension(static_cast<std::size_t>(bar - bars.begin()), solution.pose.points);
    return result;
}

}  // namespace

Result<std::vector<NamedResult>> asked_of_results(const Solution& solution, const std::vector<NamedResult>& results) {
    std::vector<NamedResult> asked;
    Errors errors;
    for (const AskedResult& each : asked_of(solution.mechanism)) {
        if (const NamedResult* found = result_named(results, each.name))
            asked.push_back(as_asked(solution, *found));
        else
            errors.push_back(missing_result(solution, results, each.name, each.where));
    }
    if (!errors.empty()) return tl::unexpected(std::move(errors));
    return asked;
}

Result<std::vector<NamedResult>> asked_results(const Solution& solution) {
    if (!solution.mechanism.exercise) return std::vector<NamedResult>();
    return asked_of_results(solution, results_for(*solution.mechanism.exercise, solution));
}

ToldResult told(const NamedResult& result, const Units& units) {
    if (!result.unit.empty()) return {result.value, result.unit};
    const Unit unit = unit_of(result.column.unit, units);
    return {result.value / unit.si.to_double(), unit.symbol == "deg" ? "°" : unit.symbol};
}

}  // namespace kinegraph
