// solve FILE: reads, solves, draws what is asked and writes it, all or nothing.
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "app/commands.hpp"
#include "app/driver_choice.hpp"
#include "app/outputs.hpp"
#include "constructions/solve.hpp"
#include "engine/moved.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/steps.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

/// What programs read is English whatever the sheet speaks.
std::string in_english(const Message& message) { return render::tell(message, render::Language::en); }

/// Why Joukowsky's lever cannot be drawn; empty where it can.
const char* why_no_lever(const Solution& solution) {
    switch (render::no_lever(solution)) {
        case render::NoLever::none:
            return "";
        case render::NoLever::no_forces:
            return "no forces act, or none are asked for";
        case render::NoLever::no_velocities:
            return "forces have powers only where something is driven and its velocities are known";
        case render::NoLever::nothing_moves:
            return "no force acts at a point that moves";
    }
    return "";
}

/// Positions asked for, as the driver's coordinates: exactly, and as they are told.
struct Asked {
    Exact coordinate;
    std::string text;
};
tl::expected<std::vector<Asked>, std::string> positions_asked(const SolveRequest& request, const Mechanism& mechanism,
                                                              int driver) {
    constexpr std::size_t most = 720;
    std::vector<Asked> all;
    const auto add = [&](const Exact& coordinate) {
        all.push_back({coordinate, coordinate_text(mechanism, driver, coordinate.to_double())});
    };
    for (const std::string& text : request.at) {
        const bool every = text.starts_with("every ");
        const auto read = coordinate_of(mechanism, driver, every ? text.substr(6) : text);
        if (!read) return tl::unexpected("--at: " + read.error());
        if (!every) {
            add(*read);
            continue;
        }
        if (!turns(mechanism, driver)) return tl::unexpected("--at " + text + ": a slide has no whole turn; give its positions");
        if (read->sign() <= 0 || *read * Exact(static_cast<int>(most)) < 2 * pi())
            return tl::unexpected("--at " + text + ": a turn is divided into 1 to " + std::to_string(most) + " positions");
        for (Exact turn = 0; turn < 2 * pi(); turn += *read) add(turn);
    }
    if (all.size() > most) return tl::unexpected("--at: at most " + std::to_string(most) + " positions in one run");
    return all;
}

/// Its title says in which position a sheet is.
void name_position(Mechanism& mechanism, const std::string& driver, const std::string& turn) {
    for (std::string* title : {&mechanism.title.en, &mechanism.title.it}) {
        const std::string& known = title->empty() ? mechanism.source : *title;
        *title = known + " (" + driver + ": " + turn + ")";
    }
}

/// The mechanism solved in the positions asked for; else it has been said what is wrong.
tl::expected<std::vector<Solution>, Status> solved_at(const Mechanism& mechanism, const SolveRequest& request,
                                                      const std::string& name) {
    const auto wrong = [&](const std::string& why, Status status = Status::bad_input) {
        say(name, why);
        return tl::unexpected(status);
    };
    const auto driver = driver_named(mechanism, request.driver);
    if (!driver) return wrong(driver.error());
    const auto asked = positions_asked(request, mechanism, *driver);
    if (!asked) return wrong(asked.error());
    const auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(say(name, pose.error()));
    auto positions = Positions::of(mechanism, *pose, *driver);
    if (!positions) return tl::unexpected(say(name, positions.error()));
    const Mover mover(mechanism, *pose);
    std::vector<Solution> solutions;
    for (const auto& [coordinate, text] : *asked) {
        if (coordinate.is_zero()) {
            auto drawn = solve(mechanism);
            if (!drawn) return tl::unexpected(say(name, drawn.error()));
            solutions.push_back(*std::move(drawn));
        } else {
            Positions here = *positions;
            if (!here.move_to(coordinate.to_double()))
                return wrong("--at: " + text + " is out of reach: driver " + name_of_driver(mechanism, *driver) + " stops at " +
                             coordinate_text(mechanism, *driver, here.limit().value_or(0)));
            if (here.is_singular())
                return wrong("--at: at " + text +
                                 " the mechanism is at a change point, where it has no one answer; ask for a position beside it",
                             Status::unsolved);
            Moved moved = mover.moved(here, coordinate);
            solutions.push_back(
                solve(std::move(moved.mechanism), std::move(moved.pose), [finer = std::move(moved.finer)] { return finer; }));
        }
        name_position(solutions.back().mechanism, name_of_driver(mechanism, *driver), text);
    }
    return solutions;
}

/// The file read and solved; else it has been said what is wrong.
tl::expected<std::vector<Solution>, Status> solutions_of(const SolveRequest& request, const std::string& name) {
    const auto text = read_whole(request.file, "mechanism file");
    if (!text) {
        say(name, text.error());
        return tl::unexpected(Status::bad_input);
    }
    auto mechanism = read_mechanism(*text, bare_name(request.file));
    if (!mechanism) return tl::unexpected(say(name, mechanism.error()));
    if (!request.at.empty()) return solved_at(*mechanism, request, name);
    auto solution = solve(*std::move(mechanism));
    if (!solution) return tl::unexpected(say(name, solution.error()));
    std::vector<Solution> solutions;
    solutions.push_back(*std::move(solution));
    return solutions;
}

bool wants_lever(const SolveRequest& request) {
    return std::find(request.with.begin(), request.with.end(), "joukowsky") != request.with.end();
}

/// The sheet, its steps or one figure; else it has been said that there is no such figure.
tl::expected<std::vector<render::Page>, Status> pages_of(const Solution& solution, const render::Theme& theme,
                                                         const SolveRequest& request, const std::string& name,
                                                         const render::Fonts& fonts) {
    render::SheetOptions options;
    options.paper = request.paper;
    options.language = request.language;
    options.dimensions = request.dimensions;
    options.joukowsky = wants_lever(request) || !request.figure.empty();
    options.orientation = request.orientation;
    options.author = request.author;
    options.date = request.date;
    options.theme = theme;
    if (request.steps) return render::lay_out_steps(solution, options, fonts);
    if (request.figure.empty()) return render::lay_out(solution, options, fonts);
    if (auto page = render::lay_out_alone(solution, options, request.figure, fonts)) return std::vector{*std::move(page)};
    std::string names;
    for (const std::string& each : render::figure_names(solution, options, fonts)) names += (names.empty() ? "" : ", ") + each;
    say(name, "--figure " + request.figure + ": there is no such figure; there are " + names);
    return tl::unexpected(Status::bad_input);
}

/// What was asked for and has no effect.
void remark_on_request(const SolveRequest& request, const Solution& solution, const std::vector<Target>& targets,
                       std::vector<std::string>& remarks) {
    const auto is_json = [](const Target& target) { return target.format == Format::json; };
    const bool draws = !std::all_of(targets.begin(), targets.end(), is_json);
    if (wants_lever(request)) {
        if (const char* why = why_no_lever(solution); *why)
            remarks.push_back(std::string("no lever: ") + why);
        else if (!draws)
            remarks.emplace_back("--with joukowsky adds to the sheet only, and none is asked for");
    }
    if (!request.figure.empty() && !draws) remarks.emplace_back("--figure chooses what is drawn, and no drawing is asked for");
    if (request.steps && !draws) remarks.emplace_back("--steps adds pages to what is drawn, and no drawing is asked for");
    if (request.exact && std::none_of(targets.begin(), targets.end(), is_json))
        remarks.emplace_back("--exact adds to the JSON results only, and none are asked for");
}

/// The table on the terminal, or all that the targets ask for. Remarks are added to `remarks`.
tl::expected<std::vector<Output>, Status> made(const std::vector<Solution>& solutions, const std::vector<Target>& targets,
                                               const render::Theme& theme, const SolveRequest& request, const std::string& name,
                                               std::vector<std::string>& remarks) {
    std::vector<Output> outputs;
    if (targets.empty()) {
        std::string tables;
        for (const Solution& solution : solutions)
            tables += (tables.empty() ? "" : "\n") + render::results_table(solution, request.language);
        return std::vector<Output>{{"-", std::move(tables)}};
    }
    std::optional<Press> press;
    std::vector<render::Page> pages;
    if (std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); })) {
        auto opened = Press::open(targets);
        if (!opened) return tl::unexpected(opened.error());
        press.emplace(*std::move(opened));
        for (const Solution& solution : solutions) {
            auto more = pages_of(solution, theme, request, name, press->fonts());
            if (!more) return tl::unexpected(more.error());
            std::move(more->begin(), more->end(), std::back_inserter(pages));
        }
    }
    for (const Target& target : targets) {
        if (target.is_drawn()) {
            press->print(pages, target, request.dpi, outputs, remarks);
            continue;
        }
        for (std::size_t i = 0; i < solutions.size(); ++i)
            if (i == 0 || !target.standard())
                outputs.push_back({target.path_of_page(i), results_json(solutions[i], request.exact, in_english)});
        if (target.standard() && solutions.size() > 1)
            remarks.emplace_back("standard output carries the first position only; -o with a name writes them all");
    }
    if (press) press->remark_missing(remarks);
    return outputs;
}

}  // namespace

Status solve_command(const SolveRequest& request) {
    const std::string name = spoken(request.file);
    constexpr std::array formats{Format::svg, Format::png, Format::pdf, Format::json};
    const auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) {
        say("kinegraph", targets.error());
        return Status::bad_input;
    }
    const auto theme = theme_of(request.theme, request.file);
    if (!theme) return theme.error();
    const auto solutions = solutions_of(request, name);
    if (!solutions) return solutions.error();

    std::vector<std::string> remarks;
    const auto tell = [&](const Message& message) { return render::tell(message, request.language); };
    const auto add = [&](std::string remark) {
        if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end()) remarks.push_back(std::move(remark));
    };
    for (const Solution& solution : *solutions)
        for (const Message& remark : solution.remarks) add(tell(remark));
    const auto outputs = made(*solutions, *targets, *theme, request, name, remarks);
    if (!outputs) return outputs.error();
    remark_on_request(request, solutions->front(), *targets, remarks);
    if (names_clash(*outputs, request.file)) return Status::bad_input;
    if (const auto failure = write_all(*outputs)) {
        say(failure->path == "-" ? "standard output" : failure->path, "cannot be written: " + failure->why);
        return Status::output;
    }
    for (const std::string& remark : remarks) say(name, render::word("a remark", request.language) + ": " + remark);
    bool whole = true;
    for (const Solution& solution : *solutions) {
        const std::string where = request.at.empty() ? name : solution.mechanism.title.en;
        for (const Unsolved& unsolved : solution.unsolved) {
            say(where, render::word("one unsolved", request.language) + ": " + tell(unsolved.what) + ": " + tell(unsolved.why));
            whole = false;
        }
    }
    return whole ? Status::done : Status::unsolved;
}

}  // namespace kinegraph::app
