// Solved: named results, sentences and documents of a solution.
#include <algorithm>
#include <utility>

#include "app/library/state.hpp"
#include "engine/equations/equations.hpp"
#include "engine/results/quantity_name.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/results.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/library.hpp"
#include "render/equations/chapters.hpp"
#include "render/equations/equation_text.hpp"
#include "render/figures/figure.hpp"
#include "render/sheet/sheet.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

template class Shared<const Solved::State>;

Solved::State::State(Solution found, std::optional<SourceFile> file, std::vector<NamedResult> results)
    : solution(std::move(found)), source(std::move(file)), asked(std::move(results)) {}

Solved solved(Solution solution, std::optional<SourceFile> source, std::vector<NamedResult> asked) {
    return Solved(
        Shared<const Solved::State>(new Solved::State(std::move(solution), std::move(source), std::move(asked))));
}

namespace {

/// Why Joukowsky's lever cannot be drawn; none if it can.
std::optional<Text> why_no_lever(const Solution& solution) {
    switch (render::no_lever(solution)) {
        case render::NoLever::drawn: break;
        case render::NoLever::no_forces: return text_of(Words(lang::library::no_forces_act_or_none));
        case render::NoLever::no_velocities:
            return text_of(Words(lang::library::forces_have_powers_only_where_something));
        case render::NoLever::nothing_moves: return text_of(Words(lang::library::no_force_acts_at_a_point));
    }
    return std::nullopt;
}

std::optional<ExactNumber> exact_of(const Exact& value) {
    ExactNumber number{value.to_fraction(), "1", value.to_double()};
    const std::size_t slash = number.numerator.find('/');
    if (slash != std::string::npos) {
        number.denominator = number.numerator.substr(slash + 1);
        number.numerator.resize(slash);
    }
    return number;
}

}  // namespace

ResultValue value_of(const NamedResult& result, const Solution& solution) {
    const ToldResult as_told = told(result, solution.mechanism.units);
    ResultValue value{result.column.name, result.value, as_told.value, as_told.unit, std::nullopt};
    if (const auto exact = exact_value(result, solution)) value.exact = exact_of(*exact);
    return value;
}

std::vector<ResultValue> Solved::values() const {
    std::vector<ResultValue> all;
    for (const NamedResult& each : named_results(state().solution)) all.push_back(value_of(each, state().solution));
    return all;
}

std::optional<ResultValue> Solved::value(std::string_view name) const {
    const std::vector<NamedResult> all = named_results(state().solution);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const NamedResult& each) { return each.column.name == name; });
    if (found == all.end()) return std::nullopt;
    return value_of(*found, state().solution);
}

Expected<ResultValue> Solved::evaluate(std::string_view expression) const {
    const Solution& solution = state().solution;
    const std::string text(expression);
    const auto& exercise = solution.mechanism.exercise;
    std::vector<NamedResult> all = exercise ? results_for(*exercise, solution) : named_results(solution);
    if (const NamedResult* const found = result_named(all, text)) return value_of(*found, solution);
    for (NamedResult& each : parameters_of(solution.mechanism))
        if (result_named(all, each.column.name) == nullptr) all.push_back(std::move(each));
    if (!is_expression(text)) return tl::unexpected(diagnostics_of({missing_result(solution, all, text, "")}));
    const auto found = result_of_expression(text, all);
    if (!found) return tl::unexpected(diagnostics_of({found.error()}));
    return value_of(*found, solution);
}

std::optional<std::array<double, 2>> Solved::vector(std::string_view name) const {
    if (name.empty()) return std::nullopt;
    // The components of "v B" are "vx B" and "vy B". (Where the point B slides, "v B" itself is the sliding's.)
    const std::vector<NamedResult> all = named_results(state().solution);
    std::array<double, 2> components{};
    for (std::size_t i = 0; i < components.size(); ++i) {
        const std::string component = std::string(name).insert(1, i == 0 ? "x" : "y");
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const NamedResult& each) { return each.column.name == component; });
        if (found == all.end()) return std::nullopt;
        components[i] = found->value;
    }
    return components;
}

std::vector<Text> Solved::statements() const {
    std::vector<Text> all;
    for (const Statement& each : state().solution.protocol.statements) all.push_back(text_of(each.message));
    return all;
}

std::vector<Solved::Missing> Solved::unsolved(Remedies remedies) const {
    return missing_of(state().solution.unsolved, remedies);
}

std::vector<Text> Solved::remarks(Remedies remedies) const {
    std::vector<Text> all;
    for (const Message& each : state().solution.remarks) all.push_back(text_of(each, remedies));
    const Solution& solution = state().solution;
    if (solution.problem)
        for (const Words& each : solution.problem->remarks) all.push_back(text_of(each));
    if (solution.contacts)
        for (const Words& each : solution.contacts->remarks) all.push_back(text_of(each));
    return all;
}

Text Solved::title() const { return text_of(state().solution.mechanism.title); }
Text Solved::subject() const {
    const auto& problem = state().solution.problem;
    return problem ? text_of(problem->subject) : Text{};
}

std::optional<Text> Solved::why_without(Addition addition) const {
    const Solution& solution = state().solution;
    const auto reason = [](const auto& found, const Words& without_joints) -> std::optional<Text> {
        if (!found) return text_of(without_joints);
        return found->why_not.empty() ? std::nullopt : std::optional(text_of(found->why_not));
    };
    switch (addition) {
        case Addition::lever: return why_no_lever(solution);
        case Addition::equations: return reason(solution.equations, {lang::library::a_problem_in_place_of_joints});
        case Addition::virtual_work:
            return reason(solution.displacements, {lang::library::a_problem_in_place_of_joints_has});
    }
    return std::nullopt;
}

std::vector<CheckedValue> Solved::checks() const {
    std::vector<CheckedValue> all;
    for (const CheckRow& row : state().solution.checks)
        all.push_back({name_of(row.quantity, state().solution), row.graphical, row.numeric, row.difference});
    return all;
}

std::string Solved::json(bool exact) const { return results_json(state().solution, exact, render::in_english); }

std::string Solved::table(Language language) const { return render::results_table(state().solution, language); }

Expected<std::string> Solved::equations(Language language) const {
    const Solution& solution = state().solution;
    if (!solution.equations)
        return refused(Diagnostic::Kind::bad_input, {lang::library::the_closure_equations_were_not_asked});
    if (!solution.equations->why_not.empty())
        return refused(Diagnostic::Kind::bad_input, Words(lang::common::no_equations, solution.equations->why_not));
    return render::as_text(render::equation_items(solution, language));
}

}  // namespace kinegraph
