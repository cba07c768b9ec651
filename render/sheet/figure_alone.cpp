// Figures of the sheet, each on a page of its own size.
#include "render/sheet/figure_alone.hpp"

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "render/content/title_block.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/figures/caption.hpp"
#include "render/mechanism/subject.hpp"
#include "render/page/shapes.hpp"
#include "render/problems/contact_pages.hpp"
#include "render/problems/problem_sheet.hpp"

namespace kinegraph::render {
namespace {

constexpr double margin = 4;           // round the figure, mm
constexpr double tallest_alone = 130;  // mm; less than half a page, because the text of a book continues below

/// The mechanism without centres, then the list.
std::vector<FigureId> choices(const WantedFigures& wanted) {
    const FigureId mechanism{FigureKind::mechanism};
    std::vector<FigureId> all{mechanism};
    for (const Wanted& each : wanted.list)
        if (each.id != mechanism) all.push_back(each.id);
    return all;
}
Figure drawn_alone(const WantedFigures& wanted, FigureId id, Spot room) {
    return draw_figure(wanted.shown(), id, room, {0, size_of(wanted.shown(), id).asked});
}

/// Moves the figure to the corner of a page of its size.
AloneFigure cut_to(const DrawingContext& context, Figure figure) {
    const Box box = box_of(figure.marks);
    figure.move(margin - box.min.x, margin - box.min.y);
    Page page;
    page.width = box.width() + 2 * margin;
    page.height = box.height() + 2 * margin;
    page.paper = context.theme.paper;
    page.title = title_of(context.solution, context.language) + word(lang::notation::colon, context.language) +
                 plain(figure.caption);
    page.language = code_of(context.language);
    page.marks = std::move(figure.marks);
    return {std::move(page), {}, std::move(figure.caption), {}, figure.origin, figure.places, {}, figure.by_load};
}

std::optional<Figure> mechanism_figure_named(const DrawingContext& context, const SheetOptions& options,
                                             const SheetFormat& format, const std::string& name) {
    const WantedFigures wanted(context, options.joukowsky);
    for (const FigureId id : choices(wanted))
        if (name_of(context.solution, id) == name)
            return drawn_alone(wanted, id, {2 * format.measure + gap, tallest_alone});
    return std::nullopt;
}

}  // namespace

std::vector<std::string> figure_names(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    const DrawingContext context{solution, options.theme, fonts, options.language, options.dimensions};
    if (stands_for_joints(solution.mechanism)) return problem_figure_names(context);
    const WantedFigures wanted(context, options.joukowsky);
    std::vector<std::string> names;
    for (const FigureId id : choices(wanted)) names.push_back(name_of(solution, id));
    for (ContactFigure& each : contact_figures(solution, options, fonts)) names.push_back(std::move(each.name));
    return names;
}

std::optional<Page> lay_out_alone(const Solution& solution, const SheetOptions& options, const std::string& name,
                                  const Fonts& fonts) {
    const DrawingContext context{solution, options.theme, fonts, options.language, options.dimensions};
    const SheetFormat format = format_of(options.paper, options.orientation);
    auto drawn = stands_for_joints(solution.mechanism) ? problem_figure(context, name, format.measure, tallest_alone)
                                                       : mechanism_figure_named(context, options, format, name);
    if (!drawn) drawn = contact_figure(solution, options, fonts, name, {format.measure, tallest_alone});
    if (!drawn) return std::nullopt;
    return page_of_figure(context, *std::move(drawn));
}

Page page_of_figure(const DrawingContext& context, Figure figure) { return cut_to(context, std::move(figure)).page; }

std::vector<AloneFigure> lay_out_each_alone(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    const DrawingContext context{solution, options.theme, fonts, options.language, options.dimensions};
    const SheetFormat format = format_of(options.paper, options.orientation);
    std::vector<AloneFigure> all;
    const auto add = [&](const std::string& name, Figure figure) {
        RichText scale = figure.has_scale ? scale_words(context, figure) : RichText{};
        all.push_back(cut_to(context, std::move(figure)));
        all.back().name = name;
        all.back().scale_in_words = std::move(scale);
    };
    const bool stands = stands_for_joints(solution.mechanism);
    if (stands) {
        for (const std::string& name : problem_figure_names(context))
            if (auto figure = problem_figure(context, name, format.measure, tallest_alone))
                add(name, *std::move(figure));
        return all;
    }
    const WantedFigures wanted(context, options.joukowsky, options.detail, options.superposed);
    for (const FigureId id : choices(wanted))
        if (!row_of(id.kind).size.spare && !wanted.is_replaced(id)) {
            add(name_of(solution, id), drawn_alone(wanted, id, {2 * format.measure + gap, tallest_alone}));
            all.back().id = id;
        }
    for (const auto& [name, joint] : contact_figures(solution, options, fonts)) {
        auto figure = contact_figure(solution, options, fonts, name, {format.measure, tallest_alone});
        if (!figure) continue;
        add(name, *std::move(figure));
        all.back().loaded = joint;
    }
    return all;
}

}  // namespace kinegraph::render
