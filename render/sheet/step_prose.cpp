#include "render/sheet/step_prose.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

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
constexpr std::array slide_sizes{1.45, 1.3, 1.15, 1.0};
std::span<const double> type_sizes(const SheetFormat& format) {
    return format.is_slide ? std::span<const double>(slide_sizes) : std::span<const double>(sheet_sizes);
}

constexpr double below_heading_of_slide = 3;  // mm

/// The block, smaller if its ink is wider than `measure`.
Block within(Block block, double measure) {
    const double width = box_of(block.marks).max.x;
    return width > measure ? scaled(std::move(block), measure / width) : block;
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
    for (const FreeBody* body : solved_by(loads, index))
        found.push_back(force_equation_block(context_, loads, *body, true, format_.measure));
    std::erase_if(found, [&](const Block& block) { return !(block.width > 0) || block.width > format_.measure; });
    for (Block& block : found) {
        render::move(block.marks, 0, 2.5);
        block.height += 5;
    }
    return found;
}

void StepProse::set(Page& page, const std::string& heading, const std::vector<StepRow>& rows, const std::string& figure,
                    bool with_sentences) const {
    const Block head = within(heading_block(in_type_, format_.measure, heading, {}), format_.measure);
    render::set(page.marks, head, room_.min);
    double y = room_.min.y + head.height + (format_.is_slide ? below_heading_of_slide : 0.8);
    double height = 0;
    for (const StepRow& row : rows) height += row.block.height;
    // What even the smallest type has no room for is made smaller as a whole.
    const double smaller = format_.is_slide && height > room() ? room() / height : 1;
    StepText said{figure, heading, {}, {}, format_.measure, theme_.body_text * smaller};
    const auto put = [&](const StepRow& row) {
        const Block block = smaller < 1 ? scaled(row.block, smaller) : row.block;
        render::set(page.marks, block, {room_.min.x, y});
        y += block.height;
    };
    if (!format_.is_slide) {
        for (const StepRow& row : rows) put(row);
    } else {
        // The equations of all sentences first, see rows_in_this_type().
        for (const StepRow& row : rows)
            if (row.sentence.empty()) put(row);
        said.corner = {room_.min.x, y};
        page.marks.emplace_back(GroupBegin{"sentence", {}, "", {}, none});
        for (const StepRow& row : rows)
            if (!row.sentence.empty() && with_sentences) put(row);
        page.marks.emplace_back(GroupEnd{});
    }
    for (const StepRow& row : rows)
        if (!row.sentence.empty()) said.sentences.push_back(row.sentence);
    page.step = std::move(said);
}

}  // namespace kinegraph::render
