// solve FILE: reads, solves, draws and writes all outputs or none.
#include "app/commands/solved.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/library/requested_results.hpp"
#include "app/library/solved_positions.hpp"
#include "constructions/moving/moving.hpp"
#include "constructions/positions/conditions.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/equations/equations.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/live/live_page.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/handout.hpp"
#include "render/sheet/steps.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

/// Why Joukowsky's lever cannot be drawn; empty if it can.
Words why_no_lever(const Solution& solution) {
    switch (render::no_lever(solution)) {
        case render::NoLever::drawn: return {};
        case render::NoLever::no_forces:
            return {"no forces act, or none are asked for", "nessuna forza agisce o è richiesta"};
        case render::NoLever::no_velocities:
            return {"forces have powers only where something is driven and its velocities are known",
                    "le forze hanno potenza solo dove qualcosa è comandato e le sue velocità sono note"};
        case render::NoLever::nothing_moves:
            return {"no force acts at a point that moves", "nessuna forza agisce in un punto che si muove"};
    }
    return {};
}

/// The first option of the request that needs a mechanism; null if none does.
const char* asked_of_mechanisms(const SolveRequest& request) {
    if (!request.at.empty()) return "solve --at";
    if (request.grid) return "solve --grid";
    return request.detail == render::SolutionDetail::brief ? "solve --detail" : nullptr;
}

tl::expected<Mechanism, Status> mechanism_of(const SolveRequest& request) {
    auto mechanism = read_mechanism(*request.text, bare_name(request.file), request.set);
    if (!mechanism) return tl::unexpected(say(spoken(request.file), mechanism.error(), request.language));
    return *std::move(mechanism);
}

bool wants(const SolveRequest& request, const char* what) {
    return std::find(request.with.begin(), request.with.end(), what) != request.with.end();
}
/// Reads and solves the file; a status after an error was reported.
tl::expected<std::vector<Solution>, Status> solutions_of(const SolveRequest& request, Arithmetic arithmetic) {
    auto mechanism = mechanism_of(request);
    if (!mechanism) return tl::unexpected(mechanism.error());
    if (const char* const what = asked_of_mechanisms(request); stands_for_joints(*mechanism) && what != nullptr) {
        say(spoken(request.file), no_mechanism(what), request.language);
        return tl::unexpected(Status::bad_input);
    }
    if (wants(request, "equations")) mechanism->find.equations = true;
    if (wants(request, "virtual work")) mechanism->find.virtual_work = true;
    if (!request.at.empty()) {
        auto solutions = solved_positions(*mechanism, {request.at, request.driver, request.branch}, arithmetic, "--");
        if (!solutions) return tl::unexpected(say(spoken(request.file), solutions.error(), request.language));
        return *std::move(solutions);
    }
    auto solution = solve(*std::move(mechanism), arithmetic);
    if (!solution) return tl::unexpected(say(spoken(request.file), solution.error(), request.language));
    std::vector<Solution> solutions;
    solutions.push_back(*std::move(solution));
    return solutions;
}

bool wants_lever(const SolveRequest& request) { return wants(request, "joukowsky"); }

render::SheetOptions options_of(const SolveRequest& request, const render::Theme& theme) {
    render::SheetOptions options;
    options.paper = request.paper;
    options.language = request.language;
    options.dimensions = request.dimensions;
    options.joukowsky = wants_lever(request) || !request.figure.empty();
    options.orientation = request.orientation;
    options.author = request.author;
    options.date = request.date;
    options.theme = theme;
    options.detail = request.detail;
    options.kind = request.sheet;
    options.grid = request.grid;
    return options;
}

/// The sheet, its steps or one figure; adds its remarks to `remarks`. A status after reporting that there is no such
/// figure.
tl::expected<std::vector<render::Page>, Status> pages_of(const Solution& solution, const render::Theme& theme,
                                                         const SolveRequest& request, const render::Fonts& fonts,
                                                         std::vector<std::string>& remarks) {
    const render::SheetOptions options = options_of(request, theme);
    if (request.sheet == render::SheetKind::answers && !stands_for_joints(solution.mechanism)) {
        render::Key key = render::lay_out_key_of(solution, requested_results(solution), options, fonts);
        for (const render::RichText& remark : key.remarks) remarks.push_back(render::plain(remark));
        return std::move(key.pages);
    }
    if (request.steps) return render::lay_out_steps(solution, options, fonts);
    if (request.sheet == render::SheetKind::question && !stands_for_joints(solution.mechanism))
        return render::lay_out_handout(solution, options, fonts, requested_results(solution));
    if (request.figure.empty()) return render::lay_out(solution, options, fonts);
    if (auto page = render::lay_out_alone(solution, options, request.figure, fonts))
        return std::vector{*std::move(page)};
    std::string names;
    for (const std::string& each : render::figure_names(solution, options, fonts))
        names += (names.empty() ? "" : ", ") + each;
    say(spoken(request.file),
        {"--figure {0}: there is no such figure; there are {1}", "--figure {0}: non c’è questa figura; ci sono {1}",
         request.figure, names},
        request.language);
    return tl::unexpected(Status::bad_input);
}

/// The message for options that contradict each other; empty if there are none.
Words meaningless(const SolveRequest& request) {
    const bool solution = request.sheet == render::SheetKind::solution,
               brief = request.detail == render::SolutionDetail::brief;
    const char* const sheet = request.sheet == render::SheetKind::question ? "question" : "answers";
    const auto both = [](const std::string& one, const std::string& other) {
        return Words("{0} and {1} exclude each other: leave one of them out",
                     "{0} e {1} si escludono: togliere una delle due", one, other);
    };
    const std::string kind = std::string("--sheet ") + sheet;
    if (request.grid && request.sheet != render::SheetKind::question)
        return {"--grid is for the question: add --sheet question",
                "--grid è per la domanda: aggiungere --sheet question"};
    if (!solution && brief) return both(kind, "--detail brief");
    if (!request.figure.empty() && (!solution || brief)) return both("--figure", solution ? "--detail brief" : kind);
    if (request.steps && (!solution || brief)) return both("--steps", solution ? "--detail brief" : kind);
    if (!solution && wants_lever(request)) return both("--with joukowsky", kind);
    if (!solution && wants(request, "equations")) return both("--with equations", kind);
    if (!solution && wants(request, "virtual work")) return both("--with \"virtual work\"", kind);
    if (request.sheet == render::SheetKind::question && request.dimensions == render::Dimensions::on)
        return both("--dimensions on", kind);
    return {};
}

/// The same for a live page, which is always the whole solution, step by step.
Words meaningless_on_page(const SolveRequest& request, const std::vector<Target>& targets) {
    if (std::none_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_page(); })) return {};
    const char* const other = !request.figure.empty()                        ? "--figure"
                              : request.steps                                ? "--steps"
                              : request.sheet != render::SheetKind::solution ? "--sheet"
                                                                             : nullptr;
    if (other == nullptr) return {};
    return {
        "{0} has no meaning for a live page, which has every figure and every step: ask for .html in a run of its own",
        "{0} non ha senso per una pagina viva, che ha ogni figura e ogni passo: chiedere .html in un comando a parte",
        std::string(other)};
}

/// Reports options that have no effect.
void remark_on_request(const SolveRequest& request, const Solution& solution, const std::vector<Target>& targets,
                       std::vector<std::string>& remarks) {
    const auto is_json = [](const Target& target) { return target.format == Format::json; };
    const bool draws = !std::all_of(targets.begin(), targets.end(), is_json);
    const auto remark = [&](const Words& words) { remarks.push_back(in(words, request.language)); };
    if (wants_lever(request)) {
        if (const Words why = why_no_lever(solution); !why.empty())
            remark({"no lever: {0}", "nessuna leva: {0}", why});
        else if (!draws)
            remark({"--with joukowsky adds to the sheet only, and none is asked for",
                    "--with joukowsky aggiunge solo al foglio, e nessuno è richiesto"});
    }
    if (wants(request, "equations") && (!solution.equations || !solution.equations->why_not.empty()))
        remark({"no equations: {0}", "nessuna equazione: {0}",
                solution.equations ? solution.equations->why_not
                                   : Words("a problem in place of joints has no loops",
                                           "un problema al posto delle coppie non ha maglie")});
    if (wants(request, "virtual work") && (!solution.displacements || !solution.displacements->why_not.empty()))
        remark({"no virtual work: {0}", "niente lavori virtuali: {0}",
                solution.displacements ? solution.displacements->why_not
                                       : Words("a problem in place of joints has no bodies that are displaced",
                                               "un problema al posto delle coppie non ha corpi da spostare")});
    if (!request.figure.empty() && !draws)
        remark({"--figure chooses what is drawn, and no drawing is asked for",
                "--figure sceglie che cosa si disegna, e nessun disegno è richiesto"});
    const auto can_live = [](const Target& target) {
        return target.format == Format::svg || target.format == Format::pdf;
    };
    if (request.live_text && std::none_of(targets.begin(), targets.end(), can_live))
        remark({"--text says how SVG and PDF carry their words, and neither is asked for",
                "--text dice come SVG e PDF portano le loro parole, e nessuno dei due è richiesto"});
    if (request.steps && !draws)
        remark({"--steps adds pages to what is drawn, and no drawing is asked for",
                "--steps aggiunge pagine al disegno, e nessun disegno è richiesto"});
    if (request.sheet != render::SheetKind::solution && !draws)
        remark({"--sheet chooses what is drawn, and no drawing is asked for",
                "--sheet sceglie che cosa si disegna, e nessun disegno è richiesto"});
    if (request.detail == render::SolutionDetail::brief && !draws)
        remark({"--detail says how much is drawn, and no drawing is asked for",
                "--detail dice quanto si disegna, e nessun disegno è richiesto"});
    if (request.exact && std::none_of(targets.begin(), targets.end(), is_json))
        remark({"--exact adds to the JSON results only, and none are asked for",
                "--exact aggiunge solo ai risultati JSON, e nessuno è richiesto"});
}

std::string live_page(const Solution& solution, const render::Theme& theme, const SolveRequest& request,
                      const render::Fonts& fonts) {
    // In a requested position the page cannot change parameters: they apply to the position of the file.
    const Rereading file =
        request.at.empty() ? rereading_of(*request.text, bare_name(request.file), request.set) : Rereading{};
    return render::live_page(solution, moving_of(solution, file), options_of(request, theme),
                             dark_beside(request.theme), fonts);
}

/// The table for the terminal, or the bytes of all targets. Adds to `remarks`.
tl::expected<std::vector<Output>, Status> made(const std::vector<Solution>& solutions,
                                               const std::vector<Target>& targets, const render::Theme& theme,
                                               const SolveRequest& request, std::optional<OutputWriter>& press,
                                               std::vector<std::string>& remarks) {
    std::vector<Output> outputs;
    if (targets.empty()) {
        std::string tables;
        for (const Solution& solution : solutions)
            tables += (tables.empty() ? "" : "\n") + render::results_table(solution, request.language);
        return std::vector<Output>{{"-", std::move(tables)}};
    }
    std::vector<render::Page> pages;
    const bool draws =
        std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
    if (draws) {
        const auto ready =
            OutputWriter::prepare(press, request.language, request.live_text ? Lettering::live : Lettering::outlines);
        if (!ready) return tl::unexpected(ready.error());
        const bool lays_out = std::any_of(targets.begin(), targets.end(),
                                          [](const Target& target) { return target.is_drawn() && !target.is_page(); });
        for (const Solution& solution : solutions) {
            if (!lays_out) break;
            auto more = pages_of(solution, theme, request, press->fonts(), remarks);
            if (!more) return tl::unexpected(more.error());
            std::move(more->begin(), more->end(), std::back_inserter(pages));
        }
        if (const auto able = press->prepare_to_print(targets); !able) return tl::unexpected(able.error());
    }
    for (const Target& target : targets) {
        if (target.is_page()) {
            for (std::size_t i = 0; i < solutions.size(); ++i)
                if (i == 0 || !target.standard())
                    outputs.push_back(
                        {target.path_of_page(i), live_page(solutions[i], theme, request, press->fonts())});
            continue;
        }
        if (target.is_drawn()) {
            press->print(pages, target, request.dpi, outputs, remarks);
            continue;
        }
        for (std::size_t i = 0; i < solutions.size(); ++i)
            if (i == 0 || !target.standard())
                outputs.push_back(
                    {target.path_of_page(i), results_json(solutions[i], request.exact, render::in_english)});
        if (target.standard() && solutions.size() > 1)
            remarks.push_back(in({"standard output carries the first position only; -o with a name writes them all",
                                  "l’uscita standard porta solo la prima posizione; -o con un nome le scrive tutte"},
                                 request.language));
    }
    if (draws) press->remark_missing(remarks);
    return outputs;
}

}  // namespace

namespace {

/// A file that asks for a result that it does not have is an error, as in `check` and `variants`. A result without a
/// unique value in this position is reported with the solution.
std::optional<Status> refused_exercise(const std::vector<Solution>& solutions, const SolveRequest& request) {
    for (const Solution& solution : solutions)
        if (const Errors missing = missing_in(solution); !missing.empty())
            return say(spoken(request.file), missing, request.language);
    return std::nullopt;
}

}  // namespace

tl::expected<Solved, Status> solved(const SolveRequest& request, const std::vector<Target>& targets,
                                    const render::Theme& theme, std::optional<OutputWriter>& press) {
    const Language language = request.language;
    if (const Words fault = meaningless(request); !fault.empty()) return tl::unexpected(refuse(fault, language));
    if (!request.text) {
        auto text = read_whole(request.file, {"mechanism file", "file di meccanismo"});
        if (!text) {
            say(spoken(request.file), text.error(), language);
            return tl::unexpected(Status::bad_input);
        }
        SolveRequest read = request;
        read.text = *std::move(text);
        return solved(read, targets, theme, press);
    }
    const bool tells =
        std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
    const auto solutions = solutions_of(request, tells ? Arithmetic::told : Arithmetic::left_out);
    if (!solutions) return tl::unexpected(solutions.error());
    if (const auto status = refused_exercise(*solutions, request)) return tl::unexpected(*status);

    Solved found;
    const auto tell = [&](const Message& message) { return render::tell(message, language); };
    const auto add = [&](std::string remark) {
        if (std::find(found.remarks.begin(), found.remarks.end(), remark) == found.remarks.end())
            found.remarks.push_back(std::move(remark));
    };
    for (const Solution& solution : *solutions) {
        for (const Message& remark : solution.remarks) add(tell(remark));
        if (solution.problem)
            for (const Words& remark : solution.problem->remarks) add(in(remark, language));
    }
    auto outputs = made(*solutions, targets, theme, request, press, found.remarks);
    if (!outputs) return tl::unexpected(outputs.error());
    found.outputs = *std::move(outputs);
    remark_on_request(request, solutions->front(), targets, found.remarks);
    if (names_clash(found.outputs, request.file, language)) return tl::unexpected(Status::bad_input);
    for (const Solution& solution : *solutions) {
        const Words where = request.at.empty() ? spoken(request.file) : solution.mechanism.title;
        for (const Unsolved& unsolved : solution.unsolved)
            found.unsolved.push_back({where, tell(unsolved.what) + ": " + tell(unsolved.why)});
    }
    return found;
}

Status solve_command(const SolveRequest& request) {
    const Language language = request.language;
    constexpr std::array formats{Format::svg, Format::png, Format::pdf, Format::tex, Format::json, Format::html};
    const auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    const auto theme = theme_of(request.theme, request.file, language);
    if (!theme) return theme.error();
    if (const Words fault = meaningless_on_page(request, *targets); !fault.empty()) return refuse(fault, language);
    std::optional<OutputWriter> press;
    const auto found = solved(request, *targets, *theme, press);
    if (!found) return found.error();
    if (const auto failure = write_all(found->outputs)) return fail_to_write(*failure, language);
    const auto tell_of = [&](const Words& where, const char* kind, const std::string& line) {
        say(where, render::word(kind, language) + ": " + line, language);
    };
    for (const std::string& remark : found->remarks) tell_of(spoken(request.file), "a remark", remark);
    for (const Solved::Missing& missing : found->unsolved) tell_of(missing.where, "one unsolved", missing.line);
    return found->status();
}

}  // namespace kinegraph::app
