#include "render/sheet/step_prose.hpp"

#include <algorithm>
#include <array>

#include "render/equations/prose.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/sentences.hpp"
#include "render/sheet/statement_figures.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {
namespace {

/// Sizes of type relative to the theme's, the first if there is room. A single sentence on a page is read from a
/// greater distance than a column of text, and a slide from the end of a room.
constexpr std::array sheet_sizes{1.25};
constexpr std::array slide_sizes{1.45, 1.3, 1.15};
std::span<const double> type_sizes(const SheetFormat& format) {
    return format.is_slide ? std::span<const double>(slide_sizes) : std::span<const double>(sheet_sizes);
}

}  // namespace

StepProse::StepProse(const DrawingContext& context, const SheetFormat& format, const Box& room)
    : context_(context),
      format_(format),
      room_(room),
      theme_(context.theme),
      in_type_{context.solution, theme_, context.fonts, context.language, context.dimensions} {
    theme_.body_text *= type_sizes(format_).front();
    theme_.label *= format_.is_slide ? 1.2 : 1.1;
}

StepRows StepProse::rows_of(StatementIndex index) {
    StepRows rows;
    for (const bool with_arithmetic : {true, false})
        for (const double size : type_sizes(format_)) {
            theme_.body_text = context_.theme.body_text * size;
            rows = rows_in_this_type(index, with_arithmetic);
            if (rows.height <= room()) return rows;
        }
    return rows;
}

StepRows StepProse::rows_in_this_type(StatementIndex index, bool with_arithmetic) const {
    Message message = context_.solution.protocol.statements[at_index(index)].message;
    if (!with_arithmetic) message = {message.sentence, message.arguments};
    StepRows found;
    found.rows.push_back(paragraph(say(message, context_.language)));
    for (Block& equation : equations_of(index)) found.rows.push_back({std::move(equation)});
    // On a slide the sentence comes last: set by TeX it may have a line more.
    if (format_.is_slide) std::rotate(found.rows.begin(), found.rows.begin() + 1, found.rows.end());
    for (StepRow& row : found.rows) {
        found.height += row.block.height;
        belong(row.block.marks, 0, index);
    }
    return found;
}

StepRow StepProse::paragraph(const RichText& text) const {
    StepRow row{paragraph_block(in_type_, format_.measure, text), text};
    row.block.height += 1;
    return row;
}

std::vector<Block> StepProse::equations_of(StatementIndex index) const {
    const Statement& statement = context_.solution.protocol.statements[at_index(index)];
    std::vector<Block> found;
    if (statement.equation) found.push_back(equation_block(context_, *statement.equation, format_.measure, 10));
    const LoadCase loads(context_.solution, part_of(context_.solution, index));
    for (const FreeBody* body : closed_by(loads, index))
        found.push_back(force_equation_block(context_, loads, *body, true));
    std::erase_if(found, [&](const Block& block) { return !(block.width > 0) || block.width > format_.measure; });
    for (Block& block : found) {
        render::move(block.marks, 0, 2.5);
        block.height += 5;
    }
    return found;
}

void StepProse::set(Page& page, const std::string& heading, const std::vector<StepRow>& rows, const std::string& figure,
                    bool with_sentences) const {
    const Block head = heading_block(in_type_, format_.measure, heading, {});
    render::set(page.marks, head, room_.min);
    double y = room_.min.y + head.height + 0.8;
    StepText said{figure, heading, {}, {}, format_.measure, theme_.body_text};
    const auto put = [&](const StepRow& row) {
        render::set(page.marks, row.block, {room_.min.x, y});
        y += row.block.height;
    };
    if (!format_.is_slide) {
        for (const StepRow& row : rows) put(row);
    } else {
        // The equations of all sentences first, see rows_in_this_type().
        for (const StepRow& row : rows)
            if (row.sentence.empty()) put(row);
        said.corner = {room_.min.x, y};
        page.marks.emplace_back(GroupBegin{"sentence", "", "", {}, none});
        for (const StepRow& row : rows)
            if (!row.sentence.empty() && with_sentences) put(row);
        page.marks.emplace_back(GroupEnd{});
    }
    for (const StepRow& row : rows)
        if (!row.sentence.empty()) said.sentences.push_back(row.sentence);
    page.step = std::move(said);
}

}  // namespace kinegraph::render
