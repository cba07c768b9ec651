// solve FILE: reads, solves, draws what is asked and writes it, all or nothing.
#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/module.hpp"
#include "app/modules/type.hpp"
#include "app/painter.hpp"
#include "constructions/solve.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/steps.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

enum class Format { svg, png, pdf, json };

std::optional<Format> format_named(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (name == "svg") return Format::svg;
    if (name == "png") return Format::png;
    if (name == "pdf") return Format::pdf;
    if (name == "json") return Format::json;
    return std::nullopt;
}

/// Where a path's last dot is, or its end: "out/sheet.svg" → 9, "a.b/sheet" → 9.
std::size_t ending_of(const std::string& path) {
    const std::size_t name = path.rfind('/') + 1;  // 0 where there is no slash
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos || dot <= name ? path.size() : dot;
}

struct Target {
    std::string path;
    Format format = Format::svg;
    bool standard() const { return path == "-"; }
    std::string path_of_page(std::size_t page) const {
        if (page == 0) return path;
        std::string numbered = path;
        return numbered.insert(ending_of(path), '-' + std::to_string(page + 1));
    }
};

bool is_painted(const Target& target) { return target.format == Format::png || target.format == Format::pdf; }

/// What is to be written, or why the command line cannot be meant so.
tl::expected<std::vector<Target>, std::string> targets_of(const SolveRequest& request) {
    std::vector<std::string> paths = request.outputs;
    if (paths.empty() && !request.format.empty()) paths.emplace_back("-");
    std::vector<Target> targets;
    for (const std::string& path : paths) {
        if (path.empty() || path.ends_with('/')) return tl::unexpected("-o \"" + path + "\" names no file");
        const std::size_t ending = ending_of(path);
        std::optional<Format> format;
        if (path != "-" && ending < path.size()) format = format_named(path.substr(ending + 1));
        if (!format) format = format_named(request.format);
        if (!format && path == "-") return tl::unexpected(std::string("-o - needs --format svg, png, pdf or json"));
        if (!format)
            return tl::unexpected(
                "-o " + path +
                ": the ending does not say what to write; it may be .svg, .png, .pdf or .json (or --format says it)");
        for (const Target& other : targets)
            if (other.path == path)
                return tl::unexpected(path == "-" ? std::string("standard output can carry one output only")
                                                  : "-o " + path + " is given twice");
        if (path != "-" && same_file(path, request.file))
            return tl::unexpected("-o " + path + " would overwrite the mechanism file itself");
        targets.push_back({path, *format});
    }
    return targets;
}

/// "./a.svg" and "a.svg" alike.
std::string plain(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

/// What programs read is English whatever the sheet speaks.
std::string in_english(const Message& message) { return render::tell(message, render::Language::en); }

/// All bytes of a run, under the names they get. Remarks are added to `remarks`.
std::vector<Output> outputs_of(const Solution& solution, const std::vector<Target>& targets, const SolveRequest& request,
                               const std::vector<render::Page>& pages, const std::optional<render::Fonts>& fonts,
                               const std::optional<Painter>& painter, std::vector<std::string>& remarks) {
    std::vector<Output> outputs;
    for (const Target& target : targets) {
        if (target.format == Format::json) {
            outputs.push_back({target.path, results_json(solution, request.exact, in_english)});
            continue;
        }
        if (target.format == Format::pdf) {
            outputs.push_back({target.path, painter->to_pdf(pages, *fonts)});
            continue;
        }
        const std::size_t count = target.standard() ? std::min<std::size_t>(pages.size(), 1) : pages.size();
        if (target.format == Format::svg) {
            std::vector<std::string> texts =
                count == 1 ? std::vector{render::to_svg(pages.front(), *fonts)} : render::to_svg(pages, *fonts);
            for (std::size_t page = 0; page < count; ++page)
                outputs.push_back({target.path_of_page(page), std::move(texts[page])});
        } else {
            for (std::size_t page = 0; page < count; ++page)
                outputs.push_back({target.path_of_page(page), painter->to_png(pages[page], *fonts, request.dpi)});
        }
        if (count < pages.size())
            remarks.push_back("the sheet has " + std::to_string(pages.size()) +
                              " pages and standard output carries the first only; a PDF has them all, and so has -o with a name");
    }
    if (fonts) {
        std::string absent;
        for (const std::string& character : fonts->missing()) absent += (absent.empty() ? "" : ", ") + character;
        if (!absent.empty()) remarks.push_back("the font has no " + absent + ": drawn as its code in a box");
    }
    return outputs;
}

/// A built-in theme, or that of a file; else it has been said what is wrong.
tl::expected<render::Theme, Status> theme_of(const std::string& name) {
    if (auto built_in = render::built_in_theme(name)) return *std::move(built_in);
    const auto text = read_whole(name, "theme file");
    if (!text) {
        std::string known;
        for (const std::string_view each : render::theme_names()) known.append(known.empty() ? "" : ", ").append(each);
        say(spoken(name), text.error() + " (--theme is one of " + known + ", or the path of a theme file)");
        return tl::unexpected(Status::bad_input);
    }
    auto theme = render::read_theme(*text);
    if (!theme) return tl::unexpected(say(spoken(name), theme.error()));
    return *std::move(theme);
}

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

/// The file read and solved; else it has been said what is wrong.
tl::expected<Solution, Status> solution_of(const SolveRequest& request, const std::string& name) {
    const auto text = read_whole(request.file, "mechanism file");
    if (!text) {
        say(name, text.error());
        return tl::unexpected(Status::bad_input);
    }
    auto mechanism = read_mechanism(*text, bare_name(request.file));
    if (!mechanism) return tl::unexpected(say(name, mechanism.error()));
    auto solution = solve(*std::move(mechanism));
    if (!solution) return tl::unexpected(say(name, solution.error()));
    return *std::move(solution);
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

/// The names of further pages are known only now; none may be another output's, or the mechanism file's. Says so where one is.
bool names_clash(const std::vector<Output>& outputs, const std::string& file) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (plain(outputs[i].path) != plain(outputs[j].path)) continue;
            say("kinegraph", "two outputs of this run would both be " + outputs[i].path);
            return true;
        }
        if (outputs[i].path != "-" && same_file(outputs[i].path, file)) {
            say("kinegraph", outputs[i].path + " (a further page) would overwrite the mechanism file itself");
            return true;
        }
    }
    return false;
}

/// The table on the terminal, or all that the targets ask for. Remarks are added to `remarks`.
tl::expected<std::vector<Output>, Status> made(const Solution& solution, const std::vector<Target>& targets,
                                               const render::Theme& theme, const SolveRequest& request, const std::string& name,
                                               std::vector<std::string>& remarks) {
    if (targets.empty()) return std::vector<Output>{{"-", render::results_table(solution, request.language)}};
    if (std::all_of(targets.begin(), targets.end(), [](const Target& target) { return target.format == Format::json; }))
        return outputs_of(solution, targets, request, {}, {}, {}, remarks);
    auto typefaces = open_module_as<TypeFunctions>("kinegraph_type", "Type is set").and_then([](const TypeFunctions* functions) {
        return functions->open_typefaces();
    });
    if (!typefaces) {
        say("kinegraph", typefaces.error());
        return tl::unexpected(Status::output);
    }
    const std::optional<render::Fonts> opened(std::in_place, *std::move(typefaces));
    std::optional<Painter> painter;
    if (std::any_of(targets.begin(), targets.end(), is_painted)) {
        auto loaded = Painter::open();
        if (!loaded) {
            say("kinegraph", loaded.error());
            return tl::unexpected(Status::output);
        }
        painter.emplace(*std::move(loaded));
    }
    const auto pages = pages_of(solution, theme, request, name, *opened);
    if (!pages) return tl::unexpected(pages.error());
    return outputs_of(solution, targets, request, *pages, opened, painter, remarks);
}

}  // namespace

Status solve_command(const SolveRequest& request) {
    const std::string name = spoken(request.file);
    const auto targets = targets_of(request);
    if (!targets) {
        say("kinegraph", targets.error());
        return Status::bad_input;
    }
    if (request.theme == "-" && request.file == "-") {
        say("kinegraph", "standard input can be the mechanism file or the theme, not both");
        return Status::bad_input;
    }
    const auto theme = theme_of(request.theme);
    if (!theme) return theme.error();
    const auto solution = solution_of(request, name);
    if (!solution) return solution.error();

    std::vector<std::string> remarks;
    const auto tell = [&](const Message& message) { return render::tell(message, request.language); };
    for (const Message& remark : solution->remarks) remarks.push_back(tell(remark));
    const auto outputs = made(*solution, *targets, *theme, request, name, remarks);
    if (!outputs) return outputs.error();
    remark_on_request(request, *solution, *targets, remarks);
    if (names_clash(*outputs, request.file)) return Status::bad_input;
    if (const auto failure = write_all(*outputs)) {
        say(failure->path == "-" ? "standard output" : failure->path, "cannot be written: " + failure->why);
        return Status::output;
    }
    for (const std::string& remark : remarks) say(name, render::word("a remark", request.language) + ": " + remark);
    for (const Unsolved& unsolved : solution->unsolved)
        say(name, render::word("one unsolved", request.language) + ": " + tell(unsolved.what) + ": " + tell(unsolved.why));
    return solution->unsolved.empty() ? Status::done : Status::unsolved;
}

}  // namespace kinegraph::app
