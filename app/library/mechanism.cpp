// MechanismFile: reads, checks and solves mechanism files.
#include <string>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/limits.hpp"
#include "app/library/problem_kinds.hpp"
#include "app/library/state.hpp"
#include "constructions/kinematics/degeneracy.hpp"
#include "constructions/positions/conditions.hpp"
#include "constructions/solving/solve.hpp"
#include "constructions/verdicts/verdicts.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/equations/equations.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/reading/file_text.hpp"
#include "engine/reading/forms.hpp"
#include "engine/results/results.hpp"
#include "engine/solution/problem_kind.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/library.hpp"
#include "render/equations/equation_text.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph {

template class Shared<const MechanismFile::State>;

namespace {

render::TextForm form_of(TextForm form) {
    switch (form) {
        case TextForm::markdown: return render::TextForm::markdown;
        case TextForm::json: return render::TextForm::json;
        case TextForm::plain:
        case TextForm::latex:
        case TextForm::formulas: break;
    }
    return render::TextForm::plain;
}

std::string printed(const std::vector<render::EquationItem>& items, TextForm form) {
    if (form == TextForm::formulas) return render::as_formulas(items);
    return form == TextForm::latex ? render::as_latex(items) : render::as_text(items);
}

/// Remarks on the file's exercise, with the file's own values: missing results, and conditions that are not fulfilled.
Expected<std::vector<Text>> check_exercise(const Mechanism& mechanism) {
    std::vector<Text> remarks;
    if (!mechanism.exercise) return remarks;
    const auto solution = solve(mechanism);
    if (!solution) return tl::unexpected(diagnostics_of(solution.error()));
    const std::vector<NamedResult> results = results_for(*mechanism.exercise, *solution);
    if (const Errors missing = missing_in(*solution, results); !missing.empty())
        return tl::unexpected(diagnostics_of(missing));
    for (const Condition& each : mechanism.exercise->require) {
        if (each.kind == Condition::Kind::polygon_readable) continue;  // needs a drawing
        Result<bool> fits = true;
        if (each.kind == Condition::Kind::crank_turns_fully)
            fits = crank_turns_fully(mechanism, solution->pose);
        else
            fits = each.holds ? *each.holds : holds(each, *solution, results);
        if (!fits) return tl::unexpected(diagnostics_of(fits.error()));
        if (!*fits) remarks.push_back(text_of(Words(lang::library::does_not_hold_with_the_file, quoted(each.text))));
    }
    return remarks;
}

/// The mechanism with what the options ask for besides.
Mechanism with_wishes(Mechanism mechanism, const SolveOptions& options) {
    if (options.equations) mechanism.find.equations = true;
    if (options.virtual_work) mechanism.find.virtual_work = true;
    return mechanism;
}
Arithmetic arithmetic_of(const SolveOptions& options) {
    return options.sentences ? Arithmetic::told : Arithmetic::left_out;
}

}  // namespace

Expected<MechanismFile> MechanismFile::parse(std::string_view text, std::string name,
                                             const std::vector<ParameterValue>& set) {
    std::vector<Setting> settings = settings_of(set);
    auto mechanism = read_mechanism(text, name, settings);
    if (!mechanism) return tl::unexpected(diagnostics_of(mechanism.error()));
    return MechanismFile(Shared<const State>(
        new State{{}, std::string(text), std::move(name), std::move(settings), *std::move(mechanism)}));
}

Expected<MechanismFile> MechanismFile::open(const std::string& path, const std::vector<ParameterValue>& set) {
    const auto text = read_file(path, {lang::common::mechanism_file});
    if (!text) return tl::unexpected(text.error());
    return parse(*text, path.substr(path.rfind('/') + 1), set);
}

Text MechanismFile::title() const { return text_of(state().mechanism.title); }
bool MechanismFile::has_joints() const { return !stands_for_joints(state().mechanism); }

bool MechanismFile::has_equations() const {
    return has_joints() || app::equations_of_problem(state().mechanism) != nullptr;
}
MechanismFile::Counts MechanismFile::counts() const {
    const Mechanism& mechanism = state().mechanism;
    return {mechanism.bodies.size(), mechanism.joints.size(), mechanism.drivers.size()};
}

Expected<std::vector<Text>> MechanismFile::check(Remedies remedies) const {
    const Mechanism& mechanism = state().mechanism;
    const auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(diagnostics_of(pose.error()));
    auto remarks = check_exercise(mechanism);
    if (!remarks) return remarks;
    if (stands_for_joints(mechanism)) {
        const auto solution = kinegraph::solve(mechanism);
        if (!solution) return tl::unexpected(diagnostics_of(solution.error()));
        for (const Words& each : solution->problem->remarks) remarks->push_back(text_of(each));
        return remarks;
    }
    std::vector<Message> found = pose->remarks;
    for (Message& each : remarks_on_lengths(mechanism, *pose)) found.push_back(std::move(each));
    for (Message& each : likely_mistakes(mechanism, *pose, mobility_of(mechanism, *pose)))
        found.push_back(std::move(each));
    for (const Message& each : found) remarks->push_back(text_of(each, remedies));
    return remarks;
}

Expected<Solved> MechanismFile::solve(const SolveOptions& options) const {
    Mechanism mechanism = with_wishes(state().mechanism, options);
    if (const auto beyond = app::beyond_solving(mechanism)) return tl::unexpected(diagnostics_of({*beyond}));
    auto solution = kinegraph::solve(std::move(mechanism), arithmetic_of(options));
    if (!solution) return tl::unexpected(diagnostics_of(solution.error()));
    if (const Errors missing = missing_in(*solution); !missing.empty()) return tl::unexpected(diagnostics_of(missing));
    return solved(*std::move(solution), SourceFile{state().text, state().name, state().set});
}

Expected<std::vector<Solved>> MechanismFile::solve_at(const PositionsWanted& positions,
                                                      const SolveOptions& options) const {
    if (!has_joints()) return refused(Diagnostic::Kind::bad_input, {lang::library::the_file_states_a_problem});
    const Mechanism mechanism = with_wishes(state().mechanism, options);
    if (const auto beyond = app::beyond_solving(mechanism)) return tl::unexpected(diagnostics_of({*beyond}));
    auto solutions = app::solved_positions(mechanism, positions, arithmetic_of(options));
    if (!solutions) return tl::unexpected(diagnostics_of(solutions.error()));
    std::vector<Solved> all;
    for (Solution& each : *solutions) {
        if (const Errors missing = missing_in(each); !missing.empty()) return tl::unexpected(diagnostics_of(missing));
        all.push_back(solved(std::move(each)));
    }
    return all;
}

Expected<std::string> MechanismFile::pairs(TextForm form, Language language) const {
    const Mechanism& mechanism = state().mechanism;
    if (stands_for_joints(mechanism))
        return refused(Diagnostic::Kind::bad_input, {lang::library::the_file_states_a_problem_in_place});
    const auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(diagnostics_of(pose.error()));
    const Mobility mobility = mobility_of(mechanism, *pose);
    return render::pair_report(mechanism, mobility,
                               remarks_on_mobility(mechanism, mobility, degenerate_motion(mechanism, *pose, mobility)),
                               language, form_of(form));
}

Expected<std::string> MechanismFile::equations(TextForm form, Language language) const {
    Mechanism mechanism = state().mechanism;
    const app::EquationsOfProblem of_problem = app::equations_of_problem(mechanism);
    mechanism.find.equations = of_problem == nullptr;
    if (const auto beyond = app::beyond_solving(mechanism)) return tl::unexpected(diagnostics_of({*beyond}));
    const auto solution = kinegraph::solve(std::move(mechanism));
    if (!solution) return tl::unexpected(diagnostics_of(solution.error()));
    JsonWriter json;
    json.open('{', JsonWriter::Entries::on_lines);
    if (of_problem != nullptr) {
        if (form != TextForm::json) return printed(of_problem(*solution, language), form);
        const ProblemKind& kind = *solution->mechanism.problem->kind;
        json.key(kind.key);
        kind.results(*solution, false, json);
        return json.close().take() + '\n';
    }
    if (!solution->equations)
        return refused(Diagnostic::Kind::bad_input, {lang::library::a_problem_in_place_of_joints});
    if (!solution->equations->why_not.empty())
        return refused(Diagnostic::Kind::bad_input, Words(lang::common::no_equations, solution->equations->why_not));
    if (form == TextForm::json) {
        write_equations(*solution->equations, json.key("equations"));
        return json.close().take() + '\n';
    }
    return printed(render::equation_items(*solution, language), form);
}

std::string pair_catalogue(TextForm form, Language language) { return render::pair_catalogue(language, form_of(form)); }

std::string_view mechanism_schema() {
    static const std::string schema = json_schema_of(forms::mechanism());
    return schema;
}

}  // namespace kinegraph
