// Draws the title block in the corner of the frame.
#include "render/content/title_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <system_error>

#include "engine/solution/problem_kind.hpp"
#include "lang/keys/equations.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/figures/caption.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/tables.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {

namespace {

constexpr std::size_t most_characters = 1000;  // of a title; more than any block can hold

/// A line in one face. If it is too wide, its size decreases to `least` points, then it is cut with an ellipsis.
ShapedLine fitted(const Fonts& fonts, const std::string& words, Face face, double size, double least, double width) {
    const RichText text = one_piece(words, face);
    for (; size > least; size -= 0.5)
        if (ShapedLine line = fonts.shape(text, size); line.width <= width) return line;
    return shaped_within(text, size, fonts, width);
}

/// The same, but the end of the text is kept.
ShapedLine fitted_with_its_end(const Fonts& fonts, const std::string& words, double size, double least, double width) {
    for (; size > least; size -= 0.5)
        if (ShapedLine line = fonts.shape(one_piece(words), size); line.width <= width) return line;
    return shaped_with_its_end(words, size, fonts, width);
}

/// The title on several lines, as far as the height allows.
void set_title(std::vector<Mark>& marks, const DrawingContext& context, const Box& room, double size,
               double small_print) {
    constexpr double least = 5, leading = 1.15;
    const std::string whole = title_of(context.solution, context.language);
    const RichText title = one_piece(std::string(first_characters(whole, most_characters)), Face::bold);
    const auto lead = [&] { return millimetres(size) * leading; };
    std::vector<ShapedLine> lines;
    const auto most = [&] {
        return static_cast<std::size_t>(std::max(1.0, std::floor((room.height() - small_print) / lead())));
    };
    for (;; size -= 0.5) {
        lines = context.fonts.wrap(title, size, room.width());
        const bool wide =
            std::any_of(lines.begin(), lines.end(), [&](const ShapedLine& each) { return each.width > room.width(); });
        if (size <= least || (!wide && lines.size() <= std::min<std::size_t>(most(), size > 8 ? 2 : 4))) break;
    }
    if (lines.size() > most()) {
        lines.resize(most());
        lines.back() = fitted(context.fonts, lines.back().words + " …", Face::bold, size, size, room.width());
    }
    double baseline = room.min.y + (lines.size() > 1 ? 0 : 1.3) + millimetres(size) * 0.72;
    for (const ShapedLine& each : lines) {
        const ShapedLine cut =
            each.width > room.width() ? fitted(context.fonts, each.words, Face::bold, size, size, room.width()) : each;
        set_text(marks, cut, {room.min.x, baseline}, context.theme.text, "text");
        baseline += lead();
    }
}

/// By the diagrams that it has; of bars that cross, and that no cut separates, the free bodies.
Key subtitle_of_truss(const Truss& truss) {
    const bool has_plan = truss.polygon >= 0, has_cuts = !truss.cuts.empty();
    return has_plan && has_cuts ? lang::sheet::subtitle_truss
           : has_plan           ? lang::sheet::subtitle_cremona
           : has_cuts           ? lang::sheet::subtitle_cuts
                                : lang::sheet::subtitle_forces;
}

std::string subtitle_of(const Solution& solution, Language language) {
    if (stands_for_joints(solution.mechanism)) return in(solution.problem->subject, language);
    const bool acceleration = std::any_of(solution.protocol.polygons.begin(), solution.protocol.polygons.end(),
                                          [](const Polygon& p) { return p.plane == Plane::acceleration; });
    return word(is_mixed(solution)                   ? lang::sheet::subtitle_mixed
                : solution.truss                     ? subtitle_of_truss(*solution.truss)
                : has_forces(solution)               ? lang::sheet::subtitle_forces
                : solution.displacements             ? lang::equations::virtual_work
                : solution.protocol.polygons.empty() ? lang::sheet::subtitle_pose
                : acceleration                       ? lang::sheet::subtitle_acceleration
                                                     : lang::sheet::subtitle_velocity,
                language);
}

/// "four_bar.json  ·  A. Rossi  ·  2026-11-21"
std::string origin_of(const Solution& solution, const Signature& signature) {
    std::string origin = solution.mechanism.source;
    if (const std::size_t slash = origin.find_last_of('/'); slash != std::string::npos)
        origin = origin.substr(slash + 1);
    for (const std::string& each : {signature.author, signature.date})
        if (!each.empty()) origin += (origin.empty() ? "" : "  ·  ") + each;
    return origin;
}

/// The title on one line along the lower edge of the frame, with the page number.
void draw_strip(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                const Signature& signature, std::size_t index, std::size_t count) {
    const Theme& theme = context.theme;
    const Box room = rectangle(format.inner.min.x + 2, format.inner.max.y - strip_height, format.inner.max.x - 2,
                               format.inner.max.y - 1.6);
    marks.emplace_back(line({format.inner.min.x, room.min.y}, {format.inner.max.x, room.min.y},
                            Pen{theme.thin, theme.text, {}, false}));
    const ShapedLine sheet = context.fonts.shape(one_piece(word(lang::sheet::block_sheet, context.language) + " " +
                                                           std::to_string(index) + "/" + std::to_string(count)),
                                                 theme.block);
    set_text(marks, sheet, {room.max.x - sheet.width, room.max.y}, theme.secondary, "text");
    std::string words(first_characters(title_of(context.solution, context.language), most_characters));
    if (const std::string origin = origin_of(context.solution, signature); !origin.empty()) words += "  ·  " + origin;
    set_text(marks, fitted_with_its_end(context.fonts, words, theme.block, 5, room.width() - sheet.width - 6),
             {room.min.x, room.max.y}, theme.secondary, "text");
}

bool is_of_points(const Mechanism& mechanism) {
    return stands_for_joints(mechanism) && mechanism.problem->kind->title_block.of_points;
}

std::string count_of_bodies(const Mechanism& mechanism) {
    if (!stands_for_joints(mechanism)) return std::to_string(mechanism.bodies.size());
    return std::to_string(mechanism.problem->kind->title_block.count);
}

std::string units_of(const Solution& solution) {
    const Units& units = solution.mechanism.units;
    const std::string length = units.length.symbol, force = ", " + units.force.symbol;
    ProblemKind::TitleBlock shown;
    if (stands_for_joints(solution.mechanism)) {
        shown = solution.mechanism.problem->kind->title_block;
    } else {
        shown.has_forces = has_forces(solution);
        shown.has_time = has_motion(solution) || !has_forces(solution);
    }
    return length + (shown.has_time ? ", s" : "") + (shown.has_forces ? force : "");
}

/// The number of a slide, in its corner.
void draw_slide_number(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                       std::size_t index, std::size_t count) {
    const ShapedLine number =
        context.fonts.shape(one_piece(std::to_string(index) + " / " + std::to_string(count)), context.theme.small);
    set_text(marks, number, {format.content.max.x - number.width, format.content.max.y - number.descent},
             context.theme.secondary, "text");
}

}  // namespace

ShapedLine shaped_with_its_end(const std::string& words, double size, const Fonts& fonts, double width) {
    ShapedLine line = fonts.shape(one_piece(words), size);
    const std::size_t whole = character_count(words);
    constexpr std::size_t fewest = 8, many = 400;
    for (std::size_t kept = whole; line.width > width && kept > fewest; kept -= kept > many ? 50 : 2) {
        const std::size_t front = kept / 3, cut = whole - (kept - front);
        const std::string end = words.substr(first_characters(words, cut).size());
        line = fonts.shape(one_piece(std::string(first_characters(words, front)) + " … " + end), size);
    }
    line.words = words;
    return line;
}

std::string title_of(const Solution& solution, Language language) {
    const std::string& given = in(solution.mechanism.title, language);
    return given.empty() ? word(lang::sheet::untitled, language) : given;
}

void draw_title_block(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                      std::optional<double> scale_of_mechanism, const Signature& signature, std::size_t index,
                      std::size_t count) {
    const Solution& solution = context.solution;
    const Theme& theme = context.theme;
    const Pen edge{theme.outline, theme.text, {}, false}, inner_pen{theme.thin, theme.text, {}, false};
    const double cells_width = format.large ? 25 : 17.5, cells_left = format.block.max.x - 3 * cells_width;
    const double half = format.block.min.y + format.block.height() / 2;
    marks.emplace_back(line({format.block.min.x, format.block.min.y}, {format.block.max.x, format.block.min.y}, edge));
    marks.emplace_back(line({format.block.min.x, format.block.min.y}, {format.block.min.x, format.block.max.y}, edge));
    marks.emplace_back(line({cells_left, format.block.min.y}, {cells_left, format.block.max.y}, inner_pen));
    marks.emplace_back(line({cells_left + cells_width, format.block.min.y},
                            {cells_left + cells_width, format.block.max.y}, inner_pen));
    marks.emplace_back(line({cells_left + 2 * cells_width, format.block.min.y},
                            {cells_left + 2 * cells_width, format.block.max.y}, inner_pen));
    marks.emplace_back(line({cells_left, half}, {format.block.max.x, half}, inner_pen));

    const std::string scale = scale_of_mechanism ? ratio_words(*scale_of_mechanism, context.language) : "–";
    const std::array<std::pair<std::string, std::string>, 6> cells{
        std::pair{word(lang::sheet::block_scale, context.language), scale},
        {word(lang::sheet::block_size, context.language), format.name},
        {word(lang::sheet::block_sheet, context.language), std::to_string(index) + "/" + std::to_string(count)},
        {word(lang::sheet::block_units, context.language), units_of(solution)},
        {word(lang::sheet::block_readings, context.language), fixed(0.1, 1, context.language) + " mm"},
        {word(is_of_points(solution.mechanism) ? lang::sheet::block_points : lang::sheet::block_bodies,
              context.language),
         count_of_bodies(solution.mechanism)}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double x = cells_left + static_cast<double>(i % 3) * cells_width + 1.6;
        const double top = i < 3 ? format.block.min.y : half;
        const double height = format.block.height() / 2;
        set_text(marks, context.fonts.shape(one_piece(cells[i].first), theme.block), {x, top + 0.34 * height},
                 theme.secondary, "text");
        double size = format.large ? theme.derived : theme.body_text;
        ShapedLine value = context.fonts.shape(one_piece(cells[i].second), size);
        while (value.width > cells_width - 3 && size > 4)
            value = context.fonts.shape(one_piece(cells[i].second), size -= 0.5);
        set_text(marks, value, {x, top + 0.82 * height}, theme.text, "text");
    }

    const double left = format.block.min.x + 3.5, right = cells_left - 2;
    std::string origin = origin_of(solution, signature);
    const double print = format.large ? theme.body_text : 7.5, line = 3.4;
    const auto small_print = [&](const std::string& words, double at) {
        set_text(marks, fitted_with_its_end(context.fonts, words, print, 5, right - left), {left, at}, theme.secondary,
                 "text");
    };
    const std::string title = title_of(solution, context.language);
    const double size = format.large ? theme.title : 13;
    const bool one_line = context.fonts.shape(one_piece(title, Face::bold), size).width <= right - left;
    // On a question or a key the kind of sheet is always shown.
    if (!one_line && !signature.subtitle.empty())
        origin = signature.subtitle + (origin.empty() ? "" : "  ·  ") + origin;
    set_title(marks, context, rectangle(left, format.block.min.y + 1.5, right, format.block.max.y - 1.5), size,
              origin.empty() ? 0 : line);
    const std::string subtitle =
        signature.subtitle.empty() ? subtitle_of(solution, context.language) : signature.subtitle;
    if (one_line) small_print(subtitle, format.block.max.y - (origin.empty() ? 3.2 : 5.4));
    if (!origin.empty()) small_print(origin, format.block.max.y - 2.0);
}

Page framed_page(const DrawingContext& context, const SheetFormat& format, const Signature& signature,
                 std::vector<Mark> marks, std::optional<double> scale_of_mechanism, std::size_t index,
                 std::size_t count, bool whole_block) {
    const Theme& theme = context.theme;
    Page page;
    page.width = format.width;
    page.height = format.height;
    page.paper = theme.paper;
    page.title = title_of(context.solution, context.language);
    page.language = code_of(context.language);
    const Pen pen{theme.outline, theme.text, {}, false};
    if (format.is_slide && count > 1) draw_slide_number(page.marks, context, format, index, count);
    if (!format.is_slide)
        page.marks.emplace_back(polyline({format.inner.min,
                                          {format.inner.max.x, format.inner.min.y},
                                          format.inner.max,
                                          {format.inner.min.x, format.inner.max.y}},
                                         pen, true));
    if (whole_block && !format.is_slide)
        draw_title_block(page.marks, context, format, scale_of_mechanism, signature, index, count);
    else if (!format.is_slide)
        draw_strip(page.marks, context, format, signature, index, count);
    page.marks.insert(page.marks.end(), std::make_move_iterator(marks.begin()), std::make_move_iterator(marks.end()));
    // The mark of a point's label carries the name in the file, not the typeset one.
    for (Mark& mark : page.marks)
        if (auto* text = std::get_if<TextMark>(&mark); text && !text->in_file.empty()) text->words = text->in_file;
    return page;
}

}  // namespace kinegraph::render
