// check FILE: reads and validates a mechanism file, including curves that cannot meet, and reports likely mistakes.
#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "constructions/kinematics/degeneracy.hpp"
#include "constructions/positions/conditions.hpp"
#include "constructions/solving/solve.hpp"
#include "constructions/verdicts/verdicts.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {

Words spoken(const std::string& file) {
    return file == "-" ? Words("standard input", "ingresso standard") : Words(file);
}

std::string bare_name(const std::string& file) {
    const std::string name = spoken(file).en;
    return name.substr(name.rfind('/') + 1);
}

tl::expected<Mechanism, Status> mechanism_of(const std::string& file, Language language, std::span<const Setting> set) {
    const auto text = read_whole(file, {"mechanism file", "file di meccanismo"});
    if (!text) {
        say(spoken(file), text.error(), language);
        return tl::unexpected(Status::bad_input);
    }
    auto mechanism = read_mechanism(*text, bare_name(file), set);
    if (!mechanism) return tl::unexpected(say(spoken(file), mechanism.error(), language));
    return *std::move(mechanism);
}

Words no_mechanism(const char* command) {
    return {
        "{0} is for mechanisms; this file has no joints, and \"solve\", \"check\" and \"variants\" alone "
        "take it",
        "{0} è per i meccanismi; questo file non ha coppie, e lo prendono solo \"solve\", \"check\" e \"variants\"",
        std::string(command)};
}

namespace {

/// Checks what an exercise asks for against its own values: an error if there is no such result, a remark if a
/// condition does not hold. Needs no polygons.
std::optional<Status> check_exercise(const Mechanism& mechanism, const Words& name, Language language) {
    if (!mechanism.exercise) return std::nullopt;
    const auto solution = solve(mechanism);
    if (!solution) return say(name, solution.error(), language);
    const std::vector<NamedResult> results = results_for(*mechanism.exercise, *solution);
    if (const Errors missing = missing_in(*solution, results); !missing.empty()) return say(name, missing, language);
    for (const Condition& each : mechanism.exercise->require) {
        Result<bool> fits = true;
        if (each.kind == Condition::Kind::crank_turns_fully)
            fits = crank_turns_fully(mechanism, solution->pose);
        else if (each.kind != Condition::Kind::polygon_readable)
            fits = each.holds ? *each.holds : holds(each, *solution, results);
        if (!fits) return say(name, fits.error(), language);
        if (!*fits)
            say(name,
                Words(render::word("a remark", language) + ": ") + Words("{0} does not hold with the file’s own values",
                                                                         "{0} non vale con i valori propri del file",
                                                                         quoted(each.text)),
                language);
    }
    return std::nullopt;
}

/// Remarks that need the solution: numbers too far apart, bodies that separate.
Status check_problem(const Mechanism& mechanism, const Words& name, Language language) {
    const auto solution = solve(mechanism);
    if (!solution) return say(name, solution.error(), language);
    for (const Words& remark : solution->problem->remarks)
        say(name, Words(render::word("a remark", language) + ": " + in(remark, language)), language);
    const Words line("{0}: in order ({1})\n", "{0}: in ordine ({1})\n", one_line(in(name, language)),
                     solution->problem->subject);
    return print(in(line, language), language);
}

}  // namespace

Status check_command(const CheckRequest& request) {
    const Language language = request.language;
    const Words name = spoken(request.file);
    const auto mechanism = mechanism_of(request.file, language, request.set);
    if (!mechanism) return mechanism.error();
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(name, pose.error(), language);
    if (const auto status = check_exercise(*mechanism, name, language)) return *status;
    if (stands_for_joints(*mechanism)) return check_problem(*mechanism, name, language);
    std::vector<Message> remarks = pose->remarks;
    for (Message& each : remarks_on_lengths(*mechanism, *pose)) remarks.push_back(std::move(each));
    for (Message& each : likely_mistakes(*mechanism, *pose, mobility_of(*mechanism, *pose)))
        remarks.push_back(std::move(each));
    for (const Message& remark : remarks)
        say(name, Words(render::word("a remark", language) + ": " + render::tell(remark, language)), language);
    const auto counted = [](std::size_t count, const Words& one, const Words& more) {
        return Words(std::to_string(count) + ' ') + (count == 1 ? one : more);
    };
    const std::size_t bodies = mechanism->bodies.size();
    const Words line(
        "{0}: in order ({1}, {2}, {3})\n", "{0}: in ordine ({1}, {2}, {3})\n", one_line(in(name, language)),
        bodies == 1 ? Words("one body", "un corpo") : counted(bodies, {"body", "corpo"}, {"bodies", "corpi"}),
        counted(mechanism->joints.size(), {"joint", "coppia"}, {"joints", "coppie"}),
        counted(mechanism->drivers.size(), {"driver", "movente"}, {"drivers", "moventi"}));
    return print(in(line, language), language);
}

}  // namespace kinegraph::app
