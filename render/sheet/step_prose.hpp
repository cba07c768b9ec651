// What the page of a step says: a heading, sentences with their equations, set into the page's room for them.
#pragma once

#include <string>
#include <vector>

#include "render/content/sheet_parts.hpp"
#include "render/page/block.hpp"
#include "render/page/page.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A row of a step, and the words of a sentence.
struct StepRow {
    Block block;
    RichText sentence{};  ///< empty: it is an equation
};
struct StepRows {
    std::vector<StepRow> rows;
    double height = 0;
};

class StepProse {
public:
    StepProse(const DrawingContext& context, const SheetFormat& format, const Box& room);
    StepProse(const StepProse&) = delete;
    StepProse& operator=(const StepProse&) = delete;

    /// Height for rows.
    double room() const { return room_.height() - head_height; }
    /// The sentence of a statement and its equations. On a sheet the arithmetic of a sentence is left out where there
    /// is no room for it; on a slide its type is made smaller before.
    StepRows rows_of(StatementIndex index);
    StepRow paragraph(const RichText& text) const;
    /// Sets them into the room, and says on the page what they say.
    void set(Page& page, const std::string& heading, const std::vector<StepRow>& rows, const std::string& figure,
             bool with_sentences) const;

private:
    std::vector<Block> equations_of(StatementIndex index) const;
    StepRows rows_in_this_type(StatementIndex index, bool with_arithmetic) const;

    static constexpr double head_height = 9;

    const DrawingContext& context_;
    const SheetFormat& format_;
    Box room_;
    Theme theme_;
    DrawingContext in_type_;  // with that theme
};

}  // namespace kinegraph::render
