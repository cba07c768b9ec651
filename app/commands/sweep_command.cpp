// sweep FILE: the results in a sequence of positions, or of values of a parameter, as rows that are written while they
// are computed.
#include <algorithm>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/commands/progress.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

/// The options of the library, or why drivers and steps do not belong together.
tl::expected<SweepOptions, Words> options_of(const SweepRequest& request) {
    SweepOptions options = request.options;
    options.dashes = "--";
    if (!request.drivers.empty()) options.driver = request.drivers.front();
    if (!options.over.empty()) {
        if (request.step.size() > 1) return tl::unexpected(Words(lang::command_line::step_is_given_twice));
        if (!request.step.empty() && request.says_steps)
            return tl::unexpected(
                Words(lang::common::do_not_go_together, std::string("--step"), std::string("--steps")));
        if (!request.step.empty()) options.step = request.step.front();
        return options;
    }
    const std::size_t more = request.drivers.empty() ? 0 : request.drivers.size() - 1;
    if (more != request.step.size())
        return tl::unexpected(
            Words(lang::command_line::step_is_of_a_driver, std::to_string(more), std::to_string(request.step.size())));
    for (std::size_t i = 0; i < more; ++i) options.along.push_back({request.drivers[i + 1], request.step[i]});
    return options;
}

/// Remarks on options that add to a drawing where none is asked for.
std::vector<Text> remarks_on(const SweepOptions& options) {
    if (options.plots.empty() && options.traces.empty() && options.poses == 0) return {};
    if (!options.over.empty()) return {Words(lang::command_line::plot_adds_to_the_drawing)};
    return {Words(lang::command_line::plot_trace_and_poses_add)};
}

/// Computes the rows and writes them to their files; a status after an error was reported.
tl::expected<std::vector<Output>, Status> rows_written(const SweepRequest& request, const std::vector<Target>& targets,
                                                       Sweep& sweep) {
    const Language language = request.sheet.language;
    std::vector<Growing> files;
    files.reserve(targets.size());  // their addresses are kept below
    std::vector<RowsText> texts;
    std::optional<NotWritten> failure;
    for (const Target& target : targets) {
        if (target.is_drawn()) continue;
        auto opened = Growing::open(target.path);
        if (!opened) return tl::unexpected(fail_to_write(opened.error(), language));
        Growing& file = files.emplace_back(*std::move(opened));
        texts.push_back({target.format == Format::json ? RowsText::Form::json : RowsText::Form::csv,
                         [&](std::string_view piece) { return !failure && !(failure = file.add(piece)); }});
    }
    const auto computed = [&] {
        Progress progress;  // gone before the first message
        return sweep.write(texts, [&](long done, long all) { progress.at(done, all); });
    }();
    if (!computed) return tl::unexpected(say(spoken(request.file), computed.error(), language));
    if (failure) return tl::unexpected(fail_to_write(*failure, language));
    std::vector<Output> outputs;
    for (Growing& file : files) outputs.push_back(std::move(file).finish());
    return outputs;
}

/// The motion as a film: once round, or to the end and back.
std::optional<Status> film(const SweepRequest& request, const DrawingOptions& options, const Target& target,
                           Sweep& sweep, std::vector<Output>& outputs) {
    const auto frames = draw_frames(sweep, request.frames, options);
    if (!frames) return cannot_draw(spoken(request.file), frames.error(), options.language);
    const auto [first, last] = sweep.limits();
    const bool goes_round = !first && !last && request.options.from.empty() && request.options.to.empty();
    using Course = FilmOptions::Course;
    const FilmOptions film{options.language, Captions::none, request.film_height,
                           goes_round ? Course::round : Course::to_and_fro};
    return add_film(*frames, target, film, outputs);
}

/// Writes all outputs; reports the results and errors.
Status run(const SweepRequest& request, const std::vector<Target>& targets, Sweep sweep) {
    const Words name = spoken(request.file);
    const Language language = request.sheet.language;
    DrawingOptions drawing = request.sheet;
    if (const auto status = set_theme(drawing, request.theme, request.file)) return *status;
    auto outputs = rows_written(request, targets, sweep);
    if (!outputs) return outputs.error();
    std::vector<Text> remarks = any_drawn(targets) ? std::vector<Text>() : remarks_on(request.options);
    const auto add = [&](const std::vector<Text>& more) { remarks.insert(remarks.end(), more.begin(), more.end()); };
    add(sweep.remarks());
    if (any_drawn(targets)) {
        const auto is_sheet = [](const Target& target) { return target.is_drawn() && !target.is_film(); };
        const bool has_sheet = std::any_of(targets.begin(), targets.end(), is_sheet);
        std::optional<Drawing> sheet;
        if (has_sheet) {
            auto drawn = draw(sweep, drawing);
            if (!drawn) return cannot_draw(name, drawn.error(), language);
            sheet = *std::move(drawn);
            add(sheet->remarks());
        }
        for (const Target& target : targets) {
            if (!target.is_drawn()) continue;
            const auto failed =
                target.is_film() ? film(request, drawing, target, sweep, *outputs)
                                 : print(*sheet, target, {language, request.lettering, request.dpi}, *outputs, remarks);
            if (failed) return *failed;
        }
    }
    if (names_clash(*outputs, request.file, language)) return Status::bad_input;
    if (const auto failure = write_all(*outputs)) return fail_to_write(*failure, language);
    remark(name, remarks, language);
    for (const Text& line : sweep.summary()) say(name, line, language);
    for (const auto& [what, why] : sweep.unsolved()) say_unsolved(name, what, why, language);
    return sweep.is_complete() ? Status::done : Status::unsolved;
}

}  // namespace

Status sweep_command(const SweepRequest& request) {
    const Language language = request.sheet.language;
    constexpr auto formats = drawings_and(Format::csv, Format::json, Format::mp4, Format::webm, Format::gif);
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    const auto file = mechanism_of(request.file, language, request.set);
    if (!file) return file.error();
    const bool moves = request.options.over.empty();
    const auto wrong = [&](const Words& subject, const Words& why) {
        say(subject, why, language);
        return Status::bad_input;
    };
    if (moves && !file->has_joints()) return wrong(spoken(request.file), no_mechanism("sweep"));
    if (any_drawn(*targets) && !file->has_joints())
        return wrong(spoken(request.file), {lang::command_line::plots_are_of_a_mechanism});
    // Which values a parameter takes is the command line's alone; how a driver moves depends on the file.
    const Words name = moves ? spoken(request.file) : Words(std::string("kinegraph"));
    const auto options = options_of(request);
    if (!options) return wrong(name, options.error());
    auto sweep = Sweep::of(*file, *options);
    if (!sweep) return say(name, sweep.error(), language);
    return run(request, *targets, *std::move(sweep));
}

}  // namespace kinegraph::app
