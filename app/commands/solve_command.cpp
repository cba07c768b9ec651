// solve FILE: reads, solves, draws and writes all outputs or none.
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/commands/solved.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

using Detail = DrawingOptions::Detail;
using Sheet = DrawingOptions::Sheet;

/// The first option of the request that needs a mechanism; null if none does.
const char* asked_of_mechanisms(const SolveRequest& request) {
    if (!request.positions.at.empty()) return "solve --at";
    if (request.drawing.grid) return "solve --grid";
    return request.drawing.detail == Detail::brief ? "solve --detail" : nullptr;
}

bool wants(const SolveRequest& request, const char* what) {
    return std::find(request.with.begin(), request.with.end(), what) != request.with.end();
}

/// Reads and solves the file; a status after an error was reported. `sentences`: whether they are to be shown.
tl::expected<std::vector<Solved>, Status> solutions_of(const SolveRequest& request, const std::string& text,
                                                       bool sentences) {
    const Words name = spoken(request.file);
    const auto wrong = [&](const Diagnostics& faults) { return tl::unexpected(say(name, faults, request.language())); };
    const auto file = MechanismFile::parse(text, bare_name(request.file), request.set);
    if (!file) return wrong(file.error());
    if (const char* const what = asked_of_mechanisms(request); !file->has_joints() && what != nullptr) {
        say(name, no_mechanism(what), request.language());
        return tl::unexpected(Status::bad_input);
    }
    const SolveOptions options{wants(request, "equations"), wants(request, "virtual work"), sentences};
    if (!request.positions.at.empty()) {
        PositionsWanted positions = request.positions;
        positions.dashes = "--";
        auto all = file->solve_at(positions, options);
        if (!all) return wrong(all.error());
        return *std::move(all);
    }
    auto solved = file->solve(options);
    if (!solved) return wrong(solved.error());
    return std::vector<Solved>{*std::move(solved)};
}

/// The message for options that contradict each other; empty if there are none.
Words meaningless(const SolveRequest& request) {
    const DrawingOptions& drawing = request.drawing;
    const bool solution = drawing.sheet == Sheet::solution, brief = drawing.detail == Detail::brief;
    const char* const sheet = drawing.sheet == Sheet::question ? "question" : "answers";
    const auto both = [](const std::string& one, const std::string& other) {
        return Words(lang::command_line::and_exclude_each_other_leave, one, other);
    };
    const std::string kind = std::string("--sheet ") + sheet;
    if (drawing.grid && drawing.sheet != Sheet::question) return {lang::command_line::grid_is_for_the_question_add};
    if (!solution && brief) return both(kind, "--detail brief");
    if (drawing.superposition == DrawingOptions::Superposition::each && (!solution || brief))
        return both("--superposition each", solution ? "--detail brief" : kind);
    if (!drawing.figure.empty() && (!solution || brief)) return both("--figure", solution ? "--detail brief" : kind);
    if (drawing.slides && !drawing.steps)
        return {lang::command_line::slides_show_the_steps, std::string(request.beamer ? "--beamer" : "--slides")};
    if (drawing.steps && (!solution || brief)) return both("--steps", solution ? "--detail brief" : kind);
    if (drawing.steps && !drawing.figure.empty()) return both("--steps", "--figure");
    if (drawing.slides && drawing.paper != DrawingOptions::Paper::a4) return both("--slides", "--paper");
    if (drawing.slides && drawing.orientation != DrawingOptions::Orientation::landscape)
        return both("--slides", "--orientation");
    if (!solution && wants(request, "joukowsky")) return both("--with joukowsky", kind);
    if (!solution && wants(request, "equations")) return both("--with equations", kind);
    if (!solution && wants(request, "virtual work")) return both("--with \"virtual work\"", kind);
    if (drawing.sheet == Sheet::question && drawing.dimensions == DrawingOptions::Dimensions::on)
        return both("--dimensions on", kind);
    return {};
}

/// The same for a live page, which is always the whole solution, step by step.
Words meaningless_on_page(const SolveRequest& request, const std::vector<Target>& targets) {
    if (std::none_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_page(); })) return {};
    const char* const other = !request.drawing.figure.empty()            ? "--figure"
                              : request.drawing.steps                    ? "--steps"
                              : request.drawing.sheet != Sheet::solution ? "--sheet"
                                                                         : nullptr;
    if (other == nullptr) return {};
    return {lang::command_line::has_no_meaning_for_a_live, std::string(other)};
}

/// The same for a film, which is the whole solution, step by step.
Words meaningless_in_film(const SolveRequest& request, const std::vector<Target>& targets) {
    const auto film =
        std::find_if(targets.begin(), targets.end(), [](const Target& target) { return target.is_film(); });
    if (film == targets.end()) return {};
    const DrawingOptions& drawing = request.drawing;
    const char* const other = !drawing.figure.empty()            ? "--figure"
                              : drawing.detail == Detail::brief  ? "--detail brief"
                              : drawing.sheet != Sheet::solution ? "--sheet"
                                                                 : nullptr;
    if (other == nullptr) return {};
    return {lang::command_line::and_exclude_each_other_leave, "-o " + film->path, std::string(other)};
}

/// Remarks on options that have no effect.
std::vector<Text> remarks_on_request(const SolveRequest& request, const Solved& solved,
                                     const std::vector<Target>& targets) {
    const auto none_is = [&](std::initializer_list<Format> formats) {
        return std::none_of(targets.begin(), targets.end(), [&](const Target& target) {
            return std::find(formats.begin(), formats.end(), target.format) != formats.end();
        });
    };
    const bool draws =
        !std::all_of(targets.begin(), targets.end(), [](const auto& each) { return each.format == Format::json; });
    std::vector<Text> remarks;
    if (wants(request, "joukowsky")) {
        if (const auto why = solved.why_without(Solved::Addition::lever))
            remarks.push_back(Words(lang::command_line::no_lever, *why));
        else if (!draws)
            remarks.push_back(Words(lang::command_line::with_joukowsky_adds_to_the_sheet));
    }
    if (wants(request, "equations"))
        if (const auto why = solved.why_without(Solved::Addition::equations))
            remarks.push_back(Words(lang::common::no_equations, *why));
    if (wants(request, "virtual work"))
        if (const auto why = solved.why_without(Solved::Addition::virtual_work))
            remarks.push_back(Words(lang::command_line::no_virtual_work, *why));
    struct WithoutEffect {
        bool is;
        Words remark;
    };
    const DrawingOptions& drawing = request.drawing;
    for (const WithoutEffect& each : std::vector<WithoutEffect>{
             {!drawing.figure.empty() && !draws, {lang::command_line::figure_chooses_what_is_drawn}},
             {request.lettering != Lettering::outlines && none_is({Format::svg, Format::pdf}),
              {lang::command_line::text_says_how_svg_and_pdf}},
             {drawing.steps && !draws, {lang::command_line::steps_adds_pages_to_what}},
             {drawing.sheet != Sheet::solution && !draws, {lang::command_line::sheet_chooses_what_is_drawn}},
             {drawing.detail == Detail::brief && !draws, {lang::command_line::detail_says_how_much_is_drawn}},
             {request.beamer && none_is({Format::tex}), {lang::command_line::beamer_is_of_tex}},
             {!request.captions.empty() && none_is({Format::mp4, Format::webm, Format::gif}),
              {lang::command_line::captions_are_of_a_film}},
             {request.exact && none_is({Format::json}), {lang::command_line::exact_adds_to_the_json_results}}})
        if (each.is) remarks.push_back(each.remark);
    return remarks;
}

/// The bytes of the targets of one run.
class Making {
public:
    Making(const SolveRequest& request, const std::vector<Solved>& solved, Outcome& outcome)
        : request_(request), solved_(solved), outcome_(outcome), options_(request.drawing) {
        options_.lever = wants(request, "joukowsky");
    }

    /// The table for the terminal.
    void table() {
        std::string tables;
        for (const Solved& each : solved_) tables += (tables.empty() ? "" : "\n") + each.table(request_.language());
        outcome_.outputs = {{"-", std::move(tables)}};
    }
    /// A status after an error was reported.
    std::optional<Status> make(const std::vector<Target>& targets) {
        std::optional<Drawing> drawing;
        std::vector<Text> in_the_end;
        const auto is_sheet = [](const Target& target) {
            return target.is_drawn() && !target.is_page() && !target.is_film();
        };
        if (std::any_of(targets.begin(), targets.end(), is_sheet)) {
            auto drawn = draw(solved_, options_);
            if (!drawn) return not_drawn(drawn.error());
            in_the_end = drawn->remarks();
            drawing = *std::move(drawn);
        }
        for (const Target& target : targets) {
            const Printing printing{request_.language(), request_.lettering, request_.dpi, request_.beamer};
            const auto failed = target.is_page()   ? pages(target, in_the_end)
                                : target.is_film() ? film(target, in_the_end)
                                : target.is_drawn()
                                    ? print(*drawing, target, printing, outcome_.outputs, outcome_.remarks)
                                : target.format == Format::ggb ? construction(target)
                                                               : results(target);
            if (failed) return failed;
        }
        for (Text& each : in_the_end) outcome_.remarks.push_back(std::move(each));
        return std::nullopt;
    }

private:
    std::optional<Status> not_drawn(Diagnostics faults) const {
        // The theme has been read before: what is wrong without a place in the file is wrong with the figure.
        const bool has_figure = !request_.drawing.figure.empty();
        if (has_figure && faults.front().kind == Diagnostic::Kind::bad_input && faults.front().place.empty())
            faults.front().text = Words(lang::command_line::figure) + faults.front().text;
        return cannot_draw(spoken(request_.file), faults, request_.language());
    }
    std::optional<Status> pages(const Target& target, std::vector<Text>& remarks) {
        for (std::size_t i = 0; i < (target.standard() ? 1 : solved_.size()); ++i) {
            auto page = live_page(solved_[i], options_);
            if (!page) return not_drawn(page.error());
            outcome_.outputs.push_back({target.path_of_page(i), std::move(page->html)});
            std::move(page->remarks.begin(), page->remarks.end(), std::back_inserter(remarks));
        }
        return std::nullopt;
    }
    /// The steps as a film. Where nothing shows captions they are in the pictures.
    std::optional<Status> film(const Target& target, std::vector<Text>& remarks) {
        const bool burnt = request_.captions == "burnt" || (request_.captions.empty() && target.format == Format::gif);
        DrawingOptions slides = options_;
        slides.steps = slides.slides = true;
        slides.sentences = burnt;
        slides.growing = target.format == Format::gif ? 4 : 8;  // eight tenths of a second
        const auto drawn = draw(solved_, slides);
        if (!drawn) return not_drawn(drawn.error());
        for (Text& each : drawn->remarks()) remarks.push_back(std::move(each));
        const Captions captions = burnt                         ? Captions::burnt
                                  : request_.captions == "none" ? Captions::none
                                                                : Captions::file;
        return add_film(*drawn, target, {request_.language(), captions, request_.film_height}, outcome_.outputs);
    }
    std::optional<Status> construction(const Target& target) {
        auto file = geogebra_file(solved_.front(), options_);
        if (!file) return cannot_draw(spoken(request_.file), file.error(), request_.language());
        outcome_.outputs.push_back({target.path, std::move(file->bytes)});
        std::move(file->remarks.begin(), file->remarks.end(), std::back_inserter(outcome_.remarks));
        return std::nullopt;
    }
    std::optional<Status> results(const Target& target) {
        for (std::size_t i = 0; i < (target.standard() ? 1 : solved_.size()); ++i)
            outcome_.outputs.push_back({target.path_of_page(i), solved_[i].json(request_.exact)});
        if (target.standard() && solved_.size() > 1)
            outcome_.remarks.push_back(Words(lang::command_line::standard_output_carries_the_first_position));
        return std::nullopt;
    }

    const SolveRequest& request_;
    const std::vector<Solved>& solved_;
    Outcome& outcome_;
    DrawingOptions options_;
};

/// Removes repetitions in the language of the reader; the first stays.
std::vector<Text> each_once(std::vector<Text> remarks, Language language) {
    std::vector<Text> once;
    for (Text& each : remarks)
        if (std::none_of(once.begin(), once.end(),
                         [&](const Text& other) { return other.in(language) == each.in(language); }))
            once.push_back(std::move(each));
    return once;
}

}  // namespace

tl::expected<Outcome, Status> outcome_of(const SolveRequest& request, const std::vector<Target>& targets) {
    const Language language = request.language();
    if (const Words fault = meaningless(request); !fault.empty()) return tl::unexpected(refuse(fault, language));
    auto text = request.text ? tl::expected<std::string, Words>(*request.text)
                             : read_whole(request.file, {lang::common::mechanism_file});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return tl::unexpected(Status::bad_input);
    }
    const bool has_sentences = std::any_of(targets.begin(), targets.end(), [](const Target& target) {
        return target.is_drawn() || target.format == Format::ggb;
    });
    const auto solved = solutions_of(request, *text, has_sentences);
    if (!solved) return tl::unexpected(solved.error());

    Outcome outcome;
    const auto add = [&](const std::vector<Text>& more) {
        outcome.remarks.insert(outcome.remarks.end(), more.begin(), more.end());
    };
    for (const Solved& each : *solved) add(each.remarks());
    Making making(request, *solved, outcome);
    if (targets.empty())
        making.table();
    else if (const auto failed = making.make(targets))
        return tl::unexpected(*failed);
    add(remarks_on_request(request, solved->front(), targets));
    outcome.remarks = each_once(std::move(outcome.remarks), language);
    if (names_clash(outcome.outputs, request.file, language)) return tl::unexpected(Status::bad_input);
    for (const Solved& each : *solved) {
        const Words where = request.positions.at.empty() ? spoken(request.file) : Words(each.title());
        for (Solved::Missing& missing : each.unsolved())
            outcome.unsolved.push_back({where, std::move(missing.what), std::move(missing.reason)});
    }
    return outcome;
}

Status solve_command(const SolveRequest& request) {
    const Language language = request.language();
    constexpr auto formats =
        drawings_and(Format::json, Format::html, Format::mp4, Format::webm, Format::gif, Format::ggb);
    const auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    SolveRequest full = request;
    if (const auto status = set_theme(full.drawing, request.theme, request.file)) return *status;
    if (const Words fault = meaningless_on_page(request, *targets); !fault.empty()) return refuse(fault, language);
    if (const Words fault = meaningless_in_film(request, *targets); !fault.empty()) return refuse(fault, language);
    const auto outcome = outcome_of(full, *targets);
    if (!outcome) return outcome.error();
    if (const auto failure = write_all(outcome->outputs)) return fail_to_write(*failure, language);
    remark(spoken(request.file), outcome->remarks, language);
    for (const Outcome::Missing& each : outcome->unsolved) say_unsolved(each.where, each.what, each.why, language);
    return outcome->status();
}

}  // namespace kinegraph::app
