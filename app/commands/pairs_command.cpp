// pairs [FILE]: the catalogue of pairs, printed or drawn, or the pairs of a mechanism with its counts and its verdict.
#include <algorithm>
#include <array>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/files/files.hpp"
#include "constructions/kinematics/degeneracy.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/sheet/pair_sheet.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::app {
namespace {

/// The catalogue, or the pairs of the file; a status after an error was reported.
tl::expected<std::string, Status> text_of(const PairsRequest& request, render::TextForm form) {
    const Language language = request.sheet.language;
    if (request.file.empty()) return render::pair_catalogue(language, form);
    const auto mechanism = mechanism_of(request.file, language);
    if (!mechanism) return tl::unexpected(mechanism.error());
    if (stands_for_joints(*mechanism)) {
        say(spoken(request.file), no_mechanism("pairs"), language);
        return tl::unexpected(Status::bad_input);
    }
    const auto pose = draw_pose(*mechanism);
    if (!pose) return tl::unexpected(say(spoken(request.file), pose.error(), language));
    const Mobility mobility = mobility_of(*mechanism, *pose);
    return render::pair_report(
        *mechanism, mobility, remarks_on_mobility(*mechanism, mobility, degenerate_motion(*mechanism, *pose, mobility)),
        language, form);
}

/// Writes the files of -o.
Status write_targets(const PairsRequest& request, const std::vector<Target>& targets) {
    const Language language = request.sheet.language;
    std::vector<Output> outputs;
    std::vector<std::string> remarks;
    const bool draws =
        std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
    if (draws && !request.file.empty())
        return refuse(
            {"what pairs draws is the catalogue; leave {0} out, or have its pairs as .json",
             "ciò che pairs disegna è il catalogo; togliere {0}, o chiederne le coppie in .json", request.file},
            language);
    std::optional<OutputWriter> press;
    std::vector<render::Page> pages;
    if (draws) {
        const auto theme = theme_of(request.theme, request.file, language);
        if (!theme) return theme.error();
        auto opened = OutputWriter::open(targets, language);
        if (!opened) return opened.error();
        press.emplace(*std::move(opened));
        render::SheetOptions options = request.sheet;
        options.theme = *theme;
        pages = render::lay_out_catalogue(options, press->fonts());
    }
    for (const Target& target : targets) {
        if (target.is_drawn()) {
            press->print(pages, target, request.dpi, outputs, remarks);
            continue;
        }
        auto text = text_of(request, render::TextForm::json);
        if (!text) return text.error();
        outputs.push_back({target.path, *std::move(text)});
    }
    if (press) press->remark_missing(remarks);
    if (names_clash(outputs, request.file, language)) return Status::bad_input;
    if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language);
    for (const std::string& remark : remarks)
        say({"pairs", "pairs"}, render::word("a remark", language) + ": " + remark, language);
    return Status::done;
}

}  // namespace

Status pairs_command(const PairsRequest& request) {
    const Language language = request.sheet.language;
    const bool is_text = request.format == "text" || request.format == "markdown" || request.format == "json";
    if (request.outputs.empty() && is_text) {
        const auto text = text_of(request, request.format == "markdown" ? render::TextForm::markdown
                                           : request.format == "json"   ? render::TextForm::json
                                                                        : render::TextForm::plain);
        return text ? print(*text, language) : text.error();
    }
    constexpr std::array formats{Format::svg, Format::png, Format::pdf, Format::tex, Format::json};
    const auto targets = targets_of(request.outputs, request.format, request.file, formats);
    return targets ? write_targets(request, *targets) : refuse(targets.error(), language);
}

}  // namespace kinegraph::app
