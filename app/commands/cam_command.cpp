// cam FILE: computes the disc cam that gives its follower a law, solves every position of it as a mechanism and
// compares the result with the law.

#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

/// Writes all outputs; reports the results and errors.
Status run(const CamRequest& request, const std::vector<Target>& targets, const CamFile& file) {
    const Words name = spoken(request.file);
    const Language language = request.sheet.language;
    DrawingOptions drawing = request.sheet;
    if (const auto status = set_theme(drawing, request.theme, request.file)) return *status;
    CamOptions options = request.options;
    options.dashes = "--";
    const auto cycle = CamCycle::of(file, options);
    if (!cycle) return say(name, cycle.error(), language);
    std::vector<Text> remarks = cycle->remarks();
    std::vector<Output> outputs;
    for (const Target& target : targets) {
        if (target.format == Format::csv) outputs.push_back({target.path, cycle->csv()});
        if (target.format == Format::json) outputs.push_back({target.path, cycle->mechanism()});
    }
    for (const Target& target : targets) {
        if (!target.is_page()) continue;
        auto page = live_page(*cycle, drawing);
        if (!page) return cannot_draw(name, page.error(), language);
        outputs.push_back({target.path, std::move(page->html)});
    }
    const auto is_sheet = [](const Target& target) { return target.is_drawn() && !target.is_page(); };
    if (std::any_of(targets.begin(), targets.end(), is_sheet)) {
        const auto drawn = draw(*cycle, drawing);
        if (!drawn) return cannot_draw(name, drawn.error(), language);
        for (const Target& target : targets)
            if (is_sheet(target))
                if (const auto failed =
                        print(*drawn, target, {language, request.lettering, request.dpi}, outputs, remarks))
                    return *failed;
        for (Text& each : drawn->remarks()) remarks.push_back(std::move(each));
    }
    if (names_clash(outputs, request.file, language)) return Status::bad_input;
    if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language);
    for (const Text& line : cycle->facts()) say(name, line, language);
    remark(name, remarks, language);
    for (const Text& line : cycle->comparison()) say(name, line, language);
    return cycle->keeps_law() ? Status::done : Status::unsolved;
}

}  // namespace

Status cam_command(const CamRequest& request) {
    const Language language = request.sheet.language;
    constexpr auto formats = drawings_and(Format::html, Format::csv, Format::json);
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    const auto text = read_whole(request.file, {lang::common::cam_file});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return Status::bad_input;
    }
    const auto file = CamFile::parse(*text, bare_name(request.file));
    if (!file) return say(spoken(request.file), file.error(), language);
    return run(request, *targets, *file);
}

}  // namespace kinegraph::app
