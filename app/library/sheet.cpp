// Drawings of a solution, and their output formats.
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/requested_results.hpp"
#include "app/library/state.hpp"
#include "constructions/moving/moving.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/library.hpp"
#include "render/backends/backends.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/live/live_page.hpp"
#include "render/page/body_colours.hpp"
#include "render/page/theme.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/handout.hpp"
#include "render/sheet/sheet.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "render/sheet/steps.hpp"

namespace kinegraph {

template class Shared<const Drawing::State>;

Expected<const render::Fonts*> fonts_of_thread() {
    thread_local std::optional<render::Fonts> fonts;
    if (fonts) {
        fonts->start_anew();
        return &*fonts;
    }
    auto opened = render::Fonts::open();
    if (!opened) return refused(Diagnostic::Kind::output, opened.error());
    fonts.emplace(*std::move(opened));
    return &*fonts;
}

std::optional<render::Theme> dark_beside(const DrawingOptions& options) {
    return options.theme_file.empty() && options.theme == "colour" ? render::built_in_theme("dark") : std::nullopt;
}

render::SheetOptions with_colours_of(render::SheetOptions options, const Mechanism& mechanism) {
    options.theme = render::with_colours_of(std::move(options.theme), mechanism);
    return options;
}

namespace {

using Paper = DrawingOptions::Paper;
using Dimensions = DrawingOptions::Dimensions;
using SheetWanted = DrawingOptions::Sheet;

/// The outlines of the thread's fonts: most letters of a sheet were on the sheet before.
render::GlyphPaths& glyph_paths_of_thread() {
    thread_local render::GlyphPaths paths;
    return paths;
}

/// The fonts for pages that are already laid out.
const render::Fonts* fonts_that_drew() {
    const auto fonts = fonts_of_thread();
    KG_ASSERT(fonts.has_value(), "the fonts that laid out the pages are still there");
    return *fonts;
}

Expected<render::Theme> theme_of(const DrawingOptions& options) {
    if (!options.theme_file.empty()) {
        auto theme = render::read_theme(options.theme_file);
        if (!theme) return tl::unexpected(diagnostics_of(theme.error()));
        return *std::move(theme);
    }
    if (auto theme = render::built_in_theme(options.theme)) return *std::move(theme);
    std::string known;
    for (const std::string_view each : render::theme_names()) known.append(known.empty() ? "" : ", ").append(each);
    return refused(Diagnostic::Kind::bad_input, Words(lang::library::there_is_no_theme_there, options.theme, known));
}

/// Codes of characters ("U+4E2D"), each once.
std::vector<std::string> in_unicode_order(std::vector<std::string> codes) {
    const auto size_and_digits = [](const std::string& code) { return std::pair(code.size(), std::string_view(code)); };
    std::sort(codes.begin(), codes.end(),
              [&](const std::string& a, const std::string& b) { return size_and_digits(a) < size_and_digits(b); });
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    return codes;
}

/// Why there is no sheet or page of a solution, with the place in its file.
std::optional<Diagnostics> why_not_drawn(const Solution& solution, bool in_steps) {
    if (auto far = why_points_not_drawn(solution)) return far;
    if (const auto beyond = in_steps ? render::beyond_steps(solution) : render::beyond_sheet(solution))
        return not_drawn("/find", *beyond);
    return std::nullopt;
}

/// The pages of one solution; adds remarks to `remarks`.
Expected<std::vector<render::Page>> pages_of(const Solution& solution, const DrawingOptions& wanted,
                                             const render::SheetOptions& any, const render::Fonts& fonts,
                                             std::vector<Text>& remarks) {
    const render::SheetOptions options = with_colours_of(any, solution.mechanism);
    if (auto why = why_not_drawn(solution, wanted.steps)) return tl::unexpected(*std::move(why));
    const bool has_joints = !stands_for_joints(solution.mechanism);
    if (wanted.sheet == SheetWanted::answers && has_joints) {
        render::LaidOutKey key = render::lay_out_key_of(solution, app::requested_results(solution), options, fonts);
        for (const render::RichText& remark : key.remarks) {
            const std::string text = render::plain(remark);
            remarks.push_back({{text, text}});
        }
        return std::move(key.pages);
    }
    if (wanted.steps) return render::lay_out_steps(solution, options, fonts);
    if (wanted.sheet == SheetWanted::question && has_joints)
        return render::lay_out_handout(solution, options, fonts, app::requested_results(solution));
    if (wanted.figure.empty()) return render::lay_out(solution, options, fonts);
    if (auto page = render::lay_out_alone(solution, options, wanted.figure, fonts))
        return std::vector{*std::move(page)};
    std::string names;
    for (const std::string& each : render::figure_names(solution, options, fonts))
        names += (names.empty() ? "" : ", ") + each;
    return refused(Diagnostic::Kind::bad_input,
                   Words(lang::library::there_is_no_such_figure_there, wanted.figure, names));
}

render::Page empty_page_after(const render::Page& page) {
    render::Page empty = page;
    empty.marks.clear();
    return empty;
}

/// Calls `paint` with the thread's fonts once the rendering library is open.
template <class Paint>
Expected<std::string> painted(Paint paint) {
    const auto fonts = fonts_of_thread();
    if (!fonts) return tl::unexpected(fonts.error());
    if (const auto opened = render::open_painter(); !opened) return refused(Diagnostic::Kind::output, opened.error());
    return paint(**fonts);
}

}  // namespace

Diagnostics not_drawn(const char* place, const Words& why) {
    return {diagnostic_of(Diagnostic::Kind::bad_input, place, why)};
}

std::optional<Diagnostics> why_points_not_drawn(const Solution& solution) {
    if (const auto beyond = render::beyond_doubles(solution)) return not_drawn("/points", *beyond);
    return std::nullopt;
}

Expected<render::SheetOptions> sheet_options_of(const DrawingOptions& options) {
    auto theme = theme_of(options);
    if (!theme) return tl::unexpected(theme.error());
    render::SheetOptions sheet;
    sheet.language = options.language;
    sheet.paper = options.slides                   ? render::Paper::slide
                  : options.paper == Paper::a3     ? render::Paper::a3
                  : options.paper == Paper::letter ? render::Paper::letter
                                                   : render::Paper::a4;
    const bool upright = options.orientation == DrawingOptions::Orientation::portrait && !options.slides;
    sheet.orientation = upright ? render::Orientation::portrait : render::Orientation::landscape;
    sheet.dimensions = options.dimensions == Dimensions::on    ? render::Dimensions::on
                       : options.dimensions == Dimensions::off ? render::Dimensions::off
                                                               : render::Dimensions::automatic;
    sheet.detail =
        options.detail == DrawingOptions::Detail::brief ? render::SolutionDetail::brief : render::SolutionDetail::full;
    if (options.superposition == DrawingOptions::Superposition::each) sheet.superposed = render::SuperposedLoads::each;
    sheet.kind = options.sheet == SheetWanted::question  ? render::SheetKind::question
                 : options.sheet == SheetWanted::answers ? render::SheetKind::answers
                                                         : render::SheetKind::solution;
    sheet.with_sentences = options.sentences;
    sheet.growing = options.slides ? options.growing : 0;
    sheet.grid = options.grid;
    if (options.scales) sheet.kept = render::KeptScales{options.scales->of_figures, options.scales->of_forces};
    sheet.joukowsky = options.lever || !options.figure.empty();
    sheet.author = options.author;
    sheet.date = options.date;
    sheet.theme = *std::move(theme);
    return sheet;
}

Text remark_on_missing(const std::vector<std::string>& characters) {
    std::string absent;
    for (const std::string& character : in_unicode_order(characters))
        absent += (absent.empty() ? "" : ", ") + character;
    return text_of(Words(lang::library::the_font_has_no_drawn, absent));
}

std::size_t Drawing::pages() const { return state().pages.size(); }
const std::vector<std::string>& Drawing::missing_characters() const { return state().missing; }
std::vector<Text> Drawing::remarks() const {
    std::vector<Text> all = state().remarks;
    if (!state().missing.empty()) all.push_back(remark_on_missing(state().missing));
    return all;
}

std::vector<std::string> Drawing::svg(Lettering lettering) const {
    const auto fonts = fonts_that_drew();
    if (lettering == Lettering::live) return render::to_live_svg(state().pages, *fonts);
    if (lettering == Lettering::office) return render::to_office_svg(state().pages, *fonts);
    return render::to_svg(state().pages, *fonts, glyph_paths_of_thread());
}

Expected<std::string> Drawing::png(std::size_t page, double dpi) const {
    constexpr double least = 20, most = 1200;
    if (page >= state().pages.size() || !(dpi >= least && dpi <= most))
        return refused(Diagnostic::Kind::bad_input,
                       Words(lang::library::a_page_from_0, std::to_string(state().pages.size() - 1)));
    try {
        return painted([&](const render::Fonts& fonts) { return render::to_png(state().pages[page], fonts, dpi); });
    } catch (const std::bad_alloc&) {
        return refused(Diagnostic::Kind::output, {lang::library::memory_does_not_hold_the_picture});
    }
}

Expected<std::string> Drawing::pdf(Lettering lettering) const {
    return painted([&](const render::Fonts& fonts) {
        return lettering == Lettering::outlines ? render::to_pdf(state().pages, fonts)
                                                : render::to_live_pdf(state().pages, fonts);
    });
}

std::string Drawing::tex() const { return render::to_tex(state().pages, *fonts_that_drew()); }
std::string Drawing::beamer() const { return render::to_beamer(state().pages, *fonts_that_drew()); }
std::vector<std::string> Drawing::dxf() const { return render::to_dxf(state().pages, *fonts_that_drew()); }
bool Drawing::grows(std::size_t page) const {
    const auto& pages = state().pages;
    return page < pages.size() && pages[page].step && pages[page].step->grows;
}

std::string Drawing::sentences(std::size_t page) const {
    std::string text;
    if (page >= state().pages.size() || !state().pages[page].step) return text;
    for (const render::RichText& each : state().pages[page].step->sentences)
        text += (text.empty() ? "" : "\n") + render::plain(each);
    return text;
}

Expected<Drawing> drawing_of(const DrawingOptions& options, const LayOut& lay_out) {
    const auto fonts = fonts_of_thread();
    if (!fonts) return tl::unexpected(fonts.error());
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    std::vector<Text> remarks;
    auto pages = lay_out(*sheet, **fonts, remarks);
    if (!pages) return tl::unexpected(pages.error());
    for (const render::Page& page : *pages)
        if (const auto beyond = render::beyond_paper(page)) return tl::unexpected(not_drawn("", *beyond));
    return Drawing(Shared<const Drawing::State>(
        new Drawing::State{{}, *std::move(pages), std::move(remarks), (*fonts)->missing()}));
}

Expected<Drawing> draw(const std::vector<Solved>& solved, const DrawingOptions& options) {
    if (solved.empty()) return refused(Diagnostic::Kind::bad_input, {lang::library::there_is_no_solution_to_draw});
    return drawing_of(options, [&](const render::SheetOptions& sheet, const render::Fonts& fonts, auto& remarks) {
        Expected<std::vector<render::Page>> pages;
        for (const Solved& each : solved) {
            auto more = pages_of(each.state().solution, options, sheet, fonts, remarks);
            if (!more) return more;
            if (options.even_pages && more->size() % 2 == 1) more->push_back(empty_page_after(more->back()));
            std::move(more->begin(), more->end(), std::back_inserter(*pages));
        }
        return pages;
    });
}

Expected<Drawing> draw(const Solved& solved, const DrawingOptions& options) {
    return draw(std::vector{solved}, options);
}

Expected<Drawing> joined(const std::vector<Drawing>& drawings) {
    if (drawings.empty()) return refused(Diagnostic::Kind::bad_input, {lang::library::there_is_no_drawing_to_join});
    std::vector<render::Page> pages;
    std::vector<Text> remarks;
    std::vector<std::string> missing;
    for (const Drawing& each : drawings) {
        const Drawing::State& state = each.state();
        pages.insert(pages.end(), state.pages.begin(), state.pages.end());
        remarks.insert(remarks.end(), state.remarks.begin(), state.remarks.end());
        missing.insert(missing.end(), state.missing.begin(), state.missing.end());
    }
    return Drawing(Shared<const Drawing::State>(
        new Drawing::State{{}, std::move(pages), std::move(remarks), in_unicode_order(std::move(missing))}));
}

void FigureScales::add(const FigureScales& other) {
    for (const auto& [name, scale] : other.of_figures) {
        double& own = of_figures[name];
        own = std::max(own, scale);
    }
    if (other.of_forces) of_forces = std::max(of_forces.value_or(0), *other.of_forces);
}

Expected<FigureScales> figure_scales(const Solved& solved, const DrawingOptions& options) {
    const auto fonts = fonts_of_thread();
    if (!fonts) return tl::unexpected(fonts.error());
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    const Solution& solution = solved.state().solution;
    if (stands_for_joints(solution.mechanism)) return FigureScales{};
    render::KeptScales kept = render::scales_of_solution(solution, *sheet, **fonts);
    return FigureScales{std::move(kept.of_figures), kept.of_forces};
}

Expected<std::vector<std::string>> figure_names(const Solved& solved, const DrawingOptions& options) {
    const auto fonts = fonts_of_thread();
    if (!fonts) return tl::unexpected(fonts.error());
    auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    sheet->joukowsky = true;
    return render::figure_names(solved.state().solution, *sheet, **fonts);
}

Expected<LivePage> live_page(const Solved& solved, const DrawingOptions& options, int version) {
    const auto fonts = fonts_of_thread();
    if (!fonts) return tl::unexpected(fonts.error());
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    if (auto why = why_not_drawn(solved.state().solution, false)) return tl::unexpected(*std::move(why));
    const auto& source = solved.state().source;
    const Rereading file = source ? rereading_of(source->text, source->name, source->set) : Rereading{};
    const Solution& solution = solved.state().solution;
    const auto moving = solution.mechanism.drivers.empty() ? standing_of(solution) : moving_of(solution, file);
    auto dark = dark_beside(options);
    if (dark) dark = render::with_colours_of(*std::move(dark), solution.mechanism);
    const render::SheetOptions coloured = with_colours_of(*sheet, solution.mechanism);
    auto html = render::live_page(solution, moving, coloured, dark, **fonts, version);
    if (!html) return tl::unexpected(not_drawn("", html.error()));
    std::vector<Text> remarks;
    if (const auto missing = (*fonts)->missing(); !missing.empty()) remarks.push_back(remark_on_missing(missing));
    if (!solution.mechanism.cam_file.empty()) remarks.push_back(text_of(app::cam_stays(solution.mechanism)));
    if (!solution.mechanism.drivers.empty() && is_beyond_moving(solution.mechanism))
        remarks.push_back(text_of(Words(lang::library::the_page_does_not_move, std::to_string(most_moved_bodies),
                                        std::to_string(most_moved_drivers))));
    return LivePage{*std::move(html), std::move(remarks)};
}

Expected<std::string> waiting_page(const std::string& name, const DrawingOptions& options) {
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    return render::waiting_page(name, *sheet, dark_beside(options));
}

std::vector<std::string> theme_names() {
    const auto& names = render::theme_names();
    return {names.begin(), names.end()};
}
Expected<void> check_theme(std::string_view theme_file) {
    if (const auto theme = render::read_theme(theme_file); !theme) return tl::unexpected(diagnostics_of(theme.error()));
    return {};
}

Expected<Drawing> draw_pair_catalogue(const DrawingOptions& options) {
    return drawing_of(options, [](const render::SheetOptions& sheet, const render::Fonts& fonts, auto&) {
        return render::lay_out_catalogue(sheet, fonts);
    });
}

}  // namespace kinegraph
