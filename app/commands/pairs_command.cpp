// pairs [FILE]: the catalogue of pairs, printed or drawn, or the pairs of a mechanism with its counts and its verdict.
#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {
namespace {

/// The catalogue, or the pairs of the file; a status after an error was reported.
tl::expected<std::string, Status> text_of(const PairsRequest& request, TextForm form) {
    const Language language = request.sheet.language;
    if (request.file.empty()) return pair_catalogue(form, language);
    const auto file = mechanism_of(request.file, language);
    if (!file) return tl::unexpected(file.error());
    if (!file->has_joints()) {
        say(spoken(request.file), no_mechanism("pairs"), language);
        return tl::unexpected(Status::bad_input);
    }
    auto text = file->pairs(form, language);
    if (!text) return tl::unexpected(say(spoken(request.file), text.error(), language));
    return *std::move(text);
}

/// Writes the files of -o.
Status write_targets(const PairsRequest& request, const std::vector<Target>& targets) {
    const Language language = request.sheet.language;
    std::vector<Output> outputs;
    std::vector<Text> remarks;
    const bool draws = any_drawn(targets);
    if (draws && !request.file.empty())
        return refuse({lang::command_line::what_pairs_draws_is_the_catalogue, request.file}, language);
    std::optional<Drawing> catalogue;
    if (draws) {
        DrawingOptions options = request.sheet;
        if (const auto status = set_theme(options, request.theme, request.file)) return *status;
        auto drawn = draw_pair_catalogue(options);
        if (!drawn) return cannot_draw({lang::command_line::pairs}, drawn.error(), language);
        catalogue = *std::move(drawn);
    }
    for (const Target& target : targets) {
        if (target.is_drawn()) {
            if (const auto failed =
                    print(*catalogue, target, {language, Lettering::outlines, request.dpi}, outputs, remarks))
                return *failed;
            continue;
        }
        auto text = text_of(request, TextForm::json);
        if (!text) return text.error();
        outputs.push_back({target.path, *std::move(text)});
    }
    if (catalogue)
        for (Text& each : catalogue->remarks()) remarks.push_back(std::move(each));
    if (names_clash(outputs, request.file, language)) return Status::bad_input;
    if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language);
    remark({lang::command_line::pairs}, remarks, language);
    return Status::done;
}

}  // namespace

Status pairs_command(const PairsRequest& request) {
    const Language language = request.sheet.language;
    const bool is_text = request.format == "text" || request.format == "markdown" || request.format == "json";
    if (request.outputs.empty() && is_text) {
        const auto text = text_of(request, request.format == "markdown" ? TextForm::markdown
                                           : request.format == "json"   ? TextForm::json
                                                                        : TextForm::plain);
        return text ? print(*text, language) : text.error();
    }
    constexpr auto formats = drawings_and(Format::json);
    const auto targets = targets_of(request.outputs, request.format, request.file, formats);
    return targets ? write_targets(request, *targets) : refuse(targets.error(), language);
}

}  // namespace kinegraph::app
